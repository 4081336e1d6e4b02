//! Measures the neighbour search: nanoseconds a particle for the order, one permuted array and the list.
//!
//! `cargo run --release -p etalon-simd --example neighbour_speed -- [SIDE] [THREADS]`: SIDE^3 particles on a jittered lattice,
//! about 100 neighbours each, in f32 and f64 arithmetic, on every instruction set that the processor has.

use etalon_simd::neighbours::{Coordinate, NeighbourList, Order, Scalar};
use fearless_simd::Level;
use std::time::Instant;

const REPEATS: usize = 7;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let side: usize = arguments.next().map_or(Ok(64), |side| side.parse())?;
    let threads: usize = arguments.next().map_or(Ok(1), |threads| threads.parse())?;
    rayon::ThreadPoolBuilder::new().num_threads(threads).build_global()?;

    println!("{} particles, {threads} threads; nanoseconds a particle, best of {REPEATS}", side.pow(3));
    println!("precision level     shuffled: order  apply | sorted: order  apply   list  neighbours");
    for (name, level) in levels() {
        measure::<u32>("f32", name, level, side)?;
        measure::<u64>("f64", name, level, side)?;
    }
    Ok(())
}

/// The instruction sets to compare.
fn levels() -> Vec<(&'static str, Level)> {
    let best = Level::new();
    #[cfg(target_arch = "x86_64")]
    let levels = {
        use fearless_simd::Simd;
        [
            best.as_avx512().map(|level| ("AVX-512", level.level())),
            best.as_avx2().map(|level| ("AVX2", level.level())),
            best.as_sse4_2().map(|level| ("SSE4.2", level.level())),
        ]
    };
    #[cfg(not(target_arch = "x86_64"))]
    let levels = [Some(("best", best))];
    levels.into_iter().flatten().collect()
}

fn measure<C: Coordinate>(
    precision: &str,
    name: &str,
    level: Level,
    side: usize,
) -> Result<(), Box<dyn std::error::Error>> {
    let particles = side.pow(3);
    let spacing = 1.0 / side as f64;
    let mut random = 0x9e37_79b9_7f4a_7c15_u64;
    let mut jitter = || {
        random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (random >> 11) as f64 * (-53_f64).exp2() - 0.5
    };
    // 100 neighbours and the particle itself in the volume of the support, 4/3 pi reach^3.
    let reach = spacing * (101.0 * 0.75 / std::f64::consts::PI).cbrt();
    // A permutation without any order: multiplication by a number that divides no power of the side.
    let place = |n: usize| ((n as u128 * 1_000_000_007) % particles as u128) as usize;
    let mut coordinates: [Vec<C>; 3] = std::array::from_fn(|_| vec![C::default(); particles]);
    for n in 0..particles {
        let lattice = [n % side, n / side % side, n / side / side];
        for k in 0..3 {
            let position = (lattice[k] as f64 + 0.5 + 0.4 * jitter()) * spacing;
            coordinates[k][place(n)] = C::from_fraction(position);
        }
    }
    let reach: Vec<C::Scalar> = (0..particles).map(|_| C::Scalar::from_f64(reach * (1.0 + 0.1 * jitter()))).collect();

    let mut order = Order::default();
    let mut sorted: [Vec<C>; 3] = Default::default();
    let mut best = [f64::INFINITY; 5];
    let mut list = NeighbourList::<C, 3>::default();
    for _ in 0..REPEATS {
        let [x, y, z] = &coordinates;
        time(&mut best[0], || order.compute([x, y, z], &[1.0; 3], level))?;
        time(&mut best[1], || order.apply(x, &mut sorted[0]));
        order.apply(y, &mut sorted[1]);
        order.apply(z, &mut sorted[2]);
        let [x, y, z] = &sorted;
        time(&mut best[2], || order.compute([x, y, z], &[1.0; 3], level))?;
        let mut again = Vec::new();
        order.apply(x, &mut again);
        time(&mut best[3], || order.apply(x, &mut again));
        time(&mut best[4], || list.build([x, y, z], &reach, &[1.0; 3], level))?;
    }
    let [shuffled, apply_shuffled, order, apply, build] = best.map(|seconds| seconds * 1e9 / particles as f64);
    let neighbours = list.pairs() as f64 / particles as f64;
    println!(
        "{precision:9} {name:8} {shuffled:16.1} {apply_shuffled:6.1} | {order:13.1} {apply:6.1} {build:6.1} {neighbours:11.2}"
    );
    Ok(())
}

/// Runs and keeps the shorter time.
fn time<T>(best: &mut f64, run: impl FnOnce() -> T) -> T {
    let start = Instant::now();
    let result = run();
    *best = best.min(start.elapsed().as_secs_f64());
    result
}
