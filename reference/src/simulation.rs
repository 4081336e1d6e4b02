//! A scene through time, on any engine: kick, drift, kick.
//!
//! Second order in the step. Forces depend on velocities, so the closing kick's velocities are first foretold with the old
//! acceleration and corrected afterwards (see [`KickDrift`] and [`Correct`](crate::passes::Correct)).
//!
//! What acts from outside acts at the moment for which forces are computed: driven walls have the velocity, and particles the host's force, of the
//! step's end. A constant gravity is part of the physics and needs nothing here.

mod checkpoint;

pub use checkpoint::Checkpoint;

use crate::engine::{Engine, EngineError, smaller};
use crate::fields;
use crate::passes::{KickDrift, Physics};
use crate::pipeline::{Pipeline, UpdateKind, UpdateVisitor};
use crate::turbulence::forcing::Forcing;
use etalon_kernels_gen::{Component, Update};

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
    forcing: Option<Stirring<D>>,
}

/// A force that the host makes, and what it acts on.
struct Stirring<const D: usize> {
    force: Forcing<D>,
    /// Masses, zero for walls.
    mass: Vec<f64>,
}

impl<const D: usize> Stirring<D> {
    fn new<E: Engine<D>>(engine: &mut E, force: Forcing<D>) -> Result<Self, EngineError> {
        let (mass, mobility) = (engine.read_scalar(fields::MASS)?, engine.read_scalar(fields::MOBILITY)?);
        Ok(Stirring { force, mass: mass.into_iter().zip(mobility).map(|(mass, mobility)| mass * mobility).collect() })
    }
}

impl<const D: usize, E: Engine<D>> Simulation<D, E> {
    /// Takes an engine with particles and computes their accelerations.
    ///
    /// Smoothing lengths are first brought to the wanted neighbour number by some rounds of their update.
    pub fn new(engine: E, physics: Physics) -> Result<Self, EngineError> {
        Self::start(engine, physics, None)
    }

    /// The same with a force that stirs the gas. The physics must say that it is [`forced`](Physics::forced).
    pub fn with_forcing(engine: E, physics: Physics, force: Forcing<D>) -> Result<Self, EngineError> {
        if !physics.forced {
            return Err(EngineError(
                "a force needs the field it is carried in: set `forced` in the physics".to_string(),
            ));
        }
        Self::start(engine, physics, Some(force))
    }

    fn start(mut engine: E, physics: Physics, force: Option<Forcing<D>>) -> Result<Self, EngineError> {
        let pipeline = Pipeline::of_scene::<D>(&physics);
        for axis in 0..D {
            let zeros = vec![0.0; engine.particle_count()];
            for field in [fields::ACCELERATION, fields::PREVIOUS_ACCELERATION, fields::DISPLACEMENT] {
                engine.write(Component { field, index: axis }, &zeros)?;
            }
            if axis == 0 {
                for field in [fields::ENERGY_RATE, fields::PREVIOUS_ENERGY_RATE] {
                    engine.write(Component { field, index: 0 }, &zeros)?;
                }
            }
        }
        pipeline.start(&mut engine, physics)?;
        let forcing = force.map(|force| Stirring::new(&mut engine, force)).transpose()?;
        let mut simulation = Simulation { engine, physics, pipeline, time: 0.0, steps: 0, next_step: 0.0, forcing };
        let density = Pipeline::of_smoothing_lengths::<D>(&physics);
        for _ in 0..SETTLING_ROUNDS {
            simulation.engine.find_neighbours(physics.kernel.support())?;
            density.run(&mut simulation.engine, physics)?;
            // With a step of length zero this changes nothing but the smoothing length.
            simulation.engine.run_update(&KickDrift(physics), 0.0)?;
        }
        simulation.drive(0.0)?;
        simulation.forces(0.0)?;
        Ok(simulation)
    }

    /// Neighbours, passes, what pushes from outside after `step` more of it, and the step they allow.
    fn forces(&mut self, step: f64) -> Result<(), EngineError> {
        self.engine.find_neighbours(self.physics.kernel.support())?;
        self.pipeline.run(&mut self.engine, self.physics)?;
        if let Some(Stirring { force, mass }) = &mut self.forcing {
            force.advance(step).map_err(EngineError::from_display)?;
            let mut places: [Vec<u64>; D] = std::array::from_fn(|_| Vec::new());
            for (axis, places) in places.iter_mut().enumerate() {
                *places = self.engine.coordinates(axis)?;
            }
            for (index, values) in
                force.at(&places, mass).map_err(EngineError::from_display)?.acceleration.iter().enumerate()
            {
                self.engine.write(Component { field: fields::FORCING, index }, values)?;
            }
        }
        self.update(self.pipeline.pushing(), step)?;
        let allowed = self.engine.minimum(fields::TIME_STEP)?;
        self.next_step = self.physics.driver.map_or(allowed, |driver| smaller(allowed, driver.longest_step()));
        Ok(())
    }

    /// Gives driven walls the velocity of the end of a step and the way they go in it.
    fn drive(&mut self, step: f64) -> Result<(), EngineError> {
        let Some(driver) = self.physics.driver else { return Ok(()) };
        for update in self.pipeline.driving() {
            let scalar = match update {
                UpdateKind::MoveWall => driver.way(self.time, step),
                _ => driver.share(self.time + step),
            };
            self.update(std::slice::from_ref(update), scalar)?;
        }
        Ok(())
    }

    /// Runs updates with the scalar they take, which is the step's length for most.
    fn update(&mut self, updates: &[UpdateKind], scalar: f64) -> Result<(), EngineError> {
        struct Run<'e, E>(&'e mut E, f64);
        impl<const D: usize, E: Engine<D>> UpdateVisitor<D> for Run<'_, E> {
            type Output = Result<(), EngineError>;
            fn visit_update<U: Update<D>>(&mut self, update: &U) -> Self::Output {
                self.0.run_update(update, self.1)
            }
        }
        let mut run = Run(&mut self.engine, scalar);
        updates.iter().try_for_each(|update| update.visit::<D, _>(self.physics, &mut run))
    }

    /// One step, no further than `until`; returns its length.
    pub fn step(&mut self, until: f64) -> Result<f64, EngineError> {
        let rest = until - self.time;
        self.refuse_steps_up_to(LEFT_OVER * self.time)?;
        let left_over = LEFT_OVER * (self.time + self.next_step);
        let step = if rest - self.next_step <= left_over { rest } else { self.next_step };
        self.update(self.pipeline.opening(), step)?;
        self.drive(step)?;
        self.engine.drift()?;
        self.forces(step)?;
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
        self.run_watched(until, |simulation| -> Result<(), EngineError> {
            progress(simulation.time);
            Ok(())
        })
    }

    /// Steps until `until`, showing itself to `watch` after each; what it reads changes nothing.
    pub fn run_watched<W: From<EngineError>>(
        &mut self,
        until: f64,
        mut watch: impl FnMut(&mut Self) -> Result<(), W>,
    ) -> Result<(), W> {
        while self.time < until {
            self.refuse_steps_up_to(SHORTEST_STEP * until)?;
            self.step(until)?;
            watch(self)?;
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
    /// The force that stirs the gas, as it stands.
    pub fn forcing(&self) -> Option<&Forcing<D>> {
        self.forcing.as_ref().map(|stirring| &stirring.force)
    }
    /// The physics.
    pub fn physics(&self) -> &Physics {
        &self.physics
    }
}
