//! The five rungs of C25's ladder on two small problems with known answers, run by the reference: docs/ladder.md has what it prints.
//!
//! ```text
//! cargo run --release -p etalon-reference --example ladder
//! ```

use etalon_reference::engine::{Engine, PlainEngine};
use etalon_reference::fields;
use etalon_reference::norms::l1_error;
use etalon_reference::scenes::gresho_chan::{self, GreshoChan};
use etalon_reference::scenes::sod::{self, INTERFACE, MEASURED, Sod};
use etalon_reference::scenes::{Definition, Scene, State};
use etalon_reference::schemes::Rung;
use etalon_reference::simulation::Simulation;
use std::error::Error;

type Outcome<T> = Result<T, Box<dyn Error>>;

/// `L_1` of the velocity of the tube at its end, in one dimension.
fn tube(rung: Rung) -> Outcome<f64> {
    let scene = Sod::standard(1).with(|method| *method = method.on(rung));
    let set = scene.particles::<1>(|_| Ok(Vec::new()))?;
    let mut run = Simulation::new(PlainEngine::<f64, 1>::new(&set), scene.physics())?;
    run.run(sod::END_TIME, |_| {})?;
    let x: Vec<f64> = run.engine().coordinates(0)?.iter().map(|&x| set.domain().decode(0, x)).collect();
    let velocity = run.engine().read_all(fields::VELOCITY)?.remove(0);
    let exact = scene.exact()?;
    let due: Vec<f64> = x.iter().map(|x| exact.sample((x - INTERFACE) / sod::END_TIME).velocity).collect();
    Ok(l1_error(&velocity, &due, &x, MEASURED)?)
}

/// What the vortex measures at its end, in two dimensions, by name.
fn vortex(rung: Rung, particles: usize) -> Outcome<Vec<(&'static str, f64)>> {
    let mut vortex = GreshoChan::standard(2);
    vortex.method.particles = particles;
    vortex.method = vortex.method.on(rung);
    let scene: &dyn Scene<2> = &vortex;
    let set = scene.particles(&mut |_| Ok(Vec::new()))?;
    let mut run = Simulation::new(PlainEngine::<f64, 2>::new(&set), scene.physics())?;
    run.run(0.0, |_| {})?;
    let start = State::read(run.engine(), set.domain(), 0.0)?;
    run.run(gresho_chan::END_TIME, |_| {})?;
    let end = State::read(run.engine(), set.domain(), gresho_chan::END_TIME)?;
    let values = scene.observe_since(&start, &end)?;
    Ok(scene.quantities().iter().map(|quantity| quantity.name).zip(values).collect())
}

fn main() -> Outcome<()> {
    for &rung in Rung::ALL {
        println!("Sod's tube, 1-D, {rung}: L1 of the velocity {:.3e}", tube(rung)?);
    }
    for particles in [900, 2500] {
        for &rung in Rung::ALL {
            let values = vortex(rung, particles)?;
            let values: Vec<String> = values.iter().map(|(name, value)| format!("{name} {value:.3e}")).collect();
            println!("Gresho-Chan vortex, 2-D, {particles} particles, {rung}: {}", values.join(", "));
        }
    }
    Ok(())
}
