//! Keys along Hilbert's curve.
//!
//! Particles that follow one another along the curve are near one another in space, in every dimension and at every
//! density: this is what makes groups of consecutive particles compact, and keeps the neighbours of a group in cache.
//!
//! The algorithm is that of J. Skilling, "Programming the Hilbert curve", AIP Conf. Proc. 707, 381 (2004): exclusive-or
//! operations only, so that all lanes work on a particle each.

use super::coordinate::Coordinate;
use super::lanes::axes;
use fearless_simd::{Simd, prelude::*};

/// Particles whose keys are computed together. A multiple of every number of lanes.
pub(super) const BLOCK: usize = 16;

/// Maps coordinates to the integer grid of the curve, with cells of equal sides in physical length.
#[derive(Debug, Clone, Copy)]
pub(super) struct Grid<C, const D: usize> {
    /// Least coordinate of each axis.
    low: [C; D],
    /// Shift that uses all 32 leading bits of the occupied range of each axis.
    shift: [u32; D],
    /// Cells along the shifted range of each axis, at most 2^bits.
    cells: [u64; D],
    /// Bits of a cell number along each axis.
    bits: u32,
}

impl<C: Coordinate, const D: usize> Grid<C, D> {
    /// Bits of a key in all, at most.
    pub(super) const KEY_BITS: u32 = 32;

    /// The grid over the occupied range `low..=high` of a torus, with about 2^`resolution` cells in that range.
    pub(super) fn new(low: [C; D], high: [C; D], length: &[f64; D], resolution: u32) -> Self {
        let shift: [u32; D] = std::array::from_fn(|k| high[k].spare_bits(low[k]));
        // Products and quotients only: they round alike on every machine, which a logarithm may not.
        let extent: [f64; D] = std::array::from_fn(|k| length[k] / (1_u64 << shift[k]) as f64);
        let longest = extent.iter().copied().fold(0.0, f64::max);
        let cells_along = |k: usize, bits: u32| extent[k] / longest * (1_u64 << bits) as f64;
        // A range that is short along some axis uses few cells there: then the others get more.
        let enough = |bits: &u32| {
            let cells: f64 = (0..D).map(|k| cells_along(k, *bits).max(1.0)).product();
            cells >= (1_u64 << resolution) as f64
        };
        let most = Self::KEY_BITS / D as u32;
        let bits = (1..=most).find(enough).unwrap_or(most);
        let cells = std::array::from_fn(|k| cells_along(k, bits) as u64);
        Self { low, shift, cells, bits }
    }

    /// Bits of a key.
    pub(super) fn key_bits(&self) -> u32 {
        self.bits * D as u32
    }

    /// How many levels of keys there are: the range of an axis is divided down to 32 bits.
    pub(super) fn levels(&self) -> u32 {
        1 + 32 / self.bits
    }

    /// The cell number along axis `k`. Level 0 is the coarse grid; each further level divides every cell of the level
    /// before it into 2^bits cells along each axis, and numbers them within that cell.
    #[inline(always)]
    fn cell(&self, k: usize, coordinate: C, level: u32) -> u32 {
        let position = u64::from(coordinate.leading_bits(self.low[k], self.shift[k])) * self.cells[k];
        // 32 bits of fraction; the last level may have fewer bits left than the others.
        let cell = if level * self.bits <= 32 {
            position >> (32 - level * self.bits)
        } else {
            position << (level * self.bits - 32)
        };
        cell as u32 & (u32::MAX >> (32 - self.bits))
    }

    /// The keys of a block of particles.
    #[inline(always)]
    pub(super) fn keys<S: Simd>(&self, simd: S, points: &[[C; BLOCK]; D]) -> [u32; BLOCK] {
        let mut cells = [[0; BLOCK]; D];
        for k in 0..D {
            for lane in 0..BLOCK {
                cells[k][lane] = self.cell(k, points[k][lane], 0);
            }
        }
        let mut keys = [0; BLOCK];
        for at in (0..BLOCK).step_by(S::u32s::LEN) {
            let lanes = at..at + S::u32s::LEN;
            let cells: [_; D] = axes(
                #[inline(always)]
                |k| S::u32s::from_slice(simd, &cells[k][lanes.clone()]),
            );
            hilbert(simd, cells, self.bits).store_slice(&mut keys[lanes]);
        }
        keys
    }

    /// The key of one particle among those of the same cell of the level before.
    pub(super) fn key_at_level(&self, point: [C; D], level: u32) -> u32 {
        let cells: [_; D] = std::array::from_fn(|k| self.cell(k, point[k], level));
        hilbert_scalar(cells, self.bits)
    }
}

/// The position along Hilbert's curve of cells numbered with `bits` bits along each of D axes.
#[inline(always)]
fn hilbert<S: Simd, const D: usize>(simd: S, mut x: [S::u32s; D], bits: u32) -> S::u32s {
    let zero = S::u32s::splat(simd, 0);
    for bit in (1..bits).rev() {
        let below = (1 << bit) - 1;
        for k in 0..D {
            // All bits set where this bit of axis k is set.
            let set = zero - ((x[k] >> bit) & 1);
            let swap = (x[0] ^ x[k]) & !set & below;
            x[0] ^= (set & below) | swap;
            x[k] ^= swap;
        }
    }
    for k in 1..D {
        let before = x[k - 1];
        x[k] ^= before;
    }
    let mut flip = zero;
    for bit in (1..bits).rev() {
        let set = zero - ((x[D - 1] >> bit) & 1);
        flip ^= set & ((1 << bit) - 1);
    }
    let mut key = zero;
    for axis in x {
        key = (key << 1) | spread::<S, D>(axis ^ flip);
    }
    key
}

/// Moves bit b to bit b * D.
#[inline(always)]
fn spread<S: Simd, const D: usize>(x: S::u32s) -> S::u32s {
    match D {
        2 => {
            let x = (x | (x << 8)) & 0x00ff_00ff;
            let x = (x | (x << 4)) & 0x0f0f_0f0f;
            let x = (x | (x << 2)) & 0x3333_3333;
            (x | (x << 1)) & 0x5555_5555
        }
        3 => {
            let x = (x | (x << 16)) & 0x0300_00ff;
            let x = (x | (x << 8)) & 0x0300_f00f;
            let x = (x | (x << 4)) & 0x030c_30c3;
            (x | (x << 2)) & 0x0924_9249
        }
        _ => x,
    }
}

/// The same as [`hilbert`] for one particle, written as in Skilling's paper.
fn hilbert_scalar<const D: usize>(mut x: [u32; D], bits: u32) -> u32 {
    for bit in (1..bits).rev() {
        let below = (1 << bit) - 1;
        for k in 0..D {
            if x[k] >> bit & 1 == 1 {
                x[0] ^= below;
            } else {
                let swap = (x[0] ^ x[k]) & below;
                x[0] ^= swap;
                x[k] ^= swap;
            }
        }
    }
    for k in 1..D {
        x[k] ^= x[k - 1];
    }
    let mut flip = 0;
    for bit in (1..bits).rev() {
        if x[D - 1] >> bit & 1 == 1 {
            flip ^= (1 << bit) - 1;
        }
    }
    let mut key = 0;
    for bit in (0..bits).rev() {
        for axis in x {
            key = key << 1 | (axis ^ flip) >> bit & 1;
        }
    }
    key
}

#[cfg(test)]
mod tests {
    use super::*;
    use fearless_simd::{Level, dispatch};

    /// All cells of a grid, sorted along the curve, form a path of steps of length one that visits each cell once; and the
    /// lane version agrees with the scalar one.
    fn walk<const D: usize>(bits: u32) {
        let side = 1u32 << bits;
        let cells: Vec<[u32; D]> =
            (0..side.pow(D as u32)).map(|n| std::array::from_fn(|k| n / side.pow(k as u32) % side)).collect();
        let mut path = vec![None; cells.len()];
        for cell in &cells {
            let key = hilbert_scalar(*cell, bits);
            assert!(path[key as usize].replace(*cell).is_none(), "two cells at key {key}");
        }
        let path: Vec<[u32; D]> = path.into_iter().map(|cell| cell.expect("a cell at every key")).collect();
        for pair in path.windows(2) {
            let steps: u32 = (0..D).map(|k| pair[0][k].abs_diff(pair[1][k])).sum();
            assert_eq!(steps, 1, "{:?} and {:?} follow one another", pair[0], pair[1]);
        }
        for block in cells.chunks(BLOCK) {
            let expected: Vec<u32> = block.iter().map(|cell| hilbert_scalar(*cell, bits)).collect();
            let lanes = dispatch!(Level::new(), simd => block_keys(simd, block, bits));
            assert_eq!(lanes[..block.len()], expected, "D = {D}, {bits} bits");
        }
    }

    #[inline(always)]
    fn block_keys<S: Simd, const D: usize>(simd: S, block: &[[u32; D]], bits: u32) -> [u32; BLOCK] {
        let mut keys = [0; BLOCK];
        for at in (0..BLOCK).step_by(S::u32s::LEN) {
            let cell = |lane: usize, k: usize| block.get(at + lane).map_or(0, |cell| cell[k]);
            let cells: [_; D] = std::array::from_fn(|k| S::u32s::from_fn(simd, |lane| cell(lane, k)));
            hilbert(simd, cells, bits).store_slice(&mut keys[at..at + S::u32s::LEN]);
        }
        keys
    }

    #[test]
    fn the_curve_steps_from_neighbour_to_neighbour() {
        walk::<1>(6);
        walk::<2>(1);
        walk::<2>(5);
        walk::<3>(1);
        walk::<3>(4);
    }

    #[test]
    fn levels_refine_one_another() {
        // Two points that differ in one bit of the 32 are told apart at the level that holds that bit.
        for bit in 0..32 {
            let grid = Grid::<u32, 3>::new([0; 3], [u32::MAX; 3], &[1.0; 3], 24);
            assert_eq!(grid.bits, 8);
            let level_of_bit = (31 - bit) / 8;
            for level in 0..grid.levels() {
                let differ = grid.key_at_level([0; 3], level) != grid.key_at_level([0, 1 << bit, 0], level);
                assert_eq!(differ, level == level_of_bit, "bit {bit}, level {level}");
            }
        }
    }

    #[test]
    fn cells_are_cubes_in_physical_length() {
        // A tube ten times as long as wide, at an eighth of the torus along x only.
        let high = [u32::MAX / 8, u32::MAX, u32::MAX];
        let grid = Grid::<u32, 3>::new([0; 3], high, &[80.0, 1.0, 1.0], 20);
        assert_eq!(grid.shift, [3, 0, 0]);
        // 20 bits for a tube that fills 1/100 of its bounding cube: 2^26.6 cells, 9 bits along each axis.
        assert_eq!(grid.bits, 9);
        assert_eq!(grid.cells, [512, 51, 51]);
    }
}
