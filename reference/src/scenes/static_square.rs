//! A square of denser gas in pressure balance with the gas around, at rest (Saitoh & Makino 2013): it should stay a square.
//!
//! Where the density is smoothed and the energy jumps, so does the pressure: a surface tension that rounds the corners.

use super::scene::{Description, GivenMomentum, Glasses, Measured, Quantity, Scene, Solution};
use super::{Block, Definition, Method, SceneError, State, View};
use crate::domain::Domain;
use crate::particles::{Particle, ParticleSet};
use crate::passes::Physics;
use serde::{Deserialize, Serialize};

/// The pressure (Saitoh & Makino 2013, their test of hydrostatic equilibrium).
pub const PRESSURE: f64 = 2.5;
/// The density around (same place).
pub const AROUND: f64 = 1.0;
/// The density of the square (same place).
pub const INSIDE: f64 = 4.0;
/// The square's sides along each axis (same place).
pub const SQUARE: (f64, f64) = (0.25, 0.75);
/// When one looks: sound has gone through the box twice and more. The paper goes on to 8.
pub const END_TIME: f64 = 1.0;
/// The adiabatic index (same place).
const GAMMA: f64 = 5.0 / 3.0;
/// Fewer show no square.
const LEAST: usize = 100;

/// The square: what is a choice of the problem.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct StaticSquare {
    /// How it is computed.
    #[serde(skip)]
    pub method: Method,
    /// The density of the square; around it is 1.
    pub density: f64,
    /// The adiabatic index.
    pub gamma: f64,
}

impl Default for StaticSquare {
    fn default() -> Self {
        Self::standard(2)
    }
}

impl StaticSquare {
    fn whole<const D: usize>() -> Block<D> {
        Block { lower: [0.0; D], upper: [1.0; D] }
    }
    fn square<const D: usize>() -> Block<D> {
        Block { lower: [SQUARE.0; D], upper: [SQUARE.1; D] }
    }
    /// Rows of the gas around along each axis: four or a multiple, so that the square's sides are between two of them.
    fn rows<const D: usize>(&self, particles: usize) -> usize {
        let square = Self::square::<D>().volume();
        let around = particles as f64 / (1.0 + square * (self.density - 1.0));
        4 * ((around.powf(1.0 / D as f64) / 4.0).round() as usize).max(1)
    }
}

impl Definition for StaticSquare {
    const TITLE: &'static str = "A dense square at rest";
    const SOURCE: &'static str = "Saitoh & Makino 2013";
    const DIMENSIONS: &'static [usize] = &[2, 3];
    const SOLUTION: &'static str = "none; nothing moves";

    fn standard(dimension: usize) -> Self {
        let method = Method::standard(dimension, if dimension == 2 { 4_000 } else { 14_000 });
        StaticSquare { method, density: INSIDE, gamma: GAMMA }
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

impl<const D: usize> Scene<D> for StaticSquare {
    fn method(&self) -> &Method {
        &self.method
    }
    fn physics(&self) -> Physics {
        self.method.physics(self.gamma)
    }
    fn check(&self) -> Result<(), SceneError> {
        SceneError::unless_in::<Self>("static-square", D)?;
        SceneError::unless_above("gamma", self.gamma, 1.0)?;
        if !(MOST_CONTRAST.recip()..=MOST_CONTRAST).contains(&self.density) {
            let rule = format!("give a number from {} to {MOST_CONTRAST}", MOST_CONTRAST.recip());
            return Err(SceneError::Choice { name: "density", given: self.density.to_string(), rule });
        }
        self.method.check(D)?;
        let (whole, square) = (Self::whole::<D>(), Self::square::<D>());
        let fits = |particles: usize| {
            let around = self.rows::<D>(particles).pow(D as u32);
            let inside = (square.volume() * self.density * around as f64).round().max(1.0) as usize;
            // The widest supports are those of the thinner gas. Nothing is periodic about the square, but a glass that fills it is.
            whole.has_room(&self.method, [true; D], around, (AROUND / self.density).max(1.0))
                && square.has_room(&self.method, [false; D], inside, 1.0)
        };
        self.method.check_number(D, LEAST, fits)
    }
    fn particles(&self, glasses: &mut Glasses<D>) -> Result<ParticleSet<D>, SceneError> {
        Scene::<D>::check(self)?;
        let (whole, square) = (Self::whole::<D>(), Self::square::<D>());
        let in_square = |x: &[f64; D]| x.iter().all(|x| (SQUARE.0..SQUARE.1).contains(x));
        let around = whole.filled(&self.method, self.rows::<D>(self.method.particles).pow(D as u32), glasses)?;
        let outer: Vec<[f64; D]> = around.places.into_iter().filter(|x| !in_square(x)).collect();
        let outer_volume = (whole.volume() - square.volume()) / outer.len() as f64;
        // As many as have the mass of those around.
        let count = (square.volume() * self.density / (AROUND * outer_volume)).round() as usize;
        let inner = square.filled(&self.method, count.max(1), glasses)?;
        let particle = |position: [f64; D], density: f64, volume: f64| Particle {
            position,
            velocity: [0.0; D],
            mass: density * volume,
            smoothing_length: self.method.smoothing_length(D, volume),
            internal_energy: PRESSURE / ((self.gamma - 1.0) * density),
            mobile: true,
        };
        let outer = outer.into_iter().map(|x| particle(x, AROUND, outer_volume));
        let inner = inner.places.iter().map(|&x| particle(x, self.density, inner.volume));
        Ok(ParticleSet::new(Domain::new(whole.lower, whole.upper, [true; D])?, outer.chain(inner).collect())?)
    }
    fn view(&self) -> View {
        View::Along(0)
    }
    fn shown(&self) -> (f64, f64) {
        (0.0, 1.0)
    }
    fn measured(&self, _: f64) -> Measured {
        Measured { range: (0.0, 1.0), source: "the whole box" }
    }
    fn solution(&self, _: f64) -> Result<Option<Box<dyn Solution>>, SceneError> {
        Ok(None)
    }
    fn given_momentum(&self, _: f64) -> GivenMomentum {
        GivenMomentum::None
    }
    fn quantities(&self) -> Vec<Quantity> {
        let rest = Some((0.0, "gas at rest"));
        let quantity = |name, label, symbol| Quantity { name, label, symbol, unit: "", expected: rest };
        vec![
            quantity("velocity_noise", "velocity over the speed of sound around", "σ(v)/c"),
            quantity("pressure_noise", "scatter of the pressure", "σ(P)/P"),
            quantity("energy_drift", "change of the energy, over the energy", "ΔE/E"),
            quantity("entropy_gain", "mean change of the entropy over the specific heat", "ΔS/c_v"),
            quantity("spill", "share of the square's mass that has left it by more than a smoothing length", "ΔM/M"),
        ]
    }
    fn observe(&self, state: &State) -> Result<Vec<f64>, SceneError> {
        Scene::<D>::observe_since(self, state, state)
    }
    fn observe_since(&self, start: &State, now: &State) -> Result<Vec<f64>, SceneError> {
        let sound = (self.gamma * PRESSURE / AROUND).sqrt();
        let energy = |state: &State| state.kinetic_energy() + state.thermal_energy();
        let within = |state: &State, i: usize, margin: f64| {
            (0..D).all(|axis| (SQUARE.0 - margin..SQUARE.1 + margin).contains(&state.position[axis][i]))
        };
        let square: Vec<usize> = start.moving().filter(|&i| within(start, i, 0.0)).collect();
        let gone = square.iter().filter(|&&i| !within(now, i, start.smoothing_length[i])).count();
        Ok(vec![
            now.root_mean_square(|i| now.quickness(i)) / sound,
            now.scatter(&now.pressure, PRESSURE),
            (energy(now) - energy(start)) / energy(start),
            now.entropy_gain(start, self.gamma - 1.0, 0.0)?,
            gone as f64 / square.len().max(1) as f64,
        ])
    }
    fn description(&self) -> Description {
        Description {
            start: "a denser square in pressure balance, at rest".into(),
            boundaries: "periodic".into(),
            settings: vec![
                ("Density around, inside".into(), format!("{AROUND}, {}", self.density)),
                ("Pressure".into(), PRESSURE.to_string()),
            ],
        }
    }
}

/// Beyond this the square, or the gas around, has too few particles to have an inside.
const MOST_CONTRAST: f64 = 64.0;
