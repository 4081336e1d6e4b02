//! What an equation can give over its whole domain: rigorous bounds, beside what a sample finds.
//!
//! The domain is a box, one side for each input, cut into smaller boxes; on each the equation runs on [`Interval`]s, and the results
//! are joined. An interval does not know that two of its operands are the same number, so bounds of large boxes are wide; cut in
//! half they come closer at least in proportion. What remains is proven for every real input of the domain, with the equation's true
//! constants and functions, not for a target's rounding of it.

use crate::interval::Interval;
use crate::probe::Probe;
use crate::quad::Quad;
use crate::sample::random_inputs;
use crate::target::Label;
use rayon::prelude::*;

/// The range of one result.
#[derive(Clone, Debug, PartialEq)]
pub struct Enclosure {
    /// The result's name.
    pub output: String,
    /// It lies between these for every input of the domain; infinite where no bound was found.
    pub bounds: Interval,
    /// How the bounds are known: proven, unless the inputs depend on one another, so that the box holds more than what is legal. They
    /// are proven for that too.
    pub label: Label,
    /// The least and the greatest value of a sample of a thousand.
    pub seen: Interval,
}

/// Encloses the results of a probe over the box of its domains, cut into about so many smaller boxes.
#[must_use]
pub fn enclose(probe: &Probe, boxes: usize) -> Vec<Enclosure> {
    let sides: Vec<Interval> =
        probe.input_domains().iter().map(|domain| domain.hull()).map(|(a, b)| Interval::new(a, b)).collect();
    let seen = seen(probe);
    let bounds = subdivided(sides, boxes)
        .into_par_iter()
        .map(|inputs| probe.evaluate(&inputs).unwrap_or_default()) // as many sides as the probe has inputs
        .reduce_with(|all, more| all.into_iter().zip(more).map(|(a, b)| a.hull(b)).collect())
        .unwrap_or_default();
    let names = probe.output_names();
    let entry = |((output, bounds), seen)| Enclosure { output, bounds, label: Label::Proven, seen };
    names.into_iter().zip(bounds).zip(seen).map(entry).collect()
}

/// Cuts a box again and again, along each side in turn, until there are so many.
fn subdivided(sides: Vec<Interval>, boxes: usize) -> Vec<Vec<Interval>> {
    let mut all = vec![sides];
    let mut axis = 0;
    while 2 * all.len() <= boxes && all.first().is_some_and(|sides| !sides.is_empty()) {
        all = all.into_iter().flat_map(|sides| halves(sides, axis)).collect();
        axis = (axis + 1) % all[0].len();
    }
    all
}

fn halves(sides: Vec<Interval>, axis: usize) -> [Vec<Interval>; 2] {
    let (low, high) = (sides[axis].low(), sides[axis].high());
    let middle = cut(low, high);
    let (mut lower, mut upper) = (sides.clone(), sides);
    lower[axis] = Interval::new(low, middle);
    upper[axis] = Interval::new(middle, high);
    [lower, upper]
}

/// Where to cut: at zero, at the geometric mean of ends far apart, else in the middle.
fn cut(low: f64, high: f64) -> f64 {
    match (low < 0.0, high > 0.0) {
        (true, true) => 0.0,
        _ if low * high > 0.0 && (high / low > 4.0 || low / high > 4.0) => (low * high).sqrt().copysign(high + low),
        _ => low + 0.5 * (high - low),
    }
}

fn seen(probe: &Probe) -> Vec<Interval> {
    let values = random_inputs(probe, 0).into_iter().map(|inputs| {
        let inputs: Vec<Quad> = inputs.into_iter().map(Quad::exact).collect();
        let results = probe.evaluate(&inputs).unwrap_or_default();
        results.into_iter().map(|value| Interval::exact(value.to_f64())).collect::<Vec<_>>()
    });
    values.reduce(|all, more| all.into_iter().zip(more).map(|(a, b)| a.hull(b)).collect()).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boxes_cover_the_whole_and_meet() {
        let boxes = subdivided(vec![Interval::new(0.0, 1.0), Interval::new(1.0, 1e6)], 64);
        assert_eq!(boxes.len(), 64);
        let area: f64 = boxes.iter().map(|b| (b[0].high() - b[0].low()) * (b[1].high() - b[1].low())).sum();
        assert!((area / (1e6 - 1.0) - 1.0).abs() < 1e-9, "{area}");
    }
}
