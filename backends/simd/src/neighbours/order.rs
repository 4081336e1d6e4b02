//! The order in which particles are stored: along a space-filling curve.

use super::coordinate::{Coordinate, Scalar};
use super::curve::{BLOCK, Grid};
use super::error::{NeighbourError, axis_name};
use super::radix;
use fearless_simd::{Level, Simd, dispatch};
use rayon::prelude::*;
use std::sync::atomic::AtomicU64;

/// Entries that one task works on.
const TASK: usize = 1 << 13;
/// Cells of the curve's grid per particle, as a power of two: fine enough that few particles share a cell.
const CELLS_PER_PARTICLE: u32 = 5;
/// A cell with more particles than this is ordered by a finer curve inside it.
const CROWDED: usize = 8;

/// Finds the permutation that sorts particles along a Hilbert curve over the range they occupy.
///
/// Keep one between steps: it keeps its memory. The result depends on the coordinates and on nothing else, neither on the
/// number of threads nor on the instruction set; particles that the curve cannot tell apart stay in the order they had.
///
/// ```
/// use etalon_simd::neighbours::{Coordinate, Order};
/// use fearless_simd::Level;
///
/// let x: Vec<u32> = [0.75, 0.25, 0.5].map(u32::from_fraction).to_vec();
/// let mut order = Order::default();
/// order.compute([&x], &[1.0], Level::new())?;
/// assert_eq!(order.permutation(), [1, 2, 0]);
/// let mut sorted = Vec::new();
/// order.apply(&x, &mut sorted);
/// assert_eq!(sorted, [0.25, 0.5, 0.75].map(u32::from_fraction));
/// # Ok::<(), etalon_simd::neighbours::NeighbourError>(())
/// ```
#[derive(Debug, Default)]
pub struct Order {
    entries: Vec<AtomicU64>,
    scratch: Vec<AtomicU64>,
    permutation: Vec<u32>,
}

impl Order {
    /// Computes the order of the particles with the given coordinates, in a torus with the given side lengths.
    ///
    /// Errors: coordinate arrays of unequal lengths, 2^32 - 1 particles or more, a side that is not positive and finite.
    pub fn compute<C: Coordinate, const D: usize>(
        &mut self,
        coordinates: [&[C]; D],
        length: &[f64; D],
        level: Level,
    ) -> Result<(), NeighbourError> {
        let particles = check_coordinates(coordinates, length)?;
        if particles == 0 {
            self.permutation.clear();
            return Ok(());
        }
        let (low, high) = occupied_range(coordinates);
        let resolution = usize::BITS - particles.leading_zeros() + CELLS_PER_PARTICLE;
        let grid = Grid::new(low, high, length, resolution);

        self.entries.resize_with(particles, AtomicU64::default);
        self.entries.par_chunks_mut(TASK).enumerate().for_each(|(task, entries)| {
            dispatch!(level, simd => fill_entries(simd, &grid, coordinates, task * TASK, entries));
        });
        radix::sort(&mut self.entries, &mut self.scratch, grid.key_bits());
        self.order_crowded_cells(&grid, coordinates);

        self.permutation.resize(particles, 0);
        self.permutation.par_chunks_mut(TASK).zip(self.entries.par_chunks(TASK)).for_each(|(permutation, entries)| {
            for (place, entry) in permutation.iter_mut().zip(entries) {
                *place = radix::index(entry);
            }
        });
        Ok(())
    }

    /// For each place in the new order, the index of the particle that goes there.
    pub fn permutation(&self) -> &[u32] {
        &self.permutation
    }

    /// Writes the entries of `source` to `target` in the new order: `target[place] = source[permutation[place]]`.
    ///
    /// Panics if `source` has fewer entries than there are particles.
    pub fn apply<T: Copy + Send + Sync + Default>(&self, source: &[T], target: &mut Vec<T>) {
        target.resize(self.permutation.len(), T::default());
        target.par_chunks_mut(TASK).zip(self.permutation.par_chunks(TASK)).for_each(|(target, permutation)| {
            for (place, index) in target.iter_mut().zip(permutation) {
                *place = source[*index as usize];
            }
        });
    }

    /// Sorts the particles inside of cells that hold many of them, as in strongly clustered sets.
    fn order_crowded_cells<C: Coordinate, const D: usize>(&mut self, grid: &Grid<C, D>, coordinates: [&[C]; D]) {
        // A task goes from the first cell that begins in its part of the array to the first that begins beyond.
        let count = self.entries.len();
        let first_cell_from = |at: usize| {
            let Some(before) = at.checked_sub(1).filter(|before| *before < count) else {
                return at.min(count);
            };
            let key = radix::key(&self.entries[before]);
            at + self.entries[at..].partition_point(|entry| radix::key(entry) <= key)
        };
        let bounds: Vec<usize> =
            (0..=count.div_ceil(TASK)).map(|task| first_cell_from((task * TASK).min(count))).collect();
        let mut rest = &mut self.entries[..];
        let mut tasks = Vec::with_capacity(bounds.len());
        for bound in bounds.windows(2) {
            let (task, after) = std::mem::take(&mut rest).split_at_mut(bound[1] - bound[0]);
            tasks.push(task);
            rest = after;
        }
        tasks.into_par_iter().for_each(|entries| order_cells(entries, grid, coordinates, 1));
    }
}

/// The keys of the particles from `first` on.
#[inline(always)]
fn fill_entries<S: Simd, C: Coordinate, const D: usize>(
    simd: S,
    grid: &Grid<C, D>,
    coordinates: [&[C]; D],
    first: usize,
    entries: &mut [AtomicU64],
) {
    for (block, entries) in entries.chunks_mut(BLOCK).enumerate() {
        let at = first + block * BLOCK;
        let mut points = [[C::RANGE.0; BLOCK]; D];
        for k in 0..D {
            points[k][..entries.len()].copy_from_slice(&coordinates[k][at..at + entries.len()]);
        }
        let keys = grid.keys(simd, &points);
        for (lane, entry) in entries.iter_mut().enumerate() {
            *entry = radix::entry(keys[lane], (at + lane) as u32);
        }
    }
}

/// Orders the particles of each run of equal keys by the keys of the next level.
fn order_cells<C: Coordinate, const D: usize>(
    entries: &mut [AtomicU64],
    grid: &Grid<C, D>,
    coordinates: [&[C]; D],
    level: u32,
) {
    for cell in entries.chunk_by_mut(|a, b| radix::key(a) == radix::key(b)) {
        if cell.len() <= CROWDED {
            continue;
        }
        for entry in cell.iter_mut() {
            let index = radix::index(entry);
            let point = std::array::from_fn(|k| coordinates[k][index as usize]);
            *entry = radix::entry(grid.key_at_level(point, level), index);
        }
        // Index and key together are unique, so an unstable sort has one result only.
        let order = |entry: &AtomicU64| (radix::key(entry), radix::index(entry));
        if cell.len() > TASK {
            cell.par_sort_unstable_by_key(order);
        } else {
            cell.sort_unstable_by_key(order);
        }
        if level + 1 < grid.levels() {
            order_cells(cell, grid, coordinates, level + 1);
        }
    }
}

/// The least and the greatest coordinate along each axis.
fn occupied_range<C: Coordinate, const D: usize>(coordinates: [&[C]; D]) -> ([C; D], [C; D]) {
    let range = coordinates.map(|axis| {
        let of_task =
            |task: &[C]| task.iter().fold((C::RANGE.1, C::RANGE.0), |(low, high), x| (low.min(*x), high.max(*x)));
        axis.par_chunks(TASK).map(of_task).reduce(|| (C::RANGE.1, C::RANGE.0), |a, b| (a.0.min(b.0), a.1.max(b.1)))
    });
    (range.map(|range| range.0), range.map(|range| range.1))
}

/// Checks what order and list both need, and returns the number of particles.
pub(super) fn check_coordinates<C: Coordinate, const D: usize>(
    coordinates: [&[C]; D],
    length: &[f64; D],
) -> Result<usize, NeighbourError> {
    const { assert!(D >= 1 && D <= 3, "particles live in one, two or three dimensions") };
    const NAMES: [&str; 3] = ["x", "y", "z"];
    let particles = coordinates.first().map_or(0, |axis| axis.len());
    for (axis, array) in NAMES.iter().zip(coordinates) {
        if array.len() != particles {
            return Err(NeighbourError::ArrayLength { array: axis, expected: particles, found: array.len() });
        }
    }
    // The largest number stays free, as a mark for "no particle".
    if particles >= u32::MAX as usize {
        return Err(NeighbourError::TooManyParticles { found: particles });
    }
    for (axis, length) in length.iter().enumerate() {
        if !C::Scalar::from_f64(*length).has_a_square() || !length.is_finite() {
            return Err(NeighbourError::BoxLength { axis: axis_name(axis), length: *length });
        }
    }
    Ok(particles)
}
