//! Loading the ledger and looking things up in it.

use serde::Deserialize;

use crate::bad_input::{BadInput, BadValue, Caught};
use crate::entry::{Confidence, Entry, Index, Kind, Symbol};
use crate::error::LedgerError;
use crate::identifier::EquationId;
use crate::paper::Paper;
use crate::text::{ReadError, one_line, parse_table, typed};
use crate::validate;

/// One paper's part of the ledger: its citation and its equations in order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PaperLedger {
    /// The paper.
    pub paper: Paper,
    /// The full citation.
    pub citation: String,
    /// What the file covers and how it was made, in a sentence or two.
    pub about: String,
    /// The letters that number particles and components in this paper.
    pub indices: Vec<Index>,
    entries: Vec<Entry>,
}

/// The whole ledger: every numbered equation of every paper.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Ledger {
    papers: Vec<PaperLedger>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawFile {
    paper: String,
    citation: String,
    about: String,
    particles: (String, String),
    indices: Vec<Index>,
    equation: Vec<toml::Value>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawEntry {
    number: u16,
    title: String,
    kind: Kind,
    confidence: Confidence,
    paper_section: String,
    latex: String,
    latex_as_printed: Option<String>,
    symbols: Vec<RawSymbol>,
    reading: String,
    open_question: Option<String>,
    deviation: Option<String>,
    bad_input: Option<BadInput>,
    #[serde(default)]
    caught: Vec<RawCaught>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawCaught {
    of: String,
    values: Vec<BadValue>,
    gives: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawSymbol {
    symbol: String,
    name: String,
    unit: String,
}

impl PaperLedger {
    /// Reads and checks the text of one paper's file; `file` is its name for messages.
    ///
    /// # Errors
    /// [`LedgerError`] for the first fault found.
    pub fn parse(paper: Paper, file: &str, text: &str) -> Result<Self, LedgerError> {
        let table = parse_table(text).map_err(|ReadError { line, message }| LedgerError::NotToml {
            file: file.to_owned(),
            line: line.unwrap_or(0),
            message,
        })?;
        let header_fault = |message| LedgerError::BadHeader { file: file.to_owned(), message };
        let raw: RawFile = typed(toml::Value::Table(table)).map_err(|error| header_fault(error.message))?;
        if raw.paper != paper.key() {
            let expected = paper.key().to_owned();
            return Err(LedgerError::WrongPaper { file: file.to_owned(), expected, found: raw.paper });
        }
        for (field, text) in [("citation", &raw.citation), ("about", &raw.about)] {
            if text.trim().is_empty() {
                return Err(header_fault(format!("field `{field}` is empty")));
            }
        }

        let entries = raw
            .equation
            .into_iter()
            .enumerate()
            .map(|(position, value)| typed_entry(file, position, value))
            .collect::<Result<Vec<_>, _>>()?;
        let numbers: Vec<u16> = entries.iter().map(|entry| entry.number).collect();
        validate::numbers(paper, file, &numbers)?;

        let entries = EquationId::of_paper(paper)
            .zip(entries)
            .map(|(id, entry)| {
                let entry = checked_symbols(file, id, entry)?;
                validate::entry(file, &entry, &raw.particles, &raw.indices)?;
                Ok(entry)
            })
            .collect::<Result<Vec<_>, LedgerError>>()?;
        Ok(Self {
            paper,
            citation: one_line(&raw.citation),
            about: one_line(&raw.about),
            indices: raw.indices,
            entries,
        })
    }

    /// The paper's equations, in order.
    pub fn entries(&self) -> impl Iterator<Item = &Entry> {
        self.entries.iter()
    }
}

fn typed_entry(file: &str, position: usize, value: toml::Value) -> Result<RawEntry, LedgerError> {
    let equation = match value.get("number") {
        Some(number) => number.to_string(),
        None => format!("without a number, at place {} of the file", position + 1),
    };
    typed(value).map_err(|error| LedgerError::BadEntry { file: file.to_owned(), equation, message: error.message })
}

fn checked_symbols(file: &str, id: EquationId, raw: RawEntry) -> Result<Entry, LedgerError> {
    let symbols = raw
        .symbols
        .into_iter()
        .map(|symbol| match symbol.unit.parse() {
            Ok(unit) => Ok(Symbol { latex: symbol.symbol, name: one_line(&symbol.name), unit }),
            Err(source) => {
                Err(LedgerError::BadUnit { file: file.to_owned(), number: id.number(), symbol: symbol.symbol, source })
            }
        })
        .collect::<Result<Vec<_>, _>>()?;
    let trimmed = |text: String| text.trim().to_owned();
    Ok(Entry {
        id,
        title: one_line(&raw.title),
        kind: raw.kind,
        confidence: raw.confidence,
        paper_section: one_line(&raw.paper_section),
        latex: trimmed(raw.latex),
        latex_as_printed: raw.latex_as_printed.map(trimmed),
        symbols,
        reading: one_line(&raw.reading),
        open_question: raw.open_question.as_deref().map(one_line),
        deviation: raw.deviation.as_deref().map(one_line),
        bad_input: raw.bad_input,
        caught: raw
            .caught
            .into_iter()
            .map(|raw| Caught { of: trimmed(raw.of), values: raw.values, gives: one_line(&raw.gives) })
            .collect(),
    })
}

impl Ledger {
    /// Reads and checks the ledger that is built into this crate.
    ///
    /// # Errors
    /// [`LedgerError`] for the first fault found; none occurs in a build whose tests pass.
    pub fn load() -> Result<Self, LedgerError> {
        let papers = Paper::ALL
            .into_iter()
            .map(|paper| {
                let (file, text) = source(paper);
                PaperLedger::parse(paper, file, text)
            })
            .collect::<Result<Vec<_>, _>>()?;
        Ok(Self { papers })
    }

    /// The papers with their citations, in the order of [`Paper::ALL`].
    pub fn papers(&self) -> impl Iterator<Item = &PaperLedger> {
        self.papers.iter()
    }

    /// One paper's part.
    #[must_use]
    pub fn paper(&self, paper: Paper) -> &PaperLedger {
        let position = match paper {
            Paper::Gs25 => 0,
            Paper::Pl20 => 1,
            Paper::C25 => 2,
        };
        &self.papers[position]
    }

    /// The entry of an equation. Every identifier has one: loading has checked it.
    #[must_use]
    pub fn get(&self, id: EquationId) -> &Entry {
        &self.paper(id.paper()).entries[usize::from(id.number()) - 1]
    }

    /// Every entry, paper by paper and in order.
    pub fn entries(&self) -> impl Iterator<Item = &Entry> {
        self.papers.iter().flat_map(PaperLedger::entries)
    }
}

/// The file of a paper: its name for messages, and its text.
fn source(paper: Paper) -> (&'static str, &'static str) {
    match paper {
        Paper::Gs25 => ("spec/gs25.toml", include_str!("../gs25.toml")),
        Paper::Pl20 => ("spec/pl20.toml", include_str!("../pl20.toml")),
        Paper::C25 => ("spec/c25.toml", include_str!("../c25.toml")),
    }
}
