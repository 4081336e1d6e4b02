//! Walls that reflect, exactly: a box and its mirror image beside it, periodic together.
//!
//! What is symmetric stays so, and nothing that is crosses the planes of symmetry: the lower end of the box and the upper one, where it meets its
//! image. It costs twice the particles and needs nothing of any engine. Place and velocity of an image follow those of its original to rounding.

use crate::domain::Domain;
use crate::particles::{Particle, ParticleError, ParticleSet};

/// Why there is no mirror image.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MirrorError {
    /// The box has no such axis.
    #[error("there is no axis {axis} in {dimension}-D: count from 0")]
    Axis {
        /// What was given.
        axis: usize,
        /// In how many dimensions.
        dimension: usize,
    },
    /// A particle that is its own image.
    #[error("particle {particle} lies on a wall that reflects, at {value} on axis {axis}; put it inside the box")]
    OnWall {
        /// Which particle, from 0.
        particle: usize,
        /// Which axis, from 0.
        axis: usize,
        /// Where.
        value: f64,
    },
    /// The two together were refused.
    #[error(transparent)]
    Particles(#[from] ParticleError),
}

/// The particles and their mirror images beyond the box's upper end along an axis, in a box of twice the length that is periodic along it.
///
/// Particle `i` keeps its number, its image is number `i + n`. Only the first half is of interest: lower and upper end of the box given are walls
/// that reflect. Whether that axis was periodic before does not matter.
///
/// # Errors
/// An axis that there is not, a particle on one of the walls.
pub fn mirrored<const D: usize>(set: &ParticleSet<D>, axis: usize) -> Result<ParticleSet<D>, MirrorError> {
    if axis >= D {
        return Err(MirrorError::Axis { axis, dimension: D });
    }
    let (lower, mut upper, mut periodic) = (set.domain().lower(), set.domain().upper(), set.domain().periodic());
    upper[axis] += upper[axis] - lower[axis];
    periodic[axis] = true;
    let domain = Domain::new(lower, upper, periodic).map_err(ParticleError::from)?;
    let (mut originals, mut images) = (Vec::new(), Vec::new());
    for (particle, original) in set.particles().iter().enumerate() {
        let place = domain.encode(axis, original.position[axis]);
        let image = place.wrapping_neg();
        // The two places that are their own images: zero, and half the way round.
        if image == place {
            return Err(MirrorError::OnWall { particle, axis, value: original.position[axis] });
        }
        // Both from the grid of places, on which one is exactly as far from the wall as the other.
        let at = |place: u64, sign: f64| {
            let mut copy: Particle<D> = *original;
            copy.position[axis] = domain.decode(axis, place);
            copy.velocity[axis] *= sign;
            copy
        };
        originals.push(at(place, 1.0));
        images.push(at(image, -1.0));
    }
    originals.append(&mut images);
    Ok(ParticleSet::new(domain, originals)?)
}
