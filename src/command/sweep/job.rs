//! One run of many.

use crate::command::explain::work_per_update;
use crate::command::failure::Failure;
use crate::command::memory::{self, Memory};
use crate::command::restarts::{self, Restarts, USUAL_SECONDS};
use crate::command::run::graphics::Graphics;
use crate::command::run::plan::Combination;
use crate::command::run::progress::Progress;
use crate::command::run::seen::names;
use crate::command::run::simulate::{Finished, Task};
use crate::command::run::{self, compare, particles};
use crate::command::setup::Setup;
use etalon_reference::pipeline::Pipeline;
use etalon_reference::scenes::wind_cloud::destruction_rate;
use fearless_simd::Level;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

/// A run to be made.
#[derive(Clone, Debug)]
pub struct Job {
    /// The scene with all its choices.
    pub setup: Setup,
    /// What runs it, in which precision.
    pub combination: Combination,
    /// About how much work it is beside others of its sweep.
    pub weight: f64,
}

/// What is remembered of a run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// The options of `etalon run` that make it again: no two different runs have the same.
    pub id: String,
    /// Particles, walls included.
    pub particles: u64,
    /// Steps taken.
    pub steps: u64,
    /// Wall-clock time of all steps, seconds.
    pub wall_seconds: f64,
    /// Floating-point operations of all steps, counted from the graph with the wanted neighbour number.
    pub operations: f64,
    /// Memory held at the largest, bytes a particle, counted.
    pub bytes_per_particle: f64,
    /// Mean absolute error of each field against the solution (GS25 20); empty without one.
    pub l1: BTreeMap<String, f64>,
    /// Change of the energy from start to end, over that at the start.
    pub energy_drift: f64,
    /// When it was measured on the way, ascending.
    pub time: Vec<f64>,
    /// What was measured then, by name; of what is measured at the end alone one value.
    pub measured: BTreeMap<String, Vec<f64>>,
}

impl Record {
    /// The last value of what was measured.
    pub fn last(&self, name: &str) -> Option<f64> {
        self.measured.get(name)?.last().copied()
    }

    /// Its largest value.
    pub fn largest(&self, name: &str) -> Option<f64> {
        self.measured.get(name)?.iter().copied().reduce(f64::max)
    }

    /// Its mean over time from a time on, by straight lines between the values; none for fewer than two.
    pub fn mean(&self, name: &str, since: f64) -> Option<f64> {
        let first = self.time.partition_point(|time| *time < since);
        let (time, value) = (self.time.get(first..)?, self.measured.get(name)?.get(first..)?);
        let pieces = time.windows(2).zip(value.windows(2));
        let sum: f64 = pieces.map(|(t, v)| 0.5 * (t[1] - t[0]) * (v[0] + v[1])).sum();
        let long = time.last()? - time.first()?;
        (long > 0.0).then(|| sum / long)
    }

    /// How fast it changes around a time: the slope of the line through all values at most `within` away from it, by least squares. None if there are fewer
    /// than two.
    pub fn rate(&self, name: &str, at: f64, within: f64) -> Option<f64> {
        destruction_rate(&self.time, self.measured.get(name)?, at, within)
    }
}

impl Job {
    /// The options that make it again.
    pub fn id(&self) -> String {
        let (backend, precision) = self.combination;
        format!("{} --backend {backend} --precision {precision}", self.setup.options())
    }

    /// A run whose weight counts pairs of particles: each step is shorter the closer particles lie.
    pub fn new(setup: Setup, combination: Combination) -> Self {
        let (particles, neighbours) = (setup.method().particles as f64, setup.method().neighbours);
        let weight = particles.powf(1.0 + 1.0 / setup.dimension as f64) * neighbours * setup.end_time;
        Job { setup, combination, weight }
    }

    /// In a few words.
    pub fn name(&self) -> String {
        let method = self.setup.method();
        let (scene, scheme) = (self.setup.problem.name(), method.viscosity.dissipation);
        format!("{scene}, {scheme}, {} particles", method.particles)
    }

    /// Refuses a run that does not fit into memory.
    pub fn fits(&self) -> Result<(), Failure> {
        let each = match self.setup.dimension {
            1 => self.bytes::<1>(),
            2 => self.bytes::<2>(),
            _ => self.bytes::<3>(),
        };
        let particles = self.setup.method().particles;
        memory::check(&format!("--n {particles}"), particles, each)
    }

    /// Memory of a particle.
    fn bytes<const D: usize>(&self) -> f64 {
        let pipeline = Pipeline::of_scene::<D>(&self.setup.physics());
        let (backend, precision) = self.combination;
        let neighbours = self.setup.method().neighbours.min(1000.0);
        Memory::of::<D>(backend, precision, &pipeline, neighbours).total() + memory::beside::<D>()
    }

    /// Makes the run, from its restart file in this folder if there is one. The file is to be removed once the record is on the disk.
    pub fn run(
        &self,
        level: Level,
        graphics: &Graphics,
        label: &str,
        folder: &Path,
    ) -> Result<(Record, Restarts), Failure> {
        // Each run has a place of its own, for another may be made before it goes on.
        let own = folder.join(format!("{:08x}.restart", crc32fast::hash(self.id().as_bytes())));
        let settings = restarts::settings(&self.setup, None, level);
        let restarts = Restarts::new(own, USUAL_SECONDS, settings, graphics.adapter())?;
        let record = match self.setup.dimension {
            1 => self.run_in::<1>(level, graphics, label, &restarts),
            2 => self.run_in::<2>(level, graphics, label, &restarts),
            _ => self.run_in::<3>(level, graphics, label, &restarts),
        }?;
        Ok((record, restarts))
    }

    fn run_in<const D: usize>(
        &self,
        level: Level,
        graphics: &Graphics,
        label: &str,
        restarts: &Restarts,
    ) -> Result<Record, Failure> {
        let scene = self.setup.problem.scene::<D>();
        let set = particles::<D>(&self.setup, level)?;
        let count = set.len() as u64;
        let physics = scene.physics();
        let task = Task {
            scene,
            physics,
            end_time: self.setup.end_time,
            mobile: set.particles().iter().map(|p| p.mobile).collect(),
            observe_every: self.setup.observe_every,
            level,
        };
        let progress = Progress::new(label, task.end_time, true);
        let restart = restarts.of(&run::label(self.combination), &physics, &set);
        let finished = task.run(self.combination, Arc::new(set), graphics, progress, Some(restart))?;
        let mut l1 = BTreeMap::new();
        if let Some(solution) = scene.solution(task.end_time)? {
            let measured = scene.measured(task.end_time);
            let errors = compare::discretisation(&finished.seen, scene.view(), solution.as_ref(), measured)?;
            l1.extend(names(scene.view()).into_iter().map(String::from).zip(errors.into_iter().map(|e| e.l1)));
        }
        let on_the_way = finished.series.quantities.iter().map(|q| (q.name.clone(), q.value.clone()));
        // Of what is measured at the end alone there is one value, the last.
        let at_end = finished.ending.quantities.iter().filter_map(|q| Some((q.name.clone(), vec![q.value?])));
        let measured = on_the_way.chain(at_end).collect();
        let pipeline = Pipeline::of_scene::<D>(&physics);
        let (backend, precision) = self.combination;
        let neighbours = self.setup.method().neighbours;
        let updates = count as f64 * finished.steps as f64;
        Ok(Record {
            id: self.id(),
            particles: count,
            steps: finished.steps,
            wall_seconds: finished.wall_seconds,
            operations: updates * work_per_update::<D>(&pipeline, physics, precision, neighbours)?,
            bytes_per_particle: Memory::of::<D>(backend, precision, &pipeline, neighbours).total(),
            l1,
            energy_drift: drift(&finished),
            measured,
            time: finished.series.time,
        })
    }
}

fn drift(finished: &Finished) -> f64 {
    (finished.end.energy - finished.start.energy) / finished.start.energy.max(f64::MIN_POSITIVE)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rate_is_the_slope_around_its_time() {
        let time: Vec<f64> = (0..=20).map(|k| 0.1 * f64::from(k)).collect();
        let kinked = time.iter().map(|t| if *t < 1.0 { 5.0 } else { 5.0 - 3.0 * (t - 1.0) }).collect();
        let record = Record {
            id: String::new(),
            particles: 1,
            steps: 1,
            wall_seconds: 1.0,
            operations: 1.0,
            bytes_per_particle: 1.0,
            l1: BTreeMap::new(),
            energy_drift: 0.0,
            time,
            measured: BTreeMap::from([("mass".to_string(), kinked)]),
        };
        // A line is met to rounding.
        assert!((record.rate("mass", 1.5, 0.4).unwrap() + 3.0).abs() < 1e-12);
        assert!(record.rate("mass", 0.5, 0.4).unwrap().abs() < 1e-12);
        assert_eq!((record.rate("mass", 9.0, 0.4), record.rate("heat", 1.0, 1.0)), (None, None));
        assert_eq!((record.last("mass"), record.largest("mass")), (Some(2.0), Some(5.0)));
        // 5 to t = 1, then down to 2 in a straight line.
        assert!((record.mean("mass", 0.0).unwrap() - 4.25).abs() < 1e-12);
        assert!((record.mean("mass", 1.5).unwrap() - 2.75).abs() < 1e-12);
        assert_eq!((record.mean("mass", 2.0), record.mean("heat", 0.0)), (None, None));
    }
}
