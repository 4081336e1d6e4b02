//! Numbers that carry a derivative.

pub use etalon_kernels_gen::dual::Dual;
