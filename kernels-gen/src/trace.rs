//! The drawing of a computation: an equation is run once on a number that only remembers what is done to it, and what is
//! remembered is an expression graph. Everything that is not a plain run of the equation starts there: text in other
//! languages ([`emit`](crate::emit)), operation counts, and the check for expressions that graphics drivers rewrite.
//!
//! - [`Symbol`] is the number that remembers; [`draw`] runs a closure on it and returns a [`Drawing`];
//! - [`Drawing::of_pass`] and [`Drawing::of_update`] draw what a backend runs;
//! - [`Drawing::simplified`] removes what costs something and changes nothing;
//! - [`interpret`] evaluates a drawing, which is how a test knows that drawing lost nothing;
//! - [`Drawing::count`] counts operations, [`Drawing::lint`] finds rewritable expressions.
//!
//! Rust-level decisions (dimension, scheme, kernel) are taken while the equation runs, so a drawing contains only what one
//! scene asked for. Data-dependent choices are drawn with both sides and a selection.

mod count;
mod drawing;
mod error;
mod graph;
mod interpret;
mod lint;
mod pass;
mod simplify;
mod symbol;

pub use count::Count;
pub use drawing::{Drawing, Output};
pub use error::{InterpretError, TraceError};
pub use graph::{Graph, Id, Literal, Node, Op, Scope, Shape};
pub use interpret::{first_not_finite, interpret};
pub use lint::{Finding, Pattern};
pub use pass::{PassDrawing, Sum, UpdateDrawing};
pub use symbol::{Double, Pen, Significand, Single, Symbol, SymbolMask, draw};
