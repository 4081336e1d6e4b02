//! What the `#[equation]` macro accepts, and how it translates it.
//!
//! An equation is written once, as a generic function of some `R: Real`, with plain literals, `if` and `<`. This crate turns
//! those into calls of the number trait, so that the same function runs on scalars, on vector lanes and on symbols. `README.md`
//! beside this crate lists the language.
//!
//! It is an ordinary library, so that it can be tested and fuzzed without a compiler around it: the macro crate is a thin
//! shell. It never panics, and it reports every error of a function at once, each at its own token.
#![forbid(unsafe_code)]

mod advice;
mod arguments;
mod emit;
mod errors;
mod macros;
mod mutants;
mod scopes;
mod signature;
mod translate;

use arguments::Arguments;
use errors::Errors;
pub use mutants::{Mutant, Place};
use proc_macro2::{Span, TokenStream};
use syn::ItemFn;

/// What the library cannot know by itself.
pub struct Surroundings<'a> {
    /// Whether the ledger has an equation of this id; if not, the sentence to show.
    pub check_id: &'a dyn Fn(&str) -> Result<(), String>,
    /// The function as its author wrote it, if the compiler still has the text; else its tokens are printed.
    pub source_text: Option<String>,
    /// Whether the function is to carry its mutants, and if so where a token stands in its file.
    pub mutants: Option<&'a dyn Fn(Span) -> Place>,
}

impl Surroundings<'_> {
    /// Any id is good, no source text is known, and there are no mutants: for tests.
    pub const NONE: Surroundings<'static> = Surroundings { check_id: &|_| Ok(()), source_text: None, mutants: None };
}

/// Translates the function `item` under `#[equation(attribute)]`.
///
/// # Errors
/// All errors of the attribute and of the function, combined, each with the span of the token it is about.
pub fn translate(attribute: TokenStream, item: TokenStream, around: &Surroundings) -> syn::Result<TokenStream> {
    let function = parse(item)?;
    translate_function(attribute, function, around)
}

/// As [`translate`], for the compiler: errors become `compile_error!` at their tokens, followed by the function's signature
/// with an empty body, so that its callers do not add complaints of their own.
pub fn expand(attribute: TokenStream, item: TokenStream, around: &Surroundings) -> TokenStream {
    let function = match parse(item) {
        Ok(function) => function,
        Err(error) => return error.to_compile_error(),
    };
    match translate_function(attribute, function.clone(), around) {
        Ok(tokens) => tokens,
        Err(error) => {
            let mut tokens = error.to_compile_error();
            tokens.extend(emit::placeholder(function));
            tokens
        }
    }
}

/// A function that equations are made of and that is none itself: left as it is, unless it is to carry mutants.
pub fn expand_part(item: TokenStream, around: &Surroundings) -> TokenStream {
    let Some(place_of) = around.mutants else { return item };
    let mut function = match parse(item) {
        Ok(function) => function,
        Err(error) => return error.to_compile_error(),
    };
    let mut errors = Errors::default();
    let reals = signature::real_parameters(&function.sig.generics);
    let Some(real) = reals.first() else {
        errors.at(
            &function.sig.ident,
            "a part of an equation is generic over its number type: write `fn name<R: Real>(...)`",
        );
        return errors.finish().map_or_else(|error| error.to_compile_error(), |()| TokenStream::new());
    };
    let planted = translate::body(&mut function, real, &mut errors, Some(mutants::Mutants::new(place_of)));
    match errors.finish() {
        Ok(()) => emit::part(function, planted),
        Err(error) => error.to_compile_error(),
    }
}

/// The faults that a function gets where it is to carry them, an equation or a part of equations; number 1 first.
///
/// For who reads the source and does not compile it. `place_of` says where a token stands.
///
/// # Errors
/// All errors of the function's body, combined.
pub fn mutants(item: TokenStream, place_of: &dyn Fn(Span) -> Place) -> syn::Result<Vec<Mutant>> {
    let mut function = parse(item)?;
    let mut errors = Errors::default();
    let reals = signature::real_parameters(&function.sig.generics);
    let mutants = Some(mutants::Mutants::new(place_of));
    let planted = reals.first().and_then(|real| translate::body(&mut function, real, &mut errors, mutants));
    errors.finish()?;
    Ok(planted.map_or_else(Vec::new, |planted| planted.list))
}

fn parse(item: TokenStream) -> syn::Result<ItemFn> {
    syn::parse2(item).map_err(|mut error| {
        error.combine(syn::Error::new(error.span(), "#[equation] stands on a function with a body"));
        error
    })
}

fn translate_function(attribute: TokenStream, mut function: ItemFn, around: &Surroundings) -> syn::Result<TokenStream> {
    let mut errors = Errors::default();
    let arguments = arguments::parse(attribute, around.check_id, &mut errors);
    let text = around.source_text.clone().unwrap_or_else(|| emit::token_text(&function));
    if let Some(Arguments { source, host: true }) = &arguments {
        signature::check_host(&function, &mut errors);
        errors.finish()?;
        return Ok(emit::host(function, source, &text));
    }
    let real = signature::check(&function, &mut errors);
    let mutants = around.mutants.map(mutants::Mutants::new);
    let planted = real.as_ref().and_then(|real| translate::body(&mut function, real, &mut errors, mutants));
    errors.finish()?;
    match (arguments, real) {
        (Some(arguments), Some(real)) => Ok(emit::function(function, &real, &arguments.source, &text, planted)),
        // Without an error both are there; this is only to have no panic even so.
        _ => Err(syn::Error::new(proc_macro2::Span::call_site(), "the equation could not be understood")),
    }
}
