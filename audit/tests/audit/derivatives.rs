//! What is the derivative of something is exactly that: by dual numbers, without finite differences.

use etalon_audit::{Probe, probes, random_inputs};
use etalon_kernels_gen::Real;
use etalon_kernels_gen::dual::Dual;
use etalon_reference::equations::equation_of_state::{pressure, sound_speed};
use etalon_reference::equations::grad_h::density_derivative_exact;
use etalon_reference::equations::kernels::{inverse_volume, kernel_shape, smoothing_length_derivative};
use etalon_reference::schemes::Kernel;

const U: f64 = f64::EPSILON;

fn named<'a>(function: &str, dimension: usize) -> &'a Probe {
    let is_it = |probe: &&Probe| probe.function == function && probe.dimension == Some(dimension);
    probes().iter().find(is_it).unwrap_or_else(|| panic!("no probe of {function}"))
}

/// `w'(q) = 2 q dw/d(q^2)`. Differentiating the code's own steps cancels at the centre (splines) and at the edge, where the encoded slope does
/// not; so errors are in ulps of the largest slope, 16 of them: the sinc kernels' powers of nine with eleven terms of a polynomial.
#[test]
fn slopes_of_kernels_are_their_derivatives() {
    for function in ["mixed_sinc", "cubic_spline", "quintic_spline", "wendland_c2", "wendland_c4", "wendland_c6"] {
        for dimension in 1..=3 {
            let probe = named(function, dimension);
            let inputs = random_inputs(probe, 0);
            let slopes: Vec<(f64, f64)> = inputs
                .iter()
                .filter(|q| q[0] > 0.0)
                .map(|q| {
                    let at = |q_squared: Dual| probe.evaluate(&[q_squared]).unwrap();
                    let shape = at(Dual::variable(q[0]));
                    let q = q[0].sqrt();
                    (2.0 * q * shape[0].slope, q * shape[1].value)
                })
                .collect();
            let scale = slopes.iter().map(|(_, slope)| slope.abs()).fold(0.0, f64::max);
            let worst = slopes.iter().map(|(found, slope)| (found - slope).abs() / (U * scale)).fold(0.0, f64::max);
            // The quintic spline's slope at the centre is a sum of 405, 480 and 75 that is zero; its largest is about 60.
            let tolerance = if function == "quintic_spline" { 8.0 * 16.0 } else { 16.0 };
            println!("{function} {dimension}-D: {worst:.2} ulps of the largest slope, tolerance {tolerance}");
            assert!(worst < tolerance && slopes.len() > 900, "{function} {dimension}-D: {worst}");
        }
    }
}

/// `dW/dh` of `W = h^-nu w(r/h)` at fixed `r` is `h^-(nu+1)` times `smoothing_length_derivative`: a dozen roundings each way.
#[test]
fn smoothing_length_derivative_is_that_of_the_kernel() {
    fn check<const D: usize>(kernel: Kernel, h: f64, r: f64) -> f64 {
        let w = |h: Dual| {
            let q = Dual::lit(r) / h;
            kernel_shape::<_, D>(kernel, q * q).value * inverse_volume::<_, D>(Dual::lit(1.0) / h)
        };
        let q_squared = (r / h) * (r / h);
        let shape = kernel_shape::<_, D>(kernel, q_squared);
        let encoded = smoothing_length_derivative::<_, D>(shape, q_squared) / h.powi(D as i32 + 1);
        // Both terms of the derivative are of the size of nu w / h^(nu + 1), of which they may cancel.
        let scale = (D as f64 * shape.value + q_squared * shape.slope_over_q.abs()) / h.powi(D as i32 + 1);
        (w(Dual::variable(h)).slope - encoded).abs() / (U * scale.max(f64::MIN_POSITIVE))
    }
    let mut worst = 0.0_f64;
    for &kernel in Kernel::ALL {
        for k in 0..400 {
            let (h, q) = (0.5 + f64::from(k % 7), f64::from(k) / 400.0 * 0.95 * kernel.support());
            worst = worst.max(check::<1>(kernel, h, q * h)).max(check::<2>(kernel, h, q * h)).max(check::<3>(
                kernel,
                h,
                q * h,
            ));
        }
    }
    // At 95 % of the support the distance to the edge has lost a factor of forty.
    println!("dW/dh: {worst:.1} ulps of its terms, tolerance {}", 40.0 * 24.0);
    assert!(worst < 40.0 * 24.0, "{worst}");
}

/// `c^2 = dP/d rho` along an adiabat, `du = P / rho^2 d rho`: five roundings, and the root.
#[test]
fn sound_speed_is_the_adiabatic_derivative_of_the_pressure() {
    let mut worst = 0.0_f64;
    for k in 1..500 {
        let (gamma_minus_one, density, energy) =
            (f64::from(k % 11 + 1) * 0.06, f64::from(k) * 0.01, f64::from(k % 37 + 1) * 0.3);
        let p = pressure(gamma_minus_one, density, energy);
        let along = Dual { value: energy, slope: p / (density * density) };
        let slope = pressure(Dual::lit(gamma_minus_one), Dual::variable(density), along).slope;
        worst = worst.max((sound_speed(gamma_minus_one, energy) / slope.sqrt() - 1.0).abs() / U);
    }
    println!("sound speed: {worst:.2} ulps, tolerance 6");
    assert!(worst < 6.0, "{worst}");
}

/// The exact grad-h form is the derivative of the density (C25 21) with respect to the particle's own smoothing length, of a handful of
/// neighbours and with everything else fixed: `rho = m k / X`, `k = sum X_b W_ab`, `X = m / sum m_b W_ab`.
#[test]
fn exact_grad_h_is_the_derivative_of_the_density() {
    const D: usize = 3;
    let neighbours: Vec<(f64, f64, f64)> =
        (1..40).map(|b| (0.05 * f64::from(b), 1.0 + 0.1 * f64::from(b % 5), 0.8 + 0.05 * f64::from(b % 9))).collect();
    for &kernel in Kernel::ALL {
        let (mass, h) = (1.3, 0.9);
        let w = |r: f64, h: Dual| {
            let q = Dual::lit(r) / h;
            kernel_shape::<_, D>(kernel, q * q).value * inverse_volume::<_, D>(Dual::lit(1.0) / h)
        };
        let sum = |h: Dual, weight: &dyn Fn(&(f64, f64, f64)) -> f64| {
            neighbours.iter().fold(Dual::lit(0.0), |sum, b| sum + Dual::lit(weight(b)) * w(b.0, h))
        };
        let h_a = Dual::variable(h);
        let standard = Dual::lit(mass) * w(0.0, h_a) + sum(h_a, &|b| b.1);
        let estimator = Dual::lit(mass) / standard;
        let k = estimator * w(0.0, h_a) + sum(h_a, &|b| b.2);
        let density = Dual::lit(mass) * k / estimator;
        let (self_w, sum_x, sum_m) = (w(0.0, h_a), sum(h_a, &|b| b.2), sum(h_a, &|b| b.1));
        let encoded = density_derivative_exact(
            mass,
            estimator.value,
            k.value,
            sum_x.slope,
            sum_m.slope,
            self_w.value,
            self_w.slope,
        );
        let scale = (mass / estimator.value * sum_x.slope).abs()
            + (k.value * sum_m.slope).abs()
            + (mass * self_w.slope * k.value).abs();
        let error = (density.slope - encoded).abs() / (U * scale);
        // Forty terms a sum, a dozen roundings each, not all of one sign.
        println!("{kernel}: {error:.2} ulps of its terms, tolerance 64");
        assert!(error < 64.0, "{kernel}: {error}");
        assert!(encoded.abs() > 1e-3 * scale, "{kernel}: the test says nothing");
    }
}
