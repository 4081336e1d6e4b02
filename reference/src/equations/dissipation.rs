//! Artificial viscosity: GS25 (1)-(8), (27)-(29); C25 (6), (7), (18).

use crate::schemes::{Dissipation, Viscosity};
use etalon_kernels_gen::functions::ratio_or_zero;
use etalon_kernels_gen::{Real, Vector, equation};

/// The factor of the approach velocity in the signal velocity; the paper calls it gamma, it is not the adiabatic index (GS25 3).
const SIGNAL_FACTOR: f64 = 3.0;

/// The regularisation of GS25 (5), `eta^2`, in units of the mean smoothing length squared. The paper gives none; a tenth of the length is
/// customary (Monaghan 1992).
const REGULARISATION: f64 = 0.01;

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
    let approach = 0.0.min(omega_ab);
    -(alpha * v_sig * approach) / (mean_density + mean_density)
}

/// The regularised velocity of approach, `mu = h_mean v_ab . r_ab / (r^2 + eta^2)` with `eta = h_mean / 10`.
///
/// Takes the place of `omega` in the classical form. It has its sign, is larger nearer than one smoothing length and smaller beyond, and
/// zero for coincident particles. Source: GS25 (5).
#[equation("gs25:5")]
pub fn regularised_approach<R: Real>(v_dot_r: R, r_squared: R, mean_h: R) -> R {
    let eta_squared = R::lit(REGULARISATION) * mean_h * mean_h;
    ratio_or_zero(mean_h * v_dot_r, r_squared + eta_squared)
}

/// The viscosity of a pair, `Pi = (-alpha c omega + beta omega^2) / rho` with pair means of `c` and `rho`, while `omega < 0`, else zero.
///
/// `omega` is the reconstructed velocity of approach where the scheme reconstructs, in the formula and in the cut-off; with
/// [`regularised_approach`] in its place it is the classical form. Unit: L^(2+nu) M^-1 T^-2. Source: GS25 (6); (4) for `mu`.
#[equation("gs25:4", "gs25:6")]
pub fn pair_viscosity<R: Real>(alpha: R, beta: R, mean_sound_speed: R, omega_ab: R, mean_density: R) -> R {
    let approach = 0.0.min(omega_ab);
    approach * (beta * approach - alpha * mean_sound_speed) / mean_density
}

/// The mean of the two particles' Balsara factors.
///
/// Source: GS25 (7) and the footnote to (18).
#[equation("gs25:7")]
pub fn pair_balsara<R: Real>(balsara_a: R, balsara_b: R) -> R {
    0.5 * (balsara_a + balsara_b)
}

/// The viscosity as Balsara limits it, `B_ab Pi_ab`.
///
/// None of the paper's seven schemes takes it; the classical one before them does. Source: GS25 (7).
#[equation("gs25:7")]
pub fn limited_viscosity<R: Real>(balsara_ab: R, viscosity: R) -> R {
    balsara_ab * viscosity
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

/// Balsara's limiter in a driven wave, `B* = |div v| / (|div v| + |curl v| + 1e-4 c/h + 2 pi/T)`: small where `div v` oscillates with the driver.
///
/// `angular_frequency` is `2 pi / T`, with `T` the driver's known period (T^-1). For `T` towards infinity it is (8), towards zero it is zero.
/// Source: GS25 (28).
#[equation("gs25:28")]
pub fn wave_aware_limiter<R: Real>(divergence: R, curl: R, sound_speed: R, inverse_h: R, angular_frequency: R) -> R {
    balsara_limiter(divergence, curl + angular_frequency, sound_speed, inverse_h)
}

/// The linear coefficient of a pair: `alpha`, or `alpha max(F, B_ab)` in AVSLRB2F and AVSLRB*2F.
///
/// The quadratic term is left alone. We read the paper's `mu` as `omega`, so that `F = 1` gives back the schemes of Table 1; as printed it is
/// the scheme with [`ApproachForm::Regularised`](crate::schemes::ApproachForm).
/// Source: GS25 (27).
#[equation("gs25:27")]
pub fn linear_coefficient<R: Real>(viscosity: &Viscosity, balsara_ab: R) -> R {
    let alpha = R::lit(viscosity.alpha);
    match viscosity.dissipation {
        Dissipation::AvSlrB2F | Dissipation::AvSlrBStar2F => alpha * R::lit(viscosity.floor).max(balsara_ab),
        _ => alpha,
    }
}

/// One for a pair whose raw and reconstructed velocities of approach have opposite signs, else zero.
///
/// By their signs, not by their product, which may underflow. Where it is one, the viscous heating is negative. Source: GS25 (29), one term of the count.
#[equation("gs25:29")]
pub fn sign_is_reversed<R: Real>(omega_ab: R, omega_prime: R) -> R {
    if omega_ab < 0.0 && omega_prime > 0.0 || omega_ab > 0.0 && omega_prime < 0.0 { 1.0 } else { 0.0 }
}
