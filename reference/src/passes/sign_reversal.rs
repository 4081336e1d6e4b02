//! A sweep that counts pairs, for the diagnostic GS25 (29); not part of a step.

use super::Physics;
use super::momentum::{Line, ReconstructionPair, Side, reconstructed_omega};
use crate::equations::dissipation::{pair_balsara, sign_is_reversed};
use crate::equations::reconstruction::reconstruction_share;
use crate::fields::*;
use etalon_kernels_gen::{Pass, Real, Scalar, Separation, Vector, record};

/// Counts of each particle how many of its pairs there are, how many approach, and of how many of either the reconstruction turns the sign of
/// the velocity of approach (GS25 29).
#[derive(Clone, Copy, Debug)]
pub struct SignReversal(pub Physics);

record! {
    /// Read of either particle.
    pub struct SignReversalPair {
        inverse_h: Scalar = INVERSE_SMOOTHING_LENGTH,
        velocity: Vector = VELOCITY,
        reconstruction: ReconstructionPair,
    }
}
record! {
    /// Summed and written.
    pub struct SignReversalSums {
        pairs: Scalar = PAIRS,
        approaching: Scalar = APPROACHING_PAIRS,
        reversed: Scalar = REVERSED_PAIRS,
        reversed_approaching: Scalar = REVERSED_APPROACHING_PAIRS,
    }
}

impl<R: Real, const D: usize> SignReversalPair<R, D> {
    #[inline(always)]
    fn side(&self, at: &Separation<R, D>) -> Side<R> {
        let slope = self.reconstruction.strain_rate.quadratic_form(at.x_ab);
        Side { slope, inverse_h: self.inverse_h, q_crit: self.reconstruction.q_crit }
    }
}

impl<const D: usize> Pass<D> for SignReversal {
    type Own<R: Real> = SignReversalPair<R, D>;
    type Other<R: Real> = SignReversalPair<R, D>;
    type Sums<R: Real> = SignReversalSums<R, D>;
    type Out<R: Real> = SignReversalSums<R, D>;
    const NAME: &'static str = "sign_reversal";

    #[inline(always)]
    fn pair<R: Real>(&self, own: &Self::Own<R>, other: &Self::Other<R>, at: &Separation<R, D>) -> Self::Sums<R> {
        let viscosity = &self.0.viscosity;
        let line = Line::of(own.velocity, other.velocity, at);
        let sides = [own.side(at), other.side(at)];
        let balsara = pair_balsara(own.reconstruction.balsara, other.reconstruction.balsara);
        let share = reconstruction_share(viscosity, balsara);
        let reversed = sign_is_reversed(line.omega, reconstructed_omega(viscosity, &line, sides, share));
        let approaches = line.omega.lt(R::zero());
        SignReversalSums {
            pairs: R::one(),
            approaching: R::pick(approaches, R::one(), R::zero()),
            reversed,
            reversed_approaching: R::pick(approaches, reversed, R::zero()),
        }
    }

    #[inline(always)]
    fn finish<R: Real>(&self, _: &Self::Own<R>, sums: &Self::Sums<R>) -> Self::Out<R> {
        *sums
    }
}
