//! The sweep that makes velocity gradients: strain rate and Balsara's limiter of flows whose gradient is known.

use crate::check::{UNIT, assert_close, gamma};
use crate::cloud::Recipe;
use etalon_kernels_gen::{Component, Symmetric};
use etalon_reference::domain::separation;
use etalon_reference::engine::{Engine, PlainEngine};
use etalon_reference::equations::kernels::kernel_shape;
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
    ..Physics::STANDARD
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
    Pipeline::leading_to::<D>(PassKind::VelocityGradients, &PHYSICS).run(&mut engine, PHYSICS).unwrap();

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

/// `c` is the inverse of `tau = sum V_b x_ba x_ba^T W_ab(h_a)` (C25 2), summed here over all pairs.
///
/// A flow's gradient is `I c` and does not tell: a factor in `tau` that is missing in `I` as well, such as `h^-nu`, goes unseen.
fn gradient_matrix_inverts_the_moments<const D: usize>() {
    let set = Recipe::unequal::<D>(79).particles::<D>(true);
    let mut engine = PlainEngine::<f64, D>::new(&set);
    engine.find_neighbours(2.0).unwrap();
    Pipeline::leading_to::<D>(PassKind::Gradients, &PHYSICS).run(&mut engine, PHYSICS).unwrap();
    let volume = engine.read_scalar(fields::VOLUME).unwrap();
    let columns = engine.read_all(fields::GRADIENT_MATRIX).unwrap();
    let coordinates: [Vec<u64>; D] = std::array::from_fn(|axis| set.coordinates(axis));
    let central = kernel_shape::<f64, D>(PHYSICS.kernel, 0.0).value;
    let mut checked = 0;
    for (a, p) in set.particles().iter().enumerate() {
        let h = p.smoothing_length;
        let mut tau = DMatrix::<f64>::zeros(D, D);
        // What the terms would add up to with the largest weight there is.
        let (mut size, mut neighbours) = (0.0, 0);
        for b in 0..set.len() {
            let x = DMatrix::from_fn(D, 1, |i, _| separation(coordinates[i][b], coordinates[i][a], 1.0));
            let r_squared = x.norm_squared();
            if b != a && r_squared < 4.0 * h * h {
                let weight = kernel_shape::<f64, D>(PHYSICS.kernel, r_squared / (h * h)).value / h.powi(D as i32);
                tau += (&x * x.transpose()) * (volume[b] * weight);
                size += volume[b] * r_squared * central / h.powi(D as i32);
                neighbours += 1;
            }
        }
        let scale = tau.trace() / D as f64;
        let quality = (&tau / scale).determinant();
        if quality < 0.05 {
            continue;
        }
        checked += 1;
        let c = DMatrix::from_fn(D, D, |i, j| columns[Symmetric::<f64, D>::position(i, j)][a]);
        // In units where tau has the trace D, entries of c are below (D / (D-1))^(D-1) / quality <= 2.25 / quality. The inverse by
        // cofactors is good to (20 + 450 / quality) u / quality. Both sums round as often as they have terms and 200 times for
        // q^2 and the kernel, in units of `size`. Then there is the product of two matrices, here.
        let inverse = (20.0 + 450.0 / quality) / quality * UNIT;
        let sums = 2.0 * gamma(neighbours + 200, UNIT) * size / scale * 2.25 / quality;
        let bound = (D * D) as f64 * (inverse + sums + 2.25 / quality * gamma(D, UNIT));
        let product = c * tau;
        for i in 0..D {
            for j in 0..D {
                let what = format!("c tau {i}{j} of particle {a} in {D}-D, quality {quality}");
                assert_close(&what, product[(i, j)], if i == j { 1.0 } else { 0.0 }, bound);
            }
        }
    }
    assert!(checked * 4 > set.len() * 3, "only {checked} of {} particles in {D}-D", set.len());
}

#[test]
fn gradient_matrix_is_the_inverse_of_the_moments() {
    gradient_matrix_inverts_the_moments::<1>();
    gradient_matrix_inverts_the_moments::<2>();
    gradient_matrix_inverts_the_moments::<3>();
}

/// The two third sweeps agree in what they share, to the last bit.
#[test]
fn sweeps_with_and_without_velocities_agree() {
    let set = Recipe::unequal::<2>(67).particles::<2>(true);
    let read = |last| {
        let mut engine = PlainEngine::<f64, 2>::new(&set);
        engine.find_neighbours(2.0).unwrap();
        Pipeline::leading_to::<2>(last, &PHYSICS).run(&mut engine, PHYSICS).unwrap();
        let scalar = |field| Component { field, index: 0 };
        let mut all = engine.read_all(fields::GRADIENT_MATRIX).unwrap();
        all.push(engine.read(scalar(fields::GRAD_H)).unwrap());
        all.push(engine.read(scalar(fields::PRESSURE_COEFFICIENT)).unwrap());
        all
    };
    assert_eq!(read(PassKind::Gradients), read(PassKind::VelocityGradients));
}
