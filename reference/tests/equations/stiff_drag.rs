//! Drag over whole steps: the exact pair, its splitting, and the mean over a step.

use crate::check::{UNIT, assert_close, gamma};
use crate::float::Float;
use crate::hard_inputs::Domain::{Any, NotNegative};
use crate::hard_inputs::try_all;
use etalon_kernels_gen::Vector;
use etalon_reference::equations::drag::{drag_rate, drag_weight, stopping_rate};
use etalon_reference::equations::dust_reconstruction::{entropy_fixed, mass_share};
use etalon_reference::equations::stiff_drag::*;
use nalgebra::DMatrix;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

#[test]
fn whole_numbers() {
    // Half of 8 is lost: the gas, with 3/4 of the mass, gives a quarter of 4, the dust gets three quarters. Heat: 1 (6 - 2).
    let got = pair_drag(0.5, 6.0, 8.0, 0.75, 0.25, Vector([1.0, 0.0]));
    assert_eq!((got.gas_velocity.0, got.dust_velocity.0, got.gas_energy), ([-1.0, 0.0], [3.0, 0.0], 4.0));
    assert_eq!(decayed_share(0.0, 5.0), 0.0);
    assert_eq!(mean_drag_share(0.0, 5.0), 1.0);
}

/// Accurate where nearly nothing decays, and where nearly everything does.
#[test]
fn decay_is_exponential() {
    for (rate, step) in [(3.0, 1e-20), (2.0, 0.01), (7.0, 0.1), (5.0, 0.5), (4.0, 2.0), (10.0, 3.0), (1e9, 1e9_f64)] {
        let due = -(-rate * step).exp_m1();
        // Budget of `expm1_negative`, 7 epsilon, and the product's rounding; beyond 32 time constants it stays at exp(-32) = 1.3e-14.
        let floor = if rate * step > 32.0 { 1.3e-14 } else { 0.0 };
        assert_close("decayed share", decayed_share(rate, step), due, gamma(16, UNIT) * due + floor);
        let mean = due / (rate * step);
        assert_close("mean share", mean_drag_share(rate, step), mean, (gamma(18, UNIT) + floor) * mean);
    }
}

/// A pair with everything unequal: masses, velocities, unit vector from dust to gas.
fn random_pair(random: &mut Pcg64Mcg) -> ([f64; 2], [Vector<f64, 3>; 2], Vector<f64, 3>) {
    let mut vector = || Vector::from_fn(|_| 2.0 * random.random::<f64>() - 1.0);
    let (v_a, v_i, separation) = (vector(), vector(), vector());
    let masses = [0.5 + 3.0 * random.random::<f64>(), 0.1 + random.random::<f64>()];
    (masses, [v_a, v_i], separation.scale(1.0 / separation.norm()))
}

/// Momentum is kept, and what the pair loses in kinetic energy is the gas's heat: for any decay and any reconstruction.
#[test]
fn a_pair_keeps_momentum_and_energy() {
    let mut random = Pcg64Mcg::seed_from_u64(7);
    for _ in 0..1000 {
        let (m, v, direction) = random_pair(&mut random);
        let omega = (v[0] - v[1]).dot(direction);
        let omega_star = 4.0 * random.random::<f64>() - 2.0;
        let decayed = [0.0, 1e-9, 0.3, 1.0][random.random_range(0..4)];
        let (share_a, share_i) = (mass_share(m[0], m[1]), mass_share(m[1], m[0]));
        let drag = pair_drag(decayed, omega, omega_star, share_a, share_i, direction);
        let after = [v[0] + drag.gas_velocity, v[1] + drag.dust_velocity];
        let energy = |v: [Vector<f64, 3>; 2]| 0.5 * (m[0] * v[0].norm_squared() + m[1] * v[1].norm_squared());
        // Velocities below 4 and masses below 4: kinetic energies below 16 each.
        let momentum = drag.gas_velocity.scale(m[0]) + drag.dust_velocity.scale(m[1]);
        for axis in 0..3 {
            assert_close("momentum", momentum[axis], 0.0, gamma(12, UNIT) * m[0] * decayed * 2.0);
        }
        assert_close("energy", energy(after) + m[0] * drag.gas_energy, energy(v), gamma(40, UNIT) * 32.0);
        let difference = (after[0] - after[1]).dot(direction);
        assert_close("difference left", difference, omega - decayed * omega_star, gamma(30, UNIT) * 8.0);
        // Raw velocities, or reconstructed ones with the entropy fix, never cool.
        let fixed = entropy_fixed(omega_star, omega, decayed);
        for star in [omega, fixed] {
            let heat = pair_drag(decayed, omega, star, share_a, share_i, direction).gas_energy;
            assert!(heat >= 0.0, "heat {heat:e} with {star} for {omega}");
        }
    }
}

/// The pair of (4) and (5) with slopes that stand still, integrated in small steps.
#[test]
fn a_pair_follows_its_equations_of_motion() {
    let (m, rho, k, hump, step, slopes) = ([2.0, 0.5], [3.0, 0.7], 4.0, 0.6, 0.35, 0.9);
    let weight = |own: usize| drag_weight::<f64, 3>(drag_rate(k, rho[own]), m[1 - own] / rho[1 - own], hump);
    let (mut v_a, mut v_i, mut heat) = (2.0_f64, -1.0_f64, 0.0_f64);
    let exact = {
        let omega = v_a - v_i;
        let decayed = decayed_share(weight(0) + weight(1), step);
        pair_drag(decayed, omega, omega - slopes, mass_share(m[0], m[1]), mass_share(m[1], m[0]), Vector([1.0]))
    };
    let start = [v_a, v_i];
    // Midpoint rule: an error of (rate dt)^3 / 24 a step.
    let turns = 20_000;
    let dt = step / f64::from(turns);
    for _ in 0..turns {
        let rates = |v_a: f64, v_i: f64| {
            let star = v_a - v_i - slopes;
            [-weight(0) * star, weight(1) * star, weight(0) * star * (v_a - v_i)]
        };
        let first = rates(v_a, v_i);
        let middle = rates(v_a + 0.5 * dt * first[0], v_i + 0.5 * dt * first[1]);
        v_a += dt * middle[0];
        v_i += dt * middle[1];
        heat += dt * middle[2];
    }
    let rate: f64 = weight(0) + weight(1);
    let tolerance = f64::from(turns) * (rate * dt).powi(3) * 3.0;
    println!("tolerance {tolerance:e}");
    assert_close("gas", start[0] + exact.gas_velocity[0], v_a, tolerance);
    assert_close("dust", start[1] + exact.dust_velocity[0], v_i, tolerance);
    assert_close("heat", exact.gas_energy, heat, 4.0 * tolerance);
}

/// Some particles of both kinds on a line, each pair with its own weight `G`: `m_a dv_a/dt = -G (v_a - v_i)`.
struct Cluster {
    gas: usize,
    mass: Vec<f64>,
    coupling: Vec<(usize, usize, f64)>,
}

impl Cluster {
    fn new() -> Self {
        let mut random = Pcg64Mcg::seed_from_u64(8);
        let gas = 4;
        let mass: Vec<f64> = (0..7).map(|_| 0.5 + random.random::<f64>()).collect();
        let coupling = (0..gas).flat_map(|a| (gas..7).map(move |i| (a, i))).map(|(a, i)| (a, i, random.random()));
        Cluster { gas, mass, coupling: coupling.collect() }
    }

    fn start(&self) -> Vec<f64> {
        (0..self.mass.len()).map(|k| if k < self.gas { 1.0 + k as f64 } else { -(k as f64) }).collect()
    }

    fn exact(&self, time: f64) -> Vec<f64> {
        let n = self.mass.len();
        let mut rates = DMatrix::<f64>::zeros(n, n);
        for &(a, i, g) in &self.coupling {
            for (own, other) in [(a, i), (i, a)] {
                rates[(own, own)] -= g / self.mass[own];
                rates[(own, other)] += g / self.mass[own];
            }
        }
        let start = nalgebra::DVector::from_vec(self.start());
        ((rates * time).exp() * start).as_slice().to_vec()
    }

    /// Goes through the pairs in the order given; returns the heat.
    fn sweep<'p>(&self, v: &mut [f64], dt: f64, pairs: impl Iterator<Item = &'p (usize, usize, f64)>) -> f64 {
        let mut heat = 0.0;
        for &(a, i, g) in pairs {
            let (m_a, m_i) = (self.mass[a], self.mass[i]);
            let decayed = decayed_share(g / m_a + g / m_i, dt);
            let omega = v[a] - v[i];
            let drag = pair_drag(decayed, omega, omega, mass_share(m_a, m_i), mass_share(m_i, m_a), Vector([1.0]));
            v[a] += drag.gas_velocity[0];
            v[i] += drag.dust_velocity[0];
            heat += m_a * drag.gas_energy;
        }
        heat
    }

    fn run(&self, time: f64, steps: usize, symmetric: bool) -> Vec<f64> {
        let mut v = self.start();
        let dt = time / steps as f64;
        for _ in 0..steps {
            if symmetric {
                self.sweep(&mut v, 0.5 * dt, self.coupling.iter());
                self.sweep(&mut v, 0.5 * dt, self.coupling.iter().rev());
            } else {
                self.sweep(&mut v, dt, self.coupling.iter());
            }
        }
        v
    }

    fn error(&self, time: f64, steps: usize, symmetric: bool) -> f64 {
        let exact = self.exact(time);
        self.run(time, steps, symmetric).iter().zip(exact).map(|(v, due)| (v - due).abs()).fold(0.0, f64::max)
    }
}

/// First order pair after pair, second there and back: halving the step divides the error by 2 and by 4.
#[test]
fn splitting_has_its_stated_order() {
    let cluster = Cluster::new();
    for (symmetric, order) in [(false, 1.0), (true, 2.0)] {
        let errors: Vec<f64> = [64, 128, 256].iter().map(|&n| cluster.error(1.0, n, symmetric)).collect();
        let measured = (errors[1] / errors[2]).log2();
        println!("errors {errors:?}, order {measured}");
        // The next term is one power of the step further: a share of some n_pairs rate dt = 12 / 128 of the leading one.
        assert!((measured - order).abs() < 0.1, "order {measured} where {order} is due, tolerance 0.1");
    }
}

/// However long the step, energy falls and goes into heat, momentum stays, and all come to one velocity.
#[test]
fn any_step_is_stable() {
    let cluster = Cluster::new();
    let momentum = |v: &[f64]| cluster.mass.iter().zip(v).map(|(m, v)| m * v).sum::<f64>();
    let energy = |v: &[f64]| 0.5 * cluster.mass.iter().zip(v).map(|(m, v)| m * v * v).sum::<f64>();
    for dt in [1e-6, 1.0, 1e6, 1e100] {
        let mut v = cluster.start();
        let (p, e) = (momentum(&v), energy(&v));
        let mut heat = 0.0;
        let mut before = e;
        for _ in 0..200 {
            heat += cluster.sweep(&mut v, dt, cluster.coupling.iter());
            assert!(energy(&v) <= before * (1.0 + gamma(100, UNIT)), "energy rises with a step of {dt}");
            before = energy(&v);
        }
        // 200 sweeps of 12 pairs, ten roundings each.
        assert_close("momentum", momentum(&v), p, gamma(24_000, UNIT) * 50.0);
        assert_close("energy and heat", energy(&v) + heat, e, gamma(24_000, UNIT) * 150.0);
        if dt >= 1.0 {
            let common = p / cluster.mass.iter().sum::<f64>();
            for v in v {
                assert_close("common velocity", v, common, gamma(24_000, UNIT) * 50.0);
            }
        }
    }
}

/// Two uniform fluids in one step of any length: `(K f / rho) dt` with the mean share `f` is the exact change.
#[test]
fn mean_drag_is_exact_in_a_uniform_box() {
    let (k, rho_g, rho_d): (f64, f64, f64) = (4.0, 2.0, 0.5);
    let rate = stopping_rate(k, rho_g, rho_d);
    for dt in [1e-12, 0.01, 0.1, 1.0, 10.0, 1e6_f64] {
        let mean = k * mean_drag_share(rate, dt);
        let decayed = (drag_rate(mean, rho_g) + drag_rate(mean, rho_d)) * dt;
        let due = -(-rate * dt).exp_m1();
        assert_close("decayed", decayed, due, gamma(30, UNIT) * due + 1.3e-14);
        assert!(decayed <= 1.0 + gamma(30, UNIT), "a step of {dt} takes {decayed} of the difference");
    }
}

fn hard_inputs<T: Float>(extreme: f64) {
    try_all("decayed_share", [NotNegative; 2], extreme, |[a, b]: [T; 2]| decayed_share(a, b));
    try_all("mean_drag_share", [NotNegative; 2], extreme, |[a, b]: [T; 2]| mean_drag_share(a, b));
    try_all("pair_drag", [NotNegative, Any, Any], extreme, |[a, b, c]: [T; 3]| {
        pair_drag(a, b, c, T::lit(0.75), T::lit(0.25), Vector([T::one()])).gas_energy
    });
}

#[test]
fn stiff_drag_never_leaves_the_numbers() {
    hard_inputs::<f64>(1e50);
    hard_inputs::<f32>(1e6);
}
