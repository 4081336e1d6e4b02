//! Where the time goes.

use std::time::{Duration, Instant};

/// Wall time and number of runs of each stage, in the order of their first run.
#[derive(Clone, Debug, Default)]
pub struct Timings {
    stages: Vec<(&'static str, Duration, u64)>,
}

impl Timings {
    /// Adds one run of a stage that began at `start`.
    pub fn add(&mut self, stage: &'static str, start: Instant) {
        let elapsed = start.elapsed();
        match self.stages.iter_mut().find(|(name, ..)| *name == stage) {
            Some((_, time, runs)) => {
                *time += elapsed;
                *runs += 1;
            }
            None => self.stages.push((stage, elapsed, 1)),
        }
    }
    /// Name, total time and number of runs of each stage.
    pub fn stages(&self) -> &[(&'static str, Duration, u64)] {
        &self.stages
    }
    /// Forgets everything.
    pub fn clear(&mut self) {
        self.stages.clear();
    }
}
