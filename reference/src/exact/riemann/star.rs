//! The state between the two waves.

use super::side::{Side, two};
use super::{RiemannError, Star};
use num_traits::Float;

/// The doublings that any pressure of the number type can need, and more.
const MOST_STEPS: usize = 3000;
/// After this many Newton steps only the bracket is halved. Newton needed fewer than 20 in 300 000 random problems.
const NEWTON_STEPS: usize = 50;
/// Halvings (of the logarithm) that exhaust every bracket.
const MOST_ITERATIONS: usize = 200;

/// The star state; `None` where vacuum lies between the sides. `right` is mirrored.
pub(super) fn solve<F: Float>(left: &Side<F>, right: &Side<F>) -> Result<Option<Star<F>>, RiemannError> {
    // u_R - u_L: how fast the sides draw apart.
    let parting = -right.state.velocity - left.state.velocity;
    if left.state.is_vacuum() || right.state.is_vacuum() {
        return finite([left.front().unwrap_or(F::zero()), right.front().unwrap_or(F::zero())]).map(|()| None);
    }
    // (u_R - u_L)/2 against (c_L + c_R)/(gamma - 1), not by the difference of the fronts, which rounds more.
    let half_reach = (left.sound_speed + right.sound_speed) / (left.gamma - F::one());
    finite([parting, half_reach])?;
    if parting >= two::<F>() * half_reach {
        return Ok(None);
    }
    let (pressure, changes) = star_pressure(left, right, parting)?;
    let star = Star {
        pressure,
        velocity: star_velocity(left, right, pressure, changes),
        density_left: left.density_behind(pressure),
        density_right: right.density_behind(pressure),
    };
    finite([star.pressure, star.velocity, star.density_left, star.density_right])?;
    Ok(Some(star))
}

/// The root of f(p) = f_L(p) + f_R(p) + u_R - u_L, which grows with p and is negative at p = 0; and f_L and f_R there.
fn star_pressure<F: Float>(left: &Side<F>, right: &Side<F>, parting: F) -> Result<(F, [F; 2]), RiemannError> {
    let least = left.state.pressure.min(right.state.pressure);
    let changes = |p: F| [left.velocity_change(p), right.velocity_change(p)];
    let [change_left, change_right] = changes(least);
    if least > F::zero() && change_left + change_right + parting >= F::zero() {
        return Ok(two_fans(left, right, parting, least));
    }
    let pressure = with_a_shock(left, right, parting, least)?;
    Ok((pressure, changes(pressure)))
}

/// The root where at least one wave is a shock: Newton's method, held in a bracket.
fn with_a_shock<F: Float>(left: &Side<F>, right: &Side<F>, parting: F, least: F) -> Result<F, RiemannError> {
    let mismatch = |p: F| left.velocity_change(p) + right.velocity_change(p) + parting;
    let (low, high) = bracket(left, right, parting, least)?;
    if low.is_zero() {
        return Ok(F::zero()); // the pressure is below what the number type can hold
    }
    let (mut low, mut high) = (low, high);
    let mut p = low.sqrt() * high.sqrt();
    for iteration in 0..MOST_ITERATIONS {
        let value = mismatch(p);
        if value < F::zero() {
            low = p;
        } else {
            high = p;
        }
        // Newton's step in ln p, where f is convex.
        let slope = left.velocity_slope(p) + right.velocity_slope(p);
        let newton = p * (-value / slope).exp();
        let inside = low < newton && newton < high;
        let next = if inside && iteration < NEWTON_STEPS { newton } else { low.sqrt() * high.sqrt() };
        let moved = (next - p).abs();
        // A Newton step that ends on the bracket's end has arrived; so has a bracket of neighbouring numbers.
        let arrived = (newton - p).abs() <= two::<F>() * F::epsilon() * p;
        if arrived || moved.is_zero() || high - low <= two::<F>() * F::epsilon() * low {
            return Ok(if inside { next } else { p });
        }
        p = next;
    }
    Ok(p)
}

/// Both waves are fans: f is linear in z = (p/p_min)^e, e = (gamma-1)/2gamma, so the root is known. The velocity changes
/// come from z as well, which remains a good number when p, a high power of it, has become too small for the number type.
fn two_fans<F: Float>(left: &Side<F>, right: &Side<F>, parting: F, least: F) -> (F, [F; 2]) {
    let (exponent, half) = (left.exponent(), (left.gamma - F::one()) / two());
    // (p_min/p_K)^e - 1 <= 0, with all its digits for gamma close to 1.
    let drops = [left, right].map(|side| (exponent * side.log_ratio(least)).exp_m1());
    let lost = -(left.sound_speed * drops[0] + right.sound_speed * drops[1]);
    let total = left.sound_speed * (F::one() + drops[0]) + right.sound_speed * (F::one() + drops[1]);
    let z_minus_one = ((lost - half * parting) / total).min(F::zero());
    let log_z = if z_minus_one + z_minus_one > -F::one() {
        z_minus_one.ln_1p()
    } else {
        // Near vacuum: the same numerator plus the total, with less rounding.
        let reach = left.sound_speed + right.sound_speed - half * parting;
        (reach.max(F::zero()) / total).ln()
    };
    let change = |side: &Side<F>, drop: F| side.sound_speed / half * (z_minus_one * (F::one() + drop) + drop);
    (least * (log_z / exponent).exp(), [change(left, drops[0]), change(right, drops[1])])
}

/// Pressures of negative and of non-negative mismatch. The lower one is 0 only if no positive number would do.
fn bracket<F: Float>(left: &Side<F>, right: &Side<F>, parting: F, least: F) -> Result<(F, F), RiemannError> {
    let mismatch = |p: F| left.velocity_change(p) + right.velocity_change(p) + parting;
    let sixteen = two::<F>().powi(4);
    let greatest = left.state.pressure.max(right.state.pressure);
    let ram = left.state.density.max(right.state.density) * parting * parting;
    let mut high = greatest.max(if ram.is_finite() { ram } else { F::zero() }).max(F::min_positive_value());
    let mut low = least;
    for _ in 0..MOST_STEPS {
        if mismatch(high) >= F::zero() {
            break;
        }
        low = high;
        high = high * sixteen;
        finite([high])?;
    }
    if low.is_zero() {
        // One side is cold, so the pressure may lie anywhere below.
        low = high;
        for _ in 0..MOST_STEPS {
            low = low / sixteen;
            if low.is_zero() || mismatch(low) < F::zero() {
                break;
            }
            high = low;
        }
    }
    Ok((low, high))
}

/// u_* = u_L - f_L = u_R + f_R, from the side that moves less when p_* changes in its last digit.
fn star_velocity<F: Float>(left: &Side<F>, right: &Side<F>, pressure: F, changes: [F; 2]) -> F {
    let [change_left, change_right] = changes;
    let from_left = left.state.velocity - change_left;
    let from_right = -right.state.velocity + change_right;
    let unsure_left = change_left.abs() + left.velocity_slope(pressure);
    let unsure_right = change_right.abs() + right.velocity_slope(pressure);
    if unsure_left < unsure_right {
        from_left
    } else if unsure_left > unsure_right {
        from_right
    } else {
        (from_left + from_right) / two()
    }
}

fn finite<F: Float, const N: usize>(values: [F; N]) -> Result<(), RiemannError> {
    if values.iter().all(|value| value.is_finite()) { Ok(()) } else { Err(RiemannError::Overflow) }
}
