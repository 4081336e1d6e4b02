//! The neighbour list: for every particle the particles within reach.

use super::coordinate::{Coordinate, Scalar};
use super::error::{NeighbourError, axis_name};
use super::order::check_coordinates;
use super::search::{SEGMENT, Scratch, Search};
use super::tree::Tree;
use fearless_simd::{Level, dispatch};
use rayon::prelude::*;
use std::collections::TryReserveError;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

/// Readable entries beyond the last neighbour of any particle, see [`Segment::padded`].
pub const PADDING: usize = 16;

/// For every particle i, the indices j != i with |r_i - r_j|^2 < max(reach_i, reach_j)^2.
///
/// The square of the distance is [`distance_squared`](super::distance_squared), computed in the scalar type of the
/// coordinates, so the set is exactly the one that [`brute_force`](super::brute_force) finds. Particles at the same place are
/// neighbours. The indices of each particle ascend. The list depends on the input and on nothing else, neither on the number of
/// threads nor on the instruction set.
///
/// Particles should be sorted by [`Order`](super::Order) first: the list is right for any order, but only then fast.
///
/// The list is stored in segments of 256 consecutive particles, each with its own array of indices: segments are what
/// threads work on, and no total is needed before the first is written. Keep the list between steps: it keeps its memory.
#[derive(Debug)]
pub struct NeighbourList<C: Coordinate, const D: usize> {
    tree: Tree<C, D>,
    segments: Vec<Segment>,
    particles: usize,
    pairs: usize,
    pair_limit: usize,
}

/// The neighbours of up to 256 consecutive particles.
#[derive(Debug, Default)]
pub struct Segment {
    first: usize,
    /// Where the neighbours of each particle begin; one more entry than there are particles.
    offsets: Vec<u32>,
    /// The neighbours of all particles, then room without meaning.
    indices: Vec<u32>,
}

impl<C: Coordinate, const D: usize> Default for NeighbourList<C, D> {
    fn default() -> Self {
        Self { tree: Tree::default(), segments: Vec::new(), particles: 0, pairs: 0, pair_limit: usize::MAX }
    }
}

impl<C: Coordinate, const D: usize> NeighbourList<C, D> {
    /// A list that refuses to hold more than this number of pairs (4 bytes each; i, j and j, i are two).
    pub fn with_pair_limit(pair_limit: usize) -> Self {
        Self { pair_limit, ..Self::default() }
    }

    /// Finds all neighbours.
    ///
    /// `coordinates` are fractions of a torus with side lengths `length`, and `reach` is the support radius of each particle,
    /// in the unit of `length`. `level` says which instructions to use; it does not change the result.
    ///
    /// Errors: arrays of unequal lengths, 2^32 - 1 particles or more, a side or a support radius that is not positive and finite,
    /// a support radius above half of a side, more pairs than the limit or than memory holds. After an error the list is
    /// empty.
    pub fn build(
        &mut self,
        coordinates: [&[C]; D],
        reach: &[C::Scalar],
        length: &[f64; D],
        level: Level,
    ) -> Result<(), NeighbourError> {
        self.particles = 0;
        self.pairs = 0;
        let particles = check_coordinates(coordinates, length)?;
        if reach.len() != particles {
            return Err(NeighbourError::ArrayLength { array: "reach", expected: particles, found: reach.len() });
        }
        if particles == 0 {
            self.segments.clear();
            return Ok(());
        }
        if !self.tree.build(coordinates, reach, level) {
            return Err(invalid_reach(reach));
        }
        check_supports_fit(reach, length)?;

        self.segments.resize_with(particles.div_ceil(SEGMENT), Segment::default);
        let search = Search { coordinates, reach, unit: length.map(C::unit), tree: &self.tree };
        let pairs = AtomicUsize::new(0);
        let limit = self.pair_limit;
        self.segments.par_iter_mut().enumerate().try_for_each_init(
            Scratch::default,
            |scratch, (number, segment)| {
                if pairs.load(Relaxed) > limit {
                    return Err(NeighbourError::TooManyPairs { limit, particles });
                }
                segment.begin(number * SEGMENT);
                dispatch!(level, simd => search.segment(simd, number, scratch, segment))
                    .map_err(|_| NeighbourError::OutOfMemory { particles })?;
                segment.finish();
                if pairs.fetch_add(segment.pairs(), Relaxed) + segment.pairs() > limit {
                    return Err(NeighbourError::TooManyPairs { limit, particles });
                }
                Ok(())
            },
        )?;
        self.particles = particles;
        self.pairs = pairs.into_inner();
        Ok(())
    }

    /// The number of particles.
    pub fn particles(&self) -> usize {
        self.particles
    }

    /// The number of pairs in the list; i, j and j, i are two.
    pub fn pairs(&self) -> usize {
        self.pairs
    }

    /// The neighbours of a particle. Panics if there is no such particle.
    pub fn neighbours(&self, particle: usize) -> &[u32] {
        assert!(particle < self.particles, "particle {particle} of {}", self.particles);
        self.segments[particle / SEGMENT].neighbours(particle % SEGMENT)
    }

    /// The segments, in the order of the particles. All but the last hold [`SEGMENT`] particles.
    pub fn segments(&self) -> &[Segment] {
        if self.particles == 0 { &[] } else { &self.segments }
    }
}

impl Segment {
    /// Index of the first particle.
    pub fn first(&self) -> usize {
        self.first
    }

    /// The number of particles.
    pub fn particles(&self) -> usize {
        self.offsets.len().saturating_sub(1)
    }

    /// The number of pairs.
    #[inline]
    pub fn pairs(&self) -> usize {
        self.offsets.last().map_or(0, |end| *end as usize)
    }

    /// The neighbours of the particle `first + target`. Panics if the segment does not have that many.
    #[inline]
    pub fn neighbours(&self, target: usize) -> &[u32] {
        &self.indices[self.offsets[target] as usize..self.offsets[target + 1] as usize]
    }

    /// The neighbours of the particle `first + target` followed by [`PADDING`] further indices, and the number of neighbours.
    ///
    /// The further indices are those of some particles, no matter which: a driver may load whole vectors of neighbours and
    /// mask the lanes beyond the last one.
    #[inline]
    pub fn padded(&self, target: usize) -> (&[u32], usize) {
        let (begin, end) = (self.offsets[target] as usize, self.offsets[target + 1] as usize);
        (&self.indices[begin..end + PADDING], end - begin)
    }

    /// Forgets what it held; the first particle is now this one.
    pub(super) fn begin(&mut self, first: usize) {
        self.first = first;
        self.offsets.clear();
        self.offsets.push(0);
    }

    /// Room for so many more indices.
    #[inline(always)]
    pub(super) fn room(&mut self, room: usize) -> Result<&mut [u32], TryReserveError> {
        let used = self.pairs();
        if self.indices.len() < used + room + PADDING {
            self.grow(used + room + PADDING)?;
        }
        Ok(&mut self.indices[used..])
    }

    #[cold]
    #[inline(never)]
    fn grow(&mut self, room: usize) -> Result<(), TryReserveError> {
        // As much as the segment will hold in all if it goes on as it began, and an eighth more: most grow once or twice.
        let targets = self.particles().max(1);
        let foreseen = self.pairs() / targets * SEGMENT;
        let room = room.max(foreseen);
        let room = room + room / 8;
        self.indices.try_reserve_exact(room - self.indices.len())?;
        self.indices.resize(room, 0);
        Ok(())
    }

    /// The next target has this number of neighbours, written to the room.
    #[inline(always)]
    pub(super) fn close_target(&mut self, neighbours: usize) {
        self.offsets.push((self.pairs() + neighbours) as u32);
    }

    /// Makes the padding valid, and gives memory back when most of it is unused.
    fn finish(&mut self) {
        let used = self.pairs();
        self.indices[used..used + PADDING].fill(0);
        if self.indices.len() > 2 * used + 4096 {
            self.indices.truncate(used + PADDING);
            self.indices.shrink_to_fit();
        }
    }
}

/// The error for the first support radius that is not a positive number with a square.
#[cold]
fn invalid_reach<T: Scalar>(reach: &[T]) -> NeighbourError {
    let particle = reach.iter().position(|reach| !reach.has_a_square()).unwrap_or(0);
    NeighbourError::Reach { particle, reach: reach[particle].to_f64() }
}

/// No support sphere may overlap its own image, or a pair would meet twice.
fn check_supports_fit<T: Scalar, const D: usize>(reach: &[T], length: &[f64; D]) -> Result<(), NeighbourError> {
    let largest = reach
        .par_chunks(1 << 13)
        .map(|chunk| chunk.iter().fold(0.0, |largest, reach| f64::max(largest, reach.to_f64())))
        .reduce(|| 0.0, f64::max);
    for (axis, length) in length.iter().enumerate() {
        if 2.0 * largest > *length {
            let fits = |reach: &T| 2.0 * reach.to_f64() <= *length;
            let particle = reach.iter().position(|reach| !fits(reach)).unwrap_or(0);
            let reach = reach[particle].to_f64();
            return Err(NeighbourError::BoxTooThin { axis: axis_name(axis), length: *length, particle, reach });
        }
    }
    Ok(())
}
