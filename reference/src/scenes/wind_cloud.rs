//! A cloud in a wind (GS25 section 3.6): a dense ball, at rest in a supersonic wind of the same pressure.
//!
//! The paper gives a box of 40 x 10 x 10 without its unit; it is the cloud's radius, which the growth time it states fits. It does not say what bounds the
//! box: it is periodic here, and the wind comes around after 11 units of time.

use super::scene::{Description, GivenMomentum, Glasses, Measured, Quantity, Scene, Solution};
use super::{AtEnd, Block, Course, Definition, Method, SceneError, State, View};
use crate::diagnostics::cloud_mass::CloudAndWind;
use crate::domain::Domain;
use crate::equations::initial_state::wind_cloud::{
    CENTRE, DENSITY, MACH, PRESSURE, RADIUS, Wind, wind_cloud, wind_speed,
};
use crate::particles::{Particle, ParticleSet};
use crate::passes::Physics;
use crate::schemes::Viscosity;
use etalon_kernels_gen::Vector;
use serde::{Deserialize, Serialize};

/// The box in cloud radii (GS25 Table 2).
pub const BOX: [f64; 3] = [40.0, 10.0, 10.0];
/// The growth time that the paper measures in (GS25 section 3.6).
pub const GROWTH_TIME: f64 = 2.9;
/// When the paper looks last, in growth times (GS25 Table 5).
const LAST_LOOK: f64 = 2.0;
/// The adiabatic index (GS25 section 3).
const GAMMA: f64 = 5.0 / 3.0;
/// When the paper takes the rate (GS25 Tables 5, 7), in growth times; and within how much time of it, which the paper does not say.
const RATE_AT: f64 = 1.8;
const RATE_WITHIN: f64 = 0.5;
/// Fewer show no cloud: it has a hundredth of the volume and ten times the density.
const LEAST: usize = 2_000;

/// The cloud: what is a choice of the problem.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct WindCloud {
    /// How it is computed.
    #[serde(skip)]
    pub method: Method,
    /// What the 2.7 of the wind means.
    pub wind: Wind,
    /// The adiabatic index.
    pub gamma: f64,
}

impl Default for WindCloud {
    fn default() -> Self {
        Self::standard(3)
    }
}

impl WindCloud {
    fn whole<const D: usize>() -> Block<D> {
        Block { lower: [0.0; D], upper: std::array::from_fn(|axis| BOX[axis]) }
    }

    /// The cube that the cloud is cut from, which holds whole particles of the wind's mass, and how many.
    fn cube<const D: usize>(mass: f64) -> (Block<D>, usize) {
        let spacing = (mass / DENSITY[1]).powf(1.0 / D as f64);
        let across = (2.0 * RADIUS / spacing).ceil();
        let half = 0.5 * across * spacing;
        let block = Block {
            lower: std::array::from_fn(|axis| CENTRE[axis] - half),
            upper: std::array::from_fn(|axis| CENTRE[axis] + half),
        };
        (block, across.powi(D as i32) as usize)
    }

    /// What of the gas is cloud.
    pub fn gas(&self) -> CloudAndWind {
        CloudAndWind { cloud_density: DENSITY[1], wind_energy: PRESSURE / ((self.gamma - 1.0) * DENSITY[0]) }
    }

    /// The mass of the cloud in a state.
    pub fn cloud_mass(&self, state: &State) -> f64 {
        self.gas().mass(state.moving().map(|i| [state.mass[i], state.density[i], state.internal_energy[i]]))
    }
}

/// The rate at which the mass changes that is left of the cloud, $\dot M / M_0$, at a time: the slope of the straight line nearest to a run's values within
/// `window` before and after it (GS25 Table 5). None if there are fewer than two values, or all are at one time.
///
/// The paper gives neither its unit of time nor how it takes the slope; its values fit a rate per code unit.
pub fn destruction_rate(times: &[f64], mass_fraction: &[f64], at: f64, window: f64) -> Option<f64> {
    let near = || times.iter().zip(mass_fraction).filter(|(time, _)| (*time - at).abs() <= window);
    let count = near().count() as f64;
    let mean_time = near().map(|(time, _)| time).sum::<f64>() / count;
    let mean_mass = near().map(|(_, mass)| mass).sum::<f64>() / count;
    let spread: f64 = near().map(|(time, _)| (time - mean_time).powi(2)).sum();
    let along: f64 = near().map(|(time, mass)| (time - mean_time) * (mass - mean_mass)).sum();
    (spread > 0.0).then(|| along / spread)
}

impl Definition for WindCloud {
    const TITLE: &'static str = "A cloud in a wind";
    const SOURCE: &'static str = "GS25, section 3.6";
    const DIMENSIONS: &'static [usize] = &[3];
    const SOLUTION: &'static str = "none";

    /// With the conduction that the paper's code has here.
    fn standard(dimension: usize) -> Self {
        let mut method = Method::standard(dimension, 20_000);
        method.viscosity.conduction = Viscosity::CONDUCTION;
        WindCloud { method, wind: Wind::Mach, gamma: GAMMA }
    }
    fn end_time(&self) -> f64 {
        LAST_LOOK * GROWTH_TIME
    }
    fn method(&self) -> &Method {
        &self.method
    }
    fn method_mut(&mut self) -> &mut Method {
        &mut self.method
    }
}

impl<const D: usize> Scene<D> for WindCloud {
    fn method(&self) -> &Method {
        &self.method
    }
    fn physics(&self) -> Physics {
        self.method.physics(self.gamma)
    }
    fn check(&self) -> Result<(), SceneError> {
        SceneError::unless_in::<Self>("wind-cloud", D)?;
        SceneError::unless_above("gamma", self.gamma, 1.0)?;
        self.method.check(D)?;
        let whole = Self::whole::<D>();
        let fits = |count: usize| {
            let (cube, of_cloud) = Self::cube::<D>(DENSITY[0] * whole.volume() / count as f64);
            // Nothing is periodic about the cloud, but a glass that it is cut from is.
            whole.has_room(&self.method, [true; D], count, 1.0)
                && cube.has_room(&self.method, [false; D], of_cloud, 1.0)
        };
        self.method.check_number(D, LEAST, fits)
    }
    fn particles(&self, glasses: &mut Glasses<D>) -> Result<ParticleSet<D>, SceneError> {
        Scene::<D>::check(self)?;
        let block = Self::whole::<D>();
        let wind = block.filled(&self.method, self.method.particles, glasses)?;
        let mass = DENSITY[0] * wind.volume;
        let (cube, count) = Self::cube::<D>(mass);
        let cloud = cube.filled(&self.method, count, glasses)?;
        let inside = |x: &[f64; D]| (0..D).map(|axis| (x[axis] - CENTRE[axis]).powi(2)).sum::<f64>() <= RADIUS * RADIUS;
        let particle = |position: [f64; D], volume: f64| {
            let gas = wind_cloud::<f64, D>(Vector(position), self.gamma, self.wind);
            Particle {
                position,
                velocity: gas.velocity.0,
                mass: gas.density * volume,
                smoothing_length: self.method.smoothing_length(D, volume),
                internal_energy: gas.pressure / ((self.gamma - 1.0) * gas.density),
                mobile: true,
            }
        };
        let outer = wind.places.iter().filter(|x| !inside(x)).map(|&x| particle(x, wind.volume));
        let inner = cloud.places.iter().filter(|x| inside(x)).map(|&x| particle(x, cloud.volume));
        let particles = outer.chain(inner).collect();
        Ok(ParticleSet::new(Domain::new(block.lower, block.upper, [true; D])?, particles)?)
    }
    fn view(&self) -> View {
        View::Along(0)
    }
    fn shown(&self) -> (f64, f64) {
        (0.0, BOX[0])
    }
    fn measured(&self, _: f64) -> Measured {
        Measured { range: (0.0, BOX[0]), source: "the whole box" }
    }
    fn solution(&self, _: f64) -> Result<Option<Box<dyn Solution>>, SceneError> {
        Ok(None)
    }
    fn given_momentum(&self, _: f64) -> GivenMomentum {
        GivenMomentum::None
    }
    fn quantities(&self) -> Vec<Quantity> {
        let quantity = |name, label, symbol, unit| Quantity { name, label, symbol, unit, expected: None };
        vec![
            quantity("cloud_fraction", "share of the cloud that is left", "M/M₀", ""),
            quantity("cloud_mass", "mass of the cloud", "M", "M"),
        ]
    }
    fn observe(&self, state: &State) -> Result<Vec<f64>, SceneError> {
        Scene::<D>::observe_since(self, state, state)
    }
    /// The share is of the mass that the start is found to have: smoothing takes some of the nominal one.
    fn observe_since(&self, start: &State, now: &State) -> Result<Vec<f64>, SceneError> {
        let (before, left) = (self.cloud_mass(start), self.cloud_mass(now));
        Ok(vec![if before > 0.0 { left / before } else { 0.0 }, left])
    }
    fn quantities_at_end(&self) -> Vec<Quantity> {
        vec![Quantity {
            name: "destruction_rate",
            label: "change of the share of the cloud in a unit of time, at 1.8 growth times",
            symbol: "Ṁ/M₀",
            unit: "T^-1",
            expected: None,
        }]
    }
    fn at_end(&self, course: &Course) -> Result<AtEnd, SceneError> {
        let at = RATE_AT * GROWTH_TIME;
        // Half of the window is no rate at its middle.
        let over = course.time.last().is_some_and(|last| *last >= at + RATE_WITHIN);
        let fraction = course.values.first().filter(|_| over);
        let rate = fraction.and_then(|fraction| destruction_rate(course.time, fraction, at, RATE_WITHIN));
        let (from, to) = (at - RATE_WITHIN, at + RATE_WITHIN);
        let none = || format!("the share was not measured twice from t = {from} to {to}, and beyond: run until then");
        Ok(AtEnd { values: vec![rate.ok_or_else(none)], curves: Vec::new() })
    }
    fn description(&self) -> Description {
        let speed = match self.wind {
            Wind::Mach => format!("{:.4} (Mach {MACH})", wind_speed(MACH, self.gamma, PRESSURE, DENSITY[0])),
            Wind::Speed => format!("{MACH}, a speed and no Mach number"),
        };
        Description {
            start: "a dense ball at rest in a wind of the same pressure".into(),
            boundaries: "periodic".into(),
            settings: vec![
                ("Density of wind and cloud".into(), format!("{}, {}", DENSITY[0], DENSITY[1])),
                ("Pressure".into(), PRESSURE.to_string()),
                ("Speed of the wind".into(), speed),
                ("Radius of the cloud".into(), RADIUS.to_string()),
            ],
        }
    }
}
