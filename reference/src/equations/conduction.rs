//! Artificial conduction of heat in the form of Price et al. 2018, which GS25 section 3.6 names. Off unless a scene asks for it.

use etalon_kernels_gen::functions::ratio_or_zero;
use etalon_kernels_gen::{Real, Vector, equation};

/// The speed at which energies are evened out, `sqrt(|P_a - P_b| / rho_mean)` (L T^-1): zero where pressures agree.
///
/// Hence no heat flows across a contact in pressure balance. Source: Price et al. 2018, for gas without gravity.
#[equation(unnumbered = "artificial conduction, GS25 section 3.6")]
pub fn conduction_velocity<R: Real>(pressure_a: R, pressure_b: R, mean_density: R) -> R {
    let difference = (pressure_a - pressure_b).abs();
    ratio_or_zero(difference, mean_density).sqrt()
}

/// What a particle brings to the conduction of a pair, `1 / (Omega rho)`; zero without a positive denominator.
///
/// Source: Price et al. 2018.
#[equation(unnumbered = "artificial conduction, GS25 section 3.6")]
pub fn conduction_weight<R: Real>(grad_h: R, density: R) -> R {
    ratio_or_zero(1.0, grad_h * density)
}

/// One neighbour's part of the conduction, `(1/2) m_b alpha_u v_u (u_a - u_b) r_ab/r . [A_ab(h_a)/(Omega_a rho_a) + A_ab(h_b)/(Omega_b rho_b)]`.
///
/// `A` points to the neighbour, so the hotter of the two loses; `r_ab . A` is the same for both, so energy is conserved pair by pair.
/// `weighted_a_ab` is the bracket, `inverse_r` is `1/r` or zero for coincident particles. Unit: L^2 T^-3.
/// Source: Price et al. 2018, with the integral gradient for the kernel's.
#[equation(unnumbered = "artificial conduction, GS25 section 3.6")]
pub fn conduction_rate<R: Real, const D: usize>(
    mass_b: R,
    coefficient: R,
    velocity: R,
    energy_ab: R,
    x_ab: Vector<R, D>,
    inverse_r: R,
    weighted_a_ab: Vector<R, D>,
) -> R {
    let slope = x_ab.dot(weighted_a_ab) * inverse_r;
    0.5 * mass_b * coefficient * velocity * energy_ab * slope
}
