//! The problems that are run: initial state, boundaries, physics, end time and what to compare with.

pub mod dustybox;
pub mod dustyshock;
pub mod dustywave;
mod gas_and_dust;
mod glass;
mod lattice;
pub mod sod;

pub use gas_and_dust::DustySceneError;
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
