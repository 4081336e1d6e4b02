//! Gas with dust: the sweeps that drag adds, and the three scenes that PL20 and its forerunners try them on.

mod boxes;
#[path = "../support/check.rs"]
mod check;
#[path = "../support/cloud.rs"]
mod cloud;
mod drag_sums;
mod linear_gradients;
mod refusals;
mod shock;
mod species;
mod wave;

use cloud::Recipe;
use etalon_reference::domain::Domain;
use etalon_reference::engine::{Engine, PlainEngine};
use etalon_reference::particles::{Particle, ParticleSet};
use etalon_reference::passes::Physics;
use etalon_reference::pipeline::Pipeline;
use etalon_reference::schemes::{CommonPoint, Drag, DragReconstruction, Rung, SlopeLimiter, Viscosity};

/// A physics with this drag and few neighbours.
fn physics(drag: Drag) -> Physics {
    Physics { neighbours: 50.0, drag: Some(drag), ..Physics::STANDARD }
}

/// The same physics on a rung of C25's ladder.
fn on(rung: Rung, physics: Physics) -> Physics {
    Physics {
        gradients: rung.gradients(),
        volume_element: rung.volume_element(),
        viscosity: Viscosity::of(rung.dissipation()),
        ..physics
    }
}

/// Every reconstruction that conserves, with and without the entropy fix.
fn all_drags(coefficient: f64) -> Vec<Drag> {
    let mut all = vec![Drag { reconstruction: DragReconstruction::NONE, ..Drag::of(coefficient) }];
    for &point in &CommonPoint::ALL[1..] {
        for &limiter in SlopeLimiter::ALL {
            for entropy_fix in [false, true] {
                let reconstruction = DragReconstruction { point, limiter };
                all.push(Drag { reconstruction, entropy_fix, ..Drag::of(coefficient) });
            }
        }
    }
    all
}

/// Two clouds in one periodic box, unequal in everything, the second of them dust.
fn two_clouds<const D: usize>(seed: u64) -> ParticleSet<D> {
    let gas = Recipe::unequal::<D>(seed).particles::<D>(true);
    let dust = Recipe::unequal::<D>(seed + 100).particles::<D>(true);
    together(*gas.domain(), gas.particles(), dust.particles())
}

/// Gas, and then dust.
fn together<const D: usize>(domain: Domain<D>, gas: &[Particle<D>], dust: &[Particle<D>]) -> ParticleSet<D> {
    let cold = dust.iter().map(|p| Particle { internal_energy: 0.0, ..*p });
    let all: Vec<_> = gas.iter().copied().chain(cold).collect();
    let species = (0..all.len()).map(|i| i >= gas.len()).collect();
    ParticleSet::new(domain, all).unwrap().with_dust(species).unwrap()
}

/// The reference engine after one round of all passes.
fn run<const D: usize>(set: &ParticleSet<D>, physics: Physics) -> PlainEngine<f64, D> {
    let mut engine = PlainEngine::<f64, D>::new(set);
    engine.find_neighbours(physics.kernel.support()).unwrap();
    let pipeline = Pipeline::of_scene::<D>(&physics);
    pipeline.start(&mut engine, physics).unwrap();
    pipeline.run(&mut engine, physics).unwrap();
    engine
}
