//! The time-dependent viscosity coefficient after Read & Hayfield 2012: GS25 (9) and (10), C25 (15) and (16).

use crate::schemes::Viscosity;
use etalon_kernels_gen::functions::{exp_negative, larger, ratio_or_zero};
use etalon_kernels_gen::{Real, Vector, equation};

/// The share of the sound speed in the denominator of GS25 (9): slower changes of velocity than this do not trip the switch.
const NOISE_SHARE: f64 = 0.05;

/// The indicator of coming convergence, `D = h^2 |grad(div v)|` (L T^-1).
///
/// Each component is multiplied with `h` twice before the length is taken: velocities are squared then, whatever the unit of length,
/// and `h^2`, which underflows in `f32` for `h < 1e-19`, is never formed. Source: GS25 (9), C25 (15).
#[equation("gs25:9", "c25:15")]
pub fn convergence_indicator<R: Real, const D: usize>(divergence_gradient: Vector<R, D>, h: R) -> R {
    divergence_gradient.scale(h).scale(h).norm()
}

/// The coefficient the local flow asks for, `alpha_max D / (D + h |div v| + 0.05 c)` while `div v < 0`, else zero.
///
/// Between 0 and `alpha_max`, which is the scheme's `alpha`. Zero where nothing moves in cold gas. Source: GS25 (9), C25 (15).
#[equation("gs25:9", "c25:15")]
pub fn local_coefficient<R: Real>(viscosity: &Viscosity, indicator: R, divergence: R, sound_speed: R, h: R) -> R {
    let denominator = indicator + h * divergence.abs() + R::lit(NOISE_SHARE) * sound_speed;
    let asked = R::lit(viscosity.alpha) * ratio_or_zero(indicator, denominator);
    if divergence >= 0.0 { 0.0 } else { asked }
}

/// The coefficient after the rise, which is instantaneous: the larger of what is left and what is asked for.
///
/// Source: GS25 section 2.2, the first of the two options between (9) and (10).
#[equation("gs25:10", "c25:16")]
pub fn raised_coefficient<R: Real>(alpha: R, alpha_local: R) -> R {
    larger(alpha, alpha_local)
}

/// What the coefficient decays to: `alpha_loc`, and no lower than `alpha_min`. Joins the two branches of the printed formula.
///
/// Source: GS25 (10), C25 (16).
#[equation("gs25:10", "c25:16")]
pub fn decay_target<R: Real>(viscosity: &Viscosity, alpha_local: R) -> R {
    R::lit(viscosity.alpha_min).max(alpha_local)
}

/// The rate of decay, `1 / tau = v_sig,max / h` (T^-1).
///
/// As a product: `tau` itself is infinite in cold gas at rest. Source: GS25 (10), C25 (16).
#[equation("gs25:10", "c25:16")]
pub fn decay_rate<R: Real>(largest_signal_velocity: R, inverse_h: R) -> R {
    largest_signal_velocity * inverse_h
}

/// The rate of change of the coefficient as printed, `(alpha_* - alpha) / tau` with `alpha_*` the [`decay_target`] (T^-1).
///
/// Not part of a step, which takes the exact solution, [`decayed_coefficient`]: a step along this line overshoots when it is longer
/// than `tau`. Source: GS25 (10), C25 (16).
#[equation("gs25:10", "c25:16")]
pub fn coefficient_rate<R: Real>(viscosity: &Viscosity, alpha: R, alpha_local: R, decay_rate: R) -> R {
    (decay_target(viscosity, alpha_local) - alpha) * decay_rate
}

/// The coefficient after a time `dt` of decay, `alpha_* + (alpha - alpha_*) exp(-dt / tau)`.
///
/// The solution of (10) with `alpha_*` and `tau` held, for steps of any length. It stays between `alpha_min` and `alpha_max`, to the
/// last bit. Source: GS25 (10), C25 (16), solved.
#[equation("gs25:10", "c25:16")]
pub fn decayed_coefficient<R: Real>(viscosity: &Viscosity, alpha: R, alpha_local: R, decay_rate: R, dt: R) -> R {
    let target = decay_target(viscosity, alpha_local);
    let decayed = (alpha - target).mul_add(exp_negative(dt * decay_rate), target);
    R::lit(viscosity.alpha).min(R::lit(viscosity.alpha_min).max(decayed))
}

/// The pair's coefficient, the mean of the two particles'.
///
/// Source: GS25 (6).
#[equation("gs25:6")]
pub fn pair_coefficient<R: Real>(alpha_a: R, alpha_b: R) -> R {
    0.5 * (alpha_a + alpha_b)
}
