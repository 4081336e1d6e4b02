//! The inputs on which a probe is measured: hard ones first, then random ones from the domains.
//!
//! The stream of a probe is always the same, and a shorter sample is the beginning of a longer one. So a small sample cannot find
//! a larger error than a large one did, unless something has changed.

use crate::probe::Probe;
use rand::{Rng, RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use rayon::prelude::*;

/// Hard values are combined systematically up to this number of inputs.
const MOST_COMBINATIONS: usize = 4096;
/// Random inputs are drawn in blocks of this size, each from a generator of its own, so that blocks can be drawn at once.
pub const BLOCK: usize = 1024;
/// In one of so many random inputs each argument is a hard value with even odds.
const HARD_EVERY: usize = 8;

/// All combinations of hard values, or as many evenly spread ones as are allowed, arranged into legal inputs.
#[must_use]
pub fn hard_inputs(probe: &Probe) -> Vec<Vec<f64>> {
    let choices: Vec<Vec<f64>> = probe.input_domains().iter().map(|domain| domain.hard()).collect();
    let total = choices.iter().fold(1_usize, |product, values| product.saturating_mul(values.len()));
    if total <= MOST_COMBINATIONS {
        return (0..total).map(|index| arranged(probe, combination(&choices, index))).collect();
    }
    // Too many: random ones, which do not favour the first arguments.
    let mut random = generator(probe, u64::MAX);
    let pick =
        |random: &mut Pcg64Mcg| choices.iter().map(|values| values[random.random_range(0..values.len())]).collect();
    (0..MOST_COMBINATIONS).map(|_| arranged(probe, pick(&mut random))).collect()
}

/// A block of random inputs, arranged into legal ones.
#[must_use]
pub fn random_inputs(probe: &Probe, block: usize) -> Vec<Vec<f64>> {
    let domains = probe.input_domains();
    let hard: Vec<Vec<f64>> = domains.iter().map(|domain| domain.hard()).collect();
    let mut random = generator(probe, block as u64);
    let draw = |index: usize, random: &mut Pcg64Mcg| {
        let is_hard = index.is_multiple_of(HARD_EVERY);
        let values = domains.iter().zip(&hard).map(|(domain, hard)| match is_hard && random.random() {
            true => hard[random.random_range(0..hard.len())],
            false => domain.at(random.random()),
        });
        arranged(probe, values.collect())
    };
    (0..BLOCK).map(|index| draw(index, &mut random)).collect()
}

fn arranged(probe: &Probe, mut inputs: Vec<f64>) -> Vec<f64> {
    probe.arrange(&mut inputs);
    inputs
}

fn combination(choices: &[Vec<f64>], mut index: usize) -> Vec<f64> {
    let digit = |values: &Vec<f64>| {
        let value = values[index % values.len()];
        index /= values.len();
        value
    };
    choices.iter().map(digit).collect()
}

/// The generator of a block: a function of the probe's name and the block, and of nothing else.
fn generator(probe: &Probe, block: u64) -> Pcg64Mcg {
    let mut random = Pcg64Mcg::seed_from_u64(hash(&probe.key()) ^ block.wrapping_mul(0x9e37_79b9_7f4a_7c15));
    random.next_u64();
    random
}

/// Fowler, Noll and Vo's hash, which is the same everywhere and for ever.
pub(crate) fn hash(text: &str) -> u64 {
    text.bytes()
        .fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3))
}

/// All inputs of a measurement: the hard ones, then at least so many random ones.
#[must_use]
pub fn all_inputs(probe: &Probe, samples: usize) -> Vec<Vec<f64>> {
    let mut inputs = hard_inputs(probe);
    let random = (0..samples.div_ceil(BLOCK)).into_par_iter().map(|block| random_inputs(probe, block));
    inputs.extend(random.collect::<Vec<_>>().into_iter().flatten());
    inputs
}
