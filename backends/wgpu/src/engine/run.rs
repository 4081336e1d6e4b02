//! What an engine is asked to do.

use etalon_kernels_gen::emit::Header;
use etalon_kernels_gen::trace::{Drawing, Single};
use etalon_kernels_gen::{Component, Field, Pass, Update};
use etalon_reference::engine::{Arrangement, Engine, EngineError};
use etalon_reference::fields;

use super::work::{Work, record};
use super::{NO_FIELD, WgpuEngine, single, told};
use crate::{Extremes, Result as DeviceResult, frame};

/// What a generated text says of itself when it is made for a device rather than for a reader.
const HEAD: Header<'static> = Header { command: "etalon emit --target wgsl", definition: "reference/src/passes" };

impl<const D: usize> WgpuEngine<D> {
    fn slot(&self, component: Component) -> Result<usize, EngineError> {
        self.slots.of(component).ok_or_else(|| EngineError(format!("{NO_FIELD} the field {}", component.name(D))))
    }

    /// The smallest and the largest of a column, with everything that is pending before.
    fn extremes(&mut self, slot: usize) -> DeviceResult<Extremes> {
        let reduction = match self.reductions.get(&slot) {
            Some(known) => known.clone(),
            None => {
                let made = self.reducer.reduction(&self.device, &self.store, slot)?;
                self.reductions.insert(slot, made.clone());
                made
            }
        };
        let start = self.clock.start(&self.device)?;
        let work = std::mem::take(&mut self.pending);
        let bindings = self.bound()?;
        let (drift, timer) = (self.drift.as_ref(), &mut self.clock.timer);
        let values = self.device.read_after(&[reduction.region()], |encoder| {
            record(&work, &bindings, drift, encoder, timer);
            reduction.record(encoder, timer, "minimum");
        })?;
        self.bindings = Some(bindings);
        self.clock.stop(&self.device, "minimum", start)?;
        Ok(Extremes { smallest: values[0], largest: values[1] })
    }

    /// Values by place on the device as values by original number.
    fn by_identity<T: Copy, U: Copy + Default>(&self, values: &[T], convert: impl Fn(T) -> U) -> Vec<U> {
        let mut sorted = vec![U::default(); values.len()];
        for (&original, &value) in self.identity.iter().zip(values) {
            sorted[original as usize] = convert(value);
        }
        sorted
    }
}

impl<const D: usize> Engine<D> for WgpuEngine<D> {
    fn particle_count(&self) -> usize {
        self.identity.len()
    }

    /// A particle that had moved too far in the [`drift`](Engine::drift) before is told of here, when the device is waited
    /// for in any case.
    fn find_neighbours(&mut self, support: f64) -> Result<(), EngineError> {
        self.set_parameter(frame::SUPPORT, support as f32).map_err(told)?;
        self.search().map_err(told)?;
        self.searches += 1;
        if self.searches.is_multiple_of(self.order_every) {
            self.put_in_order().map_err(told)?;
            if self.found.is_none() {
                self.search().map_err(told)?;
            }
        }
        let diameter = 2.0 * self.found.map_or(0.0, |found| f64::from(found.largest_reach));
        if let Some(axis) = self.length.iter().position(|&length| diameter > length) {
            self.found = None;
            return Err(EngineError(format!(
                "the box is {} long on axis {axis}, less than the support's diameter {diameter}; \
                 use more particles or fewer neighbours",
                self.length[axis]
            )));
        }
        Ok(())
    }

    fn run_pass<P: Pass<D>>(&mut self, pass: &P) -> Result<(), EngineError> {
        if self.found.is_none() {
            return Err(EngineError(format!("pass {} was asked for before neighbours were found", P::NAME)));
        }
        let drawing = Drawing::of_pass::<D, P, Single>(pass).map_err(EngineError::from_display)?;
        let pipeline = self
            .pipeline(P::NAME, &[&drawing.pair, &drawing.finish], |slots| frame::pass_text(&drawing, slots, &HEAD))?;
        self.enqueue(P::NAME, Work::Sweep(pipeline)).map_err(told)
    }

    fn run_update<U: Update<D>>(&mut self, update: &U, time_step: f64) -> Result<(), EngineError> {
        let drawing = Drawing::of_update::<D, U, Single>(update).map_err(EngineError::from_display)?;
        let pipeline = self.pipeline(U::NAME, &[&drawing.apply], |slots| frame::update_text(&drawing, slots, &HEAD))?;
        self.set_parameter(frame::TIME_STEP, time_step as f32).map_err(told)?;
        self.enqueue(U::NAME, Work::Sweep(pipeline)).map_err(told)
    }

    fn drift(&mut self) -> Result<(), EngineError> {
        let component = Component { field: fields::DISPLACEMENT, index: 0 };
        self.slot(component)?;
        self.found = None;
        self.enqueue("drift", Work::Drift).map_err(told)
    }

    fn minimum(&mut self, field: Field) -> Result<f64, EngineError> {
        let slot = self.slot(Component { field, index: 0 })?;
        let extremes = self.extremes(slot).map_err(told)?;
        if extremes.smallest.is_nan() || extremes.largest.is_nan() {
            return Err(EngineError(format!(
                "the {} of a particle is not a number; the run has gone wrong, use a smaller time step",
                field.name
            )));
        }
        Ok(f64::from(extremes.smallest))
    }

    fn read(&mut self, component: Component) -> Result<Vec<f64>, EngineError> {
        let slot = self.slot(component)?;
        self.flush().map_err(told)?;
        let values = self.store.download(&self.device, slot).map_err(told)?;
        Ok(self.by_identity(&values, f64::from))
    }

    fn write(&mut self, component: Component, values: &[f64]) -> Result<(), EngineError> {
        let slot = self.slot(component)?;
        if values.len() != self.identity.len() {
            let (found, wanted) = (values.len(), self.identity.len());
            return Err(EngineError(format!("{} has {found} values for {wanted} particles", component.name(D))));
        }
        let by_number = single::<D>(component, values.len(), |particle| values[particle])?;
        self.flush().map_err(told)?;
        let column: Vec<f32> = self.identity.iter().map(|&original| by_number[original as usize]).collect();
        self.store.upload(&self.device, slot, &column).map_err(told)
    }

    fn coordinates(&mut self, axis: usize) -> Result<Vec<u64>, EngineError> {
        self.flush().map_err(told)?;
        let values = self.positions.download(&self.device, axis).map_err(told)?;
        Ok(self.by_identity(&values, |word| u64::from(word) << 32))
    }

    fn place(&mut self, axis: usize, coordinates: &[u64]) -> Result<(), EngineError> {
        if coordinates.len() != self.identity.len() {
            let (found, wanted) = (coordinates.len(), self.identity.len());
            return Err(EngineError(format!("axis {axis} has {found} coordinates for {wanted} particles")));
        }
        if let Some(particle) = coordinates.iter().position(|bits| bits & 0xffff_ffff != 0) {
            return Err(EngineError(format!(
                "the coordinate of particle {particle} on axis {axis} has more digits than single precision keeps; \
                 use double precision with `--backend simd`"
            )));
        }
        self.flush().map_err(told)?;
        self.found = None;
        let column: Vec<u32> = self.identity.iter().map(|&n| (coordinates[n as usize] >> 32) as u32).collect();
        self.positions.upload(&self.device, axis, &column).map_err(told)
    }

    fn arrangement(&self) -> Arrangement {
        Arrangement { order: self.identity.clone(), searches: self.searches }
    }

    fn arrange(&mut self, arrangement: &Arrangement) -> Result<(), EngineError> {
        let sources = arrangement.sources(&self.identity)?;
        self.flush().map_err(told)?;
        self.found = None;
        for slot in 0..self.slots.count() {
            let column = self.store.download(&self.device, slot).map_err(told)?;
            self.store.upload(&self.device, slot, &sorted(&column, &sources)).map_err(told)?;
        }
        for axis in 0..D {
            let column = self.positions.download(&self.device, axis).map_err(told)?;
            self.positions.upload(&self.device, axis, &sorted(&column, &sources)).map_err(told)?;
        }
        self.identity.clone_from(&arrangement.order);
        self.searches = arrangement.searches;
        Ok(())
    }
}

/// At each place what is at its source now.
fn sorted<T: Copy>(column: &[T], sources: &[u32]) -> Vec<T> {
    sources.iter().map(|&place| column[place as usize]).collect()
}
