//! Volume elements: C25 (19)-(21).

use etalon_kernels_gen::{Real, equation};

/// The estimator of the generalised volume element, `X_a = m_a / rho^0_a` (L^nu).
///
/// `rho^0_a = sum_b m_b W_ab(h_a)`, the particle itself included, is the plain density estimate. Source: C25 (20).
#[equation("c25:20")]
pub fn volume_estimator<R: Real>(mass: R, standard_density: R) -> R {
    mass / standard_density
}

/// The volume element `V_a = X_a / k_a` (L^nu).
///
/// `k_a = sum_b X_b W_ab(h_a)`, the particle itself included; `k = 1` would be a perfect partition of unity. Source: C25 (19).
#[equation("c25:19")]
pub fn volume_element<R: Real>(estimator: R, normalisation: R) -> R {
    estimator / normalisation
}

/// The density `rho_a = m_a / V_a`.
///
/// Source: C25 (21).
#[equation("c25:21")]
pub fn density<R: Real>(mass: R, volume: R) -> R {
    mass / volume
}
