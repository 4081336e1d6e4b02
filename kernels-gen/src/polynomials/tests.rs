//! The generated numbers against truths computed here: Taylor series in double-double arithmetic
//! (twofloat, about 31 digits; only its `+ - * /` are used, whose relative error is below 1e-30).

use super::{
    ARTANH, EXPM1_NEGATIVE, Polynomial, SINC, SINC_4_NORMALISATION, SINC_9_NORMALISATION, SINC_SLOPE_DOUBLE_ERROR,
    SINC_SLOPE_EXTENDED_ERROR,
    SINC_SLOPE_SINGLE_ERROR,
};
use crate::constant::Constant;
use twofloat::TwoFloat;

const SAMPLES: u32 = 4096;

/// Error of the truths themselves: 60 terms with a few double-double roundings each.
const TRUTH_ERROR: f64 = 1e-28;

fn exact(value: f64) -> TwoFloat {
    TwoFloat::from(value)
}

/// Horner's rule in double-double.
fn evaluate(coefficients: &[f64], t: TwoFloat) -> TwoFloat {
    let start = exact(0.0);
    coefficients.iter().rev().fold(start, |sum, &c| sum * t + c)
}

/// sum_k term_k with term_0 = 1 and term_k = term_{k-1} * factor(k).
fn series(factor: impl Fn(f64) -> TwoFloat) -> TwoFloat {
    let mut term = exact(1.0);
    let mut sum = term;
    for k in 1..60 {
        term *= factor(f64::from(k));
        sum += term;
    }
    sum
}

fn pi_squared() -> TwoFloat {
    twofloat::consts::PI * twofloat::consts::PI
}

/// sinc(pi sqrt t) = sum_k (-pi^2 t)^k / (2k + 1)!
fn sinc(t: TwoFloat) -> TwoFloat {
    series(|k| -pi_squared() * t / (2.0 * k * (2.0 * k + 1.0)))
}

/// d/dt sinc(pi sqrt t) = -(pi^2/6) sum_k (k + 1) 6 (-pi^2 t)^k / (2k + 3)!
fn sinc_slope(t: TwoFloat) -> TwoFloat {
    let sum = series(|k| -pi_squared() * t * (k + 1.0) / (k * (2.0 * k + 2.0) * (2.0 * k + 3.0)));
    -pi_squared() / 6.0 * sum
}

/// (1 - exp(-x))/x = sum_k (-x)^k / (k + 1)!
fn reduced_expm1(x: TwoFloat) -> TwoFloat {
    series(|k| -x / (k + 1.0))
}

/// artanh(z)/z = sum_k (t/4)^k / (2k + 1), t = 4 z^2: after 60 terms less than 4^-60 = 1e-36 is missing.
fn reduced_artanh(t: TwoFloat) -> TwoFloat {
    series(|k| t * (2.0 * k - 1.0) / (4.0 * (2.0 * k + 1.0)))
}

/// exp(-y) for y >= 0 through exp(-y/64), squared six times (the relative error grows 64 fold).
fn exp_negative(y: f64) -> f64 {
    let mut power = series(|k| exact(-y / 64.0) / k);
    for _ in 0..6 {
        power = power * power;
    }
    power.hi()
}

/// Largest relative error over (0, 1); the end points have their own tests.
fn largest_error(approximation: impl Fn(TwoFloat) -> TwoFloat, truth: impl Fn(TwoFloat) -> TwoFloat) -> f64 {
    (1..SAMPLES)
        .map(|k| {
            let t = exact(f64::from(k) / f64::from(SAMPLES));
            ((approximation(t) - truth(t)) / truth(t)).hi().abs()
        })
        .fold(0.0, f64::max)
}

/// The stated bound holds, and is not so loose that it would hide a changed coefficient.
fn assert_stated(what: &str, measured: f64, stated: f64) {
    println!("{what}: measured {measured:e}, stated {stated:e}");
    assert!(measured <= stated + TRUTH_ERROR, "{what}: {measured:e} exceeds {stated:e}");
    assert!(measured >= 0.9 * stated, "{what}: {measured:e} is far below {stated:e}");
}

fn sinc_approximation(coefficients: &'static [f64]) -> impl Fn(TwoFloat) -> TwoFloat {
    move |t| (exact(1.0) - t) * evaluate(coefficients, t)
}

#[test]
fn sinc_has_the_stated_error() {
    let Polynomial { single, double, single_error, double_error, .. } = SINC;
    assert_stated("sinc f32", largest_error(sinc_approximation(single), sinc), single_error);
    assert_stated("sinc f64", largest_error(sinc_approximation(double), sinc), double_error);
}

#[test]
fn sinc_slope_has_the_stated_error() {
    // Largest at t = 0, where the slope is -1 + c_1 against -pi^2/6.
    let sets = [(SINC.single, SINC_SLOPE_SINGLE_ERROR), (SINC.double, SINC_SLOPE_DOUBLE_ERROR)];
    for (coefficients, stated) in sets {
        let slope: Vec<f64> = (1..coefficients.len()).map(|k| k as f64 * coefficients[k]).collect();
        let approximation = |t: TwoFloat| (exact(1.0) - t) * evaluate(&slope, t) - evaluate(coefficients, t);
        let at_zero = ((approximation(exact(0.0)) - sinc_slope(exact(0.0))) * 6.0 / pi_squared()).hi();
        let measured = largest_error(approximation, sinc_slope).max(at_zero.abs());
        assert_stated("sinc slope", measured, stated);
    }
}

#[test]
fn expm1_negative_has_the_stated_error() {
    let Polynomial { single, double, single_error, double_error, .. } = EXPM1_NEGATIVE;
    for (coefficients, stated) in [(single, single_error), (double, double_error)] {
        let measured = largest_error(|x| evaluate(coefficients, x), reduced_expm1);
        assert_stated("expm1", measured, stated);
    }
}

#[test]
fn artanh_has_the_stated_error() {
    let Polynomial { single, double, single_error, double_error, .. } = ARTANH;
    for (coefficients, stated) in [(single, single_error), (double, double_error)] {
        let measured = largest_error(|t| evaluate(coefficients, t), reduced_artanh);
        assert_stated("artanh", measured, stated);
    }
}

#[test]
fn values_at_the_ends() {
    for polynomial in [SINC, EXPM1_NEGATIVE, ARTANH] {
        assert_eq!(polynomial.single[0], 1.0);
        assert_eq!(polynomial.double[0], 1.0);
    }
    // p(1) = prod_{n >= 2} (1 - 1/n^2) = 1/2.
    for (coefficients, stated) in [(SINC.single, SINC.single_error), (SINC.double, SINC.double_error)] {
        let error = (evaluate(coefficients, exact(1.0)) * 2.0 - 1.0).hi().abs();
        assert!(error <= stated + TRUTH_ERROR, "{error:e} exceeds {stated:e}");
    }
}

/// Horner's rule in double-double on coefficients in double-double.
fn evaluate_extended(polynomial: &Polynomial, t: TwoFloat) -> TwoFloat {
    let pair = |c: &Constant| exact(c.value()) + exact(c.rest());
    polynomial.extended.iter().rev().fold(exact(0.0), |sum, c| sum * t + pair(c))
}

#[test]
fn extended_coefficients_are_as_good_as_the_truths_here() {
    let sinc_error = largest_error(|t| (exact(1.0) - t) * evaluate_extended(&SINC, t), sinc);
    let expm1_error = largest_error(|x| evaluate_extended(&EXPM1_NEGATIVE, x), reduced_expm1);
    let artanh_error = largest_error(|t| evaluate_extended(&ARTANH, t), reduced_artanh);
    println!("sinc {sinc_error:e}, expm1 {expm1_error:e}, artanh {artanh_error:e}; truths are off by up to {TRUTH_ERROR:e}");
    assert!(sinc_error.max(expm1_error).max(artanh_error) < TRUTH_ERROR);
    let stated = [SINC.extended_error, SINC_SLOPE_EXTENDED_ERROR, EXPM1_NEGATIVE.extended_error, ARTANH.extended_error];
    assert!(stated.iter().all(|error| *error < 1e-31), "{stated:?}");
}

#[test]
fn single_coefficients_are_exact_in_f32() {
    for coefficient in [SINC.single, EXPM1_NEGATIVE.single, ARTANH.single].concat() {
        assert_eq!(f64::from(coefficient as f32), coefficient);
    }
}

/// The recipe of [`EXPM1_NEGATIVE`] in the arithmetic of a float, with every operation rounded.
macro_rules! exp_negative_in {
    ($name:ident, $float:ty) => {
        fn $name(y: $float, coefficients: &[f64]) -> $float {
            let x = y.min(32.0) * (1.0 / 32.0);
            let p = coefficients.iter().rev().fold(0.0, |sum, &c| sum * x + c as $float);
            let mut e = -x * p;
            for _ in 0..5 {
                e *= 2.0 + e;
            }
            1.0 + e
        }
    };
}
exp_negative_in!(exp_negative_single, f32);
exp_negative_in!(exp_negative_double, f64);

/// Bound of the absolute error of exp(-y) so evaluated, for unit roundoff `u`.
///
/// At the start e = -x P carries the relative errors of P, of Horner's rule and of the last product.
/// Horner's rule for P, whose terms are 1, x/2, x^2/6, ...: the innermost sums are small, so its error
/// stays below u (1 + x (1/2 + 1) + ...) < 3u; with the product 4u. A doubling e (2 + e) maps an absolute
/// error d to 2 (1 + e) d and adds two roundings, 2u |e'|; the last sum adds u of the result.
/// Second-order terms are below 1e-5 of the whole, covered by the factor 1.001.
fn rounding_bound(y: f64, unit_roundoff: f64, fit_error: f64) -> f64 {
    let x = y.min(32.0) / 32.0;
    let mut e = (-x).exp_m1();
    let mut error = (4.0 * unit_roundoff + fit_error) * -e;
    for _ in 0..5 {
        error *= 2.0 * (1.0 + e);
        e *= 2.0 + e;
        error += 2.0 * unit_roundoff * -e;
    }
    1.001 * (error + unit_roundoff * (1.0 + e))
}

#[test]
fn exp_of_minus_y_is_within_its_rounding_bound() {
    let mut worst = [0.0_f64; 4]; // absolute and relative, f32 and f64; relative for y <= 1
    for k in 0..=32 * 1024 {
        // 37/36 leaves the grid of round numbers; y up to 32.9 passes the clamp.
        let y = (k as f32) / 1024.0 * (37.0 / 36.0);
        let clamped = f64::from(y).min(32.0);
        let truth = exp_negative(clamped);
        let single = f64::from(exp_negative_single(y, EXPM1_NEGATIVE.single));
        let double = exp_negative_double(f64::from(y), EXPM1_NEGATIVE.double);
        let cases = [
            (single, f64::from(f32::EPSILON) / 2.0, EXPM1_NEGATIVE.single_error),
            (double, f64::EPSILON / 2.0, EXPM1_NEGATIVE.double_error),
        ];
        for (i, (value, unit_roundoff, fit_error)) in cases.into_iter().enumerate() {
            // The truth is rounded to f64, which counts for the double case only.
            let error = (value - truth).abs();
            let bound = rounding_bound(clamped, unit_roundoff, fit_error) + f64::EPSILON / 2.0 * truth;
            assert!(error <= bound, "y = {y}: error {error:e}, bound {bound:e}");
            assert!((0.0..=1.0).contains(&value), "y = {y}: {value:e} is no exponential");
            worst[2 * i] = worst[2 * i].max(error);
            if y <= 1.0 {
                worst[2 * i + 1] = worst[2 * i + 1].max(error / truth);
            }
        }
    }
    println!("exp(-y), largest absolute and (y <= 1) relative error, f32 then f64: {worst:?}");
    assert_eq!(exp_negative_single(0.0, EXPM1_NEGATIVE.single), 1.0);
    assert_eq!(exp_negative_double(0.0, EXPM1_NEGATIVE.double), 1.0);
}

#[test]
fn sinc_kernels_have_unit_integral() {
    // Simpson's rule: h^4/180 times the length 2 times a fourth derivative below 2000 (S_9: B, n^2 and
    // 4 pi included) at h = 2/8192 gives 8e-14; summing 8193 terms adds less than 1e-12 in the worst case.
    const INTERVALS: u32 = 8192;
    let tolerance = 1.1e-12;
    for (power, normalisation) in [(4, SINC_4_NORMALISATION), (9, SINC_9_NORMALISATION)] {
        for (dimension, b) in (1_i32..).zip(normalisation) {
            let pi = std::f64::consts::PI;
            let shell = [2.0, 2.0 * pi, 4.0 * pi][dimension as usize - 1];
            let h = 2.0 / f64::from(INTERVALS);
            let sum: f64 = (0..=INTERVALS)
                .map(|k| {
                    let q = f64::from(k) * h;
                    let x = pi * q / 2.0;
                    let s = if k == 0 { 1.0 } else { x.sin() / x };
                    let weight = match k {
                        0 | INTERVALS => 1.0,
                        _ if k % 2 == 1 => 4.0,
                        _ => 2.0,
                    };
                    weight * s.powi(power) * q.powi(dimension - 1)
                })
                .sum();
            let error = (b.value() * shell * sum * h / 3.0 - 1.0).abs();
            println!("S_{power} in {dimension}-D: integral off by {error:e}, tolerance {tolerance:e}");
            assert!(error <= tolerance);
        }
    }
}
