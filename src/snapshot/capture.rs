//! The particles of an engine, as a snapshot.

use super::table::{AXES, Column, Frame, Snapshot};
use etalon_kernels_gen::{Field, components};
use etalon_reference::domain::Domain;
use etalon_reference::engine::{Engine, EngineError};

/// Positions and these fields of all particles, in their original order and by their original numbers.
///
/// # Errors
/// What the engine gives, for example for a field that nothing wrote yet; [`EngineError`] naming a number that is not finite.
pub fn capture<const D: usize, E: Engine<D>>(
    engine: &mut E,
    domain: &Domain<D>,
    time: f64,
    fields: &[Field],
) -> Result<Snapshot, EngineError> {
    let mut columns = Vec::new();
    for (axis, name) in AXES.into_iter().enumerate().take(D) {
        let values = engine.coordinates(axis)?.into_iter().map(|place| domain.decode(axis, place)).collect();
        columns.push(Column::new(name, "L", values));
    }
    for component in components(fields, D) {
        columns.push(Column::new(component.name(D), component.field.unit, engine.read(component)?));
    }
    let count = engine.particle_count() as u64;
    let snapshot = Snapshot::new(D, columns).and_then(|snapshot| snapshot.with_ids((0..count).collect()));
    let snapshot = snapshot.and_then(|snapshot| snapshot.at_time(time).in_frame(Frame::from(domain)));
    snapshot.map_err(EngineError::from_display)
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_reference::conformance::sets::{Difficulty, set};
    use etalon_reference::engine::PlainEngine;
    use etalon_reference::fields;
    use etalon_reference::scenes::sod::Sod;

    #[test]
    fn an_engines_particles_are_captured_with_names_and_units() {
        let set = set::<2>(Difficulty::None, 6, &Sod::standard(2).physics(), 3).unwrap();
        let mut engine = PlainEngine::<f64, 2>::new(&set);
        let found = capture(&mut engine, set.domain(), 0.5, &[fields::VELOCITY, fields::MASS]).unwrap();
        let names: Vec<(&str, &str)> = found.columns().iter().map(|c| (c.name.as_str(), c.unit.as_str())).collect();
        let expected = [("x", "L"), ("y", "L"), ("velocity_x", "L T^-1"), ("velocity_y", "L T^-1"), ("mass", "M")];
        assert_eq!((names.as_slice(), found.len(), found.time()), (&expected[..], 36, Some(0.5)));
        // Places are kept to 2^-32 of the side, 1.
        for (x, particle) in found.column("x").unwrap().iter().zip(set.particles()) {
            assert!((x - particle.position[0]).abs() <= 0.5 / 4_294_967_296.0, "{x}");
        }
        let error = capture(&mut engine, set.domain(), 0.5, &[fields::DENSITY]).unwrap_err();
        assert!(error.to_string().contains("density is read before anything wrote it"), "{error}");
    }
}
