//! GS25 (9), (10): the time-dependent viscosity coefficient, its equations and its sweep.

use crate::check::{UNIT, assert_close, gamma};
use crate::cloud::Recipe;
use crate::dual::Dual;
use crate::float::Float;
use etalon_kernels_gen::{Component, Real, Symmetric, Vector};
use etalon_reference::engine::{Engine, PlainEngine};
use etalon_reference::equations::switch::*;
use etalon_reference::fields;
use etalon_reference::passes::{Decay, Physics, Switch};
use etalon_reference::pipeline::Pipeline;
use etalon_reference::scenes::sod::Sod;
use etalon_reference::schemes::{Dissipation, Viscosity};
use etalon_reference::simulation::Simulation;
use nalgebra::DMatrix;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

const USUAL: Viscosity = Viscosity::of(Dissipation::AvSw);
/// Between 1/4 and 2.
const WHOLE: Viscosity = Viscosity { alpha: 2.0, alpha_min: 0.25, ..USUAL };

#[test]
fn whole_numbers() {
    // 2^2 |(3, -4)|
    assert_eq!(convergence_indicator(Vector([3.0, -4.0]), 2.0), 20.0);
    // 2 * 3 / (3 + 2 * 4 + 0.05 * 20)
    assert_close("alpha_loc", local_coefficient(&WHOLE, 3.0, -4.0, 20.0, 2.0), 0.5, 4.0 * UNIT);
    for divergence in [0.0, -0.0, 4.0, 1e-300] {
        assert_eq!(local_coefficient(&WHOLE, 3.0, divergence, 20.0, 2.0), 0.0, "div v = {divergence}");
    }
    assert_eq!((raised_coefficient(0.5, 1.5), raised_coefficient(1.5, 0.5)), (1.5, 1.5));
    assert_eq!((decay_target(&WHOLE, 0.5), decay_target(&WHOLE, 0.125)), (0.5, 0.25));
    assert_eq!(decay_rate(6.0, 0.5), 3.0);
    assert_eq!(pair_coefficient(0.25, 0.75), 0.5);
}

/// (10) branch by branch as it is printed.
#[test]
fn rate_has_the_printed_branches() {
    let (alpha, alpha_min, tau) = (1.5, 0.25, 4.0);
    for alpha_local in [0.0, 0.125, 0.25, 0.5, 1.0] {
        let due = if alpha_local <= alpha_min { (alpha_min - alpha) / tau } else { (alpha_local - alpha) / tau };
        assert_eq!(coefficient_rate(&WHOLE, alpha, alpha_local, 1.0 / tau), due, "alpha_loc = {alpha_local}");
    }
    // Below the smallest it would rise.
    assert!(coefficient_rate(&WHOLE, 0.125, 0.0, 0.25) > 0.0);
}

#[test]
fn decay_is_exponential() {
    let mut random = Pcg64Mcg::seed_from_u64(81);
    for _ in 0..1000 {
        let mut draw = |low: f64, high: f64| low + (high - low) * random.random::<f64>();
        let (alpha, rate, dt) = (draw(0.25, 2.0), draw(0.1, 10.0), draw(0.0, 1.0));
        let local = draw(0.0, alpha);
        let target = local.max(0.25);
        let due = target + (alpha - target) * (-dt * rate).exp();
        // 16u of the exponential and 4u of y = 10 at most, times 2; a few of the sum.
        let bound = 2.0 * (16.0 + 4.0 + 4.0) * UNIT;
        assert_close("alpha", decayed_coefficient(&WHOLE, alpha, local, rate, dt), due, bound);
        // In two steps as in one.
        let half = decayed_coefficient(&WHOLE, alpha, local, rate, 0.5 * dt);
        assert_close("in two steps", decayed_coefficient(&WHOLE, half, local, rate, 0.5 * dt), due, 2.0 * bound);
        // And at the start it changes as (10) says: the derivative with respect to the time, at zero.
        let [alpha, local, rate] = [alpha, local, rate].map(Dual::lit);
        let slope = decayed_coefficient(&WHOLE, alpha, local, rate, Dual::variable(0.0)).slope;
        let due = coefficient_rate(&WHOLE, alpha, local, rate).value;
        assert_close("rate", slope, due, 60.0 * UNIT * due.abs().max(rate.value));
    }
}

/// A step of any length ends between the smallest and the largest coefficient; Euler's would not.
#[test]
fn coefficient_stays_in_its_range() {
    let mut random = Pcg64Mcg::seed_from_u64(82);
    let mut overshoots = 0;
    for _ in 0..20_000 {
        let mut draw = || random.random::<f64>();
        let viscosity = Viscosity { alpha: 0.1 + draw(), alpha_min: 0.1 * draw(), ..USUAL };
        let range = viscosity.alpha_min..=viscosity.alpha;
        let mut alpha = viscosity.alpha_min;
        for _ in 0..4 {
            let mut size = || 10_f64.powf(6.0 * draw() - 3.0);
            let [indicator, sound_speed, h, signal, dt] = std::array::from_fn(|_| size());
            let divergence = draw() - 0.7;
            let local = local_coefficient(&viscosity, indicator, divergence, sound_speed, h);
            assert!((0.0..=viscosity.alpha).contains(&local), "alpha_loc = {local}, {viscosity:?}");
            alpha = raised_coefficient(alpha, local);
            assert!(range.contains(&alpha), "alpha = {alpha} after the rise, {viscosity:?}");
            let rate = decay_rate(signal, 1.0 / h);
            let euler = alpha + dt * coefficient_rate(&viscosity, alpha, local, rate);
            overshoots += usize::from(euler < viscosity.alpha_min);
            alpha = decayed_coefficient(&viscosity, alpha, local, rate, dt);
            assert!(range.contains(&alpha), "alpha = {alpha} after decay, {viscosity:?}");
        }
    }
    assert!(overshoots > 1000, "steps longer than tau were tried: {overshoots}");
}

/// Gas that neither moves nor has a temperature does not decay: `alpha_* + (alpha - alpha_*)`, which two roundings can take out of the range.
#[test]
fn rounding_does_not_leave_the_range() {
    let at = |alpha_min: f64, largest: f64, alpha: f64, local: f64| {
        decayed_coefficient(&Viscosity { alpha: largest, alpha_min, ..USUAL }, alpha, local, 0.0, 1.0)
    };
    let rounded = |alpha: f64, target: f64| (alpha - target) + target;
    assert!(rounded(0.3, 0.03) > 0.3 && rounded(0.01, 0.1) < 0.01, "numbers that would not tell");
    assert_eq!(at(0.01, 0.3, 0.3, 0.03), 0.3);
    assert_eq!(at(0.01, 0.3, 0.01, 0.1), 0.01);
    // And what was out of it before is brought back.
    assert_eq!((at(0.25, 2.0, 0.125, 0.0), at(0.25, 2.0, 3.0, 0.0)), (0.25, 2.0));
}

/// Where the flow asks for the smallest coefficient the two branches agree; where it asks for what there is, nothing changes.
#[test]
fn branches_meet() {
    let at = |local: f64| decayed_coefficient(&WHOLE, 1.0, local, 1.0, 1.0);
    assert_eq!(at(0.25), at(0.0));
    assert_close("just above", at(0.25 + 1e-9), at(0.25), 1e-9);
    assert_eq!(at(1.0), 1.0);
    assert_eq!(decayed_coefficient(&WHOLE, 1.0, 0.0, 0.0, 1e30), 1.0, "without signals there is no decay");
    assert_close("after long", decayed_coefficient(&WHOLE, 1.0, 0.0, 1e30, 1e30), 0.25, 1e-13);
}

/// `h^2` of a small length underflows in `f32`, and so does a guard of 1e-40; the formulas must not need either.
#[test]
fn single_precision_survives_small_units() {
    // (1e-22)^2 * 1e36: the square by itself is subnormal.
    let indicator = convergence_indicator(Vector([1e36_f32, 0.0, 0.0]), 1e-22);
    assert_close("D", f64::from(indicator), 1e-8, 8.0 * f32::UNIT * 1e-8);
    assert_eq!(local_coefficient(&USUAL, 0.0_f32, -1.0, 0.0, 1e-25), 0.0);
    assert_eq!(local_coefficient(&USUAL, 0.0_f32, -1e-30, 0.0, 1e-25), 0.0, "a denominator that underflows");
    assert_eq!(decayed_coefficient(&USUAL, 0.5_f32, 0.0, decay_rate(0.0, 1e25), 1.0), 0.5);
}

fn physics<const D: usize>(dissipation: Dissipation) -> Physics {
    Physics { viscosity: Viscosity::of(dissipation), ..Sod::standard(D).physics() }
}

/// The sweep, given a divergence that is linear in the position: its gradient must come back, whatever the cloud.
fn gradient_is_recovered<const D: usize>(slope: [f64; D]) {
    let physics = physics::<D>(Dissipation::AvSw);
    let viscosity = physics.viscosity;
    let set = Recipe { jitter: 0.5, ..Recipe::unequal::<D>(83) }.particles::<D>(false);
    let mut engine = PlainEngine::<f64, D>::new(&set);
    engine.find_neighbours(2.0).unwrap();
    let pipeline = Pipeline::of_scene::<D>(&physics);
    pipeline.start(&mut engine, physics).unwrap();
    pipeline.run(&mut engine, physics).unwrap();

    let place =
        |a: usize, axis| set.domain().decode(axis, set.domain().encode(axis, set.particles()[a].position[axis]));
    let divergence: Vec<f64> =
        (0..set.len()).map(|a| -8.0 + (0..D).map(|axis| slope[axis] * place(a, axis)).sum::<f64>()).collect();
    // Shared out unevenly, so that only the trace is right.
    let shares = [[1.0, 0.0, 0.0], [0.75, 0.25, 0.0], [0.5, 0.75, -0.25]][D - 1];
    let pairs = (0..D).flat_map(|i| (i..D).map(move |j| (i, j)));
    for (i, j) in pairs {
        let index = Symmetric::<f64, D>::position(i, j);
        let entry = |d: &f64| if i == j { shares[i] * d } else { 17.0 };
        let values: Vec<f64> = divergence.iter().map(entry).collect();
        engine.write(Component { field: fields::STRAIN_RATE, index }, &values).unwrap();
    }
    let remaining: Vec<f64> = (0..set.len()).map(|a| 0.05 + 0.4 * (a % 3) as f64).collect();
    engine.write(Component { field: fields::REMAINING_ALPHA, index: 0 }, &remaining).unwrap();
    engine.run_pass(&Switch(physics)).unwrap();

    let c = engine.read_all(fields::GRADIENT_MATRIX).unwrap();
    let sound = engine.read_scalar(fields::SOUND_SPEED).unwrap();
    let (local, alpha) = (engine.read_scalar(fields::LOCAL_ALPHA).unwrap(), engine.read_scalar(fields::ALPHA).unwrap());
    let size = slope.iter().map(|s| s * s).sum::<f64>().sqrt();
    let (mut checked, mut raised, mut receding) = (0, 0, 0);
    for (a, p) in set.particles().iter().enumerate() {
        let h = p.smoothing_length;
        assert_eq!(alpha[a], local[a].max(remaining[a]), "coefficient of particle {a}");
        raised += usize::from(alpha[a] == local[a]);
        receding += usize::from(divergence[a] > 0.0);
        let inverse = DMatrix::from_fn(D, D, |i, j| c[Symmetric::<f64, D>::position(i, j)][a]);
        let Some(tau) = inverse.try_inverse() else { continue };
        let quality = (&tau * (D as f64 / tau.trace())).determinant();
        if quality < 0.05 {
            continue;
        }
        checked += 1;
        // As for the velocity gradient: the inverse, applied to sums of |tau| |slope|; the divergence, up to 40, is rounded a few
        // times and enters with sum V |A| < 10 / h. The derivative of alpha_loc with respect to D is below 1 / (0.05 c).
        let bound = (D * D) as f64 * (20.0 + 450.0 / quality) / quality * UNIT * size + 40.0 * 4.0 * UNIT * 10.0 / h;
        let bound = h * h * bound / (0.05 * sound[a]) + 20.0 * UNIT;
        let indicator = h * h * size;
        let due = match divergence[a] < 0.0 {
            true => viscosity.alpha * indicator / (indicator + h * divergence[a].abs() + 0.05 * sound[a]),
            false => 0.0,
        };
        assert_close(&format!("alpha_loc of particle {a} in {D}-D, quality {quality}"), local[a], due, bound);
    }
    assert!(checked * 4 > set.len() * 3, "only {checked} of {} particles in {D}-D", set.len());
    assert!(raised * 10 > set.len() && receding * 10 > set.len(), "{raised} raised, {receding} receding");
}

#[test]
fn a_linear_divergence_has_its_exact_gradient() {
    gradient_is_recovered([16.0]);
    gradient_is_recovered([10.0, 8.0]);
    gradient_is_recovered([9.0, -4.0, 12.0]);
}

/// The update applies the formula, and the last sweep gives it the largest signal velocity over `h`.
#[test]
fn a_step_decays_with_the_signal() {
    let physics = physics::<2>(Dissipation::AvSwSlr);
    let set = Recipe::unequal::<2>(84).particles::<2>(true);
    let mut engine = PlainEngine::<f64, 2>::new(&set);
    engine.find_neighbours(2.0).unwrap();
    let pipeline = Pipeline::of_scene::<2>(&physics);
    pipeline.start(&mut engine, physics).unwrap();
    pipeline.run(&mut engine, physics).unwrap();
    let dt = 1e-3;
    engine.run_update(&Decay(physics), dt).unwrap();
    let mut read = |field| engine.read_scalar(field).unwrap();
    let [alpha, local, rate, remaining, sound] =
        [fields::ALPHA, fields::LOCAL_ALPHA, fields::ALPHA_DECAY_RATE, fields::REMAINING_ALPHA, fields::SOUND_SPEED]
            .map(&mut read);
    let mut decaying = 0;
    for (a, p) in set.particles().iter().enumerate() {
        let largest = engine.neighbours().of(a).iter().map(|&b| b as usize).map(|b| {
            let coordinates = [0, 1].map(|axis| set.coordinates(axis));
            let x: [f64; 2] = std::array::from_fn(|axis| {
                etalon_reference::domain::separation(coordinates[axis][a], coordinates[axis][b], 1.0)
            });
            let v: [f64; 2] = std::array::from_fn(|axis| p.velocity[axis] - set.particles()[b].velocity[axis]);
            let r = (x[0] * x[0] + x[1] * x[1]).sqrt();
            sound[a] + sound[b] - 3.0 * ((x[0] * v[0] + x[1] * v[1]) / r).min(0.0)
        });
        let due = largest.fold(2.0 * sound[a], f64::max) / p.smoothing_length;
        assert_close(&format!("1/tau of particle {a}"), rate[a], due, gamma(20, UNIT) * due);
        let target = local[a].max(0.05);
        let due = target + (alpha[a] - target) * (-dt * rate[a]).exp();
        assert_close(&format!("what is left of particle {a}'s coefficient"), remaining[a], due, 24.0 * UNIT);
        decaying += usize::from(remaining[a] < alpha[a]);
    }
    // Where the flow has raised it, the coefficient is its own target and stays; an initial one is the smallest and stays too.
    assert_eq!(decaying, 0);
}

/// In the tube the coefficient rises at the shock, falls behind it, and is nowhere else but where it started.
#[test]
fn coefficient_follows_the_shock() {
    for dissipation in [Dissipation::AvSw, Dissipation::AvSwSlr] {
        let scene = Sod::standard(1).with(|m| (m.viscosity, m.particles) = (Viscosity::of(dissipation), 300));
        let set = scene.particles::<1>(|_| unreachable!("the tube starts on a lattice")).unwrap();
        let domain = *set.domain();
        let mut simulation = Simulation::new(PlainEngine::<f64, 1>::new(&set), scene.physics()).unwrap();
        let (mut seen, mut fell) = (vec![0.0_f64; set.len()], 0);
        while simulation.time() < 0.1 {
            simulation.step(0.1).unwrap();
            let alpha = simulation.engine().read_scalar(fields::ALPHA).unwrap();
            assert!(alpha.iter().all(|a| (0.05..=1.0).contains(a)), "{dissipation}");
            for (seen, alpha) in seen.iter_mut().zip(&alpha) {
                fell += usize::from(*alpha < *seen);
                *seen = seen.max(*alpha);
            }
        }
        let alpha = simulation.engine().read_scalar(fields::ALPHA).unwrap();
        let x: Vec<f64> = simulation.engine().coordinates(0).unwrap().iter().map(|c| domain.decode(0, *c)).collect();
        let largest = |from: f64, to: f64| {
            alpha.iter().zip(&x).filter(|(_, x)| (from..to).contains(*x)).map(|(a, _)| *a).fold(0.0, f64::max)
        };
        // At t = 0.1 the shock is at 0.6845, the rarefaction's head at 0.371. What is undisturbed has a small fraction of it.
        let shock = largest(0.66, 0.72);
        assert!(shock > 0.4, "{dissipation}: {shock} at the shock");
        for (from, to, place) in [(0.1, 0.33, "ahead of the rarefaction"), (0.76, 0.95, "ahead of the shock")] {
            assert!(largest(from, to) < 0.2 * shock, "{dissipation}: {} {place}", largest(from, to));
        }
        assert!(fell > 1000, "{dissipation}: it decays behind the shock ({fell} falls)");
        let passed = |i: usize| (0.52..0.62).contains(&x[i]) && seen[i] > 0.3 && alpha[i] < 0.5 * seen[i];
        assert!((0..x.len()).any(passed), "{dissipation}: a particle has risen and come down");
    }
}
