//! From what was typed to a scene that can be run, or a sentence that says why not.

use super::arguments::SceneArguments;
use super::choices::Start;
use super::failure::Failure;
use super::start_file::StartFile;
use crate::report::plain;
use etalon_kernels_gen::lanes::{available_levels, level_name};
use etalon_reference::scenes::sod::{self, Sod};
use etalon_reference::schemes::Viscosity;
use fearless_simd::Level;

/// Heat conducted a hundred times as strongly as usual is no flow to compare anything in.
const MOST_CONDUCTION: f64 = 10.0;

/// A scene with every option settled.
#[derive(Clone, Debug)]
pub struct Setup {
    /// Dimensions.
    pub dimension: usize,
    /// The tube.
    pub sod: Sod,
    /// Simulated time to stop at.
    pub end_time: f64,
    /// Particles to start from instead of those the tube makes.
    pub start_file: Option<StartFile>,
}

impl Setup {
    /// Settles the options and checks those that can be checked without particles.
    pub fn new(arguments: &SceneArguments) -> Result<Self, Failure> {
        let standard = Sod::standard(arguments.dim);
        let usual = usual_neighbours(arguments);
        let start_file = arguments.start_file.as_ref().map(|path| StartFile::read(path, arguments.dim)).transpose()?;
        let given = start_file.as_ref().map(StartFile::mobile).or(arguments.n);
        let sod = Sod {
            particles: given.unwrap_or(standard.particles),
            arrangement: arguments.start.arrangement(),
            smoothed: arguments.smoothed,
            gamma: arguments.gamma.unwrap_or(standard.gamma),
            kernel: arguments.kernel,
            neighbours: arguments.neighbours.unwrap_or(usual),
            dissipation: arguments.scheme,
            grad_h: arguments.grad_h,
            conduction: arguments.conduction.unwrap_or(0.0),
        };
        let setup = Setup { dimension: arguments.dim, sod, end_time: arguments.end_time, start_file };
        // Whether particles from a file leave their supports room shows in their own smoothing lengths.
        match (&setup.start_file, setup.dimension) {
            (Some(_), dimension) => sod.check_physics(dimension),
            (None, 1) => sod.check::<1>(),
            (None, 2) => sod.check::<2>(),
            (None, _) => sod.check::<3>(),
        }?;
        setup.check_dissipation()?;
        setup.check_end_time()?;
        Ok(setup)
    }

    /// A limiter that has to know a wave's period has none to know here; heat flows from the hotter to the colder.
    fn check_dissipation(&self) -> Result<(), Failure> {
        let Sod { dissipation, conduction, .. } = self.sod;
        if dissipation.knows_waves() {
            return Err(Failure::BadInput(format!(
                "--scheme {dissipation}: it needs the period of a driven wave, and the tube has none; choose {}, which it is where the \
                 period is infinite",
                dissipation.name().replace('*', "")
            )));
        }
        if !(0.0..=MOST_CONDUCTION).contains(&conduction) {
            return Err(Failure::BadInput(format!(
                "--conduction {conduction}: give a number that is not negative, and at most {MOST_CONDUCTION}"
            )));
        }
        Ok(())
    }

    /// The exact solution lasts until a wave reaches an end of the tube.
    fn check_end_time(&self) -> Result<(), Failure> {
        let given = self.end_time;
        if given <= 0.0 {
            return Err(Failure::BadInput(format!("--end-time {given}: a run takes time; give a number above 0")));
        }
        let exact = self.sod.exact()?;
        let (left, right) = (exact.left_wave(), exact.right_wave());
        let room = [sod::INTERFACE, 1.0 - sod::INTERFACE];
        let reaches = |wave: Option<f64>, room: f64| wave.map_or(f64::INFINITY, |speed| room / speed.abs());
        let last = reaches(left.map(|w| w.head()), room[0]).min(reaches(right.map(|w| w.head()), room[1]));
        if given > last {
            return Err(Failure::BadInput(format!(
                "--end-time {given}: with --gamma {} a wave reaches the end of the tube at t = {}, and there is no exact solution \
                 after that; give a smaller number",
                plain(self.sod.gamma),
                plain(last)
            )));
        }
        Ok(())
    }

    /// Options that give this setup again, all spelled out.
    pub fn options(&self) -> String {
        let Sod { particles, arrangement, smoothed, gamma, kernel, neighbours, dissipation, grad_h, conduction } =
            self.sod;
        let particles = match &self.start_file {
            Some(file) => format!("--start-file {}", quoted(&file.path().display().to_string())),
            None => {
                let start = Start::ALL.iter().find(|s| s.arrangement() == arrangement).map_or("lattice", |s| s.name());
                format!("--n {particles} --start {start}{}", if smoothed { " --smoothed" } else { "" })
            }
        };
        let conduction = if conduction > 0.0 { format!(" --conduction {conduction}") } else { String::new() };
        format!(
            "sod --dim {} {particles} --scheme {dissipation} --kernel {kernel} --neighbours {neighbours} --grad-h {grad_h}\
             {conduction} --gamma {gamma} --end-time {}",
            self.dimension, self.end_time
        )
    }

    /// The scheme's coefficients in words.
    pub fn coefficients(&self) -> String {
        let Viscosity { dissipation, alpha, alpha_min, beta, q_fold, conduction, .. } = self.sod.physics().viscosity;
        let mut words = match dissipation.switches() {
            true => format!("α from {alpha_min} to {alpha}, β = {beta}"),
            false => format!("α = {alpha}, β = {beta}"),
        };
        if dissipation.reconstructs() {
            words += &format!(", reconstruction cut off over {q_fold} h");
        }
        if conduction > 0.0 {
            words += &format!(", conduction α_u = {conduction}");
        }
        words
    }
}

/// As a shell takes it for one word.
pub fn quoted(word: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_./".contains(c);
    if !word.is_empty() && word.chars().all(plain) { word.into() } else { format!("'{}'", word.replace('\'', "'\\''")) }
}

/// The scene's neighbours are for kernels of support 2 h; a wider one gets more, so that h stays the same.
fn usual_neighbours(arguments: &SceneArguments) -> f64 {
    let wider = (arguments.kernel.support() / 2.0).powi(arguments.dim as i32);
    Sod::usual_neighbours(arguments.dim) * wider
}

/// The vector instructions of that name, or the best ones.
pub fn instructions(name: Option<&str>) -> Result<Level, Failure> {
    let levels = available_levels();
    let names: Vec<&str> = levels.iter().map(|level| level_name(*level)).collect();
    match name {
        None => Ok(levels.first().copied().unwrap_or_else(Level::new)),
        Some(name) => levels.iter().copied().find(|level| level_name(*level) == name).ok_or_else(|| {
            Failure::BadInput(format!(
                "--instructions {name}: this processor runs {}; choose one of them",
                names.join(", ")
            ))
        }),
    }
}

/// A pool of that many threads, or one for each the processor has.
pub fn threads(number: Option<usize>) -> Result<rayon::ThreadPool, Failure> {
    /// More help nobody: the pool would only fill memory with stacks.
    const MOST: usize = 4096;
    if let Some(number) = number.filter(|number| *number > MOST) {
        return Err(Failure::BadInput(format!(
            "--threads {number}: at most {MOST} can be started; give a smaller number"
        )));
    }
    let pool = rayon::ThreadPoolBuilder::new().num_threads(number.unwrap_or(0)).build();
    pool.map_err(|error| {
        Failure::BadInput(format!("--threads: the threads could not be started ({error}); give fewer"))
    })
}
