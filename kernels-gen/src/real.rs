//! The number every equation is generic over.
//!
//! An equation is a function of some `R: Real`. The type put in for `R` decides what running it means: a number (`f32`,
//! `f64`, [`Fused`](crate::Fused)), many numbers at once (the vector lanes of [`lanes`](crate::lanes)), or a drawing of the
//! computation itself ([`Symbol`](crate::trace::Symbol)), from which other languages are printed.
//!
//! Only operations whose result is the same on every target are offered: `+ - * /`, square root, absolute value, minimum,
//! maximum, comparison and selection. There is no sine and no exponential: those are polynomials written with these
//! operations (see [`functions`](crate::functions)). `docs/numerics.md` states the policy.

use crate::constant::Constant;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Which set of fitted coefficients a number type deserves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Precision {
    /// 24 bits of significand.
    Single,
    /// 53 bits of significand.
    Double,
    /// More than that: for the oracle that others are measured against, and for what encloses the truth. No target and no
    /// drawing has it.
    Extended,
}

/// The outcome of comparing two numbers: one truth value, or one per lane, or the drawing of one.
pub trait Mask: Copy + 'static {
    /// Both hold.
    fn and(self, other: Self) -> Self;
    /// At least one holds.
    fn or(self, other: Self) -> Self;
    /// It does not hold.
    fn not(self) -> Self;
    /// What `if` means: a scalar runs one side only; lanes and symbols run both and select, so both sides must be finite
    /// for any legal input.
    fn choose<T: Choose<Self>>(self, yes: impl FnOnce() -> T, no: impl FnOnce() -> T) -> T;
    /// [`choose`](Mask::choose) for a costly `yes` that few lanes take: lanes may skip it when none does. Same result.
    fn choose_rare<T: Choose<Self>>(self, yes: impl FnOnce() -> T, no: impl FnOnce() -> T) -> T {
        self.choose(yes, no)
    }
}

/// A value that can be picked by a mask, lane by lane where there are lanes.
pub trait Choose<M>: Copy {
    /// `yes` where the mask holds, else `no`.
    fn pick(mask: M, yes: Self, no: Self) -> Self;
}

/// A real number, or something that computes like one. See the module's text.
pub trait Real:
    Copy
    + Choose<Self::Mask>
    + Nameable
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + 'static
{
    /// The result of comparing two of these.
    type Mask: Mask;
    /// The coefficient set that matches this type's significand.
    const PRECISION: Precision;

    /// A constant, rounded to this type. One that no `f64` holds exactly, and whose shortest decimal does not say what is meant
    /// either (0.1 does), is a [`constant`](Real::constant).
    fn lit(value: f64) -> Self;
    /// A constant with more digits than an `f64` has, rounded to this type.
    #[inline(always)]
    fn constant(value: Constant) -> Self {
        Self::lit(value.value())
    }
    /// Square root; the argument must not be negative.
    fn sqrt(self) -> Self;
    /// Absolute value.
    fn abs(self) -> Self;
    /// `self` if `self < other`, else `other`; so NaN on the right comes out, and on the left is lost. Limits stand on the left.
    fn min(self, other: Self) -> Self;
    /// `self` if `self > other`, else `other`; see [`min`](Real::min).
    fn max(self, other: Self) -> Self;
    /// `self * factor + addend`, fused or not as the type says: never the compiler's choice.
    fn mul_add(self, factor: Self, addend: Self) -> Self;
    /// `self < other`.
    fn lt(self, other: Self) -> Self::Mask;
    /// `self <= other`.
    fn le(self, other: Self) -> Self::Mask;
    /// `self > other`.
    fn gt(self, other: Self) -> Self::Mask {
        other.lt(self)
    }
    /// `self >= other`.
    fn ge(self, other: Self) -> Self::Mask {
        other.le(self)
    }

    /// Nothing.
    #[inline(always)]
    fn zero() -> Self {
        Self::lit(0.0)
    }
    /// One.
    #[inline(always)]
    fn one() -> Self {
        Self::lit(1.0)
    }
    /// `self * self`.
    #[inline(always)]
    fn squared(self) -> Self {
        self * self
    }
    /// A whole power by repeated squaring: the same multiplications on every target.
    #[inline(always)]
    fn power(self, exponent: u32) -> Self {
        let mut result = None;
        let mut base = self;
        let mut rest = exponent;
        while rest > 0 {
            if rest & 1 == 1 {
                result = Some(result.map_or(base, |r: Self| r * base));
            }
            rest >>= 1;
            if rest > 0 {
                base = base * base;
            }
        }
        result.unwrap_or_else(Self::one)
    }

    /// Runs an equation's body under its ledger id, so that a drawing can say where a value comes from. Numbers just run it.
    #[inline(always)]
    fn equation<T>(_id: &'static str, _name: &'static str, body: impl FnOnce() -> T) -> T {
        body()
    }
}

/// A value that a `let` can give its name to: drawings remember it, numbers ignore it.
pub trait Nameable: Sized {
    /// Whether names are kept: only drawings do.
    const NAMES: bool = false;
    /// The same value, known as `name`.
    #[inline(always)]
    fn named(self, _name: &str) -> Self {
        self
    }
}
