//! Limiters of two slopes: PL20 (13)-(16).
//!
//! All are symmetric, odd, homogeneous of degree one, give back equal slopes, and are zero unless both slopes have one sign. In
//! magnitude minmod, van Leer, monotonized central, Superbee ascend. Signs are compared one by one: a product of slopes would
//! underflow or overflow. No intermediate is larger than the larger slope.

use crate::schemes::SlopeLimiter;
use etalon_kernels_gen::functions::ratio_or_zero;
use etalon_kernels_gen::{Real, equation};

/// The slope that stands for both: by a limiter, or without one their mean.
///
/// Replaces half the sum of the slopes of PL20 (10). Source: PL20 section 2.4.
#[equation(unnumbered = "the choice of a slope limiter, PL20 section 2.4")]
pub fn limited_slope<R: Real>(limiter: SlopeLimiter, slope_a: R, slope_i: R) -> R {
    match limiter {
        SlopeLimiter::Unlimited => 0.5 * slope_a + 0.5 * slope_i,
        SlopeLimiter::Minmod => slope_minmod(slope_a, slope_i),
        SlopeLimiter::VanLeer => slope_van_leer(slope_a, slope_i),
        SlopeLimiter::MonotonizedCentral => slope_monotonized_central(slope_a, slope_i),
        SlopeLimiter::Superbee => slope_superbee(slope_a, slope_i),
    }
}

/// Minmod: the slope of smaller magnitude.
///
/// Source: PL20 (13).
#[equation("pl20:13")]
pub fn slope_minmod<R: Real>(slope_a: R, slope_b: R) -> R {
    let small = slope_a.abs().min(slope_b.abs());
    with_common_sign(small, slope_a, slope_b)
}

/// Van Leer's harmonic mean, `2 a b / (a + b)`.
///
/// Computed as `s 2 / (1 + s/l)` with the smaller magnitude `s` and the larger `l`. Source: PL20 (14).
#[equation("pl20:14")]
pub fn slope_van_leer<R: Real>(slope_a: R, slope_b: R) -> R {
    let small = slope_a.abs().min(slope_b.abs());
    let large = slope_a.abs().max(slope_b.abs());
    let factor = 2.0 / (1.0 + ratio_or_zero(small, large));
    with_common_sign(small * factor, slope_a, slope_b)
}

/// Van Leer's monotonized central slope: the mean, but at most twice the smaller, `min(|a + b| / 2, 2 |a|, 2 |b|)`.
///
/// Computed as `s + min((l - s) / 2, s)` with the smaller magnitude `s` and the larger `l`. Source: PL20 (15).
#[equation("pl20:15")]
pub fn slope_monotonized_central<R: Real>(slope_a: R, slope_b: R) -> R {
    let small = slope_a.abs().min(slope_b.abs());
    let large = slope_a.abs().max(slope_b.abs());
    let size = small + small.min(0.5 * (large - small));
    with_common_sign(size, slope_a, slope_b)
}

/// Superbee: the larger slope, but at most twice the smaller, `max[min(|b|, 2 |a|), min(2 |b|, |a|)]`.
///
/// Computed as `s + min(l - s, s)` with the smaller magnitude `s` and the larger `l`, without any rounding error. Source: PL20 (16).
#[equation("pl20:16")]
pub fn slope_superbee<R: Real>(slope_a: R, slope_b: R) -> R {
    let small = slope_a.abs().min(slope_b.abs());
    let large = slope_a.abs().max(slope_b.abs());
    let size = small + small.min(large - small);
    with_common_sign(size, slope_a, slope_b)
}

/// A magnitude with the sign that both slopes have; zero where they have none in common.
///
/// Source: the cases of PL20 (13)-(16).
#[equation("pl20:13", "pl20:14", "pl20:15", "pl20:16")]
pub fn with_common_sign<R: Real>(size: R, slope_a: R, slope_b: R) -> R {
    if slope_a > 0.0 && slope_b > 0.0 {
        size
    } else if slope_a < 0.0 && slope_b < 0.0 {
        -size
    } else {
        0.0
    }
}
