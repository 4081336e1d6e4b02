//! What the search costs, in candidates held against each target: a search that tested everything would be right, but slow.

use super::{Random, Set, arrays};
use crate::neighbours::list::Segment;
use crate::neighbours::search::{SEGMENT, Scratch, Search};
use crate::neighbours::tree::Tree;
use crate::neighbours::{Coordinate, Order};
use fearless_simd::{Level, dispatch};

/// Neighbours and candidates per particle, of all particles of the set.
fn cost(set: &Set<3>) -> (f64, f64) {
    let level = Level::new();
    let (coordinates, reach) = arrays::<u32, 3>(set);
    let mut order = Order::default();
    order.compute(coordinates.each_ref().map(Vec::as_slice), &set.length, level).expect("an order");
    let sorted = coordinates.each_ref().map(|axis| {
        let mut sorted = Vec::new();
        order.apply(axis, &mut sorted);
        sorted
    });
    let coordinates = sorted.each_ref().map(Vec::as_slice);
    let mut sorted_reach = Vec::new();
    order.apply(&reach, &mut sorted_reach);
    let reach = &sorted_reach[..];

    let mut tree = Tree::default();
    assert!(tree.build(coordinates, reach, level));
    let search = Search { coordinates, reach, unit: set.length.map(u32::unit), tree: &tree };
    let mut scratch = Scratch::default();
    let mut pairs = 0;
    for number in 0..reach.len().div_ceil(SEGMENT) {
        let mut segment = Segment::default();
        segment.begin(number * SEGMENT);
        dispatch!(level, simd => search.segment(simd, number, &mut scratch, &mut segment)).expect("memory");
        pairs += segment.pairs();
    }
    let particles = reach.len() as f64;
    (pairs as f64 / particles, scratch.tested as f64 / particles)
}

/// For cubic groups of 16, reach r and n = 4/3 pi r^3 neighbours at density 1, the candidates are those of a cube of side
/// s = 16^(1/3) rounded off by r: s^3 + 6 s^2 r + 3 pi s r^2 + 4/3 pi r^3.
fn candidates_of_cubes(neighbours: f64) -> f64 {
    let (s, r) = (16_f64.cbrt(), (neighbours * 0.75 / std::f64::consts::PI).cbrt());
    s.powi(3) + 6.0 * s * s * r + 3.0 * std::f64::consts::PI * s * r * r + neighbours
}

#[test]
fn uniform_particles() {
    let count = 30_000;
    let mut random = Random(59);
    let reach = (100.0 * 0.75 / std::f64::consts::PI / f64::from(count)).cbrt();
    let set = Set::<3> {
        fractions: (0..count).map(|_| random.point()).collect(),
        reach: (0..count).map(|_| reach).collect(),
        length: [1.0; 3],
    };
    let (neighbours, candidates) = cost(&set);
    // Runs along the curve are not cubes: grant them half as much again.
    let bound = 1.5 * candidates_of_cubes(neighbours);
    println!("uniform: {neighbours:.1} neighbours, {candidates:.0} candidates, bound {bound:.0}");
    assert!((80.0..120.0).contains(&neighbours) && candidates < bound);
}

#[test]
fn dense_regions_do_not_pay_for_sparse_ones() {
    // 20 000 particles in a cube of 1/100 of the box, 500 in the rest, each with the reach for about 60 neighbours of its kind.
    let mut random = Random(61);
    let mut set = Set::<3> { fractions: vec![], reach: vec![], length: [1.0; 3] };
    for _ in 0..20_000 {
        set.fractions.push(random.point::<3>().map(|x| 0.4 + 0.01 * x));
        set.reach.push(0.01 * (60.0 * 0.75 / std::f64::consts::PI / 20_000.0_f64).cbrt());
    }
    let dense = cost(&set);
    for _ in 0..500 {
        // Not so near to the cluster that its support holds it: that would be real neighbours.
        let place = random.point::<3>();
        let distance: f64 = place.iter().map(|x| (x - 0.405).powi(2)).sum();
        if distance.sqrt() > 0.4 {
            set.fractions.push(place);
            set.reach.push((60.0 * 0.75 / std::f64::consts::PI / 500.0_f64).cbrt());
        }
    }
    let both = cost(&set);
    println!("dense alone: {dense:?}, with a sparse background: {both:?} (neighbours, candidates)");
    assert!(dense.1 < 1.5 * candidates_of_cubes(60.0));
    // A group of 16 sparse particles may see the whole cluster from afar, as its box is large; there are 500 / 16 + 2 = 33 such
    // groups at most, with 16 * 20 000 candidates each, shared by 20 000 particles. Were supports not kept apart, every dense
    // particle would see the whole cluster: 20 000 candidates a particle.
    let sparse_groups = 33.0 * 16.0;
    assert!(both.1 < dense.1 + sparse_groups, "{} candidates instead of {}", both.1, dense.1);
}
