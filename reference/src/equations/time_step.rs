//! How long a step may be.
//!
//! Each asks when there is *no* limit, so that a quantity that is not a number makes a step that is not one, and the run stops.

use etalon_kernels_gen::functions::ratio_or_zero;
use etalon_kernels_gen::{Real, equation};

/// No step is longer than this; it stands for "no limit" and is finite on every target.
pub const LONGEST_STEP: f64 = 1e30;

/// The Courant number on `h / v_sig`; on `h / c` it is half as large, for `v_sig` of two particles at rest is twice the sound speed.
///
/// Ours (SPH-EXA: 0.2 on `h/c`).
pub const COURANT: f64 = 0.4;

/// The step a signal allows, `0.4 h / v_sig`, with the largest signal velocity among the neighbours.
///
/// Source: the criterion of Courant, Friedrichs & Lewy; the factor is [`COURANT`].
#[equation(unnumbered = "Courant's criterion")]
pub fn courant_step<R: Real>(h: R, signal_velocity: R) -> R {
    let limit = ratio_or_zero(R::lit(COURANT) * h, signal_velocity);
    if signal_velocity <= 0.0 { R::lit(LONGEST_STEP) } else { limit }
}

/// The step an acceleration allows, `0.25 sqrt(h / |a|)`.
///
/// Source: Monaghan 1989.
#[equation(unnumbered = "the force criterion")]
pub fn acceleration_step<R: Real>(h: R, acceleration: R) -> R {
    let limit = ratio_or_zero(h, acceleration);
    if acceleration <= 0.0 { R::lit(LONGEST_STEP) } else { 0.25 * limit.sqrt() }
}

/// The step cooling allows, `0.5 u / |du/dt|` while the energy falls, so that it stays positive.
///
/// Source: ours.
#[equation(unnumbered = "the energy criterion")]
pub fn cooling_step<R: Real>(internal_energy: R, energy_rate: R) -> R {
    let limit = ratio_or_zero(0.5 * internal_energy, -energy_rate);
    if energy_rate >= 0.0 || internal_energy <= 0.0 { R::lit(LONGEST_STEP) } else { limit }
}
