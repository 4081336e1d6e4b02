//! The order along the curve.

use super::{Random, in_pool};
use crate::neighbours::{Coordinate, Order};
use fearless_simd::Level;

fn permutation<C: Coordinate, const D: usize>(points: &[[f64; D]], length: [f64; D]) -> Vec<u32> {
    let axis = |k: usize| -> Vec<C> { points.iter().map(|point| C::from_fraction(point[k])).collect() };
    let coordinates: [Vec<C>; D] = std::array::from_fn(axis);
    let mut order = Order::default();
    order.compute(coordinates.each_ref().map(Vec::as_slice), &length, Level::new()).expect("an order");
    order.permutation().to_vec()
}

#[test]
fn in_one_dimension_the_order_is_that_of_the_coordinate() {
    let mut random = Random(43);
    // A third of 21 000 points in a range of 1e-6, too narrow for the coarse grid.
    let points: Vec<[f64; 1]> = (0..21_000)
        .map(|n| {
            let x = random.next();
            [if n % 3 == 0 { 0.7 + 1e-6 * x } else { x }]
        })
        .collect();
    // Up to 8 particles in a cell stay as they are. There are 2^20 cells, 32 and more a particle; those that are crowded are
    // divided down to 2^-32 of the range. No step back is longer than a cell of its region.
    let (cell, fine_cell) = ((-20_f64).exp2(), (-32_f64).exp2());
    let (mut steps_back, mut fine_steps_back) = (0.0, 0.0);
    for pair in permutation::<u64, 1>(&points, [1.0]).windows(2) {
        let [a, b] = [points[pair[0] as usize][0], points[pair[1] as usize][0]];
        steps_back = f64::max(steps_back, a - b);
        if (0.7 + 1e-7..0.7 + 9e-7).contains(&a) {
            fine_steps_back = f64::max(fine_steps_back, a - b);
        }
    }
    println!("longest step back {steps_back:e}, bound {cell:e}");
    println!("longest step back where it is crowded {fine_steps_back:e}, bound {:e}", fine_cell);
    assert!(steps_back < cell && fine_steps_back < fine_cell);
}

#[test]
fn equal_points_keep_their_order() {
    assert!(permutation::<u32, 3>(&[[0.5; 3]; 100], [1.0; 3]).into_iter().eq(0..100));
}

#[test]
fn runs_of_sixteen_are_compact_at_any_density() {
    // The mean volume of the box around 16 consecutive particles, in units of the volume that 16 particles have on average:
    // a cube would have about 0.7 of it ((15/17)^3, as the extremes of uniform numbers are 15/17 of the range apart); runs along
    // Hilbert's curve reach across a few cells and are below 2.2. A row-major or a broken order is above 10.
    let mut random = Random(47);
    for extent in [1.0, 1e-3] {
        let mut points: Vec<[f64; 3]> =
            (0..20_000).map(|_| random.point::<3>().map(|x| 0.25 + extent * x * 0.5)).collect();
        // Outliers spread the coarse grid over the whole torus.
        points.extend([[0.0; 3], [0.999; 3]]);
        let order = permutation::<u64, 3>(&points, [1.0; 3]);
        let volume = |run: &[u32]| -> f64 {
            (0..3)
                .map(|k| {
                    let x = run.iter().map(|i| points[*i as usize][k]);
                    x.clone().fold(0.0, f64::max) - x.fold(1.0, f64::min)
                })
                .product()
        };
        // The outliers come first and last or nearly: leave out the runs that hold them.
        let volumes: Vec<f64> =
            order.chunks_exact(16).filter(|run| run.iter().all(|i| *i < 20_000)).map(volume).collect();
        let share = (extent * 0.5).powi(3) / 20_000.0 * 16.0;
        let mean = volumes.iter().sum::<f64>() / volumes.len() as f64 / share;
        println!("extent {extent}: mean volume of a run {mean:.2} of its share, bound 2.2");
        assert!(mean < 2.2, "extent {extent}: runs of 16 have {mean} times the volume of their share");
    }
}

#[test]
fn a_crowded_cell_gives_the_same_on_any_number_of_threads() {
    // 30 000 points in one cell of the coarse grid.
    let mut random = Random(53);
    let mut points: Vec<[f64; 2]> = (0..30_000).map(|_| random.point::<2>().map(|x| 1e-7 * x)).collect();
    points.push([0.9; 2]);
    let one = in_pool(1, || permutation::<u32, 2>(&points, [1.0; 2]));
    let three = in_pool(3, || permutation::<u32, 2>(&points, [1.0; 2]));
    assert!(one == three);
}

#[test]
fn no_particles() {
    let mut order = Order::default();
    order.compute::<u32, 2>([&[1, 2], &[3, 4]], &[1.0; 2], Level::new()).expect("an order");
    order.compute::<u32, 2>([&[], &[]], &[1.0; 2], Level::new()).expect("an order");
    assert!(order.permutation().is_empty());
}
