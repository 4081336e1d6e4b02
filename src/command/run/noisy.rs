//! An engine that rounds at random: Monte Carlo arithmetic.
//!
//! Source of the idea: Parker, Pierce & Eggert 2000, *Monte Carlo arithmetic: how to gamble with floating point and win*.

use super::wrapped::{Around, Work, Wrapped};
use etalon_kernels_gen::{Component, Update};
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

/// An engine whose particles are changed in every step.
pub type Noisy<E, const D: usize> = Wrapped<E, Shaking<D>>;

/// Changes an engine's particles in every step.
pub struct Shaking<const D: usize> {
    noise: Noise<D>,
    random: Pcg64Mcg,
}

impl<E, const D: usize> Noisy<E, D> {
    /// Takes an engine with its particles.
    pub fn new(engine: E, noise: Noise<D>) -> Self {
        Wrapped { engine, around: Shaking { noise, random: Pcg64Mcg::seed_from_u64(1) } }
    }
}

impl<const D: usize> Shaking<D> {
    /// Adds to every particle that moves `size(its value, its number)`, up or down at random.
    fn shake<E: Engine<D>>(
        &mut self,
        engine: &mut E,
        component: Component,
        mobility: &[f64],
        size: impl Fn(f64, usize) -> f64,
    ) -> Result<(), EngineError> {
        let mut values = engine.read(component)?;
        for (i, value) in values.iter_mut().enumerate() {
            let sign = if self.random.random::<bool>() { 1.0 } else { -1.0 };
            *value += sign * mobility[i] * size(*value, i);
        }
        engine.write(component, &values)
    }

    fn shake_all<E: Engine<D>>(&mut self, engine: &mut E) -> Result<(), EngineError> {
        let Noise { relative, place } = self.noise;
        let mobility = engine.read_scalar(fields::MOBILITY)?;
        let sound_speed = engine.read_scalar(fields::SOUND_SPEED)?;
        for field in [fields::INTERNAL_ENERGY, fields::SMOOTHING_LENGTH] {
            self.shake(engine, Component { field, index: 0 }, &mobility, |value, _| relative * value.abs())?;
        }
        for (index, step) in place.into_iter().enumerate() {
            let velocity = Component { field: fields::VELOCITY, index };
            self.shake(engine, velocity, &mobility, |value, i| relative * (value.abs() + sound_speed[i]))?;
            self.shake(engine, Component { field: fields::DISPLACEMENT, index }, &mobility, |_, _| step)?;
        }
        Ok(())
    }
}

impl<E: Engine<D>, const D: usize> Around<E> for Shaking<D> {
    fn during(
        &mut self,
        engine: &mut E,
        work: Work,
        run: impl FnOnce(&mut E) -> Result<(), EngineError>,
    ) -> Result<(), EngineError> {
        run(engine)?;
        // Once a step, between the kick and the drift; a step of length zero is set-up.
        let kicked = work.name == <KickDrift as Update<D>>::NAME && work.time_step.is_some_and(|step| step > 0.0);
        if kicked { self.shake_all(engine) } else { Ok(()) }
    }
}
