//! Where an engine's time goes.

use crate::report::model::Stage;
use etalon_kernels_gen::{Component, Field, Pass, Update};
use etalon_reference::engine::{Engine, EngineError};
use etalon_simd::{LaneEngine, Number, Timings};
use std::time::{Duration, Instant};

/// An engine that knows how long its stages took.
pub trait Clocked {
    /// Forgets what was.
    fn restart(&mut self) -> Result<(), EngineError>;
    /// Time by stage since the last restart.
    fn stages(&mut self) -> Result<Vec<Stage>, EngineError>;
}

fn stages<N: ToString>(timings: &[(N, Duration, u64)]) -> Vec<Stage> {
    let stage = |(name, time, count): &(N, Duration, u64)| Stage {
        name: name.to_string(),
        seconds: time.as_secs_f64(),
        count: *count,
    };
    timings.iter().map(stage).collect()
}

impl<T: Number, const D: usize> Clocked for LaneEngine<T, D> {
    fn restart(&mut self) -> Result<(), EngineError> {
        self.clear_timings();
        Ok(())
    }
    fn stages(&mut self) -> Result<Vec<Stage>, EngineError> {
        Ok(stages(self.timings().stages()))
    }
}

#[cfg(feature = "wgpu")]
impl<const D: usize> Clocked for etalon_wgpu::WgpuEngine<D> {
    fn restart(&mut self) -> Result<(), EngineError> {
        self.set_timed(true)
    }
    fn stages(&mut self) -> Result<Vec<Stage>, EngineError> {
        Ok(stages(self.timings()?.stages()))
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
    fn restart(&mut self) -> Result<(), EngineError> {
        self.timings.clear();
        Ok(())
    }
    fn stages(&mut self) -> Result<Vec<Stage>, EngineError> {
        Ok(stages(self.timings.stages()))
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
