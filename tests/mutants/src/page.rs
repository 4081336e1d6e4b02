//! The page with the result: `docs/mutants.md`.

use crate::error::Error;
use crate::places;
use crate::summary::Summary;
use std::fmt::Write;

const INTRODUCTION: &str = include_str!("introduction.md");

/// The whole page.
pub fn page(summary: &Summary) -> String {
    let [all, caught, equivalent, missed, unknown] = summary.totals();
    let equations = summary.equations.len();
    let mut text = INTRODUCTION.to_string();
    // Writing to a string cannot fail.
    let _ = writeln!(text, "\n## The last result\n");
    let _ = write!(
        text,
        "{all} mutants of {equations} equations: {caught} caught, {equivalent} equivalent, {missed} missed"
    );
    let _ = writeln!(text, "{}.\n", if unknown > 0 { format!(", {unknown} not run") } else { String::new() });
    let _ = writeln!(text, "| equation | tests that reach it | mutants | caught | equivalent | missed |");
    let _ = writeln!(text, "|---|---|---|---|---|---|");
    for row in &summary.equations {
        let [tests, mutants, missed] = [row.tests.len(), row.mutants(), row.missed.len() + row.unknown];
        let _ =
            writeln!(text, "| `{}` | {tests} | {mutants} | {} | {} | {missed} |", row.path, row.caught, row.equivalent);
    }
    let _ = writeln!(text, "\n## Missed\n");
    let lines: Vec<_> = summary.equations.iter().flat_map(|row| &row.missed).collect();
    if lines.is_empty() {
        let _ = writeln!(text, "None.");
    }
    for line in lines {
        let _ = writeln!(text, "- {line}");
    }
    let _ = writeln!(text, "\n## Equivalent, and why\n");
    let mut last = "";
    for reason in &summary.equivalent {
        if reason.equation != last {
            let _ = writeln!(text, "{}### `{}`\n", if last.is_empty() { "" } else { "\n" }, reason.equation);
            last = &reason.equation;
        }
        let changes: Vec<_> = reason.changes.iter().map(|change| format!("`{change}`")).collect();
        let _ = writeln!(text, "- `{}`: {}. {}", reason.code, changes.join(", "), reason.reason.trim());
    }
    text
}

/// Writes it.
pub fn write(page: &str) -> Result<(), Error> {
    let path = places::page();
    std::fs::write(&path, page).map_err(Error::file(&path))
}

/// Whether the page there is this one.
pub fn is_current(page: &str) -> Result<bool, Error> {
    let path = places::page();
    Ok(std::fs::read_to_string(&path).map_err(Error::file(&path))? == page)
}
