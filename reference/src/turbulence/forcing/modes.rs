//! The waves that are driven.

use crate::equations::turbulence::driving_amplitude;
use crate::schemes::{ModeWeights, Profile};
use etalon_kernels_gen::equation;

/// The wave number with the largest power (C25 section 2); the parabola ends one below and one above.
pub const PEAK: f64 = 2.0;

/// A driven wave: one of each pair of opposite wave vectors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mode<const D: usize> {
    /// Waves along each side of the box.
    pub wave_vector: [i32; D],
    /// Its amplitude, without weights.
    pub amplitude: f64,
    /// How often SPH-EXA's list has it: 1, twice for each component that is zero.
    pub multiplicity: u32,
}

/// All waves with `1 <= |n| <= 3`, of each pair of opposite ones that whose last component other than zero is positive.
///
/// SPH-EXA goes through `n_x, n_y, n_z >= 0` and adds the other signs of all components but the first. A component that is zero has no other sign,
/// but gets its entry: so waves along a face of the box stand there twice and those along an edge four times, each with amplitudes of its
/// own: 112 entries for 61 waves in 3-D.
#[equation(unnumbered = "the driven waves, C25 section 2", host)]
pub fn modes<const D: usize>(profile: Profile) -> Vec<Mode<D>> {
    let range = -3..=3;
    let all = (0..7_usize.pow(D as u32))
        .map(|i| std::array::from_fn(|axis| i as i32 / 7_i32.pow(axis as u32) % 7 + range.start()));
    let kept = |n: &[i32; D]| {
        let squared: i32 = n.iter().map(|n| n * n).sum();
        (1..=9).contains(&squared) && n.iter().rev().find(|n| **n != 0).is_some_and(|n| *n > 0)
    };
    all.filter(kept)
        .map(|wave_vector: [i32; D]| {
            let squared: i32 = wave_vector.iter().map(|n| n * n).sum();
            let amplitude = driving_amplitude::<f64, D>(f64::from(squared).sqrt(), PEAK, profile);
            let zeros = wave_vector.iter().filter(|n| **n == 0).count();
            Mode { wave_vector, amplitude, multiplicity: 1 << zeros }
        })
        .collect()
}

impl<const D: usize> Mode<D> {
    /// The amplitude squared with its weight; `share` is that of even weights.
    fn power(&self, weights: ModeWeights, share: f64) -> f64 {
        let weight = match weights {
            ModeWeights::Published => f64::from(self.multiplicity),
            ModeWeights::Even => share,
        };
        weight * self.amplitude * self.amplitude
    }
}

/// The modes that have an amplitude, with their weighted amplitudes. The sum of the squares is the same for both kinds of weights.
pub fn weighted<const D: usize>(profile: Profile, weights: ModeWeights) -> Vec<([i32; D], f64)> {
    let modes = modes::<D>(profile);
    let sum = |weights| modes.iter().map(|mode| mode.power(weights, 1.0)).sum::<f64>();
    let share = sum(ModeWeights::Published) / sum(ModeWeights::Even);
    let driven = modes.iter().filter(|mode| mode.amplitude > 0.0);
    driven.map(|mode| (mode.wave_vector, mode.power(weights, share).sqrt())).collect()
}
