//! Noh's implosion (Noh 1987): cold gas that falls onto a point, a line or a plane at unit speed.
//!
//! The papers here do not run it. The gas is a ball, a disc or an interval with nothing around it: with no pressure its edge knows nothing and moves
//! inwards at unit speed like all the rest, so the solution holds within it until the shock comes near.

use super::scene::{Description, GivenMomentum, Glasses, Measured, Quantity, Scene, Solution};
use super::{Block, Definition, Method, SceneError, State, View};
use crate::domain::Domain;
use crate::exact::noh::Noh as Exact;
use crate::particles::{Particle, ParticleSet};
use crate::passes::Physics;
use crate::sum::CompensatedSum;
use serde::{Deserialize, Serialize};

/// When one usually looks (Noh 1987, section 3): the shock has come to 0.2 for an index of 5/3.
pub const END_TIME: f64 = 0.6;
/// The density at the start (Noh 1987, section 3).
pub const DENSITY: f64 = 1.0;
/// The speed of the fall (Noh 1987, section 3).
pub const SPEED: f64 = 1.0;
/// The adiabatic index (Noh 1987, section 3).
const GAMMA: f64 = 5.0 / 3.0;
/// The ball's radius: at the usual time its edge is three times as far out as the shock.
const RADIUS: f64 = 1.2;
/// Within this share of the shock's radius lies the plateau: beyond, the shock is spread over a few particles.
const PLATEAU: f64 = 0.8;
/// Within this share it is disturbed by the heat of the first moment, when the shock was as thin as a particle.
const CENTRE: f64 = 0.3;
/// Shells in which density is averaged to find the shock.
const SHELLS: usize = 200;
/// Fewer show no shock.
const LEAST: usize = 40;

/// The implosion: what is a choice of the problem.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Noh {
    /// How it is computed.
    #[serde(skip)]
    pub method: Method,
    /// The adiabatic index.
    pub gamma: f64,
    /// The ball's radius.
    pub radius: f64,
    /// The specific internal energy at the start, which should be nothing beside the 1/2 that the shock makes.
    pub internal_energy: f64,
}

impl Default for Noh {
    fn default() -> Self {
        Self::standard(2)
    }
}

impl Noh {
    /// The exact solution.
    pub fn exact(&self, dimension: usize) -> Result<Exact, SceneError> {
        Exact::new(dimension, self.gamma, DENSITY, SPEED).map_err(|error| SceneError::Solution(error.to_string()))
    }

    fn block<const D: usize>(&self) -> Block<D> {
        Block { lower: [-self.radius; D], upper: [self.radius; D] }
    }

    /// How many particles the box must have for the ball to have as many as asked for.
    fn in_the_box(&self, dimension: usize) -> usize {
        let share = [1.0, std::f64::consts::FRAC_PI_4, std::f64::consts::FRAC_PI_6][dimension - 1];
        (self.method.particles as f64 / share).round() as usize
    }

    /// How far the support of a particle of the initial gas reaches.
    fn reach<const D: usize>(&self) -> f64 {
        self.method.reach(D, self.block::<D>().volume() / self.in_the_box(D) as f64)
    }

    /// The density within two distances from the centre; none if no particle is there.
    fn mean_density(&self, state: &State, within: (f64, f64)) -> Option<f64> {
        let radius = |i: usize| View::Radius([0.0; 3]).of(state.place(i), state.speed(i), state.position.len()).0;
        let (mut mass, mut volume) = (CompensatedSum::new(), CompensatedSum::new());
        for i in state.moving().filter(|&i| (within.0..within.1).contains(&radius(i))) {
            mass.add(state.mass[i]);
            volume.add(state.mass[i] / state.density[i]);
        }
        (volume.value() > 0.0).then(|| mass.value() / volume.value())
    }

    /// The outermost place where the mean density is above the middle of those behind and before the shock; zero before there is one.
    fn shock(&self, state: &State, exact: &Exact) -> f64 {
        let width = self.radius / SHELLS as f64;
        let behind = exact.at(0.0, state.time).density;
        let shells = (0..SHELLS).rev().map(|shell| (shell as f64 * width, (shell + 1) as f64 * width));
        let dense = |&(inner, outer): &(f64, f64)| {
            // Gas that falls has this density, wherever it is.
            let before = DENSITY * (1.0 + SPEED * state.time / outer).powi(state.position.len() as i32 - 1);
            self.mean_density(state, (inner, outer)).is_some_and(|density| density > 0.5 * (behind + before))
        };
        shells.into_iter().find(dense).map_or(0.0, |(_, outer)| outer)
    }
}

impl Definition for Noh {
    const TITLE: &'static str = "Noh's implosion";
    const SOURCE: &'static str = "Noh 1987, section 3";
    const DIMENSIONS: &'static [usize] = &[2, 3, 1];
    const SOLUTION: &'static str = "Noh's solution";

    fn standard(dimension: usize) -> Self {
        let method = Method::standard(dimension, [400, 6_000, 14_000][dimension - 1]);
        Noh { method, gamma: GAMMA, radius: RADIUS, internal_energy: 0.0 }
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

impl<const D: usize> Scene<D> for Noh {
    fn method(&self) -> &Method {
        &self.method
    }
    fn physics(&self) -> Physics {
        self.method.physics(self.gamma)
    }
    fn check(&self) -> Result<(), SceneError> {
        SceneError::unless_in::<Self>("noh", D)?;
        SceneError::unless_above("gamma", self.gamma, 1.0)?;
        SceneError::unless_above("radius", self.radius, 0.0)?;
        if !(0.0..=MOST_ENERGY).contains(&self.internal_energy) {
            let rule =
                format!("give a number from 0 to {MOST_ENERGY}, which is nothing beside the 1/2 behind the shock");
            return Err(SceneError::Choice { name: "internal_energy", given: self.internal_energy.to_string(), rule });
        }
        self.method.check(D)?;
        self.block::<D>().check_room(&self.method, [false; D], LEAST, 1.0)
    }
    fn particles(&self, glasses: &mut Glasses<D>) -> Result<ParticleSet<D>, SceneError> {
        Scene::<D>::check(self)?;
        let block = self.block::<D>();
        let filling = block.filled(&self.method, self.in_the_box(D), glasses)?;
        let h = self.method.smoothing_length(D, filling.volume);
        let radius = |x: &[f64; D]| x.iter().map(|x| x * x).sum::<f64>().sqrt();
        let inside = filling.places.iter().map(|&x| (x, radius(&x))).filter(|(_, r)| *r <= self.radius);
        let particles = inside.map(|(position, r)| Particle {
            position,
            // In the very centre there is no direction to fall in.
            velocity: position.map(|x| if r > 0.0 { -SPEED * x / r } else { 0.0 }),
            mass: DENSITY * filling.volume,
            smoothing_length: h,
            internal_energy: self.internal_energy,
            mobile: true,
        });
        Ok(ParticleSet::new(Domain::new(block.lower, block.upper, [false; D])?, particles.collect())?)
    }
    fn view(&self) -> View {
        View::Radius([0.0; 3])
    }
    fn shown(&self) -> (f64, f64) {
        (0.0, 0.5 * self.radius)
    }
    /// Within the supports that do not reach beyond the edge, whose gas has come a way inwards.
    fn measured(&self, time: f64) -> Measured {
        let edge = (self.radius - SPEED * time - self.reach::<D>()).max(0.0);
        Measured {
            range: (0.0, edge.min(0.5 * self.radius)),
            source: "ours: half of the ball, less what its edge comes near",
        }
    }
    fn solution(&self, time: f64) -> Result<Option<Box<dyn Solution>>, SceneError> {
        Ok(Some(Box::new(Imploding { exact: self.exact(D)?, time, gamma_minus_one: self.gamma - 1.0 })))
    }
    fn last_time(&self) -> (f64, &'static str) {
        let Ok(exact) = self.exact(D) else { return (0.0, "there is no exact solution") };
        let room = self.radius - self.reach::<D>();
        (room / (SPEED + exact.shock_radius(1.0)), "the edge of the ball comes near the shock then")
    }
    fn given_momentum(&self, _: f64) -> GivenMomentum {
        GivenMomentum::None
    }
    fn quantities(&self) -> Vec<Quantity> {
        let exact = self.exact(D).ok();
        let source = "the exact solution";
        let plateau = exact.map(|exact| (exact.at(0.0, END_TIME).density, source));
        vec![
            Quantity {
                name: "plateau_density",
                label: "mean density of the plateau",
                symbol: "⟨ρ⟩",
                unit: "M L^-ν",
                expected: plateau,
            },
            Quantity {
                name: "wall_heating",
                label: "share of the density that is missing in the centre",
                symbol: "1 − ρ/ρ_2",
                unit: "",
                expected: Some((0.0, source)),
            },
            Quantity {
                name: "shock_radius",
                label: "radius of the shock",
                symbol: "r_s",
                unit: "L",
                expected: exact.map(|exact| (exact.shock_radius(END_TIME), source)),
            },
        ]
    }
    /// Zero where no particle lies yet where one looks.
    fn observe(&self, state: &State) -> Result<Vec<f64>, SceneError> {
        let exact = self.exact(D)?;
        let front = exact.shock_radius(state.time);
        let plateau = self.mean_density(state, (CENTRE * front, PLATEAU * front));
        let centre = self.mean_density(state, (0.0, CENTRE * front));
        let missing = centre.map(|density| 1.0 - density / exact.at(0.0, state.time).density);
        Ok(vec![plateau.unwrap_or(0.0), missing.unwrap_or(0.0), self.shock(state, &exact)])
    }
    fn description(&self) -> Description {
        Description {
            start: "cold gas that falls inwards at the same speed everywhere".into(),
            boundaries: "none: a ball with nothing around it".into(),
            settings: vec![
                ("Density".into(), DENSITY.to_string()),
                ("Speed".into(), SPEED.to_string()),
                ("Radius of the ball".into(), self.radius.to_string()),
                ("Specific internal energy".into(), self.internal_energy.to_string()),
            ],
        }
    }
}

/// A hundredth of what the shock makes.
const MOST_ENERGY: f64 = 5e-3;

struct Imploding {
    exact: Exact,
    time: f64,
    gamma_minus_one: f64,
}

impl Solution for Imploding {
    fn at(&self, r: f64) -> [f64; 4] {
        let state = self.exact.at(r, self.time);
        [state.density, state.velocity, state.pressure, state.pressure / (self.gamma_minus_one * state.density)]
    }
    fn jumps(&self) -> Vec<f64> {
        vec![self.exact.shock_radius(self.time)]
    }
}
