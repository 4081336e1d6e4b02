//! The Rayleigh-Taylor layers: GS25 (25), (26).

use super::GasState;
use etalon_kernels_gen::functions::sine_of_turns;
use etalon_kernels_gen::{Real, Vector, equation};
use serde::{Deserialize, Serialize};

/// Density below and above the interface (GS25 section 3.5).
pub const DENSITY: [f64; 2] = [1.0, 2.0];
/// The acceleration along y (GS25 section 3.5).
pub const GRAVITY: f64 = -0.5;
/// The pressure at the bottom (GS25 section 3.5).
pub const BOTTOM_PRESSURE: f64 = 2.5;
/// The height of the interface (GS25 section 3.5: the middle of a box of height 2).
pub const INTERFACE: f64 = 1.0;
/// The height of the unstable layer (GS25 25, 26).
pub const LAYER: f64 = 0.4;
/// The amplitude of the seed; the largest velocity is four times it (GS25 26).
pub const SEED: f64 = 0.025;

/// How the pressure is set.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Balance {
    /// In balance with the sharp step of the density: (25) with a layer of no height. The text asks for balance.
    Hydrostatic,
    /// (25) with the printed layer of 0.4, within which the mean density is taken. Not in balance: the layer is squeezed from the start.
    Printed,
}

impl Balance {
    /// The height of the layer in which the pressure takes the mean density.
    pub const fn layer(self) -> f64 {
        match self {
            Balance::Hydrostatic => 0.0,
            Balance::Printed => LAYER,
        }
    }
}

/// The pressure at height `y`, falling with `rho_d` below a layer around the interface, with the mean density in it and with `rho_u` above.
///
/// `P = P(0) + g [rho_d y_1 + (rho_d + rho_u)/2 (y_2 - y_1) + rho_u (y - y_2)]`, the three stretches ending where `y` does. The layer has the height `layer`;
/// zero makes it hydrostatic for a density that jumps. `g` is negative. Source: GS25 (25).
#[equation("gs25:25")]
pub fn layered_pressure<R: Real>(y: R, bottom_pressure: R, density: [R; 2], gravity: R, interface: R, layer: R) -> R {
    let [lower, upper] = density;
    let (floor, ceiling) = (interface - 0.5 * layer, interface + 0.5 * layer);
    let below = floor.min(y);
    let within = floor.max(ceiling.min(y)) - floor;
    let above = 0.0.max(y - ceiling);
    let column = lower * below + 0.5 * (lower + upper) * within + upper * above;
    bottom_pressure + gravity * column
}

/// The vertical velocity, `dv [1 - cos 2 pi x] [1 + cos(2 pi (y - y_b)/delta)]` within the layer, zero outside.
///
/// As `4 dv sin^2(pi x) sin^2(pi/2 - pi |y - y_b|/delta)`, which loses no digits where it is small and is never negative. For up to 32 box widths.
/// Source: GS25 (26).
#[equation("gs25:26")]
pub fn plume_seed<R: Real>(x: R, y: R, amplitude: R, interface: R, layer: R) -> R {
    let depth = 0.0.max(0.5 - (y - interface).abs() / layer);
    let sideways = sine_of_turns(0.5 * x);
    let upwards = sine_of_turns(0.5 * depth);
    4.0 * amplitude * (sideways * sideways) * (upwards * upwards)
}

/// The layers at a place of the box of width 1 and height 2, with the pressure as `balance` says.
///
/// Source: GS25 (25), (26) with the values of its section 3.5.
#[equation("gs25:25", "gs25:26")]
pub fn rayleigh_taylor<R: Real, const D: usize>(x: Vector<R, D>, balance: Balance) -> GasState<R, D> {
    let y = x.0[1];
    let [lower, upper] = DENSITY.map(R::lit);
    let density = if y < R::lit(INTERFACE) { lower } else { upper };
    let (gravity, interface) = (R::lit(GRAVITY), R::lit(INTERFACE));
    let layer = R::lit(balance.layer());
    let pressure = layered_pressure(y, R::lit(BOTTOM_PRESSURE), [lower, upper], gravity, interface, layer);
    let rise = plume_seed(x.0[0], y, R::lit(SEED), interface, R::lit(LAYER));
    let velocity = Vector::from_fn(|axis| if axis == 1 { rise } else { R::zero() });
    GasState { density, velocity, pressure }
}
