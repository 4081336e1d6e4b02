//! One definition, many readings: the number trait that equations are generic over, the vector lanes and the symbols that can
//! stand in for the number, and the printers that turn a drawn equation into other languages.
//!
//! - [`Real`], [`Vector`], [`Symmetric`], [`Matrix`]: what equations are written with;
//! - [`record!`], [`Pass`], [`Update`]: what backends run;
//! - [`Constant`]: what is computed with, to more digits than any target has;
//! - [`lanes`]: many numbers at once;
//! - [`trace`]: the drawing of a computation; [`emit`]: its print in WGSL and C.
#![deny(unsafe_code)]

extern crate self as etalon_kernels_gen;

pub mod bounded;
mod constant;
pub mod dual;
pub mod emit;
mod equation;
pub mod functions;
pub mod lanes;
mod pass;
#[rustfmt::skip]
pub mod polynomials;
mod real;
mod record;
mod scalar;
pub mod trace;
mod vector;

pub use constant::Constant;
#[cfg(feature = "mutants")]
pub use equation::mutants;
#[doc(hidden)]
pub use equation::private as __private;
pub use equation::{EquationEntry, registered};
pub use etalon_kernels_gen_macros::{equation, equation_part};
pub use pass::{Footprint, Part, Pass, Separation, Update, used_components};
pub use real::{Choose, Mask, Nameable, Precision, Real};
pub use record::{Component, Field, Quantity, Rank, Record, Reduction, Scalar, components};
pub use scalar::Fused;
pub use vector::{Matrix, Symmetric, Vector, axes, symmetric_count};
