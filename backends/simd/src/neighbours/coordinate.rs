//! Fixed-point positions on a torus, and their exact separations.

use super::lanes::LaneCoordinate;
use std::fmt::Debug;
use std::ops::{Add, Mul};

/// The floating-point number in which separations and support radii are given: `f32` or `f64`.
pub trait Scalar:
    Copy + PartialOrd + Default + Debug + Add<Output = Self> + Mul<Output = Self> + Send + Sync + 'static
{
    /// The nearest number of this type.
    fn from_f64(value: f64) -> Self;
    /// The same number as `f64` (exact).
    fn to_f64(self) -> f64;
    /// Whether the number and its square are positive, finite and not subnormal.
    fn has_a_square(self) -> bool;
}

/// A position along one axis as a fixed-point fraction of the length of the torus.
///
/// `u32` counts units of length/2^32 and goes with `f32` arithmetic; `u64` counts units of
/// length/2^64 and goes with `f64` arithmetic, where a caller who keeps the lowest 11 bits zero gets
/// separations without any rounding but that of the last product.
///
/// Differences wrap around, so the nearest periodic image comes by itself and a difference does not
/// depend on where the origin is.
pub trait Coordinate: LaneCoordinate + Copy + Eq + Ord + Default + Debug + Send + Sync + 'static {
    /// The least and the greatest coordinate.
    const RANGE: (Self, Self);
    /// How many units there are to a length: 2^bits.
    const UNITS: f64;

    /// The length of one unit, `length / 2^bits`, rounded to the scalar type.
    fn unit(length: f64) -> Self::Scalar;

    /// `self - other` by the shortest way around the torus, in the unit of length of `unit`.
    fn separation(self, other: Self, unit: Self::Scalar) -> Self::Scalar;

    /// The coordinate of a fraction of the length; fractions outside [0, 1) wrap around. For `u64` the lowest
    /// 11 bits of the result are zero. A fraction that is not finite gives 0.
    fn from_fraction(fraction: f64) -> Self;

    /// The fraction of the length, in [0, 1) up to the rounding of `f64`.
    fn to_fraction(self) -> f64;

    /// The leading 32 bits of `(self - low) << shift`, where no one bit may be shifted out.
    fn leading_bits(self, low: Self, shift: u32) -> u32;

    /// How far `self - low` can be shifted before a bit is lost; one less than the number of bits if it is zero.
    fn spare_bits(self, low: Self) -> u32;

    /// Centre and half width of an interval of the torus that holds every point.
    ///
    /// The half width is at most half of the torus, which covers everything. No points: the point 0.
    fn interval(points: &[Self]) -> (Self, Self);

    /// Centre and half width of an interval of the torus that holds every given interval (centres and half widths).
    fn hull(centres: &[Self], halves: &[Self]) -> (Self, Self);
}

/// The square of the distance between two points, in the arithmetic of the neighbour search.
///
/// The definition that every instruction set follows: each separation is squared with one rounding, and the squares are
/// added one after the other from the first axis to the last, never fused.
#[inline(always)]
pub fn distance_squared<C: Coordinate, const D: usize>(a: [C; D], b: [C; D], unit: [C::Scalar; D]) -> C::Scalar {
    let mut sum = C::Scalar::default();
    for k in 0..D {
        let separation = a[k].separation(b[k], unit[k]);
        let square = separation * separation;
        // The first square stands alone: adding it to zero would give the same bits, at the price of an addition.
        sum = if k == 0 { square } else { sum + square };
    }
    sum
}

macro_rules! scalar {
    ($float:ty) => {
        impl Scalar for $float {
            #[inline(always)]
            fn from_f64(value: f64) -> Self {
                value as $float
            }

            #[inline(always)]
            fn to_f64(self) -> f64 {
                f64::from(self)
            }

            #[inline(always)]
            fn has_a_square(self) -> bool {
                self > 0.0 && (self * self).is_normal()
            }
        }
    };
}

scalar!(f32);
scalar!(f64);

/// `$wide` is a signed integer that holds any sum of three numbers of type `$unsigned`.
macro_rules! coordinate {
    ($unsigned:ty, $signed:ty, $wide:ty, $float:ty, $unused_bits:expr) => {
        impl Coordinate for $unsigned {
            const RANGE: (Self, Self) = (<$unsigned>::MIN, <$unsigned>::MAX);
            const UNITS: f64 = (1_u128 << <$unsigned>::BITS) as f64;

            #[inline(always)]
            fn unit(length: f64) -> $float {
                // A power of two: exact but for the one rounding to the scalar type.
                (length / Self::UNITS) as $float
            }

            #[inline(always)]
            fn separation(self, other: Self, unit: $float) -> $float {
                self.wrapping_sub(other).cast_signed() as $float * unit
            }

            fn from_fraction(fraction: f64) -> Self {
                let fraction = fraction - fraction.floor();
                // A tiny negative fraction rounds to 1 here; `as` would saturate where it must wrap.
                if fraction >= 1.0 || fraction.is_nan() {
                    return 0;
                }
                let units = (fraction * Self::UNITS) as $unsigned;
                (units >> $unused_bits) << $unused_bits
            }

            fn to_fraction(self) -> f64 {
                self as f64 / Self::UNITS
            }

            #[inline(always)]
            fn leading_bits(self, low: Self, shift: u32) -> u32 {
                (self.wrapping_sub(low) << shift >> (<$unsigned>::BITS - 32)) as u32
            }

            fn spare_bits(self, low: Self) -> u32 {
                self.wrapping_sub(low).leading_zeros().min(<$unsigned>::BITS - 1)
            }

            #[inline(always)]
            fn interval(points: &[Self]) -> (Self, Self) {
                let origin = points.first().copied().unwrap_or(0);
                let (mut low, mut high): ($signed, $signed) = (0, 0);
                for point in points {
                    let offset = point.wrapping_sub(origin).cast_signed();
                    low = low.min(offset);
                    high = high.max(offset);
                }
                let extent = high.wrapping_sub(low).cast_unsigned();
                let centre = origin.wrapping_add(low.cast_unsigned()).wrapping_add(extent / 2);
                (centre, extent - extent / 2)
            }

            #[inline(always)]
            fn hull(centres: &[Self], halves: &[Self]) -> (Self, Self) {
                let origin = centres.first().copied().unwrap_or(0);
                let (mut low, mut high): ($wide, $wide) = (0, 0);
                for (centre, half) in centres.iter().zip(halves) {
                    let offset = <$wide>::from(centre.wrapping_sub(origin).cast_signed());
                    low = low.min(offset - <$wide>::from(*half));
                    high = high.max(offset + <$wide>::from(*half));
                }
                // An interval longer than the torus covers it, and so does one that is as long.
                let extent = (high - low).min(<$wide>::from(<$unsigned>::MAX)) as $unsigned;
                let centre = origin.wrapping_add(low as $unsigned).wrapping_add(extent / 2);
                (centre, extent - extent / 2)
            }
        }
    };
}

coordinate!(u32, i32, i64, f32, 0);
coordinate!(u64, i64, i128, f64, 11);
