//! C25 (22), (23): the equations of motion.

use crate::check::{UNIT, assert_close};
use crate::float::Float;
use etalon_kernels_gen::Vector;
use etalon_reference::equations::hydrodynamics::{
    ATWOOD_RAMP, crossed_weight, pressure_acceleration, pressure_coefficient, pressure_work, viscous_acceleration,
    viscous_heating,
};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

#[test]
fn whole_numbers() {
    // P / (Omega k rho0^2) = 24 / (1/2 * 3 * 16)
    assert_eq!(pressure_coefficient(24.0, 0.5, 3.0, 4.0), 1.0);
    let (a_own, a_other) = (Vector([1.0, 2.0]), Vector([4.0, -8.0]));
    // m 2, Y_a 3, Y_b 5, g 2: own 12, other 5.
    assert_eq!(pressure_acceleration::<f64, 2>(2.0, 3.0, 5.0, 2.0, a_own, a_other).0, [-32.0, 16.0]);
    // m Y_a g v.A = 12 (3 - 14)
    assert_eq!(pressure_work::<f64, 2>(2.0, 3.0, 2.0, Vector([3.0, -7.0]), a_own), -132.0);
    assert_eq!(viscous_acceleration::<f64, 2>(2.0, 3.0, a_own).0, [-6.0, -12.0]);
    assert_eq!(viscous_heating::<f64, 2>(2.0, 3.0, Vector([3.0, -7.0]), a_own), -33.0);
}

#[test]
fn a_pressure_without_a_denominator_is_none() {
    for (omega, k, rho) in [(0.0, 1.0, 1.0), (-0.5, 1.0, 1.0), (1.0, 0.0, 1.0), (1.0, 1.0, 0.0)] {
        assert_eq!(pressure_coefficient(3.0, omega, k, rho), 0.0, "Omega {omega}, k {k}, rho0 {rho}");
    }
}

/// Two particles of the same gas push one another apart, and what one gains in motion the other's gas gives.
#[test]
fn pressure_repels_and_compression_heats() {
    // b stands at +x of a, so both gradients point to +x.
    let towards_b = Vector([0.3, 0.0, 0.0]);
    let push = pressure_acceleration::<f64, 3>(1.0, 2.0, 2.0, 1.0, towards_b, towards_b);
    assert!(push[0] < 0.0);
    // a moves towards b: v_ab along +x. Both works are positive.
    assert!(pressure_work::<f64, 3>(1.0, 2.0, 1.0, Vector([1.0, 0.0, 0.0]), towards_b) > 0.0);
    // A positive Pi, as approaching particles have, slows a and heats it.
    assert!(viscous_acceleration::<f64, 3>(1.0, 2.0, towards_b)[0] < 0.0);
    assert!(viscous_heating::<f64, 3>(1.0, 2.0, Vector([1.0, 0.0, 0.0]), towards_b) > 0.0);
}

#[test]
fn smooth_flow_takes_no_crossed_form() {
    assert_eq!(ATWOOD_RAMP, (0.1, 0.2));
    // Atwood numbers up to 0.0999; what the standard densities say does not matter.
    for ratio in [1.0, 1.01, 1.1, 1.2, 1.2219] {
        for (standard_a, standard_b) in [(1.0, 1.0), (1.0, 9.0), (7.0, 0.1)] {
            assert_eq!(crossed_weight(3.0, 3.0 * ratio, standard_a, standard_b), 1.0);
            assert_eq!(crossed_weight(3.0 * ratio, 3.0, standard_a, standard_b), 1.0);
        }
    }
    assert_eq!(crossed_weight(0.0, 0.0, 1.0, 2.0), 1.0, "no gas at all");
}

#[test]
fn contacts_take_the_crossed_form_whole() {
    // Atwood numbers of 0.2002 and more, up to near vacuum.
    for ratio in [1.5006, 1.6, 8.0, 1e6, 1e12] {
        for (standard_a, standard_b) in [(3.0, 5.0), (5.0, 3.0), (1.0, 1e9), (2.0, 2.0)] {
            assert_eq!(crossed_weight(1.0, ratio, standard_a, standard_b), standard_a / standard_b);
            assert_eq!(crossed_weight(ratio, 1.0, standard_a, standard_b), standard_a / standard_b);
        }
    }
}

/// Within the ramp the weight is `(a/b)^sigma`, for ratios of up to three and Atwood numbers that need not go with
/// them.
fn ramp_is_a_power<T: Float>() {
    let mut random = Pcg64Mcg::seed_from_u64(19);
    let mut draw = |low: f64, high: f64| T::lit(low + (high - low) * random.random::<f64>());
    let mut inside = 0;
    for _ in 0..20_000 {
        let (density_a, density_b) = (draw(1.0, 1.6), draw(1.0, 1.6));
        let (standard_a, standard_b) = (draw(1.0, 2.9), draw(1.0, 2.9));
        let [rho_a, rho_b, s_a, s_b] = [density_a, density_b, standard_a, standard_b].map(Float::to_f64);
        let atwood = (rho_a - rho_b).abs() / (rho_a + rho_b);
        let sigma = ((atwood - 0.1) / 0.1).clamp(0.0, 1.0);
        inside += usize::from(sigma > 0.0 && sigma < 1.0);
        let got = crossed_weight(density_a, density_b, standard_a, standard_b).to_f64();
        // Counted for the weight not above one, at least 1/3; the other is its inverse. sigma: At has 2u of 0.2, twice
        // tenfold, 6u; z 3u and the polynomial 4u of a logarithm up to 1.1; exp(-y) adds 8 epsilon = 16u absolute, 48u
        // relative. The library's power 4u.
        let bound = (1.1 * (6.0 + 7.0 + 1.0) + 48.0 + 2.0) * T::UNIT + 4.0 * UNIT;
        let due = (s_a / s_b).powf(sigma);
        assert_close(&format!("weight at At = {atwood}, ratio {}", s_a / s_b), got / due, 1.0, bound);
        let back = crossed_weight(density_b, density_a, standard_b, standard_a).to_f64();
        // One is the inverse of the other, each rounded once.
        assert_close("product of the two weights", got * back, 1.0, 2.1 * T::UNIT);
    }
    assert!(inside > 3000, "{inside} pairs in the ramp");
}

#[test]
fn ramp_is_a_power_of_the_ratio() {
    ramp_is_a_power::<f64>();
    ramp_is_a_power::<f32>();
}

#[test]
fn ramp_meets_both_ends() {
    // rho_b for a given Atwood number with rho_a = 1; a step of 1e-9 in it moves sigma by 1e-8 and the weight by
    // 1.1e-8.
    let denser = |atwood: f64| (1.0 + atwood) / (1.0 - atwood);
    let weight = |atwood: f64| crossed_weight(1.0, denser(atwood), 1.0, 2.5);
    assert_close("just above 0.1", weight(0.1 + 1e-9), 1.0, 1.1e-8);
    assert_close("just below 0.2", weight(0.2 - 1e-9), 0.4, 1.1e-8);
    assert_close("half-way", weight(0.15), 0.4_f64.sqrt(), 1e-13);
    // It falls all the way.
    let values: Vec<f64> = (0..=1000).map(|k| weight(0.09 + 0.12 * f64::from(k) / 1000.0)).collect();
    assert!(values.windows(2).all(|w| w[1] <= w[0]));
}

/// At an Atwood number of 0.2 the ramp has ended: the power of one is the ratio itself, and it has no limit of three.
#[test]
fn end_of_the_ramp_is_a_contact() {
    // 0.5 / 2.5; (0.2 - 0.1) * 10 is one in both precisions.
    assert_eq!(crossed_weight(1.5, 1.0, 1.0, 40.0), 1.0 / 40.0);
    assert_eq!(crossed_weight(1.0, 1.5, 40.0, 1.0), 40.0);
}

/// Ratios of more than three cannot be had inside the ramp without strange masses; what is beyond three grows linearly.
#[test]
fn ramp_is_linear_beyond_a_ratio_of_three() {
    // Neither is one of the standard densities, which alone make the ratio.
    let densities = (2.0, 2.3 / 0.85);
    let due = 3_f64.sqrt() * (1.0 + 0.5 * (40.0 / 3.0 - 1.0));
    // sigma = 0.5 is good to 1e-15 and moves a weight of 12 by a hundredth of that per unit.
    assert_close("lighter", crossed_weight(densities.0, densities.1, 1.0, 40.0), 1.0 / due, 1e-13);
    assert_close("denser", crossed_weight(densities.0, densities.1, 40.0, 1.0), due, 1e-12);
}

/// The weight has no step anywhere, whatever the masses: rounding that turns a comparison turns nothing else.
fn weight_has_no_step<T: Float>() {
    let denser = |atwood: f64| T::lit((1.0 + atwood) / (1.0 - atwood));
    let step = 2.0 * T::UNIT;
    for ratio in [1.0, 2.5, 3.0 - 1e-6, 3.0, 3.0 + 1e-6, 9.0, 1e3] {
        for (standard_a, standard_b) in [(ratio, 1.0), (1.0, ratio)] {
            let weight = |atwood: f64| {
                crossed_weight(T::lit(1.0), denser(atwood), T::lit(standard_a), T::lit(standard_b)).to_f64()
            };
            // The weight's logarithm grows with sigma by log 3 and by excess / (1 + sigma excess), which is below the ratio at the
            // ramp's beginning, 2 half-way, 1 at the end.
            for (atwood, growth) in [(0.1, 1.1 + ratio / 3.0), (0.15, 3.1), (0.2, 2.1)] {
                // Each Atwood number is off by the step, and by as much again from rounding: 4 steps apart, sigma by ten times
                // that. Rounding adds on either side what `ramp_is_a_power` counts, and 3 for the excess.
                let bound = 40.0 * step * growth + 140.0 * T::UNIT;
                assert!(bound < 0.01, "a bound of {bound} says nothing");
                let what = format!("ratio {standard_a}/{standard_b} across At = {atwood}");
                assert_close(&what, weight(atwood + step) / weight(atwood - step), 1.0, bound);
            }
        }
    }
}

#[test]
fn weight_has_no_step_at_any_ratio() {
    weight_has_no_step::<f64>();
    weight_has_no_step::<f32>();
}
