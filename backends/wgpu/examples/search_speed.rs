//! Nanoseconds per particle of each kernel of the neighbour search, on the adapter that `ETALON_ADAPTER` names.
//!
//! `cargo run --release -p etalon-wgpu --example search_speed -- [ACROSS]`: a jittered 3-D tube with an 8:1 density jump, `ACROSS`
//! particles to a side of its dense half (24 if not given), about 100 neighbours, in a torus twice as long as the tube; once in
//! the order of the lattice, and once in that of the search's cells, in which the engine keeps its particles.

#[path = "../tests/support/random.rs"]
mod random;

use std::error::Error;
use std::f64::consts::PI;
use std::time::Instant;

use etalon_wgpu::{Coordinates, Device, FieldStore, NeighbourSearch, Timer, Torus};
use random::Random;

/// Searches that are timed, after one that compiles.
const RUNS: u32 = 3;
/// The torus.
const LENGTHS: [f64; 3] = [8.0, 1.0, 1.0];
/// Fewer on the dense side, and the other has not even two across.
const LEAST_ACROSS: usize = 4;

/// `coordinates[axis][particle]`, and each one's support radius.
struct Particles {
    coordinates: [Vec<u32>; 3],
    reach: Vec<f32>,
}

fn main() -> Result<(), Box<dyn Error>> {
    let across = std::env::args().nth(1).map_or(Ok(24), |across| across.parse())?;
    if across < LEAST_ACROSS {
        return Err(format!("{across} particles across are too few: give at least {LEAST_ACROSS}").into());
    }
    let device = etalon_wgpu::open(None)?;
    println!("{}", device.adapter());
    let particles = tube(across);
    let order = measure(&device, "in the order of the lattice", &particles)?;
    measure(&device, "in the order of the cells", &particles.sorted(&order))?;
    Ok(())
}

/// The tube, x slowest.
fn tube(across: usize) -> Particles {
    let mut random = Random(50);
    let mut particles = Particles { coordinates: Default::default(), reach: Vec::new() };
    for (start, across) in [(0.0, across), (2.0, across / 2)] {
        let spacing = 1.0 / across as f64;
        for cell in 0..2 * across.pow(3) {
            let place = [cell / across.pow(2), cell / across % across, cell % across];
            for axis in 0..3 {
                let jitter = random.between(0.3, 0.7);
                let x = (place[axis] as f64 + jitter) * spacing + if axis == 0 { start } else { 0.0 };
                particles.coordinates[axis].push((x / LENGTHS[axis] * 2.0_f64.powi(32)) as u32);
            }
            // 4/3 pi reach^3 = 100 spacing^3.
            particles.reach.push((spacing * (75.0 / PI).cbrt()) as f32);
        }
    }
    particles
}

impl Particles {
    fn sorted(&self, order: &[u32]) -> Self {
        Particles {
            coordinates: self.coordinates.each_ref().map(|axis| order.iter().map(|i| axis[*i as usize]).collect()),
            reach: order.iter().map(|i| self.reach[*i as usize]).collect(),
        }
    }
}

/// Prints how long searches take; returns the particles in the order of the cells.
fn measure(device: &Device, name: &str, particles: &Particles) -> Result<Vec<u32>, Box<dyn Error>> {
    let count = particles.reach.len();
    let coordinates = Coordinates::new(device, Torus::new(&LENGTHS)?, count)?;
    for (axis, values) in particles.coordinates.iter().enumerate() {
        coordinates.upload(device, axis, values)?;
    }
    let fields = FieldStore::new(device, 1, count)?;
    fields.upload(device, 0, &particles.reach)?;
    let mut search = NeighbourSearch::new(device, &coordinates, &fields, 0)?;
    search.build(device, &mut Timer::off())?;

    let mut timer = Timer::new(device)?;
    let started = Instant::now();
    let mut entries = 0;
    for _ in 0..RUNS {
        entries = search.build(device, &mut timer)?.entries;
    }
    let nanoseconds = |seconds: f64, runs: u32| seconds * 1e9 / f64::from(runs) / count as f64;
    let neighbours = f64::from(entries) / count as f64;
    println!("{count} particles {name}, {neighbours:.1} neighbours, cells {:?}", search.cells());
    println!(
        "  {:24} {:9.1} ns per particle",
        "by the clock on the wall",
        nanoseconds(started.elapsed().as_secs_f64(), RUNS)
    );
    for kernel in timer.read(device)? {
        println!("  {:24} {:9.1}", kernel.name, nanoseconds(kernel.seconds, kernel.runs));
    }
    Ok(search.lists().download_order(device)?)
}
