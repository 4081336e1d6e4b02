//! Runs passes on the processor's vector lanes, and finds neighbours.
//!
//! - [`LaneEngine`]: the backend, in `f32` or `f64`;
//! - [`neighbours`]: the search it uses.
//!
//! Results are the same bits at every instruction-set level and for any number of threads: the number of lanes is fixed, each
//! particle's sum is formed by one thread in one order, and every operation rounds alike everywhere.
#![forbid(unsafe_code)]

mod engine;
// The tests of this crate need few of them.
#[cfg(not(test))]
#[doc(hidden)]
pub mod instances;
pub mod neighbours;
mod number;
mod store;
mod sweep;
mod timing;

pub use engine::{LaneEngine, Options};
pub use number::Number;
pub use timing::Timings;
