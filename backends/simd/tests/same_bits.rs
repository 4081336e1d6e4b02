//! The same bits, whatever the processor's instructions and the number of threads.

use etalon_kernels_gen::components;
use etalon_kernels_gen::lanes::{available_levels, level_name};
use etalon_reference::conformance::sets::{Difficulty, set};
use etalon_reference::engine::Engine;
use etalon_reference::particles::ParticleSet;
use etalon_reference::passes::Physics;
use etalon_reference::pipeline::Pipeline;
use etalon_reference::scenes::sod::Sod;
use etalon_reference::schemes::{Dissipation, Viscosity};
use etalon_reference::simulation::Simulation;
use etalon_simd::{LaneEngine, Number, Options};
use fearless_simd::Level;

/// All fields of all particles, as bits, by name.
type Bits = Vec<(String, Vec<u64>)>;

fn bits<const D: usize, T: Number>(engine: &mut LaneEngine<T, D>, physics: &Physics) -> Bits {
    let fields = Pipeline::of_scene::<D>(physics).fields::<D>();
    let column = |values: Vec<f64>| values.into_iter().map(f64::to_bits).collect();
    // A single round of passes leaves the updates' fields alone.
    let read = components(&fields, D).into_iter().filter_map(|c| Some((c.name(D), column(engine.read(c).ok()?))));
    let mut all: Bits = read.collect();
    all.push(("coordinate_x".to_string(), engine.coordinates(0).unwrap()));
    all
}

/// On so many threads.
fn on<R: Send>(threads: usize, work: impl FnOnce() -> R + Send) -> R {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(work)
}

fn engine<const D: usize, T: Number>(set: &ParticleSet<D>, physics: &Physics, level: Level) -> LaneEngine<T, D> {
    LaneEngine::new(set, &Pipeline::of_scene::<D>(physics).fields::<D>(), Options { level })
}

fn after_steps<const D: usize, T: Number>(set: &ParticleSet<D>, physics: Physics, level: Level) -> Bits {
    let mut simulation = Simulation::new(engine::<D, T>(set, &physics, level), physics).unwrap();
    for _ in 0..3 {
        simulation.step(1.0).unwrap();
    }
    bits(simulation.engine(), &physics)
}

fn after_one_round<const D: usize, T: Number>(set: &ParticleSet<D>, physics: Physics, level: Level) -> Bits {
    let mut engine = engine::<D, T>(set, &physics, level);
    let pipeline = Pipeline::of_scene::<D>(&physics);
    engine.find_neighbours(physics.kernel.support()).unwrap();
    pipeline.start(&mut engine, physics).unwrap();
    pipeline.run(&mut engine, physics).unwrap();
    bits(&mut engine, &physics)
}

/// Runs at the lowest level on one thread, then at every level on each of these numbers of threads, and compares all bits.
fn compare(what: &str, thread_numbers: &[usize], run: impl Fn(Level) -> Bits + Sync) {
    let expected = on(1, || run(Level::baseline()));
    assert!(expected.len() > 15, "{what}: only {} columns", expected.len());
    for level in available_levels() {
        for &threads in thread_numbers {
            for ((name, expected), (_, found)) in expected.iter().zip(on(threads, || run(level))) {
                let differing = expected.iter().zip(&found).filter(|(a, b)| a != b).count();
                let place = format!("{} with {threads} threads", level_name(level));
                assert_eq!((differing, found.len()), (0, expected.len()), "{what}: {name} differs at {place}");
            }
        }
    }
}

/// Three steps of the usual scheme, then of others; then a round of passes on every difficult set.
fn same_bits<const D: usize, T: Number>(across: usize) {
    let usual = Sod::standard(D).physics();
    let plain = set::<D>(Difficulty::None, across, &usual, 7).unwrap();
    let what = |case: String| format!("{} {D}-D, {case}", T::NAME);
    compare(&what("usual".into()), &[1, 2, 5], |level| after_steps::<D, T>(&plain, usual, level));
    for dissipation in [Dissipation::Av, Dissipation::AvSlrB2F, Dissipation::AvSwSlr] {
        let viscosity = Viscosity { conduction: Viscosity::CONDUCTION, ..Viscosity::of(dissipation) };
        let physics = Physics { viscosity, ..usual };
        let case = what(format!("{dissipation} with conduction"));
        compare(&case, &[2], |level| after_one_round::<D, T>(&plain, physics, level));
    }
    for &difficulty in Difficulty::ALL {
        let set = set::<D>(difficulty, across, &usual, 7).unwrap();
        let case = what(format!("{difficulty:?}"));
        compare(&case, &[2], |level| after_one_round::<D, T>(&set, usual, level));
    }
}

#[test]
fn single_precision_in_one_dimension() {
    same_bits::<1, f32>(600);
}
#[test]
fn double_precision_in_one_dimension() {
    same_bits::<1, f64>(600);
}
#[test]
fn single_precision_in_two_dimensions() {
    same_bits::<2, f32>(24);
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
