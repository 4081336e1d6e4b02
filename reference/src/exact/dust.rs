//! Two fluids coupled by drag: what the exact solutions with dust have in common.

use num_traits::Float;

/// Why there is no solution.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum DustError {
    /// NaN or infinite.
    #[error("the {field} is {value}: give a finite number")]
    NotFinite {
        /// Which number.
        field: &'static str,
        /// What was given.
        value: f64,
    },
    /// Zero or negative.
    #[error("the {field} is {value}: give a number above 0")]
    NotPositive {
        /// Which number.
        field: &'static str,
        /// What was given.
        value: f64,
    },
    /// Below zero.
    #[error("the {field} is {value}: give 0 or a positive number")]
    Negative {
        /// Which number.
        field: &'static str,
        /// What was given.
        value: f64,
    },
    /// A rate or a share does not fit the number type.
    #[error("the drag rates K/rho or the densities leave the number type: rescale the units or use more digits")]
    Overflow,
}

pub(super) fn finite<F: Float>(field: &'static str, value: F) -> Result<(), DustError> {
    if value.is_finite() { Ok(()) } else { Err(DustError::NotFinite { field, value: printable(value) }) }
}

pub(super) fn positive<F: Float>(field: &'static str, value: F) -> Result<(), DustError> {
    finite(field, value)?;
    if value > F::zero() { Ok(()) } else { Err(DustError::NotPositive { field, value: printable(value) }) }
}

pub(super) fn not_negative<F: Float>(field: &'static str, value: F) -> Result<(), DustError> {
    finite(field, value)?;
    if value >= F::zero() { Ok(()) } else { Err(DustError::Negative { field, value: printable(value) }) }
}

/// Gas and dust of uniform density with a constant drag coefficient, checked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mixture<F> {
    gas_density: F,
    dust_density: F,
    drag_coefficient: F,
}

impl<F: Float> Mixture<F> {
    /// A mixture of densities `rho_g`, `rho_d` (M L^-nu) and drag coefficient `K` (M L^-nu T^-1).
    ///
    /// # Errors
    /// A number that is not finite, a density that is not positive, a negative drag coefficient, or a `K/rho` beyond the number type.
    pub fn new(gas_density: F, dust_density: F, drag_coefficient: F) -> Result<Self, DustError> {
        positive("gas density", gas_density)?;
        positive("dust density", dust_density)?;
        not_negative("drag coefficient", drag_coefficient)?;
        let mixture = Mixture { gas_density, dust_density, drag_coefficient };
        let all = [mixture.stopping_rate(), mixture.density(), gas_density / dust_density, dust_density / gas_density];
        if all.iter().all(|x| x.is_finite()) { Ok(mixture) } else { Err(DustError::Overflow) }
    }

    /// `rho_g`.
    pub fn gas_density(&self) -> F {
        self.gas_density
    }
    /// `rho_d`.
    pub fn dust_density(&self) -> F {
        self.dust_density
    }
    /// `rho_g + rho_d`.
    pub fn density(&self) -> F {
        self.gas_density + self.dust_density
    }
    /// The rate at which drag acts on the gas, `K / rho_g` (PL20 1).
    pub fn gas_rate(&self) -> F {
        self.drag_coefficient / self.gas_density
    }
    /// The rate at which drag acts on the dust, `K / rho_d` (PL20 2).
    pub fn dust_rate(&self) -> F {
        self.drag_coefficient / self.dust_density
    }
    /// `1 / t_s = K / rho_g + K / rho_d` (PL20 7); zero without drag.
    pub fn stopping_rate(&self) -> F {
        self.gas_rate() + self.dust_rate()
    }
    /// The gas's share of the mass, `rho_g / (rho_g + rho_d)`.
    pub fn gas_share(&self) -> F {
        self.gas_density / self.density()
    }
    /// The dust's share of the mass, `rho_d / (rho_g + rho_d)`.
    pub fn dust_share(&self) -> F {
        self.dust_density / self.density()
    }
}

fn printable<F: Float>(value: F) -> f64 {
    value.to_f64().unwrap_or(f64::NAN)
}
