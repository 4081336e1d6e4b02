//! What is asked of the reference in the wrong order is refused in a sentence.

use etalon_kernels_gen::Component;
use etalon_reference::conformance::sets::{Difficulty, set};
use etalon_reference::engine::{Engine, PlainEngine};
use etalon_reference::fields;
use etalon_reference::passes::VolumeElements;
use etalon_reference::scenes::sod::Sod;

#[test]
fn every_misuse_is_told_in_a_sentence() {
    let physics = Sod::standard(2).physics();
    let set = set::<2>(Difficulty::None, 20, &physics, 1).unwrap();
    let mut engine = PlainEngine::<f64, 2>::new(&set);
    let early = |engine: &mut PlainEngine<f64, 2>| engine.run_pass(&VolumeElements(physics)).unwrap_err().to_string();
    assert!(early(&mut engine).contains("before neighbours were found"));
    engine.find_neighbours(physics.kernel.support()).unwrap();
    let message = engine.read_scalar(fields::DENSITY).unwrap_err().to_string();
    assert!(message.contains("density is read before anything wrote it"), "{message}");
    let message = engine.write(Component { field: fields::MASS, index: 0 }, &[1.0]).unwrap_err().to_string();
    assert!(message.contains("mass has 1 values for 400 particles"), "{message}");
    engine.forget_neighbours();
    assert!(early(&mut engine).contains("before neighbours were found"));
    let message = engine.find_neighbours(50.0).unwrap_err().to_string();
    assert!(message.contains("less than the support's diameter"), "{message}");
}
