//! The six kernels, in one to three dimensions and two precisions.

// Published figures are given with all their digits.
#![allow(clippy::excessive_precision)]

use crate::check::{UNIT, assert_close, gamma};
use crate::dual::Dual;
use crate::float::Float;
use crate::quadrature::{POINTS, over_space};
use etalon_kernels_gen::polynomials::SINC;
use etalon_kernels_gen::{Precision, Real};
use etalon_reference::equations::kernels::{
    Shape, central_value, inverse_volume, kernel_shape, sinc_half_pi, smoothing_length_derivative,
};
use etalon_reference::schemes::Kernel;
use std::f64::consts::PI;

/// Runs a generic check for one, two and three dimensions and every kernel.
macro_rules! for_each_kernel {
    ($check:ident) => {
        for &kernel in Kernel::ALL {
            $check::<1>(kernel);
            $check::<2>(kernel);
            $check::<3>(kernel);
        }
    };
}

/// The shape of any number type in a dimension known at run time.
fn shape<R: Real>(kernel: Kernel, dimension: usize, q_squared: R) -> Shape<R> {
    match dimension {
        1 => kernel_shape::<R, 1>(kernel, q_squared),
        2 => kernel_shape::<R, 2>(kernel, q_squared),
        _ => kernel_shape::<R, 3>(kernel, q_squared),
    }
}

/// What is known about the rounding of a kernel.
struct Budget {
    /// Rounding errors of value and slope, in units of the sum of the magnitudes of their terms.
    roundings: usize,
    /// Relative error of `q^2` that stands for the rounding of `q` on its way in.
    input: f64,
    /// Largest ratio of the sum of the terms' magnitudes to the value or slope at the centre; one where all terms have
    /// one sign.
    cancellation: f64,
}

fn budget(kernel: Kernel) -> Budget {
    // Those with a square root of q^2 round q once more: u in q is 2u in q^2.
    let rooted = |roundings, cancellation| Budget { roundings, input: 3.0, cancellation };
    match kernel {
        // Horner's rule for p, terms |c_k| with 2k+1 roundings: 8u of p at worst, 11u for the slope; s is p times the
        // edge: 10u. s^9 has nine times that and eight products; coefficients and sums eight more.
        Kernel::MixedSinc => Budget { roundings: 9 * 10 + 8 + 11 + 8, input: 1.0, cancellation: 1.0 },
        // A power n of a rounded base has n + (n - 1) roundings; coefficients, sums, normalisation and the last
        // product ten more. At the centre 2 + 1 make a value of 1; the slope's terms are -3 and up to 9/4.
        Kernel::CubicSpline => rooted(5 + 10, 3.0 / 0.75),
        // 243 + 192 + 15 make 66; 120, 120 q^2 and 50 q^3 make -50 at q = 1: 290 / 50.
        Kernel::QuinticSpline => rooted(9 + 10, 6.9),
        // All terms positive: the power, and Horner's rule of degree up to three with two roundings a degree.
        Kernel::WendlandC2 | Kernel::WendlandC4 | Kernel::WendlandC6 => rooted(15 + 6 + 10, 1.0),
    }
}

/// The tolerance of `quantity(q^2)`: its own roundings, and what the rounding of `q^2` does to it.
fn tolerance<T: Float>(kernel: Kernel, quantity: Dual, q_squared: f64) -> f64 {
    let Budget { roundings, input, cancellation } = budget(kernel);
    let fit = if kernel == Kernel::MixedSinc && T::PRECISION == Precision::Single { 9.0 * 5.35e-9 } else { 0.0 };
    let smallest = if T::PRECISION == Precision::Single { f32::MIN_POSITIVE as f64 } else { f64::MIN_POSITIVE };
    let own = (gamma(roundings, T::UNIT) * cancellation + fit) * quantity.value.abs();
    own + input * T::UNIT * q_squared * quantity.slope.abs() + smallest
}

struct Entry {
    kernel: Kernel,
    dimension: usize,
    q: f64,
    value: f64,
    slope: f64,
}

/// The table of 30-digit values, made by independent means.
fn table() -> Vec<Entry> {
    let text = include_str!("../../../kernels-gen/coefficients/kernel_values.toml");
    let parsed: toml::Table = text.parse().unwrap();
    let mut entries = Vec::new();
    for block in parsed["kernel"].as_array().unwrap() {
        let kernel = match block["name"].as_str().unwrap() {
            "sinc_4_9" => Kernel::MixedSinc,
            "m4" => Kernel::CubicSpline,
            "m6" => Kernel::QuinticSpline,
            "wendland_c2" => Kernel::WendlandC2,
            "wendland_c4" => Kernel::WendlandC4,
            "wendland_c6" => Kernel::WendlandC6,
            other => panic!("no kernel is called {other}"),
        };
        assert_eq!(block["support"].as_integer().unwrap() as f64, kernel.support(), "{kernel}");
        let dimension = block["dimension"].as_integer().unwrap() as usize;
        for row in block["values"].as_array().unwrap() {
            let number = |key: &str| row[key].as_str().unwrap().parse::<f64>().unwrap();
            let q = row["q"].as_float().unwrap();
            entries.push(Entry { kernel, dimension, q, value: number("w"), slope: number("dw") });
        }
    }
    entries
}

fn agrees_with_the_table<T: Float>() {
    let mut worst = 0.0_f64;
    let entries = table();
    assert_eq!(entries.len(), 18 * 30 + 3 * 3, "the table has every kernel in every dimension");
    for Entry { kernel, dimension, q, value, slope } in entries {
        let q_squared = T::lit(q) * T::lit(q);
        let got = shape(kernel, dimension, q_squared);
        let what = format!("{kernel} in {dimension}-D at q = {q}");
        // The slopes with respect to q^2 that the tolerance needs; just inside where the square root has no derivative.
        let around = shape(kernel, dimension, Dual::variable((q * q).max(1e-300)));
        let bound = tolerance::<T>(kernel, around.value, q * q);
        assert_close(&format!("w of {what}"), got.value.to_f64(), value, bound);
        worst = worst.max((got.value.to_f64() - value).abs() / bound);
        let bound = tolerance::<T>(kernel, around.slope_over_q, q * q) * q;
        assert_close(&format!("w' of {what}"), got.slope_over_q.to_f64() * q, slope, bound);
        if bound > 0.0 {
            worst = worst.max((got.slope_over_q.to_f64() * q - slope).abs() / bound);
        }
    }
    println!("worst error over tolerance: {worst}");
}

#[test]
fn values_and_slopes_agree_with_thirty_digits() {
    agrees_with_the_table::<f64>();
    agrees_with_the_table::<f32>();
}

/// `w(0)` and `lim w'/q` by hand: the second is never got by a division at `q = 0`.
#[test]
fn centre_has_its_value_and_curvature() {
    let b_4 = [0.752215012981181464, 0.580312175416713882, 0.458917516687635347];
    let b_9 = [1.10394401102938183, 1.23244006128305170, 1.39132214892178846];
    fn check<const D: usize>(kernel: Kernel, value: f64, curvature: f64) {
        let got = kernel_shape::<f64, D>(kernel, 0.0);
        let bound = gamma(budget(kernel).roundings, UNIT) * budget(kernel).cancellation;
        assert_close(&format!("w(0) of {kernel} in {D}-D"), got.value, value, bound * value);
        assert_close(&format!("w'/q at 0 of {kernel} in {D}-D"), got.slope_over_q, curvature, bound * curvature.abs());
        assert_eq!(central_value::<f64, D>(kernel), got.value);
    }
    fn all<const D: usize>(norms: [f64; 5], b_4: f64, b_9: f64) {
        // sinc^n near the centre is 1 - n pi^2 q^2 / 24.
        let sinc = (0.9 * b_4 + 0.1 * b_9, -(0.9 * b_4 * 4.0 + 0.1 * b_9 * 9.0) * PI * PI / 12.0);
        check::<D>(Kernel::MixedSinc, sinc.0, sinc.1);
        check::<D>(Kernel::CubicSpline, norms[0], -3.0 * norms[0]);
        check::<D>(Kernel::QuinticSpline, 66.0 * norms[1], -120.0 * norms[1]);
        let curvatures = if D == 1 { [-3.0, -3.5, -4.5] } else { [-5.0, -14.0 / 3.0, -5.5] };
        for (i, kernel) in [Kernel::WendlandC2, Kernel::WendlandC4, Kernel::WendlandC6].into_iter().enumerate() {
            check::<D>(kernel, norms[2 + i], curvatures[i] * norms[2 + i]);
        }
    }
    all::<1>([2.0 / 3.0, 1.0 / 120.0, 5.0 / 8.0, 3.0 / 4.0, 55.0 / 64.0], b_4[0], b_9[0]);
    all::<2>(
        [10.0 / (7.0 * PI), 7.0 / (478.0 * PI), 7.0 / (4.0 * PI), 9.0 / (4.0 * PI), 39.0 / (14.0 * PI)],
        b_4[1],
        b_9[1],
    );
    all::<3>(
        [1.0 / PI, 1.0 / (120.0 * PI), 21.0 / (16.0 * PI), 495.0 / (256.0 * PI), 1365.0 / (512.0 * PI)],
        b_4[2],
        b_9[2],
    );
}

#[test]
fn integrals_over_space_are_those_of_any_kernel() {
    fn check<const D: usize>(kernel: Kernel) {
        let at = |q: f64| kernel_shape::<f64, D>(kernel, q * q);
        let reach = kernel.support() as usize;
        // The kernel's own roundings, a few for nodes and weights, one a term for the sum.
        let bound = gamma(budget(kernel).roundings + 8 + reach * POINTS, UNIT) * budget(kernel).cancellation;
        let what = |name: &str| format!("integral of {name} for {kernel} in {D}-D");
        assert_close(&what("W"), over_space::<D>(reach, |q| at(q).value), 1.0, bound);
        let nu = D as f64;
        let outward = over_space::<D>(reach, |q| q * q * at(q).slope_over_q);
        assert_close(&what("r . grad W"), outward, -nu, nu * bound);
        let changing = over_space::<D>(reach, |q| smoothing_length_derivative::<f64, D>(at(q), q * q));
        // nu w and q w' have integrals nu and -nu.
        assert_close(&what("dW/dh"), changing, 0.0, 2.0 * nu * bound);
    }
    for_each_kernel!(check);
}

/// The second moment tells kernels apart that share everything else; figures from closed forms.
#[test]
fn second_moments_are_the_published_ones() {
    let figures = [
        (Kernel::MixedSinc, [0.247412956753052068, 0.235917542380367762, 0.225212243955294842]),
        (Kernel::CubicSpline, [1.0 / 3.0, 31.0 / 98.0, 0.3]),
        (Kernel::QuinticSpline, [0.5, 2771.0 / 5736.0, 7.0 / 15.0]),
        (Kernel::WendlandC2, [8.0 / 21.0, 5.0 / 18.0, 4.0 / 15.0]),
        (Kernel::WendlandC4, [4.0 / 15.0, 7.0 / 33.0, 8.0 / 39.0]),
        (Kernel::WendlandC6, [8.0 / 39.0, 6.0 / 35.0, 1.0 / 6.0]),
    ];
    for (kernel, [one, two, three]) in figures {
        fn moment<const D: usize>(kernel: Kernel, due: f64) {
            let reach = kernel.support() as usize;
            let got = over_space::<D>(reach, |q| q * q * kernel_shape::<f64, D>(kernel, q * q).value) / D as f64;
            let bound = gamma(budget(kernel).roundings + 8 + reach * POINTS, UNIT) * budget(kernel).cancellation;
            assert_close(&format!("second moment of {kernel} in {D}-D"), got, due, bound * due);
        }
        moment::<1>(kernel, one);
        moment::<2>(kernel, two);
        moment::<3>(kernel, three);
    }
}

#[test]
fn slope_is_the_derivative_of_the_value() {
    fn check<const D: usize>(kernel: Kernel) {
        for k in 1..400 {
            let q = kernel.support() * f64::from(k) / 400.0 + 1e-3;
            let shape = kernel_shape::<Dual, D>(kernel, Dual::variable(q * q));
            // w' = 2 q dw/d(q^2). The derivative of the splines is a sum of powers that cancel near the centre: 5 (81
            // + 96 + 15) = 960 at most, against 120 q. All others add terms of one sign.
            let terms = match kernel {
                Kernel::QuinticSpline => 960.0 * kernel_shape::<f64, D>(kernel, 0.0).value / 66.0,
                Kernel::CubicSpline => 6.0 * kernel_shape::<f64, D>(kernel, 0.0).value,
                _ => {
                    q * kernel_shape::<f64, D>(kernel, q * q).slope_over_q.abs()
                        + kernel_shape::<f64, D>(kernel, q * q).value
                }
            };
            // Twice the work of the value, on either side of the comparison.
            let bound = gamma(4 * budget(kernel).roundings, UNIT) * terms;
            let what = format!("w' of {kernel} in {D}-D at q = {q}");
            assert_close(&what, shape.slope_over_q.value * q, 2.0 * q * shape.value.slope, bound);
        }
    }
    for_each_kernel!(check);
}

#[test]
fn change_with_h_is_the_derivative_of_the_whole_kernel() {
    fn check<const D: usize>(kernel: Kernel) {
        let mut nonzero = 0;
        for k in 1..100 {
            let (h, r) = (0.7, 0.7 * kernel.support() * f64::from(k) / 90.0);
            let inverse = Dual::lit(1.0) / Dual::variable(h);
            let q_squared = Dual::lit(r * r) * inverse * inverse;
            let whole = kernel_shape::<Dual, D>(kernel, q_squared).value * inverse_volume::<Dual, D>(inverse);
            let shape = kernel_shape::<f64, D>(kernel, q_squared.value);
            let got = smoothing_length_derivative::<f64, D>(shape, q_squared.value) * h.powi(-(D as i32) - 1);
            let centre = kernel_shape::<f64, D>(kernel, 0.0).value;
            // The terms are nu w and q w'; those of the splines' slope are up to 15 w(0).
            let bound =
                gamma(4 * budget(kernel).roundings, UNIT) * (D as f64 + 15.0) * centre * h.powi(-(D as i32) - 1);
            assert_close(&format!("dW/dh of {kernel} in {D}-D at r = {r}"), got, whole.slope, bound);
            nonzero += usize::from(got.abs() > 100.0 * bound);
        }
        assert!(nonzero > 60, "{kernel}: only {nonzero} places say anything");
    }
    for_each_kernel!(check);
    // By hand: w = 3, w'/q = -5, q^2 = 2 in 3-D: -(9 - 10); in 1-D: -(3 - 10).
    let shape = Shape { value: 3.0, slope_over_q: -5.0 };
    assert_eq!(smoothing_length_derivative::<f64, 3>(shape, 2.0), 1.0);
    assert_eq!(smoothing_length_derivative::<f64, 1>(shape, 2.0), 7.0);
}

#[test]
fn nothing_is_left_outside_the_support() {
    fn outside<T: Float, const D: usize>(kernel: Kernel, largest: f64) {
        let edge = kernel.support() * kernel.support();
        for q_squared in [edge, edge * (1.0 + 2.0 * T::UNIT), edge * 1.01, 20.0, 1e4, 1e20, largest] {
            let Shape { value, slope_over_q } = kernel_shape::<T, D>(kernel, T::lit(q_squared));
            assert_eq!((value.to_f64(), slope_over_q.to_f64()), (0.0, 0.0), "{kernel} in {D}-D at q^2 = {q_squared:e}");
        }
    }
    fn check<const D: usize>(kernel: Kernel) {
        // Smoothing lengths that differ by more than 1e12 (f32) or 1e100 (f64) would overflow the q^3 of Wendland's C6.
        outside::<f64, D>(kernel, 1e200);
        outside::<f32, D>(kernel, 1e24);
    }
    for_each_kernel!(check);
}

#[test]
fn kernels_fall_from_the_centre_to_the_edge() {
    fn check<const D: usize>(kernel: Kernel) {
        let mut last = f64::INFINITY;
        for k in 0..500 {
            let q = kernel.support() * f64::from(k) / 500.0;
            let Shape { value, slope_over_q } = kernel_shape::<f64, D>(kernel, q * q);
            assert!(value < last && value > 0.0, "{kernel} in {D}-D at q = {q}: {value:e} after {last:e}");
            assert!(slope_over_q < 0.0, "{kernel} in {D}-D at q = {q}: w'/q = {slope_over_q:e}");
            last = value;
        }
    }
    for_each_kernel!(check);
}

/// Every `f32` around the edge and around the knots, and the smallest numbers there are: where a power of a sine would
/// be negative, an expanded polynomial noise, and a division 0/0.
#[test]
fn hard_distances_give_no_negative_weight_and_no_nan() {
    fn good<T: Float>(kernel: Kernel, dimension: usize, q_squared: T) {
        let Shape { value, slope_over_q } = shape(kernel, dimension, q_squared);
        let (value, slope) = (value.to_f64(), slope_over_q.to_f64());
        let good = value >= 0.0 && value.is_finite() && slope <= 0.0 && slope.is_finite();
        assert!(good, "{kernel} in {dimension}-D at q^2 = {:e}: {value:e}, {slope:e}", q_squared.to_f64());
    }
    for &kernel in Kernel::ALL {
        for dimension in 1..=3 {
            for place in [1.0_f32, 4.0, 9.0] {
                for bits in place.to_bits() - 2000..place.to_bits() + 2000 {
                    good(kernel, dimension, f32::from_bits(bits));
                }
            }
            for tiny in [f32::from_bits(1), f32::MIN_POSITIVE, 1e-30, 1e-20, 1e-12, 1e-7] {
                good(kernel, dimension, tiny);
            }
            for tiny in [f64::from_bits(1), f64::MIN_POSITIVE, 1e-200, 1e-100, 1e-30, 1e-16] {
                good(kernel, dimension, tiny);
                // Taken as zero: the slope cannot have changed by more than its rounding and q itself.
                let (near, centre) = (shape(kernel, dimension, tiny), shape(kernel, dimension, 0.0));
                let bound = 10.0 * (UNIT + tiny.sqrt()) * centre.slope_over_q.abs();
                assert_close("w'/q close to the centre", near.slope_over_q, centre.slope_over_q, bound);
            }
        }
    }
}

#[test]
fn sinc_is_the_sine_over_its_argument() {
    for k in 1..1000 {
        let t = f64::from(k) / 1000.0;
        let x = PI * t.sqrt();
        let (s, slope) = sinc_half_pi(t);
        // The library's sine near pi has the absolute error of its argument, 3u pi / x; the polynomial 10u of s.
        assert_close("sinc", s, x.sin() / x, 14.0 * UNIT);
        // d/dt = (cos x - sinc x) / (2t): numerator to 16u absolute.
        assert_close("d sinc / dt", slope, (x.cos() - x.sin() / x) / (2.0 * t), 12.0 * UNIT * 1.7 + 10.0 * UNIT / t);
    }
    let (at_centre, slope_there) = sinc_half_pi(0.0);
    assert_eq!(at_centre, 1.0);
    assert_close("slope at the centre", slope_there, -PI * PI / 6.0, 4.0 * UNIT);
    let (at_edge, slope_there) = sinc_half_pi(1.0);
    assert_eq!(at_edge, 0.0);
    // At t = 1 the slope is -p(1) = -1/2; Horner's rule loses at most 8u of it (see the budget).
    assert_close("slope at the edge", slope_there, -0.5, 4.0 * UNIT);
    assert_eq!(SINC.double[0], 1.0);
}

#[test]
fn inverse_volume_is_the_power_of_the_dimension() {
    assert_eq!(inverse_volume::<f64, 1>(4.0), 4.0);
    assert_eq!(inverse_volume::<f64, 2>(4.0), 16.0);
    assert_eq!(inverse_volume::<f64, 3>(4.0), 64.0);
}
