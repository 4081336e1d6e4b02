//! Literals: `0.5` is a constant of the number type.

use super::comparisons::without_parentheses;
use super::{Translator, generated};
use crate::scopes::Kind;
use quote::quote_spanned;
use syn::spanned::Spanned;
use syn::visit_mut::VisitMut;
use syn::{Expr, ExprLit, Lit, Pat, UnOp};

impl Translator<'_> {
    /// `0.5` as `<R as Real>::lit(0.5)`; nothing for other literals.
    pub(crate) fn literal(&mut self, literal: &ExprLit) -> Option<Expr> {
        self.constant(literal, false)
    }

    fn constant(&mut self, literal: &ExprLit, negative: bool) -> Option<Expr> {
        let Lit::Float(float) = &literal.lit else { return None };
        if self.constants > 0 {
            return None;
        }
        if !float.suffix().is_empty() {
            let digits = float.base10_digits();
            self.errors.at(
                float,
                format!("a literal takes the equation's number type: write `{digits}` without `{}`", float.suffix()),
            );
            return None;
        }
        let lit = self.real_function("lit", float.span());
        let span = generated(float.span());
        Some(Expr::Verbatim(match negative {
            true => quote_spanned!(span=> #lit(-#float)),
            false => quote_spanned!(span=> #lit(#float)),
        }))
    }

    /// `-2.0` is one constant; `!` of a mask is the mask's own.
    pub(crate) fn unary(&mut self, expr: &mut Expr) {
        let is_mask = self.constants == 0 && self.kind(expr) == Kind::Mask;
        let Expr::Unary(unary) = expr else { return };
        if matches!(unary.op, UnOp::Neg(_))
            && let Expr::Lit(literal) = &*unary.expr
        {
            if let Some(new) = self.constant(&literal.clone(), true) {
                *expr = new;
            }
            return;
        }
        if matches!(unary.op, UnOp::Not(_)) && is_mask {
            let not = Self::mask_function("not", unary.op.span());
            let mut operand = Self::take(&mut unary.expr);
            self.mask(&mut operand);
            let operand = without_parentheses(operand);
            *expr = Expr::Verbatim(quote_spanned!(generated(operand.span())=> #not(#operand)));
            return;
        }
        self.visit_expr_mut(&mut unary.expr);
    }

    /// A float in a pattern compares for equality, which no target promises.
    pub(crate) fn pattern(&mut self, pattern: &Pat) {
        if let Pat::Lit(literal) = pattern
            && let Lit::Float(float) = &literal.lit
        {
            self.errors.at(float, "reals are not matched against literals; compare with `if x < ...`");
        }
    }
}
