//! What is measured at a run's end: on states whose answer is known.

use crate::support::{near, particles, states};
use etalon_kernels_gen::Field;
use etalon_reference::diagnostics::sign_reversal::reversed_shares;
use etalon_reference::engine::PlainEngine;
use etalon_reference::equations::equation_of_state::sound_speed;
use etalon_reference::fields::GRAD_H;
use etalon_reference::scenes::turbulence::{GAMMA_MINUS_ONE, INTERNAL_ENERGY, Turbulence};
use etalon_reference::scenes::{AtEnd, Course, Definition, Name, Scene, State, membrane::Membrane, sod::Sod};
use etalon_reference::schemes::Dissipation;
use etalon_reference::simulation::Simulation;
use std::f64::consts::TAU;

/// Gas of density one at these places, axis by axis, that moves like this.
fn gas(position: Vec<Vec<f64>>, velocity: Vec<Vec<f64>>, energy: f64) -> State {
    let n = position[0].len();
    State {
        time: 1.0,
        density: vec![1.0; n],
        pressure: vec![1.0; n],
        internal_energy: vec![energy; n],
        smoothing_length: vec![1.5 / n as f64; n],
        mass: vec![1.0 / n as f64; n],
        mobility: vec![1.0; n],
        species: Vec::new(),
        further: Vec::new(),
        position,
        velocity,
    }
}

/// Turbulence on a line: waves of the energy `E(k)`, each with a phase of its own, at as many places as its grid has.
fn waves(across: usize, energy: impl Fn(f64) -> f64) -> State {
    let x: Vec<f64> = (0..across).map(|i| (i as f64 + 0.5) / across as f64).collect();
    let wave = |x: f64, k: usize| {
        let k = k as f64;
        // A cosine of amplitude A has A^2 / 4 for each mass.
        2.0 * energy(k).sqrt() * (TAU * k * x + 2.4 * k * k).cos()
    };
    let velocity = x.iter().map(|&x| (1..across / 2).map(|k| wave(x, k)).sum()).collect();
    gas(vec![x], vec![velocity], INTERNAL_ENERGY)
}

fn end_of<const D: usize>(scene: &dyn Scene<D>, state: &State) -> AtEnd {
    scene.at_end(&Course::to(state)).unwrap()
}

/// The value of a quantity of the end, or why there is none.
fn value<const D: usize>(scene: &dyn Scene<D>, state: &State, name: &str) -> Result<f64, String> {
    let at = scene.quantities_at_end().iter().position(|q| q.name == name).unwrap_or_else(|| panic!("no {name}"));
    end_of(scene, state).values[at].clone()
}

#[test]
fn a_bottleneck_is_where_it_was_put() {
    let line: &dyn Scene<1> = &Turbulence::standard(1);
    // In logarithms a parabola, which three points tell exactly.
    let peak = 13.3_f64;
    let state = waves(64, |k| k.powf(-5.0 / 3.0) * 1e-4 * (-(k / peak).ln().powi(2)).exp());
    // Energies are good to some 1e-14, the second difference of their logarithms is about 0.01.
    near("k_max", value(line, &state, "k_max").unwrap(), peak, 1e-10);
}

#[test]
fn a_spectrum_without_a_bottleneck_says_so() {
    let line: &dyn Scene<1> = &Turbulence::standard(1);
    for (power, end) in [(-1.2, "k = 31"), (-2.5, "k = 4")] {
        let why = value(line, &waves(64, |k| k.powf(power)), "k_max").unwrap_err();
        assert!(why.contains(end) && why.contains("take more particles"), "{why}");
    }
    let rest = gas(vec![(0..64).map(|i| (f64::from(i) + 0.5) / 64.0).collect()], vec![vec![0.0; 64]], INTERNAL_ENERGY);
    for name in ["k_max", "spectrum_slope", "mach_slope"] {
        value(line, &rest, name).expect_err("gas at rest has none");
    }
    assert!(end_of(line, &rest).curves.is_empty(), "nothing to draw of gas at rest");
    // What rounding leaves in shells that nothing has reached is no spectrum.
    let calm = waves(64, |k| if k < 4.0 { 1.0 } else { 1e-30 });
    for name in ["k_max", "spectrum_slope"] {
        let why = value(line, &calm, name).unwrap_err();
        assert!(why.contains("k = 4") && why.contains("run for longer"), "{why}");
    }
    let drawn = end_of(line, &calm).curves.into_iter().find(|curve| curve.name == "compensated_spectrum").unwrap();
    assert_eq!(drawn.points.len(), 3);
    let few = waves(20, |k| k.powf(-2.0));
    let why = value(line, &few, "spectrum_slope").unwrap_err();
    assert!(why.contains("take 21 particles a side"), "{why}");
}

#[test]
fn the_slope_of_a_spectrum_is_its_power() {
    let line: &dyn Scene<1> = &Turbulence::standard(1);
    for power in [-5.0 / 3.0, -2.0] {
        let state = waves(64, |k| 1e-3 * k.powf(power));
        near("slope", value(line, &state, "spectrum_slope").unwrap(), power, 1e-12);
        let end = end_of(line, &state);
        let curve = end.curves.iter().find(|curve| curve.name == "compensated_spectrum").unwrap();
        assert_eq!(curve.points.len(), 31, "all waves but Nyquist's");
        for (k, y) in &curve.points {
            near("k^(5/3) E", *y, 1e-3 * k.powf(power + 5.0 / 3.0), 1e-11);
        }
    }
}

/// On a line `S_2(l) = 4 sum E(k) (1 - cos 2 pi k l)`, since each wave's mean over the line is known.
#[test]
fn mach_numbers_of_lengths_are_those_of_the_waves() {
    let line: &dyn Scene<1> = &Turbulence::standard(1);
    let (across, energy) = (256, |k: f64| 1e-3 * k.powf(-5.0 / 3.0));
    let state = waves(across, energy);
    let c = sound_speed(GAMMA_MINUS_ONE, INTERNAL_ENERGY);
    let due = |l: f64| {
        let terms = (1..across / 2).map(|k| k as f64).map(|k| energy(k) * (1.0 - (TAU * k * l).cos()));
        (2.0 * terms.sum::<f64>()).sqrt() / c
    };
    let end = end_of(line, &state);
    let curve = end.curves.iter().find(|curve| curve.name == "mach_by_length").unwrap();
    let spacing = 1.0 / across as f64;
    for &(l, mach) in &curve.points {
        let steps = l / spacing;
        // An interval that holds one distance is that distance; those that hold more are means.
        let single = steps < 5.5;
        near(&format!("M at {steps} spacings"), mach, due(l), if single { 1e-9 } else { 0.02 });
    }
    assert!(curve.points.len() > 20, "{:?}", curve.points);
    // The slope over a tenth to a quarter, by the mean of that over the whole.
    let slope = (due(0.25) / due(0.1)).ln() / 2.5_f64.ln();
    let found = value(line, &state, "mach_slope").unwrap();
    println!("slope {found}, between the ends {slope}");
    assert!((found - slope).abs() < 0.1 && (0.1..0.6).contains(&found), "{found} and {slope}");
}

#[test]
fn densities_are_distributed_as_they_were_made() {
    // Equal masses at the middles of equal shares of a normal distribution: cumulative by the logistic's inverse is enough of one.
    let (n, sigma) = (4000, 0.1);
    let mut state = gas(vec![(0..n).map(|i| f64::from(i) / f64::from(n)).collect()], vec![vec![0.0; n as usize]], 1.0);
    state.density =
        (0..n).map(|i| (f64::from(i) + 0.5) / f64::from(n)).map(|p| (sigma * (p / (1.0 - p)).ln()).exp()).collect();
    let line: &dyn Scene<1> = &Turbulence::standard(1);
    let end = end_of(line, &state);
    let mean = |name: &str| {
        let curve = end.curves.iter().find(|curve| curve.name == name).unwrap();
        let width = curve.points.windows(2).map(|pair| pair[1].0 - pair[0].0).fold(f64::INFINITY, f64::min);
        let total: f64 = curve.points.iter().map(|(_, p)| p * width).sum();
        // All but what lies beyond five standard deviations, of the logistic 1.1e-4 at either end.
        assert!((total - 1.0).abs() < 5e-4, "{name}: {total}");
        assert!(curve.points.iter().all(|(_, p)| *p > 0.0));
        curve.points.iter().map(|(s, p)| s * p * width).sum::<f64>() / total
    };
    // The weight exp(-s) moves a distribution's mean by its variance, in first order.
    let variance = (sigma * std::f64::consts::PI).powi(2) / 3.0;
    near("shift of the mean", mean("density_pdf_mass") - mean("density_pdf_volume"), variance, 0.03);
}

#[test]
fn the_grad_h_factor_has_a_mean_and_a_scatter() {
    let line: &dyn Scene<1> = &Turbulence::standard(1);
    let mut state = waves(4, |_| 1.0);
    let missing = line.observe(&state).unwrap_err().to_string();
    assert!(missing.contains("read_for"), "{missing}");
    state.further = vec![(GRAD_H, vec![0.75, 1.25, 0.75, 1.25])];
    let values = line.observe(&state).unwrap();
    let of = |name: &str| values[line.quantities().iter().position(|q| q.name == name).unwrap()];
    assert_eq!((of("grad_h_mean"), of("grad_h_scatter")), (1.0, 0.25));
}

/// A scene that does not ask for it gets no column more.
#[test]
fn further_fields_are_read_where_they_are_asked_for() {
    fn read<const D: usize>(name: Name) -> Vec<Field> {
        let mut problem = name.standard(D).unwrap();
        problem.method_mut().particles = 60;
        let state = states(problem.scene::<D>(), &[0.0]).remove(0);
        assert!(state.further.iter().all(|(_, column)| column.len() == state.len()));
        state.further.into_iter().map(|(field, _)| field).collect()
    }
    assert_eq!(read::<1>(Name::Sod), []);
    assert_eq!(read::<1>(Name::Turbulence), [GRAD_H]);
}

/// What is swept over once more is what the run itself had.
#[test]
fn reversals_are_those_of_the_run() {
    let mut problem = Name::KelvinHelmholtz.standard(2).unwrap();
    problem.method_mut().particles = 900;
    let scene: &dyn Scene<2> = problem.scene();
    let set = particles(scene);
    let mut run = Simulation::new(PlainEngine::<f64, 2>::new(&set), scene.physics()).unwrap();
    run.run(0.1, |_| {}).unwrap();
    let state = State::read_for(scene, run.engine(), set.domain(), 0.1).unwrap();
    let due = reversed_shares(run.engine(), scene.physics()).unwrap();
    assert!(due.of_all > 0.0, "a run that turns no sign shows nothing");
    // Places are rounded to 2^-32 of the box. Of some 1e4 pairs two may lie so near to no approach that it tells.
    for (name, due) in [("sign_reversals", due.of_all), ("sign_reversals_approaching", due.of_approaching)] {
        let found = value(scene, &state, name).unwrap();
        println!("{name}: {found}, of the run {due}");
        assert!((found - due).abs() < 2e-4, "{name}: {found} where {due} is due");
    }
    problem.method_mut().viscosity.dissipation = Dissipation::Av;
    assert!(problem.scene::<2>().quantities_at_end().is_empty(), "nothing is reconstructed");
}

/// Particles of a tube with the exact solution's values.
fn tube(scene: &dyn Scene<1>, time: f64) -> State {
    let n = 1000;
    let x: Vec<f64> = (0..n).map(|i| (f64::from(i) + 0.5) / f64::from(n)).collect();
    let exact = scene.solution(time).unwrap().unwrap();
    let column = |field: usize| x.iter().map(|&x| exact.at(x)[field]).collect::<Vec<f64>>();
    let (density, velocity, energy) = (column(0), column(1), column(3));
    State { time, density, internal_energy: energy, ..gas(vec![x.clone()], vec![velocity], 1.0) }
}

#[test]
fn behind_waves_the_exact_solution_is_even_and_what_is_added_is_found() {
    let sod = Sod::standard(1);
    let scene: &dyn Scene<1> = &sod;
    let names: Vec<&str> = scene.quantities_at_end().iter().map(|q| q.name).collect();
    assert_eq!(names, ["post_shock_noise", "post_shock_entropy", "rarefaction_entropy"]);
    let mut state = tube(scene, 0.2);
    for name in names {
        // Ratios of equal numbers; a mean of equal numbers is rounded.
        assert!(value(scene, &state, name).unwrap().abs() < 1e-14, "{name}");
    }
    state.velocity[0].iter_mut().enumerate().for_each(|(i, v)| *v += if i % 2 == 0 { 0.01 } else { -0.01 });
    state.internal_energy.iter_mut().for_each(|u| *u *= 0.02_f64.exp());
    let star = sod.exact().unwrap().star().unwrap();
    let c = (sod.gamma * star.pressure / star.density_right).sqrt();
    // An odd number of particles has a mean beside zero.
    near("noise", value(scene, &state, "post_shock_noise").unwrap(), 0.01 / c, 1e-3);
    near("behind the shock", value(scene, &state, "post_shock_entropy").unwrap(), 0.02, 1e-12);
    near("behind the fan", value(scene, &state, "rarefaction_entropy").unwrap(), 0.02, 1e-12);
    // Only what lies behind the waves counts.
    let away = |x: f64| (x - 0.568).abs() > 0.1 && (x - 0.769).abs() > 0.1;
    let mut disturbed = tube(scene, 0.2);
    for i in (0..disturbed.len()).filter(|&i| away(disturbed.position[0][i])) {
        (disturbed.velocity[0][i], disturbed.internal_energy[i]) = (7.0, 7.0);
    }
    assert!(value(scene, &disturbed, "rarefaction_entropy").unwrap().abs() < 1e-14);
    let early = value(scene, &tube(scene, 1e-4), "post_shock_noise").unwrap_err();
    assert!(early.contains("fewer than two particles"), "{early}");
    let apart = Name::NearVacuum.standard(1).unwrap();
    assert!(apart.scene::<1>().quantities_at_end().iter().all(|q| q.name == "rarefaction_entropy"));
}

/// Rings of eight particles in pairs, of which two share a shell of 0.044, with these velocities away and around by radius and number.
fn rings(velocity: impl Fn(f64, usize) -> [f64; 2]) -> State {
    let (mut position, mut speed) = (vec![Vec::new(), Vec::new()], vec![Vec::new(), Vec::new()]);
    for radius in (0..16).map(|k| 0.05 + 0.02 * f64::from(k / 2) + 1e-4 * f64::from(k % 2)) {
        for i in 0..8 {
            let (sine, cosine) = (TAU * i as f64 / 8.0 + 0.1).sin_cos();
            let [away, around] = velocity(radius, i);
            position[0].push(0.5 + radius * cosine);
            position[1].push(0.5 + radius * sine);
            speed[0].push(away * cosine - around * sine);
            speed[1].push(away * sine + around * cosine);
        }
    }
    gas(position, speed, 1.5)
}

#[test]
fn a_round_wave_is_round_and_what_is_not_is_found() {
    let membrane = Membrane::standard(2);
    let scene: &dyn Scene<2> = &membrane;
    let of = |state: &State, name: &str| {
        let at = scene.quantities().iter().position(|q| q.name == name).unwrap();
        scene.observe(state).unwrap()[at] * membrane.velocity
    };
    let round = rings(|radius, _| [0.3 - radius, 0.0]);
    for name in ["azimuthal_velocity", "radial_scatter"] {
        // Places and their radius are rounded in the last place of one.
        assert!(of(&round, name) < 1e-13, "{name}: {}", of(&round, name));
    }
    let turning = rings(|radius, _| [0.3 - radius, 0.07]);
    near("around", of(&turning, "azimuthal_velocity"), 0.07, 1e-12);
    assert!(of(&turning, "radial_scatter") < 1e-13);
    // Thirty-two a shell, of which a line takes two freedoms; each ring has as many of either sign, so that it takes nothing else.
    let lobed = rings(|radius, i| [0.3 - radius + if i % 2 == 0 { 0.02 } else { -0.02 }, 0.0]);
    near("scatter", of(&lobed, "radial_scatter"), 0.02 * (32.0_f64 / 30.0).sqrt(), 1e-9);
    assert_eq!(of(&lobed, "entropy_scatter"), 0.0);
}

#[test]
fn entropy_scatters_about_its_mean() {
    let membrane = Membrane::standard(2);
    let scene: &dyn Scene<2> = &membrane;
    let start = rings(|_, _| [0.0; 2]);
    let mut now = start.clone();
    now.internal_energy.iter_mut().enumerate().for_each(|(i, u)| *u *= if i % 2 == 0 { 0.03_f64 } else { 0.01 }.exp());
    let values = scene.observe_since(&start, &now).unwrap();
    let of = |name: &str| values[scene.quantities().iter().position(|q| q.name == name).unwrap()];
    near("gain", of("entropy_gain"), 0.02, 1e-12);
    near("scatter", of("entropy_scatter"), 0.01, 1e-12);
}

#[test]
fn a_cloud_that_shrinks_evenly_has_that_rate() {
    let problem = Name::WindCloud.standard(3).unwrap();
    let scene: &dyn Scene<3> = problem.scene();
    let state = gas(vec![vec![0.5]; 3], vec![vec![0.0]; 3], 1.0);
    let course = |until: i32| {
        let time: Vec<f64> = (0..=until).map(|k| 0.1 * f64::from(k)).collect();
        let share = time.iter().map(|t| 1.0 - 0.07 * t).collect();
        let values = vec![share, vec![0.0; time.len()]];
        scene.at_end(&Course { end: &state, time: &time, values: &values }).unwrap().values.remove(0)
    };
    near("rate", course(58).unwrap(), -0.07, 1e-12);
    assert!(course(50).unwrap_err().contains("run until then"));
}
