//! The sweeps of a step once more, on the plain engine in double precision, for what a run does not keep.

use super::{SceneError, State};
use crate::domain::Domain;
use crate::engine::{Engine, PlainEngine};
use crate::particles::{Particle, ParticleSet};
use crate::passes::Physics;
use crate::pipeline::{PassKind, Pipeline};

impl State {
    /// An engine with the gas of this state that has run the passes which lead to `last`, with that one. Smoothing lengths are those of the state;
    /// places are rounded to the grid that all runs start from. A coefficient that a switch remembers starts from its least.
    ///
    /// # Errors
    /// Particles that no run could start from; what the engine refuses.
    pub fn swept<const D: usize>(
        &self,
        domain: Domain<D>,
        physics: Physics,
        last: PassKind,
    ) -> Result<PlainEngine<f64, D>, SceneError> {
        let particle = |i: usize| Particle {
            position: std::array::from_fn(|axis| self.position[axis][i]),
            velocity: std::array::from_fn(|axis| self.velocity[axis][i]),
            mass: self.mass[i],
            smoothing_length: self.smoothing_length[i],
            internal_energy: self.internal_energy[i],
            mobile: self.mobility[i] > 0.0,
        };
        let set = ParticleSet::new(domain, (0..self.len()).map(particle).collect())?;
        let mut engine = PlainEngine::new(&set);
        let pipeline = Pipeline::leading_to::<D>(last, &physics);
        pipeline.start(&mut engine, physics)?;
        engine.find_neighbours(physics.kernel.support())?;
        pipeline.run(&mut engine, physics)?;
        Ok(engine)
    }
}
