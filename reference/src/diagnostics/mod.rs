//! What is measured on a run beside its error: the entropy of its gas, and what its viscosity does.

pub mod cloud_mass;
pub mod entropy;
pub mod front_width;
pub mod mode_amplitude;
pub mod sign_reversal;
