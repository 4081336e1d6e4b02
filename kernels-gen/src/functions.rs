//! The few functions beyond arithmetic that equations need, made of arithmetic and square roots only, so that every target
//! computes the same thing. Their coefficients are fitted: see [`polynomials`](crate::polynomials).

use crate::polynomials::{EXPM1_NEGATIVE, Polynomial};
use crate::real::{Precision, Real};

/// The coefficients that match the number type, lowest power first.
#[inline(always)]
pub fn coefficients<R: Real>(polynomial: &Polynomial) -> &'static [f64] {
    match R::PRECISION {
        Precision::Single => polynomial.single,
        Precision::Double => polynomial.double,
    }
}

/// The polynomial's value at `x`, by Horner's rule.
#[inline(always)]
pub fn horner<R: Real>(polynomial: &Polynomial, x: R) -> R {
    let c = coefficients::<R>(polynomial);
    let mut value = R::lit(c[c.len() - 1]);
    for k in (0..c.len() - 1).rev() {
        value = value.mul_add(x, R::lit(c[k]));
    }
    value
}

/// The polynomial's derivative at `x`, by Horner's rule on `k c_k`.
#[inline(always)]
pub fn horner_derivative<R: Real>(polynomial: &Polynomial, x: R) -> R {
    let c = coefficients::<R>(polynomial);
    let last = c.len() - 1;
    let mut value = R::lit(c[last] * last as f64);
    for k in (1..last).rev() {
        value = value.mul_add(x, R::lit(c[k] * k as f64));
    }
    value
}

/// Beyond this the exponential is no more than 1.3e-14, and [`exp_negative`] stays there.
const EXP_RANGE: f64 = 32.0;

/// `exp(-y) - 1` for `y >= 0`, good to a few roundings of itself however small `y` is.
///
/// With `x = y / 32`, `e = exp(-x) - 1` comes from a polynomial, and five doublings `e <- e (2 + e)` carry it back to
/// `exp(-y) - 1`. Neither step takes one from nearly one.
#[inline(always)]
pub fn expm1_negative<R: Real>(y: R) -> R {
    let x = y.min(R::lit(EXP_RANGE)) * R::lit(1.0 / EXP_RANGE);
    let mut e = -(x * horner(&EXPM1_NEGATIVE, x));
    for _ in 0..5 {
        e = e * (R::lit(2.0) + e);
    }
    e
}

/// `exp(-y)` for `y >= 0`.
///
/// Working on the difference from one, [`expm1_negative`], keeps the *absolute* error at a few roundings; the relative error of
/// a tiny result is that of its absolute error.
#[inline(always)]
pub fn exp_negative<R: Real>(y: R) -> R {
    R::one() + expm1_negative(y)
}

/// The cube root of a positive number of moderate size (1e-9 to 1e9).
///
/// `x^(1/4) x^(1/16) x^(1/64) = x^(21/64)` is within 12 % there; each of Halley's steps cubes the error.
#[inline(always)]
pub fn cube_root<R: Real>(x: R) -> R {
    let fourth = x.sqrt().sqrt();
    let sixteenth = fourth.sqrt().sqrt();
    let mut y = fourth * sixteenth * sixteenth.sqrt().sqrt();
    for _ in 0..3 {
        let cube = y * y * y;
        let twice = x + x;
        y = y * ((cube + twice) / (cube + cube + x));
    }
    y
}

/// The `D`-th root of a positive number of moderate size, for `D` of 1, 2 or 3.
#[inline(always)]
pub fn dimension_root<R: Real, const D: usize>(x: R) -> R {
    match D {
        1 => x,
        2 => x.sqrt(),
        _ => cube_root(x),
    }
}

/// `numerator / denominator`, and zero where the denominator is not positive. Neither side of the choice divides by zero.
#[inline(always)]
pub fn ratio_or_zero<R: Real>(numerator: R, denominator: R) -> R {
    let usable = denominator.gt(R::zero());
    let safe = R::pick(usable, denominator, R::one());
    R::pick(usable, numerator / safe, R::zero())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Scans a range in equal factors and returns the largest error in units of `epsilon`.
    fn worst(low: f64, high: f64, epsilon: f64, error: impl Fn(f64) -> f64) -> f64 {
        let n = 20_000;
        let at = |i: i32| low * (high / low).powf(i as f64 / n as f64);
        (0..=n).map(|i| error(at(i)) / epsilon).fold(0.0, f64::max)
    }

    /// Halley's last step rounds about five times, each once relative: budget 4 ulp.
    #[test]
    fn cube_root_is_a_cube_root() {
        let double = worst(1e-9, 1e9, f64::EPSILON, |x| (cube_root(x) / x.cbrt() - 1.0).abs());
        let single = worst(1e-9, 1e9, f32::EPSILON as f64, |x| {
            let x = x as f32;
            (cube_root(x) as f64 / (x as f64).cbrt() - 1.0).abs()
        });
        assert!(double < 4.0 && single < 4.0, "worst error {double} ulp (f64), {single} ulp (f32); budget 4");
    }

    /// Five doublings, three roundings each at most, on a quantity no larger than one: budget 8 epsilon absolute.
    #[test]
    fn exp_negative_is_the_exponential() {
        let double = worst(1e-12, 32.0, f64::EPSILON, |y| (exp_negative(y) - (-y).exp()).abs());
        let single = worst(1e-12, 32.0, f32::EPSILON as f64, |y| {
            let y = y as f32;
            (exp_negative(y) as f64 - (-y as f64).exp()).abs()
        });
        assert!(double < 8.0 && single < 8.0, "worst error {double} (f64), {single} (f32) epsilon; budget 8");
        assert_eq!(exp_negative(0.0), 1.0);
        assert!(exp_negative(1e30_f64) < 2e-14 && exp_negative(1e30_f64) >= 0.0);
    }

    /// Five doublings of three roundings on what came from fifteen, each relative: budget 20 epsilon.
    #[test]
    fn expm1_negative_keeps_its_digits_down_to_nothing() {
        let double = worst(1e-300, 30.0, f64::EPSILON, |y| (expm1_negative(y) / (-y).exp_m1() - 1.0).abs());
        let single = worst(1e-30, 30.0, f32::EPSILON as f64, |y| {
            let y = y as f32;
            (expm1_negative(y) as f64 / (-y as f64).exp_m1() - 1.0).abs()
        });
        println!("{double} (f64), {single} (f32) epsilon");
        assert!(double < 20.0 && single < 20.0, "worst error {double} (f64), {single} (f32) epsilon; budget 20");
        assert_eq!(expm1_negative(0.0), 0.0);
    }

    #[test]
    fn ratio_or_zero_never_divides_by_zero() {
        assert_eq!(ratio_or_zero(3.0, 2.0), 1.5);
        assert_eq!(ratio_or_zero(3.0, 0.0), 0.0);
        assert_eq!(ratio_or_zero(0.0, 0.0), 0.0);
        assert_eq!(ratio_or_zero(3.0, -1.0), 0.0);
    }
}
