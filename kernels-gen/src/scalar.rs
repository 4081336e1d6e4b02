//! Plain numbers: `f32` and `f64` compute `a * b + c` with two roundings; [`Fused`] with one.

use crate::real::{Choose, Mask, Nameable, Precision, Real};
use std::ops::{Add, Div, Mul, Neg, Sub};

impl Mask for bool {
    #[inline(always)]
    fn and(self, other: Self) -> Self {
        self && other
    }
    #[inline(always)]
    fn or(self, other: Self) -> Self {
        self || other
    }
    #[inline(always)]
    fn not(self) -> Self {
        !self
    }
    #[inline(always)]
    fn choose<T: Choose<Self>>(self, yes: impl FnOnce() -> T, no: impl FnOnce() -> T) -> T {
        if self { yes() } else { no() }
    }
}

/// A scalar whose `mul_add` rounds once: what the processor's vector lanes compute, one lane at a time.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd, Default)]
pub struct Fused<T>(pub T);

macro_rules! fused_operator {
    ($trait:ident, $method:ident) => {
        impl<T: $trait<Output = T>> $trait for Fused<T> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Fused(self.0.$method(other.0))
            }
        }
    };
}
fused_operator!(Add, add);
fused_operator!(Sub, sub);
fused_operator!(Mul, mul);
fused_operator!(Div, div);

impl<T: Neg<Output = T>> Neg for Fused<T> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Fused(-self.0)
    }
}

macro_rules! scalar {
    ($type:ty, $precision:expr, $make:expr, $raw:expr, $mul_add:expr) => {
        impl Nameable for $type {}
        impl Choose<bool> for $type {
            #[inline(always)]
            fn pick(mask: bool, yes: Self, no: Self) -> Self {
                if mask { yes } else { no }
            }
        }
        impl Real for $type {
            type Mask = bool;
            const PRECISION: Precision = $precision;
            #[inline(always)]
            fn lit(value: f64) -> Self {
                $make(value as _)
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                $make($raw(self).sqrt())
            }
            #[inline(always)]
            fn abs(self) -> Self {
                $make($raw(self).abs())
            }
            #[inline(always)]
            fn min(self, other: Self) -> Self {
                if self < other { self } else { other }
            }
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                if self > other { self } else { other }
            }
            #[inline(always)]
            fn mul_add(self, factor: Self, addend: Self) -> Self {
                $make($mul_add($raw(self), $raw(factor), $raw(addend)))
            }
            #[inline(always)]
            fn lt(self, other: Self) -> bool {
                self < other
            }
            #[inline(always)]
            fn le(self, other: Self) -> bool {
                self <= other
            }
        }
    };
}
scalar!(f32, Precision::Single, |v: f32| v, |v: f32| v, |a: f32, b: f32, c: f32| a * b + c);
scalar!(f64, Precision::Double, |v: f64| v, |v: f64| v, |a: f64, b: f64, c: f64| a * b + c);
scalar!(Fused<f32>, Precision::Single, Fused, |v: Fused<f32>| v.0, f32::mul_add);
scalar!(Fused<f64>, Precision::Double, Fused, |v: Fused<f64>| v.0, f64::mul_add);
