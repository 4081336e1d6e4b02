//! The same bits, whatever the processor's instructions and the number of threads.

use etalon_kernels_gen::components;
use etalon_kernels_gen::lanes::{available_levels, level_name};
use etalon_reference::conformance::sets::{Difficulty, set};
use etalon_reference::engine::Engine;
use etalon_reference::pipeline::Pipeline;
use etalon_reference::scenes::sod::Sod;
use etalon_reference::simulation::Simulation;
use etalon_simd::{LaneEngine, Number, Options};
use fearless_simd::Level;

/// All fields of all particles after some steps, as bits.
fn bits_after<const D: usize, T: Number>(
    level: Level,
    threads: usize,
    across: usize,
    steps: usize,
) -> Vec<(String, Vec<u64>)> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| {
        let physics = Sod::standard(D).physics();
        let particles = set::<D>(Difficulty::None, across, &physics, 7).unwrap();
        let fields = Pipeline::of_scene::<D>(&physics).fields::<D>();
        let engine = LaneEngine::<T, D>::new(&particles, &fields, Options { level });
        let mut simulation = Simulation::new(engine, physics).unwrap();
        for _ in 0..steps {
            simulation.step(1.0).unwrap();
        }
        let engine = simulation.engine();
        let mut all: Vec<_> = components(&fields, D)
            .into_iter()
            .map(|c| (c.name(D), engine.read(c).unwrap().into_iter().map(f64::to_bits).collect()))
            .collect();
        all.push(("coordinate_x".to_string(), engine.coordinates(0).unwrap()));
        all
    })
}

fn same_bits<const D: usize, T: Number>(across: usize) {
    let steps = 3;
    let expected = bits_after::<D, T>(Level::baseline(), 1, across, steps);
    for level in available_levels() {
        for threads in [1, 2, 5] {
            let found = bits_after::<D, T>(level, threads, across, steps);
            for ((name, expected), (_, found)) in expected.iter().zip(&found) {
                let differing = expected.iter().zip(found).filter(|(a, b)| a != b).count();
                assert_eq!(
                    differing,
                    0,
                    "{} {D}-D: {name} differs at {} with {threads} threads",
                    T::NAME,
                    level_name(level)
                );
            }
        }
    }
}

#[test]
fn single_precision_in_one_dimension() {
    same_bits::<1, f32>(600);
}
#[test]
fn double_precision_in_two_dimensions() {
    same_bits::<2, f64>(24);
}
#[test]
fn single_precision_in_three_dimensions() {
    same_bits::<3, f32>(10);
}
#[test]
fn double_precision_in_three_dimensions() {
    same_bits::<3, f64>(10);
}
