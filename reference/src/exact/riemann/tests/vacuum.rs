//! Vacuum that is there, vacuum that opens, and states just short of it.

use super::properties::assert_conserves;
use super::{assert_close, solve, state};
use crate::exact::riemann::{State, Wave};

const GAMMA: f64 = 5.0 / 3.0;

#[test]
fn gas_expands_into_vacuum_at_two_sound_speeds_over_gamma_minus_one() {
    let gas = state(2.0, 0.5, 3.0);
    let problem = solve(gas, State::vacuum(), GAMMA);
    let sound_speed = (GAMMA * 1.5_f64).sqrt();
    let front = 0.5 + 3.0 * sound_speed;
    let Some(Wave::Rarefaction { head, tail }) = problem.left_wave() else { panic!("a fan") };
    assert_close("head", head, 0.5 - sound_speed, 8.0 * f64::EPSILON);
    assert_close("front", tail, front, 16.0 * f64::EPSILON * front);
    assert_eq!((problem.star(), problem.contact(), problem.right_wave()), (None, None, None));
    assert_eq!(problem.sample(tail + 1e-9), state(0.0, tail, 0.0));
    // Close to the front, v -> front and rho -> 0 without a jump.
    let sample = problem.sample(tail - 1e-6);
    assert!(sample.density > 0.0 && sample.density < 1e-15, "{sample:?}");
    assert_close("v", sample.velocity, tail, 1e-6);
    assert_conserves(&problem, gas, State::vacuum(), GAMMA);
    // The mirror image.
    let mirrored = solve(State::vacuum(), state(2.0, -0.5, 3.0), GAMMA);
    assert_eq!(mirrored.right_wave(), Some(Wave::Rarefaction { head: -head, tail: -tail }));
    assert_eq!(mirrored.sample(-tail - 1.0), state(0.0, -tail, 0.0));
    assert_conserves(&mirrored, State::vacuum(), state(2.0, -0.5, 3.0), GAMMA);
}

#[test]
fn nothing_stays_nothing() {
    let problem = solve(State::vacuum(), State::vacuum(), GAMMA);
    for xi in [-1.0, 0.0, 2.0] {
        assert!(problem.sample(xi).is_vacuum());
    }
    assert_eq!((problem.left_wave(), problem.right_wave(), problem.star()), (None, None, None));
}

#[test]
fn vacuum_opens_when_the_sides_part_faster_than_their_fronts() {
    let (left, right) = (state(1.0, -10.0, 1.0), state(0.5, 8.0, 0.25));
    let problem = solve(left, right, GAMMA);
    let fronts = [-10.0 + 3.0 * GAMMA.sqrt(), 8.0 - 3.0 * (GAMMA * 0.5).sqrt()];
    assert!(fronts[0] < fronts[1], "the test is about a true gap");
    assert_eq!(problem.star(), None);
    assert_close("left front", problem.left_wave().unwrap().tail(), fronts[0], 32.0 * f64::EPSILON);
    assert_close("right front", problem.right_wave().unwrap().tail(), fronts[1], 32.0 * f64::EPSILON);
    assert_eq!(problem.sample(0.0), state(0.0, 0.0, 0.0));
    assert_eq!(problem.sample(-1.0), state(0.0, -1.0, 0.0));
    assert!(problem.sample(fronts[0] - 0.1).density > 0.0);
    assert!(problem.sample(fronts[1] + 0.1).density > 0.0);
    assert_conserves(&problem, left, right, GAMMA);
}

#[test]
fn just_short_of_vacuum_the_pressure_is_that_of_the_two_fans() {
    // Equal states parting at (1 - s) of the limit: (p/p_0)^((gamma-1)/2gamma) = s, so p* = s^5 for gamma = 5/3.
    let limit = 3.0 * GAMMA.sqrt();
    for short in [1e-1_f64, 1e-3, 1e-6, 1e-9, 1e-12] {
        let speed = limit * (1.0 - short);
        let problem = solve(state(1.0, -speed, 1.0), state(1.0, speed, 1.0), GAMMA);
        let star = problem.star().expect("not yet vacuum");
        // s is a difference of numbers near 1, each a few epsilon off, and is taken to its fifth power.
        let tolerance = 5.0 * 8.0 * f64::EPSILON / short + 64.0 * f64::EPSILON;
        assert_close("p*/s^5", star.pressure / short.powi(5), 1.0, tolerance);
        assert_close("u*", star.velocity, 0.0, 8.0 * f64::EPSILON * limit);
        assert!(problem.sample(0.0).density > 0.0);
    }
    let gone = solve(state(1.0, -limit * (1.0 + 1e-12), 1.0), state(1.0, limit * (1.0 + 1e-12), 1.0), GAMMA);
    assert_eq!(gone.star(), None);
}

#[test]
fn cold_gas_on_one_side_or_both() {
    // Hot gas against cold: a shock of full compression, however thin the cold gas is.
    for density in [1.0, 1e-10, 1e-100, 1e-200] {
        let (left, right) = (state(1.0, 0.0, 1.0), state(density, 0.0, 0.0));
        let problem = solve(left, right, GAMMA);
        let star = problem.star().expect("not vacuum");
        assert!(star.pressure > 0.0 && star.pressure < 1.0, "{star:?}");
        assert_close("compression", star.density_right / density, 4.0, 16.0 * f64::EPSILON);
        // p = (gamma+1)/2 rho u^2 behind a strong shock.
        let ram = (GAMMA + 1.0) / 2.0 * density * star.velocity * star.velocity;
        assert_close("p*", star.pressure / ram, 1.0, 64.0 * f64::EPSILON);
        if density == 1.0 {
            assert_conserves(&problem, left, right, GAMMA);
        }
    }
    // So thin that the pressure underflows: the hot gas behaves as into vacuum, with nothing but finite numbers.
    let star = solve(state(1.0, 0.0, 1.0), state(1e-323, 0.0, 0.0), GAMMA).star().expect("not vacuum");
    assert_close("u*", star.velocity, 3.0 * GAMMA.sqrt(), 1e-9);
    // Pressureless on both sides: parting leaves vacuum, resting leaves everything.
    let parting = solve(state(1.0, -1.0, 0.0), state(1.0, 1.0, 0.0), GAMMA);
    assert_eq!(parting.sample(-1.5), state(1.0, -1.0, 0.0));
    assert_eq!(parting.sample(0.25), state(0.0, 0.25, 0.0));
    assert_eq!(parting.sample(1.5), state(1.0, 1.0, 0.0));
    let resting = solve(state(1.0, 0.0, 0.0), state(2.0, 0.0, 0.0), GAMMA);
    assert_eq!((resting.sample(-1e-9), resting.sample(1e-9)), (state(1.0, 0.0, 0.0), state(2.0, 0.0, 0.0)));
}

#[test]
fn a_pressure_too_small_for_the_number_type_spoils_nothing_else() {
    // gamma = 1.001, parting at s = 1/2 short of vacuum: p* = 2^-2002 = 0 in f64, but the sound speed is c/2.
    let gamma: f64 = 1.001;
    let sound_speed = gamma.sqrt();
    let speed = 0.5 * 2.0 * sound_speed / (gamma - 1.0);
    let problem = solve(state(1.0, -speed, 1.0), state(1.0, speed, 1.0), gamma);
    let star = problem.star().expect("not vacuum");
    assert_eq!((star.pressure, star.velocity), (0.0, 0.0));
    // The tail is c/2 from the contact, up to the rounding of the fronts, which are a thousand times as fast.
    let tolerance = 4.0 * f64::EPSILON * speed;
    assert_close("tail", problem.left_wave().unwrap().tail(), -0.5 * sound_speed, tolerance);
    assert_close("tail", problem.right_wave().unwrap().tail(), 0.5 * sound_speed, tolerance);
    // 20 sound speeds into the fan: xi = -speed - c + 20 c.
    let sample = problem.sample(-speed + 19.0 * sound_speed);
    let ratio = 1.0 - (gamma - 1.0) / (gamma + 1.0) * 20.0;
    // The power 2/(gamma-1) = 2000 amplifies the rounding of xi, 1e-13 of c, and of the base here.
    let expected = ratio.powf(2.0 / (gamma - 1.0));
    assert_close(
        "rho",
        sample.density / expected,
        1.0,
        2000.0 * (2.0 * f64::EPSILON + (gamma - 1.0) / 2.0 * f64::EPSILON * speed),
    );
}
