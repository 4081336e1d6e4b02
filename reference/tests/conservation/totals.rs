//! Total momentum and total energy, for every scheme, with unequal masses and smoothing lengths.

use crate::check::{UNIT, gamma};
use crate::cloud::Recipe;
use crate::pairs::{LastSweep, Pairs, with_last_sweep};
use crate::{all_formulations, all_physics};
use etalon_reference::engine::Engine;
use etalon_reference::fields;
use etalon_reference::particles::ParticleSet;
use etalon_reference::passes::Physics;

/// `sum m a` and `sum m (v . a + du/dt)` are zero to rounding.
///
/// A pair's two contributions differ by at most 12 roundings of their size (see the pairs), some 20 more where they
/// are multiplied with velocities; a particle's sum over n neighbours is off by gamma_n of the sum of magnitudes, and
/// so is the sum over all N particles by gamma_N.
pub fn totals_of_a_cloud_are_kept<P: LastSweep<D>, const D: usize>(cloud: &ParticleSet<D>, physics: Physics) {
    let mut pairs = Pairs::<P, D>::of(cloud, physics);
    let acceleration = pairs.engine.read_all(fields::ACCELERATION).unwrap();
    let heating = pairs.engine.read_scalar(fields::ENERGY_RATE).unwrap();
    let speed = |i: usize| cloud.particles()[i].velocity.iter().map(|v| v * v).sum::<f64>().sqrt();

    let (mut momentum, mut energy) = ([0.0; D], 0.0);
    let (mut momentum_size, mut energy_size, mut moved) = (0.0, 0.0, 0.0);
    let mut most = 0;
    for (a, p) in cloud.particles().iter().enumerate() {
        for axis in 0..D {
            momentum[axis] += p.mass * acceleration[axis][a];
            energy += p.mass * p.velocity[axis] * acceleration[axis][a];
            moved += (p.mass * acceleration[axis][a]).abs();
        }
        energy += p.mass * heating[a];
        let neighbours = pairs.engine.neighbours().of(a);
        most = most.max(neighbours.len());
        for &b in neighbours {
            let size = p.mass * pairs.size(a, b as usize);
            momentum_size += size;
            energy_size += size * (speed(a) + speed(b as usize));
        }
    }
    let Physics { gradients, volume_element, grad_h, viscosity, .. } = physics;
    let what = format!("{D}-D, {}, {grad_h}, {gradients}, {volume_element}", viscosity.dissipation);
    let tolerance = gamma(most + cloud.len() + 12, UNIT) * momentum_size;
    for total in momentum {
        assert!(total.abs() <= tolerance, "{what}: sum m a = {total:e}, tolerance {tolerance:e}");
    }
    let energy_tolerance = gamma(most + D * cloud.len() + 32, UNIT) * energy_size;
    assert!(energy.abs() <= energy_tolerance, "{what}: dE/dt = {energy:e}, tolerance {energy_tolerance:e}");
    // Something did happen: the forces on the particles are not themselves zero.
    assert!(moved > 1e6 * tolerance, "{what}: forces {moved:e} are no larger than the tolerance {tolerance:e}");
    println!("{what}: {:e} and {:e} of the tolerance", momentum[0].abs() / tolerance, energy.abs() / energy_tolerance);
}

fn totals_are_kept<P: LastSweep<D>, const D: usize>(physics: Physics, seed: u64) {
    totals_of_a_cloud_are_kept::<P, D>(&Recipe::unequal::<D>(seed).particles::<D>(true), physics);
}

#[test]
fn momentum_and_energy_are_kept() {
    for physics in all_physics() {
        for seed in [1, 2] {
            with_last_sweep!(physics, totals_are_kept::<1>(physics, seed));
            with_last_sweep!(physics, totals_are_kept::<2>(physics, seed));
            with_last_sweep!(physics, totals_are_kept::<3>(physics, seed));
        }
    }
}

/// The same whatever stands for the kernel's gradient and for the volume: what a pair gives to one it takes from the other. The kernel's gradient is
/// made with fewer roundings than the integral one, and there is no crossed weight with standard volumes.
#[test]
fn momentum_and_energy_are_kept_by_every_formulation() {
    for physics in all_formulations() {
        with_last_sweep!(physics, totals_are_kept::<1>(physics, 3));
        with_last_sweep!(physics, totals_are_kept::<2>(physics, 3));
        with_last_sweep!(physics, totals_are_kept::<3>(physics, 3));
    }
}
