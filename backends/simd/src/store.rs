//! Where the particles' fields are kept: in blocks of 16 particles, each block holding all fields.
//!
//! A block's fields are one slice, so a thread that owns a block may read and write all of them, and the neighbours' fields a
//! pass reads come from a separate packed copy: no two threads ever touch the same data.

use crate::number::Number;
use etalon_kernels_gen::{Component, Field, components};
use rayon::prelude::*;
use std::collections::HashMap;

/// Particles in a block.
pub const BLOCK: usize = 16;

/// All fields of all particles.
pub struct Store<T> {
    slots: HashMap<Component, usize>,
    width: usize,
    count: usize,
    blocks: Vec<T>,
}

impl<T: Number> Store<T> {
    /// Room for the components of these fields. Beyond the last particle, blocks are filled with ones: finite whatever is done.
    pub fn new(fields: &[Field], dimension: usize, count: usize) -> Self {
        let slots: HashMap<_, _> = components(fields, dimension).into_iter().zip(0..).collect();
        let width = slots.len();
        let blocks = vec![T::one(); count.div_ceil(BLOCK) * width * BLOCK];
        Store { slots, width, count, blocks }
    }

    /// Where each component of a record is in a block, or the first one that is not there.
    pub fn slots(&self, fields: &[Field], dimension: usize) -> Result<Vec<usize>, Component> {
        components(fields, dimension).into_iter().map(|c| self.slots.get(&c).copied().ok_or(c)).collect()
    }
    /// Numbers in a block.
    pub fn block_len(&self) -> usize {
        self.width * BLOCK
    }
    /// The blocks, one after the other.
    pub fn blocks(&self) -> &[T] {
        &self.blocks
    }
    /// The blocks, to write.
    pub fn blocks_mut(&mut self) -> &mut [T] {
        &mut self.blocks
    }
    /// One number of one particle.
    pub fn at(&self, slot: usize, particle: usize) -> T {
        self.blocks[self.index(slot, particle)]
    }

    fn index(&self, slot: usize, particle: usize) -> usize {
        particle / BLOCK * self.block_len() + slot * BLOCK + particle % BLOCK
    }

    /// A component as a column.
    pub fn column(&self, slot: usize) -> impl IndexedParallelIterator<Item = T> {
        (0..self.count).into_par_iter().map(move |particle| self.at(slot, particle))
    }

    /// Sets a component from a column.
    pub fn set_column(&mut self, slot: usize, value: impl Fn(usize) -> T + Sync) {
        let (len, count) = (self.block_len(), self.count);
        self.blocks.par_chunks_mut(len).enumerate().for_each(|(block, values)| {
            let first = block * BLOCK;
            for k in 0..BLOCK.min(count - first) {
                values[slot * BLOCK + k] = value(first + k);
            }
        });
    }

    /// The particles in another order: place `i` gets the particle at `order[i]`. One component after the other, so that no
    /// more than one is kept twice.
    pub fn permute(&mut self, order: &[u32]) {
        let mut sorted = Vec::with_capacity(self.count);
        for slot in 0..self.width {
            order.par_iter().map(|&source| self.at(slot, source as usize)).collect_into_vec(&mut sorted);
            self.set_column(slot, |place| sorted[place]);
        }
    }
}
