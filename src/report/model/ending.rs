//! What is measured at the end of a run alone.

use serde::{Deserialize, Serialize};

/// Measurements of the end.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Ending {
    /// Single numbers.
    pub quantities: Vec<EndQuantity>,
    /// One number over another.
    pub curves: Vec<EndCurve>,
}

/// One number of an [`Ending`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct EndQuantity {
    /// As a column is named.
    pub name: String,
    /// For people.
    pub label: String,
    /// Its symbol; empty where it has none.
    pub symbol: String,
    /// Its unit.
    pub unit: String,
    /// What it should be. Absent where nothing is known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub expected: Option<f64>,
    /// Where that is from. Absent where nothing is known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub expected_source: Option<String>,
    /// Its value. Absent where this end has none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub value: Option<f64>,
    /// Why there is none, in a clause. Absent where there is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub missing: Option<String>,
}

/// One number over another.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct EndCurve {
    /// As a file is named.
    pub name: String,
    /// For people.
    pub label: String,
    /// What it runs along.
    pub x: CurveColumn,
    /// What it shows, at each `x`.
    pub y: CurveColumn,
    /// A line that it should look like. Absent where nothing is known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub expected: Option<ExpectedLine>,
}

impl EndCurve {
    /// Its points.
    pub fn points(&self) -> impl Iterator<Item = (f64, f64)> {
        self.x.value.iter().copied().zip(self.y.value.iter().copied())
    }
}

/// The numbers along one axis of an [`EndCurve`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CurveColumn {
    /// As a column is named.
    pub name: String,
    /// For people, with its symbol.
    pub label: String,
    /// Its unit.
    pub unit: String,
    /// Whether it is drawn by powers of ten; all numbers are above zero then.
    pub logarithmic: bool,
    /// The numbers.
    pub value: Vec<f64>,
}

/// What an [`EndCurve`] should look like.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ExpectedLine {
    /// What it is and where it is from.
    pub source: String,
    /// Its corners, ascending.
    pub x: Vec<f64>,
    /// The same.
    pub y: Vec<f64>,
}
