//! A run between two steps, as plain numbers from which it can go on bit for bit.

use super::{Simulation, Stirring};
use crate::engine::{Arrangement, Engine, EngineError};
use crate::passes::Physics;
use crate::pipeline::Pipeline;
use crate::turbulence::forcing::Forcing;
use etalon_kernels_gen::{Component, components};

/// All that the next step depends on, and nothing that it computes anew.
///
/// Derived quantities, such as the density, are not among it: after [`Simulation::resume`] they are there again with the first step.
#[derive(Clone, Debug, PartialEq)]
pub struct Checkpoint {
    /// Fixed-point coordinates, axis by axis, in the particles' original order.
    pub coordinates: Vec<Vec<u64>>,
    /// The fields of [`Pipeline::carried`], component by component, in the particles' original order.
    pub columns: Vec<(Component, Vec<f64>)>,
    /// How the engine keeps its particles.
    pub arrangement: Arrangement,
    /// The time reached.
    pub time: f64,
    /// How many steps that took.
    pub steps: u64,
    /// The length of the next step, as far as the particles allow.
    pub next_step: f64,
}

impl<const D: usize, E: Engine<D>> Simulation<D, E> {
    /// What it takes to go on from here later.
    ///
    /// # Errors
    /// Whatever reading from the engine gives.
    pub fn checkpoint(&mut self) -> Result<Checkpoint, EngineError> {
        let read = |component| Ok((component, self.engine.read(component)?));
        let columns = components(&self.pipeline.carried::<D>(), D).into_iter().map(read);
        let columns = columns.collect::<Result<_, EngineError>>()?;
        Ok(Checkpoint {
            coordinates: (0..D).map(|axis| self.engine.coordinates(axis)).collect::<Result<_, _>>()?,
            columns,
            arrangement: self.engine.arrangement(),
            time: self.time,
            steps: self.steps,
            next_step: self.next_step,
        })
    }

    /// Goes on from a checkpoint, on an engine made like the one it was taken from: from then on every bit is as if the run had never been
    /// interrupted. The engine's particles need only be as many; all they carry from step to step is replaced.
    ///
    /// # Errors
    /// A checkpoint of other dimensions, of another number of particles, without a field that this physics carries, of another kind of
    /// engine, or with a time that is none; whatever writing to the engine gives.
    pub fn resume(engine: E, physics: Physics, checkpoint: &Checkpoint) -> Result<Self, EngineError> {
        if physics.forced {
            return Err(EngineError(
                "the run is stirred by a force; resume it with that force as it stood".to_string(),
            ));
        }
        Self::resumed(engine, physics, checkpoint)
    }

    /// The same for a run that a force stirs, which must stand as it stood ([`Forcing::restore`]).
    ///
    /// # Errors
    /// As [`Self::resume`], and for a physics that is not forced.
    pub fn resume_with_forcing(
        engine: E,
        physics: Physics,
        checkpoint: &Checkpoint,
        force: Forcing<D>,
    ) -> Result<Self, EngineError> {
        let mut simulation = Self::resumed(engine, physics, checkpoint)?;
        simulation.forcing = Some(Stirring::new(&mut simulation.engine, force)?);
        Ok(simulation)
    }

    fn resumed(mut engine: E, physics: Physics, checkpoint: &Checkpoint) -> Result<Self, EngineError> {
        let pipeline = Pipeline::of_scene::<D>(&physics);
        let refused = |what: String| Err(EngineError(format!("the checkpoint {what}")));
        let count = engine.particle_count();
        let Checkpoint { time, next_step, .. } = *checkpoint;
        if checkpoint.coordinates.len() != D {
            return refused(format!("is of a run in {} dimensions, not in {D}", checkpoint.coordinates.len()));
        }
        if let Some(found) = checkpoint.coordinates.iter().map(Vec::len).find(|&found| found != count) {
            return refused(format!("has {found} particles where the scene has {count}"));
        }
        if !(time.is_finite() && time >= 0.0 && next_step.is_finite() && next_step >= 0.0) {
            return refused(format!(
                "is of time {time} with a next step of {next_step}; both must be finite numbers from 0 on"
            ));
        }
        engine.arrange(&checkpoint.arrangement)?;
        for (axis, column) in checkpoint.coordinates.iter().enumerate() {
            engine.place(axis, column)?;
        }
        for component in components(&pipeline.carried::<D>(), D) {
            match checkpoint.columns.iter().find(|(saved, _)| *saved == component) {
                Some((_, values)) => engine.write(component, values)?,
                None => {
                    return refused(format!("has no {}, which this physics carries on", component.name(D)));
                }
            }
        }
        let steps = checkpoint.steps;
        Ok(Simulation { engine, physics, pipeline, time, steps, next_step, forcing: None })
    }
}
