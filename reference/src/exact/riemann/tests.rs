//! The table of known solutions, the conservation laws, and everything that is close to vacuum.

mod properties;
mod refusals;
mod vacuum;

use super::{RiemannProblem, State, Wave};

pub(super) fn state(density: f64, velocity: f64, pressure: f64) -> State<f64> {
    State { density, velocity, pressure }
}

pub(super) fn solve(left: State<f64>, right: State<f64>, gamma: f64) -> RiemannProblem<f64> {
    RiemannProblem::new(left, right, gamma).expect("these states are fine")
}

fn sod(gamma: f64) -> RiemannProblem<f64> {
    solve(state(1.0, 0.0, 1.0), state(0.125, 0.0, 0.1), gamma)
}

/// Within `tolerance` of a printed figure; error and tolerance are printed.
fn assert_close(what: &str, value: f64, expected: f64, tolerance: f64) {
    let error = (value - expected).abs();
    println!("{what}: {value:?}, error {error:e}, tolerance {tolerance:e}");
    assert!(error <= tolerance, "{what}: {value:?} is not {expected:?}: error {error:e}, tolerance {tolerance:e}");
}

/// Figures are given with 15 significant digits: half a unit of the last, and for the solution's own rounding 8 epsilon.
fn assert_printed(what: &str, value: f64, expected: f64) {
    let last_digit = 10_f64.powi(expected.abs().log10().floor() as i32 - 14);
    assert_close(what, value, expected, 0.5 * last_digit + 8.0 * f64::EPSILON * expected.abs());
}

#[test]
fn sod_tube_has_its_known_figures() {
    // gamma, p*, u*, rho*L, rho*R, shock, head, tail: computed with 40 digits.
    let rows = [
        [
            5.0 / 3.0,
            0.293945187666018,
            0.841194852168808,
            0.479689058720917,
            0.229805749311947,
            1.84447336705382,
            -1.29099444873581,
            -0.169401312510728,
        ],
        [
            1.4,
            0.303130178050647,
            0.92745262004895,
            0.426319428178495,
            0.265573711705307,
            1.75215573203018,
            -1.18321595661992,
            -0.0702728125611833,
        ],
    ];
    for [gamma, pressure, velocity, density_left, density_right, shock, head, tail] in rows {
        let problem = sod(gamma);
        let star = problem.star().expect("no vacuum");
        assert_printed("p*", star.pressure, pressure);
        assert_printed("u*", star.velocity, velocity);
        assert_printed("rho*L", star.density_left, density_left);
        assert_printed("rho*R", star.density_right, density_right);
        assert_eq!(problem.contact(), Some(star.velocity));
        let left = problem.left_wave().expect("gas");
        assert_printed("head", left.head(), head);
        // The tail is a difference of numbers near 0.8 to 1: their last places count, not its own.
        assert_close("tail", left.tail(), tail, 1e-15 + 8.0 * f64::EPSILON);
        assert_eq!(left.shock(), None);
        let right = problem.right_wave().expect("gas");
        assert_printed("shock", right.shock().expect("a shock"), shock);
        assert_eq!((right.head(), right.tail()), (right.shock().unwrap(), right.shock().unwrap()));
        // Mach number of the shock: 1.59736 and 1.65563 to six digits.
        let mach = shock / (gamma * 0.1 / 0.125).sqrt();
        assert_close("Mach", mach, if gamma == 1.4 { 1.65563 } else { 1.59736 }, 0.5e-5);
    }
}

#[test]
fn sod_tube_at_time_0_2_has_its_known_places() {
    let places = [
        (5.0 / 3.0, [0.2418011, 0.4661197, 0.6682390, 0.8688947]),
        (1.4, [0.2633568, 0.4859454, 0.6854905, 0.8504311]),
    ];
    for (gamma, expected) in places {
        let problem = sod(gamma);
        let (left, right) = (problem.left_wave().unwrap(), problem.right_wave().unwrap());
        let speeds = [left.head(), left.tail(), problem.contact().unwrap(), right.head()];
        for (speed, place) in speeds.into_iter().zip(expected) {
            assert_close("place", 0.5 + 0.2 * speed, place, 0.5e-7);
        }
    }
}

#[test]
fn fan_of_the_sod_tube_follows_the_textbook_formula() {
    // v = 2/(gamma+1) (c_L + xi), c = c_L - (gamma-1)/2 v, rho ~ c^(2/(gamma-1)), p ~ rho^gamma.
    let gamma: f64 = 1.4;
    let problem = sod(gamma);
    let sound_speed = gamma.sqrt();
    for k in 0..=50 {
        let xi = -1.18 + 1.10 * f64::from(k) / 50.0;
        let velocity = 2.0 / (gamma + 1.0) * (sound_speed + xi);
        let ratio = 1.0 - (gamma - 1.0) / 2.0 * velocity / sound_speed;
        let sample = problem.sample(xi);
        // A power amplifies the rounding of its base (2 epsilon) by its exponent, 5 and 7; the rest is 8 more.
        assert_close("v", sample.velocity, velocity, 8.0 * f64::EPSILON);
        assert_close("rho", sample.density, ratio.powf(5.0), 18.0 * f64::EPSILON);
        assert_close("p", sample.pressure, ratio.powf(7.0), 22.0 * f64::EPSILON);
    }
}

#[test]
fn samples_on_either_side_of_the_waves() {
    let problem = sod(5.0 / 3.0);
    let star = problem.star().unwrap();
    let shock = problem.right_wave().unwrap().head();
    assert_eq!(problem.sample(-1.2909945), state(1.0, 0.0, 1.0));
    assert_eq!(problem.sample(f64::NEG_INFINITY), state(1.0, 0.0, 1.0));
    assert_eq!(problem.sample(0.0), state(star.density_left, star.velocity, star.pressure));
    assert_eq!(problem.sample(star.velocity), state(star.density_left, star.velocity, star.pressure));
    assert_eq!(problem.sample(0.8411949), state(star.density_right, star.velocity, star.pressure));
    assert_eq!(problem.sample(shock - 1e-12), state(star.density_right, star.velocity, star.pressure));
    assert_eq!(problem.sample(shock + 1e-12), state(0.125, 0.0, 0.1));
    assert_eq!(problem.sample(f64::INFINITY), state(0.125, 0.0, 0.1));
}

#[test]
fn toros_five_tests() {
    // Toro (2009), tables 4.1 and 4.2, gamma = 1.4; expected p*, u*, rho*L, rho*R as printed, with the unit of the last
    // digit, of which half is the tolerance (and a thousandth for figures that end in 5).
    // The fifth test collides the shocked gases of the third and the fourth.
    let blast = |left: f64, right: f64| solve(state(1.0, 0.0, left), state(1.0, 0.0, right), 1.4).star().unwrap();
    let (third, fourth) = (blast(1000.0, 0.01), blast(0.01, 100.0));
    let a = state(third.density_right, third.velocity, third.pressure);
    let b = state(fourth.density_left, fourth.velocity, fourth.pressure);
    let rows = [
        (state(1.0, 0.0, 1.0), state(0.125, 0.0, 0.1), [0.30313, 0.92745, 0.42632, 0.26557], [1e-5; 4]),
        (state(1.0, -2.0, 0.4), state(1.0, 2.0, 0.4), [0.00189, 0.0, 0.02185, 0.02185], [1e-5; 4]),
        (
            state(1.0, 0.0, 1000.0),
            state(1.0, 0.0, 0.01),
            [460.894, 19.5975, 0.57506, 5.99924],
            [1e-3, 1e-4, 1e-5, 1e-5],
        ),
        (
            state(1.0, 0.0, 0.01),
            state(1.0, 0.0, 100.0),
            [46.0950, -6.19633, 5.99242, 0.57511],
            [1e-4, 1e-5, 1e-5, 1e-5],
        ),
        (a, b, [1691.64, 8.68975, 14.2823, 31.0426], [1e-2, 1e-5, 1e-4, 1e-4]),
    ];
    for (left, right, expected, units) in rows {
        let star = solve(left, right, 1.4).star().expect("no vacuum");
        let values = [star.pressure, star.velocity, star.density_left, star.density_right];
        for ((value, expected), unit) in values.into_iter().zip(expected).zip(units) {
            assert_close("Toro", value, expected, 0.501 * unit);
        }
    }
}

#[test]
fn equal_states_stay_as_they_are() {
    for gamma in [1.0001, 1.4, 5.0 / 3.0, 3.0] {
        let gas = state(0.3, 17.0, 2.5e-7);
        let star = solve(gas, gas, gamma).star().expect("no vacuum");
        assert_eq!((star.pressure, star.velocity), (gas.pressure, gas.velocity));
        assert_eq!((star.density_left, star.density_right), (gas.density, gas.density));
    }
}

#[test]
fn a_lone_contact_stays_as_it_is() {
    let problem = solve(state(1e3, -2.0, 0.7), state(1e-3, -2.0, 0.7), 1.4);
    assert_eq!(problem.sample(-2.0 - 1e-9), state(1e3, -2.0, 0.7));
    assert_eq!(problem.sample(-2.0 + 1e-9), state(1e-3, -2.0, 0.7));
}

#[test]
fn strong_shocks_reach_the_limit_of_compression() {
    // Pressure ratio 1e10: the shocked density is (gamma+1)/(gamma-1) times the initial one up to 1/p-ratio of the shock.
    let gamma = 5.0 / 3.0;
    let star = solve(state(1.0, 0.0, 1e10), state(1.0, 0.0, 1.0), gamma).star().expect("no vacuum");
    let mu = (gamma - 1.0) / (gamma + 1.0);
    let (p, bound) = (star.pressure, 16.0 * f64::EPSILON);
    assert_close("compression", star.density_right, (p + mu) / (mu * p + 1.0), 4.0 * bound);
    assert!((star.density_right - 4.0).abs() < 16.0 / p, "{star:?}");
    // A cold wall of gas: two streams of density 1 meet at speed 1. p* = (gamma+1)/2 and density 4, exactly.
    let cold = solve(state(1.0, 1.0, 0.0), state(1.0, -1.0, 0.0), gamma);
    let star = cold.star().expect("no vacuum");
    assert_close("p*", star.pressure, 4.0 / 3.0, bound);
    assert_close("u*", star.velocity, 0.0, bound);
    assert_close("rho*", star.density_left, 4.0, bound);
    let Some(Wave::Shock { speed }) = cold.left_wave() else { panic!("a shock runs into the left stream") };
    assert_close("speed", speed, -1.0 / 3.0, bound);
}

#[test]
fn single_precision_agrees_with_double() {
    let single = |density, velocity, pressure| State::<f32> { density, velocity, pressure };
    let problem = RiemannProblem::new(single(1.0, 0.0, 1.0), single(0.125, 0.0, 0.1), 1.4).unwrap();
    let exact = sod(1.4).star().unwrap();
    let star = problem.star().unwrap();
    // The inputs 0.1 and 1.4 are rounded (half an epsilon each) and the solution's own steps add a few.
    let tolerance = 8.0 * f64::from(f32::EPSILON);
    assert_close("p*", f64::from(star.pressure), exact.pressure, tolerance * exact.pressure);
    assert_close("u*", f64::from(star.velocity), exact.velocity, tolerance * exact.velocity);
}
