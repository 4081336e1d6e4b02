//! What can be wrong with the input of a neighbour search.

use thiserror::Error;

/// The reason why an order or a neighbour list was not made.
///
/// Every message names the offending input and what to do about it.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum NeighbourError {
    /// An input array does not have one entry for every particle.
    #[error(
        "the array `{array}` has {found} entries but there are {expected} particles; give every array one entry for every particle"
    )]
    ArrayLength {
        /// Name of the offending array.
        array: &'static str,
        /// Number of particles, taken from the first coordinate array.
        expected: usize,
        /// Number of entries found.
        found: usize,
    },
    /// Particles are counted with 32 bits.
    #[error(
        "{found} particles are too many: the neighbour list numbers particles with 32 bits; use fewer than 4294967295"
    )]
    TooManyParticles {
        /// Number of particles given.
        found: usize,
    },
    /// A side of the torus is not a positive, finite number.
    #[error(
        "the box has length {length} along axis {axis}; every side must be positive, finite, and neither so small nor so large that its square leaves the range of the arithmetic"
    )]
    BoxLength {
        /// Name of the axis: x, y or z.
        axis: char,
        /// The length given.
        length: f64,
    },
    /// A support radius is not a positive, finite number.
    #[error(
        "particle {particle} has support radius {reach}; every support radius (kernel radius times smoothing length) must be positive, finite, and neither so small nor so large that its square leaves the range of the arithmetic"
    )]
    Reach {
        /// Index of the first offending particle.
        particle: usize,
        /// Its support radius.
        reach: f64,
    },
    /// A support sphere would overlap its own periodic image.
    #[error(
        "box too thin for the support along axis {axis}: particle {particle} has support radius {reach}, more than half of the length {length}; make the box longer along {axis} (repeat the particles) or use smaller smoothing lengths"
    )]
    BoxTooThin {
        /// Name of the axis: x, y or z.
        axis: char,
        /// Length of the box along that axis.
        length: f64,
        /// Index of the first particle whose support does not fit.
        particle: usize,
        /// Its support radius.
        reach: f64,
    },
    /// The list would hold more pairs than the caller allows.
    #[error(
        "the neighbour list would hold more than {limit} pairs for {particles} particles; use smaller smoothing lengths or fewer particles, or raise the limit if the memory is there (4 bytes a pair)"
    )]
    TooManyPairs {
        /// The limit in force.
        limit: usize,
        /// Number of particles.
        particles: usize,
    },
    /// The memory for the list could not be had.
    #[error(
        "no memory for the neighbour list of {particles} particles (4 bytes a pair); use smaller smoothing lengths or fewer particles"
    )]
    OutOfMemory {
        /// Number of particles.
        particles: usize,
    },
}

/// Name of axis 0, 1 or 2, for messages.
pub(super) fn axis_name(axis: usize) -> char {
    ['x', 'y', 'z'].get(axis).copied().unwrap_or('?')
}
