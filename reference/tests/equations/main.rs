//! Every equation by itself: exact values, limits, symmetries, derivatives and hard inputs.
//!
//! A check is meant to fail for any wrong sign, factor, exponent or argument; tolerances are counted in roundings and
//! say from where.

mod both_sides;
#[path = "../support/check.rs"]
mod check;
#[path = "../support/cloud.rs"]
mod cloud;
mod dissipation;
mod dual;
mod float;
mod gas_and_steps;
mod grad_h;
mod gradients;
mod hard_inputs;
mod hydrodynamics;
mod kernels;
mod motion;
#[cfg(feature = "mutants")]
mod mutants;
mod quadrature;
mod reconstruction;
mod velocity_gradients;
mod volume_elements;
