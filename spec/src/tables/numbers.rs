//! A file of published numbers: what they measure, and one row for each variant.

use serde::Deserialize;

use super::place::Place;
use super::quantity::Quantity;
use super::scene::Scene;
use super::variant::Variant;
use super::{TableError, domain, read, rows_in_order};
use crate::paper::Paper;
use crate::text::one_line;

/// How a paper states a value.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Says {
    /// As a number.
    #[default]
    Exactly,
    /// As a number that is not meant to be exact.
    About,
    /// As an upper bound.
    AtMost,
}

/// A column of such a file.
pub(super) type Column = Quantity<String, Scene>;

/// The rows of such a file, each with what was run.
pub(super) type Rows = Vec<(Variant, Row)>;

/// A row of such a file.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Row {
    /// The key of the column.
    pub(super) quantity: String,
    /// The name of the variant.
    scheme: String,
    /// The paper's name of the run.
    pub(super) run: Option<String>,
    /// Particles along an axis or in a wavelength; the file says which.
    pub(super) resolution: Option<u32>,
    /// The value as printed; none where the paper or the text at hand has none.
    pub(super) value: Option<f64>,
    #[serde(default)]
    pub(super) says: Says,
    pub(super) note: Option<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    quantity: Vec<Column>,
    result: Vec<Row>,
}

/// A place of a paper with what must stand in its file: the columns, and the rows of each.
pub(super) struct Source {
    pub(super) paper: Paper,
    pub(super) place: Place,
    pub(super) text: &'static str,
    /// Every column with its variants, in the order of the file; one that has several resolutions as often as those.
    pub(super) columns: &'static [(&'static str, &'static [Variant])],
}

impl Source {
    /// Reads and checks the text of the file: the columns, and the rows with their variants.
    pub(super) fn parse(&self, text: &str) -> Result<(Vec<Column>, Rows), TableError> {
        let file = &self.place.file(self.paper);
        let File { quantity: mut columns, result: mut rows } = read(file, self.paper, self.place, text)?;
        let keys: Vec<&str> = columns.iter().map(|column| column.key.as_str()).collect();
        let expected: Vec<&str> = self.columns.iter().map(|(key, _)| *key).collect();
        rows_in_order(file, "key", &keys, &expected)?;
        let mut expected = Vec::new();
        for &(key, variants) in self.columns {
            expected.extend(variants.iter().map(|&variant| (key, variant)));
        }
        let found: Vec<(&str, &str)> = rows.iter().map(|row| (row.quantity.as_str(), row.scheme.as_str())).collect();
        let names: Vec<(&str, &str)> = expected.iter().map(|(key, variant)| (*key, variant.as_str())).collect();
        rows_in_order(file, "quantity, scheme", &found, &names)?;
        for column in &mut columns {
            column.checked(file)?;
        }
        for row in &mut rows {
            row.note = row.note.as_deref().map(one_line);
            let (name, says) = ((row.quantity.as_str(), row.scheme.as_str()), row.says);
            let value = row.value.unwrap_or(f64::NAN);
            domain(file, &name, "value", value, row.value.is_none_or(f64::is_finite), "a finite number")?;
            let stated = row.value.is_some() || (says == Says::Exactly && row.note.is_some());
            domain(
                file,
                &name,
                "value",
                value,
                stated,
                "given; without one a note must say why, and `says` be left out",
            )?;
        }
        for pair in rows.windows(2) {
            let [one, next] = pair else { continue };
            if (&one.quantity, &one.scheme) == (&next.quantity, &next.scheme) {
                let name = (next.quantity.as_str(), next.scheme.as_str());
                let finer = one.resolution < next.resolution && one.resolution.is_some();
                let resolution = f64::from(next.resolution.unwrap_or(0));
                domain(file, &name, "resolution", resolution, finer, "finer than that of the row before")?;
            }
        }
        Ok((columns, expected.into_iter().map(|(_, variant)| variant).zip(rows).collect()))
    }
}
