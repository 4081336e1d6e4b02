//! What an engine does besides computing: order, errors, clocks, the choice of pipelines.

use etalon_kernels_gen::{Component, Field};
use etalon_reference::conformance::sets::Difficulty;
use etalon_reference::engine::{Engine, PlainEngine};
use etalon_reference::fields;
use etalon_reference::particles::ParticleSet;
use etalon_reference::passes::{Correct, Density, KickDrift, VolumeElements};
use etalon_reference::schemes::{Dissipation, Kernel};
use etalon_reference::simulation::Simulation;
use etalon_wgpu::WgpuEngine;

use crate::adapter::device;
use crate::scene::{all_fields, engine, physics, set};

fn scalar(field: Field) -> Component {
    Component { field, index: 0 }
}

#[test]
fn values_go_in_and_out_in_the_original_order() {
    let Some(device) = device() else { return };
    let physics = physics::<2>(Dissipation::Av);
    let set = set::<2>(Difficulty::None, &physics);
    let mut engine = engine(&set, &physics, device);
    let mut places: Vec<u32> = engine.identity().to_vec();
    assert!(!places.is_sorted(), "the particles were not put in order");
    places.sort_unstable();
    assert!(places.iter().copied().eq(0..set.len() as u32), "not a permutation");
    for axis in 0..2 {
        assert_eq!(engine.coordinates(axis).unwrap(), set.coordinates(axis));
    }
    let mass = engine.read_scalar(fields::MASS).unwrap();
    assert!(mass.iter().zip(set.particles()).all(|(found, p)| *found == f64::from(p.mass as f32)));
    let values: Vec<f64> = (0..set.len()).map(|i| i as f64).collect();
    engine.write(scalar(fields::PRESSURE), &values).unwrap();
    assert_eq!(engine.read_scalar(fields::PRESSURE).unwrap(), values);
}

#[test]
fn particles_are_put_in_order_again_and_keep_their_numbers() {
    let Some(device) = device() else { return };
    let physics = physics::<1>(Dissipation::Av);
    let set = set::<1>(Difficulty::None, &physics);
    let mut engine = engine(&set, &physics, device);
    let before = engine.identity().to_vec();
    // Everyone jumps by a third of the box, so that those at its end come first.
    engine.write(scalar(fields::DISPLACEMENT), &vec![1.0 / 3.0; set.len()]).unwrap();
    engine.drift().unwrap();
    for _ in 0..10 {
        engine.find_neighbours(2.0).unwrap();
    }
    assert_ne!(engine.identity(), before, "no new order");
    let moved = engine.coordinates(0).unwrap();
    // To the nearest 2^-32 of the box, from a displacement rounded to f32.
    let step = (f64::from(1f32 / 3.0) * 2f64.powi(32)).round() as u64;
    assert!(moved.iter().zip(set.coordinates(0)).all(|(now, then)| *now == then.wrapping_add(step << 32)));
    let mass = engine.read_scalar(fields::MASS).unwrap();
    assert!(mass.iter().zip(set.particles()).all(|(found, p)| *found == f64::from(p.mass as f32)));
}

#[test]
fn another_physics_is_another_pipeline() {
    let Some(device) = device() else { return };
    let physics = physics::<2>(Dissipation::Av);
    let set = set::<2>(Difficulty::None, &physics);
    let mut engine = engine(&set, &physics, device);
    let mut reference = PlainEngine::<f32, 2>::new(&set);
    engine.find_neighbours(2.0).unwrap();
    reference.find_neighbours(2.0).unwrap();
    let mut found = Vec::new();
    for kernel in [Kernel::MixedSinc, Kernel::WendlandC2, Kernel::MixedSinc] {
        let pass = VolumeElements(etalon_reference::passes::Physics { kernel, ..physics });
        engine.run_pass(&pass).unwrap();
        reference.run_pass(&pass).unwrap();
        let density = engine.read_scalar(fields::STANDARD_DENSITY).unwrap();
        let expected = reference.read_scalar(fields::STANDARD_DENSITY).unwrap();
        // Each of the two is within 26 neighbours' roundings and some tens of operations of the truth; kernels differ by
        // far more.
        let far = density.iter().zip(&expected).map(|(a, b)| ((a - b) / b).abs()).fold(0.0, f64::max);
        assert!(far < 1e-5, "{kernel}: error {far:e}, tolerance 1e-5");
        found.push(density);
    }
    assert_ne!(found[0], found[1]);
    assert_eq!(found[0], found[2], "not the same bits when repeated");
}

#[test]
fn every_misuse_is_told_in_a_sentence() {
    let Some(device) = device() else { return };
    let physics = physics::<2>(Dissipation::Av);
    let set = set::<2>(Difficulty::None, &physics);
    let mut engine = engine(&set, &physics, device);
    let message = engine.run_pass(&VolumeElements(physics)).unwrap_err().to_string();
    assert!(message.contains("before neighbours were found"), "{message}");
    let message = engine.read(scalar(fields::STRAIN_RATE)).unwrap_err().to_string();
    assert!(message.contains("without the field strain_rate_xx"), "{message}");
    let message = engine.write(scalar(fields::MASS), &[1.0]).unwrap_err().to_string();
    assert!(message.contains("mass has 1 values for 400 particles"), "{message}");
    let mut large = vec![1.0; set.len()];
    large[9] = 1e39;
    let message = engine.write(scalar(fields::PRESSURE), &large).unwrap_err().to_string();
    assert!(message.contains("pressure of particle 9 is 1e39, out of the range"), "{message}");
    let mut light = set.particles().to_vec();
    light[3].mass = 1e-40;
    let light = ParticleSet::new(*set.domain(), light).unwrap();
    let message = WgpuEngine::new(&light, &all_fields::<2>(&physics), device.clone()).unwrap_err().to_string();
    assert!(message.contains("mass of particle 3 is 1e-40, out of the range"), "{message}");
    let message = engine.find_neighbours(50.0).unwrap_err().to_string();
    assert!(message.contains("less than the support's diameter"), "{message}");
    let message = engine.run_pass(&VolumeElements(physics)).unwrap_err().to_string();
    assert!(message.contains("before neighbours were found"), "{message}");

    let mut steps = vec![1.0; set.len()];
    steps[17] = 0.25;
    engine.write(scalar(fields::TIME_STEP), &steps).unwrap();
    assert_eq!(engine.minimum(fields::TIME_STEP).unwrap(), 0.25);
    for bad in [f64::NAN, -f64::NAN] {
        steps[30] = bad;
        engine.write(scalar(fields::TIME_STEP), &steps).unwrap();
        let message = engine.minimum(fields::TIME_STEP).unwrap_err().to_string();
        assert!(message.contains("time_step of a particle is not a number"), "{message}");
    }

    // Told at the next search, by the particle's original number.
    let mut displacement = vec![0.0; set.len()];
    displacement[123] = 0.75;
    engine.write(scalar(fields::DISPLACEMENT), &displacement).unwrap();
    engine.drift().unwrap();
    let message = engine.find_neighbours(2.0).unwrap_err().to_string();
    assert!(message.contains("particle 123 was to move by [0.75"), "{message}");
    engine.find_neighbours(2.0).unwrap();

    let mut lengths = engine.read_scalar(fields::SMOOTHING_LENGTH).unwrap();
    lengths[5] = -1.0;
    engine.write(scalar(fields::SMOOTHING_LENGTH), &lengths).unwrap();
    let message = engine.find_neighbours(2.0).unwrap_err().to_string();
    assert!(message.contains("positive and finite"), "{message}");

    let few = [fields::MASS, fields::SMOOTHING_LENGTH];
    let mut small = WgpuEngine::new(&set, &few, device.clone()).unwrap();
    small.find_neighbours(2.0).unwrap();
    let message = small.run_pass(&Density(physics)).unwrap_err().to_string();
    assert!(message.contains("`density` needs the field"), "{message}");
    let message = small.drift().unwrap_err().to_string();
    assert!(message.contains("without the field displacement_x"), "{message}");
    let message = WgpuEngine::new(&set, &[fields::MASS], device.clone()).unwrap_err().to_string();
    assert!(message.contains("smoothing_length"), "{message}");
}

/// Work that is gathered must still run with the time step it was asked for with.
#[test]
fn every_update_has_its_own_time_step() {
    let Some(device) = device() else { return };
    let physics = physics::<1>(Dissipation::Av);
    let set = set::<1>(Difficulty::None, &physics);
    let mut engine = engine(&set, &physics, device);
    let zeros = vec![0.0; set.len()];
    for field in [fields::PREVIOUS_ACCELERATION, fields::PREVIOUS_ENERGY_RATE, fields::VELOCITY, fields::ACCELERATION] {
        engine.write(scalar(field), &zeros).unwrap();
    }
    let ones = vec![1.0; set.len()];
    engine.write(scalar(fields::ENERGY_RATE), &ones).unwrap();
    engine.write(scalar(fields::INTERNAL_ENERGY), &zeros).unwrap();
    for time_step in [2.0, 4.0, 4.0, 0.5] {
        engine.run_update(&Correct, time_step).unwrap();
    }
    // Half of each step: powers of two, without rounding.
    assert_eq!(engine.read_scalar(fields::INTERNAL_ENERGY).unwrap(), vec![5.25; set.len()]);
}

#[test]
fn stages_are_timed_by_name() {
    let Some(device) = device() else { return };
    let physics = physics::<2>(Dissipation::Av);
    let set = set::<2>(Difficulty::None, &physics);
    let mut simulation = Simulation::new(engine(&set, &physics, device), physics).unwrap();
    simulation.engine().set_timed(true).unwrap();
    for _ in 0..3 {
        simulation.step(1.0).unwrap();
    }
    let timings = simulation.engine().timings().unwrap();
    let names: Vec<&str> = timings.stages().iter().map(|(name, ..)| name.as_str()).collect();
    let wanted = ["kick_drift", "drift", "neighbour_list", "volume_elements", "density", "gradients", "momentum"];
    for name in wanted.into_iter().chain(["minimum", "correct"]) {
        assert!(names.contains(&name), "{name} is not among {names:?}");
    }
    for (name, time, runs) in timings.stages().iter().filter(|(name, ..)| name != "order") {
        assert!(time.as_secs_f64() > 0.0 && time.as_secs_f64() < 60.0, "{name}: {time:?}");
        // A search is made once more after the particles were put in a new order.
        assert!(*runs == 3 || (name == "neighbour_list" && *runs == 4), "{name}: {runs} runs");
    }
}

/// How work is gathered must not be seen: reading everything between the passes changes no bit.
#[test]
fn reading_between_passes_changes_nothing() {
    let Some(device) = device() else { return };
    let physics = physics::<1>(Dissipation::AvSlrB2F);
    let set = set::<1>(Difficulty::None, &physics);
    let fields = all_fields::<1>(&physics);
    let run = |watched: bool| {
        let mut engine = engine(&set, &physics, device);
        for field in [fields::ACCELERATION, fields::ENERGY_RATE] {
            engine.write(scalar(field), &vec![0.5; set.len()]).unwrap();
        }
        let look = |engine: &mut WgpuEngine<1>| {
            if watched {
                fields.iter().for_each(|field| drop(engine.read_all(*field).unwrap()));
            }
        };
        engine.find_neighbours(2.0).unwrap();
        engine.run_pass(&VolumeElements(physics)).unwrap();
        look(&mut engine);
        engine.run_pass(&Density(physics)).unwrap();
        look(&mut engine);
        engine.run_update(&KickDrift(physics), 1e-3).unwrap();
        look(&mut engine);
        engine.drift().unwrap();
        look(&mut engine);
        engine.find_neighbours(2.0).unwrap();
        engine.run_pass(&VolumeElements(physics)).unwrap();
        let mut all: Vec<Vec<f64>> = fields.iter().flat_map(|field| engine.read_all(*field).unwrap()).collect();
        all.push(engine.coordinates(0).unwrap().iter().map(|place| *place as f64).collect());
        all
    };
    assert_eq!(run(false), run(true));
}
