//! Every scene at a small size: what it measures is the same on any number of threads and as it was recorded; and the three that the
//! engines are held together on through time.

#[path = "command/place.rs"]
mod place;

use etalon_kernels_gen::components;
use etalon_reference::pipeline::Pipeline;
use etalon_reference::scenes::{Course, Name, Scene, SceneError, State};
use etalon_reference::simulation::Simulation;
use etalon_reference::{domain::Domain, fields};
use etalon_simd::{LaneEngine, Options};
use place::{Place, code, json, stderr};
use serde_json::Value;

/// Steps that a scene is followed for.
const STEPS: usize = 4;

/// A problem in its cheapest dimension with as few particles as it takes.
fn smallest(name: Name) -> (etalon_reference::scenes::Problem, usize) {
    let dimension = name.dimensions().iter().copied().min().unwrap();
    let mut problem = name.standard(dimension).unwrap();
    problem.method_mut().particles = 1;
    let enough = match dimension {
        1 => problem.scene::<1>().check(),
        2 => problem.scene::<2>().check(),
        _ => problem.scene::<3>().check(),
    };
    // Without walls around, the least that says anything.
    let floor = [60, 400, 2000][dimension - 1];
    problem.method_mut().particles = match enough {
        Err(SceneError::TooFew { enough, .. }) => enough.max(floor),
        _ => floor,
    };
    let stands = match dimension {
        1 => problem.scene::<1>().check(),
        2 => problem.scene::<2>().check(),
        _ => problem.scene::<3>().check(),
    };
    // What else depends on how many there are stands at the usual number.
    if stands.is_err() {
        problem = name.standard(dimension).unwrap();
    }
    (problem, dimension)
}

/// All numbers of the state after some steps, and what the scene measures then.
fn followed<const D: usize>(scene: &dyn Scene<D>, threads: usize) -> (Vec<u64>, Vec<String>) {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| {
        let set = scene.particles(&mut |_| unreachable!("the usual start is a lattice")).unwrap();
        let physics = scene.physics();
        let fields = Pipeline::of_scene::<D>(&physics).fields::<D>();
        let engine = LaneEngine::<f64, D>::new(&set, &fields, Options::default());
        let mut simulation = match scene.forcing().unwrap() {
            Some(force) => Simulation::with_forcing(engine, physics, force).unwrap(),
            None => Simulation::new(engine, physics).unwrap(),
        };
        let domain: Domain<D> = *set.domain();
        let start = State::read_for(scene, simulation.engine(), &domain, 0.0).unwrap();
        for _ in 0..STEPS {
            simulation.step(f64::INFINITY).unwrap();
        }
        let time = simulation.time();
        let state = State::read_for(scene, simulation.engine(), &domain, time).unwrap();
        let columns = state.position.iter().chain(&state.velocity).chain([&state.density, &state.internal_energy]);
        let bits = columns.flatten().map(|value| value.to_bits()).collect();
        let values = scene.observe_since(&start, &state).unwrap();
        let names = scene.quantities().into_iter().map(|quantity| quantity.name);
        let mut measured =
            vec![("time", time), ("kinetic_energy_of_all", kinetic(&state)), ("heat_of_all", heat(&state))];
        measured.extend(names.zip(values));
        let end = scene.at_end(&Course::to(&state)).unwrap();
        let at_end = scene.quantities_at_end().into_iter().map(|quantity| quantity.name).zip(end.values);
        let mut lines: Vec<String> =
            measured.into_iter().map(|(name, value)| format!("{name} = {}", shown(value))).collect();
        // After a few steps much of it is rounding, or not to be had; what it is, tests of known answers hold.
        lines.extend(at_end.map(|(name, value)| {
            assert!(value.map_or_else(|why| !why.is_empty(), f64::is_finite), "{name}");
            format!("{name} at the end")
        }));
        lines.extend(end.curves.iter().map(|curve| format!("curve {}", curve.name)));
        (bits, lines)
    })
}

/// Six digits, and nothing of what is rounding: the host's logarithms and sines, in some measurements, may differ in the last digits.
fn shown(value: f64) -> String {
    if value != 0.0 && value.abs() < 1e-10 { "below 1e-10".into() } else { format!("{value:.5e}") }
}

fn kinetic(state: &State) -> f64 {
    let squared = |i: usize| state.speed(i).iter().map(|v| v * v).sum::<f64>();
    (0..state.len()).map(|i| 0.5 * state.mass[i] * squared(i)).sum()
}

fn heat(state: &State) -> f64 {
    (0..state.len()).map(|i| state.mass[i] * state.internal_energy[i]).sum()
}

/// Would notice a change of any scene's start, physics or measurements, and a sum that depends on who adds it.
#[test]
fn every_scene_measures_what_it_did() {
    let mut lines = Vec::new();
    for &name in Name::ALL {
        let (problem, dimension) = smallest(name);
        let of = |threads| match dimension {
            1 => followed(problem.scene::<1>(), threads),
            2 => followed(problem.scene::<2>(), threads),
            _ => followed(problem.scene::<3>(), threads),
        };
        let ((bits, measured), (again, _)) = (of(1), of(3));
        assert!(bits == again, "{name}: the particles depend on the number of threads");
        lines.push(format!("{name}, {dimension}-D, {} particles asked for, {STEPS} steps", problem.method().particles));
        lines.extend(measured.into_iter().map(|line| format!("  {line}")));
    }
    insta::assert_snapshot!(lines.join("\n"));
}

/// Every scheme on the tube, the vortex and the membrane, on every engine there is, against the reference through time, field by field. The
/// tolerance is what the flow makes of roundings, measured on the reference itself.
fn follows_the_reference(scene: &str, more: &[&str], schemes: &[&str]) {
    let place = Place::new(scene);
    for scheme in schemes {
        let arguments = [&["run", scene, "--scheme", scheme, "--json"], more].concat();
        let output = place.etalon(&arguments);
        assert_eq!(code(&output), Some(0), "{arguments:?}: {}", stderr(&output));
        let report = json(std::str::from_utf8(&output.stdout).unwrap());
        let mut compared = 0;
        for run in report["runs"].as_array().unwrap() {
            let differences = run["outcome"]["ran"]["arithmetic_difference"].as_array();
            for difference in differences.into_iter().flatten() {
                compared += 1;
                assert_eq!(difference["pass"], Value::Bool(true), "{scene} {scheme}: {difference}");
            }
        }
        // Two engines at least, four fields each.
        assert!(compared >= 8, "{scene} {scheme}: {compared} comparisons");
    }
}

const SCHEMES: [&str; 8] = ["AV", "AVSW", "AVSLR", "AVSWSLR", "AVSLRB", "AVSLRB2", "AVSLRB2F", "AVB"];

#[test]
fn all_engines_follow_the_reference_through_the_tube() {
    follows_the_reference("sod", &["--dim", "1", "--n", "100"], &SCHEMES);
}

#[test]
fn all_engines_follow_the_reference_around_the_vortex() {
    follows_the_reference("gresho-chan", &["--dim", "2", "--n", "600", "--end-time", "0.1"], &SCHEMES);
}

/// The paper's problem on four times its scale of length and time, with the six variants of GS25 Table 8.
#[test]
fn all_engines_follow_the_reference_around_the_membrane() {
    let large = ["--set", "radius=0.14", "--set", "period=0.2", "--set", "compared_with=linear", "--n", "600"];
    let schemes = ["AV", "AVSW", "AVSLRB2", "AVSWSLR", "AVSLRB*2", "AVSLRB*2F"];
    follows_the_reference("membrane", &[&large[..], &["--end-time", "0.1"]].concat(), &schemes);
}

/// A scene that has no walls, no gravity, no switches and a dimension less carries nothing of them.
#[test]
fn a_scene_carries_only_what_it_needs() {
    fn numbers<const D: usize>(name: Name, change: impl Fn(&mut etalon_reference::scenes::Method)) -> (usize, usize) {
        let mut problem = name.standard(D).unwrap();
        change(problem.method_mut());
        let pipeline = Pipeline::of_scene::<D>(&problem.scene::<D>().physics());
        (components(&pipeline.fields::<D>(), D).len(), pipeline.passes().len())
    }
    let usual = |_: &mut etalon_reference::scenes::Method| {};
    let scheme = |dissipation| {
        move |method: &mut etalon_reference::scenes::Method| {
            method.viscosity = etalon_reference::schemes::Viscosity::of(dissipation)
        }
    };
    use etalon_reference::schemes::Dissipation::{Av, AvSlrB2, AvSw};
    let plane = numbers::<2>(Name::GreshoChan, usual);
    let thick = numbers::<3>(Name::GreshoChan, usual);
    // Per axis a number of each of velocity, acceleration, previous acceleration, displacement (4 in all), of the two symmetric matrices
    // (3 more each in 3-D), of the velocity's moments none that is kept.
    assert_eq!((thick.0 - plane.0, thick.1), (4 + 2 * 3, plane.1));
    // The plain scheme has no velocity gradient, no Balsara factor; the switch has its four.
    let [plain, usual_scheme, switched] =
        [Av, AvSlrB2, AvSw].map(|dissipation| numbers::<2>(Name::GreshoChan, scheme(dissipation)));
    assert!(plain.0 < usual_scheme.0 && usual_scheme.0 < switched.0, "{plain:?} {usual_scheme:?} {switched:?}");
    assert_eq!(switched.1, usual_scheme.1 + 1);
    let carried = |name: Name| {
        let problem = name.standard(name.dimensions()[0]).unwrap();
        let physics = match name.dimensions()[0] {
            1 => problem.scene::<1>().physics(),
            2 => problem.scene::<2>().physics(),
            _ => problem.scene::<3>().physics(),
        };
        Pipeline::of_scene::<2>(&physics).fields::<2>()
    };
    // Nobody carries a species but where there is dust.
    for name in [Name::Sod, Name::GreshoChan, Name::Noh, Name::Sedov] {
        assert!(!carried(name).contains(&fields::SPECIES), "{name}");
    }
}
