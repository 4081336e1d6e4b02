//! The grad-h factor: C25 (24), (29)-(31).
//!
//! `D_ab = dW_ab(h_a)/dh_a` (L^-(nu+1)). Two forms are kept apart: [`density_derivative_exact`] is what differentiating the density
//! estimate gives; [`density_derivative_corrected`] takes the derivative of the partition of unity out of it and is not the
//! derivative of anything, but averages to one with a third of the scatter.

use etalon_kernels_gen::{Real, equation};

/// `Omega_a = 1 + h_a / (nu rho_a) * drho_a/dh_a`; divides the pressure in the equations of motion.
///
/// Source: C25 (24), with `dh/drho = -h/(nu rho)`.
#[equation("c25:24")]
pub fn grad_h_factor<R: Real, const D: usize>(h: R, density: R, density_derivative: R) -> R {
    1.0 + h * density_derivative / (density * R::lit(D as f64))
}

/// One neighbour's part of `drho/dh` for plain volume elements: `V_b (rho_b - rho_a) D_ab`.
///
/// Source: C25 (29), that is (28) with `phi = 1`.
#[equation("c25:29")]
pub fn plain_density_derivative_term<R: Real>(volume_b: R, density_ba: R, d_ab: R) -> R {
    volume_b * density_ba * d_ab
}

/// One neighbour's part of `S_a`, the derivative of the partition of unity: `V_b D_ab`.
///
/// `S_a = sum over b != a`. Source: C25 (30), reconstructed.
#[equation("c25:30")]
pub fn partition_derivative_term<R: Real>(volume_b: R, d_ab: R) -> R {
    volume_b * d_ab
}

/// The derivative of the density estimate (21) with respect to `h_a`, all else fixed.
///
/// `drho/dh = (m/X) sum_b X_b D_ab + (k - X W_aa) sum_b m_b D_ab`, both sums with the self term, for `X = m / rho^0`.
/// `estimator_sum` is the first sum and `mass_sum` the second, over the neighbours alone; `self_d = D_aa` and `self_kernel = W_aa`
/// complete them. Source: derived from C25 (21); it is the form of García-Senz et al. 2022.
#[equation(unnumbered = "d(rho)/dh of C25 (21), exact")]
pub fn density_derivative_exact<R: Real>(
    mass: R,
    estimator: R,
    normalisation: R,
    estimator_sum: R,
    mass_sum: R,
    self_kernel: R,
    self_d: R,
) -> R {
    let first = mass / estimator * (estimator * self_d + estimator_sum);
    let second = (normalisation - estimator * self_kernel) * (mass * self_d + mass_sum);
    first + second
}

/// The corrected derivative of the density in Omega.
///
/// `{ (m/X) sum X_b D - rho S } + (k - X W_aa) { sum m_b D - (rho/k) S }`, all sums over the neighbours alone (the self terms cancel), with
/// `S` of (30) and `rho / k = rho^0`. Tied to `X = m / rho^0`. Source: C25 (31).
#[equation("c25:31")]
#[allow(clippy::too_many_arguments)]
pub fn density_derivative_corrected<R: Real>(
    mass: R,
    estimator: R,
    normalisation: R,
    density: R,
    estimator_sum: R,
    mass_sum: R,
    partition_sum: R,
    self_kernel: R,
) -> R {
    let first = mass / estimator * estimator_sum - density * partition_sum;
    let second = mass_sum - density / normalisation * partition_sum;
    first + (normalisation - estimator * self_kernel) * second
}
