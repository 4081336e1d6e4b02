//! GS25 (1)-(8), (27), (28): artificial viscosity.

use crate::check::{UNIT, assert_close};
use etalon_kernels_gen::Vector;
use etalon_reference::equations::dissipation::{
    approach_velocity, balsara_limiter, limited_viscosity, linear_coefficient, pair_balsara, pair_viscosity,
    regularised_approach, riemann_viscosity, signal_velocity, wave_aware_limiter,
};
use etalon_reference::schemes::{ApproachForm, Dissipation, Viscosity};
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
    assert_eq!(limited_viscosity(0.25, 12.0), 3.0);
    // 10 * (-6) / (21 - 1 + 0.01 * 100), h = 10
    assert_close("mu", regularised_approach(-6.0, 20.0, 10.0), -60.0 / 21.0, 4.0 * UNIT * 3.0);
}

/// (5): `mu` is `omega h / r` far from zero separation, has the sign of the approach, and is finite at it.
#[test]
fn regularised_approach_has_its_limits() {
    let h: f64 = 0.5;
    for (r, omega) in [(0.25_f64, -3.0), (0.5, -3.0), (2.0, 3.0), (100.0, -1.0)] {
        let mu = regularised_approach(omega * r, r * r, h);
        let due = omega * h / r / (1.0 + 0.01 * (h / r).powi(2));
        assert_close(&format!("mu at r = {r}"), mu, due, 8.0 * UNIT * due.abs());
        // Larger than omega inside of one smoothing length, smaller beyond, but for one part in a hundred.
        assert_eq!(mu.abs() > omega.abs(), r < 0.9 * h, "r = {r}");
        assert_eq!(mu < 0.0, omega < 0.0);
    }
    assert_eq!(regularised_approach(0.0, 0.0, h), 0.0, "coincident");
    assert_eq!(regularised_approach(0.0_f32, 0.0, 1e-30), 0.0, "a denominator that underflows");
    // It passes its largest value where r = eta = h / 10 and goes down to zero from there.
    let mu = |r: f64| regularised_approach(-r, r * r, h).abs();
    assert!(mu(0.05) > mu(0.04) && mu(0.05) > mu(0.06) && mu(1e-9) < 1e-6);
    assert_close("the largest mu", mu(0.05), 5.0, 20.0 * UNIT);
}

/// (4) with `mu` is (6) with `omega` at the separation `r = h`, `eta` aside.
#[test]
fn classical_form_is_the_production_form_with_mu() {
    let (alpha, beta, c, rho, omega) = (1.5, 3.0, 2.0, 4.0, -0.5);
    let mu = regularised_approach(omega * 2.0, 4.0, 2.0);
    let classical = pair_viscosity(alpha, beta, c, mu, rho);
    let due = (-alpha * c * mu + beta * mu * mu) / rho;
    assert_close("Pi", classical, due, 8.0 * UNIT * due);
    assert_close("mu at one smoothing length", mu * 1.01, omega, 4.0 * UNIT);
    assert!(classical > 0.0);
    assert_eq!(pair_viscosity(alpha, beta, c, regularised_approach(1.0, 4.0, 2.0), rho), 0.0, "receding");
}

/// (28): (8) with the driver's frequency below; (8) itself for a slow driver, nothing for a fast one.
#[test]
fn waves_are_no_shocks() {
    // 3 / (3 + 4 + 1e-4 * 1e4 * 3 + 5)
    assert_close("B*", wave_aware_limiter(-3.0, 4.0, 1e4, 3.0, 5.0), 0.2, 4.0 * UNIT);
    assert_eq!(wave_aware_limiter(3.0, 4.0, 1e4, 3.0, 0.0), balsara_limiter(3.0, 4.0, 1e4, 3.0));
    assert_eq!(wave_aware_limiter(0.0, 0.0, 0.0, 1.0, 0.0), 0.0, "cold gas at rest");
    assert!(wave_aware_limiter(3.0, 0.0, 1.0, 1.0, 1e12) < 1e-11);
    // The oscillating membrane: T = 0.05, |div v| up to omega v / c = 15.6.
    let membrane = Viscosity::of(Dissipation::AvSlrBStar2);
    assert_close("2 pi / T", membrane.angular_frequency(), 125.66370614, 1e-8);
    let largest = wave_aware_limiter(15.6, 0.0, 1.29, 1.0 / 0.007, membrane.angular_frequency());
    assert!(largest < 0.1105 && largest > 0.10, "{largest}");
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
        let due = match dissipation {
            Dissipation::AvSlrB2F | Dissipation::AvSlrBStar2F => (1.5, 2.25),
            _ => (3.0, 3.0),
        };
        assert_eq!((quiet, shocked), due, "{dissipation}");
    }
    // With a floor of one it is the scheme before.
    let whole = Viscosity { floor: 1.0, ..Viscosity::of(Dissipation::AvSlrB2F) };
    assert_eq!(linear_coefficient(&whole, 0.25), 1.0);
}

/// The coefficients of Table 1, its caption and section 2.3.
#[test]
fn schemes_have_the_coefficients_of_table_1() {
    use Dissipation::*;
    for &dissipation in Dissipation::ALL {
        let due = Viscosity {
            dissipation,
            form: if dissipation == AvB { ApproachForm::Regularised } else { ApproachForm::Projected },
            alpha: 1.0,
            alpha_min: 0.05,
            beta: 2.0,
            q_fold: 0.2,
            floor: 0.5,
            wave_period: 0.05,
            conduction: 0.0,
        };
        assert_eq!(Viscosity::of(dissipation), due);
        assert_eq!(dissipation.reconstructs(), ![Av, AvSw, AvB].contains(&dissipation));
        assert_eq!(dissipation.switches(), [AvSw, AvSwSlr].contains(&dissipation));
        assert_eq!(dissipation.knows_waves(), [AvSlrBStar2, AvSlrBStar2F].contains(&dissipation));
    }
    // In the order of the table, and by its names.
    let names = ["AV", "AVSW", "AVSLR", "AVSWSLR", "AVSLRB", "AVSLRB2", "AVSLRB2F"];
    assert_eq!(names, [0, 1, 2, 3, 4, 5, 6].map(|number| Dissipation::ALL[number].name()));
    assert_eq!(Dissipation::ALL.len(), 10);
}

/// Table 8: alpha between (0.2; 0.2), (0.05; 1), (1; 1), (0.05; 1), (1; 1), (0.5; 1).
#[test]
fn membrane_has_the_coefficients_of_table_8() {
    use Dissipation::*;
    let schemes = Viscosity::MEMBRANE.map(|viscosity| viscosity.dissipation);
    assert_eq!(schemes, [Av, AvSw, AvSlrB2, AvSwSlr, AvSlrBStar2, AvSlrBStar2F]);
    let smallest = |v: &Viscosity| match v.dissipation {
        AvSw | AvSwSlr => v.alpha_min,
        _ => linear_coefficient(v, 0.0),
    };
    assert_eq!(Viscosity::MEMBRANE.map(|v| smallest(&v)), [0.2, 0.05, 1.0, 0.05, 1.0, 0.5]);
    assert_eq!(Viscosity::MEMBRANE.map(|v| v.alpha), [0.2, 1.0, 1.0, 1.0, 1.0, 1.0]);
}
