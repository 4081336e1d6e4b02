//! The names users choose from that are not physics: scene, start, backend, precision.

use etalon_kernels_gen::bounded::Roundoff;
use etalon_kernels_gen::trace::{Double, Single};
use etalon_reference::choice;
use etalon_reference::scenes::Arrangement;

choice! {
    /// A problem that can be run.
    SceneName, "scene" {
        /// Sod's shock tube.
        Sod = "sod",
    }
}

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
    /// How particles are laid out at the start.
    Start, "start" {
        /// On a lattice.
        Lattice = "lattice",
        /// As a relaxed glass.
        Glass = "glass",
    }
}

impl Start {
    /// As scenes know it.
    pub fn arrangement(self) -> Arrangement {
        match self {
            Start::Lattice => Arrangement::Lattice,
            Start::Glass => Arrangement::Glass,
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
