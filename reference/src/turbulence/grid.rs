//! Velocities on a regular grid, taken from particles.

use super::error::{TurbulenceError, check_column, check_length};
use super::snapshot::Snapshot;
use crate::domain::separation;
use crate::equations::kernels::{inverse_volume, kernel_shape};
use crate::schemes::Kernel;
use etalon_kernels_gen::Vector;

/// Velocities at the middles of `across^D` cells of a periodic box. Entry `i_x + across (i_y + across i_z)` belongs to cell `(i_x, i_y, i_z)`.
#[derive(Clone, Debug, PartialEq)]
pub struct VelocityGrid<const D: usize> {
    across: usize,
    components: [Vec<f64>; D],
}

impl<const D: usize> VelocityGrid<D> {
    /// Takes velocities from elsewhere.
    ///
    /// # Errors
    /// A grid without points, a component without a value for each, a value that is not finite.
    pub fn from_components(across: usize, components: [Vec<f64>; D]) -> Result<Self, TurbulenceError> {
        let points = points::<D>(across)?;
        for component in &components {
            if component.len() != points {
                let column = "component of the grid's velocities";
                return Err(TurbulenceError::Length { column, found: component.len(), expected: points });
            }
            check_column("grid's velocities", component, false)?;
        }
        Ok(VelocityGrid { across, components })
    }

    /// Every point has the velocity of the nearest particle; of two as near, that of the one with the lower number.
    ///
    /// # Errors
    /// A box that is not a periodic cube, a grid without points.
    pub fn nearest(snapshot: &Snapshot<D>, across: usize) -> Result<Self, TurbulenceError> {
        let points = points::<D>(across)?;
        let side = snapshot.periodic_side()?;
        let mut residents = vec![Vec::new(); points];
        for particle in 0..snapshot.len() {
            let cell = snapshot.coordinates(particle).map(|x| ((x as u128 * across as u128) >> 64) as usize);
            residents[index(cell, across)].push(particle);
        }
        let velocity = |point: usize| {
            let cell = cell_of::<D>(point, across);
            let distance = |particle: usize| squared_distance(snapshot, particle, cell, across, side);
            let mut best = (f64::INFINITY, 0);
            for ring in 0..=across / 2 {
                for other in cells_of_ring(cell, ring, across) {
                    for &particle in &residents[index(other, across)] {
                        let found = (distance(particle), particle);
                        if found.0 < best.0 || (found.0 == best.0 && found.1 < best.1) {
                            best = found;
                        }
                    }
                }
                // What has not been looked at is at least so many and a half cells away.
                if best.0 < ((ring as f64 + 0.5) * side / across as f64).powi(2) {
                    break;
                }
            }
            snapshot.velocity(best.1)
        };
        Ok(Self::collect(across, (0..points).map(velocity)))
    }

    /// Every point has the mean of the velocities around it, `sum V_b v_b W(h_b) / sum V_b W(h_b)`: a uniform velocity stays what it is.
    ///
    /// Structure smaller than the support is smoothed away, and its power with it.
    ///
    /// # Errors
    /// A box that is not a periodic cube, a grid without points, smoothing lengths or volumes that are not positive, not one for each particle,
    /// or whose support is larger than half the box; points that no particle reaches.
    pub fn smoothed(
        snapshot: &Snapshot<D>,
        kernel: Kernel,
        smoothing_length: &[f64],
        volume: &[f64],
        across: usize,
    ) -> Result<Self, TurbulenceError> {
        let points = points::<D>(across)?;
        let side = snapshot.periodic_side()?;
        for (column, values) in [("smoothing lengths", smoothing_length), ("volumes", volume)] {
            check_length(column, values.len(), snapshot.len())?;
            check_column(column, values, true)?;
        }
        if let Some(index) = smoothing_length.iter().position(|h| 2.0 * kernel.support() * h > side) {
            let rule = "a support must fit into the box: use more particles or fewer neighbours";
            let value = smoothing_length[index];
            return Err(TurbulenceError::Value { column: "smoothing lengths", index, value, rule });
        }
        let mut sums = vec![(Vector::<f64, D>::zero(), 0.0); points];
        for particle in 0..snapshot.len() {
            let h = smoothing_length[particle];
            let velocity = snapshot.velocity(particle);
            let reach = (kernel.support() * h / side * across as f64) as usize + 1;
            let home = snapshot.coordinates(particle).map(|x| ((x as u128 * across as u128) >> 64) as usize);
            for cell in block(home, reach, across) {
                let q_squared = squared_distance(snapshot, particle, cell, across, side) / (h * h);
                let shape = kernel_shape::<f64, D>(kernel, q_squared).value;
                let weight = volume[particle] * shape * inverse_volume::<f64, D>(1.0 / h);
                let sum = &mut sums[index(cell, across)];
                *sum = (sum.0 + velocity.scale(weight), sum.1 + weight);
            }
        }
        let empty = sums.iter().filter(|(_, weight)| *weight <= 0.0).count();
        if empty > 0 {
            return Err(TurbulenceError::OutOfReach { points: empty });
        }
        Ok(Self::collect(across, sums.into_iter().map(|(sum, weight)| sum.scale(1.0 / weight))))
    }

    fn collect(across: usize, velocities: impl Iterator<Item = Vector<f64, D>>) -> Self {
        let mut components: [Vec<f64>; D] = std::array::from_fn(|_| Vec::new());
        for velocity in velocities {
            components.iter_mut().enumerate().for_each(|(axis, component)| component.push(velocity[axis]));
        }
        VelocityGrid { across, components }
    }

    /// Points along each side.
    pub fn across(&self) -> usize {
        self.across
    }
    /// One component of the velocity, by point.
    pub fn component(&self, axis: usize) -> &[f64] {
        &self.components[axis]
    }
}

/// How many points such a grid has.
fn points<const D: usize>(across: usize) -> Result<usize, TurbulenceError> {
    match across.checked_pow(D as u32) {
        Some(points) if points > 0 && points <= 1 << 32 => Ok(points),
        _ => {
            let rule = "take at least one, and no more than 2^32 points in all";
            Err(TurbulenceError::Parameter { name: "number of grid points a side", value: across as f64, rule })
        }
    }
}

fn index<const D: usize>(cell: [usize; D], across: usize) -> usize {
    cell.iter().rev().fold(0, |index, &i| index * across + i)
}

fn cell_of<const D: usize>(point: usize, across: usize) -> [usize; D] {
    std::array::from_fn(|axis| point / across.pow(axis as u32) % across)
}

/// The fixed-point coordinate of a cell's middle.
fn middle(i: usize, across: usize) -> u64 {
    (((2 * i as u128 + 1) << 63) / across as u128) as u64
}

fn squared_distance<const D: usize>(
    snapshot: &Snapshot<D>,
    particle: usize,
    cell: [usize; D],
    across: usize,
    side: f64,
) -> f64 {
    let place = snapshot.coordinates(particle);
    (0..D).map(|axis| separation(place[axis], middle(cell[axis], across), side).powi(2)).sum()
}

/// The cells at most `reach` away along every axis, each once.
fn block<const D: usize>(home: [usize; D], reach: usize, across: usize) -> impl Iterator<Item = [usize; D]> {
    let wide = (2 * reach + 1).min(across);
    // Not below zero: `reach` whole turns forward first.
    let first = home.map(|i| i + across * reach - reach);
    (0..wide.pow(D as u32))
        .map(move |offset| std::array::from_fn(|axis| (first[axis] + offset / wide.pow(axis as u32) % wide) % across))
}

/// The cells exactly `ring` away along the axis where they are farthest.
fn cells_of_ring<const D: usize>(home: [usize; D], ring: usize, across: usize) -> impl Iterator<Item = [usize; D]> {
    let away = move |cell: [usize; D]| {
        let along = |axis: usize| {
            let ahead = (cell[axis] + across - home[axis]) % across;
            ahead.min(across - ahead)
        };
        (0..D).map(along).max().unwrap_or(0)
    };
    block(home, ring, across).filter(move |&cell| away(cell) == ring)
}
