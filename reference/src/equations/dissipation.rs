//! Artificial viscosity: GS25 (1)-(3), (6)-(8), (27); C25 (6), (7), (18).

use crate::schemes::{Dissipation, Viscosity};
use etalon_kernels_gen::functions::ratio_or_zero;
use etalon_kernels_gen::{Real, Vector, equation};

/// The factor of the approach velocity in the signal velocity; the paper calls it gamma, it is not the adiabatic index (GS25 3).
const SIGNAL_FACTOR: f64 = 3.0;

/// The noise floor of Balsara's limiter in units of `c/h` (GS25 8).
const BALSARA_FLOOR: f64 = 1e-4;

/// The velocity of approach, `omega_ab = v_ab . r_ab / |r_ab|`: negative when the particles approach.
///
/// `inverse_r` is `1/|r_ab|`, or zero for coincident particles, which then do not see each other. Source: GS25 (2).
#[equation("gs25:2")]
pub fn approach_velocity<R: Real, const D: usize>(v_ab: Vector<R, D>, x_ab: Vector<R, D>, inverse_r: R) -> R {
    v_ab.dot(x_ab) * inverse_r
}

/// The speed at which a signal passes between two particles, `v_sig = c_a + c_b - 3 omega_ab`.
///
/// Source: GS25 (3), C25 (7).
#[equation("gs25:3", "c25:7")]
pub fn signal_velocity<R: Real>(sound_speed_a: R, sound_speed_b: R, omega_ab: R) -> R {
    sound_speed_a + sound_speed_b - R::lit(SIGNAL_FACTOR) * omega_ab
}

/// The viscosity of a pair in the form of a Riemann problem, `Pi = -alpha v_sig omega / (2 rho_mean)` while approaching, else zero.
///
/// The cut-off is not printed with the formula but needed: without it receding pairs would be pulled apart.
/// It is (6) with `beta = 3 alpha / 2`. Unit: L^(2+nu) M^-1 T^-2. Source: GS25 (1), C25 (6).
#[equation("gs25:1", "c25:6")]
pub fn riemann_viscosity<R: Real>(alpha: R, v_sig: R, omega_ab: R, mean_density: R) -> R {
    let approach = omega_ab.min(0.0);
    -(alpha * v_sig * approach) / (mean_density + mean_density)
}

/// The viscosity of a pair, `Pi = (-alpha c omega + beta omega^2) / rho` with pair means of `c` and `rho`, while `omega < 0`, else zero.
///
/// `omega` is the reconstructed velocity of approach where the scheme reconstructs, in the formula and in the cut-off.
/// Unit: L^(2+nu) M^-1 T^-2. Source: GS25 (6).
#[equation("gs25:6")]
pub fn pair_viscosity<R: Real>(alpha: R, beta: R, mean_sound_speed: R, omega_ab: R, mean_density: R) -> R {
    let approach = omega_ab.min(0.0);
    approach * (beta * approach - alpha * mean_sound_speed) / mean_density
}

/// The mean of the two particles' Balsara factors.
///
/// Source: GS25 (7) and the footnote to (18).
#[equation("gs25:7")]
pub fn pair_balsara<R: Real>(balsara_a: R, balsara_b: R) -> R {
    0.5 * (balsara_a + balsara_b)
}

/// Balsara's limiter, `B = |div v| / (|div v| + |curl v| + 1e-4 c/h)`: one in pure compression or expansion, zero in pure shear.
///
/// Zero where all three vanish (cold gas at rest). Source: GS25 (8), C25 (18).
#[equation("gs25:8", "c25:18")]
pub fn balsara_limiter<R: Real>(divergence: R, curl: R, sound_speed: R, inverse_h: R) -> R {
    let compression = divergence.abs();
    let denominator = compression + curl + R::lit(BALSARA_FLOOR) * sound_speed * inverse_h;
    ratio_or_zero(compression, denominator)
}

/// The linear coefficient of a pair: `alpha`, or `alpha max(F, B_ab)` in AVSLRB2F.
///
/// The quadratic term is left alone. We read the paper's `mu` as `omega`, so that `F = 1` gives back the schemes of Table 1.
/// Source: GS25 (27).
#[equation("gs25:27")]
pub fn linear_coefficient<R: Real>(viscosity: &Viscosity, balsara_ab: R) -> R {
    let alpha = R::lit(viscosity.alpha);
    match viscosity.dissipation {
        Dissipation::AvSlrB2F => alpha * balsara_ab.max(R::lit(viscosity.floor)),
        _ => alpha,
    }
}
