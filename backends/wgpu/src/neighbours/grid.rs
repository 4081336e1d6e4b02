//! The cells into which the neighbour search sorts the particles.

use bytemuck::NoUninit;

use super::programs::Programs;
use crate::drift::four;
use crate::scan::Scan;
use crate::sort::SegmentSort;
use crate::{Device, Result, Torus};

/// Width of a cell in units of the smallest support radius, by dimension. With smaller cells fewer candidates are tested, but
/// more cells are walked; measured in 3-D, anything from 0.5 to 0.7 is as good.
const WIDTH_PER_REACH: [f64; 3] = [1.0, 0.7, 0.6];

/// Cells per particle at most, which bounds the memory in boxes that are mostly empty.
const CELLS_PER_PARTICLE: f64 = 4.0;

/// Cells along an axis at most, so that cell numbers are exact in f32.
const LARGEST_NUMBER: f64 = 16_777_216.0;

/// How far the smallest support radius may run from the planned one before the cells are planned anew.
const DRIFT_OF_REACH: f32 = 1.25;

/// How many cells there are, and for which support radius they were made.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Plan {
    /// Cells along each axis, 1 beyond the dimension.
    pub cells: [u32; 3],
    reach: f32,
}

impl Plan {
    /// Cells for `count` particles on a torus, the smallest of whose support radii is `reach` (positive and finite).
    pub fn new(torus: &Torus, count: usize, reach: f32) -> Self {
        let dimension = torus.dimension();
        let width = WIDTH_PER_REACH[dimension - 1] * f64::from(reach);
        let most = (CELLS_PER_PARTICLE * count as f64).max(64.0);
        let mut numbers: Vec<f64> =
            torus.lengths().iter().map(|length| (length / width).clamp(1.0, LARGEST_NUMBER)).collect();
        // Too many: coarsen all axes alike, which axes already at one cell cannot follow; hence more than once.
        for _ in 0..dimension {
            let total: f64 = numbers.iter().product();
            let coarser =
                (most / total).min(1.0).powf(1.0 / numbers.iter().filter(|n| **n > 1.0).count().max(1) as f64);
            for number in &mut numbers {
                *number = (*number * coarser).max(1.0);
            }
        }
        let mut cells = [1; 3];
        for (cell, number) in cells.iter_mut().zip(numbers) {
            *cell = number as u32;
        }
        Self { cells, reach }
    }

    /// Whether the cells still suit the smallest support radius. They are right in any case, only slower.
    pub fn suits(&self, reach: f32) -> bool {
        reach < self.reach * DRIFT_OF_REACH && reach > self.reach / DRIFT_OF_REACH
    }

    fn total(&self) -> u32 {
        // Within `most`, which is below 2^32 for any number of particles that fits a buffer.
        self.cells.iter().product()
    }
}

#[derive(Clone, Copy, NoUninit)]
#[repr(C)]
pub(super) struct SearchParameters {
    pub count: u32,
    pub cell_total: u32,
    pub capacity: u32,
    pub first_reach: u32,
    pub cells: [u32; 4],
    pub length_per_unit: [f32; 4],
    pub cell_width: [f32; 4],
}

/// The buffers of the cells, and what is bound to them. Made anew when the plan changes.
#[derive(Debug)]
pub(super) struct Grid {
    pub plan: Plan,
    pub total: u32,
    pub parameters: wgpu::Buffer,
    pub counts: wgpu::Buffer,
    pub reach: wgpu::Buffer,
    pub start: wgpu::Buffer,
    pub scan: Scan,
    pub sort: SegmentSort,
    pub cells: wgpu::BindGroup,
    /// One widening per axis, each reading what the one before wrote.
    pub windows: Vec<wgpu::BindGroup>,
    /// Where the last widening wrote: how far to look from each cell.
    pub search_reach: wgpu::Buffer,
}

/// The buffers that a grid is bound to.
pub(super) struct GridInputs<'a> {
    pub torus: &'a Torus,
    pub count: u32,
    pub first_reach: u32,
    pub coordinates: &'a wgpu::Buffer,
    pub fields: &'a wgpu::Buffer,
    pub order: &'a wgpu::Buffer,
    pub packed: &'a wgpu::Buffer,
    pub reach_extremes: &'a wgpu::Buffer,
}

impl Grid {
    pub fn new(device: &Device, programs: &Programs, inputs: &GridInputs<'_>, plan: Plan) -> Result<Self> {
        let total = plan.total();
        let bytes = 4 * u64::from(total);
        let counts = device.storage("the cells' counts", bytes + 4)?;
        let start = device.storage("the cells' places", bytes + 4)?;
        let reach = device.storage("the cells' support radii", bytes)?;
        let widened = device.storage("the cells' search radii", bytes)?;

        let lengths = inputs.torus.lengths();
        let width = |axis: usize| lengths.get(axis).map_or(1.0, |length| length / f64::from(plan.cells[axis])) as f32;
        let parameters = device.uniform(
            "the parameters of the search",
            &SearchParameters {
                count: inputs.count,
                cell_total: total,
                capacity: 0,
                first_reach: inputs.first_reach,
                cells: [plan.cells[0], plan.cells[1], plan.cells[2], 1],
                length_per_unit: four(inputs.torus.length_per_unit()),
                cell_width: [width(0), width(1), width(2), 1.0],
            },
        )?;

        let cells = programs.cells.bind(
            device,
            &[inputs.coordinates, inputs.fields, &counts, &reach, &start, inputs.order, inputs.packed, &parameters],
        )?;
        let (mut source, mut target) = (reach.clone(), widened);
        let mut windows = Vec::new();
        for axis in 0..inputs.torus.dimension() as u32 {
            let along = device.uniform("an axis", &[axis, 0, 0, 0])?;
            windows
                .push(programs.window.bind(device, &[&source, &target, inputs.reach_extremes, &parameters, &along])?);
            std::mem::swap(&mut source, &mut target);
        }
        Ok(Self {
            scan: programs.scanner.scan(device, &start, total + 1)?,
            sort: programs.sorter.sort(device, &start, inputs.order, total, inputs.count)?,
            plan,
            total,
            parameters,
            counts,
            reach,
            start,
            cells,
            windows,
            search_reach: source,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn planned(lengths: &[f64], count: usize, reach: f32) -> [u32; 3] {
        Plan::new(&Torus::new(lengths).unwrap(), count, reach).cells
    }

    #[test]
    fn cells_follow_the_reach_and_stay_few() {
        assert_eq!(planned(&[1.0], 1000, 0.01), [100, 1, 1]);
        assert_eq!(planned(&[1.0, 1.0, 1.0], 1_000_000, 0.02), [83, 83, 83]);
        // A reach beyond the torus: one cell.
        assert_eq!(planned(&[1.0, 1.0], 10, 5.0), [1, 1, 1]);
        // A tiny reach in a large empty box: as many cells as the particles allow, never more.
        for (lengths, count) in
            [(&[1.0, 1.0, 1.0][..], 1000), (&[100.0, 1e-3, 1e-3], 1000), (&[1e6], 50), (&[1.0, 1e-6], 77)]
        {
            let cells = planned(lengths, count, 1e-6);
            let total: u64 = cells.iter().map(|n| u64::from(*n)).product();
            assert!(total <= 4 * count as u64 && total >= 1, "{lengths:?} {cells:?}");
            assert!(total >= count as u64 / 2, "{lengths:?}: only {cells:?} for {count} particles");
        }
    }

    #[test]
    fn a_plan_lasts_while_the_reach_stays_near() {
        let plan = Plan::new(&Torus::new(&[1.0]).unwrap(), 100, 0.1);
        assert!(plan.suits(0.1) && plan.suits(0.12) && plan.suits(0.085));
        assert!(!plan.suits(0.13) && !plan.suits(0.07));
    }
}
