//! The Gresho-Chan vortex: GS25 (22), (23). A steady flow, so it is its own exact solution.

use super::GasState;
use etalon_kernels_gen::functions::{logarithm, ratio_or_zero};
use etalon_kernels_gen::{Real, Vector, equation};

/// The radius of the largest velocity (GS25 22, where it is printed as `psi = 5 r`).
pub const RADIUS: f64 = 0.2;
/// The largest velocity (GS25 section 3.3).
pub const VELOCITY: f64 = 1.0;
/// The density (GS25 section 3.3).
pub const DENSITY: f64 = 1.0;
/// The pressure on the axis (GS25 section 3.3).
pub const CENTRAL_PRESSURE: f64 = 5.0;

/// The azimuthal velocity, `v_0 psi` to `psi = 1`, `v_0 (2 - psi)` to `psi = 2`, zero beyond; `psi` is the distance from the axis over 0.2.
///
/// Source: GS25 (22).
#[equation("gs25:22")]
pub fn vortex_velocity<R: Real>(psi: R, largest_velocity: R) -> R {
    largest_velocity * 0.0.max(psi.min(2.0 - psi))
}

/// The pressure that holds the vortex together, `P_0 + 4 rho_0 v_0^2 s` with `s = psi^2/8`, `psi^2/8 - psi + ln psi + 1`, `ln 2 - 1/2` in the
/// three zones.
///
/// The third is the second at `psi = 2`, where the flow ends. `dP/dr = rho_0 v_phi^2 / r`. The printed form has no `rho_0`, which is one. Source: GS25 (23).
#[equation("gs25:23")]
pub fn vortex_pressure<R: Real>(psi: R, central_pressure: R, density: R, largest_velocity: R) -> R {
    let inner = 0.125 * psi * psi;
    let within = psi.max(1.0).min(2.0);
    let outer = 0.125 * within * within - within + logarithm(within) + 1.0;
    let shape = if psi > 1.0 { outer } else { inner };
    central_pressure + 4.0 * density * largest_velocity * largest_velocity * shape
}

/// The vortex at a place; its axis is the third one, through the origin. Zero velocity on the axis.
///
/// Source: GS25 (22), (23) with the values of its section 3.3.
#[equation("gs25:22", "gs25:23")]
pub fn gresho_chan<R: Real, const D: usize>(x: Vector<R, D>) -> GasState<R, D> {
    let (east, north) = plane(x);
    let r = (east * east + north * north).sqrt();
    let psi = r * R::lit(1.0 / RADIUS);
    let turning = ratio_or_zero(vortex_velocity(psi, R::lit(VELOCITY)), r);
    let velocity = Vector::from_fn(|axis| match axis {
        0 => -(turning * north),
        1 => turning * east,
        _ => R::zero(),
    });
    let pressure = vortex_pressure(psi, R::lit(CENTRAL_PRESSURE), R::lit(DENSITY), R::lit(VELOCITY));
    GasState { density: R::lit(DENSITY), velocity, pressure }
}

/// The first two coordinates; the second is zero where there is none.
#[inline(always)]
fn plane<R: Real, const D: usize>(x: Vector<R, D>) -> (R, R) {
    (x.0[0], if D > 1 { x.0[1 % D] } else { R::zero() })
}
