//! A run in which something is not a number stops.

use etalon_kernels_gen::Field;
use etalon_reference::conformance::poison::{POISONED, stopped_by};
use etalon_reference::engine::{PlainEngine, Scalar};
use etalon_reference::fields;
use etalon_reference::particles::ParticleSet;
use etalon_reference::passes::Physics;
use etalon_reference::scenes::sod::Sod;
use etalon_reference::schemes::{Dissipation, Viscosity};

fn stops<T: Scalar, const D: usize>(physics: Physics, values: &[f64]) {
    let make = |set: &ParticleSet<D>, _: &[Field]| PlainEngine::<T, D>::new(set);
    for field in POISONED {
        for &bad in values {
            let said = stopped_by(make, physics, field, bad).unwrap_or_else(|error| panic!("{error}, {physics:?}"));
            let words = ["not finite", "moves by", "has gone wrong", "smoothing length", "long on axis"];
            assert!(words.iter().any(|word| said.contains(word)), "{}: {said}", field.name);
        }
    }
}

/// Whatever the field, the scheme and the precision: by the time step, by the drift, or by the neighbour search, with a sentence.
#[test]
fn a_run_that_is_not_finite_stops() {
    for dissipation in [Dissipation::Av, Dissipation::AvB, Dissipation::AvSlrB2F, Dissipation::AvSwSlr] {
        for conduction in [0.0, Viscosity::CONDUCTION] {
            let viscosity = Viscosity { conduction, ..Viscosity::of(dissipation) };
            let bad = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
            stops::<f64, 1>(Physics { viscosity, ..Sod::standard(1).physics() }, &bad);
            stops::<f32, 2>(Physics { viscosity, ..Sod::standard(2).physics() }, &bad[..1]);
        }
    }
    stops::<f64, 3>(Sod::standard(3).physics(), &[f64::NAN]);
}

/// What stops must stop for its bad value: with a good one in its place the same run goes on.
#[test]
fn a_run_that_is_finite_goes_on() {
    let make = |set: &ParticleSet<1>, _: &[Field]| PlainEngine::<f64, 1>::new(set);
    let error = stopped_by(make, Sod::standard(1).physics(), fields::INTERNAL_ENERGY, 1.0).unwrap_err().to_string();
    assert!(error.contains("did not stop the run"), "{error}");
}
