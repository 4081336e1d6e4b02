//! A number with a running bound of its rounding error: where differential tests get their tolerances from.
//!
//! Put in for `R`, it computes in `f64` and carries along by how much the same computation in a precision with unit roundoff
//! `u` may differ: each operation passes on the errors of its arguments to first order and adds half a unit of its own. The
//! bound holds with or without fused multiply-add, and, for sums formed by [`Bounded::accumulate`], in any order of summation.
//!
//! Comparisons look at the values. Where an error could turn one, the two sides must meet continuously for the bound to hold;
//! the equations' do.

use crate::real::{Choose, Nameable, Precision, Real};
use crate::trace::Single;
use std::cmp::Ordering;
use std::marker::PhantomData;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A precision whose errors are bounded.
pub trait Roundoff: Copy + std::fmt::Debug + 'static {
    /// Half the distance from 1 to the next number.
    const UNIT: f64;
    /// The smallest normal number: below it, targets may flush to zero.
    const TINY: f64;
    /// Its coefficient set.
    const PRECISION: Precision;
}

/// `f64`'s. (The name in [`trace`](crate::trace) carries no roundoff.)
impl Roundoff for crate::trace::Double {
    const UNIT: f64 = f64::EPSILON / 2.0;
    const TINY: f64 = f64::MIN_POSITIVE;
    const PRECISION: Precision = Precision::Double;
}
impl Roundoff for Single {
    const UNIT: f64 = f32::EPSILON as f64 / 2.0;
    const TINY: f64 = f32::MIN_POSITIVE as f64;
    const PRECISION: Precision = Precision::Single;
}

/// A value, and how far the same computation at the precision `P` may be from it.
#[derive(Clone, Copy, Debug)]
pub struct Bounded<P> {
    value: f64,
    error: f64,
    /// The sum of the sizes of what was accumulated.
    gathered: f64,
    precision: PhantomData<P>,
}

impl<P: Roundoff> Bounded<P> {
    /// A value known up to an error.
    #[must_use]
    pub fn new(value: f64, error: f64) -> Self {
        Bounded { value, error, gathered: value.abs(), precision: PhantomData }
    }
    /// The result of an operation whose arguments' errors amount to `passed_on`.
    fn rounded(value: f64, passed_on: f64) -> Self {
        Self::new(value, passed_on + P::UNIT * value.abs() + P::TINY)
    }
    /// The least that the same computation may give.
    fn low(self) -> f64 {
        self.value - self.error()
    }
    /// The most that it may give.
    fn high(self) -> f64 {
        self.value + self.error()
    }
    /// A value that is taken over without rounding, known to lie between two others.
    fn between(value: f64, (low, high): (f64, f64)) -> Self {
        Self::new(value, (value - low).max(high - value))
    }
    /// The value.
    pub fn value(self) -> f64 {
        self.value
    }
    /// The bound; infinite where there is none.
    pub fn error(self) -> f64 {
        if self.error.is_nan() { f64::INFINITY } else { self.error }
    }
    /// This sum with one more term, bounded for any order of summation.
    #[must_use]
    pub fn accumulate(self, term: Self) -> Self {
        let gathered = self.gathered + term.value.abs() + term.error;
        let error = self.error + term.error + P::UNIT * gathered;
        Bounded { value: self.value + term.value, error, gathered, precision: PhantomData }
    }
}

impl<P: Roundoff> Add for Bounded<P> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::rounded(self.value + other.value, self.error + other.error)
    }
}
impl<P: Roundoff> Sub for Bounded<P> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::rounded(self.value - other.value, self.error + other.error)
    }
}
impl<P: Roundoff> Mul for Bounded<P> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let passed_on = self.value.abs() * other.error + (other.value.abs() + other.error) * self.error;
        Self::rounded(self.value * other.value, passed_on)
    }
}
impl<P: Roundoff> Div for Bounded<P> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        let margin = other.value.abs() - other.error;
        let passed_on = if self.error == 0.0 && other.error == 0.0 {
            0.0
        } else if margin > 0.0 {
            (self.error + value.abs() * other.error) / margin
        } else {
            f64::INFINITY
        };
        // WGSL promises division to 2.5 units in the last place only.
        Self::rounded(value, passed_on + 5.0 * P::UNIT * value.abs())
    }
}
impl<P: Roundoff> Neg for Bounded<P> {
    type Output = Self;
    fn neg(self) -> Self {
        Bounded { value: -self.value, ..self }
    }
}
impl<P> PartialEq for Bounded<P> {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}
impl<P> PartialOrd for Bounded<P> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.value.partial_cmp(&other.value)
    }
}
impl<P> Nameable for Bounded<P> {}
impl<P: Roundoff> Choose<bool> for Bounded<P> {
    fn pick(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }
}

impl<P: Roundoff> Real for Bounded<P> {
    type Mask = bool;
    const PRECISION: Precision = P::PRECISION;

    fn lit(value: f64) -> Self {
        let rounded = match P::PRECISION {
            Precision::Single => f64::from(value as f32),
            Precision::Double | Precision::Extended => value,
        };
        Self::new(value, (value - rounded).abs())
    }
    fn sqrt(self) -> Self {
        let value = self.value.sqrt();
        // From the exact difference of the roots, which stays finite at zero; WGSL allows a few units more than one half.
        let passed_on = (self.value + self.error).sqrt() - (self.value - self.error).max(0.0).sqrt();
        let passed_on = if self.error == 0.0 { 0.0 } else { passed_on };
        Self::rounded(value, passed_on + 8.0 * P::UNIT * value)
    }
    fn abs(self) -> Self {
        Bounded { value: self.value.abs(), ..self }
    }
    fn min(self, other: Self) -> Self {
        let value = if self.value < other.value { self.value } else { other.value };
        Self::between(value, (self.low().min(other.low()), self.high().min(other.high())))
    }
    fn max(self, other: Self) -> Self {
        let value = if self.value > other.value { self.value } else { other.value };
        Self::between(value, (self.low().max(other.low()), self.high().max(other.high())))
    }
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        self * factor + addend
    }
    fn lt(self, other: Self) -> bool {
        self.value < other.value
    }
    fn le(self, other: Self) -> bool {
        self.value <= other.value
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::functions::{cube_root, exp_negative};
    use proptest::prelude::*;

    /// Some computation with cancellation, division and roots in it.
    fn messy<R: Real>(a: R, b: R, c: R) -> R {
        let difference = (a - b) * c + a * b;
        let root = cube_root(c) / (b + R::lit(0.1)).sqrt();
        difference / root - exp_negative(a).max(b * R::lit(0.3))
    }

    proptest! {
        #[test]
        fn single_precision_stays_within_the_bound(a in 0.0..4.0_f32, b in 0.0..4.0_f32, c in 0.01..100.0_f32) {
            let exact = |x: f32| Bounded::<Single>::new(f64::from(x), 0.0);
            let bounded = messy(exact(a), exact(b), exact(c));
            let error = (f64::from(messy(a, b, c)) - bounded.value()).abs();
            prop_assert!(error <= bounded.error(), "error {error:e}, bound {:e}", bounded.error());
            // A bound far from any error would let faults through. The cube root's chain of roots and quotients, each allowed what
            // WGSL allows, takes most of it.
            prop_assert!(bounded.error() < 5e-3 * (1.0 + bounded.value().abs()), "{:e}", bounded.error());
        }

        #[test]
        fn sums_stay_within_it_in_any_order(terms in prop::collection::vec(-1.0..1.0_f32, 1..200)) {
            let sum = terms.iter().fold(Bounded::<Single>::new(0.0, 0.0), |s, &t| s.accumulate(Bounded::new(f64::from(t), 0.0)));
            let forward: f32 = terms.iter().sum();
            let backward: f32 = terms.iter().rev().sum();
            for found in [forward, backward] {
                prop_assert!((f64::from(found) - sum.value()).abs() <= sum.error());
            }
        }
    }

    /// Of two numbers that are surely apart only the chosen one's error counts: a limit of 1e30 must not lend its rounding to a time step.
    #[test]
    fn the_smaller_does_not_take_over_the_error_of_the_larger() {
        let (small, large) = (Bounded::<Single>::new(1.0, 1e-7), Bounded::new(1e30, 1e22));
        // One minus 1e-7, and that from one, each round once in f64.
        let tolerance = 2.0 * f64::EPSILON;
        for least in [small.min(large), large.min(small), (-small).max(-large), (-large).max(-small)] {
            assert_eq!(least.value().abs(), 1.0);
            assert!((least.error() - 1e-7).abs() <= tolerance, "{:e}", least.error());
        }
        // Where they overlap the other's may count: the least of 1 +- 0.1 and 1.05 +- 0.3 is between 0.75 and 1.1.
        let least = Bounded::<Single>::new(1.0, 0.1).min(Bounded::new(1.05, 0.3));
        assert!((least.error() - 0.25).abs() <= tolerance, "{:e}", least.error());
        assert_eq!(small.min(Bounded::new(2.0, f64::NAN)).error(), f64::INFINITY);
    }

    #[test]
    fn dividing_by_what_may_be_zero_has_no_bound() {
        let doubtful = Bounded::<Single>::new(1e-9, 1e-8);
        assert_eq!((Bounded::new(1.0, 0.0) / doubtful).error(), f64::INFINITY);
    }
}
