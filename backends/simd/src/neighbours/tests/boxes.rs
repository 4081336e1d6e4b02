//! The shape of the torus: thin boxes, tubes, and particles that fill only a part of it.

use super::{Random, Set, check, in_pool};
use crate::neighbours::{Coordinate, NeighbourList, Order, Scalar, brute_force};
use etalon_reference::domain::Domain;
use fearless_simd::Level;

#[test]
fn a_box_as_thin_as_two_supports() {
    // The support just fits: every particle sees its partner from one side only, and the farthest at half of the length.
    let mut random = Random(29);
    let fractions = (0..800).map(|_| random.point()).collect();
    let set = Set::<3> { fractions, reach: vec![0.125; 800], length: [1.0, 0.25, 0.5] };
    assert!(check(&set) > 800);
}

#[test]
fn a_partner_at_half_of_the_box() {
    // The partner is as far by one way around as by the other. At exactly the reach it is no neighbour, and a little nearer it
    // is one, once.
    let half = Set::<2> { fractions: vec![[0.0, 0.0], [0.5, 0.0]], reach: vec![0.5, 0.625], length: [1.25, 2.5] };
    assert_eq!(check(&half), 0);
    let nearer = Set { fractions: vec![[0.0, 0.0], [0.499, 0.0]], ..half };
    assert_eq!(check(&nearer), 2);
}

#[test]
fn a_tube_with_two_densities() {
    // The Sod tube: dense in the first half, an eighth of the density in the second, supports to match.
    let mut random = Random(31);
    let mut set = Set::<3> { fractions: vec![], reach: vec![], length: [10.0, 1.0, 1.0] };
    for n in 0..2700 {
        let dense = n % 9 != 0;
        let [x, y, z] = random.point();
        set.fractions.push([if dense { 0.5 * x } else { 0.5 + 0.5 * x }, y, z]);
        set.reach.push(if dense { 0.2 } else { 0.4 });
    }
    assert!(check(&set) > 10 * 2700);
}

#[test]
fn an_open_box_embedded_in_a_larger_torus() {
    // The same cloud in the middle of tori of 2 and of 2^10 times its extent has the same neighbours, and they are those of
    // open space: no pair across the seam.
    let mut random = Random(37);
    let cloud: Vec<[f64; 3]> = (0..700).map(|_| random.point()).collect();
    let reach: Vec<f64> = cloud.iter().map(|_| 0.1 + 0.1 * random.next()).collect();
    let open = |i: usize, j: usize| {
        let distance: f64 = (0..3).map(|k| (cloud[i][k] - cloud[j][k]).powi(2)).sum();
        i != j && distance.sqrt() < reach[i].max(reach[j])
    };
    let pairs: usize = (0..700).map(|i| (0..700).filter(|j| open(i, *j)).count()).sum();
    for scale in [2.0, 1024.0] {
        let fractions = cloud.iter().map(|point| point.map(|x| 0.5 + x / scale)).collect();
        let set = Set::<3> { fractions, reach: reach.clone(), length: [scale; 3] };
        assert_eq!(check(&set), pairs, "torus of length {scale}");
    }
}

#[test]
fn a_box_with_walls_that_is_open_along_one_axis() {
    // As the tube is made: open along x, embedded in a torus of 2.5 sides, with layers at rest at either end on a lattice; periodic across.
    // Pairs across the seam of y and z count, pairs from one wall to the other do not.
    let mut random = Random(43);
    let domain = Domain::new([0.0; 3], [1.0, 0.5, 0.25], [false, true, true]).expect("a box");
    let inside = (0..600).map(|_| {
        let [x, y, z] = random.point();
        [0.2 + 0.6 * x, 0.5 * y, 0.25 * z]
    });
    let walls = [0.02, 0.06, 0.1, 0.9, 0.94, 0.98]
        .into_iter()
        .flat_map(|x| (0..72).map(move |n| [x, (f64::from(n % 12) + 0.5) / 24.0, (f64::from(n / 12) + 0.5) / 24.0]));
    let places: Vec<[f64; 3]> = inside.chain(walls).collect();
    let reach: Vec<f64> = places.iter().map(|_| 0.1 + 0.02 * random.next()).collect();
    let around = |apart: f64, side: f64| apart.abs().min(side - apart.abs());
    let near = |i: usize, j: usize| {
        let [x, y, z] = std::array::from_fn(|axis| places[i][axis] - places[j][axis]);
        let squares = x.powi(2) + around(y, 0.5).powi(2) + around(z, 0.25).powi(2);
        i != j && squares.sqrt() < reach[i].max(reach[j])
    };
    let count = places.len();
    let pairs: usize = (0..count).map(|i| (0..count).filter(|j| near(i, *j)).count()).sum();
    let fraction = |axis: usize, x: f64| domain.encode(axis, x) as f64 / 2f64.powi(64);
    let fractions = places.iter().map(|place| std::array::from_fn(|axis| fraction(axis, place[axis]))).collect();
    let set = Set::<3> { fractions, reach, length: domain.torus_length() };
    assert_eq!(check(&set), pairs);
    assert!(pairs > 20 * count, "only {pairs} pairs");
}

/// Enough particles for several tasks and sort threads; only the best level, as brute force over all pairs is slow.
#[test]
fn many_particles_on_several_threads() {
    let mut random = Random(41);
    let count = 60_000;
    let points: Vec<[u32; 3]> = (0..count).map(|_| random.point::<3>().map(u32::from_fraction)).collect();
    let axis = |k: usize| -> Vec<u32> { points.iter().map(|point| point[k]).collect() };
    let coordinates = [axis(0), axis(1), axis(2)];
    let reach = vec![f32::from_f64(0.03); count];
    let run = |threads: usize| {
        in_pool(threads, || {
            let mut order = Order::default();
            order.compute(coordinates.each_ref().map(Vec::as_slice), &[1.0; 3], Level::new()).expect("an order");
            let sorted = coordinates.each_ref().map(|axis| {
                let mut sorted = Vec::new();
                order.apply(axis, &mut sorted);
                sorted
            });
            let mut list = NeighbourList::default();
            list.build(sorted.each_ref().map(Vec::as_slice), &reach, &[1.0; 3], Level::new()).expect("a list");
            (order.permutation().to_vec(), sorted, super::rows(&list))
        })
    };
    let (permutation, sorted, rows) = run(1);
    for threads in [2, 5] {
        let (other_permutation, _, other_rows) = run(threads);
        assert!(permutation == other_permutation && rows == other_rows, "{threads} threads differ from one");
    }
    // Held against brute force for some targets: those alone have a support that matters.
    for target in (0..count).step_by(3001) {
        let some: [Vec<u32>; 3] = sorted.each_ref().map(|axis| [&[axis[target]], axis.as_slice()].concat());
        let mut only_target = vec![f32::MIN_POSITIVE.sqrt() * 2.0; count + 1];
        only_target[0] = reach[0];
        let expected = first_row(some.each_ref().map(Vec::as_slice), &only_target);
        let found: Vec<u32> = rows[target].clone();
        assert_eq!(
            found,
            expected.into_iter().filter(|j| *j as usize != target).collect::<Vec<_>>(),
            "target {target}"
        );
    }
}

/// Neighbours of particle 0 among the others, numbered without it.
fn first_row(coordinates: [&[u32]; 3], reach: &[f32]) -> Vec<u32> {
    let mut found = Vec::new();
    for j in 1..reach.len() {
        let pair = brute_force(
            coordinates.map(|axis| [axis[0], axis[j]]).each_ref().map(|axis| &axis[..]),
            &[reach[0]; 2],
            &[1.0; 3],
        );
        if !pair[0].is_empty() {
            found.push(j as u32 - 1);
        }
    }
    found
}
