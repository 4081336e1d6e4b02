//! `etalon reproduce`: the papers' comparisons, our number beside the published one.
//!
//! | file | what lives there |
//! |---|---|
//! | `readings.rs` | which of our measurements stands beside which published number |
//! | `runs.rs` | the runs that takes |
//! | `comparison.rs` | both numbers with their ranks |

mod comparison;
mod readings;
mod runs;

use super::Done;
use super::arguments::ReproduceArguments;
use super::choices::Backend;
use super::failure::Failure;
use super::run::graphics::Graphics;
use super::run::progress::note;
use super::setup;
use super::sweep::{Chances, Job, Store, work};
use comparison::Comparison;
use etalon_spec::tables::published;
use std::path::{Path, PathBuf};

/// Minutes that a run of the default sizes may take.
const USUAL_MINUTES: f64 = 15.0;

/// Makes the runs that are not made yet, compares, tells.
pub fn reproduce(arguments: &ReproduceArguments) -> Result<Done, Failure> {
    let all = published().map_err(|error| Failure::Broken(format!("the published tables: {error}")))?;
    let runs = runs::wanted(arguments, all)?;
    let folder = arguments.out.clone().unwrap_or_else(|| PathBuf::from("etalon-out").join("reproduce"));
    let level = setup::instructions(None)?;
    let wanted = arguments.backend == Backend::Wgpu;
    let graphics = Graphics::find(arguments.adapter.as_deref(), wanted);
    if let Some(reason) = graphics.absent().filter(|_| wanted) {
        return Err(Failure::BadInput(format!("--backend wgpu: {reason}")));
    }
    let mut store = Store::open(&folder.join("results.jsonl"))?;
    let minutes = arguments.minutes.or((!arguments.paper_resolution).then_some(USUAL_MINUTES));
    let chances = Chances { level, graphics: &graphics, budget_seconds: minutes.map(|minutes| minutes * 60.0) };
    let jobs: Vec<Job> = runs.iter().map(|run| run.job.clone()).collect();
    let pool = setup::threads(arguments.threads)?;
    let left = pool.install(|| work(&jobs, &mut store, &chances))?;
    if left > 0 {
        note(&format!("{left} runs are left; the same command goes on with them"));
    }
    let comparison = Comparison::new(&runs, &store, all);
    write(&comparison, &folder)?;
    let text = match arguments.json {
        true => super::to_text(&comparison.json())?,
        false => comparison.text(&folder, left),
    };
    Ok(Done::passed(text))
}

fn write(comparison: &Comparison, folder: &Path) -> Result<(), Failure> {
    let put = |name: &str, text: String| {
        let path = folder.join(name);
        std::fs::write(&path, text).map_err(|error| {
            Failure::Broken(format!("cannot write {}: {error}; the results are in results.jsonl", path.display()))
        })
    };
    put("reproduce.json", super::to_text(&comparison.json())?)?;
    if let Some(plot) = comparison.heat_map()? {
        put("heat_map.svg", plot.svg())?;
    }
    Ok(())
}
