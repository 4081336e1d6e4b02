//! `if` and `match`: decided while generating, or for each particle.

use super::{Translator, generated};
use crate::scopes::{Boundary, Kind};
use quote::{ToTokens, quote_spanned};
use syn::spanned::Spanned;
use syn::visit_mut::VisitMut;
use syn::{Expr, ExprIf, ExprMatch};

/// What `rare(...)` is applied to, if this is such a call.
fn rare_condition(expr: &mut Expr) -> Option<&mut Expr> {
    let Expr::Call(call) = expr else { return None };
    let Expr::Path(path) = &*call.func else { return None };
    if path.path.is_ident("rare") && call.args.len() == 1 { call.args.first_mut() } else { None }
}

impl Translator<'_> {
    pub(crate) fn branch(&mut self, expr: &mut Expr) {
        let Expr::If(branch) = expr else { return };
        if self.constants == 0 && self.is_dependent(branch) {
            *expr = self.dependent(branch);
        } else {
            self.decided(branch);
        }
    }

    /// Whether an `if` is decided for each particle: its condition compares reals.
    pub(crate) fn is_dependent(&self, branch: &ExprIf) -> bool {
        self.kind(&branch.cond) == Kind::Mask
    }

    /// An `if` that is decided while generating: it stays.
    fn decided(&mut self, branch: &mut ExprIf) {
        self.within(Boundary::Plain, |this| {
            let written = this.is_mutating().then(|| branch.cond.clone());
            this.condition_with_let(&mut branch.cond);
            if let Some(written) = written {
                this.mutate_flag(&written, branch.if_token.span(), &mut branch.cond);
            }
            this.visit_block_mut(&mut branch.then_branch);
        });
        if let Some((_, otherwise)) = &mut branch.else_branch {
            self.visit_expr_mut(otherwise);
        }
    }

    /// `if let` binds names for the branch.
    fn condition_with_let(&mut self, condition: &mut Expr) {
        match condition {
            Expr::Let(binding) => {
                self.visit_expr_mut(&mut binding.expr);
                self.visit_pat_mut(&mut binding.pat);
                self.scopes.bind_pattern(&binding.pat, Kind::Unknown);
            }
            Expr::Binary(binary) if matches!(binary.op, syn::BinOp::And(_)) => {
                self.condition_with_let(&mut binary.left);
                self.condition_with_let(&mut binary.right);
            }
            other => self.visit_expr_mut(other),
        }
    }

    /// An `if` on data: both sides become closures, of which a scalar runs one, and lanes and symbols both.
    fn dependent(&mut self, branch: &mut ExprIf) -> Expr {
        let mut name = "choose";
        if let Some(inner) = rare_condition(&mut branch.cond) {
            name = "choose_rare";
            let inner = Self::take(inner);
            *branch.cond = inner;
        }
        let span = generated(branch.if_token.span());
        let written = self.is_mutating().then(|| branch.cond.clone());
        match self.kind(&branch.cond) {
            Kind::Flag | Kind::Integer => {
                self.errors.at(
                    &branch.cond,
                    "`rare` is for a comparison of reals, but this is decided while generating: remove `rare`",
                );
            }
            _ => self.mask(&mut branch.cond),
        }
        self.within(Boundary::Branch, |this| this.visit_block_mut(&mut branch.then_branch));
        match &mut branch.else_branch {
            Some((_, otherwise)) => self.within(Boundary::Branch, |this| this.visit_expr_mut(otherwise)),
            None => self.errors.at(
                branch.if_token,
                "every target picks one of two values here, so this `if` needs an `else`: write `let x = if a < b { .. } else { .. };`",
            ),
        }
        let choose = Self::mask_function(name, branch.if_token.span());
        let condition = super::comparisons::without_parentheses(Self::take(&mut branch.cond));
        let condition = match written {
            Some(written) => self.mutate_mask(&written, span, condition.to_token_stream()),
            None => condition.to_token_stream(),
        };
        let yes = &branch.then_branch;
        let no = branch.else_branch.as_ref().map(|(_, otherwise)| otherwise);
        Expr::Verbatim(quote_spanned!(span=> #choose(#condition, #[inline(always)] || #yes, #[inline(always)] || #no)))
    }

    /// A `match` is decided while generating: it stays.
    pub(crate) fn choice(&mut self, choice: &mut ExprMatch) {
        if self.constants == 0 && matches!(self.kind(&choice.expr), Kind::Mask | Kind::Real) {
            self.errors.at(&choice.expr, "`match` is decided while generating, but this is known for each particle only: write `if a < b { .. } else { .. }`");
        }
        self.visit_expr_mut(&mut choice.expr);
        for arm in &mut choice.arms {
            self.within(Boundary::Plain, |this| {
                this.visit_pat_mut(&mut arm.pat);
                this.scopes.bind_pattern(&arm.pat, Kind::Unknown);
                if let Some((_, guard)) = &mut arm.guard {
                    if this.constants == 0 && this.kind(guard) == Kind::Mask {
                        this.errors.at(&*guard, "a guard is decided while generating, but this is known for each particle only: put an `if` into the arm");
                    } else {
                        this.visit_expr_mut(guard);
                    }
                }
                this.visit_expr_mut(&mut arm.body);
            });
        }
    }
}
