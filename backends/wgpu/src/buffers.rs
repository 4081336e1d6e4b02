//! The particles' storage on the device.

use crate::transfer::Region;
use crate::{Device, Error, Result, Torus};

/// All fields of all particles in one storage buffer of f32: component k of particle i lies at `k * count + i`.
#[derive(Debug, Clone)]
pub struct FieldStore {
    buffer: wgpu::Buffer,
    components: usize,
    count: usize,
}

impl FieldStore {
    /// A store for `count` particles with `components` numbers each, all zero.
    ///
    /// # Errors
    /// [`Error::BadCount`], [`Error::TooLarge`], [`Error::OutOfMemory`] or [`Error::DeviceLost`].
    pub fn new(device: &Device, components: usize, count: usize) -> Result<Self> {
        let bytes = 4 * components as u64 * u64::from(checked_count(count)?);
        let buffer = device.storage(&format!("{components} fields of {count} particles"), bytes)?;
        Ok(Self { buffer, components, count })
    }

    /// Number of particles.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Numbers per particle.
    pub fn components(&self) -> usize {
        self.components
    }

    /// Writes one component of all particles.
    ///
    /// # Errors
    /// [`Error::NoSuchIndex`], [`Error::WrongLength`] or [`Error::DeviceLost`].
    pub fn upload(&self, device: &Device, component: usize, values: &[f32]) -> Result<()> {
        check_length("a component of the fields", self.count, values.len())?;
        device.write(&self.buffer, self.offset(component)?, values)
    }

    /// Reads one component of all particles; waits for the device.
    ///
    /// # Errors
    /// [`Error::NoSuchIndex`] or [`Error::DeviceLost`].
    pub fn download(&self, device: &Device, component: usize) -> Result<Vec<f32>> {
        device.read(&[Region { buffer: &self.buffer, offset: self.offset(component)?, bytes: 4 * self.count as u64 }])
    }

    pub(crate) fn buffer(&self) -> &wgpu::Buffer {
        &self.buffer
    }

    /// Where a component begins, in bytes.
    pub(crate) fn offset(&self, component: usize) -> Result<u64> {
        check_index("component", component, self.components)?;
        Ok(4 * component as u64 * self.count as u64)
    }

    /// Where a component begins, in numbers. Fits: all numbers are within one binding, which is below 2^32 of them.
    pub(crate) fn first(&self, component: usize) -> Result<u32> {
        Ok((self.offset(component)? / 4) as u32)
    }
}

/// The particles' positions: unsigned 32-bit fractions of a torus, axis by axis: axis d of particle i lies at `d * count + i`.
#[derive(Debug, Clone)]
pub struct Coordinates {
    buffer: wgpu::Buffer,
    torus: Torus,
    count: usize,
}

impl Coordinates {
    /// A store for `count` positions on a torus, all at its origin.
    ///
    /// # Errors
    /// As [`FieldStore::new`].
    pub fn new(device: &Device, torus: Torus, count: usize) -> Result<Self> {
        let bytes = 4 * torus.dimension() as u64 * u64::from(checked_count(count)?);
        let buffer = device.storage(&format!("the coordinates of {count} particles"), bytes)?;
        Ok(Self { buffer, torus, count })
    }

    /// Number of particles.
    pub fn count(&self) -> usize {
        self.count
    }

    /// The torus the positions are fractions of.
    pub fn torus(&self) -> &Torus {
        &self.torus
    }

    /// Writes all particles' coordinates along one axis.
    ///
    /// # Errors
    /// As [`FieldStore::upload`].
    pub fn upload(&self, device: &Device, axis: usize, values: &[u32]) -> Result<()> {
        check_length("an axis of the coordinates", self.count, values.len())?;
        device.write(&self.buffer, self.offset(axis)?, values)
    }

    /// Reads all particles' coordinates along one axis; waits for the device.
    ///
    /// # Errors
    /// As [`FieldStore::download`].
    pub fn download(&self, device: &Device, axis: usize) -> Result<Vec<u32>> {
        device.read(&[Region { buffer: &self.buffer, offset: self.offset(axis)?, bytes: 4 * self.count as u64 }])
    }

    pub(crate) fn buffer(&self) -> &wgpu::Buffer {
        &self.buffer
    }

    fn offset(&self, axis: usize) -> Result<u64> {
        check_index("axis", axis, self.torus.dimension())?;
        Ok(4 * axis as u64 * self.count as u64)
    }

    /// Fails unless a field store is for as many particles.
    pub(crate) fn check_matches(&self, fields: &FieldStore) -> Result<()> {
        if fields.count == self.count {
            Ok(())
        } else {
            Err(Error::CountMismatch { what: "the field store", expected: self.count, found: fields.count })
        }
    }
}

/// A few numbers that every particle shares: the time step, constants of the scene.
///
/// The host writes them, or a result on the device is copied in with [`Parameters::take`], so that a time step need not go
/// through the host.
#[derive(Debug, Clone)]
pub struct Parameters {
    buffer: wgpu::Buffer,
    length: usize,
}

impl Parameters {
    /// Room for `length` numbers, all zero.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`] or [`Error::DeviceLost`].
    pub fn new(device: &Device, length: usize) -> Result<Self> {
        Ok(Self { buffer: device.storage("the parameters", 4 * length as u64)?, length })
    }

    /// Writes numbers from `first` on.
    ///
    /// # Errors
    /// [`Error::NoSuchIndex`] if they run beyond the end, or [`Error::DeviceLost`].
    pub fn upload(&self, device: &Device, first: usize, values: &[f32]) -> Result<()> {
        if let Some(last) = values.len().checked_sub(1) {
            check_index("parameter", first.saturating_add(last), self.length)?;
        }
        device.write(&self.buffer, 4 * first as u64, values)
    }

    /// Reads all of them; waits for the device.
    ///
    /// # Errors
    /// [`Error::DeviceLost`] if it was.
    pub fn download(&self, device: &Device) -> Result<Vec<f32>> {
        device.read(&[Region { buffer: &self.buffer, offset: 0, bytes: 4 * self.length as u64 }])
    }

    /// Copies the smallest and the largest value of a reduction to the numbers `first` and `first + 1`, on the device.
    ///
    /// # Errors
    /// [`Error::NoSuchIndex`] or [`Error::DeviceLost`].
    pub fn take(&self, device: &Device, first: usize, reduction: &crate::Reduction) -> Result<()> {
        check_index("parameter", first.saturating_add(1), self.length)?;
        device.submit("taking a reduction's result", |encoder| {
            encoder.copy_buffer_to_buffer(reduction.result(), 0, &self.buffer, 4 * first as u64, 8);
        })
    }

    pub(crate) fn buffer(&self) -> &wgpu::Buffer {
        &self.buffer
    }
}

/// A number of particles as the kernels count them: at least one, and below 2^31 so that no index overflows.
fn checked_count(count: usize) -> Result<u32> {
    u32::try_from(count).ok().filter(|count| (1..1 << 31).contains(count)).ok_or(Error::BadCount { count })
}

fn check_length(what: &str, expected: usize, found: usize) -> Result<()> {
    if expected == found { Ok(()) } else { Err(Error::WrongLength { what: what.to_owned(), expected, found }) }
}

fn check_index(what: &'static str, index: usize, count: usize) -> Result<()> {
    if index < count { Ok(()) } else { Err(Error::NoSuchIndex { what, index, count }) }
}
