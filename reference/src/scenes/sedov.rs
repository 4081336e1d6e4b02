//! Sedov's blast (GS25 section 3.2): energy set free in the middle of cold gas.
//!
//! The paper's caption says t = 1 and its text t = 0.1: at t = 1 the shock has left the box, so it is 0.1. It gives the width of the deposit, 2 h, but
//! not what a Gaussian of that width is; both readings are a choice. Its box is periodic here.

use super::measures::Compared;
use super::scene::{Description, GivenMomentum, Glasses, Measured, Quantity, Scene, Solution};
use super::{Arrangement, Block, Definition, Method, SceneError, State, View};
use crate::domain::Domain;
use crate::exact::sedov::Sedov as Exact;
use crate::particles::{Particle, ParticleSet};
use crate::passes::Physics;
use crate::sum::CompensatedSum;
use serde::{Deserialize, Serialize};

/// When the paper looks (GS25 section 3.2).
pub const END_TIME: f64 = 0.1;
/// The density at the start (GS25 section 3.2).
pub const DENSITY: f64 = 1.0;
/// The energy set free (GS25 section 3.2): in one dimension for each unit of area, in two of length.
pub const ENERGY: f64 = 1.0;
/// The width of the deposit in smoothing lengths (GS25 section 3.2).
pub const WIDTH: f64 = 2.0;
/// The specific internal energy of the gas around (SPH-EXA's own set-up; the paper has none).
pub const COLD: f64 = 1e-8;
/// The adiabatic index (GS25 section 3).
const GAMMA: f64 = 5.0 / 3.0;
/// Half of the box, whose sides are 1 (GS25 section 3.2).
const HALF: f64 = 0.5;
/// The middle, where the energy is set free.
const CENTRE: View = View::Radius([0.0; 3]);
/// Fewer show no blast.
const LEAST: usize = 40;

/// What a Gaussian of width `delta` is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Gaussian {
    /// `exp(-r^2 / delta^2)`, as in SPH-EXA.
    Width,
    /// `exp(-r^2 / (2 delta^2))`: delta is the standard deviation.
    Deviation,
}

impl Gaussian {
    fn at(self, r: f64, delta: f64) -> f64 {
        let x = r / delta;
        match self {
            Gaussian::Width => (-x * x).exp(),
            Gaussian::Deviation => (-0.5 * x * x).exp(),
        }
    }
}

/// The blast: what is a choice of the problem.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Sedov {
    /// How it is computed.
    #[serde(skip)]
    pub method: Method,
    /// The adiabatic index, above 1 and below 2.
    pub gamma: f64,
    /// What the deposit looks like.
    pub deposit: Gaussian,
    /// Its width in smoothing lengths.
    pub width: f64,
    /// The specific internal energy of the gas around.
    pub cold: f64,
}

impl Default for Sedov {
    fn default() -> Self {
        Self::standard(3)
    }
}

impl Sedov {
    fn block<const D: usize>() -> Block<D> {
        Block { lower: [-HALF; D], upper: [HALF; D] }
    }

    /// How many particles there are: on a lattice an even number of rows. The row through the middle of an odd one is shot along itself, where
    /// nothing can push it aside, and its particles run into each other.
    fn number<const D: usize>(&self) -> usize {
        match self.method.arrangement {
            Arrangement::Glass => self.method.particles,
            Arrangement::Lattice => {
                let rows = (self.method.particles as f64).powf(1.0 / D as f64);
                (2 * (0.5 * rows).round() as usize).pow(D as u32)
            }
        }
    }

    /// The exact solution for a deposit at a point.
    pub fn exact(&self, dimension: usize) -> Result<Exact, SceneError> {
        Exact::new(dimension, self.gamma, DENSITY, ENERGY).map_err(|error| SceneError::Choice {
            name: "gamma",
            given: self.gamma.to_string(),
            rule: error.to_string(),
        })
    }

    /// The radius of the particle that moves outwards fastest.
    fn fastest(state: &State) -> f64 {
        let dimension = state.position.len();
        let seen = state.moving().map(|i| CENTRE.of(state.place(i), state.speed(i), dimension));
        seen.max_by(|a, b| a.1.total_cmp(&b.1)).map_or(0.0, |(radius, _)| radius)
    }
}

impl Definition for Sedov {
    const TITLE: &'static str = "Sedov's blast";
    const SOURCE: &'static str = "GS25, section 3.2";
    const DIMENSIONS: &'static [usize] = &[3, 2, 1];
    const SOLUTION: &'static str = "Sedov's solution";

    /// A glass, as the paper has it, where there is more than one line of particles.
    fn standard(dimension: usize) -> Self {
        let mut method = Method::standard(dimension, [400, 6_000, 20_000][dimension - 1]);
        if dimension > 1 {
            method.arrangement = Arrangement::Glass;
        }
        Sedov { method, gamma: GAMMA, deposit: Gaussian::Width, width: WIDTH, cold: COLD }
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

impl<const D: usize> Scene<D> for Sedov {
    fn method(&self) -> &Method {
        &self.method
    }
    fn physics(&self) -> Physics {
        self.method.physics(self.gamma)
    }
    fn check(&self) -> Result<(), SceneError> {
        SceneError::unless_in::<Self>("sedov", D)?;
        self.exact(D)?;
        SceneError::unless_above("width", self.width, 0.0)?;
        if !(0.0..=MOST_COLD).contains(&self.cold) {
            let rule = format!("give a number from 0 to {MOST_COLD}, which is nothing beside the blast");
            return Err(SceneError::Choice { name: "cold", given: self.cold.to_string(), rule });
        }
        self.method.check(D)?;
        let block = Self::block::<D>();
        block.check_room(&self.method, [true; D], LEAST, 1.0)?;
        let delta = self.width * self.method.smoothing_length(D, block.volume() / self.method.particles as f64);
        if delta > MOST_WIDTH {
            let rule = format!(
                "the deposit is {delta} wide in a box of 1; more particles, or a smaller width, make it {MOST_WIDTH}"
            );
            return Err(SceneError::Choice { name: "width", given: self.width.to_string(), rule });
        }
        Ok(())
    }
    fn particles(&self, glasses: &mut Glasses<D>) -> Result<ParticleSet<D>, SceneError> {
        Scene::<D>::check(self)?;
        let block = Self::block::<D>();
        let filling = block.filled(&self.method, self.number::<D>(), glasses)?;
        let mass = DENSITY * filling.volume;
        let h = self.method.smoothing_length(D, filling.volume);
        let radius = |x: &[f64; D]| x.iter().map(|x| x * x).sum::<f64>().sqrt();
        let shape = |x: &[f64; D]| self.deposit.at(radius(x), self.width * h);
        // The sum over particles is made the energy, not the integral: a Gaussian two particles wide is no quadrature.
        let total = mass * filling.places.iter().map(shape).collect::<CompensatedSum<f64>>().value();
        let particles = filling.places.iter().map(|&position| Particle {
            position,
            velocity: [0.0; D],
            mass,
            smoothing_length: h,
            internal_energy: self.cold + ENERGY * shape(&position) / total,
            mobile: true,
        });
        Ok(ParticleSet::new(Domain::new(block.lower, block.upper, [true; D])?, particles.collect())?)
    }
    fn view(&self) -> View {
        CENTRE
    }
    fn shown(&self) -> (f64, f64) {
        (0.0, HALF)
    }
    /// To the shock. The paper goes to the radius of the largest velocity of each run, which is another place for each: that is in the
    /// quantities.
    fn measured(&self, time: f64) -> Measured {
        let shock = self.exact(D).map_or(HALF, |exact| exact.shock_radius(time));
        Measured { range: (0.0, shock.min(HALF)), source: "GS25, section 3.2, to the exact shock" }
    }
    fn solution(&self, time: f64) -> Result<Option<Box<dyn Solution>>, SceneError> {
        if time <= 0.0 {
            return Ok(None);
        }
        Ok(Some(Box::new(Blast { exact: self.exact(D)?, time, gamma_minus_one: self.gamma - 1.0 })))
    }
    fn last_time(&self) -> (f64, &'static str) {
        let Ok(exact) = self.exact(D) else { return (0.0, "there is no exact solution") };
        // The radius grows as t^(2 / (nu + 2)).
        let last = (HALF / exact.shock_radius(1.0)).powf(0.5 * (D as f64 + 2.0));
        (last, "the blast meets itself around the box then")
    }
    fn given_momentum(&self, _: f64) -> GivenMomentum {
        GivenMomentum::None
    }
    fn quantities(&self) -> Vec<Quantity> {
        let exact = self.exact(D).ok();
        let quantity = |name, label, symbol, unit, expected| Quantity { name, label, symbol, unit, expected };
        let strong = (self.gamma + 1.0) / (self.gamma - 1.0) * DENSITY;
        let front = exact.map(|exact| (exact.shock_radius(END_TIME), "Sedov's solution"));
        vec![
            quantity(
                "maximum_density",
                "largest density",
                "ρ_max",
                "M L^-ν",
                Some((strong, "the limit of a strong shock")),
            ),
            quantity("shock_radius", "radius of the fastest particle", "R", "L", front),
            quantity("l1_radial_velocity", "error of the radial velocity, to that radius", "L₁(v_r)", "L T^-1", None),
            quantity("l1_density", "error of the density, to that radius", "L₁(ρ)", "M L^-ν", None),
        ]
    }
    /// Errors are zero at the start, where there is no solution.
    fn observe(&self, state: &State) -> Result<Vec<f64>, SceneError> {
        let largest = state.moving().map(|i| state.density[i]).fold(0.0, f64::max);
        let Some(solution) = Scene::<D>::solution(self, state.time)? else {
            return Ok(vec![largest, 0.0, 0.0, 0.0]);
        };
        let radius = Self::fastest(state);
        let error = |what| state.l1(CENTRE, solution.as_ref(), what, (0.0, radius));
        Ok(vec![largest, radius, error(Compared::Velocity)?, error(Compared::Density)?])
    }
    fn description(&self) -> Description {
        let deposit = match self.deposit {
            Gaussian::Width => "exp(−r²/δ²)",
            Gaussian::Deviation => "exp(−r²/2δ²)",
        };
        Description {
            start: format!("an energy of {ENERGY} as {deposit} with δ = {} h, in gas at rest", self.width),
            boundaries: "periodic".into(),
            settings: vec![
                ("Density".into(), DENSITY.to_string()),
                ("Specific internal energy of the gas around".into(), self.cold.to_string()),
            ],
        }
    }
}

/// A ten-thousandth of the blast's mean, if it were spread over the box.
const MOST_COLD: f64 = 1e-4;
/// A fifth of the box: the blast of a wider deposit is none from a point by the time it is looked at.
const MOST_WIDTH: f64 = 0.2;

/// Nearer to the centre, in shock radii, the internal energy is taken to be what it is there.
const INNERMOST: f64 = 0.01;

struct Blast {
    exact: Exact,
    time: f64,
    gamma_minus_one: f64,
}

impl Solution for Blast {
    fn at(&self, r: f64) -> [f64; 4] {
        let state = self.exact.at(r, self.time);
        // In the very centre there is pressure without density, and no finite energy.
        let near = self.exact.at(r.max(INNERMOST * self.exact.shock_radius(self.time)), self.time);
        let energy = near.pressure / (self.gamma_minus_one * near.density);
        [state.density, state.velocity, state.pressure, energy]
    }
    fn jumps(&self) -> Vec<f64> {
        vec![self.exact.shock_radius(self.time)]
    }
}
