//! All that is known of an equation, ready to be shown: as text, as JSON, as a page of the book.

mod bad_values;
mod book;
mod figures;
mod indices;
mod markdown;
mod mathml;
mod text;

pub use bad_values::{BadRow, CaughtEntry};
pub use book::{Book, BookError, Stale};
pub(crate) use figures::ratio;
pub use mathml::{NoFormula, mathml};
pub(crate) use text::table;

use crate::bad_input::of_unnumbered;
use crate::budgets::Record;
use crate::catalogue::{Catalogue, Subject, is_host};
use crate::encoded::path_of;
use crate::formula::formula;
use crate::gains::Gain;
use crate::probe::{Argument, Probe, Quantity};
use crate::probes::of_equation;
use crate::ranges::Range;
use crate::reach::Mutants;
use etalon_kernels_gen::EquationEntry;
use etalon_kernels_gen::emit::{EmitError, Header, MulAdd, wgsl};
use etalon_kernels_gen::trace::{Count, Double, Single, TraceError};
use etalon_spec::{EquationId, Symbol};
use serde::Serialize;

/// Functions that exist in several dimensions are printed in this one.
const SHOWN_DIMENSION: usize = 2;

/// All that is known of an equation.
#[derive(Clone, Debug, Serialize)]
pub struct Page {
    /// Its number, or the path of the function asked for.
    pub subject: String,
    /// What it is called.
    pub title: String,
    /// The ledger's entries: one for a number, any number for a function.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub entries: Vec<LedgerEntry>,
    /// The functions that encode it.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub functions: Vec<Function>,
}

/// What the ledger says.
#[derive(Clone, Debug, Serialize)]
pub struct LedgerEntry {
    /// Paper and number.
    pub id: String,
    /// A short name.
    pub title: String,
    /// The paper's citation.
    pub citation: String,
    /// The section it stands in.
    pub section: String,
    /// What it is for.
    pub kind: String,
    /// How sure our reading is.
    pub confidence: String,
    /// The formula as we read it.
    pub latex: String,
    /// As the paper prints it, if that differs.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub latex_as_printed: Option<String>,
    /// Its symbols.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub symbols: Vec<SymbolEntry>,
    /// How we read it, and why.
    pub reading: String,
    /// What stays undecided.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub open_question: Option<String>,
    /// Where the paper departs from physics, itself or published codes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub deviation: Option<String>,
    /// What its code does with bad input: `propagates`, `guards` or `refuses`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bad_input: Option<String>,
    /// Which values do not propagate.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub caught: Vec<CaughtEntry>,
    /// Why no function encodes it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub not_encoded: Option<String>,
}

/// A symbol.
#[derive(Clone, Debug, Serialize)]
pub struct SymbolEntry {
    /// LaTeX.
    pub symbol: String,
    /// What it is.
    pub name: String,
    /// In mass, length, time.
    pub unit: String,
}

/// A function.
#[derive(Clone, Debug, Serialize)]
pub struct Function {
    /// Module and name.
    pub path: String,
    /// All its numbers.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub ids: Vec<String>,
    /// Where a definition without a number stands.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unnumbered: Option<String>,
    /// `targets` if it runs on all of them, `host` if it does not.
    pub runs_on: &'static str,
    /// Its file, from the root.
    pub file: String,
    /// The line of its attribute, from 1.
    pub line: u32,
    /// As its author wrote it.
    pub source: String,
    /// Bad values that do not propagate, for a definition without a number; the ledger says it of others.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub caught: Vec<CaughtEntry>,
    /// The ways in which it was drawn and measured; none for a host function.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub calls: Vec<Call>,
    /// The tests that exercise it.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub tests: Vec<String>,
    /// How that is known: `run` with the function watched, or it stands in their `text`.
    pub tests_known_by: &'static str,
    /// What became of faults put into it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mutants: Option<Mutants>,
}

/// A function with its choices made.
#[derive(Clone, Debug, Serialize)]
pub struct Call {
    /// The probe's key.
    pub probe: String,
    /// What goes in.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub arguments: Vec<CallQuantity>,
    /// How the arguments depend on one another, if they do.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub arranged: Option<String>,
    /// What comes out.
    pub results: Vec<CallQuantity>,
    /// What bad values give, argument by argument.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub bad_values: Vec<BadRow>,
    /// Operations in `f32` and `f64`.
    pub operations: Operations,
    /// The formula as it is computed, in LaTeX; in one dimension of several.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub formula: Option<String>,
    /// As a function in WGSL; in one dimension of several.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wgsl: Option<String>,
    /// Recorded errors, by target.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub figures: Vec<Record>,
    /// What each result can be at all.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub ranges: Vec<Range>,
    /// What is gained over textbook forms.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub gains: Vec<Gain>,
}

/// An argument or a result.
#[derive(Clone, Debug, Serialize)]
pub struct CallQuantity {
    /// In the code.
    pub name: String,
    /// In LaTeX.
    pub symbol: String,
    /// In mass, length, time.
    pub unit: String,
    /// What it is, where the ledger or the probe says so.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub meaning: Option<String>,
    /// The values that it is measured with.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub domain: Option<String>,
}

/// Operations of a call: `a * b + c` counts two, any other one, signs none.
#[derive(Clone, Debug, Serialize)]
pub struct Operations {
    /// In `f32`, for polynomials are shorter there.
    pub f32: u32,
    /// In `f64`.
    pub f64: u32,
    /// The kinds in `f32`, in words.
    #[serde(skip)]
    pub words: String,
}

/// Why there is no page.
#[derive(Debug, thiserror::Error)]
pub enum PageError {
    /// An equation cannot be drawn.
    #[error("{probe} cannot be drawn: {source}")]
    NotDrawn {
        /// The probe.
        probe: String,
        /// Why.
        source: TraceError,
    },
    /// A drawing cannot be printed.
    #[error("{probe} cannot be printed: {source}")]
    NotPrinted {
        /// The probe.
        probe: String,
        /// Why.
        source: EmitError,
    },
}

impl Page {
    /// The pages of what was asked for: one, or one for each function of a name.
    ///
    /// # Errors
    /// If an equation cannot be drawn or printed; none is known.
    pub fn of(catalogue: &Catalogue, subject: &Subject) -> Result<Vec<Self>, PageError> {
        match subject {
            Subject::Number(id) => Ok(vec![Page::of_number(catalogue, *id)?]),
            Subject::Functions(entries) => {
                entries.iter().map(|entry| Page::of_function(catalogue, entry)).collect::<Result<_, _>>()
            }
        }
    }

    /// The page of a numbered equation.
    ///
    /// # Errors
    /// As for [`of`](Page::of).
    pub fn of_number(catalogue: &Catalogue, id: EquationId) -> Result<Self, PageError> {
        let functions = catalogue.functions(id).map(|entry| Function::of(catalogue, entry));
        Ok(Page {
            subject: id.to_string(),
            title: catalogue.ledger.get(id).title.clone(),
            functions: functions.collect::<Result<_, _>>()?,
            entries: vec![LedgerEntry::of(catalogue, id)],
        })
    }

    /// The page of a function.
    ///
    /// # Errors
    /// As for [`of`](Page::of).
    pub fn of_function(catalogue: &Catalogue, entry: &EquationEntry) -> Result<Self, PageError> {
        let ids = entry.ids.iter().filter_map(|id| id.parse().ok());
        Ok(Page {
            subject: path_of(entry),
            title: entry.name.replace('_', " "),
            entries: ids.map(|id| LedgerEntry::of(catalogue, id)).collect(),
            functions: vec![Function::of(catalogue, entry)?],
        })
    }
}

impl LedgerEntry {
    fn of(catalogue: &Catalogue, id: EquationId) -> Self {
        let entry = catalogue.ledger.get(id);
        let symbol = |symbol: &Symbol| SymbolEntry {
            symbol: symbol.latex.clone(),
            name: symbol.name.clone(),
            unit: symbol.unit.to_string(),
        };
        let is_encoded = catalogue.functions(id).next().is_some();
        LedgerEntry {
            id: id.to_string(),
            title: entry.title.clone(),
            citation: catalogue.ledger.paper(id.paper()).citation.clone(),
            section: entry.paper_section.clone(),
            kind: entry.kind.to_string(),
            confidence: entry.confidence.to_string(),
            latex: entry.latex.clone(),
            latex_as_printed: entry.latex_as_printed.clone(),
            symbols: entry.symbols.iter().map(symbol).collect(),
            reading: entry.reading.clone(),
            open_question: entry.open_question.clone(),
            deviation: entry.deviation.clone(),
            bad_input: entry.bad_input.map(|behaviour| behaviour.to_string()),
            caught: entry.caught.iter().map(CaughtEntry::of).collect(),
            not_encoded: (!is_encoded).then(|| entry.kind.reason_not_encoded().to_string()),
        }
    }
}

impl Function {
    fn of(catalogue: &Catalogue, entry: &EquationEntry) -> Result<Self, PageError> {
        let path = path_of(entry);
        let probes: Vec<&Probe> = of_equation(entry).collect();
        let is_shown = |probe: &Probe| {
            let alike = || probes.iter().filter(|other| other.variant == probe.variant);
            probe.dimension == Some(SHOWN_DIMENSION) || alike().count() == 1
        };
        let calls = probes.iter().map(|probe| Call::of(catalogue, probe, is_shown(probe)));
        let watched = catalogue.reach.tests(&path).is_some();
        Ok(Function {
            ids: entry.ids.iter().map(ToString::to_string).collect(),
            unnumbered: entry.unnumbered.map(ToString::to_string),
            runs_on: if is_host(entry) { "host" } else { "targets" },
            file: entry.file.to_string(),
            line: entry.line,
            source: entry.source.trim_end().to_string(),
            caught: of_unnumbered(&path).iter().map(CaughtEntry::of).collect(),
            calls: calls.collect::<Result<_, _>>()?,
            tests: catalogue.tests(entry).to_vec(),
            tests_known_by: if watched { "run" } else { "text" },
            mutants: catalogue.reach.mutants(&path),
            path,
        })
    }
}

impl Call {
    fn of(catalogue: &Catalogue, probe: &Probe, is_shown: bool) -> Result<Self, PageError> {
        let not_drawn = |source| PageError::NotDrawn { probe: probe.key(), source };
        let single = probe.draw::<Single>().map_err(not_drawn)?;
        let double = probe.draw::<Double>().map_err(not_drawn)?;
        let command = format!("etalon show {}", probe.function);
        let definition = format!("{}::{}", probe.module, probe.function);
        let head = Header { command: &command, definition: &definition };
        let print = || wgsl::function(probe.function, &single, &head, MulAdd::TwoRoundings);
        let wgsl = is_shown.then(print).transpose();
        let count = |drawing: &etalon_kernels_gen::trace::Drawing| Count::of(&drawing.simplified());
        let ids = probe.ids();
        let meaning = |latex: &str| {
            let mut symbols = ids.iter().flat_map(|id| &catalogue.ledger.get(*id).symbols);
            symbols.find(|symbol| symbol.latex == latex).map(|symbol| symbol.name.clone())
        };
        let key = probe.key();
        let of_probe = |record: &&Record| record.probe == key && record.is_of_this_text();
        let printed = is_shown.then(|| formula(probe)).transpose().map_err(not_drawn)?;
        Ok(Call {
            probe: probe.key(),
            arguments: probe.arguments.iter().map(|argument| CallQuantity::argument(argument, meaning)).collect(),
            arranged: probe.arranged.map(ToString::to_string),
            results: probe.results.iter().map(|quantity| CallQuantity::result(quantity, meaning)).collect(),
            bad_values: if is_shown { bad_values::rows(probe) } else { Vec::new() },
            operations: Operations {
                f32: count(&single).flops(),
                f64: count(&double).flops(),
                words: count(&single).to_string(),
            },
            formula: printed.map(|formula| formula.trim_end().to_string()),
            wgsl: wgsl.map_err(|source| PageError::NotPrinted { probe: probe.key(), source })?,
            figures: catalogue.budgets.records.iter().filter(of_probe).cloned().collect(),
            ranges: catalogue.ranges.of(&key).cloned().collect(),
            gains: catalogue.gains.gains.iter().filter(|gain| gain.probe == key).cloned().collect(),
        })
    }
}

impl CallQuantity {
    fn result(quantity: &Quantity, meaning: impl Fn(&str) -> Option<String>) -> Self {
        let own = quantity.symbol.meaning.map(ToString::to_string);
        CallQuantity {
            name: quantity.name.to_string(),
            symbol: quantity.symbol.latex.to_string(),
            unit: quantity.unit_text.to_string(),
            meaning: own.or_else(|| meaning(quantity.symbol.latex)),
            domain: None,
        }
    }
    fn argument(argument: &Argument, meaning: impl Fn(&str) -> Option<String>) -> Self {
        let domain = Some(argument.domain.describe());
        CallQuantity { domain, ..CallQuantity::result(&argument.quantity, meaning) }
    }
}
