//! The problems that are run: initial state, boundaries, physics, end time and what to compare with.

pub mod double_blast;
pub mod dustybox;
pub mod dustyshock;
pub mod dustywave;
mod error;
mod even;
mod filling;
mod gas_and_dust;
mod glass;
pub mod gresho_chan;
mod lattice;
mod measures;
pub mod membrane;
mod method;
pub mod mirror;
pub mod noh;
mod problem;
mod scene;
pub mod sedov;
pub mod sod;
mod state;
pub mod turbulence;
mod view;

pub use error::SceneError;
pub(crate) use even::lattice;
pub use filling::{Block, Filling};
pub use gas_and_dust::DustySceneError;
pub use glass::{GlassError, relax};
pub use lattice::Tube;
pub use measures::Compared;
pub use method::Method;
pub use problem::{Definition, Name, Problem, ReadChoices};
pub use scene::{Description, GivenMomentum, Glasses, Measured, Quantity, Scene, Solution};
pub use state::{State, Totals};
pub use view::View;

use crate::choice;

choice! {
    /// How particles are laid out at the start.
    Arrangement, "start" {
        /// On a cubic lattice on each side.
        Lattice = "lattice",
        /// Relaxed from random places to a glass, without direction or order.
        Glass = "glass",
    }
}
