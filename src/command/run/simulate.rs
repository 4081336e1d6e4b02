//! One simulation from start to end.

use super::observe::Observer;
use super::plan::Combination;
use super::progress::Progress;
use super::seen::Seen;
use super::timed::{Clocked, Timed};
use crate::command::choices::{Backend, Precision};
use crate::command::failure::Failure;
use crate::command::run::graphics::Graphics;
use crate::report::model::{Ending, Series, Stage};
use etalon_reference::domain::Domain;
use etalon_reference::engine::{Engine, EngineError, PlainEngine};
use etalon_reference::particles::ParticleSet;
use etalon_reference::passes::Physics;
use etalon_reference::pipeline::Pipeline;
use etalon_reference::scenes::{Scene, State, Totals};
use etalon_reference::simulation::Simulation;
use etalon_simd::{LaneEngine, Options};
use fearless_simd::Level;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// What every run of a scene has in common.
pub struct Task<'a, const D: usize> {
    /// What is run.
    pub scene: &'a dyn Scene<D>,
    /// The physics.
    pub physics: Physics,
    /// When to stop.
    pub end_time: f64,
    /// Which particles move.
    pub mobile: Vec<bool>,
    /// Simulated time between two measurements; usual if none.
    pub observe_every: Option<f64>,
    /// The vector instructions to use.
    pub level: Level,
}

/// A simulation that reached its end.
pub struct Finished {
    /// The particles at the end.
    pub seen: Seen,
    /// What was measured on the way.
    pub series: Series,
    /// What was measured at the end alone.
    pub ending: Ending,
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

impl<const D: usize> Task<'_, D> {
    /// Runs the particles on the backend of a combination. An engine has its own copy of them: the set is let go before the first step,
    /// and its memory is free again if nobody else holds it.
    pub fn run(
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
    pub fn simulate<E: Engine<D> + Clocked>(
        &self,
        engine: E,
        domain: &Domain<D>,
        mut progress: Progress,
    ) -> Result<Finished, Failure> {
        let label = progress.label().to_string();
        let wrong = |error: EngineError| Failure::Broken(format!("{label}: {error}"));
        let forcing = self.scene.forcing().map_err(|error| Failure::BadInput(error.to_string()))?;
        let mut simulation = match forcing {
            Some(force) => Simulation::with_forcing(engine, self.physics, force),
            None => Simulation::new(engine, self.physics),
        }
        .map_err(wrong)?;
        let start = Totals::read(simulation.engine(), &self.mobile).map_err(wrong)?;
        simulation.engine().restart().map_err(wrong)?;
        let mut observer = Observer::new(self.scene, self.observe_every, self.end_time);
        let mut watch = |simulation: &mut Simulation<D, E>| -> Result<Duration, Failure> {
            let (clock, time) = (Instant::now(), simulation.time());
            if observer.wants(time, time >= self.end_time) {
                let state = State::read_for(self.scene, simulation.engine(), domain, time).map_err(wrong)?;
                observer.measure(state).map_err(|error| Failure::Broken(format!("{label}: {error}")))?;
            }
            Ok(clock.elapsed())
        };
        watch(&mut simulation)?;
        // What is read and measured is no part of the simulation's time.
        let mut watching = Duration::ZERO;
        let clock = Instant::now();
        simulation.run_watched(self.end_time, |simulation| {
            progress.step(simulation.time());
            watching += watch(simulation)?;
            Ok::<_, Failure>(())
        })?;
        let wall_seconds = clock.elapsed().saturating_sub(watching).as_secs_f64();
        progress.done(wall_seconds);
        let stages = simulation.engine().stages().map_err(wrong)?;
        let time = simulation.time();
        // The results take the place of what the last step needed.
        simulation.engine().forget_neighbours();
        let state = State::read_for(self.scene, simulation.engine(), domain, time).map_err(wrong)?;
        let ending = observer.ending(&state).map_err(|error| Failure::Broken(format!("{label}: {error}")))?;
        Ok(Finished {
            seen: Seen::new(state, self.scene.view()),
            ending,
            series: observer.series(),
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
