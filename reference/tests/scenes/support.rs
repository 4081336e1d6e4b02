//! Running a scene of any kind on the reference.

use etalon_reference::engine::PlainEngine;
use etalon_reference::particles::ParticleSet;
use etalon_reference::scenes::{Scene, State};
use etalon_reference::simulation::Simulation;

/// A lattice of `across^D` in the unit cube, in the place of a glass.
pub fn regular<const D: usize>(across: usize) -> Vec<[f64; D]> {
    let place =
        |i: usize| std::array::from_fn(|axis| ((i / across.pow(axis as u32) % across) as f64 + 0.5) / across as f64);
    (0..across.pow(D as u32)).map(place).collect()
}

/// The particles a scene starts from.
pub fn particles<const D: usize>(scene: &dyn Scene<D>) -> ParticleSet<D> {
    scene.particles(&mut |across| Ok(regular(across))).unwrap_or_else(|error| panic!("{error}"))
}

/// Its states at these times, which rise; zero is the start.
pub fn states<const D: usize>(scene: &dyn Scene<D>, times: &[f64]) -> Vec<State> {
    let set = particles(scene);
    let mut run = Simulation::new(PlainEngine::<f64, D>::new(&set), scene.physics()).unwrap();
    let mut state = |&time: &f64| {
        run.run(time, |_| {}).unwrap_or_else(|error| panic!("{error}"));
        State::read_for(scene, run.engine(), set.domain(), time).unwrap()
    };
    times.iter().map(&mut state).collect()
}

/// The quantities at those times, by name.
pub fn series<const D: usize>(scene: &dyn Scene<D>, times: &[f64]) -> Vec<Vec<f64>> {
    let states = states(scene, times);
    let values = |now| scene.observe_since(&states[0], now).unwrap_or_else(|error| panic!("{error}"));
    let rows: Vec<Vec<f64>> = states.iter().map(values).collect();
    assert!(rows.iter().all(|row| row.len() == scene.quantities().len()), "not one value for each quantity");
    rows
}

/// The total mass and energy of what moves.
pub fn mass_and_energy<const D: usize>(set: &ParticleSet<D>) -> (f64, f64) {
    let moving = set.particles().iter().filter(|p| p.mobile);
    moving.fold((0.0, 0.0), |(mass, energy), p| {
        let square: f64 = p.velocity.iter().map(|v| v * v).sum();
        (mass + p.mass, energy + p.mass * (0.5 * square + p.internal_energy))
    })
}

/// Fails unless they agree to this share of the second.
pub fn near(what: &str, found: f64, due: f64, tolerance: f64) {
    let off = (found / due - 1.0).abs();
    println!("{what}: {found} where {due} is due, off by {off:e}, tolerance {tolerance:e}");
    assert!(off <= tolerance, "{what}: {found} where {due} is due: off by {off:e}, tolerance {tolerance:e}");
}
