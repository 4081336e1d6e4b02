//! Putting the particles in another order, on the device.

use bytemuck::NoUninit;

use crate::program::{Program, Slot};
use crate::{Device, Result, Timer, wgsl};

#[derive(Clone, Copy, NoUninit)]
#[repr(C)]
struct PermutationParameters {
    count: u32,
    words: u32,
    padding: [u32; 2],
}

/// Permutes columns of one word per particle that lie one after the other in a buffer.
#[derive(Debug)]
pub(crate) struct Permutation {
    program: Program<1>,
}

impl Permutation {
    /// Compiles the kernel.
    pub fn new(device: &Device) -> Result<Self> {
        let slots = [Slot::Read, Slot::Read, Slot::ReadWrite, Slot::Uniform];
        let text = wgsl::assemble(1, &[wgsl::PERMUTATION]);
        Ok(Self { program: Program::new(device, "permutation", &text, &slots, ["permute"])? })
    }

    /// Moves the particle `order[i]` to place i in each of `columns` columns of `buffer`. Needs as much memory again while
    /// it runs.
    pub fn run(
        &self,
        device: &Device,
        timer: &mut Timer,
        order: &wgpu::Buffer,
        buffer: &wgpu::Buffer,
        [columns, count]: [usize; 2],
    ) -> Result<()> {
        // Fits: the words fill one binding, whose size in bytes fits.
        let words = (columns * count) as u32;
        let sorted = device.storage("the particles in their new order", 4 * u64::from(words))?;
        let parameters = device.uniform(
            "the sizes of a permutation",
            &PermutationParameters { count: count as u32, words, padding: [0; 2] },
        )?;
        let bound = self.program.bind(device, &[buffer, order, &sorted, &parameters])?;
        device.submit("putting the particles in order", |encoder| {
            self.program.dispatch(&mut timer.begin(encoder, "order"), 0, &bound, words);
            encoder.copy_buffer_to_buffer(&sorted, 0, buffer, 0, 4 * u64::from(words));
        })
    }
}
