//! Which tests reach an equation: the record of the mutation tests, `tests/mutants/record.toml`, and for equations that it does
//! not have the tests that call them by name.

use serde::Deserialize;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// What the mutation tests found, by the equation's path.
#[derive(Clone, Debug, Default, Deserialize)]
pub struct Reach {
    #[serde(default)]
    equation: BTreeMap<String, Reached>,
    #[serde(skip)]
    reasons: BTreeMap<String, Vec<Equivalent>>,
}

/// One equation of the record.
#[derive(Clone, Debug, Default, Deserialize)]
struct Reached {
    #[serde(default)]
    tests: Vec<String>,
    #[serde(default)]
    missed: BTreeSet<u32>,
    #[serde(default)]
    caught: BTreeMap<String, BTreeSet<u32>>,
    #[serde(default)]
    timed_out: BTreeMap<String, BTreeSet<u32>>,
}

/// Changes of a line that make no difference, and why.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize, Deserialize)]
pub struct Equivalent {
    #[serde(skip_serializing)]
    equation: String,
    /// The line, as it stands in the source.
    pub code: String,
    /// What becomes of what.
    pub changes: Vec<String>,
    /// Why no input can tell.
    pub reason: String,
}

#[derive(Deserialize)]
struct EquivalentFile {
    equivalent: Vec<Equivalent>,
}

/// What became of the small faults put into an equation.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
pub struct Mutants {
    /// How many a test failed for, or did not end for.
    pub caught: usize,
    /// How many all tests passed over; each is listed in `equivalent`, or a test is missing.
    pub passed_over: usize,
    /// How many each test was the first to notice.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub noticed_by: Vec<Noticed>,
    /// Those that change nothing.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub equivalent: Vec<Equivalent>,
}

/// A test, and how many mutants it was the first to notice.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
pub struct Noticed {
    /// The test.
    pub test: String,
    /// How many.
    pub mutants: usize,
}

impl Reach {
    /// The record that is checked in.
    ///
    /// # Errors
    /// What TOML's reader says; none in a build whose tests pass.
    pub fn recorded() -> Result<Self, toml::de::Error> {
        let mut reach: Self = toml::from_str(include_str!("../../tests/mutants/record.toml"))?;
        let file: EquivalentFile = toml::from_str(include_str!("../../tests/mutants/equivalent.toml"))?;
        for equivalent in file.equivalent {
            reach.reasons.entry(equivalent.equation.clone()).or_default().push(equivalent);
        }
        Ok(reach)
    }
    /// The tests that reach an equation, the most particular first; nothing if it was not run yet.
    #[must_use]
    pub fn tests(&self, path: &str) -> Option<&[String]> {
        self.equation.get(path).map(|reached| reached.tests.as_slice()).filter(|tests| !tests.is_empty())
    }
    /// What became of its mutants; nothing if they were not run yet.
    #[must_use]
    pub fn mutants(&self, path: &str) -> Option<Mutants> {
        let reached = self.equation.get(path)?;
        let mut counts = BTreeMap::<&String, usize>::new();
        for (test, numbers) in reached.caught.iter().chain(&reached.timed_out) {
            *counts.entry(test).or_default() += numbers.len();
        }
        if counts.is_empty() && reached.missed.is_empty() {
            return None;
        }
        let noticed = |(test, mutants): (&String, usize)| Noticed { test: test.clone(), mutants };
        let caught = counts.values().sum();
        let equivalent = self.reasons.get(path).cloned().unwrap_or_default();
        let noticed_by = counts.into_iter().map(noticed).collect();
        Some(Mutants { caught, passed_over: reached.missed.len(), noticed_by, equivalent })
    }
}

/// The tests below these folders that call a function by its name, as `module::test`. A test that calls it through a helper is
/// not found; a test of another function of the same name is.
///
/// # Errors
/// If a file cannot be read.
pub fn tests_calling(function: &str, sources: &[(String, String)]) -> Vec<String> {
    let calls = |(module, text): &(String, String)| {
        let tests = text.split("#[test]").skip(1).filter(|test| is_called(function, test));
        let named = tests.filter_map(|test| test.split("fn ").nth(1)?.split('(').next());
        named.map(|name| format!("{module}::{name}")).collect::<Vec<_>>()
    };
    let mut tests: Vec<String> = sources.iter().flat_map(calls).collect();
    tests.sort();
    tests.dedup();
    tests
}

/// Whether a text has `function(` or `function::<`, and not as a method or a part of a longer name.
fn is_called(function: &str, text: &str) -> bool {
    text.match_indices(function).any(|(at, _)| {
        let before = text[..at].chars().next_back();
        let whole = before.is_none_or(|c| !(c.is_alphanumeric() || c == '_' || c == '.'));
        let after = &text[at + function.len()..];
        whole && (after.starts_with('(') || after.starts_with("::<"))
    })
}

/// All Rust sources below a folder: each one's module (the file's name, or its folder's for `mod.rs`, `main.rs`) and text.
///
/// # Errors
/// If a file cannot be read.
pub fn sources_below(folder: &Path) -> std::io::Result<Vec<(String, String)>> {
    let mut found = Vec::new();
    let mut entries: Vec<_> = std::fs::read_dir(folder)?.collect::<Result<_, _>>()?;
    entries.sort_by_key(std::fs::DirEntry::path);
    for path in entries.iter().map(std::fs::DirEntry::path) {
        if path.is_dir() {
            found.extend(sources_below(&path)?);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            let stem = |path: &Path| path.file_stem().map_or(String::new(), |stem| stem.to_string_lossy().into_owned());
            let module = match stem(&path).as_str() {
                "mod" | "main" | "tests" => stem(folder),
                name => name.to_string(),
            };
            found.push((module, std::fs::read_to_string(&path)?));
        }
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tests_that_call_a_function_are_found_and_others_are_not() {
        let text = "
            #[test]
            fn calls() { assert_eq!(norm(1.0), 1.0); }
            #[test]
            fn calls_with_types() { module::norm::<f64>(1.0); }
            #[test]
            fn calls_another() { l2_norm(1.0); vector.norm(); norm; }
            fn norm() {}";
        // The last test's text runs to the end of the file, with the definition in it: it has a parenthesis too.
        let text = text.replace("fn norm() {}", "");
        let sources = [("file".to_string(), text)];
        assert_eq!(tests_calling("norm", &sources), ["file::calls", "file::calls_with_types"]);
    }

    #[test]
    fn every_mutant_that_was_passed_over_has_its_reason() {
        let reach = Reach::recorded().unwrap();
        let limiter = reach.mutants("reconstruction::slope_limiter").unwrap();
        assert!(limiter.caught > 0 && limiter.passed_over > 0);
        let reasons: usize = limiter.equivalent.iter().map(|equivalent| equivalent.changes.len()).sum();
        assert_eq!(reasons, limiter.passed_over);
        assert!(reach.tests("no::such").is_none() && reach.mutants("no::such").is_none());
    }
}
