//! PL20 (4)-(7) as a sweep, against a plain double loop, and what it must conserve.

use crate::check::{UNIT, gamma};
use crate::{all_drags, physics, run, together, two_clouds};
use etalon_kernels_gen::Component;
use etalon_reference::domain::separation;
use etalon_reference::engine::{Engine, PlainEngine};
use etalon_reference::equations::double_hump::double_hump;
use etalon_reference::equations::limiters::limited_slope;
use etalon_reference::equations::time_step::LONGEST_STEP;
use etalon_reference::fields;
use etalon_reference::particles::{Particle, ParticleSet};
use etalon_reference::passes::{DragForces, ReconstructedDragForces};
use etalon_reference::schemes::{CommonPoint, Drag, DragSigns, SlopeLimiter};

const COEFFICIENT: f64 = 3.0;

/// What drag alone does to every particle, and how large the terms are that it is the sum of.
struct Rates<const D: usize> {
    acceleration: Vec<[f64; D]>,
    heating: Vec<f64>,
    /// Sum over pairs of the magnitudes of all that is added, of forces and of heating.
    sizes: Vec<[f64; 2]>,
    /// The shortest stopping time.
    stopping: Vec<f64>,
    neighbours: usize,
}

/// By the sweep, on top of nothing.
fn swept<const D: usize>(set: &ParticleSet<D>, drag: Drag) -> (PlainEngine<f64, D>, Vec<[f64; D]>, Vec<f64>, Vec<f64>) {
    let mut engine = run(set, physics(drag));
    let all = |value: f64| vec![value; set.len()];
    for index in 0..D {
        engine.write(Component { field: fields::ACCELERATION, index }, &all(0.0)).unwrap();
    }
    engine.write(Component { field: fields::ENERGY_RATE, index: 0 }, &all(0.0)).unwrap();
    engine.write(Component { field: fields::TIME_STEP, index: 0 }, &all(LONGEST_STEP)).unwrap();
    if drag.reconstructs() {
        engine.run_pass(&ReconstructedDragForces(physics(drag))).unwrap();
    } else {
        engine.run_pass(&DragForces(physics(drag))).unwrap();
    }
    let columns = engine.read_all(fields::ACCELERATION).unwrap();
    let acceleration = (0..set.len()).map(|a| std::array::from_fn(|axis| columns[axis][a])).collect();
    let heating = engine.read_scalar(fields::ENERGY_RATE).unwrap();
    let step = engine.read_scalar(fields::TIME_STEP).unwrap();
    (engine, acceleration, heating, step)
}

/// By the paper's formulas with signs that slow down, over all gas and all dust, from the densities and gradients that the sweeps before found.
fn summed<const D: usize>(engine: &mut PlainEngine<f64, D>, set: &ParticleSet<D>, drag: Drag) -> Rates<D> {
    let density = engine.read_scalar(fields::DENSITY).unwrap();
    let strain = if drag.reconstructs() { engine.read_all(fields::LINEAR_STRAIN_RATE).unwrap() } else { Vec::new() };
    let coordinates: [Vec<u64>; D] = std::array::from_fn(|axis| set.coordinates(axis));
    let (count, half) = (set.len(), set.len() / 2);
    let mut rates = Rates {
        acceleration: vec![[0.0; D]; count],
        heating: vec![0.0; count],
        sizes: vec![[0.0; 2]; count],
        stopping: vec![LONGEST_STEP; count],
        neighbours: (0..count).map(|a| engine.neighbours().of(a).len()).max().unwrap(),
    };
    let p = set.particles();
    for a in 0..half {
        for i in half..count {
            let r_ai: [f64; D] =
                std::array::from_fn(|axis| separation(coordinates[axis][a], coordinates[axis][i], 1.0));
            let r = r_ai.iter().map(|x| x * x).sum::<f64>().sqrt();
            let h = p[a].smoothing_length.max(p[i].smoothing_length);
            if r == 0.0 || r >= physics(drag).kernel.support() * h {
                continue;
            }
            let hat = r_ai.map(|x| x / r);
            let omega: f64 = (0..D).map(|k| (p[a].velocity[k] - p[i].velocity[k]) * hat[k]).sum();
            let slope = |of: usize| {
                let pairs = (0..D).flat_map(|j| (j..D).map(move |k| (j, k)));
                let term = |(at, (j, k)): (usize, (usize, usize))| {
                    strain[at][of] * hat[j] * hat[k] * if j == k { 1.0 } else { 2.0 }
                };
                pairs.enumerate().map(term).sum::<f64>()
            };
            let (mut star, mut parts) = (omega, omega.abs());
            if drag.reconstructs() {
                let (s_a, s_i) = (slope(a), slope(i));
                let (mu_a, mu_i) = (p[a].mass / (p[a].mass + p[i].mass), p[i].mass / (p[a].mass + p[i].mass));
                let limited = limited_slope(drag.reconstruction.limiter, s_a, s_i);
                let unlimited = drag.reconstruction.limiter == SlopeLimiter::Unlimited;
                star -= r * match drag.reconstruction.point {
                    CommonPoint::AsPrinted => 2.0 * mu_a * limited,
                    CommonPoint::Barycentre if unlimited => mu_i * s_a + mu_a * s_i,
                    _ => limited,
                };
                // Of a slope every product of components is rounded.
                let gradient: f64 = strain.iter().map(|column| 2.0 * (column[a].abs() + column[i].abs())).sum();
                parts += 2.0 * r * gradient;
            }
            if drag.entropy_fix && star * omega < 0.0 {
                star = omega;
            }
            let stopping = density[a] * density[i] / (COEFFICIENT * (density[a] + density[i]));
            let hump = double_hump::<f64, D>(physics(drag).kernel, (r / h) * (r / h)) / h.powi(D as i32);
            let common = D as f64 / ((density[a] + density[i]) * stopping) * hump;
            for (k, along) in hat.iter().enumerate() {
                rates.acceleration[a][k] -= common * p[i].mass * star * along;
                rates.acceleration[i][k] += common * p[a].mass * star * along;
            }
            rates.heating[a] += common * p[i].mass * star * omega;
            let [of_gas, of_dust] = [p[i].mass, p[a].mass].map(|m| common * m * parts);
            rates.sizes[a][0] += of_gas;
            rates.sizes[i][0] += of_dust;
            rates.sizes[a][1] += of_gas * omega.abs();
            for both in [a, i] {
                rates.stopping[both] = rates.stopping[both].min(stopping);
            }
        }
    }
    rates
}

/// Either side rounds: n terms of a sum, and some 60 times in each term, most of them in the kernel's polynomial, near whose edge relative errors
/// grow, but not those of what it is beside other pairs.
fn sums_are_the_papers<const D: usize>(drag: Drag, seed: u64) -> f64 {
    let set = two_clouds::<D>(seed);
    let (mut engine, acceleration, heating, step) = swept(&set, drag);
    let due = summed(&mut engine, &set, drag);
    let mut worst = 0.0_f64;
    let what = format!("{D}-D, {drag:?}");
    for a in 0..set.len() {
        let share = 2.0 * gamma(due.neighbours + 60, UNIT);
        for (k, (found, expected)) in acceleration[a].iter().zip(&due.acceleration[a]).enumerate() {
            let error = (found - expected).abs();
            let tolerance = share * due.sizes[a][0];
            assert!(error <= tolerance, "{what}: acceleration {k} of {a}: off by {error:e}, tolerance {tolerance:e}");
            worst = worst.max(if tolerance > 0.0 { error / tolerance } else { 0.0 });
        }
        let (error, tolerance) = ((heating[a] - due.heating[a]).abs(), share * due.sizes[a][1]);
        assert!(error <= tolerance, "{what}: heating of {a}: off by {error:e}, tolerance {tolerance:e}");
        assert!(step[a] <= 0.9 * due.stopping[a] * (1.0 + gamma(8, UNIT)), "{what}: the step of {a} is {}", step[a]);
    }
    worst
}

#[test]
fn a_plain_double_loop_gives_the_same() {
    let mut worst = 0.0_f64;
    for drag in all_drags(COEFFICIENT) {
        worst = worst.max(sums_are_the_papers::<1>(drag, 21));
        worst = worst.max(sums_are_the_papers::<2>(drag, 22));
    }
    worst = worst.max(sums_are_the_papers::<3>(Drag::of(COEFFICIENT), 23));
    println!("largest error over tolerance: {worst}");
}

/// `sum m a` and `sum m (v . a + du/dt)` of drag alone, with masses that differ by four, and the sizes of what is added up.
fn totals<const D: usize>(drag: Drag, seed: u64) -> ([f64; D], f64, f64, [f64; 3]) {
    let set = two_clouds::<D>(seed);
    let (mut engine, acceleration, heating, _) = swept(&set, drag);
    let sizes = summed(&mut engine, &set, drag);
    let (mut momentum, mut energy, mut heat) = ([0.0; D], 0.0, 0.0);
    let mut size = [0.0; 2];
    for (a, p) in set.particles().iter().enumerate() {
        for k in 0..D {
            momentum[k] += p.mass * acceleration[a][k];
            energy += p.mass * p.velocity[k] * acceleration[a][k];
        }
        heat += p.mass * heating[a];
        // Velocities are within -1 and 1 along each axis.
        size[0] += p.mass * sizes.sizes[a][0];
        size[1] += p.mass * (sizes.sizes[a][0] * (D as f64).sqrt() + sizes.sizes[a][1]);
    }
    let share = gamma(sizes.neighbours + set.len() + 60, UNIT);
    (momentum, energy + heat, heat, [share * size[0], share * size[1], size[0]])
}

/// Momentum and energy are kept to the rounding of the sums, whatever is reconstructed how: each partner feels the same velocity difference.
#[test]
fn momentum_and_energy_are_kept_with_unequal_masses() {
    fn kept<const D: usize>(drag: Drag, seed: u64) {
        let (momentum, energy, heat, [of_momentum, of_energy, size]) = totals::<D>(drag, seed);
        let what = format!("{D}-D, {drag:?}");
        for total in momentum {
            assert!(total.abs() <= of_momentum, "{what}: sum m a = {total:e}, tolerance {of_momentum:e}");
        }
        assert!(energy.abs() <= of_energy, "{what}: dE/dt = {energy:e}, tolerance {of_energy:e}");
        assert!(heat.abs() > 1e6 * of_energy && size > 1e6 * of_momentum, "{what}: no drag to speak of");
    }
    for drag in all_drags(COEFFICIENT) {
        kept::<1>(drag, 31);
        kept::<2>(drag, 32);
        kept::<3>(drag, 33);
    }
}

/// With the signs as printed momentum is kept all the same, and energy grows by twice the heating: the motion gains what it should lose.
#[test]
fn printed_signs_keep_momentum_and_not_energy() {
    let drag = Drag { signs: DragSigns::AsPrinted, ..Drag::of(COEFFICIENT) };
    let (momentum, energy, heat, [of_momentum, of_energy, _]) = totals::<3>(drag, 35);
    assert!(momentum.iter().all(|total| total.abs() <= of_momentum), "{momentum:?}, tolerance {of_momentum:e}");
    let error = (energy - 2.0 * heat).abs();
    assert!(error <= 2.0 * of_energy, "dE/dt = {energy:e} where {:e} is due, tolerance {of_energy:e}", 2.0 * heat);
    assert!(heat > 1e6 * of_energy, "{heat:e}");
}

/// Gas and dust that flow together, but for a hundredth: what is left of a pair's velocity difference after reconstruction is often of the other
/// sign, and a gas particle is cooled. The fix lets no pair do that.
#[test]
fn the_entropy_fix_lets_no_gas_cool() {
    let cooled = |entropy_fix: bool| {
        let mixed = two_clouds::<2>(37);
        let half = mixed.len() / 2;
        let together_but_for = |p: &Particle<2>| {
            let common = (std::f64::consts::TAU * p.position[0]).sin();
            Particle { velocity: [common + 0.01 * p.velocity[0], 0.01 * p.velocity[1]], ..*p }
        };
        let all: Vec<_> = mixed.particles().iter().map(together_but_for).collect();
        let set = together(*mixed.domain(), &all[..half], &all[half..]);
        let mut drag = Drag { entropy_fix, ..Drag::of(COEFFICIENT) };
        drag.reconstruction.limiter = SlopeLimiter::Unlimited;
        let (_, _, heating, _) = swept(&set, drag);
        heating.iter().filter(|rate| **rate < 0.0).count()
    };
    let (without, with) = (cooled(false), cooled(true));
    assert!(without > 0 && with == 0, "{without} particles of gas cool without the fix, {with} with it");
}
