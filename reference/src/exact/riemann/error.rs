//! What a Riemann problem is refused for.

use super::State;
use num_traits::Float;
use std::fmt;

/// One of the two states.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SideName {
    /// x < 0.
    Left,
    /// x > 0.
    Right,
}

impl fmt::Display for SideName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            SideName::Left => "left",
            SideName::Right => "right",
        })
    }
}

/// One number of a state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Field {
    /// Mass per volume.
    Density,
    /// Velocity along x.
    Velocity,
    /// Pressure.
    Pressure,
}

impl fmt::Display for Field {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Field::Density => "density",
            Field::Velocity => "velocity",
            Field::Pressure => "pressure",
        })
    }
}

/// Why there is no solution.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum RiemannError {
    /// NaN or infinite.
    #[error("the {field} of the {side} state is {value}: give a finite number")]
    NotFinite {
        /// Which state.
        side: SideName,
        /// Which number.
        field: Field,
        /// What was given.
        value: f64,
    },
    /// Below zero.
    #[error(
        "the {field} of the {side} state is {value}: give a positive number, or 0 for both density and pressure if it is vacuum"
    )]
    Negative {
        /// Which state.
        side: SideName,
        /// Density or pressure.
        field: Field,
        /// What was given.
        value: f64,
    },
    /// Pressure without gas.
    #[error(
        "the density of the {side} state is 0 but its pressure is {pressure}: give a positive density, or a pressure of 0 for vacuum"
    )]
    PressureWithoutDensity {
        /// Which state.
        side: SideName,
        /// The pressure given.
        pressure: f64,
    },
    /// No ideal gas has it.
    #[error("the adiabatic index gamma is {gamma}: give a finite number above 1")]
    Gamma {
        /// What was given.
        gamma: f64,
    },
    /// A speed or pressure of the solution does not fit the number type.
    #[error("the solution of the Riemann problem overflows the number type: rescale the states or use more digits")]
    Overflow,
}

/// Whether a state is a gas or vacuum.
pub(super) fn check<F: Float>(side: SideName, state: &State<F>) -> Result<(), RiemannError> {
    let fields =
        [(Field::Density, state.density), (Field::Velocity, state.velocity), (Field::Pressure, state.pressure)];
    for (field, value) in fields {
        if !value.is_finite() {
            return Err(RiemannError::NotFinite { side, field, value: printable(value) });
        }
        if field != Field::Velocity && value < F::zero() {
            return Err(RiemannError::Negative { side, field, value: printable(value) });
        }
    }
    if state.density.is_zero() && !state.pressure.is_zero() {
        return Err(RiemannError::PressureWithoutDensity { side, pressure: printable(state.pressure) });
    }
    Ok(())
}

/// Whether an adiabatic index is one.
pub(super) fn check_gamma<F: Float>(gamma: F) -> Result<(), RiemannError> {
    if gamma > F::one() && gamma.is_finite() {
        return Ok(());
    }
    Err(RiemannError::Gamma { gamma: printable(gamma) })
}

fn printable<F: Float>(value: F) -> f64 {
    value.to_f64().unwrap_or(f64::NAN)
}
