//! Runs into which something that is not a number was put: they must stop, and say so.

use super::sets::{Difficulty, set};
use crate::engine::{Engine, EngineError};
use crate::fields;
use crate::particles::ParticleSet;
use crate::passes::Physics;
use crate::pipeline::Pipeline;
use crate::simulation::Simulation;
use etalon_kernels_gen::{Component, Field};

/// What a run starts from and is carried on by.
pub const POISONED: [Field; 6] = [
    fields::MASS,
    fields::VELOCITY,
    fields::INTERNAL_ENERGY,
    fields::SMOOTHING_LENGTH,
    fields::ACCELERATION,
    fields::ENERGY_RATE,
];

/// Steps that a run may still take: one with what was computed before, one in which the bad value reaches the time step.
const MOST_STEPS: usize = 2;

/// How long runs are to go on: many steps, none of them short beside it. To an endless time every step would be too short, and any run
/// would stop.
const UNTIL: f64 = 1.0;

/// Puts a bad value into one particle of a small run and lets it go on: the sentence with which it stops.
///
/// # Errors
/// [`EngineError`] if it does *not* stop within two steps, could not be started, or stops before the bad value is there.
pub fn stopped_by<const D: usize, E: Engine<D>>(
    make: impl Fn(&ParticleSet<D>, &[Field]) -> E,
    physics: Physics,
    field: Field,
    bad: f64,
) -> Result<String, EngineError> {
    let across = [200, 14, 10][D - 1];
    let particles = set::<D>(Difficulty::None, across, &physics, 3).map_err(EngineError::from_display)?;
    let engine = make(&particles, &Pipeline::of_scene::<D>(&physics).fields::<D>());
    let mut run = Simulation::new(engine, physics)?;
    run.step(UNTIL)?;
    let component = Component { field, index: 0 };
    let mut values = run.engine().read(component)?;
    let somewhere = values.len() / 2;
    values[somewhere] = bad;
    run.engine().write(component, &values)?;
    for _ in 0..=MOST_STEPS {
        if let Err(stopped) = run.step(UNTIL) {
            return Ok(stopped.to_string());
        }
    }
    Err(EngineError(format!("a {} of {bad} did not stop the run within {MOST_STEPS} steps", field.name)))
}
