//! Intervals that values are sorted into.

use super::error::{TurbulenceError, check_column};

/// Intervals that follow one another, each with its lower end and without its upper one; the last has both.
#[derive(Clone, Debug, PartialEq)]
pub struct Bins {
    edges: Vec<f64>,
}

impl Bins {
    /// Bins between these edges.
    ///
    /// # Errors
    /// Fewer than two edges, one that is not finite, or edges that do not ascend.
    pub fn between(edges: Vec<f64>) -> Result<Self, TurbulenceError> {
        if edges.len() < 2 {
            return Err(TurbulenceError::Empty { what: "bins", least: 1 });
        }
        check_column("bin edges", &edges, false)?;
        match edges.windows(2).position(|pair| pair[0] >= pair[1]) {
            Some(at) => Err(TurbulenceError::Value {
                column: "bin edges",
                index: at + 1,
                value: edges[at + 1],
                rule: "edges must ascend",
            }),
            None => Ok(Bins { edges }),
        }
    }

    /// Bins of equal width.
    ///
    /// # Errors
    /// As [`Bins::between`].
    pub fn linear(from: f64, to: f64, count: usize) -> Result<Self, TurbulenceError> {
        Bins::between((0..=count).map(|i| ends(i, count, from, to, |t| from + (to - from) * t)).collect())
    }

    /// Bins of equal ratio.
    ///
    /// # Errors
    /// As [`Bins::between`], or a lower end that is not positive.
    pub fn logarithmic(from: f64, to: f64, count: usize) -> Result<Self, TurbulenceError> {
        check_column("bin edges", &[from], true)?;
        Bins::between((0..=count).map(|i| ends(i, count, from, to, |t| from * (to / from).powf(t))).collect())
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.edges.len() - 1
    }
    /// The ends of one.
    pub fn ends(&self, bin: usize) -> (f64, f64) {
        (self.edges[bin], self.edges[bin + 1])
    }
    /// The lowest and the highest edge.
    pub fn range(&self) -> (f64, f64) {
        (self.edges[0], self.edges[self.count()])
    }
    /// Which bin a value belongs to.
    pub fn of(&self, value: f64) -> Option<usize> {
        let (from, to) = self.range();
        if !(from..=to).contains(&value) {
            return None;
        }
        Some(self.edges.partition_point(|&edge| edge <= value).min(self.count()) - 1)
    }
}

/// Edge `i` of `count + 1`: the ends as they were given, so that no rounding moves them.
fn ends(i: usize, count: usize, from: f64, to: f64, between: impl Fn(f64) -> f64) -> f64 {
    match i {
        0 => from,
        _ if i == count => to,
        _ => between(i as f64 / count as f64),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_value_has_one_bin_and_both_ends_belong() {
        let bins = Bins::linear(0.0, 1.0, 4).unwrap();
        let places = [0.0, 0.1, 0.25, 0.3, 0.5, 0.75, 0.999, 1.0].map(|x| bins.of(x));
        assert_eq!(places, [0, 0, 1, 1, 2, 3, 3, 3].map(Some));
        assert_eq!([-1e-9, 1.0 + 1e-9, f64::NAN].map(|x| bins.of(x)), [None; 3]);
        let bins = Bins::logarithmic(1.0, 16.0, 4).unwrap();
        assert_eq!((bins.ends(1), bins.ends(3)), ((2.0, 4.0), (8.0, 16.0)));
    }

    #[test]
    fn edges_that_make_no_bins_are_refused() {
        let message = |bins: Result<Bins, TurbulenceError>| bins.unwrap_err().to_string();
        assert_eq!(message(Bins::linear(0.0, 1.0, 0)), "there are no bins: give at least 1");
        assert_eq!(message(Bins::linear(1.0, 0.0, 2)), "entry 1 of the bin edges is 0.5; edges must ascend");
        assert_eq!(message(Bins::linear(0.0, f64::NAN, 1)), "entry 1 of the bin edges is NaN; it must be finite");
        assert_eq!(
            message(Bins::logarithmic(0.0, 1.0, 3)),
            "entry 0 of the bin edges is 0; it must be finite and positive"
        );
    }
}
