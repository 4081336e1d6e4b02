//! A run between two steps, as plain numbers from which it can go on bit for bit.

use super::Simulation;
use crate::engine::{Arrangement, Engine, EngineError};
use crate::fields;
use crate::turbulence::forcing::ForcingState;
use etalon_kernels_gen::{Component, Field, components};

/// All that the next step depends on, what stirs the gas included, and what is looked at between steps ([`fields::SHOWN`]).
#[derive(Clone, Debug, PartialEq)]
pub struct Checkpoint {
    /// Fixed-point coordinates, axis by axis, in the particles' original order.
    pub coordinates: Vec<Vec<u64>>,
    /// The fields of [`Pipeline::carried`](crate::pipeline::Pipeline::carried) and those that are shown, component by component, in the particles'
    /// original order.
    pub columns: Vec<(Component, Vec<f64>)>,
    /// How the engine keeps its particles.
    pub arrangement: Arrangement,
    /// How the force that stirs the gas stands; none where nothing does.
    pub forcing: Option<ForcingState>,
    /// The time reached.
    pub time: f64,
    /// How many steps that took.
    pub steps: u64,
    /// The length of the next step, as far as the particles allow.
    pub next_step: f64,
}

impl<const D: usize, E: Engine<D>> Simulation<D, E> {
    /// What it takes to go on from here later, with what is `shown` beside [`fields::SHOWN`].
    ///
    /// # Errors
    /// Whatever reading from the engine gives.
    pub fn checkpoint(&mut self, shown: &[Field]) -> Result<Checkpoint, EngineError> {
        let (mut kept, all) = (self.pipeline.carried::<D>(), self.pipeline.fields::<D>());
        for field in fields::SHOWN.iter().chain(shown) {
            if all.contains(field) && !kept.contains(field) {
                kept.push(*field);
            }
        }
        let read = |component| Ok((component, self.engine.read(component)?));
        let columns = components(&kept, D).into_iter().map(read).collect::<Result<_, EngineError>>()?;
        Ok(Checkpoint {
            coordinates: (0..D).map(|axis| self.engine.coordinates(axis)).collect::<Result<_, _>>()?,
            columns,
            arrangement: self.engine.arrangement(),
            forcing: self.forcing.as_ref().map(|stirring| stirring.force.state()),
            time: self.time,
            steps: self.steps,
            next_step: self.next_step,
        })
    }

    /// Goes on from a checkpoint, in a simulation that was started like the one it was taken from: from then on every bit is as if that run had
    /// never been interrupted. Particles and force need only be of the same kind and number; all they carry from step to step is replaced.
    ///
    /// # Errors
    /// A checkpoint of other dimensions, of another number of particles, without a field that this physics carries, of another kind of
    /// engine, of a run that is stirred where this is not or the other way round, or with a time that is none; whatever writing to the engine
    /// gives. What was refused half-way leaves a simulation that is of no more use.
    pub fn restore(&mut self, checkpoint: &Checkpoint) -> Result<(), EngineError> {
        let refused = |what: String| Err(EngineError(format!("the checkpoint {what}")));
        let count = self.engine.particle_count();
        let Checkpoint { time, next_step, steps, .. } = *checkpoint;
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
        let has = |wanted: &Component| checkpoint.columns.iter().any(|(saved, _)| saved == wanted);
        if let Some(lost) = components(&self.pipeline.carried::<D>(), D).into_iter().find(|wanted| !has(wanted)) {
            return refused(format!("has no {}, which this physics carries on", lost.name(D)));
        }
        match (&mut self.forcing, &checkpoint.forcing) {
            (None, None) => {}
            (Some(stirring), Some(state)) => stirring.force.restore(state).map_err(EngineError::from_display)?,
            (Some(_), None) => return refused("is of a run that no force stirs".into()),
            (None, Some(_)) => return refused("is of a run that a force stirs; start this one with the force".into()),
        }
        self.engine.arrange(&checkpoint.arrangement)?;
        for (axis, column) in checkpoint.coordinates.iter().enumerate() {
            self.engine.place(axis, column)?;
        }
        for (component, values) in &checkpoint.columns {
            self.engine.write(*component, values)?;
        }
        (self.time, self.steps, self.next_step) = (time, steps, next_step);
        Ok(())
    }
}
