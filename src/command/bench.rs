//! `etalon bench`: a complete step, in particle updates per second and per GFLOP/s of the core's peak.
//!
//! Three dimensions, a periodic box, a lattice whose particles are moved by up to a tenth of its spacing and whose velocities, energies and smoothing
//! lengths scatter, 100 neighbours, the mixed sinc kernel, AVSLRB2. Setting up is not timed.

use super::arguments::BenchArguments;
use super::choices::{Backend, Precision};
use super::failure::Failure;
use super::memory::{self, Memory};
use super::run::{Clocked, Timed};
use super::{machine, setup};
use crate::fma_peak::{self, FmaPeak};
use crate::report::model::Stage;
use crate::report::plain;
use etalon_kernels_gen::lanes::level_name;
use etalon_reference::domain::Domain;
use etalon_reference::engine::{Engine, EngineError, PlainEngine};
use etalon_reference::equations::reconstruction::smoothing_length_holding;
use etalon_reference::particles::{Particle, ParticleSet};
use etalon_reference::passes::Physics;
use etalon_reference::pipeline::Pipeline;
use etalon_reference::scenes::sod::Sod;
use etalon_reference::simulation::Simulation;
use etalon_simd::{LaneEngine, Number, Options};
use fearless_simd::Level;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use serde_json::{Value, json};
use std::fmt::Write;
use std::time::Instant;

/// Particles along a side of the reference's box: its cost a particle hardly depends on it, and a million would take minutes.
const REFERENCE_ACROSS: usize = 20;
/// Steps of the reference.
const REFERENCE_STEPS: usize = 2;
/// Fewer along a side, and a support would meet itself around the box.
const LEAST_ACROSS: usize = 8;

/// A time that is not reached, so that no step is cut short.
const FAR: f64 = 1e6;

/// What was measured of one precision.
struct Measured {
    precision: &'static str,
    particles: usize,
    pairs_per_particle: f64,
    nanoseconds: f64,
    stages: Vec<(Stage, f64)>,
    peak_gflops: f64,
    threads: usize,
    speed_up: f64,
    peak_bytes: Option<f64>,
}

impl Measured {
    fn updates_per_second(&self) -> f64 {
        1e9 / self.nanoseconds
    }
    /// Per core and GFLOP/s of its peak; threads beyond the hardware's are no cores.
    fn updates_per_gflop(&self) -> f64 {
        self.updates_per_second() / (self.threads.min(machine::hardware_threads()) as f64 * self.peak_gflops)
    }
}

/// Measures and tells, for people or as JSON.
pub fn bench(arguments: &BenchArguments) -> Result<String, Failure> {
    let level = setup::instructions(arguments.instructions.as_deref())?;
    let across = (arguments.n as f64).cbrt().round() as usize;
    if across < LEAST_ACROSS {
        let least = LEAST_ACROSS.pow(3);
        return Err(Failure::BadInput(format!(
            "--n {}: 100 neighbours need a box of at least {least} particles",
            arguments.n
        )));
    }
    let physics = Sod::standard(3).physics();
    let pipeline = Pipeline::of_scene::<3>(&physics);
    let double = Memory::of::<3>(Backend::Simd, Precision::Double, &pipeline, physics.neighbours);
    memory::check(&format!("--n {}", arguments.n), arguments.n, double.total() + size_of::<Particle<3>>() as f64)?;
    let pool = setup::threads(Some(arguments.threads))?;
    pool.install(|| {
        let peak = fma_peak::measure(level);
        let reference = reference(physics)?;
        // The smaller first: peak memory only ever rises.
        let single = measure::<f32>(arguments, across, level, physics, peak.single, reference)?;
        let double = measure::<f64>(arguments, across, level, physics, peak.double, reference)?;
        let all = [double, single];
        if arguments.json {
            super::to_text(&as_json(&all, level, peak, reference))
        } else {
            Ok(text(&all, level, peak, reference))
        }
    })
}

/// A jittered lattice in the unit box.
fn particles(across: usize, physics: Physics) -> Result<ParticleSet<3>, Failure> {
    let spacing = 1.0 / across as f64;
    let mut random = Pcg64Mcg::seed_from_u64(1);
    let mut scatter = move |size: f64| size * (random.random::<f64>() - 0.5);
    let h = smoothing_length_holding(physics.neighbours, spacing.powi(3), 3, physics.kernel.support());
    let particle = |i: usize| {
        let cell = [i % across, i / across % across, i / across / across];
        Particle {
            position: cell.map(|c| ((c as f64 + 0.5 + scatter(0.2)) * spacing).rem_euclid(1.0)),
            velocity: [scatter(1.0), scatter(1.0), scatter(1.0)],
            mass: spacing.powi(3),
            smoothing_length: h * (1.0 + scatter(0.05)),
            internal_energy: 1.0 + scatter(0.1),
            mobile: true,
        }
    };
    let broken = |error: &dyn std::fmt::Display| Failure::Broken(error.to_string());
    let domain = Domain::new([0.0; 3], [1.0; 3], [true; 3]).map_err(|e| broken(&e))?;
    ParticleSet::new(domain, (0..across.pow(3)).map(particle).collect()).map_err(|e| broken(&e))
}

/// Nanoseconds a particle update of the scalar reference takes.
fn reference(physics: Physics) -> Result<f64, Failure> {
    let set = particles(REFERENCE_ACROSS, physics)?;
    let mut simulation = Simulation::new(Timed::new(PlainEngine::<f64, 3>::new(&set)), physics)?;
    Ok(time(&mut simulation, REFERENCE_STEPS)? * 1e9 / (set.len() * REFERENCE_STEPS) as f64)
}

/// Wall-clock seconds of some steps.
fn time<E: Engine<3> + Clocked>(simulation: &mut Simulation<3, E>, steps: usize) -> Result<f64, EngineError> {
    simulation.engine().restart()?;
    let start = Instant::now();
    for _ in 0..steps {
        simulation.step(FAR)?;
    }
    Ok(start.elapsed().as_secs_f64())
}

fn measure<T: Number>(
    arguments: &BenchArguments,
    across: usize,
    level: Level,
    physics: Physics,
    peak_gflops: f64,
    reference: f64,
) -> Result<Measured, Failure> {
    let set = particles(across, physics)?;
    let particles = set.len();
    let fields = Pipeline::of_scene::<3>(&physics).fields::<3>();
    let engine = LaneEngine::<T, 3>::new(&set, &fields, Options { level });
    drop(set);
    let mut simulation = Simulation::new(engine, physics)?;
    let seconds = time(&mut simulation, arguments.steps)?;
    let updates = (particles * arguments.steps) as f64;
    let engine = simulation.engine();
    let nanoseconds = seconds * 1e9 / updates;
    let each = |stage: Stage| {
        let nanoseconds = stage.seconds * 1e9 / updates;
        (stage, nanoseconds)
    };
    Ok(Measured {
        precision: T::NAME,
        particles,
        pairs_per_particle: engine.pair_count() as f64 / particles as f64,
        nanoseconds,
        stages: engine.stages()?.into_iter().map(each).collect(),
        peak_gflops,
        threads: arguments.threads,
        speed_up: reference / nanoseconds,
        peak_bytes: machine::peak_memory().map(|bytes| bytes as f64 / particles as f64),
    })
}

fn as_json(all: &[Measured], level: Level, peak: FmaPeak, reference: f64) -> Value {
    let one = |m: &Measured| {
        let stage = |(stage, nanoseconds): &(Stage, f64)| json!({ "name": stage.name, "nanoseconds_per_update": nanoseconds, "count": stage.count });
        let mut entry = json!({
            "backend": "simd",
            "precision": m.precision,
            "particles": m.particles,
            "pairs_per_particle": m.pairs_per_particle,
            "threads": m.threads,
            "nanoseconds_per_update": m.nanoseconds,
            "updates_per_second": m.updates_per_second(),
            "updates_per_gflop": m.updates_per_gflop(),
            "speed_up": m.speed_up,
            "stages": m.stages.iter().map(stage).collect::<Vec<_>>(),
        });
        if let Some(bytes) = m.peak_bytes {
            entry["peak_bytes_per_particle"] = json!(bytes);
        }
        entry
    };
    json!({
        "schema": "etalon-bench",
        "schema_version": 1,
        "machine": {
            "cpu": machine::processor(),
            "system": machine::system(),
            "instruction_set": level_name(level),
            "fma_peak_gflops_per_core": { "f32": peak.single, "f64": peak.double },
        },
        "reference": { "precision": "f64", "particles": REFERENCE_ACROSS.pow(3), "nanoseconds_per_update": reference },
        "runs": all.iter().map(one).collect::<Vec<_>>(),
    })
}

fn text(all: &[Measured], level: Level, peak: FmaPeak, reference: f64) -> String {
    let mut out = String::new();
    // Writing to a string cannot fail.
    let mut line = |text: String| {
        let _ = writeln!(out, "{}", text.trim_end());
    };
    let first = &all[0];
    line(format!(
        "A complete step in 3-D: periodic box, jittered lattice, kernel sinc49, AVSLRB2, {} particles, {:.1} neighbours, {} thread{}",
        first.particles,
        first.pairs_per_particle,
        first.threads,
        if first.threads == 1 { "" } else { "s" }
    ));
    line(format!(
        "{}, {}; FMA peak of a core {:.1} GFLOP/s in f64, {:.1} in f32\n",
        machine::processor(),
        level_name(level),
        peak.double,
        peak.single
    ));
    let cells = |of: &dyn Fn(&Measured) -> String| all.iter().map(|m| format!("{:>12}", of(m))).collect::<String>();
    let mut row = |name: &str, of: &dyn Fn(&Measured) -> String| line(format!("{name:<34}{}", cells(of)));
    row("", &|m| m.precision.into());
    for (index, (stage, _)) in first.stages.iter().enumerate() {
        let nanoseconds = |m: &Measured| m.stages.get(index).map_or_else(String::new, |(_, ns)| format!("{ns:.0}"));
        row(&format!("  {}, ns a particle", stage.name), &nanoseconds);
    }
    row("complete step, ns a particle", &|m| format!("{:.0}", m.nanoseconds));
    row("particle updates per second", &|m| plain(m.updates_per_second()));
    row("updates_per_gflop", &|m| format!("{:.0}", m.updates_per_gflop()));
    row("speed-up over the reference", &|m| plain(m.speed_up));
    row("peak memory, bytes a particle", &|m| m.peak_bytes.map_or_else(|| "unknown".into(), |b| format!("{b:.0}")));
    line(format!(
        "\nThe scalar reference (f64, {} particles) takes {reference:.0} ns a particle. updates_per_gflop: updates per second and core,\n\
         divided by the peak of that precision measured in the same run. Memory is that of the whole program.",
        REFERENCE_ACROSS.pow(3)
    ));
    out
}
