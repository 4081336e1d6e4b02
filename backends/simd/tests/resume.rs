//! A run on vector lanes that is interrupted goes on bit for bit: the particles are put back into the order in which they were kept.

use etalon_reference::conformance::resume::differing;
use etalon_reference::conformance::sets::{Difficulty, set};
use etalon_reference::engine::{Arrangement, EngineError};
use etalon_reference::passes::Physics;
use etalon_reference::scenes::sod::Sod;
use etalon_reference::schemes::{Dissipation, Viscosity};
use etalon_reference::simulation::{Checkpoint, Simulation};
use etalon_simd::{LaneEngine, Number, Options};

/// The start takes 11 searches; particles are sorted at every tenth. So both parts of the run have a sorting in them, or nearly.
const STEPS: [usize; 2] = [6, 6];

fn found<T: Number, const D: usize>(
    dissipation: Dissipation,
    across: usize,
    through: impl FnOnce(Checkpoint) -> Result<Checkpoint, EngineError>,
) -> Vec<String> {
    let physics = Physics { viscosity: Viscosity::of(dissipation), ..Sod::standard(D).physics() };
    let set = set::<D>(Difficulty::None, across, &physics, 7).unwrap();
    differing(|set, fields| LaneEngine::<T, D>::new(set, fields, Options::default()), &set, physics, STEPS, through)
        .unwrap()
}

#[test]
fn both_precisions_resume_bit_for_bit() {
    for dissipation in [Dissipation::AvSlrB2, Dissipation::AvSw] {
        assert_eq!(found::<f64, 1>(dissipation, 300, Ok), [""; 0]);
        assert_eq!(found::<f32, 1>(dissipation, 300, Ok), [""; 0]);
        assert_eq!(found::<f64, 2>(dissipation, 20, Ok), [""; 0]);
        assert_eq!(found::<f32, 2>(dissipation, 20, Ok), [""; 0]);
    }
    assert_eq!(found::<f64, 3>(Dissipation::AvSlrB2, 9, Ok), [""; 0]);
    assert_eq!(found::<f32, 3>(Dissipation::AvSlrB2, 9, Ok), [""; 0]);
}

/// What the order is saved for: with the particles in another one the sums' last bits differ.
#[test]
fn in_another_order_the_last_bits_differ() {
    let reverse = |checkpoint: Checkpoint| {
        let Arrangement { mut order, searches } = checkpoint.arrangement;
        order.reverse();
        Ok(Checkpoint { arrangement: Arrangement { order, searches }, ..checkpoint })
    };
    assert!(!found::<f32, 2>(Dissipation::AvSlrB2, 20, reverse).is_empty());
}

#[test]
fn coordinates_of_double_precision_are_refused_in_single() {
    let physics = Sod::standard(1).physics();
    let set = set::<1>(Difficulty::None, 100, &physics, 7).unwrap();
    let fields = etalon_reference::pipeline::Pipeline::of_scene::<1>(&physics).fields::<1>();
    let double = LaneEngine::<f64, 1>::new(&set, &fields, Options::default());
    let mut run = Simulation::<1, _>::new(double, physics).unwrap();
    run.step(f64::MAX).unwrap();
    let saved = run.checkpoint(&[]).unwrap();
    let single = LaneEngine::<f32, 1>::new(&set, &fields, Options::default());
    let error = Simulation::<1, _>::new(single, physics).unwrap().restore(&saved).unwrap_err();
    assert!(error.to_string().contains("more digits than single precision keeps"), "{error}");
}
