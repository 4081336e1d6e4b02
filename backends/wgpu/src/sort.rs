//! Sorting many short segments, each by itself.

use bytemuck::NoUninit;

use crate::program::{Program, Slot};
use crate::{Device, Result, wgsl};

#[derive(Clone, Copy, NoUninit)]
#[repr(C)]
struct SortParameters {
    segments: u32,
    capacity: u32,
    padding: [u32; 2],
}

/// The kernel, compiled once.
#[derive(Debug, Clone)]
pub(crate) struct SegmentSorter {
    program: Program<1>,
}

/// Sorts the segments `values[starts[s]..starts[s + 1]]` ascending.
#[derive(Debug)]
pub(crate) struct SegmentSort {
    program: Program<1>,
    bound: wgpu::BindGroup,
    segments: u32,
}

impl SegmentSorter {
    pub fn new(device: &Device) -> Result<Self> {
        let slots = [Slot::Read, Slot::ReadWrite, Slot::Uniform];
        let text = wgsl::assemble(1, &[wgsl::SORT_SEGMENTS]);
        Ok(Self { program: Program::new(device, "sort_segments", &text, &slots, ["sort_segments"])? })
    }

    /// Prepares the sort of `segments` segments, of which those that end beyond `capacity` are left alone.
    pub fn sort(
        &self,
        device: &Device,
        starts: &wgpu::Buffer,
        values: &wgpu::Buffer,
        segments: u32,
        capacity: u32,
    ) -> Result<SegmentSort> {
        let parameters =
            device.uniform("the segments of a sort", &SortParameters { segments, capacity, padding: [0; 2] })?;
        let bound = self.program.bind(device, &[starts, values, &parameters])?;
        Ok(SegmentSort { program: self.program.clone(), bound, segments })
    }
}

impl SegmentSort {
    pub fn record(&self, pass: &mut wgpu::ComputePass<'_>) {
        self.program.dispatch(pass, 0, &self.bound, self.segments);
    }
}
