//! Noh's implosion: even cold gas at the start; then a plateau that is hollow in the centre, and a shock where it should be.

use crate::support::{mass_and_energy, near, particles, series, states};
use etalon_reference::scenes::noh::{END_TIME, Noh};
use etalon_reference::scenes::{Compared, Definition, Scene};
use std::f64::consts::{FRAC_PI_3, PI};

fn noh(dimension: usize, particles: usize) -> Noh {
    let mut scene = Noh::standard(dimension);
    scene.method.particles = particles;
    scene
}

fn starts<const D: usize>(count: usize, volume: f64) {
    let set = particles::<D>(&noh(D, count));
    let (mass, energy) = mass_and_energy(&set);
    // The edge of a ball cut from a lattice is a spacing rough; what is off on one side is made up for on another.
    let rough = (count as f64).powf(-1.0 / D as f64);
    near("mass", mass, volume, if D == 1 { 1e-12 } else { rough });
    // All of it falls at unit speed.
    near("energy", energy, 0.5 * mass, 1e-12);
    near("particles", set.len() as f64, count as f64, rough);
}

#[test]
fn it_starts_even_and_cold_in_all_dimensions() {
    let radius: f64 = 1.2;
    starts::<1>(100, 2.0 * radius);
    starts::<2>(1000, PI * radius.powi(2));
    starts::<3>(4000, 4.0 * FRAC_PI_3 * radius.powi(3));
}

/// No internal energy at all, so no sound: the step is the shock's alone.
#[test]
fn the_line_converges_to_noh() {
    let l1 = |count: usize| {
        let scene = noh(1, count);
        let states = states::<1>(&scene, &[0.0, END_TIME]);
        let solution = Scene::<1>::solution(&scene, END_TIME).unwrap().unwrap();
        let range = Scene::<1>::measured(&scene, END_TIME).range;
        let found = states[1].l1(Scene::<1>::view(&scene), solution.as_ref(), Compared::Density, range).unwrap();
        (found, Scene::<1>::observe(&scene, &states[1]).unwrap())
    };
    let (coarse, fine) = (l1(80), l1(240));
    println!("{coarse:?} {fine:?}");
    let order = (coarse.0 / fine.0).ln() / 3.0_f64.ln();
    assert!(order > 0.6, "order {order}");
    near("plateau", fine.1[0], 4.0, 0.02);
    // A shell is 1/200, and a particle of the plateau 1/400.
    near("shock", fine.1[2], 0.2, 0.05);
    assert!(fine.1[1] > 0.0, "the first moment's heat leaves the centre hollow");
}

/// Where gas converges sideways the viscosity heats it before the shock comes, so the plateau is too thin and the shock too far out; both the less
/// so the more particles there are.
#[test]
fn the_disc_comes_nearer_to_noh() {
    let time = 0.3;
    let off = |count| {
        let found = &series::<2>(&noh(2, count), &[0.0, time])[1];
        println!("{count}: {found:?}");
        (16.0 - found[0], found[2] - time / 3.0)
    };
    let (coarse, fine) = (off(300), off(1500));
    assert!(0.0 < fine.0 && fine.0 < 0.9 * coarse.0, "the plateau lacks {} and {}", coarse.0, fine.0);
    assert!(fine.1.abs() < coarse.1.abs(), "the shock is off by {} and {}", coarse.1, fine.1);
}

#[test]
fn what_is_no_cold_gas_is_refused() {
    let mut scene = noh(3, 1000);
    scene.internal_energy = 1.0;
    assert!(Scene::<3>::check(&scene).unwrap_err().to_string().starts_with("internal_energy = 1"));
    scene.internal_energy = 1e-6;
    scene.gamma = 1.0;
    assert!(Scene::<3>::check(&scene).unwrap_err().to_string().contains("above 1"));
    let (last, why) = Scene::<3>::last_time(&noh(3, 14_000));
    assert!(last > END_TIME && why.contains("edge"), "{last}");
}
