//! A scene through time, on any engine: kick, drift, kick.
//!
//! Second order in the step. Forces depend on velocities, so the closing kick's velocities are first foretold with the old
//! acceleration and corrected afterwards (see [`KickDrift`] and [`Correct`]).

use crate::engine::{Engine, EngineError};
use crate::fields;
use crate::passes::{Correct, Decay, KickDrift, Physics};
use crate::pipeline::{PassKind, Pipeline};

/// Rounds of the smoothing length's update before the first step. An error shrinks by half in each at a contact, faster elsewhere.
const SETTLING_ROUNDS: usize = 10;

/// A step shorter than this fraction of the time already run would never end.
const SHORTEST_STEP: f64 = 1e-12;

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

    /// One step, no further than `until`; returns its length.
    pub fn step(&mut self, until: f64) -> Result<f64, EngineError> {
        let rest = until - self.time;
        if self.next_step.is_nan() || self.next_step <= SHORTEST_STEP * self.time {
            return Err(EngineError(format!(
                "the time step has shrunk to {:e} at time {}; a particle's state is not finite or changes too fast",
                self.next_step, self.time
            )));
        }
        // What would be left over would be no step.
        let step = if rest - self.next_step <= SHORTEST_STEP * until { rest } else { self.next_step };
        self.engine.run_update(&KickDrift(self.physics), step)?;
        if self.pipeline.switches() {
            self.engine.run_update(&Decay(self.physics), step)?;
        }
        self.engine.drift()?;
        self.forces()?;
        self.engine.run_update(&Correct, step)?;
        self.time = if step == rest { until } else { self.time + step };
        self.steps += 1;
        Ok(step)
    }

    /// Steps until `until`, telling `progress` the time after each.
    pub fn run(&mut self, until: f64, mut progress: impl FnMut(f64)) -> Result<(), EngineError> {
        while self.time < until {
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
