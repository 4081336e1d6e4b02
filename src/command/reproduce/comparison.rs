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
    /// What the paper's tables say to beware of, whatever the variant.
    caveat: &'a str,
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
            let rows = all.iter().filter(|p| (&p.quantity, p.place) == (&published.quantity, published.place));
            quantities.push(Quantity { reading, published, pairs, caveat: common_end(rows.map(note)) });
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
        let better = match better {
            Goal::Target(target) => format!("closer to {} is better", plain(*target)),
            goal => goal.to_string(),
        };
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
                self.label(pair),
                number(published),
                number(pair.ours),
                number(ratio.filter(|ratio| ratio.is_finite())),
                rank(theirs[k]),
                rank(ours[k]),
            ]);
        }
        out += &columns(&rows);
        for note in [self.reading.note, self.caveat].into_iter().filter(|note| !note.is_empty()) {
            out += &format!("Note: {note}\n");
        }
        for pair in &self.pairs {
            if let Some(said) = self.said_of(pair) {
                out += &format!("The paper of {}: {said}\n", self.label(pair));
            }
        }
        out
    }

    /// A variant with its resolution, where there are several.
    fn label(&self, pair: &Pair) -> String {
        match pair.compared.resolution.filter(|_| self.has_resolutions()) {
            Some(resolution) => format!("{}, {resolution}", pair.compared.variant),
            None => pair.compared.variant.to_string(),
        }
    }

    /// What is said of this variant alone.
    fn said_of<'b>(&self, pair: &Pair<'b>) -> Option<&'b str> {
        let said = note(pair.compared.place).strip_suffix(self.caveat)?.trim();
        (!said.is_empty()).then_some(said)
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
            put("said", self.said_of(pair).map(|said| json!(said)));
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
            "caveat": self.caveat,
            "variants": self.pairs.iter().enumerate().map(entry).collect::<Vec<_>>(),
        })
    }
}

/// What a row of a table says beside its number: of the variant, then of all.
fn note(published: &Published) -> &str {
    published.note.as_deref().unwrap_or_default()
}

/// The words that all end with, from the beginning of a sentence on.
fn common_end<'a>(notes: impl Iterator<Item = &'a str>) -> &'a str {
    let both = |a: &'a str, b: &'a str| {
        let same = a.chars().rev().zip(b.chars().rev()).take_while(|(a, b)| a == b);
        let end = &a[a.len() - same.map(|(c, _)| c.len_utf8()).sum::<usize>()..];
        match end.len() == a.len() || end.len() == b.len() {
            true => end,
            // What they share may begin within a sentence that differs.
            false => end.find(". ").map_or("", |dot| &end[dot + 2..]),
        }
    };
    notes.reduce(both).unwrap_or_default()
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
    fn what_all_rows_say_is_told_from_what_one_says() {
        let end = |notes: &[&'static str]| common_end(notes.iter().copied());
        assert_eq!(end(&["Noisy. Beware.", "Beware.", "Less noisy. Beware."]), "Beware.");
        assert_eq!(
            end(&["Said to be large. Beware. Really.", "Said to be enlarged. Beware. Really."]),
            "Beware. Really."
        );
        assert_eq!(
            (end(&["Large.", "Enlarged."]), end(&["Beware."]), end(&["", "Beware."]), end(&[])),
            ("", "Beware.", "", "")
        );
    }

    #[test]
    fn ranks_follow_the_goal_and_skip_what_is_not_there() {
        let values = [Some(3.0), None, Some(1.0), Some(3.0), Some(f64::NAN)];
        assert_eq!(ranks(Goal::Lower, &values), [Some(2), None, Some(1), Some(2), None]);
        assert_eq!(ranks(Goal::Higher, &values), [Some(1), None, Some(3), Some(1), None]);
        assert_eq!(ranks(Goal::Target(1.5), &values), [Some(2), None, Some(1), Some(2), None]);
    }
}
