//! Why there is no result.

use crate::engine::EngineError;

/// Input that a measurement or the driving cannot use.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum TurbulenceError {
    /// Nothing to measure.
    #[error("there are no {what}: give at least {least}")]
    Empty {
        /// What is missing.
        what: &'static str,
        /// How many would do.
        least: usize,
    },
    /// Columns of different length.
    #[error("the {column} has {found} entries where {expected} are due: give one for each")]
    Length {
        /// Which column.
        column: &'static str,
        /// How many entries it has.
        found: usize,
        /// How many it should have.
        expected: usize,
    },
    /// NaN, infinite, or not positive where it must be.
    #[error("entry {index} of the {column} is {value}; {rule}")]
    Value {
        /// Which column.
        column: &'static str,
        /// Which entry, from 0.
        index: usize,
        /// What stands there.
        value: f64,
        /// What is allowed.
        rule: &'static str,
    },
    /// A number that was chosen.
    #[error("the {name} is {value}; {rule}")]
    Parameter {
        /// Which one.
        name: &'static str,
        /// What was given.
        value: f64,
        /// What is allowed.
        rule: &'static str,
    },
    /// A box without wave vectors on one scale.
    #[error("the box has the sides {sides:?}, periodic {periodic:?}; waves need a periodic box with equal sides")]
    NotAPeriodicCube {
        /// Its sides.
        sides: Vec<f64>,
        /// Which of them are periodic.
        periodic: Vec<bool>,
    },
    /// A grid too coarse to have a spectrum.
    #[error("the grid has {across} points a side, and a spectrum needs at least {least}: refine it")]
    GridTooSmall {
        /// Points a side.
        across: usize,
        /// How many would do.
        least: usize,
    },
    /// Grid points without a velocity.
    #[error(
        "{points} of the grid's points lie in no particle's support: use nearest-particle interpolation or larger smoothing lengths"
    )]
    OutOfReach {
        /// How many.
        points: usize,
    },
    /// Bins with nothing in them.
    #[error("none of the {entries} {what} falls into the bins from {from} to {to}: widen them")]
    NothingInRange {
        /// How many there were.
        entries: usize,
        /// Of what.
        what: &'static str,
        /// Lower end.
        from: f64,
        /// Upper end.
        to: f64,
    },
    /// A slope of a single place.
    #[error("all points of the slope are at {place}: give at least two different places")]
    OnePlace {
        /// Where they all are.
        place: f64,
    },
    /// An engine that could not hand out its particles.
    #[error(transparent)]
    Engine(#[from] EngineError),
}

/// Checks that every entry is finite, and positive if it must be.
pub(crate) fn check_column(column: &'static str, values: &[f64], positive: bool) -> Result<(), TurbulenceError> {
    let wrong = |value: f64| !value.is_finite() || (positive && value <= 0.0);
    match values.iter().position(|&value| wrong(value)) {
        Some(index) => {
            let rule = if positive { "it must be finite and positive" } else { "it must be finite" };
            Err(TurbulenceError::Value { column, index, value: values[index], rule })
        }
        None => Ok(()),
    }
}

/// Checks that a column has an entry for each particle.
pub(crate) fn check_length(column: &'static str, found: usize, expected: usize) -> Result<(), TurbulenceError> {
    if found == expected { Ok(()) } else { Err(TurbulenceError::Length { column, found, expected }) }
}
