//! What is asked of every scene there is.

use crate::support::particles;
use etalon_kernels_gen::Field;
use etalon_reference::particles::ParticleSet;
use etalon_reference::scenes::{Course, Definition, Name, Problem, ReadChoices, Scene, SceneError, State};
use std::collections::HashSet;

/// Reads choices from JSON.
struct Json(String);

impl ReadChoices for Json {
    type Error = serde_json::Error;
    fn read<P: Definition>(&self) -> Result<P, serde_json::Error> {
        serde_json::from_str(&self.0)
    }
}

fn written(problem: &Problem) -> String {
    let mut text = Vec::new();
    problem.choices(&mut serde_json::Serializer::new(&mut text)).unwrap();
    String::from_utf8(text).unwrap()
}

#[test]
fn choices_are_read_as_they_are_written_and_others_are_refused() {
    for &name in Name::ALL {
        for &dimension in name.dimensions() {
            let problem = name.standard(dimension).unwrap();
            let mut read = Problem::read(name, Json(written(&problem))).unwrap();
            // The method is not the problem's own.
            *read.method_mut() = *problem.method();
            assert_eq!(read, problem, "{name}");
        }
        let error = Problem::read(name, Json(r#"{"colour": 3}"#.into())).unwrap_err().to_string();
        assert!(error.contains("unknown field `colour`"), "{name}: {error}");
        assert_eq!(Problem::read(name, Json("{}".into())).unwrap().name(), name);
    }
}

/// The state before anything was summed, with the density of even gas.
fn state<const D: usize>(set: &ParticleSet<D>, further: &[Field]) -> State {
    let all = set.particles();
    let column = |of: &dyn Fn(usize) -> f64| (0..all.len()).map(of).collect::<Vec<f64>>();
    State {
        time: 0.0,
        position: (0..D).map(|axis| column(&|i| all[i].position[axis])).collect(),
        velocity: (0..D).map(|axis| column(&|i| all[i].velocity[axis])).collect(),
        density: column(&|_| 1.0),
        pressure: column(&|_| 1.0),
        // No scene's entropy is to depend on a start without energy.
        internal_energy: column(&|i| all[i].internal_energy.max(1e-12)),
        smoothing_length: column(&|i| all[i].smoothing_length),
        mass: column(&|i| all[i].mass),
        mobility: column(&|i| if all[i].mobile { 1.0 } else { 0.0 }),
        species: column(&|i| set.species(i)),
        further: further.iter().map(|field| (*field, column(&|_| 1.0))).collect(),
    }
}

fn stands<const D: usize>(name: Name) {
    let mut problem = name.standard(D).unwrap();
    // As few as it takes: what is asked here does not depend on how many there are.
    problem.method_mut().particles = 1;
    if let Err(SceneError::TooFew { enough, .. }) = problem.scene::<D>().check() {
        problem.method_mut().particles = enough;
    }
    // A deposit as wide as its particles, a step as long as they are apart: what else depends on the number stands at the standard one.
    if problem.scene::<D>().check().is_err() {
        problem = name.standard(D).unwrap();
    }
    let scene: &dyn Scene<D> = problem.scene();
    let set = particles(scene);
    // Gas and dust may be in one place: drag is zero there, and nothing else acts between them.
    let place = |i: usize| (set.species(i) as u8, set.particles()[i].position.map(f64::to_bits));
    let places: HashSet<(u8, [u64; D])> = (0..set.len()).map(place).collect();
    assert_eq!(places.len(), set.len(), "{name} in {D}-D: particles coincide");
    assert!(set.particles().iter().any(|p| p.mobile));
    let (low, high) = scene.shown();
    assert!(low < high && scene.physics().gamma_minus_one > 0.0);
    let quantities = scene.quantities();
    let named = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
    assert!(quantities.iter().all(|q| q.name.chars().all(named) && !q.name.is_empty() && !q.label.is_empty()));
    let names: HashSet<_> = quantities.iter().map(|q| q.name).collect();
    assert_eq!(names.len(), quantities.len(), "{name}: two quantities of one name");
    let state = state(&set, scene.further_fields());
    for values in [scene.observe(&state).unwrap(), scene.observe_since(&state, &state).unwrap()] {
        assert_eq!(values.len(), quantities.len(), "{name}: one value for each quantity");
        assert!(values.iter().all(|value| value.is_finite()), "{name}: {values:?}");
    }
    let at_end = scene.quantities_at_end();
    assert!(at_end.iter().all(|q| q.name.chars().all(named) && !q.name.is_empty() && !q.label.is_empty()));
    assert!(at_end.iter().all(|q| !names.contains(q.name)), "{name}: a quantity twice");
    let end = scene.at_end(&Course::to(&state)).unwrap();
    assert_eq!(end.values.len(), at_end.len(), "{name}: one value or reason for each quantity of the end");
    let told =
        |value: &Result<f64, String>| value.as_ref().map_or_else(|why| why.len() > 20, |value| value.is_finite());
    assert!(end.values.iter().all(told), "{name}: {:?}", end.values);
    let description = scene.description();
    assert!(!description.start.is_empty() && !description.boundaries.is_empty());
}

#[test]
fn every_scene_starts_and_is_watched_in_all_its_dimensions() {
    for &name in Name::ALL {
        for &dimension in name.dimensions() {
            match dimension {
                1 => stands::<1>(name),
                2 => stands::<2>(name),
                _ => stands::<3>(name),
            }
        }
    }
}
