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
use etalon_reference::particles::{Particle, ParticleSet};
use etalon_reference::passes::Physics;
use etalon_reference::pipeline::Pipeline;
use etalon_reference::schemes::{
    CommonPoint, Dissipation, Drag, DragReconstruction, GradH, Gradients, Kernel, SlopeLimiter, Viscosity,
    VolumeElement,
};

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

/// A last sweep of each kind, and conduction's heat among them, with every way to take gradients and every volume element but the usual two.
fn all_formulations() -> impl Iterator<Item = Physics> {
    let schemes = [Dissipation::Av, Dissipation::AvSwSlr, Dissipation::AvSlrB2];
    let pairs = Gradients::ALL.iter().flat_map(|&g| VolumeElement::ALL.iter().map(move |&v| (g, v)));
    pairs.filter(|pair| *pair != (Gradients::Integral, VolumeElement::Generalised)).flat_map(
        move |(gradients, volume_element)| {
            schemes
                .into_iter()
                .zip([GradH::Exact, GradH::Corrected, GradH::Corrected])
                .map(move |(scheme, form)| Physics { gradients, volume_element, ..physics(scheme, form) })
        },
    )
}

/// Drag without reconstruction, with the recommended one, and with the one that asks most questions.
fn mixtures() -> [Option<Drag>; 3] {
    let plain = Drag { reconstruction: DragReconstruction::NONE, ..Drag::of(2.0) };
    let printed = DragReconstruction { point: CommonPoint::AsPrinted, limiter: SlopeLimiter::Superbee };
    [plain, Drag::of(2.0), Drag { reconstruction: printed, entropy_fix: true, ..Drag::of(2.0) }].map(Some)
}

/// The usual scheme with each of them.
fn all_mixtures() -> impl Iterator<Item = Physics> {
    mixtures().into_iter().map(|drag| Physics { drag, ..physics(Dissipation::AvSlrB2, GradH::Corrected) })
}

/// A cloud of gas, or of gas and, where physics has drag, dust: every third particle.
fn cloud_for<const D: usize>(physics: &Physics, seed: u64) -> ParticleSet<D> {
    let set = cloud::Recipe::unequal::<D>(seed).particles::<D>(true);
    if physics.drag.is_none() {
        return set;
    }
    let dust: Vec<bool> = (0..set.len()).map(|i| i % 3 == 0).collect();
    let cold = |(p, dust): (&Particle<D>, &bool)| match dust {
        true => Particle { internal_energy: 0.0, ..*p },
        false => *p,
    };
    let particles = set.particles().iter().zip(&dust).map(cold).collect();
    ParticleSet::new(*set.domain(), particles).unwrap().with_dust(dust).unwrap()
}

/// Changed particles, of the same species as before.
fn with_species_of<const D: usize>(before: &ParticleSet<D>, changed: ParticleSet<D>) -> ParticleSet<D> {
    match before.dust() {
        Some(dust) => changed.with_dust(dust.to_vec()).unwrap(),
        None => changed,
    }
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
