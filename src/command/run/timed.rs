//! Where an engine's time goes.

use crate::report::model::Stage;
use etalon_kernels_gen::{Component, Field, Pass, Update};
use etalon_reference::engine::{Engine, EngineError};
use etalon_simd::{LaneEngine, Number, Timings};
use std::time::Instant;

/// An engine that knows how long its stages took.
pub trait Clocked {
    /// Forgets what was.
    fn restart(&mut self);
    /// Wall-clock time by stage since the last restart.
    fn stages(&self) -> Vec<Stage>;
}

fn stages(timings: &Timings) -> Vec<Stage> {
    let stage = |(name, time, count): &(&str, std::time::Duration, u64)| Stage {
        name: name.to_string(),
        seconds: time.as_secs_f64(),
        count: *count,
    };
    timings.stages().iter().map(stage).collect()
}

impl<T: Number, const D: usize> Clocked for LaneEngine<T, D> {
    fn restart(&mut self) {
        self.clear_timings();
    }
    fn stages(&self) -> Vec<Stage> {
        stages(self.timings())
    }
}

/// An engine without clocks, timed from outside.
pub struct Timed<E> {
    engine: E,
    timings: Timings,
}

impl<E> Timed<E> {
    /// Puts clocks around an engine.
    pub fn new(engine: E) -> Self {
        Timed { engine, timings: Timings::default() }
    }

    fn time<T>(&mut self, stage: &'static str, work: impl FnOnce(&mut E) -> T) -> T {
        let start = Instant::now();
        let done = work(&mut self.engine);
        self.timings.add(stage, start);
        done
    }
}

impl<E> Clocked for Timed<E> {
    fn restart(&mut self) {
        self.timings.clear();
    }
    fn stages(&self) -> Vec<Stage> {
        stages(&self.timings)
    }
}

impl<const D: usize, E: Engine<D>> Engine<D> for Timed<E> {
    fn particle_count(&self) -> usize {
        self.engine.particle_count()
    }
    fn find_neighbours(&mut self, support: f64) -> Result<(), EngineError> {
        self.time("neighbour_list", |engine| engine.find_neighbours(support))
    }
    fn run_pass<P: Pass<D>>(&mut self, pass: &P) -> Result<(), EngineError> {
        self.time(P::NAME, |engine| engine.run_pass(pass))
    }
    fn run_update<U: Update<D>>(&mut self, update: &U, time_step: f64) -> Result<(), EngineError> {
        self.time(U::NAME, |engine| engine.run_update(update, time_step))
    }
    fn drift(&mut self) -> Result<(), EngineError> {
        self.time("drift", Engine::drift)
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
}
