//! What is measured while a run goes on.

use serde::{Deserialize, Serialize};

/// Measurements in time.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Series {
    /// When, ascending, in the scene's units.
    pub time: Vec<f64>,
    /// What.
    pub quantities: Vec<SeriesQuantity>,
}

/// One quantity of a [`Series`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SeriesQuantity {
    /// As a column is named.
    pub name: String,
    /// For people.
    pub label: String,
    /// Its symbol.
    pub symbol: String,
    /// Its unit.
    pub unit: String,
    /// What it should be at the end. Absent where nothing is known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub expected: Option<f64>,
    /// Where that is from. Absent where nothing is known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub expected_source: Option<String>,
    /// Its value at each time.
    pub value: Vec<f64>,
}
