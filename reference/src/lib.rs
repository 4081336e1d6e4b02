//! Every equation once, the passes built from them, scenes and exact solutions.
//!
//! - [`equations`]: one function per equation of the papers, generic over the number;
//! - [`passes`]: the sweeps over particles that are made of them, and [`pipeline`], which finds those a scene needs;
//! - [`engine`]: what a backend must do, and the plain one that does it by direct loops;
//! - [`simulation`]: the time integration, on any engine;
//! - [`scenes`], [`exact`], [`norms`]: what is run and what it is compared with;
//! - [`turbulence`]: the driving of turbulence and what is measured on it;
//! - [`diagnostics`]: what else is measured on a run.
#![forbid(unsafe_code)]

pub mod choice;
pub mod conformance;
pub mod diagnostics;
pub mod domain;
pub mod engine;
pub mod equations;
pub mod exact;
pub mod fields;
pub mod norms;
pub mod particles;
pub mod passes;
pub mod pipeline;
pub mod scenes;
pub mod schemes;
pub mod simulation;
pub mod sum;
pub mod turbulence;
