//! The search: from the whole tree down to the neighbours of each particle, by ever smaller shared sets.
//!
//! A *segment* is a run of 256 consecutive particles, 16 leaves. For a segment the tree is walked once, which gives the
//! leaves that may hold a neighbour of anyone in the segment. For each leaf of 16 targets these are narrowed down, first to
//! the leaves and then to the particles within reach of the box around the targets: the *candidates*. Only these are held
//! against each target. At about 100 neighbours in three dimensions a target sees about 400 candidates.
//!
//! Every step tests a vector of boxes or particles at once and keeps the hits, packed and in ascending order.

use super::candidates::Candidates;
use super::coordinate::Coordinate;
use super::lanes::{axes, compress_indices, count, counting, lanes_below};
use super::list::Segment;
use super::tree::{BoxLanes, Boxes, FAN, Tree};
use fearless_simd::{Simd, prelude::*};
use std::collections::TryReserveError;

/// Particles of a segment of the neighbour list, but for the last.
pub const SEGMENT: usize = FAN * FAN;

/// What the search works on.
#[derive(Clone, Copy)]
pub(super) struct Search<'a, C: Coordinate, const D: usize> {
    pub(super) coordinates: [&'a [C]; D],
    pub(super) reach: &'a [C::Scalar],
    pub(super) unit: [C::Scalar; D],
    pub(super) tree: &'a Tree<C, D>,
}

/// Memory for the sets of one segment at a time.
#[derive(Debug)]
pub(super) struct Scratch<C: Coordinate, const D: usize> {
    /// Boxes of a level that touch the segment, and those of the level below.
    boxes: [Vec<u32>; 2],
    /// Leaves that touch the segment, with their numbers.
    near: Boxes<C, D>,
    near_leaves: Vec<u32>,
    /// Leaves that touch the targets.
    leaves: Vec<u32>,
    candidates: Candidates<C, D>,
    /// How many pairs of a target and a candidate were tested: the measure of the work, for the tests.
    pub(super) tested: usize,
}

impl<C: Coordinate, const D: usize> Default for Scratch<C, D> {
    fn default() -> Self {
        Self {
            boxes: Default::default(),
            near: Boxes::default(),
            near_leaves: Vec::new(),
            leaves: Vec::new(),
            candidates: Candidates::default(),
            tested: 0,
        }
    }
}

/// Makes room for a number of entries.
fn reserve(entries: &mut Vec<u32>, room: usize) {
    if entries.len() < room {
        entries.resize(room, 0);
    }
}

impl<C: Coordinate, const D: usize> Search<'_, C, D> {
    /// Writes the neighbours of every particle of segment `number`.
    #[inline(always)]
    pub(super) fn segment<S: Simd>(
        &self,
        simd: S,
        number: usize,
        scratch: &mut Scratch<C, D>,
        segment: &mut Segment,
    ) -> Result<(), TryReserveError> {
        let unit = axes(
            #[inline(always)]
            |k| C::splat_scalar(simd, self.unit[k]),
        );
        let box_of_segment = self.tree.boxes(1).splat(simd, number);
        self.walk(simd, &box_of_segment, &unit, &mut scratch.boxes);
        let near = self.near_leaves(simd, &box_of_segment, &unit, scratch);

        let first_leaf = number * FAN;
        let last_leaf = (first_leaf + FAN).min(self.tree.count(0));
        for leaf in first_leaf..last_leaf {
            let box_of_leaf = self.tree.boxes(0).splat(simd, leaf);
            let leaves = self.leaves(simd, &box_of_leaf, &unit, near, scratch);
            let targets = leaf * FAN..((leaf + 1) * FAN).min(self.reach.len());

            let Scratch { leaves: numbers, candidates, tested, .. } = &mut *scratch;
            let found = self.candidates(simd, &box_of_leaf, &unit, &numbers[..leaves], candidates);
            *tested += found * targets.len();
            for target in targets {
                self.neighbours(simd, target, &unit, found, candidates, segment)?;
            }
        }
        Ok(())
    }

    /// Leaves the boxes of level 1 that touch `region` in `found[0]`.
    #[inline(always)]
    fn walk<S: Simd>(&self, simd: S, region: &BoxLanes<S, C, D>, unit: &[C::Floats<S>; D], found: &mut [Vec<u32>; 2]) {
        let [found, above] = found;
        let top = self.tree.top();
        // The boxes of the top are the children of one box that holds all.
        found.clear();
        found.push(0);
        for level in (1..=top).rev() {
            std::mem::swap(found, above);
            reserve(found, above.len() * FAN + S::u32s::LEN);
            let boxes = self.tree.boxes(level);
            let mut kept = 0;
            for parent in above.iter() {
                let first = *parent as usize * FAN;
                for at in (first..first + FAN).step_by(S::u32s::LEN) {
                    let mask = boxes.load(simd, at).touches(region, unit);
                    let mask = lanes_below(simd, mask, at, self.tree.count(level));
                    let numbers = counting(simd) + at as u32;
                    compress_indices::<S>(numbers, mask, &mut found[kept..]);
                    kept += count::<S>(mask);
                }
            }
            found.truncate(kept);
        }
    }

    /// Collects the leaves that touch the segment, and returns their number.
    #[inline(always)]
    fn near_leaves<S: Simd>(
        &self,
        simd: S,
        region: &BoxLanes<S, C, D>,
        unit: &[C::Floats<S>; D],
        scratch: &mut Scratch<C, D>,
    ) -> usize {
        let room = scratch.boxes[0].len() * FAN + S::u32s::LEN;
        scratch.near.reserve(room);
        reserve(&mut scratch.near_leaves, room);
        let leaves = self.tree.boxes(0);
        let mut kept = 0;
        for parent in &scratch.boxes[0] {
            let first = *parent as usize * FAN;
            for at in (first..first + FAN).step_by(S::u32s::LEN) {
                if at >= self.tree.count(0) {
                    break;
                }
                let boxes = leaves.load(simd, at);
                let mask = lanes_below(simd, boxes.touches(region, unit), at, self.tree.count(0));
                scratch.near.compress(boxes, mask, kept);
                compress_indices::<S>(counting(simd) + at as u32, mask, &mut scratch.near_leaves[kept..]);
                kept += count::<S>(mask);
            }
        }
        kept
    }

    /// Narrows the `near` leaves down to those that touch the targets, and returns their number.
    #[inline(always)]
    fn leaves<S: Simd>(
        &self,
        simd: S,
        targets: &BoxLanes<S, C, D>,
        unit: &[C::Floats<S>; D],
        near: usize,
        scratch: &mut Scratch<C, D>,
    ) -> usize {
        reserve(&mut scratch.leaves, near + S::u32s::LEN);
        let mut kept = 0;
        for at in (0..near).step_by(S::u32s::LEN) {
            let mask = scratch.near.load(simd, at).touches(targets, unit);
            let mask = lanes_below(simd, mask, at, near);
            let numbers = S::u32s::from_slice(simd, &scratch.near_leaves[at..at + S::u32s::LEN]);
            compress_indices::<S>(numbers, mask, &mut scratch.leaves[kept..]);
            kept += count::<S>(mask);
        }
        kept
    }
}
