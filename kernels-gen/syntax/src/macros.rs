//! Macros inside an equation: only those that decide something while generating.

use crate::scopes::Kind;
use crate::translate::Translator;
use quote::ToTokens;
use syn::parse::{Parse, ParseStream, Parser};
use syn::punctuated::Punctuated;
use syn::visit_mut::VisitMut;
use syn::{Expr, Macro, Pat, Token};

/// `matches!(value, pattern if guard)`.
struct Matches {
    value: Expr,
    guard: Option<Expr>,
}

impl Parse for Matches {
    fn parse(input: ParseStream) -> syn::Result<Self> {
        let value = input.parse()?;
        input.parse::<Token![,]>()?;
        Pat::parse_multi_with_leading_vert(input)?;
        let guard = match input.parse::<Option<Token![if]>>()? {
            Some(_) => Some(input.parse()?),
            None => None,
        };
        input.parse::<Option<Token![,]>>()?;
        Ok(Matches { value, guard })
    }
}

impl Translator<'_> {
    pub(crate) fn macro_call(&mut self, call: &Macro) {
        let name = call.path.segments.last().map(|segment| segment.ident.to_string()).unwrap_or_default();
        match name.as_str() {
            "assert" | "debug_assert" => match Punctuated::<Expr, Token![,]>::parse_terminated.parse2(call.tokens.clone()) {
                Ok(arguments) => arguments.into_iter().take(1).for_each(|condition| self.untranslated(&name, condition)),
                Err(error) => self.errors.add(error),
            },
            "matches" => match syn::parse2::<Matches>(call.tokens.clone()) {
                Ok(matches) => {
                    self.untranslated(&name, matches.value);
                    matches.guard.into_iter().for_each(|guard| self.untranslated(&name, guard));
                }
                Err(error) => self.errors.add(error),
            },
            "unreachable" => {}
            _ => self.errors.at(
                &call.path,
                format!(
                    "`{name}!` cannot be looked into; an equation may use assert!, debug_assert!, matches! and unreachable! (and \
                     functions, instead of macros of its own)"
                ),
            ),
        }
    }

    /// An expression inside a macro, which stays as it is: so it must need no translation.
    fn untranslated(&mut self, name: &str, expr: Expr) {
        if self.constants == 0 && matches!(self.kind(&expr), Kind::Mask) {
            self.errors.at(
                &expr,
                format!("`{name}!` is decided while generating, but this is known for each particle only: state the domain in the doc comment"),
            );
            return;
        }
        let mut translated = expr.clone();
        self.without_mutants(|this| this.visit_expr_mut(&mut translated));
        if translated.to_token_stream().to_string() != expr.to_token_stream().to_string() {
            self.errors
                .at(&expr, format!("nothing is translated inside `{name}!`: give this a name with `let` before it"));
        }
    }
}
