//! Numbers that are slightly wrong, or not there.

use super::apply::{held, helper};
use super::{Variants, text};
use crate::scopes::Kind;
use crate::signature::float_name;
use crate::translate::Translator;
use proc_macro2::{Span, TokenStream, TokenTree};
use quote::{ToTokens, quote};
use syn::spanned::Spanned;
use syn::{Expr, ExprCall, Ident, Lit, LitFloat, LitInt};

/// By how much a constant is scaled: little enough to be overlooked, far beyond rounding.
const SCALE: f64 = 1.01;

/// What a dimension can be.
const DIMENSIONS: [usize; 3] = [1, 2, 3];

impl Translator<'_> {
    /// `2.0` as `2.02` and `0.0`, `0.0` as `1.0` and `-1.0`, `-2.0` also as `2.0`; `3` as `4` and `2`.
    pub(super) fn mutate_literal(&mut self, written: &Expr, literal: &Lit, negative: bool, translated: &mut Expr) {
        let span = written.span();
        let mut variants = Variants::default();
        match literal {
            Lit::Float(float) => {
                let Ok(value) = float.base10_parse::<f64>() else { return };
                let value = if negative { -value } else { value };
                let others = match value == 0.0 {
                    true => vec![1.0, -1.0],
                    // Shortest digits, so that 1.01 times 0.1 does not read 0.10100000000000001.
                    false => vec![format!("{:.12e}", value * SCALE).parse().unwrap_or(value * SCALE), 0.0],
                };
                let others = others.into_iter().chain(negative.then_some(-value));
                for other in others {
                    let other = signed(other, float.suffix(), span);
                    self.variant(&mut variants, "constant", span, (text(written), text(&other)), other);
                }
                let choice = variants.or(written.to_token_stream());
                *translated = Expr::Verbatim(if self.constants > 0 {
                    quote!((#choice))
                } else {
                    let lit = self.real_function("lit", span);
                    quote!(#lit(#choice))
                });
            }
            Lit::Int(integer) => {
                let Ok(value) = integer.base10_parse::<u64>() else { return };
                let others = [value.checked_add(1), value.checked_sub(1)];
                for other in others.into_iter().flatten() {
                    let other = LitInt::new(&format!("{other}{}", integer.suffix()), span);
                    let other = if negative { quote!(-#other) } else { other.to_token_stream() };
                    self.variant(&mut variants, "integer", span, (text(written), text(&other)), other);
                }
                let choice = variants.or(written.to_token_stream());
                *translated = Expr::Verbatim(quote!((#choice)));
            }
            _ => {}
        }
    }

    /// Names, fields and elements inside of `R::lit(..)`, and casts to whole numbers anywhere.
    pub(super) fn mutate_constant(&mut self, written: &Expr, translated: &mut Expr) {
        let mut variants = Variants::default();
        let (value, span) = (held("value"), written.span());
        let is_integer = self.kind(written) == Kind::Integer;
        let is_cast = match written {
            Expr::Cast(cast) => is_integer || self.constants > 0 && float_name(&cast.ty).is_some(),
            _ => false,
        };
        if is_cast && is_integer {
            for sign in ["+", "-"] {
                let operator: syn::BinOp =
                    if sign == "+" { syn::BinOp::Add(Default::default()) } else { syn::BinOp::Sub(Default::default()) };
                let change = (text(written), format!("{} {sign} 1", text(written)));
                self.variant(&mut variants, "integer", span, change, quote!(#value #operator 1));
            }
        } else if self.constants > 0 && !is_integer && (is_cast || !matches!(written, Expr::Cast(_))) {
            let constant = helper("Constant");
            for (name, other) in [("scaled", format!("{SCALE:?} * {}", text(written))), ("gone", "0.0".to_string())] {
                let name = held(name);
                let change = (text(written), other);
                let call = quote!(#constant::of(&#value).#name(#value));
                self.variant(&mut variants, "constant", span, change, call);
            }
            let scaled = held("scaled");
            self.scaled_in_one_dimension(&mut variants, written, span, quote!(#constant::of(&#value).#scaled(#value)));
        } else {
            return;
        }
        let choice = variants.or(value.to_token_stream());
        *translated = Expr::Verbatim(quote!(({ let #value = #translated; #choice })));
    }
}

impl Translator<'_> {
    /// `R::constant(NAME)`: slightly wrong, or not there.
    pub(super) fn mutate_exact_constant(&mut self, written: &Expr, span: Span, translated: &mut Expr) {
        let mut variants = Variants::default();
        let (value, lit) = (held("value"), self.real_function("lit", span));
        let scaled = quote!(#lit(#SCALE) * #value);
        let change = |to: String| (text(written), to);
        self.variant(&mut variants, "constant", span, change(format!("{SCALE:?} * {}", text(written))), scaled.clone());
        self.variant(&mut variants, "constant", span, change("0.0".to_string()), quote!(#lit(0.0)));
        self.scaled_in_one_dimension(&mut variants, written, span, scaled);
        let choice = variants.or(value.to_token_stream());
        *translated = Expr::Verbatim(quote!(({ let #value = #translated; #choice })));
    }

    /// A constant that the dimension decides may be right in some and wrong in one: an entry of a table.
    fn scaled_in_one_dimension(&mut self, variants: &mut Variants, written: &Expr, span: Span, scaled: TokenStream) {
        let Some(size) = self.scopes.sizes().iter().find(|size| mentions(written.to_token_stream(), size)).cloned()
        else {
            return;
        };
        let value = held("value");
        for dimension in DIMENSIONS {
            let change = (text(written), format!("{SCALE:?} * {} where {size} = {dimension}", text(written)));
            let choice = quote!(if #size == #dimension { #scaled } else { #value });
            self.variant(variants, "constant", span, change, choice);
        }
    }

    /// Whether this is `R::constant(..)`.
    pub(super) fn is_exact_constant(&self, call: &ExprCall) -> bool {
        let Expr::Path(path) = &*call.func else { return false };
        let mut segments = path.path.segments.iter().rev();
        segments.next().is_some_and(|name| name.ident == "constant")
            && segments.next().is_some_and(|owner| owner.ident == *self.scopes.real())
    }
}

/// Whether a name stands anywhere in some tokens.
fn mentions(tokens: TokenStream, name: &Ident) -> bool {
    tokens.into_iter().any(|token| match token {
        TokenTree::Ident(other) => other == *name,
        TokenTree::Group(group) => mentions(group.stream(), name),
        _ => false,
    })
}

/// A float literal with its sign in front.
fn signed(value: f64, suffix: &str, span: proc_macro2::Span) -> proc_macro2::TokenStream {
    let size = LitFloat::new(&format!("{:?}{suffix}", value.abs()), span);
    if value < 0.0 { quote!(-#size) } else { size.to_token_stream() }
}
