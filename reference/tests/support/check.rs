//! Comparing numbers, with error and tolerance always printed together.

/// The unit roundoff of `f64`.
pub const UNIT: f64 = f64::EPSILON / 2.0;

/// `n u / (1 - n u)`: the largest relative error that `n` roundings in a row can make (Higham 2002, lemma 3.1).
pub fn gamma(roundings: usize, unit: f64) -> f64 {
    let n = roundings as f64 * unit;
    n / (1.0 - n)
}

/// Fails, NaN included, unless `value` is within `tolerance` of `expected`; the message has both figures and the bits.
#[track_caller]
pub fn assert_close(what: &str, value: f64, expected: f64, tolerance: f64) {
    let error = (value - expected).abs();
    assert!(
        error <= tolerance,
        "{what}: {value:e} ({:#018x}) where {expected:e} ({:#018x}) is due; error {error:e}, tolerance {tolerance:e}",
        value.to_bits(),
        expected.to_bits(),
    );
}
