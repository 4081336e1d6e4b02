//! How fields differ, particle by particle.

use super::matching::{Matching, spacing};
use crate::snapshot::Snapshot;
use crate::snapshot::table::{AXES, Column};
use serde::Serialize;

/// Where a difference sits.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Place {
    /// The particle's number in the first snapshot.
    pub id: u64,
    /// Where it is there.
    pub position: Vec<f64>,
    /// The field's value in the first snapshot.
    pub a: f64,
    /// And in the second.
    pub b: f64,
}

/// How one field differs over all pairs: second minus first.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FieldDifference {
    /// The field.
    pub name: String,
    /// Its unit, if the first file says.
    pub unit: String,
    /// What differences are measured in: the root mean square of the field in the first snapshot, of all components of a vector; for a
    /// position, the mean spacing. Where that is zero, of the second snapshot; where both are, one.
    pub scale: f64,
    /// Root of the mean square difference.
    pub rms: f64,
    /// Mean size of the difference.
    pub l1: f64,
    /// The largest difference.
    pub max: f64,
    /// The root mean square in units of the scale.
    pub relative_rms: f64,
    /// The mean in units of the scale.
    pub relative_l1: f64,
    /// The largest in units of the scale.
    pub relative_max: f64,
    /// Where the largest is.
    pub at: Place,
}

/// All fields that both have.
pub fn differences(a: &Snapshot, b: &Snapshot, matching: &Matching) -> Vec<FieldDifference> {
    let both = a.columns().iter().filter_map(|column| Some((column, b.column(&column.name)?)));
    both.filter_map(|(column, other)| difference(a, b, column, other, matching)).collect()
}

fn difference(
    a: &Snapshot,
    b: &Snapshot,
    column: &Column,
    other: &[f64],
    matching: &Matching,
) -> Option<FieldDifference> {
    let axis = AXES.iter().position(|axis| *axis == column.name);
    // Along a periodic axis, the short way round.
    let length = axis.and_then(|axis| a.frame().filter(|f| f.periodic[axis]).map(|f| f.upper[axis] - f.lower[axis]));
    let apart = |&(i, j): &(usize, usize)| {
        let straight = other[j] - column.values[i];
        length.map_or(straight, |length| straight - length * (straight / length).round())
    };
    let scale = if axis.is_some() { spacing(a) } else { scale(a, b, &column.name) };
    let (mut squares, mut sum, mut max, mut worst) = (0.0, 0.0, 0.0, matching.pairs.first()?);
    for pair in &matching.pairs {
        let size = apart(pair).abs();
        squares += (size / scale).powi(2);
        sum += size;
        // What is no number is the worst there is.
        if size > max || size.is_nan() {
            (max, worst) = (size, pair);
        }
    }
    let count = matching.pairs.len() as f64;
    let (relative_rms, l1) = ((squares / count).sqrt(), sum / count);
    let (i, j) = *worst;
    let at = Place {
        id: a.id(i),
        position: a.position().iter().map(|column| column[i]).collect(),
        a: column.values[i],
        b: other[j],
    };
    Some(FieldDifference {
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
    })
}

/// The root mean square of a field, of all components if it is one of a vector, each weighing as much as a scalar.
pub fn scale(a: &Snapshot, b: &Snapshot, name: &str) -> f64 {
    let stem = name.rsplit_once('_').filter(|(_, axis)| AXES.contains(axis)).map(|(stem, _)| stem);
    let of = |snapshot: &Snapshot| {
        let columns: Vec<&[f64]> = match stem {
            Some(stem) => AXES.iter().filter_map(|axis| snapshot.column(&format!("{stem}_{axis}"))).collect(),
            None => snapshot.column(name).into_iter().collect(),
        };
        // By the largest first: squares of what is small or large leave the range of numbers.
        let largest = columns.iter().flat_map(|c| c.iter()).fold(0.0, |most: f64, x| most.max(x.abs()));
        let squares: f64 = columns.iter().flat_map(|c| c.iter()).map(|x| (x / largest).powi(2)).sum();
        if largest > 0.0 { largest * (squares / snapshot.len() as f64).sqrt() } else { 0.0 }
    };
    [of(a), of(b)].into_iter().find(|scale| *scale > 0.0).unwrap_or(1.0)
}
