//! Inputs on which a formula as it stands in a book loses its digits or its head. `docs/hard-cases.md` has the list, with the checks of other files.
//!
//! Most checks here try the textbook form too and ask that it fails: else they would not notice anything.

use crate::check::{UNIT, assert_close, gamma};
use crate::float::Float;
use etalon_kernels_gen::{Component, Matrix, Symmetric, Vector};
use etalon_reference::domain::{Domain, separation};
use etalon_reference::engine::{Engine, PlainEngine, Scalar};
use etalon_reference::equations::dissipation::approach_velocity;
use etalon_reference::equations::equation_of_state::{pressure, sound_speed};
use etalon_reference::equations::gradients::inverse_moments;
use etalon_reference::equations::hydrodynamics::{crossed_weight, pressure_coefficient};
use etalon_reference::equations::kernels::{central_value, kernel_shape, sinc_half_pi};
use etalon_reference::equations::reconstruction::{
    critical_separation, reconstructed_approach_velocity, short_range_factor, slope_limiter,
};
use etalon_reference::equations::switch::{decay_rate, decayed_coefficient, local_coefficient, raised_coefficient};
use etalon_reference::fields;
use etalon_reference::particles::{Particle, ParticleSet};
use etalon_reference::passes::{Density, KickDrift, Physics, VelocityGradients, VolumeElements};
use etalon_reference::schemes::{Dissipation, GradH, Kernel, Viscosity};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use std::f64::consts::{FRAC_PI_2, PI};

/// What the fitted polynomials add in single precision: nine times the slope's 5.35e-9.
fn fit<T: Float>() -> f64 {
    if T::UNIT > UNIT { 9.0 * 5.35e-9 } else { 0.0 }
}

/// `s'(x) / x` of `s = sin x / x` by its series, good for small `x`: `sum (-1)^k 2k x^(2k-2) / (2k+1)!`.
fn sinc_slope_over_x(x: f64) -> f64 {
    let mut factorial = 1.0;
    (1..12).fold(0.0, |sum, k| {
        factorial *= f64::from(2 * k) * f64::from(2 * k + 1);
        sum + if k % 2 == 0 { 1.0 } else { -1.0 } * f64::from(2 * k) * x.powi(2 * k - 2) / factorial
    })
}

fn slope_near_the_centre<T: Float, const D: usize>() {
    let centre = kernel_shape::<f64, D>(Kernel::MixedSinc, 0.0);
    // w(0) = a + b and w'/q(0) = -(4 a + 9 b) pi^2 / 12 tell the weights of the two members.
    let (sum, slopes) = (centre.value, -centre.slope_over_q * 12.0 / (PI * PI));
    let (b, a) = ((slopes - 4.0 * sum) / 5.0, (9.0 * sum - slopes) / 5.0);
    for q in [0.0, 1e-30, 1e-10, 1e-6, 1e-4, 1e-3, 1e-2, 0.02, 0.1, 0.25, 0.3] {
        let q_squared = T::lit(q * q);
        let x = FRAC_PI_2 * q_squared.to_f64().sqrt();
        let s = if x == 0.0 { 1.0 } else { x.sin() / x };
        let due = (4.0 * a * s.powi(3) + 9.0 * b * s.powi(8)) * sinc_slope_over_x(x) * FRAC_PI_2 * FRAC_PI_2;
        let got = kernel_shape::<T, D>(Kernel::MixedSinc, q_squared).slope_over_q.to_f64();
        // The kernel's 117 roundings (see its budget), as many for the weights found here in double precision.
        let bound = (gamma(117, T::UNIT) + 10.0 * gamma(117, UNIT) + fit::<T>()) * due.abs();
        assert_close(&format!("w'/q at {q:e} in {D}-D"), got, due, bound);
    }
}

/// Rows 2 and 3: the slope at small distances, where the difference of a cosine and a sinc, or a cotangent, has no digit left.
#[test]
fn slope_keeps_its_digits_near_the_centre() {
    slope_near_the_centre::<f64, 1>();
    slope_near_the_centre::<f64, 2>();
    slope_near_the_centre::<f64, 3>();
    slope_near_the_centre::<f32, 1>();
    slope_near_the_centre::<f32, 2>();
    slope_near_the_centre::<f32, 3>();
    let x = std::f32::consts::FRAC_PI_2 * 1e-4;
    let textbook = (x.cos() - x.sin() / x) / x / x;
    let cotangent = (1.0 / x.tan() - 1.0 / x) / x;
    for wrong in [textbook, cotangent] {
        assert!((f64::from(wrong) * -3.0 - 1.0).abs() > 0.1, "the textbook's form is good after all: {wrong}");
    }
}

fn sinc_near_the_edge<T: Float>(smallest: i32) {
    for exponent in 1..=smallest {
        let depth = 2_f64.powi(-exponent);
        // sin(pi sqrt t) = sin(pi (1 - sqrt t)), and 1 - sqrt t without a difference.
        let short = depth / (1.0 + (1.0 - depth).sqrt());
        let due = (PI * short).sin() / (PI * (1.0 - short));
        let (got, _) = sinc_half_pi(T::lit(1.0 - depth));
        let bound = (14.0 * T::UNIT + if T::UNIT > UNIT { 1.96e-10 } else { 0.0 }) * due;
        assert_close(&format!("sinc at t = 1 - {depth:e}"), got.to_f64(), due, bound);
    }
}

/// Rows 1 and 4: one at the centre; full *relative* accuracy down to the last number before the edge; nothing beyond.
#[test]
fn sinc_keeps_its_digits_to_the_edge() {
    sinc_near_the_edge::<f64>(52);
    sinc_near_the_edge::<f32>(23);
    assert_eq!((sinc_half_pi(0.0_f64).0, sinc_half_pi(0.0_f32).0), (1.0, 1.0));
    assert_eq!((sinc_half_pi(1.0_f64).0, sinc_half_pi(1.0_f32).0), (0.0, 0.0));
    let t = 1.0 - 2_f32.powi(-20);
    let x = std::f32::consts::PI * t.sqrt();
    let (textbook, good) = (x.sin() / x, sinc_half_pi(t).0);
    assert!((textbook / good - 1.0).abs() > 0.01, "the textbook's form is good after all: {textbook}, {good}");
}

/// Row 6: splines as truncated powers.
#[test]
fn splines_keep_their_digits_at_the_edge() {
    for q in [2.5, 2.9, 2.99, 2.999] {
        let q_squared = (q * q) as f32;
        let exact = f64::from(q_squared).sqrt();
        let due = (3.0 - exact).powi(5) / (120.0 * PI);
        let got = f64::from(kernel_shape::<f32, 3>(Kernel::QuinticSpline, q_squared).value);
        // The root of q^2 is off by u of 3, five times in a power of 3 - q; 25 roundings of the rest.
        let bound = gamma(25, f32::UNIT) + 5.0 * 3.0 * f32::UNIT / (3.0 - exact);
        assert_close(&format!("M6 at {q}"), got / due, 1.0, bound);
        if q > 2.95 {
            let x = q_squared.sqrt();
            let expanded = 243.0 - x * (405.0 - x * (270.0 - x * (90.0 - x * (15.0 - x))));
            let wrong = f64::from(expanded) / (120.0 * PI) / due;
            assert!((wrong - 1.0).abs() > 0.5, "the expanded polynomial is good after all at {q}: {wrong}");
        }
    }
    for q in [1.9, 1.99, 1.999] {
        let q_squared = (q * q) as f32;
        let exact = f64::from(q_squared).sqrt();
        let due = (2.0 - exact).powi(3) / (4.0 * PI);
        let got = f64::from(kernel_shape::<f32, 3>(Kernel::CubicSpline, q_squared).value);
        let bound = gamma(25, f32::UNIT) + 3.0 * 2.0 * f32::UNIT / (2.0 - exact);
        assert_close(&format!("M4 at {q}"), got / due, 1.0, bound);
    }
}

fn particle<const D: usize>(position: [f64; D], h: f64) -> Particle<D> {
    Particle { position, velocity: [0.0; D], mass: 0.7, smoothing_length: h, internal_energy: 1.5, mobile: true }
}

fn engine_with<const D: usize>(particles: Vec<Particle<D>>) -> PlainEngine<f64, D> {
    let domain = Domain::new([0.0; D], [1.0; D], [true; D]).unwrap();
    PlainEngine::new(&ParticleSet::new(domain, particles).unwrap())
}

/// Row 11: at half the box a separation has no sign, so nobody may be a neighbour there; and a support that reaches farther, so that a particle
/// would be a neighbour twice, is refused.
#[test]
fn half_the_box_away_is_nobodys_neighbour() {
    let mut engine = engine_with(vec![particle([0.125, 0.5], 0.25), particle([0.625, 0.5], 0.25)]);
    engine.find_neighbours(2.0).unwrap();
    assert_eq!((engine.neighbours().of(0).len(), engine.neighbours().of(1).len()), (0, 0));
    let (a, b) = (1_u64 << 61, 5_u64 << 61);
    assert_eq!((separation(a, b, 1.0), separation(b, a, 1.0)), (-0.5, -0.5), "the one place without a sign");
    assert_eq!(separation(a, b - 1, 1.0), -separation(b - 1, a, 1.0));
    let mut engine = engine_with(vec![particle([0.125, 0.5], 0.25), particle([0.625, 0.5], 0.251)]);
    let refused = engine.find_neighbours(2.0).unwrap_err().to_string();
    assert!(refused.contains("use more particles or fewer neighbours"), "{refused}");
}

/// Row 13, in single precision: squares of 1e-7 to the third power would be denormal, those of 1e8 infinite.
#[test]
fn moments_of_any_size_have_an_inverse_in_single_precision() {
    let tau = Symmetric::<f32, 3>([2.0, 0.5, -0.25, 1.0, 0.125, 1.5]);
    let c = inverse_moments(tau);
    for exponent in [-100, -46, -20, 20, 52, 100] {
        let factor = 2_f32.powi(exponent);
        assert_eq!(inverse_moments(tau.scale(factor)).scale(factor), c, "2^{exponent}");
    }
    let tiny = 1e-14_f32;
    assert!(tiny.powi(3) < f32::MIN_POSITIVE, "the determinant itself would be lost");
}

/// A neighbourhood that is `thickness` as thick as wide.
fn slab<T: Float>(thickness: f64, random: &mut Pcg64Mcg) -> Symmetric<T, 3> {
    let mut tau = [0.0; 6];
    // Tilted, so that nothing is zero.
    let tilt = |[x, y, z]: [f64; 3]| {
        [0.8 * x + 0.6 * z, 0.6 * (0.6 * x - 0.8 * z) + 0.8 * y, 0.8 * (0.6 * x - 0.8 * z) - 0.6 * y]
    };
    for _ in 0..40 {
        let mut next = || 2.0 * random.random::<f64>() - 1.0;
        let x = tilt([next(), next(), thickness * next()]);
        let mut entry = tau.iter_mut();
        for i in 0..3 {
            for j in i..3 {
                *entry.next().unwrap() += x[i] * x[j];
            }
        }
    }
    Symmetric(tau.map(T::lit))
}

fn inverse_stays_positive<T: Float>() {
    let mut random = Pcg64Mcg::seed_from_u64(13);
    for exponent in 0..=12 {
        for _ in 0..20 {
            let c = inverse_moments(slab::<T>(10_f64.powi(-exponent), &mut random));
            for _ in 0..50 {
                let x = Vector::<T, 3>::from_fn(|_| T::lit(2.0 * random.random::<f64>() - 1.0));
                let form = c.quadratic_form(x).to_f64();
                assert!(form.is_finite() && form > 0.0, "thickness 1e-{exponent}: x c x = {form:e}");
            }
        }
    }
}

/// Row 14: the determinant of a nearly flat neighbourhood has lost its sign to rounding; its inverse must not.
#[test]
fn inverse_of_a_nearly_flat_neighbourhood_stays_positive() {
    inverse_stays_positive::<f64>();
    inverse_stays_positive::<f32>();
    // What is there to lose: cofactors of a slab 1e-5 thick in single precision.
    let mut random = Pcg64Mcg::seed_from_u64(14);
    let negative = (0..100).filter(|_| {
        let Symmetric([xx, xy, xz, yy, yz, zz]) = slab::<f32>(1e-5, &mut random);
        xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz) <= 0.0
    });
    assert!(negative.count() > 10, "the determinant keeps its sign after all");
}

/// Row 16: alone, `rho = rho^0 = m w(0) / h^nu`, `k = 1`, `V = h^nu / w(0)`.
#[test]
fn a_lone_particle_has_its_kernels_volume() {
    fn check<const D: usize>(kernel: Kernel) {
        let h = 0.1_f64;
        let mut engine = engine_with(vec![particle([0.5; D], h)]);
        let viscosity = Viscosity::of(Dissipation::Av);
        let physics = Physics {
            kernel,
            grad_h: GradH::Exact,
            viscosity,
            gamma_minus_one: 0.4,
            neighbours: 50.0,
            ..Physics::STANDARD
        };
        engine.find_neighbours(kernel.support()).unwrap();
        engine.run_pass(&VolumeElements(physics)).unwrap();
        engine.run_pass(&Density(physics)).unwrap();
        let mut is = |field, due: f64| {
            let got = engine.read_scalar(field).unwrap()[0];
            assert_close(&format!("{} of {kernel} in {D}-D", field.name), got, due, 16.0 * UNIT * due);
        };
        let volume = h.powi(D as i32) / central_value::<f64, D>(kernel);
        is(fields::KERNEL_NORMALISATION, 1.0);
        is(fields::VOLUME, volume);
        is(fields::STANDARD_DENSITY, 0.7 / volume);
        is(fields::DENSITY, 0.7 / volume);
        is(fields::PRESSURE, 0.4 * 1.5 * 0.7 / volume);
    }
    for &kernel in Kernel::ALL {
        check::<1>(kernel);
        check::<2>(kernel);
        check::<3>(kernel);
    }
}

/// Rows 18 and 19: neither `rho^2` nor `m^2` is formed, which single precision has no room for.
#[test]
fn pressure_coefficient_survives_any_density() {
    for exponent in (-30..=30).step_by(3) {
        let density = 10_f32.powi(exponent);
        let got = pressure_coefficient(0.4 * density, 0.9, 1.05, density);
        let due = 0.4_f64 / (0.9 * 1.05) / f64::from(density);
        // Four operations, four constants.
        assert_close(&format!("Y at {density:e}"), f64::from(got) / due, 1.0, 8.0 * f32::UNIT);
    }
    let (dense, thin) = (1e30_f32, 1e-30_f32);
    assert!((dense * dense).is_infinite() && thin * thin == 0.0, "squares fit after all");
}

/// Row 20: two voids side by side. Every division in the weight is one by something, in the branch that is not taken too; so it is
/// next to smooth flow of strange masses, where what grows linearly from a ratio of three would pass through zero.
#[test]
fn two_voids_take_no_crossed_form() {
    fn check<T: Float>() {
        let weight = |densities: [f64; 4]| {
            let [a, b, c, d] = densities.map(T::lit);
            crossed_weight(a, b, c, d).to_f64()
        };
        for densities in [[0.0; 4], [0.0, 0.0, 1.0, 2.0], [1.0, 1.0, 6.0, 1.0], [1.0, 1.0, 0.0, 0.0]] {
            assert_eq!(weight(densities), 1.0, "{densities:?}");
        }
        assert_eq!(weight([1.0, 0.0, 0.0, 0.0]), 0.0, "a void has no density to weigh with");
    }
    check::<f64>();
    check::<f32>();
}

/// Row 21: `gamma - 1` is given as such; formed from 1.001 in single precision it has lost four digits.
#[test]
fn gamma_less_one_is_no_difference() {
    fn check<T: Float>() {
        let due = (0.001_f64 * 1.001 * 1000.0).sqrt();
        // gamma - 1, one more than it, two products and the root; as many for P.
        let got = sound_speed(T::lit(0.001), T::lit(1000.0)).to_f64();
        assert_close("c", got, due, gamma(6, T::UNIT) * due);
        assert_close("P", pressure(T::lit(0.001), T::one(), T::lit(1000.0)).to_f64(), 1.0, gamma(4, T::UNIT));
    }
    check::<f64>();
    check::<f32>();
    let textbook = f64::from(1.001_f32 - 1.0) / 0.001 - 1.0;
    assert!(textbook.abs() > 4e-5, "the difference is good after all: {textbook:e}");
}

/// Row 22: what a step adds to a specific energy of 1000 is less than half a unit of it in single precision, and lost. Nothing is done about
/// that: such runs need double precision, and this is the proof.
#[test]
fn slow_heating_needs_double_precision() {
    fn heated<T: Scalar>() -> f64 {
        let domain = Domain::new([0.0], [1.0], [true]).unwrap();
        let mut engine = PlainEngine::<T, 1>::new(&ParticleSet::new(domain, vec![particle([0.5], 0.1)]).unwrap());
        let viscosity = Viscosity::of(Dissipation::Av);
        let kernel = Kernel::CubicSpline;
        let physics = Physics {
            kernel,
            grad_h: GradH::Exact,
            viscosity,
            gamma_minus_one: 0.001,
            neighbours: 4.0,
            ..Physics::STANDARD
        };
        let others = [fields::INVERSE_SMOOTHING_LENGTH, fields::VOLUME, fields::GRAD_H, fields::ACCELERATION];
        let values = others.into_iter().zip([10.0, 0.1, 1.0, 0.0]);
        for (field, value) in values.chain([(fields::INTERNAL_ENERGY, 1000.0), (fields::ENERGY_RATE, 0.02)]) {
            engine.write(Component { field, index: 0 }, &[value]).unwrap();
        }
        for _ in 0..1000 {
            engine.run_update(&KickDrift(physics), 1e-3).unwrap();
        }
        engine.read_scalar(fields::INTERNAL_ENERGY).unwrap()[0]
    }
    // 1000 roundings of 1000.
    assert_close("heating kept", heated::<f64>() - 1000.0, 0.02, 1000.0 * 1000.0 * UNIT);
    assert_eq!(heated::<f32>(), 1000.0, "2e-5 is below half a unit, 3e-5");
}

/// Row 26: one at the mean spacing, falling from there inwards, no trouble far away or far inside.
#[test]
fn short_range_factor_falls_from_one() {
    fn check<T: Float>() {
        let kappa = |q: f64| short_range_factor(T::lit(q), T::lit(0.7), T::lit(5.0)).to_f64();
        for q in [T::lit(0.7).to_f64(), 0.8, 2.0, 1e30] {
            assert_eq!(kappa(q), 1.0, "q = {q}");
        }
        let values: Vec<f64> = (0..=700).map(|k| kappa(f64::from(k) * 1e-3)).collect();
        // It may shrink by the exponential's absolute error only, 16 roundings of one.
        assert!(
            values.windows(2).all(|w| w[1] >= w[0] - 16.0 * T::UNIT)
                && values.iter().all(|&k| (0.0..=1.0).contains(&k))
        );
        let deep = short_range_factor(T::zero(), T::lit(1e9), T::lit(5.0)).to_f64();
        assert!((0.0..2e-14_f64.max(16.0 * T::UNIT)).contains(&deep), "far inside: {deep:e}");
    }
    check::<f64>();
    check::<f32>();
}

/// Row 27: the number of neighbours counts the particle itself, so it is never zero: alone it is the ball's volume times `w(0)`, and the mean
/// spacing is `w(0)^(-1/nu)` smoothing lengths. A number of zero would not go unnoticed.
#[test]
fn a_lone_particle_has_a_critical_separation() {
    fn check<const D: usize>(kernel: Kernel) {
        let mut engine = engine_with(vec![particle([0.5; D], 0.1)]);
        let viscosity = Viscosity::of(Dissipation::AvSlrB2);
        let physics = Physics {
            kernel,
            grad_h: GradH::Corrected,
            viscosity,
            gamma_minus_one: 0.4,
            neighbours: 50.0,
            ..Physics::STANDARD
        };
        engine.find_neighbours(kernel.support()).unwrap();
        engine.run_pass(&VolumeElements(physics)).unwrap();
        engine.run_pass(&Density(physics)).unwrap();
        engine.run_pass(&VelocityGradients(physics)).unwrap();
        let got = engine.read(Component { field: fields::CRITICAL_SEPARATION, index: 0 }).unwrap()[0];
        let due = central_value::<f64, D>(kernel).powf(-1.0 / D as f64);
        // The root is good to 4 epsilon, its argument to a dozen roundings.
        assert_close(&format!("q_crit of {kernel} in {D}-D"), got, due, 32.0 * UNIT * due);
        assert!(
            !critical_separation::<f64, D>(0.0, 4.0).is_finite()
                && !critical_separation::<f32, D>(0.0, 4.0).is_finite()
        );
    }
    for &kernel in Kernel::ALL {
        check::<1>(kernel);
        check::<2>(kernel);
        check::<3>(kernel);
    }
}

/// Row 29: what is left of the velocity of approach in a linear flow is rounding of its parts, in either precision, and nothing is cut off.
#[test]
fn a_linear_flow_leaves_rounding_only() {
    fn check<T: Float>() {
        let mut random = Pcg64Mcg::seed_from_u64(29);
        let mut left = 0;
        for _ in 0..500 {
            let mut draw = || 2.0 * random.random::<f64>() - 1.0;
            let jacobian = Matrix::<T, 3>::from_fn(|_, _| T::lit(draw()));
            let x_ab = Vector::<T, 3>::from_fn(|_| T::lit(draw()));
            let slope = jacobian.symmetric_part().quadratic_form(x_ab);
            let inverse_r = T::one() / x_ab.norm();
            let omega = approach_velocity(jacobian.apply(x_ab), x_ab, inverse_r);
            let limiter = slope_limiter(slope, slope);
            let got = reconstructed_approach_velocity(omega, limiter, slope, limiter, slope, inverse_r).to_f64();
            let parts = (0..3).flat_map(|i| (0..3).map(move |j| (i, j)));
            let size: f64 = parts.map(|(i, j)| (x_ab[i] * jacobian.0[i][j] * x_ab[j]).to_f64().abs()).sum();
            // As for `a_linear_flow_has_no_viscosity`: a dozen roundings either way; the limiter is one to a rounding or two.
            assert_close("omega'", got, 0.0, 30.0 * T::UNIT * size * inverse_r.to_f64());
            left += usize::from(got != 0.0);
        }
        assert!(left > 50, "rounding is not hidden by a threshold: {left} of 500 are not zero");
    }
    check::<f64>();
    check::<f32>();
}

/// Row 33: the coefficient stays in its range through steps of any length, to the last bit, in single precision too; without signals it stays.
#[test]
fn coefficient_stays_in_its_range_in_single_precision() {
    let mut random = Pcg64Mcg::seed_from_u64(33);
    for _ in 0..20_000 {
        let mut draw = || random.random::<f32>();
        let viscosity = Viscosity { alpha: 0.1 + f64::from(draw()), ..Viscosity::of(Dissipation::AvSw) };
        let range = viscosity.alpha_min as f32..=viscosity.alpha as f32;
        let mut size = || 10_f32.powf(6.0 * draw() - 3.0);
        let [indicator, sound_speed, h, signal, dt] = std::array::from_fn(|_| size());
        let local = local_coefficient(&viscosity, indicator, draw() - 0.7, sound_speed, h);
        let alpha = raised_coefficient(viscosity.alpha_min as f32, local);
        let after = decayed_coefficient(&viscosity, alpha, local, decay_rate(signal, 1.0 / h), dt);
        assert!(range.contains(&alpha) && range.contains(&after), "{alpha}, {after}, {viscosity:?}");
        // Without signals it stays: a difference and a sum round.
        let kept = f64::from(decayed_coefficient(&viscosity, alpha, 0.0, decay_rate(0.0, 1.0 / h), 1e30));
        assert_close("without signals", kept, f64::from(alpha), 2.0 * f32::UNIT * f64::from(alpha));
    }
}
