//! The power spectrum of a velocity field, and what is read off it (C25 section 3, GS25 section 4).
//!
//! Wave numbers count waves along a side of the box: `k` stands for `2 pi k / L`. A wave vector of whole numbers belongs to the shell of the
//! nearest whole number, `k - 1/2 <= |k'| < k + 1/2`. There are no ties: `(k + 1/2)^2 = k^2 + k + 1/4` is no whole number, and `|k'|^2` is one, so shells are
//! told apart in integers.
//!
//! On an even grid `n/2` and `-n/2` are the same wave. It counts once, in the shell of its length. From there on shells are cut by the
//! corners of the grid: they belong into the sum, which is the whole energy, but not into a plot. See [`Spectrum::resolved`].

use super::error::{TurbulenceError, check_column};
use super::grid::VelocityGrid;
use crate::sum::CompensatedSum;
use etalon_kernels_gen::equation;
use rustfft::FftPlanner;
use rustfft::num_complex::Complex;
use std::f64::consts::PI;

/// Fewer points a side leave no shell between the mean and Nyquist's wave.
const LEAST_ACROSS: usize = 4;

/// The waves of about one length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shell {
    /// The wave number.
    pub wave_number: usize,
    /// Their energy per mass, half the squared velocity, `E(k)`.
    pub energy: f64,
    /// How many wave vectors the shell has.
    pub modes: u64,
}

/// Energy by wave number, from 0 (the mean flow) on.
#[derive(Clone, Debug, PartialEq)]
pub struct Spectrum {
    dimension: usize,
    across: usize,
    shells: Vec<Shell>,
}

/// `E(k) = sum over the shell of |v_hat|^2 / 2`, with `v_hat = FFT(v) / n^D`. All shells together have `<v^2> / 2`.
///
/// # Errors
/// A grid of fewer than four points a side.
#[equation(unnumbered = "power spectrum of the velocity, C25 section 3, GS25 section 4", host)]
pub fn velocity_spectrum<const D: usize>(grid: &VelocityGrid<D>) -> Result<Spectrum, TurbulenceError> {
    let across = grid.across();
    if across < LEAST_ACROSS {
        return Err(TurbulenceError::GridTooSmall { across, least: LEAST_ACROSS });
    }
    let farthest = D as u64 * (across as u64 / 2).pow(2);
    let mut sums = vec![(CompensatedSum::<f64>::new(), 0); shell_of(farthest) + 1];
    for axis in 0..D {
        for (point, amplitude) in transformed::<D>(grid.component(axis), across).into_iter().enumerate() {
            let squared = (0..D).map(|axis| wave_number(point / across.pow(axis as u32) % across, across).pow(2)).sum();
            let sum = &mut sums[shell_of(squared)];
            sum.0.add(0.5 * amplitude.norm_sqr());
            sum.1 += u64::from(axis == 0);
        }
    }
    let shell = |(wave_number, (energy, modes)): (usize, (CompensatedSum<f64>, u64))| Shell {
        wave_number,
        energy: energy.value(),
        modes,
    };
    Ok(Spectrum { dimension: D, across, shells: sums.into_iter().enumerate().map(shell).collect() })
}

impl Spectrum {
    /// Every shell.
    pub fn shells(&self) -> &[Shell] {
        &self.shells
    }
    /// The shells that the grid holds whole: `1 <= k < n/2`.
    pub fn resolved(&self) -> &[Shell] {
        &self.shells[1..self.across.div_ceil(2)]
    }
    /// The energy of all shells, `<v^2> / 2`.
    pub fn total(&self) -> f64 {
        self.shells.iter().map(|shell| shell.energy).collect::<CompensatedSum<f64>>().value()
    }

    /// The resolved shells in the other reading in use: the mean over a shell's waves times the surface of the shell, `4 pi k^2` in 3-D.
    ///
    /// It differs from the sum as the number of wave vectors differs from the surface (by 43 % at `k = 1`), and its shells do not add up to
    /// the energy.
    pub fn shell_averages(&self) -> Vec<f64> {
        let surface = |k: f64| match self.dimension {
            1 => 2.0,
            2 => 2.0 * PI * k,
            _ => 4.0 * PI * k * k,
        };
        let average = |shell: &Shell| shell.energy / shell.modes as f64 * surface(shell.wave_number as f64);
        self.resolved().iter().map(average).collect()
    }

    /// Wave number and `k^exponent E(k)` of the resolved shells; 5/3 makes an inertial range flat.
    pub fn compensated(&self, exponent: f64) -> Vec<(f64, f64)> {
        let entry = |shell: &Shell| {
            let k = shell.wave_number as f64;
            (k, k.powf(exponent) * shell.energy)
        };
        self.resolved().iter().map(entry).collect()
    }

    /// Where `k^(5/3) E(k)` is largest between two wave numbers, both included: the bottleneck, `k_max` of GS25 Table 6.
    ///
    /// Begin above the driven waves: their peak may be the higher one. The papers' values are not whole; how they were read is
    /// not said, so [`Bottleneck::refined`] is our reading.
    ///
    /// # Errors
    /// No resolved shell in the range, or no energy in one of its shells.
    pub fn bottleneck(&self, range: (usize, usize)) -> Result<Bottleneck, TurbulenceError> {
        let inside = |&(k, _): &(f64, f64)| range.0 as f64 <= k && k <= range.1 as f64;
        let points: Vec<(f64, f64)> = self.compensated(5.0 / 3.0).into_iter().filter(inside).collect();
        check_column("compensated spectrum", &points.iter().map(|p| p.1).collect::<Vec<_>>(), true)?;
        let Some(at) = (0..points.len()).reduce(|best, i| if points[i].1 > points[best].1 { i } else { best }) else {
            let (from, to) = (range.0 as f64, range.1 as f64);
            return Err(TurbulenceError::NothingInRange { entries: self.resolved().len(), what: "shells", from, to });
        };
        let refined = match at {
            0 => None,
            _ => points.get(at + 1).map(|&after| top_of_parabola(points[at - 1], points[at], after)),
        };
        Ok(Bottleneck { shell: points[at].0 as usize, refined })
    }
}

/// The highest point of a compensated spectrum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bottleneck {
    /// The shell.
    pub shell: usize,
    /// The top of the parabola through it and its two neighbours, in logarithms; `None` at an end of the range, where the spectrum may well
    /// rise on.
    pub refined: Option<f64>,
}

/// Where the parabola through the logarithms of three points has its top; the middle one is the highest.
fn top_of_parabola(before: (f64, f64), top: (f64, f64), after: (f64, f64)) -> f64 {
    let point = |p: (f64, f64)| (p.0.ln(), p.1.ln());
    let ((x_0, y_0), (x_1, y_1), (x_2, y_2)) = (point(before), point(top), point(after));
    // Slopes of the two chords, at their middles; the top is where the slope has come down to zero.
    let (rise, fall) = ((y_1 - y_0) / (x_1 - x_0), (y_2 - y_1) / (x_2 - x_1));
    let (m_0, m_1) = (0.5 * (x_0 + x_1), 0.5 * (x_1 + x_2));
    if rise > fall { (m_0 + (m_1 - m_0) * rise / (rise - fall)).exp() } else { top.0 }
}

/// The whole number nearest to the root.
fn shell_of(squared: u64) -> usize {
    let below = squared.isqrt();
    (below + u64::from(squared > below * below + below)) as usize
}

/// The shorter of the two ways round.
fn wave_number(i: usize, across: usize) -> u64 {
    i.min(across - i) as u64
}

/// The amplitudes of all waves: a transform along each axis in turn, divided by the number of points.
fn transformed<const D: usize>(values: &[f64], across: usize) -> Vec<Complex<f64>> {
    let transform = FftPlanner::new().plan_fft_forward(across);
    let scale = 1.0 / values.len() as f64;
    let mut all: Vec<Complex<f64>> = values.iter().map(|&v| Complex::new(v * scale, 0.0)).collect();
    let mut line = vec![Complex::default(); across];
    let mut scratch = vec![Complex::default(); transform.get_inplace_scratch_len()];
    for axis in 0..D {
        let stride = across.pow(axis as u32);
        for first in (0..all.len()).filter(|i| (i / stride).is_multiple_of(across)) {
            (0..across).for_each(|i| line[i] = all[first + i * stride]);
            transform.process_with_scratch(&mut line, &mut scratch);
            (0..across).for_each(|i| all[first + i * stride] = line[i]);
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::shell_of;

    /// The nearest whole number, and none is ever half-way.
    #[test]
    fn shells_have_no_ties() {
        for squared in 0..20_000_u64 {
            let k = shell_of(squared) as u64;
            // 2 |k'| lies strictly between 2k - 1 and 2k + 1.
            assert!(k == 0 || (2 * k - 1).pow(2) < 4 * squared, "{squared}");
            assert!(4 * squared < (2 * k + 1).pow(2), "{squared}");
        }
    }
}
