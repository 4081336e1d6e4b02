//! The Rayleigh-Taylor instability (GS25 section 3.5): a heavy gas on a light one.
//!
//! The paper states neither what bounds its box above and below nor in which sense (25) balances: it does not, for a density that jumps. Here fixed layers of
//! the same gas at rest lie beyond both ends, and the pressure is in balance unless the printed one is asked for.

use super::layers::{Layer, between_walls, check_room};
use super::scene::{Description, GivenMomentum, Glasses, Measured, Quantity, Scene, Solution};
use super::{Block, Definition, Method, SceneError, State, View};
use crate::diagnostics::mode_amplitude::{ShearColumns, mode_amplitude};
use crate::equations::initial_state::rayleigh_taylor::{
    BOTTOM_PRESSURE, Balance, DENSITY, GRAVITY, INTERFACE, LAYER, SEED, rayleigh_taylor,
};
use crate::particles::ParticleSet;
use crate::passes::Physics;
use etalon_kernels_gen::Vector;
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// When the paper looks (GS25 Table 4).
pub const END_TIME: f64 = 6.0;
/// The depth of the paper's box (GS25 Table 2).
pub const DEPTH: f64 = 0.1;
/// The height of the box (GS25 Table 2).
pub const HEIGHT: f64 = 2.0;
/// The adiabatic index (GS25 section 3).
const GAMMA: f64 = 1.4;
/// The width of the box, one wave of the seed (GS25 26).
const WAVELENGTH: f64 = 1.0;
/// The wave is looked for so near the interface: beyond it has died down to a fifth.
const NEAR: f64 = 0.25;
/// Fewer show no layers.
const LEAST: usize = 200;

/// The layers: what is a choice of the problem.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct RayleighTaylor {
    /// How it is computed.
    #[serde(skip)]
    pub method: Method,
    /// How the pressure is set.
    pub balance: Balance,
    /// How deep the box is in three dimensions.
    pub depth: f64,
    /// The adiabatic index.
    pub gamma: f64,
}

impl Default for RayleighTaylor {
    fn default() -> Self {
        Self::standard(2)
    }
}

/// The rate at which a small wave on a sharp interface between incompressible gases grows, $\sqrt{\mathrm{At}\, |g| k}$.
///
/// A wave that starts with a velocity and no displacement grows as the hyperbolic cosine. Walls a wavelength away change it by 1e-5.
pub fn growth_rate() -> f64 {
    let atwood = (DENSITY[1] - DENSITY[0]) / (DENSITY[1] + DENSITY[0]);
    (atwood * GRAVITY.abs() * TAU / WAVELENGTH).sqrt()
}

impl RayleighTaylor {
    fn between<const D: usize>(&self, low: f64, high: f64) -> Block<D> {
        let upper = [WAVELENGTH, high, self.depth];
        Block {
            lower: std::array::from_fn(|axis| if axis == 1 { low } else { 0.0 }),
            upper: std::array::from_fn(|axis| upper[axis]),
        }
    }
    fn layers<const D: usize>(&self) -> [Layer<D>; 2] {
        [
            Layer { block: self.between(0.0, INTERFACE), density: DENSITY[0] },
            Layer { block: self.between(INTERFACE, HEIGHT), density: DENSITY[1] },
        ]
    }
}

impl Definition for RayleighTaylor {
    const TITLE: &'static str = "Rayleigh-Taylor instability";
    const SOURCE: &'static str = "GS25, section 3.5";
    const DIMENSIONS: &'static [usize] = &[2, 3];
    const SOLUTION: &'static str = "none; the growth of a small wave is known";

    /// In three dimensions the paper's depth takes more particles than a minute or two allow.
    fn standard(dimension: usize) -> Self {
        let method = Method::standard(dimension, if dimension == 2 { 6_000 } else { 140_000 });
        RayleighTaylor { method, balance: Balance::Hydrostatic, depth: DEPTH, gamma: GAMMA }
    }
    fn end_time(&self) -> f64 {
        END_TIME
    }
    fn method(&self) -> &Method {
        &self.method
    }
    fn method_mut(&mut self) -> &mut Method {
        &mut self.method
    }
}

impl<const D: usize> Scene<D> for RayleighTaylor {
    fn method(&self) -> &Method {
        &self.method
    }
    fn physics(&self) -> Physics {
        Physics { gravity: [0.0, GRAVITY, 0.0], ..self.method.physics(self.gamma) }
    }
    fn check(&self) -> Result<(), SceneError> {
        SceneError::unless_in::<Self>("rayleigh-taylor", D)?;
        SceneError::unless_above("depth", self.depth, 0.0)?;
        SceneError::unless_above("gamma", self.gamma, 1.0)?;
        self.method.check(D)?;
        check_room(&self.layers::<D>(), &self.method, std::array::from_fn(|axis| axis != 1), LEAST)
    }
    fn particles(&self, glasses: &mut Glasses<D>) -> Result<ParticleSet<D>, SceneError> {
        Scene::<D>::check(self)?;
        let gas = |place| rayleigh_taylor::<f64, D>(Vector(place), self.balance);
        between_walls(&self.layers(), &self.method, self.gamma, glasses, gas)
    }
    fn view(&self) -> View {
        View::Along(1)
    }
    fn shown(&self) -> (f64, f64) {
        (0.0, HEIGHT)
    }
    fn measured(&self, _: f64) -> Measured {
        Measured { range: (0.0, HEIGHT), source: "the whole box" }
    }
    fn solution(&self, _: f64) -> Result<Option<Box<dyn Solution>>, SceneError> {
        Ok(None)
    }
    fn given_momentum(&self, _: f64) -> GivenMomentum {
        GivenMomentum::Unknown("gravity pulls, and the fixed layers push as the gas above and below them does".into())
    }
    fn quantities(&self) -> Vec<Quantity> {
        let quantity = |name, label, symbol, unit| Quantity { name, label, symbol, unit, expected: None };
        vec![
            quantity("kinetic_energy_y", "vertical kinetic energy", "E_y", "M L^2 T^-2"),
            quantity("bubble", "height of the highest light particle", "y_b", "L"),
            quantity("spike", "height of the lowest heavy particle", "y_s", "L"),
            quantity("amplitude", "amplitude of the vertical velocity at the interface", "A", "L T^-1"),
        ]
    }
    fn observe(&self, state: &State) -> Result<Vec<f64>, SceneError> {
        Scene::<D>::observe_since(self, state, state)
    }
    /// Light and heavy is what was below and above the interface at the start.
    fn observe_since(&self, start: &State, now: &State) -> Result<Vec<f64>, SceneError> {
        let height = &now.position[1];
        let light = now.moving().filter(|&i| start.position[1][i] < INTERFACE);
        let heavy = now.moving().filter(|&i| start.position[1][i] >= INTERFACE);
        let bubble = light.map(|i| height[i]).fold(f64::NEG_INFINITY, f64::max);
        let spike = heavy.map(|i| height[i]).fold(f64::INFINITY, f64::min);
        // The estimator has its layer at a quarter.
        let near: Vec<usize> = now.moving().filter(|&i| (height[i] - INTERFACE).abs() < NEAR).collect();
        let pick = |of: &dyn Fn(usize) -> f64| near.iter().map(|&i| of(i)).collect::<Vec<f64>>();
        let x = pick(&|i| now.position[0][i]);
        let y = pick(&|i| height[i] - INTERFACE + 0.25);
        let velocity_y = pick(&|i| now.velocity[1][i]);
        let volume = pick(&|i| now.mass[i] / now.density[i]);
        let gas = ShearColumns { x: &x, y: &y, velocity_y: &velocity_y, volume: &volume };
        Ok(vec![now.kinetic_energy_along(1), bubble, spike, mode_amplitude(gas, WAVELENGTH)?])
    }
    fn description(&self) -> Description {
        let start = match self.balance {
            Balance::Hydrostatic => "a heavy gas on a light one, in balance".into(),
            Balance::Printed => format!(
                "a heavy gas on a light one, with the mean weight within {LAYER} as GS25 (25) is printed: out of balance there"
            ),
        };
        let mut settings = vec![
            ("Density, below and above".into(), format!("{}, {}", DENSITY[0], DENSITY[1])),
            ("Gravity".into(), GRAVITY.to_string()),
            ("Pressure at the bottom".into(), BOTTOM_PRESSURE.to_string()),
            ("Seed".into(), SEED.to_string()),
            ("Growth rate of a small wave".into(), format!("{:.4}", growth_rate())),
        ];
        if D > 2 {
            settings.push(("Depth of the box".into(), self.depth.to_string()));
        }
        Description { start, boundaries: "fixed layers below and above, periodic else".into(), settings }
    }
}
