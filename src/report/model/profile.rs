//! Particles and curves for the plots.

use serde::{Deserialize, Serialize};

/// The exact solution sampled along the scene's coordinate, ready to be drawn as a line.
///
/// A discontinuity is two samples at the same place.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Curve {
    /// Coordinate of each sample, ascending.
    pub x: Vec<f64>,
    /// The fields at those places.
    pub fields: Vec<CurveField>,
}

/// One field of a [`Curve`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CurveField {
    /// Which field.
    pub field: String,
    /// Its value at each sample.
    pub value: Vec<f64>,
}

/// Some particles of a run, enough of them for a plot.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Profile {
    /// How these were chosen from all particles, in a clause.
    pub selection: String,
    /// Coordinate of each particle.
    pub x: Vec<f64>,
    /// The fields of those particles.
    pub fields: Vec<ProfileField>,
}

/// One field of a [`Profile`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ProfileField {
    /// Which field.
    pub field: String,
    /// Its value for each particle of the profile.
    pub value: Vec<f64>,
    /// The exact solution at each particle's place. Empty where there is none.
    pub exact: Vec<f64>,
    /// What the scalar f64 reference has for the same particle. Empty for the reference itself.
    pub reference: Vec<f64>,
}

/// Picks about `limit` particles that show a profile fairly: the range is cut into equal cells, and from each as
/// many are taken, evenly by rank, so that a thin gas is drawn as densely as a thick one and the scatter is kept.
///
/// Returns indices into `x` in ascending order of `x`. Deterministic; at most `limit` of them. Places that are not
/// finite are left out.
pub fn stratified(x: &[f64], limit: usize) -> Vec<usize> {
    /// Particles a cell: enough to show scatter in it.
    const PER_CELL: usize = 4;
    let mut order: Vec<usize> = (0..x.len()).filter(|&i| x[i].is_finite()).collect();
    order.sort_by(|&a, &b| x[a].total_cmp(&x[b]).then(a.cmp(&b)));
    if order.len() <= limit {
        return order;
    }
    let per_cell = PER_CELL.min(limit.max(1));
    let cells = limit / per_cell;
    let (Some(&first), Some(&last)) = (order.first(), order.last()) else { return Vec::new() };
    let width = (x[last] - x[first]) / cells as f64;
    let mut picked = Vec::with_capacity(limit);
    let mut begin = 0;
    for cell in 0..cells {
        // The last cell is closed, so that the last particle belongs to one.
        let end_at = x[first] + width * (cell + 1) as f64;
        let inside = order[begin..].partition_point(|&i| x[i] < end_at);
        let end = if cell + 1 == cells { order.len() } else { begin + inside };
        let members = &order[begin..end];
        let take = members.len().min(per_cell);
        // Middles of `take` equal runs of ranks.
        picked.extend((0..take).map(|k| members[(2 * k + 1) * members.len() / (2 * take)]));
        begin = end;
    }
    picked
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stratified_is_fair_to_thin_gas() {
        // 8000 particles left of 0.5 and 1000 right of it, as in the Sod tube.
        let left = (0..8000).map(|i| 0.5 * f64::from(i) / 8000.0);
        let right = (0..1000).map(|i| 0.5 + 0.5 * f64::from(i) / 1000.0);
        let x: Vec<f64> = left.chain(right).collect();
        let picked = stratified(&x, 400);
        assert_eq!(picked.len(), 400);
        let thin = picked.iter().filter(|&&i| x[i] >= 0.5).count();
        // Equal cells give half to each side; a cell that straddles 0.5 may move a few.
        assert!((196..=204).contains(&thin), "{thin} of 400 in the thin half");
        assert!(picked.is_sorted_by(|&a, &b| x[a] < x[b]), "ascending, none twice");
    }

    #[test]
    fn stratified_survives_degenerate_input() {
        assert_eq!(stratified(&[], 10), Vec::<usize>::new());
        assert_eq!(stratified(&[3.0, 1.0, f64::NAN], 10), vec![1, 0]);
        assert!(stratified(&[1.0; 100], 10).len() <= 10, "all in one place");
        assert!(stratified(&[0.0, 1.0, 2.0], 0).is_empty());
        assert_eq!(stratified(&[0.0, 1.0, 2.0], 1).len(), 1);
    }
}
