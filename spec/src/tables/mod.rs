//! What the papers publish, as data: schemes, set-ups and results of GS25; results of PL20 and C25.
//!
//! Tables with a form of their own have a type of their own: [`Schemes`], [`Setups`], [`Results`], [`MembraneSettings`].
//! [`published()`] hands out every number in one form.

mod catalogue;
mod membrane;
mod numbers;
mod place;
mod quantity;
mod results;
mod scene;
mod schemes;
mod setups;
mod variant;

pub use catalogue::{Published, parse_published, published};
pub use membrane::{Factor, MembraneSetting, MembraneSettings, MembraneVariant, Modulation};
pub use numbers::Says;
pub use place::Place;
pub use quantity::{Better, Goal, Quantity};
pub use results::{Metric, MetricKey, Results};
pub use scene::Scene;
pub use schemes::{LinearCoefficient, Scheme, SchemeName, Schemes};
pub use setups::{PerAxis, Setup, Setups, Test};
pub use variant::{DragScheme, GradHForm, Rung, Variant};

use serde::Deserialize;
use serde::de::DeserializeOwned;
use thiserror::Error;

use crate::paper::Paper;
use crate::text::{ReadError, parse_table, typed};

/// A fault in a file of tables. Each message names the file, the row, the field and what to do.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum TableError {
    /// The file is not TOML or a key is unknown, missing or of the wrong type.
    #[error("{file}{place}: {message}; compare with the other rows of the file")]
    Shape {
        /// The file.
        file: String,
        /// The line, where it is known, with a comma before it.
        place: String,
        /// What is wrong, with the name of the key.
        message: String,
    },
    /// Nothing is kept of that place.
    #[error(
        "no numbers are kept of {paper}, {place}, in the common form; `published()` lists the places that have some"
    )]
    UnknownPlace {
        /// The paper.
        paper: Paper,
        /// The place.
        place: Place,
    },
    /// The file is not the one of the place it is kept for.
    #[error("{file}, fields `paper` and `{key}`: they say {found}; they must say {expected}")]
    WrongTable {
        /// The file.
        file: String,
        /// The field that numbers the place.
        key: &'static str,
        /// What they must say.
        expected: String,
        /// What they say.
        found: String,
    },
    /// A row that should be there once is missing, doubled or out of order.
    #[error(
        "{file}, row {row}, field `{field}`: found `{found}` where `{expected}` belongs; keep one row for each, in the published order"
    )]
    Row {
        /// The file.
        file: String,
        /// The row, from 1.
        row: usize,
        /// The field that identifies rows.
        field: &'static str,
        /// What stands there.
        found: String,
        /// What should stand there.
        expected: String,
    },
    /// A number is outside its domain.
    #[error("{file}, row `{row}`, field `{field}`: {value} is not {domain}; correct it from the paper")]
    Domain {
        /// The file.
        file: String,
        /// What identifies the row.
        row: String,
        /// The field.
        field: &'static str,
        /// The value, as text.
        value: String,
        /// What it must be.
        domain: &'static str,
    },
}

/// Reads a file of tables, checks that it is that `place` of the `paper`, and gives the rows their type.
///
/// `paper`, the place (`table`, `figure` or `equation`) and `about` stand at the head of every such file; they must be
/// there and are left out of the rows.
fn read<T: DeserializeOwned>(file: &str, paper: Paper, place: Place, text: &str) -> Result<T, TableError> {
    #[derive(Deserialize)]
    struct Head {
        paper: String,
        #[serde(rename = "about")]
        _about: String,
    }
    let shape = |error: ReadError| TableError::Shape {
        file: file.to_owned(),
        place: error.line.map_or_else(String::new, |line| format!(", line {line}")),
        message: error.message,
    };
    let mut rows = parse_table(text).map_err(shape)?;
    let head: Head = typed(toml::Value::Table(rows.clone())).map_err(shape)?;
    let number = rows.get(place.key()).map_or_else(|| "nothing".to_owned(), toml::Value::to_string);
    let (found, expected) = (format!("{}, {number}", head.paper), format!("{paper}, {}", place.number()));
    if found != expected {
        return Err(TableError::WrongTable { file: file.to_owned(), key: place.key(), expected, found });
    }
    rows.retain(|key, _| !["paper", place.key(), "about"].contains(&key));
    typed(toml::Value::Table(rows)).map_err(shape)
}

/// `load` and `parse` for a table of GS25: its number, its file, and the function that checks the rows once they have their type.
macro_rules! loaded {
    ($type:ident, $number:literal, $file:literal, $checked:path) => {
        impl $type {
            /// The table built into this crate.
            ///
            /// # Errors
            /// [`TableError`] for the first fault found; none occurs in a build whose tests pass.
            pub fn load() -> Result<Self, TableError> {
                Self::parse(concat!("spec/tables/", $file), include_str!(concat!("../../tables/", $file)))
            }

            /// Reads and checks the text of the table; `file` is its name for messages.
            ///
            /// # Errors
            /// [`TableError`] for the first fault found.
            pub fn parse(file: &str, text: &str) -> Result<Self, TableError> {
                $checked(
                    file,
                    $crate::tables::read(
                        file,
                        $crate::paper::Paper::Gs25,
                        $crate::tables::Place::Table($number),
                        text,
                    )?,
                )
            }
        }
    };
}
use loaded;

/// Checks that the rows carry the `expected` names, each once and in order.
fn rows_in_order<T: Copy + PartialEq + std::fmt::Debug>(
    file: &str,
    field: &'static str,
    found: &[T],
    expected: &[T],
) -> Result<(), TableError> {
    for row in 0..found.len().max(expected.len()) {
        let name = |names: &[T]| names.get(row).map_or_else(|| "nothing".to_owned(), |name| format!("{name:?}"));
        if found.get(row) != expected.get(row) {
            let (found, expected) = (name(found), name(expected));
            return Err(TableError::Row { file: file.to_owned(), row: row + 1, field, found, expected });
        }
    }
    Ok(())
}

/// Checks one number of a row against a condition.
fn domain<T: std::fmt::Debug>(
    file: &str,
    row: &T,
    field: &'static str,
    value: f64,
    allowed: bool,
    domain: &'static str,
) -> Result<(), TableError> {
    if allowed {
        return Ok(());
    }
    Err(TableError::Domain { file: file.to_owned(), row: format!("{row:?}"), field, value: value.to_string(), domain })
}
