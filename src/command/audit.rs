//! `etalon audit`: every equation, whether it is encoded and tested, how far each target is from the truth, and what became worse
//! since that was recorded.

use super::Done;
use super::arguments::AuditArguments;
use super::failure::Failure;
use etalon_audit::{Catalogue, Encoded, FULL_SAMPLES, State, Survey};
use indicatif::{ProgressBar, ProgressStyle};
use serde_json::json;
use std::fs;
use std::path::Path;

/// Enough to notice what changed, in a minute or so. A record is made with [`FULL_SAMPLES`].
const QUICK_SAMPLES: usize = 1000;
/// What `--record` writes.
const RECORDS: [&str; 2] = ["audit/budgets.toml", "audit/equations.toml"];

/// The state of all equations, or of one.
pub fn audit(arguments: &AuditArguments) -> Result<Done, Failure> {
    let mut catalogue = catalogue()?;
    let only = arguments.only.as_ref().map(|name| catalogue.find(name));
    let only = only.transpose().map_err(|unknown| Failure::BadInput(format!("--only: {unknown}")))?;
    if arguments.record && !RECORDS.iter().all(|record| Path::new(record).exists()) {
        let records = RECORDS.join(" and ");
        return Err(Failure::BadInput(format!("--record: {records} are not here; go to the root of Etalon's sources")));
    }
    let samples = arguments.samples.unwrap_or(if arguments.record { FULL_SAMPLES } else { QUICK_SAMPLES });

    let bar = ProgressBar::new(0);
    if let Ok(style) = ProgressStyle::with_template("[{wide_bar}] {pos}/{len} {msg}, {eta} left") {
        bar.set_style(style.progress_chars("=> "));
    }
    let survey = Survey::of(&catalogue, only, samples, |probe, done, all| {
        bar.set_length(all as u64);
        bar.set_position(done as u64);
        bar.set_message(probe.to_string());
    });
    bar.finish_and_clear();

    if arguments.record {
        record(&mut catalogue, &survey)?;
    }
    let state = State::of(&catalogue, &survey);
    let text = if arguments.json { super::to_text(&as_json(&state)?)? } else { state.to_string() };
    Ok(Done { text, passed: state.passed })
}

/// Everything that is known of the equations.
pub fn catalogue() -> Result<Catalogue, Failure> {
    Catalogue::load().map_err(|error| Failure::Broken(error.to_string()))
}

/// Writes both records, and takes them for those that the survey is held against.
fn record(catalogue: &mut Catalogue, survey: &Survey) -> Result<(), Failure> {
    catalogue.budgets = survey.budgets();
    let wrong = |error: &dyn std::fmt::Display| Failure::Broken(format!("--record: {error}"));
    catalogue.encoded = Encoded::now(Path::new("."), &catalogue.reach).map_err(|error| wrong(&error))?;
    let texts = [catalogue.budgets.to_toml(), catalogue.encoded.to_toml()];
    for (path, text) in RECORDS.into_iter().zip(texts) {
        let text = text.map_err(|error| wrong(&error))?;
        fs::write(path, text).map_err(|error| wrong(&format!("cannot write {path}: {error}")))?;
        eprintln!("{path} written");
    }
    Ok(())
}

fn as_json(state: &State) -> Result<serde_json::Value, Failure> {
    let mut value = json!({ "schema": "etalon-audit", "schema_version": 1 });
    super::extend(&mut value, state)?;
    Ok(value)
}
