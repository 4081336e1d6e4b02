//! Whether an engine of single precision follows the reference through time.
//!
//! A flow magnifies every rounding error, and by how much is measured: the scalar reference runs in single precision too, and its
//! distance from the run in double precision is the response. An engine does the same operations. Where its target rounds otherwise its
//! errors are of the same size; only divisions may be 2.5 units in the last place off instead of half a unit. Two independent
//! errors, one five times the other: an engine's distance from the reference is allowed `sqrt(1 + 5^2)` times the response, in the root
//! mean square. Its places are kept to 2^-32 of the box, those of the reference far better: half a step of that grid for each time
//! step comes on top.
//!
//! In double precision this would not do: there the grid of places, 2^-53 of the box, disturbs a flow more than the roundings of numbers
//! do, and a scalar run has none to measure its effect by.

use crate::domain::{SINGLE_PLACES, separation};
use crate::engine::{Engine, EngineError, PlainEngine};
use crate::fields;
use crate::particles::ParticleSet;
use crate::passes::Physics;
use crate::simulation::Simulation;
use etalon_kernels_gen::Field;
use std::fmt;

/// `sqrt(1 + 5^2)`, rounded up: how far apart two computations may be of which one divides five times as badly as the other.
pub const FACTOR: f64 = 5.1;

/// Half the spacing of places, in sides of the torus.
const HALF_GRID_STEP: f64 = 0.5 / SINGLE_PLACES;

/// Fewer steps show nothing.
const FEWEST_STEPS: u64 = 3;

/// What is compared, besides places.
const COMPARED: [Field; 6] = [
    fields::VELOCITY,
    fields::INTERNAL_ENERGY,
    fields::SMOOTHING_LENGTH,
    fields::DENSITY,
    fields::ACCELERATION,
    fields::ENERGY_RATE,
];

/// How one field compares at the end of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Distance {
    /// The field, or the axis of a place.
    pub what: String,
    /// Root of the mean square difference to the reference.
    pub error: f64,
    /// What it may be.
    pub tolerance: f64,
}

impl Distance {
    /// Whether it is within the tolerance; NaN is not.
    pub fn holds(&self) -> bool {
        self.error <= self.tolerance
    }
}

impl fmt::Display for Distance {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let share = if self.error > 0.0 { 100.0 * self.error / self.tolerance } else { 0.0 };
        write!(f, "{}: rms error {:.2e}, tolerance {:.2e}, {share:.0} % of it", self.what, self.error, self.tolerance)
    }
}

/// Runs the scene to `until` on `engine`, which must hold the particles of `set`, and on the reference in both precisions.
///
/// An engine that takes another number of steps is an error, and so is a run of fewer than three.
pub fn check_run<const D: usize, E: Engine<D>>(
    set: &ParticleSet<D>,
    physics: Physics,
    engine: E,
    until: f64,
) -> Result<Vec<Distance>, EngineError> {
    let mut exact = run(PlainEngine::<f64, D>::new(set), physics, until)?;
    let mut single = run(PlainEngine::<f32, D>::new(set), physics, until)?;
    let mut found = run(engine, physics, until)?;
    let steps = exact.steps();
    if found.steps() != steps || steps < FEWEST_STEPS {
        return Err(EngineError(format!("{} steps where the reference takes {steps}", found.steps())));
    }
    let mut all = Vec::new();
    for field in COMPARED {
        let truth = exact.engine().read_all(field)?.concat();
        let response = rms(&single.engine().read_all(field)?.concat(), &truth);
        let error = rms(&found.engine().read_all(field)?.concat(), &truth);
        all.push(Distance { what: field.name.to_string(), error, tolerance: FACTOR * response });
    }
    for axis in 0..D {
        let length = set.domain().torus_length()[axis];
        let truth = exact.engine().coordinates(axis)?;
        let far = |places: Vec<u64>| {
            let apart = |(a, b): (&u64, &u64)| separation(*a, *b, length).powi(2);
            (places.iter().zip(&truth).map(apart).sum::<f64>() / truth.len() as f64).sqrt()
        };
        let response = far(single.engine().coordinates(axis)?);
        let error = far(found.engine().coordinates(axis)?);
        let tolerance = FACTOR * response + steps as f64 * HALF_GRID_STEP * length;
        all.push(Distance { what: format!("place along axis {axis}"), error, tolerance });
    }
    Ok(all)
}

fn run<const D: usize, E: Engine<D>>(engine: E, physics: Physics, until: f64) -> Result<Simulation<D, E>, EngineError> {
    let mut run = Simulation::new(engine, physics)?;
    run.run(until, |_| {})?;
    Ok(run)
}

fn rms(a: &[f64], b: &[f64]) -> f64 {
    (a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>() / a.len() as f64).sqrt()
}
