//! A page for a terminal.

use super::{Call, CaughtEntry, Function, LedgerEntry, Page, figures};
use std::fmt;

const WIDTH: usize = 100;

impl fmt::Display for Page {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}  {}", self.subject, self.title)?;
        for entry in &self.entries {
            ledger(f, entry)?;
        }
        for entry in &self.functions {
            function(f, entry)?;
        }
        Ok(())
    }
}

fn ledger(f: &mut fmt::Formatter<'_>, entry: &LedgerEntry) -> fmt::Result {
    writeln!(f, "\n== {}, in the ledger: {}", entry.id, entry.title)?;
    writeln!(f, "{}", wrapped(&format!("{}, section {}.", entry.citation, entry.section)))?;
    writeln!(f, "{}; our reading is {}.", entry.kind, entry.confidence)?;
    writeln!(f, "\nFormula\n  {}", entry.latex)?;
    if let Some(printed) = &entry.latex_as_printed {
        writeln!(f, "\nAs printed\n  {printed}")?;
    }
    if !entry.symbols.is_empty() {
        writeln!(f, "\nSymbols")?;
        let rows: Vec<_> =
            entry.symbols.iter().map(|of| vec![of.symbol.clone(), format!("[{}]", of.unit), of.name.clone()]).collect();
        write!(f, "{}", table(&rows))?;
    }
    let bad_input = entry.bad_input.as_ref().map(|behaviour| super::bad_values::words(behaviour));
    let parts = [
        ("Reading", Some(&entry.reading)),
        ("Open question", entry.open_question.as_ref()),
        ("Deviation", entry.deviation.as_ref()),
        ("Not encoded", entry.not_encoded.as_ref()),
        ("Bad input", bad_input.as_ref()),
    ];
    for (name, text) in parts.into_iter().filter_map(|(name, text)| Some((name, text?))) {
        writeln!(f, "\n{name}\n{}", wrapped(text))?;
    }
    caught(f, &entry.caught)
}

fn caught(f: &mut fmt::Formatter<'_>, list: &[CaughtEntry]) -> fmt::Result {
    for CaughtEntry { of, values, gives } in list {
        writeln!(f, "{}", wrapped(&format!("- {of} {}: {gives}.", values.join(" or "))))?;
    }
    Ok(())
}

fn function(f: &mut fmt::Formatter<'_>, function: &Function) -> fmt::Result {
    let of = function.unnumbered.clone().unwrap_or_else(|| function.ids.join(", "));
    writeln!(f, "\n== {} ({of})", function.path)?;
    writeln!(f, "{}:{}\n", function.file, function.line)?;
    writeln!(f, "{}", indented(&function.source))?;
    if function.runs_on == "host" {
        writeln!(f, "\nRuns on the host only: it is not generic over the number, and not drawn.")?;
    } else if function.calls.is_empty() {
        writeln!(f, "\nNo probe calls it yet: it was neither drawn nor measured here.")?;
    }
    if !function.caught.is_empty() {
        writeln!(f, "\nBad input\n  {}", super::bad_values::words("guards"))?;
        caught(f, &function.caught)?;
    }
    for call in &function.calls {
        drawn(f, call)?;
    }
    if !function.calls.is_empty() {
        figure(f, "Errors", figures::ERRORS, &figures::errors(function))?;
        figure(f, "Ranges", figures::RANGES, &figures::ranges(function))?;
    }
    for gain in function.calls.iter().flat_map(|call| &call.gains) {
        writeln!(f, "\nA textbook's form of {}\n{}", gain.probe, indented(&gain.formula))?;
        writeln!(f, "{}", wrapped(&format!("{}. Trouble: {}.", gain.source, gain.trouble)))?;
        figure(f, "Gain", figures::GAINS, &figures::gain(gain))?;
    }
    tests(f, function)
}

/// A table of figures with a word above and its notes below.
fn figure(f: &mut fmt::Formatter<'_>, name: &str, about: &str, of: &figures::Table) -> fmt::Result {
    writeln!(f, "\n{name}\n{}", wrapped(about))?;
    let rows: Vec<_> = std::iter::once(&of.head).chain(&of.rows).cloned().collect();
    write!(f, "{}", table(&rows).replace('`', ""))?;
    of.notes.iter().try_for_each(|note| writeln!(f, "{}", wrapped(note)))
}

fn drawn(f: &mut fmt::Formatter<'_>, call: &Call) -> fmt::Result {
    let quantities = call.arguments.iter().chain(&call.results);
    let own: Vec<_> = quantities
        .map(|of| {
            let domain = of.domain.as_ref().map_or_else(|| "result".to_string(), ToString::to_string);
            let meaning = of.meaning.clone().unwrap_or_default();
            vec![of.name.clone(), of.symbol.clone(), format!("[{}]", of.unit), domain, meaning]
        })
        .collect();
    if call.wgsl.is_none() {
        return Ok(());
    }
    writeln!(f, "\n{}: arguments, units, domains", call.probe)?;
    write!(f, "{}", table(&own))?;
    if let Some(arranged) = &call.arranged {
        writeln!(f, "{}", wrapped(&format!("The arguments belong together: {arranged}.")))?;
    }
    if !call.bad_values.is_empty() {
        writeln!(f, "\n{}: what bad values give", call.probe)?;
        let head = super::bad_values::HEAD.map(ToString::to_string).to_vec();
        let rows = call.bad_values.iter().map(|row| row.cells().map(ToString::to_string).to_vec());
        write!(f, "{}", table(&std::iter::once(head).chain(rows).collect::<Vec<_>>()))?;
    }
    if let Some(formula) = &call.formula {
        writeln!(f, "\n{}: the formula as it is computed\n{}", call.probe, indented(formula))?;
    }
    writeln!(f, "\n{}: {} operations in f32", call.probe, call.operations.words)?;
    if let Some(wgsl) = &call.wgsl {
        writeln!(f, "\n{}: as WGSL\n{}", call.probe, indented(wgsl.trim_end()))?;
    }
    Ok(())
}

fn tests(f: &mut fmt::Formatter<'_>, function: &Function) -> fmt::Result {
    let how = if function.tests_known_by == "run" { "that reach it" } else { "that call it by name" };
    match function.tests.len() {
        0 => writeln!(f, "\nTests {how}: none")?,
        count => writeln!(f, "\nTests {how}: {count}\n{}", indented(&function.tests.join("\n")))?,
    }
    let Some(mutants) = &function.mutants else {
        let why = if function.runs_on == "host" { "not put into what runs on the host only" } else { "not run yet" };
        return writeln!(f, "\nMutants: {why}");
    };
    writeln!(f, "\nMutants: {} caught, {} equivalent", mutants.caught, mutants.passed_over)?;
    let rows: Vec<_> =
        mutants.noticed_by.iter().map(|of| vec![of.mutants.to_string(), format!("by {}", of.test)]).collect();
    write!(f, "{}", table(&rows))?;
    for equivalent in &mutants.equivalent {
        writeln!(f, "  {}\n    {}", equivalent.changes.join("; "), equivalent.reason)?;
    }
    Ok(())
}

/// Rows with columns below each other, each as wide as its widest cell, the last one free.
pub(crate) fn table(rows: &[Vec<String>]) -> String {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let width = |column: usize| {
        rows.iter().filter_map(|row| row.get(column)).map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..columns).map(width).collect();
    let line = |row: &Vec<String>| {
        let cells: Vec<String> = row.iter().zip(&widths).map(|(cell, width)| format!("{cell:<width$}")).collect();
        format!("  {}\n", cells.join("  ").trim_end())
    };
    rows.iter().map(line).collect()
}

/// Words in lines of a terminal's width, indented.
fn wrapped(text: &str) -> String {
    let mut lines = vec![String::new()];
    for word in text.split_whitespace() {
        let line = lines.len() - 1;
        if !lines[line].is_empty() && lines[line].chars().count() + word.chars().count() >= WIDTH {
            lines.push(word.to_string());
        } else {
            let space = if lines[line].is_empty() { "" } else { " " };
            lines[line] += &format!("{space}{word}");
        }
    }
    indented(&lines.join("\n"))
}

fn indented(text: &str) -> String {
    let line = |line: &str| if line.is_empty() { String::new() } else { format!("  {line}") };
    text.lines().map(line).collect::<Vec<_>>().join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_wrapped_and_columns_aligned() {
        let text = wrapped(&"word ".repeat(50));
        assert!(text.lines().all(|line| line.len() <= WIDTH + 2 && line.starts_with("  word")));
        assert_eq!(text.lines().count(), 3);
        let rows = [vec!["a".to_string(), "b".to_string()], vec!["long".to_string(), "c".to_string()]];
        assert_eq!(table(&rows), "  a     b\n  long  c\n");
    }
}
