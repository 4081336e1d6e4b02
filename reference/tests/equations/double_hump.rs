//! Double-humped kernels, in one to three dimensions and two precisions.

// Published figures are given with all their digits.
#![allow(clippy::excessive_precision)]

use crate::check::{UNIT, assert_close, gamma};
use crate::float::Float;
use crate::quadrature::{POINTS, over_space};
use etalon_reference::equations::double_hump::{double_hump, double_hump_factor};
use etalon_reference::equations::kernels::kernel_shape;
use etalon_reference::schemes::Kernel;
use std::f64::consts::PI;

/// Runs a generic check for one, two and three dimensions and every kernel.
macro_rules! for_each_kernel {
    ($check:ident) => {
        for &kernel in Kernel::ALL {
            $check::<1>(kernel);
            $check::<2>(kernel);
            $check::<3>(kernel);
        }
    };
}

/// Roundings of a bell kernel and its double hump, in units of the value at its largest: those of `kernels.rs`, and three products.
const ROUNDINGS: usize = 120;

/// Largest ratio of the sum of the terms' magnitudes of a bell kernel to its value at the centre: M6 has 450 for 66.
const CANCELLATION: f64 = 6.9;

#[test]
fn integral_is_one_and_the_factor_is_the_second_moment() {
    fn check<const D: usize>(kernel: Kernel) {
        let reach = kernel.support() as usize;
        let bound = gamma(ROUNDINGS + 8 + reach * POINTS, UNIT) * CANCELLATION;
        let total = over_space::<D>(reach, |q| double_hump::<f64, D>(kernel, q * q));
        assert_close(&format!("integral of D for {kernel} in {D}-D"), total, 1.0, bound);
        let moment = over_space::<D>(reach, |q| q * q * kernel_shape::<f64, D>(kernel, q * q).value);
        assert_close(
            &format!("second moment of {kernel} in {D}-D"),
            double_hump_factor::<D>(kernel).value() * moment,
            1.0,
            bound,
        );
    }
    for_each_kernel!(check);
}

/// The normalisations `B_D` of `D = B_D h^-nu q^2 f(q)`, each with its `f`, from the closed integrals.
#[test]
fn closed_forms() {
    let m4 = |q: f64| 0.25 * (2.0 - q).max(0.0).powi(3) - (1.0 - q).max(0.0).powi(3);
    let m6 = |q: f64| (3.0 - q).max(0.0).powi(5) - 6.0 * (2.0 - q).max(0.0).powi(5) + 15.0 * (1.0 - q).max(0.0).powi(5);
    let u = |q: f64| (1.0 - 0.5 * q).max(0.0);
    let c2 = |q: f64| u(q).powi(4) * (2.0 * q + 1.0);
    let c4 = |q: f64| u(q).powi(6) * (35.0 / 12.0 * q * q + 3.0 * q + 1.0);
    let c6 = |q: f64| u(q).powi(8) * (4.0 * q.powi(3) + 6.25 * q * q + 4.0 * q + 1.0);
    let c2_line = |q: f64| u(q).powi(3) * (1.5 * q + 1.0);
    let c4_line = |q: f64| u(q).powi(5) * (2.0 * q * q + 2.5 * q + 1.0);
    let c6_line = |q: f64| u(q).powi(7) * (2.625 * q.powi(3) + 4.75 * q * q + 3.5 * q + 1.0);
    fn check<const D: usize>(kernel: Kernel, norm: f64, f: impl Fn(f64) -> f64) {
        for q in [0.0, 0.001, 0.3, 0.8, 1.0, 1.25, 1.7, 1.99, 2.5, 2.9, 3.0, 4.0] {
            let due = norm * q * q * f(q);
            // The largest term of a kernel's sum is some 243 / 66 of the value at the centre.
            let bound = gamma(2 * ROUNDINGS, UNIT) * CANCELLATION * norm * q * q * f(0.0);
            assert_close(&format!("D of {kernel} in {D}-D at {q}"), double_hump::<f64, D>(kernel, q * q), due, bound);
        }
    }
    check::<1>(Kernel::CubicSpline, 2.0, m4);
    check::<2>(Kernel::CubicSpline, 70.0 / (31.0 * PI), m4);
    check::<3>(Kernel::CubicSpline, 10.0 / (9.0 * PI), m4);
    check::<1>(Kernel::QuinticSpline, 1.0 / 60.0, m6);
    check::<2>(Kernel::QuinticSpline, 42.0 / (2771.0 * PI), m6);
    check::<3>(Kernel::QuinticSpline, 1.0 / (168.0 * PI), m6);
    check::<1>(Kernel::WendlandC2, 105.0 / 64.0, c2_line);
    check::<2>(Kernel::WendlandC2, 63.0 / (20.0 * PI), c2);
    check::<3>(Kernel::WendlandC2, 105.0 / (64.0 * PI), c2);
    check::<1>(Kernel::WendlandC4, 45.0 / 16.0, c4_line);
    check::<2>(Kernel::WendlandC4, 297.0 / (56.0 * PI), c4);
    check::<3>(Kernel::WendlandC4, 6435.0 / (2048.0 * PI), c4);
    check::<1>(Kernel::WendlandC6, 2145.0 / 512.0, c6_line);
    check::<2>(Kernel::WendlandC6, 65.0 / (8.0 * PI), c6);
    check::<3>(Kernel::WendlandC6, 1365.0 / (256.0 * PI), c6);
    // The mixed sinc kernel has no closed form: published figures, fifteen digits.
    let published = [4.04182550955939, 2.11938457375863, 1.48008530743782];
    let ours = [
        double_hump_factor::<1>(Kernel::MixedSinc).value(),
        double_hump_factor::<2>(Kernel::MixedSinc).value(),
        double_hump_factor::<3>(Kernel::MixedSinc).value(),
    ];
    for (ours, published) in ours.into_iter().zip(published) {
        assert_close("factor of the mixed sinc kernel", ours, published, 1e-14);
    }
}

/// Two humps: zero at the centre, where a bell kernel is largest, zero outside, positive between, finite however far away.
#[test]
fn coincident_and_distant_particles_do_not_drag_each_other() {
    fn at<T: Float, const D: usize>(kernel: Kernel, q_squared: f64) -> f64 {
        double_hump::<T, D>(kernel, T::lit(q_squared)).to_f64()
    }
    fn check<const D: usize>(kernel: Kernel) {
        let edge = kernel.support() * kernel.support();
        for q_squared in [0.0, edge, 1.5 * edge, 1e30] {
            assert_eq!(at::<f64, D>(kernel, q_squared), 0.0, "{kernel} at q^2 = {q_squared}");
            assert_eq!(at::<f32, D>(kernel, q_squared), 0.0, "{kernel} at q^2 = {q_squared} in f32");
        }
        assert_eq!(at::<f64, D>(kernel, 1e300), 0.0, "{kernel}");
        for part in [1e-20, 0.1, 0.5, 0.9] {
            assert!(at::<f64, D>(kernel, part * edge) > 0.0, "{kernel}");
            assert!(at::<f32, D>(kernel, part * edge) > 0.0, "{kernel} in f32");
        }
    }
    for_each_kernel!(check);
}
