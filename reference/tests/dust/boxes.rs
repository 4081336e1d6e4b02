//! DUSTYBOX in one, two and three dimensions.

use crate::on;
use etalon_kernels_gen::Component;
use etalon_reference::engine::{Engine, PlainEngine};
use etalon_reference::equations::double_hump::double_hump;
use etalon_reference::fields;
use etalon_reference::passes::Physics;
use etalon_reference::scenes::dustybox::DustyBox;
use etalon_reference::schemes::{Drag, DragReconstruction, Rung};
use etalon_reference::simulation::Simulation;

/// What a lattice makes of `nu int (r_x/r)^2 D dV = 1`, for a particle `shift` spacings beside it along x: least and most over all shifts.
fn lattice_factor<const D: usize>(scene: &DustyBox, h_in_spacings: f64) -> [f64; 2] {
    let reach = (scene.kernel.support() * h_in_spacings).ceil() as i64 + 1;
    let side = (2 * reach + 1) as usize;
    let factor = |shift: f64| {
        let terms = (0..side.pow(D as u32)).map(|i| {
            let r: [f64; D] = std::array::from_fn(|axis| {
                let place = (i / side.pow(axis as u32) % side) as f64 - reach as f64;
                if axis == 0 { place + shift } else { place }
            });
            let r_squared: f64 = r.iter().map(|x| x * x).sum();
            let hump = double_hump::<f64, D>(scene.kernel, r_squared / (h_in_spacings * h_in_spacings));
            if r_squared > 0.0 { D as f64 * hump * r[0] * r[0] / r_squared } else { 0.0 }
        });
        terms.sum::<f64>() / h_in_spacings.powi(D as i32)
    };
    let all: Vec<f64> = (0..=20).map(|k| factor(f64::from(k) / 20.0)).collect();
    [all.iter().copied().fold(f64::INFINITY, f64::min), all.iter().copied().fold(0.0, f64::max)]
}

/// The difference decays at the rate that the lattice's own sum gives, which is within a few per cent of the exact one, and to the integrator's error.
///
/// All particles of a species see the same, so that their equation is that of the exact solution with another rate: `f (rho / rho_SPH)^2 / t_s`, `f`
/// between the least and the most that the lattice makes as it is passed. A step with the forces of foretold velocities has a factor `1 - z + z^2/2 +
/// z^3/4 + O(z^4)` for `z = dt / t_s`, so that a decay by `e^-z` is off by `(1/4 + 1/6) z^3`, over a time `t` by `(5/12) z^2 t / t_s`; twice that
/// leaves room for the next order.
fn decays<const D: usize>(scene: DustyBox, until: f64) {
    decays_with::<D>(scene, scene.physics(), until);
}

/// The same with another physics than the scene's own.
fn decays_with<const D: usize>(scene: DustyBox, physics: Physics, until: f64) {
    let set = scene.particles::<D>().unwrap();
    let half = set.len() / 2;
    let mut simulation = Simulation::new(PlainEngine::<f64, D>::new(&set), physics).unwrap();
    let mut longest = 0.0_f64;
    while simulation.time() < until {
        longest = longest.max(simulation.step(until).unwrap());
    }
    let engine = simulation.engine();
    let read = |engine: &mut PlainEngine<f64, D>, field| engine.read_all(field).unwrap();
    let velocity = read(engine, fields::VELOCITY);
    let density = engine.read_scalar(fields::DENSITY).unwrap();
    let h = engine.read_scalar(fields::SMOOTHING_LENGTH).unwrap();
    let spread = |values: &[f64]| {
        let low = values.iter().copied().fold(f64::INFINITY, f64::min);
        let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        (0.5 * (low + high), high - low)
    };
    let ((gas, gas_spread), (dust, dust_spread)) = (spread(&velocity[0][..half]), spread(&velocity[0][half..]));
    // All particles of a species are alike, but for the grid of places; nothing happens across.
    assert!(gas_spread + dust_spread < 1e-8, "{D}-D: velocities differ by {gas_spread:e} and {dust_spread:e}");
    assert!(velocity[1..].iter().flatten().all(|v| v.abs() < 1e-8), "{D}-D: something moves across");

    let exact = scene.exact().unwrap();
    let rate = scene.drag.coefficient * (1.0 / scene.gas_density + 1.0 / scene.dust_density);
    let [least, most] = lattice_factor::<D>(&scene, h[0] * scene.across as f64);
    // A volume is m / rho, the same lattice for both.
    let rarer = (scene.gas_density / density[0]) * (scene.dust_density / density[half]);
    let z_squared = (longest * rate).powi(2);
    let integrator = 2.0 * (5.0 / 12.0) * z_squared;
    let found = (scene.gas_velocity - scene.dust_velocity) / (gas - dust);
    let relative = found.ln() / (until * rate);
    println!(
        "{D}-D: the rate is {relative:.6} of the exact one; the lattice's {:.6} to {:.6}, integrator {integrator:.1e}",
        least * rarer,
        most * rarer
    );
    assert!(
        relative > least * rarer - integrator && relative < most * rarer + integrator,
        "{D}-D: the difference decays {relative} times as fast as exactly; the lattice makes {} to {}, the integrator {integrator:e}",
        least * rarer,
        most * rarer
    );
    // The lattice itself is within this of the continuum.
    assert!((least * rarer - 1.0).abs() < 0.05 && (most * rarer - 1.0).abs() < 0.05, "{D}-D: {least} to {most}");

    // Momentum to rounding, over all steps; the heat to what the rate is off.
    let mass = engine.read_scalar(fields::MASS).unwrap();
    let energy = engine.read_scalar(fields::INTERNAL_ENERGY).unwrap();
    let start = set.particles();
    let moved: f64 = (0..set.len()).map(|i| mass[i] * (velocity[0][i] - start[i].velocity[0])).sum();
    assert!(moved.abs() < 1e-12, "{D}-D: momentum has changed by {moved:e}");
    let heat: f64 = (0..set.len()).map(|i| mass[i] * (energy[i] - start[i].internal_energy)).sum();
    let due = exact.heat(until);
    println!("{D}-D: heat {heat:.6}, exact {due:.6}");
    let lost: f64 =
        (0..set.len()).map(|i| 0.5 * mass[i] * (start[i].velocity[0].powi(2) - velocity[0][i].powi(2))).sum();
    // What the motion lost is what the gas gained, but for foretold velocities in the heating: a share of z^2 / 4, by the same expansion.
    let tolerance = 2.0 * 0.25 * z_squared * due;
    assert!((heat - lost).abs() < tolerance, "{D}-D: {heat} gained, {lost} lost, tolerance {tolerance:e}");
    assert!((heat / due - 1.0).abs() < 0.05, "{D}-D: heat {heat}, exact {due}");
}

/// Gradients and volume elements are none of drag's business where nothing varies.
#[test]
fn the_difference_decays_on_every_rung_of_the_ladder() {
    for &rung in Rung::ALL {
        let scene = DustyBox { across: 32, ..DustyBox::standard(1) };
        decays_with::<1>(scene, on(rung, scene.physics()), 0.5);
    }
    let scene = DustyBox { across: 12, ..DustyBox::standard(2) };
    decays_with::<2>(scene, on(Rung::Standard, scene.physics()), 0.2);
}

#[test]
fn the_difference_decays_in_one_dimension() {
    for shift in [0.0, 0.5] {
        decays::<1>(DustyBox { across: 32, shift, ..DustyBox::standard(1) }, 1.0);
    }
    // Twice as much dust, a third of the gas, no reconstruction: in a uniform flow there is nothing to reconstruct.
    let drag = Drag { reconstruction: DragReconstruction::NONE, ..Drag::of(0.2) };
    decays::<1>(
        DustyBox { across: 32, gas_density: 0.3, dust_density: 2.0, gas_velocity: 0.4, drag, ..DustyBox::standard(1) },
        1.0,
    );
}

#[test]
fn the_difference_decays_in_two_dimensions() {
    decays::<2>(DustyBox { across: 12, shift: 0.5, ..DustyBox::standard(2) }, 0.4);
}

#[test]
fn the_difference_decays_in_three_dimensions() {
    decays::<3>(DustyBox { across: 7, ..DustyBox::standard(3) }, 0.15);
}

/// Under drag so strong that a step of a Courant time would be twenty stopping times long both end with the common velocity.
#[test]
fn strong_drag_ends_at_the_common_velocity() {
    let scene = DustyBox { across: 16, drag: Drag::of(1000.0), ..DustyBox::standard(1) };
    let set = scene.particles::<1>().unwrap();
    let mut simulation = Simulation::new(PlainEngine::<f64, 1>::new(&set), scene.physics()).unwrap();
    simulation.run(0.05, |_| {}).unwrap();
    // A hundred stopping times in steps of 0.9: the larger factor of two successive steps is 0.87, to the power 111.
    assert!(simulation.steps() > 100, "{} steps", simulation.steps());
    let velocity = simulation.engine().read(Component { field: fields::VELOCITY, index: 0 }).unwrap();
    assert!(velocity.iter().all(|v| (v - 0.5).abs() < 1e-5), "{velocity:?}");
}
