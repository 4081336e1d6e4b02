//! The checks on a ledger file that TOML's own types cannot make.

use std::collections::BTreeSet;

use crate::bad_input::BadInput;
use crate::entry::{Confidence, Entry, Index, Kind};
use crate::error::LedgerError;
use crate::latex;
use crate::paper::Paper;

/// Checks that `numbers` are 1 to the paper's last, each once and in order.
pub(crate) fn numbers(paper: Paper, file: &str, numbers: &[u16]) -> Result<(), LedgerError> {
    let file = || file.to_owned();
    let last = paper.last_number();
    let mut seen = BTreeSet::new();
    for &number in numbers {
        if !(1..=last).contains(&number) {
            return Err(LedgerError::NumberOutOfRange { file: file(), number, last });
        }
        if !seen.insert(number) {
            return Err(LedgerError::DuplicateNumber { file: file(), number });
        }
    }
    if let Some(number) = (1..=last).find(|number| !seen.contains(number)) {
        return Err(LedgerError::MissingNumber { file: file(), number, last });
    }
    match numbers.windows(2).find(|pair| pair[0] > pair[1]) {
        Some(pair) => Err(LedgerError::OutOfOrder { file: file(), number: pair[1], previous: pair[0] }),
        None => Ok(()),
    }
}

/// Checks one entry's fields; `particles` are the letters of a pair, `indices` the file's declared letters.
pub(crate) fn entry(
    file: &str,
    entry: &Entry,
    particles: &(String, String),
    indices: &[Index],
) -> Result<(), LedgerError> {
    let number = entry.id.number();
    let file = || file.to_owned();

    let required = [
        ("title", entry.title.as_str()),
        ("paper_section", entry.paper_section.as_str()),
        ("latex", entry.latex.as_str()),
        ("reading", entry.reading.as_str()),
    ];
    let optional = [
        ("latex_as_printed", entry.latex_as_printed.as_deref()),
        ("open_question", entry.open_question.as_deref()),
        ("deviation", entry.deviation.as_deref()),
    ];
    let present = optional.into_iter().filter_map(|(field, text)| Some((field, text?)));
    for (field, text) in required.into_iter().chain(present) {
        if text.trim().is_empty() {
            return Err(LedgerError::EmptyField { file: file(), number, field });
        }
        if let Some(fault) = latex::fault(text) {
            return Err(LedgerError::Unbalanced { file: file(), number, field, fault });
        }
    }
    if entry.symbols.is_empty() {
        return Err(LedgerError::EmptyField { file: file(), number, field: "symbols" });
    }
    if entry.confidence == Confidence::Open && entry.open_question.is_none() {
        return Err(LedgerError::OpenWithoutQuestion { file: file(), number });
    }

    bad_input(file(), entry)?;

    let formula = latex::tokens(&entry.latex);
    let mut covered = vec![false; formula.len()];
    let mut listed = BTreeSet::new();
    for symbol in &entry.symbols {
        if symbol.name.trim().is_empty() {
            return Err(LedgerError::EmptyField { file: file(), number, field: "symbols.name" });
        }
        if let Some(fault) = latex::fault(&symbol.latex) {
            return Err(LedgerError::Unbalanced { file: file(), number, field: "symbols.symbol", fault });
        }
        let own = latex::tokens(&symbol.latex);
        if !listed.insert(own.clone()) {
            return Err(LedgerError::DuplicateSymbol { file: file(), number, symbol: symbol.latex.clone() });
        }
        let partner = latex::swapped(&own, &particles.0, &particles.1);
        let places = latex::occurrences(&formula, &own);
        if places.is_empty() {
            return Err(LedgerError::SymbolNotInFormula { file: file(), number, symbol: symbol.latex.clone() });
        }
        for place in places.into_iter().chain(latex::occurrences(&formula, &partner)) {
            covered[place].fill(true);
        }
    }
    let letters: Vec<&str> = indices.iter().map(|index| index.letter.as_str()).collect();
    match latex::unexplained(&formula, &covered, &letters) {
        Some(letter) => Err(LedgerError::UnexplainedLetter { file: file(), number, letter: letter.clone() }),
        None => Ok(()),
    }
}

/// Checks what the entry says of bad input.
fn bad_input(file: String, entry: &Entry) -> Result<(), LedgerError> {
    let number = entry.id.number();
    match (entry.bad_input, entry.caught.is_empty()) {
        (None, true) if entry.kind == Kind::Explanatory => return Ok(()),
        (None, _) => return Err(LedgerError::MissingBadInput { file, number }),
        (Some(BadInput::Propagates), false) => return Err(LedgerError::CaughtYetPropagates { file, number }),
        (Some(BadInput::Guards | BadInput::Refuses), true) => {
            return Err(LedgerError::EmptyField { file, number, field: "caught" });
        }
        _ => {}
    }
    for caught in &entry.caught {
        let texts = [("caught.of", &caught.of), ("caught.gives", &caught.gives)];
        for (field, text) in texts {
            if text.is_empty() {
                return Err(LedgerError::EmptyField { file, number, field });
            }
            if let Some(fault) = latex::fault(text) {
                return Err(LedgerError::Unbalanced { file, number, field, fault });
            }
        }
        let values: BTreeSet<_> = caught.values.iter().collect();
        if values.is_empty() {
            return Err(LedgerError::EmptyField { file, number, field: "caught.values" });
        }
        if values.len() < caught.values.len() {
            return Err(LedgerError::DuplicateBadValue { file, number, of: caught.of.clone() });
        }
    }
    Ok(())
}
