//! Sines, cosines and exponentials, as a textbook takes them for granted. The equations' own number has none; these are here so that a textbook's
//! form can be tried.
//!
//! `f32` and `f64` have them to the last half unit, from a series with 113 bits: the best that a library could do. In a drawing they are this
//! project's own polynomials, whose operations stand for what such a call costs.

use crate::quad::Quad;
use etalon_kernels_gen::functions::{exp_negative, sine_of_turns};
use etalon_kernels_gen::trace::{Significand, Symbol};
use etalon_kernels_gen::{Constant, Real};

/// A number with the functions of a textbook.
pub trait Elementary: Real {
    /// The sine, for up to half a turn.
    fn sin(self) -> Self;
    /// The cosine, for up to half a turn.
    fn cos(self) -> Self;
    /// `exp(-self)`, for what is not negative.
    fn exp_minus(self) -> Self;
}

/// Terms of both series: `pi^52 / 52!` is below 1e-40.
const SINE_TERMS: u32 = 26;
/// Terms of the exponential's, for arguments up to one half.
const EXPONENTIAL_TERMS: u32 = 30;
/// `exp(-750)` is below every `f64`.
const VANISHED: f64 = 750.0;

/// `first (1 - x^2 / ((n+1)(n+2)) (1 - ...))`: the series of the sine from `n = 1`, of the cosine from `n = 0`.
fn alternating(first: Quad, n: u32, x: Quad) -> Quad {
    let square = x * x;
    let whole = |k: u32| Quad::exact(f64::from(k));
    let step = |value: Quad, k: u32| whole(1) - square / whole((n + 2 * k + 1) * (n + 2 * k + 2)) * value;
    first * (0..SINE_TERMS).rev().fold(whole(1), step)
}

impl Elementary for Quad {
    fn sin(self) -> Self {
        // Where the sine comes back to zero the series would cancel.
        let turned = Quad::constant(Constant::PI) - self;
        if turned.abs() < self.abs() { alternating(turned, 1, turned) } else { alternating(self, 1, self) }
    }
    fn cos(self) -> Self {
        alternating(Quad::exact(1.0), 0, self)
    }
    fn exp_minus(self) -> Self {
        if Quad::exact(VANISHED) < self {
            return Quad::exact(0.0);
        }
        let mut halvings = 0;
        let mut x = self;
        while Quad::exact(0.5) < x {
            x = x * Quad::exact(0.5);
            halvings += 1;
        }
        let one = Quad::exact(1.0);
        let term = |value: Quad, k: u32| one - x / Quad::exact(f64::from(k)) * value;
        let small = (1..EXPONENTIAL_TERMS).rev().fold(one, term);
        (0..halvings).fold(small, |value, _| value * value)
    }
}

macro_rules! rounded {
    ($type:ty, $into:expr, $out:expr) => {
        impl Elementary for $type {
            fn sin(self) -> Self {
                $out(Elementary::sin($into(self)))
            }
            fn cos(self) -> Self {
                $out(Elementary::cos($into(self)))
            }
            fn exp_minus(self) -> Self {
                $out($into(self).exp_minus())
            }
        }
    };
}
rounded!(f64, Quad::exact, Quad::to_f64);
rounded!(f32, |x: f32| Quad::exact(f64::from(x)), |x: Quad| x.to_f64() as f32);

impl<P: Significand> Elementary for Symbol<P> {
    fn sin(self) -> Self {
        sine_of_turns(self * Self::lit(1.0 / std::f64::consts::TAU))
    }
    fn cos(self) -> Self {
        sine_of_turns(self * Self::lit(1.0 / std::f64::consts::TAU) + Self::lit(0.25))
    }
    fn exp_minus(self) -> Self {
        exp_negative(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The standard library's are good to a unit in the last place or so.
    #[test]
    fn functions_are_those_of_the_library() {
        for k in 0..=400 {
            let x = f64::from(k) * std::f64::consts::PI / 400.0;
            for (name, found, due) in [
                ("sin", Elementary::sin(x), f64::sin(x)),
                ("cos", Elementary::cos(x), f64::cos(x)),
                ("exp", (10.0 * x).exp_minus(), (-10.0 * x).exp()),
            ] {
                assert!((found - due).abs() <= 2.0 * f64::EPSILON * due.abs(), "{name} at {x}: {found:e}, not {due:e}");
            }
        }
        assert_eq!((0.0_f64.exp_minus(), 800.0_f64.exp_minus(), 1e30_f32.exp_minus()), (1.0, 0.0, 0.0));
        // Beyond twice pi's first 53 bits, which the library has too: sin(fl(pi)) is what fl(pi) lacks.
        assert_eq!(Elementary::sin(std::f64::consts::PI), Constant::PI.rest());
    }

    #[test]
    fn sine_and_cosine_have_thirty_digits() {
        for k in 1..=31 {
            let x = Quad::exact(f64::from(k)) * Quad::lit(0.1);
            let (s, c) = (Elementary::sin(x), Elementary::cos(x));
            let off = (s * s + c * c - Quad::exact(1.0)).abs().to_f64();
            assert!(off < 1e-30, "{k}: {off:e}");
            // Halving: sin x = 2 sin x/2 cos x/2.
            let half = x * Quad::exact(0.5);
            let double = (s - Quad::exact(2.0) * Elementary::sin(half) * Elementary::cos(half)).abs().to_f64();
            assert!(double < 1e-30, "{k}: {double:e}");
        }
    }
}
