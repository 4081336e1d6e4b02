//! What `etalon audit` says: all is well now, and each way to become worse is noticed.

use etalon_audit::{Catalogue, State, Subject, Survey};

/// The hard inputs alone, and one block of random ones.
const SAMPLES: usize = 1;

fn only(catalogue: &Catalogue, name: &str) -> Survey {
    let subject = catalogue.find(name).unwrap();
    Survey::of(catalogue, Some(subject), SAMPLES, None, |_, _, _| ()).unwrap()
}

#[test]
fn nothing_is_worse_than_recorded() {
    let catalogue = Catalogue::load().unwrap();
    let mut heard = 0;
    let subject = catalogue.find("gs25:13").unwrap();
    let survey = Survey::of(&catalogue, Some(subject), SAMPLES, None, |probe, done, all| {
        assert_eq!((probe, done, all), ("reconstruction::slope_limiter", 0, 1));
        heard += 1;
    })
    .unwrap();
    assert_eq!(heard, 1);
    let state = State::of(&catalogue, &survey);
    assert!(state.passed, "{state}");
    let [row] = &state.equations[..] else { panic!("{state}") };
    let here = row.errors.iter().filter(|error| error.measured).count();
    assert_eq!((row.functions[0].as_str(), row.units, here), ("reconstruction::slope_limiter", "fit", 4));
    assert!(row.encoded && row.tests > 0 && row.deviation && !row.open_question && !row.regressed);
    // What WGSL makes of it stands there where it is on record.
    let targets: Vec<&String> = row.targets.iter().filter(|target| *target != "wgsl f32").collect();
    assert_eq!(targets, ["scalar f32", "scalar f64", "lanes f32", "lanes f64", "c", "wgsl"]);
    assert!(row.errors.iter().all(|error| error.worst <= error.budget && error.worst > 0.0));
}

#[test]
fn a_larger_error_or_budget_than_recorded_is_noticed() {
    let mut catalogue = Catalogue::load().unwrap();
    let survey = only(&catalogue, "gs25:13");
    for record in &mut catalogue.budgets.records {
        record.worst /= 4.0;
        record.budget /= 2.0;
    }
    let state = State::of(&catalogue, &survey);
    // Four targets, an error and a budget each.
    assert_eq!(state.regressions.len(), 8, "{state}");
    assert!(!state.passed && state.equations[0].regressed);
    assert!(state.to_string().contains("WORSE"));
}

#[test]
fn a_missing_record_is_noticed_and_a_new_one_mends_it() {
    let mut catalogue = Catalogue::load().unwrap();
    let survey = only(&catalogue, "slope_limiter");
    catalogue.budgets.records.clear();
    assert_eq!(State::of(&catalogue, &survey).regressions.len(), 4);
    catalogue.budgets = survey.budgets();
    assert!(State::of(&catalogue, &survey).passed);
}

#[test]
fn an_equation_that_is_no_longer_encoded_is_noticed() {
    let mut catalogue = Catalogue::load().unwrap();
    catalogue.entries.retain(|entry| entry.name != "slope_limiter");
    let survey = only(&catalogue, "gs25:13");
    let state = State::of(&catalogue, &survey);
    let [worse] = &state.regressions[..] else { panic!("{state}") };
    assert_eq!(worse.subject, "gs25:13");
    assert!(worse.message.contains("no longer encoded by reconstruction::slope_limiter"), "{}", worse.message);
    assert!(!state.equations[0].encoded && state.equations[0].regressed);
}

#[test]
fn every_numbered_equation_has_a_row() {
    let catalogue = Catalogue::load().unwrap();
    // Nothing is measured: a subject without functions.
    let survey = Survey::of(&catalogue, Some(Subject::Functions(Vec::new())), SAMPLES, None, |_, _, _| ()).unwrap();
    assert!(State::of(&catalogue, &survey).equations.is_empty());
    let all = Survey::default();
    let state = State::of(&catalogue, &all);
    assert_eq!(state.equations.len(), 79);
    assert!(!state.unnumbered.is_empty() && state.unnumbered.iter().all(|row| row.encoded && row.kind.is_none()));
    for row in &state.equations {
        assert_eq!(row.encoded, row.not_encoded.is_none(), "{}", row.id);
    }
}
