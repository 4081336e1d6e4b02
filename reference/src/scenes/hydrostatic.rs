//! A box of gas at rest in gravity, between fixed layers: its pressure holds its weight, and nothing should move.
//!
//! Ours: the box of GS25 section 3.5 with one gas, and half as high.

use super::layers::{Layer, between_walls, check_room};
use super::measures::Compared;
use super::scene::{Description, GivenMomentum, Glasses, Measured, Quantity, Scene, Solution};
use super::{Block, Definition, Method, SceneError, State, View};
use crate::equations::initial_state::GasState;
use crate::equations::initial_state::rayleigh_taylor::{BOTTOM_PRESSURE, GRAVITY, INTERFACE, layered_pressure};
use crate::particles::ParticleSet;
use crate::passes::Physics;
use etalon_kernels_gen::Vector;
use serde::{Deserialize, Serialize};

/// When one looks: sound has gone up and down.
pub const END_TIME: f64 = 1.0;
/// The density.
pub const DENSITY: f64 = 1.0;
/// The height of the box.
pub const HEIGHT: f64 = 1.0;
/// The adiabatic index (GS25 section 3).
const GAMMA: f64 = 1.4;
/// Fewer have no inside.
const LEAST: usize = 100;
/// What looks along the vertical.
const UPWARDS: View = View::Along(1);

/// The box: what is a choice of the problem.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Hydrostatic {
    /// How it is computed.
    #[serde(skip)]
    pub method: Method,
    /// The adiabatic index.
    pub gamma: f64,
}

impl Default for Hydrostatic {
    fn default() -> Self {
        Self::standard(2)
    }
}

fn pressure(height: f64) -> f64 {
    layered_pressure(height, BOTTOM_PRESSURE, [DENSITY; 2], GRAVITY, INTERFACE, 0.0)
}

impl Hydrostatic {
    fn layers<const D: usize>() -> [Layer<D>; 1] {
        let upper = std::array::from_fn(|axis| if axis == 1 { HEIGHT } else { 1.0 });
        [Layer { block: Block { lower: [0.0; D], upper }, density: DENSITY }]
    }
}

impl Definition for Hydrostatic {
    const TITLE: &'static str = "Gas at rest in gravity";
    const SOURCE: &'static str = "ours, after GS25, section 3.5";
    const DIMENSIONS: &'static [usize] = &[2, 3];
    const SOLUTION: &'static str = "rest";

    fn standard(dimension: usize) -> Self {
        let method = Method::standard(dimension, if dimension == 2 { 3_000 } else { 14_000 });
        Hydrostatic { method, gamma: GAMMA }
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

impl<const D: usize> Scene<D> for Hydrostatic {
    fn method(&self) -> &Method {
        &self.method
    }
    fn physics(&self) -> Physics {
        Physics { gravity: [0.0, GRAVITY, 0.0], ..self.method.physics(self.gamma) }
    }
    fn check(&self) -> Result<(), SceneError> {
        SceneError::unless_in::<Self>("hydrostatic", D)?;
        SceneError::unless_above("gamma", self.gamma, 1.0)?;
        self.method.check(D)?;
        check_room(&Self::layers::<D>(), &self.method, std::array::from_fn(|axis| axis != 1), LEAST)
    }
    fn particles(&self, glasses: &mut Glasses<D>) -> Result<ParticleSet<D>, SceneError> {
        Scene::<D>::check(self)?;
        let gas =
            |place: [f64; D]| GasState { density: DENSITY, velocity: Vector([0.0; D]), pressure: pressure(place[1]) };
        between_walls(&Self::layers(), &self.method, self.gamma, glasses, gas)
    }
    fn view(&self) -> View {
        UPWARDS
    }
    fn shown(&self) -> (f64, f64) {
        (0.0, HEIGHT)
    }
    fn measured(&self, _: f64) -> Measured {
        Measured { range: (0.0, HEIGHT), source: "the whole box" }
    }
    fn solution(&self, _: f64) -> Result<Option<Box<dyn Solution>>, SceneError> {
        Ok(Some(Box::new(Rest { gamma_minus_one: self.gamma - 1.0 })))
    }
    fn given_momentum(&self, _: f64) -> GivenMomentum {
        GivenMomentum::Unknown("gravity pulls, and the fixed layers push as the gas above and below them does".into())
    }
    fn quantities(&self) -> Vec<Quantity> {
        let rest = Some((0.0, "gas at rest"));
        let quantity = |name, label, symbol, unit| Quantity { name, label, symbol, unit, expected: rest };
        vec![
            quantity("velocity_noise", "velocity over the speed of sound at the bottom", "σ(v)/c", ""),
            quantity("l1_pressure", "error of the pressure", "L₁(P)", "M L^(2-ν) T^-2"),
            quantity("entropy_gain", "mean change of the entropy over the specific heat", "ΔS/c_v", ""),
        ]
    }
    fn observe(&self, state: &State) -> Result<Vec<f64>, SceneError> {
        Scene::<D>::observe_since(self, state, state)
    }
    fn observe_since(&self, start: &State, now: &State) -> Result<Vec<f64>, SceneError> {
        let sound = (self.gamma * BOTTOM_PRESSURE / DENSITY).sqrt();
        let rest = Rest { gamma_minus_one: self.gamma - 1.0 };
        Ok(vec![
            now.root_mean_square(|i| now.quickness(i)) / sound,
            now.l1(UPWARDS, &rest, Compared::Pressure, (0.0, HEIGHT))?,
            now.entropy_gain(start, self.gamma - 1.0, 0.0)?,
        ])
    }
    fn description(&self) -> Description {
        Description {
            start: "gas at rest whose pressure holds its weight".into(),
            boundaries: "fixed layers below and above, periodic else".into(),
            settings: vec![
                ("Density".into(), DENSITY.to_string()),
                ("Gravity".into(), GRAVITY.to_string()),
                ("Pressure at the bottom".into(), BOTTOM_PRESSURE.to_string()),
            ],
        }
    }
}

struct Rest {
    gamma_minus_one: f64,
}

impl Solution for Rest {
    fn at(&self, height: f64) -> [f64; 4] {
        let pressure = pressure(height);
        [DENSITY, 0.0, pressure, pressure / (self.gamma_minus_one * DENSITY)]
    }
}
