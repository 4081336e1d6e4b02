//! The graphics backend as an [`Engine`]: particles live on the device, and every pass runs there as generated WGSL.
//!
//! Between steps nothing goes to the host but the smallest time step and, after a search, the length of the neighbour lists
//! and the extremes of the support radii. On the device the particles lie in the order of the search's cells, so that
//! neighbours are near in memory; whatever goes in or out is put in the particles' original order.

mod run;
mod work;

use std::collections::HashMap;

use etalon_kernels_gen::{Component, Field};
use etalon_reference::engine::EngineError;
use etalon_reference::fields;
use etalon_reference::particles::ParticleSet;

use self::work::Work;
use crate::clock::{Clock, Timings};
use crate::frame::{self, Slots};
use crate::permutation::Permutation;
use crate::reduce::Reducer;
use crate::{
    Coordinates, Device, Drift, Error, FieldStore, NeighbourSearch, Parameters, PassBindings, PassPipeline, Reduction,
    SearchSummary, Torus,
};

/// The particles are put in the order of the cells again after so many neighbour searches: the lists are made faster, and
/// passes read neighbours that lie nearer. Measured on a software device, about a tenth of the time of a step.
const ORDER_EVERY: u64 = 10;
/// A support, in smoothing lengths, for the first order; any kernel's will do.
const FIRST_SUPPORT: f32 = 2.0;

/// Particles on a graphics device, in single precision.
#[derive(Debug)]
pub struct WgpuEngine<const D: usize> {
    device: Device,
    length: [f64; D],
    slots: Slots,
    store: FieldStore,
    positions: Coordinates,
    parameters: Parameters,
    search: NeighbourSearch,
    found: Option<SearchSummary>,
    searches: u64,
    /// After how many searches the particles are put in order again.
    order_every: u64,
    /// The original number of the particle at each place.
    identity: Vec<u32>,
    permutation: Permutation,
    reach: PassPipeline,
    pipelines: HashMap<(&'static str, u64), PassPipeline>,
    bindings: Option<PassBindings>,
    /// What was asked for and not yet handed to the device.
    pending: Vec<Work>,
    /// What the parameters hold on the device, where it is known.
    parameters_held: [Option<f32>; frame::PARAMETERS],
    drift: Option<Drift>,
    reducer: Reducer,
    reductions: HashMap<usize, Reduction>,
    clock: Clock,
}

impl<const D: usize> WgpuEngine<D> {
    /// Takes over the particles, with room for these fields, onto a device.
    ///
    /// # Errors
    /// Whatever the device cannot do ([`Error`](crate::Error)), or a list of fields without the smoothing length.
    pub fn new(set: &ParticleSet<D>, all_fields: &[Field], device: Device) -> Result<Self, EngineError> {
        let mut engine = Self::in_original_order(set, all_fields, device)?;
        engine.order_every = ORDER_EVERY;
        engine.set_parameter(frame::SUPPORT, FIRST_SUPPORT).map_err(told)?;
        engine.search().map_err(told)?;
        engine.put_in_order().map_err(told)?;
        engine.found = None;
        Ok(engine)
    }

    /// As [`new`](Self::new), but the particles keep their order on the device too, so that sums are formed in the order in
    /// which the reference forms them. Slower for many particles.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn in_original_order(set: &ParticleSet<D>, all_fields: &[Field], device: Device) -> Result<Self, EngineError> {
        let slots = Slots::new(all_fields, D);
        let length_slot = slots
            .of(Component { field: fields::SMOOTHING_LENGTH, index: 0 })
            .ok_or_else(|| EngineError(format!("{NO_FIELD} the field smoothing_length, which the search needs")))?;
        let engine = Self::empty(set, slots, length_slot, device).map_err(told)?;
        let particles = set.particles();
        let put = |field: Field, index: usize, value: &dyn Fn(usize) -> f64| {
            let component = Component { field, index };
            let Some(slot) = engine.slots.of(component) else { return Ok(()) };
            let column = single::<D>(component, particles.len(), value)?;
            let positive = [fields::MASS, fields::SMOOTHING_LENGTH].contains(&field);
            // A device may take smaller numbers for zero.
            if let Some(i) = column.iter().position(|&x| positive && x < f32::MIN_POSITIVE) {
                return Err(out_of_range::<D>(component, i, value(i)));
            }
            engine.store.upload(&engine.device, slot, &column).map_err(told)
        };
        put(fields::MASS, 0, &|i| particles[i].mass)?;
        put(fields::SMOOTHING_LENGTH, 0, &|i| particles[i].smoothing_length)?;
        put(fields::SETTLED_SMOOTHING_LENGTH, 0, &|i| particles[i].smoothing_length)?;
        put(fields::INTERNAL_ENERGY, 0, &|i| particles[i].internal_energy)?;
        put(fields::MOBILITY, 0, &|i| if particles[i].mobile { 1.0 } else { 0.0 })?;
        put(fields::SPECIES, 0, &|i| set.species(i))?;
        for axis in 0..D {
            put(fields::VELOCITY, axis, &|i| particles[i].velocity[axis])?;
        }
        Ok(engine)
    }

    /// The buffers and kernels, the particles in their places but with fields of zero.
    fn empty(set: &ParticleSet<D>, slots: Slots, length_slot: usize, device: Device) -> crate::Result<Self> {
        let count = set.len();
        let length = set.domain().torus_length();
        let positions = Coordinates::new(&device, Torus::new(&length)?, count)?;
        for axis in 0..D {
            let column: Vec<u32> = set.coordinates(axis).into_iter().map(|place| (place >> 32) as u32).collect();
            positions.upload(&device, axis, &column)?;
        }
        let store = FieldStore::new(&device, slots.count(), count)?;
        let drift = match slots.of(Component { field: fields::DISPLACEMENT, index: 0 }) {
            Some(slot) => Some(Drift::new(&device, &positions, &store, slot)?),
            None => None,
        };
        let reach_text = frame::reach_text(D, &slots, length_slot);
        Ok(Self {
            length,
            search: NeighbourSearch::new(&device, &positions, &store, slots.reach())?,
            found: None,
            searches: 0,
            order_every: u64::MAX,
            identity: (0..count as u32).collect(),
            permutation: Permutation::new(&device)?,
            reach: PassPipeline::new(&device, "cells: reach", &reach_text, frame::ENTRY_POINT)?,
            pipelines: HashMap::new(),
            bindings: None,
            pending: Vec::new(),
            parameters_held: [None; frame::PARAMETERS],
            drift,
            reducer: Reducer::new(&device)?,
            reductions: HashMap::new(),
            clock: Clock::off(),
            parameters: Parameters::new(&device, frame::PARAMETERS)?,
            slots,
            store,
            positions,
            device,
        })
    }

    /// The device it runs on.
    pub fn device(&self) -> &Device {
        &self.device
    }

    /// The number of pairs last found, each counted from both ends.
    pub fn pair_count(&self) -> usize {
        self.found.map_or(0, |found| found.entries as usize)
    }

    /// The original number of the particle at each place on the device.
    pub fn identity(&self) -> &[u32] {
        &self.identity
    }

    /// Starts or stops the clocks, anew. They cost little where the device has timestamps; where it has none, every stage
    /// is waited for.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`] or [`Error::DeviceLost`] in words.
    pub fn set_timed(&mut self, timed: bool) -> Result<(), EngineError> {
        self.flush().map_err(told)?;
        self.clock = if timed { Clock::on(&self.device).map_err(told)? } else { Clock::off() };
        Ok(())
    }

    /// Time per stage since the clocks were started; waits for the device.
    ///
    /// # Errors
    /// [`Error::DeviceLost`] in words.
    pub fn timings(&mut self) -> Result<Timings, EngineError> {
        self.flush().map_err(told)?;
        self.clock.read(&self.device).map_err(told)
    }
}

/// Begins the message about a field that there is no room for.
const NO_FIELD: &str = "this engine was made without";

fn told(error: Error) -> EngineError {
    EngineError::from_display(error)
}

/// Values by number as single precision, refused where they leave its range.
fn single<const D: usize>(
    component: Component,
    count: usize,
    value: impl Fn(usize) -> f64,
) -> Result<Vec<f32>, EngineError> {
    let column: Vec<f32> = (0..count).map(|i| value(i) as f32).collect();
    match column.iter().enumerate().position(|(i, x)| x.is_infinite() && value(i).is_finite()) {
        Some(i) => Err(out_of_range::<D>(component, i, value(i))),
        None => Ok(column),
    }
}

fn out_of_range<const D: usize>(component: Component, particle: usize, value: f64) -> EngineError {
    EngineError(format!(
        "the {} of particle {particle} is {value:e}, out of the range of single precision: choose other units, or \
         compute in double precision with `--backend simd`",
        component.name(D)
    ))
}
