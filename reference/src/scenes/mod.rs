//! The problems that are run: initial state, boundaries, physics, end time and what to compare with.

pub mod double_blast;
mod even;
mod glass;
mod lattice;
pub mod membrane;
pub mod mirror;
pub mod sod;
pub mod turbulence;

pub(crate) use even::lattice;
pub use glass::{GlassError, relax};
pub use lattice::Tube;

/// How particles are laid out at the start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arrangement {
    /// On a cubic lattice on each side.
    Lattice,
    /// Relaxed from random places to a glass, without direction or order.
    Glass,
}
