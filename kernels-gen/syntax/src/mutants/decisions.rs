//! Conditions: turned round, and ignored either way.

use super::apply::held;
use super::{Variants, text};
use crate::translate::Translator;
use proc_macro2::{Span, TokenStream};
use quote::{ToTokens, quote};
use syn::Expr;

impl Translator<'_> {
    /// The condition of an `if` on data, a mask: negated, always true, always false.
    pub(crate) fn mutate_mask(&mut self, written: &Expr, span: Span, condition: TokenStream) -> TokenStream {
        let mask = held("mask");
        let [and, or, not] = ["and", "or", "not"].map(|name| Self::mask_function(name, span));
        let values = [quote!(#not(#mask)), quote!(#or(#mask, #not(#mask))), quote!(#and(#mask, #not(#mask)))];
        self.mutated_condition(written, span, &mask, condition, values)
    }

    /// The condition of an `if` that is decided early: the same.
    pub(crate) fn mutate_flag(&mut self, written: &Expr, span: Span, condition: &mut Expr) {
        if has_let(written) {
            return;
        }
        let flag = held("flag");
        let values = [quote!(!#flag), quote!(true), quote!(false)];
        let tokens = self.mutated_condition(written, span, &flag, condition.to_token_stream(), values);
        *condition = Expr::Verbatim(tokens);
    }

    fn mutated_condition(
        &mut self,
        written: &Expr,
        span: Span,
        name: &syn::Ident,
        condition: TokenStream,
        values: [TokenStream; 3],
    ) -> TokenStream {
        let mut variants = Variants::default();
        let written = text(written);
        let changed = [format!("if !({written})"), "if true".to_string(), "if false".to_string()];
        for (value, changed) in values.into_iter().zip(changed) {
            self.variant(&mut variants, "branch", span, (format!("if {written}"), changed), value);
        }
        let choice = variants.or(name.to_token_stream());
        quote!(({ let #name = #condition; #choice }))
    }
}

fn has_let(condition: &Expr) -> bool {
    match condition {
        Expr::Let(_) => true,
        Expr::Binary(binary) => has_let(&binary.left) || has_let(&binary.right),
        Expr::Paren(inner) => has_let(&inner.expr),
        _ => false,
    }
}
