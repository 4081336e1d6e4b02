//! What every backend can do, and the plainest one that does it.

mod plain;
mod search;

pub use plain::{PlainEngine, Scalar};
pub use search::{PlainNeighbours, brute_force};

use etalon_kernels_gen::{Component, Field, Pass, Rank, Update};

/// What went wrong inside an engine, in one sentence with its remedy.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{0}")]
pub struct EngineError(pub String);

impl EngineError {
    /// From any error's text.
    pub fn from_display(error: impl std::fmt::Display) -> Self {
        EngineError(error.to_string())
    }
}

/// The smaller of two numbers, and NaN if either is: a state that is not finite must not hide behind one that is.
pub fn smaller(a: f64, b: f64) -> f64 {
    if b < a || b.is_nan() { b } else { a }
}

/// Something that holds particles and runs passes over them: the scalar reference, vector lanes, a graphics device.
///
/// Values go in and out as `f64` in the particles' original order, whatever the engine does inside.
pub trait Engine<const D: usize> {
    /// How many particles it holds.
    fn particle_count(&self) -> usize;
    /// Finds for every particle the others closer than the larger of the two supports, `support * h`.
    fn find_neighbours(&mut self, support: f64) -> Result<(), EngineError>;
    /// Runs a pass over all particles with the neighbours last found.
    fn run_pass<P: Pass<D>>(&mut self, pass: &P) -> Result<(), EngineError>;
    /// Runs an update over all particles.
    fn run_update<U: Update<D>>(&mut self, update: &U, time_step: f64) -> Result<(), EngineError>;
    /// Moves every particle by its displacement.
    fn drift(&mut self) -> Result<(), EngineError>;
    /// The smallest value of a scalar field; NaN if any is, infinite if there are none.
    fn minimum(&mut self, field: Field) -> Result<f64, EngineError>;
    /// One component of a field, by particle.
    fn read(&mut self, component: Component) -> Result<Vec<f64>, EngineError>;
    /// Sets one component of a field.
    fn write(&mut self, component: Component, values: &[f64]) -> Result<(), EngineError>;
    /// Fixed-point coordinates along one axis, by particle.
    fn coordinates(&mut self, axis: usize) -> Result<Vec<u64>, EngineError>;

    /// Gives back what memory only neighbours and passes need; before the next pass they must be found again.
    fn forget_neighbours(&mut self) {}

    /// A scalar field, by particle.
    fn read_scalar(&mut self, field: Field) -> Result<Vec<f64>, EngineError> {
        debug_assert_eq!(field.rank, Rank::Scalar);
        self.read(Component { field, index: 0 })
    }
    /// All components of a field, each by particle.
    fn read_all(&mut self, field: Field) -> Result<Vec<Vec<f64>>, EngineError> {
        (0..field.rank.components(D)).map(|index| self.read(Component { field, index })).collect()
    }
}
