//! The ideal gas, time steps, smoothing lengths and initial profiles.

use crate::check::{UNIT, assert_close};
use crate::float::Float;
use etalon_reference::equations::equation_of_state::{pressure, sound_speed};
use etalon_reference::equations::initial_state::smoothed_pressure;
use etalon_reference::equations::smoothing_length::{
    effective_neighbours, next_smoothing_length, settled_smoothing_length,
};
use etalon_reference::equations::time_step::{LONGEST_STEP, acceleration_step, cooling_step, courant_step};

#[test]
fn ideal_gas_of_whole_numbers() {
    assert_eq!(pressure(0.5, 4.0, 3.0), 6.0);
    // sqrt(1/4 * 5/4 * 20)
    assert_eq!(sound_speed(0.25, 20.0), 2.5);
    // c^2 = gamma P / rho
    let (gamma_minus_one, rho, u) = (0.4, 3.0, 1.7);
    let c = sound_speed(gamma_minus_one, u);
    let due = 1.4 * pressure(gamma_minus_one, rho, u) / rho;
    assert_close("c^2", c * c, due, 10.0 * UNIT * due);
}

/// Energy that a step made negative is no reason for NaN, at any size, in either precision.
#[test]
fn cold_and_overcooled_gas_has_no_sound() {
    fn check<T: Float>() {
        for u in [0.0, -0.0, -1e-30, -1.0, -1e30] {
            assert_eq!(sound_speed(T::lit(0.4), T::lit(u)).to_f64(), 0.0, "u = {u}");
        }
        assert_eq!(pressure(T::lit(0.4), T::one(), T::zero()).to_f64(), 0.0);
    }
    check::<f64>();
    check::<f32>();
}

/// gamma = 1.001 in single precision: gamma - 1 by subtraction would be off by 5e-5.
#[test]
fn nearly_isothermal_gas_keeps_its_digits() {
    let due = (0.001_f64 * 1.001 * 1000.0).sqrt();
    // gamma - 1, its product, the sum and the root: at most 3u after halving by the root, one more for u's constant.
    let got = f64::from(sound_speed(0.001_f32, 1000.0));
    assert_close("c", got, due, 4.0 * f32::UNIT * due);
    assert_close("P", f64::from(pressure(0.001_f32, 1.0, 1000.0)), 1.0, 3.0 * f32::UNIT);
}

#[test]
fn time_steps_of_whole_numbers() {
    assert_eq!(courant_step(2.0, 4.0), 0.2);
    assert_eq!(courant_step(2.0, 0.5), 1.6);
    assert_eq!(acceleration_step(8.0, 2.0), 0.5);
    assert_eq!(acceleration_step(8.0, 0.5), 1.0);
    assert_eq!(cooling_step(3.0, -2.0), 0.75);
    assert_eq!(cooling_step(0.5, -0.25), 1.0);
    // Nothing happens, nothing limits; heating does not either, and energy that is not there cannot be saved.
    for longest in [
        courant_step(2.0, 0.0),
        acceleration_step(8.0, 0.0),
        cooling_step(3.0, 0.0),
        cooling_step(3.0, 0.25),
        cooling_step(0.0, -2.0),
        cooling_step(-1.0, -2.0),
    ] {
        assert_eq!(longest, LONGEST_STEP);
    }
    assert!((LONGEST_STEP as f32).is_finite() && LONGEST_STEP >= 1e30);
}

#[test]
fn effective_neighbours_is_support_over_volume() {
    // h = 2, V = 3: 48 / (3 / 2^nu)
    assert_eq!(effective_neighbours::<f64, 1>(0.5, 3.0, 48.0), 32.0);
    assert_eq!(effective_neighbours::<f64, 2>(0.5, 3.0, 48.0), 64.0);
    assert_eq!(effective_neighbours::<f64, 3>(0.5, 3.0, 48.0), 128.0);
}

#[test]
fn smoothing_length_settles_and_carries_on() {
    // Where the right one is h/4 (1-D) or h/2. The roots of powers of two are exact but for the last.
    assert_eq!(settled_smoothing_length::<f64, 1>(2.0, 40.0, 10.0, 1.0), 0.5);
    assert_eq!(settled_smoothing_length::<f64, 2>(2.0, 40.0, 10.0, 1.0), 1.0);
    assert_close("3-D", settled_smoothing_length::<f64, 3>(2.0, 80.0, 10.0, 1.0), 1.0, 8.0 * UNIT);
    // And upwards.
    assert_eq!(settled_smoothing_length::<f64, 1>(2.0, 10.0, 40.0, 1.0), 8.0);
    // Half of the way where Omega is two; never more than the whole.
    assert_eq!(settled_smoothing_length::<f64, 1>(2.0, 40.0, 10.0, 2.0), 1.25);
    assert_eq!(settled_smoothing_length::<f64, 1>(2.0, 40.0, 10.0, 0.5), 0.5);
    assert_eq!(settled_smoothing_length::<f64, 1>(2.0, 40.0, 10.0, -3.0), 0.5);
    // What grew by an eighth grows by an eighth again; no more than by a quarter, no less than to four fifths.
    assert_eq!(next_smoothing_length(1.125, 1.0), 1.125 * 1.125);
    assert_eq!(next_smoothing_length(2.0, 1.0), 2.5);
    assert_eq!(next_smoothing_length(1.0, 2.0), 0.8);
}

fn fixed_point<const D: usize>() {
    for k in 1..200 {
        let (h, neighbours) = (0.01 * f64::from(k), 3.0 + 1.7 * f64::from(k));
        let settled = settled_smoothing_length::<f64, D>(h, neighbours, neighbours, 1.3);
        assert_eq!((settled, next_smoothing_length(settled, h)), (h, h), "{D}-D");
        assert_eq!(settled_smoothing_length::<f32, D>(h as f32, 64.1, 64.1, 1.3), h as f32, "{D}-D");
    }
    // At constant volume the settled one is the goal at once.
    let (ball, volume, wanted): (f64, f64, f64) = (4.0, 0.01, 50.0);
    let goal = (wanted * volume / ball).powf(1.0 / D as f64);
    let h = 3.0 * goal;
    let neighbours = effective_neighbours::<f64, D>(1.0 / h, volume, ball);
    let settled = settled_smoothing_length::<f64, D>(h, neighbours, wanted, 1.0);
    // Some 20 roundings of h.
    assert_close("settled", settled, goal, 20.0 * UNIT * h);
}

#[test]
fn smoothing_length_has_its_fixed_point() {
    fixed_point::<1>();
    fixed_point::<2>();
    fixed_point::<3>();
}

/// How far the smoothing length is from the right one after a hundred steps, in units of how far it was. The number of neighbours grows
/// as `h^(nu omega)`; the update is told that `omega` is `told`.
fn left_after_a_hundred_steps<const D: usize>(omega: f64, told: f64) -> f64 {
    let (start, wanted) = (1.01_f64, 50.0);
    let (mut h, mut before) = (start, start);
    for _ in 0..100 {
        let neighbours = wanted * h.powf(D as f64 * omega);
        let settled = settled_smoothing_length::<f64, D>(h, neighbours, wanted, told);
        (h, before) = (next_smoothing_length(settled, before), settled);
    }
    (h - 1.0).abs() / (start - 1.0)
}

/// With `s = 1 - omega / max(1, told)` the relative error obeys `e'' = 2 s e' - s e`: its roots are within the unit circle for
/// `-1/3 < s < 1`.
#[test]
fn smoothing_length_settles_next_to_a_denser_gas() {
    for omega in [0.5, 0.8, 1.0, 1.3, 1.6, 2.5, 10.0] {
        // The slowest: 0.707^100 = 1e-15 at Omega = 1/2. The root of n / n_0 is good to a few units of 1e-16, in units of 0.01.
        for left in [
            left_after_a_hundred_steps::<1>(omega, omega),
            left_after_a_hundred_steps::<2>(omega, omega),
            left_after_a_hundred_steps::<3>(omega, omega),
        ] {
            assert!(left < 1e-12, "Omega {omega}: {left:e} of the error is left");
        }
    }
    // The documented limits are limits: a third more than was told.
    assert!(left_after_a_hundred_steps::<1>(1.3, 1.0) < 1e-2 && left_after_a_hundred_steps::<1>(1.36, 1.0) > 1.0);
    assert!(left_after_a_hundred_steps::<1>(2.6, 2.0) < 1e-2 && left_after_a_hundred_steps::<1>(2.72, 2.0) > 1.0);
}

/// Where the right length grows by a hundredth each step it is met, not followed.
#[test]
fn smoothing_length_does_not_lag() {
    for grad_h in [1.0, 1.5] {
        let (mut h, mut before) = (1.0, 1.0);
        for step in 1..=100 {
            let neighbours = effective_neighbours::<f64, 1>(1.0 / h, 1.01_f64.powi(step), 4.0);
            let settled = settled_smoothing_length::<f64, 1>(h, neighbours, 4.0, grad_h);
            (h, before) = (next_smoothing_length(settled, before), settled);
        }
        // h is now that of step 101. A start that is off by a hundredth is forgotten: with s = 1/3, 0.577^100 = 1e-24.
        assert_close(&format!("h for Omega {grad_h}"), h, 1.01_f64.powi(101), 1e-13);
    }
}

#[test]
fn smoothed_pressure_is_a_hyperbolic_tangent() {
    let tube = |x: f64| smoothed_pressure(x, 0.5, 0.01, 0.45, 0.55);
    // exp(-y) stops at y = 32 with 1.27e-14, so either end is off by 0.45 * 2 * 1.27e-14; and three roundings.
    let end = 0.9 * 1.27e-14 + 4.0 * UNIT;
    assert_close("left end", tube(0.0), 1.0, end);
    assert_close("right end", tube(1.0), 0.1, end);
    assert_eq!(tube(0.5), 0.55);
    for k in -100..=100 {
        let x = 0.5 + 0.0013 * f64::from(k);
        let y: f64 = (x - 0.5) / 0.01;
        // exp is good to 16u, so is (1 - e)/(1 + e) to twice that; y itself is the same here and there.
        let bound = 0.45 * 36.0 * UNIT + end;
        assert_close(&format!("pressure at {x}"), tube(x), 0.55 - 0.45 * y.tanh(), bound);
    }
    // Other figures: B - A tanh(y), y = (3 - 1) / 4.
    assert_close("general", smoothed_pressure(3.0, 1.0, 4.0, 2.0, 7.0), 7.0 - 2.0 * 0.5_f64.tanh(), 80.0 * UNIT);
}
