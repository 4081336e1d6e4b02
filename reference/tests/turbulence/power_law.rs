//! Slopes.

use crate::check::{UNIT, assert_close};
use etalon_reference::turbulence::power_law::fit_power_law;

#[test]
fn a_power_law_is_found_as_it_is() {
    for (exponent, amplitude) in [(-5.0 / 3.0, 0.3), (1.0 / 3.0, 7.0), (0.0, 2.0), (4.0, 1e-3)] {
        let x: Vec<f64> = (1..=40).map(f64::from).collect();
        let y: Vec<f64> = x.iter().map(|x| amplitude * x.powf(exponent)).collect();
        let fit = fit_power_law(&x, &y, (2.0, 30.0)).unwrap();
        assert_eq!(fit.points, 29, "both ends of the range count");
        // Logarithms of up to ln 40 exponent and of rounded powers: a few u each, the slope a mean of such.
        let bound = 20.0 * UNIT * (1.0 + exponent.abs()) * 4.0;
        assert_close("exponent", fit.exponent, exponent, bound);
        assert_close("amplitude", fit.amplitude, amplitude, 4.0 * bound * amplitude);
        assert_close("error of the exponent", fit.exponent_error, 0.0, bound);
    }
}

/// By hand, in powers of e: points (0, 0), (1, 1), (2, 3): slope 3/2, intercept -1/6, residuals 1/6, -1/3, 1/6.
#[test]
fn scattered_points_have_the_line_of_least_squares() {
    let x = [1.0, 1_f64.exp(), 2_f64.exp()];
    let y = [1.0, 1_f64.exp(), 3_f64.exp()];
    let fit = fit_power_law(&x, &y, (0.0, 100.0)).unwrap();
    assert_close("exponent", fit.exponent, 1.5, 20.0 * UNIT);
    assert_close("amplitude", fit.amplitude, (-1.0_f64 / 6.0).exp(), 20.0 * UNIT);
    // Residual square sum 1/6 over one degree of freedom, over a spread of 2.
    assert_close("error", fit.exponent_error, (1.0_f64 / 12.0).sqrt(), 20.0 * UNIT);
}

#[test]
fn two_points_have_a_line_without_an_error() {
    let fit = fit_power_law(&[1.0, 4.0], &[3.0, 6.0], (1.0, 4.0)).unwrap();
    assert_close("exponent", fit.exponent, 0.5, 8.0 * UNIT);
    assert_eq!((fit.exponent_error, fit.points), (0.0, 2));
}
