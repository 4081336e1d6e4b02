//! What is refused, in which words.

use super::state;
use crate::exact::riemann::{RiemannError, RiemannProblem, State};

fn message(left: State<f64>, right: State<f64>, gamma: f64) -> String {
    RiemannProblem::new(left, right, gamma).expect_err("this must be refused").to_string()
}

#[test]
fn every_refusal_names_side_field_and_remedy() {
    let fine = state(1.0, 0.0, 1.0);
    let cases = [
        (message(state(f64::NAN, 0.0, 1.0), fine, 1.4), "the density of the left state is NaN: give a finite number"),
        (
            message(fine, state(1.0, f64::INFINITY, 1.0), 1.4),
            "the velocity of the right state is inf: give a finite number",
        ),
        (message(fine, state(1.0, 0.0, f64::NAN), 1.4), "the pressure of the right state is NaN: give a finite number"),
        (
            message(state(-1.0, 0.0, 1.0), fine, 1.4),
            "the density of the left state is -1: give a positive number, or 0 for both density and pressure if it is vacuum",
        ),
        (
            message(fine, state(1.0, 0.0, -0.5), 1.4),
            "the pressure of the right state is -0.5: give a positive number, or 0 for both density and pressure if it is vacuum",
        ),
        (
            message(fine, state(0.0, 0.0, 1.0), 1.4),
            "the density of the right state is 0 but its pressure is 1: give a positive density, or a pressure of 0 for vacuum",
        ),
    ];
    for (message, expected) in cases {
        assert_eq!(message, expected);
    }
    for gamma in [1.0, 0.5, -2.0, f64::NAN, f64::INFINITY] {
        assert_eq!(
            message(fine, fine, gamma),
            format!("the adiabatic index gamma is {gamma}: give a finite number above 1")
        );
    }
}

#[test]
fn overflow_is_said_and_not_returned() {
    let streams = |speed| RiemannProblem::new(state(1.0, speed, 1.0), state(1.0, -speed, 1.0), 1.4);
    assert_eq!(streams(1e200), Err(RiemannError::Overflow));
    assert_eq!(streams(1.7e308), Err(RiemannError::Overflow));
    assert!(streams(1e150).is_ok());
}
