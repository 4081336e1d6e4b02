//! Numbers that carry a derivative: an equation run on them gives its own exact slope, without finite differences.

use crate::real::{Choose, Nameable, Precision, Real};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// `value + slope e` with `e^2 = 0`.
#[derive(Clone, Copy, Debug)]
pub struct Dual {
    /// The number.
    pub value: f64,
    /// Its derivative with respect to the variable.
    pub slope: f64,
}

impl Dual {
    /// The variable itself.
    pub fn variable(value: f64) -> Self {
        Dual { value, slope: 1.0 }
    }
}

impl Add for Dual {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Dual { value: self.value + o.value, slope: self.slope + o.slope }
    }
}
impl Sub for Dual {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        Dual { value: self.value - o.value, slope: self.slope - o.slope }
    }
}
impl Mul for Dual {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        Dual { value: self.value * o.value, slope: self.slope * o.value + self.value * o.slope }
    }
}
impl Div for Dual {
    type Output = Self;
    fn div(self, o: Self) -> Self {
        let value = self.value / o.value;
        Dual { value, slope: (self.slope - value * o.slope) / o.value }
    }
}
impl Neg for Dual {
    type Output = Self;
    fn neg(self) -> Self {
        Dual { value: -self.value, slope: -self.slope }
    }
}
impl Nameable for Dual {}
impl Choose<bool> for Dual {
    fn pick(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }
}
impl Real for Dual {
    type Mask = bool;
    const PRECISION: Precision = Precision::Double;
    fn lit(value: f64) -> Self {
        Dual { value, slope: 0.0 }
    }
    fn sqrt(self) -> Self {
        let value = self.value.sqrt();
        // A constant stays one, also at zero.
        Dual { value, slope: if self.slope == 0.0 { 0.0 } else { self.slope / (2.0 * value) } }
    }
    fn abs(self) -> Self {
        if self.value < 0.0 { -self } else { self }
    }
    fn min(self, o: Self) -> Self {
        if self.value < o.value { self } else { o }
    }
    fn max(self, o: Self) -> Self {
        if self.value > o.value { self } else { o }
    }
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        self * factor + addend
    }
    fn lt(self, o: Self) -> bool {
        self.value < o.value
    }
    fn le(self, o: Self) -> bool {
        self.value <= o.value
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn duals_know_the_rules_of_differentiation() {
        let x = Dual::variable(2.0);
        // (x^2 + 1) / x - sqrt(2 x) at 2: 5/2 - 2, slope (1 - 1/x^2) - 1/sqrt(2 x) = 3/4 - 1/2.
        let y = (x * x + Dual::lit(1.0)) / x - (x + x).sqrt();
        assert_eq!((y.value, y.slope), (0.5, 0.25));
        assert_eq!((-x).abs().slope, 1.0);
        assert_eq!(x.power(3).slope, 12.0);
    }
}
