//! Fields between particles: the value of the nearest one, or the mean of all around, weighted with a kernel.

use super::super::ReportError;
use super::refuse::{finite, unless};

/// A rectangle of the plane, in which particles may come back in on the other side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Window {
    /// The lower left corner.
    pub low: [f64; 2],
    /// The upper right corner.
    pub high: [f64; 2],
    /// Whether each axis is periodic with the rectangle's side.
    pub periodic: [bool; 2],
}

impl Window {
    pub(super) fn side(&self, axis: usize) -> f64 {
        self.high[axis] - self.low[axis]
    }

    /// Refuses what is no rectangle.
    pub(super) fn check(&self) -> Result<(), ReportError> {
        for axis in 0..2 {
            finite(self.low[axis], || format!("window.low[{axis}]"))?;
            finite(self.high[axis], || format!("window.high[{axis}]"))?;
            unless(
                self.side(axis) > 0.0,
                || format!("window, axis {axis}"),
                "the upper end must lie above the lower one",
            )?;
        }
        Ok(())
    }

    /// The square of the distance of two points, by the shorter way round where an axis is periodic.
    fn distance_squared(&self, one: [f64; 2], other: [f64; 2]) -> f64 {
        let along = |axis: usize| {
            let (difference, side) = (one[axis] - other[axis], self.side(axis));
            if self.periodic[axis] { difference - side * (difference / side).round() } else { difference }
        };
        along(0).powi(2) + along(1).powi(2)
    }
}

/// Particles sorted into cells.
struct Cells<'a> {
    window: Window,
    points: &'a [[f64; 2]],
    count: [usize; 2],
    /// Where the particles of each cell begin in `order`, with one more for the end.
    start: Vec<usize>,
    order: Vec<usize>,
}

impl<'a> Cells<'a> {
    /// Sorts the particles into about as many cells as there are particles, as square as the window allows.
    fn new(points: &'a [[f64; 2]], window: Window) -> Self {
        let side = (window.side(0) * window.side(1) / points.len().max(1) as f64).sqrt();
        // Of a strip much narrower than a cell, no more than a cell a particle.
        let count = [0, 1].map(|axis| ((window.side(axis) / side) as usize).clamp(1, points.len().max(1)));
        let mut cells =
            Self { window, points, count, start: vec![0; count[0] * count[1] + 1], order: vec![0; points.len()] };
        let places: Vec<usize> = points.iter().map(|&point| cells.flat(cells.cell(point))).collect();
        for &place in &places {
            cells.start[place + 1] += 1;
        }
        for place in 1..cells.start.len() {
            cells.start[place] += cells.start[place - 1];
        }
        let mut next = cells.start.clone();
        for (particle, place) in places.into_iter().enumerate() {
            cells.order[next[place]] = particle;
            next[place] += 1;
        }
        cells
    }

    /// The cell of a point; of one outside the window, the cell nearest to it, or the one it comes back into.
    fn cell(&self, point: [f64; 2]) -> [usize; 2] {
        [0, 1].map(|axis| {
            let part = (point[axis] - self.window.low[axis]) / self.window.side(axis);
            let part = if self.window.periodic[axis] { part.rem_euclid(1.0) } else { part };
            // Casting to an unsigned number takes what is below zero to zero.
            ((part * self.count[axis] as f64) as usize).min(self.count[axis] - 1)
        })
    }

    fn flat(&self, cell: [usize; 2]) -> usize {
        cell[1] * self.count[0] + cell[0]
    }

    /// The shorter side of a cell.
    fn cell_side(&self) -> f64 {
        (self.window.side(0) / self.count[0] as f64).min(self.window.side(1) / self.count[1] as f64)
    }

    /// The indices along one axis that lie within `reach` of `middle`, each once.
    fn indices(&self, axis: usize, middle: usize, reach: usize) -> Vec<usize> {
        let count = self.count[axis];
        if !self.window.periodic[axis] {
            return (middle.saturating_sub(reach)..=(middle + reach).min(count - 1)).collect();
        }
        if 2 * reach + 1 >= count {
            return (0..count).collect();
        }
        (0..=2 * reach).map(|step| (middle + count + step - reach) % count).collect()
    }

    /// The particles of all cells within `reach` cells of that of `point`.
    fn near(&self, point: [f64; 2], reach: usize) -> impl Iterator<Item = usize> {
        let middle = self.cell(point);
        let columns = self.indices(0, middle[0], reach);
        let rows = self.indices(1, middle[1], reach);
        let cells = rows.into_iter().flat_map(move |row| columns.clone().into_iter().map(move |column| [column, row]));
        cells.flat_map(move |cell| {
            let place = self.flat(cell);
            self.order[self.start[place]..self.start[place + 1]].iter().copied()
        })
    }
}

/// Every particle has a place and a value, and there is one at least.
fn check(points: &[[f64; 2]], values: &[f64], window: &Window) -> Result<(), ReportError> {
    window.check()?;
    unless(!points.is_empty(), || "particles".into(), "there are none to make a field of")?;
    unless(points.len() == values.len(), || "particles".into(), "there must be one value a particle")?;
    for (place, (point, value)) in points.iter().zip(values).enumerate() {
        finite(point[0], || format!("particles[{place}].x"))?;
        finite(point[1], || format!("particles[{place}].y"))?;
        finite(*value, || format!("particles[{place}].value"))?;
    }
    Ok(())
}

/// The value of the particle nearest to a point; every point has one.
///
/// # Errors
/// [`ReportError::NotFinite`] for a place or value that is no number, [`ReportError::Inconsistent`] for no particles, another number of
/// values, or an empty window.
pub fn nearest<'a>(
    points: &'a [[f64; 2]],
    values: &'a [f64],
    window: Window,
) -> Result<impl Fn([f64; 2]) -> Option<f64> + 'a, ReportError> {
    check(points, values, &window)?;
    let cells = Cells::new(points, window);
    Ok(move |at: [f64; 2]| {
        let distance = |&particle: &usize| window.distance_squared(cells.points[particle], at);
        let farthest = cells.count[0].max(cells.count[1]);
        let mut reach = 1;
        loop {
            let best = cells.near(at, reach).min_by(|one, other| distance(one).total_cmp(&distance(other)));
            // What lies beyond these cells is farther than `reach` of them.
            let safe = reach as f64 * cells.cell_side();
            if best.is_some_and(|best| distance(&best) <= safe * safe) || reach >= farthest {
                return best.map(|best| values[best]);
            }
            reach *= 2;
        }
    })
}

/// The mean of the particles around a point, weighted with a kernel; nothing where none reaches.
///
/// The weight of particle b at distance r is `kernel(r / lengths[b])`, zero from `support` on. It is divided by the sum of weights, so the
/// kernel needs no normalisation; and where each particle has the same number of neighbours, it is the usual V_b W(r, h_b), whose
/// powers of h cancel.
///
/// # Errors
/// Those of [`nearest`], and the same for lengths and support that are not above zero.
pub fn smoothed<'a>(
    points: &'a [[f64; 2]],
    values: &'a [f64],
    lengths: &'a [f64],
    window: Window,
    kernel: impl Fn(f64) -> f64 + 'a,
    support: f64,
) -> Result<impl Fn([f64; 2]) -> Option<f64> + 'a, ReportError> {
    check(points, values, &window)?;
    unless(points.len() == lengths.len(), || "particles".into(), "there must be one length a particle")?;
    let positive = |value: f64, path: &dyn Fn() -> String| {
        finite(value, path)?;
        unless(value > 0.0, path, "it must be above zero")
    };
    positive(support, &|| "support".into())?;
    for (place, &length) in lengths.iter().enumerate() {
        positive(length, &|| format!("particles[{place}].length"))?;
    }
    let cells = Cells::new(points, window);
    let longest = lengths.iter().copied().fold(0.0, f64::max);
    // No further than from end to end.
    let reach = ((support * longest / cells.cell_side()).ceil() as usize).min(cells.count[0].max(cells.count[1]));
    Ok(move |at: [f64; 2]| {
        let (mut sum, mut weights) = (0.0, 0.0);
        for particle in cells.near(at, reach) {
            let q = window.distance_squared(points[particle], at).sqrt() / lengths[particle];
            if q < support {
                let weight = kernel(q);
                (sum, weights) = (sum + weight * values[particle], weights + weight);
            }
        }
        (weights > 0.0).then(|| sum / weights)
    })
}
