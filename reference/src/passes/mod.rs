//! The sweeps over the particles, each defined once for every backend.
//!
//! A step runs [`VolumeElements`] where volume elements are generalised ones, [`Density`], then [`Gradients`] and [`Momentum`]; a scheme that reconstructs velocities takes
//! [`VelocityGradients`] and [`ReconstructedMomentum`] instead, one with a time-dependent coefficient [`VelocityGradients`], [`Switch`] and
//! [`SwitchedMomentum`]. [`Conduction`] follows where it is asked for. What each reads and writes is in its records.
//!
//! Where there is dust in the gas, each of these runs as [`SameSpecies`] or [`GasOnly`] of itself, and [`DragForces`] follows, or
//! [`LinearGradients`] and [`ReconstructedDragForces`].

mod conduction;
mod density;
mod drag_forces;
mod external;
mod gradient_vector;
mod gradients;
mod linear_gradients;
mod momentum;
mod sign_reversal;
mod species;
mod switch;
mod switched_momentum;
mod updates;
mod volume_elements;

pub use conduction::Conduction;
pub use density::Density;
pub use drag_forces::{DragForces, ReconstructedDragForces};
pub use external::{DriveWall, Driver, MoveWall, Push};
pub use gradients::{Gradients, VelocityGradients};
pub use linear_gradients::LinearGradients;
pub use momentum::{Momentum, ReconstructedMomentum};
pub use sign_reversal::SignReversal;
pub use species::{GasOnly, OfSpecies, SameSpecies, is_gas};
pub use switch::{Decay, Switch};
pub use switched_momentum::SwitchedMomentum;
pub use updates::{Correct, KickDrift};
pub use volume_elements::VolumeElements;

use crate::fields;
use crate::schemes::{self, Dissipation, Drag, GradH, Kernel, Viscosity, VolumeElement};
use etalon_kernels_gen::Field;

/// What a scene decides for all its passes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Physics {
    /// The kernel of all sums.
    pub kernel: Kernel,
    /// How derivatives are estimated.
    pub gradients: schemes::Gradients,
    /// Which volume a particle stands for.
    pub volume_element: VolumeElement,
    /// The form of the grad-h factor.
    pub grad_h: GradH,
    /// The dissipation scheme and its coefficients.
    pub viscosity: Viscosity,
    /// `gamma - 1` of the ideal gas.
    pub gamma_minus_one: f64,
    /// The number of neighbours the smoothing length aims at, the particle included.
    pub neighbours: f64,
    /// A constant acceleration of all particles that move, axis by axis; the axes a scene does not have are not looked at.
    pub gravity: [f64; 3],
    /// Drag between gas and dust; none where there is gas only.
    pub drag: Option<Drag>,
    /// What drives the particles that are not mobile, where something does.
    pub driver: Option<Driver>,
    /// Whether particles carry a force that the host makes anew in every step, [`FORCING`](crate::fields::FORCING).
    pub forced: bool,
}

impl Physics {
    /// What a three-dimensional scene takes where it does not say otherwise: the kernel, scheme and neighbour number of GS25, an adiabatic index
    /// of 5/3, no dust, nothing that acts from outside.
    pub const STANDARD: Self = Physics {
        kernel: Kernel::MixedSinc,
        gradients: schemes::Gradients::Integral,
        volume_element: VolumeElement::Generalised,
        grad_h: GradH::Corrected,
        viscosity: Viscosity::of(Dissipation::AvSlrB2),
        gamma_minus_one: 2.0 / 3.0,
        neighbours: 100.0,
        gravity: [0.0; 3],
        drag: None,
        driver: None,
        forced: false,
    };

    /// Whether particles have a field of the sweeps at all, given how gradients and volumes are made. The sweeps' records name what the richest
    /// choice needs; of each choice they use what is here.
    pub fn knows(&self, field: Field) -> bool {
        let generalised = self.volume_element == VolumeElement::Generalised;
        match field {
            fields::MOMENT_MATRIX | fields::GRADIENT_MATRIX => self.gradients == schemes::Gradients::Integral,
            // Where volumes are standard ones the plain density is the density, and the kernel counts as normalised.
            fields::STANDARD_DENSITY
            | fields::VOLUME_ESTIMATOR
            | fields::KERNEL_NORMALISATION
            | fields::VOLUME_ESTIMATOR_DERIVATIVE => generalised,
            fields::PARTITION_DERIVATIVE => generalised || self.grad_h == GradH::Corrected,
            _ => true,
        }
    }

    /// Whether anything pulls in `dimension` dimensions.
    pub fn has_gravity(&self, dimension: usize) -> bool {
        self.gravity[..dimension].iter().any(|g| *g != 0.0)
    }
}
