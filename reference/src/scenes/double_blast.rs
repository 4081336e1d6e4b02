//! Two blast waves that collide between reflecting walls (Woodward & Colella 1984): pressure jumps of 1e5 and 1e4 in even gas at rest.
//!
//! In one dimension. There is no closed solution; the reference is a converged finite-volume one.

use super::mirror::{MirrorError, mirrored};
use crate::domain::Domain;
use crate::equations::reconstruction::smoothing_length_holding;
use crate::exact::finite_volume::{End, FiniteVolume, FiniteVolumeError};
use crate::exact::riemann::State;
use crate::particles::{Particle, ParticleError, ParticleSet};
use crate::passes::Physics;
use crate::schemes::{Dissipation, GradH, Kernel, Viscosity};

/// The gas's density (Woodward & Colella 1984).
pub const DENSITY: f64 = 1.0;
/// Pressure left, in the middle and right (Woodward & Colella 1984).
pub const PRESSURE: [f64; 3] = [1000.0, 0.01, 100.0];
/// Where they meet (Woodward & Colella 1984).
pub const INTERFACES: [f64; 2] = [0.1, 0.9];
/// The adiabatic index (Woodward & Colella 1984).
pub const GAMMA: f64 = 1.4;
/// When one looks (Woodward & Colella 1984).
pub const END_TIME: f64 = 0.038;
/// Where errors are measured: between the walls.
pub const MEASURED: (f64, f64) = (0.0, 1.0);
/// Fewer show no waves.
const LEAST: usize = 40;

/// The choices of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DoubleBlast {
    /// How many particles between the walls; their mirror images come on top.
    pub particles: usize,
    /// The kernel.
    pub kernel: Kernel,
    /// The number of neighbours, the particle included.
    pub neighbours: f64,
    /// The dissipation scheme.
    pub dissipation: Dissipation,
    /// The grad-h form.
    pub grad_h: GradH,
    /// The coefficient of artificial conduction; zero for none.
    pub conduction: f64,
}

/// What is wrong with the choices.
#[derive(Debug, thiserror::Error)]
pub enum DoubleBlastError {
    /// It is a problem of one dimension.
    #[error("two blast waves in {0}-D: they are set up in 1-D only")]
    Dimension(usize),
    /// Too few particles.
    #[error("{0} particles show no blast waves; give at least {LEAST}")]
    TooFew(usize),
    /// No mirror image.
    #[error(transparent)]
    Mirror(#[from] MirrorError),
    /// The particles were refused.
    #[error(transparent)]
    Particles(#[from] ParticleError),
}

impl DoubleBlast {
    /// The usual choices, with a size that the scalar reference runs within a minute.
    pub fn standard() -> Self {
        DoubleBlast {
            particles: 400,
            kernel: Kernel::MixedSinc,
            neighbours: 5.8,
            dissipation: Dissipation::AvSlrB2,
            grad_h: GradH::Corrected,
            conduction: 0.0,
        }
    }

    /// The physics of all passes.
    pub fn physics(&self) -> Physics {
        Physics {
            kernel: self.kernel,
            grad_h: self.grad_h,
            viscosity: Viscosity { conduction: self.conduction, ..Viscosity::of(self.dissipation) },
            gamma_minus_one: GAMMA - 1.0,
            neighbours: self.neighbours,
            ..Physics::STANDARD
        }
    }

    /// The initial particles and, behind them, their mirror images.
    ///
    /// # Errors
    /// More than one dimension, too few particles.
    pub fn particles<const D: usize>(&self) -> Result<ParticleSet<D>, DoubleBlastError> {
        if D != 1 {
            return Err(DoubleBlastError::Dimension(D));
        }
        if self.particles < LEAST {
            return Err(DoubleBlastError::TooFew(self.particles));
        }
        let spacing = 1.0 / self.particles as f64;
        let particle = |i: usize| {
            let x = (i as f64 + 0.5) * spacing;
            Particle {
                position: [x; D],
                velocity: [0.0; D],
                mass: DENSITY * spacing,
                smoothing_length: smoothing_length_holding(self.neighbours, spacing, D, self.kernel.support()),
                internal_energy: start(x).pressure / ((GAMMA - 1.0) * DENSITY),
                mobile: true,
            }
        };
        let domain = Domain::new([0.0; D], [1.0; D], [false; D]).map_err(ParticleError::from)?;
        Ok(mirrored(&ParticleSet::new(domain, (0..self.particles).map(particle).collect())?, 0)?)
    }
}

/// The gas at the start.
fn start(x: f64) -> State<f64> {
    let side = INTERFACES.iter().filter(|interface| x > **interface).count();
    State { density: DENSITY, velocity: 0.0, pressure: PRESSURE[side] }
}

/// The flow at a time, by finite volumes in so many cells.
///
/// # Errors
/// As [`FiniteVolume::new`] and [`FiniteVolume::run`].
pub fn reference(cells: usize, time: f64) -> Result<FiniteVolume, FiniteVolumeError> {
    let mut gas = FiniteVolume::new(1, GAMMA, (0.0, 1.0), cells, [End::Wall; 2], start)?;
    gas.run(time)?;
    Ok(gas)
}
