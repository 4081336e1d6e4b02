//! The names users choose from that are not physics: backend, target, precision.

use super::sweep::Record;
use etalon_kernels_gen::bounded::Roundoff;
use etalon_kernels_gen::trace::{Double, Single};
use etalon_reference::choice;

choice! {
    /// What runs a scene.
    Backend, "backend" {
        /// Direct loops on one thread.
        Reference = "reference",
        /// The processor's vector lanes, on all threads.
        Simd = "simd",
        /// Generated WGSL on a graphics adapter.
        Wgpu = "wgpu",
    }
}

choice! {
    /// A language that kernels are printed in.
    Target, "target" {
        /// The shading language of WebGPU: whole shaders, with their bindings and the loop over neighbours.
        Wgsl = "wgsl",
        /// C99: the bodies of a pass as functions.
        C = "c",
    }
}

choice! {
    /// How many digits it computes with.
    Precision, "precision" {
        /// 32-bit floats.
        Single = "f32",
        /// 64-bit floats.
        Double = "f64",
    }
}

choice! {
    /// What a run costs.
    Cost, "cost" {
        /// Wall-clock time of all steps.
        Seconds = "seconds",
        /// Floating-point operations, counted from the graph.
        Operations = "operations",
        /// Memory of all particles.
        Bytes = "bytes",
    }
}

impl Cost {
    /// With its unit, for a plot.
    pub fn label(self) -> &'static str {
        match self {
            Cost::Seconds => "wall-clock time of all steps [s]",
            Cost::Operations => "floating-point operations of all steps",
            Cost::Bytes => "memory of all particles [B]",
        }
    }
    /// What a run cost.
    pub fn of(self, record: &Record) -> f64 {
        match self {
            Cost::Seconds => record.wall_seconds,
            Cost::Operations => record.operations,
            Cost::Bytes => record.bytes_per_particle * record.particles as f64,
        }
    }
}

impl Precision {
    /// The largest relative error of one rounding: 2^-24 or 2^-53.
    pub fn unit_roundoff(self) -> f64 {
        match self {
            Precision::Single => Single::UNIT,
            Precision::Double => Double::UNIT,
        }
    }
    /// Bytes of a number.
    pub fn bytes(self) -> usize {
        match self {
            Precision::Single => 4,
            Precision::Double => 8,
        }
    }
}
