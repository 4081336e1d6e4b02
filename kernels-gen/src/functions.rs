//! The few functions beyond arithmetic that equations need, made of arithmetic and square roots only, so that every target
//! computes the same thing. Their coefficients are fitted: see [`polynomials`](crate::polynomials).

use crate::constant::Constant;
use crate::polynomials::{ARTANH, EXPM1_NEGATIVE, Polynomial, SINC};
use crate::real::{Mask, Precision, Real};
use std::f64::consts::SQRT_2;

/// How many coefficients the number type deserves.
#[inline(always)]
fn length<R: Real>(polynomial: &Polynomial) -> usize {
    match R::PRECISION {
        Precision::Single => polynomial.single.len(),
        Precision::Double => polynomial.double.len(),
        Precision::Extended => polynomial.extended.len(),
    }
}

/// `factor` times the coefficient of the `k`-th power in the set that matches the number type.
#[inline(always)]
fn coefficient<R: Real>(polynomial: &Polynomial, k: usize, factor: f64) -> R {
    match R::PRECISION {
        Precision::Single => R::lit(polynomial.single[k] * factor),
        Precision::Double => R::lit(polynomial.double[k] * factor),
        Precision::Extended => R::constant(polynomial.extended[k].times(Constant::new(factor))),
    }
}

/// The polynomial's value at `x`, by Horner's rule.
#[inline(always)]
pub fn horner<R: Real>(polynomial: &Polynomial, x: R) -> R {
    let last = length::<R>(polynomial) - 1;
    let mut value = coefficient::<R>(polynomial, last, 1.0);
    for k in (0..last).rev() {
        value = value.mul_add(x, coefficient(polynomial, k, 1.0));
    }
    value
}

/// The polynomial's derivative at `x`, by Horner's rule on `k c_k`.
#[inline(always)]
pub fn horner_derivative<R: Real>(polynomial: &Polynomial, x: R) -> R {
    let last = length::<R>(polynomial) - 1;
    let mut value = coefficient::<R>(polynomial, last, last as f64);
    for k in (1..last).rev() {
        value = value.mul_add(x, coefficient(polynomial, k, k as f64));
    }
    value
}

/// Up to where the exponential is computed, beyond which it stays, and by how many doublings from there.
///
/// `exp(-32)` is 1.3e-14: as good as nothing beside one, but no oracle. With extended precision it is `exp(-256)`, 1e-111.
#[inline(always)]
fn exp_range<R: Real>() -> (f64, u32) {
    match R::PRECISION {
        Precision::Single | Precision::Double => (32.0, 5),
        Precision::Extended => (256.0, 8),
    }
}

/// `exp(-x) - 1` of the `x = y / range` that is small enough for the polynomial.
#[inline(always)]
fn reduced_expm1<R: Real>(y: R) -> R {
    let (range, _) = exp_range::<R>();
    let x = R::lit(range).min(y) * R::lit(1.0 / range);
    -(x * horner(&EXPM1_NEGATIVE, x))
}

/// `exp(-y) - 1` for `y >= 0`, to a relative error of a few roundings also where `y` is tiny.
///
/// With `x = y / 32`, `e = exp(-x) - 1` comes from a polynomial, and five doublings `e <- e (2 + e)` carry it back.
#[inline(always)]
pub fn expm1_negative<R: Real>(y: R) -> R {
    let mut e = reduced_expm1(y);
    for _ in 0..exp_range::<R>().1 {
        e = e * (R::lit(2.0) + e);
    }
    e
}

/// `exp(-y)` for `y >= 0`.
///
/// Working on the difference from one, [`expm1_negative`], keeps the *absolute* error at a few roundings; the relative error of a
/// tiny result is that of its absolute error. A number with extended precision, which is to know better, squares `exp(-x)`
/// instead: right to the last digits wherever the result is above 1e-111.
#[inline(always)]
pub fn exp_negative<R: Real>(y: R) -> R {
    if R::PRECISION == Precision::Extended {
        let (_, doublings) = exp_range::<R>();
        return (R::one() + reduced_expm1(y)).power(1 << doublings);
    }
    R::one() + expm1_negative(y)
}

/// The natural logarithm of a positive number that is not subnormal.
///
/// Powers of two are taken out by halving, which is exact, until `x = 2^n m` with `m` between `sqrt(1/2)` and `sqrt(2)`; then
/// `ln x = n ln 2 + 2 artanh((m - 1) / (m + 1))`. Near one `n = 0` and `m = x`, so a small logarithm keeps its relative accuracy.
#[inline(always)]
pub fn logarithm<R: Real>(x: R) -> R {
    let (mut m, mut n) = (x, R::zero());
    let mut take_out = |when: R::Mask, factor: f64, power: i32| {
        m = R::pick(when, m * R::lit(factor), m);
        n = R::pick(when, n + R::lit(f64::from(power)), n);
        m
    };
    let mut rest = x;
    let first = match R::PRECISION {
        Precision::Single => 6,
        Precision::Double | Precision::Extended => 9,
    };
    for k in (0..=first).rev() {
        let power = 1 << k;
        rest = take_out(rest.ge(R::lit(2_f64.powi(power))), 2_f64.powi(-power), power);
        rest = take_out(rest.lt(R::lit(2_f64.powi(1 - power))), 2_f64.powi(power), -power);
    }
    rest = take_out(rest.gt(R::lit(SQRT_2)), 0.5, 1);
    let z = (rest - R::one()) / (rest + R::one());
    (z + z).mul_add(horner(&ARTANH, R::lit(4.0) * (z * z)), n * R::constant(Constant::LN_2))
}

/// The sine of an angle in turns, `sin(2 pi t)`, for `|t|` up to 16.
///
/// Whole turns are taken off, which is exact, until `|s| <= 1/2`; then `sin(2 pi s) = 2 pi s (1 - 4 s^2) p(4 s^2)` with the polynomial of
/// the sinc kernels. The zeros at half turns are factors, so the result is relatively accurate near them.
#[inline(always)]
pub fn sine_of_turns<R: Real>(turns: R) -> R {
    let mut rest = turns.abs();
    for whole in [8.0, 4.0, 2.0, 1.0] {
        rest = R::pick(rest.ge(R::lit(whole)), rest - R::lit(whole), rest);
    }
    let s = R::pick(rest.gt(R::lit(0.5)), rest - R::one(), rest);
    let twice = s + s;
    let zeros = (R::one() - twice) * (R::one() + twice);
    let sine = (R::constant(Constant::TAU) * s) * (zeros * horner(&SINC, twice * twice));
    R::pick(turns.lt(R::zero()), -sine, sine)
}

/// The cube root of a positive number of moderate size (1e-9 to 1e9).
///
/// `x^(1/4) x^(1/16) x^(1/64) = x^(21/64)` is within 12 % there; each of Halley's steps cubes the error.
#[inline(always)]
pub fn cube_root<R: Real>(x: R) -> R {
    let fourth = x.sqrt().sqrt();
    let sixteenth = fourth.sqrt().sqrt();
    let mut y = fourth * sixteenth * sixteenth.sqrt().sqrt();
    // 0.12, 1.2e-3, 1.2e-9, 1e-27; a fourth step for those who can tell.
    let steps = if R::PRECISION == Precision::Extended { 4 } else { 3 };
    for _ in 0..steps {
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

/// `numerator / denominator`, and zero where the denominator is zero or negative. Neither side of the choice divides by zero.
#[inline(always)]
pub fn ratio_or_zero<R: Real>(numerator: R, denominator: R) -> R {
    // Not asked whether it is positive: what is not a number is to come out as such, not as zero.
    let unusable = denominator.le(R::zero());
    let safe = R::pick(unusable, R::one(), denominator);
    R::pick(unusable, R::zero(), numerator / safe)
}

/// The smaller of two numbers, and NaN if either is: what [`Real::min`] does only for its second argument.
///
/// Costs five operations instead of one, so it is for what is computed once a particle.
#[inline(always)]
pub fn smaller<R: Real>(a: R, b: R) -> R {
    let comparable = a.le(b).or(b.lt(a));
    R::pick(comparable, a.min(b), a + b)
}

/// The larger of two numbers, and NaN if either is; see [`smaller`].
#[inline(always)]
pub fn larger<R: Real>(a: R, b: R) -> R {
    let comparable = a.le(b).or(b.lt(a));
    R::pick(comparable, a.max(b), a + b)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

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

    /// Relative, down to the smallest normal numbers. A doubling rounds twice, and both terms of `2 + e` being of one size it passes
    /// on no more than it gets: five doublings, Horner's last step and two products make 14 roundings, 7 epsilon.
    #[test]
    fn expm1_negative_keeps_its_digits_near_zero() {
        let double = worst(1e-300, 32.0, f64::EPSILON, |y| (expm1_negative(y) / (-y).exp_m1() - 1.0).abs());
        let single = worst(1e-30, 32.0, f32::EPSILON as f64, |y| {
            let y = y as f32;
            (expm1_negative(y) as f64 / (-y as f64).exp_m1() - 1.0).abs()
        });
        assert!(double < 7.0 && single < 7.0, "worst error {double} (f64), {single} (f32) epsilon; budget 7");
        assert_eq!(expm1_negative(0.0), 0.0);
    }

    /// The quotient rounds three times, the polynomial and the last sum twice more: budget 6 epsilon of the logarithm itself, near one too.
    #[test]
    fn logarithm_is_the_logarithm() {
        let off = |found: f64, x: f64| if x == 1.0 { found.abs() } else { (found / x.ln() - 1.0).abs() };
        for (low, high) in [(1e-300, 1e300), (0.5, 2.0), (1.0 - 1e-6, 1.0 + 1e-6)] {
            let double = worst(low, high, f64::EPSILON, |x| off(logarithm(x), x));
            assert!(double < 6.0, "worst error {double} epsilon between {low} and {high}; budget 6");
        }
        for (low, high) in [(1e-37, 1e37), (0.5, 2.0), (1.0 - 1e-3, 1.0 + 1e-3)] {
            let single = worst(low, high, f32::EPSILON as f64, |x| off(logarithm(x as f32) as f64, x as f32 as f64));
            assert!(single < 6.0, "worst error {single} epsilon between {low} and {high}; budget 6");
        }
        assert_eq!((logarithm(1.0), logarithm(1.0_f32)), (0.0, 0.0));
        for extreme in [f64::MIN_POSITIVE, f64::MAX, 2.0, 0.5, 4.0, 0.25] {
            assert!(off(logarithm(extreme), extreme) < 6.0 * f64::EPSILON, "{extreme:e}");
        }
        for extreme in [f32::MIN_POSITIVE, f32::MAX] {
            assert!(off(logarithm(extreme) as f64, extreme as f64) < 6.0 * f32::EPSILON as f64, "{extreme:e}");
        }
    }

    /// Eight roundings of factors, and one of the standard library's argument: budget 8 epsilon relative, short of the half turn in `f64`,
    /// where that argument has no digits to compare with.
    #[test]
    fn sine_of_turns_is_the_sine() {
        let single = worst(1e-30, 0.49999, f32::EPSILON as f64, |t| {
            let t = t as f32;
            (sine_of_turns(t) as f64 / (TAU * t as f64).sin() - 1.0).abs()
        });
        let double = worst(1e-300, 0.3, f64::EPSILON, |t| (sine_of_turns(t) / (TAU * t).sin() - 1.0).abs());
        assert!(single < 8.0 && double < 8.0, "worst error {double} (f64), {single} (f32) epsilon; budget 8");
        for (turns, due) in [(0.0, 0.0), (0.25, 1.0), (0.5, 0.0), (0.75, -1.0), (1.0, 0.0), (15.25, 1.0), (-2.25, -1.0)]
        {
            assert!((sine_of_turns(turns) - due).abs() < 4.0 * f64::EPSILON, "sine of {turns} turns");
        }
        // A twelfth of a turn is a half; whole turns change nothing, not even a bit where they are exact.
        assert!((sine_of_turns(1.0 / 12.0) - 0.5).abs() < 4.0 * f64::EPSILON);
        for whole in [1.0, 2.0, 5.0, 8.0, 15.0] {
            assert_eq!(sine_of_turns(whole + 0.375), sine_of_turns(0.375));
            assert_eq!(sine_of_turns(-whole - 0.375), -sine_of_turns(0.375));
        }
    }

    #[test]
    fn ratio_or_zero_never_divides_by_zero() {
        assert_eq!(ratio_or_zero(3.0, 2.0), 1.5);
        assert_eq!(ratio_or_zero(3.0, 0.0), 0.0);
        assert_eq!(ratio_or_zero(0.0, 0.0), 0.0);
        assert_eq!(ratio_or_zero(3.0, -1.0), 0.0);
        assert!(ratio_or_zero(3.0, f64::NAN).is_nan() && ratio_or_zero(f64::NAN, 3.0).is_nan());
    }

    #[test]
    fn neither_side_hides_what_is_not_a_number() {
        assert_eq!((smaller(2.0, 3.0), smaller(3.0, 2.0), smaller(2.0, 2.0)), (2.0, 2.0, 2.0));
        assert_eq!((larger(2.0, 3.0), larger(3.0, 2.0), larger(2.0, 2.0)), (3.0, 3.0, 2.0));
        let infinite = f64::INFINITY;
        assert_eq!(
            (smaller(infinite, 1.0), larger(-infinite, 1.0), smaller(-infinite, infinite)),
            (1.0, 1.0, -infinite)
        );
        for (a, b) in [(f64::NAN, 1.0), (1.0, f64::NAN), (f64::NAN, f64::NAN), (f64::NAN, infinite)] {
            assert!(smaller(a, b).is_nan() && larger(a, b).is_nan(), "{a}, {b}");
        }
        for y in [exp_negative(f64::NAN), expm1_negative(f64::NAN), logarithm(f64::NAN), sine_of_turns(f64::NAN)] {
            assert!(y.is_nan());
        }
    }
}
