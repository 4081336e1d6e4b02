//! The equations of motion: C25 (22) and (23), without and with dissipation.

use etalon_kernels_gen::functions::exp_negative;
use etalon_kernels_gen::polynomials::ARTANH;
use etalon_kernels_gen::{Constant, Real, Vector, equation, functions};

/// Where the ramp between the two forms of the pressure force begins and ends, in Atwood number (C25 section 2; SPH-EXA).
pub const ATWOOD_RAMP: (f64, f64) = (0.1, 0.2);

const THIRD: Constant = Constant::ratio(1.0, 3.0);

/// What a particle brings to the pressure force, `Y_a = P_a / (Omega_a k_a (rho^0_a)^2)`.
///
/// The factor of C25 (22) in front of the integral gradient at `sigma = 0`, where `X/m = 1/rho^0`. Zero without a positive denominator.
/// Divided by the density twice: its square would leave `f32` beyond 2^64 either way. Source: C25 (22).
#[equation("c25:22")]
pub fn pressure_coefficient<R: Real>(pressure: R, grad_h: R, normalisation: R, standard_density: R) -> R {
    let specific = functions::ratio_or_zero(pressure, standard_density);
    let denominator = grad_h * normalisation * standard_density;
    functions::ratio_or_zero(specific, denominator)
}

/// How much of the crossed form a pair takes: `(rho^0_a / rho^0_b)^sigma` with the Atwood ramp
/// `sigma = min(1, max(0, (At - 0.1) / (0.2 - 0.1)))`, `At = |rho_a - rho_b| / (rho_a + rho_b)`.
///
/// Multiplies the particle's own coefficient and divides the neighbour's, so that (22) has `X_a^(2-sigma) X_b^sigma / (m_a^(2-sigma) m_b^sigma)`:
/// one in smooth flow, the geometric-mean density across a contact. The mass exponents are those that keep the force's limit
/// for unequal masses. Inside the ramp the power is `exp(2 sigma artanh z)`, `z = (rho^0_a - rho^0_b)/(rho^0_a + rho^0_b)`, for ratios of up to
/// three; a ramp's density ratio ends at 1.5. What masses far apart make of a ratio beyond three grows linearly with `sigma`, so that the
/// weight has no step at either end of the ramp. Source: C25 (22); what is beyond three is ours.
#[equation("c25:22")]
pub fn crossed_weight<R: Real>(density_a: R, density_b: R, standard_a: R, standard_b: R) -> R {
    let difference = (density_a - density_b).abs();
    let sum = density_a + density_b;
    // Not asked whether it is larger: a density that is not a number is to come out as such, not as smooth flow.
    if rare(!(difference <= R::lit(ATWOOD_RAMP.0) * sum)) {
        let atwood = functions::ratio_or_zero(difference, sum);
        let sigma = 0.0.max((atwood - R::lit(ATWOOD_RAMP.0)) * R::lit(1.0 / (ATWOOD_RAMP.1 - ATWOOD_RAMP.0)));
        let relative = functions::ratio_or_zero(standard_a - standard_b, standard_a + standard_b);
        let z = 0.5.min(R::lit(-0.5).max(relative));
        let logarithm = 2.0 * z * functions::horner(&ARTANH, 4.0 * z * z);
        let decay = exp_negative(sigma * logarithm.abs());
        let ratio = functions::ratio_or_zero(standard_a, standard_b);
        let contrast = ratio.max(functions::ratio_or_zero(standard_b, standard_a));
        let excess = 1.0.max(contrast * R::constant(THIRD));
        let beyond = 1.0 + sigma * (excess - 1.0);
        let ramp = if z < 0.0 { decay / beyond } else { beyond / decay };
        if sigma >= 1.0 { ratio } else { ramp }
    } else {
        1.0
    }
}

/// One neighbour's part of the pressure acceleration, `-m_b [ Y_a g A_ab(h_a) + Y_b / g A_ab(h_b) ]`.
///
/// `g` is [`crossed_weight`], `Y` [`pressure_coefficient`], `A` the integral gradients; both point to the neighbour, so pressure repels.
/// Source: C25 (22).
#[equation("c25:22")]
pub fn pressure_acceleration<R: Real, const D: usize>(
    mass_b: R,
    coefficient_a: R,
    coefficient_b: R,
    crossed: R,
    a_ab_a: Vector<R, D>,
    a_ab_b: Vector<R, D>,
) -> Vector<R, D> {
    let own = mass_b * coefficient_a * crossed;
    let other = mass_b * coefficient_b / crossed;
    -(a_ab_a.scale(own) + a_ab_b.scale(other))
}

/// One neighbour's part of the work of pressure, `m_b Y_a g v_ab . A_ab(h_a)`.
///
/// Source: C25 (23).
#[equation("c25:23")]
pub fn pressure_work<R: Real, const D: usize>(
    mass_b: R,
    coefficient_a: R,
    crossed: R,
    v_ab: Vector<R, D>,
    a_ab_a: Vector<R, D>,
) -> R {
    mass_b * coefficient_a * crossed * v_ab.dot(a_ab_a)
}

/// One neighbour's part of the viscous acceleration, `-m_b Pi_ab A`, with `A = (A_ab(h_a) + A_ab(h_b)) / 2`.
///
/// Source: C25 (22), dissipative part.
#[equation("c25:22")]
pub fn viscous_acceleration<R: Real, const D: usize>(mass_b: R, viscosity: R, mean_a_ab: Vector<R, D>) -> Vector<R, D> {
    mean_a_ab.scale(-(mass_b * viscosity))
}

/// One neighbour's part of the viscous heating, `(1/2) m_b Pi_ab v_ab . A`, with the true relative velocity.
///
/// Heat is what the viscous force takes from the motion, whatever velocity went into `Pi`: so energy is conserved, and the heating
/// may be negative where the reconstructed and the true velocity disagree in sign. It is not clipped. Source: C25 (23), dissipative part.
#[equation("c25:23")]
pub fn viscous_heating<R: Real, const D: usize>(
    mass_b: R,
    viscosity: R,
    v_ab: Vector<R, D>,
    mean_a_ab: Vector<R, D>,
) -> R {
    0.5 * mass_b * viscosity * v_ab.dot(mean_a_ab)
}
