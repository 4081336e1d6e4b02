//! What holds for every solution: the equation it solves, the jump conditions, the conservation laws, the symmetries.

use super::{solve, state};
use crate::exact::riemann::{RiemannProblem, State, Wave};
use proptest::prelude::*;

/// Mass, momentum and energy per volume.
fn conserved(s: State<f64>, gamma: f64) -> [f64; 3] {
    let energy = s.pressure / (gamma - 1.0) + 0.5 * s.density * s.velocity * s.velocity;
    [s.density, s.density * s.velocity, energy]
}

/// Their fluxes.
fn fluxes(s: State<f64>, gamma: f64) -> [f64; 3] {
    let [mass, momentum, energy] = conserved(s, gamma);
    [mass * s.velocity, momentum * s.velocity + s.pressure, (energy + s.pressure) * s.velocity]
}

/// The integral of the solution at t = 1 over an interval that holds all waves equals what was there at t = 0 less what
/// has flowed out. Five-point Gauss rule on 64 panels between each two wave edges: interior points only, so jumps do no
/// harm. Near vacuum a fan ends like a broken power of the distance; points crowd there like the fourth power, which makes
/// it smooth, and the rule's error is below rounding. Rounding: 320 terms and samples good to about 20 epsilon (powers up
/// to 11 of a ratio good to 2).
pub(super) fn assert_conserves(problem: &RiemannProblem<f64>, left: State<f64>, right: State<f64>, gamma: f64) {
    const NODES: [(f64, f64); 5] = [
        (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
        (-0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
        (0.0, 0.568_888_888_888_888_9),
        (0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
        (0.906_179_845_938_664, 0.236_926_885_056_189_1),
    ];
    const PANELS: u32 = 64;
    let mut edges: Vec<f64> = problem.contact().into_iter().collect();
    for wave in [problem.left_wave(), problem.right_wave()].into_iter().flatten() {
        edges.extend([wave.head(), wave.tail()]);
    }
    edges.sort_by(f64::total_cmp);
    let width = edges[edges.len() - 1] - edges[0];
    let (from, to) = (edges[0] - 0.1 * width, edges[edges.len() - 1] + 0.1 * width);
    edges.insert(0, from);
    edges.push(to);
    let (mut sum, mut size) = ([0.0; 3], [0.0; 3]);
    for pair in edges.windows(2) {
        let length = pair[1] - pair[0];
        let half = 0.5 / f64::from(PANELS);
        for panel in 0..PANELS {
            let middle = half * f64::from(2 * panel + 1);
            for (node, weight) in NODES {
                let s = middle + half * node;
                let place = s.powi(4) * (35.0 - s * (84.0 - s * (70.0 - s * 20.0)));
                let weight = half * weight * length * 140.0 * (s * (1.0 - s)).powi(3);
                let values = conserved(problem.sample(pair[0] + length * place), gamma);
                for i in 0..3 {
                    sum[i] += weight * values[i];
                    size[i] += weight * values[i].abs();
                }
            }
        }
    }
    let (before, after) = (conserved(left, gamma), conserved(right, gamma));
    let (inflow, outflow) = (fluxes(left, gamma), fluxes(right, gamma));
    for (i, what) in ["mass", "momentum", "energy"].into_iter().enumerate() {
        let expected = -from * before[i] + to * after[i] + inflow[i] - outflow[i];
        let scale =
            size[i] + from.abs() * before[i].abs() + to.abs() * after[i].abs() + inflow[i].abs() + outflow[i].abs();
        let (error, tolerance) = ((sum[i] - expected).abs(), 400.0 * f64::EPSILON * scale);
        println!("{what}: off by {error:e}, tolerance {tolerance:e}");
        assert!(error <= tolerance, "{what}: {} is not {expected}: off by {error:e}, tolerance {tolerance:e}", sum[i]);
    }
}

/// The jump conditions of mass, momentum and energy across a shock at `speed`. Each is a difference of products of numbers
/// good to a few epsilon; velocities enter as differences to the shock, so the scale uses their sizes before subtraction.
fn assert_jumps(outside: State<f64>, inside: State<f64>, speed: f64, gamma: f64) {
    let v = outside.velocity.abs() + inside.velocity.abs() + speed.abs();
    let density = outside.density.max(inside.density);
    let pressure = outside.pressure.max(inside.pressure);
    let energy = density * v * v + pressure * gamma / (gamma - 1.0);
    let scale = [density * v, density * v * v + pressure, energy * v];
    for (i, scale) in scale.into_iter().enumerate() {
        let jump = (fluxes(outside, gamma)[i] - fluxes(inside, gamma)[i])
            - speed * (conserved(outside, gamma)[i] - conserved(inside, gamma)[i]);
        let tolerance = 64.0 * f64::EPSILON * scale;
        assert!(jump.abs() <= tolerance, "jump condition {i}: {jump:e}, tolerance {tolerance:e}");
    }
}

/// $f_K(p)$ as printed in textbooks.
fn textbook_change(s: State<f64>, p: f64, gamma: f64) -> f64 {
    if p > s.pressure {
        let (a, b) = (2.0 / ((gamma + 1.0) * s.density), (gamma - 1.0) / (gamma + 1.0) * s.pressure);
        return (p - s.pressure) * (a / (p + b)).sqrt();
    }
    2.0 * sound_speed(s, gamma) / (gamma - 1.0) * ((p / s.pressure).powf((gamma - 1.0) / (2.0 * gamma)) - 1.0)
}

fn sound_speed(s: State<f64>, gamma: f64) -> f64 {
    (gamma * s.pressure / s.density).sqrt()
}

fn check(left: State<f64>, right: State<f64>, gamma: f64) {
    let problem = solve(left, right, gamma);
    let reach = 2.0 * (sound_speed(left, gamma) + sound_speed(right, gamma)) / (gamma - 1.0);
    let size = reach + left.velocity.abs() + right.velocity.abs();
    let Some(star) = problem.star() else {
        assert!(right.velocity - left.velocity >= reach - 8.0 * f64::EPSILON * size);
        return;
    };
    assert!(star.pressure.is_finite() && star.pressure >= 0.0);
    let (l, r) = (problem.left_wave().expect("gas"), problem.right_wave().expect("gas"));
    let mut scale = size;
    if star.pressure < f64::MIN_POSITIVE {
        // Too small to put into f: both waves are fans, and keep the Riemann invariants u + 2c/(gamma-1), u - 2c/(gamma-1).
        let factor = 2.0 / (gamma - 1.0);
        let drift = [
            left.velocity + factor * sound_speed(left, gamma) - star.velocity - factor * (star.velocity - l.tail()),
            right.velocity - factor * sound_speed(right, gamma) - star.velocity + factor * (r.tail() - star.velocity),
        ];
        let tolerance = 16.0 * f64::EPSILON * size * factor;
        assert!(drift.iter().all(|d| d.abs() <= tolerance), "{star:?}: {drift:?}, tolerance {tolerance:e}");
    } else {
        let change = [textbook_change(left, star.pressure, gamma), textbook_change(right, star.pressure, gamma)];
        scale += change[0].abs() + change[1].abs();
        let residual = change[0] + change[1] + right.velocity - left.velocity;
        // p* is good to 4 epsilon, which moves each f by less than 4 epsilon of its size or of its reach; powf, the
        // quotient inside it and the sums add about as much again for either side.
        let tolerance = 16.0 * f64::EPSILON * scale;
        assert!(residual.abs() <= tolerance, "{star:?}: residual {residual:e}, tolerance {tolerance:e}");
    }
    // Waves stand in order, up to rounding.
    let speeds = [l.head(), l.tail(), star.velocity, r.tail(), r.head()];
    for pair in speeds.windows(2) {
        assert!(pair[0] <= pair[1] + 16.0 * f64::EPSILON * scale, "{speeds:?}");
    }
    for (wave, outside, density) in [(l, left, star.density_left), (r, right, star.density_right)] {
        let inside = state(density, star.velocity, star.pressure);
        match wave {
            Wave::Shock { speed } => {
                assert!(inside.density >= outside.density && inside.pressure > outside.pressure);
                assert_jumps(outside, inside, speed, gamma);
            }
            Wave::Rarefaction { .. } => assert!(inside.density <= outside.density),
        }
    }
    for k in 0..64 {
        let xi = speeds[0] + (speeds[4] - speeds[0]) * f64::from(k) / 63.0;
        let sample = problem.sample(xi);
        assert!(sample.density.is_finite() && sample.velocity.is_finite() && sample.pressure.is_finite());
        assert!(sample.density >= 0.0 && sample.pressure >= 0.0);
    }
    assert_mirrors(left, right, gamma);
}

/// Bit for bit: both sides run through the same operations.
fn assert_mirrors(left: State<f64>, right: State<f64>, gamma: f64) {
    let (problem, image) = (solve(left, right, gamma), solve(right.mirrored(), left.mirrored(), gamma));
    let (star, mirrored) = (problem.star().unwrap(), image.star().unwrap());
    assert_eq!(star.pressure, mirrored.pressure);
    assert_eq!(star.velocity, -mirrored.velocity);
    assert_eq!((star.density_left, star.density_right), (mirrored.density_right, mirrored.density_left));
    for k in 0..32 {
        let xi = star.velocity + (f64::from(k) - 15.5) * 0.1 * (1.0 + star.velocity.abs());
        assert_eq!(problem.sample(xi), image.sample(-xi).mirrored());
    }
}

fn gas() -> impl Strategy<Value = State<f64>> {
    (-8.0..8.0_f64, -1.0..1.0_f64, 0.0..4.0_f64, -10.0..10.0_f64)
        .prop_map(|(rho, sign, speed, p)| state(10_f64.powf(rho), sign * 10_f64.powf(speed), 10_f64.powf(p)))
}

/// Of comparable sizes, so that all four patterns of waves are frequent.
fn mild_gas() -> impl Strategy<Value = State<f64>> {
    (0.1..10.0_f64, -2.0..2.0_f64, 0.1..10.0_f64).prop_map(|(rho, u, p)| state(rho, u, p))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, ..ProptestConfig::default() })]

    #[test]
    fn wild_states_are_solved(left in gas(), right in gas(), gamma in 1.001..3.0_f64) {
        check(left, right, gamma);
    }

    #[test]
    fn mild_states_are_solved(left in mild_gas(), right in mild_gas(), gamma in 1.001..3.0_f64) {
        check(left, right, gamma);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, ..ProptestConfig::default() })]

    #[test]
    fn solutions_conserve_mass_momentum_and_energy(left in mild_gas(), right in mild_gas(), gamma in 1.2..3.0_f64) {
        assert_conserves(&solve(left, right, gamma), left, right, gamma);
    }

    /// Powers of two (even ones where a root is taken) change no digit.
    #[test]
    fn units_do_not_matter(left in gas(), right in gas(), gamma in 1.05..3.0_f64) {
        let (mass, speed) = (2_f64.powi(6), 2_f64.powi(-5));
        let scaled = |s: State<f64>| state(s.density * mass, s.velocity * speed, s.pressure * mass * speed * speed);
        let (problem, other) = (solve(left, right, gamma), solve(scaled(left), scaled(right), gamma));
        match (problem.star(), other.star()) {
            (Some(a), Some(b)) => {
                prop_assert_eq!(a.pressure * mass * speed * speed, b.pressure);
                prop_assert_eq!(a.velocity * speed, b.velocity);
                prop_assert_eq!(a.density_left * mass, b.density_left);
                prop_assert_eq!(a.density_right * mass, b.density_right);
            }
            (a, b) => prop_assert!(a.is_none() && b.is_none()),
        }
    }
}
