//! The problems that are run: initial state, boundaries, physics, end time and what to compare with.

mod again;
pub mod double_blast;
pub mod dusty;
pub mod dustybox;
pub mod dustyshock;
pub mod dustywave;
mod ending;
mod error;
pub mod even_gas;
mod filling;
mod gas_and_dust;
pub mod gas_tube;
mod glass;
pub mod gresho_chan;
pub mod hydrostatic;
pub mod kelvin_helmholtz;
mod lattice;
mod layers;
mod measures;
pub mod membrane;
mod method;
pub mod mirror;
pub mod noh;
mod plateau;
mod problem;
pub mod rayleigh_taylor;
mod scene;
pub mod sedov;
mod shock_tube;
pub mod sod;
mod state;
pub mod static_square;
pub mod turbulence;
mod view;
pub mod wind_cloud;

pub use ending::{AtEnd, Axis, Course, Curve, Expected};
pub use error::SceneError;
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
