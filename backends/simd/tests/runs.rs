//! The vector engine follows the reference through time, in single precision. Both precisions are held to it by `etalon run`.

use etalon_kernels_gen::lanes::available_levels;
use etalon_reference::conformance::runs::check_run;
use etalon_reference::conformance::sets::{Difficulty, set};
use etalon_reference::particles::ParticleSet;
use etalon_reference::passes::Physics;
use etalon_reference::pipeline::Pipeline;
use etalon_reference::scenes::dustyshock::DustyShock;
use etalon_reference::scenes::sod::Sod;
use etalon_reference::schemes::{Dissipation, Drag, Viscosity};
use etalon_simd::{LaneEngine, Options};

/// One level is enough: all give the same bits (`same_bits.rs`).
fn follow<const D: usize>(set: &ParticleSet<D>, physics: Physics, until: f64) {
    let fields = Pipeline::of_scene::<D>(&physics).fields::<D>();
    let level = available_levels()[0];
    let engine = LaneEngine::<f32, D>::new(set, &fields, Options { level });
    let distances = check_run::<D, _>(set, physics, engine, until).unwrap();
    for distance in &distances {
        println!("{D}-D: {distance}");
    }
    assert!(distances.iter().all(|distance| distance.holds()), "{D}-D: {distances:?}");
}

#[test]
fn the_shock_tube_in_one_dimension() {
    let scene = Sod::standard(1).with(|m| m.particles = 200);
    let set = scene.particles::<1>(|_| Ok(Vec::new())).unwrap();
    follow::<1>(&set, scene.physics(), 0.05);
}

#[test]
fn the_shock_tube_in_two_dimensions() {
    let scene = Sod::standard(2).with(|m| (m.particles, m.viscosity) = (3000, Viscosity::of(Dissipation::AvSlrB2F)));
    let set = scene.particles::<2>(|_| Ok(Vec::new())).unwrap();
    follow::<2>(&set, scene.physics(), 0.01);
}

/// The tube would need many more particles to be as wide as a support in three dimensions.
#[test]
fn disordered_gas_in_three_dimensions() {
    let physics = Sod::standard(3).physics();
    let set = set::<3>(Difficulty::None, 9, &physics, 3).unwrap();
    follow::<3>(&set, physics, 0.02);
}

/// Dust that streams through gas, with drag reconstructed.
#[test]
fn gas_with_dust_in_one_dimension() {
    let scene = DustyShock { drag: Drag::of(20.0), ..DustyShock::standard(1) };
    follow::<1>(&scene.particles::<1>().unwrap(), scene.physics(), 0.05);
}
