//! C25 (25)-(28): why the grad-h factor is corrected. Nothing is computed from these, but what they say can be tried.

use crate::check::{UNIT, assert_close, gamma};
use crate::cloud::Recipe;
use crate::dual::Dual;
use etalon_kernels_gen::{Real, Symmetric, Vector};
use etalon_reference::domain::separation;
use etalon_reference::engine::{Engine, PlainEngine};
use etalon_reference::equations::gradients::integral_gradient;
use etalon_reference::equations::hydrodynamics::pressure_acceleration;
use etalon_reference::equations::kernels::{inverse_volume, kernel_shape};
use etalon_reference::fields;
use etalon_reference::particles::ParticleSet;
use etalon_reference::passes::Physics;
use etalon_reference::pipeline::{PassKind, Pipeline};
use etalon_reference::schemes::{Dissipation, GradH, Kernel, Viscosity};

/// A disordered gas of equal masses and nearly even density, as subsonic turbulence is.
fn gas() -> ParticleSet<3> {
    let recipe =
        Recipe { across: 9, jitter: 0.175, mass_spread: 1.0, h_spread: 1.0, neighbours: 100.0, support: 2.0, seed: 6 };
    recipe.particles::<3>(true)
}

/// What the expansion is made of, for one form of the factor.
struct Factors {
    set: ParticleSet<3>,
    engine: PlainEngine<f64, 3>,
    place: [Vec<u64>; 3],
    matrices: Vec<Symmetric<f64, 3>>,
    omega: Vec<f64>,
    mean: f64,
    /// `P / rho^2`.
    strength: Vec<f64>,
}

impl Factors {
    fn of(grad_h: GradH) -> Self {
        let set = gas();
        let viscosity = Viscosity::of(Dissipation::Av);
        let physics = Physics {
            kernel: Kernel::MixedSinc,
            grad_h,
            viscosity,
            gamma_minus_one: 0.4,
            neighbours: 100.0,
            ..Physics::STANDARD
        };
        let mut engine = PlainEngine::<f64, 3>::new(&set);
        engine.find_neighbours(2.0).unwrap();
        Pipeline::leading_to::<3>(PassKind::Gradients, &physics).run(&mut engine, physics).unwrap();
        let columns = engine.read_all(fields::GRADIENT_MATRIX).unwrap();
        let [omega, pressure, density] =
            [fields::GRAD_H, fields::PRESSURE, fields::DENSITY].map(|field| engine.read_scalar(field).unwrap());
        Factors {
            place: std::array::from_fn(|axis| set.coordinates(axis)),
            matrices: (0..set.len()).map(|i| Symmetric(std::array::from_fn(|k| columns[k][i]))).collect(),
            mean: omega.iter().sum::<f64>() / omega.len() as f64,
            strength: pressure.iter().zip(&density).map(|(p, rho)| p / (rho * rho)).collect(),
            set,
            engine,
            omega,
        }
    }

    /// `delta Omega / <Omega>` of (25).
    fn scatter(&self, a: usize) -> f64 {
        (self.omega[a] - self.mean) / self.mean
    }

    /// `-sum m_b [Y_a A_ab(h_a) + Y_b A_ab(h_b)]` with any coefficients, and the sum of the magnitudes of its terms.
    fn acceleration(&self, a: usize, coefficient: impl Fn(usize) -> f64) -> (Vector<f64, 3>, f64) {
        let (mut sum, mut size) = (Vector::zero(), 0.0);
        for &b in self.engine.neighbours().of(a) {
            let b = b as usize;
            let x_ba = Vector::from_fn(|axis| separation(self.place[axis][b], self.place[axis][a], 1.0));
            let gradient = |i: usize| {
                let h = self.set.particles()[i].smoothing_length;
                let w = kernel_shape::<f64, 3>(Kernel::MixedSinc, x_ba.norm_squared() / (h * h)).value / h.powi(3);
                integral_gradient(self.matrices[i], x_ba, w)
            };
            let (y_a, y_b, m_b) = (coefficient(a), coefficient(b), self.set.particles()[b].mass);
            let (own, other) = (gradient(a), gradient(b));
            sum = sum + pressure_acceleration(m_b, y_a, y_b, 1.0, own, other);
            size += m_b * (y_a.abs() * own.norm() + y_b.abs() * other.norm());
        }
        (sum, size)
    }
}

/// (25), (26): what the expansion leaves out is `x^2 / (1 + x)` of the whole, `x = delta Omega / <Omega>`. With the other sign of the first order,
/// or `<Omega>` missing once, what is left is of first order.
#[test]
fn expansion_in_the_scatter_is_right_to_second_order() {
    for form in [GradH::Exact, GradH::Corrected] {
        let f = Factors::of(form);
        let total: f64 = (0..f.omega.len()).map(|a| f.scatter(a)).sum();
        assert_close("sum of the scatter", total, 0.0, 3.0 * gamma(730, UNIT) * 730.0);
        let mut largest = 0.0_f64;
        for a in 0..f.omega.len() {
            let x = f.scatter(a);
            let whole = f.strength[a] / f.omega[a];
            let plain = f.strength[a] / f.mean;
            let left_out = whole - plain * (1.0 - x);
            assert_close("rest of (26)", left_out, plain * x * x / (1.0 + x), 12.0 * UNIT * plain);
            largest = largest.max(x.abs());
        }
        assert!(largest > 0.02, "{form}: no scatter, no test ({largest})");
    }
}

/// (27): the noise the scatter adds to the acceleration, with a plus. What is left over is of second order, exactly the rest of (26) in place
/// of the coefficients; and the exact factor's noise is more than twice the corrected one's.
#[test]
fn scatter_of_the_factor_acts_as_a_noisy_acceleration() {
    let noise_of = |form| {
        let f = Factors::of(form);
        let (mut noise, mut rest, mut count) = (0.0, 0.0, 0.0);
        for a in (0..f.omega.len()).step_by(9) {
            let (with_scatter, size) = f.acceleration(a, |i| f.strength[i] / f.omega[i]);
            let (with_mean, _) = f.acceleration(a, |i| f.strength[i] / f.mean);
            // (27) has a plus where `pressure_acceleration` has a minus.
            let (negative, _) = f.acceleration(a, |i| f.strength[i] / f.mean * f.scatter(i));
            let as_said = -negative;
            let second = |i: usize| f.strength[i] / f.mean * f.scatter(i).powi(2) / (1.0 + f.scatter(i));
            let (left_over, _) = f.acceleration(a, second);
            let difference = with_scatter - with_mean;
            for axis in 0..3 {
                // Four sums of 200 terms of that size.
                let bound = 4.0 * gamma(230, UNIT) * size;
                assert_close("rest of (27)", difference[axis] - as_said[axis], left_over[axis], bound);
            }
            noise += as_said.norm_squared();
            rest += left_over.norm_squared();
            count += 1.0;
        }
        let (noise, rest) = (f64::sqrt(noise / count), f64::sqrt(rest / count));
        println!("{form}: rms noise {noise}, rest {rest}");
        assert!(rest < 0.2 * noise, "{form}: (27) is not the most of it: {noise} and {rest} more");
        noise
    };
    let (exact, corrected) = (noise_of(GradH::Exact), noise_of(GradH::Corrected));
    // The factors scatter by 0.0564 and 0.0158.
    assert!(corrected < 0.5 * exact, "noise {corrected} of the corrected factor, {exact} of the exact one");
}

/// The biased mean, by itself, is a constant factor of all pressure forces and no noise (C25 appendix B).
#[test]
fn mean_of_the_factor_scales_the_pressure_force() {
    let f = Factors::of(GradH::Exact);
    for a in (0..f.omega.len()).step_by(50) {
        let (unbiased, size) = f.acceleration(a, |i| f.strength[i]);
        let (biased, _) = f.acceleration(a, |i| f.strength[i] / f.mean);
        for axis in 0..3 {
            assert_close("biased force", biased[axis] * f.mean, unbiased[axis], 2.0 * gamma(220, UNIT) * size);
        }
    }
}

/// (28), for sums over a neighbourhood with any scalar: differentiated as a product it gives the derivative of the density.
#[test]
fn product_rule_gives_the_derivative_for_any_scalar() {
    let f = Factors::of(GradH::Exact);
    for a in (0..f.omega.len()).step_by(100) {
        let members: Vec<usize> =
            f.engine.neighbours().of(a).iter().map(|b| *b as usize).chain(std::iter::once(a)).collect();
        let sum = |of: &dyn Fn(usize) -> f64| {
            let inverse = Dual::lit(1.0) / Dual::variable(f.set.particles()[a].smoothing_length);
            members.iter().fold(Dual::lit(0.0), |sum, &b| {
                let x = Vector::<f64, 3>::from_fn(|axis| separation(f.place[axis][b], f.place[axis][a], 1.0));
                let q_squared = Dual::lit(x.norm_squared()) * inverse * inverse;
                let w = kernel_shape::<Dual, 3>(Kernel::MixedSinc, q_squared).value;
                sum + Dual::lit(of(b)) * w * inverse_volume::<Dual, 3>(inverse)
            })
        };
        let rho = sum(&|b| f.set.particles()[b].mass);
        for scalar in [|_| 1.0, |b: usize| 1.0 + (b % 7) as f64, |b: usize| 0.3 + (b % 3) as f64] {
            let phi = sum(&|b| f.set.particles()[b].mass * scalar(b));
            let product = phi * rho;
            let due = (product.slope - rho.value * phi.slope) / phi.value;
            let size = (product.slope.abs() + (rho.value * phi.slope).abs()) / phi.value;
            assert_close("d(rho)/dh", rho.slope, due, 8.0 * UNIT * size);
            assert!(phi.slope.abs() > 1e-3 * phi.value, "a scalar that does not change says nothing");
        }
    }
}
