//! A stable, parallel radix sort of keys with their indices.
//!
//! Threads write to places of the same array that do not overlap but are interleaved, which safe Rust can say only with
//! atomic cells. Relaxed loads and stores of 64 bits are ordinary moves on every processor that has them, so this costs
//! nothing.

use rayon::prelude::*;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// Below this many entries one thread is faster than several.
const ENTRIES_PER_THREAD: usize = 1 << 14;
/// Bits of a digit, at most: 2048 counters and 2048 write positions stay in the first-level cache.
const DIGIT_BITS: u32 = 11;

/// An entry: the key above, the index below.
#[inline(always)]
pub(super) fn entry(key: u32, index: u32) -> AtomicU64 {
    AtomicU64::new(u64::from(key) << 32 | u64::from(index))
}

/// The key of an entry.
#[inline(always)]
pub(super) fn key(entry: &AtomicU64) -> u32 {
    (entry.load(Relaxed) >> 32) as u32
}

/// The index of an entry.
#[inline(always)]
pub(super) fn index(entry: &AtomicU64) -> u32 {
    entry.load(Relaxed) as u32
}

/// Sorts by the lowest `key_bits` bits of the key, keeping the order of equal keys. `scratch` is overwritten.
///
/// The result does not depend on the number of threads, because the sort is stable.
pub(super) fn sort(entries: &mut Vec<AtomicU64>, scratch: &mut Vec<AtomicU64>, key_bits: u32) {
    scratch.resize_with(entries.len(), AtomicU64::default);
    let passes = key_bits.div_ceil(DIGIT_BITS);
    for pass in 0..passes {
        // Digits as equal as can be: 30 bits are three digits of 10.
        let from = key_bits * pass / passes;
        let bits = key_bits * (pass + 1) / passes - from;
        if scatter(entries, scratch, 32 + from, bits) {
            std::mem::swap(entries, scratch);
        }
    }
}

/// Sorts `source` by one digit into `target`; false if there was nothing to do because all digits are equal.
fn scatter(source: &[AtomicU64], target: &[AtomicU64], shift: u32, bits: u32) -> bool {
    let buckets = 1usize << bits;
    let digit = move |entry: u64| (entry >> shift) as usize & (buckets - 1);
    let chunk = source.len().div_ceil(rayon::current_num_threads()).max(ENTRIES_PER_THREAD);

    // How many entries of each digit each chunk has.
    let mut counts: Vec<Vec<u32>> = source
        .par_chunks(chunk)
        .map(|chunk| {
            // Two counters in turn: neighbours mostly have the same digit, and a counter waits for itself.
            let mut twofold = vec![[0; 2]; buckets];
            for (at, entry) in chunk.iter().enumerate() {
                twofold[digit(entry.load(Relaxed))][at % 2] += 1;
            }
            let count: Vec<u32> = twofold.iter().map(|[even, odd]| even + odd).collect();
            count
        })
        .collect();

    // Where each chunk writes its first entry of each digit.
    let mut start = 0;
    for bucket in 0..buckets {
        let before = start;
        for count in &mut counts {
            start += std::mem::replace(&mut count[bucket], start);
        }
        if (start - before) as usize == source.len() {
            return false;
        }
    }

    source.par_chunks(chunk).zip(&mut counts).for_each(|(chunk, position)| {
        for entry in chunk {
            let entry = entry.load(Relaxed);
            let position = &mut position[digit(entry)];
            target[*position as usize].store(entry, Relaxed);
            *position += 1;
        }
    });
    true
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn sorted(keys: &[u32], key_bits: u32, threads: usize) -> Vec<(u32, u32)> {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        let mut entries: Vec<AtomicU64> = keys.iter().zip(0..).map(|(key, index)| entry(*key, index)).collect();
        pool.install(|| sort(&mut entries, &mut Vec::new(), key_bits));
        entries.iter().map(|entry| (key(entry), index(entry))).collect()
    }

    proptest! {
        #[test]
        fn sorts_stably(keys in prop::collection::vec(any::<u32>(), 0..300), key_bits in 1u32..=32) {
            let keys: Vec<u32> = keys.iter().map(|key| key >> (32 - key_bits)).collect();
            let mut expected: Vec<(u32, u32)> = keys.iter().copied().zip(0..).collect();
            expected.sort();
            prop_assert_eq!(sorted(&keys, key_bits, 1), expected);
        }
    }

    #[test]
    fn many_threads_give_the_same_as_one() {
        // More entries than three threads take at least, with many equal keys.
        let keys: Vec<u32> = (0..60_000u32).map(|n| n.wrapping_mul(2_654_435_761) >> 15).collect();
        let mut expected: Vec<(u32, u32)> = keys.iter().copied().zip(0..).collect();
        expected.sort();
        for threads in [1, 2, 3] {
            assert_eq!(sorted(&keys, 17, threads), expected, "{threads} threads");
        }
    }
}
