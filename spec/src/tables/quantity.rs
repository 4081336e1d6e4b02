//! What a published number measures, in which unit and at which time, and which of two values is the better one.

use std::fmt;

use serde::{Deserialize, Deserializer};

use super::{TableError, domain};
use crate::text::one_line;
use crate::unit::Unit;

/// Which of two values of a quantity is the better one, as a file of tables writes it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Better {
    /// The lower value.
    Lower,
    /// The higher value.
    Higher,
    /// The one closer to the quantity's target.
    CloserTo,
}

/// Which of two values of a quantity is the better one, with the target where there is one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Goal {
    /// The lower value.
    Lower,
    /// The higher value.
    Higher,
    /// The value closer to this one, in the quantity's unit.
    Target(f64),
}

impl Goal {
    /// How bad a value is, in the quantity's unit: the lower, the better.
    ///
    /// The value itself, its negative, or its distance from the target.
    #[must_use]
    pub fn badness(self, value: f64) -> f64 {
        match self {
            Self::Lower => value,
            Self::Higher => -value,
            Self::Target(target) => (value - target).abs(),
        }
    }
}

impl fmt::Display for Goal {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Lower => formatter.write_str("lower is better"),
            Self::Higher => formatter.write_str("higher is better"),
            Self::Target(target) => write!(formatter, "closer to {target} is better"),
        }
    }
}

/// What a column of published numbers measures. `Key` names the column, `Problem` the test it belongs to.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Quantity<Key, Problem> {
    /// The column.
    pub key: Key,
    /// The test it belongs to.
    pub test: Problem,
    /// What is measured, in plain words.
    pub meaning: String,
    /// The unit of the values; the papers work in code units, of which these are the powers.
    #[serde(deserialize_with = "unit")]
    pub unit: Unit,
    /// When it is measured, such as `t = 1.5`.
    pub time: String,
    /// The printed values are to be multiplied by ten to this power.
    pub power_of_ten: i8,
    /// Which value is better.
    pub better: Better,
    /// The value aimed at, in the scale of the printed values; present with [`Better::CloserTo`] only.
    pub target: Option<f64>,
    /// What to beware of when comparing with these values, and where the paper contradicts itself.
    pub caveat: Option<String>,
}

impl<Key: fmt::Debug, Problem> Quantity<Key, Problem> {
    /// Checks the numbers and joins the lines of the texts.
    pub(super) fn checked(&mut self, file: &str) -> Result<(), TableError> {
        self.meaning = one_line(&self.meaning);
        self.caveat = self.caveat.as_deref().map(one_line);
        let power = self.power_of_ten;
        // Ten to the power 22 is the last one that double precision holds exactly; see `scaled`.
        let exact = (-22..=0).contains(&power);
        domain(file, &self.key, "power_of_ten", power.into(), exact, "between -22 and 0")?;
        let aims = self.better == Better::CloserTo;
        let target = self.target.unwrap_or(f64::NAN);
        domain(file, &self.key, "target", target, target.is_finite() == aims, "given just where better = \"closer-to\"")
    }

    /// A printed value times ten to the quantity's power.
    #[must_use]
    pub fn scaled(&self, printed: f64) -> f64 {
        // The inverse of the power is exact, so dividing rounds once where multiplying would round twice.
        printed / 10_f64.powi(-i32::from(self.power_of_ten))
    }

    /// Which of two values is the better one; the target in the quantity's unit.
    #[must_use]
    pub fn goal(&self) -> Goal {
        match (self.better, self.target) {
            (Better::Higher, _) => Goal::Higher,
            (Better::CloserTo, Some(target)) => Goal::Target(self.scaled(target)),
            // Reading has checked that what aims has a target.
            (Better::Lower, _) | (Better::CloserTo, None) => Goal::Lower,
        }
    }
}

/// A unit as the ledger writes it.
fn unit<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Unit, D::Error> {
    String::deserialize(deserializer)?.parse().map_err(serde::de::Error::custom)
}
