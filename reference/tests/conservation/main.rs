//! What the sweeps must keep whatever the particles: momentum, energy, symmetry of pairs, independence of units, place
//! and order; and finite numbers.

#[path = "../support/check.rs"]
mod check;
#[path = "../support/cloud.rs"]
mod cloud;
mod free_surface;
mod nasty;
mod pairs;
#[path = "../support/records.rs"]
mod records;
mod scaling;
mod symmetry;
mod torque;
mod totals;

use etalon_reference::engine::{Engine, PlainEngine};
use etalon_reference::particles::ParticleSet;
use etalon_reference::passes::Physics;
use etalon_reference::pipeline::Pipeline;
use etalon_reference::schemes::{Dissipation, GradH, Kernel, Viscosity};

/// A scene's physics with the mixed sinc kernel.
fn physics(dissipation: Dissipation, grad_h: GradH) -> Physics {
    let viscosity = Viscosity::of(dissipation);
    Physics {
        kernel: Kernel::MixedSinc,
        grad_h,
        viscosity,
        gamma_minus_one: 2.0 / 3.0,
        neighbours: 50.0,
        ..Physics::STANDARD
    }
}

/// Every scheme with either form of the grad-h factor.
fn all_physics() -> impl Iterator<Item = Physics> {
    let forms = [GradH::Exact, GradH::Corrected];
    Dissipation::ALL.iter().flat_map(move |&dissipation| forms.map(|form| physics(dissipation, form)))
}

/// The reference engine after one round of all passes.
fn run<const D: usize>(set: &ParticleSet<D>, physics: Physics) -> PlainEngine<f64, D> {
    let mut engine = PlainEngine::<f64, D>::new(set);
    run_on(&mut engine, physics);
    engine
}

/// Neighbours and one round of all passes.
fn run_on<const D: usize>(engine: &mut impl Engine<D>, physics: Physics) {
    engine.find_neighbours(physics.kernel.support()).unwrap();
    let pipeline = Pipeline::of_scene::<D>(&physics);
    pipeline.start(engine, physics).unwrap();
    pipeline.run(engine, physics).unwrap();
}
