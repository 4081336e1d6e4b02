//! The ideal gas.

use etalon_kernels_gen::{Real, equation};

/// Pressure of an ideal gas, `P = (gamma - 1) rho u`.
///
/// `gamma_minus_one` is kept as such: the turbulence scene's `gamma = 1.001` would lose four digits in the subtraction.
/// Source: GS25 section 3.
#[equation(unnumbered = "ideal gas, GS25 section 3")]
pub fn pressure<R: Real>(gamma_minus_one: R, density: R, internal_energy: R) -> R {
    gamma_minus_one * density * internal_energy
}

/// Adiabatic sound speed of an ideal gas, `c = sqrt(gamma (gamma - 1) u)`; zero for `u <= 0`.
///
/// Source: `c^2 = gamma P / rho` with the ideal gas of GS25 section 3.
#[equation(unnumbered = "ideal gas, GS25 section 3")]
pub fn sound_speed<R: Real>(gamma_minus_one: R, internal_energy: R) -> R {
    let squared = gamma_minus_one * (1.0 + gamma_minus_one) * 0.0.max(internal_energy);
    squared.sqrt()
}
