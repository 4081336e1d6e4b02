//! What an equation does with values that no gas has.

use std::fmt;

use serde::Deserialize;

/// What an encoded equation does with arguments outside of what is legal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum BadInput {
    /// Nothing is caught. Wherever an argument matters, a result is NaN if it is; infinities and wrong signs go through the arithmetic.
    Propagates,
    /// Some values of some arguments are caught, and give a number; all others propagate.
    Guards,
    /// Some values are answered with a typed error instead of a result; all others propagate.
    Refuses,
}

impl fmt::Display for BadInput {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(match self {
            Self::Propagates => "propagates",
            Self::Guards => "guards",
            Self::Refuses => "refuses",
        })
    }
}

/// A class of bad values.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum BadValue {
    /// Not a number.
    Nan,
    /// Infinite, of either sign.
    Infinite,
    /// Zero, where the argument must not be; of a sum over neighbours, that there are none.
    Zero,
    /// Below zero, where the argument must not be.
    Negative,
    /// A list without entries.
    Empty,
}

impl fmt::Display for BadValue {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(match self {
            Self::Nan => "NaN",
            Self::Infinite => "infinite",
            Self::Zero => "zero",
            Self::Negative => "negative",
            Self::Empty => "empty",
        })
    }
}

/// Values that do not propagate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Caught {
    /// The argument, in LaTeX, as the formula or the encoding function's declaration writes it.
    pub of: String,
    /// Which values of it.
    pub values: Vec<BadValue>,
    /// What comes out instead, and why, in plain words. May hold LaTeX between dollar signs.
    pub gives: String,
}

impl fmt::Display for Caught {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let values: Vec<String> = self.values.iter().map(ToString::to_string).collect();
        write!(formatter, "${}$ {}: {}", self.of, values.join(" or "), self.gives)
    }
}
