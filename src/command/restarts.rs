//! The restart files of the runs that a command makes: where they lie, when they are written, how a run goes on from one.

use super::failure::Failure;
use crate::report::model::Stage;
use crate::snapshot::restart::{Settings, load, save};
use etalon_kernels_gen::Field;
use etalon_reference::engine::{Engine, EngineError};
use etalon_reference::particles::ParticleSet;
use etalon_reference::passes::Physics;
use etalon_reference::simulation::{Checkpoint, Simulation};
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Seconds between two restart files where nothing else is asked for: what an interruption may cost.
pub const USUAL_SECONDS: f64 = 300.0;

/// Where the restart files of a command lie, and how often they are written.
#[derive(Clone, Debug)]
pub struct Restarts {
    folder: PathBuf,
    every: Duration,
    settings: Vec<(&'static str, String)>,
}

impl Restarts {
    /// In this folder, so many seconds after each other. `settings` is all that the bits of a run depend on beside its engine, physics and box.
    pub fn new(folder: PathBuf, every: f64, settings: Vec<(&'static str, String)>) -> Result<Self, Failure> {
        let every = Duration::try_from_secs_f64(every)
            .map_err(|_| Failure::BadInput(format!("--restart-every {every}: give seconds, from 0 on")))?;
        Ok(Restarts { folder, every, settings })
    }

    /// The restart file of a run of these particles by this engine (`simd f64`).
    pub fn of<const D: usize>(&self, engine: &str, physics: &Physics, set: &ParticleSet<D>) -> Restart {
        let mut settings = Settings::new(engine, physics, set.domain()).with("particles", fingerprint(set));
        for (name, value) in &self.settings {
            settings = settings.with(name, value);
        }
        Restart {
            path: self.folder.join(format!("{}.h5", engine.replace(' ', "_"))),
            settings,
            every: self.every,
            on_the_way: true,
            last: Instant::now(),
        }
    }

    /// Removes the files of the engines, once what they ran for is on the disk.
    pub fn remove(&self, engines: &[String]) {
        for engine in engines {
            // What cannot be removed is not lost.
            let _ = std::fs::remove_file(self.folder.join(format!("{}.h5", engine.replace(' ', "_"))));
        }
        let _ = std::fs::remove_dir(&self.folder);
    }
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
        if !self.path.exists() {
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

    /// Writes the file, with these fields besides.
    pub fn keep<const D: usize, E: Engine<D>>(
        &mut self,
        simulation: &mut Simulation<D, E>,
        further: &[Field],
        so_far: &SoFar,
    ) -> Result<(), Failure> {
        let checkpoint =
            simulation.checkpoint(further).map_err(|error: EngineError| Failure::Broken(error.to_string()))?;
        let folder = self.path.parent().unwrap_or(Path::new("."));
        std::fs::create_dir_all(folder)
            .map_err(|error| Failure::Broken(format!("cannot create {}: {error}", folder.display())))?;
        save(&self.path, &checkpoint, &self.settings, so_far)
            .map_err(|error| Failure::Broken(format!("{error}; --restart-every 0 runs without restart files")))?;
        self.last = Instant::now();
        Ok(())
    }
}
