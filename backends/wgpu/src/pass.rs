//! The frame for a generated pass: the bindings every pass has, and a pipeline made from its text.

use bytemuck::NoUninit;

use crate::drift::four;
use crate::program::{Program, Slot};
use crate::{Coordinates, Device, FieldStore, Lists, Parameters, Result, Timer};

/// The bindings of `pass.wgsl`: fields, coordinates, offsets, list, order, parameters, particles.
const SLOTS: [Slot; 7] = [Slot::ReadWrite, Slot::Read, Slot::Read, Slot::Read, Slot::Read, Slot::Read, Slot::Uniform];

#[derive(Clone, Copy, NoUninit)]
#[repr(C)]
struct Particles {
    count: u32,
    padding: [u32; 3],
    length_per_unit: [f32; 4],
}

/// One entry point of a pass, compiled: one thread per particle.
#[derive(Debug, Clone)]
pub struct PassPipeline {
    name: String,
    program: Program<1>,
}

/// The buffers that the passes of one set of particles are bound to.
///
/// One object serves every pass: the bindings are the same for all. Made for the lists' present
/// [generation](Lists::generation); [`PassBindings::suits`] tells when to make it anew.
#[derive(Debug)]
pub struct PassBindings {
    bound: wgpu::BindGroup,
    count: u32,
    generation: u64,
}

/// What a pass works on.
#[derive(Debug, Clone, Copy)]
pub struct PassBuffers<'a> {
    /// The particles' fields, read and written.
    pub fields: &'a FieldStore,
    /// The particles' positions.
    pub coordinates: &'a Coordinates,
    /// The neighbour lists and the cell order.
    pub lists: &'a Lists,
    /// What the particles share.
    pub parameters: &'a Parameters,
}

impl PassPipeline {
    /// Compiles a pass: `text` is the whole WGSL, beginning with [`crate::wgsl::pass_prelude`]. `name` is for messages and
    /// timings.
    ///
    /// # Errors
    /// [`crate::Error::Shader`] if the text is refused, [`crate::Error::OutOfMemory`] or [`crate::Error::DeviceLost`].
    pub fn new(device: &Device, name: &str, text: &str, entry_point: &str) -> Result<Self> {
        Ok(Self { name: name.to_owned(), program: Program::new(device, name, text, &SLOTS, [entry_point])? })
    }

    /// Binds the buffers of a set of particles, for this pass and every other.
    ///
    /// # Errors
    /// [`crate::Error::CountMismatch`], [`crate::Error::OutOfMemory`] or [`crate::Error::DeviceLost`].
    pub fn bind(&self, device: &Device, buffers: &PassBuffers<'_>) -> Result<PassBindings> {
        let PassBuffers { fields, coordinates, lists, parameters } = buffers;
        coordinates.check_matches(fields)?;
        lists.check_matches(coordinates)?;
        let count = coordinates.count() as u32;
        let particles = device.uniform(
            "the parameters of the passes",
            &Particles { count, padding: [0; 3], length_per_unit: four(coordinates.torus().length_per_unit()) },
        )?;
        let bound = self.program.bind(
            device,
            &[
                fields.buffer(),
                coordinates.buffer(),
                &lists.offsets,
                &lists.list,
                &lists.order,
                parameters.buffer(),
                &particles,
            ],
        )?;
        Ok(PassBindings { bound, count, generation: lists.generation() })
    }
}

impl PassBindings {
    /// Whether the lists are still where they were when the buffers were bound.
    pub fn suits(&self, lists: &Lists) -> bool {
        self.generation == lists.generation()
    }

    /// Runs passes one after the other, each over all particles, without waiting.
    ///
    /// # Errors
    /// [`crate::Error::DeviceLost`] if it was.
    pub fn run(&self, device: &Device, timer: &mut Timer, passes: &[&PassPipeline]) -> Result<()> {
        device.submit("running passes", |encoder| passes.iter().for_each(|pass| self.record(encoder, timer, pass)))
    }

    pub(crate) fn record(&self, encoder: &mut wgpu::CommandEncoder, timer: &mut Timer, pass: &PassPipeline) {
        pass.program.dispatch(&mut timer.begin(encoder, &pass.name), 0, &self.bound, self.count);
    }
}
