//! Driven subsonic turbulence (C25 section 2, GS25 section 4): gas at rest in a periodic box, stirred by a few long waves.
//!
//! Box, density, sound speed, the range of waves and the Mach number are the papers'; the strength of the driving, its memory and the end time are those
//! of SPH-EXA, with which both papers ran it. `docs/turbulence.md` has the table.

use super::{Arrangement, GlassError, lattice};
use crate::domain::Domain;
use crate::equations::equation_of_state::sound_speed;
use crate::equations::reconstruction::smoothing_length_holding;
use crate::particles::{Particle, ParticleError, ParticleSet};
use crate::passes::Physics;
use crate::schemes::{Dissipation, GradH, Kernel, Viscosity};
use crate::turbulence::TurbulenceError;
use crate::turbulence::forcing::{Driving, Forcing};

/// The side of the periodic box (C25 section 2).
pub const SIDE: f64 = 1.0;
/// The gas's density (C25 section 2).
pub const DENSITY: f64 = 1.0;
/// `gamma - 1`: nearly isothermal (C25 section 2, GS25 section 3).
pub const GAMMA_MINUS_ONE: f64 = 0.001;
/// The specific internal energy, for a sound speed of one (SPH-EXA).
pub const INTERNAL_ENERGY: f64 = 1000.0;
/// Ten times that sound needs for a side (GS25 section 4: `-s 10`).
pub const END_TIME: f64 = 10.0;
/// How much longer than a support's diameter the side must be: a glass on its way, and gas that is stirred, want more room than gas at rest.
const ROOM: f64 = 1.35;

/// The choices of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turbulence {
    /// How many particles along the side of the box.
    pub across: usize,
    /// How they start.
    pub arrangement: Arrangement,
    /// How the gas is driven.
    pub driving: Driving,
    /// What the driving's random numbers start from.
    pub seed: u64,
    /// The kernel.
    pub kernel: Kernel,
    /// The number of neighbours, the particle included.
    pub neighbours: f64,
    /// The dissipation scheme.
    pub dissipation: Dissipation,
    /// The grad-h form.
    pub grad_h: GradH,
}

/// What is wrong with the choices.
#[derive(Debug, thiserror::Error)]
pub enum TurbulenceSceneError {
    /// So few particles that a support would meet itself around the box.
    #[error(
        "{given} particles across: too few for {neighbours} neighbours, whose supports would meet themselves; give {enough}"
    )]
    TooFew {
        /// What was asked for.
        given: usize,
        /// With so many neighbours.
        neighbours: f64,
        /// What works.
        enough: usize,
    },
    /// The driving was refused.
    #[error(transparent)]
    Driving(#[from] TurbulenceError),
    /// The particles were refused.
    #[error(transparent)]
    Particles(#[from] ParticleError),
    /// The glass failed.
    #[error(transparent)]
    Glass(#[from] GlassError),
}

impl Turbulence {
    /// The papers' settings in `dimension` dimensions, with a size that the scalar reference runs within minutes.
    pub fn standard(dimension: usize) -> Self {
        Turbulence {
            across: [100, 40, 16][dimension - 1],
            arrangement: Arrangement::Lattice,
            driving: Driving::subsonic(),
            seed: 1,
            kernel: Kernel::MixedSinc,
            neighbours: [5.8, 26.0, 100.0][dimension - 1],
            dissipation: Dissipation::AvSlrB2,
            grad_h: GradH::Corrected,
        }
    }

    /// The physics of all passes.
    pub fn physics(&self) -> Physics {
        Physics {
            kernel: self.kernel,
            grad_h: self.grad_h,
            viscosity: Viscosity::of(self.dissipation),
            gamma_minus_one: GAMMA_MINUS_ONE,
            neighbours: self.neighbours,
            forced: true,
            ..Physics::STANDARD
        }
    }

    /// The initial particles. `glass` gives a relaxed cube of `across^D` particles when one is asked for.
    ///
    /// # Errors
    /// Too few particles; what `glass` refuses.
    pub fn particles<const D: usize>(
        &self,
        glass: impl FnOnce(usize) -> Result<Vec<[f64; D]>, GlassError>,
    ) -> Result<ParticleSet<D>, TurbulenceSceneError> {
        let support = self.kernel.support();
        let diameter = 2.0 * support * smoothing_length_holding(self.neighbours, 1.0, D, support);
        let (given, enough) = (self.across, (ROOM * diameter).ceil() as usize);
        if given < enough {
            return Err(TurbulenceSceneError::TooFew { given, neighbours: self.neighbours, enough });
        }
        let spacing = SIDE / given as f64;
        let places = match self.arrangement {
            Arrangement::Lattice => lattice([given; D], spacing),
            Arrangement::Glass => glass(given)?.into_iter().map(|place| place.map(|x| SIDE * x)).collect(),
        };
        let particle = |position| Particle {
            position,
            velocity: [0.0; D],
            mass: DENSITY * spacing.powi(D as i32),
            smoothing_length: spacing * diameter / (2.0 * support),
            internal_energy: INTERNAL_ENERGY,
            mobile: true,
        };
        Ok(ParticleSet::new(Self::domain()?, places.into_iter().map(particle).collect())?)
    }

    /// The driving force at the start of a run, for [`Simulation::with_forcing`](crate::simulation::Simulation::with_forcing).
    ///
    /// # Errors
    /// As [`Forcing::new`].
    pub fn forcing<const D: usize>(&self) -> Result<Forcing<D>, TurbulenceSceneError> {
        Ok(Forcing::new(&Self::domain()?, self.driving, self.seed)?)
    }

    fn domain<const D: usize>() -> Result<Domain<D>, ParticleError> {
        Ok(Domain::new([0.0; D], [SIDE; D], [true; D])?)
    }

    /// The speed of sound at the start.
    pub fn sound_speed(&self) -> f64 {
        sound_speed(GAMMA_MINUS_ONE, INTERNAL_ENERGY)
    }
}
