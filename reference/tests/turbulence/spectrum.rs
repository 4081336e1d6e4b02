//! The power spectrum.

use crate::check::{UNIT, assert_close, gamma};
use etalon_reference::turbulence::grid::VelocityGrid;
use etalon_reference::turbulence::power_law::fit_power_law;
use etalon_reference::turbulence::spectrum::{Spectrum, velocity_spectrum};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use std::f64::consts::{PI, TAU};

/// A field on a grid, from a function of the whole-numbered place.
fn field<const D: usize>(across: usize, velocity: impl Fn([usize; D]) -> [f64; D]) -> VelocityGrid<D> {
    let place = |i: usize| std::array::from_fn(|axis| i / across.pow(axis as u32) % across);
    let points: Vec<[f64; D]> = (0..across.pow(D as u32)).map(|i| velocity(place(i))).collect();
    VelocityGrid::from_components(across, std::array::from_fn(|axis| points.iter().map(|v| v[axis]).collect())).unwrap()
}

fn random_field<const D: usize>(across: usize, seed: u64) -> VelocityGrid<D> {
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    let values = (0..D).map(|_| (0..across.pow(D as u32)).map(|_| 2.0 * random.random::<f64>() - 0.7).collect());
    let components: Vec<Vec<f64>> = values.collect();
    VelocityGrid::from_components(across, components.try_into().unwrap()).unwrap()
}

/// A transform loses a few u per level, in the norm of the whole.
fn transform_error(across: usize) -> f64 {
    20.0 * (across as f64).log2() * 3.0 * UNIT
}

/// One wave of amplitude A has the energy A^2 / 4, in its own shell and nowhere else; components add; the mean is shell 0.
#[test]
fn a_wave_has_its_energy_in_its_shell() {
    let across = 16;
    let phase = |n: [usize; 3], k: [f64; 3]| TAU * (0..3).map(|i| k[i] * n[i] as f64).sum::<f64>() / across as f64;
    // |(1, 2, -2)| = 3, |(0, 4, 3)| = 5, |(1, 1, 1)| = 1.73: shell 2.
    let grid = field::<3>(across, |n| {
        [
            2.0 * phase(n, [1.0, 2.0, -2.0]).cos() + 0.5,
            3.0 * (phase(n, [0.0, 4.0, 3.0]) + 0.3).sin(),
            1.0 * phase(n, [1.0, 1.0, 1.0]).sin() + 4.0 * phase(n, [0.0, 4.0, 3.0]).cos(),
        ]
    });
    let spectrum = velocity_spectrum(&grid).unwrap();
    let mut due = vec![0.0; spectrum.shells().len()];
    (due[0], due[2], due[3], due[5]) = (0.125, 0.25, 1.0, 2.25 + 4.0);
    for (shell, due) in spectrum.shells().iter().zip(due) {
        assert_close(&format!("E({})", shell.wave_number), shell.energy, due, transform_error(across) * 10.0);
    }
}

/// All shells together have half the mean square, whatever the dimension, odd or even, Nyquist's wave and corners included.
#[test]
fn shells_add_up_to_the_energy() {
    fn check<const D: usize>(across: usize) {
        let grid = random_field::<D>(across, 7);
        let spectrum = velocity_spectrum(&grid).unwrap();
        let points = across.pow(D as u32);
        let squares: f64 = (0..D).flat_map(|axis| grid.component(axis)).map(|v| v * v).sum();
        let due = 0.5 * squares / points as f64;
        let bound = (2.0 * transform_error(across) + gamma(D * points, UNIT)) * due;
        assert_close(&format!("total of {across}^{D}"), spectrum.total(), due, bound);
        assert_eq!(spectrum.shells().iter().map(|shell| shell.modes).sum::<u64>(), points as u64, "{across}^{D}");
    }
    for across in [4, 5, 8, 9, 12, 16, 30] {
        check::<1>(across);
        check::<2>(across);
    }
    for across in [4, 5, 8, 12] {
        check::<3>(across);
    }
}

/// Row 49, Nyquist: on an even grid the wave of n/2 has no partner and counts once; an odd grid has none.
#[test]
fn nyquists_wave_counts_once_and_is_not_resolved() {
    let grid = field::<1>(8, |n| [if n[0] % 2 == 0 { 3.0 } else { -3.0 }]);
    let spectrum = velocity_spectrum(&grid).unwrap();
    let energies: Vec<f64> = spectrum.shells().iter().map(|shell| shell.energy).collect();
    for (energy, due) in energies.iter().zip([0.0, 0.0, 0.0, 0.0, 4.5]) {
        assert_close("E", *energy, due, transform_error(8) * 4.5);
    }
    let resolved = |spectrum: &Spectrum| spectrum.resolved().iter().map(|shell| shell.wave_number).collect::<Vec<_>>();
    assert_eq!(resolved(&spectrum), [1, 2, 3]);
    let odd = velocity_spectrum(&random_field::<1>(7, 1)).unwrap();
    assert_eq!(resolved(&odd), [1, 2, 3]);
    assert_eq!(odd.shells().len(), 4);
}

/// The number of wave vectors in a shell is not its surface: for k = 1 to 6 it is 1.43, 1.23, 0.87, 1.04, 1.11, 0.99 of `4 pi k^2`.
#[test]
fn shells_have_their_number_of_waves() {
    let spectrum = velocity_spectrum(&random_field::<3>(16, 3)).unwrap();
    let counts: Vec<u64> = spectrum.resolved()[..6].iter().map(|shell| shell.modes).collect();
    assert_eq!(counts, [18, 62, 98, 210, 350, 450]);
    for (k, due) in [1.43, 1.23, 0.87, 1.04, 1.11, 0.99].into_iter().enumerate() {
        let surface = 4.0 * PI * ((k + 1) as f64).powi(2);
        assert_close("share of the surface", counts[k] as f64 / surface, due, 0.005);
        // The other reading has the surface in place of the number.
        let ratio = spectrum.resolved()[k].energy / spectrum.shell_averages()[k];
        assert_close("ratio of the readings", ratio, counts[k] as f64 / surface, 8.0 * UNIT * ratio);
    }
    let flat = velocity_spectrum(&random_field::<2>(16, 3)).unwrap();
    let shell = flat.resolved()[2];
    let due = shell.energy / shell.modes as f64 * TAU * 3.0;
    assert_close("average in 2-D", flat.shell_averages()[2], due, 4.0 * UNIT * due);
    let line = velocity_spectrum(&random_field::<1>(16, 3)).unwrap();
    assert_eq!(line.shell_averages()[4], line.resolved()[4].energy, "in 1-D two waves are the surface");
}

/// A field with any wanted spectrum: waves of random phase that share their shell's energy evenly.
fn with_spectrum(across: usize, energy: impl Fn(f64) -> f64) -> VelocityGrid<2> {
    let mut random = Pcg64Mcg::seed_from_u64(17);
    let most = (across / 2 - 1) as i32;
    let shell = |a: i32, b: i32| (f64::from(a * a + b * b)).sqrt().round();
    let all: Vec<(i32, i32)> = (-most..=most).flat_map(|a| (-most..=most).map(move |b| (a, b))).collect();
    let mut components = [vec![0.0; across * across], vec![0.0; across * across]];
    for k in 1..=most {
        let waves: Vec<(i32, i32)> = all.iter().copied().filter(|&(a, b)| shell(a, b) == f64::from(k)).collect();
        let half: Vec<(i32, i32)> = waves.iter().copied().filter(|&(a, b)| b > 0 || (b == 0 && a > 0)).collect();
        // A^2 / 4 each.
        let amplitude = (4.0 * energy(f64::from(k)) / half.len() as f64).sqrt();
        for (a, b) in half {
            let (phase, turn) = (TAU * random.random::<f64>(), TAU * random.random::<f64>());
            for j in 0..across {
                for i in 0..across {
                    let angle = TAU * (f64::from(a) * i as f64 + f64::from(b) * j as f64) / across as f64 + phase;
                    components[0][i + across * j] += amplitude * turn.cos() * angle.cos();
                    components[1][i + across * j] += amplitude * turn.sin() * angle.cos();
                }
            }
        }
    }
    VelocityGrid::from_components(across, components).unwrap()
}

#[test]
fn a_power_law_is_read_off_as_it_was_put_in() {
    let spectrum = velocity_spectrum(&with_spectrum(32, |k| 0.2 * k.powf(-5.0 / 3.0))).unwrap();
    let (k, e): (Vec<f64>, Vec<f64>) =
        spectrum.resolved().iter().map(|shell| (shell.wave_number as f64, shell.energy)).unzip();
    let bound = 1e-11;
    for (k, e) in k.iter().zip(&e) {
        assert_close(&format!("E({k})"), *e, 0.2 * k.powf(-5.0 / 3.0), bound);
    }
    let fit = fit_power_law(&k, &e, (2.0, 12.0)).unwrap();
    assert_close("slope", fit.exponent, -5.0 / 3.0, 1e-8);
    for (_, flat) in spectrum.compensated(5.0 / 3.0) {
        assert_close("compensated", flat, 0.2, 100.0 * bound);
    }
    // The reading by shell averages does not give the slope back: its noise is that of the lattice.
    let averages = spectrum.shell_averages();
    let other = fit_power_law(&k, &averages, (2.0, 12.0)).unwrap();
    assert!((other.exponent + 5.0 / 3.0).abs() > 1e-3, "slope of the other reading: {}", other.exponent);
    let sum: f64 = averages.iter().sum();
    assert!((sum / e.iter().sum::<f64>() - 1.0).abs() > 0.005, "the other reading does not add up to the energy");
}

/// A bump at 9.5 on the inertial range, below a peak of the driving that is higher still.
#[test]
fn bottleneck_is_the_top_above_the_driving() {
    let bump = |k: f64| 1.0 + (-(k / 9.5).ln().powi(2) / 0.18).exp();
    let driven = |k: f64| if k < 3.5 { 50.0 } else { 1.0 };
    let spectrum = velocity_spectrum(&with_spectrum(32, |k| k.powf(-5.0 / 3.0) * bump(k) * driven(k))).unwrap();
    let found = spectrum.bottleneck((4, 15)).unwrap();
    // bump(9) and bump(10) differ by 1e-3; the parabola finds the place between them to its own fourth order.
    assert!(found.shell == 9 || found.shell == 10, "{found:?}");
    assert_close("k_max", found.refined.unwrap(), 9.5, 0.02);
    let with_driving = spectrum.bottleneck((1, 15)).unwrap();
    assert!(with_driving.shell <= 3, "with the driven waves in range their peak wins: {with_driving:?}");
    // At an end of the range nothing can be said about what is beyond.
    assert_eq!(spectrum.bottleneck((4, 7)).unwrap().refined, None);
    assert_eq!(spectrum.bottleneck((12, 15)).unwrap().refined, None);
}

/// Shifting, swapping axes and doubling the velocity.
#[test]
fn spectrum_has_its_symmetries() {
    let across = 8;
    let grid = random_field::<2>(across, 21);
    let v = |n: [usize; 2]| [grid.component(0)[n[0] + across * n[1]], grid.component(1)[n[0] + across * n[1]]];
    let energies = |grid: &VelocityGrid<2>| -> Vec<f64> {
        velocity_spectrum(grid).unwrap().shells().iter().map(|shell| shell.energy).collect()
    };
    let plain = energies(&grid);
    let others = [
        (energies(&field(across, |n| v([(n[0] + 3) % across, (n[1] + 1) % across]))), 1.0),
        (energies(&field(across, |n| [v([n[1], n[0]])[1], v([n[1], n[0]])[0]])), 1.0),
        (energies(&field(across, |n| v(n).map(|v| -2.0 * v))), 4.0),
    ];
    for (other, factor) in others {
        for (other, plain) in other.iter().zip(&plain) {
            assert_close("E", *other, factor * plain, factor * transform_error(across) * plain.max(1.0));
        }
    }
}
