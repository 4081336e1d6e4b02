//! A scene through time, on any engine: kick, drift, kick.
//!
//! Second order in the step. Forces depend on velocities, so the closing kick's velocities are first foretold with the old
//! acceleration and corrected afterwards (see [`KickDrift`] and [`Correct`](crate::passes::Correct)).

mod checkpoint;

pub use checkpoint::Checkpoint;

use crate::engine::{Engine, EngineError};
use crate::fields;
use crate::passes::{KickDrift, Physics};
use crate::pipeline::{PassKind, Pipeline, UpdateKind, UpdateVisitor};
use etalon_kernels_gen::Update;

/// Rounds of the smoothing length's update before the first step. An error shrinks by half in each at a contact, faster elsewhere.
const SETTLING_ROUNDS: usize = 10;

/// A run of steps shorter than this fraction of it would never end.
const SHORTEST_STEP: f64 = 1e-9;

/// What is shorter than this fraction of the time is left over by rounding, and is no step.
const LEFT_OVER: f64 = 1e-12;

/// Particles on an engine, and the time they have reached.
pub struct Simulation<const D: usize, E> {
    engine: E,
    physics: Physics,
    pipeline: Pipeline,
    time: f64,
    steps: u64,
    next_step: f64,
}

impl<const D: usize, E: Engine<D>> Simulation<D, E> {
    /// Takes an engine with particles and computes their accelerations.
    ///
    /// Smoothing lengths are first brought to the wanted neighbour number by some rounds of their update.
    pub fn new(mut engine: E, physics: Physics) -> Result<Self, EngineError> {
        let pipeline = Pipeline::of_scene::<D>(&physics);
        for axis in 0..D {
            let zeros = vec![0.0; engine.particle_count()];
            for field in [fields::ACCELERATION, fields::PREVIOUS_ACCELERATION, fields::DISPLACEMENT] {
                engine.write(etalon_kernels_gen::Component { field, index: axis }, &zeros)?;
            }
            if axis == 0 {
                for field in [fields::ENERGY_RATE, fields::PREVIOUS_ENERGY_RATE] {
                    engine.write(etalon_kernels_gen::Component { field, index: 0 }, &zeros)?;
                }
            }
        }
        pipeline.start(&mut engine, physics)?;
        let mut simulation = Simulation { engine, physics, pipeline, time: 0.0, steps: 0, next_step: 0.0 };
        let density = Pipeline::leading_to::<D>(PassKind::Gradients);
        for _ in 0..SETTLING_ROUNDS {
            simulation.engine.find_neighbours(physics.kernel.support())?;
            density.run(&mut simulation.engine, physics)?;
            // With a step of length zero this changes nothing but the smoothing length.
            simulation.engine.run_update(&KickDrift(physics), 0.0)?;
        }
        simulation.forces()?;
        Ok(simulation)
    }

    /// Neighbours, passes, and the step they allow.
    fn forces(&mut self) -> Result<(), EngineError> {
        self.engine.find_neighbours(self.physics.kernel.support())?;
        self.pipeline.run(&mut self.engine, self.physics)?;
        self.next_step = self.engine.minimum(fields::TIME_STEP)?;
        Ok(())
    }

    fn update(&mut self, updates: &[UpdateKind], step: f64) -> Result<(), EngineError> {
        struct Run<'e, E>(&'e mut E, f64);
        impl<const D: usize, E: Engine<D>> UpdateVisitor<D> for Run<'_, E> {
            type Output = Result<(), EngineError>;
            fn visit_update<U: Update<D>>(&mut self, update: &U) -> Self::Output {
                self.0.run_update(update, self.1)
            }
        }
        let mut run = Run(&mut self.engine, step);
        updates.iter().try_for_each(|update| update.visit::<D, _>(self.physics, &mut run))
    }

    /// One step, no further than `until`; returns its length.
    pub fn step(&mut self, until: f64) -> Result<f64, EngineError> {
        let rest = until - self.time;
        self.refuse_steps_up_to(LEFT_OVER * self.time)?;
        let left_over = LEFT_OVER * (self.time + self.next_step);
        let step = if rest - self.next_step <= left_over { rest } else { self.next_step };
        self.update(self.pipeline.opening(), step)?;
        self.engine.drift()?;
        self.forces()?;
        self.update(self.pipeline.closing(), step)?;
        self.time = if step == rest { until } else { self.time + step };
        self.steps += 1;
        Ok(step)
    }

    /// An error if the next step is no longer than that, or no number.
    fn refuse_steps_up_to(&self, length: f64) -> Result<(), EngineError> {
        if self.next_step.is_nan() || self.next_step <= length {
            return Err(EngineError(format!(
                "the time step has shrunk to {:e} at time {}; a particle's state is not finite or changes too fast",
                self.next_step, self.time
            )));
        }
        Ok(())
    }

    /// Steps until `until`, telling `progress` the time after each.
    pub fn run(&mut self, until: f64, mut progress: impl FnMut(f64)) -> Result<(), EngineError> {
        while self.time < until {
            self.refuse_steps_up_to(SHORTEST_STEP * until)?;
            self.step(until)?;
            progress(self.time);
        }
        Ok(())
    }

    /// The time reached.
    pub fn time(&self) -> f64 {
        self.time
    }
    /// How many steps that took.
    pub fn steps(&self) -> u64 {
        self.steps
    }
    /// The engine, to read fields from.
    pub fn engine(&mut self) -> &mut E {
        &mut self.engine
    }
    /// The passes of each step.
    pub fn pipeline(&self) -> &Pipeline {
        &self.pipeline
    }
    /// The physics.
    pub fn physics(&self) -> &Physics {
        &self.physics
    }
}
