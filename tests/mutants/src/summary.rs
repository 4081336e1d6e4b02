//! Results and reasons put together.

use crate::equivalent::Equivalent;
use crate::judge::Outcome;
use crate::mutant::Equation;
use crate::record::Record;
use crate::source::Tests;
use serde::Serialize;
use std::fmt::Write;

/// What is known of all equations.
#[derive(Debug, Serialize)]
pub struct Summary {
    /// By path.
    pub equations: Vec<Row>,
    /// Mutants that are no faults, with reasons; as listed.
    pub equivalent: Vec<Reason>,
    /// What is wrong with the list of these.
    pub complaints: Vec<String>,
}

/// One equation.
#[derive(Debug, Default, Serialize)]
pub struct Row {
    /// Its path.
    pub path: String,
    /// The source file.
    pub file: String,
    /// Tests that reach it.
    pub tests: Vec<String>,
    /// How many mutants were caught, those that never ended included.
    pub caught: usize,
    /// How many are listed as no faults.
    pub equivalent: usize,
    /// Those that no test noticed.
    pub missed: Vec<String>,
    /// How many have not been run.
    pub unknown: usize,
}

impl Row {
    /// All that make sense.
    pub fn mutants(&self) -> usize {
        self.caught + self.equivalent + self.missed.len() + self.unknown
    }
}

/// Changes that make no difference.
#[derive(Debug, Serialize)]
pub struct Reason {
    /// The equation's path.
    pub equation: String,
    /// The line.
    pub code: String,
    /// The changes of it.
    pub changes: Vec<String>,
    /// Why.
    pub reason: String,
}

impl Summary {
    /// Puts it together.
    pub fn new(equations: &[Equation], record: &Record, equivalents: &[Equivalent], there: &Tests) -> Self {
        let mut complaints = Vec::new();
        let mut rows = Vec::new();
        for equation in equations {
            let found = record.equation.get(&equation.path).filter(|found| found.fingerprint == equation.fingerprint());
            let tests = found.map(|found| found.tests.clone()).unwrap_or_default();
            for test in found.into_iter().flat_map(|found| found.caught.keys().chain(found.timed_out.keys())) {
                if !there.has(test) {
                    complaints.push(format!(
                        "{}: `{test}`, which caught mutants, is no longer there: run the command for this equation",
                        equation.path
                    ));
                }
            }
            let mut row = Row { path: equation.path.clone(), file: equation.file.clone(), tests, ..Row::default() };
            for mutant in &equation.mutants {
                let is_listed = equivalents.iter().any(|entry| entry.covers(equation, mutant));
                match found.and_then(|found| found.outcome(mutant.number)) {
                    Some(Outcome::Caught(test) | Outcome::TimedOut(test)) => {
                        row.caught += 1;
                        if is_listed {
                            complaints.push(format!(
                                "{}: `{}` is listed as equivalent, but `{test}` fails for it",
                                equation.path, mutant.change
                            ));
                        }
                    }
                    Some(Outcome::Missed) if is_listed => row.equivalent += 1,
                    Some(Outcome::Missed) => row
                        .missed
                        .push(format!("{}:{} `{}`: `{}`", equation.file, mutant.line, mutant.code, mutant.change)),
                    Some(Outcome::None) => {}
                    None => row.unknown += 1,
                }
            }
            rows.push(row);
        }
        for entry in equivalents {
            for change in &entry.changes {
                let is_there = equations.iter().any(|equation| {
                    equation.path == entry.equation
                        && equation.mutants.iter().any(|mutant| mutant.code == entry.code && mutant.change == *change)
                });
                if !is_there {
                    complaints.push(format!(
                        "{}: there is no mutant `{change}` of `{}`: remove it from the list of equivalent ones, or bring it up to date",
                        entry.equation, entry.code
                    ));
                }
            }
        }
        let reason = |entry: &Equivalent| Reason {
            equation: entry.equation.clone(),
            code: entry.code.clone(),
            changes: entry.changes.clone(),
            reason: entry.reason.clone(),
        };
        Summary { equations: rows, equivalent: equivalents.iter().map(reason).collect(), complaints }
    }

    /// Whether every mutant was run, and caught or excused.
    pub fn is_good(&self) -> bool {
        self.complaints.is_empty() && self.equations.iter().all(|row| row.missed.is_empty() && row.unknown == 0)
    }

    /// All mutants, caught, equivalent, missed, unknown.
    pub fn totals(&self) -> [usize; 5] {
        let sum = |of: fn(&Row) -> usize| self.equations.iter().map(of).sum();
        [
            sum(Row::mutants),
            sum(|row| row.caught),
            sum(|row| row.equivalent),
            sum(|row| row.missed.len()),
            sum(|row| row.unknown),
        ]
    }

    /// For the terminal.
    pub fn text(&self) -> String {
        let mut text = String::new();
        for row in &self.equations {
            for missed in &row.missed {
                // Writing to a string cannot fail.
                let _ = writeln!(text, "missed  {}  {missed}", row.path);
            }
        }
        for complaint in &self.complaints {
            let _ = writeln!(text, "{complaint}");
        }
        let [all, caught, equivalent, missed, unknown] = self.totals();
        let equations = self.equations.len();
        let _ = writeln!(
            text,
            "{all} mutants of {equations} equations: {caught} caught, {equivalent} equivalent, {missed} missed, {unknown} not run"
        );
        text
    }
}
