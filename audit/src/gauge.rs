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
//! The bound holds fused or not, to first order in the unit roundoff, and follows from the operations, not from a measurement;
//! it assumes what the CPU targets do: one rounding each, to nearest. ([`Bounded`](etalon_kernels_gen::bounded::Bounded) allows
//! for what graphics devices do besides.) Comparisons look at the values; where an error may turn one, both sides must meet
//! continuously.

use etalon_kernels_gen::bounded::Roundoff;
use etalon_kernels_gen::{Choose, Nameable, Precision, Real};
use std::marker::PhantomData;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A value with its natural scale and the bound of its error, for the precision `P`. See the module's text.
#[derive(Clone, Copy, Debug)]
pub struct Gauge<P> {
    value: f64,
    scale: f64,
    bound: f64,
    precision: PhantomData<P>,
}

impl<P: Roundoff> Gauge<P> {
    /// A value that the precision holds exactly.
    #[must_use]
    pub fn exact(value: f64) -> Self {
        Gauge { value, scale: value.abs(), bound: 0.0, precision: PhantomData }
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
        let bound = passed_on + P::UNIT * (value.abs() + passed_on) + P::UNIT * P::TINY;
        Gauge { value, scale: scale.max(P::TINY), bound, precision: PhantomData }
    }
    /// Whether an error might turn a comparison of the two.
    fn is_near(self, other: Self) -> bool {
        (self.value - other.value).abs() <= self.bound() + other.bound()
    }
    /// One of the two, of which it is not sure which.
    fn either(self, other: Self, first: bool) -> Self {
        let value = if first { self.value } else { other.value };
        let (scale, bound) = (self.scale.max(other.scale), self.bound.max(other.bound));
        Gauge { value, scale, bound, precision: PhantomData }
    }
}

impl<P: Roundoff> Add for Gauge<P> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::result(self.value + other.value, self.scale + other.scale, self.bound + other.bound)
    }
}
impl<P: Roundoff> Sub for Gauge<P> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}
impl<P: Roundoff> Mul for Gauge<P> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let passed_on = self.bound * (other.value.abs() + other.bound) + self.value.abs() * other.bound;
        // Where a value has cancelled to nothing, its error is what counts.
        let size = |x: Self| x.value.abs() + x.bound;
        let scale = (self.scale * size(other)).max(size(self) * other.scale);
        Self::result(self.value * other.value, scale, passed_on)
    }
}
impl<P: Roundoff> Div for Gauge<P> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        // A divisor that may be half gone bounds nothing.
        let margin = other.value.abs() - other.bound();
        if margin.is_nan() || margin <= 0.5 * other.value.abs() {
            return Gauge { value, scale: f64::INFINITY, bound: f64::INFINITY, precision: PhantomData };
        }
        let size = value.abs() + self.bound / margin;
        let scale = (self.scale / margin).max(size * (other.scale / margin));
        Self::result(value, scale, (self.bound + value.abs() * other.bound) / margin)
    }
}
impl<P: Roundoff> Neg for Gauge<P> {
    type Output = Self;
    fn neg(self) -> Self {
        Gauge { value: -self.value, ..self }
    }
}
impl<P> Nameable for Gauge<P> {}
impl<P: Roundoff> Choose<bool> for Gauge<P> {
    fn pick(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }
}

impl<P: Roundoff> Real for Gauge<P> {
    type Mask = bool;
    const PRECISION: Precision = P::PRECISION;

    fn lit(value: f64) -> Self {
        // One rounding for every constant, whole numbers too: it also pays for what a polynomial leaves out.
        Gauge { bound: P::UNIT * value.abs(), ..Self::exact(value) }
    }
    fn sqrt(self) -> Self {
        let value = self.value.sqrt();
        // The exact difference of the roots, which stays finite at zero.
        let passed_on = (self.value + self.bound).max(0.0).sqrt() - (self.value - self.bound).max(0.0).sqrt();
        let passed_on = if self.bound == 0.0 { 0.0 } else { passed_on };
        // The derivative's, as far as the argument is not lost in its error.
        let scale = if value > 0.0 { self.scale / value } else { f64::INFINITY };
        Self::result(value, scale.min(passed_on / P::UNIT).max(value), passed_on)
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
    use etalon_kernels_gen::trace::Single;

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
    fn a_root_near_zero_has_the_root_of_the_error() {
        let unit = f64::from(f32::EPSILON / 2.0);
        let nothing = (G::exact(1.0) + G::exact(0.0)) - G::exact(1.0);
        let root = nothing.sqrt();
        assert_eq!(root.value(), 0.0);
        assert!(root.bound() >= unit.sqrt() && root.scale() >= unit.sqrt(), "{root:?}");
    }
}
