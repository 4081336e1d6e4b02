//! Profiles that scenes start from: functions of position, a file per test problem.

pub mod gresho_chan;
pub mod kelvin_helmholtz;
pub mod rayleigh_taylor;
pub mod wind_cloud;

use etalon_kernels_gen::functions::exp_negative;
use etalon_kernels_gen::{Real, Vector, equation};

/// What a gas is like at a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GasState<R, const D: usize> {
    /// Density (M L^-nu).
    pub density: R,
    /// Velocity (L T^-1).
    pub velocity: Vector<R, D>,
    /// Pressure (M L^(2-nu) T^-2).
    pub pressure: R,
}

/// The smoothed pressure of the shock tube, `P = -A tanh((x - x_c) / delta) + B`.
///
/// `A = 0.45`, `B = 0.55`, `delta = 0.01`, `x_c = 0.5` take the pressure from 1 to 0.1. The hyperbolic tangent is `(1 - e) / (1 + e)` with `e = exp(-2 |y|)`.
/// Source: GS25 (21).
#[equation("gs25:21")]
pub fn smoothed_pressure<R: Real>(x: R, centre: R, width: R, amplitude: R, offset: R) -> R {
    let y = (x - centre) / width;
    let e = exp_negative(2.0 * y.abs());
    let size = (1.0 - e) / (1.0 + e);
    let tanh = if y < 0.0 { -size } else { size };
    offset - amplitude * tanh
}
