//! Two blast waves that collide between reflecting walls (Woodward & Colella 1984): pressure jumps of 1e5 and 1e4 in even gas at rest.
//!
//! In one dimension. There is no closed solution; the reference is a converged finite-volume one.

use super::mirror::mirrored;
use super::scene::{Description, GivenMomentum, Glasses, Measured, Quantity, Scene, Solution};
use super::{Block, Definition, Method, SceneError, State, View};
use crate::domain::Domain;
use crate::exact::finite_volume::{End, FiniteVolume, FiniteVolumeError};
use crate::exact::riemann::State as Gas;
use crate::particles::{Particle, ParticleSet};
use crate::passes::Physics;
use serde::{Deserialize, Serialize};

/// The gas's density (Woodward & Colella 1984).
pub const DENSITY: f64 = 1.0;
/// Pressure left, in the middle and right (Woodward & Colella 1984).
pub const PRESSURE: [f64; 3] = [1000.0, 0.01, 100.0];
/// Where they meet (Woodward & Colella 1984).
pub const INTERFACES: [f64; 2] = [0.1, 0.9];
/// The adiabatic index (Woodward & Colella 1984).
pub const GAMMA: f64 = 1.4;
/// When one looks (Woodward & Colella 1984).
pub const END_TIME: f64 = 0.038;
/// Where errors are measured: between the walls.
pub const MEASURED: (f64, f64) = (0.0, 1.0);
/// Fewer show no waves.
const LEAST: usize = 40;

/// Cells of the finite-volume solution.
const CELLS: usize = 1600;

/// The two blasts. They have no choices of their own.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct DoubleBlast {
    /// How it is computed.
    #[serde(skip)]
    pub method: Method,
}

impl Default for DoubleBlast {
    fn default() -> Self {
        Self::standard(1)
    }
}

impl DoubleBlast {
    /// The same with another method.
    pub fn with(mut self, change: impl FnOnce(&mut Method)) -> Self {
        change(&mut self.method);
        self
    }
}

/// The finite-volume solution at one time.
struct Blasts(FiniteVolume);

impl Solution for Blasts {
    fn at(&self, x: f64) -> [f64; 4] {
        // Beyond the wall that reflects lies the mirror image.
        let mirror = x > 1.0;
        let Gas { density, velocity, pressure } = self.0.at(if mirror { 2.0 - x } else { x });
        let velocity = if mirror { -velocity } else { velocity };
        [density, velocity, pressure, pressure / ((GAMMA - 1.0) * density)]
    }
}

impl Definition for DoubleBlast {
    const TITLE: &'static str = "Two blast waves that collide";
    const SOURCE: &'static str = "Woodward & Colella 1984";
    const DIMENSIONS: &'static [usize] = &[1];
    const SOLUTION: &'static str = "finite volumes";

    fn standard(dimension: usize) -> Self {
        DoubleBlast { method: Method::standard(dimension, 400) }
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

impl<const D: usize> Scene<D> for DoubleBlast {
    fn method(&self) -> &Method {
        &self.method
    }
    fn physics(&self) -> Physics {
        self.method.physics(GAMMA)
    }
    fn check(&self) -> Result<(), SceneError> {
        SceneError::unless_in::<Self>("double-blast", D)?;
        self.method.check(D)?;
        self.method.check_number(D, LEAST, |_| true)
    }
    /// The gas and its mirror image.
    fn particles(&self, glasses: &mut Glasses<D>) -> Result<ParticleSet<D>, SceneError> {
        Scene::<D>::check(self)?;
        let block = Block { lower: [0.0; D], upper: [1.0; D] };
        let filling = block.filled(&self.method, self.method.particles, glasses)?;
        let particle = |&position: &[f64; D]| Particle {
            position,
            velocity: [0.0; D],
            mass: DENSITY * filling.volume,
            smoothing_length: self.method.smoothing_length(D, filling.volume),
            internal_energy: start(position[0]).pressure / ((GAMMA - 1.0) * DENSITY),
            mobile: true,
        };
        let domain = Domain::new(block.lower, block.upper, [false; D])?;
        let set = ParticleSet::new(domain, filling.places.iter().map(particle).collect())?;
        mirrored(&set, 0).map_err(|error| SceneError::Given(error.to_string()))
    }
    fn view(&self) -> View {
        View::Along(0)
    }
    fn shown(&self) -> (f64, f64) {
        (0.0, 1.0)
    }
    fn measured(&self, _: f64) -> Measured {
        Measured { range: MEASURED, source: "between the walls" }
    }
    fn solution(&self, time: f64) -> Result<Option<Box<dyn Solution>>, SceneError> {
        let gas = reference(CELLS, time).map_err(|error| SceneError::Solution(error.to_string()))?;
        Ok(Some(Box::new(Blasts(gas))))
    }
    fn given_momentum(&self, _: f64) -> GivenMomentum {
        GivenMomentum::None
    }
    fn quantities(&self) -> Vec<Quantity> {
        vec![Quantity {
            name: "maximum_density",
            label: "largest density",
            symbol: "ρ_max",
            unit: "M L^-ν",
            expected: None,
        }]
    }
    fn observe(&self, state: &State) -> Result<Vec<f64>, SceneError> {
        Ok(vec![state.moving().map(|i| state.density[i]).fold(0.0, f64::max)])
    }
    fn description(&self) -> Description {
        Description {
            start: "at rest, with jumps of the pressure at x = 0.1 and 0.9".into(),
            boundaries: "reflecting: the mirror image beside it is computed too".into(),
            settings: vec![
                ("Density".into(), DENSITY.to_string()),
                ("Pressure".into(), PRESSURE.map(|p| p.to_string()).join(", ")),
            ],
        }
    }
}

/// The gas at the start.
fn start(x: f64) -> Gas<f64> {
    let side = INTERFACES.iter().filter(|interface| x > **interface).count();
    Gas { density: DENSITY, velocity: 0.0, pressure: PRESSURE[side] }
}

/// The flow at a time, by finite volumes in so many cells.
///
/// # Errors
/// As [`FiniteVolume::new`] and [`FiniteVolume::run`].
pub fn reference(cells: usize, time: f64) -> Result<FiniteVolume, FiniteVolumeError> {
    let mut gas = FiniteVolume::new(1, GAMMA, (0.0, 1.0), cells, [End::Wall; 2], start)?;
    gas.run(time)?;
    Ok(gas)
}
