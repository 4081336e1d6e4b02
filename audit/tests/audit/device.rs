//! Figures of a device: taken on the same inputs against the same truth, held against the record of the same device only.

use etalon_audit::{Budgets, Catalogue, Device, Label, Probe, State, Survey, Target, measure_on, probes, text_mark};
use etalon_kernels_gen::trace::{Drawing, interpret};

/// A device that evaluates drawings as the scalar reference does, and adds a fault.
struct Interpreter {
    name: &'static str,
    fault: fn(f32) -> f32,
}

impl Device for Interpreter {
    fn name(&self) -> String {
        self.name.to_string()
    }
    fn call(&self, function: &str, drawing: &Drawing, calls: usize, rows: &[f32]) -> Result<Vec<f32>, String> {
        if function == "courant_step" {
            return Err("it does not like Courant".to_string());
        }
        let inputs = drawing.inputs().len();
        let row = |call: usize| interpret(drawing, &rows[inputs * call..inputs * (call + 1)]).unwrap();
        Ok((0..calls).flat_map(row).map(self.fault).collect())
    }
}

const GOOD: Interpreter = Interpreter { name: "good", fault: |x| x };
/// Off by 2^-18, 64 ulps at most.
const COARSE: Interpreter = Interpreter { name: "coarse", fault: |x| x * (1.0 + 1.0 / 262_144.0) };

fn named<'a>(key: &str) -> &'a Probe {
    probes().iter().find(|probe| probe.key() == key).unwrap_or_else(|| panic!("no probe {key}"))
}

#[test]
fn a_device_that_computes_as_the_reference_has_its_errors() {
    for key in ["reconstruction::slope_limiter", "kernels::mixed_sinc 3-D", "gradients::inverse_moments 2-D"] {
        let all = measure_on(named(key), Some(&GOOD), 1000).unwrap();
        assert_eq!(all.iter().map(|of| of.target).collect::<Vec<_>>(), Target::ALL, "{key}");
        let (scalar, device) = (&all[0], &all[4]);
        assert_eq!((device.inputs, &device.of_result), (scalar.inputs, &scalar.of_result), "{key}");
        // WGSL promises less, so more is allowed, and where nothing can be promised nothing is measured against it.
        assert!(device.budget > scalar.budget && device.unbounded >= scalar.unbounded, "{key}");
        assert!(device.of_scale.ulps <= scalar.of_scale.ulps && device.violation_count == 0, "{key}");
        assert_eq!(device.device.as_ref().map(|by| by.adapter.as_str()), Some("good"), "{key}");
    }
    assert_eq!(measure_on(named("reconstruction::slope_limiter"), None, 1).unwrap().len(), Target::HERE.len());
}

#[test]
fn a_coarse_device_is_outside_of_its_budget() {
    let limiter = measure_on(named("reconstruction::slope_limiter"), Some(&COARSE), 1000).unwrap();
    assert!(limiter[4].violation_count > 500, "{}", limiter[4].violation_count);
    assert!(limiter[..4].iter().all(|here| here.violation_count == 0));
}

#[test]
fn a_device_that_fails_is_named() {
    let error = measure_on(named("time_step::courant_step"), Some(&GOOD), 1).unwrap_err();
    assert_eq!(error.to_string(), "time_step::courant_step could not be run on good: it does not like Courant");
}

fn survey(catalogue: &Catalogue, device: &dyn Device) -> Survey {
    let subject = catalogue.find("gs25:13").unwrap();
    Survey::of(catalogue, Some(subject), 1, Some(device), |_, _, _| ()).unwrap()
}

/// With the record of this device, and no other's.
fn catalogue(budgets: Budgets) -> Catalogue {
    let mut catalogue = Catalogue::load().unwrap();
    catalogue.budgets.records.retain(|record| record.adapter.is_none());
    let kept = Budgets { records: budgets.records.into_iter().filter(|record| record.adapter.is_some()).collect() };
    catalogue.budgets.records.extend(kept.records);
    catalogue
}

#[test]
fn figures_are_held_against_those_of_the_same_device() {
    let nothing = catalogue(Budgets::default());
    let good = survey(&nothing, &GOOD);
    // New: there is only its budget to be held against.
    assert!(State::of(&nothing, &good).passed);
    let mut recorded = catalogue(good.budgets());
    let [row] = &State::of(&recorded, &good).equations[..] else { panic!() };
    let error = row.errors.last().unwrap();
    assert_eq!((error.target, error.adapter.as_deref(), error.measured), ("wgsl f32", Some("good"), true));
    assert_eq!((error.worst_label, error.budget_label), (Label::Measured, Label::Believed));
    assert!(error.recorded_worst.unwrap() >= error.worst);
    // Another device is not held against it.
    let other = Interpreter { name: "other", ..GOOD };
    assert!(State::of(&recorded, &survey(&recorded, &other)).passed);
    // The same one with a better record is worse than recorded.
    for record in recorded.budgets.records.iter_mut().filter(|record| record.adapter.is_some()) {
        record.worst /= 4.0;
    }
    let state = State::of(&recorded, &good);
    assert_eq!(state.regressions.len(), 1, "{state}");
    assert!(state.regressions[0].message.contains("slope_limiter on wgsl f32"), "{state}");
}

#[test]
fn without_a_device_the_record_is_shown_as_such() {
    let mut recorded = catalogue(survey(&catalogue(Budgets::default()), &GOOD).budgets());
    let subject = || recorded.find("gs25:13").unwrap();
    let alone = Survey::of(&recorded, Some(subject()), 1, None, |_, _, _| ()).unwrap();
    let state = State::of(&recorded, &alone);
    let error = state.equations[0].errors.last().unwrap();
    assert_eq!((error.target, error.measured, error.recorded_worst), ("wgsl f32", false, Some(error.worst)));
    let text = state.to_string();
    assert!(text.contains("WGSL was not run; figures in parentheses are on record, of good."), "{text}");
    assert!(state.passed, "{text}");
    // A record made now keeps it, as long as it is of the same text.
    let kept = |recorded: &Catalogue| {
        let records = alone.budgets().with_absent_devices(&recorded.budgets).records;
        records.iter().filter(|record| record.adapter.is_some()).count()
    };
    assert_eq!(kept(&recorded), 1);
    let record = recorded.budgets.records.last_mut().unwrap();
    assert_eq!(record.text_mark, text_mark(named("reconstruction::slope_limiter")));
    record.text_mark = Some("of another text".to_string());
    assert_eq!(kept(&recorded), 0);
    assert!(State::of(&recorded, &alone).equations[0].errors.iter().all(|error| error.measured));
}
