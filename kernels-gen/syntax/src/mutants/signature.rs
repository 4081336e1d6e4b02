//! Faults of the whole function: parameters of one type in the wrong order, the result with the wrong sign.

use super::{Mutants, Variants, text};
use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use syn::{FnArg, ItemFn, Pat, PatIdent, ReturnType};

/// What surrounds the body.
#[derive(Default)]
pub(crate) struct Prologue {
    /// Stands before it: parameters exchanged.
    pub(crate) exchanges: TokenStream,
    /// Whether the result is wrong in sign; nothing where it may not have one.
    pub(crate) negates: Option<TokenStream>,
}

/// Enters the faults of a function's signature.
pub(crate) fn prologue(function: &ItemFn, real: &str, mutants: &mut Mutants) -> Prologue {
    let mut prologue = Prologue::default();
    let inputs: Vec<_> = function.sig.inputs.iter().filter_map(plain).collect();
    for pair in inputs.windows(2) {
        let [(one, one_type), (two, two_type)] = pair else { continue };
        if one_type != two_type || one_type == "usize" {
            continue;
        }
        let (one, two) = (&one.ident, &two.ident);
        let change = (format!("fn(.., {one}, {two}, ..)"), format!("fn(.., {two}, {one}, ..)"));
        let is_active = mutants.enter("swapped", one.span(), change.0, change.1);
        let mut variants = Variants::default();
        variants.add(is_active, quote!((#two, #one)));
        let choice = variants.or(quote!((#one, #two)));
        prologue.exchanges.extend(quote!(let (#one, #two) = #choice;));
    }
    if let ReturnType::Type(_, ty) = &function.sig.output
        && let name = text(ty)
        && (name == real || ["Vector", "Matrix", "Symmetric"].iter().any(|kind| name.starts_with(kind)))
    {
        let change = (function.sig.ident.to_string(), format!("-{}", function.sig.ident));
        prologue.negates = Some(mutants.enter("sign", function.sig.ident.span(), change.0, change.1));
    }
    prologue
}

/// A parameter that is only a name, with the text of its type.
fn plain(input: &FnArg) -> Option<(&PatIdent, String)> {
    let FnArg::Typed(input) = input else { return None };
    match &*input.pat {
        Pat::Ident(name) if name.mutability.is_none() && name.by_ref.is_none() && name.subpat.is_none() => {
            Some((name, input.ty.to_token_stream().to_string()))
        }
        _ => None,
    }
}
