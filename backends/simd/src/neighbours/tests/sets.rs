//! Particle sets, from regular to nasty.

use super::{Random, Set, check};
use proptest::prelude::*;

/// Points everywhere, with about `neighbours` neighbours each.
fn uniform<const D: usize>(count: usize, neighbours: f64, seed: u64) -> Set<D> {
    let mut random = Random(seed);
    let reach = 0.5 * (neighbours / count as f64).powf(1.0 / D as f64);
    Set {
        fractions: (0..count).map(|_| random.point()).collect(),
        reach: (0..count).map(|_| (reach * (0.8 + 0.4 * random.next())).min(0.5)).collect(),
        length: [1.0; D],
    }
}

#[test]
fn random_points() {
    // Sizes around those of a leaf (16) and of a segment (256), and one with three levels of boxes above the leaves.
    for count in [3, 15, 16, 17, 255, 256, 257, 1000, 4200] {
        for neighbours in [2.0, 30.0] {
            assert!(check(&uniform::<1>(count, neighbours, 1)) > 0);
            assert!(check(&uniform::<2>(count, neighbours, 2)) > 0);
            let pairs = check(&uniform::<3>(count, neighbours, 3));
            assert!(pairs > 0 || count == 3, "{count} points, {neighbours} neighbours");
        }
    }
}

#[test]
fn few_particles() {
    for fractions in [vec![], vec![[0.5; 3]], vec![[0.99, 0.5, 0.5], [0.01, 0.5, 0.5]]] {
        let pairs = check(&Set { reach: vec![0.1; fractions.len()], fractions: fractions.clone(), length: [1.0; 3] });
        // The two are neighbours through the periodic boundary only.
        assert_eq!(pairs, if fractions.len() == 2 { 2 } else { 0 });
    }
}

#[test]
fn lattice_with_distances_on_the_edge() {
    // 12 x 12 x 12 points one apart, a power of two times which is exact, with the reach at just the distance of a shell: a
    // pair at that distance is not a neighbour. The shells within sqrt(3) have 6 + 12 points, and 8 on the edge.
    let fractions: Vec<[f64; 3]> =
        (0..4096).map(|n: u32| [n % 16, n / 16 % 16, n / 256].map(|k| f64::from(k) / 16.0)).collect();
    let on_the_edge = Set { reach: vec![2.0; 4096], fractions, length: [16.0; 3] };
    // Within a distance of 2, exclusive: 6 at 1, 12 at sqrt 2, 8 at sqrt 3. The next are 6 at exactly 2.
    assert_eq!(check(&on_the_edge), 26 * 4096);
    let beyond_the_edge = Set { reach: vec![2.0_f64.next_up() + 1e-6; 4096], ..on_the_edge };
    assert_eq!(check(&beyond_the_edge), 32 * 4096);
}

#[test]
fn clusters_with_supports_to_match() {
    // Supports over a factor of 1000: a dense cluster within a thin background, and one large particle.
    let mut random = Random(7);
    let mut set = Set::<3> { fractions: vec![], reach: vec![], length: [1.0; 3] };
    for _ in 0..1500 {
        set.fractions.push(random.point::<3>().map(|x| 0.3 + 0.001 * x));
        set.reach.push(0.0001 * (0.5 + random.next()));
    }
    for _ in 0..500 {
        set.fractions.push(random.point());
        set.reach.push(0.1 * (0.5 + random.next()));
    }
    set.fractions.push([0.301, 0.301, 0.301]);
    set.reach.push(0.5);
    // The large one reaches the whole cluster, and the cluster reaches it back.
    assert!(check(&set) > 2 * 1500);
}

#[test]
fn coincident_points() {
    // All at one place: all are neighbours of one another.
    let count = 300;
    let set = Set::<2> { fractions: vec![[0.25, 0.75]; count], reach: vec![0.001; count], length: [1.0, 3.0] };
    assert_eq!(check(&set), count * (count - 1));
    // Twins in a random set.
    let mut set = uniform::<3>(400, 10.0, 11);
    set.fractions.extend_from_within(..);
    set.reach.extend_from_within(..);
    assert!(check(&set) >= 800);
}

#[test]
fn collinear_and_coplanar_points() {
    let mut random = Random(13);
    for flat in 1..3 {
        // Along the diagonal direction and in the plane of it, so that no axis is special.
        let fractions = (0..600)
            .map(|_| {
                let (a, b) = (random.next(), if flat == 2 { random.next() } else { 0.0 });
                [a, 0.5 * a + b, 0.25 * a + 0.5 * b]
            })
            .collect();
        let set = Set::<3> { fractions, reach: vec![0.05; 600], length: [1.0, 2.0, 4.0] };
        assert!(check(&set) > 600);
    }
    // All on a line along each axis in turn.
    for axis in 0..3 {
        let fractions =
            (0..500).map(|_| std::array::from_fn(|k| if k == axis { random.next() } else { 0.5 })).collect();
        assert!(check(&Set::<3> { fractions, reach: vec![0.01; 500], length: [1.0; 3] }) > 500);
    }
}

#[test]
fn points_on_the_seam() {
    // Within 1e-3 of the corner of the torus, where all coordinates wrap.
    let mut random = Random(17);
    let fractions = (0..500).map(|_| random.point::<3>().map(|x| 0.001 * (x - 0.5))).collect();
    assert!(check(&Set::<3> { fractions, reach: vec![0.0002; 500], length: [1.0; 3] }) > 500);
}

#[test]
fn tiny_and_huge_lengths() {
    for scale in [1e-12, 1e12] {
        let mut set = uniform::<3>(500, 20.0, 19);
        set.length = [scale; 3];
        set.reach.iter_mut().for_each(|reach| *reach *= scale);
        assert!(check(&set) > 500);
    }
}

#[test]
fn reach_between_nothing_and_everything() {
    // Supports from far below the spacing to half of the box, in any order.
    let mut random = Random(23);
    for dimension_independent_seed in 0..3 {
        let mut set = uniform::<2>(300, 5.0, dimension_independent_seed);
        for reach in &mut set.reach {
            *reach = 0.5 * (-12.0 * random.next()).exp();
        }
        assert!(check(&set) > 300);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// Coordinates from a coarse grid make ties, coincident points and distances on the edge common.
    #[test]
    fn any_set(
        points in prop::collection::vec((prop::array::uniform3(0u32..64), 1u32..33), 1..120),
        length in prop::array::uniform3(1u32..5),
        fine in 0.0..1.0f64,
    ) {
        let length = length.map(f64::from);
        let shortest = length.iter().copied().fold(f64::INFINITY, f64::min);
        let set = Set::<3> {
            fractions: points.iter().map(|(point, _)| point.map(|x| f64::from(x) / 64.0 * (1.0 - 1e-3 * fine))).collect(),
            reach: points.iter().map(|(_, reach)| f64::from(*reach) / 64.0 * shortest).collect(),
            length,
        };
        check(&set);
        let flat = Set::<1> {
            fractions: set.fractions.iter().map(|point| [point[0]]).collect(),
            reach: set.reach.clone(),
            length: [length[0]],
        };
        check(&flat);
    }
}
