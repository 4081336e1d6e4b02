//! The device follows the reference through time.
//!
//! A flow magnifies every rounding error, and by how much is measured: the scalar reference runs in single precision too. The
//! device does the same operations, and where its driver rounds otherwise its errors are of the same size; only divisions
//! may be 2.5 units in the last place off instead of half a unit. Two independent errors, one five times the other: the
//! device's distance from the truth is allowed sqrt(1 + 5^2) times that of the scalar run, in the root mean square. Its
//! places are kept to 2^-32 of the box, those of the reference far better: one more half step of that grid for each step.

use etalon_kernels_gen::Field;
use etalon_reference::domain::{Domain, separation};
use etalon_reference::engine::{Engine, PlainEngine};
use etalon_reference::equations::reconstruction::support_volume;
use etalon_reference::fields;
use etalon_reference::particles::{Particle, ParticleSet};
use etalon_reference::passes::Physics;
use etalon_reference::scenes::sod::Sod;
use etalon_reference::schemes::Dissipation;
use etalon_reference::simulation::Simulation;

use crate::adapter::device;
use crate::random::Random;
use crate::scene::{engine, physics};

const FACTOR: f64 = 5.1;

/// What is compared, besides places.
fn state<const D: usize, E: Engine<D>>(run: &mut Simulation<D, E>) -> Vec<(String, Vec<f64>)> {
    let compared: [Field; 6] = [
        fields::VELOCITY,
        fields::INTERNAL_ENERGY,
        fields::SMOOTHING_LENGTH,
        fields::DENSITY,
        fields::ACCELERATION,
        fields::ENERGY_RATE,
    ];
    let mut all = Vec::new();
    for field in compared {
        let values = run.engine().read_all(field).unwrap().concat();
        all.push((field.name.to_owned(), values));
    }
    all
}

fn rms(a: &[f64], b: &[f64]) -> f64 {
    (a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>() / a.len() as f64).sqrt()
}

fn run<const D: usize, E: Engine<D>>(engine: E, physics: Physics, until: f64) -> Simulation<D, E> {
    let mut run = Simulation::new(engine, physics).unwrap();
    run.run(until, |_| {}).unwrap();
    run
}

fn judge(what: &str, error: f64, tolerance: f64) {
    eprintln!("{what}: rms error {error:.2e}, tolerance {tolerance:.2e}, {:.0} % of it", 100.0 * error / tolerance);
    assert!(error <= tolerance, "{what}: rms error {error:e}, tolerance {tolerance:e}");
}

fn follow<const D: usize>(name: &str, set: &ParticleSet<D>, physics: Physics, until: f64) {
    let Some(device) = device() else { return };
    let mut exact = run(PlainEngine::<f64, D>::new(set), physics, until);
    let mut single = run(PlainEngine::<f32, D>::new(set), physics, until);
    let mut found = run(engine(set, &physics, device), physics, until);
    assert_eq!(found.steps(), exact.steps(), "{name}: another number of steps");
    assert!(exact.steps() >= 3, "{name}: {} steps show nothing", exact.steps());
    eprintln!("{name}: {} particles, {} steps", set.len(), exact.steps());

    let (exact_state, single_state, found_state) = (state(&mut exact), state(&mut single), state(&mut found));
    for (k, (field, truth)) in exact_state.iter().enumerate() {
        let tolerance = FACTOR * rms(&single_state[k].1, truth);
        judge(&format!("{name}: {field}"), rms(&found_state[k].1, truth), tolerance);
    }
    for axis in 0..D {
        let length = set.domain().torus_length()[axis];
        let truth = exact.engine().coordinates(axis).unwrap();
        let far = |places: Vec<u64>| {
            let apart = |(a, b): (&u64, &u64)| separation(*a, *b, length).powi(2);
            (places.iter().zip(&truth).map(apart).sum::<f64>() / truth.len() as f64).sqrt()
        };
        let error = far(found.engine().coordinates(axis).unwrap());
        let half_step = length * 2f64.powi(-33);
        let tolerance = FACTOR * far(single.engine().coordinates(axis).unwrap()) + found.steps() as f64 * half_step;
        judge(&format!("{name}: place along axis {axis}"), error, tolerance);
    }
}

#[test]
fn the_shock_tube_in_one_dimension() {
    let scene = Sod { particles: 200, ..Sod::standard(1) };
    let set = scene.particles::<1>(|_| Ok(Vec::new())).unwrap();
    follow("1-D shock tube", &set, scene.physics(), 0.05);
}

#[test]
fn the_shock_tube_in_two_dimensions() {
    let scene = Sod { particles: 3000, dissipation: Dissipation::AvSlrB2F, ..Sod::standard(2) };
    let set = scene.particles::<2>(|_| Ok(Vec::new())).unwrap();
    follow("2-D shock tube", &set, scene.physics(), 0.01);
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
    let volume = support_volume(3, physics.kernel.support());
    let mut random = Random(3);
    let particles = (0..across.pow(3)).map(|i| {
        let cell = [i % across, i / across % across, i / across / across];
        let position = cell.map(|k| (k as f64 + 0.5 + random.between(-0.1, 0.1)) * spacing);
        Particle {
            position,
            velocity: [0.3 * (std::f64::consts::TAU * position[0]).sin(), 0.1 * position[0], 0.0],
            mass: spacing.powi(3),
            smoothing_length: spacing * (physics.neighbours / volume).cbrt(),
            internal_energy: 1.0,
            mobile: true,
        }
    });
    ParticleSet::new(Domain::new([0.0; 3], [1.0; 3], [true; 3]).unwrap(), particles.collect()).unwrap()
}
