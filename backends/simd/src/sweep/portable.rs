//! The same driver without vector instructions: lanes one by one, each sum and rounding where the vector code has it.

use super::{BlockUpdate, InDimension, Inputs, SegmentSweep};
use crate::neighbours::Coordinate;
use crate::number::{Number, reduce_pairwise};
use crate::store::BLOCK;
use etalon_kernels_gen::{Pass, Quantity, Real, Record, Separation, Update, Vector, axes};

/// No precision has more lanes.
const MOST_LANES: usize = 16;

/// One segment of particles through a pass.
pub fn segment<T: Number, P: Pass<D>, const D: usize>(sweep: SegmentSweep<'_, T, P, D>) {
    let SegmentSweep { inputs, block_len, blocks } = sweep;
    for target in 0..inputs.segment.particles() {
        let (block, k) = (&mut blocks[target / BLOCK * block_len..][..block_len], target % BLOCK);
        let own: P::Own<T::Lane> = record(&inputs.layout.own, block, k);
        let mut lanes = sums(&inputs, &own, target).map(|sums| {
            let mut values = Vec::with_capacity(inputs.layout.reductions.len());
            sums.for_each(|value| values.push(value));
            values.into_iter()
        });
        let mut reductions = inputs.layout.reductions.iter();
        let reduced = P::Sums::<T::Lane>::from_each(|| {
            let mut values = [T::Lane::zero(); MOST_LANES];
            for (value, lane) in values.iter_mut().zip(&mut lanes) {
                *value = lane.next().unwrap_or_else(T::Lane::zero);
            }
            let reduction = reductions.next().copied().unwrap_or(etalon_kernels_gen::Reduction::Sum);
            reduce_pairwise(&mut values[..T::LANES], reduction)
        });
        let mut slots = inputs.layout.out.iter();
        inputs.pass.finish(&own, &reduced).for_each(|value| {
            if let Some(Some(slot)) = slots.next() {
                block[slot * BLOCK + k] = T::from_lane(value);
            }
        });
    }
}

/// The sums of one particle, one for each lane.
fn sums<T: Number, P: Pass<D>, const D: usize>(
    inputs: &Inputs<'_, T, P, D>,
    own: &P::Own<T::Lane>,
    target: usize,
) -> [P::Sums<T::Lane>; MOST_LANES] {
    let place = inputs.segment.first() + target;
    let len = inputs.layout.record_len(D);
    let mut lanes = [P::Sums::<T::Lane>::from_each(T::Lane::zero); MOST_LANES];
    for (at, &neighbour) in inputs.segment.neighbours(target).iter().enumerate() {
        let neighbour = neighbour as usize;
        let x_ab = Vector(axes(|axis| {
            let column = &inputs.coordinates[axis];
            column[place].separation(column[neighbour], inputs.unit[axis]).lane()
        }));
        let mut words = inputs.records[neighbour * len + D..].iter();
        let other =
            P::Other::<T::Lane>::from_each(|| words.next().map_or_else(T::Lane::zero, |&w| T::from_word(w).lane()));
        let terms = inputs.pass.pair(own, &other, &Separation { x_ab, r_squared: x_ab.norm_squared() });
        let lane = &mut lanes[at % T::LANES];
        *lane = lane.combine(terms);
    }
    lanes
}

/// Some blocks of particles through an update.
pub fn update<T: Number, U: Update<D>, const D: usize>(program: InDimension<D, BlockUpdate<'_, T, U>>) {
    let BlockUpdate { update, own, out, time_step, blocks, block_len } = program.0;
    for block in blocks.chunks_exact_mut(block_len) {
        for k in 0..BLOCK {
            let own: U::Own<T::Lane> = record(own, block, k);
            store(update.apply(&own, time_step.lane()), out, block, k);
        }
    }
}

fn record<T: Number, Q: Quantity<T::Lane>>(slots: &[usize], block: &[T], k: usize) -> Q {
    let mut slots = slots.iter();
    Q::from_each(|| slots.next().map_or_else(T::Lane::zero, |slot| block[slot * BLOCK + k].lane()))
}

fn store<T: Number, Q: Quantity<T::Lane>>(record: Q, slots: &[usize], block: &mut [T], k: usize) {
    let mut slots = slots.iter();
    record.for_each(|value| {
        if let Some(slot) = slots.next() {
            block[slot * BLOCK + k] = T::from_lane(value);
        }
    });
}
