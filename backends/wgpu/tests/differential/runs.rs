//! The device follows the reference through time.

use etalon_reference::conformance::runs::check_run;
use etalon_reference::domain::Domain;
use etalon_reference::equations::reconstruction::smoothing_length_holding;
use etalon_reference::particles::{Particle, ParticleSet};
use etalon_reference::passes::Physics;
use etalon_reference::scenes::dustyshock::DustyShock;
use etalon_reference::scenes::sod::Sod;
use etalon_reference::schemes::{Dissipation, Drag, Viscosity};

use crate::adapter::device;
use crate::random::Random;
use crate::scene::{engine, physics};

fn follow<const D: usize>(name: &str, set: &ParticleSet<D>, physics: Physics, until: f64) {
    let Some(device) = device() else { return };
    let distances = check_run::<D, _>(set, physics, engine(set, &physics, device), until).unwrap();
    for distance in &distances {
        eprintln!("{name}: {distance}");
    }
    assert!(distances.iter().all(|distance| distance.holds()), "{name}: {distances:?}");
}

#[test]
fn the_shock_tube_in_one_dimension() {
    let scene = Sod::standard(1).with(|m| m.particles = 200);
    let set = scene.particles::<1>(|_| Ok(Vec::new())).unwrap();
    // The end of the standard problem: shock, contact and rarefaction stand apart.
    follow("1-D shock tube", &set, scene.physics(), 0.2);
}

#[test]
fn the_shock_tube_in_two_dimensions() {
    let scene = Sod::standard(2).with(|m| (m.particles, m.viscosity) = (3000, Viscosity::of(Dissipation::AvSlrB2F)));
    let set = scene.particles::<2>(|_| Ok(Vec::new())).unwrap();
    follow("2-D shock tube", &set, scene.physics(), 0.01);
}

/// Dust that streams through gas, with drag reconstructed.
#[test]
fn gas_with_dust_in_one_dimension() {
    let scene = DustyShock { drag: Drag::of(20.0), ..DustyShock::standard(1) };
    follow("1-D dusty shock", &scene.particles::<1>().unwrap(), scene.physics(), 0.05);
}

/// The tube would need many more particles to be as wide as a support in three dimensions.
#[test]
fn a_strong_wave_in_three_dimensions() {
    let physics = physics::<3>(Dissipation::AvSlrB2);
    follow("3-D wave", &wave(12, &physics), physics, 0.06);
}

/// A box of gas at almost even density, blown together in one half and apart in the other at a third of the speed of sound.
fn wave(across: usize, physics: &Physics) -> ParticleSet<3> {
    let spacing = 1.0 / across as f64;
    let h = smoothing_length_holding(physics.neighbours, spacing.powi(3), 3, physics.kernel.support());
    let mut random = Random(3);
    let particles = (0..across.pow(3)).map(|i| {
        let cell = [i % across, i / across % across, i / across / across];
        let position = cell.map(|k| (k as f64 + 0.5 + random.between(-0.1, 0.1)) * spacing);
        Particle {
            position,
            velocity: [0.3 * (std::f64::consts::TAU * position[0]).sin(), 0.1 * position[0], 0.0],
            mass: spacing.powi(3),
            smoothing_length: h,
            internal_energy: 1.0,
            mobile: true,
        }
    });
    ParticleSet::new(Domain::new([0.0; 3], [1.0; 3], [true; 3]).unwrap(), particles.collect()).unwrap()
}
