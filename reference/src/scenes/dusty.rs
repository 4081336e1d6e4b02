//! Gas with dust (PL20 section 3) as scenes: the box, the wave and the tube, with the choices that they share.
//!
//! Errors and profiles are those of the gas; what the dust does is among what is measured on the way.

use super::gas_and_dust::{KERNEL, usual_neighbours};
use super::scene::{Description, GivenMomentum, Glasses, Measured, Quantity, Scene, Solution};
use super::{Definition, DustySceneError, Method, SceneError, State, View};
use crate::diagnostics::front_width::front_width;
use crate::particles::ParticleSet;
use crate::passes::Physics;
use crate::schemes::{CommonPoint, Drag, DragReconstruction, DragSigns, SlopeLimiter};
use serde::{Deserialize, Serialize};
use std::marker::PhantomData;

mod kinds;
pub use kinds::{InABox, InATube, InAWave};

/// Gas and dust of one kind of problem: the choices that all three have.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, bound = "P: Kind")]
pub struct Dusty<P: Kind> {
    /// How it is computed. Kernel and neighbours are those of either species.
    #[serde(skip)]
    pub method: Method,
    /// The drag coefficient `K`.
    pub drag_coefficient: f64,
    /// Where velocities of gas and dust are compared; `particles` is no reconstruction.
    pub common_point: CommonPoint,
    /// How slopes are limited.
    pub limiter: SlopeLimiter,
    /// Whether the raw velocity difference is taken where the reconstructed one would cool the gas.
    pub entropy_fix: bool,
    /// Density of the dust over that of the gas.
    pub dust_to_gas: f64,
    /// The adiabatic index.
    pub gamma: f64,
    #[serde(skip)]
    kind: PhantomData<P>,
}

/// What tells the problems apart.
pub trait Kind: Clone + Default + PartialEq + std::fmt::Debug + Send + Sync + 'static {
    /// On the command line.
    const NAME: &'static str;
    /// For people.
    const TITLE: &'static str;
    /// Paper and section.
    const SOURCE: &'static str;
    /// What it is compared with.
    const SOLUTION: &'static str;
    /// The drag coefficient.
    const DRAG: f64;
    /// When to look.
    const END_TIME: f64;
    /// How many particles, of both species together, in each dimension.
    const PARTICLES: [usize; 3];
    /// In words.
    const START: &'static str;
    /// In words.
    const BOUNDARIES: &'static str;

    /// The initial particles.
    fn particles<const D: usize>(scene: &Dusty<Self>) -> Result<ParticleSet<D>, DustySceneError>;
    /// The solution: that of the gas, and the velocity of the dust.
    fn solution(scene: &Dusty<Self>, time: f64) -> Result<GasAndDust, DustySceneError>;
    /// Where errors are measured.
    const MEASURED: (f64, f64) = (0.0, 1.0);
    /// Whether walls push: the momentum along x by then.
    fn pushed(_: &Dusty<Self>, _: f64) -> bool {
        false
    }
    /// The velocity behind a shock that runs into gas at rest, where there is one.
    fn behind_shock(_: &Dusty<Self>) -> Option<f64> {
        None
    }
}

type Profile<T> = Box<dyn Fn(f64) -> T + Send + Sync>;

/// A solution for two species.
pub struct GasAndDust {
    gas: Profile<[f64; 4]>,
    dust_velocity: Profile<f64>,
    jumps: Vec<f64>,
}

impl Solution for GasAndDust {
    fn at(&self, x: f64) -> [f64; 4] {
        (self.gas)(x)
    }
    fn jumps(&self) -> Vec<f64> {
        self.jumps.clone()
    }
}

impl<P: Kind> Dusty<P> {
    /// The same with another method.
    pub fn with(mut self, change: impl FnOnce(&mut Method)) -> Self {
        change(&mut self.method);
        self
    }

    fn drag(&self) -> Drag {
        Drag {
            coefficient: self.drag_coefficient,
            signs: DragSigns::Physical,
            reconstruction: DragReconstruction { point: self.common_point, limiter: self.limiter },
            entropy_fix: self.entropy_fix,
        }
    }

    /// Particles of one species along x, if so many lie along each other axis.
    fn along(&self, dimension: usize, rows: usize) -> usize {
        (self.method.particles as f64 / (2 * rows.pow(dimension as u32 - 1)) as f64).round() as usize
    }
}

impl<P: Kind> Default for Dusty<P> {
    fn default() -> Self {
        Self::standard(1)
    }
}

impl<P: Kind> Definition for Dusty<P> {
    const TITLE: &'static str = P::TITLE;
    const SOURCE: &'static str = P::SOURCE;
    const DIMENSIONS: &'static [usize] = &[1, 2, 3];
    const SOLUTION: &'static str = P::SOLUTION;

    fn standard(dimension: usize) -> Self {
        let usual = Method::standard(dimension, P::PARTICLES[dimension - 1]);
        let DragReconstruction { point, limiter } = DragReconstruction::RECOMMENDED;
        Dusty {
            method: Method { kernel: KERNEL, neighbours: usual_neighbours(dimension), ..usual },
            drag_coefficient: P::DRAG,
            common_point: point,
            limiter,
            entropy_fix: false,
            dust_to_gas: 1.0,
            gamma: 5.0 / 3.0,
            kind: PhantomData,
        }
    }
    fn end_time(&self) -> f64 {
        P::END_TIME
    }
    fn method(&self) -> &Method {
        &self.method
    }
    fn method_mut(&mut self) -> &mut Method {
        &mut self.method
    }
}

impl<P: Kind, const D: usize> Scene<D> for Dusty<P> {
    fn method(&self) -> &Method {
        &self.method
    }
    fn physics(&self) -> Physics {
        Physics { drag: Some(self.drag()), ..self.method.physics(self.gamma) }
    }
    fn check(&self) -> Result<(), SceneError> {
        SceneError::unless_in::<Self>(P::NAME, D)?;
        self.method.check(D)?;
        SceneError::unless_above("gamma", self.gamma, 1.0)?;
        SceneError::unless_above("dust_to_gas", self.dust_to_gas, 0.0)?;
        if !(self.drag_coefficient.is_finite() && self.drag_coefficient >= 0.0) {
            let rule = "give a finite number that is not negative".into();
            return Err(SceneError::Choice {
                name: "drag_coefficient",
                given: self.drag_coefficient.to_string(),
                rule,
            });
        }
        P::solution(self, P::END_TIME).map_err(refused)?;
        // Many particles cost time to lay out; whether a number is enough shows with as many as leave room at all.
        let fits = |particles: usize| P::particles::<D>(&self.clone().with(|m| m.particles = particles)).is_ok();
        match P::particles::<D>(self) {
            Ok(_) => Ok(()),
            Err(DustySceneError::TooFew { .. }) => self.method.check_number(D, 1, fits),
            Err(other) => Err(refused(other)),
        }
    }
    fn particles(&self, _: &mut Glasses<D>) -> Result<ParticleSet<D>, SceneError> {
        Scene::<D>::check(self)?;
        P::particles::<D>(self).map_err(refused)
    }
    fn view(&self) -> View {
        View::Along(0)
    }
    fn shown(&self) -> (f64, f64) {
        (0.0, 1.0)
    }
    fn measured(&self, _: f64) -> Measured {
        Measured { range: P::MEASURED, source: "PL20, section 3; the whole problem" }
    }
    fn solution(&self, time: f64) -> Result<Option<Box<dyn Solution>>, SceneError> {
        Ok(Some(Box::new(P::solution(self, time).map_err(refused)?)))
    }
    fn given_momentum(&self, time: f64) -> GivenMomentum {
        match P::pushed(self, time) {
            true => GivenMomentum::Unknown("the fixed layers push the gas, and hold the dust that meets them".into()),
            false => GivenMomentum::None,
        }
    }
    fn quantities(&self) -> Vec<Quantity> {
        let quantity = |name, label, symbol, unit| Quantity { name, label, symbol, unit, expected: None };
        let mut all = vec![
            quantity("kinetic_energy", "kinetic energy of gas and dust", "E_kin", "M L^(2-ν) T^-2"),
            quantity("l1_gas_velocity", "error of the gas's velocity", "L₁(v_g)", "L T^-1"),
            quantity("l1_dust_velocity", "error of the dust's velocity", "L₁(v_d)", "L T^-1"),
        ];
        let shock = quantity("shock_width", "width of the shock in the gas, in smoothing lengths", "w/h", "");
        all.extend(P::behind_shock(self).map(|_| shock));
        all
    }
    fn observe(&self, state: &State) -> Result<Vec<f64>, SceneError> {
        let gas_at = |i: usize| [state.position[0][i], state.velocity[0][i], state.smoothing_length[i]];
        // Zero until there is a front.
        let width = P::behind_shock(self).map(|v| front_width(state.moving_gas().map(gas_at), v).unwrap_or(0.0));
        // Nothing has moved at the start, where a shock's similarity has no meaning.
        if state.time <= 0.0 {
            return Ok([state.kinetic_energy(), 0.0, 0.0].into_iter().chain(width).collect());
        }
        let exact = P::solution(self, state.time).map_err(refused)?;
        let mean = |dust: bool, due: &dyn Fn(f64) -> f64| {
            let of = |i: &usize| state.species.get(*i).is_some_and(|species| *species > 0.5) == dust;
            let inside = |i: &usize| (P::MEASURED.0..=P::MEASURED.1).contains(&state.position[0][*i]);
            let errors: Vec<f64> = state
                .moving()
                .filter(of)
                .filter(inside)
                .map(|i| (state.velocity[0][i] - due(state.position[0][i])).abs())
                .collect();
            errors.iter().sum::<f64>() / errors.len().max(1) as f64
        };
        let gas = mean(false, &|x| (exact.gas)(x)[1]);
        let dust = mean(true, &|x| (exact.dust_velocity)(x));
        Ok([state.kinetic_energy(), gas, dust].into_iter().chain(width).collect())
    }
    fn description(&self) -> Description {
        Description {
            start: P::START.into(),
            boundaries: P::BOUNDARIES.into(),
            settings: vec![
                ("Drag coefficient".into(), self.drag_coefficient.to_string()),
                ("Velocities compared at".into(), self.common_point.to_string()),
                ("Slope limiter".into(), self.limiter.to_string()),
                ("Dust over gas".into(), self.dust_to_gas.to_string()),
            ],
        }
    }
}

fn refused(error: DustySceneError) -> SceneError {
    match error {
        DustySceneError::Particles(error) => SceneError::Particles(error),
        other => SceneError::Given(other.to_string()),
    }
}
