//! GS25 (1)-(3), (6)-(8), (27): artificial viscosity.

use crate::check::{UNIT, assert_close};
use etalon_kernels_gen::Vector;
use etalon_reference::equations::dissipation::{
    approach_velocity, balsara_limiter, linear_coefficient, pair_balsara, pair_viscosity, riemann_viscosity,
    signal_velocity,
};
use etalon_reference::schemes::{Dissipation, Viscosity};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

#[test]
fn whole_numbers() {
    assert_eq!(approach_velocity::<f64, 2>(Vector([3.0, -7.0]), Vector([2.0, 4.0]), 0.5), -11.0);
    // c_a + c_b - 3 omega
    assert_eq!(signal_velocity(2.0, 5.0, -4.0), 19.0);
    assert_eq!(signal_velocity(2.0, 5.0, 1.0), 4.0);
    // -2 * 5 * (-3) / (2 * 4)
    assert_eq!(riemann_viscosity(2.0, 5.0, -3.0, 4.0), 3.75);
    // (-2 * 5 * (-4) + 3 * 16) / 8
    assert_eq!(pair_viscosity(2.0, 3.0, 5.0, -4.0, 8.0), 11.0);
    assert_eq!(pair_balsara(0.25, 0.5), 0.375);
}

#[test]
fn particles_in_the_same_place_do_not_see_each_other() {
    assert_eq!(approach_velocity::<f64, 3>(Vector([1.0, 2.0, 3.0]), Vector([0.0; 3]), 0.0), 0.0);
}

#[test]
fn receding_particles_have_no_viscosity() {
    for omega in [0.0, -0.0, 1e-300, 1.0, 1e30] {
        assert_eq!(riemann_viscosity(1.0, 3.0, omega, 2.0), 0.0, "omega = {omega}");
        assert_eq!(pair_viscosity(1.0, 2.0, 3.0, omega, 2.0), 0.0, "omega = {omega}");
    }
    // And it sets in without a step.
    assert_close("Pi just below zero", pair_viscosity(1.0, 2.0, 3.0, -1e-12, 2.0), 1.5e-12, 1e-23);
    assert_close("Pi just below zero", riemann_viscosity(1.0, 3.0, -1e-12, 2.0), 0.75e-12, 1e-23);
}

/// (1) with the signal velocity (3) is (6) with `beta = 3 alpha / 2`: every constant of the three in one identity.
#[test]
fn riemann_form_is_the_production_form_with_its_own_beta() {
    let mut random = Pcg64Mcg::seed_from_u64(2);
    for _ in 0..1000 {
        let mut draw = || 0.1 + 3.0 * random.random::<f64>();
        let (alpha, c_a, c_b, omega, rho) = (draw(), draw(), draw(), -draw(), draw());
        let riemann = riemann_viscosity(alpha, signal_velocity(c_a, c_b, omega), omega, rho);
        let production = pair_viscosity(alpha, 1.5 * alpha, 0.5 * (c_a + c_b), omega, rho);
        // All terms of either are positive; ten roundings each.
        assert_close("Pi", production / riemann, 1.0, 20.0 * UNIT);
        assert!(riemann > 0.0, "approaching particles repel each other");
    }
}

#[test]
fn balsara_has_its_limits() {
    // 3 / (3 + 4 + 1e-4 * 1e4 * 3)
    assert_close("Balsara", balsara_limiter(3.0, 4.0, 1e4, 3.0), 0.3, 4.0 * UNIT);
    assert_close("Balsara in compression", balsara_limiter(-3.0, 4.0, 1e4, 3.0), 0.3, 4.0 * UNIT);
    assert_eq!(balsara_limiter(0.0, 4.0, 1.0, 1.0), 0.0, "pure shear");
    assert_eq!(balsara_limiter(-4.0, 0.0, 0.0, 1.0), 1.0, "pure compression of cold gas");
    assert_eq!(balsara_limiter(0.0, 0.0, 0.0, 1.0), 0.0, "cold gas at rest");
    assert_eq!(balsara_limiter(0.0_f32, 0.0, 1e-30, 1e-10), 0.0, "a floor that underflows");
    let mut random = Pcg64Mcg::seed_from_u64(4);
    for _ in 0..1000 {
        let mut draw = || 10_f64.powf(20.0 * random.random::<f64>() - 10.0);
        let b = balsara_limiter(draw() - draw(), draw(), draw(), draw());
        assert!((0.0..=1.0).contains(&b), "{b}");
    }
}

#[test]
fn only_the_floored_scheme_lowers_alpha() {
    for &dissipation in Dissipation::ALL {
        let viscosity = Viscosity { alpha: 3.0, floor: 0.5, ..Viscosity::of(dissipation) };
        let (quiet, shocked) = (linear_coefficient(&viscosity, 0.25), linear_coefficient(&viscosity, 0.75));
        let due = if dissipation == Dissipation::AvSlrB2F { (1.5, 2.25) } else { (3.0, 3.0) };
        assert_eq!((quiet, shocked), due, "{dissipation}");
    }
    // With a floor of one it is the scheme before.
    let whole = Viscosity { floor: 1.0, ..Viscosity::of(Dissipation::AvSlrB2F) };
    assert_eq!(linear_coefficient(&whole, 0.25), 1.0);
}

/// The coefficients of Table 1, its caption and section 2.3.
#[test]
fn schemes_have_the_coefficients_of_table_1() {
    for &dissipation in Dissipation::ALL {
        let Viscosity { dissipation: same, alpha, beta, q_fold, floor } = Viscosity::of(dissipation);
        assert_eq!((same, alpha, beta, q_fold, floor), (dissipation, 1.0, 2.0, 0.2, 0.5));
        assert_eq!(dissipation.reconstructs(), dissipation != Dissipation::Av);
    }
    assert_eq!(Dissipation::ALL.len(), 5);
}
