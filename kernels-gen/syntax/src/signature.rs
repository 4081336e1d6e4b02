//! What an equation's signature must look like.

use crate::errors::Errors;
use quote::ToTokens;
use syn::visit::Visit;
use syn::{Attribute, Expr, GenericParam, Generics, Ident, ItemFn, Lit, Meta, Type, TypeParamBound, WherePredicate};

/// Checks the signature and finds the number type: the one type parameter bounded by `Real`.
pub(crate) fn check(function: &ItemFn, errors: &mut Errors) -> Option<Ident> {
    let signature = &function.sig;
    check_documentation(function, errors);
    if let Some(attribute) = function.attrs.iter().find(|a| a.path().is_ident("inline")) {
        errors.at(attribute, "#[equation] adds #[inline(always)] itself; remove this line");
    }
    if let Some(token) = &signature.unsafety {
        errors.at(token, "an equation is plain arithmetic: remove `unsafe`");
    }
    if let Some(token) = &signature.asyncness {
        errors.at(token, "an equation is plain arithmetic: remove `async`");
    }
    if let Some(token) = &signature.constness {
        errors.at(token, "an equation calls the number trait, which is not `const`: remove `const`");
    }
    if let Some(abi) = &signature.abi {
        errors.at(abi, "an equation is an ordinary Rust function: remove the ABI");
    }
    let reals = real_parameters(&signature.generics);
    let real = match reals.as_slice() {
        [one] => Some(one.clone()),
        [] => {
            errors.at(
                &signature.ident,
                format!("an equation is generic over its number type: write `fn {}<R: Real>(...)`", signature.ident),
            );
            None
        }
        [_, others @ ..] => {
            for other in others {
                errors.at(other, "an equation has one number type; use the first one here too");
            }
            None
        }
    };
    let name = real.as_ref().map_or_else(|| "R".to_string(), Ident::to_string);
    let mut floats = Floats { real: &name, errors };
    for input in &signature.inputs {
        floats.visit_fn_arg(input);
    }
    floats.visit_return_type(&signature.output);
    real
}

/// Checks the signature of a function that is computed on the host alone: any, but not that of one that could be translated.
pub(crate) fn check_host(function: &ItemFn, errors: &mut Errors) {
    check_documentation(function, errors);
    for real in real_parameters(&function.sig.generics) {
        errors.at(real, "what is generic over `Real` runs on every target: leave `host` out");
    }
}

fn check_documentation(function: &ItemFn, errors: &mut Errors) {
    if !function.attrs.iter().any(documents) {
        errors.at(
            &function.sig.ident,
            "an equation is its documentation too: write above it what it computes, its symbols with their units, and its \
             source (`/// ...`)",
        );
    }
}

/// A `///` line with words in it.
fn documents(attribute: &Attribute) -> bool {
    let Meta::NameValue(pair) = &attribute.meta else { return false };
    if !pair.path.is_ident("doc") {
        return false;
    }
    match &pair.value {
        Expr::Lit(literal) => match &literal.lit {
            Lit::Str(text) => !text.value().trim().is_empty(),
            _ => false,
        },
        // `#[doc = include_str!("...")]`
        _ => true,
    }
}

/// The type parameters with a bound called `Real`, whether beside them or in the where clause.
pub(crate) fn real_parameters(generics: &Generics) -> Vec<Ident> {
    let is_real = |bound: &TypeParamBound| match bound {
        TypeParamBound::Trait(bound) => bound.path.segments.last().is_some_and(|segment| segment.ident == "Real"),
        _ => false,
    };
    let in_where = |name: &Ident| {
        generics.where_clause.iter().flat_map(|clause| &clause.predicates).any(|predicate| match predicate {
            WherePredicate::Type(predicate) => {
                is_identifier(&predicate.bounded_ty, name) && predicate.bounds.iter().any(is_real)
            }
            _ => false,
        })
    };
    let parameters = generics.params.iter().filter_map(|parameter| match parameter {
        GenericParam::Type(parameter) => Some(parameter),
        _ => None,
    });
    parameters.filter(|p| p.bounds.iter().any(is_real) || in_where(&p.ident)).map(|p| p.ident.clone()).collect()
}

/// Whether a type is this plain name.
pub(crate) fn is_identifier(ty: &Type, name: &Ident) -> bool {
    match ty {
        Type::Path(path) => path.qself.is_none() && path.path.is_ident(name),
        _ => false,
    }
}

/// The name of a float type, if the type is one.
pub(crate) fn float_name(ty: &Type) -> Option<String> {
    let name = ty.to_token_stream().to_string();
    ["f16", "f32", "f64", "f128"].contains(&name.as_str()).then_some(name)
}

struct Floats<'a> {
    real: &'a str,
    errors: &'a mut Errors,
}

impl<'ast> Visit<'ast> for Floats<'_> {
    fn visit_attribute(&mut self, _: &'ast Attribute) {}
    fn visit_type(&mut self, ty: &'ast Type) {
        match float_name(ty) {
            Some(name) => {
                let real = self.real;
                self.errors
                    .at(ty, format!("an equation is generic over its number type: write `{real}` instead of `{name}`"));
            }
            None => syn::visit::visit_type(self, ty),
        }
    }
}
