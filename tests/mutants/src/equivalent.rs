//! Mutants that are no faults: `tests/mutants/equivalent.toml`, written by hand, each with its reason.

use crate::error::Error;
use crate::mutant::{Equation, Mutant};
use crate::places;
use serde::Deserialize;

/// Changes of one line that make no difference, and why.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Equivalent {
    /// The equation's path, such as `reconstruction::slope_limiter`.
    pub equation: String,
    /// The line as it stands in the source, without the space around it.
    pub code: String,
    /// The changes, as `--list` shows them.
    pub changes: Vec<String>,
    /// Why no test can tell them from the original.
    pub reason: String,
}

impl Equivalent {
    /// Whether it speaks of this mutant.
    pub fn covers(&self, equation: &Equation, mutant: &Mutant) -> bool {
        self.equation == equation.path && self.code == mutant.code && self.changes.contains(&mutant.change)
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(default)]
    equivalent: Vec<Equivalent>,
}

/// All that are listed.
pub fn read() -> Result<Vec<Equivalent>, Error> {
    let path = places::equivalents();
    let text = std::fs::read_to_string(&path).map_err(Error::file(&path))?;
    let content = |message| Error::Content { path: path.clone(), message };
    let file: File = toml::from_str(&text).map_err(|error| content(error.to_string()))?;
    match file.equivalent.iter().find(|entry| entry.reason.trim().is_empty()) {
        Some(entry) => Err(content(format!("{}, `{}`: give a reason", entry.equation, entry.code))),
        None => Ok(file.equivalent),
    }
}
