//! Nanoseconds per particle of each stage of a step of the Sod tube, on the adapter that `ETALON_ADAPTER` names.
//!
//! `cargo run --release -p etalon-wgpu --example step_speed -- [PARTICLES [STEPS [DIMENSION]]]`

use std::error::Error;
use std::time::Instant;

use etalon_reference::pipeline::Pipeline;
use etalon_reference::scenes::sod::Sod;
use etalon_reference::simulation::Simulation;
use etalon_wgpu::WgpuEngine;

fn number(place: usize, otherwise: usize) -> usize {
    std::env::args().nth(place).and_then(|text| text.parse().ok()).unwrap_or(otherwise)
}

fn main() -> Result<(), Box<dyn Error>> {
    match number(3, 3) {
        1 => measure::<1>(),
        2 => measure::<2>(),
        _ => measure::<3>(),
    }
}

fn measure<const D: usize>() -> Result<(), Box<dyn Error>> {
    let scene = Sod::standard(D).with(|m| m.particles = number(1, 20_000));
    let set = scene.particles::<D>(|_| Ok(Vec::new()))?;
    let device = etalon_wgpu::open(None)?;
    println!("{}", device.adapter());
    let fields = Pipeline::of_scene::<3>(&scene.physics()).fields::<D>();

    let start = Instant::now();
    let engine = WgpuEngine::new(&set, &fields, device.clone())?;
    println!("made in {:.2} s", start.elapsed().as_secs_f64());
    let start = Instant::now();
    let mut simulation = Simulation::new(engine, scene.physics())?;
    println!("started in {:.2} s", start.elapsed().as_secs_f64());

    simulation.engine().set_timed(true)?;
    let start = Instant::now();
    let steps = number(2, 5);
    for _ in 0..steps {
        simulation.step(1.0)?;
    }
    let elapsed = start.elapsed().as_secs_f64();
    let updates = set.len() as f64 * steps as f64;
    let neighbours = simulation.engine().pair_count() as f64 / set.len() as f64;
    println!("{} particles, {neighbours:.1} neighbours, {steps} steps", set.len());
    let timings = simulation.engine().timings()?;
    let mut total = 0.0;
    for (stage, time, runs) in timings.stages() {
        let nanoseconds = time.as_nanos() as f64 / updates;
        total += nanoseconds;
        println!("  {stage:24} {nanoseconds:9.1} ns per particle and step, {runs} runs");
    }
    println!("  {:24} {total:9.1}", "all kernels");
    println!("  {:24} {:9.1}", "by the clock on the wall", elapsed * 1e9 / updates);
    for kernel in timings.kernels() {
        println!("    {:24} {:9.1}", kernel.name, kernel.seconds * 1e9 / updates);
    }
    Ok(())
}
