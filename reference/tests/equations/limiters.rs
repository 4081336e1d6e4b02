//! PL20 (13)-(16): limiters of two slopes.

use crate::check::{assert_close, gamma};
use crate::float::Float;
use etalon_reference::equations::limiters::*;
use etalon_reference::schemes::SlopeLimiter;
use etalon_reference::schemes::SlopeLimiter::*;
use proptest::prelude::*;

const LIMITERS: [SlopeLimiter; 4] = [Minmod, VanLeer, MonotonizedCentral, Superbee];

#[test]
fn whole_numbers() {
    // Slopes; minmod; van Leer; monotonized central, by the mean and by twice the smaller; Superbee, by the larger and by twice the smaller.
    let cases = [
        ([3.0, 6.0], [3.0, 4.0, 4.5, 6.0]),
        ([4.0, 12.0], [4.0, 6.0, 8.0, 8.0]),
        ([3.0, 15.0], [3.0, 5.0, 6.0, 6.0]),
        ([2.0, 6.0], [2.0, 3.0, 4.0, 4.0]),
        ([4.0, 4.0], [4.0; 4]),
        ([3.0, -6.0], [0.0; 4]),
        ([3.0, 0.0], [0.0; 4]),
    ];
    let close = |got: f64, due: f64, what: &str| assert_close(what, got, due, gamma(4, f64::UNIT) * due.abs());
    for ([a, b], due) in cases {
        for (limiter, due) in LIMITERS.into_iter().zip(due) {
            close(limited_slope(limiter, a, b), due, &format!("{limiter}({a}, {b})"));
            close(limited_slope(limiter, b, a), due, &format!("{limiter}({b}, {a})"));
            close(limited_slope(limiter, -a, -b), -due, &format!("{limiter}({}, {})", -a, -b));
        }
    }
    assert_eq!(limited_slope(Unlimited, 3.0, -7.0), -2.0);
    assert_eq!(SlopeLimiter::ALL.len(), 1 + LIMITERS.len());
}

/// The formulas as printed, where their products neither underflow nor overflow.
fn as_printed(limiter: SlopeLimiter, a: f64, b: f64) -> f64 {
    if a * b <= 0.0 {
        return 0.0;
    }
    match limiter {
        Unlimited => 0.5 * (a + b),
        Minmod if a > 0.0 => a.abs().min(b.abs()),
        Minmod => -a.abs().min(b.abs()),
        VanLeer => 2.0 * a * b / (a + b),
        MonotonizedCentral => a.signum() * (0.5 * (a + b)).abs().min(2.0 * a.abs()).min(2.0 * b.abs()),
        Superbee => a.signum() * b.abs().min(2.0 * a.abs()).max((2.0 * b.abs()).min(a.abs())),
    }
}

proptest! {
    #[test]
    fn limiters_are_the_printed_formulas(a in -1e3..1e3_f64, b in -1e3..1e3_f64) {
        for limiter in LIMITERS {
            let due = as_printed(limiter, a, b);
            // Four roundings either way; the terms all have one sign.
            assert_close(&format!("{limiter}({a}, {b})"), limited_slope(limiter, a, b), due, gamma(8, f64::UNIT) * due.abs());
        }
    }

    #[test]
    fn limiters_have_the_properties_of_limiters(a in -1e3..1e3_f64, b in -1e3..1e3_f64, power in -200..200_i32) {
        let scale = 2_f64.powi(power);
        let mut before = 0.0;
        for limiter in LIMITERS {
            let f = |a, b| limited_slope(limiter, a, b);
            prop_assert_eq!(f(a, b), f(b, a), "{} is symmetric", limiter);
            prop_assert_eq!(f(-a, -b), -f(a, b), "{} is odd", limiter);
            prop_assert_eq!(f(a, a), a, "{} of equal slopes", limiter);
            prop_assert_eq!(f(a * scale, b * scale), f(a, b) * scale, "{} is homogeneous", limiter);
            prop_assert!(f(a, b).abs() <= a.abs().max(b.abs()), "{} is no larger than the larger slope", limiter);
            // The order is exact but for the last rounding of each.
            prop_assert!(f(a, b).abs() >= before * (1.0 - gamma(8, f64::UNIT)), "{} is too small", limiter);
            before = f(a, b).abs();
        }
    }
}

/// Products of slopes would underflow or overflow for most of these; the printed forms then give 0, infinity or NaN.
fn hard_slopes<T: Float>(least: f64, small: f64, large: f64, largest: f64) {
    let f = |limiter, a: f64, b: f64| limited_slope(limiter, T::lit(a), T::lit(b)).to_f64();
    let largest = T::lit(largest).to_f64();
    for limiter in LIMITERS {
        for size in [least, small, 1.0, large, largest] {
            let size = T::lit(size).to_f64();
            assert_eq!(f(limiter, size, size), size, "{limiter}");
            assert_eq!(f(limiter, -size, -size), -size, "{limiter}");
            for (a, b) in [(size, -size), (size, 0.0), (-0.0, size), (size, -0.0), (size, f64::NAN), (f64::NAN, -size)]
            {
                assert_eq!(f(limiter, a, b), 0.0, "{limiter}({a}, {b})");
            }
        }
        // Of slopes far apart only the smaller one counts: once, or twice.
        let factor = if limiter == Minmod { 1.0 } else { 2.0 };
        let small = T::lit(small).to_f64();
        assert_eq!(f(limiter, small, large), factor * small, "{limiter}");
        assert_eq!(f(limiter, -large, -small), -factor * small, "{limiter}");
        assert!(f(limiter, largest, 0.75 * largest).is_finite(), "{limiter}");
    }
}

#[test]
fn limiters_hold_for_all_slopes() {
    hard_slopes::<f64>(f64::MIN_POSITIVE, 1e-300, 1e300, f64::MAX);
    hard_slopes::<f32>(f32::MIN_POSITIVE as f64, 1e-36, 1e36, f32::MAX as f64);
}

/// Smaller than the smallest normal number: a processor that keeps such numbers gives the slope, one that does not gives zero, none NaN.
#[test]
fn limiters_survive_subnormal_slopes() {
    fn check<T: Float>(tiny: T) {
        for limiter in LIMITERS {
            let got = limited_slope(limiter, tiny, tiny).to_f64();
            assert!(got == tiny.to_f64() || got == 0.0, "{limiter}: {got:e}");
            assert!(limited_slope(limiter, tiny, T::one()).to_f64() <= 2.0 * tiny.to_f64(), "{limiter}");
        }
    }
    check(f64::from_bits(3));
    check(f32::from_bits(3));
}

/// By itself: whatever the size, zero has no sign in common with anything.
#[test]
fn a_size_gets_the_sign_that_both_slopes_have() {
    for (a, b, due) in [
        (2.0, 5.0, 3.0),
        (-2.0, -5.0, -3.0),
        (2.0, -5.0, 0.0),
        (2.0, 0.0, 0.0),
        (2.0, -0.0, 0.0),
        (-2.0, 0.0, 0.0),
        (-2.0, -0.0, 0.0),
        (0.0, -0.0, 0.0),
        (2.0, f64::NAN, 0.0),
        (-2.0, f64::NAN, 0.0),
    ] {
        assert_eq!((with_common_sign(3.0, a, b), with_common_sign(3.0, b, a)), (due, due), "{a}, {b}");
    }
}
