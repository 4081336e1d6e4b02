//! From what was typed to a scene that can be run, or a sentence that says why not.

use super::arguments::SceneArguments;
use super::failure::Failure;
use super::scene_file::{self, MethodChanges, SceneFile};
use super::start_file::StartFile;
use crate::report::plain;
use etalon_kernels_gen::lanes::{available_levels, level_name};
use etalon_reference::passes::Physics;
use etalon_reference::scenes::{Method, Name, Problem, SceneError};
use etalon_reference::schemes::{Gradients, Viscosity, VolumeElement};
use fearless_simd::Level;
use std::path::{Path, PathBuf};

/// A scene with every option settled.
#[derive(Clone, Debug)]
pub struct Setup {
    /// Dimensions.
    pub dimension: usize,
    /// The problem with all its choices and its method.
    pub problem: Problem,
    /// Simulated time to stop at.
    pub end_time: f64,
    /// Simulated time between two measurements, if it was chosen.
    pub observe_every: Option<f64>,
    /// The file it was read from.
    pub file: Option<PathBuf>,
    /// Particles to start from instead of those the tube makes.
    pub start_file: Option<StartFile>,
}

impl Setup {
    /// Settles the options and checks those that can be checked without particles.
    pub fn new(arguments: &SceneArguments) -> Result<Self, Failure> {
        let (mut scene, file) = named_or_read(&arguments.scene)?;
        let dimension = arguments.dim.or(scene.dimension).unwrap_or(scene.name.dimensions()[0]);
        if !(1..=3).contains(&dimension) {
            let at = file.as_ref().map_or(String::new(), |path| format!("{}: ", path.display()));
            return Err(Failure::BadInput(format!("{at}dimension = {dimension}: there are 1, 2 or 3 dimensions")));
        }
        let start_file = arguments.start_file.as_ref().map(|path| StartFile::read(path, dimension)).transpose()?;
        if start_file.is_some() && scene.name != Name::Sod {
            return Err(Failure::BadInput(format!(
                "--start-file: only the tube starts from particles of a file, {} makes its own; leave it out",
                scene.name
            )));
        }
        scene.method = std::mem::take(&mut scene.method).and(MethodChanges {
            particles: start_file.as_ref().map(StartFile::mobile).or(arguments.n),
            start: arguments.start,
            kernel: arguments.kernel,
            neighbours: arguments.neighbours,
            scheme: arguments.scheme,
            grad_h: arguments.grad_h,
            conduction: arguments.conduction,
            ..MethodChanges::default()
        });
        if arguments.smoothed {
            scene.choices.insert("smoothed".into(), toml::Value::Boolean(true));
        }
        if let Some(gamma) = arguments.gamma {
            scene.choices.insert("gamma".into(), toml::Value::Float(gamma));
        }
        let (of_method, of_problem): (Vec<_>, Vec<_>) =
            arguments.set.iter().cloned().partition(|(key, _)| key.starts_with(METHOD));
        scene.choices.extend(of_problem);
        let of_method: toml::Table =
            of_method.into_iter().map(|(key, value)| (key[METHOD.len()..].to_string(), value)).collect();
        let changes = of_method.try_into::<MethodChanges>().map_err(|error| {
            Failure::BadInput(format!(
                "--set {METHOD}..: {}",
                error.message().split_whitespace().collect::<Vec<_>>().join(" ")
            ))
        })?;
        scene.method = std::mem::take(&mut scene.method).and(changes);
        let source = file.as_ref().map_or_else(|| scene.name.to_string(), |path| path.display().to_string());
        let problem =
            scene.problem(dimension).map_err(|wrong| Failure::BadInput(format!("{source}: {}", wrong.problem)))?;
        let end_time = arguments.end_time.or(scene.end_time).unwrap_or_else(|| problem.end_time());
        let observe_every = scene.observe_every;
        let setup = Setup { dimension, problem, end_time, observe_every, file, start_file };
        setup.check()?;
        Ok(setup)
    }

    /// How it is computed.
    pub fn method(&self) -> &Method {
        self.problem.method()
    }

    /// What all passes are told.
    pub fn physics(&self) -> Physics {
        match self.dimension {
            1 => self.problem.scene::<1>().physics(),
            2 => self.problem.scene::<2>().physics(),
            _ => self.problem.scene::<3>().physics(),
        }
    }

    fn check(&self) -> Result<(), Failure> {
        self.check_dissipation()?;
        let checked = match self.dimension {
            1 => self.problem.scene::<1>().check(),
            2 => self.problem.scene::<2>().check(),
            _ => self.problem.scene::<3>().check(),
        };
        match checked {
            // Whether particles from a file leave their supports room shows in their own smoothing lengths.
            Err(SceneError::TooFew { .. }) if self.start_file.is_some() => {}
            checked => checked?,
        }
        self.check_times()
    }

    /// A limiter that has to know a wave's period has none to know where nothing is driven.
    fn check_dissipation(&self) -> Result<(), Failure> {
        let dissipation = self.method().viscosity.dissipation;
        if dissipation.knows_waves() && !self.problem.name().drives_waves() {
            return Err(Failure::BadInput(format!(
                "--scheme {dissipation}: it needs the period of a driven wave, and {} has none; choose {}, which it is where the \
                 period is infinite",
                self.problem.name(),
                dissipation.name().replace('*', "")
            )));
        }
        Ok(())
    }

    /// Box and solution last for a certain time only.
    fn check_times(&self) -> Result<(), Failure> {
        let given = self.end_time;
        if given.is_nan() || given <= 0.0 {
            return Err(Failure::BadInput(format!("--end-time {given}: a run takes time; give a number above 0")));
        }
        let (last, reason) = match self.dimension {
            1 => self.problem.scene::<1>().last_time(),
            2 => self.problem.scene::<2>().last_time(),
            _ => self.problem.scene::<3>().last_time(),
        };
        if given > last {
            return Err(Failure::BadInput(format!(
                "--end-time {given}: the scene lasts to t = {}, for {reason}; give a smaller number",
                plain(last)
            )));
        }
        Ok(())
    }

    /// Options that give this setup again, all spelled out.
    pub fn options(&self) -> String {
        let Method { particles, arrangement, kernel, neighbours, viscosity, gradients, volume_element, grad_h } =
            *self.method();
        let name = self.problem.name();
        let scene = self.file.as_ref().map_or_else(|| name.to_string(), |path| quoted(&path.display().to_string()));
        let particles = match &self.start_file {
            Some(file) => format!("--start-file {}", quoted(&file.path().display().to_string())),
            None => format!("--n {particles} --start {arrangement}"),
        };
        let Viscosity { dissipation, conduction, .. } = viscosity;
        let conduction = format!(" --conduction {conduction}");
        let usual = Viscosity::of(dissipation);
        let coefficients = [
            ("alpha", viscosity.alpha, usual.alpha),
            ("alpha_min", viscosity.alpha_min, usual.alpha_min),
            ("beta", viscosity.beta, usual.beta),
            ("q_fold", viscosity.q_fold, usual.q_fold),
            ("floor", viscosity.floor, usual.floor),
            ("wave_period", viscosity.wave_period, usual.wave_period),
        ];
        let changed = coefficients.iter().filter(|(_, value, usual)| value != usual);
        let coefficients: String = changed.map(|(key, value, _)| format!(" --set {METHOD}{key}={value}")).collect();
        let formulation = formulation(gradients, volume_element);
        let formulation: String =
            formulation.iter().map(|(key, value)| format!(" --set {METHOD}{key}={value}")).collect();
        // A key is part of a problem's definition: it has a TOML form.
        let choices = scene_file::choices(&self.problem).unwrap_or_default();
        let choices: String =
            choices.iter().map(|(key, value)| format!(" --set {}", quoted(&setting(key, value)))).collect();
        format!(
            "{scene} --dim {} {particles} --scheme {dissipation} --kernel {kernel} --neighbours {neighbours} --grad-h {grad_h}\
             {conduction}{coefficients}{formulation}{choices} --end-time {}",
            self.dimension, self.end_time
        )
    }

    /// Gradients and volume elements in words, where they are not the usual ones.
    pub fn formulation(&self) -> Option<String> {
        let Method { gradients, volume_element, .. } = *self.method();
        let words = formulation(gradients, volume_element);
        let words: Vec<String> =
            words.iter().map(|(key, value)| format!("{} {value}", key.replace('_', " "))).collect();
        (!words.is_empty()).then(|| words.join(", "))
    }

    /// The scheme's coefficients in words.
    pub fn coefficients(&self) -> String {
        let Viscosity { dissipation, alpha, alpha_min, beta, q_fold, conduction, .. } = self.method().viscosity;
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

/// Gradients and volume elements where they are not the usual ones, by the keys of a scene file.
fn formulation(gradients: Gradients, volume_element: VolumeElement) -> Vec<(&'static str, &'static str)> {
    let mut unusual = Vec::new();
    if gradients != Physics::STANDARD.gradients {
        unusual.push(("gradients", gradients.name()));
    }
    if volume_element != Physics::STANDARD.volume_element {
        unusual.push(("volume_elements", volume_element.name()));
    }
    unusual
}

/// A key and its value as `--set` takes them; a word without its quotes.
fn setting(key: &str, value: &toml::Value) -> String {
    match value {
        toml::Value::String(word) => format!("{key}={word}"),
        value => format!("{key}={value}"),
    }
}

/// As a shell takes it for one word.
pub fn quoted(word: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_./=".contains(c);
    if !word.is_empty() && word.chars().all(plain) { word.into() } else { format!("'{}'", word.replace('\'', "'\\''")) }
}

/// What keys of the method begin with in `--set`.
const METHOD: &str = "method.";

/// A scene by its name, or read from a file.
fn named_or_read(given: &str) -> Result<(SceneFile, Option<PathBuf>), Failure> {
    let path = Path::new(given);
    let unknown = match given.parse::<Name>() {
        Ok(name) => return Ok((SceneFile::of(name), None)),
        Err(unknown) => unknown,
    };
    // A name that there is not, unless it looks like a file or is one.
    if !path.exists() && path.extension().is_none() && path.components().count() < 2 {
        return Err(Failure::BadInput(format!("{unknown}, or give a file that describes one, such as my-scene.toml")));
    }
    let text = std::fs::read_to_string(path)
        .map_err(|error| Failure::BadInput(format!("{given}: the scene cannot be read ({error})")))?;
    let scene = SceneFile::parse(&text).map_err(|wrong| {
        let at = wrong.line.map_or(String::new(), |line| format!(", line {line}"));
        Failure::BadInput(format!("{given}{at}: {}", wrong.problem))
    })?;
    Ok((scene, Some(path.to_path_buf())))
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
