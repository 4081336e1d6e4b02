//! The box of gas and dust in uniform motion: nothing but drag (PL20 1-3).
//!
//! The common velocity stays, the difference decays as $e^{-t/t_s}$, and what the motion loses heats the gas. Laibe & Price 2011.

use super::dust::{DustError, Mixture, finite};
use num_traits::Float;

/// Gas and dust that start with a velocity each, along one axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DustyBox<F> {
    mixture: Mixture<F>,
    gas_velocity: F,
    dust_velocity: F,
}

impl<F: Float> DustyBox<F> {
    /// A mixture with the velocities it starts with.
    ///
    /// # Errors
    /// A velocity that is not finite.
    pub fn new(mixture: Mixture<F>, gas_velocity: F, dust_velocity: F) -> Result<Self, DustError> {
        finite("gas velocity", gas_velocity)?;
        finite("dust velocity", dust_velocity)?;
        Ok(DustyBox { mixture, gas_velocity, dust_velocity })
    }

    /// The velocity difference at time `t`, gas less dust: $\Delta v = \Delta v_0\, e^{-t/t_s}$.
    pub fn difference(&self, t: F) -> F {
        self.initial_difference() * (-t * self.mixture.stopping_rate()).exp()
    }

    /// The velocities of gas and dust at time `t`: the initial ones less their part of what has decayed.
    pub fn velocities(&self, t: F) -> (F, F) {
        let lost = -self.initial_difference() * (-t * self.mixture.stopping_rate()).exp_m1();
        (self.gas_velocity - self.mixture.dust_share() * lost, self.dust_velocity + self.mixture.gas_share() * lost)
    }

    /// Kinetic energy per volume at time `t`, $\frac12(\rho_g v_g^2 + \rho_d v_d^2)$.
    pub fn kinetic_energy(&self, t: F) -> F {
        let (gas, dust) = self.velocities(t);
        (self.mixture.gas_density() * gas * gas + self.mixture.dust_density() * dust * dust) / two()
    }

    /// Energy per volume that the gas has gained as heat by time `t`, $\frac12\frac{\rho_g\rho_d}{\rho_g+\rho_d}(\Delta v_0^2 - \Delta v^2)$.
    pub fn heat(&self, t: F) -> F {
        let reduced = self.mixture.gas_density() * self.mixture.dust_share();
        let difference = self.initial_difference();
        -reduced * difference * difference * (-two::<F>() * t * self.mixture.stopping_rate()).exp_m1() / two()
    }

    fn initial_difference(&self) -> F {
        self.gas_velocity - self.dust_velocity
    }
}

fn two<F: Float>() -> F {
    F::one() + F::one()
}
