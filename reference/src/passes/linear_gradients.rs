//! The velocity gradient that the drag's reconstruction takes: PL20 (11), (12).

use super::Physics;
use super::gradients::SMALLEST_SPREAD;
use crate::equations::dust_reconstruction::{correction_term, gradient_sum_term, linear_gradient};
use crate::equations::kernels::{inverse_volume, kernel_shape};
use crate::fields::*;
use crate::schemes::VolumeElement;
use etalon_kernels_gen::{Field, Matrix, Part, Pass, Real, Scalar, Separation, Symmetric, Vector, record};

/// `J R = sum` with the kernel's gradients, exact for linear flows; of `J` only the symmetric part is kept.
///
/// (10) has it between the two unit vectors of a pair, where the rest is nothing: six numbers instead of the paper's nine. To be run as
/// [`SameSpecies`](super::SameSpecies).
#[derive(Clone, Copy, Debug)]
pub struct LinearGradients(pub Physics);

record! {
    /// Read of the particle.
    pub struct LinearGradientsOwn {
        inverse_h: Scalar = INVERSE_SMOOTHING_LENGTH,
        standard_density: Scalar = STANDARD_DENSITY,
        density: Scalar = DENSITY,
        velocity: Vector = VELOCITY,
    }
}
record! {
    /// Read of a neighbour.
    pub struct LinearGradientsOther {
        mass: Scalar = MASS,
        velocity: Vector = VELOCITY,
    }
}
record! {
    /// Summed, without the powers of `h_a` common to all terms.
    pub struct LinearGradientsSums {
        sum: Matrix = LINEAR_GRADIENT_SUM,
        correction: Symmetric = CORRECTION_MATRIX,
    }
}
record! {
    /// Written.
    pub struct LinearGradientsOut { strain_rate: Symmetric = LINEAR_STRAIN_RATE }
}

impl<const D: usize> Pass<D> for LinearGradients {
    type Own<R: Real> = LinearGradientsOwn<R, D>;
    type Other<R: Real> = LinearGradientsOther<R, D>;
    type Sums<R: Real> = LinearGradientsSums<R, D>;
    type Out<R: Real> = LinearGradientsOut<R, D>;
    const NAME: &'static str = "linear_gradients";

    fn uses(&self, part: Part, field: Field) -> bool {
        match (part, field) {
            (Part::Own, DENSITY) => self.0.volume_element == VolumeElement::Standard,
            _ => self.0.knows(field),
        }
    }

    #[inline(always)]
    fn pair<R: Real>(&self, own: &Self::Own<R>, other: &Self::Other<R>, at: &Separation<R, D>) -> Self::Sums<R> {
        let shape = kernel_shape::<R, D>(self.0.kernel, at.r_squared * (own.inverse_h * own.inverse_h));
        let (v_ba, r_ba) = (other.velocity - own.velocity, -at.x_ab);
        LinearGradientsSums {
            sum: gradient_sum_term(other.mass, shape.slope_over_q, v_ba, r_ba),
            correction: correction_term(other.mass, shape.slope_over_q, r_ba),
        }
    }

    #[inline(always)]
    fn finish<R: Real>(&self, own: &Self::Own<R>, sums: &Self::Sums<R>) -> Self::Out<R> {
        // grad W = h^-(nu+2) (w'/q) r. Over the density as well, R is about the unit matrix.
        let standard_density = match self.0.volume_element {
            VolumeElement::Standard => own.density,
            VolumeElement::Generalised => own.standard_density,
        };
        let scale = inverse_volume::<R, D>(own.inverse_h) * (own.inverse_h * own.inverse_h) / standard_density;
        let spread = sums.correction.trace() * scale;
        let weight = R::pick(spread.gt(R::lit(SMALLEST_SPREAD)), scale, R::zero());
        let jacobian = linear_gradient(sums.sum.scale(weight), sums.correction.scale(weight));
        LinearGradientsOut { strain_rate: jacobian.symmetric_part() }
    }
}
