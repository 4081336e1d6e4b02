//! The shock tube of gas and dust in the limit of strong drag: one gas, heavier by the dust it carries.
//!
//! With $\varepsilon = \rho_d/\rho_g$ the mixture has density $\rho_g(1+\varepsilon)$, the gas's pressure and the gas's adiabatic index, so sound travels at
//! $c_s/\sqrt{1+\varepsilon}$. Laibe & Price 2012a. At a finite drag coefficient fronts are some $t_s c_s/\sqrt{1+\varepsilon}$ wide.

use super::dust::{DustError, not_negative};
use super::riemann::State;
use num_traits::Float;

/// The mixture as one gas: the state to give a [`RiemannProblem`](super::riemann::RiemannProblem).
///
/// # Errors
/// A dust-to-gas ratio that is negative or not finite.
pub fn mixture<F: Float>(gas: State<F>, dust_to_gas: F) -> Result<State<F>, DustError> {
    not_negative("dust-to-gas ratio", dust_to_gas)?;
    Ok(State { density: gas.density * (F::one() + dust_to_gas), ..gas })
}

/// The gas's part of a state of the mixture; the dust has `dust_to_gas` times its density, and the same velocity.
///
/// # Errors
/// A dust-to-gas ratio that is negative or not finite.
pub fn gas_of<F: Float>(mixture: State<F>, dust_to_gas: F) -> Result<State<F>, DustError> {
    not_negative("dust-to-gas ratio", dust_to_gas)?;
    Ok(State { density: mixture.density / (F::one() + dust_to_gas), ..mixture })
}
