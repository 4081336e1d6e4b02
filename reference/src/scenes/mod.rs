//! The problems that are run: initial state, boundaries, physics, end time and what to compare with.

mod error;
pub mod even_gas;
mod filling;
pub mod gas_tube;
mod glass;
pub mod gresho_chan;
pub mod hydrostatic;
pub mod kelvin_helmholtz;
mod lattice;
mod layers;
mod measures;
mod method;
pub mod noh;
mod problem;
pub mod rayleigh_taylor;
mod scene;
pub mod sedov;
mod shock_tube;
pub mod sod;
mod state;
pub mod static_square;
mod view;
pub mod wind_cloud;

pub use error::SceneError;
pub use filling::{Block, Filling};
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
