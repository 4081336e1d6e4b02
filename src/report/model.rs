//! The data of a report. Every type serialises to the JSON described in `docs/report-schema.md`.
//!
//! Physical quantities are in the scene's own units (each field names its unit), times of the machine in seconds or
//! nanoseconds as the name says.

mod ending;
mod measured;
mod profile;
mod series;

pub use ending::{CurveColumn, EndCurve, EndQuantity, Ending, ExpectedLine};
pub use measured::{Conserved, FieldDifference, FieldError, Measurements, Norm, Outcome, Run, Speed, Stage, Tolerance};
pub use profile::{Curve, CurveField, Profile, ProfileField, stratified};
pub use series::{Series, SeriesQuantity};

use serde::{Deserialize, Serialize};

/// One execution of `etalon run`: a scene, a machine, and what each backend made of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Report {
    /// Version of the program that measured, for example `0.1.0`.
    pub program_version: String,
    /// When the run ended, RFC 3339 in UTC (see [`crate::report::utc_now`]).
    pub created: String,
    /// The command line that gives this report again, all settings spelled out.
    pub command: String,
    /// What was simulated.
    pub scene: Scene,
    /// What it ran on.
    pub machine: Machine,
    /// The fields that errors and profiles refer to, in the order in which they are shown.
    pub fields: Vec<Field>,
    /// The exact solution at the end time, sampled finely enough to be drawn as a line.
    pub exact: Curve,
    /// Third source of error: the polynomials and tables that stand for exact functions inside the kernels.
    pub kernel_approximation: Vec<KernelApproximation>,
    /// One entry per backend and precision, skipped ones included. The scalar reference comes first.
    pub runs: Vec<Run>,
}

impl Report {
    /// The run that the others are compared with: the first one, if it ran and calls itself the reference.
    pub fn reference(&self) -> Option<(&Run, &Measurements)> {
        self.runs.iter().find_map(|run| match &run.outcome {
            Outcome::Ran(measured) if run.is_reference() => Some((run, measured.as_ref())),
            _ => None,
        })
    }

    /// The runs that took place, each with its position in [`Report::runs`] (which fixes its colour in all plots).
    pub fn measured(&self) -> impl Iterator<Item = (usize, &Run, &Measurements)> {
        self.runs.iter().enumerate().filter_map(|(index, run)| match &run.outcome {
            Outcome::Ran(measured) => Some((index, run, measured.as_ref())),
            Outcome::Skipped { .. } => None,
        })
    }

    /// The field of that name.
    pub fn field(&self, name: &str) -> Option<&Field> {
        self.fields.iter().find(|field| field.name == name)
    }
}

/// What was simulated.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Scene {
    /// Name on the command line, for example `sod`.
    pub name: String,
    /// Name for people, for example `Sod shock tube`.
    pub title: String,
    /// Space dimensions: 1, 2 or 3.
    pub dimension: u8,
    /// Particles, boundary layers included.
    pub particles: u64,
    /// Neighbours asked for within the kernel's support.
    pub neighbours: f64,
    /// Interpolating kernel.
    pub kernel: String,
    /// Dissipation scheme, by its name in the paper.
    pub scheme: String,
    /// Adiabatic index of the ideal gas.
    pub gamma: f64,
    /// Time at which the fields are compared, in the scene's units.
    pub end_time: f64,
    /// Particle arrangement at the start: `lattice`, `glass` or `file`.
    pub arrangement: String,
    /// What is special about the start: for a jump `sharp`, or how it is smoothed.
    pub discontinuity: String,
    /// What happens at each boundary, in words.
    pub boundaries: String,
    /// Where the error norms are taken.
    pub norm: NormRange,
    /// Anything else a reader needs to repeat the run.
    pub settings: Vec<Setting>,
}

/// A named setting, as printed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Setting {
    /// Name for people.
    pub name: String,
    /// Value with its unit.
    pub value: String,
}

/// The range over which error norms are taken.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct NormRange {
    /// The coordinate that plots and norms run along, for example `x`.
    pub coordinate: String,
    /// Unit of the coordinate.
    pub unit: String,
    /// Lower end, included.
    pub from: f64,
    /// Upper end, included.
    pub to: f64,
    /// Where range and norm are defined, for example `GS25, Eq. 20`.
    pub source: String,
}

/// What it ran on.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Machine {
    /// Processor's name.
    pub cpu: String,
    /// Hardware threads that the run could use.
    pub threads: u32,
    /// Widest instruction set that the SIMD kernels used, for example `AVX-512`.
    pub instruction_set: String,
    /// Operating system and architecture.
    pub system: String,
    /// Graphics adapter of the WGSL kernels, software ones included.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub adapter: Option<String>,
    /// Fused multiply-add peak of one core, measured in the same run, GFLOP/s.
    pub fma_peak_gflops_per_core: FmaPeak,
}

/// Fused multiply-add peak of one core in GFLOP/s; one fused operation counts as two.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct FmaPeak {
    /// In 32-bit floats.
    pub f32: f64,
    /// In 64-bit floats.
    pub f64: f64,
}

/// A field that is compared.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Field {
    /// Name by which runs refer to it, for example `velocity_x`.
    pub name: String,
    /// Name for people, for example `velocity`.
    pub label: String,
    /// Symbol, for example `vₓ`.
    pub symbol: String,
    /// Unit, for example `√(P₀/ρ₀)`.
    pub unit: String,
}

/// How far a function used inside the kernels lies from the exact function it stands for.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct KernelApproximation {
    /// The function, for example `mixed sinc kernel w(q)`.
    pub function: String,
    /// What stands for it, for example `polynomial in q², degree 8`.
    pub approximation: String,
    /// Float type it is used in: `f32` or `f64`.
    pub precision: String,
    /// Largest absolute error over the whole support, relative to the function's largest value; dimensionless.
    pub max: f64,
    /// What `max` may be, and why.
    pub tolerance: Tolerance,
}

impl KernelApproximation {
    /// Whether the error lies within its tolerance. NaN does not.
    pub fn passes(&self) -> bool {
        self.max <= self.tolerance.value
    }
}
