//! How long the kernels take, by the device's own clock.

use crate::transfer::Region;
use crate::{Device, Result};

/// Groups of kernels that can be timed between two readings.
const CAPACITY: u32 = 1024;

/// The time spent in kernels of one name.
#[derive(Debug, Clone, PartialEq)]
pub struct KernelTime {
    /// The name.
    pub name: String,
    /// How often it ran.
    pub runs: u32,
    /// The sum of its times in seconds.
    pub seconds: f64,
}

/// Times kernels by timestamp queries, where the device has them; does nothing where it has none.
#[derive(Debug)]
pub struct Timer {
    queries: Option<Queries>,
    names: Vec<String>,
}

#[derive(Debug)]
struct Queries {
    set: wgpu::QuerySet,
    resolved: wgpu::Buffer,
    seconds_per_tick: f64,
}

impl Timer {
    /// A timer for the device. Where [`Device::has_timestamps`] says no it measures nothing.
    ///
    /// # Errors
    /// [`crate::Error::OutOfMemory`] or [`crate::Error::DeviceLost`].
    pub fn new(device: &Device) -> Result<Self> {
        if !device.has_timestamps() {
            return Ok(Self::off());
        }
        let queries = device.checked("making the timer", || Queries {
            set: device.raw().create_query_set(&wgpu::QuerySetDescriptor {
                label: Some("times"),
                ty: wgpu::QueryType::Timestamp,
                count: 2 * CAPACITY,
            }),
            resolved: device.raw().create_buffer(&wgpu::BufferDescriptor {
                label: Some("times"),
                size: u64::from(2 * CAPACITY) * 8,
                usage: wgpu::BufferUsages::QUERY_RESOLVE | wgpu::BufferUsages::COPY_SRC,
                mapped_at_creation: false,
            }),
            seconds_per_tick: f64::from(device.queue().get_timestamp_period()) * 1e-9,
        })?;
        Ok(Self { queries: Some(queries), names: Vec::new() })
    }

    /// A timer that measures nothing and costs nothing.
    pub fn off() -> Self {
        Self { queries: None, names: Vec::new() }
    }

    /// Groups timed since the last reading.
    pub(crate) fn held(&self) -> usize {
        self.names.len()
    }

    /// Begins a group of kernels under a name. Beyond the timer's capacity groups still run, untimed, until the next
    /// [`Timer::read`].
    pub(crate) fn begin<'encoder>(
        &mut self,
        encoder: &'encoder mut wgpu::CommandEncoder,
        name: &str,
    ) -> wgpu::ComputePass<'encoder> {
        let index = self.names.len() as u32;
        let queries = self.queries.as_ref().filter(|_| index < CAPACITY);
        if queries.is_some() {
            self.names.push(name.to_owned());
        }
        encoder.begin_compute_pass(&wgpu::ComputePassDescriptor {
            label: Some(name),
            timestamp_writes: queries.map(|queries| wgpu::ComputePassTimestampWrites {
                query_set: &queries.set,
                beginning_of_pass_write_index: Some(2 * index),
                end_of_pass_write_index: Some(2 * index + 1),
            }),
        })
    }

    /// The times since the last reading, by name in order of first use; waits for the device. Empty where the device has
    /// no timestamps.
    ///
    /// # Errors
    /// [`crate::Error::DeviceLost`] if it was.
    pub fn read(&mut self, device: &Device) -> Result<Vec<KernelTime>> {
        let names = std::mem::take(&mut self.names);
        let Some(queries) = self.queries.as_ref().filter(|_| !names.is_empty()) else {
            return Ok(Vec::new());
        };
        let count = 2 * names.len() as u32;
        device.submit("reading the timer", |encoder| {
            encoder.resolve_query_set(&queries.set, 0..count, &queries.resolved, 0);
        })?;
        let ticks: Vec<u64> =
            device.read(&[Region { buffer: &queries.resolved, offset: 0, bytes: u64::from(count) * 8 }])?;

        let mut times: Vec<KernelTime> = Vec::new();
        for (name, pair) in names.into_iter().zip(ticks.chunks_exact(2)) {
            let seconds = pair[1].saturating_sub(pair[0]) as f64 * queries.seconds_per_tick;
            match times.iter_mut().find(|time| time.name == name) {
                Some(time) => {
                    time.runs += 1;
                    time.seconds += seconds;
                }
                None => times.push(KernelTime { name, runs: 1, seconds }),
            }
        }
        Ok(times)
    }
}
