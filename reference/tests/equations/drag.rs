//! PL20 (1)-(7): drag between gas and dust.

use crate::check::{UNIT, assert_close, gamma};
use crate::float::Float;
use crate::hard_inputs::Domain::{Any, NotNegative, Positive};
use crate::hard_inputs::try_all;
use etalon_kernels_gen::Vector;
use etalon_reference::equations::double_hump::double_hump;
use etalon_reference::equations::drag::*;
use etalon_reference::equations::time_step::LONGEST_STEP;
use etalon_reference::schemes::{DragSigns, Kernel};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

#[test]
fn whole_numbers() {
    assert_eq!(drag_rate(6.0, 2.0), 3.0);
    // The gas is faster by (1, 2): it is held back, the dust dragged along.
    assert_eq!(continuum_drag(3.0, Vector([1.0, 2.0])).0, [-3.0, -6.0]);
    assert_eq!(continuum_drag_heating(3.0, Vector([1.0, 2.0])), 15.0);
    // 6/2 + 6/3
    assert_eq!(stopping_rate(6.0, 2.0, 3.0), 5.0);
    assert_eq!(stopping_time(4.0), 0.25);
    // The paper's: K = 1000 and unit densities.
    assert_eq!(stopping_time(stopping_rate(1000.0, 1.0, 1.0)), 5e-4);
    assert_close("0.9 / 4.5", drag_step(4.5), 0.2, gamma(3, UNIT) * 0.2);
    // nu times 5 * 7 * 11
    assert_eq!(drag_weight::<_, 1>(5.0, 7.0, 11.0), 385.0);
    assert_eq!(drag_weight::<_, 2>(5.0, 7.0, 11.0), 770.0);
    assert_eq!(drag_weight::<_, 3>(5.0, 7.0, 11.0), 1155.0);
    let direction = Vector([0.6, -0.8]);
    assert_eq!(drag_acceleration(DragSigns::Physical, 5.0, 2.0, direction).0, [-6.0, 8.0]);
    assert_eq!(drag_acceleration(DragSigns::AsPrinted, 5.0, 2.0, direction).0, [6.0, -8.0]);
    assert_eq!(drag_heating(5.0, 2.0, -3.0), -30.0);
}

/// A pair with everything unequal.
struct Pair {
    mass: [f64; 2],
    density: [f64; 2],
    velocity: [Vector<f64, 3>; 2],
    /// From dust to gas.
    direction: Vector<f64, 3>,
    drag_coefficient: f64,
    double_hump: f64,
    omega_star: f64,
}

impl Pair {
    fn random(random: &mut Pcg64Mcg) -> Self {
        let mut between = |low: f64, high: f64| low + (high - low) * random.random::<f64>();
        let mut vector = || Vector([between(-1.0, 1.0), between(-1.0, 1.0), between(-1.0, 1.0)]);
        let velocity = [vector(), vector()];
        let separation = vector();
        Pair {
            mass: [between(0.5, 4.0), between(0.1, 1.0)],
            density: [between(1.0, 9.0), between(0.2, 2.0)],
            velocity,
            direction: separation.scale(1.0 / separation.norm()),
            drag_coefficient: between(1.0, 20.0),
            double_hump: between(0.1, 2.0),
            omega_star: between(-2.0, 2.0),
        }
    }

    fn omega(&self) -> f64 {
        (self.velocity[0] - self.velocity[1]).dot(self.direction)
    }

    fn weight(&self, own: usize) -> f64 {
        let other = 1 - own;
        let rate = drag_rate(self.drag_coefficient, self.density[own]);
        drag_weight::<f64, 3>(rate, self.mass[other] / self.density[other], self.double_hump)
    }

    /// Accelerations of gas and dust.
    fn accelerations(&self, signs: DragSigns) -> [Vector<f64, 3>; 2] {
        let gas = drag_acceleration(signs, self.weight(0), self.omega_star, self.direction);
        let dust = drag_acceleration(signs, self.weight(1), self.omega_star, -self.direction);
        [gas, dust]
    }
}

/// (4), (5), (6) with the stopping time of (7), as printed but for the signs of (4) and (5).
#[test]
fn pair_terms_are_the_printed_ones() {
    let mut random = Pcg64Mcg::seed_from_u64(1);
    for _ in 0..500 {
        let pair = Pair::random(&mut random);
        let ([m_a, m_i], [rho_a, rho_i]) = (pair.mass, pair.density);
        let t_s = rho_a * rho_i / (pair.drag_coefficient * (rho_a + rho_i));
        let common = 3.0 / ((rho_a + rho_i) * t_s) * pair.omega_star * pair.double_hump;
        let [gas, dust] = pair.accelerations(DragSigns::Physical);
        let [gas_printed, dust_printed] = pair.accelerations(DragSigns::AsPrinted);
        for axis in 0..3 {
            let r_hat = pair.direction[axis];
            let close = |what: &str, got: f64, due: f64| assert_close(what, got, due, gamma(20, UNIT) * due.abs());
            close("(4)", gas_printed[axis], m_i * common * r_hat);
            close("(5)", dust_printed[axis], -m_a * common * r_hat);
            close("(4), sign corrected", gas[axis], -m_i * common * r_hat);
            close("(5), sign corrected", dust[axis], m_a * common * r_hat);
        }
        let heating = drag_heating(pair.weight(0), pair.omega_star, pair.omega());
        let due = m_i * common * pair.omega();
        assert_close("(6)", heating, due, gamma(20, UNIT) * due.abs());
        let rate = stopping_rate(pair.drag_coefficient, rho_a, rho_i);
        assert_close("(7)", stopping_time(rate), t_s, gamma(10, UNIT) * t_s);
    }
}

/// Momentum is kept whatever the signs; energy only with the physical ones, and with one raw and one reconstructed velocity in the heat.
#[test]
fn momentum_is_kept_and_energy_only_with_the_physical_signs() {
    let mut random = Pcg64Mcg::seed_from_u64(2);
    let mut told_apart = 0;
    for _ in 0..500 {
        let pair = Pair::random(&mut random);
        let (m, v, omega) = (pair.mass, pair.velocity, pair.omega());
        let size = m[0] * pair.weight(0) * pair.omega_star.abs();
        let budget = |motion: [Vector<f64, 3>; 2], heating: f64| {
            m[0] * v[0].dot(motion[0]) + m[1] * v[1].dot(motion[1]) + m[0] * heating
        };
        for &signs in DragSigns::ALL {
            let [gas, dust] = pair.accelerations(signs);
            // A weight has six roundings from masses, an acceleration two more; both partners.
            let momentum = gas.scale(m[0]) + dust.scale(m[1]);
            for axis in 0..3 {
                assert_close(&format!("momentum, {signs}"), momentum[axis], 0.0, gamma(24, UNIT) * size);
            }
        }
        let motion = pair.accelerations(DragSigns::Physical);
        let heating = |first, second| drag_heating(pair.weight(0), first, second);
        // Velocities along the line are sums of three products of at most one each.
        let bound = gamma(40, UNIT) * size * 8.0;
        assert_close("energy", budget(motion, heating(pair.omega_star, omega)), 0.0, bound);
        let printed = budget(pair.accelerations(DragSigns::AsPrinted), heating(pair.omega_star, omega));
        let due = 2.0 * m[0] * pair.weight(0) * pair.omega_star * omega;
        assert_close("energy with the printed signs: twice the heat", printed, due, bound);
        for wrong in [heating(omega, omega), heating(pair.omega_star, pair.omega_star)] {
            told_apart += usize::from(budget(motion, wrong).abs() > 1e6 * bound);
        }
    }
    assert!(told_apart > 900, "raw twice and reconstructed twice were told apart in {told_apart} of 1000 cases only");
}

/// A particle among a lattice of the other kind feels `-(K / rho) (v_own - v_other)` and warms accordingly: the factor `nu`, the
/// normalisation of the double hump, and which density goes where.
#[test]
fn sum_over_a_lattice_is_the_continuum_drag() {
    fn check<const D: usize>(kernel: Kernel) {
        let (spacing, mass, own_density, drag_coefficient) = (0.5_f64, 3.0, 7.0, 11.0);
        let h = 4.0 * spacing;
        let volume = spacing.powi(D as i32);
        // Of the dust: mass per volume.
        let other_density = mass / volume;
        let place = Vector::<f64, D>::from_fn(|axis| spacing * [0.3, -0.2, 0.45][axis]);
        let velocity = Vector::<f64, D>::from_fn(|axis| [2.0, -3.0, 5.0][axis]);
        let reach = (kernel.support() * h / spacing) as i64 + 1;
        let across = (2 * reach + 1) as usize;
        let rate = drag_rate(drag_coefficient, own_density);
        let mut acceleration = Vector::zero();
        let mut heating = 0.0;
        for index in 0..across.pow(D as u32) {
            let other = Vector::<f64, D>::from_fn(|axis| {
                spacing * ((index / across.pow(axis as u32) % across) as i64 - reach) as f64
            });
            let separation = place - other;
            let r = separation.norm();
            let direction = separation.scale(1.0 / r);
            let omega = velocity.dot(direction);
            let hump = double_hump::<f64, D>(kernel, (r / h).powi(2)) / h.powi(D as i32);
            let weight = drag_weight::<f64, D>(rate, mass / other_density, hump);
            acceleration = acceleration + drag_acceleration(DragSigns::Physical, weight, omega, direction);
            heating += drag_heating(weight, omega, omega);
        }
        // By Poisson's formula the sum differs from the integral by the transform of x_i x_j W at the lattice's reciprocal vectors. The least smooth
        // kernel, M4 in 1-D, has jumps of its third derivative that add up to 48: 2 zeta(4) 48 / (2 pi 4)^4 = 2.6e-4. Four times that for
        // the more vectors in more dimensions.
        let tolerance = 1e-3;
        let due = continuum_drag(rate, velocity);
        for axis in 0..D {
            let what = format!("drag with {kernel} in {D}-D");
            assert_close(&what, acceleration[axis] / due[axis], 1.0, tolerance);
        }
        let due = continuum_drag_heating(rate, velocity);
        assert_close(&format!("heating with {kernel} in {D}-D"), heating / due, 1.0, tolerance);
    }
    for &kernel in Kernel::ALL {
        check::<1>(kernel);
        check::<2>(kernel);
        check::<3>(kernel);
    }
}

/// Forward Euler on the decay of a difference: factor `1 - dt / t_s` a step, 0.1 with the step here, growing beyond `2 t_s`.
#[test]
fn explicit_step_lets_the_difference_decay() {
    let rate = stopping_rate(1000.0, 1.0, 4.0);
    assert_close("factor a step", 1.0 - drag_step(rate) * rate, 0.1, gamma(6, UNIT));
}

/// Without drag no force, and no limit on the step; with tiny densities no 0/0, where a product of the two is zero already.
#[test]
fn no_drag_and_near_vacuum_are_harmless() {
    fn check<T: Float>(tiny: f64) {
        for density in [tiny, 1.0, 1.0 / tiny] {
            let density = T::lit(density);
            let none = drag_rate(T::zero(), density);
            assert_eq!(none.to_f64(), 0.0);
            assert_eq!(drag_weight::<T, 3>(none, T::one(), T::one()).to_f64(), 0.0);
            let unlimited = stopping_time(stopping_rate(T::zero(), density, density)).to_f64();
            // The constant and its inverse are rounded once each.
            assert_close("time without drag", unlimited, LONGEST_STEP, gamma(3, T::UNIT) * LONGEST_STEP);
        }
        // Densities whose product vanishes, a drag coefficient of the same order: a rate of one, a volume of one, and D = 1.
        let tiny = T::lit(tiny);
        assert_eq!((tiny * tiny).to_f64(), 0.0);
        assert_eq!(drag_weight::<T, 3>(drag_rate(tiny, tiny), tiny / tiny, T::one()).to_f64(), 3.0);
        assert_eq!(stopping_time(stopping_rate(tiny, tiny, tiny)).to_f64(), 0.5);
        // The volume meets D first: a large rate of drag times a large D would be infinite.
        let large = T::one() / tiny;
        assert!(!(large * large).to_f64().is_finite());
        let weight = drag_weight::<T, 1>(large, tiny, large).to_f64();
        assert_close("weight", weight, large.to_f64(), gamma(4, T::UNIT) * large.to_f64());
    }
    check::<f64>(1e-200);
    check::<f32>(1e-30);
}

fn hard_inputs<T: Float>(extreme: f64) {
    try_all("drag_rate", [NotNegative, Positive], extreme, |[a, b]: [T; 2]| drag_rate(a, b));
    try_all("stopping_time", [NotNegative, Positive, Positive], extreme, |[a, b, c]: [T; 3]| {
        stopping_time(stopping_rate(a, b, c))
    });
    try_all("drag_step", [NotNegative], extreme, |[a]: [T; 1]| drag_step(a));
    try_all("drag_weight", [NotNegative; 3], extreme, |[a, b, c]: [T; 3]| drag_weight::<T, 3>(a, b, c));
    try_all("drag_acceleration", [NotNegative, Any, Any], extreme, |[a, b, c]: [T; 3]| {
        drag_acceleration(DragSigns::Physical, a, b, Vector([c]))[0]
    });
    try_all("drag_heating", [NotNegative, Any, Any], extreme, |[a, b, c]: [T; 3]| drag_heating(a, b, c));
}

#[test]
fn drag_never_leaves_the_numbers() {
    hard_inputs::<f64>(1e50);
    hard_inputs::<f32>(1e6);
}
