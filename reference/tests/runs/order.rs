//! The integrator's order, from runs whose steps differ by factors of two.
//!
//! With a second-order method the results of steps `dt`, `dt/2`, `dt/4` differ by four times as much as those of `dt/2` and `dt/4` do.

use etalon_reference::domain::{Domain, separation};
use etalon_reference::engine::{Engine, PlainEngine};
use etalon_reference::fields;
use etalon_reference::particles::{Particle, ParticleSet};
use etalon_reference::passes::Physics;
use etalon_reference::scenes::sod::Sod;
use etalon_reference::schemes::{Dissipation, GradH, Viscosity};
use etalon_reference::simulation::Simulation;
use std::f64::consts::TAU;

/// Positions, velocities and energies at the end.
type State = [Vec<f64>; 3];

/// So many equal steps to `end`; odd ones `uneven` longer than even ones.
fn state_after(set: &ParticleSet<1>, physics: Physics, end: f64, steps: u32, uneven: f64) -> State {
    let mut run = Simulation::new(PlainEngine::<f64, 1>::new(set), physics).unwrap();
    for k in 1..=steps {
        let shift = if k % 2 == 1 { 0.5 * uneven } else { 0.0 };
        let until = end * (f64::from(k) + shift) / f64::from(steps);
        run.step(until).unwrap();
        assert_eq!(run.time(), until, "the step is longer than the flow allows");
    }
    let length = set.domain().torus_length()[0];
    let start = set.coordinates(0);
    let moved = run.engine().coordinates(0).unwrap().into_iter().zip(start).map(|(x, x_0)| separation(x, x_0, length));
    let velocity = run.engine().read_all(fields::VELOCITY).unwrap().concat();
    [moved.collect(), velocity, run.engine().read_scalar(fields::INTERNAL_ENERGY).unwrap()]
}

/// The order that three runs show, for each part of the state.
fn orders(set: &ParticleSet<1>, physics: Physics, end: f64, steps: u32, uneven: f64) -> [f64; 3] {
    let runs = [steps, 2 * steps, 4 * steps].map(|steps| state_after(set, physics, end, steps, uneven));
    let distance = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
    std::array::from_fn(|k| (distance(&runs[0][k], &runs[1][k]) / distance(&runs[1][k], &runs[2][k])).log2())
}

/// The next term of the error is of third order: with steps so short it is a twentieth of the second's, and less. First order is far off.
fn assert_second_order(what: &str, orders: [f64; 3]) {
    println!("{what}: order {:.3} in place, {:.3} in velocity, {:.3} in energy", orders[0], orders[1], orders[2]);
    assert!(orders.iter().all(|order| (order - 2.0).abs() < 0.15), "{what}: orders {orders:?} where 2 is due");
}

/// A periodic wave that steepens: speeds of a third of sound, temperatures that differ by a fifth.
fn wave(physics: &Physics) -> ParticleSet<1> {
    let across = 48;
    let spacing = 1.0 / f64::from(across);
    let particles = (0..across).map(|i| {
        let x = (f64::from(i) + 0.5) * spacing;
        Particle {
            position: [x],
            velocity: [0.3 * (TAU * x).sin()],
            mass: spacing,
            // M4 and its like hold 4 h / V in one dimension.
            smoothing_length: spacing * physics.neighbours / 4.0,
            internal_energy: 1.0 + 0.1 * (TAU * x).cos(),
            mobile: true,
        }
    });
    ParticleSet::new(Domain::new([0.0], [1.0], [true]).unwrap(), particles.collect()).unwrap()
}

#[test]
fn a_smooth_wave_is_integrated_to_second_order() {
    for &dissipation in Dissipation::ALL {
        for &grad_h in GradH::ALL {
            let physics = Physics { viscosity: Viscosity::of(dissipation), grad_h, ..Sod::standard(1).physics() };
            let what = format!("{dissipation}, {grad_h}");
            assert_second_order(&what, orders(&wave(&physics), physics, 0.15, 50, 0.0));
        }
    }
}

/// Without viscosity no maximum has a kink. Steps that alternate show that the smoothing length, which looks one step of the same length
/// ahead, does not lower the order: what it is off in one step it is off the other way in the next.
#[test]
fn neither_kinks_nor_uneven_steps_lower_the_order() {
    let physics = Sod::standard(1).physics();
    let inviscid = Physics { viscosity: Viscosity { alpha: 0.0, beta: 0.0, ..physics.viscosity }, ..physics };
    assert_second_order("no viscosity", orders(&wave(&physics), inviscid, 0.15, 50, 0.0));
    assert_second_order("steps of 1.2 and 0.8", orders(&wave(&physics), physics, 0.15, 60, 0.4));
}

/// The tube's start is sharp in space, not in time. A smoothing length that does not settle at the contact shows here as first order.
#[test]
fn the_shock_tube_is_integrated_to_second_order() {
    let scene = Sod::standard(1).with(|m| m.particles = 60);
    let set = scene.particles::<1>(|_| Ok(Vec::new())).unwrap();
    assert_second_order("shock tube", orders(&set, scene.physics(), 0.1, 400, 0.0));
}
