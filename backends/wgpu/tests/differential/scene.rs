//! Particles, physics and engines for the tests.

use etalon_kernels_gen::Field;
use etalon_reference::conformance::sets::{self, Difficulty};
use etalon_reference::particles::ParticleSet;
use etalon_reference::passes::Physics;
use etalon_reference::pipeline::Pipeline;
use etalon_reference::scenes::sod::Sod;
use etalon_reference::schemes::{Dissipation, Viscosity};
use etalon_wgpu::{Device, WgpuEngine};

/// The paper's physics with a scheme.
pub fn physics<const D: usize>(dissipation: Dissipation) -> Physics {
    Physics { viscosity: Viscosity::of(dissipation), ..Sod::standard(D).physics() }
}

/// All that a particle carries under this physics.
pub fn all_fields<const D: usize>(physics: &Physics) -> Vec<Field> {
    Pipeline::of_scene::<D>(physics).fields::<D>()
}

/// A few hundred particles, enough for the support to fit the box.
pub fn set<const D: usize>(difficulty: Difficulty, physics: &Physics) -> ParticleSet<D> {
    sets::set(difficulty, [100, 20, 9][D - 1], physics, 7).unwrap()
}

/// Particles on the device.
pub fn engine<const D: usize>(set: &ParticleSet<D>, physics: &Physics, device: &Device) -> WgpuEngine<D> {
    WgpuEngine::new(set, &all_fields::<D>(physics), device.clone()).unwrap()
}
