//! Making buffers, writing to them and reading from them.

use bytemuck::{NoUninit, Pod};

use crate::{Device, Error, Result};

/// A part of a buffer to be read back.
pub(crate) struct Region<'a> {
    pub buffer: &'a wgpu::Buffer,
    pub offset: u64,
    pub bytes: u64,
}

impl Device {
    /// A storage buffer of at least `bytes` bytes, all zero.
    pub(crate) fn storage(&self, what: &str, bytes: u64) -> Result<wgpu::Buffer> {
        let limit = self.largest_binding();
        if bytes > limit {
            return Err(Error::TooLarge { what: what.to_owned(), needed: bytes, limit });
        }
        let usage = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC | wgpu::BufferUsages::COPY_DST;
        // 16 bytes hold one element of any buffer here: a binding may not be smaller than that.
        self.buffer(what, bytes.max(16), usage)
    }

    /// A uniform buffer with the given contents.
    pub(crate) fn uniform<T: NoUninit>(&self, what: &str, contents: &T) -> Result<wgpu::Buffer> {
        let bytes = bytemuck::bytes_of(contents);
        let usage = wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST;
        let buffer = self.buffer(what, bytes.len() as u64, usage)?;
        self.write(&buffer, 0, bytes)?;
        Ok(buffer)
    }

    fn buffer(&self, what: &str, size: u64, usage: wgpu::BufferUsages) -> Result<wgpu::Buffer> {
        self.checked(&format!("making the buffer of {what}"), || {
            self.raw().create_buffer(&wgpu::BufferDescriptor {
                label: Some(what),
                size,
                usage,
                mapped_at_creation: false,
            })
        })
    }

    /// Writes values to a buffer, `offset` in bytes.
    pub(crate) fn write<T: NoUninit>(&self, buffer: &wgpu::Buffer, offset: u64, values: &[T]) -> Result<()> {
        self.checked("writing to a buffer", || self.queue().write_buffer(buffer, offset, bytemuck::cast_slice(values)))
    }

    /// Records commands and hands them to the device, without waiting.
    pub(crate) fn submit(&self, doing: &str, record: impl FnOnce(&mut wgpu::CommandEncoder)) -> Result<()> {
        self.healthy()?;
        self.checked(doing, || {
            let mut encoder = self.raw().create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some(doing) });
            record(&mut encoder);
            self.queue().submit([encoder.finish()]);
        })
    }

    /// Reads regions back, one after the other, as values; waits for everything submitted before.
    pub(crate) fn read<T: Pod>(&self, regions: &[Region<'_>]) -> Result<Vec<T>> {
        self.read_after(regions, |_| {})
    }

    /// As [`read`](Self::read), after commands that go to the device on the same occasion.
    pub(crate) fn read_after<T: Pod>(
        &self,
        regions: &[Region<'_>],
        record: impl FnOnce(&mut wgpu::CommandEncoder),
    ) -> Result<Vec<T>> {
        let size = regions.iter().map(|region| region.bytes).sum::<u64>();
        if size == 0 {
            return Ok(Vec::new());
        }
        let usage = wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST;
        let staging = self.buffer("results on their way back", size, usage)?;
        self.submit("reading results back", |encoder| {
            record(encoder);
            let mut place = 0;
            for region in regions {
                encoder.copy_buffer_to_buffer(region.buffer, region.offset, &staging, place, region.bytes);
                place += region.bytes;
            }
        })?;
        self.checked("reading results back", || staging.map_async(wgpu::MapMode::Read, .., |_| {}))?;
        self.wait()?;
        // A failed mapping shows here.
        let view = staging.get_mapped_range(..).map_err(|error| Error::Refused {
            doing: "reading results back".into(),
            message: crate::device::one_line(&error.to_string()),
        })?;
        Ok(bytemuck::pod_collect_to_vec(&view))
    }
}
