//! The oscillating membrane (GS25 section 5.2): a thin cylinder in gas at rest that swells and shrinks and sends out waves.
//!
//! The paper states the cylinder's radius and length, the period, the largest velocity, the gas, the box and the number of particles. It does not
//! state how the oscillation starts, what the cylinder is made of, nor how particles are laid out; `docs/membrane.md` says what was taken.

use super::lattice;
use crate::domain::Domain;
use crate::equations::equation_of_state::sound_speed;
use crate::equations::polar::radial_velocity;
use crate::equations::reconstruction::smoothing_length_holding;
use crate::exact::finite_volume::{End, FiniteVolume, FiniteVolumeError};
use crate::exact::outgoing_wave::OutgoingWave;
use crate::exact::radial::RadialError;
use crate::exact::riemann::State;
use crate::particles::{Particle, ParticleError, ParticleSet};
use crate::passes::{Driver, Physics};
use crate::schemes::{GradH, Kernel, Viscosity};
use etalon_kernels_gen::Vector;
use std::f64::consts::TAU;

/// The cylinder's radius (GS25 section 5.2).
pub const RADIUS: f64 = 0.035;
/// The period of its oscillation (GS25 section 5.2).
pub const PERIOD: f64 = 0.05;
/// Its largest velocity (GS25 section 5.2).
pub const VELOCITY: f64 = 0.16;
/// A hundredth of it, at which the wave is that of linear acoustics to 0.2 %.
pub const FAINT_VELOCITY: f64 = 0.0016;
/// Density of the gas (GS25 section 5.2).
pub const DENSITY: f64 = 1.0;
/// Pressure of the gas (GS25 section 5.2).
pub const PRESSURE: f64 = 1.0;
/// The side of the periodic box (GS25 section 5.2, by reference to the blast's).
pub const SIDE: f64 = 1.0;
/// When the paper looks (GS25 Fig. 12).
pub const END_TIME: f64 = 0.35;
/// Where errors are measured in the paper's setting, in distances from the axis: all that is not cylinder and not nearer to a neighbouring box. Ours.
pub const MEASURED: (f64, f64) = (0.036, 0.5);
/// How much longer than a support's diameter a side must be: smoothing lengths change a little.
const ROOM: f64 = 1.1;

/// The choices of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Membrane {
    /// How many particles along the side of the box; even numbers leave none on the axis.
    pub across: usize,
    /// The cylinder's radius; the paper's is [`RADIUS`].
    pub radius: f64,
    /// The period of its oscillation; the paper's is [`PERIOD`].
    pub period: f64,
    /// The largest velocity of its surface; the paper's is [`VELOCITY`].
    pub velocity: f64,
    /// Whether the surface moves with its velocity; it stays in place otherwise.
    pub moves: bool,
    /// The adiabatic index; the paper's is 5/3.
    pub gamma: f64,
    /// The kernel.
    pub kernel: Kernel,
    /// The number of neighbours, the particle included.
    pub neighbours: f64,
    /// The dissipation scheme; the paper compares those of [`Viscosity::MEMBRANE`].
    pub viscosity: Viscosity,
    /// The grad-h form.
    pub grad_h: GradH,
}

/// What is wrong with the choices.
#[derive(Debug, thiserror::Error)]
pub enum MembraneError {
    /// Too few particles for the supports or for the cylinder.
    #[error(
        "{given} particles across: too few for {neighbours} neighbours and a cylinder of two spacings; give {enough}"
    )]
    TooFew {
        /// What was asked for.
        given: usize,
        /// With so many neighbours.
        neighbours: f64,
        /// What works.
        enough: usize,
    },
    /// A cylinder is not a thing of one dimension.
    #[error("the membrane in {0}-D: it needs 2 dimensions, or 3 for a thin box")]
    Dimension(usize),
    /// A number that the wave cannot have.
    #[error(transparent)]
    Radial(#[from] RadialError),
    /// The finite-volume reference failed.
    #[error(transparent)]
    FiniteVolume(#[from] FiniteVolumeError),
    /// The particles were refused.
    #[error(transparent)]
    Particles(#[from] ParticleError),
}

impl Membrane {
    /// The paper's settings in `dimension` dimensions, with a size that the scalar reference runs within a minute.
    pub fn standard(dimension: usize) -> Self {
        Membrane {
            across: 100,
            radius: RADIUS,
            period: PERIOD,
            velocity: VELOCITY,
            moves: true,
            gamma: 5.0 / 3.0,
            kernel: Kernel::MixedSinc,
            neighbours: if dimension == 2 { 26.0 } else { 100.0 },
            viscosity: Viscosity::MEMBRANE[4],
            grad_h: GradH::Corrected,
        }
    }

    /// The physics of all passes.
    pub fn physics(&self) -> Physics {
        Physics {
            kernel: self.kernel,
            grad_h: self.grad_h,
            viscosity: Viscosity { wave_period: self.period, ..self.viscosity },
            gamma_minus_one: self.gamma - 1.0,
            neighbours: self.neighbours,
            driver: Some(self.driver()),
            ..Physics::STANDARD
        }
    }

    /// The initial particles: a square lattice, in three dimensions of as few layers as hold a support.
    ///
    /// # Errors
    /// One dimension; too few particles.
    pub fn particles<const D: usize>(&self) -> Result<ParticleSet<D>, MembraneError> {
        if D == 1 {
            return Err(MembraneError::Dimension(D));
        }
        let enough =
            ((2.0 * SIDE / self.radius).ceil() as usize).max((ROOM * self.diameter_in_spacings::<D>()).ceil() as usize);
        if self.across < enough {
            let (given, neighbours) = (self.across, self.neighbours);
            return Err(MembraneError::TooFew { given, neighbours, enough });
        }
        let spacing = SIDE / self.across as f64;
        let layers = (ROOM * self.diameter_in_spacings::<D>()).ceil() as usize;
        let counts: [usize; D] = std::array::from_fn(|axis| if axis < 2 { self.across } else { layers });
        let upper = counts.map(|count| count as f64 * spacing);
        let domain = Domain::new([0.0; D], upper, [true; D]).map_err(ParticleError::from)?;
        let mass = DENSITY * spacing.powi(D as i32);
        let particle = |position: [f64; D]| {
            let from_axis = from_axis(position);
            let r = from_axis.norm();
            let mobile = r >= self.radius;
            let outwards = if mobile || r == 0.0 { 0.0 } else { self.velocity / r };
            Particle {
                position,
                velocity: std::array::from_fn(|axis| if axis < 2 { outwards * from_axis[axis] } else { 0.0 }),
                mass,
                smoothing_length: spacing * self.diameter_in_spacings::<D>() / (2.0 * self.kernel.support()),
                internal_energy: PRESSURE / ((self.gamma - 1.0) * DENSITY),
                mobile,
            }
        };
        Ok(ParticleSet::new(domain, lattice(counts, spacing).into_iter().map(particle).collect())?)
    }

    fn driver(&self) -> Driver {
        Driver { period: self.period, moves: self.moves }
    }

    fn diameter_in_spacings<const D: usize>(&self) -> f64 {
        2.0 * self.kernel.support() * smoothing_length_holding(self.neighbours, 1.0, D, self.kernel.support())
    }

    fn sound_speed(&self) -> f64 {
        sound_speed(self.gamma - 1.0, PRESSURE / ((self.gamma - 1.0) * DENSITY))
    }

    /// The wave of linear acoustics with the same surface, kept in place.
    ///
    /// # Errors
    /// A velocity that is not positive, an index not above 1.
    pub fn linear(&self) -> Result<OutgoingWave, MembraneError> {
        Ok(OutgoingWave::new(self.radius, TAU / self.period, self.velocity, self.sound_speed())?)
    }

    /// The wave of the full equations at a time, by finite volumes in so many cells.
    ///
    /// # Errors
    /// As [`FiniteVolume::new`] and [`FiniteVolume::run`].
    pub fn full(&self, cells: usize, time: f64) -> Result<FiniteVolume, MembraneError> {
        let inner = End::Driven { velocity: self.velocity, driver: self.driver() };
        let rest = |_: f64| State { density: DENSITY, velocity: 0.0, pressure: PRESSURE };
        let mut gas = FiniteVolume::new(2, self.gamma, (self.radius, 0.5 * SIDE), cells, [inner, End::Open], rest)?;
        gas.run(time)?;
        Ok(gas)
    }
}

/// The vector from the axis to a place; the axis is the middle of the box.
fn from_axis<const D: usize>(position: [f64; D]) -> Vector<f64, 2> {
    Vector([position[0] - 0.5 * SIDE, position.get(1).map_or(0.0, |y| y - 0.5 * SIDE)])
}

/// Distance from the axis and velocity away from it.
pub fn radial<const D: usize>(position: [f64; D], velocity: [f64; D]) -> (f64, f64) {
    let x = from_axis(position);
    let v = Vector([velocity[0], velocity.get(1).copied().unwrap_or(0.0)]);
    (x.norm(), radial_velocity(v, x))
}
