//! What the scenes refuse, in one sentence that says what to give instead.

use etalon_reference::scenes::DustySceneError;
use etalon_reference::scenes::dustybox::DustyBox;
use etalon_reference::scenes::dustyshock::DustyShock;
use etalon_reference::scenes::dustywave::DustyWave;
use etalon_reference::schemes::Drag;

#[test]
fn impossible_choices_are_refused() {
    let box_error = |scene: DustyBox| scene.particles::<1>().unwrap_err().to_string();
    let standard = DustyBox::standard(1);
    for (scene, expected) in [
        (DustyBox { gas_density: -1.0, ..standard }, "gas density is -1"),
        (DustyBox { dust_velocity: f64::NAN, ..standard }, "dust velocity is NaN"),
        (DustyBox { drag: Drag::of(-3.0), ..standard }, "drag coefficient is -3"),
        (DustyBox { neighbours: 1e9, ..standard }, "1-D needs between 4 and 40"),
        (DustyBox { neighbours: f64::NAN, ..standard }, "1-D needs between 4 and 40"),
        (DustyBox { gamma: 1.0, ..standard }, "internal_energy"),
        (DustyBox { across: 0, ..standard }, "give 7 or more"),
        (DustyBox { shift: f64::INFINITY, ..standard }, "outside the box"),
    ] {
        let error = box_error(scene);
        assert!(error.contains(expected), "{error}: `{expected}` is not in it");
    }
    let wave = DustyWave { sound_speed: 0.0, ..DustyWave::standard(1) }.particles::<1>().unwrap_err().to_string();
    assert!(wave.contains("sound speed is 0"), "{wave}");
    let wave = DustyWave { amplitude: 2.0, ..DustyWave::standard(1) }.particles::<1>().unwrap_err().to_string();
    assert!(wave.contains("mass") && wave.contains("positive"), "{wave}");
    let shock = DustyShock { dust_to_gas: 0.0, ..DustyShock::standard(1) }.particles::<1>().unwrap_err().to_string();
    assert!(shock.contains("dust density is 0"), "{shock}");
    let shock = DustyShock { gamma: 0.5, ..DustyShock::standard(1) }.particles::<1>().unwrap_err().to_string();
    assert!(shock.contains("0.5"), "{shock}");
}

/// The number a refusal names is taken, and one less is not.
#[test]
fn too_few_particles_are_told_how_many_are_enough() {
    let enough = |error: DustySceneError| match error {
        DustySceneError::TooFew { given, enough } => {
            assert!(enough > given);
            enough
        }
        other => panic!("{other}"),
    };
    let boxes = |across: usize| DustyBox { across, ..DustyBox::standard(3) }.particles::<3>();
    let across = enough(boxes(1).unwrap_err());
    assert!(boxes(across).is_ok() && boxes(across - 1).is_err());
    let waves = |rows: usize| DustyWave { particles: 16, rows, ..DustyWave::standard(2) }.particles::<2>();
    let rows = enough(waves(0).unwrap_err());
    assert!(waves(rows).is_ok() && waves(rows - 1).is_err());
    let shocks = |rows: usize| DustyShock { particles: 32, rows, ..DustyShock::standard(2) }.particles::<2>();
    let rows = enough(shocks(0).unwrap_err());
    assert!(shocks(rows).is_ok() && shocks(rows - 1).is_err());
    let line = |particles: usize| DustyShock { particles, ..DustyShock::standard(1) }.particles::<1>();
    let particles = enough(line(0).unwrap_err());
    assert!(line(particles).is_ok() && line(particles - 1).is_err());
}
