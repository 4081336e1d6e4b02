//! Driven turbulence, small: the gas starts to move as it is pushed, its momentum stays zero, and a run can be taken up again.

use etalon_reference::engine::{Engine, PlainEngine};
use etalon_reference::fields;
use etalon_reference::particles::ParticleSet;
use etalon_reference::scenes::turbulence::Turbulence;
use etalon_reference::scenes::{Definition, Scene, SceneError};
use etalon_reference::simulation::Simulation;
use etalon_reference::turbulence::forcing::Forcing;

fn start<const D: usize>(scene: &Turbulence) -> ParticleSet<D> {
    scene.particles(&mut |_| unreachable!("a lattice asks for no glass")).unwrap()
}

fn force<const D: usize>(scene: &Turbulence) -> Forcing<D> {
    scene.forcing().unwrap().unwrap()
}

/// The root mean square Mach number and the largest component of the momentum over mass, per sound speed.
fn motion(run: &mut Simulation<2, PlainEngine<f64, 2>>) -> (f64, f64) {
    let velocity = run.engine().read_all(fields::VELOCITY).unwrap();
    let sound = run.engine().read_scalar(fields::SOUND_SPEED).unwrap();
    let count = sound.len() as f64;
    let squares: f64 = (0..sound.len()).map(|i| velocity.iter().map(|v| (v[i] / sound[i]).powi(2)).sum::<f64>()).sum();
    let momentum = velocity.iter().map(|v| (v.iter().sum::<f64>() / count).abs()).fold(0.0, f64::max);
    ((squares / count).sqrt(), momentum)
}

#[test]
fn the_mach_number_grows_as_the_force_makes_it_and_momentum_stays_zero() {
    let scene = Turbulence::standard(2).with(|m| m.particles = 256);
    let set = start::<2>(&scene);
    let force = force::<2>(&scene);
    let mut run =
        Simulation::with_forcing(PlainEngine::<f64, 2>::new(&set), Scene::<2>::physics(&scene), force).unwrap();
    let push = run.engine().read_all(fields::FORCING).unwrap();
    let rms = (push.iter().flatten().map(|f| f * f).sum::<f64>() / set.len() as f64).sqrt();
    let mut before = 0.0;
    for until in [0.05, 0.2, 0.6] {
        run.run(until, |_| {}).unwrap();
        let (mach, momentum) = motion(&mut run);
        println!("t = {until}: Mach {mach:.4}, momentum {momentum:e}");
        assert!(mach > 1.5 * before, "Mach {mach} after {before}");
        // Roundings of the velocities, and of as many forces as there are pairs: 26 terms of order c^2/h in each of some fifty steps.
        let tolerance = 50.0 * 26.0 * f64::EPSILON * 20.0 * until;
        assert!(momentum < tolerance, "t = {until}: momentum {momentum:e}, tolerance {tolerance:e}");
        if until == 0.05 {
            // In a thirtieth of the force's memory it has hardly changed, and sound has come a twentieth of a wave.
            let due = rms * until / scene.sound_speed();
            assert!((mach / due - 1.0).abs() < 0.1, "Mach {mach} where {due} is due");
        }
        before = mach;
    }
}

/// The state of the force in the middle of a run makes the same force go on the same way.
#[test]
fn a_force_is_taken_up_again_to_the_bit() {
    let scene = Turbulence::standard(2).with(|m| m.particles = 256);
    let set = start::<2>(&scene);
    let mut run =
        Simulation::with_forcing(PlainEngine::<f64, 2>::new(&set), Scene::<2>::physics(&scene), force::<2>(&scene))
            .unwrap();
    for _ in 0..3 {
        run.step(1.0).unwrap();
    }
    let mut again = force::<2>(&scene);
    let mut onwards = run.forcing().unwrap().clone();
    assert_ne!(again.waves(), onwards.waves(), "three steps changed the force");
    again.restore(&onwards.state()).unwrap();
    for force in [&mut again, &mut onwards] {
        force.advance(0.01).unwrap();
    }
    assert_eq!(again.waves(), onwards.waves());
    let mut short = onwards.state();
    short.amplitudes.pop();
    let message = again.restore(&short).unwrap_err().to_string();
    assert!(message.contains("amplitudes"), "{message}");
}

#[test]
fn a_refusal_names_a_number_that_works() {
    fn check<const D: usize>() {
        let scene = Turbulence::standard(D).with(|m| m.particles = 2);
        match Scene::<D>::check(&scene) {
            Err(SceneError::TooFew { enough, .. }) => {
                let more = scene.with(|m| m.particles = enough);
                let engine = PlainEngine::<f64, D>::new(&start::<D>(&more));
                // With as many it runs; with fewer particles neighbours would not be found.
                Simulation::with_forcing(engine, Scene::<D>::physics(&more), force::<D>(&more)).unwrap();
            }
            other => panic!("{other:?}"),
        }
    }
    check::<1>();
    check::<2>();
    check::<3>();
}
