//! Driven subsonic turbulence (C25 section 2, GS25 section 4): gas at rest in a periodic box, stirred by a few long waves.
//!
//! Box, density, sound speed, the range of waves and the Mach number are the papers'; the strength of the driving, its memory and the end time are those
//! of SPH-EXA, with which both papers ran it. `docs/turbulence.md` has the table.

pub mod ending;

use super::scene::{Description, GivenMomentum, Glasses, Measured, Quantity, Scene, Solution};
use super::{AtEnd, Block, Course, Definition, Method, SceneError, State, View};
use crate::domain::Domain;
use crate::equations::equation_of_state::sound_speed;
use crate::fields;
use crate::norms::mean;
use crate::particles::{Particle, ParticleSet};
use crate::passes::Physics;
use crate::schemes::{ModeWeights, Profile};
use crate::turbulence::forcing::{Driving, Forcing};
use etalon_kernels_gen::Field;
use serde::{Deserialize, Serialize};

/// The side of the periodic box (C25 section 2).
pub const SIDE: f64 = 1.0;
/// The gas's density (C25 section 2).
pub const DENSITY: f64 = 1.0;
/// `gamma - 1`: nearly isothermal (C25 section 2, GS25 section 3).
pub const GAMMA_MINUS_ONE: f64 = 0.001;
/// The specific internal energy, for a sound speed of one (SPH-EXA).
pub const INTERNAL_ENERGY: f64 = 1000.0;
/// Ten times that sound needs for a side (GS25 section 4: `-s 10`).
pub const END_TIME: f64 = 10.0;
/// Gas that is stirred wants so much more room than gas at rest.
const STIRRED: f64 = 1.2;

/// The turbulence: what is a choice of the problem.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Turbulence {
    /// How it is computed.
    #[serde(skip)]
    pub method: Method,
    /// The velocity aimed at, which is the Mach number where sound has the velocity one; the papers' is 0.3.
    pub velocity: f64,
    /// The weight of the part of the force without divergence, from 0 to 1; one half is the natural mixture.
    pub solenoidal_weight: f64,
    /// What is a parabola over the driven waves.
    pub profile: Profile,
    /// How the directions of waves are weighted.
    pub weights: ModeWeights,
    /// What the driving's random numbers start from.
    pub seed: u64,
}

impl Default for Turbulence {
    fn default() -> Self {
        Self::standard(3)
    }
}

impl Turbulence {
    /// The same with another method.
    pub fn with(mut self, change: impl FnOnce(&mut Method)) -> Self {
        change(&mut self.method);
        self
    }

    fn block<const D: usize>() -> Block<D> {
        Block { lower: [0.0; D], upper: [SIDE; D] }
    }

    fn driving(&self) -> Driving {
        let Turbulence { velocity, solenoidal_weight, profile, weights, .. } = *self;
        Driving { velocity, solenoidal_weight, profile, weights }
    }

    /// The speed of sound at the start.
    pub fn sound_speed(&self) -> f64 {
        sound_speed(GAMMA_MINUS_ONE, INTERNAL_ENERGY)
    }
}

impl Definition for Turbulence {
    const TITLE: &'static str = "Driven subsonic turbulence";
    const SOURCE: &'static str = "C25, section 2; GS25, section 4";
    const DIMENSIONS: &'static [usize] = &[3, 2, 1];
    const SOLUTION: &'static str = "none";

    fn standard(dimension: usize) -> Self {
        let Driving { velocity, solenoidal_weight, profile, weights } = Driving::subsonic();
        let method = Method::standard(dimension, [200, 1_600, 4_096][dimension - 1]);
        Turbulence { method, velocity, solenoidal_weight, profile, weights, seed: 1 }
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

impl<const D: usize> Scene<D> for Turbulence {
    fn method(&self) -> &Method {
        &self.method
    }
    fn physics(&self) -> Physics {
        Physics { forced: true, ..self.method.physics(1.0 + GAMMA_MINUS_ONE) }
    }
    fn check(&self) -> Result<(), SceneError> {
        SceneError::unless_in::<Self>("turbulence", D)?;
        self.method.check(D)?;
        Scene::<D>::forcing(self)?;
        let fits = |count| Self::block::<D>().has_room(&self.method, [true; D], count, STIRRED.powi(D as i32));
        self.method.check_number(D, 1, fits)
    }
    fn forcing(&self) -> Result<Option<Forcing<D>>, SceneError> {
        let domain = Domain::new([0.0; D], [SIDE; D], [true; D])?;
        Forcing::new(&domain, self.driving(), self.seed).map(Some).map_err(|error| SceneError::Choice {
            name: "velocity, solenoidal_weight",
            given: format!("{}, {}", self.velocity, self.solenoidal_weight),
            rule: error.to_string(),
        })
    }
    fn particles(&self, glasses: &mut Glasses<D>) -> Result<ParticleSet<D>, SceneError> {
        Scene::<D>::check(self)?;
        let block = Self::block::<D>();
        let filling = block.filled(&self.method, self.method.particles, glasses)?;
        let particle = |&position: &[f64; D]| Particle {
            position,
            velocity: [0.0; D],
            mass: DENSITY * filling.volume,
            smoothing_length: self.method.smoothing_length(D, filling.volume),
            internal_energy: INTERNAL_ENERGY,
            mobile: true,
        };
        let particles = filling.places.iter().map(particle).collect();
        Ok(ParticleSet::new(Domain::new(block.lower, block.upper, [true; D])?, particles)?)
    }
    fn view(&self) -> View {
        View::Along(0)
    }
    fn shown(&self) -> (f64, f64) {
        (0.0, SIDE)
    }
    fn measured(&self, _: f64) -> Measured {
        Measured { range: (0.0, SIDE), source: "the whole box" }
    }
    fn solution(&self, _: f64) -> Result<Option<Box<dyn Solution>>, SceneError> {
        Ok(None)
    }
    fn given_momentum(&self, _: f64) -> GivenMomentum {
        GivenMomentum::None
    }
    fn quantities(&self) -> Vec<Quantity> {
        let quantity = |name, label, symbol, expected| Quantity { name, label, symbol, unit: "", expected };
        vec![
            quantity(
                "mach_rms",
                "root mean square Mach number",
                "M_rms",
                Some((self.velocity, "C25 section 2, once it is steady")),
            ),
            quantity("density_scatter", "scatter of the density", "σ(ρ)/ρ", None),
            quantity("heating", "change of the internal energy over that of the start", "ΔU/U", None),
            quantity("grad_h_mean", "mean of the grad-h factor", "⟨Ω⟩", Some((1.0, "C25 appendix B"))),
            quantity(
                "grad_h_scatter",
                "standard deviation of the grad-h factor",
                "σ(Ω)",
                Some((0.0, "C25 appendix B")),
            ),
        ]
    }
    fn further_fields(&self) -> &'static [Field] {
        &[fields::GRAD_H]
    }
    fn observe(&self, state: &State) -> Result<Vec<f64>, SceneError> {
        let speed = |i: usize| state.quickness(i) / sound_speed(GAMMA_MINUS_ONE, state.internal_energy[i]);
        // All masses are equal: a mean over particles is one over mass.
        let mach = state.root_mean_square(speed);
        let start = INTERNAL_ENERGY * DENSITY * SIDE.powi(state.position.len() as i32);
        let omega = state.further(fields::GRAD_H)?;
        let omega_mean = mean(omega.iter().copied());
        let omega_scatter = state.root_mean_square(|i| omega[i] - omega_mean);
        let heating = state.thermal_energy() / start - 1.0;
        Ok(vec![mach, state.scatter(&state.density, DENSITY), heating, omega_mean, omega_scatter])
    }
    /// Slopes are known of turbulence in three dimensions.
    fn quantities_at_end(&self) -> Vec<Quantity> {
        let known = |value: f64, source| if D == 3 { Some((value, source)) } else { None };
        let quantity = |name, label, symbol, unit, expected| Quantity { name, label, symbol, unit, expected };
        vec![
            quantity("k_max", "waves a side at the bottleneck", "k_max", "", None),
            quantity(
                "spectrum_slope",
                "slope of the velocity's spectrum from k = 4 to 10",
                "d ln E/d ln k",
                "",
                known(-ending::KOLMOGOROV, "Kolmogorov; C25 section 3"),
            ),
            quantity(
                "mach_slope",
                "slope of the Mach number from a tenth to a quarter of the side",
                "d ln M/d ln l",
                "",
                known(ending::MACH_POWER, "Kolmogorov; C25 appendix C"),
            ),
        ]
    }
    fn at_end(&self, course: &Course) -> Result<AtEnd, SceneError> {
        ending::at_end::<D>(course.end, self.seed)
    }
    fn description(&self) -> Description {
        Description {
            start: "at rest".into(),
            boundaries: "periodic".into(),
            settings: vec![
                ("Driven to a velocity of".into(), self.velocity.to_string()),
                ("Solenoidal weight".into(), self.solenoidal_weight.to_string()),
                ("A parabola is the".into(), self.profile.to_string()),
                ("Weights of waves".into(), self.weights.to_string()),
                ("Seed".into(), self.seed.to_string()),
            ],
        }
    }
}
