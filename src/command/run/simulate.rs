//! One simulation from start to end.

use super::observe::Observer;
use super::plan::Combination;
use super::progress::Progress;
use super::seen::Seen;
use super::timed::{Clocked, Timed};
use crate::command::choices::{Backend, Precision};
use crate::command::failure::Failure;
use crate::command::restarts::{Restart, SoFar};
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
        restart: Option<Restart>,
    ) -> Result<Finished, Failure> {
        let fields = Pipeline::of_scene::<D>(&self.physics).fields::<D>();
        let options = Options { level: self.level };
        let domain = *set.domain();
        match combination {
            (Backend::Reference, Precision::Double) => {
                self.simulate(Timed::new(made(set, PlainEngine::<f64, D>::new)), &domain, progress, restart)
            }
            (Backend::Reference, Precision::Single) => {
                self.simulate(Timed::new(made(set, PlainEngine::<f32, D>::new)), &domain, progress, restart)
            }
            (Backend::Simd, Precision::Double) => {
                let make = |set: &_| LaneEngine::<f64, D>::new(set, &fields, options);
                self.simulate(made(set, make), &domain, progress, restart)
            }
            (Backend::Simd, Precision::Single) => {
                let make = |set: &_| LaneEngine::<f32, D>::new(set, &fields, options);
                self.simulate(made(set, make), &domain, progress, restart)
            }
            (Backend::Wgpu, _) => graphics.run(self, &set, progress, restart),
        }
    }

    /// Runs an engine to the end time, from its restart file if there is one.
    pub fn simulate<E: Engine<D> + Clocked>(
        &self,
        engine: E,
        domain: &Domain<D>,
        mut progress: Progress,
        restart: Option<Restart>,
    ) -> Result<Finished, Failure> {
        let label = progress.label().to_string();
        let wrong = |error: EngineError| Failure::Broken(format!("{label}: {error}"));
        // Before anything is computed: it may be another run's.
        let found = restart.as_ref().map(Restart::found::<D>).transpose()?.flatten();
        let forcing = self.scene.forcing().map_err(|error| Failure::BadInput(error.to_string()))?;
        let mut simulation = match forcing {
            Some(force) => Simulation::with_forcing(engine, self.physics, force),
            None => Simulation::new(engine, self.physics),
        }
        .map_err(wrong)?;
        let start = Totals::read(simulation.engine(), &self.mobile).map_err(wrong)?;
        simulation.engine().restart().map_err(wrong)?;
        let mut watch = Watch {
            task: self,
            domain,
            label: label.clone(),
            observer: Observer::new(self.scene, self.observe_every, self.end_time),
            restart,
            before: SoFar::default(),
            clock: Instant::now(),
            aside: Duration::ZERO,
        };
        watch.look(&mut simulation)?;
        if let Some((checkpoint, before)) = found {
            simulation.restore(&checkpoint).map_err(wrong)?;
            progress.go_on(checkpoint.steps, checkpoint.time);
            watch.go_on(before);
        }
        (watch.clock, watch.aside) = (Instant::now(), Duration::ZERO);
        simulation.run_watched(self.end_time, |simulation| {
            progress.step(simulation.time());
            watch.look(simulation)?;
            watch.keep(simulation)
        })?;
        let wall_seconds = watch.wall_seconds();
        let stages = watch.before.and_stages(simulation.engine().stages().map_err(wrong)?);
        progress.done(wall_seconds);
        let time = simulation.time();
        // The results take the place of what the last step needed.
        simulation.engine().forget_neighbours();
        let state = State::read_for(self.scene, simulation.engine(), domain, time).map_err(wrong)?;
        let ending = watch.observer.ending(&state).map_err(|error| Failure::Broken(format!("{label}: {error}")))?;
        Ok(Finished {
            seen: Seen::new(state, self.scene.view()),
            ending,
            series: watch.observer.series(),
            end: Totals::read(simulation.engine(), &self.mobile).map_err(wrong)?,
            start,
            steps: simulation.steps(),
            time: simulation.time(),
            wall_seconds,
            stages,
        })
    }
}

/// What is done beside a simulation after each of its steps, and the time that takes, which is no part of the simulation's.
struct Watch<'a, const D: usize> {
    task: &'a Task<'a, D>,
    domain: &'a Domain<D>,
    label: String,
    observer: Observer<'a, D>,
    restart: Option<Restart>,
    before: SoFar,
    clock: Instant,
    aside: Duration,
}

impl<const D: usize> Watch<'_, D> {
    /// Wall-clock time of all steps, those before a stop included.
    fn wall_seconds(&self) -> f64 {
        self.before.wall_seconds + self.clock.elapsed().saturating_sub(self.aside).as_secs_f64()
    }

    fn go_on(&mut self, before: SoFar) {
        self.observer.go_on(before.time.clone(), before.values.clone());
        self.before = before;
    }

    /// Measures what the scene measures, if it is time.
    fn look<E: Engine<D>>(&mut self, simulation: &mut Simulation<D, E>) -> Result<(), Failure> {
        let (begun, time) = (Instant::now(), simulation.time());
        if self.observer.wants(time, time >= self.task.end_time) {
            let wrong = |error: String| Failure::Broken(format!("{}: {error}", self.label));
            let state = State::read_for(self.task.scene, simulation.engine(), self.domain, time);
            let state = state.map_err(|error| wrong(error.to_string()))?;
            self.observer.measure(state).map_err(|error| wrong(error.to_string()))?;
        }
        self.aside += begun.elapsed();
        Ok(())
    }

    /// Writes the restart file, if it is time.
    fn keep<E: Engine<D> + Clocked>(&mut self, simulation: &mut Simulation<D, E>) -> Result<(), Failure> {
        let (begun, wall_seconds) = (Instant::now(), self.wall_seconds());
        let last = simulation.time() >= self.task.end_time;
        let Some(restart) = self.restart.as_mut().filter(|restart| restart.due(wall_seconds, last)) else {
            return Ok(());
        };
        let stages = simulation.engine().stages().map_err(|error| Failure::Broken(error.to_string()))?;
        let (time, values) = self.observer.so_far();
        let stages = self.before.and_stages(stages);
        let so_far = SoFar { wall_seconds, stages, time: time.to_vec(), values: values.to_vec() };
        restart.keep(simulation, self.task.scene.further_fields(), &so_far)?;
        self.aside += begun.elapsed();
        Ok(())
    }
}

/// The engine made from a set, which is let go.
fn made<const D: usize, E>(set: Arc<ParticleSet<D>>, make: impl FnOnce(&ParticleSet<D>) -> E) -> E {
    make(&set)
}
