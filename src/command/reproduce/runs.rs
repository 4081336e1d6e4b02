//! The runs that the comparisons take.

use super::conditions::Conditions;
use super::readings::{READINGS, Reading, Runs};
use super::variants::choices;
use crate::command::arguments::{ReproduceArguments, SceneArguments};
use crate::command::choices::{Backend, Precision};
use crate::command::failure::Failure;
use crate::command::run::progress::note;
use crate::command::setup::Setup;
use crate::command::sweep::Job;
use etalon_spec::tables::{Published, Variant};
use std::collections::BTreeSet;

/// A number beside which ours is set.
pub struct Compared {
    /// How ours is read.
    pub reading: &'static Reading,
    /// The scheme or variant, as the paper calls it.
    pub variant: Variant,
    /// The paper's resolution, where the number belongs to one of several.
    pub resolution: Option<usize>,
    /// The paper's number, if it prints one.
    pub published: Option<f64>,
    /// Where the paper has it first.
    pub place: &'static Published,
    /// Our runs, each with the number of particles along the problem where that is what tells them apart, ascending.
    pub jobs: Vec<(usize, Job)>,
}

/// All numbers of the chosen scenes, each once: what two tables of a paper share is the same number.
pub fn wanted(arguments: &ReproduceArguments, all: &'static [Published]) -> Result<Vec<Compared>, Failure> {
    let mut compared: Vec<Compared> = Vec::new();
    let mut left_out = BTreeSet::new();
    for published in all {
        let Some(reading) = READINGS.iter().find(|reading| reading.quantity == published.quantity) else { continue };
        if !arguments.scenes.is_empty() && !arguments.scenes.contains(&reading.scene) {
            continue;
        }
        if arguments.backend == Backend::Wgpu && Conditions::of(reading.scene)?.precision == Precision::Double {
            left_out.insert(reading.scene.name());
            continue;
        }
        let (variant, resolution) = (published.scheme, resolution(reading, published, all));
        let same = |c: &&mut Compared| {
            (c.reading.quantity, c.variant, c.resolution) == (reading.quantity, variant, resolution)
        };
        match compared.iter_mut().find(same) {
            Some(known) => known.published = known.published.or(published.value),
            None => {
                let jobs = jobs(arguments, reading, variant, resolution)?;
                let (place, published) = (published, published.value);
                compared.push(Compared { reading, variant, resolution, published, place, jobs });
            }
        }
    }
    for scene in left_out {
        note(&format!("left out: {scene} needs 64-bit floats, which WGSL does not have"));
    }
    match compared.is_empty() {
        true => {
            Err(Failure::BadInput("no published number belongs to these scenes; leave the names out for all".into()))
        }
        false => Ok(compared),
    }
}

/// The runs that all of them take, each once.
pub fn jobs_of(compared: &[Compared]) -> Vec<Job> {
    let mut jobs: Vec<(String, &Job)> = Vec::new();
    for (_, job) in compared.iter().flat_map(|compared| &compared.jobs) {
        let id = job.id();
        if jobs.iter().all(|(known, _)| *known != id) {
            jobs.push((id, job));
        }
    }
    jobs.into_iter().map(|(_, job)| job.clone()).collect()
}

/// The resolution of a number of which there are several; the lowest where the paper has no number and so says none.
fn resolution(reading: &Reading, published: &Published, all: &[Published]) -> Option<usize> {
    let lowest = || all.iter().filter(|p| p.quantity == published.quantity).filter_map(|p| p.resolution).min();
    match reading.runs {
        Runs::Published => published.resolution.or_else(lowest).map(|resolution| resolution as usize),
        Runs::One | Runs::Series { .. } => None,
    }
}

/// The runs of a variant.
fn jobs(
    arguments: &ReproduceArguments,
    reading: &Reading,
    variant: Variant,
    resolution: Option<usize>,
) -> Result<Vec<(usize, Job)>, Failure> {
    let along: Vec<Option<usize>> = match reading.runs {
        Runs::One => vec![None],
        Runs::Published => vec![resolution],
        Runs::Series { paper, .. } if arguments.paper_resolution => paper.iter().copied().map(Some).collect(),
        Runs::Series { usual, .. } => usual.iter().copied().map(Some).collect(),
    };
    let scaled = |along: usize| (along as f64 * arguments.size) as usize;
    along.into_iter().map(|n| Ok((n.map_or(0, scaled), job(arguments, reading, variant, n)?))).collect()
}

fn job(
    arguments: &ReproduceArguments,
    reading: &Reading,
    variant: Variant,
    along: Option<usize>,
) -> Result<Job, Failure> {
    let (name, conditions) = (reading.scene, Conditions::of(reading.scene)?);
    let setup = |dimension: usize, particles: usize| {
        let mut base = SceneArguments {
            scene: name.to_string(),
            dim: Some(dimension),
            n: Some(particles),
            end_time: conditions.end_time,
            ..choices(variant)?
        };
        let word = |(key, value): &(&str, &str)| (key.to_string(), toml::Value::String(value.to_string()));
        base.set.extend(conditions.set.iter().map(word));
        Setup::new(&base)
    };
    let dimension = match arguments.paper_resolution {
        true => conditions.paper_dimension,
        false => arguments.dim.unwrap_or(conditions.dimension),
    };
    let particles = conditions.particles(dimension, along, arguments.paper_resolution, arguments.size)?;
    let precision = match (arguments.backend, arguments.precision) {
        (Backend::Wgpu, Some(Precision::Double)) => {
            return Err(Failure::BadInput(
                "--backend wgpu --precision f64: WGSL has no 64-bit floats; use --precision f32".into(),
            ));
        }
        (Backend::Wgpu, None) => Precision::Single,
        (_, precision) => precision.unwrap_or(conditions.precision),
    };
    let job = Job::new(setup(dimension, particles)?, (arguments.backend, precision));
    Ok(Job { weight: job.weight * conditions.cost, ..job })
}
