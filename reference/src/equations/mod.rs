//! The equations, each once. A file per subject; each function's page gives the formula, its symbols and its source.

pub mod conduction;
pub mod dissipation;
pub mod double_hump;
pub mod drag;
pub mod dust_reconstruction;
pub mod equation_of_state;
pub mod grad_h;
pub mod gradients;
pub mod hydrodynamics;
pub mod initial_state;
pub mod kernels;
pub mod limiters;
pub mod polar;
pub mod reconstruction;
pub mod smoothing_length;
pub mod stiff_drag;
pub mod switch;
pub mod time_step;
pub mod turbulence;
pub mod volume_elements;
