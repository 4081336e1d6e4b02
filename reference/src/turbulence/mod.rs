//! Driven turbulence: the force that stirs it, and what is measured on it (C25 sections 2 and 3, appendix C; GS25 section 4).
//!
//! - [`forcing`]: a force of a few long waves whose amplitudes are processes of Ornstein and Uhlenbeck;
//! - [`grid`], [`spectrum`]: velocities on a grid, and their power by wave number;
//! - [`structure_function`]: velocity differences by distance (C25 32, 33);
//! - [`density_pdf`]: how density is distributed over mass and over volume;
//! - [`mod@power_law`] fits slopes.
//!
//! These are sums over whole sets, in `f64` on the host. The value-by-value formulas are [`crate::equations::turbulence`].

mod bins;
pub mod density_pdf;
mod error;
pub mod forcing;
pub mod grid;
pub mod power_law;
mod snapshot;
pub mod spectrum;
pub mod structure_function;

pub use bins::Bins;
pub use error::TurbulenceError;
pub use snapshot::Snapshot;
