//! The oracle's number: 113 bits of significand, some 34 decimal digits, with the exponents of IEEE 754's binary128.
//!
//! Sums, products and quotients are rounded once, by the port of LLVM's software arithmetic that rustc itself uses
//! ([`rustc_apfloat`]); square roots are Newton's and off by a unit in the last place at most. The exponent reaches 1e4932, so
//! nothing that is finite in `f64` overflows here on the way.
//!
//! What an equation *means* differs from what an `f64` can say in two places, and here the meaning counts: a literal stands for
//! its shortest decimal (`0.1` is a tenth), and a [`Constant`] has 31 digits.

use etalon_kernels_gen::{Choose, Constant, Nameable, Precision, Real};
use rustc_apfloat::ieee;
use rustc_apfloat::{Float, FloatConvert};
use std::cell::RefCell;
use std::cmp::Ordering;
use std::collections::HashMap;
use std::fmt;
use std::ops::{Add, Div, Mul, Neg, Sub};
use std::str::FromStr;

/// A number of 113 bits. See the module's text.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
pub struct Quad(ieee::Quad);

/// A text that is no number.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{0}` is not a decimal number; write it like 1.5 or -2.5e-3")]
pub struct NotANumber(String);

impl Quad {
    /// The unit roundoff: half the distance from 1 to the next number.
    pub const UNIT: f64 = 9.62964972193618e-35; // 2^-113

    /// Exactly this number.
    #[must_use]
    pub fn exact(value: f64) -> Self {
        let mut loses = false;
        Quad(ieee::Double::from_bits(u128::from(value.to_bits())).convert(&mut loses).value)
    }
    /// The nearest `f64`.
    #[must_use]
    pub fn to_f64(self) -> f64 {
        let mut loses = false;
        let double: ieee::Double = self.0.convert(&mut loses).value;
        f64::from_bits(double.to_bits() as u64) // the upper half of the word is zero
    }
    /// Whether it is neither infinite nor NaN.
    #[must_use]
    pub fn is_finite(self) -> bool {
        self.0.is_finite()
    }
    /// `|self - target|`, to the digits of an `f64`.
    #[must_use]
    pub fn distance(self, target: f64) -> f64 {
        (self - Quad::exact(target)).abs().to_f64()
    }
}

impl FromStr for Quad {
    type Err = NotANumber;
    fn from_str(text: &str) -> Result<Self, NotANumber> {
        text.parse().map(Quad).map_err(|_| NotANumber(text.to_string()))
    }
}

impl fmt::Debug for Quad {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}
impl fmt::Display for Quad {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

macro_rules! operator {
    ($trait:ident, $method:ident) => {
        impl $trait for Quad {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Quad(self.0.$method(other.0).value)
            }
        }
    };
}
operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);

impl Neg for Quad {
    type Output = Self;
    fn neg(self) -> Self {
        Quad(-self.0)
    }
}

thread_local! {
    // Reading a decimal costs a thousand times what a product does, and equations have few literals.
    static LITERALS: RefCell<HashMap<u64, Quad>> = RefCell::default();
}

/// What a literal means: the shortest decimal that reads back as it.
fn meaning(value: f64) -> Quad {
    let exact = Quad::exact(value);
    // Whole numbers of moderate size are their own decimals.
    if !value.is_finite() || value.abs() < 1e15 && value.fract() == 0.0 {
        return exact;
    }
    let read = || format!("{value:e}").parse().unwrap_or(exact); // a printed number always reads back
    LITERALS.with_borrow_mut(|known| *known.entry(value.to_bits()).or_insert_with(read))
}

impl Nameable for Quad {}
impl Choose<bool> for Quad {
    fn pick(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }
}

impl Real for Quad {
    type Mask = bool;
    const PRECISION: Precision = Precision::Extended;

    fn lit(value: f64) -> Self {
        meaning(value)
    }
    fn constant(value: Constant) -> Self {
        Quad::exact(value.value()) + Quad::exact(value.rest())
    }
    fn sqrt(self) -> Self {
        if self.0.is_zero() || self.0.is_negative() || !self.0.is_finite() {
            return match self.0.partial_cmp(&ieee::Quad::ZERO) {
                Some(Ordering::Less) | None => Quad(ieee::Quad::NAN),
                Some(Ordering::Equal | Ordering::Greater) => self,
            };
        }
        // To [1, 4) by an even power of two, where an f64 gives a first guess of 53 bits; two steps double that twice.
        let exponent = self.0.ilogb().div_euclid(2);
        let reduced = Quad(self.0.scalbn(-2 * exponent));
        let half = Quad::exact(0.5);
        let mut root = Quad::exact(reduced.to_f64().sqrt());
        for _ in 0..2 {
            root = half * (root + reduced / root);
        }
        Quad(root.0.scalbn(exponent))
    }
    fn abs(self) -> Self {
        Quad(self.0.abs())
    }
    fn min(self, other: Self) -> Self {
        if self < other { self } else { other }
    }
    fn max(self, other: Self) -> Self {
        if self > other { self } else { other }
    }
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        self * factor + addend
    }
    fn lt(self, other: Self) -> bool {
        self < other
    }
    fn le(self, other: Self) -> bool {
        self <= other
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_go_in_and_out_unchanged() {
        for value in [0.0, 1.0, -0.1, 1e300, 5e-324, -2.5e-310, f64::MAX] {
            assert_eq!(Quad::exact(value).to_f64(), value);
        }
        assert!(!Quad::exact(f64::INFINITY).is_finite());
        assert!("a tenth".parse::<Quad>().is_err());
    }

    #[test]
    fn a_literal_is_the_decimal_it_was_written_as() {
        assert_eq!(Quad::lit(0.1) * Quad::exact(10.0), Quad::exact(1.0));
        assert_ne!(Quad::exact(0.1) * Quad::exact(10.0), Quad::exact(1.0));
        assert_eq!(Quad::lit(-1e-4) * Quad::exact(-1e4), Quad::exact(1.0));
        assert_eq!(Quad::lit(0.375), Quad::exact(0.375));
    }

    #[test]
    fn square_roots_are_right_to_the_last_place() {
        // A square root that is off by r has a square that is off by 2 r; the product rounds once more.
        for k in 1..2000 {
            let x = Quad::exact(f64::from(k) * 1.25e-3) * Quad::lit(1e-30);
            let root = x.sqrt();
            let error = ((root * root - x) / x).abs().to_f64();
            assert!(error <= 5.0 * Quad::UNIT, "{k}: {error:e}");
        }
        assert_eq!(Quad::exact(0.0).sqrt(), Quad::exact(0.0));
        assert_eq!(Quad::exact(4.0).sqrt(), Quad::exact(2.0));
        assert_eq!(Quad::exact(1e-320).sqrt().to_f64(), 1e-320_f64.sqrt());
        assert!(!Quad::exact(-1.0).sqrt().is_finite());
    }
}
