//! The kernels of the neighbour search, compiled once for a dimension.

use crate::program::{Program, Slot};
use crate::reduce::Reducer;
use crate::scan::Scanner;
use crate::sort::SegmentSorter;
use crate::{Device, Result, wgsl};

pub(super) const BIN: usize = 0;
pub(super) const SCATTER: usize = 1;
pub(super) const PACK: usize = 2;
pub(super) const COUNT: usize = 0;
pub(super) const FILL: usize = 1;

#[derive(Debug)]
pub(super) struct Programs {
    pub cells: Program<3>,
    pub window: Program<1>,
    pub list: Program<2>,
    pub scanner: Scanner,
    pub sorter: SegmentSorter,
    pub reducer: Reducer,
}

impl Programs {
    pub fn new(device: &Device, dimension: usize) -> Result<Self> {
        use Slot::{Read, ReadWrite, Uniform};
        let text = |kernels| wgsl::assemble(dimension, &[wgsl::SEARCH_PARAMETERS, kernels]);
        let cells = [Read, Read, ReadWrite, ReadWrite, Read, ReadWrite, ReadWrite, Uniform];
        let window = [Read, ReadWrite, Read, Uniform, Uniform];
        let list = [Read, Read, Read, Read, ReadWrite, ReadWrite, Uniform];
        Ok(Self {
            cells: Program::new(device, "cells", &text(wgsl::CELLS), &cells, ["bin", "scatter", "pack"])?,
            window: Program::new(device, "window", &text(wgsl::WINDOW), &window, ["window"])?,
            list: Program::new(device, "list", &text(wgsl::LIST), &list, ["count", "fill"])?,
            scanner: Scanner::new(device)?,
            sorter: SegmentSorter::new(device)?,
            reducer: Reducer::new(device)?,
        })
    }
}
