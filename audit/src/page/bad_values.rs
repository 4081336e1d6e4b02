//! What a page says of bad input.

use crate::bad_input::{Outcome, outcomes};
use crate::probe::Probe;
use etalon_spec::{BadValue, Caught};
use serde::Serialize;

/// The classes of a table's columns.
pub(super) const COLUMNS: [BadValue; 4] = [BadValue::Nan, BadValue::Infinite, BadValue::Zero, BadValue::Negative];

/// The head of such a table.
pub(super) const HEAD: [&str; 5] = ["argument", "NaN", "infinite", "zero", "negative"];

/// What a behaviour means, in a sentence.
pub(super) fn words(behaviour: &str) -> String {
    let sentence = match behaviour {
        "guards" => "These values are caught, all others propagate.",
        "refuses" => "These values are refused, all others propagate.",
        _ => {
            "Nothing is caught: NaN in an argument that matters comes out as NaN; other bad values go through the arithmetic."
        }
    };
    sentence.to_string()
}

/// Values that do not propagate.
#[derive(Clone, Debug, Serialize)]
pub struct CaughtEntry {
    /// The argument, in LaTeX.
    pub of: String,
    /// Which values.
    pub values: Vec<String>,
    /// What comes out instead, and why.
    pub gives: String,
}

impl CaughtEntry {
    pub(super) fn of(caught: &Caught) -> Self {
        CaughtEntry {
            of: caught.of.clone(),
            values: caught.values.iter().map(ToString::to_string).collect(),
            gives: caught.gives.clone(),
        }
    }
}

/// What bad values of one argument give, where it matters: `NaN`, `infinite`, `a number`, or several of them; `legal` where such a value is none.
#[derive(Clone, Debug, Serialize)]
pub struct BadRow {
    /// The argument's name in the code.
    pub name: String,
    /// For NaN.
    pub nan: String,
    /// For infinity of either sign.
    pub infinite: String,
    /// For zero.
    pub zero: String,
    /// For a negative value.
    pub negative: String,
}

impl BadRow {
    /// Name and cells.
    pub(super) fn cells(&self) -> [&str; 5] {
        [&self.name, &self.nan, &self.infinite, &self.zero, &self.negative]
    }
}

/// A row for each argument that ever matters.
pub(super) fn rows(probe: &Probe) -> Vec<BadRow> {
    let outcomes = outcomes(probe);
    let cell = |of: &[&Outcome], value: BadValue| match of.iter().find(|outcome| outcome.value == value) {
        Some(outcome) => outcome.kinds.iter().map(ToString::to_string).collect::<Vec<_>>().join(" or "),
        None => "legal".to_string(),
    };
    let row = |name: &'static str| {
        let of: Vec<&Outcome> = outcomes.iter().filter(|outcome| outcome.argument == name).collect();
        let [nan, infinite, zero, negative] = COLUMNS.map(|value| cell(&of, value));
        (!of.is_empty()).then(|| BadRow { name: name.to_string(), nan, infinite, zero, negative })
    };
    probe.arguments.iter().filter_map(|argument| row(argument.quantity.name)).collect()
}
