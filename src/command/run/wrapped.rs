//! An engine with something done around its stages: clocks, or noise.

use etalon_kernels_gen::{Component, Field, Pass, Update};
use etalon_reference::engine::{Arrangement, Engine, EngineError};

/// What of a step is done.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Work {
    /// The pass or update by its name, `neighbour_list` or `drift`.
    pub name: &'static str,
    /// The time step of an update.
    pub time_step: Option<f64>,
}

/// What is done around the work of an engine.
pub trait Around<E> {
    /// Has the engine do that work, and does something of its own before or after.
    fn during(
        &mut self,
        engine: &mut E,
        work: Work,
        run: impl FnOnce(&mut E) -> Result<(), EngineError>,
    ) -> Result<(), EngineError>;
}

/// An engine, and what is done around its work. Reading and writing go straight through.
pub struct Wrapped<E, A> {
    pub(super) engine: E,
    pub(super) around: A,
}

impl<E, A: Around<E>> Wrapped<E, A> {
    fn during(
        &mut self,
        name: &'static str,
        time_step: Option<f64>,
        run: impl FnOnce(&mut E) -> Result<(), EngineError>,
    ) -> Result<(), EngineError> {
        self.around.during(&mut self.engine, Work { name, time_step }, run)
    }
}

impl<const D: usize, E: Engine<D>, A: Around<E>> Engine<D> for Wrapped<E, A> {
    fn particle_count(&self) -> usize {
        self.engine.particle_count()
    }
    fn find_neighbours(&mut self, support: f64) -> Result<(), EngineError> {
        self.during("neighbour_list", None, |engine| engine.find_neighbours(support))
    }
    fn run_pass<P: Pass<D>>(&mut self, pass: &P) -> Result<(), EngineError> {
        self.during(P::NAME, None, |engine| engine.run_pass(pass))
    }
    fn run_update<U: Update<D>>(&mut self, update: &U, time_step: f64) -> Result<(), EngineError> {
        self.during(U::NAME, Some(time_step), |engine| engine.run_update(update, time_step))
    }
    fn drift(&mut self) -> Result<(), EngineError> {
        self.during("drift", None, Engine::drift)
    }
    fn minimum(&mut self, field: Field) -> Result<f64, EngineError> {
        self.engine.minimum(field)
    }
    fn read(&mut self, component: Component) -> Result<Vec<f64>, EngineError> {
        self.engine.read(component)
    }
    fn write(&mut self, component: Component, values: &[f64]) -> Result<(), EngineError> {
        self.engine.write(component, values)
    }
    fn coordinates(&mut self, axis: usize) -> Result<Vec<u64>, EngineError> {
        self.engine.coordinates(axis)
    }
    fn place(&mut self, axis: usize, coordinates: &[u64]) -> Result<(), EngineError> {
        self.engine.place(axis, coordinates)
    }
    fn arrangement(&self) -> Arrangement {
        self.engine.arrangement()
    }
    fn arrange(&mut self, arrangement: &Arrangement) -> Result<(), EngineError> {
        self.engine.arrange(arrangement)
    }
    fn forget_neighbours(&mut self) {
        self.engine.forget_neighbours();
    }
}
