//! What the driver needs of `f32` and `f64` beyond arithmetic: loading, storing, and turning records into lanes.

use crate::neighbours::Coordinate;
use etalon_kernels_gen::lanes::LaneLevel;
use etalon_kernels_gen::{Fused, Real, Reduction};
use etalon_reference::domain::{SINGLE_PLACES, UNUSED_BITS, moved, nearest};
use fearless_simd::prelude::*;
use fearless_simd::{f32x16, f64x8, i32x16, i64x8, mask32x16, mask64x8, u32x4, u32x8, u32x16, u64x4, u64x8};

/// Words of a record that are loaded together.
pub(crate) const CHUNK: usize = 4;

/// A precision the backend runs in.
pub trait Number: Real<Mask = bool> + PartialOrd + Default + Send + Sync {
    /// Coordinates of particles at this precision.
    type Coordinate: Coordinate<Scalar = Self>;
    /// A field or a coordinate as plain bits, as records hold them.
    type Word: Copy + Default + Send + Sync;
    /// Numbers in lanes.
    type Lanes<S: LaneLevel>: Real;
    /// Words in lanes.
    type Words<S: LaneLevel>: Copy;
    /// The records of as many particles as there are lanes.
    type Rows<'a>: Copy;
    /// What a lane computes, as a scalar.
    type Lane: Real<Mask = bool>;
    /// How many lanes there are.
    const LANES: usize;
    /// The precision's name.
    const NAME: &'static str;

    /// From `f64`, rounded.
    fn from_f64(value: f64) -> Self;
    /// As `f64`.
    fn to_f64(self) -> f64;
    /// As a lane.
    fn lane(self) -> Self::Lane;
    /// From a lane.
    fn from_lane(lane: Self::Lane) -> Self;
    /// The number's bits.
    fn word(self) -> Self::Word;
    /// From its bits.
    fn from_word(word: Self::Word) -> Self;
    /// The coordinate's bits.
    fn coordinate_word(coordinate: Self::Coordinate) -> Self::Word;
    /// From a coordinate of 64 bits, dropping what this precision does not keep.
    fn coordinate(bits: u64) -> Self::Coordinate;
    /// To a coordinate of 64 bits.
    fn coordinate_bits(coordinate: Self::Coordinate) -> u64;
    /// The coordinate moved by a displacement on a side of this length.
    fn moved(coordinate: Self::Coordinate, displacement: Self, length: f64) -> Self::Coordinate;

    /// As many numbers as there are lanes.
    fn load<S: LaneLevel>(values: &[Self]) -> Self::Lanes<S>;
    /// Writes all lanes.
    fn store<S: LaneLevel>(lanes: Self::Lanes<S>, out: &mut [Self]);
    /// The same number in all lanes.
    fn splat<S: LaneLevel>(value: Self) -> Self::Lanes<S>;
    /// The same coordinate in all lanes.
    fn splat_coordinate<S: LaneLevel>(coordinate: Self::Coordinate) -> Self::Words<S>;
    /// `a - b` the short way round, times the length of a unit.
    fn separation<S: LaneLevel>(a: Self::Words<S>, b: Self::Words<S>, unit: Self::Lanes<S>) -> Self::Lanes<S>;
    /// Words understood as numbers.
    fn numbers<S: LaneLevel>(words: Self::Words<S>) -> Self::Lanes<S>;
    /// The records of as many neighbours as there are lanes; each is `len` words long.
    fn rows<'a>(records: &'a [Self::Word], neighbours: &[u32], len: usize) -> Self::Rows<'a>;
    /// Words `at .. at + 4` of these records: one vector per word.
    fn transpose<S: LaneLevel>(rows: &Self::Rows<'_>, at: usize) -> [Self::Words<S>; CHUNK];
    /// True in the first `count` lanes.
    fn first_lanes<S: LaneLevel>(count: usize) -> <Self::Lanes<S> as Real>::Mask;
    /// The sum of all lanes, neighbouring lanes first.
    fn sum_lanes<S: LaneLevel>(lanes: Self::Lanes<S>) -> Self;
    /// The largest lane.
    fn max_lanes<S: LaneLevel>(lanes: Self::Lanes<S>) -> Self;
}

/// All lanes put together, neighbouring ones first: the one order of every level. There are a power of two of them.
#[inline(always)]
pub(crate) fn reduce_pairwise<T: Real>(values: &mut [T], reduction: Reduction) -> T {
    let mut width = values.len() / 2;
    while width > 0 {
        for k in 0..width {
            values[k] = reduction.combine(values[2 * k], values[2 * k + 1]);
        }
        width /= 2;
    }
    values[0]
}

/// Four vectors of four-word rows to four vectors of columns.
macro_rules! columns {
    ($v0:expr, $v1:expr, $v2:expr, $v3:expr) => {{
        let (even_low, odd_low) = $v0.deinterleave($v1);
        let (even_high, odd_high) = $v2.deinterleave($v3);
        let (x, z) = even_low.deinterleave(even_high);
        let (y, w) = odd_low.deinterleave(odd_high);
        [x, y, z, w]
    }};
}

macro_rules! number {
    (
        $float:ident, $name:literal, $lanes:literal, $coordinate:ident, $signed_lanes:ident, $float_lanes:ident,
        $word_lanes:ident, $mask:ident, $row:ident, $to_coordinate:expr, $from_coordinate:expr, $moved:expr,
        [$($lane:literal)*], |$token:ident, $rows:ident, $at:ident| $transpose:expr
    ) => {
        impl Number for $float {
            type Coordinate = $coordinate;
            type Word = $coordinate;
            type Lanes<S: LaneLevel> = $float_lanes<S>;
            type Words<S: LaneLevel> = $word_lanes<S>;
            type Rows<'a> = [&'a [$coordinate]; $lanes];
            type Lane = Fused<$float>;
            const LANES: usize = $lanes;
            const NAME: &'static str = $name;

            fn from_f64(value: f64) -> Self {
                value as $float
            }
            fn to_f64(self) -> f64 {
                f64::from(self)
            }
            #[inline(always)]
            fn lane(self) -> Fused<$float> {
                Fused(self)
            }
            #[inline(always)]
            fn from_lane(lane: Fused<$float>) -> $float {
                lane.0
            }
            #[inline(always)]
            fn word(self) -> $coordinate {
                self.to_bits()
            }
            fn from_word(word: $coordinate) -> $float {
                $float::from_bits(word)
            }
            #[inline(always)]
            fn coordinate_word(coordinate: $coordinate) -> $coordinate {
                coordinate
            }
            fn coordinate(bits: u64) -> $coordinate {
                $to_coordinate(bits)
            }
            fn coordinate_bits(coordinate: $coordinate) -> u64 {
                $from_coordinate(coordinate)
            }
            #[inline(always)]
            fn moved(coordinate: $coordinate, displacement: $float, length: f64) -> $coordinate {
                $moved(coordinate, displacement, length)
            }
            #[inline(always)]
            fn load<S: LaneLevel>(values: &[$float]) -> $float_lanes<S> {
                $float_lanes::from_slice(<S as LaneLevel>::token(), &values[..$lanes])
            }
            #[inline(always)]
            fn store<S: LaneLevel>(lanes: $float_lanes<S>, out: &mut [$float]) {
                lanes.store_slice(&mut out[..$lanes]);
            }
            #[inline(always)]
            fn splat<S: LaneLevel>(value: $float) -> $float_lanes<S> {
                $float_lanes::splat(<S as LaneLevel>::token(), value)
            }
            #[inline(always)]
            fn splat_coordinate<S: LaneLevel>(coordinate: $coordinate) -> $word_lanes<S> {
                $word_lanes::splat(<S as LaneLevel>::token(), coordinate)
            }
            #[inline(always)]
            fn separation<S: LaneLevel>(
                a: $word_lanes<S>,
                b: $word_lanes<S>,
                unit: $float_lanes<S>,
            ) -> $float_lanes<S> {
                let difference: $signed_lanes<S> = (a - b).bitcast();
                difference.to_float::<$float_lanes<S>>() * unit
            }
            #[inline(always)]
            fn numbers<S: LaneLevel>(words: $word_lanes<S>) -> $float_lanes<S> {
                words.bitcast()
            }
            #[inline(always)]
            fn rows<'a>(records: &'a [$coordinate], neighbours: &[u32], len: usize) -> Self::Rows<'a> {
                let neighbours = &neighbours[..$lanes];
                [$(&records[neighbours[$lane] as usize * len..][..len]),*]
            }
            #[inline(always)]
            fn transpose<S: LaneLevel>($rows: &Self::Rows<'_>, $at: usize) -> [$word_lanes<S>; CHUNK] {
                let $token = <S as LaneLevel>::token();
                $transpose
            }
            #[inline(always)]
            fn first_lanes<S: LaneLevel>(count: usize) -> $mask<S> {
                $mask::from_bitmask(<S as LaneLevel>::token(), (1 << count) - 1)
            }
            #[inline(always)]
            fn sum_lanes<S: LaneLevel>(lanes: $float_lanes<S>) -> $float {
                let mut values = [0.0; $lanes];
                lanes.store_slice(&mut values);
                reduce_pairwise(&mut values, Reduction::Sum)
            }
            #[inline(always)]
            fn max_lanes<S: LaneLevel>(lanes: $float_lanes<S>) -> $float {
                let mut values = [0.0; $lanes];
                lanes.store_slice(&mut values);
                reduce_pairwise(&mut values, Reduction::Max)
            }
        }
    };
}

number!(
    f32, "f32", 16, u32, i32x16, f32x16, u32x16, mask32x16, u32x4,
    |bits: u64| (bits >> 32) as u32,
    |coordinate: u32| u64::from(coordinate) << 32,
    |coordinate: u32, displacement: f32, length: f64| {
        coordinate.wrapping_add(nearest(f64::from(displacement) / length * SINGLE_PLACES) as u32)
    },
    [0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15], |token, rows, at| {
        columns!(
            four_rows(token, rows, at, 0),
            four_rows(token, rows, at, 4),
            four_rows(token, rows, at, 8),
            four_rows(token, rows, at, 12)
        )
    }
);
number!(
    f64, "f64", 8, u64, i64x8, f64x8, u64x8, mask64x8, u64x4,
    |bits: u64| bits >> UNUSED_BITS << UNUSED_BITS,
    |coordinate: u64| coordinate,
    moved,
    [0 1 2 3 4 5 6 7], |token, rows, at| {
        columns!(
            two_rows(token, rows, at, 0),
            two_rows(token, rows, at, 2),
            two_rows(token, rows, at, 4),
            two_rows(token, rows, at, 6)
        )
    }
);

/// Four words of the records `k .. k + 4`, side by side.
#[inline(always)]
fn four_rows<S: LaneLevel>(token: S, rows: &[&[u32]; 16], at: usize, k: usize) -> u32x16<S> {
    let low: u32x8<S> = four_words(token, rows[k], at).combine(four_words(token, rows[k + 1], at));
    let high: u32x8<S> = four_words(token, rows[k + 2], at).combine(four_words(token, rows[k + 3], at));
    low.combine(high)
}

#[inline(always)]
fn four_words<S: LaneLevel>(token: S, row: &[u32], at: usize) -> u32x4<S> {
    u32x4::from_slice(token, &row[at..at + CHUNK])
}

/// Four words of the records `k` and `k + 1`, side by side.
#[inline(always)]
fn two_rows<S: LaneLevel>(token: S, rows: &[&[u64]; 8], at: usize, k: usize) -> u64x8<S> {
    let low = u64x4::from_slice(token, &rows[k][at..at + CHUNK]);
    low.combine(u64x4::from_slice(token, &rows[k + 1][at..at + CHUNK]))
}
