//! Measuring a probe on a target against the oracle.

use crate::device::{Device, DeviceError, call, text_mark};
use crate::probe::Probe;
use crate::quad::Quad;
use crate::sample::{BLOCK, all_inputs};
use crate::target::Target;
use etalon_kernels_gen::Precision;
use rayon::prelude::*;

/// Second-order terms of some hundred roundings, relative to the first-order bound.
const SECOND_ORDER: f64 = 1.001;

/// The largest error of a kind, and where it is.
#[derive(Clone, Debug, PartialEq)]
pub struct Worst {
    /// The error, in units in the last place.
    pub ulps: f64,
    /// The output's name.
    pub output: String,
    /// The inputs, exact in the target's precision.
    pub inputs: Vec<f64>,
}

/// A result that is outside of its budget, or not finite.
#[derive(Clone, Debug, PartialEq)]
pub struct Violation {
    /// The output's name.
    pub output: String,
    /// The inputs.
    pub inputs: Vec<f64>,
    /// What the target computed.
    pub found: f64,
    /// What the oracle did, to the digits of an `f64`.
    pub expected: f64,
    /// The error allowed for this input.
    pub allowed: f64,
}

/// What came of measuring a probe on a target.
#[derive(Clone, Debug, PartialEq)]
pub struct Measurement {
    /// The probe's key.
    pub probe: String,
    /// The target.
    pub target: Target,
    /// The device that ran it, and the mark of the text it ran; only of what a device ran.
    pub device: Option<RunBy>,
    /// How many inputs were tried, hard ones included.
    pub inputs: usize,
    /// The largest error in ulps of the true result. Of an equation that cancels it may be of any size.
    pub of_result: Worst,
    /// The largest error in ulps of the natural scale (see [`Gauge`](crate::gauge::Gauge)): this is what the budget is for.
    pub of_scale: Worst,
    /// The budget in ulps of the natural scale: the largest of the bounds that follow from the operations, input by input.
    pub budget: f64,
    /// The largest share of its own bound that an error took; above one there is a violation.
    pub largest_share: f64,
    /// For how many numbers there is no bound, because a divisor may be nothing.
    pub unbounded: usize,
    /// How many numbers were outside of their budget.
    pub violation_count: usize,
    /// The first few of them.
    pub violations: Vec<Violation>,
}

/// Who ran the text of an equation, and which text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RunBy {
    /// The device's name.
    pub adapter: String,
    /// The text's mark; see [`text_mark`].
    pub text: String,
}

/// Violations beyond these are counted, not kept.
const VIOLATIONS_KEPT: usize = 3;

/// Measures a probe on a target, on all its hard inputs and at least `samples` random ones. Uses all threads of rayon's pool.
#[must_use]
pub fn measure(probe: &Probe, target: Target, samples: usize) -> Measurement {
    let all = measure_targets(probe, &[target], samples).pop();
    all.unwrap_or_else(|| Measurement::nothing(probe, target)) // one target, one measurement
}

/// The same for several targets, which are measured on the same inputs against the same evaluation of the oracle if they have the
/// same precision. [`Target::WgslSingle`] needs a device and is passed over: see [`measure_on`].
#[must_use]
pub fn measure_targets(probe: &Probe, targets: &[Target], samples: usize) -> Vec<Measurement> {
    gathered(probe, targets, &all_inputs(probe, samples), None)
}

/// Measures a probe on all targets that run here, and on a device if there is one.
///
/// # Errors
/// [`DeviceError`] if the device did not run it.
pub fn measure_on(probe: &Probe, device: Option<&dyn Device>, samples: usize) -> Result<Vec<Measurement>, DeviceError> {
    let inputs = all_inputs(probe, samples);
    let Some(device) = device else { return Ok(gathered(probe, &Target::HERE, &inputs, None)) };
    let target = Target::WgslSingle;
    let rounded: Vec<Vec<f64>> = inputs.iter().map(|row| row.iter().map(|x| target.round(*x)).collect()).collect();
    let found = call(device, probe, &rounded)?;
    let mut measurements = gathered(probe, &Target::ALL, &inputs, Some(&found));
    let run_by = RunBy { adapter: device.name(), text: text_mark(probe).unwrap_or_default() };
    for measurement in measurements.iter_mut().filter(|measurement| measurement.target == target) {
        measurement.device = Some(run_by.clone());
    }
    Ok(measurements)
}

/// The measurements of all blocks of inputs, put together in their order.
fn gathered(
    probe: &Probe,
    targets: &[Target],
    inputs: &[Vec<f64>],
    of_device: Option<&[Vec<f64>]>,
) -> Vec<Measurement> {
    let block = |(number, inputs): (usize, &[Vec<f64>])| {
        let first = BLOCK * number;
        measure_block(probe, targets, inputs, of_device.map(|found| &found[first..first + inputs.len()]))
    };
    let nothing = targets.iter().map(|target| Measurement::nothing(probe, *target)).collect();
    let join =
        |all: Vec<Measurement>, more: Vec<Measurement>| all.into_iter().zip(more).map(|(a, b)| a.and(b)).collect();
    inputs.par_chunks(BLOCK).enumerate().map(block).collect::<Vec<_>>().into_iter().fold(nothing, join)
}

impl Measurement {
    fn nothing(probe: &Probe, target: Target) -> Self {
        let none = Worst { ulps: 0.0, output: String::new(), inputs: Vec::new() };
        Measurement {
            probe: probe.key(),
            target,
            device: None,
            inputs: 0,
            of_result: none.clone(),
            of_scale: none,
            budget: 0.0,
            largest_share: 0.0,
            unbounded: 0,
            violation_count: 0,
            violations: Vec::new(),
        }
    }

    /// Of these inputs and the others'. The first of equal errors stays, so the order of blocks matters and threads do not.
    fn and(mut self, other: Self) -> Self {
        self.inputs += other.inputs;
        self.unbounded += other.unbounded;
        self.violation_count += other.violation_count;
        self.budget = self.budget.max(other.budget);
        self.largest_share = self.largest_share.max(other.largest_share);
        if other.of_result.ulps > self.of_result.ulps {
            self.of_result = other.of_result;
        }
        if other.of_scale.ulps > self.of_scale.ulps {
            self.of_scale = other.of_scale;
        }
        let room = VIOLATIONS_KEPT - self.violations.len();
        self.violations.extend(other.violations.into_iter().take(room));
        self
    }

    fn violate(&mut self, violation: Violation) {
        self.violation_count += 1;
        if self.violations.len() < VIOLATIONS_KEPT {
            self.violations.push(violation);
        }
    }
}

/// Measures a probe on given inputs, one after the other: one measurement for each target.
#[must_use]
pub fn measure_inputs(probe: &Probe, targets: &[Target], inputs: &[Vec<f64>]) -> Vec<Measurement> {
    measure_block(probe, targets, inputs, None)
}

/// The same, with what a device found for each of the inputs.
fn measure_block(
    probe: &Probe,
    targets: &[Target],
    inputs: &[Vec<f64>],
    of_device: Option<&[Vec<f64>]>,
) -> Vec<Measurement> {
    let mut measurements: Vec<_> = targets.iter().map(|target| Measurement::nothing(probe, *target)).collect();
    let outputs = probe.output_names();
    for (place, raw) in inputs.iter().enumerate() {
        // What targets of one precision have in common.
        let mut known: Vec<(Precision, Truth)> = Vec::new();
        for measurement in &mut measurements {
            let target = measurement.target;
            let precision = target.precision();
            if !known.iter().any(|(of, _)| *of == precision) {
                known.push((precision, Truth::new(probe, target, raw)));
            }
            let Some((_, truth)) = known.iter().find(|(of, _)| *of == precision) else { continue };
            match (target, of_device) {
                (Target::WgslSingle, None) => {}
                (Target::WgslSingle, Some(found)) => {
                    let gauges = target.gauge(probe, &truth.inputs);
                    measurement.add(truth, &gauges, &found[place], &outputs);
                }
                _ => measurement.add(truth, &truth.gauges, &target.run(probe, &truth.inputs), &outputs),
            }
        }
    }
    measurements
}

/// What is to be compared with.
struct Truth {
    /// The inputs, rounded to the target's precision.
    inputs: Vec<f64>,
    /// The oracle's results.
    results: Vec<Quad>,
    /// Scale and bound of each result.
    gauges: Vec<(f64, f64)>,
}

impl Truth {
    fn new(probe: &Probe, target: Target, raw: &[f64]) -> Self {
        let inputs: Vec<f64> = raw.iter().map(|x| target.round(*x)).collect();
        let exact: Vec<Quad> = inputs.iter().map(|x| Quad::exact(*x)).collect();
        let results = probe.evaluate(&exact).unwrap_or_default(); // as many inputs as the probe has
        let gauges = target.gauge(probe, &inputs);
        Truth { inputs, results, gauges }
    }
}

impl Measurement {
    /// Takes in what the target found for one set of inputs; the gauges are the target's own.
    fn add(&mut self, truth: &Truth, gauges: &[(f64, f64)], found: &[f64], outputs: &[String]) {
        let target = self.target;
        self.inputs += 1;
        for (((output, result), &found), (scale, bound)) in outputs.iter().zip(&truth.results).zip(found).zip(gauges) {
            let expected = result.to_f64();
            let allowed = SECOND_ORDER * bound;
            let inputs = &truth.inputs;
            let violation = || Violation { output: output.clone(), inputs: inputs.clone(), found, expected, allowed };
            if !found.is_finite() || !result.is_finite() {
                self.violate(violation());
                continue;
            }
            let error = result.distance(found);
            let worse = |worst: &mut Worst, ulps: f64| {
                if ulps > worst.ulps {
                    *worst = Worst { ulps, output: output.clone(), inputs: inputs.clone() };
                }
            };
            // What cancels to nothing has no digits of its own.
            if expected != 0.0 {
                worse(&mut self.of_result, error / target.ulp(expected));
            }
            if !allowed.is_finite() {
                self.unbounded += 1;
                continue;
            }
            worse(&mut self.of_scale, error / target.ulp(*scale));
            self.budget = self.budget.max(bound / target.ulp(*scale));
            if error > 0.0 {
                self.largest_share = self.largest_share.max(error / allowed);
            }
            if error > allowed {
                self.violate(violation());
            }
        }
    }
}
