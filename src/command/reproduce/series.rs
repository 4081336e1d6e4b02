//! How an error falls with the number of particles: pairs of both, particles ascending.

/// By least squares, the order with which it falls: minus the slope of its logarithm over that of the number. None for fewer than two, or where one is
/// not positive.
pub fn order(series: &[(f64, f64)]) -> Option<f64> {
    let usable = series.iter().all(|(n, error)| *n > 0.0 && *error > 0.0);
    if series.len() < 2 || !usable {
        return None;
    }
    let logs: Vec<(f64, f64)> = series.iter().map(|(n, error)| (n.ln(), error.ln())).collect();
    let count = logs.len() as f64;
    let (x, y) = logs.iter().fold((0.0, 0.0), |(x, y), (a, b)| (x + a / count, y + b / count));
    let spread: f64 = logs.iter().map(|(a, _)| (a - x).powi(2)).sum();
    let along: f64 = logs.iter().map(|(a, b)| (a - x) * (b - y)).sum();
    (spread > 0.0).then(|| -along / spread)
}

/// An order that is nearer to second than to first.
const SECOND: f64 = 1.5;

/// The least number from which on it falls in second order from each to the next; none if it does not between the last two.
pub fn second_order_from(series: &[(f64, f64)]) -> Option<f64> {
    from(&series[..series.len().saturating_sub(1)], |k| order(&series[k..k + 2]).is_some_and(|order| order >= SECOND))
}

/// The least number from which on it is at most so large; none if it is larger at the last.
pub fn within_from(series: &[(f64, f64)], most: f64) -> Option<f64> {
    from(series, |k| series[k].1 <= most)
}

/// The first number of those at the end that all are `good`.
fn from(series: &[(f64, f64)], good: impl Fn(usize) -> bool) -> Option<f64> {
    let first = (0..series.len()).rev().take_while(|&k| good(k)).last()?;
    Some(series[first].0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Flat to 256, second order from there.
    fn kinked() -> Vec<(f64, f64)> {
        [32.0, 64.0, 128.0, 256.0, 512.0, 1024.0].map(|n: f64| (n, 0.5 * (n / 256.0).max(1.0).powi(-2))).to_vec()
    }

    #[test]
    fn an_order_is_the_slope() {
        let all = kinked();
        // A slope of logarithms, to rounding.
        assert!((order(&all[3..]).unwrap() - 2.0).abs() < 1e-12);
        assert!(order(&all[..4]).unwrap().abs() < 1e-12);
        assert_eq!((order(&all[..1]), order(&[(1.0, 1.0), (2.0, 0.0)])), (None, None));
    }

    #[test]
    fn second_order_begins_where_it_does_and_lasts() {
        let mut all = kinked();
        assert_eq!(second_order_from(&all), Some(256.0));
        // A gain that is lost again is none.
        all[1].1 = 0.01;
        assert_eq!(second_order_from(&all), Some(256.0));
        all[5].1 = all[4].1;
        assert_eq!((second_order_from(&all), second_order_from(&all[..1]), second_order_from(&[])), (None, None, None));
    }

    #[test]
    fn an_error_is_small_from_where_it_stays_so() {
        let mut all = kinked();
        assert_eq!(within_from(&all, 0.2), Some(512.0));
        all[0].1 = 0.1;
        assert_eq!(within_from(&all, 0.2), Some(512.0));
        assert_eq!((within_from(&all, 1.0), within_from(&all, 1e-3)), (Some(32.0), None));
    }
}
