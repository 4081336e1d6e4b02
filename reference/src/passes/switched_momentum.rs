//! The last sweep with a viscosity coefficient for each particle (GS25 6, 9, 10).

use super::Physics;
use super::momentum::{
    Friction, Line, Momentum, MomentumOut, MomentumOwn, MomentumPair, MomentumSums, Side, reconstructed_omega,
};
use crate::equations::switch::{decay_rate, pair_coefficient};
use crate::fields::*;
use etalon_kernels_gen::{Field, Part, Pass, Real, Scalar, Separation, Symmetric, record};

/// [`Momentum`] with the mean of the two particles' coefficients, and reconstructed velocities (GS25 11-17) where the scheme has them.
///
/// The largest signal velocity is known only here, so the rate at which the coefficients decay (GS25 10) comes from here too.
#[derive(Clone, Copy, Debug)]
pub struct SwitchedMomentum(pub Physics);

record! {
    /// Read of either particle beside what the equations of motion read.
    pub struct SwitchedPair {
        strain_rate: Symmetric = STRAIN_RATE,
        q_crit: Scalar = CRITICAL_SEPARATION,
        alpha: Scalar = ALPHA,
    }
}
record! {
    /// Read of the particle.
    pub struct SwitchedMomentumOwn {
        base: MomentumOwn,
        switched: SwitchedPair,
    }
}
record! {
    /// Read of a neighbour.
    pub struct SwitchedMomentumOther {
        base: MomentumPair,
        switched: SwitchedPair,
    }
}
record! {
    /// Written.
    pub struct SwitchedMomentumOut {
        base: MomentumOut,
        decay_rate: Scalar = ALPHA_DECAY_RATE,
    }
}

impl<R: Real, const D: usize> SwitchedPair<R, D> {
    #[inline(always)]
    fn side(&self, pair: &MomentumPair<R, D>, at: &Separation<R, D>) -> Side<R> {
        Side { slope: self.strain_rate.quadratic_form(at.x_ab), inverse_h: pair.inverse_h, q_crit: self.q_crit }
    }
}

impl<const D: usize> Pass<D> for SwitchedMomentum {
    type Own<R: Real> = SwitchedMomentumOwn<R, D>;
    type Other<R: Real> = SwitchedMomentumOther<R, D>;
    type Sums<R: Real> = MomentumSums<R, D>;
    type Out<R: Real> = SwitchedMomentumOut<R, D>;
    const NAME: &'static str = "switched_momentum";

    fn uses(&self, _: Part, field: Field) -> bool {
        self.0.knows(field)
    }

    #[inline(always)]
    fn pair<R: Real>(&self, own: &Self::Own<R>, other: &Self::Other<R>, at: &Separation<R, D>) -> Self::Sums<R> {
        let (a, b) = (&own.base.pair, &other.base);
        let line = Line::of(a.velocity, b.velocity, at);
        let omega = if self.0.viscosity.dissipation.reconstructs() {
            let sides = [own.switched.side(a, at), other.switched.side(b, at)];
            reconstructed_omega(&self.0.viscosity, &line, sides, R::one())
        } else {
            line.omega
        };
        let alpha = pair_coefficient(own.switched.alpha, other.switched.alpha);
        Momentum(self.0).forces(a, b, at, &line, Friction { omega, alpha, limiter: None })
    }

    #[inline(always)]
    fn finish<R: Real>(&self, own: &Self::Own<R>, sums: &Self::Sums<R>) -> Self::Out<R> {
        let base = Momentum(self.0).finish(&own.base, sums);
        let signal = Momentum::largest_signal(&own.base, sums);
        SwitchedMomentumOut { base, decay_rate: decay_rate(signal, own.base.pair.inverse_h) }
    }
}
