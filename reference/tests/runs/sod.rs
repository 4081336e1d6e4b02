//! The shock tube in one dimension, run by the reference and compared with the exact solution.

use etalon_reference::engine::{Engine, PlainEngine};
use etalon_reference::fields;
use etalon_reference::norms::l1_error;
use etalon_reference::scenes::sod::{END_TIME, INTERFACE, MEASURED, Sod};
use etalon_reference::simulation::Simulation;

/// `L_1` of the velocity at the end (GS25 20), against the exact solution of the sharp start.
fn error(particles: usize, smoothed: bool) -> f64 {
    let scene = Sod { smoothed, ..Sod::standard(1).with(|m| m.particles = particles) };
    let set = scene.particles::<1>(|_| Ok(Vec::new())).unwrap();
    let mut simulation = Simulation::new(PlainEngine::<f64, 1>::new(&set), scene.physics()).unwrap();
    simulation.run(END_TIME, |_| {}).unwrap();
    let engine = simulation.engine();
    let x: Vec<f64> = engine.coordinates(0).unwrap().iter().map(|&x| set.domain().decode(0, x)).collect();
    let velocity = engine.read_all(fields::VELOCITY).unwrap().remove(0);
    let exact = scene.exact().unwrap();
    let due: Vec<f64> = x.iter().map(|x| exact.sample((x - INTERFACE) / END_TIME).velocity).collect();
    l1_error(&velocity, &due, &x, MEASURED).unwrap()
}

/// From a sharp start the error halves with the spacing, as jumps spread over a fixed number of particles allow. From the smoothed start
/// of GS25 (21) it stops at the 5.9e-3 by which that start's own solution differs (`reference/src/exact/finite_volume.rs`).
#[test]
fn sharp_tube_converges_and_the_smoothed_one_stops_at_its_floor() {
    let [coarse, middle, fine] = [100, 200, 400].map(|particles| error(particles, false));
    let orders = [(coarse / middle).log2(), (middle / fine).log2()];
    println!("L1 {coarse:e}, {middle:e}, {fine:e}: orders {orders:?}");
    for order in orders {
        // A smoothing length that lags behind the density had order 0.6; the table in docs/sod.md has 1.0 to 1.1.
        assert!((0.85..1.6).contains(&order), "order {order}");
    }
    // The order says nothing of a factor. 1.355e-2 is recorded; a twentieth lets a change of arithmetic pass, and not one of the scheme.
    let off = (coarse / 1.355e-2 - 1.0).abs();
    assert!(off < 0.05, "{coarse:e} where 1.355e-2 is recorded: off by {off}, margin 0.05");
    let smoothed = error(600, true);
    println!("L1 from the smoothed start {smoothed:e}");
    // It comes from below: 5.4e-3 with 1000 particles, 5.75e-3 with 4000.
    assert!((5.15e-3..7e-3).contains(&smoothed), "{smoothed:e}");
}
