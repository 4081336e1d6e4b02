//! Many runs as a command asks for them.

use super::work::{Chances, work};
use super::{Job, Store};
use crate::command::arguments::SweepArguments;
use crate::command::choices::Backend;
use crate::command::failure::Failure;
use crate::command::run::graphics::Graphics;
use crate::command::run::progress::note;
use crate::command::setup;
use fearless_simd::Level;
use std::path::Path;

/// What came of it.
pub struct Made {
    /// All records, those of before included.
    pub store: Store,
    /// How many of the runs are left because time ran out.
    pub left: usize,
    /// The vector instructions that were used.
    pub level: Level,
}

/// Makes those of the runs that are not remembered in the folder yet; without a limit of its own a call has `minutes`.
pub fn make(jobs: &[Job], folder: &Path, arguments: &SweepArguments, minutes: Option<f64>) -> Result<Made, Failure> {
    let level = setup::instructions(None)?;
    let wanted = jobs.iter().any(|job| job.combination.0 == Backend::Wgpu);
    let graphics = Graphics::find(arguments.adapter.as_deref(), wanted);
    if let Some(reason) = graphics.absent().filter(|_| wanted) {
        return Err(Failure::BadInput(format!("--backend wgpu: {reason}")));
    }
    let mut store = Store::open(&folder.join("results.jsonl"))?;
    let budget_seconds = arguments.minutes.or(minutes).map(|minutes| minutes * 60.0);
    let pool = setup::threads(arguments.threads)?;
    let chances = Chances { level, graphics: &graphics, budget_seconds };
    let left = pool.install(|| work(jobs, &mut store, &chances))?;
    if left > 0 {
        note(&format!("{left} runs are left; the same command goes on with them"));
    }
    Ok(Made { store, left, level })
}
