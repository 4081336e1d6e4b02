//! Particles of equal mass filling a tube with two densities.

use crate::schemes::Kernel;

/// A tube along x from 0 to 1, periodic across, with a left and a right density that meet at a given place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tube {
    /// Where the two sides meet.
    pub interface: f64,
    /// Its width along every other axis.
    pub width: f64,
    /// Density left and right.
    pub density: [f64; 2],
}

/// One side of a tube: how the lattice lies there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Side {
    /// Spacing along the tube.
    pub along: f64,
    /// Particles across, along each other axis.
    pub across: usize,
}

impl Tube {
    /// The two lattices with about `count` particles in all, and the mass that all particles share.
    ///
    /// On the left the lattice is as nearly cubic as whole numbers allow and ends exactly at both ends. On the right the spacing
    /// across is the nearest that fits the width, and the spacing along makes the density exact.
    pub fn sides<const D: usize>(&self, count: usize) -> ([Side; 2], f64) {
        let across_axes = (D - 1) as i32;
        let area = self.width.powi(across_axes);
        let lengths = [self.interface, 1.0 - self.interface];
        let share = self.density[0] * lengths[0] / (self.density[0] * lengths[0] + self.density[1] * lengths[1]);
        let wanted = count as f64 * share;
        let spacing = (lengths[0] * area / wanted).powf(1.0 / D as f64);
        let fit = |spacing: f64, length: f64| ((length / spacing).round() as usize).max(1);

        let along = lengths[0] / fit(spacing, lengths[0]) as f64;
        let across = if D == 1 { 1 } else { fit(along, self.width) };
        let left = Side { along, across };
        let mass = self.density[0] * along * (self.width / across as f64).powi(across_axes);

        let right_spacing = (mass / self.density[1]).powf(1.0 / D as f64);
        let across = if D == 1 { 1 } else { fit(right_spacing, self.width) };
        let along = mass / (self.density[1] * (self.width / across as f64).powi(across_axes));
        ([left, Side { along, across }], mass)
    }

    /// The lattice of one side: every place from the interface outwards to `depth` beyond the tube's end.
    pub fn places<const D: usize>(&self, side: usize, lattice: Side, depth: f64) -> Vec<[f64; D]> {
        let (direction, length) = if side == 0 { (-1.0, self.interface) } else { (1.0, 1.0 - self.interface) };
        let columns = ((length + depth) / lattice.along).round() as usize;
        let step = self.width / lattice.across as f64;
        let per_column = lattice.across.pow(D as u32 - 1);
        let place = |column: usize, row: usize| {
            std::array::from_fn(|axis| match axis {
                0 => self.interface + direction * (column as f64 + 0.5) * lattice.along,
                _ => ((row / lattice.across.pow(axis as u32 - 1) % lattice.across) as f64 + 0.5) * step,
            })
        };
        (0..columns).flat_map(|column| (0..per_column).map(move |row| place(column, row))).collect()
    }
}

/// How deep the fixed layers beyond a tube's end are, with the smoothing length there: more than a support and what a particle at the end moves.
pub(super) fn wall_depth(kernel: Kernel, h: f64) -> f64 {
    WALL.max(2.0 * kernel.support()) * h
}

/// The least depth of fixed layers, in smoothing lengths.
const WALL: f64 = 4.0;

#[cfg(test)]
mod tests {
    use super::*;

    const TUBE: Tube = Tube { interface: 0.5, width: 0.125, density: [1.0, 0.125] };

    /// Mass is density times volume on either side; the left lattice divides its length exactly.
    fn masses_are_right<const D: usize>(count: usize) {
        let (sides, mass) = TUBE.sides::<D>(count);
        let area = TUBE.width.powi(D as i32 - 1);
        let mut total = 0;
        for (side, lattice) in sides.into_iter().enumerate() {
            let places = TUBE.places::<D>(side, lattice, 0.0);
            total += places.len();
            let volume_each = lattice.along * area / lattice.across.pow(D as u32 - 1) as f64;
            let density = mass / volume_each;
            assert!((density / TUBE.density[side] - 1.0).abs() < 1e-12, "{D}-D side {side}: density {density}");
        }
        // Whole numbers of rows and columns: one row too many or too few on each axis at worst.
        assert!((total as f64 / count as f64 - 1.0).abs() < 0.35, "{D}-D: {total} particles for {count}");
    }

    #[test]
    fn the_tube_holds_the_mass_it_should() {
        masses_are_right::<1>(450);
        masses_are_right::<2>(5_000);
        masses_are_right::<3>(20_000);
    }

    #[test]
    fn no_two_places_coincide_and_the_sides_do_not_overlap() {
        let (sides, _) = TUBE.sides::<2>(500);
        let left = TUBE.places::<2>(0, sides[0], 0.1);
        let right = TUBE.places::<2>(1, sides[1], 0.1);
        assert!(left.iter().all(|p| p[0] < 0.5) && right.iter().all(|p| p[0] > 0.5));
        for places in [left, right] {
            let mut keys: Vec<_> = places.iter().map(|p| p.map(f64::to_bits)).collect();
            keys.sort_unstable();
            keys.dedup();
            assert_eq!(keys.len(), places.len());
        }
    }
}
