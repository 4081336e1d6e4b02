//! GS25 (11)-(19): slope-limited reconstruction.

use crate::check::{UNIT, assert_close};
use crate::float::Float;
use etalon_kernels_gen::{Matrix, Vector};
use etalon_reference::equations::dissipation::approach_velocity;
use etalon_reference::equations::reconstruction::{
    critical_separation, pair_separation, reconstructed_approach_velocity, reconstructed_velocity,
    reconstruction_share, short_range_factor, slope_limiter, support_volume,
};
use etalon_reference::schemes::{Dissipation, Viscosity};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use std::f64::consts::PI;

#[test]
fn whole_numbers() {
    // J is not symmetric: J x = (5, 11), its transpose would give (7, 10). v -+ (1/2) (4) J x.
    let jacobian = Matrix([[1.0, 2.0], [3.0, 4.0]]);
    let (v, x_ab) = (Vector([100.0, 200.0]), Vector([1.0, 2.0]));
    assert_eq!(reconstructed_velocity(v, 4.0, jacobian, x_ab, true).0, [90.0, 178.0]);
    assert_eq!(reconstructed_velocity(v, 4.0, jacobian, x_ab, false).0, [110.0, 222.0]);
    // 7 - (2 * 3 + 5 * (-4)) / (2 r), 1/r = 1/2
    assert_eq!(reconstructed_approach_velocity(7.0, 2.0, 3.0, 5.0, -4.0, 0.5), 10.5);
    assert_eq!(pair_separation(6.0, 0.5, 0.25), 1.5);
    assert_eq!(pair_separation(6.0, 0.25, 0.5), 1.5);
}

fn random_matrix<const D: usize>(random: &mut Pcg64Mcg) -> Matrix<f64, D> {
    Matrix::from_fn(|_, _| 2.0 * random.random::<f64>() - 1.0)
}
fn random_vector<const D: usize>(random: &mut Pcg64Mcg) -> Vector<f64, D> {
    Vector::from_fn(|_| 2.0 * random.random::<f64>() - 1.0)
}

/// (11) and (12) projected: with full Jacobians on one side and only the slopes of their symmetric parts on the other.
#[test]
fn projected_form_is_that_of_the_vectors() {
    fn check<const D: usize>() {
        let mut random = Pcg64Mcg::seed_from_u64(5);
        for _ in 0..500 {
            let (j_a, j_b) = (random_matrix::<D>(&mut random), random_matrix::<D>(&mut random));
            let [v_a, v_b, x_ab] = std::array::from_fn(|_| random_vector::<D>(&mut random));
            let (phi_ab, phi_ba) = (random.random::<f64>(), random.random::<f64>());
            let inverse_r = 1.0 / x_ab.norm();
            let v_a_prime = reconstructed_velocity(v_a, phi_ab, j_a, x_ab, true);
            let v_b_prime = reconstructed_velocity(v_b, phi_ba, j_b, x_ab, false);
            let due = approach_velocity(v_a_prime - v_b_prime, x_ab, inverse_r);
            let omega = approach_velocity(v_a - v_b, x_ab, inverse_r);
            let (slope_a, slope_b) =
                (j_a.symmetric_part().quadratic_form(x_ab), j_b.symmetric_part().quadratic_form(x_ab));
            let got = reconstructed_approach_velocity(omega, phi_ab, slope_a, phi_ba, slope_b, inverse_r);
            // Components are at most 1 for velocities and D for J x; some 25 roundings in sums of D products with a
            // unit vector.
            let size = (2.0 + D as f64) * (D as f64).sqrt();
            assert_close(&format!("omega' in {D}-D"), got, due, 25.0 * UNIT * size);
        }
    }
    check::<1>();
    check::<2>();
    check::<3>();
}

/// Where the velocity is linear the two reconstructed velocities meet, so nothing is left to dissipate.
#[test]
fn a_linear_flow_has_no_viscosity() {
    let mut random = Pcg64Mcg::seed_from_u64(6);
    for _ in 0..500 {
        let jacobian = random_matrix::<3>(&mut random);
        let x_ab = random_vector::<3>(&mut random);
        let v_ab = jacobian.apply(x_ab);
        let slope = jacobian.symmetric_part().quadratic_form(x_ab);
        let inverse_r = 1.0 / x_ab.norm();
        let omega = approach_velocity(v_ab, x_ab, inverse_r);
        assert_eq!(slope_limiter(slope, slope), 1.0);
        let omega_prime = reconstructed_approach_velocity(omega, 1.0, slope, 1.0, slope, inverse_r);
        // x J x from its full and from its symmetric matrix: nine products of at most |J||x|^2 / r, a dozen roundings
        // either way.
        let size: f64 = (0..3)
            .flat_map(|i| (0..3).map(move |j| (i, j)))
            .map(|(i, j)| (x_ab[i] * jacobian.0[i][j] * x_ab[j]).abs())
            .sum();
        assert_close("omega'", omega_prime, 0.0, 24.0 * UNIT * size * inverse_r);
        // The vectors themselves meet only if J and not its transpose is applied.
        let v_a = reconstructed_velocity(v_ab, 1.0, jacobian, x_ab, true);
        let v_b = reconstructed_velocity(Vector([0.0; 3]), 1.0, jacobian, x_ab, false);
        assert!((v_a - v_b).norm() <= 10.0 * UNIT * 3.0, "{:e}", (v_a - v_b).norm());
    }
}

/// The formula as printed, where it is safe to evaluate.
#[test]
fn limiter_is_that_of_van_leer() {
    let mut random = Pcg64Mcg::seed_from_u64(8);
    let mut limited = 0;
    for _ in 0..5000 {
        let mut draw = || (2.0 * random.random::<f64>() - 1.0) * 10_f64.powf(4.0 * random.random::<f64>());
        let (a, b) = (draw(), draw());
        let f: f64 = a / b;
        let due = (4.0 * f / ((1.0 + f) * (1.0 + f))).clamp(0.0, 1.0);
        limited += usize::from(due == 0.0);
        let got = slope_limiter(a, b);
        // y (1 - y), y <= 1/2: seven roundings; the printed formula with F > 0 as many.
        assert_close(&format!("limiter at F = {f}"), got, due, 14.0 * UNIT * due);
        assert_eq!(got, slope_limiter(b, a), "symmetric");
        assert_eq!(got, slope_limiter(-a, -b), "even");
        assert_eq!(got, slope_limiter(1024.0 * a, 1024.0 * b), "without scale");
        assert_eq!(slope_limiter(a, -a), 0.0, "F = -1");
        assert_eq!(slope_limiter(a, a), 1.0, "F = 1");
    }
    assert!((2000..3000).contains(&limited), "{limited} of 5000 with opposite signs");
    // F = 3: 12 / 16.
    assert_eq!(slope_limiter(3.0, 1.0), 0.75);
    assert_eq!(slope_limiter(-1.0, -3.0), 0.75);
}

fn limiter_survives<T: Float>(huge: f64, tiny: f64) {
    let l = |a: f64, b: f64| slope_limiter(T::lit(a), T::lit(b)).to_f64();
    for x in [huge, 1.0, tiny] {
        for zero in [0.0, -0.0] {
            assert_eq!((l(x, zero), l(zero, x), l(-x, zero), l(zero, -x)), (0.0, 0.0, 0.0, 0.0), "one slope is zero");
        }
        assert_eq!((l(x, x), l(-x, -x), l(x, -x)), (1.0, 1.0, 0.0), "x = {x:e}");
        assert_close("F = 3", l(x, x / 4.0 * 3.0), 48.0 / 49.0, 8.0 * T::UNIT);
    }
    assert_eq!(l(0.0, 0.0), 0.0);
    assert!((0.0..1e-30).contains(&l(huge, tiny)) && (0.0..1e-30).contains(&l(-tiny, -huge)), "F = 0 and infinity");
    assert_eq!(l(-huge, tiny), 0.0);
}

/// 0/0, x/0, F = -1, overflow and underflow of F and of the product of slopes: always a number between 0 and 1, and
/// the right one.
#[test]
fn limiter_is_defined_for_all_slopes() {
    limiter_survives::<f64>(1e300, 1e-300);
    limiter_survives::<f32>(1e30, 1e-30);
    // The smallest numbers there are.
    assert_eq!(slope_limiter(f64::from_bits(1), f64::from_bits(1)), 1.0);
    assert_eq!(slope_limiter(f32::from_bits(1), f32::from_bits(1)), 1.0);
}

#[test]
fn reconstruction_fades_at_short_range() {
    let kappa = |q: f64, q_crit: f64| short_range_factor(q, q_crit, 5.0);
    // exp(-y) keeps 8 epsilon = 16u absolute; y = depth^2 is rounded at 4u of up to 12.
    let bound = 20.0 * UNIT;
    for q in [0.7, 0.701, 1.0, 2.0, 1e30] {
        assert_eq!(kappa(q, 0.7), 1.0, "q = {q}");
    }
    assert_close("one fold inside", kappa(0.5, 0.7), (-1.0_f64).exp(), bound);
    assert_close("two folds inside", kappa(0.3, 0.7), (-4.0_f64).exp(), bound);
    assert_close("another fold", short_range_factor(0.5, 0.75, 2.0), (-0.25_f64).exp(), bound);
    // Leaves one with slope zero: 1 - kappa = depth^2.
    assert_close("just inside", 1.0 - kappa(0.7 - 1e-4, 0.7), 2.5e-7, 1e-12);
    let values: Vec<f64> = (0..1000).map(|k| kappa(f64::from(k) * 1e-3, 0.7)).collect();
    assert!(values.windows(2).all(|w| w[0] <= w[1]), "it falls towards small q");
    let q_crit = critical_separation::<f64, 3>(100.0, support_volume(3, 2.0));
    assert_close("coincident particles with 100 neighbours", kappa(0.0, q_crit), 5.8e-6, 0.05e-6);
}

#[test]
fn critical_separation_is_the_mean_spacing() {
    assert_eq!(support_volume(1, 2.0), 4.0);
    assert_close("disc", support_volume(2, 3.0), 9.0 * PI, 9.0 * PI * 2.0 * UNIT);
    assert_close("ball", support_volume(3, 2.0), 32.0 * PI / 3.0, 34.0 * 4.0 * UNIT);
    // The paper's formula in 3-D; the root is good to 4 epsilon.
    for neighbours in [30.0, 60.0, 100.0, 400.0] {
        let due = (32.0 * PI / (3.0 * neighbours)).cbrt();
        let got = critical_separation::<f64, 3>(neighbours, support_volume(3, 2.0));
        assert_close(&format!("q_crit for {neighbours}"), got, due, due * 14.0 * UNIT);
    }
    assert_close("published figure", critical_separation::<f64, 3>(100.0, support_volume(3, 2.0)), 0.694586, 5e-7);
    // A lattice of spacing 1 with h = 5/4: as many neighbours as the support's volume, and the spacing comes back in
    // units of h.
    fn spacing<const D: usize>(support: f64) {
        let ball = support_volume(D, support);
        let neighbours = ball * 1.25_f64.powi(D as i32);
        assert_close("spacing", critical_separation::<f64, D>(neighbours, ball), 0.8, 14.0 * UNIT);
    }
    spacing::<1>(2.0);
    spacing::<2>(2.0);
    spacing::<3>(3.0);
}

#[test]
fn share_of_the_reconstruction_is_the_schemes() {
    let share = |dissipation, balsara: f64| reconstruction_share(&Viscosity::of(dissipation), balsara);
    // At B = 0, 1/4 and 1.
    for (dissipation, due) in [
        (Dissipation::Av, [0.0, 0.0, 0.0]),
        (Dissipation::AvSlr, [1.0, 1.0, 1.0]),
        (Dissipation::AvSlrB, [1.0, 0.75, 0.0]),
        (Dissipation::AvSlrB2, [1.0, 0.9375, 0.0]),
        (Dissipation::AvSlrB2F, [1.0, 0.9375, 0.0]),
        (Dissipation::AvSw, [0.0, 0.0, 0.0]),
        (Dissipation::AvSwSlr, [1.0, 1.0, 1.0]),
        (Dissipation::AvB, [0.0, 0.0, 0.0]),
        (Dissipation::AvSlrBStar2, [1.0, 0.9375, 0.0]),
        (Dissipation::AvSlrBStar2F, [1.0, 0.9375, 0.0]),
    ] {
        assert_eq!([0.0, 0.25, 1.0].map(|balsara| share(dissipation, balsara)), due, "{dissipation}");
    }
}
