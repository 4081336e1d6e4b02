//! Fixed-point coordinates: conversion, wrap, separations and their intervals.

use crate::neighbours::{Coordinate, distance_squared};
use proptest::prelude::*;

#[test]
fn fractions_wrap_around() {
    assert_eq!(u32::from_fraction(0.25), 1 << 30);
    assert_eq!(u64::from_fraction(0.25), 1 << 62);
    for (fraction, same) in
        [(-0.25, 0.75), (1.0, 0.0), (3.5, 0.5), (-1e-300, 0.0), (f64::NAN, 0.0), (f64::INFINITY, 0.0)]
    {
        assert_eq!(u32::from_fraction(fraction), u32::from_fraction(same), "{fraction}");
        assert_eq!(u64::from_fraction(fraction), u64::from_fraction(same), "{fraction}");
    }
    // The largest fraction below one neither wraps nor saturates.
    assert_eq!(u32::from_fraction(1.0_f64.next_down()), u32::MAX);
    assert_eq!(u64::from_fraction(1.0_f64.next_down()), !0 << 11);
}

#[test]
fn separations_take_the_shorter_way() {
    let x = u32::from_fraction;
    // Eighths of a length of 8: exact.
    assert_eq!(x(0.875).separation(x(0.125), u32::unit(8.0)), -2.0);
    assert_eq!(x(0.125).separation(x(0.875), u32::unit(8.0)), 2.0);
    let x = u64::from_fraction;
    assert_eq!(x(0.875).separation(x(0.125), u64::unit(8.0)), -2.0);
    // sqrt(2^2 + 1^2 + 2^2) = 3, each by the shorter way.
    let (a, b) = ([x(0.0), x(0.5), x(0.25)], [x(0.75), x(0.625), x(0.0)]);
    assert_eq!(distance_squared(a, b, [8.0; 3].map(u64::unit)), 9.0);
}

proptest! {
    #[test]
    fn fractions_return(fraction in 0.0..1.0f64) {
        // Cut to a multiple of 2^-32 and 2^-53.
        let error = fraction - u32::from_fraction(fraction).to_fraction();
        prop_assert!((0.0..(-32_f64).exp2()).contains(&error), "{error:e}");
        let error = fraction - u64::from_fraction(fraction).to_fraction();
        prop_assert!((0.0..(-53_f64).exp2()).contains(&error), "{error:e}");
    }

    #[test]
    fn intervals_and_hulls_hold_their_points(points in prop::collection::vec(any::<u32>(), 1..20), width in 1u32..) {
        // From narrow to all around the torus.
        let points: Vec<u32> = points.iter().map(|x| x % width).map(|x| x.wrapping_sub(width / 2)).collect();
        let holds = |(centre, half): (u32, u32), x: u32| x.wrapping_sub(centre).cast_signed().unsigned_abs() <= half;
        let whole = u32::interval(&points);
        let parts: Vec<(u32, u32)> = points.chunks(3).map(u32::interval).collect();
        let (centres, halves): (Vec<u32>, Vec<u32>) = parts.into_iter().unzip();
        let hull = u32::hull(&centres, &halves);
        for x in points {
            prop_assert!(holds(whole, x) && holds(hull, x), "{x} is not in {whole:?} or {hull:?}");
        }
        // As narrow as they can be, up to the rounding of a half, where that is not more than half of the torus.
        if width <= 1 << 31 {
            prop_assert!(whole.1 <= width.div_ceil(2) && hull.1 <= width.div_ceil(2) + 2);
        }
    }
}
