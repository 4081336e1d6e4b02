//! What acts from outside: gravity, driven walls, a force of the host.

use etalon_kernels_gen::Field;
use etalon_kernels_gen::bounded::Roundoff;
use etalon_kernels_gen::trace::{Double, Single};
use etalon_reference::conformance::external::{check_driven_walls, check_forcing, check_free_fall};
use etalon_reference::conformance::runs::Distance;
use etalon_reference::engine::{EngineError, PlainEngine, Scalar};
use etalon_reference::fields;
use etalon_reference::particles::ParticleSet;
use etalon_reference::passes::{Driver, Physics};
use etalon_reference::pipeline::Pipeline;
use etalon_reference::scenes::sod::Sod;
use etalon_reference::scenes::turbulence::Turbulence;
use etalon_reference::scenes::{Definition, Scene};
use etalon_reference::simulation::Simulation;

fn plain<T: Scalar, const D: usize>(set: &ParticleSet<D>, _: &[Field]) -> Result<PlainEngine<T, D>, EngineError> {
    Ok(PlainEngine::new(set))
}

fn assert_all_hold(distances: Result<Vec<Distance>, EngineError>) {
    for distance in distances.unwrap() {
        println!("{distance}");
        assert!(distance.holds(), "{distance}");
    }
}

fn holds<const D: usize, T: Scalar, P: Roundoff>() {
    assert_all_hold(check_free_fall::<D, P, _>(plain::<T, D>));
    assert_all_hold(check_driven_walls::<D, P, _>(plain::<T, D>));
    assert_all_hold(check_forcing::<D, P, _>(plain::<T, D>));
}

#[test]
fn the_reference_falls_is_driven_and_is_pushed() {
    holds::<1, f64, Double>();
    holds::<2, f64, Double>();
    holds::<3, f64, Double>();
    holds::<1, f32, Single>();
    holds::<2, f32, Single>();
}

/// Fields and updates are there where something acts, and nowhere else.
#[test]
fn only_what_acts_is_carried() {
    let gas = Sod::standard(2).physics();
    let driver = Driver { period: 0.05, moves: true };
    let carried = |physics: Physics| {
        let pipeline = Pipeline::of_scene::<2>(&physics);
        let fields = pipeline.fields::<2>();
        let has = |field| fields.contains(&field);
        (has(fields::DRIVE_VELOCITY), has(fields::FORCING), pipeline.updates().count())
    };
    assert_eq!(carried(gas), (false, false, 2));
    assert_eq!(carried(Physics { driver: Some(driver), ..gas }), (true, false, 4));
    assert_eq!(carried(Physics { driver: Some(Driver { moves: false, ..driver }), ..gas }), (true, false, 3));
    assert_eq!(carried(Physics { forced: true, ..gas }), (false, true, 3));
    let pulled = Physics { gravity: [0.0, -1.0, 0.0], ..gas };
    let [with, without] = [pulled, gas].map(|physics| Pipeline::of_scene::<2>(&physics));
    assert_eq!((with.passes(), with.fields::<2>()), (without.passes(), without.fields::<2>()));
    assert!(pulled.has_gravity(2) && !pulled.has_gravity(1));
}

/// A step is never so long that a driver's oscillation would be missed.
#[test]
fn steps_see_the_oscillation() {
    let driver = Driver { period: 1e-3, moves: false };
    let physics = Physics { driver: Some(driver), ..Sod::standard(1).physics() };
    let set = Sod::standard(1).particles::<1>(|_| Ok(Vec::new())).unwrap();
    let mut run = Simulation::new(PlainEngine::<f64, 1>::new(&set), physics).unwrap();
    assert_eq!(run.step(1.0).unwrap(), driver.longest_step());
}

#[test]
fn a_force_needs_the_field_it_is_carried_in() {
    let problem = Turbulence::standard(1);
    let scene: &dyn Scene<1> = &problem;
    let set = scene.particles(&mut |_| unreachable!("a lattice asks for no glass")).unwrap();
    let physics = Physics { forced: false, ..scene.physics() };
    let force = scene.forcing().unwrap().unwrap();
    let made = Simulation::with_forcing(PlainEngine::<f64, 1>::new(&set), physics, force);
    let message = made.err().unwrap().to_string();
    assert!(message.contains("set `forced`"), "{message}");
}
