//! The record of what the code's evaluation gains over textbook forms, `audit/gains.toml`.

use crate::budgets::rounded_up;
use crate::probe::Probe;
use crate::textbook::{Errors, Textbook, textbooks};
use etalon_kernels_gen::trace::{Count, Single};
use serde::{Deserialize, Serialize};

/// All gains.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Gains {
    /// In the order of [`textbooks`].
    #[serde(rename = "gain", default)]
    pub gains: Vec<Gain>,
}

/// One equation's evaluation beside a textbook's.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Gain {
    /// The probe's key.
    pub probe: String,
    /// The textbook's form in LaTeX.
    pub formula: String,
    /// Who writes it so.
    pub source: String,
    /// What goes wrong with it, and what the code does instead.
    pub trouble: String,
    /// What the probe's inputs were multiplied by, if they were.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stretched: Option<String>,
    /// Which inputs were compared, if not all.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub restricted: Option<String>,
    /// Operations of the textbook's form in `f32`, with this project's polynomials for its functions.
    pub textbook_operations: u32,
    /// Operations of ours.
    pub operations: u32,
    /// In `f32`.
    pub f32: GainErrors,
    /// In `f64`.
    pub f64: GainErrors,
}

/// Errors in one precision, all measured.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct GainErrors {
    /// How many inputs were compared.
    pub inputs: usize,
    /// The largest error of the textbook's form, in ulps of the natural scale of ours.
    pub textbook: f64,
    /// The largest error of ours.
    pub ours: f64,
    /// For how many inputs the textbook's form gave infinity or NaN.
    pub textbook_not_finite: usize,
    /// For how many ours did.
    pub ours_not_finite: usize,
}

impl GainErrors {
    fn of(errors: &Errors) -> Self {
        GainErrors {
            inputs: errors.inputs,
            textbook: rounded_up(errors.textbook),
            ours: rounded_up(errors.ours),
            textbook_not_finite: errors.textbook_not_finite,
            ours_not_finite: errors.ours_not_finite,
        }
    }
    /// Whether the textbook's form is worse: by its error, or by having no number.
    #[must_use]
    pub fn gains(&self) -> bool {
        self.ours_not_finite == 0 && (self.textbook_not_finite > 0 || self.textbook > 2.0 * self.ours)
    }
}

impl Gain {
    fn of(textbook: &Textbook, samples: usize) -> Self {
        let [single, double] = textbook.measure(samples);
        let ours = |probe: &Probe| probe.draw::<Single>().map(|drawing| Count::of(&drawing.simplified()).flops());
        Gain {
            probe: textbook.probe.to_string(),
            formula: textbook.formula.to_string(),
            source: textbook.source.to_string(),
            trouble: textbook.trouble.to_string(),
            stretched: textbook.stretched.map(ToString::to_string),
            restricted: textbook.restricted.map(ToString::to_string),
            // Nothing is being drawn here, and names are distinct: drawing cannot fail.
            textbook_operations: textbook.operations().map_or(0, |count| count.flops()),
            operations: textbook.of_probe().and_then(|probe| ours(probe).ok()).unwrap_or(0),
            f32: GainErrors::of(&single),
            f64: GainErrors::of(&double),
        }
    }
}

impl Gains {
    /// Measures all textbook forms.
    #[must_use]
    pub fn now(samples: usize) -> Self {
        Gains { gains: textbooks().iter().map(|textbook| Gain::of(textbook, samples)).collect() }
    }
    /// The text of the record, as it is checked in.
    ///
    /// # Errors
    /// None that is known; what the serialiser says is passed on.
    pub fn to_toml(&self) -> Result<String, toml::ser::Error> {
        let head = "\
# What the code's evaluation gains over textbook forms; `docs/audit.md` explains the figures.
# Generated; do not edit. Command: etalon audit --record
# Errors are in ulps of the natural scale of the code's own form.
";
        Ok(format!("{head}\n{}", toml::to_string(self)?))
    }
}
