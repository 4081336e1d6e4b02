//! Shock tubes with any two gases, and the two hard ones among Toro's: a jump of 10^5 in pressure, and gases that fly apart until next to nothing is left.

use super::scene::{Description, GivenMomentum, Glasses, Measured, Quantity, Scene, Solution};
use super::shock_tube::ShockTube;
use super::{AtEnd, Course, Definition, Method, SceneError, View};
use crate::exact::riemann::State;
use crate::particles::ParticleSet;
use crate::passes::Physics;
use serde::{Deserialize, Serialize};
use std::fmt::Debug;
use std::marker::PhantomData;

/// The adiabatic index of Toro's tests.
const GAMMA: f64 = 1.4;
/// The width in two and three dimensions: as Sod's (GS25 Table 2).
const WIDTH: f64 = super::sod::WIDTH;
/// Where errors are measured: not quite to the ends.
const MEASURED: (f64, f64) = (0.05, 0.95);
/// How near to an end the two gases may meet.
const NEAREST: f64 = 0.1;

/// A gas at one side of a tube.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Gas {
    /// Density.
    pub density: f64,
    /// Velocity along the tube; where it is zero the end is a fixed layer.
    pub velocity: f64,
    /// Pressure.
    pub pressure: f64,
}

/// What tells one tube from another: its standard choices.
pub trait Kind: Copy + Debug + PartialEq + Send + Sync + 'static {
    /// Its word.
    const NAME: &'static str;
    /// For people.
    const TITLE: &'static str;
    /// From where.
    const SOURCE: &'static str;
    /// The gas left and right.
    const GASES: [Gas; 2];
    /// Where they meet.
    const INTERFACE: f64;
    /// When one looks.
    const END_TIME: f64;
}

/// Toro's first test: Sod's tube with gas that flows in at the left, so that the fan passes the speed of sound.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sonic;
/// Toro's third test: the left half of the double blast, a pressure 10^5 times as high.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StrongShock;
/// Toro's second test, "123": gases that fly apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearVacuum;

const fn gas(density: f64, velocity: f64, pressure: f64) -> Gas {
    Gas { density, velocity, pressure }
}

impl Kind for Sonic {
    const NAME: &'static str = "tube";
    const TITLE: &'static str = "Shock tube of two gases";
    const SOURCE: &'static str = "Toro 2009, section 6.4, test 1";
    const GASES: [Gas; 2] = [gas(1.0, 0.75, 1.0), gas(0.125, 0.0, 0.1)];
    const INTERFACE: f64 = 0.3;
    const END_TIME: f64 = 0.2;
}
impl Kind for StrongShock {
    const NAME: &'static str = "strong-shock";
    const TITLE: &'static str = "Shock tube with a jump of 10⁵";
    const SOURCE: &'static str = "Toro 2009, section 6.4, test 3";
    const GASES: [Gas; 2] = [gas(1.0, 0.0, 1000.0), gas(1.0, 0.0, 0.01)];
    const INTERFACE: f64 = 0.5;
    const END_TIME: f64 = 0.012;
}
impl Kind for NearVacuum {
    const NAME: &'static str = "vacuum";
    const TITLE: &'static str = "Gases that fly apart";
    const SOURCE: &'static str = "Toro 2009, section 6.4, test 2";
    const GASES: [Gas; 2] = [gas(1.0, -2.0, 0.4), gas(1.0, 2.0, 0.4)];
    const INTERFACE: f64 = 0.5;
    const END_TIME: f64 = 0.15;
}

/// A tube: what is a choice of the problem.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, bound = "")]
pub struct GasTube<K: Kind> {
    /// How it is computed.
    #[serde(skip)]
    pub method: Method,
    /// The gas on the left.
    pub left: Gas,
    /// The gas on the right.
    pub right: Gas,
    /// Where they meet, in a tube from 0 to 1.
    pub interface: f64,
    /// The adiabatic index.
    pub gamma: f64,
    #[serde(skip)]
    kind: PhantomData<K>,
}

impl<K: Kind> Default for GasTube<K> {
    fn default() -> Self {
        Self::standard(1)
    }
}

impl<K: Kind> GasTube<K> {
    fn gases(&self) -> [Gas; 2] {
        [self.left, self.right]
    }
    fn tube(&self) -> ShockTube {
        let state = |gas: Gas| State { density: gas.density, velocity: gas.velocity, pressure: gas.pressure };
        ShockTube {
            method: self.method,
            states: self.gases().map(state),
            gamma: self.gamma,
            interface: self.interface,
            width: WIDTH,
            end_time: K::END_TIME,
        }
    }
}

impl<K: Kind> Definition for GasTube<K> {
    const TITLE: &'static str = K::TITLE;
    const SOURCE: &'static str = K::SOURCE;
    const DIMENSIONS: &'static [usize] = &[1, 2, 3];
    const SOLUTION: &'static str = "Riemann problem";

    fn standard(dimension: usize) -> Self {
        let method = Method::standard(dimension, [450, 6_000, 14_000][dimension - 1]);
        let [left, right] = K::GASES;
        GasTube { method, left, right, interface: K::INTERFACE, gamma: GAMMA, kind: PhantomData }
    }
    fn end_time(&self) -> f64 {
        K::END_TIME
    }
    fn method(&self) -> &Method {
        &self.method
    }
    fn method_mut(&mut self) -> &mut Method {
        &mut self.method
    }
}

impl<K: Kind, const D: usize> Scene<D> for GasTube<K> {
    fn method(&self) -> &Method {
        &self.method
    }
    fn physics(&self) -> Physics {
        self.method.physics(self.gamma)
    }
    fn check(&self) -> Result<(), SceneError> {
        SceneError::unless_in::<Self>(K::NAME, D)?;
        SceneError::unless_above("gamma", self.gamma, 1.0)?;
        for (name, gas) in [("left", self.left), ("right", self.right)] {
            // Particles cannot be made of nothing.
            if !(gas.density > 0.0
                && gas.pressure > 0.0
                && [gas.density, gas.velocity, gas.pressure].iter().all(|x| x.is_finite()))
            {
                let rule = "density and pressure must be positive, and all three finite".into();
                return Err(SceneError::Choice { name, given: format!("{gas:?}"), rule });
            }
        }
        if !(NEAREST..=1.0 - NEAREST).contains(&self.interface) {
            let rule = format!("give a place from {NEAREST} to {}", 1.0 - NEAREST);
            return Err(SceneError::Choice { name: "interface", given: self.interface.to_string(), rule });
        }
        self.tube().exact().map_err(|error| SceneError::Solution(error.to_string()))?;
        self.method.check(D)?;
        self.tube().check_room::<D>()
    }
    fn particles(&self, glasses: &mut Glasses<D>) -> Result<ParticleSet<D>, SceneError> {
        Scene::<D>::check(self)?;
        let pressure = self.gases().map(|gas| gas.pressure);
        self.tube().particles(|side, _| pressure[side], glasses)
    }
    fn view(&self) -> View {
        View::Along(0)
    }
    fn shown(&self) -> (f64, f64) {
        (0.0, 1.0)
    }
    fn measured(&self, _: f64) -> Measured {
        Measured { range: MEASURED, source: "ours: all but a twentieth at each end" }
    }
    fn solution(&self, time: f64) -> Result<Option<Box<dyn Solution>>, SceneError> {
        let exact = self.tube().exact().map_err(|error| SceneError::Solution(error.to_string()))?;
        Ok(Some(Box::new(self.tube().solution(exact, time))))
    }
    fn last_time(&self) -> (f64, &'static str) {
        self.tube().last_time::<D>()
    }
    fn given_momentum(&self, time: f64) -> GivenMomentum {
        self.tube().given_momentum::<D>(time)
    }
    fn quantities_at_end(&self) -> Vec<Quantity> {
        self.tube().quantities_at_end()
    }
    fn at_end(&self, course: &Course) -> Result<AtEnd, SceneError> {
        self.tube().at_end(course.end)
    }
    fn description(&self) -> Description {
        let pair = |of: fn(Gas) -> f64| format!("{}, {}", of(self.left), of(self.right));
        let end = |gas: Gas| if gas.velocity == 0.0 { "a fixed layer" } else { "more of the gas, which moves with it" };
        Description {
            start: "sharp".into(),
            boundaries: format!(
                "left {}, right {}{}",
                end(self.left),
                end(self.right),
                if D > 1 { "; periodic across the tube" } else { "" }
            ),
            settings: vec![
                ("Density, left and right".into(), pair(|gas| gas.density)),
                ("Velocity, left and right".into(), pair(|gas| gas.velocity)),
                ("Pressure, left and right".into(), pair(|gas| gas.pressure)),
                ("Where they meet".into(), self.interface.to_string()),
            ],
        }
    }
}
