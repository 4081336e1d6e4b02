//! The lane arithmetic of the search, once for each representation of a coordinate.
//!
//! A *vector* here has as many lanes as the processor's native vector has 32-bit lanes: 16 with AVX-512, 8 with AVX2, 4
//! with NEON and SSE. A `u32` vector is one register, a `u64` vector two. Results do not depend on the number of lanes,
//! because every lane is computed on its own and hits are appended in ascending order.

use super::coordinate::Scalar;
use fearless_simd::{Simd, prelude::*};

/// Lane operations on coordinates and on their scalars. Implemented for `u32` (with `f32`) and `u64` (with `f64`).
pub trait LaneCoordinate: Sized {
    /// The number in which separations are computed.
    type Scalar: Scalar;
    /// A vector of coordinates.
    type Integers<S: Simd>: Copy;
    /// A vector of scalars.
    type Floats<S: Simd>: Copy;

    /// The same coordinate in every lane.
    fn splat<S: Simd>(simd: S, value: Self) -> Self::Integers<S>;
    /// The first lanes' worth of coordinates of a slice, which must hold as many.
    fn load<S: Simd>(simd: S, values: &[Self]) -> Self::Integers<S>;
    /// The same scalar in every lane.
    fn splat_scalar<S: Simd>(simd: S, value: Self::Scalar) -> Self::Floats<S>;
    /// The first lanes' worth of scalars of a slice, which must hold as many.
    fn load_scalars<S: Simd>(simd: S, values: &[Self::Scalar]) -> Self::Floats<S>;

    /// The square of the separation `a - b`, rounded as in [`super::distance_squared`].
    fn separation_squared<S: Simd>(
        a: Self::Integers<S>,
        b: Self::Integers<S>,
        unit: Self::Floats<S>,
    ) -> Self::Floats<S>;
    /// The square of the gap between two intervals of the torus, each given by its centre and half width; zero if they touch.
    ///
    /// Every step is monotone, rounding included, so that the gap is never above a
    /// [`separation_squared`](Self::separation_squared) between points of the two intervals: no safety margin is needed.
    fn gap_squared<S: Simd>(
        a: [Self::Integers<S>; 2],
        b: [Self::Integers<S>; 2],
        unit: Self::Floats<S>,
    ) -> Self::Floats<S>;
    /// Lane-wise sum.
    fn add<S: Simd>(a: Self::Floats<S>, b: Self::Floats<S>) -> Self::Floats<S>;
    /// Lane-wise product.
    fn square<S: Simd>(a: Self::Floats<S>) -> Self::Floats<S>;
    /// Lane-wise `distance < max(a, b)`.
    fn below_max<S: Simd>(distance: Self::Floats<S>, a: Self::Floats<S>, b: Self::Floats<S>) -> S::mask32s;

    /// Writes the lanes chosen by `mask` to `out`, one beside the other. Overwrites a whole vector's worth of `out`, which
    /// must hold as many.
    fn compress<S: Simd>(values: Self::Integers<S>, mask: S::mask32s, out: &mut [Self]);
    /// The same for scalars.
    fn compress_scalars<S: Simd>(values: Self::Floats<S>, mask: S::mask32s, out: &mut [Self::Scalar]);
}

/// The lanes that hold entries below `count`, when the first lane holds entry `at`.
#[inline(always)]
pub(super) fn lanes_below<S: Simd>(simd: S, mask: S::mask32s, at: usize, count: usize) -> S::mask32s {
    if at + S::u32s::LEN <= count {
        mask
    } else {
        mask & S::mask32s::from_bitmask(simd, (1 << count.saturating_sub(at)) - 1)
    }
}

/// The numbers 0, 1, 2, ...
#[inline(always)]
pub(super) fn counting<S: Simd>(simd: S) -> S::u32s {
    S::u32s::from_fn(simd, |lane| lane as u32)
}

/// How many lanes are chosen.
#[inline(always)]
pub(super) fn count<S: Simd>(mask: S::mask32s) -> usize {
    mask.to_bitmask().count_ones() as usize
}

/// Writes the indices chosen by `mask` to `out`, one beside the other. Overwrites a whole vector's worth of `out`, which
/// must hold as many.
#[inline(always)]
pub(super) fn compress_indices<S: Simd>(indices: S::u32s, mask: S::mask32s, out: &mut [u32]) {
    indices.compress(mask).store_slice(&mut out[..S::u32s::LEN]);
}

/// An array with the value of `f` for each axis.
///
/// As `std::array::from_fn`, but surely inlined: inside of vector code a call that is left costs far more than the work. The
/// closure must be `#[inline(always)]` too.
#[inline(always)]
pub(super) fn axes<T: Copy, const D: usize>(f: impl Fn(usize) -> T) -> [T; D] {
    let mut all = [f(0); D];
    for (k, value) in all.iter_mut().enumerate().skip(1) {
        *value = f(k);
    }
    all
}

/// The sum over the axes, from the first to the last.
#[inline(always)]
pub(super) fn sum<S: Simd, C: LaneCoordinate, const D: usize>(terms: [C::Floats<S>; D]) -> C::Floats<S> {
    let mut sum = terms[0];
    for term in &terms[1..] {
        sum = C::add::<S>(sum, *term);
    }
    sum
}

impl LaneCoordinate for u32 {
    type Scalar = f32;
    type Integers<S: Simd> = S::u32s;
    type Floats<S: Simd> = S::f32s;

    #[inline(always)]
    fn splat<S: Simd>(simd: S, value: u32) -> S::u32s {
        S::u32s::splat(simd, value)
    }

    #[inline(always)]
    fn load<S: Simd>(simd: S, values: &[u32]) -> S::u32s {
        S::u32s::from_slice(simd, &values[..S::u32s::LEN])
    }

    #[inline(always)]
    fn splat_scalar<S: Simd>(simd: S, value: f32) -> S::f32s {
        S::f32s::splat(simd, value)
    }

    #[inline(always)]
    fn load_scalars<S: Simd>(simd: S, values: &[f32]) -> S::f32s {
        S::f32s::from_slice(simd, &values[..S::f32s::LEN])
    }

    #[inline(always)]
    fn separation_squared<S: Simd>(a: S::u32s, b: S::u32s, unit: S::f32s) -> S::f32s {
        let difference: S::i32s = (a - b).bitcast();
        let separation = difference.to_float::<S::f32s>() * unit;
        separation * separation
    }

    #[inline(always)]
    fn gap_squared<S: Simd>(a: [S::u32s; 2], b: [S::u32s; 2], unit: S::f32s) -> S::f32s {
        let [centre_a, half_a] = a;
        let [centre_b, half_b] = b;
        let between: S::i32s = (centre_a - centre_b).bitcast();
        // Half of the torus, 2^31, is its own wrapping absolute value; as unsigned it is right, and in the end as signed
        // it is so up to the sign, which the square removes.
        let between: S::u32s = between.abs().bitcast();
        let gap: S::i32s = between.saturating_sub(half_a).saturating_sub(half_b).bitcast();
        let gap = gap.to_float::<S::f32s>() * unit;
        gap * gap
    }

    #[inline(always)]
    fn add<S: Simd>(a: S::f32s, b: S::f32s) -> S::f32s {
        a + b
    }

    #[inline(always)]
    fn square<S: Simd>(a: S::f32s) -> S::f32s {
        a * a
    }

    #[inline(always)]
    fn below_max<S: Simd>(distance: S::f32s, a: S::f32s, b: S::f32s) -> S::mask32s {
        distance.simd_lt(a.max(b))
    }

    #[inline(always)]
    fn compress<S: Simd>(values: S::u32s, mask: S::mask32s, out: &mut [u32]) {
        values.compress(mask).store_slice(&mut out[..S::u32s::LEN]);
    }

    #[inline(always)]
    fn compress_scalars<S: Simd>(values: S::f32s, mask: S::mask32s, out: &mut [f32]) {
        values.compress(mask).store_slice(&mut out[..S::f32s::LEN]);
    }
}

impl LaneCoordinate for u64 {
    type Scalar = f64;
    type Integers<S: Simd> = [S::u64s; 2];
    type Floats<S: Simd> = [S::f64s; 2];

    #[inline(always)]
    fn splat<S: Simd>(simd: S, value: u64) -> [S::u64s; 2] {
        [S::u64s::splat(simd, value); 2]
    }

    #[inline(always)]
    fn load<S: Simd>(simd: S, values: &[u64]) -> [S::u64s; 2] {
        let half = S::u64s::LEN;
        [S::u64s::from_slice(simd, &values[..half]), S::u64s::from_slice(simd, &values[half..2 * half])]
    }

    #[inline(always)]
    fn splat_scalar<S: Simd>(simd: S, value: f64) -> [S::f64s; 2] {
        [S::f64s::splat(simd, value); 2]
    }

    #[inline(always)]
    fn load_scalars<S: Simd>(simd: S, values: &[f64]) -> [S::f64s; 2] {
        let half = S::f64s::LEN;
        [S::f64s::from_slice(simd, &values[..half]), S::f64s::from_slice(simd, &values[half..2 * half])]
    }

    #[inline(always)]
    fn separation_squared<S: Simd>(a: [S::u64s; 2], b: [S::u64s; 2], unit: [S::f64s; 2]) -> [S::f64s; 2] {
        [separation_squared_f64::<S>(a[0], b[0], unit[0]), separation_squared_f64::<S>(a[1], b[1], unit[1])]
    }

    #[inline(always)]
    fn gap_squared<S: Simd>(a: [[S::u64s; 2]; 2], b: [[S::u64s; 2]; 2], unit: [S::f64s; 2]) -> [S::f64s; 2] {
        let [centre_a, half_a] = a;
        let [centre_b, half_b] = b;
        [
            gap_squared_f64::<S>([centre_a[0], half_a[0]], [centre_b[0], half_b[0]], unit[0]),
            gap_squared_f64::<S>([centre_a[1], half_a[1]], [centre_b[1], half_b[1]], unit[1]),
        ]
    }

    #[inline(always)]
    fn add<S: Simd>(a: [S::f64s; 2], b: [S::f64s; 2]) -> [S::f64s; 2] {
        [a[0] + b[0], a[1] + b[1]]
    }

    #[inline(always)]
    fn square<S: Simd>(a: [S::f64s; 2]) -> [S::f64s; 2] {
        [a[0] * a[0], a[1] * a[1]]
    }

    #[inline(always)]
    fn below_max<S: Simd>(distance: [S::f64s; 2], a: [S::f64s; 2], b: [S::f64s; 2]) -> S::mask32s {
        let low = distance[0].simd_lt(a[0].max(b[0]));
        let high = distance[1].simd_lt(a[1].max(b[1]));
        low.narrow(high)
    }

    #[inline(always)]
    fn compress<S: Simd>(values: [S::u64s; 2], mask: S::mask32s, out: &mut [u64]) {
        let (low, high) = mask.widen();
        let lanes = S::u64s::LEN;
        let count = low.to_bitmask().count_ones() as usize;
        values[0].compress(low).store_slice(&mut out[..lanes]);
        values[1].compress(high).store_slice(&mut out[count..count + lanes]);
    }

    #[inline(always)]
    fn compress_scalars<S: Simd>(values: [S::f64s; 2], mask: S::mask32s, out: &mut [f64]) {
        let (low, high) = mask.widen();
        let lanes = S::f64s::LEN;
        let count = low.to_bitmask().count_ones() as usize;
        values[0].compress(low).store_slice(&mut out[..lanes]);
        values[1].compress(high).store_slice(&mut out[count..count + lanes]);
    }
}

/// One register of [`LaneCoordinate::separation_squared`].
#[inline(always)]
fn separation_squared_f64<S: Simd>(a: S::u64s, b: S::u64s, unit: S::f64s) -> S::f64s {
    let difference: S::i64s = (a - b).bitcast();
    let separation = difference.to_float::<S::f64s>() * unit;
    separation * separation
}

/// One register of [`LaneCoordinate::gap_squared`], step by step as for `u32`.
#[inline(always)]
fn gap_squared_f64<S: Simd>(a: [S::u64s; 2], b: [S::u64s; 2], unit: S::f64s) -> S::f64s {
    let [centre_a, half_a] = a;
    let [centre_b, half_b] = b;
    let between: S::i64s = (centre_a - centre_b).bitcast();
    let between: S::u64s = between.abs().bitcast();
    let gap: S::i64s = between.saturating_sub(half_a).saturating_sub(half_b).bitcast();
    let gap = gap.to_float::<S::f64s>() * unit;
    gap * gap
}
