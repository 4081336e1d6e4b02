//! The time integration, particle by particle.

use super::Physics;
use crate::equations::reconstruction::support_volume;
use crate::equations::smoothing_length::{effective_neighbours, next_smoothing_length, settled_smoothing_length};
use crate::fields::*;
use etalon_kernels_gen::{Real, Scalar, Update, Vector, record};

/// The first half of a kick-drift-kick step: half a kick, the drift, and the other half foretold with the old rates.
///
/// `v_half = v + a dt/2`, `dx = v_half dt`, and `v = v_half + a dt/2`, `u` likewise, for the forces at the step's end, which depend on the
/// velocity. The smoothing length takes its next value here too.
#[derive(Clone, Copy, Debug)]
pub struct KickDrift(pub Physics);

/// The second half: what was foretold with the old rates is corrected to the mean of old and new, `v += (a_new - a_old) dt/2`.
#[derive(Clone, Copy, Debug)]
pub struct Correct;

record! {
    /// Read.
    pub struct KickDriftOwn {
        h: Scalar = SMOOTHING_LENGTH,
        settled: Scalar = SETTLED_SMOOTHING_LENGTH,
        inverse_h: Scalar = INVERSE_SMOOTHING_LENGTH,
        volume: Scalar = VOLUME,
        grad_h: Scalar = GRAD_H,
        mobility: Scalar = MOBILITY,
        velocity: Vector = VELOCITY,
        internal_energy: Scalar = INTERNAL_ENERGY,
        acceleration: Vector = ACCELERATION,
        energy_rate: Scalar = ENERGY_RATE,
    }
}
record! {
    /// Written.
    pub struct KickDriftOut {
        h: Scalar = SMOOTHING_LENGTH,
        settled: Scalar = SETTLED_SMOOTHING_LENGTH,
        velocity: Vector = VELOCITY,
        internal_energy: Scalar = INTERNAL_ENERGY,
        previous_acceleration: Vector = PREVIOUS_ACCELERATION,
        previous_energy_rate: Scalar = PREVIOUS_ENERGY_RATE,
        displacement: Vector = DISPLACEMENT,
    }
}
record! {
    /// Read.
    pub struct CorrectOwn {
        velocity: Vector = VELOCITY,
        internal_energy: Scalar = INTERNAL_ENERGY,
        acceleration: Vector = ACCELERATION,
        energy_rate: Scalar = ENERGY_RATE,
        previous_acceleration: Vector = PREVIOUS_ACCELERATION,
        previous_energy_rate: Scalar = PREVIOUS_ENERGY_RATE,
    }
}
record! {
    /// Written.
    pub struct CorrectOut {
        velocity: Vector = VELOCITY,
        internal_energy: Scalar = INTERNAL_ENERGY,
    }
}

impl<const D: usize> Update<D> for KickDrift {
    type Own<R: Real> = KickDriftOwn<R, D>;
    type Out<R: Real> = KickDriftOut<R, D>;
    const NAME: &'static str = "kick_drift";

    #[inline(always)]
    fn apply<R: Real>(&self, own: &Self::Own<R>, time_step: R) -> Self::Out<R> {
        let half = R::lit(0.5) * time_step;
        let half_kick = own.acceleration.scale(half);
        let middle = own.velocity + half_kick;
        let ball = R::lit(support_volume(D, self.0.kernel.support()));
        let neighbours = effective_neighbours::<R, D>(own.inverse_h, own.volume, ball);
        let settled = settled_smoothing_length::<R, D>(own.h, neighbours, R::lit(self.0.neighbours), own.grad_h);
        // A wall does not change, and at its outer edge neighbours are missing that were never there: it keeps its smoothing length.
        let moves = own.mobility.gt(R::zero());
        KickDriftOut {
            h: R::pick(moves, next_smoothing_length(settled, own.settled), own.h),
            settled,
            velocity: middle + half_kick,
            internal_energy: own.energy_rate.mul_add(time_step, own.internal_energy),
            previous_acceleration: own.acceleration,
            previous_energy_rate: own.energy_rate,
            displacement: middle.scale(time_step * own.mobility),
        }
    }
}

impl<const D: usize> Update<D> for Correct {
    type Own<R: Real> = CorrectOwn<R, D>;
    type Out<R: Real> = CorrectOut<R, D>;
    const NAME: &'static str = "correct";

    #[inline(always)]
    fn apply<R: Real>(&self, own: &Self::Own<R>, time_step: R) -> Self::Out<R> {
        let half = R::lit(0.5) * time_step;
        let change = own.acceleration - own.previous_acceleration;
        CorrectOut {
            velocity: own.velocity + change.scale(half),
            internal_energy: (own.energy_rate - own.previous_energy_rate).mul_add(half, own.internal_energy),
        }
    }
}
