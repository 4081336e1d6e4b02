//! A glass: particles at equal distances from one another, without the directions of a lattice.
//!
//! Made by the code itself: random displacements from a lattice, then pressure pushes the particles apart, with all motion
//! taken out after every step.

use crate::domain::Domain;
use crate::engine::{Engine, EngineError};
use crate::equations::reconstruction::smoothing_length_holding;
use crate::fields;
use crate::particles::{Particle, ParticleError, ParticleSet};
use crate::passes::{KickDrift, Physics};
use crate::pipeline::Pipeline;
use etalon_kernels_gen::Component;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// Why there is no glass.
#[derive(Debug, thiserror::Error)]
pub enum GlassError {
    /// The engine failed.
    #[error(transparent)]
    Engine(#[from] EngineError),
    /// The particles were refused.
    #[error(transparent)]
    Particles(#[from] ParticleError),
}

/// Random displacement at the start, in lattice spacings.
const JITTER: f64 = 0.35;
/// A relaxation step, as a fraction of the step that the particles' accelerations allow.
const STEP: f64 = 1.0;

/// A periodic cube of side one with `across^D` particles, relaxed for so many rounds.
///
/// `make` builds the engine to relax on. The same `seed` gives the same glass.
pub fn relax<const D: usize, E: Engine<D>>(
    across: usize,
    physics: Physics,
    rounds: usize,
    seed: u64,
    make: impl FnOnce(&ParticleSet<D>, &Pipeline) -> Result<E, EngineError>,
) -> Result<Vec<[f64; D]>, GlassError> {
    // Particles are to be even; what they rest in a gravity of is for the scene.
    let physics = Physics { gravity: [0.0; 3], drag: None, ..physics };
    let domain = Domain::new([0.0; D], [1.0; D], [true; D]).map_err(ParticleError::from)?;
    let count = across.pow(D as u32);
    let spacing = 1.0 / across as f64;
    let h = smoothing_length_holding(physics.neighbours, spacing.powi(D as i32), D, physics.kernel.support());
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    let particles = (0..count)
        .map(|i| Particle {
            position: std::array::from_fn(|axis| {
                let cell = (i / across.pow(axis as u32) % across) as f64 + 0.5;
                let shift = JITTER * (2.0 * random.random::<f64>() - 1.0);
                ((cell + shift) * spacing).rem_euclid(1.0)
            }),
            velocity: [0.0; D],
            mass: spacing.powi(D as i32),
            smoothing_length: h,
            internal_energy: 1.0,
            mobile: true,
        })
        .collect();
    let set = ParticleSet::new(domain, particles)?;
    let pipeline = Pipeline::of_scene::<D>(&physics);
    let mut engine = make(&set, &pipeline)?;
    let zeros = vec![0.0; count];
    for _ in 0..rounds {
        engine.find_neighbours(physics.kernel.support())?;
        pipeline.run(&mut engine, physics)?;
        let step = STEP * engine.minimum(fields::TIME_STEP)?;
        engine.write(Component { field: fields::ENERGY_RATE, index: 0 }, &zeros)?;
        engine.run_update(&KickDrift(physics), step)?;
        engine.drift()?;
        for axis in 0..D {
            engine.write(Component { field: fields::VELOCITY, index: axis }, &zeros)?;
        }
    }
    let columns = (0..D).map(|axis| engine.coordinates(axis)).collect::<Result<Vec<_>, _>>()?;
    Ok((0..count).map(|i| std::array::from_fn(|axis| domain.decode(axis, columns[axis][i]))).collect())
}
