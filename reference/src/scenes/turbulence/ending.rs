//! What the end of a stirred run is measured for: its spectrum, how velocities differ over a length, how density is distributed (C25 section 3,
//! appendix C; GS25 section 4).

use super::super::{AtEnd, Axis, Curve, Expected, SceneError, State};
use super::{GAMMA_MINUS_ONE, SIDE};
use crate::domain::Domain;
use crate::equations::equation_of_state::sound_speed;
use crate::schemes::{MachReading, Weighting};
use crate::turbulence::density_pdf::density_pdf;
use crate::turbulence::grid::VelocityGrid;
use crate::turbulence::power_law::fit_power_law;
use crate::turbulence::spectrum::{Bottleneck, Shell, Spectrum, velocity_spectrum};
use crate::turbulence::structure_function::{PairChoice, mach_numbers, structure_function};
use crate::turbulence::{Bins, Snapshot, TurbulenceError};

/// The wave numbers over which slopes are taken, both included: the first that nothing stirs, and one below the bottleneck that GS25 Table 6 has for all schemes
/// but the plain one. The papers do not give theirs.
pub const CASCADE: (f64, f64) = (4.0, 10.0);
/// What `E(k)` is multiplied with a power of (C25 section 3): Kolmogorov's.
pub const KOLMOGOROV: f64 = 5.0 / 3.0;
/// The power of the length that goes with it (C25 appendix C).
pub const MACH_POWER: f64 = 1.0 / 3.0;
/// Pairs that are looked at where there are more.
const PAIRS: usize = 2_000_000;
/// Lengths with fewer pairs are left out: their mean square would be uncertain by more than a seventh.
const LEAST_PAIRS: u64 = 100;
/// Lengths between one and its double.
const PER_OCTAVE: i32 = 4;
/// How far from its mean a distribution is drawn, in standard deviations, and in how many intervals.
const DRAWN: (f64, usize) = (5.0, 40);

/// Shells with less of the whole energy hold what rounding has left: 1e-12 in velocities.
const ROUNDING: f64 = 1e-24;

/// A value, or why there is none.
type Found = Result<f64, String>;

/// `k_max`, the slope of the spectrum, the slope of the Mach number, in this order; and the curves they are read off, with the densities'.
///
/// # Errors
/// A state that is not finite.
pub fn at_end<const D: usize>(state: &State, seed: u64) -> Result<AtEnd, SceneError> {
    let snapshot = snapshot::<D>(state)?;
    let across = (state.len() as f64).powf(1.0 / D as f64).round() as usize;
    let spectrum = VelocityGrid::nearest(&snapshot, across).and_then(|grid| velocity_spectrum(&grid));
    let scales = mach_by_length(&snapshot, state, across, seed);
    let lengths = (SIDE / CASCADE.1, SIDE / CASCADE.0);
    let known = spectrum.as_ref().map_err(ToString::to_string);
    let values = vec![
        known.clone().and_then(bottleneck),
        resolved(across).and(known).and_then(|spectrum| {
            stirred(spectrum, CASCADE.1 as usize)?;
            slope(&spectrum.compensated(0.0), CASCADE)
        }),
        scales.as_ref().map_err(ToString::to_string).and_then(|points| slope(points, lengths)),
    ];
    let flat = |points: &[(f64, f64)]| line(points, 0.0, CASCADE, "k^(-5/3), Kolmogorov");
    let rising = |points: &[(f64, f64)]| line(points, MACH_POWER, lengths, "l^(1/3), Kolmogorov; C25 appendix C");
    let energy = Axis { name: "compensated_energy", label: "k^(5/3) E(k)", unit: "L^2 T^-2", logarithmic: true };
    let wave = Axis { name: "wave_number", label: "waves a side, k", unit: "", logarithmic: true };
    let length = Axis { name: "length", label: "length l", unit: "L", logarithmic: true };
    let mach = Axis { name: "mach_number", label: "Mach number M(l)", unit: "", logarithmic: true };
    let mut curves = Vec::new();
    if let Ok(spectrum) = &spectrum {
        let all = spectrum.compensated(KOLMOGOROV).into_iter().zip(spectrum.resolved());
        let points: Vec<(f64, f64)> =
            all.filter(|(_, shell)| beyond_rounding(spectrum, shell)).map(|(point, _)| point).collect();
        let expected = (D == 3).then(|| flat(&points)).flatten();
        let label = "spectrum of the velocity, times k^(5/3)";
        curves.push(Curve { name: "compensated_spectrum", label, x: wave, y: energy, points, expected });
    }
    if let Ok(points) = scales {
        let points: Vec<(f64, f64)> = points.into_iter().filter(|point| point.1 > 0.0).collect();
        let expected = (D == 3).then(|| rising(&points)).flatten();
        curves.push(Curve {
            name: "mach_by_length",
            label: "Mach number of a length",
            x: length,
            y: mach,
            points,
            expected,
        });
    }
    curves.extend([Weighting::Mass, Weighting::Volume].into_iter().filter_map(|weighting| density(state, weighting)));
    // A curve of one point shows nothing.
    curves.retain(|curve| curve.points.len() > 1);
    Ok(AtEnd { values, curves })
}

fn snapshot<const D: usize>(state: &State) -> Result<Snapshot<D>, SceneError> {
    let domain = Domain::new([0.0; D], [SIDE; D], [true; D])?;
    let encode = |axis: usize| state.position[axis].iter().map(|&x| domain.encode(axis, x)).collect();
    let velocity = std::array::from_fn(|axis| state.velocity[axis].clone());
    Ok(Snapshot::new(domain, std::array::from_fn(encode), velocity, state.mass.clone())?)
}

fn beyond_rounding(spectrum: &Spectrum, shell: &Shell) -> bool {
    shell.energy > ROUNDING * spectrum.total()
}

/// Whether the cascade has reached all waves up to this one.
fn stirred(spectrum: &Spectrum, to: usize) -> Result<(), String> {
    let within = |shell: &&Shell| (CASCADE.0 as usize..=to).contains(&shell.wave_number);
    match spectrum.resolved().iter().filter(within).find(|shell| !beyond_rounding(spectrum, shell)) {
        None => Ok(()),
        Some(shell) => {
            let k = shell.wave_number;
            Err(format!("the waves of k = {k} have no more energy than rounding leaves: run for longer"))
        }
    }
}

/// Where the compensated spectrum is highest, if it is not at an end of what is looked at.
fn bottleneck(spectrum: &Spectrum) -> Found {
    let (from, to) = (CASCADE.0 as usize, spectrum.resolved().last().map_or(0, |shell| shell.wave_number));
    stirred(spectrum, to)?;
    match spectrum.bottleneck((from, to)) {
        Ok(Bottleneck { refined: Some(top), .. }) => Ok(top),
        Ok(Bottleneck { shell, refined: None }) => Err(format!(
            "the compensated spectrum is highest at k = {shell}, an end of the range from {from} to {to} that is looked at: no bottleneck is resolved; \
             take more particles"
        )),
        Err(error) => Err(error.to_string()),
    }
}

/// Whether a grid holds all waves that slopes are taken over.
fn resolved(across: usize) -> Result<(), String> {
    let least = 2 * CASCADE.1 as usize + 1;
    match across >= least {
        true => Ok(()),
        false => Err(format!(
            "a grid of {across} points a side, one a particle, does not hold the waves from k = {} to {}; take {least} particles a side or more",
            CASCADE.0, CASCADE.1
        )),
    }
}

fn slope(points: &[(f64, f64)], range: (f64, f64)) -> Found {
    let (x, y): (Vec<f64>, Vec<f64>) = points.iter().copied().unzip();
    fit_power_law(&x, &y, range).map(|law| law.exponent).map_err(|error| error.to_string())
}

/// Length and Mach number (C25 33) from a spacing to half the box.
fn mach_by_length<const D: usize>(
    snapshot: &Snapshot<D>,
    state: &State,
    across: usize,
    seed: u64,
) -> Result<Vec<(f64, f64)>, TurbulenceError> {
    let octaves = (0.5 * across as f64).log2().max(1.0);
    let count = (octaves * f64::from(PER_OCTAVE)).ceil();
    let half = 0.5 * SIDE;
    let bins = Bins::logarithmic(half * (-count / f64::from(PER_OCTAVE)).exp2(), half, count as usize)?;
    let n = snapshot.len();
    let pairs = match n * (n - 1) / 2 <= PAIRS {
        true => PairChoice::All,
        false => PairChoice::Random { count: PAIRS, seed },
    };
    let mut scales = structure_function(snapshot, &bins, pairs)?;
    scales.retain(|scale| scale.pairs >= LEAST_PAIRS);
    let mass: f64 = state.mass.iter().sum();
    let numbers =
        mach_numbers(&scales, sound_speed(GAMMA_MINUS_ONE, state.thermal_energy() / mass), MachReading::Halved)?;
    Ok(scales.iter().map(|scale| scale.distance).zip(numbers).collect())
}

/// The line of this power through the middle of the points of a range, in logarithms; none if there are none.
fn line(points: &[(f64, f64)], power: f64, range: (f64, f64), source: &'static str) -> Option<Expected> {
    let inside: Vec<f64> = points
        .iter()
        .filter(|(x, y)| range.0 <= *x && *x <= range.1 && *y > 0.0)
        .map(|(x, y)| y.ln() - power * x.ln())
        .collect();
    let level = (inside.iter().sum::<f64>() / inside.len() as f64).exp();
    let at = |x: f64| (x, level * x.powf(power));
    (!inside.is_empty()).then(|| Expected { source, points: vec![at(range.0), at(range.1)] })
}

/// The distribution of `ln(rho / rho_0)`, without empty intervals, beside the normal one of the same mean and variance; none where all are equal.
fn density(state: &State, weighting: Weighting) -> Option<Curve> {
    let of = |bins: &Bins| density_pdf(&state.mass, &state.density, weighting, bins).ok();
    // One interval that holds all: mean and variance do not depend on it.
    let whole = of(&Bins::linear(-700.0, 700.0, 1).ok()?)?;
    let (reach, count) = (DRAWN.0 * whole.variance.sqrt(), DRAWN.1);
    let pdf = of(&Bins::linear(whole.mean - reach, whole.mean + reach, count).ok()?)?;
    let middles: Vec<(f64, f64)> = pdf.bins.iter().map(|(from, to, p)| (0.5 * (from + to), *p)).collect();
    let points: Vec<(f64, f64)> = middles.iter().copied().filter(|(_, p)| *p > 0.0).collect();
    let least = points.iter().map(|(_, p)| *p).fold(f64::INFINITY, f64::min);
    let normal = middles.iter().filter_map(|&(s, _)| Some((s, pdf.normal(s)?))).filter(|(_, p)| *p >= least).collect();
    let (name, label, y) = match weighting {
        Weighting::Mass => ("density_pdf_mass", "distribution of the density over mass", "p_M"),
        Weighting::Volume => ("density_pdf_volume", "distribution of the density over volume", "p_V"),
    };
    let expected = Expected { source: "normal, of the same mean and variance; C25 Fig. 4", points: normal };
    Some(Curve {
        name,
        label,
        x: Axis { name: "log_density", label: "ln(ρ/ρ₀)", unit: "", logarithmic: false },
        y: Axis { name: "probability", label: y, unit: "", logarithmic: true },
        points,
        expected: Some(expected),
    })
}
