//! The vortex of Gresho and Chan (GS25 section 3.3): steady, so that whatever changes is error.
//!
//! The paper does not say what bounds its box: it is periodic here, and the gas at its sides rests. The paper's box is 0.5 deep; nothing depends on z.

use super::measures::Compared;
use super::scene::{Description, GivenMomentum, Glasses, Measured, Quantity, Scene, Solution};
use super::{Block, Definition, Method, SceneError, State, View};
use crate::domain::Domain;
use crate::equations::initial_state::gresho_chan::{
    CENTRAL_PRESSURE, DENSITY, RADIUS, VELOCITY, gresho_chan, vortex_pressure, vortex_velocity,
};
use crate::particles::{Particle, ParticleSet};
use crate::passes::Physics;
use etalon_kernels_gen::Vector;
use serde::{Deserialize, Serialize};
use std::f64::consts::{PI, TAU};

/// When the paper looks (GS25 Fig. 4).
pub const END_TIME: f64 = 1.0;
/// Where errors are measured (GS25 section 3.3).
pub const MEASURED: (f64, f64) = (0.0, 0.5);
/// The depth of the paper's box (GS25 Table 2).
pub const DEPTH: f64 = 0.5;
/// The adiabatic index (GS25 section 3).
const GAMMA: f64 = 5.0 / 3.0;
/// Half of the box, whose sides are 1 (GS25 Table 2).
const HALF: f64 = 0.5;
/// Fewer show no vortex.
const LEAST: usize = 100;
/// The axis.
const CENTRE: [f64; 2] = [0.0; 2];

/// The vortex: what is a choice of the problem.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct GreshoChan {
    /// How it is computed.
    #[serde(skip)]
    pub method: Method,
    /// How deep the box is in three dimensions.
    pub depth: f64,
    /// The adiabatic index.
    pub gamma: f64,
}

impl Default for GreshoChan {
    fn default() -> Self {
        Self::standard(2)
    }
}

impl GreshoChan {
    fn block<const D: usize>(&self) -> Block<D> {
        let end = |sign: f64| std::array::from_fn(|axis| sign * if axis < 2 { HALF } else { 0.5 * self.depth });
        Block { lower: end(-1.0), upper: end(1.0) }
    }

    /// The volume along z that sums over particles stand for: the depth in three dimensions, one in two.
    fn length<const D: usize>(&self) -> f64 {
        if D > 2 { self.depth } else { 1.0 }
    }

    /// The vortex as a function of the distance from its axis.
    pub fn steady(&self) -> impl Solution + use<> {
        Vortex { gamma_minus_one: self.gamma - 1.0 }
    }

    /// Its angular momentum, $2\pi \rho_0 v_0 a^3 \cdot 7/6$ per depth, with `a` the radius of the largest velocity.
    pub fn angular_momentum<const D: usize>(&self) -> f64 {
        TAU * DENSITY * VELOCITY * RADIUS.powi(3) * (7.0 / 6.0) * self.length::<D>()
    }

    /// Its kinetic energy, $\pi \rho_0 v_0^2 a^2 \cdot 2/3$ per depth.
    pub fn kinetic_energy<const D: usize>(&self) -> f64 {
        PI * DENSITY * VELOCITY * VELOCITY * RADIUS * RADIUS * (2.0 / 3.0) * self.length::<D>()
    }
}

impl Definition for GreshoChan {
    const TITLE: &'static str = "Gresho-Chan vortex";
    const SOURCE: &'static str = "GS25, section 3.3";
    const DIMENSIONS: &'static [usize] = &[2, 3];
    const SOLUTION: &'static str = "the vortex itself, which is steady";

    fn standard(dimension: usize) -> Self {
        let method = Method::standard(dimension, if dimension == 2 { 5_000 } else { 14_000 });
        GreshoChan { method, depth: DEPTH, gamma: GAMMA }
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

impl<const D: usize> Scene<D> for GreshoChan {
    fn method(&self) -> &Method {
        &self.method
    }
    fn physics(&self) -> Physics {
        self.method.physics(self.gamma)
    }
    fn check(&self) -> Result<(), SceneError> {
        SceneError::unless_in::<Self>("gresho-chan", D)?;
        SceneError::unless_above("depth", self.depth, 0.0)?;
        SceneError::unless_above("gamma", self.gamma, 1.0)?;
        self.method.check(D)?;
        self.block::<D>().check_room(&self.method, [true; D], LEAST, 1.0)
    }
    fn particles(&self, glasses: &mut Glasses<D>) -> Result<ParticleSet<D>, SceneError> {
        Scene::<D>::check(self)?;
        let block = self.block::<D>();
        let filling = block.filled(&self.method, self.method.particles, glasses)?;
        let h = self.method.smoothing_length(D, filling.volume);
        let particles = filling.places.iter().map(|&position| {
            let gas = gresho_chan::<f64, D>(Vector(position));
            Particle {
                position,
                velocity: gas.velocity.0,
                mass: gas.density * filling.volume,
                smoothing_length: h,
                internal_energy: gas.pressure / ((self.gamma - 1.0) * gas.density),
                mobile: true,
            }
        });
        Ok(ParticleSet::new(Domain::new(block.lower, block.upper, [true; D])?, particles.collect())?)
    }
    fn view(&self) -> View {
        View::Azimuth(CENTRE)
    }
    fn shown(&self) -> (f64, f64) {
        MEASURED
    }
    fn measured(&self, _: f64) -> Measured {
        Measured { range: MEASURED, source: "GS25, section 3.3" }
    }
    fn solution(&self, _: f64) -> Result<Option<Box<dyn Solution>>, SceneError> {
        Ok(Some(Box::new(self.steady())))
    }
    fn given_momentum(&self, _: f64) -> GivenMomentum {
        GivenMomentum::None
    }
    fn quantities(&self) -> Vec<Quantity> {
        let steady = "the steady vortex";
        vec![
            Quantity {
                name: "l1_azimuthal_velocity",
                label: "error of the azimuthal velocity",
                symbol: "L₁(v_φ)",
                unit: "L T^-1",
                expected: Some((0.0, steady)),
            },
            Quantity {
                name: "angular_momentum",
                label: "angular momentum",
                symbol: "L_z",
                unit: "M L^2 T^-1",
                expected: Some((self.angular_momentum::<D>(), steady)),
            },
            Quantity {
                name: "kinetic_energy",
                label: "kinetic energy",
                symbol: "E_kin",
                unit: "M L^2 T^-2",
                expected: Some((self.kinetic_energy::<D>(), steady)),
            },
        ]
    }
    fn observe(&self, state: &State) -> Result<Vec<f64>, SceneError> {
        Ok(vec![
            state.l1(View::Azimuth(CENTRE), &self.steady(), Compared::Velocity, MEASURED)?,
            state.angular_momentum(CENTRE),
            state.kinetic_energy(),
        ])
    }
    fn description(&self) -> Description {
        let mut settings = vec![
            ("Density".into(), DENSITY.to_string()),
            ("Largest velocity, at radius".into(), format!("{VELOCITY}, {RADIUS}")),
            ("Pressure on the axis".into(), CENTRAL_PRESSURE.to_string()),
        ];
        if D > 2 {
            settings.push(("Depth of the box".into(), self.depth.to_string()));
        }
        Description {
            start: "a vortex in balance: its pressure holds it together".into(),
            boundaries: "periodic; at rest there".into(),
            settings,
        }
    }
}

struct Vortex {
    gamma_minus_one: f64,
}

impl Solution for Vortex {
    fn at(&self, r: f64) -> [f64; 4] {
        let psi = r / RADIUS;
        let pressure = vortex_pressure(psi, CENTRAL_PRESSURE, DENSITY, VELOCITY);
        [DENSITY, vortex_velocity(psi, VELOCITY), pressure, pressure / (self.gamma_minus_one * DENSITY)]
    }
    fn corners(&self) -> Vec<f64> {
        vec![RADIUS, 2.0 * RADIUS]
    }
}
