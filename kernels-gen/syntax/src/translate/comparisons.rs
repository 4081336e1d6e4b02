//! Comparisons, and what joins them.

use super::{Translator, generated};
use crate::scopes::Kind;
use quote::quote_spanned;
use syn::spanned::Spanned;
use syn::visit_mut::{self, VisitMut};
use syn::{BinOp, Expr, ExprBinary};

/// `<`, `<=`, `>` or `>=`.
pub(crate) fn is_order(operator: &BinOp) -> bool {
    matches!(operator, BinOp::Lt(_) | BinOp::Le(_) | BinOp::Gt(_) | BinOp::Ge(_))
}

/// Its name in the number trait.
pub(crate) fn order_name(operator: &BinOp) -> &'static str {
    match operator {
        BinOp::Lt(_) => "lt",
        BinOp::Le(_) => "le",
        BinOp::Gt(_) => "gt",
        _ => "ge",
    }
}

fn is_compound(operator: &BinOp) -> bool {
    use BinOp::{AddAssign, DivAssign, MulAssign, RemAssign, SubAssign};
    matches!(operator, AddAssign(_) | SubAssign(_) | MulAssign(_) | DivAssign(_) | RemAssign(_))
        || is_bitwise_assignment(operator)
}

fn is_bitwise_assignment(operator: &BinOp) -> bool {
    use BinOp::{BitAndAssign, BitOrAssign, BitXorAssign, ShlAssign, ShrAssign};
    matches!(operator, BitAndAssign(_) | BitOrAssign(_) | BitXorAssign(_) | ShlAssign(_) | ShrAssign(_))
}

impl Translator<'_> {
    /// Whether a comparison is one of whole numbers, which is decided while generating.
    pub(crate) fn compares_integers(&self, binary: &ExprBinary) -> bool {
        self.kind(&binary.left) == Kind::Integer || self.kind(&binary.right) == Kind::Integer
    }

    pub(crate) fn binary(&mut self, expr: &mut Expr) {
        let Expr::Binary(binary) = expr else { return };
        if self.constants > 0 {
            visit_mut::visit_expr_binary_mut(self, binary);
            return;
        }
        match &binary.op {
            operator if is_order(operator) => {
                if self.compares_integers(binary) {
                    self.refuse_mixed_comparison(binary);
                    visit_mut::visit_expr_binary_mut(self, binary);
                } else {
                    *expr = self.comparison(binary);
                }
            }
            BinOp::And(_) | BinOp::Or(_) => match self.kind(expr) {
                Kind::Mask => self.joined(expr),
                _ => visit_mut::visit_expr_mut(self, expr),
            },
            BinOp::Eq(_) | BinOp::Ne(_) => {
                self.refuse_equality(binary);
                visit_mut::visit_expr_binary_mut(self, binary);
            }
            operator if is_compound(operator) => self.compound_assignment(expr),
            operator => {
                let is_real = |side| self.kind(side) == Kind::Real;
                if matches!(operator, BinOp::Rem(_)) && (is_real(&binary.left) || is_real(&binary.right)) {
                    self.errors.at(
                        operator,
                        "the remainder of reals is not offered on every target: it jumps for a last-bit difference",
                    );
                }
                visit_mut::visit_expr_binary_mut(self, binary);
            }
        }
    }

    /// `a < b` as `<R as Real>::lt(a, b)`.
    fn comparison(&mut self, binary: &mut ExprBinary) -> Expr {
        let function = self.real_function(order_name(&binary.op), binary.op.span());
        let written = self.is_mutating().then(|| binary.clone());
        let (mut left, mut right) = (Self::take(&mut binary.left), Self::take(&mut binary.right));
        self.visit_expr_mut(&mut left);
        self.visit_expr_mut(&mut right);
        let (left, right) = (without_parentheses(left), without_parentheses(right));
        Expr::Verbatim(match written {
            Some(written) => self.mutate_comparison(&written, function, [left, right]),
            None => quote_spanned!(generated(binary.op.span())=> #function(#left, #right)),
        })
    }

    /// `a && b` of masks as `Mask::and(a, b)`.
    fn joined(&mut self, expr: &mut Expr) {
        let Expr::Binary(binary) = expr else { return };
        let name = if matches!(binary.op, BinOp::And(_)) { "and" } else { "or" };
        let function = Self::mask_function(name, binary.op.span());
        let span = generated(binary.op.span());
        let written = self.is_mutating().then(|| binary.clone());
        let (mut left, mut right) = (Self::take(&mut binary.left), Self::take(&mut binary.right));
        self.mask(&mut left);
        self.mask(&mut right);
        let (left, right) = (without_parentheses(left), without_parentheses(right));
        *expr = Expr::Verbatim(match written {
            Some(written) => self.mutate_joined(&written, function, [left, right]),
            None => quote_spanned!(span=> #function(#left, #right)),
        });
    }

    /// Translates an operand that has to be a mask.
    pub(crate) fn mask(&mut self, expr: &mut Expr) {
        if let Expr::Let(pattern) = expr {
            self.errors.at(pattern.let_token, "`let` is decided while generating, the comparison beside it for each particle: nest two `if`s, the `if let` outside");
            return;
        }
        if matches!(self.kind(expr), Kind::Flag | Kind::Integer) {
            self.errors.at(
                &*expr,
                "this is decided while generating, the comparison beside it for each particle: nest two `if`s, this one outside \
                 (`if THIS { if a < b { x } else { y } } else { y }`)",
            );
            return;
        }
        self.visit_expr_mut(expr);
    }

    fn refuse_mixed_comparison(&mut self, binary: &ExprBinary) {
        for (side, other) in [(&binary.left, &binary.right), (&binary.right, &binary.left)] {
            if self.kind(side) == Kind::Real
                && let Expr::Lit(literal) = &**other
            {
                use quote::ToTokens;
                let number = literal.to_token_stream();
                self.errors.at(literal, format!("a real is compared with a real: write `{number}.0`"));
            }
        }
    }

    fn refuse_equality(&mut self, binary: &ExprBinary) {
        let sides = [self.kind(&binary.left), self.kind(&binary.right)];
        if sides.contains(&Kind::Real) {
            self.errors.at(
                binary.op,
                "equality of reals turns on a last bit and is not offered; compare with `<` or `<=`, against a margin you can defend",
            );
        } else if sides.contains(&Kind::Mask) {
            self.errors.at(binary.op, "outcomes of comparisons are joined with `&&`, `||` and `!`");
        }
    }
}

/// The inside of parentheses, which an argument of a function does not need.
pub(crate) fn without_parentheses(expr: Expr) -> Expr {
    match expr {
        Expr::Paren(inner) if inner.attrs.is_empty() => without_parentheses(*inner.expr),
        other => other,
    }
}
