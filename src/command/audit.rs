//! `etalon audit`: every equation, whether it is encoded and tested, how far each target is from the truth, and what became worse
//! since that was recorded.

mod adapter;

use super::Done;
use super::arguments::AuditArguments;
use super::failure::Failure;
use etalon_audit::{Catalogue, FULL_SAMPLES, RecordError, State, Survey};
use indicatif::{ProgressBar, ProgressStyle};
use serde_json::json;
use std::path::Path;

/// Enough to notice what changed, in ten seconds or so. A record is made with [`FULL_SAMPLES`].
const QUICK_SAMPLES: usize = 1000;

/// The state of all equations, or of one.
pub fn audit(arguments: &AuditArguments) -> Result<Done, Failure> {
    let mut catalogue = catalogue()?;
    if let Some(folder) = &arguments.against {
        catalogue = catalogue.with_records(folder).map_err(|error| Failure::BadInput(format!("--against: {error}")))?;
    }
    let only = arguments.only.as_ref().map(|name| catalogue.find(name));
    let only = only.transpose().map_err(|unknown| Failure::BadInput(format!("--only: {unknown}")))?;
    let root = Path::new(".");
    if arguments.record && !Catalogue::has_records(root) {
        let wrong = "--record: the folder audit with its records is not here; go to the root of Etalon's sources";
        return Err(Failure::BadInput(wrong.to_string()));
    }
    let samples = arguments.samples.unwrap_or(if arguments.record { FULL_SAMPLES } else { QUICK_SAMPLES });
    let adapter = adapter::find(arguments)?;

    let bar = ProgressBar::new(0);
    if let Ok(style) = ProgressStyle::with_template("[{wide_bar}] {pos}/{len} {msg}, {eta} left") {
        bar.set_style(style.progress_chars("=> "));
    }
    let progress = |probe: &str, done: usize, all: usize| {
        bar.set_length(all as u64);
        bar.set_position(done as u64);
        bar.set_message(probe.to_string());
    };
    let survey = Survey::of(&catalogue, only, samples, adapter.as_deref(), progress);
    bar.finish_and_clear();
    let survey = survey.map_err(|error| Failure::Broken(error.to_string()))?;

    if arguments.record {
        let wrong = |error: RecordError| Failure::Broken(format!("--record: {error}"));
        eprintln!("enclosing ranges, trying textbook forms");
        catalogue.record(&survey, samples, root).map_err(wrong)?;
        for path in catalogue.write_records(root).map_err(wrong)? {
            eprintln!("{} written", path.display());
        }
    }
    told(&State::of(&catalogue, &survey), arguments.json)
}

/// The state in words or JSON; passed unless something is wrong.
fn told(state: &State, json: bool) -> Result<Done, Failure> {
    let text = if json { super::to_text(&as_json(state)?)? } else { state.to_string() };
    Ok(Done { text, passed: state.passed })
}

/// Everything that is known of the equations.
pub fn catalogue() -> Result<Catalogue, Failure> {
    Catalogue::load().map_err(|error| Failure::Broken(error.to_string()))
}

fn as_json(state: &State) -> Result<serde_json::Value, Failure> {
    let mut value = json!({ "schema": "etalon-audit", "schema_version": 2 });
    super::extend(&mut value, state)?;
    Ok(value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::command::finished;
    use etalon_audit::{Catalogue, Probe, Subject, own, positive, probe};
    use etalon_kernels_gen::registered;
    use std::process::ExitCode;

    mod equations {
        //! One whose units fit, and one whose units do not.
        use etalon_kernels_gen::{Real, equation};

        /// The floor of Balsara's limiter. Source: none.
        #[equation(unnumbered = "test: a rate")]
        pub fn rate<R: Real>(sound_speed: R, inverse_h: R, divergence: R) -> R {
            divergence.abs() + 1e-4 * sound_speed * inverse_h
        }

        /// The same without its smoothing length. Source: none.
        #[equation(unnumbered = "test: a rate without its length")]
        pub fn rate_without_length<R: Real>(sound_speed: R, divergence: R) -> R {
            divergence.abs() + 1e-4 * sound_speed
        }
    }

    fn probes() -> [Vec<Probe>; 2] {
        let fits = probe! {
            equations::rate(sound_speed, inverse_h, divergence);
            sound_speed: R = own("c", "sound speed"), "L T^-1", positive(0.1, 10.0);
            inverse_h: R = own("h^{-1}", "inverse smoothing length"), "L^-1", positive(0.1, 10.0);
            divergence: R = own("d", "divergence"), "T^-1", positive(0.1, 10.0);
            => rate: R = own("s", "rate"), "T^-1";
        };
        let wrong = probe! {
            equations::rate_without_length(sound_speed, divergence);
            sound_speed: R = own("c", "sound speed"), "L T^-1", positive(0.1, 10.0);
            divergence: R = own("d", "divergence"), "T^-1", positive(0.1, 10.0);
            => rate: R = own("s", "rate"), "T^-1";
        };
        [fits, wrong]
    }

    /// What the command comes to for the equation of these probes, were it one of ours.
    fn audited(probes: &[Probe], json: bool) -> (String, ExitCode) {
        let mut catalogue = Catalogue::load().unwrap();
        let entry = registered().into_iter().find(|entry| probes[0].is_of(entry)).unwrap();
        let probes: Vec<&Probe> = probes.iter().collect();
        let survey =
            Survey::of_probes(&catalogue, Some(Subject::Functions(vec![entry])), &probes, 1, None, |_, _, _| ())
                .unwrap();
        // Its errors are on record: nothing is wrong but what is wrong with it.
        catalogue.budgets = survey.budgets();
        let done = told(&State::of(&catalogue, &survey), json).unwrap();
        (done.text.clone(), finished(Ok(done)))
    }

    #[test]
    fn an_equation_whose_units_do_not_fit_exits_with_1() {
        let [fits, wrong] = probes();
        for json in [false, true] {
            let (text, code) = audited(&fits, json);
            assert_eq!(code, ExitCode::SUCCESS, "{text}");
            let (text, code) = audited(&wrong, json);
            assert_eq!(code, ExitCode::from(1), "{text}");
            assert!(text.contains("a sum of T^-1 and L T^-1") && text.contains("rate_without_length"), "{text}");
        }
    }
}
