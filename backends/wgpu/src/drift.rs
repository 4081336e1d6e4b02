//! Moving the particles.

use bytemuck::NoUninit;

use crate::program::{Program, Slot};
use crate::transfer::Region;
use crate::{Coordinates, Device, Error, FieldStore, Result, Timer, wgsl};

/// The word that says that no particle has gone wrong: no particle has this index.
const NO_FAULT: u32 = u32::MAX;

#[derive(Clone, Copy, NoUninit)]
#[repr(C)]
struct DriftParameters {
    count: u32,
    first_displacement: u32,
    padding: [u32; 2],
    units_per_length: [f32; 4],
    half_length: [f32; 4],
}

/// Adds a displacement to every position: the coordinate grows by `displacement * 2^32 / length`, multiplied in f32 and
/// rounded to the nearest unit, half to even.
///
/// The displacement of a particle is a vector in the field store, one component per axis, in the unit of the torus.
#[derive(Debug)]
pub struct Drift {
    program: Program<1>,
    bound: wgpu::BindGroup,
    coordinates: Coordinates,
    fields: FieldStore,
    first_component: usize,
    first_fault: wgpu::Buffer,
}

impl Drift {
    /// Prepares the motion of `coordinates` by the components `first_component`, `first_component + 1`, ... of `fields`.
    ///
    /// # Errors
    /// [`Error::NoSuchIndex`], [`Error::CountMismatch`], [`Error::Shader`], [`Error::OutOfMemory`] or [`Error::DeviceLost`].
    pub fn new(
        device: &Device,
        coordinates: &Coordinates,
        fields: &FieldStore,
        first_component: usize,
    ) -> Result<Self> {
        coordinates.check_matches(fields)?;
        let torus = coordinates.torus();
        fields.first(first_component.saturating_add(torus.dimension() - 1))?;

        let slots = [Slot::Read, Slot::ReadWrite, Slot::ReadWrite, Slot::Uniform];
        let text = wgsl::assemble(torus.dimension(), &[wgsl::DRIFT]);
        let program = Program::new(device, "drift", &text, &slots, ["drift"])?;
        let parameters = device.uniform(
            "the parameters of the drift",
            &DriftParameters {
                count: coordinates.count() as u32,
                first_displacement: fields.first(first_component)?,
                padding: [0; 2],
                units_per_length: four(torus.units_per_length()),
                half_length: four(torus.half_length()),
            },
        )?;
        let first_fault = device.storage("the first particle that went wrong", 4)?;
        device.write(&first_fault, 0, &[NO_FAULT])?;
        let bound = program.bind(device, &[fields.buffer(), coordinates.buffer(), &first_fault, &parameters])?;
        Ok(Self {
            program,
            bound,
            coordinates: coordinates.clone(),
            fields: fields.clone(),
            first_component,
            first_fault,
        })
    }

    /// Moves every particle, without waiting. A displacement that is not a number, or not shorter than half the torus, is
    /// left out; [`Drift::check`] tells.
    ///
    /// # Errors
    /// [`Error::DeviceLost`] if it was.
    pub fn run(&self, device: &Device, timer: &mut Timer) -> Result<()> {
        device.submit("moving the particles", |encoder| self.record(encoder, timer))
    }

    pub(crate) fn record(&self, encoder: &mut wgpu::CommandEncoder, timer: &mut Timer) {
        self.program.dispatch(&mut timer.begin(encoder, "drift"), 0, &self.bound, self.coordinates.count() as u32);
    }

    /// Whether every displacement since the last check was good; waits for the device.
    ///
    /// # Errors
    /// [`Error::DisplacementTooLarge`] with the first particle for which it was not and the displacement it has now, or
    /// [`Error::DeviceLost`].
    pub fn check(&self, device: &Device) -> Result<()> {
        let faults: Vec<u32> = device.read(&[self.fault()])?;
        self.judge(device, faults[0])
    }

    /// The word that [`Drift::judge`] understands.
    pub(crate) fn fault(&self) -> Region<'_> {
        Region { buffer: &self.first_fault, offset: 0, bytes: 4 }
    }

    /// As [`Drift::check`], where the word has been read already.
    pub(crate) fn judge(&self, device: &Device, particle: u32) -> Result<()> {
        if particle == NO_FAULT {
            return Ok(());
        }
        device.write(&self.first_fault, 0, &[NO_FAULT])?;
        let dimension = self.coordinates.torus().dimension();
        let regions = (0..dimension)
            .map(|axis| {
                let offset = self.fields.offset(self.first_component + axis)? + 4 * u64::from(particle);
                Ok(Region { buffer: self.fields.buffer(), offset, bytes: 4 })
            })
            .collect::<Result<Vec<_>>>()?;
        Err(Error::DisplacementTooLarge {
            particle,
            displacement: device.read(&regions)?,
            half_length: self.coordinates.torus().half_length()[..dimension].to_vec(),
        })
    }
}

/// Three numbers as a vec4, which is how uniform memory is laid out.
pub(crate) fn four([x, y, z]: [f32; 3]) -> [f32; 4] {
    [x, y, z, 0.0]
}
