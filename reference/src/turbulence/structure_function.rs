//! The velocity structure function and the Mach number of a scale: C25 (32), (33); and the Mach number of the whole flow.

use super::bins::Bins;
use super::error::{TurbulenceError, check_column, check_length};
use super::snapshot::Snapshot;
use crate::equations::turbulence::{scale_mach_number, squared_mach_number, squared_velocity_difference};
use crate::schemes::MachReading;
use crate::sum::CompensatedSum;
use etalon_kernels_gen::equation;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// Which pairs are looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PairChoice {
    /// Each pair once: `N (N - 1) / 2` of them.
    All,
    /// So many pairs of different particles, drawn at random with replacement.
    Random {
        /// How many.
        count: usize,
        /// Which draw.
        seed: u64,
    },
}

/// Velocity differences at one scale.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// The mean distance of the pairs.
    pub distance: f64,
    /// The mean of `|v_b - v_a|^2` over them, `S_2`.
    pub structure_function: f64,
    /// How many pairs there are.
    pub pairs: u64,
}

/// `S_2(l) = <|v(x + l) - v(x)|^2>` by distance, over pairs of particles (C25 32). Bins without a pair are left out.
///
/// Distances are those of the nearest images. A pair has the weight `m_a m_b`: for equal masses it is the plain mean over pairs of the
/// paper, for others still the mean over mass.
///
/// # Errors
/// Fewer than two particles, bins that begin below zero or end beyond half a periodic side (farther away a nearest image hides others), no pair
/// in any bin.
#[equation("c25:32", host)]
pub fn structure_function<const D: usize>(
    snapshot: &Snapshot<D>,
    bins: &Bins,
    pairs: PairChoice,
) -> Result<Vec<Scale>, TurbulenceError> {
    let n = snapshot.len();
    if n < 2 {
        return Err(TurbulenceError::Empty { what: "pairs of particles", least: 1 });
    }
    let (from, to) = bins.range();
    let half_a_side = half_a_side(snapshot);
    if from < 0.0 {
        return Err(TurbulenceError::Parameter {
            name: "smallest distance",
            value: from,
            rule: "give none below zero",
        });
    }
    if to > half_a_side {
        let rule = "nearest images reach half a side of the box: end the bins there";
        return Err(TurbulenceError::Parameter { name: "largest distance", value: to, rule });
    }
    let mut sums = vec![Sums::default(); bins.count()];
    let mut looked_at = 0;
    let mut look = |a: usize, b: usize| {
        looked_at += 1;
        let distance = snapshot.distance(a, b);
        if let Some(bin) = bins.of(distance) {
            let difference = squared_velocity_difference(snapshot.velocity(a) - snapshot.velocity(b));
            sums[bin].add(snapshot.mass()[a] * snapshot.mass()[b], distance, difference);
        }
    };
    match pairs {
        PairChoice::All => (0..n).for_each(|a| (0..a).for_each(|b| look(a, b))),
        PairChoice::Random { count, seed } => {
            let mut random = Pcg64Mcg::seed_from_u64(seed);
            for _ in 0..count {
                let a = random.random_range(0..n);
                // One of the others.
                let b = (a + random.random_range(1..n)) % n;
                look(a, b);
            }
        }
    }
    let scales: Vec<Scale> = sums.iter().filter_map(Sums::mean).collect();
    if scales.is_empty() {
        return Err(TurbulenceError::NothingInRange { entries: looked_at, what: "pairs", from, to });
    }
    Ok(scales)
}

/// The Mach number of each scale, `M(l) = sqrt(S_2 / 2) / c` or without the half (C25 33), in the order of the scales.
///
/// # Errors
/// A sound speed that is not positive.
#[equation("c25:33", host)]
pub fn mach_numbers(scales: &[Scale], sound_speed: f64, reading: MachReading) -> Result<Vec<f64>, TurbulenceError> {
    if !(sound_speed.is_finite() && sound_speed > 0.0) {
        let rule = "it must be finite and positive";
        return Err(TurbulenceError::Parameter { name: "sound speed", value: sound_speed, rule });
    }
    Ok(scales.iter().map(|scale| scale_mach_number(scale.structure_function, sound_speed, reading)).collect())
}

/// The root-mean-square Mach number `sqrt(<v^2 / c^2>)`, each particle with its own sound speed and weighted with its mass.
///
/// # Errors
/// A sound speed that is not positive, or not one for each particle.
#[equation(unnumbered = "Mach number of the whole flow, C25 section 2, GS25 section 4", host)]
pub fn rms_mach_number<const D: usize>(snapshot: &Snapshot<D>, sound_speed: &[f64]) -> Result<f64, TurbulenceError> {
    check_length("list of sound speeds", sound_speed.len(), snapshot.len())?;
    check_column("sound speeds", sound_speed, true)?;
    let (mut sum, mut mass) = (CompensatedSum::new(), CompensatedSum::new());
    for (particle, (&m, &c)) in snapshot.mass().iter().zip(sound_speed).enumerate() {
        sum.add(m * squared_mach_number(snapshot.velocity(particle), c));
        mass.add(m);
    }
    Ok((sum.value() / mass.value()).sqrt())
}

/// Half of the shortest periodic side; without limit in an open box.
fn half_a_side<const D: usize>(snapshot: &Snapshot<D>) -> f64 {
    let (length, periodic) = (snapshot.domain().torus_length(), snapshot.domain().periodic());
    (0..D).filter(|&axis| periodic[axis]).map(|axis| 0.5 * length[axis]).fold(f64::INFINITY, f64::min)
}

#[derive(Clone, Copy, Debug, Default)]
struct Sums {
    weight: CompensatedSum<f64>,
    distance: CompensatedSum<f64>,
    difference: CompensatedSum<f64>,
    pairs: u64,
}

impl Sums {
    fn add(&mut self, weight: f64, distance: f64, difference: f64) {
        self.weight.add(weight);
        self.distance.add(weight * distance);
        self.difference.add(weight * difference);
        self.pairs += 1;
    }

    fn mean(&self) -> Option<Scale> {
        let per_weight = |sum: CompensatedSum<f64>| sum.value() / self.weight.value();
        (self.pairs > 0).then(|| Scale {
            distance: per_weight(self.distance),
            structure_function: per_weight(self.difference),
            pairs: self.pairs,
        })
    }
}
