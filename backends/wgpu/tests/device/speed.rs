//! How long the search takes; prints, tests nothing.

use std::time::Instant;

use etalon_wgpu::{Device, NeighbourSearch, Timer, Torus};

use crate::common::{Particles, Random, device};

/// `cargo test --release -p etalon-wgpu -- --ignored --nocapture speed`: a jittered 3-D tube with an 8:1 density jump and
/// about 100 neighbours, in a torus twice as long as the tube.
#[test]
#[ignore = "prints timings"]
fn speed_of_the_search() {
    let Some(device) = device() else { return };
    let side = std::env::var("SIDE").ok().and_then(|side| side.parse().ok()).unwrap_or(24);
    let mut random = Random(50);
    let spacing = 1.0 / side as f64;
    let lengths = [8.0, 1.0, 1.0];
    let mut coordinates = vec![Vec::new(); 3];
    let mut reach = Vec::new();
    for (start, spacing) in [(0.0, spacing), (2.0, 2.0 * spacing)] {
        let across = (1.0 / spacing).round() as usize;
        for cell in 0..2 * across * across * across {
            let place = [cell / (across * across), cell / across % across, cell % across];
            for axis in 0..3 {
                let jitter = random.between(0.3, 0.7);
                let x = (place[axis] as f64 + jitter) * spacing + if axis == 0 { start } else { 0.0 };
                coordinates[axis].push((x / lengths[axis] * 4_294_967_296.0) as u32);
            }
            // 4/3 pi reach^3 = 100 spacing^3.
            reach.push((spacing * (300.0 / (4.0 * std::f64::consts::PI)).cbrt()) as f32);
        }
    }
    let mut particles = Particles { torus: Torus::new(&lengths).unwrap(), coordinates, reach };
    measure(device, "particles as a lattice, x slowest", &particles);
    let (coordinates, fields) = particles.upload(device, 1);
    let mut search = NeighbourSearch::new(device, &coordinates, &fields, 0).unwrap();
    search.build(device, &mut Timer::off()).unwrap();
    let order = search.lists().download_order(device).unwrap();
    let sorted = |values: &[u32]| order.iter().map(|i| values[*i as usize]).collect();
    particles.coordinates = particles.coordinates.iter().map(|axis| sorted(axis)).collect();
    particles.reach = order.iter().map(|i| particles.reach[*i as usize]).collect();
    measure(device, "particles in cell order", &particles);
}

fn measure(device: &Device, name: &str, particles: &Particles) {
    let (coordinates, fields) = particles.upload(device, 1);
    let mut search = NeighbourSearch::new(device, &coordinates, &fields, 0).unwrap();
    search.build(device, &mut Timer::off()).unwrap();
    let mut timer = Timer::new(device).unwrap();
    let started = Instant::now();
    let runs = 3;
    let mut entries = 0;
    for _ in 0..runs {
        entries = search.build(device, &mut timer).unwrap().entries;
    }
    let count = particles.count() as f64;
    let per_particle = started.elapsed().as_secs_f64() / f64::from(runs) / count * 1e9;
    eprintln!(
        "{name}: {} particles, {:.1} neighbours, cells {:?}: {per_particle:.0} ns per particle",
        particles.count(),
        f64::from(entries) / count,
        search.cells()
    );
    for time in timer.read(device).unwrap() {
        let per_particle = time.seconds / f64::from(time.runs) / count * 1e9;
        eprintln!("  {:24} {per_particle:8.1} ns per particle", time.name);
    }
}
