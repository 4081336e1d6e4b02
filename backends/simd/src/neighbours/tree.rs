//! A tree of boxes over the sorted particles.
//!
//! Particles are sorted along a space-filling curve, so any run of consecutive particles is compact. A *leaf* is a run of
//! 16, and every box further up has 16 consecutive boxes below it: no pointers, no cells, nothing to balance. A box knows
//! its centre, its half widths and the largest support radius inside. It is therefore as small as the particles are dense,
//! empty space costs nothing, and a region of small supports does not pay for large supports elsewhere.

use super::coordinate::{Coordinate, Scalar};
use super::lanes::{axes, sum};
use fearless_simd::{Level, Simd, dispatch, prelude::*};
use rayon::prelude::*;

/// Boxes below a box, and particles in a leaf. A multiple of every number of lanes.
pub(super) const FAN: usize = 16;
/// Leaves that one task works on.
const TASK: usize = 1 << 8;

/// The boxes of one level, in the order of the particles.
#[derive(Debug)]
pub(super) struct Boxes<C: Coordinate, const D: usize> {
    /// Centre along each axis.
    pub(super) centre: [Vec<C>; D],
    /// Half width along each axis.
    pub(super) half: [Vec<C>; D],
    /// Square of the largest support radius inside.
    pub(super) reach_squared: Vec<C::Scalar>,
}

impl<C: Coordinate, const D: usize> Default for Boxes<C, D> {
    fn default() -> Self {
        Self {
            centre: std::array::from_fn(|_| Vec::new()),
            half: std::array::from_fn(|_| Vec::new()),
            reach_squared: Vec::new(),
        }
    }
}

impl<C: Coordinate, const D: usize> Boxes<C, D> {
    /// Makes room for this many boxes; what is in the room has no meaning.
    pub(super) fn resize(&mut self, room: usize) {
        for axis in self.centre.iter_mut().chain(&mut self.half) {
            axis.resize(room, C::RANGE.0);
        }
        self.reach_squared.resize(room, C::Scalar::default());
    }

    /// Grows the room where it is too small.
    pub(super) fn reserve(&mut self, room: usize) {
        if self.reach_squared.len() < room {
            self.resize(room);
        }
    }

    /// One box in all lanes.
    #[inline(always)]
    pub(super) fn splat<S: Simd>(&self, simd: S, at: usize) -> BoxLanes<S, C, D> {
        BoxLanes {
            centre: axes(
                #[inline(always)]
                |k| C::splat(simd, self.centre[k][at]),
            ),
            half: axes(
                #[inline(always)]
                |k| C::splat(simd, self.half[k][at]),
            ),
            reach_squared: C::splat_scalar(simd, self.reach_squared[at]),
        }
    }

    /// As many consecutive boxes as there are lanes.
    #[inline(always)]
    pub(super) fn load<S: Simd>(&self, simd: S, at: usize) -> BoxLanes<S, C, D> {
        let lanes = at..at + S::u32s::LEN;
        BoxLanes {
            centre: axes(
                #[inline(always)]
                |k| C::load(simd, &self.centre[k][lanes.clone()]),
            ),
            half: axes(
                #[inline(always)]
                |k| C::load(simd, &self.half[k][lanes.clone()]),
            ),
            reach_squared: C::load_scalars(simd, &self.reach_squared[lanes]),
        }
    }

    /// Writes the boxes chosen by `mask` from `at` on, and whatever it likes up to a vector's worth.
    #[inline(always)]
    pub(super) fn compress<S: Simd>(&mut self, boxes: BoxLanes<S, C, D>, mask: S::mask32s, at: usize) {
        let lanes = at..at + S::u32s::LEN;
        for k in 0..D {
            C::compress::<S>(boxes.centre[k], mask, &mut self.centre[k][lanes.clone()]);
            C::compress::<S>(boxes.half[k], mask, &mut self.half[k][lanes.clone()]);
        }
        C::compress_scalars::<S>(boxes.reach_squared, mask, &mut self.reach_squared[lanes]);
    }
}

/// A box in every lane.
#[derive(Clone, Copy)]
pub(super) struct BoxLanes<S: Simd, C: Coordinate, const D: usize> {
    pub(super) centre: [C::Integers<S>; D],
    pub(super) half: [C::Integers<S>; D],
    pub(super) reach_squared: C::Floats<S>,
}

impl<S: Simd, C: Coordinate, const D: usize> BoxLanes<S, C, D> {
    /// The lanes in which a pair of neighbours may have one partner in this and one in the other box.
    ///
    /// Never misses one: gaps are rounded like separations, see [`gap_squared`](super::lanes::LaneCoordinate::gap_squared).
    #[inline(always)]
    pub(super) fn touches(&self, other: &Self, unit: &[C::Floats<S>; D]) -> S::mask32s {
        let gaps: [C::Floats<S>; D] = axes(
            #[inline(always)]
            |k| {
                let (a, b) = ([self.centre[k], self.half[k]], [other.centre[k], other.half[k]]);
                C::gap_squared::<S>(a, b, unit[k])
            },
        );
        let distance = sum::<S, C, D>(gaps);
        C::below_max::<S>(distance, self.reach_squared, other.reach_squared)
    }
}

/// The boxes of all levels; level 0 holds the leaves, the last level has at most 16 boxes. There are at least two levels.
#[derive(Debug)]
pub(super) struct Tree<C: Coordinate, const D: usize> {
    levels: Vec<Boxes<C, D>>,
    counts: Vec<usize>,
}

impl<C: Coordinate, const D: usize> Default for Tree<C, D> {
    fn default() -> Self {
        Self { levels: Vec::new(), counts: Vec::new() }
    }
}

impl<C: Coordinate, const D: usize> Tree<C, D> {
    /// Builds the tree of the given particles; false if some support radius is not a positive number with a square.
    pub(super) fn build(&mut self, coordinates: [&[C]; D], reach: &[C::Scalar], level: Level) -> bool {
        self.counts.clear();
        let mut count = reach.len().div_ceil(FAN);
        self.counts.push(count);
        while self.counts.len() < 2 || count > FAN {
            count = count.div_ceil(FAN);
            self.counts.push(count);
        }
        self.levels.resize_with(self.counts.len(), Boxes::default);
        for (boxes, count) in self.levels.iter_mut().zip(&self.counts) {
            // Boxes are loaded by whole vectors.
            boxes.resize(count.next_multiple_of(FAN));
        }

        let count = self.counts[0];
        let valid = self.levels[0]
            .tasks(count)
            .map(|task| dispatch!(level, _simd => task.enclose_particles(coordinates, reach)))
            .reduce(|| true, |a, b| a && b);
        for upper in 1..self.levels.len() {
            let (below, above) = self.levels.split_at_mut(upper);
            let children = self.counts[upper - 1];
            above[0].tasks(self.counts[upper]).for_each(|task| task.enclose_boxes(&below[upper - 1], children));
        }
        valid
    }

    /// The boxes of a level.
    pub(super) fn boxes(&self, level: usize) -> &Boxes<C, D> {
        &self.levels[level]
    }

    /// How many boxes a level has.
    pub(super) fn count(&self, level: usize) -> usize {
        self.counts[level]
    }

    /// The uppermost level.
    pub(super) fn top(&self) -> usize {
        self.levels.len() - 1
    }
}

/// A run of boxes to be filled in.
struct Task<'a, C: Coordinate, const D: usize> {
    first: usize,
    centre: [&'a mut [C]; D],
    half: [&'a mut [C]; D],
    reach_squared: &'a mut [C::Scalar],
}

impl<C: Coordinate, const D: usize> Boxes<C, D> {
    /// Cuts the first `count` boxes into runs for as many tasks.
    fn tasks(&mut self, count: usize) -> impl ParallelIterator<Item = Task<'_, C, D>> {
        let mut centre = self.centre.each_mut().map(|axis| axis[..count].chunks_mut(TASK));
        let mut half = self.half.each_mut().map(|axis| axis[..count].chunks_mut(TASK));
        let tasks: Vec<_> = self.reach_squared[..count]
            .chunks_mut(TASK)
            .enumerate()
            .map(|(task, reach_squared)| Task {
                first: task * TASK,
                centre: centre.each_mut().map(|chunks| chunks.next().unwrap_or_default()),
                half: half.each_mut().map(|chunks| chunks.next().unwrap_or_default()),
                reach_squared,
            })
            .collect();
        tasks.into_par_iter()
    }
}

impl<C: Coordinate, const D: usize> Task<'_, C, D> {
    /// Encloses 16 particles in each box; false if some support radius is not valid.
    #[inline(always)]
    fn enclose_particles(self, coordinates: [&[C]; D], reach: &[C::Scalar]) -> bool {
        let mut valid = true;
        for at in 0..self.reach_squared.len() {
            let begin = (self.first + at) * FAN;
            let end = (begin + FAN).min(reach.len());
            for (k, axis) in coordinates.iter().enumerate() {
                (self.centre[k][at], self.half[k][at]) = C::interval(&axis[begin..end]);
            }
            let mut largest = C::Scalar::default();
            for reach in &reach[begin..end] {
                valid &= reach.has_a_square();
                largest = if *reach > largest { *reach } else { largest };
            }
            self.reach_squared[at] = largest * largest;
        }
        valid
    }

    /// Encloses 16 boxes of the level below, which has `children` boxes, in each box.
    fn enclose_boxes(self, below: &Boxes<C, D>, children: usize) {
        for at in 0..self.reach_squared.len() {
            let begin = (self.first + at) * FAN;
            let end = (begin + FAN).min(children);
            for k in 0..D {
                (self.centre[k][at], self.half[k][at]) =
                    C::hull(&below.centre[k][begin..end], &below.half[k][begin..end]);
            }
            let mut largest = C::Scalar::default();
            for reach_squared in &below.reach_squared[begin..end] {
                largest = if *reach_squared > largest { *reach_squared } else { largest };
            }
            self.reach_squared[at] = largest;
        }
    }
}
