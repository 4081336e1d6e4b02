//! DUSTYBOX: gas and dust, each uniform, that stream through each other (Laibe & Price 2011; PL20's drag and nothing else).
//!
//! A periodic box of side one. PL20 does not run it; the numbers are those of PHANTOM's unit test. Nobody says how the two lattices lie: here
//! they begin at the same places, as those of the paper's shock tube do.

use super::gas_and_dust::{
    DustySceneError, KERNEL, check_neighbours, enough_across, lattice, mixture, physics, usual_neighbours,
};
use crate::domain::Domain;
use crate::equations::reconstruction::smoothing_length_holding;
use crate::exact::dust::Mixture;
use crate::exact::dustybox;
use crate::particles::{Particle, ParticleError, ParticleSet};
use crate::passes::Physics;
use crate::schemes::{Dissipation, Drag, Kernel};

/// When to look: the difference has fallen to a quarter.
pub const END_TIME: f64 = 2.0;
/// The drag coefficient (PHANTOM's unit test).
pub const DRAG_COEFFICIENT: f64 = 0.35;

/// The choices of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DustyBox {
    /// Particles of each species along each side.
    pub across: usize,
    /// By how many spacings the dust's lattice is shifted along each axis.
    pub shift: f64,
    /// Density of the gas.
    pub gas_density: f64,
    /// Density of the dust.
    pub dust_density: f64,
    /// Velocity of the gas along x.
    pub gas_velocity: f64,
    /// Velocity of the dust along x.
    pub dust_velocity: f64,
    /// The gas's adiabatic sound speed at the start.
    pub sound_speed: f64,
    /// The adiabatic index.
    pub gamma: f64,
    /// Drag.
    pub drag: Drag,
    /// The kernel, whose double-humped partner is drag's.
    pub kernel: Kernel,
    /// The number of neighbours of the same species, the particle included.
    pub neighbours: f64,
    /// The gas's dissipation scheme.
    pub dissipation: Dissipation,
}

impl DustyBox {
    /// PHANTOM's unit test in `dimension` dimensions: gas at rest, dust of the same density with velocity one.
    pub fn standard(dimension: usize) -> Self {
        DustyBox {
            across: [64, 24, 12][dimension - 1],
            shift: 0.0,
            gas_density: 1.0,
            dust_density: 1.0,
            gas_velocity: 0.0,
            dust_velocity: 1.0,
            sound_speed: 1.0,
            gamma: 5.0 / 3.0,
            drag: Drag::of(DRAG_COEFFICIENT),
            kernel: KERNEL,
            neighbours: usual_neighbours(dimension),
            dissipation: Dissipation::AvSlrB2,
        }
    }

    /// The physics of all passes.
    pub fn physics(&self) -> Physics {
        physics(self.kernel, self.neighbours, self.dissipation, self.gamma, self.drag)
    }

    /// The exact solution.
    ///
    /// # Errors
    /// Numbers that no mixture has.
    pub fn exact(&self) -> Result<dustybox::DustyBox<f64>, DustySceneError> {
        let mixture = Mixture::new(self.gas_density, self.dust_density, self.drag.coefficient)?;
        Ok(dustybox::DustyBox::new(mixture, self.gas_velocity, self.dust_velocity)?)
    }

    /// The initial particles, gas first.
    ///
    /// # Errors
    /// Numbers that no mixture has, or so few particles that a support would meet itself.
    pub fn particles<const D: usize>(&self) -> Result<ParticleSet<D>, DustySceneError> {
        self.exact()?;
        check_neighbours(self.neighbours, D)?;
        let enough = enough_across(self.kernel, self.neighbours, D);
        if self.across < enough {
            return Err(DustySceneError::TooFew { given: self.across, enough });
        }
        let spacing = 1.0 / self.across as f64;
        let of = |density: f64, velocity: f64, internal_energy: f64, shift: f64| {
            lattice([self.across; D], spacing, shift).into_iter().map(move |position| Particle {
                position,
                velocity: std::array::from_fn(|axis| if axis == 0 { velocity } else { 0.0 }),
                mass: density * spacing.powi(D as i32),
                smoothing_length: smoothing_length_holding(
                    self.neighbours,
                    spacing.powi(D as i32),
                    D,
                    self.kernel.support(),
                ),
                internal_energy,
                mobile: true,
            })
        };
        let warm = self.sound_speed * self.sound_speed / (self.gamma * (self.gamma - 1.0));
        let domain = Domain::new([0.0; D], [1.0; D], [true; D]).map_err(ParticleError::from)?;
        let gas = of(self.gas_density, self.gas_velocity, warm, 0.0);
        Ok(mixture(domain, gas, of(self.dust_density, self.dust_velocity, 0.0, self.shift))?)
    }
}
