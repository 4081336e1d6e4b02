//! Sets of real numbers between two `f64`: what an equation can give over a whole box of inputs.
//!
//! Every operation is rounded outward by one `f64` on either side, twice what it needs: IEEE operations are off by half a unit
//! at most. So the true value of the equation, with true constants and true functions, lies inside for any inputs inside (the
//! fitted polynomials' own error, below 1e-32 with the extended coefficients, is covered by the half unit to spare). Comparisons
//! have three answers; where one is undecided both sides are computed and joined.

use crate::quad::Quad;
use etalon_kernels_gen::{Choose, Constant, Mask, Nameable, Precision, Real};
use std::fmt;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// All real numbers from `low` to `high`. The bounds may be infinite; no interval is empty.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    low: f64,
    high: f64,
}

/// The outcome of comparing two intervals.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Decided {
    /// It holds for all numbers in them.
    Yes,
    /// It holds for none.
    No,
    /// It holds for some, or it is not known.
    Maybe,
}

impl Interval {
    /// Every number.
    pub const ALL: Interval = Interval { low: f64::NEG_INFINITY, high: f64::INFINITY };

    /// From the lesser to the greater of the two; everything if one is NaN.
    #[must_use]
    pub fn new(one: f64, other: f64) -> Self {
        match one.is_nan() || other.is_nan() {
            true => Self::ALL,
            false => Interval { low: one.min(other), high: one.max(other) },
        }
    }
    /// A single number.
    #[must_use]
    pub fn exact(value: f64) -> Self {
        Self::new(value, value)
    }
    /// The least number.
    pub fn low(self) -> f64 {
        self.low
    }
    /// The greatest number.
    pub fn high(self) -> f64 {
        self.high
    }
    /// The greatest size of a number in it.
    pub fn size(self) -> f64 {
        self.low.abs().max(self.high.abs())
    }
    /// Whether the number is in it.
    pub fn contains(self, value: Quad) -> bool {
        Quad::exact(self.low) <= value && value <= Quad::exact(self.high)
    }
    /// The smallest interval that holds both.
    #[must_use]
    pub fn hull(self, other: Self) -> Self {
        Interval { low: self.low.min(other.low), high: self.high.max(other.high) }
    }
    /// One `f64` further on either side.
    fn outward(low: f64, high: f64) -> Self {
        match low.is_nan() || high.is_nan() {
            true => Self::ALL,
            false => Interval { low: low.next_down(), high: high.next_up() },
        }
    }
    /// This product or quotient, cut off at zero where the signs of both sides are known.
    fn signed_like(self, one: Self, other: Self) -> Self {
        let (not_negative, not_positive) = (|x: Self| x.low >= 0.0, |x: Self| x.high <= 0.0);
        let alike = not_negative(one) && not_negative(other) || not_positive(one) && not_positive(other);
        let unlike = not_negative(one) && not_positive(other) || not_positive(one) && not_negative(other);
        // Both, if one side is zero.
        let low = if alike { self.low.max(0.0) } else { self.low };
        let high = if unlike { self.high.min(0.0) } else { self.high };
        Interval { low, high }
    }
    /// From the least to the greatest of the four results at the corners.
    fn corners(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        let all = [f(self.low, other.low), f(self.low, other.high), f(self.high, other.low), f(self.high, other.high)];
        if all.iter().any(|corner| corner.is_nan()) {
            return Self::ALL;
        }
        Self::outward(all.into_iter().fold(f64::INFINITY, f64::min), all.into_iter().fold(f64::NEG_INFINITY, f64::max))
    }
}

impl fmt::Display for Interval {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "[{:e}, {:e}]", self.low, self.high)
    }
}

impl Add for Interval {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let sum = Self::outward(self.low + other.low, self.high + other.high);
        // What is not negative is not so after rounding outward either.
        let low = if self.low >= 0.0 && other.low >= 0.0 { sum.low.max(0.0) } else { sum.low };
        let high = if self.high <= 0.0 && other.high <= 0.0 { sum.high.min(0.0) } else { sum.high };
        Interval { low, high }
    }
}
impl Sub for Interval {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}
impl Mul for Interval {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        // A bound of infinity is never reached, so nothing times it is nothing.
        self.corners(other, |a, b| if a == 0.0 || b == 0.0 { 0.0 } else { a * b }).signed_like(self, other)
    }
}
impl Div for Interval {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        if other.low <= 0.0 && other.high >= 0.0 {
            return Self::ALL;
        }
        self.corners(other, |a, b| if b.is_infinite() { 0.0 } else { a / b }).signed_like(self, other)
    }
}
impl Neg for Interval {
    type Output = Self;
    fn neg(self) -> Self {
        Interval { low: -self.high, high: -self.low }
    }
}

impl Mask for Decided {
    fn and(self, other: Self) -> Self {
        match (self, other) {
            (Decided::No, _) | (_, Decided::No) => Decided::No,
            (Decided::Yes, Decided::Yes) => Decided::Yes,
            _ => Decided::Maybe,
        }
    }
    fn or(self, other: Self) -> Self {
        self.not().and(other.not()).not()
    }
    fn not(self) -> Self {
        match self {
            Decided::Yes => Decided::No,
            Decided::No => Decided::Yes,
            Decided::Maybe => Decided::Maybe,
        }
    }
    fn choose<T: Choose<Self>>(self, yes: impl FnOnce() -> T, no: impl FnOnce() -> T) -> T {
        match self {
            Decided::Yes => yes(),
            Decided::No => no(),
            Decided::Maybe => T::pick(self, yes(), no()),
        }
    }
}

impl Nameable for Interval {}
impl Choose<Decided> for Interval {
    fn pick(mask: Decided, yes: Self, no: Self) -> Self {
        match mask {
            Decided::Yes => yes,
            Decided::No => no,
            Decided::Maybe => yes.hull(no),
        }
    }
}

impl Real for Interval {
    type Mask = Decided;
    const PRECISION: Precision = Precision::Extended;

    fn lit(value: f64) -> Self {
        // The decimal that was written lies within half a unit of its f64.
        if Quad::lit(value) == Quad::exact(value) { Self::exact(value) } else { Self::outward(value, value) }
    }
    fn constant(value: Constant) -> Self {
        Self::outward(value.value(), value.value())
    }
    fn sqrt(self) -> Self {
        // What lies below zero is not legal, so it does not occur.
        let (low, high) = (self.low.max(0.0).sqrt(), self.high.max(0.0).sqrt());
        Interval { low: low.next_down().max(0.0), high: high.next_up() }
    }
    fn abs(self) -> Self {
        let low = if self.low > 0.0 {
            self.low
        } else if self.high < 0.0 {
            -self.high
        } else {
            0.0
        };
        Interval { low, high: self.size() }
    }
    fn min(self, other: Self) -> Self {
        Interval { low: self.low.min(other.low), high: self.high.min(other.high) }
    }
    fn max(self, other: Self) -> Self {
        Interval { low: self.low.max(other.low), high: self.high.max(other.high) }
    }
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        self * factor + addend
    }
    fn lt(self, other: Self) -> Decided {
        match (self.high < other.low, self.low >= other.high) {
            (true, _) => Decided::Yes,
            (false, true) => Decided::No,
            (false, false) => Decided::Maybe,
        }
    }
    fn le(self, other: Self) -> Decided {
        other.lt(self).not()
    }
    fn power(self, exponent: u32) -> Self {
        // By the ends, where products of an interval with itself would forget that both factors are the same number.
        let whole = |x: f64| {
            let all = (0..exponent)
                .fold(Interval::exact(1.0), |product, _| product.corners(Interval::exact(x), |a, b| a * b));
            (all.low, all.high)
        };
        let (of_low, of_high) = (whole(self.low), whole(self.high));
        let ends = Interval::new(of_low.0.min(of_high.0), of_low.1.max(of_high.1));
        if exponent == 0 {
            Interval::exact(1.0)
        } else if exponent.is_multiple_of(2) && self.low <= 0.0 && self.high >= 0.0 {
            Interval { low: 0.0, ..ends }
        } else {
            ends
        }
    }
    fn squared(self) -> Self {
        self.power(2)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn interval(low: f64, high: f64) -> Interval {
        Interval::new(low, high)
    }

    #[test]
    fn signs_are_kept_apart() {
        let product = interval(-2.0, 3.0) * interval(-5.0, 1.0);
        assert_eq!((product.low, product.high), ((-15.0_f64).next_down(), 10.0_f64.next_up()));
        assert_eq!(interval(1.0, 2.0) / interval(-1.0, 1.0), Interval::ALL);
        assert_eq!(interval(-2.0, 1.0).abs(), interval(0.0, 2.0));
        assert_eq!(interval(-2.0, 1.0).power(2), interval(0.0, 4.0_f64.next_up().next_up()));
        assert_eq!(interval(-2.0, 1.0).power(3).high, 1.0_f64.next_up().next_up().next_up());
    }

    #[test]
    fn an_undecided_choice_joins_both_sides() {
        let x = interval(-1.0, 2.0);
        let positive_part = x.gt(Interval::zero()).choose(|| x + Interval::lit(1.0), Interval::zero);
        assert_eq!((positive_part.low, positive_part.high), (0.0_f64.next_down(), 3.0_f64.next_up()));
        assert_eq!(interval(1.0, 2.0).le(interval(2.0, 3.0)), Decided::Yes);
        assert_eq!(interval(1.0, 2.0).lt(interval(2.0, 3.0)), Decided::Maybe);
        assert_eq!(Decided::Maybe.and(Decided::No), Decided::No);
        assert_eq!(Decided::Maybe.or(Decided::Yes), Decided::Yes);
    }

    #[test]
    fn a_tenth_is_inside_of_a_tenth() {
        assert!(Interval::lit(0.1).contains(Quad::lit(0.1)) && !Interval::exact(0.1).contains(Quad::lit(0.1)));
        assert!(Interval::constant(Constant::PI).contains(Quad::constant(Constant::PI)));
    }
}
