//! One pair at a time: action is reaction.

use crate::check::{UNIT, assert_close};
use crate::cloud::Recipe;
use crate::records::records;
use crate::{all_physics, run};
use etalon_kernels_gen::{Part, Pass, Separation, Vector};
use etalon_reference::domain::separation;
use etalon_reference::engine::{Engine, PlainEngine};
use etalon_reference::fields;
use etalon_reference::particles::ParticleSet;
use etalon_reference::passes::{Momentum, Physics, ReconstructedMomentum, SwitchedMomentum};
use etalon_reference::schemes::{Dissipation, GradH, Viscosity};

/// Calls a function that is generic over the last sweep and the dimension, with the sweep that the physics has.
macro_rules! with_last_sweep {
    ($physics:expr, $function:ident::<$dimension:tt>($($argument:expr),*)) => {
        match $physics.viscosity.dissipation {
            scheme if scheme.switches() => {
                $function::<etalon_reference::passes::SwitchedMomentum, $dimension>($($argument),*)
            }
            etalon_reference::schemes::Dissipation::Av => {
                $function::<etalon_reference::passes::Momentum, $dimension>($($argument),*)
            }
            _ => $function::<etalon_reference::passes::ReconstructedMomentum, $dimension>($($argument),*),
        }
    };
}
pub(crate) use with_last_sweep;

/// The last sweeps, with what tests need to take their forces apart.
pub trait LastSweep<const D: usize>: Pass<D> {
    /// The sweep with this physics.
    fn of(physics: Physics) -> Self;
    /// The pressure coefficients of the particle and its neighbour.
    fn coefficients<'r>(own: &'r mut Self::Own<f64>, other: &'r mut Self::Other<f64>) -> [&'r mut f64; 2];
    /// Takes the viscosity's linear coefficients away where particles carry them.
    fn still(_: &mut Self::Own<f64>, _: &mut Self::Other<f64>) {}
    /// Acceleration, heating and signal velocity.
    fn sums(sums: &Self::Sums<f64>) -> (Vector<f64, D>, f64, f64);
}

impl<const D: usize> LastSweep<D> for Momentum {
    fn of(physics: Physics) -> Self {
        Momentum(physics)
    }
    fn coefficients<'r>(own: &'r mut Self::Own<f64>, other: &'r mut Self::Other<f64>) -> [&'r mut f64; 2] {
        [&mut own.pair.pressure_coefficient, &mut other.pressure_coefficient]
    }
    fn sums(sums: &Self::Sums<f64>) -> (Vector<f64, D>, f64, f64) {
        (sums.acceleration, sums.energy_rate, sums.signal_velocity)
    }
}

impl<const D: usize> LastSweep<D> for ReconstructedMomentum {
    fn of(physics: Physics) -> Self {
        ReconstructedMomentum(physics)
    }
    fn coefficients<'r>(own: &'r mut Self::Own<f64>, other: &'r mut Self::Other<f64>) -> [&'r mut f64; 2] {
        [&mut own.base.pair.pressure_coefficient, &mut other.base.pressure_coefficient]
    }
    fn sums(sums: &Self::Sums<f64>) -> (Vector<f64, D>, f64, f64) {
        (sums.acceleration, sums.energy_rate, sums.signal_velocity)
    }
}

impl<const D: usize> LastSweep<D> for SwitchedMomentum {
    fn of(physics: Physics) -> Self {
        SwitchedMomentum(physics)
    }
    fn coefficients<'r>(own: &'r mut Self::Own<f64>, other: &'r mut Self::Other<f64>) -> [&'r mut f64; 2] {
        [&mut own.base.pair.pressure_coefficient, &mut other.base.pressure_coefficient]
    }
    fn still(own: &mut Self::Own<f64>, other: &mut Self::Other<f64>) {
        (own.switched.alpha, other.switched.alpha) = (0.0, 0.0);
    }
    fn sums(sums: &Self::Sums<f64>) -> (Vector<f64, D>, f64, f64) {
        (sums.acceleration, sums.energy_rate, sums.signal_velocity)
    }
}

/// All particles as the last sweep takes them, and where they are.
pub struct Pairs<P: LastSweep<D>, const D: usize> {
    physics: Physics,
    own: Vec<P::Own<f64>>,
    other: Vec<P::Other<f64>>,
    coordinates: [Vec<u64>; D],
    length: [f64; D],
    /// The engine that ran the sweeps.
    pub engine: PlainEngine<f64, D>,
}

impl<P: LastSweep<D>, const D: usize> Pairs<P, D> {
    /// After one round of all passes.
    pub fn of(set: &ParticleSet<D>, physics: Physics) -> Self {
        let mut engine = run(set, physics);
        let coordinates = std::array::from_fn(|axis| set.coordinates(axis));
        let pass = P::of(physics);
        let own = records(&mut engine, &pass, Part::Own);
        let other = records(&mut engine, &pass, Part::Other);
        Pairs { physics, own, other, coordinates, length: set.domain().torus_length(), engine }
    }

    /// What lies between two particles.
    pub fn between(&self, a: usize, b: usize) -> Separation<f64, D> {
        let x_ab =
            Vector::from_fn(|axis| separation(self.coordinates[axis][a], self.coordinates[axis][b], self.length[axis]));
        Separation { x_ab, r_squared: x_ab.norm_squared() }
    }

    /// What `b` does to `a`.
    pub fn action(&self, a: usize, b: usize) -> (Vector<f64, D>, f64, f64) {
        P::sums(&P::of(self.physics).pair(&self.own[a], &self.other[b], &self.between(a, b)))
    }

    /// What of it is the particle's own pressure, the neighbour's, and viscosity.
    pub fn parts(&self, a: usize, b: usize) -> [Vector<f64, D>; 3] {
        let inviscid = Viscosity { alpha: 0.0, beta: 0.0, ..self.physics.viscosity };
        let without = Physics { viscosity: inviscid, ..self.physics };
        [(without, [1.0, 0.0]), (without, [0.0, 1.0]), (self.physics, [0.0, 0.0])].map(|(physics, keep)| {
            let (mut own, mut other) = (self.own[a], self.other[b]);
            if physics.viscosity.beta == 0.0 {
                P::still(&mut own, &mut other);
            }
            for (coefficient, keep) in P::coefficients(&mut own, &mut other).into_iter().zip(keep) {
                *coefficient *= keep;
            }
            P::sums(&P::of(physics).pair(&own, &other, &self.between(a, b))).0
        })
    }

    /// The sum of the magnitudes of the parts.
    pub fn size(&self, a: usize, b: usize) -> f64 {
        self.parts(a, b).iter().map(|part| part.norm()).sum()
    }
}

/// With equal masses and no crossed form the two see the same numbers with the opposite sign, operation by operation:
/// `x_ab` is exactly antisymmetric, and all that is added is added in twos. So the forces mirror each other to the
/// last bit.
fn equal_masses_mirror_exactly<P: LastSweep<D>, const D: usize>(physics: Physics) {
    let cloud = Recipe { mass_spread: 1.0, jitter: 0.3, ..Recipe::unequal::<D>(3) }.particles::<D>(true);
    let mut pairs = Pairs::<P, D>::of(&cloud, physics);
    let density = pairs.engine.read_scalar(fields::DENSITY).unwrap();
    let (mut mirrored, mut viscous) = (0, 0);
    for a in 0..cloud.len() {
        for &b in pairs.engine.neighbours().of(a) {
            let b = b as usize;
            let what = format!("{a} and {b} in {D}-D, {physics:?}");
            let (action, reaction) = (pairs.action(a, b), pairs.action(b, a));
            assert_eq!(action.2, reaction.2, "signal velocity of {what}");
            // The viscous force has no crossed form.
            let (friction, back) = (pairs.parts(a, b)[2], pairs.parts(b, a)[2]);
            assert_eq!(friction, -back, "viscosity of {what}");
            viscous += usize::from(friction.norm() > 0.0);
            if (density[a] - density[b]).abs() < 0.0999 * (density[a] + density[b]) {
                assert_eq!(action.0, -reaction.0, "force of {what}");
                mirrored += 1;
            }
        }
    }
    assert!(
        mirrored > cloud.len() && viscous > cloud.len(),
        "{mirrored} without crossed form, {viscous} with viscosity"
    );
}

/// Otherwise `m_a m_b` is multiplied in two orders, and the crossed weight of one side is the inverse of the other's
/// but for its rounding: at most a dozen roundings of each part. (Parts may cancel, so an ulp of the sum would be the
/// wrong measure.)
fn unequal_masses_mirror_to_rounding<P: LastSweep<D>, const D: usize>(physics: Physics) {
    let cloud = Recipe::unequal::<D>(9).particles::<D>(true);
    let pairs = Pairs::<P, D>::of(&cloud, physics);
    let mass = |i: usize| cloud.particles()[i].mass;
    let mut worst = 0.0_f64;
    for a in 0..cloud.len() {
        for &b in pairs.engine.neighbours().of(a) {
            let b = b as usize;
            let (action, reaction) = (pairs.action(a, b).0.scale(mass(a)), pairs.action(b, a).0.scale(mass(b)));
            let bound = 12.0 * UNIT * pairs.size(a, b) * mass(a);
            let error = (action + reaction).norm();
            assert_close(&format!("m_a a_ab + m_b a_ba of {a} and {b} in {D}-D, {physics:?}"), error, 0.0, bound);
            worst = worst.max(if bound > 0.0 { error / bound } else { 0.0 });
        }
    }
    println!("worst error over tolerance: {worst}");
}

#[test]
fn action_is_reaction() {
    for physics in all_physics() {
        with_last_sweep!(physics, equal_masses_mirror_exactly::<1>(physics));
        with_last_sweep!(physics, equal_masses_mirror_exactly::<2>(physics));
        with_last_sweep!(physics, equal_masses_mirror_exactly::<3>(physics));
        with_last_sweep!(physics, unequal_masses_mirror_to_rounding::<1>(physics));
        with_last_sweep!(physics, unequal_masses_mirror_to_rounding::<2>(physics));
        with_last_sweep!(physics, unequal_masses_mirror_to_rounding::<3>(physics));
    }
}

/// A scheme that reconstructs, told to reconstruct nothing, is the plain one to the last bit.
#[test]
fn no_reconstruction_is_plain_viscosity() {
    let cloud = Recipe::unequal::<3>(12).particles::<3>(true);
    let plain = crate::physics(Dissipation::Av, GradH::Corrected);
    let mut engine = run(&cloud, crate::physics(Dissipation::AvSlr, GradH::Corrected));
    let rates = |with: &mut PlainEngine<f64, 3>, reconstruct: bool| {
        match reconstruct {
            true => with.run_pass(&ReconstructedMomentum(plain)).unwrap(),
            false => with.run_pass(&Momentum(plain)).unwrap(),
        }
        let mut all = with.read_all(fields::ACCELERATION).unwrap();
        all.push(with.read_scalar(fields::ENERGY_RATE).unwrap());
        all
    };
    let before = engine.read_all(fields::ACCELERATION).unwrap();
    let none = rates(&mut engine, true);
    assert_eq!(none, rates(&mut engine, false));
    assert_ne!(none[..3], before[..], "reconstruction makes a difference");
}
