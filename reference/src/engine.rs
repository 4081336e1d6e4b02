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

/// In which order an engine keeps its particles. Sums over neighbours are formed in that order, so that their last bits depend on it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Arrangement {
    /// The original number of the particle at each place; empty where particles keep their original order.
    pub order: Vec<u32>,
    /// How many times neighbours were searched: some engines sort their particles anew after so many.
    pub searches: u64,
}

const NO_ORDER: &str = "this engine keeps particles in their original order, and the checkpoint is of one that does not; \
                        resume with the engine it was made with";

impl Arrangement {
    /// Whether particles keep their original order and nobody counts searches.
    pub fn is_original(&self) -> bool {
        self.order.is_empty() && self.searches == 0
    }

    /// For an engine that has `current` as its order: for each place, at which place its particle is now.
    ///
    /// # Errors
    /// If the order has other numbers than `current`, or one of them twice.
    pub fn sources(&self, current: &[u32]) -> Result<Vec<u32>, EngineError> {
        let bad = || {
            EngineError(format!(
                "the checkpoint's order of particles is not one of {} particles; resume with the engine it was made with",
                current.len()
            ))
        };
        let mut place_of = vec![None; current.len()];
        for (place, &original) in (0..).zip(current) {
            *place_of.get_mut(original as usize).ok_or_else(bad)? = Some(place);
        }
        if self.order.len() != current.len() {
            return Err(bad());
        }
        // Taken, so that a number that comes twice is missing the second time.
        self.order.iter().map(|&n| place_of.get_mut(n as usize).and_then(Option::take).ok_or_else(bad)).collect()
    }
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

    /// Sets the fixed-point coordinates along one axis, by particle. What the engine's precision does not hold is refused.
    fn place(&mut self, axis: usize, coordinates: &[u64]) -> Result<(), EngineError>;

    /// How it keeps its particles, as far as the bits of its results depend on it.
    fn arrangement(&self) -> Arrangement {
        Arrangement::default()
    }
    /// Keeps its particles like that from now on; which values each of them has does not change.
    fn arrange(&mut self, arrangement: &Arrangement) -> Result<(), EngineError> {
        arrangement.is_original().then_some(()).ok_or_else(|| EngineError(NO_ORDER.into()))
    }

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
