//! The driver that runs any pass: neighbours in lanes, one particle after the other.

mod portable;

use crate::neighbours::Segment;
use crate::number::{CHUNK, Number};
use crate::store::BLOCK;
use etalon_kernels_gen::lanes::{LaneLevel, LaneProgram};
use etalon_kernels_gen::{Choose, Pass, Quantity, Real, Record, Reduction, Separation, Update, Vector, axes};

/// No pass sums, reads or writes more numbers than this.
pub const MOST: usize = 48;

/// Where a pass finds its fields.
pub struct Layout {
    /// Slots read of the particle itself.
    pub own: Vec<usize>,
    /// Slots read of each neighbour, in the order of the record.
    pub other: Vec<usize>,
    /// How each sum is reduced.
    pub reductions: Vec<Reduction>,
    /// Slots written; none for a number that goes nowhere.
    pub out: Vec<Option<usize>>,
}

impl Layout {
    /// Words of a packed record: coordinates, then fields, padded to whole chunks.
    pub fn record_len(&self, dimension: usize) -> usize {
        (dimension + self.other.len()).next_multiple_of(CHUNK)
    }
}

/// What neighbours are read from: for each particle its coordinates and the fields of one pass, side by side.
pub fn pack_block<T: Number, const D: usize>(
    layout: &Layout,
    coordinates: &[Vec<T::Coordinate>; D],
    first: usize,
    block: &[T],
    records: &mut [T::Word],
) {
    let len = layout.record_len(D);
    for (k, record) in records.chunks_exact_mut(len).enumerate() {
        for axis in 0..D {
            record[axis] = T::coordinate_word(coordinates[axis][first + k]);
        }
        for (word, &slot) in record[D..].iter_mut().zip(&layout.other) {
            *word = block[slot * BLOCK + k].word();
        }
    }
}

/// One segment of particles through a pass.
pub struct SegmentSweep<'a, T: Number, P, const D: usize> {
    pub inputs: Inputs<'a, T, P, D>,
    pub block_len: usize,
    /// The blocks of the segment's particles.
    pub blocks: &'a mut [T],
}

/// What a sweep reads, the particle's own fields aside.
pub struct Inputs<'a, T: Number, P, const D: usize> {
    pub pass: &'a P,
    pub layout: &'a Layout,
    pub segment: &'a Segment,
    pub coordinates: &'a [Vec<T::Coordinate>; D],
    pub records: &'a [T::Word],
    pub unit: [T; D],
}

impl<T: Number, P: Pass<D>, const D: usize> LaneProgram for SegmentSweep<'_, T, P, D> {
    type Output = ();

    #[inline(always)]
    fn run<S: LaneLevel>(self, _: S) {
        let SegmentSweep { inputs, block_len, blocks } = self;
        let Inputs { pass, layout, segment, coordinates, .. } = inputs;
        let particles = segment.particles();
        let mut sums = [[T::default(); BLOCK]; MOST];
        for first in (0..particles).step_by(BLOCK) {
            let block = &mut blocks[first / BLOCK * block_len..][..block_len];
            for k in 0..BLOCK.min(particles - first) {
                let own = own_record::<T, S, P::Own<T::Lanes<S>>>(
                    &layout.own,
                    #[inline(always)]
                    |slot| T::splat::<S>(block[slot * BLOCK + k]),
                );
                let place = segment.first() + first + k;
                let at: [T::Words<S>; D] = axes(
                    #[inline(always)]
                    |axis| T::splat_coordinate::<S>(coordinates[axis][place]),
                );
                let mut slot = 0;
                inputs.sums(&own, at, first + k).for_each(
                    #[inline(always)]
                    |lanes| {
                        sums[slot][k] = match layout.reductions[slot] {
                            Reduction::Sum => T::sum_lanes::<S>(lanes),
                            Reduction::Max => T::max_lanes::<S>(lanes),
                        };
                        slot += 1;
                    },
                );
            }
            epilogue::<T, S, P, D>(pass, layout, block, &sums);
        }
    }

    fn one_by_one(self) {
        portable::segment(self);
    }
}

impl<T: Number, P: Pass<D>, const D: usize> Inputs<'_, T, P, D> {
    /// The sums of one particle over its neighbours, still in lanes.
    #[inline(always)]
    fn sums<S: LaneLevel>(
        &self,
        own: &P::Own<T::Lanes<S>>,
        at: [T::Words<S>; D],
        target: usize,
    ) -> P::Sums<T::Lanes<S>> {
        let unit: [T::Lanes<S>; D] = axes(
            #[inline(always)]
            |axis| T::splat::<S>(self.unit[axis]),
        );
        let mut sums = P::Sums::<T::Lanes<S>>::from_each(T::Lanes::<S>::zero);
        let (neighbours, count) = self.segment.padded(target);
        let mut done = 0;
        while done < count {
            let mut terms = self.terms(own, at, unit, &neighbours[done..done + T::LANES]);
            if count - done < T::LANES {
                // What lies beyond the last neighbour is some particle or other, and is replaced by nothing.
                let valid = T::first_lanes::<S>(count - done);
                let nothing = P::Sums::<T::Lanes<S>>::from_each(T::Lanes::<S>::zero);
                terms = terms.zip_with(
                    nothing,
                    #[inline(always)]
                    |term, zero| Choose::pick(valid, term, zero),
                );
            }
            sums = sums.combine(terms);
            done += T::LANES;
        }
        sums
    }

    /// What as many neighbours as there are lanes contribute.
    #[inline(always)]
    fn terms<S: LaneLevel>(
        &self,
        own: &P::Own<T::Lanes<S>>,
        at: [T::Words<S>; D],
        unit: [T::Lanes<S>; D],
        neighbours: &[u32],
    ) -> P::Sums<T::Lanes<S>> {
        let len = (D + P::Other::<T::Lanes<S>>::COUNT).next_multiple_of(CHUNK);
        let rows = T::rows(self.records, neighbours, len);
        let mut words = WordReader::<T, S> { chunk: T::transpose::<S>(&rows, 0), rows, next: 0 };
        let x_ab = Vector(axes(
            #[inline(always)]
            |axis| T::separation::<S>(at[axis], words.next(), unit[axis]),
        ));
        let other = P::Other::<T::Lanes<S>>::from_each(
            #[inline(always)]
            || T::numbers::<S>(words.next()),
        );
        self.pass.pair(own, &other, &Separation { x_ab, r_squared: x_ab.norm_squared() })
    }
}

/// The words of several records, one vector after the other.
struct WordReader<'a, T: Number, S: LaneLevel> {
    rows: T::Rows<'a>,
    chunk: [T::Words<S>; CHUNK],
    next: usize,
}

impl<T: Number, S: LaneLevel> WordReader<'_, T, S> {
    /// The next word of each record. Where this is called in a straight line, `next` is known when compiling.
    #[inline(always)]
    fn next(&mut self) -> T::Words<S> {
        let at = self.next;
        self.next += 1;
        if at > 0 && at.is_multiple_of(CHUNK) {
            self.chunk = T::transpose::<S>(&self.rows, at);
        }
        self.chunk[at % CHUNK]
    }
}

/// What the particles of a block make of their sums: particles in lanes.
#[inline(always)]
fn epilogue<T: Number, S: LaneLevel, P: Pass<D>, const D: usize>(
    pass: &P,
    layout: &Layout,
    block: &mut [T],
    sums: &[[T; BLOCK]; MOST],
) {
    let mut first = 0;
    while first < BLOCK {
        let own = own_record::<T, S, P::Own<T::Lanes<S>>>(
            &layout.own,
            #[inline(always)]
            |slot| T::load::<S>(&block[slot * BLOCK + first..]),
        );
        let mut j = 0;
        let sums = P::Sums::<T::Lanes<S>>::from_each(
            #[inline(always)]
            || {
                let sum = T::load::<S>(&sums[j][first..]);
                j += 1;
                sum
            },
        );
        let mut k = 0;
        pass.finish(&own, &sums).for_each(
            #[inline(always)]
            |value| {
                if let Some(slot) = layout.out[k] {
                    T::store::<S>(value, &mut block[slot * BLOCK + first..]);
                }
                k += 1;
            },
        );
        first += T::LANES;
    }
}

/// One block of particles through an update.
pub struct BlockUpdate<'a, T, U> {
    pub update: &'a U,
    pub own: &'a [usize],
    pub out: &'a [usize],
    pub time_step: T,
    pub blocks: &'a mut [T],
    pub block_len: usize,
}

/// Carries the dimension, which [`BlockUpdate`]'s fields do not name.
pub struct InDimension<const D: usize, B>(pub B);

impl<T: Number, U: Update<D>, const D: usize> LaneProgram for InDimension<D, BlockUpdate<'_, T, U>> {
    type Output = ();

    #[inline(always)]
    fn run<S: LaneLevel>(self, _: S) {
        let BlockUpdate { update, own, out, time_step, blocks, block_len } = self.0;
        let time_step = T::splat::<S>(time_step);
        for block in blocks.chunks_exact_mut(block_len) {
            let mut first = 0;
            while first < BLOCK {
                let own = own_record::<T, S, U::Own<T::Lanes<S>>>(
                    own,
                    #[inline(always)]
                    |slot| T::load::<S>(&block[slot * BLOCK + first..]),
                );
                let mut k = 0;
                update.apply(&own, time_step).for_each(
                    #[inline(always)]
                    |value| {
                        T::store::<S>(value, &mut block[out[k] * BLOCK + first..]);
                        k += 1;
                    },
                );
                first += T::LANES;
            }
        }
    }

    fn one_by_one(self) {
        portable::update(self);
    }
}

#[inline(always)]
fn own_record<T: Number, S: LaneLevel, Q: Quantity<T::Lanes<S>>>(
    slots: &[usize],
    load: impl Fn(usize) -> T::Lanes<S>,
) -> Q {
    let mut k = 0;
    Q::from_each(
        #[inline(always)]
        || {
            let slot = slots[k];
            k += 1;
            load(slot)
        },
    )
}
