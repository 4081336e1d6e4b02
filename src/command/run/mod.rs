//! `etalon run`: a scene on every backend, compared, with its report.
//!
//! | file | what lives there |
//! |---|---|
//! | `plan.rs`, `graphics.rs` | what is to run; the graphics adapter, or why there is none |
//! | `simulate.rs`, `timed.rs`, `progress.rs` | one simulation, its clocks, its progress |
//! | `seen.rs`, `curve.rs` | the particles at the end as the scene looks at them; the exact solution as a line |
//! | `observe.rs` | what a scene measures while it runs, and at the end |
//! | `compare.rs`, `approximation.rs` | the three sources of error |
//! | `sensitivity.rs`, `noisy.rs` | where tolerances come from |
//! | `wrapped.rs` | an engine with clocks or noise around it |
//! | `assemble.rs`, `picture.rs`, `attached.rs` | the report; a picture of the plane; files for other programs |

mod approximation;
mod assemble;
mod attached;
pub mod compare;
mod curve;
pub mod graphics;
mod noisy;
mod observe;
mod picture;
pub mod plan;
pub mod progress;
pub mod seen;
mod sensitivity;
pub mod simulate;
mod timed;
mod wrapped;

use super::arguments::RunArguments;
use super::choices::{Backend, Precision};
use super::explain::work_per_update;
use super::failure::Failure;
use super::memory::{self, Memory};
use super::restarts::{self, Restarts};
use super::setup::{self, Setup};
use super::{Done, machine};
use crate::fma_peak::{self, FmaPeak};
use crate::report::model::{Measurements, Run, Speed};
use crate::report::{self, Beside, Report};
use assemble::{Circumstances, particle_columns};
use compare::Yardstick;
use etalon_reference::domain::Domain;
use etalon_reference::engine::EngineError;
use etalon_reference::particles::ParticleSet;
use etalon_reference::passes::Physics;
use etalon_reference::pipeline::Pipeline;
use etalon_reference::scenes::{Problem, State, relax};
use etalon_simd::{LaneEngine, Options};
use fearless_simd::Level;
use graphics::Graphics;
use plan::{Combination, Plan, REFERENCE};
use progress::{Progress, note};
use sensitivity::Sensitivity;
use simulate::{Finished, Task};
use std::iter::repeat_n;
use std::path::{Path, PathBuf};
use std::sync::Arc;

pub use timed::{Clocked, Timed};

/// Rounds of relaxation that make a glass.
const GLASS_ROUNDS: usize = 200;

/// Particles of a glass in 1-D.
const GLASS_LENGTH: usize = 64;

/// Runs, compares, writes the report; the text for stdout.
pub fn run(arguments: &RunArguments) -> Result<Done, Failure> {
    let setup = Setup::new(&arguments.scene)?;
    if let Some(every) = arguments.observe_every.or(setup.observe_every).filter(|every| *every <= 0.0) {
        return Err(Failure::BadInput(format!("--observe-every {every}: give a time above 0")));
    }
    let plan = Plan::new(arguments)?;
    let level = setup::instructions(arguments.instructions.as_deref())?;
    let folder = arguments.out.clone().unwrap_or_else(|| {
        // A scene of a file has its report under the file's name.
        let stem =
            setup.file.as_ref().and_then(|path| path.file_stem()).map(|stem| stem.to_string_lossy().into_owned());
        let name = stem.unwrap_or_else(|| setup.problem.name().to_string());
        PathBuf::from("etalon-out").join(format!("{name}-{}d", setup.dimension))
    });
    report::check_destination(&folder)?;
    let pool = setup::threads(arguments.threads)?;
    let session = Session { setup, plan, level, arguments, folder: &folder };
    pool.install(|| match session.setup.dimension {
        1 => session.run::<1>(),
        2 => session.run::<2>(),
        _ => session.run::<3>(),
    })
}

/// All that is settled before the particles exist.
struct Session<'a> {
    setup: Setup,
    plan: Plan,
    level: Level,
    arguments: &'a RunArguments,
    folder: &'a Path,
}

/// The reference's result with what follows from it.
struct Baseline {
    finished: Finished,
    sensitivities: Vec<Sensitivity>,
    nanoseconds_per_update: f64,
}

impl Session<'_> {
    fn run<const D: usize>(&self) -> Result<Done, Failure> {
        let scene = self.setup.problem.scene::<D>();
        let method = scene.method();
        let pipeline = Pipeline::of_scene::<D>(&scene.physics());
        // The scene refuses more neighbours than this in its own words, once it makes the particles.
        let neighbours = method.neighbours.min(1000.0);
        let memory =
            |(backend, precision): Combination| Memory::of::<D>(backend, precision, &pipeline, neighbours).total();
        let largest = self.plan.combinations.iter().map(|c| memory(*c)).fold(0.0, f64::max);
        let asked = match &self.setup.start_file {
            Some(file) => format!("--start-file {}", file.path().display()),
            None => format!("--n {}", method.particles),
        };
        memory::check(&asked, method.particles, largest + memory::beside::<D>())?;
        // Drivers are opened once all else is known to be right: some talk while they start.
        let graphics = self.graphics()?;
        let restarts = self.restarts(graphics.adapter())?;

        let set = particles::<D>(&self.setup, self.level)?;
        if let Some(restarts) = &restarts {
            self.check_restarts::<D>(restarts, &scene.physics(), &set)?;
        }
        let particles = set.len();
        let domain = *set.domain();
        let task = Task {
            scene,
            physics: scene.physics(),
            end_time: self.setup.end_time,
            mobile: set.particles().iter().map(|p| p.mobile).collect(),
            observe_every: self.arguments.observe_every.or(self.setup.observe_every),
            level: self.level,
        };
        let walls = task.mobile.iter().any(|mobile| !mobile);
        let solution = scene.solution(task.end_time)?;
        let solution = solution.as_deref();
        let given = scene.given_momentum(task.end_time);
        let peak = fma_peak::measure(self.level);

        let mut baseline: Option<Baseline> = None;
        let mut kept: Option<Arc<State>> = None;
        let mut runs = Vec::new();
        // The last run gets the set itself and frees it.
        let combinations = &self.plan.combinations;
        for (&combination, set) in combinations.iter().zip(repeat_n(Arc::new(set), combinations.len())) {
            let (backend, precision) = combination;
            if let (Backend::Wgpu, Some(reason)) = (backend, graphics.absent()) {
                note(&format!("{} skipped: {reason}", label(combination)));
                runs.push(Run::skipped(backend.name(), precision.name(), reason));
                continue;
            }
            let progress = Progress::new(&label(combination), self.setup.end_time, true);
            let initial = (combination == REFERENCE).then(|| set.clone());
            let restart = restarts.as_ref().map(|all| all.of(&label(combination), &task.physics, &set));
            let finished = task.run(combination, set, &graphics, progress, restart)?;
            let reference = baseline.as_ref().filter(|_| combination != REFERENCE);
            let mut measured = self.measure(combination, &finished, reference, particles, peak)?;
            measured.bytes_per_particle = memory(combination);
            measured.operations_per_update =
                work_per_update::<D>(&pipeline, task.physics, precision, method.neighbours)?;
            if let Some(solution) = solution {
                measured.discretisation_error =
                    compare::discretisation(&finished.seen, scene.view(), solution, scene.measured(task.end_time))?;
            }
            let judge =
                |reference: &'_ Baseline| reference.sensitivities.iter().find(|s| s.precision() == precision).copied();
            let judged = reference.and_then(|reference| Some((&reference.finished, judge(reference)?)));
            if let Some((reference, sensitivity)) = &judged {
                measured.arithmetic_difference = compare::arithmetic(&finished, reference, scene.view(), sensitivity)?;
            }
            let yardstick =
                judged.as_ref().map(|(reference, sensitivity)| Yardstick::new(reference, sensitivity, &task.mobile));
            measured.conservation = compare::conservation(&finished, D, &given, walls, yardstick);
            let beside = reference.map(|reference| &reference.finished.seen);
            measured.profile = compare::profile(&finished.seen, scene.view(), solution, beside);
            runs.push(Run::ran(backend.name(), precision.name(), measured));
            if kept.is_none() || combination == (Backend::Simd, Precision::Double) {
                kept = Some(Arc::clone(&finished.seen.state));
            }
            if let Some(set) = initial {
                baseline = Some(self.baseline(&task, &set, finished, restarts.as_ref())?);
            }
        }
        let report = assemble::report(&Circumstances {
            setup: &self.setup,
            plan: &self.plan,
            arguments: self.arguments,
            folder: self.folder,
            graphics: &graphics,
            level: self.level,
            peak,
            particles,
            exact: curve::curve(solution, scene.view(), scene.shown()),
            view: scene.view(),
            measured: scene.measured(task.end_time),
            description: scene.description(),
            runs,
        });
        let done = self.finish(&report, kept.as_deref(), &domain)?;
        if let Some(restarts) = restarts {
            restarts.remove();
        }
        Ok(done)
    }

    /// Where restart files go, beside the folder of the report; none if none are wanted.
    fn restarts(&self, adapter: Option<String>) -> Result<Option<Restarts>, Failure> {
        let every = self.arguments.restart_every;
        if every == 0.0 {
            return Ok(None);
        }
        let name = self.folder.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
        let settings = restarts::settings(&self.setup, self.arguments.observe_every, self.level);
        Restarts::new(self.folder.with_file_name(format!("{name}.restart")), every, settings, adapter).map(Some)
    }

    /// Refuses restart files of another run before anything is computed.
    fn check_restarts<const D: usize>(
        &self,
        restarts: &Restarts,
        physics: &Physics,
        set: &ParticleSet<D>,
    ) -> Result<(), Failure> {
        let rounded = self.plan.compared_precisions().into_iter().map(Sensitivity::engine);
        let engines = self.plan.combinations.iter().map(|combination| label(*combination)).chain(rounded);
        for engine in engines {
            restarts.of(&engine, physics, set).found::<D>()?;
        }
        Ok(())
    }

    /// The adapter, if one is needed; an error if it was asked for and is not there.
    fn graphics(&self) -> Result<Graphics, Failure> {
        let wanted = self.plan.combinations.iter().any(|(backend, _)| *backend == Backend::Wgpu);
        let graphics = Graphics::find(self.arguments.adapter.as_deref(), wanted);
        match graphics.absent().filter(|_| self.plan.wgpu_required) {
            Some(reason) => Err(Failure::BadInput(reason.to_string())),
            None => Ok(graphics),
        }
    }

    /// Keeps the reference, and runs it once more for each precision that will be compared, to learn what rounding does.
    fn baseline<const D: usize>(
        &self,
        task: &Task<'_, D>,
        set: &ParticleSet<D>,
        finished: Finished,
        restarts: Option<&Restarts>,
    ) -> Result<Baseline, Failure> {
        let mut sensitivities = Vec::new();
        let measure =
            |precision: Precision, shown: bool| Sensitivity::measure(precision, task, set, &finished, restarts, shown);
        match self.plan.compared_precisions()[..] {
            [] => {}
            [precision] => sensitivities.push(measure(precision, true)?),
            // Side by side: they are not timed.
            _ => {
                let (single, double) =
                    rayon::join(|| measure(Precision::Single, true), || measure(Precision::Double, false));
                sensitivities.extend([single?, double?]);
            }
        }
        let nanoseconds_per_update = finished.wall_seconds * 1e9 / (set.len() as f64 * finished.steps as f64);
        Ok(Baseline { finished, sensitivities, nanoseconds_per_update })
    }

    /// What can be said of a run by itself.
    fn measure(
        &self,
        (backend, precision): Combination,
        finished: &Finished,
        reference: Option<&Baseline>,
        particles: usize,
        peak: FmaPeak,
    ) -> Result<Measurements, Failure> {
        let threads = match backend {
            Backend::Simd => rayon::current_num_threads(),
            Backend::Reference | Backend::Wgpu => 1,
        } as u32;
        let peak = match precision {
            Precision::Single => peak.single,
            Precision::Double => peak.double,
        };
        // Threads beyond the hardware's are no cores.
        let cores = match backend {
            Backend::Wgpu => None,
            _ => Some((threads.min(machine::hardware_threads() as u32), peak)),
        };
        let reference = reference.map(|reference| reference.nanoseconds_per_update);
        let mut speed = Speed::new(particles as u64, finished.steps, finished.wall_seconds, cores, reference);
        if (backend, precision) == REFERENCE {
            speed.speed_up = Some(1.0);
        }
        Ok(Measurements {
            steps: finished.steps,
            time: finished.time,
            threads,
            wall_seconds: finished.wall_seconds,
            operations_per_update: 0.0,
            bytes_per_particle: 0.0,
            speed,
            stages: finished.stages.clone(),
            conservation: Vec::new(),
            discretisation_error: Vec::new(),
            arithmetic_difference: Vec::new(),
            profile: crate::report::model::Profile { selection: String::new(), x: Vec::new(), fields: Vec::new() },
            series: finished.series.clone(),
            ending: finished.ending.clone(),
        })
    }

    /// Writes the folder; the table, or the JSON, for stdout.
    fn finish<const D: usize>(
        &self,
        report: &Report,
        particles: Option<&State>,
        domain: &Domain<D>,
    ) -> Result<Done, Failure> {
        let picture = particles.map(|state| picture::picture(state, domain)).transpose()?.flatten();
        let columns = particles.map(particle_columns).transpose()?;
        let beside = Beside {
            pictures: picture.into_iter().collect(),
            particles: columns.as_ref(),
            attachments: attached::attachments(report, particles, domain),
        };
        report::write(report, beside, self.folder)?;
        let passed = report::passes(report);
        if self.arguments.json {
            let path = self.folder.join("report.json");
            let text = std::fs::read_to_string(&path)
                .map_err(|error| Failure::Broken(format!("cannot read {} again: {error}", path.display())))?;
            return Ok(Done { text, passed });
        }
        let verdict =
            if passed { String::new() } else { format!("\nOutside tolerance: {}\n", report::headline(report)) };
        let page = self.folder.join("report.html");
        let text = format!("{}{verdict}\nReport: {}\n", report::summary_table(report), page.display());
        Ok(Done { text, passed })
    }
}

/// The initial particles; a glass is relaxed on the vector engine.
pub fn particles<const D: usize>(setup: &Setup, level: Level) -> Result<ParticleSet<D>, Failure> {
    if let (Some(file), Problem::Sod(sod)) = (&setup.start_file, &setup.problem) {
        let given = sod.particles_given(file.particles::<D>());
        return given.map_err(|error| Failure::BadInput(format!("--start-file {}: {error}", file.path().display())));
    }
    let options = Options { level };
    let scene = setup.problem.scene::<D>();
    let physics = scene.physics();
    Ok(scene.particles(&mut |across| {
        // In 1-D a glass may be of any length; a short one would meet itself around its box.
        let across = if D == 1 { across.max(GLASS_LENGTH) } else { across };
        note(&format!("relaxing a glass of {} particles", across.pow(D as u32)));
        relax::<D, LaneEngine<f64, D>>(across, physics, GLASS_ROUNDS, 1, |set, pipeline| {
            Ok::<_, EngineError>(LaneEngine::new(set, &pipeline.fields::<D>(), options))
        })
    })?)
}

/// A run as progress and errors name it.
pub fn label((backend, precision): Combination) -> String {
    format!("{backend} {precision}")
}
