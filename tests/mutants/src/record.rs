//! What was found, kept from run to run: `tests/mutants/record.toml`.

use crate::error::Error;
use crate::judge::Outcome;
use crate::mutant::Equation;
use crate::places;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};

const HEADER: &str = "\
# What became of every mutant of every equation; docs/mutants.md reads it aloud.
# Written by `cargo run -p etalon-mutants`; do not edit.

";

/// All results.
#[derive(Debug, Default, Serialize, Deserialize)]
pub struct Record {
    /// By the equation's path.
    #[serde(default)]
    pub equation: BTreeMap<String, Found>,
}

/// The results of one equation.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Found {
    /// Of which text they are.
    pub fingerprint: String,
    /// The tests that reach the equation, the most particular first.
    #[serde(default)]
    pub tests: Vec<String>,
    /// Numbers of mutants that all tests passed over.
    #[serde(default, skip_serializing_if = "BTreeSet::is_empty")]
    pub missed: BTreeSet<u32>,
    /// Numbers of those that make no sense for their types.
    #[serde(default, skip_serializing_if = "BTreeSet::is_empty")]
    pub none: BTreeSet<u32>,
    /// Which test failed for which.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub caught: BTreeMap<String, BTreeSet<u32>>,
    /// Which test did not end for which.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub timed_out: BTreeMap<String, BTreeSet<u32>>,
}

impl Record {
    /// The recorded results; none if there is no file yet.
    pub fn read() -> Result<Self, Error> {
        let path = places::record();
        match std::fs::read_to_string(&path) {
            Ok(text) => {
                toml::from_str(&text).map_err(|error| Error::Content { path, message: error.message().to_string() })
            }
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => Ok(Record::default()),
            Err(source) => Err(Error::File { path, source }),
        }
    }

    /// Writes it all, or nothing.
    pub fn write(&self) -> Result<(), Error> {
        let path = places::record();
        let text =
            toml::to_string(self).map_err(|error| Error::Content { path: path.clone(), message: error.to_string() })?;
        let beside = path.with_extension("toml.new");
        std::fs::write(&beside, format!("{HEADER}{text}")).map_err(Error::file(&beside))?;
        std::fs::rename(&beside, &path).map_err(Error::file(&path))
    }

    /// Forgets what is no longer there: equations, texts, tests.
    pub fn refresh(&mut self, equations: &[Equation], tests: &[String]) {
        self.equation.retain(|path, _| equations.iter().any(|equation| equation.path == *path));
        for equation in equations {
            let found = self.equation.entry(equation.path.clone()).or_default();
            let fingerprint = equation.fingerprint();
            if found.fingerprint != fingerprint {
                *found = Found { fingerprint, ..Found::default() };
            }
            found.caught.retain(|test, _| tests.contains(test));
            found.timed_out.retain(|test, _| tests.contains(test));
        }
    }

    /// Enters a result in the place of an earlier one.
    pub fn enter(&mut self, path: &str, number: u32, outcome: Outcome) {
        let found = self.equation.entry(path.to_string()).or_default();
        found.missed.remove(&number);
        found.none.remove(&number);
        for tests in [&mut found.caught, &mut found.timed_out] {
            tests.values_mut().for_each(|numbers| {
                numbers.remove(&number);
            });
            tests.retain(|_, numbers| !numbers.is_empty());
        }
        match outcome {
            Outcome::Caught(test) => found.caught.entry(test).or_default().insert(number),
            Outcome::TimedOut(test) => found.timed_out.entry(test).or_default().insert(number),
            Outcome::Missed => found.missed.insert(number),
            Outcome::None => found.none.insert(number),
        };
    }
}

impl Found {
    /// What is known of a mutant.
    pub fn outcome(&self, number: u32) -> Option<Outcome> {
        let by = |tests: &BTreeMap<String, BTreeSet<u32>>| {
            tests.iter().find(|(_, numbers)| numbers.contains(&number)).map(|(test, _)| test.clone())
        };
        by(&self.caught)
            .map(Outcome::Caught)
            .or_else(|| by(&self.timed_out).map(Outcome::TimedOut))
            .or_else(|| self.missed.contains(&number).then_some(Outcome::Missed))
            .or_else(|| self.none.contains(&number).then_some(Outcome::None))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_new_result_replaces_the_old_one() {
        let mut record = Record::default();
        record.enter("a::b", 3, Outcome::Missed);
        record.enter("a::b", 3, Outcome::Caught("t".to_string()));
        record.enter("a::b", 4, Outcome::None);
        let found = &record.equation["a::b"];
        assert_eq!(found.outcome(3), Some(Outcome::Caught("t".to_string())));
        assert_eq!(found.outcome(4), Some(Outcome::None));
        assert_eq!(found.outcome(5), None);
        let text = toml::to_string(&record).unwrap();
        let again: Record = toml::from_str(&text).unwrap();
        assert_eq!(again.equation, record.equation);
    }

    #[test]
    fn results_of_another_text_or_of_a_vanished_test_are_forgotten() {
        let equation =
            Equation { path: "a::b".to_string(), full_path: String::new(), file: String::new(), mutants: Vec::new() };
        let mut record = Record::default();
        record.refresh(std::slice::from_ref(&equation), &[]);
        record.enter("a::b", 1, Outcome::Caught("old".to_string()));
        record.enter("a::b", 2, Outcome::Caught("kept".to_string()));
        record.refresh(std::slice::from_ref(&equation), &["kept".to_string()]);
        assert_eq!(record.equation["a::b"].outcome(1), None);
        assert_eq!(record.equation["a::b"].outcome(2), Some(Outcome::Caught("kept".to_string())));
        if let Some(found) = record.equation.get_mut("a::b") {
            found.fingerprint = "another".to_string();
        }
        record.refresh(&[equation], &["kept".to_string()]);
        assert_eq!(record.equation["a::b"].outcome(2), None);
        record.refresh(&[], &[]);
        assert!(record.equation.is_empty());
    }
}
