//! Textbook forms are the same functions, and worse; proven ranges are proven again.

use etalon_audit::{Catalogue, Gains, Interval, Quad, Ranges, Textbook, enclose, probes, textbooks};
use etalon_kernels_gen::Real;

/// A hundredth of what the record has, beside all hard inputs.
const SAMPLES: usize = 1000;
/// Below this a result is what the oracle's digits leave of zero: the driving's process after a hundred times its memory, for one.
const NOTHING: f64 = 1e-36;

/// With the oracle's digits both forms give the same: what is compared is one function. The textbook's form cancels there too: it has thirteen digits left
/// but for the hardest inputs, such as the sinc's slope at `t = 1e-30`.
#[test]
fn textbook_forms_are_the_same_functions() {
    for textbook in textbooks() {
        let probe = textbook.of_probe().unwrap_or_else(|| panic!("there is no probe {}", textbook.probe));
        let (mut compared, mut close) = (0, 0);
        for inputs in textbook.inputs(probe, 1).into_iter().step_by(7) {
            let exact: Vec<Quad> = inputs.iter().map(|x| Quad::exact(*x)).collect();
            let (ours, theirs) = (probe.evaluate(&exact).unwrap(), textbook.exact(&inputs));
            assert_eq!(ours.len(), theirs.len(), "{}", textbook.probe);
            // 0/0 in the textbook's form is no number here either.
            if !theirs.iter().all(|x| x.is_finite()) {
                continue;
            }
            let largest = ours.iter().map(|x| x.abs().to_f64()).fold(NOTHING, f64::max);
            for (a, b) in ours.iter().zip(&theirs) {
                let off = (*a - *b).abs().to_f64() / largest;
                assert!(off < 1e-3, "{} at {inputs:?}: {a} and {b}", textbook.probe);
                compared += 1;
                close += usize::from(off < 1e-13);
            }
        }
        println!("{}: {close} of {compared} to thirteen digits", textbook.probe);
        assert!(compared > 50 && 20 * close > 19 * compared, "{}: {close} of {compared}", textbook.probe);
    }
}

/// What is recorded holds on a smaller sample, which cannot find more: ours is never worse than recorded, and the textbook's form is worse than ours.
#[test]
fn gains_are_what_is_recorded() {
    let recorded = Catalogue::load().unwrap().gains.gains;
    assert_eq!(recorded.len(), textbooks().len());
    for (found, recorded) in Gains::now(SAMPLES).gains.iter().zip(&recorded) {
        println!("{}: f32 {:?}; f64 {:?}", found.probe, found.f32, found.f64);
        assert_eq!((&found.probe, &found.formula), (&recorded.probe, &recorded.formula));
        let operations = (found.textbook_operations, found.operations);
        assert_eq!(operations, (recorded.textbook_operations, recorded.operations), "{}", found.probe);
        assert!(found.operations > 0 && found.textbook_operations > 0, "{}", found.probe);
        for (found, recorded) in [(&found.f32, &recorded.f32), (&found.f64, &recorded.f64)] {
            assert!(found.ours <= recorded.ours && found.textbook <= recorded.textbook, "{found:?} and {recorded:?}");
            assert!(found.inputs > 100 && found.ours_not_finite == 0, "{found:?}");
        }
        assert!(found.f32.gains() && recorded.f32.gains(), "{}: there is nothing gained in f32", found.probe);
    }
}

/// Everything that is recorded as proven is proven again, with as many boxes.
#[test]
fn recorded_ranges_are_proven() {
    let recorded = Catalogue::load().unwrap().ranges;
    let now = Ranges::now();
    assert_eq!(recorded, now, "write the record anew with `etalon audit --record`");
    let all = recorded.ranges.len();
    println!("{} of {all} results have a finite range", recorded.finite());
    assert!(2 * recorded.finite() > all, "only {} of {all}", recorded.finite());
    for range in &recorded.ranges {
        assert_eq!(range.gap.is_none(), range.is_finite(), "{} {}", range.probe, range.output);
        assert!(range.low.is_none_or(|low| low <= range.seen[0]), "{} {}", range.probe, range.output);
        assert!(range.high.is_none_or(|high| high >= range.seen[1]), "{} {}", range.probe, range.output);
    }
}

/// No box holds arguments that belong together, so nothing is claimed of them.
#[test]
fn nothing_is_proven_of_arguments_that_belong_together() {
    for probe in probes().iter().filter(|probe| probe.arranged.is_some()) {
        assert!(enclose(probe, 1).iter().all(|of| of.bounds == Interval::ALL && of.gap.is_some()), "{probe}");
    }
}

#[test]
fn every_form_says_who_writes_it_and_what_goes_wrong() {
    for Textbook { probe, formula, source, trouble, .. } in textbooks() {
        assert!(!formula.is_empty() && source.len() > 10 && trouble.contains("; the code"), "{probe}");
    }
}
