//! The restart files of the runs that a command makes: where they lie, when they are written, how a run goes on from one.

use super::choices::Backend;
use super::failure::Failure;
use super::setup::Setup;
use crate::command::run::progress::note;
use crate::report::model::Stage;
use crate::snapshot::begun;
use crate::snapshot::restart::{Settings, load, save};
use etalon_kernels_gen::Field;
use etalon_kernels_gen::lanes::level_name;
use etalon_reference::engine::{Engine, EngineError};
use etalon_reference::particles::ParticleSet;
use etalon_reference::passes::Physics;
use etalon_reference::simulation::{Checkpoint, Simulation};
use fearless_simd::Level;
use serde::{Deserialize, Serialize};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// Seconds between two restart files where nothing else is asked for: what an interruption may cost.
pub const USUAL_SECONDS: f64 = 300.0;

/// What the bits and the series of a run depend on beside its engine, physics, box and particles.
pub fn settings(setup: &Setup, observe_every: Option<f64>, level: Level) -> Vec<(&'static str, String)> {
    let observed = observe_every.or(setup.observe_every);
    vec![
        ("scene", setup.options()),
        ("instructions", level_name(level).into()),
        ("observed every", observed.map_or("usual".into(), |every| every.to_string())),
    ]
}

/// Where the restart files of a command lie, and how often they are written.
#[derive(Debug)]
pub struct Restarts {
    folder: PathBuf,
    every: Duration,
    settings: Vec<(&'static str, String)>,
    /// The graphics adapter, which a run on it depends on.
    adapter: Option<String>,
    /// Those that were asked for.
    taken: Mutex<Vec<PathBuf>>,
}

impl Restarts {
    /// In this folder, so many seconds after each other, for runs with these [`settings`] and on this adapter, if on one.
    pub fn new(
        folder: PathBuf,
        every: f64,
        settings: Vec<(&'static str, String)>,
        adapter: Option<String>,
    ) -> Result<Self, Failure> {
        let every = Duration::try_from_secs_f64(every)
            .map_err(|_| Failure::BadInput(format!("--restart-every {every}: give seconds from 0 to 1e9")))?;
        match std::fs::metadata(&folder) {
            Ok(found) if found.is_dir() => {}
            Err(error) if error.kind() == ErrorKind::NotFound => {}
            Ok(_) => return Err(unusable(&folder, &"it is no folder")),
            Err(error) => return Err(unusable(&folder, &error)),
        }
        Ok(Restarts { folder, every, settings, adapter, taken: Mutex::default() })
    }

    /// The restart file of a run of these particles by this engine (`simd f64`).
    pub fn of<const D: usize>(&self, engine: &str, physics: &Physics, set: &ParticleSet<D>) -> Restart {
        let mut settings = Settings::new(engine, physics, set.domain()).with("particles", fingerprint(set));
        for (name, value) in &self.settings {
            settings = settings.with(name, value);
        }
        if let Some(adapter) = self.adapter.as_ref().filter(|_| engine.starts_with(Backend::Wgpu.name())) {
            settings = settings.with("adapter", adapter);
        }
        let path = self.folder.join(format!("{}.h5", engine.replace(' ', "_")));
        if let Ok(mut taken) = self.taken.lock() {
            taken.push(path.clone());
        }
        Restart { path, settings, every: self.every, on_the_way: true, last: Instant::now(), failed: false }
    }

    /// Removes the files that were asked for, once what they are for is on the disk, with what a stop in the middle of writing them has left.
    /// What cannot be removed is not lost.
    pub fn remove(&self) {
        let Ok(taken) = self.taken.lock() else { return };
        let names: Vec<&str> = taken.iter().filter_map(|path| path.file_name()?.to_str()).collect();
        let ours = |found: &str| names.iter().any(|name| found == *name || found.starts_with(&begun(name)));
        for entry in std::fs::read_dir(&self.folder).into_iter().flatten().flatten() {
            if entry.file_name().to_str().is_some_and(ours) {
                let _ = std::fs::remove_file(entry.path());
            }
        }
        let _ = std::fs::remove_dir(&self.folder);
    }
}

fn unusable(folder: &Path, problem: &dyn std::fmt::Display) -> Failure {
    Failure::BadInput(format!(
        "restart files cannot lie in {}: {problem}; choose another folder with --out, or --restart-every 0",
        folder.display()
    ))
}

/// Tells one set of particles from another.
fn fingerprint<const D: usize>(set: &ParticleSet<D>) -> String {
    let mut hash = crc32fast::Hasher::new();
    for (number, particle) in set.particles().iter().enumerate() {
        let numbers = particle.position.iter().chain(&particle.velocity);
        let own = [particle.mass, particle.smoothing_length, particle.internal_energy, set.species(number)];
        for number in numbers.chain(&own) {
            hash.update(&number.to_bits().to_le_bytes());
        }
        hash.update(&[u8::from(particle.mobile)]);
    }
    format!("{} ({:08x})", set.len(), hash.finalize())
}

/// What of a run is kept beside its particles.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SoFar {
    /// Wall-clock time of its steps.
    pub wall_seconds: f64,
    /// The same by stage.
    pub stages: Vec<Stage>,
    /// When it was measured on the way.
    pub time: Vec<f64>,
    /// What was measured then, quantity by quantity.
    pub values: Vec<Vec<f64>>,
}

impl SoFar {
    /// Stages of the time before and after a stop.
    pub fn and_stages(&self, later: Vec<Stage>) -> Vec<Stage> {
        let mut all = self.stages.clone();
        for stage in later {
            match all.iter_mut().find(|known| known.name == stage.name) {
                Some(known) => {
                    known.seconds += stage.seconds;
                    known.count += stage.count;
                }
                None => all.push(stage),
            }
        }
        all
    }
}

/// The restart file of one run.
#[derive(Clone, Debug)]
pub struct Restart {
    path: PathBuf,
    settings: Settings,
    every: Duration,
    on_the_way: bool,
    last: Instant,
    failed: bool,
}

impl Restart {
    /// The same for a run that cannot go on from a state half-way, since something in it is kept nowhere: only what is done is kept.
    pub fn of_the_end_only(self) -> Self {
        Restart { on_the_way: false, ..self }
    }

    /// What is there of an earlier attempt.
    ///
    /// # Errors
    /// A file of another run, or one that is damaged.
    pub fn found<const D: usize>(&self) -> Result<Option<(Checkpoint, SoFar)>, Failure> {
        // What else is wrong with it, reading tells.
        if self.path.try_exists().is_ok_and(|there| !there) {
            return Ok(None);
        }
        let found = load::<D, SoFar>(&self.path, &self.settings);
        found.map(Some).map_err(|error| Failure::BadInput(format!("{error}; or remove the file to begin anew")))
    }

    /// Whether it is time for the next file; `last` after the last step, when it is kept what took longer than the time between two.
    pub fn due(&self, wall_seconds: f64, last: bool) -> bool {
        match last {
            true => wall_seconds >= self.every.as_secs_f64(),
            false => self.on_the_way && self.last.elapsed() >= self.every,
        }
    }

    /// Writes the file, with these fields besides. If the system refuses, the run goes on without: that is told once.
    ///
    /// # Errors
    /// Whatever reading from the engine gives.
    pub fn keep<const D: usize, E: Engine<D>>(
        &mut self,
        simulation: &mut Simulation<D, E>,
        further: &[Field],
        so_far: &SoFar,
    ) -> Result<(), Failure> {
        let checkpoint =
            simulation.checkpoint(further).map_err(|error: EngineError| Failure::Broken(error.to_string()))?;
        let written = self.written(&checkpoint, so_far);
        if let Some(problem) = written.err().filter(|_| !self.failed) {
            note(&format!("the run goes on, but cannot be taken up again after a stop: {problem}"));
            self.failed = true;
        }
        self.last = Instant::now();
        Ok(())
    }

    fn written(&self, checkpoint: &Checkpoint, so_far: &SoFar) -> Result<(), String> {
        let folder = self.path.parent().unwrap_or(Path::new("."));
        std::fs::create_dir_all(folder).map_err(|error| format!("cannot create {}: {error}", folder.display()))?;
        save(&self.path, checkpoint, &self.settings, so_far).map_err(|error| error.to_string())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::snapshot::testing::Place;
    use etalon_reference::scenes::Scene;
    use etalon_reference::scenes::sod::Sod;

    #[test]
    fn only_files_that_were_asked_for_are_removed() {
        let place = Place::new("restarts");
        let folder = place.path("tube.restart");
        let scene = Sod::standard(1);
        let set = Scene::<1>::particles(&scene, &mut |_| unreachable!("it starts from a lattice")).unwrap();
        let restarts = Restarts::new(folder.clone(), 1.0, Vec::new(), None).unwrap();
        let restart = restarts.of::<1>("simd f64", &Scene::<1>::physics(&scene), &set);
        assert_eq!(restart.found::<1>().unwrap(), None);
        std::fs::create_dir_all(&folder).unwrap();
        for file in ["simd_f64.h5", ".simd_f64.h5.partial-7", "simd_f32.h5", ".simd_f32.h5.partial-7"] {
            std::fs::write(folder.join(file), "").unwrap();
        }
        restarts.remove();
        let left = std::fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().file_name());
        let mut left: Vec<_> = left.collect();
        left.sort();
        assert_eq!(left, [".simd_f32.h5.partial-7", "simd_f32.h5"]);
    }

    #[test]
    fn what_no_file_can_lie_in_is_refused_at_once() {
        let place = Place::new("restarts-file");
        let path = place.path("tube.restart");
        std::fs::write(&path, "mine").unwrap();
        let refused = |every: f64| Restarts::new(path.clone(), every, Vec::new(), None).unwrap_err().to_string();
        assert!(refused(1.0).contains("it is no folder; choose another"), "{}", refused(1.0));
        assert!(refused(-1.0).contains("--restart-every -1: give seconds from 0"), "{}", refused(-1.0));
        assert!(refused(1e300).contains("to 1e9"), "{}", refused(1e300));
        assert_eq!(std::fs::read_to_string(&path).unwrap(), "mine");
    }
}
