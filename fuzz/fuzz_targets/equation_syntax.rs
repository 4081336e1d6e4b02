//! Any text, as an equation's body and as a whole item: the macro's library must answer, with Rust or with errors.
//!
//! `README.md` says how to run it.
#![no_main]

use etalon_equation_syntax::{Surroundings, expand};
use libfuzzer_sys::{Corpus, fuzz_target};
use proc_macro2::TokenStream;

const ATTRIBUTE: &str = "\"gs25:8\"";

fuzz_target!(|text: &str| -> Corpus {
    // The compiler hands a macro only what it has parsed itself, so nothing can nest deeper than its own stack allows.
    let deep = text.bytes().filter(|byte| b"([{-!&*|<".contains(byte)).count() > 200;
    let Ok(tokens) = text.parse::<TokenStream>() else { return Corpus::Reject };
    if deep {
        return Corpus::Reject;
    }
    answers(ATTRIBUTE.parse().unwrap_or_default(), tokens.clone());
    answers(tokens, "/// D.\nfn f<R: Real>(x: R) -> R { x }".parse().unwrap_or_default());
    let body = format!("/// D.\nfn f<R: Real, const D: usize>(x: R, n: usize, flag: bool) -> R {{ {text} }}");
    if let Ok(function) = body.parse() {
        answers(ATTRIBUTE.parse().unwrap_or_default(), function);
    }
    Corpus::Keep
});

/// What comes out is Rust, be it only `compile_error!`.
fn answers(attribute: TokenStream, item: TokenStream) {
    let output = expand(attribute, item, &Surroundings::NONE);
    assert!(syn::parse2::<syn::File>(output).is_ok(), "the output is no Rust");
}
