//! `etalon pareto`: which setting buys a given error cheapest.
//!
//! Runs a scene over all combinations of the chosen resolutions, schemes, kernels, neighbour numbers, precisions and backends, each by
//! itself, and draws error against cost with the front of what nothing beats in both.

use super::Done;
use super::arguments::{ParetoArguments, SceneArguments};
use super::choices::{Backend, Cost, Precision};
use super::failure::Failure;
use super::run::progress::note;
use super::run::seen::names;
use super::setup::Setup;
use super::sweep::{Job, Made, Record, Store, done_of, make};
use crate::report::{Pareto, ParetoPoint, columns, pareto as draw, pareto_front, plain, utc_now};
use etalon_kernels_gen::lanes::level_name;
use etalon_reference::schemes::Dissipation;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// Runs what is not done yet, draws, tells.
pub fn pareto(arguments: &ParetoArguments) -> Result<Done, Failure> {
    let jobs = jobs(arguments)?;
    if let Some(name) = &arguments.error {
        check_error(name, &jobs[0].setup)?;
    }
    let first = &jobs[0].setup;
    let folder = arguments.sweep.out.clone().unwrap_or_else(|| {
        PathBuf::from("etalon-out").join(format!("pareto-{}-{}d", first.problem.name(), first.dimension))
    });
    let Made { store, left, level } = make(&jobs, &folder, &arguments.sweep, None)?;
    let study = Study::new(arguments, &jobs, &store)?;
    study.write(&folder)?;
    let text = match arguments.sweep.json {
        true => super::to_text(&study.json(level_name(level)))?,
        false => study.text(&folder, left),
    };
    Ok(Done::passed(text))
}

/// Every combination of what was chosen.
fn jobs(arguments: &ParetoArguments) -> Result<Vec<Job>, Failure> {
    let base = SceneArguments {
        scene: arguments.scene.clone(),
        dim: arguments.dim,
        end_time: arguments.end_time,
        set: arguments.set.clone(),
        start: arguments.start,
        ..SceneArguments::default()
    };
    let usual = Setup::new(&base)?;
    let method = *usual.method();
    let or = |given: &[usize]| match given {
        // A quarter, half and all of the usual distance between particles.
        [] => [4_usize, 2, 1].map(|share| (method.particles / share.pow(usual.dimension as u32)).max(1)).to_vec(),
        given => given.to_vec(),
    };
    let schemes = match &arguments.scheme[..] {
        [] => vec![Dissipation::Av, Dissipation::AvSlr, Dissipation::AvSlrB2],
        given => given.to_vec(),
    };
    let optional = |given: &[f64]| match given {
        [] => vec![None],
        given => given.iter().copied().map(Some).collect(),
    };
    let kernels = match &arguments.kernel[..] {
        [] => vec![method.kernel],
        given => given.to_vec(),
    };
    let backends = if arguments.backend.is_empty() { vec![Backend::Simd] } else { arguments.backend.clone() };
    let precisions = match &arguments.precision[..] {
        [] => vec![Precision::Single, Precision::Double],
        given => given.to_vec(),
    };
    let mut jobs: Vec<Job> = Vec::new();
    let mut refused: Vec<Failure> = Vec::new();
    for n in or(&arguments.n) {
        for &scheme in &schemes {
            for &kernel in &kernels {
                for neighbours in optional(&arguments.neighbours) {
                    let chosen = SceneArguments {
                        n: Some(n),
                        scheme: Some(scheme),
                        kernel: Some(kernel),
                        neighbours,
                        ..base.clone()
                    };
                    // A size or a neighbour number may be too small for one kernel and do for another.
                    let setup = match Setup::new(&chosen) {
                        Ok(setup) => setup,
                        Err(error) => {
                            refused.push(error);
                            continue;
                        }
                    };
                    for combination in combinations(&backends, &precisions) {
                        jobs.push(Job::new(setup.clone(), combination));
                    }
                }
            }
        }
    }
    match (jobs.is_empty(), refused.pop()) {
        (true, Some(error)) => Err(error),
        (true, None) => Err(Failure::BadInput(
            "--backend wgpu --precision f64: WGSL has no 64-bit floats; add --precision f32 or --backend simd".into(),
        )),
        (false, last) => {
            let mut told: Vec<String> = refused.iter().chain(&last).map(ToString::to_string).collect();
            told.dedup();
            told.iter().for_each(|error| note(&format!("left out: {error}")));
            for job in &jobs {
                job.fits()?;
            }
            Ok(jobs)
        }
    }
}

fn combinations(backends: &[Backend], precisions: &[Precision]) -> Vec<(Backend, Precision)> {
    let all = backends.iter().flat_map(|&b| precisions.iter().map(move |&p| (b, p)));
    all.filter(|combination| *combination != (Backend::Wgpu, Precision::Double)).collect()
}

/// A finished run as a point.
struct Point<'a> {
    job: &'a Job,
    record: &'a Record,
    cost: f64,
    error: f64,
}

/// All points, and which are on the front.
struct Study<'a> {
    title: String,
    cost: Cost,
    error: String,
    points: Vec<Point<'a>>,
    front: Vec<usize>,
}

impl<'a> Study<'a> {
    fn new(arguments: &ParetoArguments, jobs: &'a [Job], store: &'a Store) -> Result<Self, Failure> {
        let done = jobs.iter().zip(done_of(jobs, store)).filter_map(|(job, record)| Some((job, record?)));
        let mut error_name = arguments.error.clone();
        let mut points = Vec::new();
        for (job, record) in done {
            let name = match &error_name {
                Some(name) => name.clone(),
                None => usual_error(record).ok_or_else(|| nothing_to_measure(job))?,
            };
            let error = value(record, &name).ok_or_else(|| unknown_error(&name, record))?;
            error_name = Some(name);
            points.push(Point { job, record, cost: arguments.cost.of(record), error: error.abs() });
        }
        let pairs: Vec<(f64, f64)> = points.iter().map(|point| (point.cost, point.error)).collect();
        let front = pareto_front(&pairs)?;
        let (first, error) = (&jobs[0].setup, error_name.unwrap_or_default());
        let title = format!("{}, {}-D: error against cost", first.problem.name().title(), first.dimension);
        Ok(Study { title, cost: arguments.cost, error, points, front })
    }

    fn label(&self, point: &Point) -> String {
        format!("N = {}", point.record.particles)
    }

    fn kind(&self, point: &Point) -> String {
        let (backend, precision) = point.job.combination;
        let method = point.job.setup.method();
        let varies = |of: &dyn Fn(&Point) -> String| self.points.iter().any(|p| of(p) != of(&self.points[0]));
        let mut parts = vec![format!("{backend} {precision}")];
        if varies(&|p| p.job.setup.method().kernel.to_string()) {
            parts.push(method.kernel.to_string());
        }
        if varies(&|p| p.job.setup.method().neighbours.to_string()) {
            parts.push(format!("{} neighbours", plain(method.neighbours)));
        }
        parts.join(", ")
    }

    fn write(&self, folder: &Path) -> Result<(), Failure> {
        let wrong = |path: &Path, error: std::io::Error| {
            Failure::Broken(format!("cannot write {}: {error}; the results are in results.jsonl", path.display()))
        };
        let put = |name: &str, text: String| {
            let path = folder.join(name);
            std::fs::write(&path, text).map_err(|error| wrong(&path, error))
        };
        put("pareto.json", super::to_text(&self.json(""))?)?;
        if self.points.is_empty() {
            return Ok(());
        }
        let points = self.points.iter().map(|point| ParetoPoint {
            cost: point.cost,
            error: point.error,
            label: self.label(point),
            family: point.job.setup.method().viscosity.dissipation.to_string(),
            kind: self.kind(point),
        });
        let plot = draw(&Pareto {
            file: "pareto.svg".into(),
            title: self.title.clone(),
            caption: "Each mark is a run.".into(),
            cost: self.cost.label().into(),
            error: format!("error: {}", self.error),
            points: points.collect(),
        })?;
        put("pareto.svg", plot.svg())
    }

    fn json(&self, instructions: &str) -> Value {
        let point = |(index, point): (usize, &Point)| {
            let method = point.job.setup.method();
            let (backend, precision) = point.job.combination;
            json!({
                "command": format!("etalon run {} --alone", point.record.id),
                "particles": point.record.particles,
                "scheme": method.viscosity.dissipation.name(),
                "kernel": method.kernel.name(),
                "neighbours": method.neighbours,
                "backend": backend.name(),
                "precision": precision.name(),
                "steps": point.record.steps,
                "wall_seconds": point.record.wall_seconds,
                "operations": point.record.operations,
                "bytes_per_particle": point.record.bytes_per_particle,
                "cost": point.cost,
                "error": point.error,
                "on_front": self.front.contains(&index),
            })
        };
        json!({
            "schema": "etalon-pareto",
            "schema_version": 1,
            "created": utc_now(),
            "title": self.title,
            "cost": self.cost.name(),
            "error": self.error,
            "instructions": instructions,
            "points": self.points.iter().enumerate().map(point).collect::<Vec<_>>(),
        })
    }

    fn text(&self, folder: &Path, left: usize) -> String {
        let mut rows = vec![[
            "scheme".to_string(),
            "particles".into(),
            "how".into(),
            self.cost.name().into(),
            self.error.clone(),
            "front".into(),
        ]];
        let mut order: Vec<usize> = (0..self.points.len()).collect();
        order.sort_by(|&a, &b| self.points[a].cost.total_cmp(&self.points[b].cost));
        for index in order {
            let point = &self.points[index];
            rows.push([
                point.job.setup.method().viscosity.dissipation.to_string(),
                point.record.particles.to_string(),
                self.kind(point),
                plain(point.cost),
                plain(point.error),
                if self.front.contains(&index) { "*".into() } else { String::new() },
            ]);
        }
        let rest = if left > 0 {
            format!("{left} runs are left; the same command goes on with them.\n")
        } else {
            String::new()
        };
        format!("{}\n{}{rest}\nFront: {}\n", self.title, columns(&rows), folder.join("pareto.svg").display())
    }
}

/// The velocity's error against the solution.
fn usual_error(record: &Record) -> Option<String> {
    record.l1.keys().find(|name| name.starts_with("velocity")).cloned()
}

/// An error against the solution, or the last value of what was measured on the way.
fn value(record: &Record, name: &str) -> Option<f64> {
    record.l1.get(name).copied().or_else(|| record.last(name))
}

/// Refuses an error that no run of this scene can have, before any is made.
fn check_error(name: &str, setup: &Setup) -> Result<(), Failure> {
    fn known<const D: usize>(setup: &Setup) -> Vec<&'static str> {
        let scene = setup.problem.scene::<D>();
        let all = scene.quantities().into_iter().chain(scene.quantities_at_end());
        let quantities = all.map(|quantity| quantity.name);
        names(scene.view()).into_iter().chain(quantities).collect()
    }
    let known = match setup.dimension {
        1 => known::<1>(setup),
        2 => known::<2>(setup),
        _ => known::<3>(setup),
    };
    match known.contains(&name) {
        true => Ok(()),
        false => {
            Err(Failure::BadInput(format!("--error {name}: this scene has {}; choose one of them", known.join(", "))))
        }
    }
}

fn nothing_to_measure(job: &Job) -> Failure {
    Failure::BadInput(format!(
        "{} has no exact solution to measure an error against; choose one of what it measures with --error",
        job.setup.problem.name()
    ))
}

fn unknown_error(name: &str, record: &Record) -> Failure {
    let names: Vec<&str> = record.l1.keys().chain(record.measured.keys()).map(String::as_str).collect();
    Failure::BadInput(format!("--error {name}: this scene has {}; choose one of them", names.join(", ")))
}
