//! The Kelvin-Helmholtz instability (GS25 section 3.4): three layers that slide past each other.
//!
//! The paper's density jumps; the reference amplitude it quotes, from McNally et al. 2012, belongs to a density that is as smooth as the velocity. Both are
//! a choice. The seed has the same size at all heights.

use super::layers::{Layer, check_room, fill};
use super::scene::{Description, GivenMomentum, Glasses, Measured, Quantity, Scene, Solution};
use super::{AtEnd, Block, Course, Definition, Method, SceneError, State, View};
use crate::diagnostics::mode_amplitude::{ShearColumns, mode_amplitude};
use crate::diagnostics::sign_reversal::reversed_shares;
use crate::domain::Domain;
use crate::equations::initial_state::kelvin_helmholtz::{
    Contact, DENSITY, PRESSURE, SEED, VELOCITY, WAVELENGTH, WIDTH, kelvin_helmholtz,
};
use crate::particles::{Particle, ParticleSet};
use crate::passes::Physics;
use crate::pipeline::PassKind;
use etalon_kernels_gen::Vector;
use serde::{Deserialize, Serialize};

/// When the paper compares amplitudes (GS25 Table 3; the header of Table 7 has 1.5 growth times, 1.59, which its reference does not fit).
pub const END_TIME: f64 = 1.5;
/// The depth of the paper's box (GS25 Table 2).
pub const DEPTH: f64 = 0.1;
/// How many times as many neighbours as elsewhere in the paper (GS25 section 3.4: 120).
pub const MORE_NEIGHBOURS: f64 = 1.2;
/// The adiabatic index (GS25 section 3).
const GAMMA: f64 = 5.0 / 3.0;
/// Where the layers meet (GS25 section 3.4 after McNally et al. 2012).
const INTERFACES: [f64; 2] = [0.25, 0.75];
/// Fewer show no layers.
const LEAST: usize = 200;
/// Of a sharp contact's amplitude at the end.
const SHARP_AMPLITUDE: (f64, &str) = (0.1408, "finite volumes, converged");
/// Of a smooth one's.
const SMOOTH_AMPLITUDE: (f64, &str) = (0.1479, "McNally et al. 2012, as GS25 Table 3 has it");

/// The layers: what is a choice of the problem.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct KelvinHelmholtz {
    /// How it is computed.
    #[serde(skip)]
    pub method: Method,
    /// What the density does where the layers meet.
    pub contact: Contact,
    /// How deep the box is in three dimensions.
    pub depth: f64,
    /// The adiabatic index.
    pub gamma: f64,
}

impl Default for KelvinHelmholtz {
    fn default() -> Self {
        Self::standard(2)
    }
}

impl KelvinHelmholtz {
    fn between<const D: usize>(&self, low: f64, high: f64) -> Block<D> {
        let upper = [1.0, high, self.depth];
        Block {
            lower: std::array::from_fn(|axis| if axis == 1 { low } else { 0.0 }),
            upper: std::array::from_fn(|axis| upper[axis]),
        }
    }

    /// For a sharp contact two layers, the outer one in one piece around the box; for a smooth one the box, whose particles have the mass that
    /// their place asks for.
    fn layers<const D: usize>(&self) -> Vec<Layer<D>> {
        let [low, high] = INTERFACES;
        match self.contact {
            Contact::Sharp => vec![
                Layer { block: self.between(high, 1.0 + low), density: DENSITY[0] },
                Layer { block: self.between(low, high), density: DENSITY[1] },
            ],
            Contact::Smooth => vec![Layer { block: self.between(0.0, 1.0), density: 1.0 }],
        }
    }
}

impl Definition for KelvinHelmholtz {
    const TITLE: &'static str = "Kelvin-Helmholtz instability";
    const SOURCE: &'static str = "GS25, section 3.4";
    const DIMENSIONS: &'static [usize] = &[2, 3];
    const SOLUTION: &'static str = "none; the amplitude at the end is known";

    /// In three dimensions the paper's depth takes more particles than a minute or two allow.
    fn standard(dimension: usize) -> Self {
        let mut method = Method::standard(dimension, if dimension == 2 { 6_000 } else { 64_000 });
        method.neighbours *= MORE_NEIGHBOURS.powf(dimension as f64 / 3.0);
        KelvinHelmholtz { method, contact: Contact::Sharp, depth: DEPTH, gamma: GAMMA }
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

impl<const D: usize> Scene<D> for KelvinHelmholtz {
    fn method(&self) -> &Method {
        &self.method
    }
    fn physics(&self) -> Physics {
        self.method.physics(self.gamma)
    }
    fn check(&self) -> Result<(), SceneError> {
        SceneError::unless_in::<Self>("kelvin-helmholtz", D)?;
        SceneError::unless_above("depth", self.depth, 0.0)?;
        SceneError::unless_above("gamma", self.gamma, 1.0)?;
        self.method.check(D)?;
        check_room(&self.layers::<D>(), &self.method, std::array::from_fn(|axis| axis != 1), LEAST)
    }
    fn particles(&self, glasses: &mut Glasses<D>) -> Result<ParticleSet<D>, SceneError> {
        Scene::<D>::check(self)?;
        let layers = self.layers::<D>();
        let mut particles = Vec::new();
        for (layer, filled) in layers.iter().zip(fill(&layers, &self.method, glasses)?) {
            particles.extend(filled.places.iter().map(|&place| {
                let mut position = place;
                position[1] -= position[1].floor();
                let gas = kelvin_helmholtz::<f64, D>(Vector(position), self.contact);
                Particle {
                    position,
                    velocity: gas.velocity.0,
                    mass: filled.mass * gas.density / layer.density,
                    smoothing_length: filled.smoothing_length,
                    internal_energy: gas.pressure / ((self.gamma - 1.0) * gas.density),
                    mobile: true,
                }
            }));
        }
        let Block { lower, upper } = self.between::<D>(0.0, 1.0);
        Ok(ParticleSet::new(Domain::new(lower, upper, [true; D])?, particles)?)
    }
    fn view(&self) -> View {
        View::Across { coordinate: 1, velocity: 1 }
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
        let expected = match self.contact {
            Contact::Sharp => SHARP_AMPLITUDE,
            Contact::Smooth => SMOOTH_AMPLITUDE,
        };
        vec![
            Quantity {
                name: "amplitude",
                label: "amplitude of the velocity across the layers",
                symbol: "A",
                unit: "L T^-1",
                expected: Some(expected),
            },
            Quantity {
                name: "kinetic_energy_y",
                label: "kinetic energy across the layers",
                symbol: "E_y",
                unit: "M L^2 T^-2",
                expected: None,
            },
        ]
    }
    fn observe(&self, state: &State) -> Result<Vec<f64>, SceneError> {
        let volume: Vec<f64> = (0..state.len()).map(|i| state.mass[i] / state.density[i]).collect();
        let [x, y] = [&state.position[0], &state.position[1]];
        let amplitude =
            mode_amplitude(ShearColumns { x, y, velocity_y: &state.velocity[1], volume: &volume }, WAVELENGTH)?;
        Ok(vec![amplitude, state.kinetic_energy_along(1)])
    }
    /// Where nothing is reconstructed, no sign is turned.
    fn quantities_at_end(&self) -> Vec<Quantity> {
        if !self.method.viscosity.dissipation.reconstructs() {
            return Vec::new();
        }
        let quantity = |name, label| Quantity { name, label, symbol: "", unit: "", expected: None };
        vec![
            quantity("sign_reversals", "share of the pairs whose velocity of approach reconstruction turns round"),
            quantity("sign_reversals_approaching", "the same of the pairs that approach"),
        ]
    }
    fn at_end(&self, course: &Course) -> Result<AtEnd, SceneError> {
        if !self.method.viscosity.dissipation.reconstructs() {
            return Ok(AtEnd::default());
        }
        let Block { lower, upper } = self.between::<D>(0.0, 1.0);
        let physics = Scene::<D>::physics(self);
        let domain = Domain::new(lower, upper, [true; D])?;
        let mut engine = course.end.swept(domain, physics, PassKind::VelocityGradients)?;
        let shares = reversed_shares(&mut engine, physics)?;
        Ok(AtEnd { values: vec![Ok(shares.of_all), Ok(shares.of_approaching)], curves: Vec::new() })
    }
    fn description(&self) -> Description {
        let start = match self.contact {
            Contact::Sharp => "three layers whose density jumps where they meet",
            Contact::Smooth => "three layers whose density is as smooth as their velocity",
        };
        let pair = |[outer, inner]: [f64; 2]| format!("{outer}, {inner}");
        let mut settings = vec![
            ("Density, outside and inside".into(), pair(DENSITY)),
            ("Velocity along x, outside and inside".into(), pair(VELOCITY)),
            ("Over what length the velocity changes".into(), WIDTH.to_string()),
            ("Pressure".into(), PRESSURE.to_string()),
            ("Seed: velocity along y, wavelength".into(), format!("{SEED}, {WAVELENGTH}")),
        ];
        if D > 2 {
            settings.push(("Depth of the box".into(), self.depth.to_string()));
        }
        Description { start: start.into(), boundaries: "periodic".into(), settings }
    }
}
