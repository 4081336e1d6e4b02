//! What the ledger records about one equation.

use std::fmt;

use serde::Deserialize;

use crate::bad_input::{BadInput, Caught};
use crate::identifier::EquationId;
use crate::unit::Unit;

/// How sure our reading of an equation is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Confidence {
    /// Stated by the paper, or by another of the papers, and confirmed by derivation or by published source code.
    Certain,
    /// Put together or corrected by us from derivation and published source code.
    Reconstructed,
    /// More than one reading survives; the entry names the one we take and what stays open.
    Open,
}

impl fmt::Display for Confidence {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(match self {
            Self::Certain => "certain",
            Self::Reconstructed => "reconstructed",
            Self::Open => "open",
        })
    }
}

/// What an equation is for, which decides what it means that no code encodes it yet.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// Evaluated for particles or pairs in the course of a step.
    Computable,
    /// Names an auxiliary quantity from which computable equations are built.
    Definition,
    /// A continuum law that other equations discretise.
    Continuum,
    /// Explains an effect or motivates a choice; no computation depends on it.
    Explanatory,
    /// Evaluated on the state of a run to judge it.
    Diagnostic,
    /// Sets the state a run starts from.
    InitialCondition,
}

impl Kind {
    /// Why an equation of this kind may have no code yet, as one plain clause.
    #[must_use]
    pub const fn reason_not_encoded(self) -> &'static str {
        match self {
            Self::Computable => "a formula of the step that no function encodes yet",
            Self::Definition => "an auxiliary quantity that no function encodes yet",
            Self::Continuum => "a continuum law: what is encoded is its discrete form",
            Self::Explanatory => "an explanation: no computation depends on it",
            Self::Diagnostic => "a measurement on a run's state that no function encodes yet",
            Self::InitialCondition => "a starting state that no scene sets yet",
        }
    }
}

impl fmt::Display for Kind {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(match self {
            Self::Computable => "computable",
            Self::Definition => "definition",
            Self::Continuum => "continuum",
            Self::Explanatory => "explanatory",
            Self::Diagnostic => "diagnostic",
            Self::InitialCondition => "initial-condition",
        })
    }
}

/// A symbol of an equation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Symbol {
    /// As it is written in the formula, in LaTeX.
    pub latex: String,
    /// What it is, in plain words.
    pub name: String,
    /// Its unit.
    pub unit: Unit,
}

/// A letter that a paper uses to number things (particles, components), so that formulas need not explain it.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Index {
    /// The letter, or the LaTeX command of a Greek one.
    pub letter: String,
    /// What it counts, in plain words.
    pub meaning: String,
}

/// One numbered equation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Paper and number.
    pub id: EquationId,
    /// A short name.
    pub title: String,
    /// What the equation is for.
    pub kind: Kind,
    /// How sure the reading is.
    pub confidence: Confidence,
    /// The section of the paper in which it stands.
    pub paper_section: String,
    /// The formula as we read it.
    pub latex: String,
    /// The formula as the paper prints it, where that differs from [`Entry::latex`].
    pub latex_as_printed: Option<String>,
    /// The symbols of [`Entry::latex`]; one listed for a particle also stands for the same symbol of its partner.
    pub symbols: Vec<Symbol>,
    /// How we read the equation, and what is easily got wrong. May hold LaTeX between dollar signs.
    pub reading: String,
    /// What stays undecided; present whenever the confidence is [`Confidence::Open`].
    pub open_question: Option<String>,
    /// Where the paper departs from physics, from itself or from published codes.
    pub deviation: Option<String>,
    /// What its code does with values that no gas has. Always there but for an explanation, which has no code.
    pub bad_input: Option<BadInput>,
    /// Which values are caught, and what comes of them; none if all propagate.
    pub caught: Vec<Caught>,
}
