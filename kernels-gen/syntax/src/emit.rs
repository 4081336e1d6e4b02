//! The translated function, with its documentation, its body under the equation's name, and its entry in the registry.

use crate::arguments::Source;
use crate::mutants::{Mutant, Planted};
use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use syn::{AttrStyle, Attribute, Block, Ident, ItemFn, ReturnType, Type};

/// The whole of what the macro puts in place of the function.
pub(crate) fn function(
    function: ItemFn,
    real: &Ident,
    source: &Source,
    text: &str,
    mutants: Option<Planted>,
) -> TokenStream {
    let ItemFn { attrs, vis, sig, block } = function;
    let (outer, inner) = sides(attrs);
    let name = unraw(&sig.ident);
    let label = source.label();
    let documentation = documentation(source);
    let entry = entry(&name, source, text);
    // A closure may say what it returns unless that is `impl Trait`.
    let output = match &sig.output {
        ReturnType::Type(_, ty) if !has_impl(ty) => sig.output.to_token_stream(),
        _ => quote!(),
    };
    let Around { allowed, entries, exchanges, block } = around(*block, &sig.output, &name, mutants);
    // The language has no loops but those over ranges, so clippy must not ask for others.
    quote! {
        #(#outer)*
        #documentation
        #[inline(always)]
        #[allow(clippy::needless_range_loop)]
        #allowed
        #vis #sig {
            #(#inner)*
            #entry
            #entries
            #exchanges
            <#real as ::etalon_kernels_gen::Real>::equation(#label, #name, #[inline(always)] || #output #block)
        }
    }
}

/// The function as it stands, with its entry in the registry.
pub(crate) fn host(function: ItemFn, source: &Source, text: &str) -> TokenStream {
    let ItemFn { attrs, vis, sig, block } = function;
    let (outer, inner) = sides(attrs);
    let documentation = documentation(source);
    let entry = entry(&unraw(&sig.ident), source, text);
    let statements = &block.stmts;
    quote! {
        #(#outer)*
        #documentation
        #vis #sig {
            #(#inner)*
            #entry
            #(#statements)*
        }
    }
}

/// The attributes above a function, and those inside of its body: `#![allow(..)]` and `//!` belong there.
fn sides(attributes: Vec<Attribute>) -> (Vec<Attribute>, Vec<Attribute>) {
    attributes.into_iter().partition(|attribute| matches!(attribute.style, AttrStyle::Outer))
}

/// A last paragraph of documentation.
fn documentation(source: &Source) -> TokenStream {
    let line = format!(" {}", source.documentation());
    quote! {
        #[doc = ""]
        #[doc = #line]
    }
}

/// What puts the function into the registry.
fn entry(name: &str, source: &Source, text: &str) -> TokenStream {
    let (ids, unnumbered) = match source {
        Source::Numbered(ids) => (quote!(&[#(#ids),*]), quote!(::core::option::Option::None)),
        Source::Unnumbered(words) => (quote!(&[]), quote!(::core::option::Option::Some(#words))),
    };
    quote! {
        ::etalon_kernels_gen::__private::inventory::submit! {
            ::etalon_kernels_gen::__private::EquationEntry {
                ids: #ids,
                name: #name,
                module_path: ::core::module_path!(),
                file: ::core::file!(),
                line: ::core::line!(),
                source: #text,
                unnumbered: #unnumbered,
            }
        }
    }
}

/// A part of equations, with its mutants.
pub(crate) fn part(function: ItemFn, mutants: Option<Planted>) -> TokenStream {
    let ItemFn { attrs, vis, sig, block } = function;
    let (outer, inner) = sides(attrs);
    let Around { allowed, entries, exchanges, block } = around(*block, &sig.output, &unraw(&sig.ident), mutants);
    quote! {
        #(#outer)*
        #allowed
        #vis #sig {
            #(#inner)*
            #entries
            #exchanges
            #block
        }
    }
}

/// A body and what its mutants put around it; without mutants, the body.
struct Around {
    allowed: TokenStream,
    entries: TokenStream,
    exchanges: TokenStream,
    block: TokenStream,
}

fn around(block: Block, output: &ReturnType, name: &str, mutants: Option<Planted>) -> Around {
    let Some(Planted { list, prologue }) = mutants else {
        return Around { allowed: quote!(), entries: quote!(), exchanges: quote!(), block: block.to_token_stream() };
    };
    let block = match (prologue.negates, output) {
        (Some(is_active), ReturnType::Type(_, ty)) => {
            let result = Ident::new("result", proc_macro2::Span::mixed_site());
            let sign = quote!(::etalon_kernels_gen::__private::mutants::Sign);
            quote!({
                let #result: #ty = #block;
                if #is_active { #sign::of(&#result).negated(#result) } else { #result }
            })
        }
        _ => block.to_token_stream(),
    };
    Around {
        // Variants are odd code, and meant to be.
        allowed: quote!(#[allow(warnings, clippy::all, arithmetic_overflow, unconditional_panic)]),
        entries: mutant_entries(&list, name),
        exchanges: prologue.exchanges,
        block,
    }
}

/// The list of an equation's mutants, and what asks for the active one.
fn mutant_entries(mutants: &[Mutant], name: &str) -> TokenStream {
    let mutants = mutants.iter().map(|mutant| {
        let Mutant { operator, original, mutated, place } = mutant;
        // A tool that counts lines in u32 is what the compiler is, too.
        let (line, column) = (place.line as u32, place.column as u32);
        quote!(::etalon_kernels_gen::__private::mutants::Mutant {
            operator: #operator,
            original: #original,
            mutated: #mutated,
            line: #line,
            column: #column,
        })
    });
    quote! {
        static ETALON_MUTANTS: ::etalon_kernels_gen::__private::mutants::Switch =
            ::etalon_kernels_gen::__private::mutants::Switch::new(::core::module_path!(), #name);
        ::etalon_kernels_gen::__private::inventory::submit! {
            ::etalon_kernels_gen::__private::mutants::MutatedEquation {
                module_path: ::core::module_path!(),
                name: #name,
                file: ::core::file!(),
                mutants: &[#(#mutants),*],
            }
        }
        ETALON_MUTANTS.reach();
    }
}

/// The signature with an empty body: stands in for a function that was refused, so that its callers still find it.
pub(crate) fn placeholder(function: ItemFn) -> TokenStream {
    let ItemFn { attrs, vis, sig, .. } = function;
    let impossible = match &sig.output {
        ReturnType::Type(_, ty) => has_impl(ty),
        ReturnType::Default => false,
    };
    if impossible || sig.asyncness.is_some() || sig.constness.is_some() {
        return quote!();
    }
    let is_kept =
        |a: &&Attribute| matches!(a.style, AttrStyle::Outer) && (a.path().is_ident("doc") || a.path().is_ident("cfg"));
    let documentation = attrs.iter().filter(is_kept);
    quote! {
        #(#documentation)*
        #[allow(unused, missing_docs, clippy::all)]
        #vis #sig {
            ::core::unreachable!("refused by #[equation]")
        }
    }
}

/// A name without the `r#` of a raw identifier.
pub(crate) fn unraw(name: &Ident) -> String {
    use syn::ext::IdentExt;
    name.unraw().to_string()
}

/// The function as text, when the compiler no longer has what was written.
pub(crate) fn token_text(function: &ItemFn) -> String {
    function.to_token_stream().to_string()
}

fn has_impl(ty: &Type) -> bool {
    struct Finder(bool);
    impl syn::visit::Visit<'_> for Finder {
        fn visit_type_impl_trait(&mut self, _: &syn::TypeImplTrait) {
            self.0 = true;
        }
    }
    let mut finder = Finder(false);
    syn::visit::Visit::visit_type(&mut finder, ty);
    finder.0
}
