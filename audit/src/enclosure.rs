//! What an equation can give over its whole domain: rigorous bounds, beside what a sample finds.
//!
//! The domain is a set of boxes: a side has a part for the positive numbers of its domain, one for the negative ones, and one for each value
//! beside them, zero above all; where there are too many combinations of parts a side is taken as a whole. The boxes are cut into smaller
//! ones; on each the equation runs on [`Interval`]s, and the results
//! are joined. An interval does not know that two of its operands are the same number, so bounds of large boxes are wide; cut in
//! half they come closer at least in proportion. What remains is proven for every real input of the domain, with the equation's true
//! constants and functions, not for a target's rounding of it.

use crate::interval::Interval;
use crate::probe::Probe;
use crate::quad::Quad;
use crate::sample::random_inputs;
use rayon::prelude::*;
use std::fmt;

/// The range of one result.
#[derive(Clone, Debug, PartialEq)]
pub struct Enclosure {
    /// The result's name.
    pub output: String,
    /// It lies between these for every input of the domain, which is proven; infinite where no bound was found.
    pub bounds: Interval,
    /// Why a bound is missing.
    pub gap: Option<Gap>,
    /// The least and the greatest value of a sample of a thousand.
    pub seen: Interval,
}

/// Why there is no bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Gap {
    /// The arguments belong together, so the legal ones fill no box.
    Arranged,
    /// Somewhere the interval of a divisor holds zero.
    Divisor,
}

impl fmt::Display for Gap {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Gap::Arranged => "the arguments depend on one another, and no box holds the legal ones alone",
            Gap::Divisor => {
                "in a part of the domain the interval of a divisor reaches zero, because an interval forgets that two of its operands are \
                 one number, or because the equation guards the divisor and the interval sees both sides of the guard"
            }
        })
    }
}

/// Encloses the results of a probe over its domain, cut into about so many boxes.
#[must_use]
pub fn enclose(probe: &Probe, boxes: usize) -> Vec<Enclosure> {
    let seen = seen(probe);
    let names = probe.output_names();
    let bounds = match probe.arranged {
        Some(_) => vec![Interval::ALL; names.len()],
        None => subdivided(domain_boxes(probe, boxes), boxes)
            .into_par_iter()
            .map(|inputs| probe.evaluate(&inputs).unwrap_or_default()) // as many sides as the probe has inputs
            .reduce_with(|all, more| all.into_iter().zip(more).map(|(a, b)| a.hull(b)).collect())
            .unwrap_or_default(),
    };
    let entry = |((output, bounds), seen): ((String, Interval), Interval)| {
        let missing = if probe.arranged.is_some() { Gap::Arranged } else { Gap::Divisor };
        let is_whole = bounds.low().is_finite() && bounds.high().is_finite();
        Enclosure { output, bounds, gap: (!is_whole).then_some(missing), seen }
    };
    names.into_iter().zip(bounds).zip(seen).map(entry).collect()
}

/// The boxes that the domain is made of, as long as there are no more than so many.
fn domain_boxes(probe: &Probe, most: usize) -> Vec<Vec<Interval>> {
    let mut all = vec![Vec::new()];
    for domain in probe.input_domains() {
        let mut parts = domain.parts();
        if all.len() * parts.len() > most {
            parts = vec![domain.hull()];
        }
        let longer = |sides: &Vec<Interval>, (low, high): (f64, f64)| {
            sides.iter().copied().chain([Interval::new(low, high)]).collect::<Vec<_>>()
        };
        all = all.iter().flat_map(|sides| parts.iter().map(move |part| longer(sides, *part))).collect();
    }
    all
}

/// Cuts boxes again and again, along each side in turn, until there are so many. Points are not cut.
fn subdivided(boxes: Vec<Vec<Interval>>, most: usize) -> Vec<Vec<Interval>> {
    let mut all = boxes;
    let axes = all.first().map_or(0, Vec::len);
    let is_wide = |sides: &[Interval], axis: usize| sides[axis].low() < sides[axis].high();
    let mut idle = 0;
    for axis in (0..axes).cycle() {
        let wide = all.iter().filter(|sides| is_wide(sides, axis)).count();
        if idle == axes || all.len() + wide > most {
            break;
        }
        idle = if wide == 0 { idle + 1 } else { 0 };
        let cut = |sides: Vec<Interval>| if is_wide(&sides, axis) { halves(sides, axis).to_vec() } else { vec![sides] };
        all = all.into_iter().flat_map(cut).collect();
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
        let boxes = subdivided(vec![vec![Interval::new(0.0, 1.0), Interval::new(1.0, 1e6)]], 64);
        assert_eq!(boxes.len(), 64);
        let area: f64 = boxes.iter().map(|b| (b[0].high() - b[0].low()) * (b[1].high() - b[1].low())).sum();
        assert!((area / (1e6 - 1.0) - 1.0).abs() < 1e-9, "{area}");
    }

    #[test]
    fn points_are_not_cut() {
        let point = Interval::exact(0.0);
        assert_eq!(subdivided(vec![vec![point, point]], 64), [[point, point]]);
        let boxes = subdivided(vec![vec![point, Interval::new(0.0, 1.0)], vec![point, point]], 5);
        assert_eq!(boxes.len(), 5);
        assert!(boxes.iter().all(|sides| sides[0] == point));
    }

    /// Zero is a part of its own, so that a divisor beside it is not near it.
    #[test]
    fn a_guarded_divisor_beside_zero_is_bounded() {
        let limiter = crate::probes().iter().find(|probe| probe.function == "slope_limiter").unwrap();
        assert_eq!(domain_boxes(limiter, 4096).len(), 9);
        let enclosure = enclose(limiter, 4096).remove(0);
        assert_eq!(enclosure.gap, None);
        // It is between zero and one; what is more is what intervals forget.
        assert!(enclosure.bounds.size() < 10.0, "{}", enclosure.bounds);
    }
}
