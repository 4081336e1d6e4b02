//! The sweeps with other gradients and other volume elements than the usual ones: the classic scheme, term by term, and what an integral
//! gradient is better at.

use crate::check::{UNIT, assert_close, gamma};
use crate::cloud::Recipe;
use crate::dual::Dual;
use etalon_kernels_gen::{Real, Symmetric};
use etalon_reference::domain::separation;
use etalon_reference::engine::{Engine, PlainEngine};
use etalon_reference::equations::grad_h::plain_density_derivative_term;
use etalon_reference::equations::kernels::{inverse_volume, kernel_shape};
use etalon_reference::fields;
use etalon_reference::particles::{Particle, ParticleSet};
use etalon_reference::passes::Physics;
use etalon_reference::pipeline::{PassKind, Pipeline};
use etalon_reference::schemes::{Dissipation, GradH, Gradients, Kernel, Viscosity, VolumeElement};

const KERNEL: Kernel = Kernel::MixedSinc;

/// The classic scheme: the kernel's own gradient and standard volumes.
const CLASSIC: Physics = Physics {
    kernel: KERNEL,
    gradients: Gradients::Kernel,
    volume_element: VolumeElement::Standard,
    viscosity: Viscosity::of(Dissipation::Av),
    neighbours: 50.0,
    ..Physics::STANDARD
};

fn run<const D: usize>(set: &ParticleSet<D>, last: PassKind, physics: Physics) -> PlainEngine<f64, D> {
    let mut engine = PlainEngine::<f64, D>::new(set);
    engine.find_neighbours(KERNEL.support()).unwrap();
    Pipeline::leading_to::<D>(last, &physics).run(&mut engine, physics).unwrap();
    engine
}

/// `x_a - x_b` as the engine has it, in a unit box.
fn between<const D: usize>(set: &ParticleSet<D>, a: usize, b: usize) -> [f64; D] {
    let length = set.domain().torus_length();
    std::array::from_fn(|axis| {
        let column = set.coordinates(axis);
        separation(column[a], column[b], length[axis])
    })
}

/// The kernel's value by its smoothing length and squared distance, in any number.
fn w<R: Real, const D: usize>(r_squared: R, h: R) -> R {
    let inverse = R::one() / h;
    kernel_shape::<R, D>(KERNEL, r_squared * inverse * inverse).value * inverse_volume::<R, D>(inverse)
}

/// Its gradient at the first of two particles: `2 x_ab dW/d(r^2)`. The slope is not the kernel's own, but its value's derivative.
fn grad_w<const D: usize>(x_ab: [f64; D], h: f64) -> [f64; D] {
    let r_squared = x_ab.iter().map(|x| x * x).sum();
    let slope = w::<Dual, D>(Dual::variable(r_squared), Dual::lit(h)).slope;
    x_ab.map(|x| 2.0 * x * slope)
}

fn dot<const D: usize>(a: [f64; D], b: [f64; D]) -> f64 {
    a.iter().zip(&b).map(|(a, b)| a * b).sum()
}

/// Sums over n neighbours in two ways: n roundings for the order, some 300 for the kernel, its slope and its powers in either way.
fn sum_error(terms: usize, size: f64) -> f64 {
    2.0 * gamma(terms + 300, UNIT) * size
}

/// Density, volume, Omega in both forms, acceleration and heating of the pressure, as Springel & Hernquist and Monaghan have them, summed here
/// by hand: `rho = sum m W`, `a = -sum m (P_a / (Omega_a rho_a^2) grad W(h_a) + P_b / (Omega_b rho_b^2) grad W(h_b))`.
fn classic_scheme_is_as_in_the_books<const D: usize>(grad_h: GradH) {
    let set = Recipe::unequal::<D>(81).particles::<D>(true);
    let still = Viscosity { alpha: 0.0, beta: 0.0, ..CLASSIC.viscosity };
    let mut engine = run::<D>(&set, PassKind::Momentum, Physics { grad_h, viscosity: still, ..CLASSIC });
    let [density, volume, omega, pressure, heating] =
        [fields::DENSITY, fields::VOLUME, fields::GRAD_H, fields::PRESSURE, fields::ENERGY_RATE]
            .map(|field| engine.read_scalar(field).unwrap());
    let acceleration = engine.read_all(fields::ACCELERATION).unwrap();
    let particles = set.particles();
    let coefficient = |i: usize| pressure[i] / (omega[i] * density[i] * density[i]);
    for a in (0..set.len()).step_by(1 + set.len() / 12) {
        let p: &Particle<D> = &particles[a];
        let what = |quantity: &str| format!("{quantity} of particle {a} in {D}-D, {grad_h}");
        // The density as a function of the smoothing length; the particle itself counts.
        let due = (0..set.len()).fold(Dual::lit(0.0), |sum, b| {
            let x_ab = between(&set, a, b);
            sum + Dual::lit(particles[b].mass)
                * w::<Dual, D>(Dual::lit(dot(x_ab, x_ab)), Dual::variable(p.smoothing_length))
        });
        assert_close(&what("density"), density[a], due.value, sum_error(set.len(), due.value));
        assert_close(&what("volume"), volume[a], p.mass / density[a], 2.0 * UNIT * volume[a]);
        let (mut differences, mut size) = (0.0, 0.0);
        let (mut due_acceleration, mut due_heating) = ([0.0; D], 0.0);
        let (mut acceleration_size, mut heating_size) = (0.0, 0.0);
        for b in (0..set.len()).filter(|b| *b != a) {
            let other = &particles[b];
            let x_ab = between(&set, a, b);
            let v_ab = std::array::from_fn(|i| p.velocity[i] - other.velocity[i]);
            let d_ab = w::<Dual, D>(Dual::lit(dot(x_ab, x_ab)), Dual::variable(p.smoothing_length)).slope;
            differences += plain_density_derivative_term(volume[b], density[b] - density[a], d_ab);
            let own = grad_w(x_ab, p.smoothing_length);
            let theirs = grad_w(x_ab, other.smoothing_length);
            // Value and slope of the kernel cancel in D: its terms are up to some times as large as it.
            size += (density[a] + density[b])
                * volume[b]
                * (d_ab.abs() + D as f64 * w::<f64, D>(dot(x_ab, x_ab), p.smoothing_length) / p.smoothing_length);
            let [from_own, from_theirs] = [coefficient(a), coefficient(b)].map(|c| other.mass * c);
            for axis in 0..D {
                due_acceleration[axis] -= from_own * own[axis] + from_theirs * theirs[axis];
            }
            acceleration_size += from_own.abs() * dot(own, own).sqrt() + from_theirs.abs() * dot(theirs, theirs).sqrt();
            due_heating += from_own * dot(v_ab, own);
            heating_size += from_own.abs() * dot(own, own).sqrt() * dot(v_ab, v_ab).sqrt();
        }
        let derivative = match grad_h {
            GradH::Exact => due.slope,
            GradH::Corrected => differences,
        };
        let of_omega = p.smoothing_length / (D as f64 * density[a]);
        size += density[a] / p.smoothing_length * D as f64;
        assert_close(&what("Omega"), omega[a], 1.0 + of_omega * derivative, of_omega * sum_error(set.len(), size));
        for axis in 0..D {
            let bound = sum_error(set.len(), acceleration_size);
            assert_close(&what("acceleration"), acceleration[axis][a], due_acceleration[axis], bound);
        }
        assert_close(&what("heating"), heating[a], due_heating, sum_error(set.len(), heating_size));
    }
}

#[test]
fn the_classic_scheme_is_as_in_the_books() {
    for grad_h in [GradH::Exact, GradH::Corrected] {
        classic_scheme_is_as_in_the_books::<1>(grad_h);
        classic_scheme_is_as_in_the_books::<2>(grad_h);
        classic_scheme_is_as_in_the_books::<3>(grad_h);
    }
}

/// Omega once more, from the density sweep itself run with other smoothing lengths: a density depends on the particle's own alone.
#[test]
fn exact_omega_of_standard_volumes_is_the_difference_quotient_of_the_density() {
    fn check<const D: usize>() {
        let set = Recipe::unequal::<D>(82).particles::<D>(true);
        let exact = Physics { grad_h: GradH::Exact, ..CLASSIC };
        let density = |factor: f64| {
            let wider = |p: &Particle<D>| Particle { smoothing_length: p.smoothing_length * factor, ..*p };
            let set = ParticleSet::new(*set.domain(), set.particles().iter().map(wider).collect()).unwrap();
            run::<D>(&set, PassKind::Density, exact).read_scalar(fields::DENSITY).unwrap()
        };
        const STEP: f64 = 1e-4;
        let [less, middle, more] = [1.0 - STEP, 1.0, 1.0 + STEP].map(density);
        let omega = run::<D>(&set, PassKind::Gradients, exact).read_scalar(fields::GRAD_H).unwrap();
        let corrected = run::<D>(&set, PassKind::Gradients, CLASSIC).read_scalar(fields::GRAD_H).unwrap();
        let mut apart = 0.0_f64;
        for a in 0..set.len() {
            let due = 1.0 + (more[a] - less[a]) / (2.0 * STEP * D as f64 * middle[a]);
            // The third derivative of a sum of h^-nu w(r/h) is some hundred times it: 100 STEP^2 / 6, with room for ten times that.
            assert_close(&format!("Omega of particle {a} in {D}-D"), omega[a], due, 2e-6);
            apart = apart.max((corrected[a] - due).abs());
        }
        assert!(apart > 0.01, "the corrected form is another number: at most {apart} apart");
    }
    check::<1>();
    check::<2>();
    check::<3>();
}

/// A linear flow on a disordered cloud: integral gradients have its strain rate to rounding, the kernel's own are off by percents; with either
/// volume element.
#[test]
fn linear_flows_are_exact_with_integral_gradients_only() {
    fn worst<const D: usize>(gradients: Gradients, volume_element: VolumeElement) -> f64 {
        let cloud = Recipe { jitter: 0.3, ..Recipe::unequal::<D>(83) }.particles::<D>(false);
        let jacobian = |i: usize, j: usize| if i == j { 1.5 + i as f64 } else { 0.5 - j as f64 };
        let place = |p: &Particle<D>, j| cloud.domain().decode(j, cloud.domain().encode(j, p.position[j]));
        let flowing = |p: &Particle<D>| Particle {
            velocity: std::array::from_fn(|i| 2.0 + (0..D).map(|j| jacobian(i, j) * place(p, j)).sum::<f64>()),
            ..*p
        };
        let set = ParticleSet::new(*cloud.domain(), cloud.particles().iter().map(flowing).collect()).unwrap();
        let physics = Physics { gradients, volume_element, ..CLASSIC };
        let strain = run::<D>(&set, PassKind::VelocityGradients, physics).read_all(fields::STRAIN_RATE).unwrap();
        // Particles whose supports are full: the kernel's own gradient is far off at a surface.
        let inside = |p: &&(usize, &Particle<D>)| p.1.position.iter().all(|x| (0.35..0.65).contains(x));
        let inner: Vec<_> = set.particles().iter().enumerate().collect();
        let mut off = 0.0_f64;
        for &(a, _) in inner.iter().filter(inside) {
            for i in 0..D {
                for j in i..D {
                    let due = 0.5 * (jacobian(i, j) + jacobian(j, i));
                    off = off.max((strain[Symmetric::<f64, D>::position(i, j)][a] - due).abs());
                }
            }
        }
        off
    }
    for &volume_element in VolumeElement::ALL {
        for (dimension, off) in [
            (1, [Gradients::Integral, Gradients::Kernel].map(|g| worst::<1>(g, volume_element))),
            (2, [Gradients::Integral, Gradients::Kernel].map(|g| worst::<2>(g, volume_element))),
            (3, [Gradients::Integral, Gradients::Kernel].map(|g| worst::<3>(g, volume_element))),
        ] {
            println!(
                "{dimension}-D, {volume_element}: off by {:e} with integrals, {:e} with the kernel",
                off[0], off[1]
            );
            // Inside such a cloud the moments' quality is above 0.1: 45,200 u D^2 |J| at the very worst (see the velocity gradients' tests).
            let tolerance = 45_200.0 * 9.0 * 10.0 * UNIT;
            assert!(off[0] < tolerance, "{dimension}-D, {volume_element}: {:e}, tolerance {tolerance:e}", off[0]);
            assert!(
                off[1] > 0.02,
                "{dimension}-D, {volume_element}: the kernel's gradient is off by {:e} only",
                off[1]
            );
        }
    }
}

/// The kernel's velocity gradient is the sum of C25 (4) with `grad W` for `A`.
#[test]
fn velocity_gradients_of_the_kernel_are_the_sum_they_say() {
    fn check<const D: usize>() {
        let set = Recipe::unequal::<D>(84).particles::<D>(true);
        let mut engine = run::<D>(&set, PassKind::VelocityGradients, CLASSIC);
        let volume = engine.read_scalar(fields::VOLUME).unwrap();
        let strain = engine.read_all(fields::STRAIN_RATE).unwrap();
        for (a, p) in set.particles().iter().enumerate().step_by(1 + set.len() / 12) {
            let (mut due, mut size) = ([[0.0; D]; D], 0.0);
            for (b, other) in set.particles().iter().enumerate().filter(|(b, _)| *b != a) {
                let gradient = grad_w(between(&set, a, b), p.smoothing_length);
                for (i, row) in due.iter_mut().enumerate() {
                    for (entry, slope) in row.iter_mut().zip(gradient) {
                        let term = volume[b] * (other.velocity[i] - p.velocity[i]) * slope;
                        *entry += term;
                        size += term.abs();
                    }
                }
            }
            for i in 0..D {
                for j in i..D {
                    let found = strain[Symmetric::<f64, D>::position(i, j)][a];
                    let what = format!("strain rate {i}{j} of particle {a} in {D}-D");
                    assert_close(&what, found, 0.5 * (due[i][j] + due[j][i]), sum_error(set.len(), size));
                }
            }
        }
    }
    check::<1>();
    check::<2>();
    check::<3>();
}
