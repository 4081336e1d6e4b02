//! Calls: other functions in their place, none at all, arguments exchanged.

use super::apply::{held, helper};
use super::{Variants, text};
use crate::scopes::Kind;
use crate::translate::Translator;
use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use syn::punctuated::Punctuated;
use syn::spanned::Spanned;
use syn::{Expr, ExprCall, ExprMethodCall, Ident, Token, UnOp};

/// What a method is taken for.
fn replacements(name: &str) -> &'static [(&'static str, &'static str)] {
    match name {
        "min" => &[("max", "min/max")],
        "max" => &[("min", "min/max")],
        "norm" => &[("norm_squared", "method")],
        "norm_squared" => &[("norm", "method")],
        "lt" => &[("gt", "direction"), ("le", "strictness")],
        "le" => &[("ge", "direction"), ("lt", "strictness")],
        "gt" => &[("lt", "direction"), ("ge", "strictness")],
        "ge" => &[("le", "direction"), ("gt", "strictness")],
        "and" => &[("or", "logic")],
        "or" => &[("and", "logic")],
        _ => &[],
    }
}

/// Whether a method may be forgotten: its receiver is of the type of its result.
fn is_forgettable(name: &str) -> bool {
    matches!(name, "sqrt" | "abs" | "squared" | "not" | "min" | "max" | "scale")
}

impl Translator<'_> {
    /// `R::zero()` as `R::one()`; arguments exchanged with their neighbours.
    pub(super) fn mutate_call(&mut self, written: &Expr, call: &ExprCall, translated: &mut Expr) {
        let Expr::Call(result) = &*translated else { return };
        if let Some(other) = self.other_unit(call) {
            let mut variants = Variants::default();
            self.variant(&mut variants, "constant", call.func.span(), (text(written), text(&other)), other);
            let choice = variants.or(translated.to_token_stream());
            *translated = Expr::Verbatim(quote!((#choice)));
            return;
        }
        let is_lit =
            matches!(&*call.func, Expr::Path(path) if path.path.segments.last().is_some_and(|s| s.ident == "lit"));
        if is_lit {
            return;
        }
        if self.is_exact_constant(call) {
            self.mutate_exact_constant(written, call.func.span(), translated);
            return;
        }
        let function = result.func.to_token_stream();
        let rest = |arguments: &Punctuated<Expr, Token![,]>| {
            let mut other = call.clone();
            other.args = arguments.clone();
            text(other)
        };
        let (bindings, names) = self.exchanges(written, &call.args, &result.args, &rest);
        if !bindings.is_empty() {
            *translated = Expr::Verbatim(quote!(({ #bindings #function(#(#names),*) })));
        }
    }

    /// `R::one()` for `R::zero()` and the other way round.
    fn other_unit(&self, call: &ExprCall) -> Option<TokenStream> {
        let Expr::Path(path) = &*call.func else { return None };
        let mut segments = path.path.segments.iter().rev();
        let (name, owner) = (segments.next()?, segments.next()?);
        if owner.ident != *self.scopes.real() || !call.args.is_empty() {
            return None;
        }
        let other = match name.ident.to_string().as_str() {
            "zero" => held("one"),
            "one" => held("zero"),
            _ => return None,
        };
        let owner = &owner.ident;
        Some(quote!(#owner::#other()))
    }

    /// Methods that are taken for others, or forgotten; arguments exchanged with their neighbours.
    pub(super) fn mutate_method(&mut self, written: &Expr, call: &ExprMethodCall, translated: &mut Expr) {
        let Expr::MethodCall(result) = &*translated else { return };
        let name = call.method.to_string();
        let rest = |arguments: &Punctuated<Expr, Token![,]>| {
            let mut other = call.clone();
            other.args = arguments.clone();
            text(other)
        };
        let (bindings, names) = self.exchanges(written, &call.args, &result.args, &rest);
        let is_known = is_forgettable(&name) || !replacements(&name).is_empty() || name == "mul_add" || name == "power";
        if bindings.is_empty() && !is_known || call.args.iter().any(|argument| matches!(argument, Expr::Closure(_))) {
            if !bindings.is_empty() {
                let mut other = result.clone();
                other.args = names.iter().map(|name| Expr::Verbatim(name.clone())).collect();
                *translated = Expr::Verbatim(quote!(({ #bindings #other })));
            }
            return;
        }
        let receiver = held("receiver");
        let own_names: Vec<Ident> = (0..names.len()).map(|i| held(&format!("given_{i}"))).collect();
        let mut variants = Variants::default();
        self.other_methods(&mut variants, written, call, &receiver, &own_names);
        let (method, turbofish, before) = (&result.method, &result.turbofish, &result.receiver);
        let choice = variants.or(quote!(#receiver.#method #turbofish(#(#own_names),*)));
        *translated =
            Expr::Verbatim(quote!(({ #bindings let #receiver = #before; #(let #own_names = #names;)* #choice })));
    }

    fn other_methods(
        &mut self,
        variants: &mut Variants,
        written: &Expr,
        call: &ExprMethodCall,
        receiver: &Ident,
        names: &[Ident],
    ) {
        let (span, before) = (call.method.span(), text(written));
        let (method, name) = (&call.method, call.method.to_string());
        let whole = quote!(#receiver.#method(#(#names),*));
        let exchange = helper("Exchange");
        for (other, operator) in replacements(&name) {
            let changed = ExprMethodCall { method: Ident::new(other, span), ..call.clone() };
            let other = held(other);
            let value = quote!(#receiver.#other(#(#names),*));
            self.variant(variants, operator, span, (before.clone(), text(changed)), value);
        }
        // Only the receiver, or only the argument, if it is of the type of the whole.
        let mut only = |this: &mut Self, part: &Ident, change: String| {
            let value = quote!({ let whole = #whole; #exchange::of(&whole, &#part).second(whole, #part) });
            this.variant(variants, "dropped", span, (before.clone(), change), value);
        };
        if is_forgettable(&name) {
            only(self, receiver, text(&call.receiver));
        }
        if let ("min" | "max", [argument]) = (name.as_str(), names) {
            only(self, argument, text(call.args.first()));
        }
        let negated = |at: usize| {
            let mut changed = call.clone();
            if let Some(argument) = changed.args.iter_mut().nth(at) {
                let value = argument.clone();
                *argument = syn::parse_quote!(-(#value));
            }
            text(changed)
        };
        match (name.as_str(), names) {
            ("scale", [factor]) => {
                self.variant(variants, "sign", span, (before, negated(0)), quote!(#receiver.scale(-#factor)));
            }
            ("mul_add", [factor, addend]) => {
                let value = quote!(#receiver.mul_add(#factor, -#addend));
                self.variant(variants, "sign", span, (before, negated(1)), value);
            }
            ("power", [exponent]) if matches!(call.args.first(), Some(Expr::Path(_) | Expr::Field(_))) => {
                let argument = text(&call.args);
                let on = text(&call.receiver);
                for (sign, value) in [("+", quote!(#exponent + 1)), ("-", quote!(#exponent - 1))] {
                    let change = (before.clone(), format!("{on}.power({argument} {sign} 1)"));
                    self.variant(variants, "integer", span, change, quote!(#receiver.power(#value)));
                }
            }
            _ => {}
        }
    }

    /// Arguments bound to names, with the choice of exchanging each with the next; and what to hand over in the end.
    fn exchanges(
        &mut self,
        written: &Expr,
        before: &Punctuated<Expr, Token![,]>,
        after: &Punctuated<Expr, Token![,]>,
        with: &dyn Fn(&Punctuated<Expr, Token![,]>) -> String,
    ) -> (TokenStream, Vec<TokenStream>) {
        let mut handed: Vec<TokenStream> = after.iter().map(ToTokens::to_token_stream).collect();
        let mut bindings = TokenStream::new();
        let can_move: Vec<bool> = before.iter().map(|argument| self.can_be_exchanged(argument)).collect();
        let texts: Vec<String> = before.iter().map(text).collect();
        let pairs: Vec<usize> = (1..before.len())
            .filter(|&i| can_move[i - 1] && can_move[i] && texts[i - 1] != texts[i])
            .map(|i| i - 1)
            .collect();
        let name = |i: usize| held(&format!("argument_{i}"));
        for (i, value) in handed.iter_mut().enumerate() {
            if pairs.contains(&i) || i > 0 && pairs.contains(&(i - 1)) {
                let name = name(i);
                bindings.extend(quote!(let #name = #value;));
                *value = name.to_token_stream();
            }
        }
        let exchange = helper("Exchange");
        for i in pairs {
            let mut other: Vec<Expr> = before.iter().cloned().collect();
            other.swap(i, i + 1);
            let change = (text(written), with(&other.into_iter().collect()));
            let (one, two) = (name(i), name(i + 1));
            let mut variants = Variants::default();
            let swapped = quote!(#exchange::of(&#one, &#two).exchanged(#one, #two));
            self.variant(&mut variants, "swapped", before[i].span(), change, swapped);
            let choice = variants.or(quote!((#one, #two)));
            bindings.extend(quote!(let (#one, #two) = #choice;));
        }
        (bindings, handed)
    }

    /// Plain values. A literal whole number has no type of its own, and the exchange would give it one.
    fn can_be_exchanged(&self, argument: &Expr) -> bool {
        match argument {
            Expr::Closure(_) => false,
            Expr::Unary(unary) if matches!(unary.op, UnOp::Neg(_)) => self.can_be_exchanged(&unary.expr),
            Expr::Reference(reference) => reference.mutability.is_none(),
            argument => !matches!(self.kind(argument), Kind::Integer | Kind::Flag | Kind::Mask),
        }
    }

    /// Each member of a struct, tuple or array with the wrong sign.
    pub(super) fn mutate_parts(&mut self, written: &Expr, translated: &mut Expr) {
        if self.constants > 0 {
            return;
        }
        match (written, translated) {
            (Expr::Struct(before), Expr::Struct(after)) => {
                for (before, after) in before.fields.iter().zip(&mut after.fields) {
                    if after.colon_token.is_none() {
                        after.colon_token = Some(Token![:](before.member.span()));
                    }
                    let member = before.member.to_token_stream().to_string();
                    self.mutate_part(&format!("{member}: "), &before.expr, &mut after.expr);
                }
            }
            (Expr::Tuple(before), Expr::Tuple(after)) => {
                before.elems.iter().zip(&mut after.elems).for_each(|(b, a)| self.mutate_part("", b, a));
            }
            (Expr::Array(before), Expr::Array(after)) => {
                before.elems.iter().zip(&mut after.elems).for_each(|(b, a)| self.mutate_part("", b, a));
            }
            _ => {}
        }
    }

    fn mutate_part(&mut self, member: &str, before: &Expr, after: &mut Expr) {
        let is_number = matches!(self.kind(before), Kind::Real | Kind::Unknown);
        // Of a literal the sign is the least that can be wrong; members of members have their own.
        let is_other = matches!(
            before,
            Expr::Closure(_) | Expr::Reference(_) | Expr::Lit(_) | Expr::Struct(_) | Expr::Tuple(_) | Expr::Array(_)
        );
        if !is_number || is_other {
            return;
        }
        let (value, sign) = (held("value"), helper("Sign"));
        let mut variants = Variants::default();
        let change = (format!("{member}{}", text(before)), format!("{member}-({})", text(before)));
        self.variant(&mut variants, "sign", before.span(), change, quote!(#sign::of(&#value).negated(#value)));
        let choice = variants.or(value.to_token_stream());
        *after = Expr::Verbatim(quote!(({ let #value = #after; #choice })));
    }
}
