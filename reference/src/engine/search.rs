//! Neighbours by a plain cell grid, and by brute force to check it.

use crate::domain::separation;

/// For each particle, the numbers of the others within reach.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct PlainNeighbours {
    start: Vec<usize>,
    members: Vec<u32>,
}

impl PlainNeighbours {
    /// The neighbours of one particle, in ascending order.
    pub fn of(&self, particle: usize) -> &[u32] {
        &self.members[self.start[particle]..self.start[particle + 1]]
    }
    /// For how many particles neighbours were found.
    pub fn particles(&self) -> usize {
        self.start.len().saturating_sub(1)
    }
    /// How many pairs there are, each counted from both ends.
    pub fn pair_count(&self) -> usize {
        self.members.len()
    }

    fn push(&mut self, mut list: Vec<u32>) {
        list.sort_unstable();
        self.members.append(&mut list);
        self.start.push(self.members.len());
    }

    /// Sorts the particles into cells, looks from each into the cells within its own reach, and tells those it finds there.
    ///
    /// `reach` is the support radius of each particle; a pair are neighbours if they are closer than the larger reach of the two.
    pub fn find<const D: usize>(coordinates: &[Vec<u64>; D], reach: &[f64], length: [f64; D]) -> Self {
        let count = reach.len();
        let edge = cell_edge(reach);
        let cells: [usize; D] = std::array::from_fn(|axis| ((length[axis] / edge) as usize).clamp(1, 1 << (60 / D)));
        let cell_of = |particle: usize| -> [usize; D] {
            std::array::from_fn(|axis| ((coordinates[axis][particle] as u128 * cells[axis] as u128) >> 64) as usize)
        };
        let key = |cell: [usize; D]| cell.iter().zip(cells).fold(0, |key, (&c, n)| key * n + c);
        let mut sorted: Vec<(usize, u32)> = (0..count).map(|i| (key(cell_of(i)), i as u32)).collect();
        sorted.sort_unstable();

        let mut lists = vec![Vec::new(); count];
        for a in 0..count {
            let home = cell_of(a);
            // So many cells to either side, but no axis is gone round twice.
            let far: [usize; D] =
                std::array::from_fn(|axis| (reach[a] / length[axis] * cells[axis] as f64) as usize + 1);
            let wide: [usize; D] = std::array::from_fn(|axis| (2 * far[axis] + 1).min(cells[axis]));
            for offset in 0..wide.iter().product() {
                let mut rest = offset;
                let cell = std::array::from_fn(|axis| {
                    let step = rest % wide[axis];
                    rest /= wide[axis];
                    (home[axis] + step + (cells[axis] - 1) * far[axis]) % cells[axis]
                });
                let wanted = key(cell);
                let from = sorted.partition_point(|&(k, _)| k < wanted);
                for &(_, b) in sorted[from..].iter().take_while(|&&(k, _)| k == wanted) {
                    let r_squared = distance_squared(coordinates, length, a, b as usize);
                    if a != b as usize && r_squared < reach[a].powi(2) {
                        lists[a].push(b);
                        // A neighbour that reaches as far finds this particle by itself.
                        if r_squared >= reach[b as usize].powi(2) {
                            lists[b as usize].push(a as u32);
                        }
                    }
                }
            }
        }
        let mut found = PlainNeighbours { start: vec![0], members: Vec::new() };
        lists.into_iter().for_each(|list| found.push(list));
        found
    }
}

/// Cells as wide as the middle reach, which suits a gas of two densities; no less than a quarter of the largest, so that nobody
/// looks into more than some hundred cells.
fn cell_edge(reach: &[f64]) -> f64 {
    let mut sorted = reach.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    let middle = sorted.get(reach.len() / 2).copied().unwrap_or(1.0);
    let largest = sorted.last().copied().unwrap_or(1.0);
    middle.max(0.25 * largest)
}

/// Neighbours by looking at every pair.
pub fn brute_force<const D: usize>(coordinates: &[Vec<u64>; D], reach: &[f64], length: [f64; D]) -> PlainNeighbours {
    let mut found = PlainNeighbours { start: vec![0], members: Vec::new() };
    for a in 0..reach.len() {
        found.push((0..reach.len() as u32).filter(|&b| near(coordinates, reach, length, a, b as usize)).collect());
    }
    found
}

fn near<const D: usize>(coordinates: &[Vec<u64>; D], reach: &[f64], length: [f64; D], a: usize, b: usize) -> bool {
    a != b && distance_squared(coordinates, length, a, b) < reach[a].max(reach[b]).powi(2)
}

fn distance_squared<const D: usize>(coordinates: &[Vec<u64>; D], length: [f64; D], a: usize, b: usize) -> f64 {
    (0..D).map(|axis| separation(coordinates[axis][a], coordinates[axis][b], length[axis]).powi(2)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]
        #[test]
        fn the_grid_finds_what_brute_force_finds(
            points in prop::collection::vec((any::<u64>(), any::<u64>(), 0.01..0.4_f64), 1..60),
            length in 0.9..3.0_f64,
        ) {
            let coordinates = [points.iter().map(|p| p.0).collect(), points.iter().map(|p| p.1).collect::<Vec<_>>()];
            let reach: Vec<f64> = points.iter().map(|p| p.2).collect();
            let found = PlainNeighbours::find(&coordinates, &reach, [length, 1.0]);
            prop_assert_eq!(found, brute_force(&coordinates, &reach, [length, 1.0]));
        }
    }

    #[test]
    fn coincident_particles_are_neighbours_and_a_lone_one_has_none() {
        let coordinates = [vec![5, 5, u64::MAX / 2]];
        let found = PlainNeighbours::find(&coordinates, &[0.1, 0.1, 0.1], [1.0]);
        assert_eq!((found.of(0), found.of(1), found.of(2)), (&[1][..], &[0][..], &[][..]));
    }
}
