//! The smallest and the largest of a component, the same bits at every run: what a time step is made of.

use bytemuck::NoUninit;

use crate::program::{Program, Slot};
use crate::transfer::Region;
use crate::{Device, FieldStore, Result, Timer, wgsl};

/// Workgroups of the first stage; the second stage is one workgroup that joins their results.
const LARGEST_STAGE: u32 = 256;

#[derive(Clone, Copy, NoUninit)]
#[repr(C)]
struct ExtremesParameters {
    first: u32,
    length: u32,
    workgroups: u32,
    padding: u32,
}

/// The kernels of the reduction, compiled once.
#[derive(Debug, Clone)]
pub struct Reducer {
    program: Program<2>,
}

/// The smallest and the largest value of a component. The order is that of the numbers, with -0 below +0; a NaN with its
/// sign bit set is below all and shows in `smallest`, any other NaN is above all and shows in `largest`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extremes {
    /// The smallest value.
    pub smallest: f32,
    /// The largest value.
    pub largest: f32,
}

/// A reduction over one component of a field store.
#[derive(Debug, Clone)]
pub struct Reduction {
    program: Program<2>,
    bound: wgpu::BindGroup,
    result: wgpu::Buffer,
    workgroups: u32,
}

impl Reducer {
    /// Compiles the kernels.
    ///
    /// # Errors
    /// [`crate::Error::Shader`], [`crate::Error::OutOfMemory`] or [`crate::Error::DeviceLost`].
    pub fn new(device: &Device) -> Result<Self> {
        let slots = [Slot::Read, Slot::ReadWrite, Slot::ReadWrite, Slot::Uniform];
        let text = wgsl::assemble(1, &[wgsl::EXTREMES]);
        Ok(Self { program: Program::new(device, "extremes", &text, &slots, ["per_workgroup", "of_workgroups"])? })
    }

    /// Prepares the reduction of one component.
    ///
    /// # Errors
    /// [`crate::Error::NoSuchIndex`], [`crate::Error::OutOfMemory`] or [`crate::Error::DeviceLost`].
    pub fn reduction(&self, device: &Device, fields: &FieldStore, component: usize) -> Result<Reduction> {
        let first = fields.first(component)?;
        let length = fields.count() as u32;
        let workgroups = length.div_ceil(wgsl::WORKGROUP).min(LARGEST_STAGE);
        let partials = device.storage("partial extremes", 8 * u64::from(workgroups))?;
        let result = device.storage("extremes", 8)?;
        let parameters = device
            .uniform("the range of a reduction", &ExtremesParameters { first, length, workgroups, padding: 0 })?;
        let bound = self.program.bind(device, &[fields.buffer(), &partials, &result, &parameters])?;
        Ok(Reduction { program: self.program.clone(), bound, result, workgroups })
    }
}

impl Reduction {
    /// Reduces the component as it is now. The result stays on the device; see [`Reduction::read`] and
    /// [`crate::Parameters::take`].
    ///
    /// # Errors
    /// [`crate::Error::DeviceLost`] if it was.
    pub fn run(&self, device: &Device, timer: &mut Timer) -> Result<()> {
        device.submit("reducing a component", |encoder| self.record(encoder, timer, "extremes"))
    }

    /// The result of the last run; waits for the device.
    ///
    /// # Errors
    /// [`crate::Error::DeviceLost`] if it was.
    pub fn read(&self, device: &Device) -> Result<Extremes> {
        let values = device.read(&[self.region()])?;
        Ok(Extremes { smallest: values[0], largest: values[1] })
    }

    pub(crate) fn record(&self, encoder: &mut wgpu::CommandEncoder, timer: &mut Timer, name: &str) {
        let mut pass = timer.begin(encoder, name);
        self.program.dispatch(&mut pass, 0, &self.bound, self.workgroups * wgsl::WORKGROUP);
        self.program.dispatch(&mut pass, 1, &self.bound, 1);
    }

    /// Two numbers on the device: the smallest, the largest.
    pub(crate) fn result(&self) -> &wgpu::Buffer {
        &self.result
    }

    pub(crate) fn region(&self) -> Region<'_> {
        Region { buffer: &self.result, offset: 0, bytes: 8 }
    }
}
