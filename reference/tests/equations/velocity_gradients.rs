//! The sweep that makes velocity gradients: strain rate and Balsara's limiter of flows whose gradient is known.

use crate::check::{UNIT, assert_close};
use crate::cloud::Recipe;
use etalon_kernels_gen::{Component, Symmetric};
use etalon_reference::engine::{Engine, PlainEngine};
use etalon_reference::fields;
use etalon_reference::particles::{Particle, ParticleSet};
use etalon_reference::passes::Physics;
use etalon_reference::pipeline::{PassKind, Pipeline};
use etalon_reference::schemes::{Dissipation, GradH, Kernel, Viscosity};
use nalgebra::DMatrix;

const PHYSICS: Physics = Physics {
    kernel: Kernel::MixedSinc,
    grad_h: GradH::Corrected,
    viscosity: Viscosity::of(Dissipation::AvSlrB2),
    gamma_minus_one: 2.0 / 3.0,
    neighbours: 50.0,
};

/// The velocity gradient of a linear flow with an offset, on an open cloud unequal in everything.
fn flow_is_recovered<const D: usize>(jacobian: [[f64; D]; D]) {
    let cloud = Recipe { jitter: 0.5, ..Recipe::unequal::<D>(61) }.particles::<D>(false);
    // Where the particles are once encoded.
    let place = |p: &Particle<D>, axis| cloud.domain().decode(axis, cloud.domain().encode(axis, p.position[axis]));
    let linear = |p: &Particle<D>| Particle {
        velocity: std::array::from_fn(|i| 3.0 + (0..D).map(|j| jacobian[i][j] * place(p, j)).sum::<f64>()),
        ..*p
    };
    let set = ParticleSet::new(*cloud.domain(), cloud.particles().iter().map(linear).collect()).unwrap();
    let mut engine = PlainEngine::<f64, D>::new(&set);
    engine.find_neighbours(2.0).unwrap();
    Pipeline::leading_to::<D>(PassKind::VelocityGradients).run(&mut engine, PHYSICS).unwrap();

    let divergence: f64 = (0..D).map(|i| jacobian[i][i]).sum();
    let rotation = |i: usize, j: usize| (jacobian[i][j] - jacobian[j][i]).powi(2);
    let curl = (0..D).flat_map(|i| (0..i).map(move |j| (i, j))).map(|(i, j)| rotation(i, j)).sum::<f64>().sqrt();
    let strain = engine.read_all(fields::STRAIN_RATE).unwrap();
    let c = engine.read_all(fields::GRADIENT_MATRIX).unwrap();
    let balsara = engine.read_scalar(fields::BALSARA).unwrap();
    let mut checked = 0;
    for (a, p) in set.particles().iter().enumerate() {
        let inverse = DMatrix::from_fn(D, D, |i, j| c[Symmetric::<f64, D>::position(i, j)][a]);
        let Some(tau) = inverse.try_inverse() else { continue };
        let quality = (&tau * (D as f64 / tau.trace())).determinant();
        if quality < 0.05 {
            continue;
        }
        checked += 1;
        // As for a gradient by itself: the inverse by cofactors is good to (20 + 450 / quality) u / quality in units
        // where tau has the trace D, the gradient is c times sums of size |tau| |J|, |J| < 10; velocities are rounded
        // at 10 and enter with sum V |A| < 10 / h.
        let from_inverse = (D * D) as f64 * 10.0 * (20.0 + 450.0 / quality) / quality * UNIT;
        let bound = from_inverse + 10.0 * UNIT * 10.0 / p.smoothing_length;
        for i in 0..D {
            for j in i..D {
                let due = 0.5 * (jacobian[i][j] + jacobian[j][i]);
                let what = format!("strain rate {i}{j} of particle {a} in {D}-D, quality {quality}");
                assert_close(&what, strain[Symmetric::<f64, D>::position(i, j)][a], due, bound);
            }
        }
        let sound = (10.0 / 9.0 * p.internal_energy).sqrt();
        let due = divergence.abs() / (divergence.abs() + curl + 1e-4 * sound / p.smoothing_length);
        // Numerator and denominator are sums of up to nine entries.
        let bound = 18.0 * bound / divergence.abs();
        assert_close(&format!("Balsara factor of particle {a} in {D}-D"), balsara[a], due, bound);
    }
    assert!(checked * 4 > set.len() * 3, "only {checked} of {} particles in {D}-D", set.len());
}

#[test]
fn linear_flows_have_their_strain_rate_and_balsara_factor() {
    flow_is_recovered([[-2.5]]);
    flow_is_recovered([[1.0, -2.0], [3.0, 0.5]]);
    flow_is_recovered([[1.0, -2.0, 0.5], [3.0, 0.25, -1.5], [4.0, 2.0, -3.0]]);
    // One component of the curl at a time.
    flow_is_recovered([[1.0, 2.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]]);
    flow_is_recovered([[1.0, 0.0, 2.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]]);
    flow_is_recovered([[1.0, 0.0, 0.0], [0.0, 0.0, 2.0], [0.0, 0.0, 0.0]]);
}

/// The two third sweeps agree in what they share, to the last bit.
#[test]
fn sweeps_with_and_without_velocities_agree() {
    let set = Recipe::unequal::<2>(67).particles::<2>(true);
    let read = |last| {
        let mut engine = PlainEngine::<f64, 2>::new(&set);
        engine.find_neighbours(2.0).unwrap();
        Pipeline::leading_to::<2>(last).run(&mut engine, PHYSICS).unwrap();
        let scalar = |field| Component { field, index: 0 };
        let mut all = engine.read_all(fields::GRADIENT_MATRIX).unwrap();
        all.push(engine.read(scalar(fields::GRAD_H)).unwrap());
        all.push(engine.read(scalar(fields::PRESSURE_COEFFICIENT)).unwrap());
        all
    };
    assert_eq!(read(PassKind::Gradients), read(PassKind::VelocityGradients));
}
