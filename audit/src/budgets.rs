//! The record of budgets and figures, `audit/budgets.toml`, and what is wrong if a measurement does not fit it.
//!
//! Of what a device ran there is a record for each device, with the mark of the text it ran.
//!
//! A *budget* is the largest of the bounds that follow from the operations, in ulps of the natural scale. Each result is held
//! against the bound for its own inputs, which is proven to first order in the unit roundoff. The *worst* figures are measured. Inputs are always the same, so on any machine a measurement with as
//! many samples gives the recorded figures to the last digit, and one with fewer gives no larger ones.

use crate::device::text_mark;
use crate::measure::{Measurement, Worst};
use crate::probe::Probe;
use crate::probes::probes;
use crate::target::{Label, Target};
use serde::{Deserialize, Serialize};

/// How many random inputs a full measurement tries, beside the hard ones.
pub const FULL_SAMPLES: usize = 100_000;

/// Enough for the record's own rounding to three digits.
const ROUNDING_OF_RECORD: f64 = 1.001;

/// One probe on one target.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Record {
    /// The probe's key.
    pub probe: String,
    /// The target's name.
    pub target: String,
    /// The device, where one ran it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub adapter: Option<String>,
    /// The mark of the text that the device ran.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[serde(rename = "text")]
    pub text_mark: Option<String>,
    /// How many inputs were tried.
    pub inputs: usize,
    /// The largest of the bounds that follow from the operations, in ulps of the natural scale.
    pub budget: f64,
    /// How the budget is known.
    pub budget_label: Label,
    /// The largest error in ulps of the natural scale.
    pub worst: f64,
    /// How that is known.
    pub worst_label: Label,
    /// The output that it is in; empty if all results were exact.
    pub worst_output: String,
    /// The inputs it was found at, exact.
    pub worst_inputs: Vec<f64>,
    /// The largest error in ulps of the result itself; of any size where the equation cancels.
    pub worst_of_result: f64,
    /// How many numbers have no bound, because a divisor may be nothing.
    pub unbounded: usize,
}

impl Record {
    /// Of a measurement; figures are rounded up to three digits.
    #[must_use]
    pub fn of(measurement: &Measurement) -> Self {
        let Worst { ulps, output, inputs } = measurement.of_scale.clone();
        Record {
            probe: measurement.probe.clone(),
            target: measurement.target.name().to_string(),
            adapter: measurement.device.as_ref().map(|device| device.adapter.clone()),
            text_mark: measurement.device.as_ref().map(|device| device.text.clone()),
            inputs: measurement.inputs,
            budget: rounded_up(measurement.budget),
            budget_label: measurement.target.budget_label(),
            worst: rounded_up(ulps),
            worst_label: Label::Measured,
            worst_output: output,
            worst_inputs: inputs,
            worst_of_result: rounded_up(measurement.of_result.ulps),
            unbounded: measurement.unbounded,
        }
    }
}

impl Record {
    /// Whether a device's figure is one of the text that is printed now; figures that no device made always are.
    #[must_use]
    pub fn is_of_this_text(&self) -> bool {
        let probe = || probes().iter().find(|probe: &&Probe| probe.key() == self.probe);
        self.text_mark.is_none() || probe().and_then(text_mark) == self.text_mark
    }
}

/// Three significant digits, never below the value.
pub(crate) fn rounded_up(value: f64) -> f64 {
    if value == 0.0 || !value.is_finite() {
        return value;
    }
    let unit = 10_f64.powi(value.log10().floor() as i32 - 2);
    let text = format!("{:.2e}", (value / unit).ceil() * unit);
    text.parse().unwrap_or(value) // a printed number always reads back
}

/// What does not fit the record.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Regression {
    /// Some results are outside of what the operations allow.
    #[error(
        "{probe} on {target}: {count} results are outside of their budget, first {output} = {found:e} instead of {expected:e} (allowed: {allowed:e}) at {inputs:?}"
    )]
    OutsideOfBudget {
        /// The probe.
        probe: String,
        /// The target.
        target: &'static str,
        /// How many.
        count: usize,
        /// The first one's output.
        output: String,
        /// What was found there.
        found: f64,
        /// What should have been.
        expected: f64,
        /// The error allowed.
        allowed: f64,
        /// At which inputs.
        inputs: Vec<f64>,
    },
    /// A larger error than recorded.
    #[error("{probe} on {target}: {found} ulps in {output}, recorded {recorded}; worst inputs {inputs:?}")]
    WorseThanRecorded {
        /// The probe.
        probe: String,
        /// The target.
        target: &'static str,
        /// Ulps of the natural scale now.
        found: f64,
        /// And then.
        recorded: f64,
        /// In which output.
        output: String,
        /// At which inputs.
        inputs: Vec<f64>,
    },
    /// More, or larger, roundings than recorded.
    #[error("{probe} on {target}: the operations allow {found:.3} ulps, recorded {recorded}")]
    LargerBudget {
        /// The probe.
        probe: String,
        /// The target.
        target: &'static str,
        /// Ulps of the natural scale now.
        found: f64,
        /// And then.
        recorded: f64,
    },
    /// There is no record.
    #[error("{probe} on {target} has no record; write one with `etalon audit --record`")]
    NotRecorded {
        /// The probe.
        probe: String,
        /// The target.
        target: &'static str,
    },
    /// There is a record of something that is not there any more.
    #[error("the record has {probe} on {target}, which does not exist; write it anew with `etalon audit --record`")]
    NoSuchProbe {
        /// The probe.
        probe: String,
        /// The target.
        target: String,
    },
}

/// All records.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Budgets {
    /// In the order of the probes and targets.
    #[serde(rename = "record", default)]
    pub records: Vec<Record>,
}

impl Budgets {
    /// Of measurements.
    #[must_use]
    pub fn of(measurements: &[Measurement]) -> Self {
        Budgets { records: measurements.iter().map(Record::of).collect() }
    }
    /// The text of the record, as it is checked in.
    ///
    /// # Errors
    /// None that is known; what the serialiser says is passed on.
    pub fn to_toml(&self) -> Result<String, toml::ser::Error> {
        let head = "\
# How far each equation is from the truth on each target; `docs/audit.md` explains the figures.
# Generated; do not edit. Command: etalon audit --record
# `budget` and `worst` are in ulps of the natural scale, `worst_of_result` in ulps of the result.
";
        Ok(format!("{head}\n{}", toml::to_string(self)?))
    }
    /// The record of a probe on a target; of several devices the first.
    #[must_use]
    pub fn get(&self, probe: &str, target: Target) -> Option<&Record> {
        self.records.iter().find(|record| record.probe == probe && record.target == target.name())
    }
    /// The record that a measurement is to be held against: of the same device, where one ran it.
    pub(crate) fn counterpart(&self, measurement: &Measurement) -> Option<&Record> {
        let adapter = measurement.device.as_ref().map(|device| device.adapter.as_str());
        let is_it = |record: &&Record| {
            record.probe == measurement.probe
                && record.target == measurement.target.name()
                && record.adapter.as_deref() == adapter
        };
        self.records.iter().find(is_it)
    }
    /// These records, and those of devices that were not there this time, as far as they are still of the text that is printed now.
    #[must_use]
    pub fn with_absent_devices(mut self, old: &Budgets) -> Self {
        let is_known = |record: &&Record| {
            self.records
                .iter()
                .any(|new| new.probe == record.probe && new.target == record.target && new.adapter == record.adapter)
        };
        let kept: Vec<Record> = old
            .records
            .iter()
            .filter(|record| record.adapter.is_some() && !is_known(record) && record.is_of_this_text())
            .cloned()
            .collect();
        for record in kept {
            // Behind the others of its probe; what has no other is not measured any more.
            if let Some(last) = self.records.iter().rposition(|other| other.probe == record.probe) {
                self.records.insert(last + 1, record);
            }
        }
        self
    }
    /// What of a measurement does not fit the record; nothing if all is well.
    #[must_use]
    pub fn compare(&self, measurement: &Measurement) -> Vec<Regression> {
        let (probe, target) = (measurement.probe.clone(), measurement.target.name());
        let mut regressions = Vec::new();
        if let Some(first) = measurement.violations.first().cloned() {
            regressions.push(Regression::OutsideOfBudget {
                probe: probe.clone(),
                target,
                count: measurement.violation_count,
                output: first.output,
                found: first.found,
                expected: first.expected,
                allowed: first.allowed,
                inputs: first.inputs,
            });
        }
        let Some(record) = self.counterpart(measurement) else {
            // A device that is new has nothing to be held against but its budget.
            if measurement.device.is_none() {
                regressions.push(Regression::NotRecorded { probe, target });
            }
            return regressions;
        };
        let Worst { ulps, output, inputs } = measurement.of_scale.clone();
        if ulps > record.worst * ROUNDING_OF_RECORD {
            let (probe, recorded) = (probe.clone(), record.worst);
            regressions.push(Regression::WorseThanRecorded { probe, target, found: ulps, recorded, output, inputs });
        }
        if measurement.budget > record.budget * ROUNDING_OF_RECORD {
            let (found, recorded) = (measurement.budget, record.budget);
            regressions.push(Regression::LargerBudget { probe, target, found, recorded });
        }
        regressions
    }
    /// Records of probes or targets that do not exist.
    #[must_use]
    pub fn left_over(&self) -> Vec<Regression> {
        let keys: Vec<String> = probes().iter().map(|probe| probe.key()).collect();
        let exists = |record: &&Record| keys.contains(&record.probe) && record.target.parse::<Target>().is_ok();
        let regression =
            |record: &Record| Regression::NoSuchProbe { probe: record.probe.clone(), target: record.target.clone() };
        self.records.iter().filter(|record| !exists(record)).map(regression).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn records_are_rounded_up_to_three_digits() {
        assert_eq!(rounded_up(1.2301), 1.24);
        assert_eq!(rounded_up(123.0), 123.0);
        assert_eq!(rounded_up(0.0), 0.0);
        assert_eq!(rounded_up(99.91), 100.0);
    }
}
