//! Which particles of two snapshots belong together.

use crate::snapshot::{Frame, Snapshot, SnapshotError};
use rstar::RTree;
use rstar::primitives::GeomWithData;
use std::collections::HashMap;

/// A part of the mean spacing beyond which particles do not belong together, if nobody says otherwise: nearer to another place than half
/// way to the neighbour.
const USUAL_PART_OF_SPACING: f64 = 0.5;

/// Pairs of rows, of the first snapshot and of the second, each in one pair at most.
#[derive(Clone, Debug, PartialEq)]
pub struct Matching {
    /// The pairs, in the order of the first snapshot.
    pub pairs: Vec<(usize, usize)>,
    /// How far apart they may be, where they are matched by position.
    pub within: Option<f64>,
}

/// A point, and its row.
type Site = GeomWithData<[f64; 3], usize>;

impl Matching {
    /// Those with the same id.
    pub fn by_id(a: &Snapshot, b: &Snapshot) -> Self {
        let rows: HashMap<u64, usize> = (0..b.len()).map(|row| (b.id(row), row)).collect();
        let pairs = (0..a.len()).filter_map(|row| Some((row, *rows.get(&a.id(row))?))).collect();
        Matching { pairs, within: None }
    }

    /// Those that are nearest to each other, both ways, and no farther apart than `within`, half the mean spacing if it is not said. Along
    /// periodic axes of the first snapshot's box, round the corner too.
    ///
    /// # Errors
    /// [`SnapshotError::Invalid`] for a distance that is not finite and positive.
    pub fn by_position(a: &Snapshot, b: &Snapshot, within: Option<f64>) -> Result<Self, SnapshotError> {
        let within = within.unwrap_or(USUAL_PART_OF_SPACING * spacing(a));
        if !(within.is_finite() && within > 0.0) {
            return Err(SnapshotError::Invalid(format!(
                "particles within {within} were asked for; it must be a finite positive distance"
            )));
        }
        let places = |of: &Snapshot| -> Vec<[f64; 3]> {
            let axes = of.position();
            let place = |row: usize| {
                std::array::from_fn(|axis| axes.get(axis).map_or(0.0, |column| wrapped(column[row], axis, a.frame())))
            };
            (0..of.len()).map(place).collect()
        };
        let (of_a, of_b) = (places(a), places(b));
        let tree = |places: &[[f64; 3]]| {
            RTree::bulk_load(places.iter().zip(0..).map(|(place, row)| Site::new(*place, row)).collect())
        };
        let (tree_a, tree_b) = (tree(&of_a), tree(&of_b));
        let nearest = |tree: &RTree<Site>, place: [f64; 3]| {
            let images = images(place, within, a.frame());
            let found = images.filter_map(|place| {
                let site = tree.nearest_neighbor(place)?;
                let squared = site.geom().iter().zip(place).map(|(x, y)| (x - y).powi(2)).sum::<f64>();
                (squared <= within * within).then_some((squared, site.data))
            });
            // Of equally near ones the first, in both directions.
            found.min_by(|(d, row), (e, other)| d.total_cmp(e).then(row.cmp(other))).map(|(_, row)| row)
        };
        let back: Vec<Option<usize>> = of_b.iter().map(|place| nearest(&tree_a, *place)).collect();
        let pair = |(row, place): (usize, &[f64; 3])| {
            let other = nearest(&tree_b, *place)?;
            (back[other] == Some(row)).then_some((row, other))
        };
        Ok(Matching { pairs: of_a.iter().enumerate().filter_map(pair).collect(), within: Some(within) })
    }
}

/// A coordinate within the box, on an axis that closes on itself.
fn wrapped(x: f64, axis: usize, frame: Option<&Frame>) -> f64 {
    match frame {
        Some(frame) if frame.periodic[axis] => {
            let (lower, length) = (frame.lower[axis], frame.upper[axis] - frame.lower[axis]);
            lower + (x - lower).rem_euclid(length)
        }
        _ => x,
    }
}

/// A place and those that are the same round the corner, as far as they are within reach of the box.
fn images(place: [f64; 3], within: f64, frame: Option<&Frame>) -> impl Iterator<Item = [f64; 3]> {
    let mut all = vec![place];
    for axis in 0..frame.map_or(0, |frame| frame.periodic.len()) {
        let Some(frame) = frame.filter(|frame| frame.periodic[axis]) else { continue };
        let length = frame.upper[axis] - frame.lower[axis];
        let beyond = |shift: f64| {
            let near = if shift > 0.0 { place[axis] - frame.lower[axis] } else { frame.upper[axis] - place[axis] };
            (near <= within).then_some(shift)
        };
        for shift in [length, -length].into_iter().filter_map(beyond) {
            for mut image in all.clone() {
                if image[axis] == place[axis] {
                    image[axis] += shift;
                    all.push(image);
                }
            }
        }
    }
    all.into_iter()
}

/// The mean spacing of a snapshot's particles: what a particle's share of the box has as its side.
pub fn spacing(of: &Snapshot) -> f64 {
    let extent = |(axis, column): (usize, &&[f64])| match of.frame() {
        Some(frame) => frame.upper[axis] - frame.lower[axis],
        None => {
            let low = column.iter().copied().fold(f64::INFINITY, f64::min);
            let high = column.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            high - low
        }
    };
    let extents: Vec<f64> = of.position().iter().enumerate().map(extent).filter(|length| *length > 0.0).collect();
    let volume: f64 = extents.iter().product();
    match extents.len() {
        0 => 1.0,
        axes => (volume / of.len() as f64).powf(1.0 / axes as f64),
    }
}
