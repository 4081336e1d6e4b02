//! The Kelvin-Helmholtz layers: the profile of McNally, Lyra & Passy 2012 with the seed of GS25 (24).

use super::GasState;
use etalon_kernels_gen::functions::{exp_negative, sine_of_turns};
use etalon_kernels_gen::{Real, Vector, equation};
use serde::{Deserialize, Serialize};

/// The largest velocity across the layers (GS25 24).
pub const SEED: f64 = 0.01;
/// Its wavelength (GS25 24).
pub const WAVELENGTH: f64 = 0.5;
/// Velocity along the layers, outside and inside of the middle one (GS25 section 3.4).
pub const VELOCITY: [f64; 2] = [0.5, -0.5];
/// Density outside and inside (GS25 section 3.4: two to one; McNally: 1 and 2).
pub const DENSITY: [f64; 2] = [1.0, 2.0];
/// The length over which the velocity changes (GS25 section 3.4).
pub const WIDTH: f64 = 0.025;
/// The pressure (GS25 section 3.4).
pub const PRESSURE: f64 = 2.5;

/// What the density does where the layers meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Contact {
    /// It jumps, as GS25 section 3.4 says. The converged amplitude at `t = 1.5` is 0.1408.
    Sharp,
    /// It follows the profile of the velocity, as in McNally et al. The amplitude of 0.1479 that GS25 compares with belongs to this one.
    Smooth,
}

/// A layered profile in a box of height one: `outer` below 1/4 and above 3/4, `inner` between, each approached as `exp(-d/L)` with the distance
/// `d` from the nearer interface; the mean of both at the interfaces.
///
/// Source: McNally et al. 2012, equations 1 and 3, named by GS25 section 3.4.
#[equation(unnumbered = "layers of McNally et al. 2012, GS25 section 3.4")]
pub fn layered_profile<R: Real>(y: R, outer: R, inner: R, width: R) -> R {
    let height = (y - 0.5).abs() - 0.25;
    let change = 0.5 * (outer - inner) * exp_negative(height.abs() / width);
    if height > 0.0 { outer - change } else { inner + change }
}

/// The velocity across the layers, `dv sin(2 pi x / lambda)`, the same at all heights.
///
/// For up to sixteen wavelengths from the origin. Source: GS25 (24).
#[equation("gs25:24")]
pub fn shear_seed<R: Real>(x: R, amplitude: R, wavelength: R) -> R {
    amplitude * sine_of_turns(x / wavelength)
}

/// The layers at a place of the unit box, with the density as `contact` says.
///
/// Source: GS25 (24) and section 3.4.
#[equation("gs25:24")]
pub fn kelvin_helmholtz<R: Real, const D: usize>(x: Vector<R, D>, contact: Contact) -> GasState<R, D> {
    let y = x.0[1];
    let [outer, inner] = DENSITY.map(R::lit);
    let density = match contact {
        Contact::Smooth => layered_profile(y, outer, inner, R::lit(WIDTH)),
        Contact::Sharp => {
            if (y - 0.5).abs() > 0.25 {
                outer
            } else {
                inner
            }
        }
    };
    let along = layered_profile(y, R::lit(VELOCITY[0]), R::lit(VELOCITY[1]), R::lit(WIDTH));
    let across = shear_seed(x.0[0], R::lit(SEED), R::lit(WAVELENGTH));
    let velocity = Vector::from_fn(|axis| match axis {
        0 => along,
        1 => across,
        _ => R::zero(),
    });
    GasState { density, velocity, pressure: R::lit(PRESSURE) }
}
