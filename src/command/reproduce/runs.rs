//! The runs that a comparison takes.

use super::readings::{READINGS, Reading};
use crate::command::arguments::{ReproduceArguments, SceneArguments};
use crate::command::choices::{Backend, Precision};
use crate::command::failure::Failure;
use crate::command::setup::Setup;
use crate::command::sweep::Job;
use etalon_reference::schemes::{Dissipation, Viscosity};
use etalon_spec::tables::{Published, Setups, Test, Variant};

/// A run, and which published numbers it stands beside.
pub struct Run {
    /// The run.
    pub job: Job,
    /// The scheme or variant, as the paper calls it.
    pub variant: Variant,
    /// How each of its quantities is read.
    pub readings: Vec<&'static Reading>,
}

/// The runs of the chosen tables: each scene with each of its variants once, however many quantities it measures.
pub fn wanted(arguments: &ReproduceArguments, all: &[Published]) -> Result<Vec<Run>, Failure> {
    let mut runs: Vec<Run> = Vec::new();
    for published in all {
        let Some(reading) = READINGS.iter().find(|reading| reading.quantity == published.quantity) else { continue };
        let chosen = |scene: &etalon_reference::scenes::Name| reading.scene == *scene;
        if !arguments.scenes.is_empty() && !arguments.scenes.iter().any(chosen) {
            continue;
        }
        let known = runs
            .iter_mut()
            .find(|run| run.job.setup.problem.name() == reading.scene && run.variant == published.scheme);
        match known {
            Some(run) if run.readings.iter().any(|r| r.quantity == reading.quantity) => {}
            Some(run) => run.readings.push(reading),
            None => {
                if let Some(job) = job(arguments, reading, published.scheme)? {
                    runs.push(Run { job, variant: published.scheme, readings: vec![reading] });
                }
            }
        }
    }
    match runs.is_empty() {
        true => {
            Err(Failure::BadInput("no published number belongs to these scenes; leave the names out for all".into()))
        }
        false => Ok(runs),
    }
}

/// The run of a variant; none where it cannot be chosen.
fn job(arguments: &ReproduceArguments, reading: &Reading, variant: Variant) -> Result<Option<Job>, Failure> {
    let Some(choices) = choices(variant) else { return Ok(None) };
    let name = reading.scene;
    let most = name.dimensions().iter().copied().max();
    let dimension = match arguments.paper_resolution {
        true => most.unwrap_or(reading.dimension),
        false => arguments.dim.unwrap_or(reading.dimension),
    };
    let standard = name.standard(dimension)?;
    let particles = match arguments.paper_resolution {
        true => of_paper(reading)?.unwrap_or(standard.method().particles),
        false => ((standard.method().particles as f64 * arguments.size) as usize).max(1),
    };
    let mut base = SceneArguments { scene: name.to_string(), dim: Some(dimension), n: Some(particles), ..choices };
    let word = |(key, value): &(&str, &str)| (key.to_string(), toml::Value::String(value.to_string()));
    base.set.extend(reading.set.iter().map(word));
    let precision = match (arguments.backend, arguments.precision) {
        (Backend::Wgpu, Precision::Double) => {
            return Err(Failure::BadInput(
                "--backend wgpu --precision f64: WGSL has no 64-bit floats; use --precision f32".into(),
            ));
        }
        (_, precision) => precision,
    };
    Ok(Some(Job { setup: Setup::new(&base)?, combination: (arguments.backend, precision) }))
}

/// How a variant is chosen.
fn choices(variant: Variant) -> Option<SceneArguments> {
    let scheme = |name: &str| name.parse::<Dissipation>().ok();
    match variant {
        Variant::Scheme(name) => {
            Some(SceneArguments { scheme: Some(scheme(name.as_str())?), ..SceneArguments::default() })
        }
        Variant::Membrane(name) => {
            let scheme = scheme(name.as_str())?;
            // The coefficients of Table 8 are not all those of Table 1.
            let viscosity = Viscosity::MEMBRANE.into_iter().find(|v| v.dissipation == scheme)?;
            let alpha = ("method.alpha".to_string(), toml::Value::Float(viscosity.alpha));
            Some(SceneArguments { scheme: Some(scheme), set: vec![alpha], ..SceneArguments::default() })
        }
        Variant::Rung(_) => {
            let rung = ("method.rung".to_string(), toml::Value::String(variant.as_str().into()));
            Some(SceneArguments { set: vec![rung], ..SceneArguments::default() })
        }
        Variant::GradH(_) | Variant::Drag(_) => None,
    }
}

/// The paper's particle number; none where it does not say.
fn of_paper(reading: &Reading) -> Result<Option<usize>, Failure> {
    let setups = Setups::load().map_err(|error| Failure::Broken(format!("GS25 Table 2: {error}")))?;
    let test =
        Test::ALL.into_iter().find(|test| etalon_spec::tables::Scene::from(*test).as_str() == reading.scene.name());
    Ok(test.map(|test| (setups.get(test).particles_in_millions * 1e6) as usize))
}
