//! The attribute macros of Etalon: a thin shell around `etalon-equation-syntax`, which says what the language is.
#![forbid(unsafe_code)]

mod source;

use etalon_equation_syntax::{Place, Surroundings, expand, expand_part};
use proc_macro::TokenStream;

/// Makes a generic function an equation of the ledger.
///
/// `#[equation("gs25:8")]` for one numbered equation, several ids separated by commas for a function that is several, and
/// `#[equation(unnumbered = "mixed sinc kernel, GS25 section 3")]` for a definition that has no number. An id that the ledger
/// does not have is a compile error.
///
/// `#[equation("gs25:20", host)]` enters a function that is computed on the host alone, from whole lists of particles, such as an
/// error norm: any function, which stays as it is and runs on no other target.
///
/// Any other function is generic over one `R: Real`. In its body `0.5` is a constant of that type, `<` compares lane by lane, and an
/// `if` that asks for such a comparison picks one of two values, so that the very same function runs on scalars, on vector
/// lanes and on symbols. `let` gives values the names that they have in generated code. What cannot be translated is refused at
/// its token. `kernels-gen/syntax/README.md` lists the language.
#[proc_macro_attribute]
pub fn equation(attribute: TokenStream, item: TokenStream) -> TokenStream {
    let check_id = |id: &str| etalon_spec::exists(id).map(drop).map_err(|error| error.to_string());
    let source_text = source::text(&item);
    expand(attribute.into(), item.into(), &Surroundings { check_id: &check_id, source_text, mutants: mutants() }).into()
}

/// Marks a function that equations are made of and that is none itself, such as the determinant of a matrix.
///
/// It is left as it is. With the feature `mutants` it gets mutants as equations do, for the tests of the tests.
#[proc_macro_attribute]
pub fn equation_part(_attribute: TokenStream, item: TokenStream) -> TokenStream {
    expand_part(item.into(), &Surroundings { mutants: mutants(), ..Surroundings::NONE }).into()
}

/// Where tokens stand, if equations are to carry their mutants.
fn mutants() -> Option<&'static dyn Fn(proc_macro2::Span) -> Place> {
    fn place_of(span: proc_macro2::Span) -> Place {
        let span = span.unwrap();
        Place { line: span.line(), column: span.column() }
    }
    if cfg!(feature = "mutants") { Some(&place_of) } else { None }
}
