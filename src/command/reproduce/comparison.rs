//! Ours beside theirs, with ranks.

use super::readings::{READINGS, Reading};
use super::runs::Run;
use crate::command::failure::Failure;
use crate::command::sweep::Store;
use crate::report::{CellText, HeatColumn, HeatMap, HeatMatrix, Plot, columns, heat_map, plain, utc_now};
use etalon_spec::tables::{Goal, Published, Variant};
use serde_json::{Value, json};
use std::path::Path;

/// A variant's two numbers.
struct Pair<'a> {
    variant: Variant,
    published: Option<f64>,
    ours: Option<f64>,
    run: &'a Run,
}

/// One quantity of one scene for all its variants.
struct Quantity<'a> {
    reading: &'static Reading,
    published: &'a Published,
    pairs: Vec<Pair<'a>>,
}

/// All that was compared.
pub struct Comparison<'a> {
    quantities: Vec<Quantity<'a>>,
}

impl<'a> Comparison<'a> {
    /// From what is done.
    pub fn new(runs: &'a [Run], store: &Store, all: &'a [Published]) -> Self {
        let mut quantities = Vec::new();
        for reading in READINGS {
            let concerned = runs.iter().filter(|run| run.readings.iter().any(|r| r.quantity == reading.quantity));
            let theirs = |variant: Variant| {
                all.iter().find(|p| p.quantity == reading.quantity && p.scheme == variant && p.value.is_some())
            };
            let pairs: Vec<Pair> = concerned
                .map(|run| Pair {
                    variant: run.variant,
                    published: theirs(run.variant).and_then(|p| p.value),
                    ours: store.find(&run.job.id()).and_then(|record| reading.of(record, run.job.setup.dimension)),
                    run,
                })
                .collect();
            let published = all.iter().find(|p| p.quantity == reading.quantity);
            if let (false, Some(published)) = (pairs.is_empty(), published) {
                quantities.push(Quantity { reading, published, pairs });
            }
        }
        Comparison { quantities }
    }

    /// Tables for people.
    pub fn text(&self, folder: &Path, left: usize) -> String {
        let mut out = String::new();
        for quantity in &self.quantities {
            out += &quantity.text();
            out.push('\n');
        }
        if left > 0 {
            out += &format!("{left} runs are left; the same command goes on with them.\n");
        }
        out + &format!("Heat map: {}\n", folder.join("heat_map.svg").display())
    }

    /// The same for programs.
    pub fn json(&self) -> Value {
        json!({
            "schema": "etalon-reproduce",
            "schema_version": 1,
            "created": utc_now(),
            "quantities": self.quantities.iter().map(Quantity::json).collect::<Vec<_>>(),
        })
    }

    /// Schemes against quantities, published and ours, as GS25 Fig. 10; none where nothing is done.
    pub fn heat_map(&self) -> Result<Option<Plot>, Failure> {
        let mut rows: Vec<Variant> = Vec::new();
        for variant in self.quantities.iter().flat_map(|quantity| quantity.pairs.iter().map(|pair| pair.variant)) {
            if !rows.contains(&variant) {
                rows.push(variant);
            }
        }
        if self.quantities.is_empty() {
            return Ok(None);
        }
        let matrix = |title: &str, of: &dyn Fn(&Pair) -> Option<f64>| HeatMatrix {
            title: title.into(),
            values: rows
                .iter()
                .map(|row| {
                    let cell = |quantity: &Quantity| quantity.pairs.iter().find(|p| p.variant == *row).and_then(of);
                    self.quantities.iter().map(cell).collect()
                })
                .collect(),
        };
        let map = HeatMap {
            file: "heat_map.svg".into(),
            title: "Schemes against quantities".into(),
            caption: "Relative difference to the best scheme of each column; published on the left, ours on the right."
                .into(),
            rows: rows.iter().map(ToString::to_string).collect(),
            columns: self
                .quantities
                .iter()
                .map(|quantity| HeatColumn {
                    name: quantity.reading.quantity.replace('_', " "),
                    goal: quantity.published.better,
                })
                .collect(),
            matrices: vec![matrix("published", &|p| p.published), matrix("ours", &|p| p.ours)],
            cells: CellText::Differences,
        };
        Ok(Some(heat_map(&map)?))
    }
}

impl Quantity<'_> {
    /// The ranks of the values that there are, 1 for the best; equal values share the better rank.
    fn ranks(&self, of: impl Fn(&Pair) -> Option<f64>) -> Vec<Option<usize>> {
        ranks(self.published.better, &self.pairs.iter().map(of).collect::<Vec<_>>())
    }

    fn text(&self) -> String {
        let Published { paper, place, meaning, unit, time, better, .. } = self.published;
        let mut out = format!(
            "{}: {meaning} [{unit}], {time} ({} {place})\n{better}\n",
            self.reading.scene.title(),
            paper.to_string().to_uppercase()
        );
        let number = |value: Option<f64>| value.map_or_else(|| "-".into(), plain);
        let rank = |rank: Option<usize>| rank.map_or_else(|| "-".into(), |rank| rank.to_string());
        let (theirs, ours) = (self.ranks(|p| p.published), self.ranks(|p| p.ours));
        let mut rows = vec![["scheme", "published", "ours", "ours/published", "rank", "ours"].map(String::from)];
        for (k, pair) in self.pairs.iter().enumerate() {
            let ratio = pair.ours.zip(pair.published).map(|(ours, theirs)| ours / theirs);
            rows.push([
                pair.variant.to_string(),
                number(pair.published),
                number(pair.ours),
                number(ratio.filter(|ratio| ratio.is_finite())),
                rank(theirs[k]),
                rank(ours[k]),
            ]);
        }
        out += &columns(&rows);
        for note in [Some(self.reading.note), self.published.note.as_deref()].into_iter().flatten() {
            if !note.is_empty() {
                out += &format!("Note: {}\n", note.trim());
            }
        }
        out
    }

    fn json(&self) -> Value {
        let (theirs, ours) = (self.ranks(|p| p.published), self.ranks(|p| p.ours));
        let pairs: Vec<Value> = self
            .pairs
            .iter()
            .enumerate()
            .map(|(k, pair)| {
                let mut entry = json!({
                    "variant": pair.variant.as_str(),
                    "command": format!("etalon run {} --alone", pair.run.job.id()),
                });
                for (key, value) in [("published", pair.published), ("ours", pair.ours)] {
                    if let Some(value) = value {
                        entry[key] = json!(value);
                    }
                }
                for (key, rank) in [("rank_published", theirs[k]), ("rank_ours", ours[k])] {
                    if let Some(rank) = rank {
                        entry[key] = json!(rank);
                    }
                }
                entry
            })
            .collect();
        json!({
            "quantity": self.reading.quantity,
            "scene": self.reading.scene.name(),
            "meaning": self.published.meaning,
            "unit": self.published.unit.to_string(),
            "time": self.published.time,
            "place": self.published.place.to_string(),
            "better": self.published.better.to_string(),
            "note": self.reading.note,
            "variants": pairs,
        })
    }
}

/// The rank of each value that there is, 1 for the best; equal values share the better rank.
fn ranks(goal: Goal, values: &[Option<f64>]) -> Vec<Option<usize>> {
    let badness: Vec<Option<f64>> =
        values.iter().map(|v| v.filter(|v| v.is_finite()).map(|v| goal.badness(v))).collect();
    let rank = |own: f64| 1 + badness.iter().flatten().filter(|other| **other < own).count();
    badness.iter().map(|own| own.map(rank)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranks_follow_the_goal_and_skip_what_is_not_there() {
        let values = [Some(3.0), None, Some(1.0), Some(3.0), Some(f64::NAN)];
        assert_eq!(ranks(Goal::Lower, &values), [Some(2), None, Some(1), Some(2), None]);
        assert_eq!(ranks(Goal::Higher, &values), [Some(1), None, Some(3), Some(1), None]);
        assert_eq!(ranks(Goal::Target(1.5), &values), [Some(2), None, Some(1), Some(2), None]);
    }
}
