//! Every equation by itself: exact values, limits, symmetries, derivatives and hard inputs.
//!
//! A check is meant to fail for any wrong sign, factor, exponent or argument; tolerances are counted in roundings and
//! say from where.

mod both_sides;
#[path = "../support/check.rs"]
mod check;
#[path = "../support/cloud.rs"]
mod cloud;
mod conduction;
mod diagnostics;
mod dissipation;
mod double_hump;
mod drag;
mod dual;
mod dust_drawn;
mod dust_reconstruction;
mod exact_dust;
mod float;
mod formulation;
mod gas_and_steps;
mod grad_h;
mod grad_h_noise;
mod gradients;
mod hard_cases;
mod hard_inputs;
mod hydrodynamics;
mod initial_states;
mod kernels;
mod limiters;
mod motion;
#[cfg(feature = "mutants")]
mod mutants;
mod polar;
mod quadrature;
mod reconstruction;
mod stiff_drag;
mod switch;
mod turbulence;
mod velocity_gradients;
mod volume_elements;
