//! Drag between gas and dust: PL20 (1)-(7).
//!
//! `a` is a gas particle, `i` a dust particle; `K` is the drag coefficient (M L^-nu T^-1). The pair formulas are the same for both
//! partners: `own` is the one that feels the drag, `other` its partner of the other kind.

use super::time_step::LONGEST_STEP;
use crate::schemes::DragSigns;
use etalon_kernels_gen::{Real, Vector, equation};

/// The share of the shortest stopping time that an explicit step may take (PL20 section 3).
const EXPLICIT_SHARE: f64 = 0.9;

/// The rate at which drag acts on one fluid, `K / rho` (T^-1): `K / rho_g` for gas, `K / rho_d` for dust.
///
/// Source: PL20 (1), (2).
#[equation("pl20:1", "pl20:2")]
pub fn drag_rate<R: Real>(drag_coefficient: R, density: R) -> R {
    drag_coefficient / density
}

/// Drag on a fluid, `(K / rho) (v_other - v_own)`, per unit of its mass: `other` is the dust for the gas, the gas for the dust.
///
/// `velocity_difference` is own less other. Source: PL20 (1), (2), the last terms.
#[equation("pl20:1", "pl20:2")]
pub fn continuum_drag<R: Real, const D: usize>(rate: R, velocity_difference: Vector<R, D>) -> Vector<R, D> {
    -velocity_difference.scale(rate)
}

/// Drag heating of the gas, `(K / rho_g) |v_d - v_g|^2`, per unit of its mass: all of it goes to the gas.
///
/// Source: PL20 (3), the last term.
#[equation("pl20:3")]
pub fn continuum_drag_heating<R: Real, const D: usize>(gas_rate: R, velocity_difference: Vector<R, D>) -> R {
    gas_rate * velocity_difference.norm_squared()
}

/// The inverse of the stopping time, `1 / t_s = K (rho_a + rho_i) / (rho_a rho_i) = K / rho_a + K / rho_i`.
///
/// In this form it neither forms a product of densities nor divides by `K`: without drag it is zero. Source: PL20 (7).
#[equation("pl20:7")]
pub fn stopping_rate<R: Real>(drag_coefficient: R, gas_density: R, dust_density: R) -> R {
    drag_rate(drag_coefficient, gas_density) + drag_rate(drag_coefficient, dust_density)
}

/// The time in which the velocity difference decays by a factor `e`, `t_s = rho_a rho_i / (K (rho_a + rho_i))`.
///
/// No longer than [`LONGEST_STEP`], which it is without drag. Source: PL20 (7).
#[equation("pl20:7")]
pub fn stopping_time<R: Real>(stopping_rate: R) -> R {
    1.0 / R::lit(1.0 / LONGEST_STEP).max(stopping_rate)
}

/// The step that explicit drag allows, `0.9 t_s` with the shortest stopping time among the neighbours.
///
/// Forward Euler is stable to `2 t_s` and monotone to `t_s`. Not needed with the exact update of
/// [`stiff_drag`](super::stiff_drag). Source: PL20 section 3.
#[equation(unnumbered = "the explicit drag step, PL20 section 3")]
pub fn drag_step<R: Real>(largest_stopping_rate: R) -> R {
    R::lit(EXPLICIT_SHARE) * stopping_time(largest_stopping_rate)
}

/// What a pair's drag has before its velocities: `nu m_other D / ((rho_a + rho_i) t_s) = nu (K / rho_own) (m_other / rho_other) D` (T^-1).
///
/// By (7), `1 / ((rho_a + rho_i) t_s) = K / (rho_a rho_i)`. A volume times `D` is of order one, so this is finite wherever the
/// partner's drag rate is, whatever the unit of density; the product of two densities is not. Densities and volumes come from
/// neighbours of the same kind, `double_hump` is `D` with the larger of the two smoothing lengths (L^-nu).
/// Source: PL20 (4)-(7).
#[equation("pl20:4", "pl20:5", "pl20:6", "pl20:7")]
pub fn drag_weight<R: Real, const D: usize>(own_rate: R, other_volume: R, double_hump: R) -> R {
    R::lit(D as f64) * (own_rate * (other_volume * double_hump))
}

/// One pair's drag on one of its partners, `-+ weight (v*_ai . r) r`: towards the other's velocity.
///
/// `omega_star` is the reconstructed `v*_ai . r_ai / r`, the same for both partners; `direction` is the unit vector from the other to
/// the particle itself, zero for coincident particles. For the gas that is (4), for the dust, whose direction is opposite, (5).
/// As printed, both have the other sign; momentum is conserved all the same, energy is not. Source: PL20 (4), (5).
#[equation("pl20:4", "pl20:5")]
pub fn drag_acceleration<R: Real, const D: usize>(
    signs: DragSigns,
    weight: R,
    omega_star: R,
    direction: Vector<R, D>,
) -> Vector<R, D> {
    let along = weight * omega_star;
    match signs {
        DragSigns::Physical => direction.scale(-along),
        DragSigns::AsPrinted => direction.scale(along),
    }
}

/// One pair's drag heating of the gas particle, `weight (v*_ai . r) (v_ai . r)`, with the gas particle's weight.
///
/// One reconstructed and one raw velocity: only so is total energy conserved. Negative where the two have different signs,
/// see [`entropy_fixed`](super::dust_reconstruction::entropy_fixed). Source: PL20 (6).
#[equation("pl20:6")]
pub fn drag_heating<R: Real>(gas_weight: R, omega_star: R, omega: R) -> R {
    gas_weight * (omega_star * omega)
}
