//! How values of one column are made comparable with those of another: the relative difference to the best of them.

use etalon_spec::tables::Goal;

/// The relative difference of each value to the best one of its column: 0 for the best, 0.5 for half as much again.
///
/// With the badness b of a value (the value itself where lower is better, its negative where higher is, its distance
/// where there is a target) and the best value v\* of the column, it is (b − b\*) / |v\*|. That is the "relative difference to the
/// best metric result" of GS25, Fig. 10, whose paper does not say what it divides by; dividing by the best result is the
/// plain reading. It may exceed 1; the colours of the heat map end there.
///
/// A best value of zero, an error that vanished, leaves nothing to divide by: every worse value is then infinitely worse.
/// What is absent or no finite number stays absent.
#[must_use]
pub fn relative_differences(values: &[Option<f64>], goal: Goal) -> Vec<Option<f64>> {
    let finite = |value: &Option<f64>| value.filter(|value| value.is_finite());
    let badness = |value: &f64| goal.badness(*value);
    let best = values.iter().filter_map(finite).min_by(|one, other| badness(one).total_cmp(&badness(other)));
    let Some(best) = best else { return vec![None; values.len()] };
    let difference = |value: f64| match badness(&value) - badness(&best) {
        0.0 => 0.0,
        worse => worse / best.abs(),
    };
    values.iter().map(|value| finite(value).map(difference)).collect()
}

#[cfg(test)]
mod tests {
    use etalon_spec::tables::{MetricKey, Results, SchemeName};

    use super::*;

    fn of(values: &[f64], goal: Goal) -> Vec<f64> {
        let values: Vec<Option<f64>> = values.iter().copied().map(Some).collect();
        relative_differences(&values, goal).into_iter().map(|difference| difference.unwrap()).collect()
    }

    #[test]
    fn the_best_is_zero_and_the_rest_is_relative_to_it() {
        assert_eq!(of(&[2.0, 3.0, 8.0], Goal::Lower), [0.0, 0.5, 3.0]);
        assert_eq!(of(&[8.0, 4.0, 6.0], Goal::Higher), [0.0, 0.5, 0.25]);
        // The lower of two negative rates is the better one.
        assert_eq!(of(&[-0.25, -0.5], Goal::Lower), [0.5, 0.0]);
        // Distances 1, 2 and 3 from the target, on both sides of it; the best value is 3.
        assert_eq!(of(&[3.0, 6.0, 1.0], Goal::Target(4.0)), [0.0, 1.0 / 3.0, 2.0 / 3.0]);
    }

    #[test]
    fn equals_are_equal_and_zero_is_out_of_reach() {
        assert_eq!(of(&[1.5, 1.5], Goal::Lower), [0.0, 0.0]);
        assert_eq!(of(&[0.0, 0.0], Goal::Lower), [0.0, 0.0]);
        assert_eq!(of(&[0.0, 1e-9], Goal::Lower), [0.0, f64::INFINITY]);
    }

    #[test]
    fn what_is_absent_stays_absent() {
        let values = [None, Some(f64::NAN), Some(2.0), Some(1.0)];
        assert_eq!(relative_differences(&values, Goal::Lower), [None, None, Some(1.0), Some(0.0)]);
        assert_eq!(relative_differences(&[None, None], Goal::Higher), [None, None]);
        assert_eq!(relative_differences(&[], Goal::Higher), []);
    }

    /// What the paper says of its figure: zero for the best of every column.
    #[test]
    fn gs25_table_7_has_a_best_in_every_column() {
        let results = Results::load().unwrap();
        for key in MetricKey::ALL {
            let values = SchemeName::ALL.map(|name| Some(results.value(name, key)));
            let differences = relative_differences(&values, results.metric(key).goal());
            assert!(differences.iter().flatten().all(|difference| *difference >= 0.0), "{key:?}");
            assert!(differences.contains(&Some(0.0)), "{key:?}");
        }
    }
}
