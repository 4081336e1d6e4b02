//! The last sweep: acceleration, heating and the time step.

use super::Physics;
use super::gradient_vector::gradient_vector;
use crate::equations::dissipation::{
    approach_velocity, limited_viscosity, linear_coefficient, pair_balsara, pair_viscosity, regularised_approach,
    signal_velocity,
};
use crate::equations::hydrodynamics::{
    crossed_weight, pressure_acceleration, pressure_work, viscous_acceleration, viscous_heating,
};
use crate::equations::reconstruction::{
    pair_separation, reconstructed_approach_velocity, reconstruction_share, short_range_factor, slope_limiter,
};
use crate::equations::time_step::{acceleration_step, cooling_step, courant_step};
use crate::fields::*;
use crate::schemes::{ApproachForm, Dissipation, Viscosity, VolumeElement};
use etalon_kernels_gen::functions::{larger, ratio_or_zero, smaller};
use etalon_kernels_gen::{Field, Part, Pass, Real, Scalar, Separation, Symmetric, Vector, record};

/// The equations of motion (C25 22, 23) with the viscosity of the true velocities (GS25 6).
#[derive(Clone, Copy, Debug)]
pub struct Momentum(pub Physics);

/// [`Momentum`] with what velocity gradients allow: reconstructed velocities in the viscosity (GS25 11-19, 27, 28), or Balsara's limiter on
/// the viscosity itself (GS25 7).
#[derive(Clone, Copy, Debug)]
pub struct ReconstructedMomentum(pub Physics);

record! {
    /// Read of either particle.
    pub struct MomentumPair {
        mass: Scalar = MASS,
        inverse_h: Scalar = INVERSE_SMOOTHING_LENGTH,
        velocity: Vector = VELOCITY,
        density: Scalar = DENSITY,
        standard_density: Scalar = STANDARD_DENSITY,
        sound_speed: Scalar = SOUND_SPEED,
        pressure_coefficient: Scalar = PRESSURE_COEFFICIENT,
        c: Symmetric = GRADIENT_MATRIX,
    }
}
record! {
    /// Read of either particle when velocities are reconstructed.
    pub struct ReconstructionPair {
        strain_rate: Symmetric = STRAIN_RATE,
        balsara: Scalar = BALSARA,
        q_crit: Scalar = CRITICAL_SEPARATION,
    }
}
record! {
    /// Read of the particle by the epilogue.
    pub struct MomentumEpilogue {
        internal_energy: Scalar = INTERNAL_ENERGY,
        mobility: Scalar = MOBILITY,
    }
}
record! {
    /// Read of the particle.
    pub struct MomentumOwn {
        pair: MomentumPair,
        epilogue: MomentumEpilogue,
    }
}
record! {
    /// Read of the particle.
    pub struct ReconstructedMomentumOwn {
        base: MomentumOwn,
        reconstruction: ReconstructionPair,
    }
}
record! {
    /// Read of a neighbour.
    pub struct ReconstructedMomentumOther {
        base: MomentumPair,
        reconstruction: ReconstructionPair,
    }
}
record! {
    /// Summed, the signal velocity maximised.
    pub struct MomentumSums {
        acceleration: Vector = ACCELERATION,
        energy_rate: Scalar = ENERGY_RATE,
        signal_velocity: Scalar = SIGNAL_VELOCITY,
    }
}
record! {
    /// Written.
    pub struct MomentumOut {
        acceleration: Vector = ACCELERATION,
        energy_rate: Scalar = ENERGY_RATE,
        time_step: Scalar = TIME_STEP,
    }
}

/// What the line of centres of a pair looks like.
pub(super) struct Line<R> {
    pub(super) r: R,
    pub(super) inverse_r: R,
    /// The velocity of approach.
    pub(super) omega: R,
}

impl<R: Real> Line<R> {
    #[inline(always)]
    pub(super) fn of<const D: usize>(v_a: Vector<R, D>, v_b: Vector<R, D>, at: &Separation<R, D>) -> Self {
        let r = at.r_squared.sqrt();
        let inverse_r = ratio_or_zero(R::one(), r);
        Line { r, inverse_r, omega: approach_velocity(v_a - v_b, at.x_ab, inverse_r) }
    }
}

/// What the reconstruction takes of one particle of a pair.
pub(super) struct Side<R> {
    /// `x_ab . J x_ab`.
    pub(super) slope: R,
    pub(super) inverse_h: R,
    pub(super) q_crit: R,
}

/// The velocity of approach of the velocities reconstructed half-way, with `share` of the reconstruction left by the scheme.
#[inline(always)]
pub(super) fn reconstructed_omega<R: Real>(viscosity: &Viscosity, line: &Line<R>, sides: [Side<R>; 2], share: R) -> R {
    let [a, b] = sides;
    let limiter = slope_limiter(a.slope, b.slope) * share;
    let inverse_q_fold = R::lit(1.0 / viscosity.q_fold);
    let q = pair_separation(line.r, a.inverse_h, b.inverse_h);
    let phi_ab = limiter * short_range_factor(q, a.q_crit, inverse_q_fold);
    let phi_ba = limiter * short_range_factor(q, b.q_crit, inverse_q_fold);
    reconstructed_approach_velocity(line.omega, phi_ab, a.slope, phi_ba, b.slope, line.inverse_r)
}

/// What a scheme's viscosity is made of, for one pair.
pub(super) struct Friction<R> {
    /// The velocity of approach it is to use.
    pub(super) omega: R,
    /// The linear coefficient.
    pub(super) alpha: R,
    /// What it is multiplied with, if anything.
    pub(super) limiter: Option<R>,
}

impl Momentum {
    /// `Pi_ab` (GS25 4-7).
    #[inline(always)]
    fn viscosity<R: Real, const D: usize>(
        &self,
        a: &MomentumPair<R, D>,
        b: &MomentumPair<R, D>,
        at: &Separation<R, D>,
        line: &Line<R>,
        friction: Friction<R>,
    ) -> R {
        let half = R::lit(0.5);
        let mean_density = half * (a.density + b.density);
        let mean_sound_speed = half * (a.sound_speed + b.sound_speed);
        let approach = match self.0.viscosity.form {
            ApproachForm::Projected => friction.omega,
            ApproachForm::Regularised => {
                let mean_h = half * (R::one() / a.inverse_h + R::one() / b.inverse_h);
                regularised_approach(friction.omega * line.r, at.r_squared, mean_h)
            }
        };
        let beta = R::lit(self.0.viscosity.beta);
        let viscosity = pair_viscosity(friction.alpha, beta, mean_sound_speed, approach, mean_density);
        match friction.limiter {
            Some(balsara) => limited_viscosity(balsara, viscosity),
            None => viscosity,
        }
    }

    /// All that a neighbour does, given what its viscosity is made of.
    #[inline(always)]
    pub(super) fn forces<R: Real, const D: usize>(
        &self,
        a: &MomentumPair<R, D>,
        b: &MomentumPair<R, D>,
        at: &Separation<R, D>,
        line: &Line<R>,
        friction: Friction<R>,
    ) -> MomentumSums<R, D> {
        let x_ba = -at.x_ab;
        let v_ab = a.velocity - b.velocity;
        let gradient_a = gradient_vector(&self.0, a.c, a.inverse_h, x_ba, at.r_squared);
        let gradient_b = gradient_vector(&self.0, b.c, b.inverse_h, x_ba, at.r_squared);
        let mean_gradient = (gradient_a + gradient_b).scale(R::lit(0.5));

        let crossed = match self.0.volume_element {
            VolumeElement::Standard => R::one(),
            VolumeElement::Generalised => crossed_weight(a.density, b.density, a.standard_density, b.standard_density),
        };
        let viscosity = self.viscosity(a, b, at, line, friction);

        let pressure = pressure_acceleration(
            b.mass,
            a.pressure_coefficient,
            b.pressure_coefficient,
            crossed,
            gradient_a,
            gradient_b,
        );
        let work = pressure_work(b.mass, a.pressure_coefficient, crossed, v_ab, gradient_a);
        MomentumSums {
            acceleration: pressure + viscous_acceleration(b.mass, viscosity, mean_gradient),
            energy_rate: work + viscous_heating(b.mass, viscosity, v_ab, mean_gradient),
            signal_velocity: signal_velocity(a.sound_speed, b.sound_speed, R::zero().min(line.omega)),
        }
    }

    /// The largest signal velocity, that between the particle and itself included.
    #[inline(always)]
    pub(super) fn largest_signal<R: Real, const D: usize>(own: &MomentumOwn<R, D>, sums: &MomentumSums<R, D>) -> R {
        let slowest = own.pair.sound_speed + own.pair.sound_speed;
        larger(sums.signal_velocity, slowest)
    }
}

impl<const D: usize> Pass<D> for Momentum {
    type Own<R: Real> = MomentumOwn<R, D>;
    type Other<R: Real> = MomentumPair<R, D>;
    type Sums<R: Real> = MomentumSums<R, D>;
    type Out<R: Real> = MomentumOut<R, D>;
    const NAME: &'static str = "momentum";

    fn uses(&self, _: Part, field: Field) -> bool {
        self.0.knows(field)
    }

    #[inline(always)]
    fn pair<R: Real>(&self, own: &Self::Own<R>, other: &Self::Other<R>, at: &Separation<R, D>) -> Self::Sums<R> {
        let line = Line::of(own.pair.velocity, other.velocity, at);
        let friction = Friction { omega: line.omega, alpha: R::lit(self.0.viscosity.alpha), limiter: None };
        self.forces(&own.pair, other, at, &line, friction)
    }

    #[inline(always)]
    fn finish<R: Real>(&self, own: &Self::Own<R>, sums: &Self::Sums<R>) -> Self::Out<R> {
        let MomentumEpilogue { internal_energy, mobility } = own.epilogue;
        let pulled = match self.0.has_gravity(D) {
            true => sums.acceleration + Vector::from_fn(|axis| R::lit(self.0.gravity[axis])),
            false => sums.acceleration,
        };
        let acceleration = pulled.scale(mobility);
        let energy_rate = sums.energy_rate * mobility;
        let h = R::one() / own.pair.inverse_h;
        // None of the three may hide that another is not a number: by the step a run that has gone wrong stops.
        let of_motion =
            smaller(courant_step(h, Self::largest_signal(own, sums)), acceleration_step(h, acceleration.norm()));
        let time_step = smaller(of_motion, cooling_step(internal_energy, energy_rate));
        MomentumOut { acceleration, energy_rate, time_step }
    }
}

impl<const D: usize> Pass<D> for ReconstructedMomentum {
    type Own<R: Real> = ReconstructedMomentumOwn<R, D>;
    type Other<R: Real> = ReconstructedMomentumOther<R, D>;
    type Sums<R: Real> = MomentumSums<R, D>;
    type Out<R: Real> = MomentumOut<R, D>;
    const NAME: &'static str = "reconstructed_momentum";

    fn uses(&self, _: Part, field: Field) -> bool {
        self.0.knows(field)
    }

    #[inline(always)]
    fn pair<R: Real>(&self, own: &Self::Own<R>, other: &Self::Other<R>, at: &Separation<R, D>) -> Self::Sums<R> {
        let viscosity = &self.0.viscosity;
        let (a, b) = (&own.base.pair, &other.base);
        let (recon_a, recon_b) = (&own.reconstruction, &other.reconstruction);
        let line = Line::of(a.velocity, b.velocity, at);

        let slope_a = recon_a.strain_rate.quadratic_form(at.x_ab);
        let slope_b = recon_b.strain_rate.quadratic_form(at.x_ab);
        let balsara = pair_balsara(recon_a.balsara, recon_b.balsara);
        let omega = if viscosity.dissipation.reconstructs() {
            let sides = [
                Side { slope: slope_a, inverse_h: a.inverse_h, q_crit: recon_a.q_crit },
                Side { slope: slope_b, inverse_h: b.inverse_h, q_crit: recon_b.q_crit },
            ];
            reconstructed_omega(viscosity, &line, sides, reconstruction_share(viscosity, balsara))
        } else {
            line.omega
        };

        let alpha = linear_coefficient(viscosity, balsara);
        let limiter = match viscosity.dissipation {
            Dissipation::AvB => Some(balsara),
            _ => None,
        };
        Momentum(self.0).forces(a, b, at, &line, Friction { omega, alpha, limiter })
    }

    #[inline(always)]
    fn finish<R: Real>(&self, own: &Self::Own<R>, sums: &Self::Sums<R>) -> Self::Out<R> {
        Momentum(self.0).finish(&own.base, sums)
    }
}
