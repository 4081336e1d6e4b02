//! Slopes: how steeply one quantity falls with another.

use super::error::{TurbulenceError, check_column, check_length};
use crate::sum::CompensatedSum;
use etalon_kernels_gen::equation;

/// `y = amplitude x^exponent`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PowerLaw {
    /// The slope in a plot of logarithms.
    pub exponent: f64,
    /// `y` at `x = 1`.
    pub amplitude: f64,
    /// The standard error of the exponent if the logarithms scatter independently about the line; zero for two points.
    pub exponent_error: f64,
    /// How many points were used.
    pub points: usize,
}

/// The power law through points `x` from `range.0` to `range.1`, both included, by least squares in logarithms, each point weighing the same.
///
/// # Errors
/// Lists of different length; in the range a number that is not positive and finite, fewer than two points, or all at one `x`.
#[equation(unnumbered = "slope of a power law, C25 section 3", host)]
pub fn fit_power_law(x: &[f64], y: &[f64], range: (f64, f64)) -> Result<PowerLaw, TurbulenceError> {
    check_length("list of values", y.len(), x.len())?;
    check_column("abscissae", x, false)?;
    let entries = x.len();
    let chosen: Vec<usize> = (0..entries).filter(|&i| range.0 <= x[i] && x[i] <= range.1).collect();
    let pick = |list: &[f64]| chosen.iter().map(|&i| list[i]).collect::<Vec<f64>>();
    let (x, y) = (pick(x), pick(y));
    if x.is_empty() {
        return Err(TurbulenceError::NothingInRange { entries, what: "points", from: range.0, to: range.1 });
    }
    check_column("abscissae in the range", &x, true)?;
    check_column("values in the range", &y, true)?;
    let n = x.len() as f64;
    let (x, y): (Vec<f64>, Vec<f64>) = x.iter().zip(&y).map(|(x, y)| (x.ln(), y.ln())).unzip();
    let mean = |list: &[f64]| list.iter().sum::<f64>() / n;
    let (x_mean, y_mean) = (mean(&x), mean(&y));
    let spread: CompensatedSum<f64> = x.iter().map(|x| (x - x_mean).powi(2)).collect();
    if spread.value() == 0.0 {
        return Err(TurbulenceError::OnePlace { place: x_mean.exp() });
    }
    let together: f64 = x.iter().zip(&y).map(|(x, y)| (x - x_mean) * (y - y_mean)).sum();
    let exponent = together / spread.value();
    let residual: f64 = x.iter().zip(&y).map(|(x, y)| (y - y_mean - exponent * (x - x_mean)).powi(2)).sum();
    let freedom = x.len() - 2;
    let variance = if freedom == 0 { 0.0 } else { residual / freedom as f64 };
    Ok(PowerLaw {
        exponent,
        amplitude: (y_mean - exponent * x_mean).exp(),
        exponent_error: (variance / spread.value()).sqrt(),
        points: x.len(),
    })
}
