//! An engine that rounds at random: Monte Carlo arithmetic.
//!
//! Source of the idea: Parker, Pierce & Eggert 2000, *Monte Carlo arithmetic: how to gamble with floating point and win*.

use etalon_kernels_gen::{Component, Field, Pass, Update};
use etalon_reference::engine::{Engine, EngineError};
use etalon_reference::fields;
use etalon_reference::passes::KickDrift;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// How much is changed in every step, up or down at random.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Noise<const D: usize> {
    /// Relative change of energies and smoothing lengths; of velocities in units of their size and the sound speed, for the sums that
    /// accelerate a particle cancel terms of that size.
    pub relative: f64,
    /// Change of positions.
    pub place: [f64; D],
}

/// Changes an engine's particles in every step.
pub struct Noisy<E, const D: usize> {
    engine: E,
    noise: Noise<D>,
    random: Pcg64Mcg,
}

impl<E: Engine<D>, const D: usize> Noisy<E, D> {
    /// Takes an engine with its particles.
    pub fn new(engine: E, noise: Noise<D>) -> Self {
        Noisy { engine, noise, random: Pcg64Mcg::seed_from_u64(1) }
    }

    /// Adds to every particle that moves `size(its value, its number)`, up or down at random.
    fn shake(
        &mut self,
        component: Component,
        mobility: &[f64],
        size: impl Fn(f64, usize) -> f64,
    ) -> Result<(), EngineError> {
        let mut values = self.engine.read(component)?;
        for (i, value) in values.iter_mut().enumerate() {
            let sign = if self.random.random::<bool>() { 1.0 } else { -1.0 };
            *value += sign * mobility[i] * size(*value, i);
        }
        self.engine.write(component, &values)
    }

    fn shake_all(&mut self) -> Result<(), EngineError> {
        let Noise { relative, place } = self.noise;
        let mobility = self.engine.read_scalar(fields::MOBILITY)?;
        let sound_speed = self.engine.read_scalar(fields::SOUND_SPEED)?;
        for field in [fields::INTERNAL_ENERGY, fields::SMOOTHING_LENGTH] {
            self.shake(Component { field, index: 0 }, &mobility, |value, _| relative * value.abs())?;
        }
        for (index, step) in place.into_iter().enumerate() {
            let velocity = Component { field: fields::VELOCITY, index };
            self.shake(velocity, &mobility, |value, i| relative * (value.abs() + sound_speed[i]))?;
            self.shake(Component { field: fields::DISPLACEMENT, index }, &mobility, |_, _| step)?;
        }
        Ok(())
    }
}

impl<E: Engine<D>, const D: usize> Engine<D> for Noisy<E, D> {
    fn particle_count(&self) -> usize {
        self.engine.particle_count()
    }
    fn find_neighbours(&mut self, support: f64) -> Result<(), EngineError> {
        self.engine.find_neighbours(support)
    }
    fn run_pass<P: Pass<D>>(&mut self, pass: &P) -> Result<(), EngineError> {
        self.engine.run_pass(pass)
    }
    fn run_update<U: Update<D>>(&mut self, update: &U, time_step: f64) -> Result<(), EngineError> {
        self.engine.run_update(update, time_step)?;
        // Once a step, between the kick and the drift; a step of length zero is set-up.
        if time_step > 0.0 && U::NAME == <KickDrift as Update<D>>::NAME { self.shake_all() } else { Ok(()) }
    }
    fn drift(&mut self) -> Result<(), EngineError> {
        self.engine.drift()
    }
    fn minimum(&mut self, field: Field) -> Result<f64, EngineError> {
        self.engine.minimum(field)
    }
    fn read(&mut self, component: Component) -> Result<Vec<f64>, EngineError> {
        self.engine.read(component)
    }
    fn write(&mut self, component: Component, values: &[f64]) -> Result<(), EngineError> {
        self.engine.write(component, values)
    }
    fn coordinates(&mut self, axis: usize) -> Result<Vec<u64>, EngineError> {
        self.engine.coordinates(axis)
    }
}
