//! The attribute's arguments: where the equation comes from, and whether it is translated.

use crate::errors::Errors;
use proc_macro2::TokenStream;
use syn::parse::{Parse, ParseStream};
use syn::punctuated::Punctuated;
use syn::{Ident, LitStr, Token};

const USAGE: &str = "write #[equation(\"gs25:8\")], several ids separated by commas, or, for a definition that has no number, \
                     #[equation(unnumbered = \"mixed sinc kernel, GS25 section 3\")]; for what is computed on the host alone, from \
                     whole lists of particles, `host` comes last";

/// What the attribute says.
pub(crate) struct Arguments {
    /// Where the equation comes from.
    pub(crate) source: Source,
    /// Whether the function is entered into the registry as it stands, instead of being translated.
    pub(crate) host: bool,
}

/// Where an equation comes from.
pub(crate) enum Source {
    /// Numbered equations of the ledger; never empty.
    Numbered(Vec<LitStr>),
    /// A definition without a number, and where it stands.
    Unnumbered(LitStr),
}

impl Source {
    /// As drawings carry it: the ids, or the words of an unnumbered source.
    pub(crate) fn label(&self) -> String {
        match self {
            Source::Numbered(ids) => ids.iter().map(LitStr::value).collect::<Vec<_>>().join(", "),
            Source::Unnumbered(words) => words.value(),
        }
    }

    /// The line that is added to the documentation.
    pub(crate) fn documentation(&self) -> String {
        match self {
            Source::Numbered(ids) => format!("Source: {}.", ids.iter().map(citation).collect::<Vec<_>>().join(", ")),
            Source::Unnumbered(words) => format!("Source: {} (no numbered equation).", words.value()),
        }
    }
}

/// `gs25:8` as `GS25 Eq. (8)`.
fn citation(id: &LitStr) -> String {
    let id = id.value();
    match id.split_once(':') {
        Some((paper, number)) => format!("{} Eq. ({number})", paper.to_uppercase()),
        None => id,
    }
}

enum Argument {
    Id(LitStr),
    Unnumbered(LitStr),
    Host(Ident),
}

impl Parse for Argument {
    fn parse(input: ParseStream) -> syn::Result<Self> {
        if input.peek(LitStr) {
            return input.parse().map(Argument::Id);
        }
        let key: Ident = input.parse().map_err(|error| syn::Error::new(error.span(), USAGE))?;
        if key == "host" {
            return Ok(Argument::Host(key));
        }
        if key != "unnumbered" {
            return Err(syn::Error::new(key.span(), USAGE));
        }
        input.parse::<Token![=]>()?;
        input.parse().map(Argument::Unnumbered)
    }
}

/// Reads the arguments and asks for each id whether the ledger has it.
pub(crate) fn parse(
    attribute: TokenStream,
    check_id: &dyn Fn(&str) -> Result<(), String>,
    errors: &mut Errors,
) -> Option<Arguments> {
    use syn::parse::Parser;
    let arguments = match Punctuated::<Argument, Token![,]>::parse_terminated.parse2(attribute) {
        Ok(arguments) => arguments,
        Err(error) => {
            errors.add(error);
            return None;
        }
    };
    let mut ids: Vec<LitStr> = Vec::new();
    let mut unnumbered: Option<LitStr> = None;
    let mut host = false;
    for argument in arguments {
        match argument {
            Argument::Id(id) => {
                if let Err(message) = check_id(&id.value()) {
                    errors.at(&id, message);
                }
                if ids.iter().any(|known| known.value() == id.value()) {
                    errors.at(&id, format!("`{}` is named twice; keep one", id.value()));
                }
                ids.push(id);
            }
            Argument::Unnumbered(words) => {
                if words.value().trim().is_empty() {
                    errors.at(&words, "say where the definition stands: paper and section");
                }
                if unnumbered.is_some() {
                    errors.at(&words, "`unnumbered` is given twice; keep one");
                }
                unnumbered = Some(words);
            }
            Argument::Host(key) => {
                if host {
                    errors.at(&key, "`host` is given twice; keep one");
                }
                host = true;
            }
        }
    }
    match (ids.is_empty(), unnumbered) {
        (false, None) => Some(Arguments { source: Source::Numbered(ids), host }),
        (true, Some(words)) => Some(Arguments { source: Source::Unnumbered(words), host }),
        (false, Some(words)) => {
            errors.at(words, "a numbered equation is not `unnumbered`; keep one of the two");
            None
        }
        (true, None) => {
            errors.at_span(proc_macro2::Span::call_site(), format!("the equation names no source; {USAGE}"));
            None
        }
    }
}
