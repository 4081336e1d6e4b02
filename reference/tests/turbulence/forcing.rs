//! The driving force: its waves, its strength, its Helmholtz decomposition, its mean.

use crate::check::{UNIT, assert_close};
use crate::places::{cube, lattice, particles, scattered, weighed};
use etalon_reference::schemes::{ModeWeights, Profile};
use etalon_reference::turbulence::forcing::{Driving, ForceWave, Forcing, force_at, modes};
use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

fn forcing<const D: usize>(driving: Driving, seed: u64) -> Forcing<D> {
    Forcing::new(&cube::<D>(1.0), driving, seed).unwrap()
}

/// SPH-EXA's list, counted: 112 entries; of 61 waves 28 stand there once, 24 twice, 9 four times.
#[test]
fn waves_are_one_of_each_pair_and_the_published_list_repeats_some() {
    let modes = modes::<3>(Profile::Power);
    assert_eq!(modes.len(), 61);
    let mut times = BTreeMap::new();
    modes.iter().for_each(|mode| *times.entry(mode.multiplicity).or_insert(0) += 1);
    assert_eq!(times, BTreeMap::from([(1, 28), (2, 24), (4, 9)]));
    assert_eq!(modes.iter().map(|mode| mode.multiplicity).sum::<u32>(), 112);
    for mode in &modes {
        let squared: i32 = mode.wave_vector.iter().map(|n| n * n).sum();
        assert!((1..=9).contains(&squared), "{:?}", mode.wave_vector);
        assert!(!modes.iter().any(|other| other.wave_vector == mode.wave_vector.map(|n| -n)), "{:?}", mode.wave_vector);
        // The parabola ends at 1 and 3.
        assert_eq!(mode.amplitude == 0.0, squared == 1 || squared == 9, "{:?}", mode.wave_vector);
    }
    // Half of all vectors of whole numbers with 1 <= n^2 <= 9: 6 in 1-D, 28 in 2-D.
    assert_eq!((self::modes::<1>(Profile::Power).len(), self::modes::<2>(Profile::Power).len()), (3, 14));
}

/// `sigma = 0.009`, `T = 1/0.6` and a force of 0.2397 for Mach 0.3; even weights keep the strength, not the directions.
#[test]
fn strength_and_memory_are_the_published_ones() {
    let subsonic = Driving::subsonic();
    assert_close("T", subsonic.correlation_time(1.0), 1.0 / 0.6, 4.0 * UNIT);
    assert_close("sigma", subsonic.deviation(1.0), 0.009, 10.0 * UNIT * 0.009);
    let published = Driving { weights: ModeWeights::Published, ..subsonic };
    let rms = forcing::<3>(published, 1).expected_rms();
    assert_close("rms force", rms, 0.2397, 5e-5);
    assert_close("rms force, even", forcing::<3>(subsonic, 1).expected_rms(), rms, 200.0 * UNIT * rms);
    // v^2 / L: T goes with L / v, sigma with v^2 / L.
    let (fast, large) = (Driving { velocity: 0.6, ..subsonic }, 4.0);
    assert_close("T", fast.correlation_time(large), 4.0 / 1.2, 10.0 * UNIT);
    assert_close("sigma", fast.deviation(large), 0.009, 10.0 * UNIT * 0.009);
}

/// The mean square over the box, wave by wave and point by point on a lattice fine enough for squares of waves.
fn mean_square<const D: usize>(waves: &[ForceWave<D>]) -> f64 {
    waves.iter().map(|wave| 0.5 * (wave.real.norm_squared() + wave.imaginary.norm_squared())).sum()
}

#[test]
fn force_is_the_sum_of_its_waves() {
    let driving = Driving { solenoidal_weight: 0.3, ..Driving::subsonic() };
    let force = forcing::<3>(driving, 5);
    let waves = force.waves();
    let snapshot = particles(1.0, &scattered::<3>(50, 2), |_| [0.0; 3]);
    for particle in 0..snapshot.len() {
        let coordinates = snapshot.coordinates(particle);
        let x = coordinates.map(|x| x as f64 / 2_f64.powi(64));
        let mut due = [0.0; 3];
        let mut size = 0.0;
        for wave in &waves {
            let phase: f64 = (0..3).map(|i| TAU * f64::from(wave.wave_vector[i]) * x[i]).sum();
            for (axis, due) in due.iter_mut().enumerate() {
                *due += wave.real[axis] * phase.cos() - wave.imaginary[axis] * phase.sin();
            }
            size += wave.real.norm() + wave.imaginary.norm();
        }
        let got = force_at(&waves, coordinates);
        for (axis, due) in due.into_iter().enumerate() {
            // The phase here is up to 12 pi, with five roundings; the sum has 43 terms.
            assert_close("force", got[axis], due, (5.0 * 12.0 * PI + 60.0) * UNIT * size);
        }
    }
    // Eight points a side see waves of up to three, and their squares of up to six as a mean.
    let on_lattice = particles(1.0, &lattice::<3>(8), |_| [0.0; 3]);
    let drive = force.on(&on_lattice).unwrap();
    let squares: f64 = drive.acceleration.iter().flatten().map(|a| a * a).sum::<f64>() / 512.0;
    assert_close("mean square", squares, mean_square(&waves), 1e3 * UNIT * mean_square(&waves));
}

/// Central differences of the force in real space: a weight of one leaves no divergence, one of zero no curl.
#[test]
fn weight_decides_between_divergence_and_curl() {
    for (weight, solenoidal) in [(1.0, true), (0.0, false)] {
        let force = forcing::<3>(Driving { solenoidal_weight: weight, ..Driving::subsonic() }, 9);
        let waves = force.waves();
        for wave in &waves {
            let n = wave.wave_vector.map(f64::from);
            for part in [wave.real.0, wave.imaginary.0] {
                let size = 24.0 * UNIT * 3.0 * part.iter().map(|x| x * x).sum::<f64>().sqrt();
                let dot: f64 = (0..3).map(|i| n[i] * part[i]).sum();
                let cross = |i: usize| n[(i + 1) % 3] * part[(i + 2) % 3] - n[(i + 2) % 3] * part[(i + 1) % 3];
                if solenoidal {
                    assert_close("k . a", dot, 0.0, size);
                } else {
                    (0..3).for_each(|i| assert_close("k x a", cross(i), 0.0, size));
                }
            }
        }
        let step = 1_u64 << 51;
        let width = 2.0 * 2_f64.powi(51 - 64);
        let snapshot = particles(1.0, &scattered::<3>(20, 4), |_| [0.0; 3]);
        let (mut divergence, mut curl) = (0.0_f64, 0.0_f64);
        for particle in 0..snapshot.len() {
            let at = snapshot.coordinates(particle);
            let slope = |axis: usize| {
                let there = |shift: u64| {
                    let mut x = at;
                    x[axis] = x[axis].wrapping_add(shift);
                    force_at(&waves, x)
                };
                (there(step) - there(step.wrapping_neg())).scale(1.0 / width)
            };
            let j: [_; 3] = std::array::from_fn(slope);
            divergence = divergence.max((j[0][0] + j[1][1] + j[2][2]).abs());
            curl = curl.max((j[1][2] - j[2][1]).abs()).max((j[2][0] - j[0][2]).abs()).max((j[0][1] - j[1][0]).abs());
        }
        // Second-order differences are off by (2 pi n dx)^2 / 6 relative, 1e-6 here; the gradient is about 4 pi times
        // the force of 0.24.
        let (none, some) = if solenoidal { (divergence, curl) } else { (curl, divergence) };
        let tolerance = 1e-6 * TAU * 3.0 * 0.24 * 10.0;
        assert!(none < tolerance, "weight {weight}: {none:e}, tolerance {tolerance:e}");
        assert!(some > 1e4 * tolerance, "weight {weight}: the other part, {some:e}, is not there either");
    }
}

/// No wave has a mean: on a lattice there is none to rounding. Elsewhere the particles sample one, which is taken away.
#[test]
fn force_has_no_mean() {
    let force = forcing::<3>(Driving::subsonic(), 11);
    let size: f64 = force.waves().iter().map(|wave| wave.real.norm() + wave.imaginary.norm()).sum();
    let even = force.on(&particles(1.0, &lattice::<3>(8), |_| [0.0; 3])).unwrap();
    for mean in even.mean {
        assert_close("mean on a lattice", mean, 0.0, (512.0 + 60.0) * UNIT * size);
    }
    let masses: Vec<f64> = (0..200).map(|i| 1.0 + f64::from(i % 7)).collect();
    let cloud = weighed(1.0, &scattered::<3>(200, 6), |_| [0.0; 3], masses.clone());
    let drive = force.on(&cloud).unwrap();
    let whole: f64 = masses.iter().sum();
    let mut sampled = 0.0_f64;
    for axis in 0..3 {
        let total: f64 = drive.acceleration[axis].iter().zip(&masses).map(|(a, m)| a * m).sum();
        assert_close("total force", total, 0.0, 2.0 * 210.0 * UNIT * size * whole);
        let raw = |i: usize| force_at(&force.waves(), cloud.coordinates(i))[axis];
        for (i, a) in drive.acceleration[axis].iter().enumerate() {
            // Together, cosine and sine are products of one for each axis: three phases of up to pi with three roundings each on either side, two
            // products of two terms; then both add up 43 waves.
            assert_close(
                "force and mean",
                a + drive.mean[axis],
                raw(i),
                (2.0 * 3.0 * 10.0 + 10.0 + 90.0) * UNIT * size,
            );
        }
        sampled = sampled.max(drive.mean[axis].abs());
    }
    assert!(sampled > 1e-3, "this cloud samples no mean ({sampled:e}): the test would not notice it");
}

/// In a fixed-point box a shift by the box is no shift, and the phase is exact far from the origin.
#[test]
fn force_is_periodic() {
    let waves = forcing::<2>(Driving::subsonic(), 13).waves();
    let at = |x: f64, y: f64| {
        let far = etalon_reference::domain::Domain::<2>::new([1e6; 2], [1e6 + 1.0; 2], [true; 2]).unwrap();
        force_at(&waves, [far.encode(0, 1e6 + x), far.encode(1, 1e6 + y)])
    };
    let near = |x: f64, y: f64| force_at(&waves, [cube::<2>(1.0).encode(0, x), cube::<2>(1.0).encode(1, y)]);
    assert_eq!(at(0.25, 0.625), near(0.25, 0.625));
    assert_eq!(at(1.0, 0.5), at(0.0, 0.5));
    // The real part at the origin, by hand.
    let due = waves.iter().fold([0.0; 2], |sum, wave| [sum[0] + wave.real[0], sum[1] + wave.real[1]]);
    assert_eq!(near(0.0, 0.0).0, due);
}

#[test]
fn the_same_seed_is_the_same_force() {
    let run = |seed: u64| {
        let mut force = forcing::<3>(Driving::subsonic(), seed);
        (0..3).for_each(|_| force.advance(0.01).unwrap());
        force.waves()
    };
    assert_eq!(run(1), run(1));
    assert_ne!(run(1), run(2));
    let mut still = forcing::<3>(Driving::subsonic(), 1);
    let before = still.waves();
    still.advance(0.0).unwrap();
    assert_eq!(still.waves(), before, "no time, no change");
}
