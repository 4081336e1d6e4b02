//! The wind-cloud test: a dense ball at rest in a supersonic wind, in pressure balance (GS25 section 3.6).

use super::GasState;
use etalon_kernels_gen::{Real, Vector, equation};
use serde::{Deserialize, Serialize};

/// Density of wind and cloud (GS25 section 3.6).
pub const DENSITY: [f64; 2] = [1.0, 10.0];
/// The pressure (GS25 section 3.6).
pub const PRESSURE: f64 = 1.0;
/// The cloud's radius: the unit of length of the box of 40 x 10 x 10, which the crushing time of GS25 (t_KH = 2.9) implies.
pub const RADIUS: f64 = 1.0;
/// The cloud's centre, from a corner of the box (Frontiere et al. 2017, whom GS25 follows).
pub const CENTRE: [f64; 3] = [5.0, 5.0, 5.0];
/// The wind's speed in units of its own sound speed (GS25 section 3.6).
pub const MACH: f64 = 2.7;

/// What the 2.7 of the wind means.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Wind {
    /// A Mach number, as GS25 section 3.6 says: a speed of 3.486.
    Mach,
    /// A speed, as in SPH-EXA's own set-up: Mach 2.09. Another problem; here to be compared with.
    Speed,
}

/// The speed of the wind, `M c` with `c^2 = gamma P / rho`.
///
/// Source: GS25 section 3.6.
#[equation(unnumbered = "wind, GS25 section 3.6")]
pub fn wind_speed<R: Real>(mach: R, gamma: R, pressure: R, density: R) -> R {
    mach * (gamma * pressure / density).sqrt()
}

/// The wind or, within the cloud's radius, the cloud, at a place of the box.
///
/// `gamma` is the adiabatic index. Source: GS25 section 3.6.
#[equation(unnumbered = "wind and cloud, GS25 section 3.6")]
pub fn wind_cloud<R: Real, const D: usize>(x: Vector<R, D>, gamma: R, wind: Wind) -> GasState<R, D> {
    let (thin, dense) = (R::lit(DENSITY[0]), R::lit(DENSITY[1]));
    let from_centre = x - Vector::from_fn(|axis| R::lit(CENTRE[axis]));
    let outside = from_centre.norm_squared() > R::lit(RADIUS * RADIUS);
    let density = if outside { thin } else { dense };
    let blowing = match wind {
        Wind::Mach => wind_speed(R::lit(MACH), gamma, R::lit(PRESSURE), thin),
        Wind::Speed => R::lit(MACH),
    };
    let speed = if outside { blowing } else { 0.0 };
    let velocity = Vector::from_fn(|axis| if axis == 0 { speed } else { R::zero() });
    GasState { density, velocity, pressure: R::lit(PRESSURE) }
}
