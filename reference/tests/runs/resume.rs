//! A run that is interrupted goes on bit for bit, and a checkpoint that does not fit is refused.

use etalon_reference::conformance::resume::differing;
use etalon_reference::conformance::sets::{Difficulty, set};
use etalon_reference::engine::{Arrangement, EngineError, PlainEngine, Scalar};
use etalon_reference::fields;
use etalon_reference::particles::ParticleSet;
use etalon_reference::passes::Physics;
use etalon_reference::pipeline::Pipeline;
use etalon_reference::scenes::sod::Sod;
use etalon_reference::scenes::turbulence::Turbulence;
use etalon_reference::scenes::{Definition, Scene, State};
use etalon_reference::schemes::{Dissipation, Viscosity};
use etalon_reference::simulation::{Checkpoint, Simulation};
use etalon_reference::turbulence::forcing::ForcingState;

fn resumes<T: Scalar, const D: usize>(dissipation: Dissipation, across: usize) {
    let viscosity = Viscosity { conduction: Viscosity::CONDUCTION, ..Viscosity::of(dissipation) };
    let physics = Physics { viscosity, ..Sod::standard(D).physics() };
    let set = set::<D>(Difficulty::None, across, &physics, 7).unwrap();
    let found = differing(|set, _| PlainEngine::<T, D>::new(set), &set, physics, [2, 2], Ok).unwrap();
    assert!(found.is_empty(), "{D}-D, {dissipation}: {found:?} differ after a resumed run");
}

#[test]
fn every_scheme_resumes_bit_for_bit_on_the_scalar_reference() {
    for &dissipation in Dissipation::ALL {
        resumes::<f64, 1>(dissipation, 100);
        resumes::<f32, 1>(dissipation, 100);
    }
    resumes::<f64, 2>(Dissipation::AvSwSlr, 14);
    resumes::<f32, 3>(Dissipation::AvSlrB2, 9);
}

/// A field fewer would not do: each that is carried changes the run if it is lost.
#[test]
fn nothing_is_carried_in_vain() {
    let physics = Physics { viscosity: Viscosity::of(Dissipation::AvSw), ..Sod::standard(1).physics() };
    let set = set::<1>(Difficulty::None, 100, &physics, 7).unwrap();
    for lost in Pipeline::of_scene::<1>(&physics).carried::<1>() {
        let spoil = |mut checkpoint: Checkpoint| {
            for (component, values) in &mut checkpoint.columns {
                if component.field == lost {
                    // Also what is zero everywhere, or the same everywhere, changes.
                    values.iter_mut().for_each(|value| *value = 1.25 * *value + 0.01);
                }
            }
            Ok(checkpoint)
        };
        let found = differing(|set, _| PlainEngine::<f64, 1>::new(set), &set, physics, [2, 2], spoil);
        assert!(found.is_err() || found.is_ok_and(|names| !names.is_empty()), "{} is carried in vain", lost.name);
    }
}

type Run = Simulation<1, PlainEngine<f64, 1>>;

fn wave() -> (ParticleSet<1>, Physics, Checkpoint) {
    let physics = Sod::standard(1).physics();
    let set = set::<1>(Difficulty::None, 100, &physics, 7).unwrap();
    let checkpoint = Run::new(PlainEngine::new(&set), physics).unwrap().checkpoint(&[]).unwrap();
    (set, physics, checkpoint)
}

#[test]
fn a_checkpoint_that_does_not_fit_is_refused_in_words() {
    let (set, physics, good) = wave();
    let refused = |physics: Physics, checkpoint: &Checkpoint| {
        let EngineError(text) = Run::new(PlainEngine::new(&set), physics).unwrap().restore(checkpoint).unwrap_err();
        text
    };
    let mut bad = good.clone();
    bad.coordinates.push(Vec::new());
    assert_eq!(refused(physics, &bad), "the checkpoint is of a run in 2 dimensions, not in 1");
    let mut bad = good.clone();
    bad.coordinates[0].pop();
    assert_eq!(refused(physics, &bad), "the checkpoint has 99 particles where the scene has 100");
    let bad = Checkpoint { time: f64::NAN, ..good.clone() };
    assert!(refused(physics, &bad).contains("of time NaN"));
    let bad = Checkpoint { forcing: Some(ForcingState { amplitudes: vec![0.0], random: 1 }), ..good.clone() };
    assert!(refused(physics, &bad).contains("a force stirs"));
    let bad = Checkpoint { arrangement: Arrangement { order: (0..100).collect(), searches: 3 }, ..good.clone() };
    assert!(refused(physics, &bad).contains("resume with the engine it was made with"));
    let switching = Physics { viscosity: Viscosity::of(Dissipation::AvSw), ..Sod::standard(1).physics() };
    assert_eq!(refused(switching, &good), "the checkpoint has no alpha, which this physics carries on");
    let mut bad = good.clone();
    bad.columns
        .iter_mut()
        .for_each(|(component, values)| values.truncate(if component.field == fields::MASS { 5 } else { 100 }));
    assert_eq!(refused(physics, &bad), "mass has 5 values for 100 particles");
}

/// The force goes on with the random numbers at which it was; and what is shown between two steps is there at once.
#[test]
fn a_stirred_run_resumes_bit_for_bit() {
    let scene = Turbulence::standard(2).with(|method| method.particles = 144);
    let set = Scene::<2>::particles(&scene, &mut |_| unreachable!("it starts from a lattice")).unwrap();
    let start = || {
        let force = Scene::<2>::forcing(&scene).unwrap().unwrap();
        Simulation::with_forcing(PlainEngine::<f64, 2>::new(&set), Scene::<2>::physics(&scene), force).unwrap()
    };
    let steps = |run: &mut Simulation<2, _>| (0..5).for_each(|_| assert!(run.step(f64::MAX).unwrap() > 0.0));
    let shown = |run: &mut Simulation<2, PlainEngine<f64, 2>>| {
        let time = run.time();
        let state = State::read_for::<2, _>(&scene, run.engine(), set.domain(), time).unwrap();
        format!("{state:?} {:?}", run.forcing().unwrap().state())
    };
    let mut whole = start();
    steps(&mut whole);
    let saved = whole.checkpoint(Scene::<2>::further_fields(&scene)).unwrap();
    let mut second = start();
    second.restore(&saved).unwrap();
    assert_eq!(shown(&mut second), shown(&mut whole));
    steps(&mut whole);
    steps(&mut second);
    assert_eq!(shown(&mut second), shown(&mut whole));
    let still = second.restore(&Checkpoint { forcing: None, ..saved }).unwrap_err();
    assert!(still.to_string().contains("that no force stirs"), "{still}");
}

#[test]
fn an_order_is_a_permutation_or_refused() {
    let order = |order: &[u32]| Arrangement { order: order.to_vec(), searches: 1 };
    // Particle 2 is at place 0 now, and so on.
    assert_eq!(order(&[0, 1, 2]).sources(&[2, 0, 1]), Ok(vec![1, 2, 0]));
    for bad in [&[0, 1][..], &[0, 1, 1], &[0, 1, 3], &[0, 1, 2, 3]] {
        assert!(order(bad).sources(&[2, 0, 1]).is_err(), "{bad:?} was taken");
    }
}
