//! The glass that initial states are cut from: even, and no two particles close.

use etalon_kernels_gen::Component;
use etalon_reference::domain::Domain;
use etalon_reference::engine::{Engine, PlainEngine};
use etalon_reference::equations::reconstruction::smoothing_length_holding;
use etalon_reference::fields;
use etalon_reference::particles::{Particle, ParticleSet};
use etalon_reference::passes::{Physics, VolumeElements};
use etalon_reference::scenes::relax;
use etalon_reference::scenes::sod::Sod;

fn glass<const D: usize>(across: usize, physics: Physics, rounds: usize, seed: u64) -> Vec<[f64; D]> {
    relax::<D, PlainEngine<f64, D>>(across, physics, rounds, seed, |set, _| Ok(PlainEngine::new(set))).unwrap()
}

/// The standard deviation of the density over its mean, all smoothing lengths being equal.
fn scatter<const D: usize>(places: &[[f64; D]], physics: Physics) -> f64 {
    let mass = 1.0 / places.len() as f64;
    let h = smoothing_length_holding(physics.neighbours, mass, D, physics.kernel.support());
    let particles = places.iter().map(|&position| Particle {
        position,
        velocity: [0.0; D],
        mass,
        smoothing_length: h,
        internal_energy: 1.0,
        mobile: true,
    });
    let domain = Domain::new([0.0; D], [1.0; D], [true; D]).unwrap();
    let mut engine = PlainEngine::<f64, D>::new(&ParticleSet::new(domain, particles.collect()).unwrap());
    engine.find_neighbours(physics.kernel.support()).unwrap();
    engine.run_pass(&VolumeElements(physics)).unwrap();
    let density = engine.read(Component { field: fields::STANDARD_DENSITY, index: 0 }).unwrap();
    let mean = density.iter().sum::<f64>() / density.len() as f64;
    (density.iter().map(|rho| (rho / mean - 1.0).powi(2)).sum::<f64>() / density.len() as f64).sqrt()
}

/// The smallest distance of two particles, the short way round, in spacings of the lattice.
fn closest<const D: usize>(places: &[[f64; D]], across: usize) -> f64 {
    let mut smallest = f64::INFINITY;
    for (i, a) in places.iter().enumerate() {
        for b in &places[..i] {
            let squares = a.iter().zip(b).map(|(a, b)| {
                let apart = (a - b).abs();
                apart.min(1.0 - apart).powi(2)
            });
            smallest = squares.sum::<f64>().min(smallest);
        }
    }
    smallest.sqrt() * across as f64
}

/// Half of what a scene takes, and enough to tell.
const ROUNDS: usize = 100;

/// How many times less the density scatters. Measured: 9 to 10 times in two dimensions, 11 to 15 in three. Where motion is not taken out
/// after every step it is 4.6 to 6.9 times, and without a drift once.
const EVENER: f64 = 7.0;

/// Relaxes for several seeds; no two particles of any may end up closer than `nearest` spacings.
fn check<const D: usize>(across: usize, seeds: &[u64], nearest: f64) {
    let physics = Sod::standard(D).physics();
    let mut last = Vec::new();
    for &seed in seeds {
        let start = glass::<D>(across, physics, 0, seed);
        let end = glass::<D>(across, physics, ROUNDS, seed);
        assert_eq!(end.len(), across.pow(D as u32));
        assert!(end.iter().flatten().all(|x| (0.0..1.0).contains(x)), "seed {seed}: outside of the unit box");
        let (before, after) = (scatter(&start, physics), scatter(&end, physics));
        let (near_before, near) = (closest(&start, across), closest(&end, across));
        eprintln!(
            "{D}-D, seed {seed}: scatter {before:.2e}, then {after:.2e}, tolerance {:.2e}; closest {near_before:.3} spacings, \
             then {near:.3}, tolerance {nearest}",
            before / EVENER
        );
        assert!(after < before / EVENER, "seed {seed}: scatter {after:e} where it was {before:e} before");
        assert!(near > nearest, "seed {seed}: two particles are {near} spacings apart, {nearest} wanted");
        assert!(near_before < nearest, "seed {seed}: the start was as even already, {near_before}");
        assert_ne!(end, last, "seed {seed} makes the glass of the one before it");
        last = end;
    }
    let again = seeds.last().map(|&seed| glass::<D>(across, physics, ROUNDS, seed));
    assert_eq!(again, Some(last), "not the same bits when repeated");
}

// The random start has neighbours as close as 0.37 to 0.43 spacings. Measured after the rounds: 0.72 to 0.75 in two dimensions, where
// the most even arrangement of all, hexagons, has 1.07; 0.56 to 0.60 in three, where it is 1.12 and a glass takes longer to form. The
// tolerance is at least an eighth less, and more than the start has.

#[test]
fn a_glass_in_two_dimensions_is_even_and_always_the_same() {
    check::<2>(16, &[1, 2, 3], 0.6);
}

#[test]
fn a_glass_in_three_dimensions_is_even_and_always_the_same() {
    check::<3>(9, &[2, 1], 0.48);
}
