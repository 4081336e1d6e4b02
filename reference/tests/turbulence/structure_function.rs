//! C25 (32), (33): velocity differences by distance.

use crate::check::{UNIT, assert_close, gamma};
use crate::places::{lattice, particles, scattered, weighed};
use etalon_reference::engine::PlainEngine;
use etalon_reference::particles::{Particle, ParticleSet};
use etalon_reference::schemes::MachReading;
use etalon_reference::turbulence::structure_function::{
    PairChoice, Scale, mach_numbers, rms_mach_number, structure_function,
};
use etalon_reference::turbulence::{Bins, Snapshot};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use std::f64::consts::TAU;

/// Three particles on a line of length 8 at 0, 1 and 6: distances 1, 3 and, the short way round, 2.
#[test]
fn pairs_by_hand() {
    let velocities = [[1.0, 0.0], [3.0, 1.0], [0.0, 5.0]];
    let places = [[0.0, 0.0], [1.0, 0.0], [6.0, 0.0]];
    let scales = |cloud: &Snapshot<2>, edges: &[f64]| {
        structure_function(cloud, &Bins::between(edges.to_vec()).unwrap(), PairChoice::All).unwrap()
    };
    let cloud = particles(8.0, &places, |i| velocities[i]);
    // All components count, not the one along the line: 4 + 1, 1 + 25, 9 + 16.
    let due = [(1.0, 5.0), (2.0, 26.0), (3.0, 25.0)];
    let scale = |(distance, structure_function)| Scale { distance, structure_function, pairs: 1 };
    assert_eq!(scales(&cloud, &[0.5, 1.5, 2.5, 3.5]), due.map(scale));
    // A bin is the mean over its pairs; one without pairs is left out.
    let wide = scales(&cloud, &[0.1, 0.2, 2.5, 3.5]);
    assert_eq!(wide, [Scale { distance: 1.5, structure_function: 15.5, pairs: 2 }, scale((3.0, 25.0))]);
    // Masses 1, 2, 5: pairs weigh 2, 5 and 10.
    let heavy = weighed(8.0, &places, |i| velocities[i], vec![1.0, 2.0, 5.0]);
    let all = scales(&heavy, &[0.0, 4.0])[0];
    assert_close("S_2", all.structure_function, (2.0 * 5.0 + 5.0 * 26.0 + 10.0 * 25.0) / 17.0, 30.0 * 4.0 * UNIT);
    assert_close("distance", all.distance, (2.0 + 10.0 + 30.0) / 17.0, 3.0 * 4.0 * UNIT);
}

/// A wave `A sin(2 pi x)` on a lattice has `S_2(l) = A^2 (1 - cos(2 pi l))`, exactly.
#[test]
fn a_wave_has_its_structure_function() {
    let across = 64;
    let (amplitude, n) = (3.0, across as f64);
    let cloud = particles(1.0, &lattice::<1>(across), |i| [amplitude * (TAU * (i as f64 + 0.5) / n).sin()]);
    let bins = Bins::between((0..=32).map(|k| ((f64::from(k) + 0.5) / n).min(0.5)).collect()).unwrap();
    let scales = structure_function(&cloud, &bins, PairChoice::All).unwrap();
    assert_eq!(scales.len(), 32);
    for (k, scale) in scales.iter().enumerate() {
        let distance = (k + 1) as f64 / n;
        assert_close("distance", scale.distance, distance, 4.0 * UNIT);
        let due = amplitude * amplitude * (1.0 - (TAU * distance).cos());
        // Squares of differences of two sines, a dozen u of A^2 each, in a mean.
        assert_close(&format!("S_2({distance})"), scale.structure_function, due, 24.0 * UNIT * 4.0 * 9.0);
        assert_eq!(
            scale.pairs,
            if k == 31 { 32 } else { 64 },
            "half the box is reached from either side by the same pair"
        );
    }
    // Moving along changes nothing, and a uniform velocity has none.
    let moving = particles(1.0, &lattice::<1>(across), |_| [1e3]);
    assert!(structure_function(&moving, &bins, PairChoice::All).unwrap().iter().all(|s| s.structure_function == 0.0));
}

/// Far-apart points that know nothing of one another: with the half the Mach number of the scale is that of the flow.
#[test]
fn uncorrelated_velocities_have_the_mach_number_of_the_flow_at_every_scale() {
    let count = 600;
    let mut random = Pcg64Mcg::seed_from_u64(2);
    let velocities: Vec<[f64; 3]> =
        (0..count).map(|_| std::array::from_fn(|_| 2.0 * random.random::<f64>() - 1.0)).collect();
    let mean: [f64; 3] = std::array::from_fn(|axis| velocities.iter().map(|v| v[axis]).sum::<f64>() / count as f64);
    let cloud =
        particles(1.0, &scattered::<3>(count, 3), |i| std::array::from_fn(|axis| velocities[i][axis] - mean[axis]));
    let whole_flow = rms_mach_number(&cloud, &vec![0.5; count]).unwrap();
    let bins = Bins::linear(0.1, 0.5, 4).unwrap();
    let scales = structure_function(&cloud, &bins, PairChoice::All).unwrap();
    let halved = mach_numbers(&scales, 0.5, MachReading::Halved).unwrap();
    let whole = mach_numbers(&scales, 0.5, MachReading::Whole).unwrap();
    for ((scale, halved), whole) in scales.iter().zip(&halved).zip(&whole) {
        // |v_b - v_a|^2 has mean 2 and deviation about 1.1; pairs share 600 particles of deviation 0.5 in v^2, so the mean
        // of S_2 / 2 is known to 0.5 / sqrt(600) and a little: 2 % of 1, half of it in the root; five times that.
        assert_close(&format!("M({})", scale.distance), halved / whole_flow, 1.0, 0.06);
        assert_close("the other reading", whole / halved, 2_f64.sqrt(), 8.0 * UNIT);
    }
    // All pairs at once, any distance: S_2 / 2 = N / (N - 1) (<v^2> - <v>^2), exactly. Beyond half a side there are pairs in the
    // corners only, so take a small cluster.
    let near: Vec<[f64; 3]> = scattered::<3>(count, 3).iter().map(|x| x.map(|x| 0.25 * x)).collect();
    let cluster = particles(1.0, &near, |i| std::array::from_fn(|axis| velocities[i][axis] - mean[axis]));
    let all = structure_function(&cluster, &Bins::linear(0.0, 0.5, 1).unwrap(), PairChoice::All).unwrap()[0];
    assert_eq!(all.pairs, (count * (count - 1) / 2) as u64);
    let mach = mach_numbers(&[all], 0.5, MachReading::Halved).unwrap()[0];
    let due = whole_flow * (count as f64 / (count - 1) as f64).sqrt();
    assert_close("all pairs", mach, due, due * gamma(2 * count + 40, UNIT));
}

/// A sample of pairs gives the mean over all of them, within its own scatter, and the same sample again.
#[test]
fn random_pairs_are_a_fair_sample() {
    let cloud = particles(1.0, &lattice::<2>(12), |i| {
        let x = TAU * ((i % 12) as f64 + 0.5) / 12.0;
        [x.sin(), 0.5 * x.cos()]
    });
    let bins = Bins::linear(0.0, 0.5, 5).unwrap();
    let all = structure_function(&cloud, &bins, PairChoice::All).unwrap();
    let sample = |seed| structure_function(&cloud, &bins, PairChoice::Random { count: 40_000, seed }).unwrap();
    assert_eq!(sample(1), sample(1));
    assert_ne!(sample(1), sample(2));
    let whole: u64 = all.iter().map(|scale| scale.pairs).sum();
    let drawn: u64 = sample(1).iter().map(|scale| scale.pairs).sum();
    let share = whole as f64 / (144.0 * 143.0 / 2.0);
    let scatter = (share * (1.0 - share) / 40_000.0).sqrt();
    assert_close("share of pairs in the bins", drawn as f64 / 40_000.0, share, 5.0 * scatter);
    for (all, some) in all.iter().zip(sample(1)) {
        // |v_b - v_a|^2 lies between 0 and 4.
        assert_close("S_2", some.structure_function, all.structure_function, 5.0 * 2.0 / (some.pairs as f64).sqrt());
    }
}

#[test]
fn rms_mach_number_is_a_mean_over_mass_with_own_sound_speeds() {
    // v^2 / c^2 = 25 / 25 and 9 / 1, masses 3 and 1: (3 + 9) / 4.
    let cloud = weighed(1.0, &[[0.1, 0.1], [0.6, 0.2]], |i| [[3.0, 4.0], [0.0, -3.0]][i], vec![3.0, 1.0]);
    assert_close("Mach", rms_mach_number(&cloud, &[5.0, 1.0]).unwrap(), 3_f64.sqrt(), 8.0 * UNIT);
}

/// A set, an engine that holds it, and columns are three ways to the same particles.
#[test]
fn particles_come_from_sets_and_engines_alike() {
    let domain = crate::places::cube::<2>(2.0);
    let particle = |i: usize| Particle {
        position: [0.1 * i as f64, 0.7],
        velocity: [i as f64, -1.0],
        mass: 1.0 + i as f64,
        smoothing_length: 0.1,
        internal_energy: 1.0,
        mobile: true,
    };
    let set = ParticleSet::new(domain, (0..5).map(particle).collect()).unwrap();
    let snapshot = Snapshot::of_set(&set).unwrap();
    let mut engine = PlainEngine::<f64, 2>::new(&set);
    assert_eq!(Snapshot::of_engine(domain, &mut engine).unwrap(), snapshot);
    assert_eq!((snapshot.len(), snapshot.mass()[3], snapshot.velocity(2).0), (5, 4.0, [2.0, -1.0]));
    assert_close("distance", snapshot.distance(0, 4), 0.4, 1e-9);
}
