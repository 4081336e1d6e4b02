//! The mutants of the equations, read from the source: nothing is compiled.

use crate::error::Error;
use crate::mutant::{Equation, ListedMutant};
use crate::places;
use etalon_equation_syntax::{Place, mutants};
use proc_macro2::{Span, TokenTree};
use std::path::{Path, PathBuf};
use syn::ext::IdentExt;
use syn::visit::Visit;
use syn::{Attribute, ItemFn, ItemMod, Meta};

/// All equations with their mutants, by path: what the test program would list.
pub fn equations() -> Result<Vec<Equation>, Error> {
    let folder = places::reference().join("src");
    let mut found = Vec::new();
    for path in files(&folder)? {
        let text = std::fs::read_to_string(&path).map_err(Error::file(&path))?;
        let content = |error: syn::Error| Error::Content { path: path.clone(), message: error.to_string() };
        let file = syn::parse_file(&text).map_err(content)?;
        let below = path.strip_prefix(&folder).unwrap_or(&path);
        let mut reader =
            Reader { module: module(below), text: &text, file: name(below), found: Vec::new(), error: None };
        reader.visit_file(&file);
        match reader.error {
            Some(error) => return Err(content(error)),
            None => found.append(&mut reader.found),
        }
    }
    found.sort_by(|(a, _), (b, _)| a.cmp(b));
    Ok(found.into_iter().map(|(_, equation)| equation).collect())
}

/// All files of Rust in a folder and those below it.
pub fn files(folder: &Path) -> Result<Vec<PathBuf>, Error> {
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(Error::file(folder))? {
        let path = entry.map_err(Error::file(folder))?.path();
        if path.is_dir() {
            files.append(&mut self::files(&path)?);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    Ok(files)
}

/// A file as the compiler is given it, from the root.
fn name(below: &Path) -> String {
    let parts: Vec<_> = below.iter().map(|part| part.to_string_lossy()).collect();
    format!("reference/src/{}", parts.join("/"))
}

/// `equations/limiters.rs` is the module `etalon_reference::equations::limiters`.
fn module(below: &Path) -> String {
    let without = below.with_extension("");
    let mut parts: Vec<_> = without.iter().map(|part| part.to_string_lossy()).collect();
    parts.pop_if(|last| ["mod", "lib"].contains(&last.as_ref()));
    parts.insert(0, "etalon_reference".into());
    parts.join("::")
}

struct Reader<'a> {
    module: String,
    text: &'a str,
    file: String,
    /// With module and name, by which they are sorted.
    found: Vec<((String, String), Equation)>,
    error: Option<syn::Error>,
}

impl<'ast> Visit<'ast> for Reader<'_> {
    fn visit_item_mod(&mut self, item: &'ast ItemMod) {
        let outer = self.module.clone();
        self.module = format!("{outer}::{}", item.ident.unraw());
        syn::visit::visit_item_mod(self, item);
        self.module = outer;
    }

    fn visit_item_fn(&mut self, item: &'ast ItemFn) {
        if !item.attrs.iter().any(has_mutants) {
            return;
        }
        let mut function = item.clone();
        function.attrs.retain(|attribute| !has_mutants(attribute));
        let place_of = |span: Span| Place { line: span.start().line, column: span.start().column + 1 };
        match mutants(quote::quote!(#function), &place_of) {
            Ok(list) => {
                let listed = list.into_iter().map(|mutant| ListedMutant {
                    operator: mutant.operator.to_string(),
                    original: mutant.original,
                    mutated: mutant.mutated,
                    line: mutant.place.line,
                });
                let name = item.sig.ident.unraw().to_string();
                let path = format!("{}::{name}", self.module);
                let equation = Equation::new(path, self.file.clone(), self.text, listed.collect());
                self.found.push(((self.module.clone(), name), equation));
            }
            Err(error) => match &mut self.error {
                Some(earlier) => earlier.combine(error),
                none => *none = Some(error),
            },
        }
    }
}

/// Whether an attribute makes its function one that is given mutants: an equation that is not for the host alone, or a part of equations.
fn has_mutants(attribute: &Attribute) -> bool {
    let is_host = |tokens: &proc_macro2::TokenStream| {
        tokens.clone().into_iter().any(|token| matches!(token, TokenTree::Ident(word) if word == "host"))
    };
    match &attribute.meta {
        Meta::Path(path) => path.is_ident("equation_part"),
        Meta::List(list) => list.path.is_ident("equation") && !is_host(&list.tokens),
        Meta::NameValue(_) => false,
    }
}

/// The tests of the equations, by their text.
#[derive(Debug)]
pub struct Tests(Vec<(String, String)>);

impl Tests {
    /// Reads them.
    pub fn read() -> Result<Self, Error> {
        let read = |path: PathBuf| {
            let module = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
            std::fs::read_to_string(&path).map(|text| (module, text)).map_err(Error::file(path))
        };
        files(&places::reference().join("tests/equations"))?.into_iter().map(read).collect::<Result<_, _>>().map(Tests)
    }

    /// Whether `limiters::whole_numbers` is there.
    pub fn has(&self, test: &str) -> bool {
        let (module, name) = test.split_once("::").unwrap_or(("main", test));
        let name = name.rsplit("::").next().unwrap_or(name);
        let start = format!("fn {name}(");
        self.0.iter().any(|(file, text)| file == module && text.contains(&start))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_modules() {
        for (file, due) in [
            ("lib.rs", "etalon_reference"),
            ("equations/mod.rs", "etalon_reference::equations"),
            ("equations/initial_state/gresho_chan.rs", "etalon_reference::equations::initial_state::gresho_chan"),
        ] {
            assert_eq!(module(Path::new(file)), due);
        }
    }

    #[test]
    fn equations_and_parts_have_mutants_and_the_host_has_none() {
        let attribute = |text: &str| -> Attribute {
            let item: ItemFn = syn::parse_str(&format!("{text} fn f() {{}}")).unwrap();
            item.attrs.into_iter().next().unwrap()
        };
        for (text, due) in [
            ("#[equation(\"gs25:8\")]", true),
            ("#[equation(unnumbered = \"host\")]", true),
            ("#[equation_part]", true),
            ("#[equation(\"gs25:20\", host)]", false),
            ("#[inline(always)]", false),
            ("#[doc = \"equation\"]", false),
        ] {
            assert_eq!(has_mutants(&attribute(text)), due, "{text}");
        }
    }

    #[test]
    fn tests_are_found_by_name() {
        let tests = Tests::read().unwrap();
        assert!(tests.has("limiters::whole_numbers") && tests.has("limiters::limiters_are_the_printed_formulas"));
        assert!(!tests.has("limiters::no_such_test") && !tests.has("no_such_file::whole_numbers"));
    }
}
