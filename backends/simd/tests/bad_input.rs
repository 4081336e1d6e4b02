//! A run in lanes in which something is not a number stops, as the scalar reference does.

use etalon_kernels_gen::Field;
use etalon_kernels_gen::lanes::available_levels;
use etalon_reference::conformance::poison::{POISONED, stopped_by};
use etalon_reference::particles::ParticleSet;
use etalon_reference::scenes::sod::Sod;
use etalon_simd::{LaneEngine, Number, Options};

fn stops<T: Number, const D: usize>() {
    let physics = Sod::standard(D).physics();
    for level in available_levels() {
        let make = |set: &ParticleSet<D>, fields: &[Field]| LaneEngine::<T, D>::new(set, fields, Options { level });
        for field in POISONED {
            for bad in [f64::NAN, f64::INFINITY] {
                let said = stopped_by(make, physics, field, bad).unwrap_or_else(|error| panic!("{error} on {level:?}"));
                assert!(!said.is_empty(), "{}", field.name);
            }
        }
    }
}

#[test]
fn a_run_in_lanes_that_is_not_finite_stops() {
    stops::<f32, 1>();
    stops::<f64, 2>();
    stops::<f32, 3>();
}
