//! Where an engine's time goes.

use super::wrapped::{Around, Work, Wrapped};
use crate::report::model::Stage;
use etalon_reference::engine::EngineError;
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
pub type Timed<E> = Wrapped<E, Clock>;

/// The time that each kind of work took.
#[derive(Default)]
pub struct Clock {
    timings: Timings,
}

impl<E> Timed<E> {
    /// Puts a clock beside an engine.
    pub fn new(engine: E) -> Self {
        Wrapped { engine, around: Clock::default() }
    }
}

impl<E> Around<E> for Clock {
    fn during(
        &mut self,
        engine: &mut E,
        work: Work,
        run: impl FnOnce(&mut E) -> Result<(), EngineError>,
    ) -> Result<(), EngineError> {
        let start = Instant::now();
        let done = run(engine);
        self.timings.add(work.name, start);
        done
    }
}

impl<E> Clocked for Timed<E> {
    fn restart(&mut self) -> Result<(), EngineError> {
        self.around.timings.clear();
        Ok(())
    }
    fn stages(&mut self) -> Result<Vec<Stage>, EngineError> {
        Ok(stages(self.around.timings.stages()))
    }
}
