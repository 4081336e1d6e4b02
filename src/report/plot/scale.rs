//! An axis that is linear or goes by powers of ten, as wide as its values.

use super::super::number;
use super::axis::{padded, tick};

/// More decades than that have marks at powers of ten only.
const FEW: f64 = 2.5;
/// Marks of an axis, about.
const TICKS: f64 = 6.0;

/// How values are laid along an axis.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Scale {
    /// Evenly, from the one to the other.
    Linear(f64, f64),
    /// By their logarithm to the base of ten, from the one to the other.
    Logarithmic(f64, f64),
}

impl Scale {
    /// One that holds these values and a little more; what is not above zero has no place on a logarithmic one.
    pub(super) fn around(logarithmic: bool, values: impl Iterator<Item = f64>) -> Self {
        if logarithmic {
            let range = padded(values.filter(|value| *value > 0.0).map(f64::log10));
            Scale::Logarithmic(range.start, range.end)
        } else {
            let range = padded(values);
            Scale::Linear(range.start, range.end)
        }
    }

    /// Where a value lies between two pixels.
    pub(super) fn map(&self, value: f64, (from, to): (i32, i32)) -> i32 {
        let part = match *self {
            Scale::Linear(low, high) => (value - low) / (high - low),
            Scale::Logarithmic(low, high) if value > 0.0 => (value.log10() - low) / (high - low),
            Scale::Logarithmic(..) => 0.0,
        };
        (f64::from(from) + part.clamp(0.0, 1.0) * f64::from(to - from)).round() as i32
    }

    /// Values with a mark, and what stands beside it.
    pub(super) fn ticks(&self) -> Vec<(f64, String)> {
        match *self {
            Scale::Linear(low, high) => {
                let step = round_step((high - low) / TICKS);
                let range = (low / step).ceil() as i64..=(high / step).floor() as i64;
                range.map(|k| k as f64 * step).map(|value| (value, tick(value))).collect()
            }
            Scale::Logarithmic(low, high) => {
                let digits: &[i32] = if high - low < FEW { &[1, 2, 5] } else { &[1] };
                let every = ((high - low) / TICKS).ceil().max(1.0) as i32;
                let powers = (low.floor() as i32..=high.floor() as i32).filter(|power| power.rem_euclid(every) == 0);
                let value = |power: i32, digit: i32| f64::from(digit) * 10_f64.powi(power);
                let all = powers.flat_map(|power| digits.iter().map(move |&digit| (power, digit)));
                let inside = all.filter(|&(power, digit)| (low..=high).contains(&value(power, digit).log10()));
                inside.map(|(power, digit)| (value(power, digit), label(power, digit))).collect()
            }
        }
    }
}

/// 1, 2 or 5 times a power of ten, the nearest above.
fn round_step(least: f64) -> f64 {
    let power = 10_f64.powf(least.log10().floor());
    [1.0, 2.0, 5.0, 10.0].into_iter().map(|digit| digit * power).find(|step| *step >= least).unwrap_or(10.0 * power)
}

fn label(power: i32, digit: i32) -> String {
    match (power, digit) {
        (-2..=3, _) => tick(f64::from(digit) * 10_f64.powi(power)),
        (_, 1) => number::power_of_ten(power),
        _ => format!("{digit}·{}", number::power_of_ten(power)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(scale: &Scale) -> Vec<String> {
        scale.ticks().into_iter().map(|(_, label)| label).collect()
    }

    #[test]
    fn marks_are_round_and_inside() {
        assert_eq!(labels(&Scale::Linear(-0.31, 0.33)), ["−0.2", "0", "0.2"]);
        assert_eq!(labels(&Scale::around(true, [1.2, 31.0].into_iter())), ["2", "5", "10", "20"]);
        assert_eq!(labels(&Scale::around(true, [2e-6, 0.3].into_iter())), ["10⁻⁵", "10⁻⁴", "10⁻³", "0.01", "0.1"]);
        assert_eq!(labels(&Scale::around(true, [4e-4, 3e-3].into_iter())), ["5·10⁻⁴", "10⁻³", "2·10⁻³"]);
        assert_eq!(Scale::around(true, [1.0, 1e40].into_iter()).ticks().len(), 6);
    }

    #[test]
    fn ends_and_what_has_no_place() {
        let scale = Scale::Logarithmic(0.0, 2.0);
        assert_eq!([1.0, 10.0, 100.0, 1e9, 0.0].map(|value| scale.map(value, (0, 200))), [0, 100, 200, 200, 0]);
        let scale = Scale::Linear(-1.0, 1.0);
        assert_eq!([-1.0, 0.0, 1.0, 5.0].map(|value| scale.map(value, (300, 100))), [300, 200, 100, 100]);
        // Nothing, or one value, still has an axis.
        assert!(!Scale::around(true, [0.0].into_iter()).ticks().is_empty());
        assert!(!Scale::around(false, [3.0].into_iter()).ticks().is_empty());
    }
}
