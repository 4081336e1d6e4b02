//! How far a simulation is from a reference: means over the particles in a range.
//!
//! Each norm takes the measured values, the reference at the same particles, the coordinate that decides which particles
//! count (x, or a radius), and the closed range of that coordinate. All three lists are in the same order.

use crate::sum::CompensatedSum;
use etalon_kernels_gen::equation;
use num_traits::Float;

/// A list that a norm was given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum List {
    /// What the simulation has.
    Measured,
    /// What it should have.
    Reference,
    /// Where the particles are.
    Coordinates,
}

impl std::fmt::Display for List {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            List::Measured => "measured values",
            List::Reference => "reference values",
            List::Coordinates => "coordinates",
        })
    }
}

/// Why there is no norm.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum NormError {
    /// The lists belong to different particles.
    #[error("there are {measured} measured values but {other} {list}: give one for each particle")]
    Lengths {
        /// How many measured values.
        measured: usize,
        /// The list that differs.
        list: List,
        /// Its length.
        other: usize,
    },
    /// NaN or infinite.
    #[error("entry {index} of the {list} is {value}: give finite numbers, a diverged run has no error norm")]
    NotFinite {
        /// In which list.
        list: List,
        /// Where in it, counted from 0.
        index: usize,
        /// What stands there.
        value: f64,
    },
    /// Not an interval.
    #[error("the range from {from} to {to} is empty or not a number: give the lower bound first")]
    Range {
        /// Its lower bound.
        from: f64,
        /// Its upper bound.
        to: f64,
    },
    /// A mean over nothing.
    #[error("none of the {particles} particles lies between {from} and {to}: widen the range")]
    NoParticles {
        /// How many there are in all.
        particles: usize,
        /// Lower bound of the range.
        from: f64,
        /// Upper bound of the range.
        to: f64,
    },
    /// The norm does not fit the number type.
    #[error("the difference to the reference overflows the number type: rescale the values or use more digits")]
    Overflow,
}

/// $L_1 = \frac{1}{N_S}\sum_{i\in S}|p_i - p_i^{ref}|$, $S = \{i: d_0 \le d_i \le d_f\}$.
///
/// The mean is over particles, hence weighted by mass if they have equal masses, not by length; it is absolute, in the
/// units of p, not divided by the reference.
///
/// # Errors
/// Lists of different lengths, an entry that is not finite, a range that is none, no particle in it.
#[equation("gs25:20", host)]
pub fn l1_error<F: Float>(p: &[F], p_ref: &[F], d: &[F], range: (F, F)) -> Result<F, NormError> {
    let differences = differences(p, p_ref, d, range)?;
    finite(mean(differences.iter().copied()))
}

/// The root of the mean square difference over the same particles as in [`l1_error`], with the same errors.
pub fn l2_error<F: Float>(p: &[F], p_ref: &[F], d: &[F], range: (F, F)) -> Result<F, NormError> {
    let differences = differences(p, p_ref, d, range)?;
    let largest = largest(&differences);
    if largest.is_zero() {
        return Ok(largest);
    }
    // Relative to the largest, so that no square over- or underflows.
    finite(largest * mean(differences.iter().map(|&x| (x / largest) * (x / largest))).sqrt())
}

/// The largest difference over the same particles as in [`l1_error`], with the same errors.
pub fn max_error<F: Float>(p: &[F], p_ref: &[F], d: &[F], range: (F, F)) -> Result<F, NormError> {
    finite(largest(&differences(p, p_ref, d, range)?))
}

/// |p - p_ref| of the particles in the range; never empty.
fn differences<F: Float>(p: &[F], p_ref: &[F], d: &[F], range: (F, F)) -> Result<Vec<F>, NormError> {
    for (list, entries) in [(List::Reference, p_ref), (List::Coordinates, d)] {
        if entries.len() != p.len() {
            return Err(NormError::Lengths { measured: p.len(), list, other: entries.len() });
        }
    }
    for (list, entries) in [(List::Measured, p), (List::Reference, p_ref), (List::Coordinates, d)] {
        if let Some(index) = entries.iter().position(|entry| !entry.is_finite()) {
            return Err(NormError::NotFinite { list, index, value: printable(entries[index]) });
        }
    }
    let (d_0, d_f) = range;
    let (from, to) = (printable(d_0), printable(d_f));
    // Infinite bounds are fine, NaN is not.
    if d_0.is_nan() || d_f.is_nan() || d_0 > d_f {
        return Err(NormError::Range { from, to });
    }
    let chosen: Vec<F> =
        (0..p.len()).filter(|&i| d_0 <= d[i] && d[i] <= d_f).map(|i| (p[i] - p_ref[i]).abs()).collect();
    if chosen.is_empty() {
        return Err(NormError::NoParticles { particles: p.len(), from, to });
    }
    Ok(chosen)
}

/// Mean of numbers, by a compensated sum.
pub(crate) fn mean<F: Float>(values: impl ExactSizeIterator<Item = F>) -> F {
    let number = F::from(values.len());
    let (mut sum, mut count) = (CompensatedSum::new(), F::zero());
    for value in values {
        sum.add(value);
        count = count + F::one();
    }
    sum.value() / number.unwrap_or(count)
}

fn largest<F: Float>(values: &[F]) -> F {
    values.iter().copied().fold(F::zero(), F::max)
}

fn finite<F: Float>(value: F) -> Result<F, NormError> {
    if value.is_finite() { Ok(value) } else { Err(NormError::Overflow) }
}

fn printable<F: Float>(value: F) -> f64 {
    value.to_f64().unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::*;

    const P: [f64; 5] = [1.0, 2.0, 3.0, 4.0, 100.0];
    const REFERENCE: [f64; 5] = [1.5, 2.0, 1.0, 4.5, 0.0];
    const D: [f64; 5] = [0.1, 0.2, 0.3, 0.4, 0.9];

    #[test]
    fn norms_of_a_short_list_are_exact() {
        // Differences in the range: 1/2, 0, 2, 1/2: sum 3, squares 4.5.
        assert_eq!(l1_error(&P, &REFERENCE, &D, (0.1, 0.4)), Ok(0.75));
        assert_eq!(l2_error(&P, &REFERENCE, &D, (0.1, 0.4)), Ok((4.5_f64 / 4.0).sqrt()));
        assert_eq!(max_error(&P, &REFERENCE, &D, (0.1, 0.4)), Ok(2.0));
    }

    #[test]
    fn the_ledger_knows_the_norm_as_encoded() {
        let registered = etalon_kernels_gen::registered();
        let entry = registered.iter().find(|entry| entry.ids == ["gs25:20"]).expect("registered");
        assert_eq!(entry.name, "l1_error");
        assert!(entry.source.contains("mean(differences"), "{}", entry.source);
    }

    #[test]
    fn both_ends_of_the_range_count_and_nothing_outside_does() {
        assert_eq!(l1_error(&P, &REFERENCE, &D, (0.3, 0.4)), Ok(1.25));
        assert_eq!(l1_error(&P, &REFERENCE, &D, (0.3, 0.3)), Ok(2.0));
        assert_eq!(l1_error(&P, &REFERENCE, &D, (0.11, 0.39)), Ok(1.0));
        assert_eq!(max_error(&P, &REFERENCE, &D, (0.0, f64::INFINITY)), Ok(100.0));
    }

    #[test]
    fn norms_are_absolute_and_symmetric() {
        let all = (f64::NEG_INFINITY, f64::INFINITY);
        let there = l1_error(&P, &REFERENCE, &D, all).unwrap();
        assert_eq!(l1_error(&REFERENCE, &P, &D, all), Ok(there));
        let negative = |list: &[f64]| list.iter().map(|x| -4.0 * x).collect::<Vec<_>>();
        assert_eq!(l1_error(&negative(&P), &negative(&REFERENCE), &D, all), Ok(4.0 * there));
        assert_eq!(l2_error(&P, &P, &D, all), Ok(0.0));
        assert_eq!(max_error(&P, &P, &D, all), Ok(0.0));
    }

    #[test]
    fn squares_neither_overflow_nor_underflow() {
        for size in [1e-30_f32, 1e30] {
            let error = l2_error(&[3.0 * size, 4.0 * size], &[0.0; 2], &[0.0; 2], (0.0, 0.0)).unwrap();
            let (off, tolerance) = ((error / size - 12.5_f32.sqrt()).abs(), 8.0 * f32::EPSILON);
            assert!(off <= tolerance, "{error:e}: off by {off:e}, tolerance {tolerance:e}");
        }
    }

    #[test]
    fn a_million_particles_in_single_precision_keep_their_digits() {
        // Plain summation is off by about 1e-3 here; Kahan's by two epsilon, and the division by half of one.
        let values = vec![0.1_f32; 1_000_000];
        let zeros = vec![0.0_f32; 1_000_000];
        let error = l1_error(&values, &zeros, &zeros, (0.0, 0.0)).unwrap();
        let (off, tolerance) = ((error - 0.1).abs(), 2.5 * f32::EPSILON * 0.1);
        assert!(off <= tolerance, "off by {off:e}, tolerance {tolerance:e}");
        let plain = values.iter().sum::<f32>() / 1e6;
        assert!((plain - 0.1).abs() > 100.0 * f32::EPSILON * 0.1, "this test would not notice a plain sum: {plain:e}");
    }

    #[test]
    fn every_refusal_names_the_fault() {
        let message = |result: Result<f64, NormError>| result.expect_err("this must be refused").to_string();
        assert_eq!(
            message(l1_error(&P, &REFERENCE[..4], &D, (0.0, 1.0))),
            "there are 5 measured values but 4 reference values: give one for each particle"
        );
        assert_eq!(
            message(l2_error(&P, &REFERENCE, &D[..3], (0.0, 1.0))),
            "there are 5 measured values but 3 coordinates: give one for each particle"
        );
        let mut broken = P;
        broken[4] = f64::NAN;
        assert_eq!(
            message(max_error(&broken, &REFERENCE, &D, (0.0, 0.5))),
            "entry 4 of the measured values is NaN: give finite numbers, a diverged run has no error norm"
        );
        broken[2] = f64::INFINITY;
        assert_eq!(
            message(l1_error(&P, &broken, &D, (0.0, 0.5))),
            "entry 2 of the reference values is inf: give finite numbers, a diverged run has no error norm"
        );
        assert_eq!(
            l1_error(&P, &REFERENCE, &broken, (0.0, 0.5)),
            Err(NormError::NotFinite { list: List::Coordinates, index: 2, value: f64::INFINITY })
        );
        assert_eq!(
            message(l1_error(&P, &REFERENCE, &D, (0.5, 0.8))),
            "none of the 5 particles lies between 0.5 and 0.8: widen the range"
        );
        assert_eq!(
            message(l1_error(&P, &REFERENCE, &D, (0.8, 0.5))),
            "the range from 0.8 to 0.5 is empty or not a number: give the lower bound first"
        );
        assert!(matches!(l1_error(&P, &REFERENCE, &D, (f64::NAN, 0.5)), Err(NormError::Range { .. })));
        assert!(matches!(l1_error(&[], &[], &[], (0.0, 0.5)), Err(NormError::NoParticles { particles: 0, .. })));
        assert_eq!(max_error(&[f64::MAX], &[-f64::MAX], &[0.0], (0.0, 0.0)), Err(NormError::Overflow));
    }
}
