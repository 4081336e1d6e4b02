//! The time-dependent viscosity coefficient (GS25 9, 10): a sweep that raises it, and an update that lets it decay.

use super::Physics;
use super::gradient_vector::{gradient_scale, weight};
use crate::equations::gradients::gradient_term;
use crate::equations::kernels::kernel_shape;
use crate::equations::switch::{convergence_indicator, decayed_coefficient, local_coefficient, raised_coefficient};
use crate::fields::*;
use crate::schemes::Gradients;
use etalon_kernels_gen::{Field, Part, Pass, Real, Scalar, Separation, Symmetric, Update, Vector, record};

/// The gradient of `div v` and from it the coefficient that the flow asks for (GS25 9); the particle's rises to it at once.
///
/// The estimator is the paper's: one more sweep of differences, `c sum V_b (div v_b - div v_a) x_ba W_ab(h_a)` (C25 1, 3), exact
/// for a divergence that is linear in the position; with kernel gradients, `sum V_b (div v_b - div v_a) grad_a W_ab`. It cannot be had in the sweep before, which makes `div v` in the first place.
/// `div v` is the trace of the strain rate, so no field is carried for it.
#[derive(Clone, Copy, Debug)]
pub struct Switch(pub Physics);

/// The decay of the coefficient over a step (GS25 10), with the target and the decay time of the step's start held.
///
/// First order in the step, where the coefficient falls; it rises with the flow, without delay.
#[derive(Clone, Copy, Debug)]
pub struct Decay(pub Physics);

record! {
    /// Read of the particle.
    pub struct SwitchOwn {
        inverse_h: Scalar = INVERSE_SMOOTHING_LENGTH,
        c: Symmetric = GRADIENT_MATRIX,
        strain_rate: Symmetric = STRAIN_RATE,
        sound_speed: Scalar = SOUND_SPEED,
        remaining: Scalar = REMAINING_ALPHA,
    }
}
record! {
    /// Read of a neighbour.
    pub struct SwitchOther {
        volume: Scalar = VOLUME,
        strain_rate: Symmetric = STRAIN_RATE,
    }
}
record! {
    /// Summed, without the powers of `h_a` common to all terms.
    pub struct SwitchSums { divergence_moment: Vector = DIVERGENCE_MOMENT }
}
record! {
    /// Written.
    pub struct SwitchOut {
        local: Scalar = LOCAL_ALPHA,
        alpha: Scalar = ALPHA,
    }
}
record! {
    /// Read.
    pub struct DecayOwn {
        alpha: Scalar = ALPHA,
        local: Scalar = LOCAL_ALPHA,
        rate: Scalar = ALPHA_DECAY_RATE,
    }
}
record! {
    /// Written.
    pub struct DecayOut { remaining: Scalar = REMAINING_ALPHA }
}

impl<const D: usize> Pass<D> for Switch {
    type Own<R: Real> = SwitchOwn<R, D>;
    type Other<R: Real> = SwitchOther<R, D>;
    type Sums<R: Real> = SwitchSums<R, D>;
    type Out<R: Real> = SwitchOut<R, D>;
    const NAME: &'static str = "switch";

    fn uses(&self, _: Part, field: Field) -> bool {
        self.0.knows(field)
    }

    #[inline(always)]
    fn pair<R: Real>(&self, own: &Self::Own<R>, other: &Self::Other<R>, at: &Separation<R, D>) -> Self::Sums<R> {
        let shape = kernel_shape::<R, D>(self.0.kernel, at.r_squared * (own.inverse_h * own.inverse_h));
        let divergence_ba = other.strain_rate.trace() - own.strain_rate.trace();
        // The matrix of A_ab is the same for all neighbours; the epilogue applies it once.
        let towards = (-at.x_ab).scale(weight(&self.0, shape));
        SwitchSums { divergence_moment: gradient_term(other.volume, divergence_ba, towards) }
    }

    #[inline(always)]
    fn finish<R: Real>(&self, own: &Self::Own<R>, sums: &Self::Sums<R>) -> Self::Out<R> {
        let viscosity = &self.0.viscosity;
        let h = R::one() / own.inverse_h;
        let moment = sums.divergence_moment.scale(gradient_scale::<R, D>(&self.0, own.inverse_h));
        let gradient = match self.0.gradients {
            Gradients::Integral => own.c.apply(moment),
            Gradients::Kernel => moment,
        };
        let indicator = convergence_indicator(gradient, h);
        let local = local_coefficient(viscosity, indicator, own.strain_rate.trace(), own.sound_speed, h);
        SwitchOut { local, alpha: raised_coefficient(own.remaining, local) }
    }
}

impl<const D: usize> Update<D> for Decay {
    type Own<R: Real> = DecayOwn<R, D>;
    type Out<R: Real> = DecayOut<R, D>;
    const NAME: &'static str = "decay";

    #[inline(always)]
    fn apply<R: Real>(&self, own: &Self::Own<R>, time_step: R) -> Self::Out<R> {
        let remaining = decayed_coefficient(&self.0.viscosity, own.alpha, own.local, own.rate, time_step);
        DecayOut { remaining }
    }
}
