//! Fields averaged in intervals of a coordinate or of the radius.

use super::particles::scale;
use super::{Along, Options};
use crate::snapshot::table::AXES;
use crate::snapshot::{Snapshot, SnapshotError};
use serde::Serialize;

/// More intervals than this are a mistake.
const MOST_BINS: usize = 100_000;

/// What a snapshot has in an interval.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct BinValue {
    /// How many particles.
    pub particles: u64,
    /// Their mean.
    pub mean: f64,
    /// Their scatter about it: the root mean square deviation.
    pub scatter: f64,
}

/// An interval.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Bin {
    /// Where it begins.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
    /// What the first snapshot has there, if any particle.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub a: Option<BinValue>,
    /// What the second has.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub b: Option<BinValue>,
}

impl Bin {
    /// The middle.
    pub fn middle(&self) -> f64 {
        0.5 * (self.from + self.to)
    }
    /// The difference of the means, second minus first, where both have particles.
    pub fn difference(&self) -> Option<f64> {
        Some(self.b?.mean - self.a?.mean)
    }
}

/// One field along the coordinate.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Profile {
    /// The field.
    pub name: String,
    /// Its unit, if the first file says.
    pub unit: String,
    /// What differences are measured in, as of particles.
    pub scale: f64,
    /// Root of the mean square difference of the means, over intervals where both have particles.
    pub rms: f64,
    /// Mean size of that difference.
    pub l1: f64,
    /// The largest.
    pub max: f64,
    /// The root mean square in units of the scale.
    pub relative_rms: f64,
    /// The mean in units of the scale.
    pub relative_l1: f64,
    /// The largest in units of the scale.
    pub relative_max: f64,
    /// The middle of the interval where it is.
    pub at: f64,
    /// The intervals, in order.
    pub bins: Vec<Bin>,
}

/// The intervals, and in which each particle is.
pub struct Ruler {
    centre: Option<Vec<f64>>,
    edges: Vec<f64>,
    of_a: Vec<usize>,
    of_b: Vec<usize>,
}

impl Ruler {
    pub fn new(a: &Snapshot, b: &Snapshot, options: &Options) -> Result<Self, SnapshotError> {
        let refused = |problem: String| Err(SnapshotError::Invalid(problem));
        let bins = options.bins;
        if !(1..=MOST_BINS).contains(&bins) {
            return refused(format!("{bins} intervals were asked for; there may be 1 to {MOST_BINS}"));
        }
        let centre = match (options.along, &options.centre) {
            (Along::Axis(axis), _) if axis >= a.dimension() => {
                return refused(format!("there is no axis {} in {} dimensions", AXES[axis.min(2)], a.dimension()));
            }
            (Along::Axis(_), _) => None,
            (Along::Radius, Some(centre)) if centre.len() != a.dimension() || centre.iter().any(|x| !x.is_finite()) => {
                return refused(format!("the centre {centre:?} is no point of {} finite coordinates", a.dimension()));
            }
            (Along::Radius, Some(centre)) => Some(centre.clone()),
            (Along::Radius, None) => Some(middle(a)),
        };
        let places = |of: &Snapshot| -> Vec<f64> {
            let axes = of.position();
            match (options.along, &centre) {
                (Along::Radius, Some(centre)) => (0..of.len())
                    .map(|row| axes.iter().zip(centre).map(|(column, x)| (column[row] - x).powi(2)).sum::<f64>().sqrt())
                    .collect(),
                (Along::Axis(axis), _) => axes[axis].to_vec(),
                (Along::Radius, None) => Vec::new(),
            }
        };
        let (of_a, of_b) = (places(a), places(b));
        let all = || of_a.iter().chain(&of_b).copied();
        let (low, high) = (all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max));
        // A radius begins at the centre.
        let low = if options.along == Along::Radius { 0.0 } else { low };
        let width = if high > low { (high - low) / bins as f64 } else { 1.0 };
        let bin = |place: &f64| (((place - low) / width) as usize).min(bins - 1);
        Ok(Ruler {
            centre,
            edges: (0..=bins).map(|k| low + k as f64 * width).collect(),
            of_a: of_a.iter().map(bin).collect(),
            of_b: of_b.iter().map(bin).collect(),
        })
    }

    /// From where radii are counted.
    pub fn centre(&self) -> Option<&[f64]> {
        self.centre.as_deref()
    }

    /// All fields that both have but positions.
    pub fn profiles(&self, a: &Snapshot, b: &Snapshot) -> Vec<Profile> {
        let fields = a.columns().iter().filter(|column| !AXES.contains(&column.name.as_str()));
        let both = fields.filter_map(|column| Some((column, b.column(&column.name)?)));
        both.map(|(column, other)| {
            let (of_a, of_b) = (self.averages(&self.of_a, &column.values), self.averages(&self.of_b, other));
            let edges = self.edges.windows(2).zip(of_a.into_iter().zip(of_b));
            let bins: Vec<Bin> = edges.map(|(edge, (a, b))| Bin { from: edge[0], to: edge[1], a, b }).collect();
            let scale = scale(a, b, &column.name);
            let differences = || bins.iter().filter_map(|bin| Some((bin.middle(), bin.difference()?.abs())));
            let count = differences().count().max(1) as f64;
            let relative_rms = (differences().map(|(_, d)| (d / scale).powi(2)).sum::<f64>() / count).sqrt();
            let l1 = differences().map(|(_, d)| d).sum::<f64>() / count;
            let (at, max) = differences().max_by(|(_, d), (_, e)| d.total_cmp(e)).unwrap_or((self.edges[0], 0.0));
            Profile {
                name: column.name.clone(),
                unit: column.unit.clone(),
                scale,
                rms: relative_rms * scale,
                l1,
                max,
                relative_rms,
                relative_l1: l1 / scale,
                relative_max: max / scale,
                at,
                bins,
            }
        })
        .collect()
    }

    /// Mean and scatter in each interval, the mean first so that nothing cancels.
    fn averages(&self, bin_of: &[usize], values: &[f64]) -> Vec<Option<BinValue>> {
        let bins = self.edges.len() - 1;
        let (mut count, mut mean, mut square) = (vec![0_u64; bins], vec![0.0; bins], vec![0.0; bins]);
        bin_of.iter().for_each(|&bin| count[bin] += 1);
        for (&bin, value) in bin_of.iter().zip(values) {
            mean[bin] += value / count[bin] as f64;
        }
        for (&bin, value) in bin_of.iter().zip(values) {
            square[bin] += (value - mean[bin]).powi(2) / count[bin] as f64;
        }
        let value = |bin: usize| BinValue { particles: count[bin], mean: mean[bin], scatter: f64::sqrt(square[bin]) };
        (0..bins).map(|bin| (count[bin] > 0).then(|| value(bin))).collect()
    }
}

/// The middle of the box, or of the particles.
fn middle(of: &Snapshot) -> Vec<f64> {
    match of.frame() {
        Some(frame) => frame.lower.iter().zip(&frame.upper).map(|(low, high)| 0.5 * (low + high)).collect(),
        None => {
            let ends = |column: &[f64]| {
                let low = column.iter().copied().fold(f64::INFINITY, f64::min);
                0.5 * (low + column.iter().copied().fold(f64::NEG_INFINITY, f64::max))
            };
            of.position().iter().map(|column| ends(column)).collect()
        }
    }
}
