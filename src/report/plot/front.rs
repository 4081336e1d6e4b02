//! The Pareto front: what nothing else beats in both error and cost.

use super::super::ReportError;
use super::refuse::finite;

/// The front of `(cost, error)` points, lower being better in both: places of the points that no other dominates, by
/// rising cost, then by place.
///
/// One point dominates another if it is no worse in both and better in one. So two equal points do not dominate each other:
/// both are on the front, or neither.
///
/// # Errors
/// [`ReportError::NotFinite`] for a coordinate that is no finite number.
pub fn pareto_front(points: &[(f64, f64)]) -> Result<Vec<usize>, ReportError> {
    for (place, &(cost, error)) in points.iter().enumerate() {
        finite(cost, || format!("points[{place}].cost"))?;
        finite(error, || format!("points[{place}].error"))?;
    }
    // Adding zero turns -0 into 0, which the order would tell apart.
    let key = |place: usize| (points[place].0 + 0.0, points[place].1 + 0.0);
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|&one, &other| {
        let ((cost, error), (other_cost, other_error)) = (key(one), key(other));
        cost.total_cmp(&other_cost).then(error.total_cmp(&other_error))
    });
    // By rising cost a point is on the front just if it has a lower error than all before it, or equals the last one on it.
    let mut front: Vec<usize> = Vec::new();
    for place in order {
        let better = |last: &usize| key(place).1 < key(*last).1 || key(place) == key(*last);
        if front.last().is_none_or(better) {
            front.push(place);
        }
    }
    Ok(front)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// The definition, word by word.
    fn dominates(one: (f64, f64), other: (f64, f64)) -> bool {
        one.0 <= other.0 && one.1 <= other.1 && (one.0 < other.0 || one.1 < other.1)
    }

    #[test]
    fn a_small_front() {
        let points = [(3.0, 1.0), (1.0, 4.0), (2.0, 2.0), (2.0, 3.0), (4.0, 1.0), (1.0, 4.0), (5.0, 9.0)];
        assert_eq!(pareto_front(&points).unwrap(), [1, 5, 2, 0]);
        assert_eq!(pareto_front(&[]).unwrap(), [0; 0]);
        assert_eq!(pareto_front(&[(0.0, 1.0), (-0.0, 1.0)]).unwrap(), [0, 1]);
    }

    #[test]
    fn what_is_no_number_is_refused() {
        for (points, path) in
            [([(1.0, 1.0), (f64::NAN, 1.0)], "points[1].cost"), ([(1.0, f64::INFINITY), (1.0, 1.0)], "points[0].error")]
        {
            let error = pareto_front(&points).unwrap_err().to_string();
            assert!(error.starts_with(path), "{error}");
        }
    }

    proptest! {
        /// Few distinct coordinates, so that ties and equal points are frequent.
        #[test]
        fn exactly_what_nothing_dominates(points in prop::collection::vec((0_u8..8, 0_u8..8), 0..40)) {
            let points: Vec<(f64, f64)> = points.iter().map(|&(cost, error)| (cost.into(), error.into())).collect();
            let front = pareto_front(&points).unwrap();
            for (place, &point) in points.iter().enumerate() {
                let dominated = points.iter().any(|&other| dominates(other, point));
                prop_assert_eq!(front.contains(&place), !dominated, "{} {:?}", place, point);
            }
            prop_assert!(front.is_sorted_by_key(|&place| points[place].0));
            prop_assert!(front.is_sorted_by(|&one, &next| points[one].1 >= points[next].1));
        }

        #[test]
        fn scales_do_not_matter(
            points in prop::collection::vec((1e-9_f64..1e9, 1e-9_f64..1e9), 0..40),
            scales in (-40_i32..40, -40_i32..40),
        ) {
            let (cost, error) = (2_f64.powi(scales.0), 2_f64.powi(scales.1));
            let scaled: Vec<(f64, f64)> = points.iter().map(|point| (point.0 * cost, point.1 * error)).collect();
            prop_assert_eq!(pareto_front(&points).unwrap(), pareto_front(&scaled).unwrap());
        }
    }
}
