//! What acts from outside acts in lanes as it does on the reference: gravity, driven walls, a force of the host.

use etalon_kernels_gen::Field;
use etalon_kernels_gen::bounded::Roundoff;
use etalon_kernels_gen::trace::{Double, Single};
use etalon_reference::conformance::external::{check_driven_walls, check_forcing, check_free_fall};
use etalon_reference::engine::EngineError;
use etalon_reference::particles::ParticleSet;
use etalon_simd::{LaneEngine, Number, Options};

fn holds<const D: usize, T: Number, P: Roundoff>() {
    let make = |set: &ParticleSet<D>, fields: &[Field]| -> Result<_, EngineError> {
        Ok(LaneEngine::<T, D>::new(set, fields, Options::default()))
    };
    let fall = check_free_fall::<D, P, _>(make).unwrap();
    let driven = check_driven_walls::<D, P, _>(make).unwrap();
    let pushed = check_forcing::<D, P, _>(make).unwrap();
    for distance in fall.into_iter().chain(driven).chain(pushed) {
        println!("{}: {distance}", T::NAME);
        assert!(distance.holds(), "{}: {distance}", T::NAME);
    }
}

#[test]
fn gas_falls_walls_are_driven_and_forces_push_in_single_precision() {
    holds::<1, f32, Single>();
    holds::<2, f32, Single>();
    holds::<3, f32, Single>();
}

#[test]
fn gas_falls_walls_are_driven_and_forces_push_in_double_precision() {
    holds::<1, f64, Double>();
    holds::<2, f64, Double>();
    holds::<3, f64, Double>();
}
