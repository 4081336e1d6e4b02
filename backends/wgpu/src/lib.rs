//! Runs passes as generated WGSL on a graphics device.
//!
//! [`WgpuEngine`] runs scenes: it keeps the particles on the device, has the text of every pass printed from its drawing
//! ([`pass_text`], [`update_text`]), validated ([`validate`]) and compiled when it is first met, and reads back only the
//! smallest time step and the length of the neighbour lists.
//!
//! Below it is everything that does not depend on a pass: opening a device ([`open`], [`Device`]), the particles' storage on
//! it ([`FieldStore`], [`Coordinates`]), the neighbour search ([`NeighbourSearch`]), the reduction that gives the time step
//! its extremes ([`Reduction`]), the motion of the particles ([`Drift`]), and the bindings that a generated pass is put into
//! ([`PassPipeline`]). [`call_function`] calls a single equation for each row of a table. The kernels written by hand are the `.wgsl` files in `src/wgsl`; they are tested without a device too.
//!
//! Two properties hold throughout. Every result is the same bits at every run: atomics are only used where their order
//! cannot be seen. And positions are unsigned 32-bit fractions of a torus ([`Torus`]), so that separations are exact.
//!
//! All of this keeps to what WebGPU guarantees everywhere: eight storage buffers to a kernel and workgroups of 64.
#![forbid(unsafe_code)]

mod buffers;
mod clock;
mod device;
mod drift;
mod engine;
mod error;
mod frame;
mod function;
mod neighbours;
mod pass;
mod permutation;
mod program;
mod reduce;
mod scan;
mod sort;
mod timing;
mod torus;
mod transfer;
mod validation;
pub mod wgsl;

pub use buffers::{Coordinates, FieldStore, Parameters};
pub use clock::Timings;
pub use device::{
    ADAPTER_VARIABLE, AdapterDescription, AdapterKind, AdapterPreference, Device, DeviceOptions, adapters, open,
};
pub use drift::Drift;
pub use engine::WgpuEngine;
pub use error::Error;
pub use frame::{Slots, TextError, pass_text, update_text};
pub use function::{call_function, function_text};
pub use neighbours::{Lists, NeighbourSearch, SearchSummary};
pub use pass::{PassBindings, PassBuffers, PassPipeline};
pub use reduce::{Extremes, Reducer, Reduction};
pub use timing::{KernelTime, Timer};
pub use torus::Torus;
pub use validation::validate;

/// What every fallible function here returns.
pub type Result<T> = std::result::Result<T, Error>;
