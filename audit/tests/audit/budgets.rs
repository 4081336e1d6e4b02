//! Every probe on every target is within the budget that follows from its operations, and no worse than recorded.

use etalon_audit::{Budgets, Target, measure_targets, probes};

/// A hundredth of a full measurement, beside all hard inputs.
const SAMPLES: usize = 1000;

#[test]
fn no_equation_is_further_from_the_truth_than_recorded() {
    let budgets = Budgets::recorded().unwrap();
    let mut regressions = budgets.left_over();
    let mut measured = 0;
    for probe in probes() {
        for measurement in measure_targets(probe, &Target::HERE, SAMPLES) {
            let target = measurement.target;
            println!(
                "{probe} on {target}: {:.2} ulps, {:.1e} of the result; budget {:.2}; share {:.2}; unbounded {}/{}",
                measurement.of_scale.ulps,
                measurement.of_result.ulps,
                measurement.budget,
                measurement.largest_share,
                measurement.unbounded,
                measurement.inputs
            );
            measured += measurement.inputs;
            regressions.extend(budgets.compare(&measurement));
        }
    }
    let list: Vec<String> = regressions.iter().map(ToString::to_string).collect();
    assert!(list.is_empty(), "{} regressions:\n{}", list.len(), list.join("\n"));
    assert!(measured > 400 * SAMPLES, "only {measured} inputs");
}
