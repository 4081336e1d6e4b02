//! NaN, infinities, zeros and wrong signs: what comes out, the same on every target, and said in the ledger.

use etalon_audit::{
    BadInputFault, Kind, bad_input_differences, not_caught, outcomes, own, positive, probe, probes, unsaid,
};
use etalon_spec::{BadValue, Ledger};

fn none<'a>(faults: impl IntoIterator<Item = &'a BadInputFault>) {
    let faults: Vec<String> = faults.into_iter().map(ToString::to_string).collect();
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
}

/// NaN in an argument that matters makes a result NaN, unless the ledger says what it makes instead.
#[test]
fn what_is_not_a_number_comes_out_as_such() {
    let ledger = Ledger::load().unwrap();
    let faults: Vec<BadInputFault> = probes().iter().flat_map(|probe| unsaid(&ledger, probe)).collect();
    none(&faults);
    // Most of what was tried mattered, or nothing was shown.
    let tried: usize = probes().iter().map(|probe| outcomes(probe).len()).sum();
    assert!(tried > 1500, "{tried} arguments and classes");
}

/// And the ledger does not say more than is so.
#[test]
fn what_is_said_to_be_caught_is() {
    none(&not_caught(&Ledger::load().unwrap(), probes()));
}

/// The scalar reference in `f32`, lanes in both precisions, and the drawings that other languages are printed from, simplified or not,
/// give a number, infinity or NaN where the reference does.
#[test]
fn no_target_takes_bad_values_for_others() {
    let faults: Vec<BadInputFault> = probes().iter().flat_map(bad_input_differences).collect();
    none(&faults);
}

mod careless {
    //! An equation that hides NaN.
    use etalon_kernels_gen::{Real, equation};

    /// A limit that stands on the wrong side. Source: none.
    #[equation(unnumbered = "test: a limit that hides NaN")]
    pub fn limited<R: Real>(speed: R) -> R {
        speed.min(10.0)
    }
}

#[test]
fn an_equation_that_hides_nan_is_found() {
    let list = probe! {
        careless::limited(speed);
        speed: R = own("v", "a speed"), "L T^-1", positive(0.1, 100.0);
        => limited: R = own("v'", "the same, limited"), "L T^-1";
    };
    let nan = outcomes(&list[0]).into_iter().find(|outcome| outcome.value == BadValue::Nan).unwrap();
    assert_eq!(nan.kinds.into_iter().collect::<Vec<_>>(), [Kind::Number]);
    let faults = unsaid(&Ledger::load().unwrap(), &list[0]);
    let [fault @ BadInputFault::Hidden { argument: "speed", .. }] = &faults[..] else { panic!("{faults:?}") };
    assert!(fault.to_string().contains("careless::limited: NaN in speed gives a number"), "{fault}");
}
