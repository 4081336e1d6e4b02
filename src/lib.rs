//! A reference standard for the kernels of smoothed-particle hydrodynamics: every equation written once, run as a scalar
//! reference, on vector lanes and as generated WGSL, and compared.
//!
//! This crate is the front door. The rooms behind it, each with its own documentation:
//!
//! - [`reference`]: equations, passes, scenes, exact solutions, norms, and the plain engine;
//! - [`kernels`]: the number that equations are generic over, its vector lanes, its drawings and their printers;
//! - [`simd`]: the engine on vector lanes; `wgpu`: the engine on a graphics adapter (feature `wgpu`);
//! - [`spec`]: the ledger of the papers' equations; [`audit`]: how far each of them is from the truth, and its page;
//! - [`report`]: what a run leaves behind; [`snapshot`]: particles in files that other programs open, time series, restart files;
//! - [`command`]: the program `etalon`; [`fma_peak`]: what speeds are measured against.
#![forbid(unsafe_code)]

pub use etalon_audit as audit;
pub use etalon_kernels_gen as kernels;
pub use etalon_reference as reference;
pub use etalon_simd as simd;
pub use etalon_spec as spec;
#[cfg(feature = "wgpu")]
pub use etalon_wgpu as wgpu;

pub mod command;
pub mod fma_peak;
pub mod report;
pub mod snapshot;
