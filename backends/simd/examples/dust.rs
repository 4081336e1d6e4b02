//! The experiments of `docs/dust.md`: what drag's reconstruction and its limiters do to the dusty wave and the dusty shock.
//!
//! ```text
//! cargo run --release -p etalon-simd --example dust -- wave 128      all schemes, at one resolution: the columns of PL20 Figs. 1 and 3
//! cargo run --release -p etalon-simd --example dust -- order 10      error against resolution to this time: PL20 Fig. 4
//! cargo run --release -p etalon-simd --example dust -- shock 128     all schemes, 1-D: PL20 Fig. 5
//! cargo run --release -p etalon-simd --example dust -- shock3 128    the paper's own, 3-D; half an hour and more
//! ```

use etalon_reference::domain::Domain;
use etalon_reference::engine::Engine;
use etalon_reference::fields;
use etalon_reference::norms::l1_error;
use etalon_reference::particles::ParticleSet;
use etalon_reference::passes::Physics;
use etalon_reference::pipeline::Pipeline;
use etalon_reference::scenes::dustyshock::{self, DustyShock};
use etalon_reference::scenes::dustywave::{self, DustyWave};
use etalon_reference::schemes::{CommonPoint, Drag, DragReconstruction, SlopeLimiter};
use etalon_reference::simulation::Simulation;
use etalon_simd::{LaneEngine, Options};
use std::error::Error;
use std::time::Instant;

type Outcome<T> = Result<T, Box<dyn Error>>;

/// Everything PL20 compares, by name.
fn schemes(coefficient: f64) -> Vec<(&'static str, Drag)> {
    let with = |point, limiter, entropy_fix| Drag {
        reconstruction: DragReconstruction { point, limiter },
        entropy_fix,
        ..Drag::of(coefficient)
    };
    use CommonPoint::{Barycentre, Particles};
    use SlopeLimiter::{Minmod, MonotonizedCentral, Superbee, Unlimited, VanLeer};
    vec![
        ("no reconstruction", with(Particles, Unlimited, false)),
        ("entropy fix, no limiter", with(Barycentre, Unlimited, true)),
        ("minmod", with(Barycentre, Minmod, false)),
        ("van Leer", with(Barycentre, VanLeer, false)),
        ("MC", with(Barycentre, MonotonizedCentral, false)),
        ("Superbee", with(Barycentre, Superbee, false)),
        ("no limiter", with(Barycentre, Unlimited, false)),
    ]
}

/// Where particles are along x and what they do there, at the end of a run.
struct Found {
    x: Vec<f64>,
    velocity: Vec<f64>,
    density: Vec<f64>,
    mass: Vec<f64>,
    mobile: Vec<bool>,
    steps: u64,
    seconds: f64,
}

fn run<const D: usize>(set: &ParticleSet<D>, physics: Physics, until: f64) -> Outcome<Found> {
    let all = Pipeline::of_scene::<D>(&physics).fields::<D>();
    let start = Instant::now();
    let mut simulation = Simulation::new(LaneEngine::<f64, D>::new(set, &all, Options::default()), physics)?;
    simulation.run(until, |_| {})?;
    let (seconds, steps) = (start.elapsed().as_secs_f64(), simulation.steps());
    let engine = simulation.engine();
    let domain: &Domain<D> = set.domain();
    Ok(Found {
        x: engine.coordinates(0)?.iter().map(|&x| domain.decode(0, x)).collect(),
        velocity: engine.read_all(fields::VELOCITY)?.swap_remove(0),
        density: engine.read_scalar(fields::DENSITY)?,
        mass: engine.read_scalar(fields::MASS)?,
        mobile: set.particles().iter().map(|p| p.mobile).collect(),
        steps,
        seconds,
    })
}

/// L1 of the velocity and the kinetic energy, both over what the exact solution has.
fn wave(scene: &DustyWave, until: f64) -> Outcome<(f64, f64, Found)> {
    let found = run::<1>(&scene.particles::<1>()?, scene.physics(), until)?;
    let (exact, start) = (scene.exact()?, scene.initial());
    let gas = found.x.len() / 2;
    let due: Vec<f64> = found
        .x
        .iter()
        .enumerate()
        .map(|(i, &x)| {
            let at = exact.at(x, until, start);
            if i < gas { at.gas_velocity } else { at.dust_velocity }
        })
        .collect();
    let error = l1_error(&found.velocity, &due, &found.x, (f64::NEG_INFINITY, f64::INFINITY))?;
    let energy: f64 = found.mass.iter().zip(&found.velocity).map(|(m, v)| 0.5 * m * v * v).sum();
    Ok((error / scene.amplitude, energy / exact.kinetic_energy(until, start), found))
}

fn waves(particles: usize) -> Outcome<()> {
    println!("DUSTYWAVE, n_x = {particles}, t = {}", dustywave::END_TIME);
    println!("{:24} {:>12} {:>14} {:>8} {:>7}", "", "L1 / amplitude", "E_kin / exact", "steps", "s");
    for (name, drag) in schemes(dustywave::DRAG_COEFFICIENT) {
        let scene = DustyWave { particles, drag, ..DustyWave::standard(1) };
        let (error, energy, found) = wave(&scene, dustywave::END_TIME)?;
        println!("{name:24} {error:>12.4e} {energy:>14.5} {:>8} {:>7.1}", found.steps, found.seconds);
    }
    Ok(())
}

fn order(until: f64) -> Outcome<()> {
    println!("DUSTYWAVE, t = {until}: L1 of the velocity over the amplitude");
    println!("{:>6} {:>18} {:>12} {:>12}", "n_x", "no reconstruction", "MC", "no limiter");
    let columns: Vec<Drag> = schemes(dustywave::DRAG_COEFFICIENT)
        .into_iter()
        .filter(|(name, _)| ["no reconstruction", "MC", "no limiter"].contains(name))
        .map(|(_, drag)| drag)
        .collect();
    for particles in [16, 32, 64, 128, 256, 512, 1024] {
        print!("{particles:>6}");
        for &drag in &columns {
            print!("   {:>12.4e}", wave(&DustyWave { particles, drag, ..DustyWave::standard(1) }, until)?.0);
        }
        println!();
    }
    Ok(())
}

fn shocks<const D: usize>(particles: usize, only: Option<&str>) -> Outcome<()> {
    let until = dustyshock::END_TIME;
    println!("DUSTYSHOCK, {D}-D, n_x = {particles} left of the interface, t = {until}: L1 of the velocity");
    println!("{:24} {:>10} {:>10} {:>10} {:>8} {:>7}", "", "both", "gas", "dust", "steps", "s");
    for (name, drag) in schemes(dustyshock::DRAG_COEFFICIENT) {
        if only.is_some_and(|only| only != name) {
            continue;
        }
        let scene = DustyShock { particles, drag, ..DustyShock::standard(D) };
        let found = run::<D>(&scene.particles::<D>()?, scene.physics(), until)?;
        let exact = scene.exact()?;
        let off: Vec<f64> = found
            .x
            .iter()
            .zip(&found.velocity)
            .map(|(x, v)| (v - exact.sample((x - dustyshock::INTERFACE) / until).velocity).abs())
            .collect();
        let count = off.len();
        let mean = |from: usize, to: usize| {
            let counted: Vec<f64> = (from..to).filter(|&i| found.mobile[i]).map(|i| off[i]).collect();
            counted.iter().sum::<f64>() / counted.len() as f64
        };
        let (both, gas, dust) = (mean(0, count), mean(0, count / 2), mean(count / 2, count));
        let most = found.velocity.iter().fold(0.0_f64, |a, b| a.max(*b));
        let dense = found.density.iter().fold(0.0_f64, |a, b| a.max(*b));
        println!(
            "{name:24} {both:>10.3e} {gas:>10.3e} {dust:>10.3e} {:>8} {:>7.1}   largest velocity {most:.4}, density {dense:.4}",
            found.steps, found.seconds
        );
    }
    Ok(())
}

fn main() -> Outcome<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let number = |k: usize| arguments.get(k).and_then(|text| text.parse::<f64>().ok());
    let only = arguments.get(2).map(String::as_str);
    match (arguments.first().map(String::as_str), number(1)) {
        (Some("wave"), n) => waves(n.unwrap_or(128.0) as usize),
        (Some("order"), until) => order(until.unwrap_or(dustywave::END_TIME)),
        (Some("shock"), n) => shocks::<1>(n.unwrap_or(128.0) as usize, only),
        (Some("shock2"), n) => shocks::<2>(n.unwrap_or(128.0) as usize, only),
        (Some("shock3"), n) => shocks::<3>(n.unwrap_or(128.0) as usize, only),
        _ => Err("say which: wave N, order TIME, shock N, shock2 N or shock3 N".into()),
    }
}
