//! The last two steps of the search: the particles near a group of targets, and those near each target.

use super::coordinate::Coordinate;
use super::lanes::{axes, compress_indices, count, counting, lanes_below, sum};
use super::list::Segment;
use super::search::Search;
use super::tree::{BoxLanes, FAN};
use fearless_simd::{Simd, prelude::*};
use std::collections::TryReserveError;

/// Particles that may be neighbours of a leaf's targets.
#[derive(Debug)]
pub(super) struct Candidates<C: Coordinate, const D: usize> {
    coordinates: [Vec<C>; D],
    reach_squared: Vec<C::Scalar>,
    index: Vec<u32>,
}

impl<C: Coordinate, const D: usize> Default for Candidates<C, D> {
    fn default() -> Self {
        Self { coordinates: std::array::from_fn(|_| Vec::new()), reach_squared: Vec::new(), index: Vec::new() }
    }
}

impl<C: Coordinate, const D: usize> Candidates<C, D> {
    fn reserve(&mut self, room: usize) {
        if self.index.len() < room {
            for axis in &mut self.coordinates {
                axis.resize(room, C::RANGE.0);
            }
            self.reach_squared.resize(room, C::Scalar::default());
            self.index.resize(room, 0);
        }
    }
}

impl<C: Coordinate, const D: usize> Search<'_, C, D> {
    /// Collects the particles of the given leaves that are within reach of the targets' box, and returns
    /// their number.
    #[inline(always)]
    pub(super) fn candidates<S: Simd>(
        &self,
        simd: S,
        targets: &BoxLanes<S, C, D>,
        unit: &[C::Floats<S>; D],
        leaves: &[u32],
        candidates: &mut Candidates<C, D>,
    ) -> usize {
        // Room for a vector of padding beyond the last candidate.
        candidates.reserve(leaves.len() * FAN + 2 * S::u32s::LEN);
        let point = C::splat(simd, C::RANGE.0);
        let mut kept = 0;
        for leaf in leaves {
            let first = *leaf as usize * FAN;
            for at in (first..first + FAN).step_by(S::u32s::LEN) {
                let lanes = at..at + S::u32s::LEN;
                let (centre, reach) = if lanes.end <= self.reach.len() {
                    let centre = axes(
                        #[inline(always)]
                        |k| C::load(simd, &self.coordinates[k][lanes.clone()]),
                    );
                    (centre, C::load_scalars(simd, &self.reach[lanes]))
                } else {
                    self.last_particles(simd, at)
                };
                let particles = BoxLanes { centre, half: [point; D], reach_squared: C::square::<S>(reach) };
                let mask = lanes_below(simd, particles.touches(targets, unit), at, self.reach.len());
                let out = kept..kept + S::u32s::LEN;
                for (axis, kept_axis) in centre.iter().zip(&mut candidates.coordinates) {
                    C::compress::<S>(*axis, mask, &mut kept_axis[out.clone()]);
                }
                C::compress_scalars::<S>(particles.reach_squared, mask, &mut candidates.reach_squared[out.clone()]);
                compress_indices::<S>(counting(simd) + at as u32, mask, &mut candidates.index[out]);
                kept += count::<S>(mask);
            }
        }
        kept
    }

    /// The particles from `at` to the last, and padding without meaning.
    #[inline(always)]
    fn last_particles<S: Simd>(&self, simd: S, at: usize) -> ([C::Integers<S>; D], C::Floats<S>) {
        let at = at.min(self.reach.len());
        let mut reach = [C::Scalar::default(); FAN];
        reach[..self.reach.len() - at].copy_from_slice(&self.reach[at..]);
        let centre = axes(
            #[inline(always)]
            |k| {
                let mut coordinates = [C::RANGE.0; FAN];
                coordinates[..self.reach.len() - at].copy_from_slice(&self.coordinates[k][at..]);
                C::load(simd, &coordinates)
            },
        );
        (centre, C::load_scalars(simd, &reach))
    }

    /// Appends the neighbours of one target, found among the first `count` candidates.
    #[inline(always)]
    pub(super) fn neighbours<S: Simd>(
        &self,
        simd: S,
        target: usize,
        unit: &[C::Floats<S>; D],
        count: usize,
        candidates: &mut Candidates<C, D>,
        segment: &mut Segment,
    ) -> Result<(), TryReserveError> {
        let lanes = S::u32s::LEN;
        let room = count.next_multiple_of(lanes);
        let own_index = S::u32s::splat(simd, target as u32);
        // The last vector is padded with the target itself, which is never its own neighbour.
        own_index.store_slice(&mut candidates.index[count..count + lanes]);

        let position: [C::Integers<S>; D] = axes(
            #[inline(always)]
            |k| C::splat(simd, self.coordinates[k][target]),
        );
        let reach_squared = C::square::<S>(C::splat_scalar(simd, self.reach[target]));
        let x: [&[C]; D] = axes(
            #[inline(always)]
            |k| &candidates.coordinates[k][..room],
        );
        let reach_squared_of = &candidates.reach_squared[..room];
        let index = &candidates.index[..room];
        let out = segment.room(room + lanes)?;
        let mut kept = 0;
        for at in (0..room).step_by(lanes) {
            let lanes = at..at + lanes;
            let squares: [C::Floats<S>; D] = axes(
                #[inline(always)]
                |k| C::separation_squared::<S>(position[k], C::load(simd, &x[k][lanes.clone()]), unit[k]),
            );
            let distance = sum::<S, C, D>(squares);
            let index = S::u32s::from_slice(simd, &index[lanes.clone()]);
            let reach_squared_of = C::load_scalars(simd, &reach_squared_of[lanes]);
            let mask = C::below_max::<S>(distance, reach_squared, reach_squared_of) & index.simd_ne(own_index);
            compress_indices::<S>(index, mask, &mut out[kept..]);
            kept += mask.to_bitmask().count_ones() as usize;
        }
        segment.close_target(kept);
        Ok(())
    }
}
