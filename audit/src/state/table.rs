//! The state for a terminal.

use super::{Row, State};
use crate::page::{ratio, table};
use crate::target::Target;
use std::collections::BTreeSet;
use std::fmt;

impl fmt::Display for State {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "Largest errors of the budget, in ulps of the natural scale; {} random inputs a probe.\n",
            self.samples
        )?;
        let head = ["equation", "encoded by", "tests", "mutants", "units", "prints"];
        let head = head.into_iter().chain(Target::ALL.map(Target::name)).chain(["remarks"]);
        let rows = self.equations.iter().chain(&self.unnumbered).map(cells);
        let rows: Vec<Vec<String>> = std::iter::once(head.map(ToString::to_string).collect()).chain(rows).collect();
        write!(f, "{}", table(&rows))?;
        let encoded = self.equations.iter().filter(|row| row.encoded).count();
        let tested = self.equations.iter().filter(|row| row.tests > 0).count();
        let measured = self.equations.iter().filter(|row| !row.errors.is_empty()).count();
        writeln!(
            f,
            "\n{} numbered equations: {encoded} encoded, {tested} tested, {measured} measured; {} without a number.",
            self.equations.len(),
            self.unnumbered.len()
        )?;
        for (adapter, measured) in self.adapters() {
            match measured {
                true => writeln!(f, "WGSL was run on {adapter}.")?,
                false => writeln!(f, "WGSL was not run; figures in parentheses are on record, of {adapter}.")?,
            }
        }
        if self.passed {
            return writeln!(f, "Nothing became worse.");
        }
        writeln!(f, "{} regressions:", self.regressions.len())?;
        self.regressions.iter().try_for_each(|worse| writeln!(f, "  {}: {}", worse.subject, worse.message))
    }
}

impl State {
    /// The devices that figures are of, and whether they are of now.
    fn adapters(&self) -> BTreeSet<(&str, bool)> {
        let errors = self.equations.iter().chain(&self.unnumbered).flat_map(|row| &row.errors);
        errors.filter_map(|error| Some((error.adapter.as_deref()?, error.measured))).collect()
    }
}

fn cells(row: &Row) -> Vec<String> {
    let names: Vec<String> =
        row.functions.iter().cloned().chain(row.host_functions.iter().map(|path| format!("{path} (host)"))).collect();
    // A row of its own for each of several functions would tear the table apart.
    let encoded = match (names.as_slice(), &row.kind) {
        ([], kind) => format!("- ({})", kind.as_deref().unwrap_or("none")),
        ([name], _) => name.clone(),
        ([name, more @ ..], _) => format!("{name} + {}", more.len()),
    };
    let mutants = match (row.mutants_caught, row.mutants_equivalent) {
        (0, 0) => "-".to_string(),
        (caught, equivalent) => format!("{caught}/{}", caught + equivalent),
    };
    let prints: Vec<&str> =
        row.targets.iter().map(String::as_str).filter(|target| ["wgsl", "c"].contains(target)).collect();
    let error = |target: Target| {
        let error = row.errors.iter().find(|error| error.target == target.name());
        error.map_or_else(
            || "-".to_string(),
            |error| {
                let ratio = ratio(error.worst, error.budget);
                if error.measured { ratio } else { format!("({ratio})") }
            },
        )
    };
    let remarks: Vec<&str> = [
        (row.regressed, "WORSE"),
        (row.encoded && row.tests == 0, "untested"),
        (!row.functions.is_empty() && row.errors.is_empty(), "not measured"),
        (row.deviation, "deviation"),
        (row.open_question, "open question"),
    ]
    .into_iter()
    .filter_map(|(holds, word)| holds.then_some(word))
    .collect();
    let or_dash = |text: String| if text.is_empty() { "-".to_string() } else { text };
    let units = if row.units == "unchecked" { "-" } else { row.units };
    [row.id.clone(), encoded, row.tests.to_string(), mutants, units.to_string(), or_dash(prints.join(" "))]
        .into_iter()
        .chain(Target::ALL.map(error))
        .chain([remarks.join(", ")])
        .collect()
}
