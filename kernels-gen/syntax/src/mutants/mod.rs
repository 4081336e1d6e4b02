//! Mutants: small faults put into an equation on purpose, to see whether a test notices.
//!
//! All of them are compiled at once. Each place of the body that can be wrong becomes a choice between what the author wrote
//! and its faulty variants, `if ETALON_MUTANTS.is(7) { left - right } else { left + right }`, and at run time at most one of
//! them is active. Off, none of this exists: the translation is what it is without this module.
//!
//! The macro sees text, not types. Where a variant may not compile, such as the difference of two things that can only be
//! added, a helper in `kernels-gen/src/equation/mutants.rs` finds out by type and ends the program with a status of its own.

mod apply;
mod calls;
mod constants;
mod decisions;
mod signature;
mod text;

use proc_macro2::{Span, TokenStream};
use quote::quote;
use signature::Prologue;
pub(crate) use text::text;

/// Where a token stands in its file, both from 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Place {
    /// The line.
    pub line: usize,
    /// The column.
    pub column: usize,
}

/// One fault that can be switched on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mutant {
    /// What kind of fault.
    pub operator: &'static str,
    /// What the author wrote.
    pub original: String,
    /// What it becomes.
    pub mutated: String,
    /// Where it is.
    pub place: Place,
}

/// The mutants of one equation, in order: the first has number 1.
pub(crate) struct Mutants<'a> {
    place_of: &'a dyn Fn(Span) -> Place,
    list: Vec<Mutant>,
    /// How many things we are inside of that must stay as they are, such as the length of an array.
    paused: usize,
}

impl<'a> Mutants<'a> {
    pub(crate) fn new(place_of: &'a dyn Fn(Span) -> Place) -> Self {
        Mutants { place_of, list: Vec::new(), paused: 0 }
    }

    /// Enters a mutant; the tokens ask whether it is the active one.
    pub(crate) fn enter(
        &mut self,
        operator: &'static str,
        span: Span,
        original: String,
        mutated: String,
    ) -> TokenStream {
        self.list.push(Mutant { operator, original, mutated, place: (self.place_of)(span) });
        // Numbers fit: an equation of four billion places is refused by the compiler for other reasons.
        let number = u32::try_from(self.list.len()).unwrap_or(u32::MAX);
        quote!(ETALON_MUTANTS.is(#number))
    }

    /// The list, with the faults of the signature entered last.
    pub(crate) fn finish(mut self, function: &syn::ItemFn, real: &str) -> Planted {
        let prologue = signature::prologue(function, real, &mut self);
        Planted { list: self.list, prologue }
    }

    pub(crate) fn pause(&mut self) {
        self.paused += 1;
    }

    pub(crate) fn go_on(&mut self) {
        self.paused -= 1;
    }

    pub(crate) fn is_paused(&self) -> bool {
        self.paused > 0
    }
}

/// All faults of a function, and what of them stands around its body.
pub(crate) struct Planted {
    /// The first has number 1.
    pub(crate) list: Vec<Mutant>,
    pub(crate) prologue: Prologue,
}

/// Variants of one expression, of which the first active one is taken.
#[derive(Default)]
pub(crate) struct Variants(TokenStream);

impl Variants {
    pub(crate) fn add(&mut self, is_active: TokenStream, value: TokenStream) {
        self.0.extend(quote!(if #is_active { #value } else));
    }

    /// With what the author wrote as the last of them.
    pub(crate) fn or(self, original: TokenStream) -> TokenStream {
        let variants = self.0;
        if variants.is_empty() { original } else { quote!(#variants { #original }) }
    }
}
