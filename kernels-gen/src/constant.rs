//! Constants with twice the digits of an `f64`.
//!
//! Kernels compute with constants such as `7 / (4 pi)`. A number type rounds them to what it can hold; the oracle can hold more
//! than an `f64`, so what is written down must have more. A [`Constant`] is the unevaluated sum of two `f64`, good for some 31
//! digits; its arithmetic runs while the program is compiled.

/// A number as the sum of two `f64`, the second below half a unit in the last place of the first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constant {
    high: f64,
    low: f64,
}

impl Constant {
    /// The circle's circumference over its diameter.
    pub const PI: Constant = Constant::pair(std::f64::consts::PI, 1.2246467991473532e-16);

    /// Twice that.
    pub const TAU: Constant = Constant::pair(std::f64::consts::TAU, 2.4492935982947064e-16);
    /// The natural logarithm of two.
    pub const LN_2: Constant = Constant::pair(std::f64::consts::LN_2, 2.3190468138462996e-17);

    /// A number that an `f64` holds exactly.
    #[must_use]
    pub const fn new(value: f64) -> Self {
        Constant { high: value, low: 0.0 }
    }
    /// The sum of both, which must not overlap: `low` is what `high` lacks.
    #[must_use]
    pub const fn pair(high: f64, low: f64) -> Self {
        Constant { high, low }
    }
    /// `numerator / denominator`, both exact: `Constant::ratio(9.0, 10.0)` is nine tenths to 31 digits.
    #[must_use]
    pub const fn ratio(numerator: f64, denominator: f64) -> Self {
        Constant::new(numerator).over(Constant::new(denominator))
    }
    /// The nearest `f64`.
    #[must_use]
    pub const fn value(self) -> f64 {
        self.high
    }
    /// What the nearest `f64` lacks.
    #[must_use]
    pub const fn rest(self) -> f64 {
        self.low
    }
    /// The sum.
    #[must_use]
    pub const fn plus(self, other: Self) -> Self {
        let (sum, error) = exact_sum(self.high, other.high);
        renormalised(sum, error + (self.low + other.low))
    }
    /// The difference.
    #[must_use]
    pub const fn minus(self, other: Self) -> Self {
        self.plus(Constant { high: -other.high, low: -other.low })
    }
    /// The product.
    #[must_use]
    pub const fn times(self, other: Self) -> Self {
        let (product, error) = exact_product(self.high, other.high);
        renormalised(product, error + (self.high * other.low + self.low * other.high))
    }
    /// The quotient, by long division: three digits of 53 bits.
    #[must_use]
    pub const fn over(self, other: Self) -> Self {
        let first = self.high / other.high;
        let rest = self.minus(other.times(Constant::new(first)));
        let second = rest.high / other.high;
        let rest = rest.minus(other.times(Constant::new(second)));
        let third = rest.high / other.high;
        let (high, low) = exact_sum(first, second);
        renormalised(high, low + third)
    }
}

/// A sum and its rounding error (Knuth).
const fn exact_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let of_b = sum - a;
    (sum, (a - (sum - of_b)) + (b - of_b))
}

/// A product and its rounding error (Dekker), for numbers below 1e290.
const fn exact_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    let (a_high, a_low) = halves(a);
    let (b_high, b_low) = halves(b);
    (product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low)
}

/// A number as the sum of two of 26 bits (Veltkamp).
const fn halves(a: f64) -> (f64, f64) {
    let scaled = a * 134_217_729.0; // 2^27 + 1
    let high = scaled - (scaled - a);
    (high, a - high)
}

const fn renormalised(high: f64, low: f64) -> Constant {
    let sum = high + low;
    Constant { high: sum, low: low - (sum - high) }
}

#[cfg(test)]
mod tests {
    use super::Constant;
    use twofloat::TwoFloat;

    /// Either side is off by a few units of 2^-104.
    fn assert_same(what: &str, found: TwoFloat, expected: TwoFloat) {
        let error = (found - expected).hi().abs() / expected.hi().abs();
        println!("{what}: {error:e}");
        assert!(error < 4e-31, "{what}: {error:e}");
    }

    #[test]
    fn arithmetic_keeps_thirty_digits() {
        let exact = |value: f64| TwoFloat::from(value);
        let found = |constant: Constant| exact(constant.value()) + exact(constant.rest());
        let pi = twofloat::consts::PI;
        assert_same("pi", found(Constant::PI), pi);
        // Quotients are multiplied back: twofloat 0.8.4 divides by one of its own numbers to the digits of an f64 only.
        assert_same("9/10", found(Constant::ratio(9.0, 10.0)) * 10.0, exact(9.0));
        assert_same("7/(4 pi)", found(Constant::ratio(7.0, 4.0).over(Constant::PI)) * pi * 4.0, exact(7.0));
        assert_same("pi pi", found(Constant::PI.times(Constant::PI)), pi * pi);
        assert_same("1 - 1/3", found(Constant::new(1.0).minus(Constant::ratio(1.0, 3.0))) * 3.0, exact(2.0));
        assert_same("pi + 1/3", found(Constant::PI.plus(Constant::ratio(1.0, 3.0))) * 3.0, pi * 3.0 + 1.0);
    }

    #[test]
    fn the_first_part_is_the_nearest_double() {
        assert_eq!(Constant::ratio(1.0, 3.0).value(), 1.0 / 3.0);
        assert_eq!(Constant::ratio(9.0, 10.0).value(), 0.9);
        assert_eq!(Constant::PI.value(), std::f64::consts::PI);
        assert_ne!(Constant::ratio(1.0, 3.0).rest(), 0.0);
    }
}
