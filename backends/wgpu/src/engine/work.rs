//! Handing work to the device: passes are gathered and go there together when something is to be read or searched.

use std::hash::{DefaultHasher, Hash, Hasher};

use etalon_kernels_gen::trace::Drawing;
use etalon_reference::engine::EngineError;

use super::{WgpuEngine, told};
use crate::frame::{self, Slots, TextError};
use crate::{Drift, Error, PassBindings, PassBuffers, PassPipeline, Result, Timer, validate};

/// One thing to do with all particles.
#[derive(Debug)]
pub(super) enum Work {
    /// A pass or an update.
    Sweep(PassPipeline),
    /// The motion.
    Drift,
}

pub(super) fn record(
    work: &[Work],
    bindings: &PassBindings,
    drift: Option<&Drift>,
    encoder: &mut wgpu::CommandEncoder,
    timer: &mut Timer,
) {
    for one in work {
        match (one, drift) {
            (Work::Sweep(pipeline), _) => bindings.record(encoder, timer, pipeline),
            (Work::Drift, Some(drift)) => drift.record(encoder, timer),
            (Work::Drift, None) => {}
        }
    }
}

impl<const D: usize> WgpuEngine<D> {
    /// Adds to the work that is pending; done at once where stages are timed by waiting.
    pub(super) fn enqueue(&mut self, stage: &str, work: Work) -> Result<()> {
        let start = self.clock.start(&self.device)?;
        self.pending.push(work);
        if start.is_some() {
            self.flush()?;
        }
        self.clock.stop(&self.device, stage, start)
    }

    /// Hands the pending work to the device, without waiting.
    pub(super) fn flush(&mut self) -> Result<()> {
        if self.pending.is_empty() {
            return Ok(());
        }
        let work = std::mem::take(&mut self.pending);
        let bindings = self.bound()?;
        let (drift, timer) = (self.drift.as_ref(), &mut self.clock.timer);
        self.device.submit("running passes", |encoder| record(&work, &bindings, drift, encoder, timer))?;
        self.bindings = Some(bindings);
        Ok(())
    }

    /// Sets one of the numbers that all particles share. What is pending still runs with the one before.
    pub(super) fn set_parameter(&mut self, index: usize, value: f32) -> Result<()> {
        if self.parameters_held[index] != Some(value) {
            self.flush()?;
            self.parameters.upload(&self.device, index, &[value])?;
            self.parameters_held[index] = Some(value);
        }
        Ok(())
    }

    /// The buffers bound, anew where the lists have moved. The caller puts them back.
    pub(super) fn bound(&mut self) -> Result<PassBindings> {
        let lists = self.search.lists();
        if let Some(bindings) = self.bindings.take().filter(|bindings| bindings.suits(lists)) {
            return Ok(bindings);
        }
        let buffers =
            PassBuffers { fields: &self.store, coordinates: &self.positions, lists, parameters: &self.parameters };
        self.reach.bind(&self.device, &buffers)
    }

    /// Finds neighbours for the support that the parameters hold, and sees whether the particles moved well before.
    pub(super) fn search(&mut self) -> Result<()> {
        self.found = None;
        let start = self.clock.start(&self.device)?;
        self.pending.push(Work::Sweep(self.reach.clone()));
        self.flush()?;
        let fault = self.drift.as_ref().map(Drift::fault);
        let (summary, fault) = self.search.build_and_read(&self.device, &mut self.clock.timer, fault)?;
        if let (Some(drift), Some(fault)) = (&self.drift, fault) {
            drift.judge(&self.device, fault).map_err(|error| self.in_original_numbers(error))?;
        }
        self.found = Some(summary);
        self.clock.stop(&self.device, "neighbour_list", start)
    }

    /// Puts the particles in the order of the cells they were last found in; the lists are void if that moves any.
    pub(super) fn put_in_order(&mut self) -> Result<()> {
        let order = self.search.lists().download_order(&self.device)?;
        if order.is_sorted() {
            return Ok(());
        }
        let start = self.clock.start(&self.device)?;
        let (device, timer, by) = (&self.device, &mut self.clock.timer, &self.search.lists().order);
        let count = self.identity.len();
        self.permutation.run(device, timer, by, self.store.buffer(), [self.slots.count(), count])?;
        self.permutation.run(device, timer, by, self.positions.buffer(), [D, count])?;
        self.identity = order.iter().map(|&place| self.identity[place as usize]).collect();
        self.found = None;
        self.clock.stop(&self.device, "order", start)
    }

    fn in_original_numbers(&self, error: Error) -> Error {
        match error {
            Error::DisplacementTooLarge { particle, displacement, half_length } => {
                let particle = self.identity.get(particle as usize).copied().unwrap_or(particle);
                Error::DisplacementTooLarge { particle, displacement, half_length }
            }
            other => other,
        }
    }

    /// The pipeline for drawings, compiled when they are first met.
    pub(super) fn pipeline(
        &mut self,
        name: &'static str,
        drawings: &[&Drawing],
        text: impl FnOnce(&Slots) -> std::result::Result<String, TextError>,
    ) -> std::result::Result<PassPipeline, EngineError> {
        let key = (name, fingerprint(drawings));
        if let Some(known) = self.pipelines.get(&key) {
            return Ok(known.clone());
        }
        let text = text(&self.slots).map_err(EngineError::from_display)?;
        validate(name, &text).map_err(told)?;
        let made = PassPipeline::new(&self.device, name, &text, frame::ENTRY_POINT).map_err(told)?;
        self.pipelines.insert(key, made.clone());
        Ok(made)
    }
}

/// A number that two drawings share only if they compute the same; their text follows from them, and takes longer to make.
fn fingerprint(drawings: &[&Drawing]) -> u64 {
    let mut hasher = DefaultHasher::new();
    for drawing in drawings {
        let graph = drawing.graph();
        drawing.inputs().hash(&mut hasher);
        graph.len().hash(&mut hasher);
        graph.ids().for_each(|id| graph.op(id).hash(&mut hasher));
        for output in drawing.outputs() {
            (&output.name, output.id).hash(&mut hasher);
        }
    }
    hasher.finish()
}
