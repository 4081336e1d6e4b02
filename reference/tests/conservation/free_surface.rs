//! Where gas ends: few neighbours, all on one side, a partition of unity far from one, and beyond it next to nothing.

use crate::cloud::Recipe;
use crate::pairs::with_last_sweep;
use crate::totals::totals_of_a_cloud_are_kept;
use crate::{all_physics, run};
use etalon_kernels_gen::components;
use etalon_reference::engine::Engine;
use etalon_reference::fields;
use etalon_reference::particles::{Particle, ParticleSet};
use etalon_reference::passes::Physics;
use etalon_reference::pipeline::Pipeline;

/// A slab across the first axis with vacuum on either side, farther than any support; its outermost layers are a million times lighter.
fn slab<const D: usize>() -> ParticleSet<D> {
    let cloud = Recipe::unequal::<D>(83).particles::<D>(true);
    let (lower, thickness) = (0.25, 0.45);
    let squeezed = cloud.particles().iter().map(|p| {
        let place = p.position[0];
        let mut position = p.position;
        position[0] = lower + thickness * place;
        let outside = !(0.1..=0.9).contains(&place);
        let smoothing_length = p.smoothing_length * thickness.powf(1.0 / D as f64);
        Particle { position, smoothing_length, mass: p.mass * if outside { 1e-6 } else { 1.0 }, ..*p }
    });
    ParticleSet::new(*cloud.domain(), squeezed.collect()).unwrap()
}

fn surface_is_sound<const D: usize>(physics: Physics) {
    let set = slab::<D>();
    with_last_sweep!(physics, totals_of_a_cloud_are_kept::<D>(&set, physics));
    let mut engine = run(&set, physics);
    for component in components(&Pipeline::of_scene::<D>(&physics).fields::<D>(), D) {
        let Ok(values) = engine.read(component) else { continue };
        let bad = values.iter().position(|v| !v.is_finite());
        assert_eq!(bad, None, "{} in {D}-D, {physics:?}", component.name(D));
    }
    // It is the case it is meant to be: contrasts beyond the ramp, and weights that add up to anything but one.
    let density = engine.read_scalar(fields::DENSITY).unwrap();
    let normalisation = engine.read_scalar(fields::KERNEL_NORMALISATION).unwrap();
    let range = |values: &[f64]| values.iter().fold((f64::INFINITY, 0.0_f64), |(l, h), v| (l.min(*v), h.max(*v)));
    let ((thin, dense), (low, high)) = (range(&density), range(&normalisation));
    assert!(dense > 1e3 * thin, "{D}-D: densities from {thin} to {dense}");
    assert!(high > 1.5 * low, "{D}-D: normalisations from {low} to {high}");
}

/// Row 54 of the hard cases: all of it at once.
#[test]
fn a_free_surface_keeps_momentum_and_makes_no_nan() {
    for physics in all_physics() {
        surface_is_sound::<1>(physics);
        surface_is_sound::<2>(physics);
        surface_is_sound::<3>(physics);
    }
}
