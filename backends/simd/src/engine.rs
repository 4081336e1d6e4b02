//! The vector backend as an [`Engine`].

use crate::neighbours::{Coordinate, NeighbourList, Order, SEGMENT};
use crate::number::Number;
use crate::store::{BLOCK, Store};
use crate::sweep::{BlockUpdate, InDimension, Inputs, Layout, MOST, SegmentSweep, pack_block};
use crate::timing::Timings;
use etalon_kernels_gen::lanes::dispatch;
use etalon_kernels_gen::{Component, Field, Footprint, Part, Pass, Reduction, Update, used_components};
use etalon_reference::engine::{Arrangement, Engine, EngineError, smaller};
use etalon_reference::fields;
use etalon_reference::particles::ParticleSet;
use fearless_simd::Level;
use rayon::prelude::*;
use std::time::Instant;

/// Particles are put in the order of the space-filling curve again after so many neighbour searches.
const ORDER_EVERY: u64 = 10;

/// How to run.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// The instruction set; [`Level::new`] is the best one there is. Results do not depend on it.
    pub level: Level,
}

impl Default for Options {
    fn default() -> Self {
        Options { level: Level::new() }
    }
}

/// Particles on the processor's vector lanes, in precision `T`. Threads: those of the current rayon pool.
pub struct LaneEngine<T: Number, const D: usize> {
    level: Level,
    length: [f64; D],
    coordinates: [Vec<T::Coordinate>; D],
    store: Store<T>,
    /// The original number of the particle at each place.
    identity: Vec<u32>,
    order: Order,
    list: NeighbourList<T::Coordinate, D>,
    reach: Vec<T>,
    records: Vec<T::Word>,
    searches: u64,
    timings: Timings,
}

impl<T: Number, const D: usize> LaneEngine<T, D> {
    /// Takes over the particles, with room for these fields.
    pub fn new(set: &ParticleSet<D>, all_fields: &[Field], options: Options) -> Self {
        let count = set.len();
        let coordinates = std::array::from_fn(|axis| set.coordinates(axis).into_iter().map(T::coordinate).collect());
        let mut engine = LaneEngine {
            level: options.level,
            length: set.domain().torus_length(),
            coordinates,
            store: Store::new(all_fields, D, count),
            identity: (0..count as u32).collect(),
            order: Order::default(),
            list: NeighbourList::default(),
            reach: Vec::new(),
            records: Vec::new(),
            searches: 0,
            timings: Timings::default(),
        };
        let particles = set.particles();
        let mut put = |field: Field, index: usize, value: &(dyn Fn(usize) -> f64 + Sync)| {
            if let Ok(slots) = engine.store.slots(&[field], D) {
                engine.store.set_column(slots[index], |i| T::from_f64(value(i)));
            }
        };
        put(fields::MASS, 0, &|i| particles[i].mass);
        put(fields::SMOOTHING_LENGTH, 0, &|i| particles[i].smoothing_length);
        put(fields::SETTLED_SMOOTHING_LENGTH, 0, &|i| particles[i].smoothing_length);
        put(fields::INTERNAL_ENERGY, 0, &|i| particles[i].internal_energy);
        put(fields::MOBILITY, 0, &|i| if particles[i].mobile { 1.0 } else { 0.0 });
        put(fields::SPECIES, 0, &|i| set.species(i));
        for axis in 0..D {
            put(fields::VELOCITY, axis, &|i| particles[i].velocity[axis]);
        }
        engine
    }

    /// Time per stage since the start or the last [`clear_timings`](Self::clear_timings).
    pub fn timings(&self) -> &Timings {
        &self.timings
    }
    /// Starts the clocks anew.
    pub fn clear_timings(&mut self) {
        self.timings.clear();
    }
    /// The number of pairs last found, each counted from both ends.
    pub fn pair_count(&self) -> usize {
        self.list.pairs()
    }
    /// The neighbours last found, by original numbers, each list ascending.
    pub fn neighbours(&self) -> Vec<Vec<u32>> {
        let mut all = vec![Vec::new(); self.identity.len()];
        for (place, &original) in self.identity.iter().enumerate() {
            let list = &mut all[original as usize];
            list.extend(self.list.neighbours(place).iter().map(|&b| self.identity[b as usize]));
            list.sort_unstable();
        }
        all
    }

    fn slots(&self, fields: &[Field]) -> Result<Vec<usize>, EngineError> {
        let missing = |c: Component| EngineError(format!("this engine was made without the field {}", c.name(D)));
        self.store.slots(fields, D).map_err(missing)
    }

    fn slot(&self, component: Component) -> Result<usize, EngineError> {
        Ok(self.slots(&[component.field])?[component.index])
    }

    fn layout<P: Pass<D>>(&self, pass: &P) -> Result<Layout, EngineError> {
        let slots = |part| -> Result<Vec<Option<usize>>, EngineError> {
            let slot = |component: Option<Component>| component.map(|component| self.slot(component)).transpose();
            used_components::<D, P>(pass, part).into_iter().map(slot).collect()
        };
        // For what the pass has no use for, the first number there is does as well as any other.
        let read = |part| Ok(slots(part)?.into_iter().map(Option::unwrap_or_default).collect());
        let reduction = |sum: Option<Component>| sum.map_or(Reduction::Sum, |sum| sum.field.reduction);
        let layout = Layout {
            own: read(Part::Own)?,
            other: read(Part::Other)?,
            reductions: used_components::<D, P>(pass, Part::Sums).into_iter().map(reduction).collect(),
            out: slots(Part::Out)?,
        };
        let most = layout.record_len(D).max(layout.reductions.len());
        if most > MOST {
            return Err(EngineError(format!("pass {} handles {most} numbers a pair; the most is {MOST}", P::NAME)));
        }
        Ok(layout)
    }

    fn sort(&mut self) -> Result<(), EngineError> {
        let views = views(&self.coordinates);
        self.order.compute(views, &self.length, self.level).map_err(EngineError::from_display)?;
        for axis in 0..D {
            let mut sorted = Vec::new();
            self.order.apply(&self.coordinates[axis], &mut sorted);
            self.coordinates[axis] = sorted;
        }
        let mut identity = Vec::new();
        self.order.apply(&self.identity, &mut identity);
        self.identity = identity;
        self.store.permute(self.order.permutation());
        Ok(())
    }
}

fn views<C, const D: usize>(columns: &[Vec<C>; D]) -> [&[C]; D] {
    std::array::from_fn(|axis| columns[axis].as_slice())
}

impl<T: Number, const D: usize> Engine<D> for LaneEngine<T, D> {
    fn particle_count(&self) -> usize {
        self.identity.len()
    }

    fn find_neighbours(&mut self, support: f64) -> Result<(), EngineError> {
        let start = Instant::now();
        if self.searches.is_multiple_of(ORDER_EVERY) {
            self.sort()?;
        }
        self.searches += 1;
        self.timings.add("order", start);

        let start = Instant::now();
        let slot = self.slot(Component { field: fields::SMOOTHING_LENGTH, index: 0 })?;
        let support = T::from_f64(support);
        self.store.column(slot).map(|h| support * h).collect_into_vec(&mut self.reach);
        self.list
            .build(views(&self.coordinates), &self.reach, &self.length, self.level)
            .map_err(EngineError::from_display)?;
        self.timings.add("neighbour_list", start);
        Ok(())
    }

    // Never inlined, so that optimised builds too take it from where it is compiled already (`instances.rs`).
    #[inline(never)]
    fn run_pass<P: Pass<D>>(&mut self, pass: &P) -> Result<(), EngineError> {
        let start = Instant::now();
        let layout = self.layout(pass)?;
        if self.list.particles() != self.identity.len() {
            return Err(EngineError(format!("pass {} was asked for before neighbours were found", P::NAME)));
        }
        let (len, block_len) = (layout.record_len(D), self.store.block_len());
        self.records.resize(self.identity.len() * len, T::Word::default());
        let coordinates = &self.coordinates;
        self.records.par_chunks_mut(len * BLOCK).zip(self.store.blocks().par_chunks(block_len)).enumerate().for_each(
            |(block, (records, values))| pack_block::<T, D>(&layout, coordinates, block * BLOCK, values, records),
        );
        let (records, level) = (&self.records, self.level);
        let unit = self.length.map(T::Coordinate::unit);
        let segments = self.list.segments();
        self.store.blocks_mut().par_chunks_mut(SEGMENT / BLOCK * block_len).zip(segments).for_each(
            |(blocks, segment)| {
                let layout = &layout;
                let inputs = Inputs { pass, layout, segment, coordinates, records, unit };
                dispatch(level, SegmentSweep { inputs, block_len, blocks });
            },
        );
        self.timings.add(P::NAME, start);
        Ok(())
    }

    #[inline(never)]
    fn run_update<U: Update<D>>(&mut self, update: &U, time_step: f64) -> Result<(), EngineError> {
        let start = Instant::now();
        let footprint = Footprint::of_update::<D, U>();
        let (own, out) = (self.slots(&footprint.own)?, self.slots(&footprint.out)?);
        let (block_len, level, time_step) = (self.store.block_len(), self.level, T::from_f64(time_step));
        self.store.blocks_mut().par_chunks_mut(SEGMENT / BLOCK * block_len).for_each(|blocks| {
            let program = BlockUpdate { update, own: &own, out: &out, time_step, blocks, block_len };
            dispatch(level, InDimension::<D, _>(program));
        });
        self.timings.add(U::NAME, start);
        Ok(())
    }

    fn drift(&mut self) -> Result<(), EngineError> {
        let start = Instant::now();
        let slots = self.slots(&[fields::DISPLACEMENT])?;
        for (axis, &slot) in slots.iter().enumerate() {
            let length = self.length[axis];
            let store = &self.store;
            let far = |d: T| {
                let twice = 2.0 * d.to_f64().abs();
                twice.is_nan() || twice >= length
            };
            if store.column(slot).any(far) {
                return Err(EngineError(format!(
                    "a particle moves by more than half the box along axis {axis} in one step; the run has gone wrong"
                )));
            }
            self.coordinates[axis].par_iter_mut().enumerate().for_each(|(place, coordinate)| {
                *coordinate = T::moved(*coordinate, store.at(slot, place), length);
            });
        }
        self.timings.add("drift", start);
        Ok(())
    }

    fn minimum(&mut self, field: Field) -> Result<f64, EngineError> {
        let slot = self.slot(Component { field, index: 0 })?;
        Ok(self.store.column(slot).map(T::to_f64).reduce(|| f64::INFINITY, smaller))
    }

    fn read(&mut self, component: Component) -> Result<Vec<f64>, EngineError> {
        let slot = self.slot(component)?;
        let mut values = vec![0.0; self.identity.len()];
        for (place, &original) in self.identity.iter().enumerate() {
            values[original as usize] = self.store.at(slot, place).to_f64();
        }
        Ok(values)
    }

    fn write(&mut self, component: Component, values: &[f64]) -> Result<(), EngineError> {
        let slot = self.slot(component)?;
        if values.len() != self.identity.len() {
            let (found, wanted) = (values.len(), self.identity.len());
            return Err(EngineError(format!("{} has {found} values for {wanted} particles", component.name(D))));
        }
        let identity = &self.identity;
        self.store.set_column(slot, |place| T::from_f64(values[identity[place] as usize]));
        Ok(())
    }

    fn coordinates(&mut self, axis: usize) -> Result<Vec<u64>, EngineError> {
        let mut values = vec![0; self.identity.len()];
        for (place, &original) in self.identity.iter().enumerate() {
            values[original as usize] = T::coordinate_bits(self.coordinates[axis][place]);
        }
        Ok(values)
    }

    fn place(&mut self, axis: usize, coordinates: &[u64]) -> Result<(), EngineError> {
        if coordinates.len() != self.identity.len() {
            let (found, wanted) = (coordinates.len(), self.identity.len());
            return Err(EngineError(format!("axis {axis} has {found} coordinates for {wanted} particles")));
        }
        let held = |bits: u64| T::coordinate_bits(T::coordinate(bits)) == bits;
        if let Some(particle) = coordinates.iter().position(|&bits| !held(bits)) {
            return Err(EngineError(format!(
                "the coordinate of particle {particle} on axis {axis} has more digits than single precision keeps; \
                 use double precision"
            )));
        }
        for (coordinate, &original) in self.coordinates[axis].iter_mut().zip(&self.identity) {
            *coordinate = T::coordinate(coordinates[original as usize]);
        }
        Ok(())
    }

    fn arrangement(&self) -> Arrangement {
        Arrangement { order: self.identity.clone(), searches: self.searches }
    }

    fn arrange(&mut self, arrangement: &Arrangement) -> Result<(), EngineError> {
        let sources = arrangement.sources(&self.identity)?;
        self.store.permute(&sources);
        for column in &mut self.coordinates {
            *column = sources.iter().map(|&place| column[place as usize]).collect();
        }
        self.identity.clone_from(&arrangement.order);
        self.searches = arrangement.searches;
        self.forget_neighbours();
        Ok(())
    }

    fn forget_neighbours(&mut self) {
        self.list = NeighbourList::default();
        self.records = Vec::new();
    }
}
