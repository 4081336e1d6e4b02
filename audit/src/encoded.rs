//! The record of what is encoded, `equations.toml`: so that an equation that vanishes is missed.

use crate::reach::{Reach, sources_below, tests_calling};
use etalon_kernels_gen::{EquationEntry, registered};
use serde::{Deserialize, Serialize};
use std::path::Path;

/// All equations, as recorded.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Encoded {
    /// In the order of the registry.
    #[serde(rename = "function", default)]
    pub functions: Vec<EncodedFunction>,
}

/// One of them.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct EncodedFunction {
    /// Module and name, as in `reconstruction::slope_limiter`.
    pub path: String,
    /// Its numbers; none for a definition without one.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub ids: Vec<String>,
    /// The tests that call it by name, where the mutation tests do not know which reach it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub called_by: Vec<String>,
}

/// Module and name of an equation, as in `reconstruction::slope_limiter`.
#[must_use]
pub fn path_of(entry: &EquationEntry) -> String {
    format!("{}::{}", entry.module_path.rsplit("::").next().unwrap_or_default(), entry.name)
}

/// Something that was encoded and is not any more.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Vanished {
    /// A function is not registered under this number.
    #[error("{id} is no longer encoded by {path}; bring it back, or say so with `etalon audit --record`")]
    Number {
        /// The number.
        id: String,
        /// The function.
        path: String,
    },
    /// A definition without a number.
    #[error("{path} is no longer there; bring it back, or say so with `etalon audit --record`")]
    Function {
        /// The function.
        path: String,
    },
}

impl Vanished {
    /// The number or path that it is about.
    #[must_use]
    pub fn subject(&self) -> &str {
        match self {
            Vanished::Number { id, .. } => id,
            Vanished::Function { path } => path,
        }
    }
}

impl Encoded {
    /// Of this program, with the tests that call equations found in the tree at `root`.
    ///
    /// # Errors
    /// If the tree cannot be read.
    pub fn now(root: &Path, reach: &Reach) -> std::io::Result<Self> {
        let mut sources = sources_below(&root.join("reference/tests"))?;
        sources.extend(sources_below(&root.join("reference/src"))?);
        let function = |entry: &EquationEntry| {
            let path = path_of(entry);
            let called_by = match reach.tests(&path) {
                Some(_) => Vec::new(),
                None => tests_calling(entry.name, &sources),
            };
            EncodedFunction { path, ids: entry.ids.iter().map(ToString::to_string).collect(), called_by }
        };
        Ok(Encoded { functions: registered().into_iter().map(function).collect() })
    }
    /// The text of the record, as it is checked in.
    ///
    /// # Errors
    /// None that is known; what the serialiser says is passed on.
    pub fn to_toml(&self) -> Result<String, toml::ser::Error> {
        let head = "\
# Which function encodes which equation, and the tests that call it where the mutation tests do not know which reach it.
# Generated; do not edit. Command: etalon audit --record
";
        Ok(format!("{head}\n{}", toml::to_string(self)?))
    }
    /// The tests that call an equation by name.
    #[must_use]
    pub fn called_by(&self, path: &str) -> &[String] {
        self.functions.iter().find(|function| function.path == path).map_or(&[], |function| &function.called_by)
    }
    /// What of the record is not there any more.
    #[must_use]
    pub fn vanished(&self, entries: &[&EquationEntry]) -> Vec<Vanished> {
        let mut vanished = Vec::new();
        for EncodedFunction { path, ids, .. } in &self.functions {
            let entry = entries.iter().find(|entry| path_of(entry) == *path);
            if ids.is_empty() && entry.is_none() {
                vanished.push(Vanished::Function { path: path.clone() });
            }
            let lost = |id: &&String| !entry.is_some_and(|entry| entry.ids.contains(&id.as_str()));
            let number = |id: &String| Vanished::Number { id: id.clone(), path: path.clone() };
            vanished.extend(ids.iter().filter(lost).map(number));
        }
        vanished
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_vanishes_is_missed() {
        let record = Encoded::recorded().unwrap();
        let mut entries = registered();
        assert_eq!(record.vanished(&entries), []);
        entries.retain(|entry| entry.name != "slope_limiter" && entry.name != "courant_step");
        let mut subjects: Vec<String> =
            record.vanished(&entries).iter().map(|vanished| vanished.subject().to_string()).collect();
        subjects.sort();
        assert_eq!(subjects, ["c25:10", "c25:14", "gs25:13", "gs25:17", "time_step::courant_step"]);
    }

    #[test]
    fn recorded_tests_are_in_the_tree() {
        let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."));
        let now = Encoded::now(root, &Reach::recorded().unwrap()).unwrap();
        let mut checked = 0;
        for function in Encoded::recorded().unwrap().functions {
            for test in &function.called_by {
                assert!(now.called_by(&function.path).contains(test), "{}: {test}; run --record", function.path);
                checked += 1;
            }
        }
        println!("{checked} tests");
    }
}
