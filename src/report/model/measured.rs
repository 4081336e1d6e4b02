//! What one backend did in one precision.

use serde::{Deserialize, Serialize};

use super::{Ending, Profile, Series};

/// One backend in one precision.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Run {
    /// `reference`, `simd` or `wgpu`.
    pub backend: String,
    /// `f32` or `f64`.
    pub precision: String,
    /// What came of it.
    pub outcome: Outcome,
}

impl Run {
    /// A run that took place.
    pub fn ran(backend: &str, precision: &str, measured: Measurements) -> Self {
        let outcome = Outcome::Ran(Box::new(measured));
        Self { backend: backend.into(), precision: precision.into(), outcome }
    }

    /// A run that did not take place, with the reason that the reader is told.
    pub fn skipped(backend: &str, precision: &str, reason: impl Into<String>) -> Self {
        let outcome = Outcome::Skipped { reason: reason.into() };
        Self { backend: backend.into(), precision: precision.into(), outcome }
    }

    /// Whether this is the scalar f64 reference that the others are compared with.
    pub fn is_reference(&self) -> bool {
        self.backend == "reference" && self.precision == "f64"
    }

    /// Name for people: `SIMD f64`, `WGSL f32`, `reference f64`.
    pub fn label(&self) -> String {
        let backend = match self.backend.as_str() {
            "simd" => "SIMD",
            "wgpu" => "WGSL",
            other => other,
        };
        format!("{backend} {}", self.precision)
    }
}

/// What came of a run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Outcome {
    /// It took place.
    Ran(Box<Measurements>),
    /// It did not, and this is why.
    Skipped {
        /// One clause that a reader understands, for example `no graphics adapter found`.
        reason: String,
    },
}

/// Everything measured in one run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Measurements {
    /// Time steps taken.
    pub steps: u64,
    /// Simulated time reached, in the scene's units.
    pub time: f64,
    /// Processor threads used.
    pub threads: u32,
    /// Wall-clock time of all steps, seconds; set-up and comparison are not in it.
    pub wall_seconds: f64,
    /// Floating-point operations of one particle in one step, counted from the graph with the wanted neighbour number.
    #[serde(default)]
    pub operations_per_update: f64,
    /// Memory held for the simulation at its largest, bytes a particle.
    pub bytes_per_particle: f64,
    /// Rates that follow from the above.
    pub speed: Speed,
    /// Wall-clock time by stage, in the order of execution.
    pub stages: Vec<Stage>,
    /// Drift of what should be conserved.
    pub conservation: Vec<Conserved>,
    /// First source of error: distance from the exact solution.
    pub discretisation_error: Vec<FieldError>,
    /// Second source of error: distance from the scalar f64 reference. Empty for the reference itself.
    pub arithmetic_difference: Vec<FieldDifference>,
    /// Particles for the plots.
    pub profile: Profile,
    /// What was measured on the way; without quantities where the scene measures nothing.
    #[serde(default)]
    pub series: Series,
    /// What was measured at the end alone.
    #[serde(default)]
    pub ending: Ending,
}

impl Measurements {
    /// The error of a field against the exact solution.
    pub fn error_of(&self, field: &str) -> Option<&FieldError> {
        self.discretisation_error.iter().find(|error| error.field == field)
    }

    /// The field that lies farthest from the reference, measured in its own scale.
    pub fn worst_difference(&self) -> Option<&FieldDifference> {
        self.arithmetic_difference.iter().max_by(|a, b| a.compared().total_cmp(&b.compared()))
    }
}

/// Rates of a run.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Speed {
    /// Wall-clock nanoseconds for one particle to advance by one step, all threads working.
    pub nanoseconds_per_update: f64,
    /// Particle updates per second and processor core. Absent where the work was not done by processor cores.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub updates_per_second_per_core: Option<f64>,
    /// `updates_per_second_per_core` divided by the core's measured FMA peak in GFLOP/s of the same precision.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub updates_per_gflop: Option<f64>,
    /// The reference's nanoseconds per update divided by this run's. Absent where the reference did not run.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub speed_up: Option<f64>,
}

impl Speed {
    /// Rates of `particles` advanced by `steps` in `wall_seconds`.
    ///
    /// `cores` is the number of processor cores at work with the FMA peak of one of them in GFLOP/s, or `None` for a
    /// graphics adapter. `reference` is the reference's nanoseconds per update.
    pub fn new(
        particles: u64,
        steps: u64,
        wall_seconds: f64,
        cores: Option<(u32, f64)>,
        reference: Option<f64>,
    ) -> Self {
        let updates = particles as f64 * steps as f64;
        let nanoseconds_per_update = wall_seconds * 1e9 / updates;
        let per_core = cores.map(|(count, peak)| (updates / (wall_seconds * f64::from(count)), peak));
        Self {
            nanoseconds_per_update,
            updates_per_second_per_core: per_core.map(|(rate, _)| rate),
            updates_per_gflop: per_core.map(|(rate, peak)| rate / peak),
            speed_up: reference.map(|reference| reference / nanoseconds_per_update),
        }
    }
}

/// Time spent in one stage of the step.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Stage {
    /// `order`, `neighbour list`, a pass by its name, `update`.
    pub name: String,
    /// Wall-clock time of all calls together, seconds.
    pub seconds: f64,
    /// Number of calls.
    pub count: u64,
}

/// Drift of a conserved quantity from start to end.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Conserved {
    /// `mass`, `momentum`, `energy`.
    pub quantity: String,
    /// Change of the sum over all particles, divided by the sum of the magnitudes of its terms; dimensionless.
    pub scaled_drift: f64,
    /// What `scaled_drift` may be, and why. Absent where the scene does not conserve the quantity.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tolerance: Option<Tolerance>,
    /// What a reader should know, for example that walls push on the gas.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub note: Option<String>,
}

impl Conserved {
    /// Whether the drift lies within its tolerance. NaN does not; a quantity without tolerance does.
    pub fn passes(&self) -> bool {
        self.tolerance.as_ref().is_none_or(|tolerance| self.scaled_drift.abs() <= tolerance.value)
    }
}

/// Distance of one field from the exact solution, in the field's unit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FieldError {
    /// Which field.
    pub field: String,
    /// Mean of the absolute error over the particles in range (GS25, Eq. 20).
    pub l1: f64,
    /// Root of the mean square over the same particles.
    pub l2: f64,
    /// Largest absolute error over the same particles.
    pub max: f64,
    /// Number of particles in range.
    pub particles: u64,
}

/// Distance of one field from the scalar f64 reference at the same time.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FieldDifference {
    /// Which field.
    pub field: String,
    /// Root of the mean square difference over all particles, in the field's unit.
    pub rms: f64,
    /// Largest absolute difference, in the field's unit.
    pub max: f64,
    /// What differences of this field are measured in: a typical magnitude, positive, in the field's unit.
    pub scale: f64,
    /// Which of the two is held against the tolerance.
    pub norm: Norm,
    /// What that norm divided by `scale` may be, and why.
    pub tolerance: Tolerance,
    /// Whether it is.
    pub pass: bool,
}

impl FieldDifference {
    /// A difference held against its tolerance. NaN fails.
    pub fn new(field: &str, rms: f64, max: f64, scale: f64, norm: Norm, tolerance: Tolerance) -> Self {
        let mut difference = Self { field: field.into(), rms, max, scale, norm, tolerance, pass: false };
        difference.pass = difference.compared() <= difference.tolerance.value;
        difference
    }

    /// What is held against the tolerance: `rms` or `max`, divided by `scale`; dimensionless.
    pub fn compared(&self) -> f64 {
        match self.norm {
            Norm::Rms => self.rms / self.scale,
            Norm::Max => self.max / self.scale,
        }
    }
}

/// A norm of a difference.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Norm {
    /// Root of the mean square.
    Rms,
    /// Largest magnitude.
    Max,
}

impl Norm {
    /// Name for people.
    pub fn label(self) -> &'static str {
        match self {
            Self::Rms => "rms",
            Self::Max => "max",
        }
    }
}

/// What an error may be, and where that figure comes from.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Tolerance {
    /// The bound, dimensionless, positive.
    pub value: f64,
    /// Its derivation in a clause.
    pub source: String,
}

impl Tolerance {
    /// A bound with its derivation.
    pub fn new(value: f64, source: impl Into<String>) -> Self {
        Self { value, source: source.into() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn speed_follows_from_its_definition() {
        // 1000 particles x 10 steps in 2 s: 2e5 ns an update; on 4 cores 1250 updates/s each.
        let speed = Speed::new(1000, 10, 2.0, Some((4, 50.0)), Some(1e6));
        assert_eq!(speed.nanoseconds_per_update, 2e5);
        assert_eq!(speed.updates_per_second_per_core, Some(1250.0));
        assert_eq!(speed.updates_per_gflop, Some(25.0));
        assert_eq!(speed.speed_up, Some(5.0));
        assert_eq!(Speed::new(1000, 10, 2.0, None, None).updates_per_second_per_core, None);
    }

    #[test]
    fn a_difference_passes_by_the_norm_it_names() {
        let tolerance = || Tolerance::new(0.1, "test");
        // In units of the scale (2): rms 0.05, max 0.5.
        assert!(FieldDifference::new("density", 0.1, 1.0, 2.0, Norm::Rms, tolerance()).pass);
        assert!(!FieldDifference::new("density", 0.1, 1.0, 2.0, Norm::Max, tolerance()).pass);
        assert!(!FieldDifference::new("density", f64::NAN, 0.0, 2.0, Norm::Rms, tolerance()).pass);
    }

    #[test]
    fn labels_name_backend_and_precision() {
        assert_eq!(Run::skipped("wgpu", "f32", "none").label(), "WGSL f32");
        assert!(!Run::skipped("reference", "f32", "none").is_reference());
    }
}
