//! Drag over a whole step, however short the stopping time: exact for a pair, and the mean over a step for sums of pairs.
//!
//! While the reconstruction's slopes stand still, a pair's velocity difference along its line decays towards what the slopes explain,
//! `d omega / dt = -rate omega*`, `d omega* / dt = -rate omega*`: exponentials. What one pair loses is shared out so that momentum is kept, and what it
//! loses in kinetic energy is, to the last rounding, given to the gas.
//!
//! **Order.** A sweep that updates pair after pair is a splitting: first order in the step for many pairs; second if a half step through the pairs
//! in one order is followed by a half step in the reverse order (Strang). Every pair being solved exactly, any step is stable without
//! reconstruction. `stiff_drag.rs` of the tests measures both orders against a matrix exponential.

use super::time_step::LONGEST_STEP;
use etalon_kernels_gen::functions::expm1_negative;
use etalon_kernels_gen::{Real, Vector, equation};

/// What a pair's exact drag over a step does to its partners.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairDrag<R, const D: usize> {
    /// Change of the gas particle's velocity.
    pub gas_velocity: Vector<R, D>,
    /// Change of the dust particle's velocity.
    pub dust_velocity: Vector<R, D>,
    /// Change of the gas particle's specific internal energy.
    pub gas_energy: R,
}

/// The part of a velocity difference that decays in a step, `1 - exp(-rate dt)`: from 0 without drag to 1 for instant coupling.
///
/// Accurate for short steps too: no difference from one is formed. For a pair, `rate` is the sum of its two
/// [`drag_weight`](super::drag::drag_weight)s. Source: PL20 (4), (5) for one pair, solved.
#[equation(unnumbered = "the decay of a pair's velocity difference, PL20 (4), (5) solved")]
pub fn decayed_share<R: Real>(rate: R, time_step: R) -> R {
    -expm1_negative(rate * time_step)
}

/// The mean of `exp(-t / t_s)` over a step, `(1 - exp(-y)) / y` with `y = dt / t_s`: one for short steps, `1/y` for long ones.
///
/// With drag coefficients multiplied by it, (4)-(6) make an explicit step that is exact for two fluids in uniform motion, and takes
/// no more than the whole difference however long the step. First order in the step otherwise. Source: PL20 (1), (2), solved for a
/// uniform box.
#[equation(unnumbered = "the mean drag over a step, PL20 (1), (2) solved")]
pub fn mean_drag_share<R: Real>(stopping_rate: R, time_step: R) -> R {
    let y = R::lit(1.0 / LONGEST_STEP).max(stopping_rate * time_step);
    -expm1_negative(y) / y
}

/// The exact drag of one pair over a step, from the share of its velocity difference that decays.
///
/// `omega = v_ai . r_ai / r`, `omega_star` the reconstructed one, `direction` the unit vector from dust to gas, zero for coincident particles.
/// `omega` becomes `omega - decayed omega*`; the gas takes the dust's share of the change and the dust the gas's, so momentum is kept; the
/// heat is what the pair's kinetic energy falls by, `(1/2) mu_ia (omega^2 - omega'^2)` per unit of gas mass.
/// Source: PL20 (4)-(6) for one pair, solved.
#[equation(unnumbered = "the exact drag of a pair, PL20 (4)-(6) solved")]
pub fn pair_drag<R: Real, const D: usize>(
    decayed: R,
    omega: R,
    omega_star: R,
    share_a: R,
    share_i: R,
    direction: Vector<R, D>,
) -> PairDrag<R, D> {
    let lost = decayed * omega_star;
    let gas_part = share_i * lost;
    PairDrag {
        gas_velocity: direction.scale(-gas_part),
        dust_velocity: direction.scale(share_a * lost),
        gas_energy: gas_part * (omega - 0.5 * lost),
    }
}
