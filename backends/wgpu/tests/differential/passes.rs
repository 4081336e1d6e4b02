//! Every pass by itself, on difficult particles, against the scalar reference in double precision, which carries a running
//! bound of the error that single precision may make. The bound is proven to first order, so no tolerance is chosen here.

use etalon_kernels_gen::trace::Single;
use etalon_reference::conformance::sets::Difficulty;
use etalon_reference::conformance::{Verdict, check_passes};
use etalon_reference::schemes::Dissipation;

use crate::adapter::device;
use crate::scene::{engine, physics, set};

fn check<const D: usize>(dissipation: Dissipation) {
    let Some(device) = device() else { return };
    let physics = physics::<D>(dissipation);
    let mut failures = Vec::new();
    let mut worst: Vec<(Difficulty, Verdict)> = Vec::new();
    for &difficulty in Difficulty::ALL {
        let set = set::<D>(difficulty, &physics);
        let mut engine = engine(&set, &physics, device);
        let verdicts = check_passes::<D, Single, _>(&set, physics, &mut engine).unwrap();
        assert!(verdicts.len() > 15, "only {} outputs were looked at", verdicts.len());
        for verdict in verdicts {
            // A set with nothing special about it has a bound for every number.
            let vacuous = difficulty == Difficulty::None && verdict.unbounded > 0;
            if vacuous || !verdict.holds() {
                failures.push(format!("{difficulty:?}: {verdict}"));
            }
            match worst.iter_mut().find(|(_, w)| (w.pass, &w.component) == (verdict.pass, &verdict.component)) {
                Some(known) if known.1.ratio() < verdict.ratio() => *known = (difficulty, verdict),
                Some(_) => {}
                None => worst.push((difficulty, verdict)),
            }
        }
    }
    for (difficulty, verdict) in worst {
        eprintln!("{D}-D {dissipation}, worst in set {difficulty:?}: {verdict}");
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn passes_in_one_dimension_stay_within_the_bound() {
    check::<1>(Dissipation::Av);
    check::<1>(Dissipation::AvSlrB2F);
}

#[test]
fn passes_in_two_dimensions_stay_within_the_bound() {
    check::<2>(Dissipation::Av);
    check::<2>(Dissipation::AvSlrB2F);
}

#[test]
fn passes_in_three_dimensions_stay_within_the_bound() {
    check::<3>(Dissipation::Av);
    check::<3>(Dissipation::AvSlrB2);
    check::<3>(Dissipation::AvSlrB2F);
}
