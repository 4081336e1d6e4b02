//! Single and double precision under one name.

use etalon_kernels_gen::Real;

/// A scalar with its unit roundoff.
pub trait Float: Real<Mask = bool> + std::fmt::Debug {
    /// The largest relative error of one rounding: half the spacing of the numbers above one.
    const UNIT: f64;
    /// As `f64`.
    fn to_f64(self) -> f64;
}
impl Float for f32 {
    const UNIT: f64 = f32::EPSILON as f64 / 2.0;
    fn to_f64(self) -> f64 {
        f64::from(self)
    }
}
impl Float for f64 {
    const UNIT: f64 = f64::EPSILON / 2.0;
    fn to_f64(self) -> f64 {
        self
    }
}
