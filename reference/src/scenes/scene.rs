//! What every scene is asked.

use super::{AtEnd, Course, GlassError, Method, SceneError, State, View};
use crate::particles::ParticleSet;
use crate::passes::Physics;
use crate::turbulence::forcing::Forcing;
use etalon_kernels_gen::Field;

/// Gives a relaxed periodic cube of `across^D` particles.
pub type Glasses<'a, const D: usize> = dyn FnMut(usize) -> Result<Vec<[f64; D]>, GlassError> + 'a;

/// A problem that can be run in `D` dimensions.
pub trait Scene<const D: usize>: Send + Sync {
    /// How it is computed.
    fn method(&self) -> &Method;
    /// What all passes are told.
    fn physics(&self) -> Physics;
    /// Refuses choices that make no sense, before any particle exists.
    fn check(&self) -> Result<(), SceneError>;
    /// The initial particles.
    fn particles(&self, glasses: &mut Glasses<D>) -> Result<ParticleSet<D>, SceneError>;
    /// Along what it is looked at.
    fn view(&self) -> View;
    /// The range of the coordinate that is drawn.
    fn shown(&self) -> (f64, f64);
    /// Where errors are measured.
    fn measured(&self, time: f64) -> Measured;
    /// What it is compared with at a time; none where there is no solution.
    fn solution(&self, time: f64) -> Result<Option<Box<dyn Solution>>, SceneError>;
    /// Until when box and solution hold; a later end is refused with the reason.
    fn last_time(&self) -> (f64, &'static str) {
        (f64::INFINITY, "")
    }
    /// What momentum particles are given from outside until a time.
    fn given_momentum(&self, time: f64) -> GivenMomentum;
    /// The force that stirs the gas, where one does.
    fn forcing(&self) -> Result<Option<Forcing<D>>, SceneError> {
        Ok(None)
    }
    /// What is measured while it runs.
    fn quantities(&self) -> Vec<Quantity> {
        Vec::new()
    }
    /// The values of the [`Self::quantities`], in their order.
    fn observe(&self, state: &State) -> Result<Vec<f64>, SceneError> {
        let _ = state;
        Ok(Vec::new())
    }
    /// The same where it takes the start to tell; what a run calls, with the state it started from.
    fn observe_since(&self, start: &State, now: &State) -> Result<Vec<f64>, SceneError> {
        let _ = start;
        self.observe(now)
    }
    /// Scalar fields beside a state's usual ones that measuring asks for; [`State::read_for`] reads them.
    fn further_fields(&self) -> &'static [Field] {
        &[]
    }
    /// What is measured at the end alone.
    fn quantities_at_end(&self) -> Vec<Quantity> {
        Vec::new()
    }
    /// The values of the [`Self::quantities_at_end`], in their order, and curves.
    fn at_end(&self, course: &Course) -> Result<AtEnd, SceneError> {
        let _ = course;
        Ok(AtEnd::default())
    }
    /// In words, for the report.
    fn description(&self) -> Description;
}

/// Where errors are measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// The closed range of the coordinate.
    pub range: (f64, f64),
    /// Where it is stated.
    pub source: &'static str,
}

/// Density, velocity, pressure and internal energy as functions of the scene's coordinate.
pub trait Solution: Send + Sync {
    /// At a place.
    fn at(&self, coordinate: f64) -> [f64; 4];
    /// Places where a drawn line has corners.
    fn corners(&self) -> Vec<f64> {
        Vec::new()
    }
    /// Places where it jumps.
    fn jumps(&self) -> Vec<f64> {
        Vec::new()
    }
}

/// What momentum particles get from outside.
#[derive(Clone, Debug, PartialEq)]
pub enum GivenMomentum {
    /// None: the sum is conserved along every axis.
    None,
    /// So much along one axis, none along the others.
    Along {
        /// The axis.
        axis: usize,
        /// How much.
        momentum: f64,
        /// By what, in a clause.
        by: String,
    },
    /// It cannot be told beforehand.
    Unknown(String),
}

/// What is measured while a scene runs.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    /// As a column is named: lower-case letters, digits and `_`.
    pub name: &'static str,
    /// For people.
    pub label: &'static str,
    /// Its symbol.
    pub symbol: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// What it should be at the end, with where that is from.
    pub expected: Option<(f64, &'static str)>,
}

/// A scene in words.
#[derive(Clone, Debug, PartialEq)]
pub struct Description {
    /// What is special about the start.
    pub start: String,
    /// What happens at each boundary.
    pub boundaries: String,
    /// Names and values of what else a reader needs.
    pub settings: Vec<(String, String)>,
}
