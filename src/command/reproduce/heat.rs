//! The comparison as heat maps, as GS25 Fig. 10: what one paper compares with each other against the quantities it is compared by.

use super::comparison::{Comparison, Pair, Quantity};
use crate::command::failure::Failure;
use crate::report::{CellText, HeatColumn, HeatMap, HeatMatrix, Plot, heat_map};
use etalon_spec::tables::Variant;

/// A column: a quantity, at one of its resolutions.
type Column<'a> = (&'a Quantity<'a>, Option<usize>);

impl Comparison<'_> {
    /// A map for each family of variants with anything to rank.
    pub fn heat_maps(&self) -> Result<Vec<Plot>, Failure> {
        let mut plots = Vec::new();
        for (file, title, of) in FAMILIES {
            let columns = self.columns(of);
            let rows = variants(&columns, of);
            let pairs = || columns.iter().flat_map(|(quantity, _)| &quantity.pairs).filter(|p| of(p.compared.variant));
            let matrix = |title: &str, value: fn(&Pair) -> Option<f64>| {
                let cell = |row: Variant, (quantity, resolution): &Column| {
                    let own = |p: &&Pair| p.compared.variant == row && p.compared.resolution == *resolution;
                    quantity.pairs.iter().find(own).and_then(value)
                };
                let values: Vec<Vec<Option<f64>>> =
                    rows.iter().map(|row| columns.iter().map(|column| cell(*row, column)).collect()).collect();
                pairs().any(|pair| value(pair).is_some()).then(|| HeatMatrix { title: title.into(), values })
            };
            let matrices = [matrix("published", |p| p.compared.published), matrix("ours", |p| p.ours)];
            let matrices: Vec<HeatMatrix> = matrices.into_iter().flatten().collect();
            if matrices.is_empty() {
                continue;
            }
            plots.push(heat_map(&HeatMap {
                file: file.into(),
                title: title.into(),
                caption: "Relative difference to the best of each column.".into(),
                rows: rows.iter().map(ToString::to_string).collect(),
                columns: columns.iter().map(heading).collect(),
                matrices,
                cells: CellText::Differences,
            })?);
        }
        Ok(plots)
    }

    /// The columns in which at least two of a family can be compared with each other.
    fn columns(&self, of: fn(Variant) -> bool) -> Vec<Column<'_>> {
        let mut columns = Vec::new();
        for quantity in &self.quantities {
            let mut resolutions: Vec<Option<usize>> = quantity.pairs.iter().map(|p| p.compared.resolution).collect();
            resolutions.sort_unstable();
            resolutions.dedup();
            for resolution in resolutions {
                let here = |p: &&Pair| of(p.compared.variant) && p.compared.resolution == resolution;
                let known = |value: fn(&Pair) -> Option<f64>| {
                    quantity.pairs.iter().filter(here).filter(|pair| value(pair).is_some()).count()
                };
                if known(|pair| pair.compared.published).max(known(|pair| pair.ours)) > 1 {
                    columns.push((quantity, resolution));
                }
            }
        }
        columns
    }
}

/// What is compared with each other: file, title, and which variants.
type Family = (&'static str, &'static str, fn(Variant) -> bool);
const FAMILIES: [Family; 4] = [
    ("heat_map.svg", "Dissipation schemes", |variant| matches!(variant, Variant::Scheme(_))),
    ("heat_map_membrane.svg", "Schemes on the membrane", |variant| matches!(variant, Variant::Membrane(_))),
    ("heat_map_dust.svg", "Drag between gas and dust", |variant| matches!(variant, Variant::Drag(_))),
    ("heat_map_ladder.svg", "Ingredients of a code", |variant| matches!(variant, Variant::Rung(_) | Variant::GradH(_))),
];

/// The variants of a family with a number in any column, in the order in which they come.
fn variants(columns: &[Column], of: fn(Variant) -> bool) -> Vec<Variant> {
    let mut rows: Vec<Variant> = Vec::new();
    for pair in columns.iter().flat_map(|(quantity, _)| &quantity.pairs) {
        let variant = pair.compared.variant;
        if of(variant) && pair.compared.published.or(pair.ours).is_some() && !rows.contains(&variant) {
            rows.push(variant);
        }
    }
    rows
}

fn heading((quantity, resolution): &Column) -> HeatColumn {
    let name = quantity.reading.quantity.replace('_', " ").replace(" l1", " L1");
    let name = match resolution.filter(|_| quantity.has_resolutions()) {
        Some(resolution) => format!("{name}, {resolution}"),
        None => name,
    };
    HeatColumn { name, goal: quantity.published.better }
}
