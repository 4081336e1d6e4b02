//! One simulation from start to end.

use super::plan::Combination;
use super::progress::Progress;
use super::state::{State, Totals};
use super::timed::{Clocked, Timed};
use crate::command::choices::{Backend, Precision};
use crate::command::failure::Failure;
use crate::command::run::graphics::Graphics;
use crate::report::model::Stage;
use etalon_reference::domain::Domain;
use etalon_reference::engine::{Engine, EngineError, PlainEngine};
use etalon_reference::particles::ParticleSet;
use etalon_reference::passes::Physics;
use etalon_reference::pipeline::Pipeline;
use etalon_reference::simulation::Simulation;
use etalon_simd::{LaneEngine, Options};
use fearless_simd::Level;
use std::sync::Arc;
use std::time::Instant;

/// What every run of a scene has in common.
pub struct Task {
    /// The physics.
    pub physics: Physics,
    /// When to stop.
    pub end_time: f64,
    /// Which particles move.
    pub mobile: Vec<bool>,
    /// The vector instructions to use.
    pub level: Level,
}

/// A simulation that reached its end.
pub struct Finished {
    /// The particles at the end; shared, for several may keep them.
    pub state: Arc<State>,
    /// Sums at the start.
    pub start: Totals,
    /// Sums at the end.
    pub end: Totals,
    /// Steps taken.
    pub steps: u64,
    /// Time reached.
    pub time: f64,
    /// Wall-clock time of all steps.
    pub wall_seconds: f64,
    /// The same by stage.
    pub stages: Vec<Stage>,
}

impl Task {
    /// Runs the particles on the backend of a combination. An engine has its own copy of them: the set is let go before the first step,
    /// and its memory is free again if nobody else holds it.
    pub fn run<const D: usize>(
        &self,
        combination: Combination,
        set: Arc<ParticleSet<D>>,
        graphics: &Graphics,
        progress: Progress,
    ) -> Result<Finished, Failure> {
        let fields = Pipeline::of_scene::<D>(&self.physics).fields::<D>();
        let options = Options { level: self.level };
        let domain = *set.domain();
        match combination {
            (Backend::Reference, Precision::Double) => {
                self.simulate(Timed::new(made(set, PlainEngine::<f64, D>::new)), &domain, progress)
            }
            (Backend::Reference, Precision::Single) => {
                self.simulate(Timed::new(made(set, PlainEngine::<f32, D>::new)), &domain, progress)
            }
            (Backend::Simd, Precision::Double) => {
                self.simulate(made(set, |set| LaneEngine::<f64, D>::new(set, &fields, options)), &domain, progress)
            }
            (Backend::Simd, Precision::Single) => {
                self.simulate(made(set, |set| LaneEngine::<f32, D>::new(set, &fields, options)), &domain, progress)
            }
            (Backend::Wgpu, _) => graphics.run(self, &set, progress),
        }
    }

    /// Runs an engine to the end time.
    pub fn simulate<const D: usize, E: Engine<D> + Clocked>(
        &self,
        engine: E,
        domain: &Domain<D>,
        mut progress: Progress,
    ) -> Result<Finished, Failure> {
        let label = progress.label().to_string();
        let wrong = |error: EngineError| Failure::Broken(format!("{label}: {error}"));
        let mut simulation = Simulation::new(engine, self.physics).map_err(wrong)?;
        let start = Totals::read(simulation.engine(), &self.mobile).map_err(wrong)?;
        simulation.engine().restart().map_err(wrong)?;
        let clock = Instant::now();
        simulation.run(self.end_time, |time| progress.step(time)).map_err(wrong)?;
        let wall_seconds = clock.elapsed().as_secs_f64();
        progress.done(wall_seconds);
        let stages = simulation.engine().stages().map_err(wrong)?;
        // The results take the place of what the last step needed.
        simulation.engine().forget_neighbours();
        Ok(Finished {
            state: Arc::new(State::read(simulation.engine(), domain).map_err(wrong)?),
            end: Totals::read(simulation.engine(), &self.mobile).map_err(wrong)?,
            start,
            steps: simulation.steps(),
            time: simulation.time(),
            wall_seconds,
            stages,
        })
    }
}

/// The engine made from a set, which is let go.
fn made<const D: usize, E>(set: Arc<ParticleSet<D>>, make: impl FnOnce(&ParticleSet<D>) -> E) -> E {
    make(&set)
}
