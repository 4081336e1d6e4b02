//! Slope-limited reconstruction of the pair's velocities: GS25 (11)-(19), C25 (8)-(14), (17).
//!
//! `J_a = dv_i/dx_j` at particle a, `x_ab = x_a - x_b`. A pair's slopes are `A = x_ab^T J_a x_ab` and `B = x_ab^T J_b x_ab`: only the symmetric part of
//! `J` enters them.

use crate::schemes::{Dissipation, Viscosity};
use etalon_kernels_gen::functions::{dimension_root, exp_negative, ratio_or_zero};
use etalon_kernels_gen::{Matrix, Real, Vector, equation};
use std::f64::consts::PI;

/// The velocity of a particle carried half-way to its neighbour, `v' = v -+ (1/2) phi J x_ab`: minus for a, plus for b.
///
/// `towards_b` is true for particle a of (11), false for particle b of (12). The passes need only the difference of the two along the
/// line of centres, [`reconstructed_approach_velocity`]. Source: GS25 (11), (12), C25 (8), (9).
#[equation("gs25:11", "gs25:12", "c25:8", "c25:9")]
pub fn reconstructed_velocity<R: Real, const D: usize>(
    velocity: Vector<R, D>,
    phi: R,
    jacobian: Matrix<R, D>,
    x_ab: Vector<R, D>,
    towards_b: bool,
) -> Vector<R, D> {
    let shift = jacobian.apply(x_ab).scale(0.5 * phi);
    if towards_b { velocity - shift } else { velocity + shift }
}

/// The velocity of approach of the reconstructed velocities, `omega' = omega - (phi_ab A + phi_ba B) / (2 r)`.
///
/// `(v'_a - v'_b) . r_ab / r` written out with (11), (12) and the pair's slopes `A`, `B`. For a linear velocity field and `phi = 1` it is zero.
/// Source: GS25 (11), (12), C25 (8), (9), projected on the line of centres.
#[equation("gs25:11", "gs25:12", "c25:8", "c25:9")]
pub fn reconstructed_approach_velocity<R: Real>(
    omega_ab: R,
    phi_ab: R,
    slope_a: R,
    phi_ba: R,
    slope_b: R,
    inverse_r: R,
) -> R {
    let correction = phi_ab * slope_a + phi_ba * slope_b;
    omega_ab - 0.5 * correction * inverse_r
}

/// Van Leer's limiter of the two slopes, `max(0, min(1, 4F / (1 + F)^2))` with `F = A / B`.
///
/// Computed as `4 y (1 - y)` with `y = min(|A|,|B|) / (|A| + |B|)`: the same function, with one division that can neither overflow nor meet
/// 0/0. Slopes of opposite sign, or one of them zero, give 0; so do both zero, where the value does not matter, for it
/// multiplies them. Source: GS25 (13) and (17), C25 (10) and (14).
#[equation("gs25:13", "gs25:17", "c25:10", "c25:14")]
pub fn slope_limiter<R: Real>(slope_a: R, slope_b: R) -> R {
    let size_a = slope_a.abs();
    let size_b = slope_b.abs();
    let share = ratio_or_zero(size_a.min(size_b), size_a + size_b);
    let limiter = 4.0 * share * (1.0 - share);
    if slope_a > 0.0 && slope_b > 0.0 || slope_a < 0.0 && slope_b < 0.0 { limiter } else { 0.0 }
}

/// The cut-off of the reconstruction at short range, `kappa = exp(-((q_ab - q_crit) / q_fold)^2)` for `q_ab < q_crit`, else 1.
///
/// Closer than the mean spacing the reconstruction fades and full viscosity returns. `inverse_q_fold` is `1 / q_fold`. Source: GS25 (14), C25 (11).
#[equation("gs25:14", "c25:11")]
pub fn short_range_factor<R: Real>(q_ab: R, q_crit: R, inverse_q_fold: R) -> R {
    // Not asked whether it is closer: a separation that is not a number is to come out as such.
    if rare(!(q_ab >= q_crit)) {
        let depth = (q_crit - q_ab) * inverse_q_fold;
        exp_negative(depth * depth)
    } else {
        1.0
    }
}

/// The pair's separation in the larger of the two smoothing lengths, `q_ab = min(r/h_a, r/h_b)`.
///
/// Source: GS25 (15), C25 (12).
#[equation("gs25:15", "c25:12")]
pub fn pair_separation<R: Real>(r: R, inverse_h_a: R, inverse_h_b: R) -> R {
    r * inverse_h_a.min(inverse_h_b)
}

/// The mean spacing in smoothing lengths, `q_crit = (omega_nu R^nu / n_b)^(1/nu)`, with `omega_nu` the volume of the unit ball and `R` the support
/// in smoothing lengths; `(32 pi / (3 n_b))^(1/3)` in 3-D with `R = 2`.
///
/// `n_b` counts the particle itself: the ball of radius `R h` holds `n_b` spacings cubed. The other dimensions and supports are ours, by the
/// same argument; `support_volume` is `omega_nu R^nu`, see [`support_volume`]. Source: GS25 (16), C25 (13).
#[equation("gs25:16", "c25:13")]
pub fn critical_separation<R: Real, const D: usize>(neighbours: R, support_volume: R) -> R {
    dimension_root::<R, D>(support_volume / neighbours)
}

/// What the Balsara factor leaves of the reconstruction: `1`, `1 - B_ab` or `1 - B_ab^2`.
///
/// The same for both particles: the paper's footnote 3 replaces `B_a`, `B_b` by their mean. Source: GS25 (18), (19), C25 (17).
#[equation("gs25:18", "gs25:19", "c25:17")]
pub fn reconstruction_share<R: Real>(viscosity: &Viscosity, balsara_ab: R) -> R {
    match viscosity.dissipation {
        Dissipation::Av | Dissipation::AvSw | Dissipation::AvB => R::zero(),
        Dissipation::AvSlr | Dissipation::AvSwSlr => R::one(),
        Dissipation::AvSlrB => 1.0 - balsara_ab,
        Dissipation::AvSlrB2 | Dissipation::AvSlrB2F | Dissipation::AvSlrBStar2 | Dissipation::AvSlrBStar2F => {
            1.0 - balsara_ab * balsara_ab
        }
    }
}

/// The volume of the support in units of `h^nu`: `2 R`, `pi R^2`, `(4 pi / 3) R^3`.
pub fn support_volume(dimension: usize, support: f64) -> f64 {
    [2.0, PI, 4.0 * PI / 3.0][dimension - 1] * support.powi(dimension as i32)
}

/// The smoothing length whose support holds so many neighbours where every particle has this volume, `(n V / (omega_nu R^nu))^(1/nu)`.
///
/// `support` is `R`, in smoothing lengths. Source: GS25 (16) solved for `h`, with `V^(1/nu)` as the mean spacing.
pub fn smoothing_length_holding(neighbours: f64, volume: f64, dimension: usize, support: f64) -> f64 {
    (neighbours * volume / support_volume(dimension, support)).powf(1.0 / dimension as f64)
}
