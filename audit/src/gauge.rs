//! How large the error of a result may be, and what to compare it with: its *natural scale*.
//!
//! A sum that cancels cannot be right to the last place of its result: what counts is the size of what was added. A [`Gauge`]
//! runs along with a target's arithmetic and keeps two things besides the value:
//!
//! - the **scale**: the result as it would be without cancellation. Of a sum it is the sum of the scales; of a product or a
//!   quotient the larger of what either side's scale makes of it; of a root what the derivative makes of it;
//! - the **bound**: how far the computed value may be from the true one when every rounding conspires. Each operation passes on
//!   the bounds of its arguments and adds half a unit of its own result; a constant has half a unit.
//!
//! The bound holds fused or not, to first order in the unit roundoff, and follows from the operations, not from a measurement. What
//! it assumes of each operation is the [`Promise`] of the target: on the CPU one rounding, to nearest; of WGSL what its
//! specification says, which a driver has to be believed. Comparisons look at the values; where an error may turn one, both sides must meet
//! continuously.

use etalon_kernels_gen::bounded::Roundoff;
use etalon_kernels_gen::trace::{Double, Single};
use etalon_kernels_gen::{Choose, Nameable, Precision, Real};
use std::marker::PhantomData;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// What the targets of a precision promise of single operations.
pub trait Promise: Roundoff {
    /// By how many unit roundoffs a sum, a difference or a product may be off.
    const OPERATION: f64 = 1.0;
    /// By how many unit roundoffs a quotient may be off.
    const QUOTIENT: f64 = 1.0;
    /// By how many a square root may be.
    const ROOT: f64 = 1.0;
    /// Whether the terms of a sum may be added in another order than the text has.
    const REASSOCIATES: bool = false;
    /// By how much a result below the smallest normal number may be.
    const UNDERFLOW: f64 = Self::UNIT * Self::TINY;
    /// The least scale: where an underflow is worth half a unit in the last place.
    const LEAST_SCALE: f64 = Self::TINY;
}

impl Promise for Single {}
impl Promise for Double {}

/// `f32` as WGSL promises it: sums and products to either neighbour of the true result, quotients to 2.5 units in the last place, roots as the
/// quotient of one and an inverse root that is good to 2; the terms of a sum may be added in any order; results below the smallest normal number may become zero. A unit in the
/// last place is up to two unit roundoffs. (WGSL's specification, chapter on floating point evaluation: accuracy, reassociation and fusion.)
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wgsl;

impl Roundoff for Wgsl {
    const UNIT: f64 = Single::UNIT;
    const TINY: f64 = Single::TINY;
    const PRECISION: Precision = Single::PRECISION;
}
impl Promise for Wgsl {
    const OPERATION: f64 = 2.0;
    const QUOTIENT: f64 = 5.0;
    const ROOT: f64 = 9.0;
    const REASSOCIATES: bool = true;
    const UNDERFLOW: f64 = Self::TINY;
    const LEAST_SCALE: f64 = Self::TINY / Self::UNIT;
}

/// A value with its natural scale and the bound of its error, for the precision `P`. See the module's text.
#[derive(Clone, Copy, Debug)]
pub struct Gauge<P> {
    value: f64,
    scale: f64,
    bound: f64,
    /// Of a sum: the bounds of its terms together, and how many additions there are; of anything else its own bound, and none.
    of_terms: f64,
    additions: f64,
    precision: PhantomData<P>,
}

impl<P: Promise> Gauge<P> {
    /// A value that the precision holds exactly.
    #[must_use]
    pub fn exact(value: f64) -> Self {
        Self::single(value, value.abs(), 0.0)
    }
    /// Something that is no sum.
    fn single(value: f64, scale: f64, bound: f64) -> Self {
        Gauge { value, scale, bound, of_terms: bound, additions: 0.0, precision: PhantomData }
    }
    /// The value, computed in `f64`.
    pub fn value(self) -> f64 {
        self.value
    }
    /// The natural scale: the size that the error is to be compared with. Infinite where nothing can be said.
    pub fn scale(self) -> f64 {
        if self.scale.is_nan() { f64::INFINITY } else { self.scale }
    }
    /// How far a computed value may be from the true one. Infinite where nothing can be said.
    pub fn bound(self) -> f64 {
        if self.bound.is_nan() { f64::INFINITY } else { self.bound }
    }
    /// The result of an operation; below the smallest normal number targets may flush, which is a rounding of that size.
    fn result(value: f64, scale: f64, passed_on: f64) -> Self {
        Self::rounded(value, scale, passed_on, P::OPERATION)
    }
    /// The same with so many unit roundoffs of its own.
    fn rounded(value: f64, scale: f64, passed_on: f64, roundoffs: f64) -> Self {
        let bound = passed_on + roundoffs * P::UNIT * (value.abs() + passed_on) + P::UNDERFLOW;
        Self::single(value, scale.max(P::LEAST_SCALE), bound)
    }
    /// A sum whose terms may be added in any order: every addition may be as large as all of them together.
    fn sum(self, other: Self) -> Self {
        let scale = (self.scale + other.scale).max(P::LEAST_SCALE);
        let (of_terms, additions) = (self.of_terms + other.of_terms, self.additions + other.additions + 1.0);
        let bound = of_terms + additions * (P::OPERATION * P::UNIT * (scale + of_terms) + P::UNDERFLOW);
        Gauge { value: self.value + other.value, scale, bound, of_terms, additions, precision: PhantomData }
    }
    /// Whether an error might turn a comparison of the two.
    fn is_near(self, other: Self) -> bool {
        (self.value - other.value).abs() <= self.bound() + other.bound()
    }
    /// One of the two, of which it is not sure which.
    fn either(self, other: Self, first: bool) -> Self {
        let value = if first { self.value } else { other.value };
        Gauge {
            value,
            scale: self.scale.max(other.scale),
            bound: self.bound.max(other.bound),
            of_terms: self.of_terms.max(other.of_terms),
            additions: self.additions.max(other.additions),
            precision: PhantomData,
        }
    }
}

impl<P: Promise> Add for Gauge<P> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        match P::REASSOCIATES {
            true => self.sum(other),
            false => Self::result(self.value + other.value, self.scale + other.scale, self.bound + other.bound),
        }
    }
}
impl<P: Promise> Sub for Gauge<P> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}
impl<P: Promise> Mul for Gauge<P> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let passed_on = self.bound * (other.value.abs() + other.bound) + self.value.abs() * other.bound;
        // Where a value has cancelled to nothing, its error is what counts.
        let size = |x: Self| x.value.abs() + x.bound;
        let scale = (self.scale * size(other)).max(size(self) * other.scale);
        Self::result(self.value * other.value, scale, passed_on)
    }
}
impl<P: Promise> Div for Gauge<P> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        // A divisor that may be half gone bounds nothing.
        let margin = other.value.abs() - other.bound();
        if margin.is_nan() || margin <= 0.5 * other.value.abs() {
            return Self::single(value, f64::INFINITY, f64::INFINITY);
        }
        let size = value.abs() + self.bound / margin;
        let scale = (self.scale / margin).max(size * (other.scale / margin));
        Self::rounded(value, scale, (self.bound + value.abs() * other.bound) / margin, P::QUOTIENT)
    }
}
impl<P: Promise> Neg for Gauge<P> {
    type Output = Self;
    fn neg(self) -> Self {
        Gauge { value: -self.value, ..self }
    }
}
impl<P> Nameable for Gauge<P> {}
impl<P: Promise> Choose<bool> for Gauge<P> {
    fn pick(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }
}

impl<P: Promise> Real for Gauge<P> {
    type Mask = bool;
    const PRECISION: Precision = P::PRECISION;

    fn lit(value: f64) -> Self {
        // One rounding for every constant, whole numbers too: it also pays for what a polynomial leaves out.
        Self::single(value, value.abs(), P::UNIT * value.abs())
    }
    fn sqrt(self) -> Self {
        let value = self.value.sqrt();
        // The exact difference of the roots, which stays finite at zero.
        let passed_on = (self.value + self.bound).max(0.0).sqrt() - (self.value - self.bound).max(0.0).sqrt();
        let passed_on = if self.bound == 0.0 { 0.0 } else { passed_on };
        // The derivative's, as far as the argument is not lost in its error.
        let scale = if value > 0.0 { self.scale / value } else { f64::INFINITY };
        Self::rounded(value, scale.min(passed_on / P::UNIT).max(value), passed_on, P::ROOT)
    }
    fn abs(self) -> Self {
        Gauge { value: self.value.abs(), ..self }
    }
    fn min(self, other: Self) -> Self {
        let first = self.value < other.value;
        match self.is_near(other) {
            true => self.either(other, first),
            false => Self::pick(first, self, other),
        }
    }
    fn max(self, other: Self) -> Self {
        let first = self.value > other.value;
        match self.is_near(other) {
            true => self.either(other, first),
            false => Self::pick(first, self, other),
        }
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

    type G = Gauge<Single>;

    #[test]
    fn a_difference_has_the_scale_of_what_it_is_made_of() {
        let unit = f64::from(f32::EPSILON / 2.0);
        let difference = G::exact(1.0) - G::exact(0.75);
        assert_eq!((difference.value(), difference.scale()), (0.25, 1.75));
        assert!((difference.bound() / (0.25 * unit) - 1.0).abs() < 1e-6, "{difference:?}");
        // Products and quotients pass on by how much a scale exceeds its value.
        let product = difference * G::exact(8.0);
        assert_eq!(product.value(), 2.0);
        assert!((product.scale() / 14.0 - 1.0).abs() < 1e-6, "{product:?}");
        assert!((product.bound() / (4.0 * unit) - 1.0).abs() < 1e-6, "{product:?}");
        let quotient = G::exact(1.0) / difference;
        assert!((quotient.scale() / 28.0 - 1.0).abs() < 1e-6, "{quotient:?}");
        assert!((quotient.bound() / (8.0 * unit) - 1.0).abs() < 1e-6, "{quotient:?}");
    }

    #[test]
    fn dividing_by_what_may_be_nothing_has_no_scale() {
        let nothing = (G::exact(1.0) + G::exact(1e-9)) - G::exact(1.0);
        assert_eq!((G::exact(1.0) / nothing).bound(), f64::INFINITY);
    }

    #[test]
    fn wgsl_promises_less_of_every_operation() {
        fn bounds<P: Promise>() -> [f64; 4] {
            let (x, y) = (Gauge::<P>::exact(3.0), Gauge::exact(7.0));
            [(x + y).bound(), (x * y).bound(), (x / y).bound(), x.sqrt().bound()]
        }
        let (single, wgsl) = (bounds::<Single>(), bounds::<Wgsl>());
        // Of a single sum the scale is the value.
        for (k, expected) in [2.0, 2.0, 5.0, 9.0].into_iter().enumerate() {
            assert!((wgsl[k] / single[k] / expected - 1.0).abs() < 1e-6, "{k}: {:e} and {:e}", single[k], wgsl[k]);
        }
    }

    /// `1 + (t + t)`: nothing but the last addition rounds, unless a driver makes it `(1 + t) + t`, as Mesa's does of products.
    #[test]
    fn wgsl_may_add_in_another_order() {
        fn sum<P: Promise>() -> Gauge<P> {
            let t = f64::from(0.001_f32);
            Gauge::exact(1.0) + (Gauge::exact(t) + Gauge::exact(t))
        }
        let t = 0.001_f32;
        let other_order = f64::from((1.0 + t) + t) - sum::<Wgsl>().value();
        assert!(other_order.abs() > sum::<Single>().bound() && other_order.abs() < sum::<Wgsl>().bound());
        // Products and choices are no sums, but keep what is in them.
        let negated = -sum::<Wgsl>();
        assert_eq!((negated.additions, (negated * Gauge::exact(2.0)).additions), (2.0, 0.0));
    }

    #[test]
    fn a_root_near_zero_has_the_root_of_the_error() {
        let unit = f64::from(f32::EPSILON / 2.0);
        let nothing = (G::exact(1.0) + G::exact(0.0)) - G::exact(1.0);
        let root = nothing.sqrt();
        assert_eq!(root.value(), 0.0);
        assert!(root.bound() >= unit.sqrt() && root.scale() >= unit.sqrt(), "{root:?}");
    }
}
