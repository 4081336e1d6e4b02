use super::super::testing::Place;
use super::*;
use etalon_kernels_gen::Field;
use etalon_reference::conformance::resume::differing;
use etalon_reference::conformance::sets::{Difficulty, set};
use etalon_reference::engine::{Engine, EngineError, PlainEngine};
use etalon_reference::particles::ParticleSet;
use etalon_reference::passes::Physics;
use etalon_reference::scenes::sod::Sod;
use etalon_reference::schemes::{Dissipation, Kernel, Viscosity};
use etalon_reference::simulation::Simulation;
use etalon_simd::{LaneEngine, Options};

fn physics<const D: usize>() -> Physics {
    Physics { viscosity: Viscosity::of(Dissipation::AvSw), ..Sod::standard(D).physics() }
}

fn particles<const D: usize>() -> ParticleSet<D> {
    set::<D>(Difficulty::None, [100, 16, 9][D - 1], &physics::<D>(), 7).unwrap()
}

/// Half the steps, a file, the other half: the bits of an uninterrupted run.
fn resumes<const D: usize, E: Engine<D>>(name: &str, make: impl Fn(&ParticleSet<D>, &[Field]) -> E) {
    let place = Place::new(&format!("restart-{name}-{D}"));
    let path = place.path("a.restart");
    let set = particles::<D>();
    let settings = Settings::new(name, &physics::<D>(), set.domain());
    let through = |checkpoint: Checkpoint| {
        save(&path, &checkpoint, &settings, &0.1).map_err(EngineError::from_display)?;
        let (found, beside) = load::<D, f64>(&path, &settings).map_err(EngineError::from_display)?;
        assert_eq!(beside, 0.1);
        assert_eq!(
            (found.time, found.next_step, found.steps),
            (checkpoint.time, checkpoint.next_step, checkpoint.steps)
        );
        assert_eq!(found.arrangement, checkpoint.arrangement);
        Ok(found)
    };
    let found = differing(make, &set, physics::<D>(), [4, 6], through).unwrap();
    assert!(found.is_empty(), "{name} in {D}-D: {found:?} differ after a resumed run");
}

#[test]
fn a_run_resumes_bit_for_bit_from_its_file_on_every_engine() {
    resumes::<2, _>("reference f64", |set, _| PlainEngine::<f64, 2>::new(set));
    resumes::<2, _>("reference f32", |set, _| PlainEngine::<f32, 2>::new(set));
    resumes::<2, _>("simd f64", |set, fields| LaneEngine::<f64, 2>::new(set, fields, Options::default()));
    resumes::<2, _>("simd f32", |set, fields| LaneEngine::<f32, 2>::new(set, fields, Options::default()));
    resumes::<1, _>("reference f64", |set, _| PlainEngine::<f64, 1>::new(set));
    resumes::<3, _>("simd f32", |set, fields| LaneEngine::<f32, 3>::new(set, fields, Options::default()));
}

fn checkpoint() -> (Checkpoint, Settings) {
    let set = particles::<1>();
    let mut run = Simulation::new(PlainEngine::<f64, 1>::new(&set), physics::<1>()).unwrap();
    run.step(1.0).unwrap();
    (
        run.checkpoint(&[]).unwrap(),
        Settings::new("reference f64", &physics::<1>(), set.domain()).with("scene", "sod\nn = 100"),
    )
}

#[test]
fn other_settings_are_refused_by_name() {
    let place = Place::new("restart-settings");
    let path = place.path("a.restart");
    let (checkpoint, settings) = checkpoint();
    save(&path, &checkpoint, &settings, &()).unwrap();
    assert_eq!(load::<1, ()>(&path, &settings).unwrap().0.steps, 1);
    let domain = *particles::<1>().domain();
    let refused = |other: Settings| load::<1, ()>(&path, &other).unwrap_err().to_string();
    let message = refused(Settings::new("simd f64", &physics::<1>(), &domain).with("scene", "sod\nn = 100"));
    assert!(message.contains("it was made with engine `reference f64` where this run has `simd f64`"), "{message}");
    let kernel = Physics { kernel: Kernel::WendlandC2, ..physics::<1>() };
    let message = refused(Settings::new("reference f64", &kernel, &domain).with("scene", "sod\nn = 100"));
    assert!(
        message.contains("it was made with physics `kernel: MixedSinc` where this run has `kernel: WendlandC2`"),
        "{message}"
    );
    let message = refused(Settings::new("reference f64", &physics::<1>(), &domain).with("scene", "sod\nn = 200"));
    assert!(message.contains("it was made with scene `n = 100` where this run has `n = 200`"), "{message}");
    let message = refused(Settings::new("reference f64", &physics::<1>(), &domain));
    assert!(message.contains("with scene `sod\nn = 100`, which this run does not have"), "{message}");
}

/// All 128 bits of the random numbers come back.
#[test]
fn a_force_is_kept_with_all_its_bits() {
    let place = Place::new("restart-force");
    let path = place.path("a.restart");
    let (checkpoint, settings) = checkpoint();
    let forcing = Some(ForcingState { amplitudes: vec![0.1 + 0.2, -0.0, 5e-324], random: u128::MAX - 12345 });
    let stirred = Checkpoint { forcing, ..checkpoint };
    save(&path, &stirred, &settings, &vec![1.0 / 3.0]).unwrap();
    let (found, beside) = load::<1, Vec<f64>>(&path, &settings).unwrap();
    assert_eq!((found.forcing, beside), (stirred.forcing, vec![1.0 / 3.0]));
}

/// Cut anywhere, or with any one byte changed: refused, or, where the byte is of no meaning, the same checkpoint.
#[test]
fn a_damaged_file_is_never_taken_for_a_good_one() {
    let place = Place::new("restart-damaged");
    let path = place.path("a.restart");
    let (checkpoint, settings) = checkpoint();
    save(&path, &checkpoint, &settings, &()).unwrap();
    let good = load::<1, ()>(&path, &settings).unwrap();
    let image = std::fs::read(&path).unwrap();
    let mut refused = 0;
    for place in (0..image.len()).step_by(29) {
        std::fs::write(&path, &image[..place]).unwrap();
        assert!(load::<1, ()>(&path, &settings).is_err(), "cut to {place} of {} bytes", image.len());
        let mut spoilt = image.clone();
        spoilt[place] ^= 0x10;
        std::fs::write(&path, &spoilt).unwrap();
        match load::<1, ()>(&path, &settings) {
            Ok(found) => assert_eq!(found, good, "byte {place} is changed"),
            Err(_) => refused += 1,
        }
    }
    assert!(refused > image.len() / 29 * 9 / 10, "only {refused} changes were noticed");
    std::fs::write(&path, b"no restart file").unwrap();
    assert!(load::<1, ()>(&path, &settings).unwrap_err().to_string().contains("cannot be read as HDF5"));
}

#[test]
fn the_last_complete_file_stays_if_the_next_cannot_be_written() {
    let place = Place::new("restart-atomic");
    let path = place.path("a.restart");
    let (checkpoint, settings) = checkpoint();
    save(&path, &checkpoint, &settings, &()).unwrap();
    let next = Checkpoint { time: f64::NAN, ..checkpoint.clone() };
    assert!(save(&path, &next, &settings, &()).is_err());
    assert_eq!(load::<1, ()>(&path, &settings).unwrap().0.time, checkpoint.time);
}
