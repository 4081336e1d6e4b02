//! What runs an equation outside of this program: a graphics adapter with its WGSL. The audit knows nobody who can; whoever asks for a
//! measurement brings one along.

use crate::probe::Probe;
use crate::sample::hash;
use etalon_kernels_gen::emit::{Header, MulAdd, wgsl};
use etalon_kernels_gen::trace::{Drawing, Single};

/// Something that prints a drawing as WGSL and runs it.
pub trait Device {
    /// What it is, with its driver: figures of devices with one name are held against one another.
    fn name(&self) -> String;
    /// Calls a function once for each row of `rows`, which holds the drawing's inputs one call after the other, and returns the outputs in the
    /// same manner.
    ///
    /// # Errors
    /// One sentence that says what went wrong.
    fn call(&self, function: &str, drawing: &Drawing, calls: usize, rows: &[f32]) -> Result<Vec<f32>, String>;
}

/// A device that did not do what it was asked for.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{probe} could not be run on {device}: {reason}")]
pub struct DeviceError {
    /// The probe.
    pub probe: String,
    /// The device.
    pub device: String,
    /// What went wrong.
    pub reason: String,
}

/// What a device makes of a probe, for inputs that `f32` holds: the outputs of each call.
pub(crate) fn call(device: &dyn Device, probe: &Probe, inputs: &[Vec<f64>]) -> Result<Vec<Vec<f64>>, DeviceError> {
    let wrong = |reason: String| DeviceError { probe: probe.key(), device: device.name(), reason };
    let drawing = probe.draw::<Single>().map_err(|error| wrong(error.to_string()))?;
    let rows: Vec<f32> = inputs.iter().flatten().map(|x| *x as f32).collect();
    let found = device.call(probe.function, &drawing, inputs.len(), &rows).map_err(wrong)?;
    let outputs = drawing.outputs().len();
    if found.len() != inputs.len() * outputs {
        return Err(wrong(format!("it returned {} numbers for {} calls", found.len(), inputs.len())));
    }
    Ok(found.chunks(outputs.max(1)).map(|row| row.iter().map(|x| f64::from(*x)).collect()).collect())
}

/// What tells one WGSL text of a probe from another, as a record keeps it: a figure is one of this text only. Nothing for what cannot be printed.
#[must_use]
pub fn text_mark(probe: &Probe) -> Option<String> {
    let drawing = probe.draw::<Single>().ok()?;
    let head = Header { command: "", definition: "" };
    let text = wgsl::function(probe.function, &drawing, &head, MulAdd::TwoRoundings).ok()?;
    Some(format!("{:016x}", hash(&text)))
}
