//! Conditions: turned round, and ignored either way. Arms in each other's place.

use super::apply::held;
use super::{Variants, text};
use crate::translate::Translator;
use proc_macro2::{Span, TokenStream};
use quote::{ToTokens, quote};
use syn::spanned::Spanned;
use syn::visit::Visit;
use syn::{Arm, Expr, ExprMatch, Pat, PatIdent};

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

impl Translator<'_> {
    /// Each arm of a `match` exchanged with the next, where no pattern gives names to what it found.
    pub(super) fn mutate_arms(&mut self, written: &ExprMatch, translated: &mut Expr) {
        let Expr::Match(result) = translated else { return };
        let bodies: Vec<_> = result.arms.iter().map(|arm| arm.body.to_token_stream()).collect();
        let mut variants: Vec<_> = bodies.iter().map(|_| Variants::default()).collect();
        for (i, pair) in written.arms.windows(2).enumerate() {
            let [one, two] = pair else { continue };
            if !is_plain(one) || !is_plain(two) || text(&one.body) == text(&two.body) {
                continue;
            }
            let [one, two] = [text(&one.pat), text(&two.pat)];
            let change = (format!("{one} => .., {two} => .."), format!("{two} => .., {one} => .."));
            let Some(mutants) = &mut self.mutants else { return };
            let is_active = mutants.enter("swapped", pair[0].pat.span(), change.0, change.1);
            variants[i].add(is_active.clone(), bodies[i + 1].clone());
            variants[i + 1].add(is_active, bodies[i].clone());
        }
        for ((arm, variants), body) in result.arms.iter_mut().zip(variants).zip(bodies) {
            *arm.body = Expr::Verbatim(variants.or(body));
            // An arm may have lost its braces.
            arm.comma = Some(Default::default());
        }
    }
}

/// Whether an arm has neither a guard nor names of its own.
fn is_plain(arm: &Arm) -> bool {
    struct Names(bool);
    impl<'ast> Visit<'ast> for Names {
        fn visit_pat_ident(&mut self, _: &'ast PatIdent) {
            self.0 = true;
        }
    }
    let mut names = Names(false);
    names.visit_pat(&arm.pat);
    arm.guard.is_none() && !names.0 && !matches!(arm.pat, Pat::Verbatim(_))
}

fn has_let(condition: &Expr) -> bool {
    match condition {
        Expr::Let(_) => true,
        Expr::Binary(binary) => has_let(&binary.left) || has_let(&binary.right),
        Expr::Paren(inner) => has_let(&inner.expr),
        _ => false,
    }
}
