//! C25 (32), (33) and the driving of section 2, value by value.

use crate::check::{UNIT, assert_close};
use crate::float::Float;
use etalon_kernels_gen::Vector;
use etalon_reference::equations::turbulence::{
    driving_amplitude, driving_term, ornstein_uhlenbeck_step, project_mode, projection_norm_squared, scale_mach_number,
    squared_mach_number, squared_velocity_difference,
};
use etalon_reference::schemes::{MachReading, Profile};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

#[test]
fn whole_numbers() {
    assert_eq!(squared_velocity_difference::<f64, 3>(Vector([1.0, -2.0, 3.0])), 14.0);
    assert_eq!(squared_mach_number::<f64, 2>(Vector([3.0, -4.0]), 0.5), 100.0);
    // 3 (2 cos - 5 sin), 3 (-1 cos - 4 sin)
    assert_eq!(driving_term::<f64, 2>(3.0, Vector([2.0, -1.0]), Vector([5.0, 4.0]), 0.5, 0.25).0, [-0.75, -4.5]);
    // k = (2, 0): the first component is along, the second across.
    assert_eq!(project_mode::<f64, 2>(Vector([8.0, 16.0]), Vector([2.0, 0.0]), 0.75).0, [2.0, 12.0]);
    // k = (1, 1): (3, 1) is (2, 2) along and (1, -1) across.
    assert_eq!(project_mode::<f64, 2>(Vector([3.0, 1.0]), Vector([1.0, 1.0]), 0.25).0, [1.75, 1.25]);
    // nu / (1 - 2 zeta + nu zeta^2)
    assert_eq!(projection_norm_squared::<f64, 3>(0.5), 4.0);
    assert_eq!(projection_norm_squared::<f64, 3>(0.0), 3.0);
    assert_eq!(projection_norm_squared::<f64, 3>(1.0), 1.5);
    assert_eq!(projection_norm_squared::<f64, 2>(1.0), 2.0);
    assert_eq!(projection_norm_squared::<f64, 1>(0.5), 4.0);
}

/// Both readings of (33): they differ by the root of two and by nothing else.
#[test]
fn mach_number_of_a_scale_has_two_readings() {
    assert_eq!(scale_mach_number(8.0, 0.5, MachReading::Halved), 4.0);
    assert_eq!(scale_mach_number(9.0, 2.0, MachReading::Whole), 1.5);
    for s_2 in [1e-12, 0.3, 7.0] {
        let ratio = scale_mach_number(s_2, 0.7, MachReading::Whole) / scale_mach_number(s_2, 0.7, MachReading::Halved);
        // Two roots and two quotients, and the ratio's own rounding.
        assert_close("ratio of the readings", ratio, 2_f64.sqrt(), 8.0 * UNIT);
    }
    assert_eq!(scale_mach_number(0.0, 1.0, MachReading::Halved), 0.0);
    assert_eq!(scale_mach_number(1.0, 0.0, MachReading::Halved), 0.0, "no sound");
    assert_eq!(squared_mach_number::<f64, 1>(Vector([1.0]), 0.0), 0.0, "no sound");
}

#[test]
fn amplitudes_are_a_parabola_in_power_or_in_amplitude() {
    for wave_number in [0.0, 0.5, 1.0, 3.0, 3.5, 1e10] {
        for profile in [Profile::Power, Profile::Amplitude] {
            assert_eq!(driving_amplitude::<f64, 3>(wave_number, 2.0, profile), 0.0, "|n| = {wave_number}");
        }
    }
    assert_eq!(driving_amplitude::<f64, 3>(2.0, 2.0, Profile::Power), 2.0);
    assert_eq!(driving_amplitude::<f64, 3>(2.0, 2.0, Profile::Amplitude), 1.0);
    assert_eq!(driving_amplitude::<f64, 3>(2.5, 2.0, Profile::Amplitude), 0.75);
    // 2 sqrt(3/4) (2 / 2.5)^((nu - 1) / 2)
    for (got, fewer) in [
        (driving_amplitude::<f64, 1>(2.5, 2.0, Profile::Power), 1.0),
        (driving_amplitude::<f64, 2>(2.5, 2.0, Profile::Power), 0.8_f64.sqrt()),
        (driving_amplitude::<f64, 3>(2.5, 2.0, Profile::Power), 0.8),
    ] {
        assert_close("amplitude", got, 3_f64.sqrt() * fewer, 10.0 * UNIT);
    }
    // Another peak: at 3.5 of 4 as at 2.5 of 2, but for the number of modes.
    let (got, due) = (driving_amplitude::<f64, 2>(3.5, 4.0, Profile::Power), (3.0 * 4.0_f64 / 3.5).sqrt());
    assert_close("amplitude about 4", got, due, 10.0 * UNIT);
}

/// Across the wave vector nothing is left at 0, along it nothing at 1; the two parts make the whole; no direction, no force.
#[test]
fn projection_splits_along_and_across() {
    let mut random = Pcg64Mcg::seed_from_u64(3);
    let mut draw = |size: f64| Vector::<f64, 3>::from_fn(|_| size * (2.0 * random.random::<f64>() - 1.0));
    for _ in 0..200 {
        let (x, k) = (draw(1.0), draw(3.0));
        let (across, along, half) = (project_mode(x, k, 1.0), project_mode(x, k, 0.0), project_mode(x, k, 0.5));
        // A dozen roundings of products no larger than |x| |k|.
        let bound = 12.0 * UNIT * x.norm() * k.norm();
        assert_close("k . across", across.dot(k), 0.0, bound);
        for i in 0..3 {
            let cross = along[(i + 1) % 3] * k[(i + 2) % 3] - along[(i + 2) % 3] * k[(i + 1) % 3];
            assert_close("k x along", cross, 0.0, bound);
            assert_close("the whole", across[i] + along[i], x[i], 4.0 * UNIT);
            assert_close("half of the whole", half[i], 0.5 * x[i], 4.0 * UNIT);
        }
    }
}

/// Row 48: the mode without a direction.
#[test]
fn a_wave_vector_of_zero_drives_nothing() {
    for weight in [0.0, 0.5, 1.0] {
        assert_eq!(project_mode::<f64, 3>(Vector([1.0, 2.0, 3.0]), Vector([0.0; 3]), weight).0, [0.0; 3]);
        assert_eq!(project_mode::<f32, 3>(Vector([1.0, 2.0, 3.0]), Vector([0.0; 3]), weight as f32).0, [0.0; 3]);
    }
}

/// The factor of the old value and the spread of the new noise, taken from the step itself.
fn factors<T: Float>(decay: f64) -> (f64, f64) {
    let of = |x: f64, z: f64| ornstein_uhlenbeck_step(T::lit(x), T::lit(decay), T::one(), T::lit(z)).to_f64();
    (of(1.0, 0.0), of(0.0, 1.0))
}

fn step_is_exact<T: Float>() {
    for decay in [1e-3, 0.01, 0.1, 0.5, 1.0, 3.0, 10.0] {
        let rounded = T::lit(decay).to_f64();
        let (fade, spread) = factors::<T>(decay);
        // expm1 is good to 20 epsilon = 40u (see there); its root halves that. Single precision fits to 2.82e-9.
        let fit = if T::UNIT > UNIT { 3e-9 } else { 0.0 };
        assert_close("fade", fade, (-rounded).exp(), 42.0 * T::UNIT + fit);
        let due = (-(-2.0 * rounded).exp_m1()).sqrt();
        assert_close("spread", spread, due, (24.0 * T::UNIT + fit) * due);
        // One step of dt is two of dt/2: f(dt) = f^2, s(dt)^2 = s^2 (1 + f^2). No explicit scheme has that.
        let (half_fade, half_spread) = factors::<T>(0.5 * decay);
        assert_close("two fades", half_fade * half_fade, fade, 3.0 * (42.0 * T::UNIT + fit));
        let variance = half_spread.powi(2) * (1.0 + half_fade * half_fade);
        assert_close("two spreads", variance, spread.powi(2), 4.0 * (45.0 * T::UNIT + fit));
        // What is settled stays settled: f^2 + s^2 = 1.
        assert_close("stationary", fade * fade + spread * spread, 1.0, 3.0 * (45.0 * T::UNIT + fit));
    }
    assert_eq!(factors::<T>(0.0), (1.0, 0.0));
    // The exponential stops at exp(-32) = 1.27e-14, and the root halves that.
    let (fade, spread) = factors::<T>(1e30);
    assert_close("what is remembered for ever", fade, 0.0, 1.27e-14 + 42.0 * T::UNIT);
    assert_close("spread after all is forgotten", spread, 1.0, 0.64e-14 + 4.0 * T::UNIT);
    // sigma and z are factors of the noise alone.
    assert_eq!(ornstein_uhlenbeck_step(T::lit(3.0), T::zero(), T::lit(5.0), T::lit(7.0)).to_f64(), 3.0);
    let noise = ornstein_uhlenbeck_step(T::zero(), T::lit(40.0), T::lit(5.0), T::lit(-3.0)).to_f64();
    assert_close("noise", noise, -15.0, 15.0 * (0.64e-14 + 6.0 * T::UNIT));
}

#[test]
fn ornstein_uhlenbeck_step_is_exact_for_any_length() {
    step_is_exact::<f64>();
    step_is_exact::<f32>();
}

/// Row 47: a step of 1e-8 correlation times has noise of 1.414e-4; `sqrt(1 - f^2)` has none in single precision.
#[test]
fn short_steps_keep_their_noise() {
    for exponent in [-4, -8, -12, -20, -30] {
        let decay = 10_f64.powi(exponent);
        let due = (2.0 * decay).sqrt();
        let (_, spread) = factors::<f32>(decay);
        assert_close(&format!("f32, dt/T = {decay:e}"), spread, due, (24.0 * f32::UNIT + 3e-9 + decay) * due);
        let (_, spread) = factors::<f64>(decay);
        assert_close(&format!("f64, dt/T = {decay:e}"), spread, due, (24.0 * UNIT + decay) * due);
    }
    let naive = |decay: f32| (1.0 - (-decay).exp().powi(2)).sqrt();
    assert_eq!(naive(1e-8), 0.0, "this test would not notice the subtraction");
}
