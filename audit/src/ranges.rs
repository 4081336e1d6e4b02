//! The record of proven ranges, `audit/ranges.toml`: what each equation can give at all.

use crate::enclosure::{Enclosure, enclose};
use crate::probe::Probe;
use crate::probes::probes;
use crate::target::Label;
use serde::{Deserialize, Serialize};

/// Into so many boxes each domain is cut for the record.
pub const BOXES: usize = 4096;

/// All ranges.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Ranges {
    /// In the order of the probes and their results.
    #[serde(rename = "range", default)]
    pub ranges: Vec<Range>,
}

/// The range of one result over the domain of its probe.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Range {
    /// The probe's key.
    pub probe: String,
    /// The result's name.
    pub output: String,
    /// The lower bound; nothing where there is none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub low: Option<f64>,
    /// The upper bound; nothing where there is none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub high: Option<f64>,
    /// How the bounds are known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub label: Option<Label>,
    /// Why a bound is missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gap: Option<String>,
    /// The least and the greatest value of a sample.
    pub seen: [f64; 2],
}

impl Range {
    fn of(probe: &str, enclosure: &Enclosure) -> Self {
        let (low, high) = (enclosure.bounds.low(), enclosure.bounds.high());
        let finite = |bound: f64| bound.is_finite().then_some(bound);
        Range {
            probe: probe.to_string(),
            output: enclosure.output.clone(),
            low: finite(low),
            high: finite(high),
            label: (low.is_finite() || high.is_finite()).then_some(Label::Proven),
            gap: enclosure.gap.map(|gap| gap.to_string()),
            seen: [enclosure.seen.low(), enclosure.seen.high()],
        }
    }
    /// Whether both bounds are there.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        self.low.is_some() && self.high.is_some()
    }
}

impl Ranges {
    /// Encloses the results of all probes.
    #[must_use]
    pub fn now() -> Self {
        let of_probe = |probe: &Probe| {
            let key = probe.key();
            enclose(probe, BOXES).iter().map(|enclosure| Range::of(&key, enclosure)).collect::<Vec<_>>()
        };
        Ranges { ranges: probes().iter().flat_map(of_probe).collect() }
    }
    /// The text of the record, as it is checked in.
    ///
    /// # Errors
    /// None that is known; what the serialiser says is passed on.
    pub fn to_toml(&self) -> Result<String, toml::ser::Error> {
        let head = "\
# What each equation can give over its whole domain, enclosed by intervals; `docs/audit.md` explains the figures.
# Generated; do not edit. Command: etalon audit --record
";
        Ok(format!("{head}\n{}", toml::to_string(self)?))
    }
    /// The ranges of a probe.
    pub fn of(&self, probe: &str) -> impl Iterator<Item = &Range> {
        self.ranges.iter().filter(move |range| range.probe == probe)
    }
    /// How many results have both bounds.
    #[must_use]
    pub fn finite(&self) -> usize {
        self.ranges.iter().filter(|range| range.is_finite()).count()
    }
}
