//! A solution as a line.

use super::seen::{FIELDS, names};
use crate::report::model::{Curve, CurveField};
use etalon_reference::scenes::{Solution, View};

/// The solution between two places: evenly, with its corners, and both sides of each jump. Without a solution an empty line.
pub fn curve(solution: Option<&dyn Solution>, view: View, (from, to): (f64, f64)) -> Curve {
    const SAMPLES: u32 = 400;
    /// How far from a jump its two sides are looked at, in lengths of the line.
    const BESIDE: f64 = 1e-9;
    let mut points: Vec<(f64, [f64; FIELDS])> = Vec::new();
    if let Some(solution) = solution {
        let length = to - from;
        let even = (0..=SAMPLES).map(|i| from + length * f64::from(i) / f64::from(SAMPLES));
        points.extend(even.chain(solution.corners()).map(|x| (x, solution.at(x))));
        for x in solution.jumps() {
            points.extend([(x, solution.at(x - BESIDE * length)), (x, solution.at(x + BESIDE * length))]);
        }
        // At a place without a finite value, such as a blast's centre, there is nothing to draw.
        points.retain(|(x, values)| (from..=to).contains(x) && values.iter().all(|v| v.is_finite()));
        // Stable: left of a jump stays before right of it.
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
    }
    let names = names(view);
    let field =
        |k: usize| CurveField { field: names[k].into(), value: points.iter().map(|(_, values)| values[k]).collect() };
    Curve { x: points.iter().map(|(x, _)| *x).collect(), fields: (0..FIELDS).map(field).collect() }
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Step;
    impl Solution for Step {
        fn at(&self, x: f64) -> [f64; 4] {
            [if x < 0.5 { 1.0 } else { 2.0 }, if x == 0.0 { f64::INFINITY } else { 1.0 / x }, 1.0, 1.0]
        }
        fn jumps(&self) -> Vec<f64> {
            vec![0.5, 7.0]
        }
    }

    #[test]
    fn jumps_have_two_sides_and_poles_none() {
        let curve = curve(Some(&Step), View::Along(0), (0.0, 1.0));
        assert!(curve.x.is_sorted() && curve.x[0] > 0.0 && curve.x.last() == Some(&1.0));
        let at_jump: Vec<f64> =
            curve.x.iter().zip(&curve.fields[0].value).filter(|(x, _)| **x == 0.5).map(|(_, v)| *v).collect();
        assert_eq!((at_jump.first(), at_jump.last()), (Some(&2.0), Some(&2.0)));
        assert!(at_jump.contains(&1.0));
        assert!(super::curve(None, View::Along(0), (0.0, 1.0)).x.is_empty());
    }
}
