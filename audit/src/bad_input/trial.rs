//! Legal inputs with one bad value in them.

use super::is_bad;
use crate::probe::Probe;
use crate::sample::{hard_inputs, random_inputs};
use crate::target::Target;
use etalon_spec::BadValue;

/// Legal inputs that bad values are put into: hard ones, and as many random ones.
const CONTEXTS: usize = 24;
/// Other legal values tried to see whether an argument matters, beside the hard ones.
const OTHERS: usize = 8;

/// Inputs with a bad value in them.
#[derive(Clone, Debug, PartialEq)]
pub struct Trial {
    /// Which argument has it.
    pub argument: usize,
    /// Of which class it is.
    pub value: BadValue,
    /// All inputs.
    pub inputs: Vec<f64>,
    /// Whether the argument matters here: some other legal value of it would change a result.
    pub matters: bool,
}

/// All trials of a probe: NaN and infinities in each component by itself, zero and wrong signs in all components of an argument at once,
/// where they are not legal.
#[must_use]
pub fn trials(probe: &Probe) -> Vec<Trial> {
    let hard = hard_inputs(probe);
    let every = hard.len().div_ceil(CONTEXTS).max(1);
    let random = random_inputs(probe, 0);
    let contexts: Vec<&Vec<f64>> = hard.iter().step_by(every).chain(random.iter().take(CONTEXTS)).collect();
    let mut trials = Vec::new();
    for inputs in contexts {
        let mut start = 0;
        for (argument, declared) in probe.arguments.iter().enumerate() {
            let components = start..start + declared.quantity.suffixes.len();
            start = components.end;
            let is_bad = |value| is_bad(value, &declared.domain, probe.arranged.is_some());
            let mut add = |value, places: &[usize], bad: &dyn Fn(f64) -> f64, matters| {
                let mut inputs = inputs.clone();
                places.iter().for_each(|&place| inputs[place] = bad(inputs[place]));
                trials.push(Trial { argument, value, inputs, matters });
            };
            let mut any_matters = false;
            for place in components.clone() {
                let matters = matters(probe, inputs, place);
                any_matters |= matters;
                add(BadValue::Nan, &[place], &|_| f64::NAN, matters);
                add(BadValue::Infinite, &[place], &|_| f64::INFINITY, matters);
                add(BadValue::Infinite, &[place], &|_| f64::NEG_INFINITY, matters);
            }
            let places: Vec<usize> = components.collect();
            if is_bad(BadValue::Zero) {
                add(BadValue::Zero, &places, &|_| 0.0, any_matters);
            }
            if is_bad(BadValue::Negative) {
                let high = declared.domain.high();
                add(BadValue::Negative, &places, &|x| if x > 0.0 { -x } else { -high }, any_matters);
            }
        }
    }
    trials
}

/// Whether another legal value in this place changes a result.
fn matters(probe: &Probe, inputs: &[f64], place: usize) -> bool {
    let as_it_is = Target::ScalarDouble.run(probe, inputs);
    let domain = probe.input_domains()[place];
    let others = domain.hard().into_iter().chain((0..OTHERS).map(|k| domain.at((k as f64 + 0.5) / OTHERS as f64)));
    others.into_iter().any(|other| {
        let mut changed = inputs.to_vec();
        changed[place] = other;
        let bits = |values: &[f64]| values.iter().map(|value| value.to_bits()).collect::<Vec<_>>();
        bits(&Target::ScalarDouble.run(probe, &changed)) != bits(&as_it_is)
    })
}
