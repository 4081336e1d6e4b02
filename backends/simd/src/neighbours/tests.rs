//! The fast search against the direct double loop, on many kinds of particle sets.

mod bad_input;
mod boxes;
mod cost;
mod fixed_point;
mod sets;
mod sorting;

use super::{Coordinate, NeighbourList, Order, PADDING, Scalar, brute_force};
use fearless_simd::Level;

/// A particle set: positions as fractions of the torus, support radii, side lengths.
#[derive(Debug, Clone)]
struct Set<const D: usize> {
    fractions: Vec<[f64; D]>,
    reach: Vec<f64>,
    length: [f64; D],
}

/// Every instruction set of this machine, the scalar fallback included.
fn levels() -> Vec<Level> {
    let best = Level::new();
    #[cfg(target_arch = "x86_64")]
    let lesser = {
        use fearless_simd::Simd;
        [
            best.as_avx2().map(|level| level.level()),
            best.as_sse4_2().map(|level| level.level()),
            best.as_sse2().map(|level| level.level()),
        ]
    };
    #[cfg(not(target_arch = "x86_64"))]
    let lesser = [None];
    [Level::fallback(), best].into_iter().chain(lesser.into_iter().flatten()).collect()
}

fn in_pool<T: Send>(threads: usize, run: impl FnOnce() -> T + Send) -> T {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a thread pool").install(run)
}

/// The coordinates and support radii of a set in the representation C.
fn arrays<C: Coordinate, const D: usize>(set: &Set<D>) -> ([Vec<C>; D], Vec<C::Scalar>) {
    let axis = |k: usize| set.fractions.iter().map(|point| C::from_fraction(point[k])).collect();
    (std::array::from_fn(axis), set.reach.iter().map(|reach| C::Scalar::from_f64(*reach)).collect())
}

/// The list as a vector of neighbours for each particle; checks what the list says about itself on the way.
fn rows<C: Coordinate, const D: usize>(list: &NeighbourList<C, D>) -> Vec<Vec<u32>> {
    let rows: Vec<Vec<u32>> = (0..list.particles()).map(|i| list.neighbours(i).to_vec()).collect();
    assert_eq!(list.pairs(), rows.iter().map(Vec::len).sum::<usize>());
    let mut particle = 0;
    for segment in list.segments() {
        assert_eq!(segment.first(), particle);
        for target in 0..segment.particles() {
            assert_eq!(segment.neighbours(target), rows[particle]);
            let (padded, count) = segment.padded(target);
            assert_eq!(padded.len(), count + PADDING);
            assert_eq!(padded[..count], rows[particle]);
            assert!(padded.iter().all(|j| (*j as usize) < list.particles()), "padding names no particle");
            particle += 1;
        }
    }
    assert_eq!(particle, list.particles());
    rows
}

/// Orders and lists the set in both representations, and compares with brute force on every level and for one and two
/// threads. Returns the number of pairs found in `u32`, so that a caller can check that there were any.
fn check<const D: usize>(set: &Set<D>) -> usize {
    check_as::<u64, D>(set);
    check_as::<u32, D>(set)
}

fn check_as<C: Coordinate, const D: usize>(set: &Set<D>) -> usize {
    let (coordinates, reach) = arrays::<C, D>(set);
    let unsorted: [&[C]; D] = coordinates.each_ref().map(Vec::as_slice);

    let mut order = Order::default();
    order.compute(unsorted, &set.length, Level::fallback()).expect("an order");
    let permutation = order.permutation().to_vec();
    let mut seen = permutation.clone();
    seen.sort_unstable();
    assert!(seen.into_iter().eq(0..set.reach.len() as u32), "the order is not a permutation");
    let mut sorted: [Vec<C>; D] = std::array::from_fn(|_| Vec::new());
    for (axis, sorted) in coordinates.iter().zip(&mut sorted) {
        order.apply(axis, sorted);
    }
    let mut sorted_reach = Vec::new();
    order.apply(&reach, &mut sorted_reach);

    let sorted: [&[C]; D] = sorted.each_ref().map(Vec::as_slice);
    let expected = brute_force(sorted, &sorted_reach, &set.length);
    // One list for all, as in a run: what a step leaves behind must not show in the next.
    let mut list = NeighbourList::default();
    for level in levels() {
        for threads in [1, 2] {
            in_pool(threads, || {
                order.compute(unsorted, &set.length, level).expect("an order");
                assert_eq!(order.permutation(), permutation, "order with {level:?}, {threads} threads");
                list.build(sorted, &sorted_reach, &set.length, level).expect("a list");
            });
            assert_eq!(rows(&list), expected, "list with {level:?}, {threads} threads");
        }
    }
    // The list does not need the order.
    list.build(unsorted, &reach, &set.length, Level::new()).expect("a list");
    assert_eq!(rows(&list), brute_force(unsorted, &reach, &set.length), "unsorted");
    expected.iter().map(Vec::len).sum()
}

/// Numbers in [0, 1) that look random and are the same on every machine.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 * (-53_f64).exp2()
    }

    fn point<const D: usize>(&mut self) -> [f64; D] {
        std::array::from_fn(|_| self.next())
    }
}
