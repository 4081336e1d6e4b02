//! The neighbour lists against brute force. They are sets of indices: equality is exact, there is no tolerance.

use etalon_wgpu::{NeighbourSearch, Timer, Torus};

use crate::common::{Particles, Random, device};

/// Builds the lists on the device, three times; all must be the same bits, equal to one of the two brute-force answers, and
/// symmetric.
fn check(name: &str, particles: &Particles) {
    let Some(device) = device() else { return };
    let (coordinates, fields) = particles.upload(device, 2);
    let mut search = NeighbourSearch::new(device, &coordinates, &fields, 0).unwrap();
    let summary = search.build(device, &mut Timer::off()).unwrap();
    let found = search.lists().download(device).unwrap();
    let order = search.lists().download_order(device).unwrap();

    assert_eq!(summary.entries as usize, found.1.len(), "{name}");
    let smallest = particles.reach.iter().copied().fold(f32::INFINITY, f32::min);
    let largest = particles.reach.iter().copied().fold(0.0, f32::max);
    assert_eq!((summary.smallest_reach, summary.largest_reach), (smallest, largest), "{name}");

    let unfused = particles.brute_force(false);
    if found != unfused && found != particles.brute_force(true) {
        for i in 0..particles.count() {
            let of = |lists: &(Vec<u32>, Vec<u32>)| lists.1[lists.0[i] as usize..lists.0[i + 1] as usize].to_vec();
            assert_eq!(of(&found), of(&unfused), "{name}: neighbours of particle {i}, cells {:?}", search.cells());
        }
        panic!("{name}: a mixture of fused and unfused arithmetic");
    }
    check_symmetric(name, &found);

    let mut sorted = order.clone();
    sorted.sort_unstable();
    assert!(sorted.iter().enumerate().all(|(k, particle)| k == *particle as usize), "{name}: order is no permutation");

    for repeat in 0..2 {
        search.build(device, &mut Timer::off()).unwrap();
        assert!(search.lists().download(device).unwrap() == found, "{name}: repeat {repeat} differs");
        assert!(search.lists().download_order(device).unwrap() == order, "{name}: order of repeat {repeat} differs");
    }
    eprintln!(
        "{name}: {} particles, {} entries, cells {:?}: equal to brute force",
        particles.count(),
        found.1.len(),
        search.cells()
    );
}

/// Action equals reaction only if i has j exactly when j has i.
fn check_symmetric(name: &str, (offsets, list): &(Vec<u32>, Vec<u32>)) {
    let of = |i: usize| &list[offsets[i] as usize..offsets[i + 1] as usize];
    for i in 0..offsets.len() - 1 {
        assert!(of(i).is_sorted_by(|a, b| a < b), "{name}: the list of {i} does not ascend");
        for j in of(i) {
            assert!(of(*j as usize).binary_search(&(i as u32)).is_ok(), "{name}: {i} has {j} but not the reverse");
        }
    }
}

fn random(lengths: &[f64], count: usize, seed: u64, mut reach: impl FnMut(&mut Random) -> f64) -> Particles {
    let mut random = Random(seed);
    let coordinates = lengths.iter().map(|_| (0..count).map(|_| random.word()).collect()).collect();
    let reach = (0..count).map(|_| reach(&mut random) as f32).collect();
    Particles { torus: Torus::new(lengths).unwrap(), coordinates, reach }
}

#[test]
fn random_particles() {
    check("1-D", &random(&[1.0], 2000, 1, |_| 0.004));
    check("2-D", &random(&[1.0, 2.0], 2000, 2, |_| 0.09));
    check("3-D", &random(&[1.0, 0.5, 2.0], 3000, 3, |_| 0.12));
    // Cells that do not divide 2^32, and a torus so thin that its whole width is searched.
    check("3-D thin", &random(&[3.0, 0.1, 0.07], 1500, 4, |_| 0.05));
}

#[test]
fn varying_reach() {
    check("1-D, reach 1:100", &random(&[1.0], 1500, 5, |random| 0.0005 * 100f64.powf(random.unit())));
    check("2-D, reach 1:30", &random(&[1.0, 1.0], 1500, 6, |random| 0.01 * 30f64.powf(random.unit())));
    check("3-D, reach 1:10", &random(&[1.0, 1.0, 1.0], 2000, 7, |random| 0.03 * 10f64.powf(random.unit())));
    // One particle reaches half the box, all others almost nothing: only its cells' surroundings may look far, and every
    // particle there must find it.
    let mut lone = random(&[1.0, 1.0, 1.0], 2000, 8, |_| 0.02);
    lone.reach[1234] = 0.4;
    check("3-D, one large reach", &lone);
    // And beyond the torus: everything is its neighbour, once.
    lone.reach[1234] = 3.0;
    check("3-D, one reach beyond the torus", &lone);
}

#[test]
fn reach_beyond_the_torus() {
    for dimension in 1..=3 {
        let particles = random(&[1.0, 0.8, 1.3][..dimension], 150, 9, |_| 2.0);
        check(&format!("{dimension}-D, all are neighbours"), &particles);
        assert_eq!(particles.brute_force(false).1.len(), 150 * 149);
    }
    // Just below half the torus, where the range of cells closes on itself.
    for reach in [0.45, 0.49, 0.4999, 0.5, 0.51] {
        check(&format!("3-D, reach {reach} of the torus"), &random(&[1.0, 1.0, 1.0], 400, 10, |_| reach));
    }
}

/// The tube: dense on the left, an eighth of the density and twice the reach on the right, in a torus twice as long.
#[test]
fn tube_with_a_density_jump_in_an_open_box() {
    let mut generator = Random(11);
    for dimension in 1..=3 {
        let lengths = &[4.0, 0.25, 0.25][..dimension];
        let (dense, sparse) = (1600, 200);
        let spacing: f64 = (0.5 * 0.25f64.powi(dimension as i32 - 1) / dense as f64).powf(1.0 / dimension as f64);
        let mut coordinates = vec![Vec::new(); dimension];
        let mut reach = Vec::new();
        for k in 0..dense + sparse {
            let (low, high, size) = if k < dense { (1.0, 1.5, 1.0) } else { (1.5, 2.0, 2.0) };
            let x = generator.between(low, high) / lengths[0];
            coordinates[0].push((x * 4_294_967_296.0) as u32);
            for axis in &mut coordinates[1..] {
                axis.push(generator.word());
            }
            reach.push((2.4 * spacing * size * generator.between(0.95, 1.05)) as f32);
        }
        check(&format!("{dimension}-D tube"), &Particles { torus: Torus::new(lengths).unwrap(), coordinates, reach });
    }
}

/// A lattice whose spacing and reach are powers of two: distances equal the reach exactly, and such pairs are no
/// neighbours; cell edges fall on particles.
#[test]
fn lattice_with_distances_equal_to_the_reach() {
    for dimension in 1..=3u32 {
        let side = [64usize, 16, 8][dimension as usize - 1];
        let count = side.pow(dimension);
        let coordinates = (0..dimension)
            .map(|axis| (0..count).map(|k| ((k / side.pow(axis)) % side * ((1 << 32) / side)) as u32).collect())
            .collect();
        let reach = vec![2.0 / side as f32; count];
        let particles = Particles { torus: Torus::new(&vec![1.0; dimension as usize]).unwrap(), coordinates, reach };
        check(&format!("{dimension}-D lattice"), &particles);
        // Strictly within two spacings lie 2, 8 and 26 points: that the reach itself is excluded is seen in every list.
        let expected = [2, 8, 26][dimension as usize - 1];
        assert!(particles.brute_force(false).0.windows(2).all(|pair| pair[1] - pair[0] == expected));
    }
}

#[test]
fn clusters() {
    let mut generator = Random(12);
    for dimension in 1..=3 {
        let mut coordinates = vec![Vec::new(); dimension];
        let mut reach = Vec::new();
        for cluster in 0..5 {
            let centre: Vec<u32> = (0..dimension).map(|_| generator.word()).collect();
            // Sizes from 2^-5 to 2^-13 of the box, one of them across the seam.
            let size = 2f64.powi(-5 - 2 * cluster);
            for _ in 0..250 {
                for axis in 0..dimension {
                    let offset = generator.between(-size, size) * 4_294_967_296.0;
                    let centre = if cluster == 2 { 0 } else { centre[axis] };
                    coordinates[axis].push(centre.wrapping_add_signed(offset as i32));
                }
                reach.push((size * generator.between(0.2, 1.0)) as f32);
            }
        }
        let torus = Torus::new(&[1.0, 1.0, 1.0][..dimension]).unwrap();
        check(&format!("{dimension}-D clusters"), &Particles { torus, coordinates, reach });
    }
}

#[test]
fn coincident_collinear_and_coplanar_particles() {
    // All in one place: every other particle is a neighbour, and one cell holds all.
    let one_place = Particles {
        torus: Torus::new(&[1.0, 1.0, 1.0]).unwrap(),
        coordinates: vec![vec![0xffff_ffff; 300], vec![0; 300], vec![0x8000_0000; 300]],
        reach: vec![1e-3; 300],
    };
    check("coincident", &one_place);
    assert_eq!(one_place.brute_force(false).1.len(), 300 * 299);

    let mut pairs = random(&[1.0, 1.0], 600, 13, |_| 0.05);
    for axis in &mut pairs.coordinates {
        for k in 0..300 {
            axis[k + 300] = axis[k];
        }
    }
    check("coincident in pairs", &pairs);

    let mut line = random(&[1.0, 1.0, 1.0], 800, 14, |_| 0.01);
    line.coordinates[0].fill(7);
    line.coordinates[2].fill(u32::MAX);
    check("collinear", &line);

    let mut plane = random(&[1.0, 1.0, 1.0], 1200, 15, |_| 0.06);
    plane.coordinates[1].fill(0x4000_0000);
    check("coplanar", &plane);
}

#[test]
fn few_particles() {
    for count in 1..=3 {
        for dimension in 1..=3 {
            check(&format!("{dimension}-D, {count}"), &random(&[1.0; 3][..dimension], count, 16, |_| 0.3));
        }
    }
}

/// More cells along an axis than 2^17, where the cell of a coordinate needs all four partial products. Brute force would take
/// long here; in one dimension the candidates can be had from the sorted coordinates.
#[test]
fn many_cells() {
    let Some(device) = device() else { return };
    let particles = random(&[1.0], 40_000, 19, |_| 6e-6);
    let (coordinates, fields) = particles.upload(device, 1);
    let mut search = NeighbourSearch::new(device, &coordinates, &fields, 0).unwrap();
    search.build(device, &mut Timer::off()).unwrap();
    assert!(search.cells()[0] > 1 << 17, "{:?}", search.cells());
    let (offsets, list) = search.lists().download(device).unwrap();

    let places = &particles.coordinates[0];
    let mut sorted: Vec<usize> = (0..places.len()).collect();
    sorted.sort_by_key(|particle| places[*particle]);
    let mut expected = vec![Vec::new(); places.len()];
    for (k, i) in sorted.iter().enumerate() {
        for j in sorted.iter().cycle().skip(k + 1) {
            let separation = particles.torus.separation(0, places[*j], places[*i]);
            if separation * separation >= particles.reach[0] * particles.reach[0] {
                break;
            }
            expected[*i].push(*j as u32);
            expected[*j].push(*i as u32);
        }
    }
    for (i, expected) in expected.iter_mut().enumerate() {
        expected.sort_unstable();
        assert_eq!(&list[offsets[i] as usize..offsets[i + 1] as usize], expected, "neighbours of particle {i}");
    }
}

/// Lengths by powers of two change nothing: the same lists, from 2^-40 to 2^40.
#[test]
fn scale_freedom() {
    let Some(device) = device() else { return };
    let mut lists = Vec::new();
    for power in [-40, 0, 40] {
        let size = 2f64.powi(power);
        let particles = random(&[size, 2.0 * size, size], 800, 17, |random| size * random.between(0.1, 0.2));
        let (coordinates, fields) = particles.upload(device, 1);
        let mut search = NeighbourSearch::new(device, &coordinates, &fields, 0).unwrap();
        search.build(device, &mut Timer::off()).unwrap();
        lists.push(search.lists().download(device).unwrap());
    }
    assert!(lists[0] == lists[1] && lists[1] == lists[2]);
}

/// The lists do not depend on the cells: a search whose cells were planned for another reach gives the same.
#[test]
fn lists_do_not_depend_on_the_cells() {
    let Some(device) = device() else { return };
    let mut particles = random(&[1.0, 1.0, 1.0], 2000, 18, |_| 0.02);
    let (coordinates, fields) = particles.upload(device, 1);
    let mut search = NeighbourSearch::new(device, &coordinates, &fields, 0).unwrap();
    search.build(device, &mut Timer::off()).unwrap();
    let mut seen = vec![search.cells()];
    for reach in [0.3f32, 0.3, 0.05, 0.05, 0.11] {
        particles.reach.fill(reach);
        fields.upload(device, 0, &particles.reach).unwrap();
        let (before, capacity) = (search.lists().generation(), search.lists().capacity());
        let entries = search.build(device, &mut Timer::off()).unwrap().entries;
        // The list grows when it must, and only then.
        assert_eq!(search.lists().generation() > before, entries > capacity);
        let found = search.lists().download(device).unwrap();
        assert!(found == particles.brute_force(false) || found == particles.brute_force(true), "reach {reach}");
        seen.push(search.cells());
    }
    let mut fresh = NeighbourSearch::new(device, &coordinates, &fields, 0).unwrap();
    fresh.build(device, &mut Timer::off()).unwrap();
    assert!(
        fresh.lists().download(device).unwrap() == search.lists().download(device).unwrap(),
        "a fresh search differs"
    );
    assert!(seen.iter().any(|cells| *cells != seen[0]), "the cells were never planned anew: {seen:?}");
    assert!(search.lists().generation() > 1, "the list never grew");
}
