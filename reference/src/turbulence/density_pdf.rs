//! How density is distributed, over mass and over volume (C25 section 3.2).
//!
//! The variable is `s = ln(rho / rho_0)` with `rho_0` the total mass over the total volume. If `s` is normally distributed with variance `sigma^2`, its
//! mean is `sigma^2 / 2` over mass and `-sigma^2 / 2` over volume, for `p_M = (rho / rho_0) p_V`.

use super::bins::Bins;
use super::error::{TurbulenceError, check_column, check_length};
use crate::schemes::Weighting;
use crate::sum::CompensatedSum;
use etalon_kernels_gen::equation;
use std::f64::consts::PI;

/// A distribution of `s = ln(rho / rho_0)`.
#[derive(Clone, Debug, PartialEq)]
pub struct DensityPdf {
    /// What it is a distribution over.
    pub weighting: Weighting,
    /// Total mass over total volume, `rho_0`.
    pub mean_density: f64,
    /// Lower end, upper end and probability per unit of `s`, for every bin.
    pub bins: Vec<(f64, f64, f64)>,
    /// The share of the mass or volume that lies outside all bins.
    pub outside: f64,
    /// Mean of `s`, bins aside.
    pub mean: f64,
    /// Variance of `s`, bins aside.
    pub variance: f64,
    /// Skewness of `s`, zero for a normal distribution and negative where the tail is towards low densities; zero if all are equal.
    pub skewness: f64,
}

impl DensityPdf {
    /// The normal distribution with the same mean and variance, at `s`; `None` where the density does not vary.
    pub fn normal(&self, s: f64) -> Option<f64> {
        let squared = (s - self.mean).powi(2) / self.variance;
        (self.variance > 0.0).then(|| (-0.5 * squared).exp() / (2.0 * PI * self.variance).sqrt())
    }
}

/// The distribution of the density of particles of these masses.
///
/// # Errors
/// No particles, lists of different length, a mass or density that is not finite and positive, nothing inside the bins.
#[equation(unnumbered = "distribution of density over mass and volume, C25 section 3.2", host)]
pub fn density_pdf(
    mass: &[f64],
    density: &[f64],
    weighting: Weighting,
    bins: &Bins,
) -> Result<DensityPdf, TurbulenceError> {
    if mass.is_empty() {
        return Err(TurbulenceError::Empty { what: "particles", least: 1 });
    }
    check_length("list of densities", density.len(), mass.len())?;
    check_column("masses", mass, true)?;
    check_column("densities", density, true)?;
    let volumes: Vec<f64> = mass.iter().zip(density).map(|(m, rho)| m / rho).collect();
    let total = |weights: &[f64]| weights.iter().copied().collect::<CompensatedSum<f64>>().value();
    let mean_density = total(mass) / total(&volumes);
    let weights = match weighting {
        Weighting::Mass => mass,
        Weighting::Volume => &volumes,
    };
    let whole = total(weights);
    let s: Vec<f64> = density.iter().map(|rho| (rho / mean_density).ln()).collect();
    let moment = |of: &dyn Fn(f64) -> f64| weights.iter().zip(&s).map(|(w, &s)| w * of(s)).sum::<f64>() / whole;
    let mean = moment(&|s| s);
    let variance = moment(&|s| (s - mean).powi(2));
    let third = moment(&|s| (s - mean).powi(3));
    let skewness = if variance > 0.0 { third / variance.powf(1.5) } else { 0.0 };

    let mut shares = vec![CompensatedSum::<f64>::new(); bins.count()];
    let mut outside = CompensatedSum::new();
    for (&weight, &s) in weights.iter().zip(&s) {
        match bins.of(s) {
            Some(bin) => shares[bin].add(weight / whole),
            None => outside.add(weight / whole),
        }
    }
    if shares.iter().all(|share| share.value() == 0.0) {
        let (from, to) = bins.range();
        return Err(TurbulenceError::NothingInRange { entries: mass.len(), what: "densities", from, to });
    }
    let probability = |(bin, share): (usize, &CompensatedSum<f64>)| {
        let (from, to) = bins.ends(bin);
        (from, to, share.value() / (to - from))
    };
    Ok(DensityPdf {
        weighting,
        mean_density,
        bins: shares.iter().enumerate().map(probability).collect(),
        outside: outside.value(),
        mean,
        variance,
        skewness,
    })
}
