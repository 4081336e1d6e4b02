//! What the scenes with gas and dust have in common.

use super::method::NEIGHBOURS;
use crate::domain::Domain;
use crate::equations::reconstruction::{smoothing_length_holding, support_volume};
use crate::exact::dust::DustError;
use crate::exact::riemann::RiemannError;
use crate::particles::{Particle, ParticleError, ParticleSet};
use crate::passes::Physics;
use crate::schemes::{Dissipation, Drag, GradH, Kernel, Viscosity};

/// The smoothing length in spacings. PL20 states none; it is what PHANTOM takes with this kernel.
const LENGTH_IN_SPACINGS: f64 = 1.0;

/// PL20 section 3: the quintic spline for everything, with its double-humped partner for drag.
pub(super) const KERNEL: Kernel = Kernel::QuinticSpline;

/// What is wrong with the choices of a scene with gas and dust.
#[derive(Debug, thiserror::Error)]
pub enum DustySceneError {
    /// So few particles that a support would meet itself around the box.
    #[error("{given} particles are too few: a support would meet itself around the box; give {enough} or more")]
    TooFew {
        /// What was asked for.
        given: usize,
        /// What works.
        enough: usize,
    },
    /// A neighbour number that no kernel can use.
    #[error("{given} neighbours: {dimension}-D needs between {least} and {most}")]
    Neighbours {
        /// What was asked for.
        given: f64,
        /// In how many dimensions.
        dimension: usize,
        /// At least.
        least: f64,
        /// At most.
        most: f64,
    },
    /// Densities, velocities or a drag coefficient that no mixture has.
    #[error(transparent)]
    Dust(#[from] DustError),
    /// A gas that is none.
    #[error(transparent)]
    Riemann(#[from] RiemannError),
    /// The particles were refused.
    #[error(transparent)]
    Particles(#[from] ParticleError),
}

/// The neighbour number, the particle included, of a smoothing length of one spacing.
pub(super) fn usual_neighbours(dimension: usize) -> f64 {
    support_volume(dimension, KERNEL.support()) * LENGTH_IN_SPACINGS.powi(dimension as i32)
}

/// Refuses a neighbour number that no kernel can use: so few that gradients fail, or more than pays.
pub(super) fn check_neighbours(given: f64, dimension: usize) -> Result<(), DustySceneError> {
    let (least, most) = NEIGHBOURS[dimension - 1];
    if (least..=most).contains(&given) {
        Ok(())
    } else {
        Err(DustySceneError::Neighbours { given, dimension, least, most })
    }
}

/// The physics of all passes, with what PL20 leaves open as in the other scenes.
pub(super) fn physics(kernel: Kernel, neighbours: f64, dissipation: Dissipation, gamma: f64, drag: Drag) -> Physics {
    Physics {
        kernel,
        neighbours,
        grad_h: GradH::Corrected,
        viscosity: Viscosity::of(dissipation),
        gamma_minus_one: gamma - 1.0,
        drag: Some(drag),
        ..Physics::STANDARD
    }
}

/// How many spacings a side must have so that no support meets itself.
pub(super) fn enough_across(kernel: Kernel, neighbours: f64, dimension: usize) -> usize {
    let reach = kernel.support() * smoothing_length_holding(neighbours, 1.0, dimension, kernel.support());
    (ROOM * 2.0 * reach).ceil() as usize
}

/// A box must be so many times a support's diameter: smoothing lengths grow a little where the flow thins out.
const ROOM: f64 = 1.05;

/// The places of a cubic lattice with so many along each axis, half a spacing from the lower ends, shifted by so many spacings along all axes.
pub(super) fn lattice<const D: usize>(counts: [usize; D], spacing: f64, shift: f64) -> Vec<[f64; D]> {
    let place = |number: usize| {
        let mut rest = number;
        std::array::from_fn(|axis| {
            let k = rest % counts[axis];
            rest /= counts[axis];
            (k as f64 + 0.5 + shift).rem_euclid(counts[axis] as f64) * spacing
        })
    };
    (0..counts.iter().product()).map(place).collect()
}

/// A box of gas and then dust.
pub(super) fn mixture<const D: usize>(
    domain: Domain<D>,
    gas: impl IntoIterator<Item = Particle<D>>,
    dust: impl IntoIterator<Item = Particle<D>>,
) -> Result<ParticleSet<D>, ParticleError> {
    let mut particles: Vec<Particle<D>> = gas.into_iter().collect();
    let of_gas = particles.len();
    particles.extend(dust.into_iter().map(|p| Particle { internal_energy: 0.0, ..p }));
    let species = (0..particles.len()).map(|i| i >= of_gas).collect();
    ParticleSet::new(domain, particles)?.with_dust(species)
}
