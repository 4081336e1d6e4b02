//! Where an engine's time goes.

use std::time::{Duration, Instant};

use crate::timing::KernelTime;
use crate::{Device, Result, Timer};

/// Groups of kernels that a timer holds before an engine empties it.
const HELD: usize = 512;

/// Time and number of runs of each stage, in the order of their first run.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Timings {
    stages: Vec<(String, Duration, u64)>,
    kernels: Vec<KernelTime>,
}

impl Timings {
    /// Name, total time and number of runs of each stage: passes and updates by their names, `neighbour_list`, `order`,
    /// `drift`, `minimum`.
    pub fn stages(&self) -> &[(String, Duration, u64)] {
        &self.stages
    }

    /// The same by kernels, where the device has a clock of its own; the neighbour search has several.
    pub fn kernels(&self) -> &[KernelTime] {
        &self.kernels
    }

    fn add_stage(&mut self, stage: &str, time: Duration, runs: u64) {
        match self.stages.iter_mut().find(|(name, ..)| name == stage) {
            Some((_, total, all)) => {
                *total += time;
                *all += runs;
            }
            None => self.stages.push((stage.to_owned(), time, runs)),
        }
    }

    fn add_kernels(&mut self, times: Vec<KernelTime>) {
        for time in times {
            let search = time.name.starts_with("cells: ") || time.name.starts_with("list: ");
            let stage = if search { "neighbour_list" } else { &time.name };
            // Every search counts once, whatever its kernels.
            let runs = if search && time.name != COUNTED { 0 } else { u64::from(time.runs) };
            self.add_stage(stage, Duration::from_secs_f64(time.seconds), runs);
            match self.kernels.iter_mut().find(|known| known.name == time.name) {
                Some(known) => {
                    known.runs += time.runs;
                    known.seconds += time.seconds;
                }
                None => self.kernels.push(time),
            }
        }
    }
}

/// The kernel that runs exactly once a search.
const COUNTED: &str = "list: count";

/// Times stages by the device's clock or, where it has none, by waiting for it; not at all unless asked to.
#[derive(Debug)]
pub(crate) struct Clock {
    pub timer: Timer,
    totals: Timings,
    by_waiting: bool,
}

impl Clock {
    pub fn off() -> Self {
        Self { timer: Timer::off(), totals: Timings::default(), by_waiting: false }
    }

    pub fn on(device: &Device) -> Result<Self> {
        Ok(Self { timer: Timer::new(device)?, totals: Timings::default(), by_waiting: !device.has_timestamps() })
    }

    /// Before a stage: the time, if it is to be measured by waiting.
    pub fn start(&self, device: &Device) -> Result<Option<Instant>> {
        if !self.by_waiting {
            return Ok(None);
        }
        device.wait()?;
        Ok(Some(Instant::now()))
    }

    /// After a stage.
    pub fn stop(&mut self, device: &Device, stage: &str, start: Option<Instant>) -> Result<()> {
        if let Some(start) = start {
            device.wait()?;
            self.totals.add_stage(stage, start.elapsed(), 1);
        } else if self.timer.held() >= HELD {
            self.totals.add_kernels(self.timer.read(device)?);
        }
        Ok(())
    }

    /// The times so far.
    pub fn read(&mut self, device: &Device) -> Result<Timings> {
        self.totals.add_kernels(self.timer.read(device)?);
        Ok(self.totals.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kernels_of_the_search_are_one_stage() {
        let time = |name: &str, runs, seconds| KernelTime { name: name.to_owned(), runs, seconds };
        let mut timings = Timings::default();
        let once = vec![time("cells: bin", 1, 0.5), time("list: count", 1, 0.25), time("density", 1, 1.0)];
        timings.add_kernels(once.clone());
        timings.add_kernels(once);
        let seconds: Vec<(&str, f64, u64)> =
            timings.stages().iter().map(|(name, time, runs)| (name.as_str(), time.as_secs_f64(), *runs)).collect();
        assert_eq!(seconds, [("neighbour_list", 1.5, 2), ("density", 2.0, 2)]);
        assert_eq!(timings.kernels()[0], time("cells: bin", 2, 1.0));
    }
}
