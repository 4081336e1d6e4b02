//! The neighbour search on the device.
//!
//! For particle i all j != i with |r_i - r_j|^2 < max(reach_i, reach_j)^2, where reach is the support radius of the kernel:
//! a pair acts if it lies within the support of either particle. Coincident particles are neighbours. The lists are in the
//! compressed-row form (offsets and one long list) and ascending in j, so that they are a function of the particles alone:
//! neither the cells nor the order in which the threads ran can be seen in them, and sums over them are the same bits at
//! every run.
//!
//! The steps of one build, all on the device: extremes of the reach; sort into cells (`cells.wgsl`); how far to look from
//! each cell (`window.wgsl`: only the cells near a particle of large reach look far, so a dense region pays nothing for a
//! sparse one elsewhere); count, scan, fill (`list.wgsl`), sort. The host reads three words back.

mod grid;
mod programs;

use self::grid::{Grid, GridInputs, Plan};
use self::programs::{BIN, COUNT, FILL, PACK, Programs, SCATTER};
use crate::reduce::Reduction;
use crate::scan::Scan;
use crate::sort::SegmentSort;
use crate::transfer::Region;
use crate::{Coordinates, Device, Error, FieldStore, Result, Timer};

/// Byte offset of `capacity` in the search's parameters.
const CAPACITY_OFFSET: u64 = 8;

/// List entries per particle to begin with; the list grows as needed.
const FIRST_CAPACITY: u64 = 48;

/// What a build found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SearchSummary {
    /// Entries in all lists together: every pair counts twice.
    pub entries: u32,
    /// The smallest support radius.
    pub smallest_reach: f32,
    /// The largest support radius.
    pub largest_reach: f32,
}

/// The lists on the device.
#[derive(Debug)]
pub struct Lists {
    pub(crate) offsets: wgpu::Buffer,
    pub(crate) list: wgpu::Buffer,
    pub(crate) order: wgpu::Buffer,
    capacity: u32,
    generation: u64,
    count: usize,
}

impl Lists {
    /// Changes whenever the list had to move to a larger buffer: what is bound to it must then be bound anew.
    pub fn generation(&self) -> u64 {
        self.generation
    }

    /// Entries for which there is room.
    pub fn capacity(&self) -> u32 {
        self.capacity
    }

    /// Fails unless the coordinates are of as many particles.
    pub(crate) fn check_matches(&self, coordinates: &Coordinates) -> Result<()> {
        if coordinates.count() == self.count {
            Ok(())
        } else {
            let (expected, found) = (coordinates.count(), self.count);
            Err(Error::CountMismatch { what: "the neighbour search", expected, found })
        }
    }

    /// Offsets (one per particle and the total) and list entries of the last build; waits for the device.
    ///
    /// # Errors
    /// [`Error::DeviceLost`] if it was.
    pub fn download(&self, device: &Device) -> Result<(Vec<u32>, Vec<u32>)> {
        let bytes = 4 * (self.count as u64 + 1);
        let offsets: Vec<u32> = device.read(&[Region { buffer: &self.offsets, offset: 0, bytes }])?;
        let entries = u64::from(offsets[self.count]).min(u64::from(self.capacity));
        let list = device.read(&[Region { buffer: &self.list, offset: 0, bytes: 4 * entries }])?;
        Ok((offsets, list))
    }

    /// The particles in the order of the cells, each cell's ascending; waits for the device.
    ///
    /// # Errors
    /// [`Error::DeviceLost`] if it was.
    pub fn download_order(&self, device: &Device) -> Result<Vec<u32>> {
        device.read(&[Region { buffer: &self.order, offset: 0, bytes: 4 * self.count as u64 }])
    }
}

/// Builds neighbour lists for the particles of a pair of stores.
#[derive(Debug)]
pub struct NeighbourSearch {
    programs: Programs,
    coordinates: Coordinates,
    fields: FieldStore,
    first_reach: u32,
    reach: Reduction,
    packed: wgpu::Buffer,
    lists: Lists,
    offsets_scan: Scan,
    grid: Option<Grid>,
    bound: Option<BoundList>,
}

/// What depends on the grid and on the list's buffer.
#[derive(Debug)]
struct BoundList {
    list: wgpu::BindGroup,
    sort: SegmentSort,
}

impl NeighbourSearch {
    /// Prepares the search among the particles at `coordinates` whose support radius is `reach_component` of `fields`.
    ///
    /// # Errors
    /// [`Error::CountMismatch`], [`Error::NoSuchIndex`], [`Error::TooLarge`], [`Error::Shader`], [`Error::OutOfMemory`] or
    /// [`Error::DeviceLost`].
    pub fn new(
        device: &Device,
        coordinates: &Coordinates,
        fields: &FieldStore,
        reach_component: usize,
    ) -> Result<Self> {
        coordinates.check_matches(fields)?;
        let count = coordinates.count();
        let programs = Programs::new(device, coordinates.torus().dimension())?;
        let bytes = 4 * count as u64;
        let lists = Lists {
            offsets: device.storage("the neighbour lists' places", bytes + 4)?,
            order: device.storage("the cells' particles", bytes)?,
            list: device.storage("the neighbour lists", 0)?,
            capacity: 0,
            generation: 0,
            count,
        };
        Ok(Self {
            first_reach: fields.first(reach_component)?,
            reach: programs.reducer.reduction(device, fields, reach_component)?,
            packed: device.storage("the particles in cell order", 4 * bytes)?,
            offsets_scan: programs.scanner.scan(device, &lists.offsets, count as u32 + 1)?,
            coordinates: coordinates.clone(),
            fields: fields.clone(),
            programs,
            lists,
            grid: None,
            bound: None,
        })
    }

    /// The lists as last built.
    pub fn lists(&self) -> &Lists {
        &self.lists
    }

    /// Cells along each axis in the last build, 1 beyond the dimension; zeros before the first. For reports: the lists do
    /// not depend on it.
    pub fn cells(&self) -> [u32; 3] {
        self.grid.as_ref().map_or([0; 3], |grid| grid.plan.cells)
    }

    /// Builds the lists for the particles as they are now; waits for the device.
    ///
    /// # Errors
    /// [`Error::BadReach`], [`Error::ListTooLong`], [`Error::TooLarge`], [`Error::OutOfMemory`] or [`Error::DeviceLost`].
    pub fn build(&mut self, device: &Device, timer: &mut Timer) -> Result<SearchSummary> {
        self.build_and_read(device, timer, None).map(|(summary, _)| summary)
    }

    /// As [`build`](Self::build), and reads another word back on the same occasion.
    pub(crate) fn build_and_read(
        &mut self,
        device: &Device,
        timer: &mut Timer,
        word: Option<Region<'_>>,
    ) -> Result<(SearchSummary, Option<u32>)> {
        if self.grid.is_none() {
            self.reach.run(device, timer)?;
            let extremes = self.reach.read(device)?;
            check_reach(extremes.smallest, extremes.largest)?;
            self.plan(device, extremes.smallest)?;
            self.grow(device, FIRST_CAPACITY * self.lists.count as u64)?;
        }
        self.search(device, timer)?;
        let (summary, word) = self.summary(device, word)?;
        if summary.entries > self.lists.capacity {
            // A quarter more than needed, so that a slowly growing list does not move at every step.
            self.grow(device, u64::from(summary.entries) * 5 / 4)?;
            self.fill(device, timer)?;
        }
        if !self.grid.as_ref().is_some_and(|grid| grid.plan.suits(summary.smallest_reach)) {
            self.plan(device, summary.smallest_reach)?;
        }
        Ok((summary, word))
    }

    /// Makes the cells for a support radius, for the builds to come.
    fn plan(&mut self, device: &Device, smallest_reach: f32) -> Result<()> {
        let torus = self.coordinates.torus();
        let inputs = GridInputs {
            torus,
            count: self.lists.count as u32,
            first_reach: self.first_reach,
            coordinates: self.coordinates.buffer(),
            fields: self.fields.buffer(),
            order: &self.lists.order,
            packed: &self.packed,
            reach_extremes: self.reach.result(),
        };
        let plan = Plan::new(torus, self.lists.count, smallest_reach);
        self.grid = Some(Grid::new(device, &self.programs, &inputs, plan)?);
        self.bind(device)
    }

    /// Moves the list to a buffer for at least one entry and about `entries`, as far as the adapter can bind them.
    fn grow(&mut self, device: &Device, entries: u64) -> Result<()> {
        let capacity = entries.max(64).min(u64::from(largest_capacity(device)));
        self.bound = None;
        self.lists.list = device.storage("the neighbour lists", 4 * capacity)?;
        self.lists.capacity = capacity as u32;
        self.lists.generation += 1;
        self.bind(device)
    }

    /// Binds the list kernels to the present grid and list.
    fn bind(&mut self, device: &Device) -> Result<()> {
        let Some(grid) = &self.grid else { return Ok(()) };
        let Lists { offsets, list, order, capacity, .. } = &self.lists;
        device.write(&grid.parameters, CAPACITY_OFFSET, &[*capacity])?;
        let buffers = [&self.packed, order, &grid.start, &grid.search_reach, offsets, list, &grid.parameters];
        self.bound = Some(BoundList {
            list: self.programs.list.bind(device, &buffers)?,
            sort: self.programs.sorter.sort(device, offsets, list, self.lists.count as u32, *capacity)?,
        });
        Ok(())
    }

    /// The whole search, as far as the list has room.
    fn search(&self, device: &Device, timer: &mut Timer) -> Result<()> {
        let (Some(grid), Some(bound)) = (&self.grid, &self.bound) else { return Ok(()) };
        let count = self.lists.count as u32;
        let Programs { cells, window, list, .. } = &self.programs;
        device.submit("searching for neighbours", |encoder| {
            self.reach.record(encoder, timer, "cells: extremes");
            // The counts are zero already: the scattering runs them down.
            encoder.clear_buffer(&grid.reach, 0, None);
            cells.dispatch(&mut timer.begin(encoder, "cells: bin"), BIN, &grid.cells, count);
            encoder.copy_buffer_to_buffer(&grid.counts, 0, &grid.start, 0, 4 * (u64::from(grid.total) + 1));
            {
                let mut pass = timer.begin(encoder, "cells: sort");
                grid.scan.record(&mut pass);
                cells.dispatch(&mut pass, SCATTER, &grid.cells, count);
                grid.sort.record(&mut pass);
                cells.dispatch(&mut pass, PACK, &grid.cells, count);
            }
            {
                let mut pass = timer.begin(encoder, "cells: search radius");
                for axis in &grid.windows {
                    window.dispatch(&mut pass, 0, axis, grid.total);
                }
            }
            list.dispatch(&mut timer.begin(encoder, "list: count"), COUNT, &bound.list, count);
            self.offsets_scan.record(&mut timer.begin(encoder, "list: scan"));
            self.record_fill(encoder, timer, bound);
        })
    }

    /// Fills and sorts the lists again, after they have grown.
    fn fill(&self, device: &Device, timer: &mut Timer) -> Result<()> {
        let Some(bound) = &self.bound else { return Ok(()) };
        device.submit("filling the neighbour lists", |encoder| self.record_fill(encoder, timer, bound))
    }

    fn record_fill(&self, encoder: &mut wgpu::CommandEncoder, timer: &mut Timer, bound: &BoundList) {
        let count = self.lists.count as u32;
        self.programs.list.dispatch(&mut timer.begin(encoder, "list: fill"), FILL, &bound.list, count);
        bound.sort.record(&mut timer.begin(encoder, "list: sort"));
    }

    /// Reads back what decides whether the build was good.
    fn summary(&self, device: &Device, word: Option<Region<'_>>) -> Result<(SearchSummary, Option<u32>)> {
        let total = Region { buffer: &self.lists.offsets, offset: 4 * self.lists.count as u64, bytes: 4 };
        let regions: Vec<Region<'_>> = [total, self.reach.region()].into_iter().chain(word).collect();
        let words: Vec<u32> = device.read(&regions)?;
        let summary = SearchSummary {
            entries: words[0],
            smallest_reach: f32::from_bits(words[1]),
            largest_reach: f32::from_bits(words[2]),
        };
        check_reach(summary.smallest_reach, summary.largest_reach)?;
        let limit = largest_capacity(device);
        if summary.entries > limit {
            // The scan stops at the largest number it can hold.
            let entries = Some(summary.entries).filter(|entries| *entries < u32::MAX);
            return Err(Error::ListTooLong { entries, limit });
        }
        Ok((summary, words.get(3).copied()))
    }
}

/// List entries that the adapter can bind, short of the value that stands for "too many to count".
fn largest_capacity(device: &Device) -> u32 {
    u32::try_from(device.largest_binding() / 4).unwrap_or(u32::MAX).min(u32::MAX - 1)
}

fn check_reach(smallest: f32, largest: f32) -> Result<()> {
    if smallest > 0.0 && largest < f32::INFINITY { Ok(()) } else { Err(Error::BadReach { smallest, largest }) }
}
