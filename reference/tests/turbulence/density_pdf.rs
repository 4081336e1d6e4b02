//! Distributions of the density over mass and over volume.

use crate::check::{UNIT, assert_close, gamma};
use etalon_reference::schemes::Weighting;
use etalon_reference::turbulence::Bins;
use etalon_reference::turbulence::density_pdf::density_pdf;
use std::f64::consts::PI;

/// Masses that are normally distributed in `ln rho`, about `centre` with variance `variance`: one particle on each of many evenly
/// spaced values, so that sums are integrals by the trapezoidal rule, which for a Gaussian cut at nine deviations is exact to rounding.
fn lognormal(centre: f64, variance: f64) -> (Vec<f64>, Vec<f64>) {
    let deviation = variance.sqrt();
    let s: Vec<f64> = (-1800..=1800).map(|i| centre + f64::from(i) * deviation / 200.0).collect();
    let mass = s.iter().map(|s| (-(s - centre).powi(2) / (2.0 * variance)).exp()).collect();
    (mass, s.iter().map(|s| s.exp()).collect())
}

/// Over mass the mean of `ln(rho / rho_0)` is half the variance, over volume minus half of it, whatever the unit of density.
#[test]
fn a_lognormal_density_is_normal_over_mass_and_over_volume() {
    for (centre, variance) in [(0.0, 0.04), (2.0, 0.25), (-1.0, 1.0)] {
        let (mass, density) = lognormal(centre, variance);
        let deviation = f64::sqrt(variance);
        let bins = Bins::linear(-5.0 * deviation, 5.0 * deviation, 50).unwrap();
        for (weighting, sign) in [(Weighting::Mass, 1.0), (Weighting::Volume, -1.0)] {
            let pdf = density_pdf(&mass, &density, weighting, &bins).unwrap();
            let what = |name: &str| format!("{name} over {weighting}, variance {variance}");
            // Sums of 3601 terms; logarithms carry u of up to 11.
            let bound = 4.0 * gamma(3700, UNIT);
            assert_close(&what("mean"), pdf.mean, sign * 0.5 * variance, bound);
            assert_close(&what("variance"), pdf.variance, variance, bound);
            assert_close(&what("skewness"), pdf.skewness, 0.0, 10.0 * bound / deviation);
            assert_close(&what("rho_0"), pdf.mean_density.ln(), centre - 0.5 * variance, bound);
            let whole: f64 = pdf.bins.iter().map(|(from, to, p)| (to - from) * p).sum();
            assert_close(&what("whole"), whole + pdf.outside, 1.0, bound);
            // A bin a fifth of a deviation wide holds 40 or so of the values: counting them is off by one in 40.
            for &(from, to, p) in &pdf.bins {
                let middle = 0.5 * (from + to);
                let due =
                    (-(middle - sign * 0.5 * variance).powi(2) / (2.0 * variance)).exp() / (2.0 * PI * variance).sqrt();
                // And the mean of a bin is not its middle: p'' w^2 / 24.
                let largest = 1.0 / (2.0 * PI * variance).sqrt();
                assert_close(&what(&format!("p({middle})")), p, due, 0.05 * due + 0.004 * largest);
                assert_close(&what("fit"), pdf.normal(middle).unwrap(), due, 1e-9 * largest);
            }
        }
    }
}

/// Two densities, 1 and 4, with masses 3 and 1: volumes 3 and 1/4, `rho_0` = 4 / 3.25.
#[test]
fn weights_by_hand() {
    let rho_0: f64 = 4.0 / 3.25;
    let bins = Bins::between(vec![-1.0, 0.0, 2.0]).unwrap();
    let over_mass = density_pdf(&[3.0, 1.0], &[1.0, 4.0], Weighting::Mass, &bins).unwrap();
    let over_volume = density_pdf(&[3.0, 1.0], &[1.0, 4.0], Weighting::Volume, &bins).unwrap();
    assert_close("rho_0", over_mass.mean_density, rho_0, 4.0 * UNIT);
    // Bins of widths 1 and 2.
    assert_eq!(over_mass.bins, [(-1.0, 0.0, 0.75), (0.0, 2.0, 0.125)]);
    for ((_, _, p), due) in over_volume.bins.iter().zip([3.0 / 3.25, 0.125 / 3.25]) {
        assert_close("p over volume", *p, due, 4.0 * UNIT);
    }
    let (low, high) = (-rho_0.ln(), 4_f64.ln() - rho_0.ln());
    assert_close("mean over mass", over_mass.mean, 0.75 * low + 0.25 * high, 8.0 * UNIT);
    assert_close("mean over volume", over_volume.mean, (3.0 * low + 0.25 * high) / 3.25, 8.0 * UNIT);
    // Three quarters low, one high: the tail is towards high densities.
    let variance = 0.1875 * (high - low).powi(2);
    assert_close("variance", over_mass.variance, variance, 20.0 * UNIT);
    assert_close("skewness", over_mass.skewness, 0.5 / 0.1875_f64.sqrt(), 40.0 * UNIT);
}

#[test]
fn uniform_gas_has_one_density() {
    let bins = Bins::linear(-0.5, 0.5, 3).unwrap();
    let pdf = density_pdf(&[2.0; 5], &[0.5; 5], Weighting::Volume, &bins).unwrap();
    assert_eq!((pdf.mean_density, pdf.mean, pdf.variance, pdf.skewness, pdf.outside), (0.5, 0.0, 0.0, 0.0, 0.0));
    assert_eq!(pdf.normal(0.0), None, "no variance, no normal distribution");
    let narrow = Bins::linear(0.1, 0.2, 1).unwrap();
    assert!(density_pdf(&[2.0], &[0.5], Weighting::Mass, &narrow).is_err());
}
