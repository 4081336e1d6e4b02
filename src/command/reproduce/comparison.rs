//! Ours beside theirs, with ranks.

use super::readings::{READINGS, Reading};
use super::runs::Compared;
use crate::command::sweep::Store;
use crate::report::{columns, plain, utc_now};
use etalon_spec::tables::{Goal, Published, Variant};
use serde_json::{Value, json};

/// A variant's two numbers.
pub struct Pair<'a> {
    /// What was run.
    pub compared: &'a Compared,
    /// Ours; none where runs are missing or did not measure it.
    pub ours: Option<f64>,
}

/// One quantity of one scene for all its variants.
pub struct Quantity<'a> {
    /// How it is read.
    pub reading: &'static Reading,
    /// The first published number of it, for what it says of the quantity.
    pub published: &'a Published,
    /// The variants.
    pub pairs: Vec<Pair<'a>>,
}

/// All that was compared.
pub struct Comparison<'a> {
    /// In the order of the readings.
    pub quantities: Vec<Quantity<'a>>,
}

impl<'a> Comparison<'a> {
    /// From what is done.
    pub fn new(compared: &'a [Compared], store: &Store, all: &'a [Published]) -> Self {
        let mut quantities = Vec::new();
        for reading in READINGS {
            let of: Vec<&Compared> = compared.iter().filter(|c| c.reading.quantity == reading.quantity).collect();
            let Some(published) = all.iter().find(|p| p.quantity == reading.quantity && !of.is_empty()) else {
                continue;
            };
            let ours = of.iter().map(|compared| read(compared, store)).collect();
            let variants: Vec<Variant> = of.iter().map(|compared| compared.variant).collect();
            let theirs: Vec<Option<f64>> = of.iter().map(|compared| compared.published).collect();
            let ours = reading.among.apply(&variants, &theirs, ours);
            let pairs = of.into_iter().zip(ours).map(|(compared, ours)| Pair { compared, ours }).collect();
            quantities.push(Quantity { reading, published, pairs });
        }
        Comparison { quantities }
    }

    /// Tables for people.
    pub fn text(&self) -> String {
        self.quantities.iter().map(|quantity| quantity.text() + "\n").collect()
    }

    /// The same for programs.
    pub fn json(&self) -> Value {
        json!({
            "schema": "etalon-reproduce",
            "schema_version": 2,
            "created": utc_now(),
            "quantities": self.quantities.iter().map(Quantity::json).collect::<Vec<_>>(),
        })
    }
}

/// Ours, once all its runs are done.
fn read(compared: &Compared, store: &Store) -> Option<f64> {
    let records = compared.jobs.iter().map(|(along, job)| Some((*along, store.find(&job.id())?)));
    let records: Vec<_> = records.collect::<Option<_>>()?;
    compared.reading.of(&records, compared.jobs.first()?.1.setup.dimension)
}

impl Quantity<'_> {
    /// Whether the paper has it at several resolutions.
    pub fn has_resolutions(&self) -> bool {
        self.pairs.iter().any(|pair| pair.compared.resolution != self.pairs[0].compared.resolution)
    }

    /// The ranks of the published values and of ours.
    fn ranks(&self) -> [Vec<Option<usize>>; 2] {
        let of = |value: fn(&Pair) -> Option<f64>| {
            ranks(self.published.better, &self.pairs.iter().map(value).collect::<Vec<_>>())
        };
        [of(|pair| pair.compared.published), of(|pair| pair.ours)]
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
        let [theirs, ours] = self.ranks();
        let mut rows = vec![["scheme", "published", "ours", "ours/published", "rank", "ours"].map(String::from)];
        for (k, pair) in self.pairs.iter().enumerate() {
            let published = pair.compared.published;
            let ratio = pair.ours.zip(published).map(|(ours, theirs)| ours / theirs);
            rows.push([
                match pair.compared.resolution.filter(|_| self.has_resolutions()) {
                    Some(resolution) => format!("{}, {resolution}", pair.compared.variant),
                    None => pair.compared.variant.to_string(),
                },
                number(published),
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
        let [theirs, ours] = self.ranks();
        let entry = |(k, pair): (usize, &Pair)| {
            let compared = pair.compared;
            let commands = compared.jobs.iter().map(|(_, job)| format!("etalon run {} --alone", job.id()));
            let mut entry = json!({
                "variant": compared.variant.as_str(),
                "commands": commands.collect::<Vec<_>>(),
            });
            let mut put = |key: &str, value: Option<Value>| {
                if let Some(value) = value {
                    entry[key] = value;
                }
            };
            put("resolution", compared.resolution.map(|resolution| json!(resolution)));
            put("published", compared.published.map(|value| json!(value)));
            put("ours", pair.ours.map(|value| json!(value)));
            put("rank_published", theirs[k].map(|rank| json!(rank)));
            put("rank_ours", ours[k].map(|rank| json!(rank)));
            entry
        };
        json!({
            "quantity": self.reading.quantity,
            "scene": self.reading.scene.name(),
            "meaning": self.published.meaning,
            "unit": self.published.unit.to_string(),
            "time": self.published.time,
            "place": self.published.place.to_string(),
            "better": self.published.better.to_string(),
            "note": self.reading.note,
            "variants": self.pairs.iter().enumerate().map(entry).collect::<Vec<_>>(),
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
