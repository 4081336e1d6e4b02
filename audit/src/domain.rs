//! Which values an argument may have.

/// A range of values with how it is sampled, and the values in it that are hard.
#[derive(Clone, Debug, PartialEq)]
pub struct Domain {
    low: f64,
    high: f64,
    spread: Spread,
    hard: Vec<f64>,
}

/// How values are drawn from a range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spread {
    /// Every part of the range is as likely as another of its length.
    Linear,
    /// Every power of two is as likely as another; positive.
    Logarithmic,
    /// The same, of either sign.
    EitherSign,
}

/// Positive values between two bounds: masses, densities, lengths.
#[must_use]
pub fn positive(low: f64, high: f64) -> Domain {
    Domain::new(low, high, Spread::Logarithmic)
}

/// Positive values between two bounds, and zero: energies, sound speeds, distances.
#[must_use]
pub fn not_negative(low: f64, high: f64) -> Domain {
    positive(low, high).with(&[0.0])
}

/// Values whose size lies between two bounds, of either sign, and zero: velocities, rates, slopes.
#[must_use]
pub fn any(low: f64, high: f64) -> Domain {
    Domain::new(low, high, Spread::EitherSign).with(&[0.0])
}

/// Values between two bounds, evenly.
#[must_use]
pub fn between(low: f64, high: f64) -> Domain {
    Domain::new(low, high, Spread::Linear)
}

impl Domain {
    fn new(low: f64, high: f64, spread: Spread) -> Self {
        Domain { low, high, spread, hard: Vec::new() }
    }
    /// The same with further hard values: where the formula changes, cancels or divides.
    #[must_use]
    pub fn with(mut self, values: &[f64]) -> Self {
        self.hard.extend(values);
        self
    }
    /// The smallest size of a value (a linear domain's lower bound).
    pub fn low(&self) -> f64 {
        self.low
    }
    /// The largest size of a value.
    pub fn high(&self) -> f64 {
        self.high
    }
    /// How values are drawn.
    pub fn spread(&self) -> Spread {
        self.spread
    }
    /// The least and the greatest value, hard ones included: the side of a box that holds the domain.
    pub fn hull(&self) -> (f64, f64) {
        let least = if self.spread == Spread::EitherSign { -self.high } else { self.low };
        let all = || self.hard.iter().copied();
        (all().fold(least, f64::min), all().fold(self.high, f64::max))
    }
    /// The connected parts it is made of, by their ends: the range, its mirror image where either sign is meant, and single values beside them.
    pub fn parts(&self) -> Vec<(f64, f64)> {
        let mut parts = vec![(self.low, self.high)];
        if self.spread == Spread::EitherSign {
            parts.push((-self.high, -self.low));
        }
        for &value in &self.hard {
            if !parts.iter().any(|(low, high)| (*low..=*high).contains(&value)) {
                parts.push((value, value));
            }
        }
        parts
    }
    /// The value at a place of the range: `0 <= place < 1`.
    pub fn at(&self, place: f64) -> f64 {
        // Evenly in the bits of an f64, which is nearly evenly in the logarithm, and the same on every machine.
        let logarithmic = |place: f64| {
            let (low, high) = (self.low.to_bits(), self.high.to_bits());
            f64::from_bits(low + (place * (high - low) as f64) as u64)
        };
        match self.spread {
            Spread::Linear => self.low + place * (self.high - self.low),
            Spread::Logarithmic => logarithmic(place),
            Spread::EitherSign if place < 0.5 => -logarithmic(2.0 * place),
            Spread::EitherSign => logarithmic(2.0 * place - 1.0),
        }
    }
    /// Its hard values: the ends, one where it is inside, and those that were named.
    pub fn hard(&self) -> Vec<f64> {
        let mut values = vec![self.low, self.high];
        if self.low < 1.0 && 1.0 < self.high {
            values.push(1.0);
        }
        if self.spread == Spread::EitherSign {
            values.extend(values.clone().into_iter().map(|value| -value));
        }
        for &value in &self.hard {
            if !values.contains(&value) {
                values.push(value);
            }
        }
        values
    }
    /// What it contains, in words and numbers: `1e-3 .. 1e3, also 0`.
    #[must_use]
    pub fn describe(&self) -> String {
        let sign = if self.spread == Spread::EitherSign { "+- " } else { "" };
        let mut text = format!("{sign}{} .. {}", short(self.low), short(self.high));
        let (least, most) =
            if self.spread == Spread::EitherSign { (-self.high, self.high) } else { (self.low, self.high) };
        let within = |value: &f64| {
            *value >= least && *value <= most && (value.abs() >= self.low || self.spread == Spread::Linear)
        };
        let outside: Vec<String> = self.hard.iter().filter(|value| !within(value)).map(|value| short(*value)).collect();
        if !outside.is_empty() {
            text += &format!(", also {}", outside.join(", "));
        }
        text
    }
}

/// `0.5`, `1e-3`.
fn short(value: f64) -> String {
    let (plain, scientific) = (format!("{value}"), format!("{value:e}"));
    if plain.len() <= scientific.len() { plain } else { scientific }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_place_is_inside_and_the_ends_are_reached() {
        for domain in [positive(1e-3, 1e3), any(1e-2, 10.0), between(-1.0, 2.0)] {
            let (least, most) = domain.hull();
            let values: Vec<f64> = (0..1000).map(|k| domain.at(f64::from(k) / 1000.0)).collect();
            assert!(values.iter().all(|v| (least..=most).contains(v)), "{domain:?}");
            assert!(domain.hard().contains(&most), "{domain:?}");
        }
        assert_eq!(any(1e-2, 10.0).hull(), (-10.0, 10.0));
        assert_eq!(not_negative(1e-2, 10.0).hull(), (0.0, 10.0));
    }

    #[test]
    fn a_domain_is_made_of_its_parts() {
        assert_eq!(any(1e-2, 10.0).with(&[1.0]).parts(), [(1e-2, 10.0), (-10.0, -1e-2), (0.0, 0.0)]);
        assert_eq!(between(0.0, 4.0).with(&[1.0, 5.0]).parts(), [(0.0, 4.0), (5.0, 5.0)]);
        for domain in [any(1e-2, 10.0), not_negative(1e-3, 1.0), between(-1.0, 2.0).with(&[3.0])] {
            let inside = |value: f64| domain.parts().iter().any(|(low, high)| (*low..=*high).contains(&value));
            assert!(domain.hard().into_iter().all(inside) && (0..99).all(|k| inside(domain.at(f64::from(k) / 99.0))));
        }
    }

    #[test]
    fn a_domain_says_what_it_contains() {
        assert_eq!(not_negative(1e-3, 1e3).describe(), "1e-3 .. 1e3, also 0");
        assert_eq!(any(0.5, 2.0).describe(), "+- 0.5 .. 2, also 0");
        assert_eq!(between(0.0, 4.0).with(&[1.0]).describe(), "0 .. 4");
    }
}
