//! Velocities of a gas and a dust particle at a common point: PL20 (8)-(12) and section 2.5.
//!
//! `r_ai = r_a - r_i`; `J_a = dv/dr` at the gas particle comes from gas particles only, `J_i` at the dust particle from dust only.

use super::gradients::{determinant, gradient, inverse_moments};
use super::limiters::limited_slope;
use crate::schemes::{CommonPoint, DragReconstruction, SlopeLimiter};
use etalon_kernels_gen::functions::ratio_or_zero;
use etalon_kernels_gen::{Matrix, Real, Symmetric, Vector, equation};

/// Neighbourhoods flatter than this have no gradient; at twice as much they have all of it.
///
/// The quality is that of [`inverse_moments`], which leaves neighbourhoods above 1e-3 as they are. Ours.
const QUALITY_FLOOR: f64 = 5e-4;

/// A particle's share in the mass of its pair, `mu_ai = m_a / (m_a + m_i)`.
///
/// The partner's share is the same with the arguments swapped, not one less this, which would lose the digits of a small one.
/// Source: PL20 (10).
#[equation("pl20:10")]
pub fn mass_share<R: Real>(own_mass: R, other_mass: R) -> R {
    own_mass / (own_mass + other_mass)
}

/// Where the common point is: the parts of `r_ai` by which it lies from the gas and from the dust particle.
///
/// `r* = r_a + first r_ai = r_i + second r_ai`. Half-way: (-1/2, 1/2). Barycentre: (-mu_ia, mu_ai). As printed:
/// (mu_ai, -mu_ia), which are two points, both outside of the pair. Source: PL20 section 2.3.
#[equation("pl20:8", "pl20:9")]
pub fn common_point<R: Real>(point: CommonPoint, share_a: R, share_i: R) -> (R, R) {
    match point {
        CommonPoint::Particles => (R::zero(), R::zero()),
        CommonPoint::Midpoint => (R::lit(-0.5), R::lit(0.5)),
        CommonPoint::Barycentre => (-share_i, share_a),
        CommonPoint::AsPrinted => (share_a, -share_i),
    }
}

/// A particle's velocity carried to another point, `v* = v + J (r* - r)`.
///
/// Source: PL20 (8) for gas, (9) for dust.
#[equation("pl20:8", "pl20:9")]
pub fn carried_velocity<R: Real, const D: usize>(
    velocity: Vector<R, D>,
    jacobian: Matrix<R, D>,
    to_point: Vector<R, D>,
) -> Vector<R, D> {
    velocity + jacobian.apply(to_point)
}

/// The slope of a particle's velocity along the pair, `S = r^T J r / r^2` (T^-1): the same seen from either partner.
///
/// Source: PL20 (10).
#[equation("pl20:10")]
pub fn slope_along_pair<R: Real, const D: usize>(jacobian: Matrix<R, D>, direction: Vector<R, D>) -> R {
    jacobian.apply(direction).dot(direction)
}

/// The velocity difference along the pair at the common point, `v*_ai . r = v_ai . r - r (mu_ia S_ai + mu_ai S_ia)`.
///
/// `omega` is `v_ai . r_ai / r`. In the middle both shares are 1/2. A limiter `f` replaces the bracket, since the shares add up to one. As
/// printed the bracket is `mu_ai (S_ai + S_ia)`, or `2 mu_ai f`: right for equal masses only.
/// Exact for two linear flows without limiter. Source: PL20 (10), section 2.4.
#[equation("pl20:10")]
pub fn reconstructed_drag_velocity<R: Real>(
    reconstruction: DragReconstruction,
    omega: R,
    r: R,
    slope_a: R,
    slope_i: R,
    share_a: R,
    share_i: R,
) -> R {
    let limited = limited_slope(reconstruction.limiter, slope_a, slope_i);
    let slope = match (reconstruction.point, reconstruction.limiter) {
        (CommonPoint::Particles, _) => R::zero(),
        (CommonPoint::AsPrinted, _) => 2.0 * share_a * limited,
        (CommonPoint::Barycentre, SlopeLimiter::Unlimited) => share_i * slope_a + share_a * slope_i,
        _ => limited,
    };
    omega - r * slope
}

/// The paper's entropy fix: the raw velocity difference where the reconstructed one would cool the gas.
///
/// In an explicit step (`decayed = 0`) that is where the two have different signs, as the paper says. In the exact step of a pair, which takes
/// the share `decayed` of the difference, it is where the reconstructed one has another sign than the mean of `omega` before and
/// after. Source: PL20 section 2.5.
#[equation(unnumbered = "the entropy fix, PL20 section 2.5")]
pub fn entropy_fixed<R: Real>(omega_star: R, omega: R, decayed: R) -> R {
    let mean = omega - 0.5 * (decayed * omega_star);
    if mean > 0.0 && omega_star < 0.0 || mean < 0.0 && omega_star > 0.0 { omega } else { omega_star }
}

/// One neighbour's part of the sum on the right of (11), `-m_b v_ab (grad W_ab)^T`; row: component, column: axis.
///
/// `slope` is `(dW/dr) / r` at `h_a`, never positive, so `grad_a W_ab = slope r_ab`; a factor common to all neighbours may be left out
/// here and in [`correction_term`]. `v_ba = v_b - v_a`, `r_ba = r_b - r_a`, neighbours of the same kind only. Source: PL20 (11).
#[equation("pl20:11")]
pub fn gradient_sum_term<R: Real, const D: usize>(
    mass: R,
    slope: R,
    v_ba: Vector<R, D>,
    r_ba: Vector<R, D>,
) -> Matrix<R, D> {
    let weighted = v_ba.scale(-(mass * slope));
    Matrix::from_fn(|i, j| weighted[i] * r_ba[j])
}

/// One neighbour's part of the correction matrix, `m_b (r_b - r_a) (grad W_ab)^T`: symmetric and positive for a radial kernel.
///
/// Arguments as for [`gradient_sum_term`]. Source: PL20 (12).
#[equation("pl20:12")]
pub fn correction_term<R: Real, const D: usize>(mass: R, slope: R, r_ba: Vector<R, D>) -> Symmetric<R, D> {
    Symmetric::outer(r_ba, -(mass * slope))
}

/// The velocity gradient that is exact for linear flows: the solution `J` of `J R = sum` (T^-1; row: component, column: axis).
///
/// Zero where the neighbours do not span the space (a lone particle, particles on a line or in a plane): the matrix is judged by
/// `det(nu R / tr R)`, as in [`inverse_moments`]. Between a quality of 5e-4 and 1e-3 the gradient fades in, so that it does not jump.
/// Source: PL20 (11).
#[equation("pl20:11")]
pub fn linear_gradient<R: Real, const D: usize>(sum: Matrix<R, D>, correction: Symmetric<R, D>) -> Matrix<R, D> {
    let scale = ratio_or_zero(R::lit(D as f64), correction.trace());
    let quality = determinant(correction.scale(scale));
    let share = 1.0.min(0.0.max(quality * R::lit(1.0 / QUALITY_FLOOR) - 1.0));
    gradient(sum, inverse_moments(correction)).scale(share)
}
