//! The second sweep: volume elements, density, state of the gas, and the sums that grad-h needs.

use super::Physics;
use crate::equations::equation_of_state::{pressure, sound_speed};
use crate::equations::kernels::{central_value, inverse_volume, kernel_shape, smoothing_length_derivative};
use crate::equations::reconstruction::{critical_separation, support_volume};
use crate::equations::smoothing_length::effective_neighbours;
use crate::equations::volume_elements::{density, volume_element};
use crate::fields::*;
use crate::schemes::VolumeElement;
use etalon_kernels_gen::{Field, Part, Pass, Real, Scalar, Separation, record};

/// `k_a = sum X_b W_ab(h_a)` (C25 19), density (C25 21), pressure and sound speed; the derivatives with respect to `h_a` of both sums.
///
/// Standard volume elements are those of `X = m`: then `k` is the density `sum m_b W_ab(h_a)` and `X/k = m/rho`. This is the first sweep then, and
/// makes `1/h` too.
#[derive(Clone, Copy, Debug)]
pub struct Density(pub Physics);

record! {
    /// Read of the particle.
    pub struct DensityOwn {
        mass: Scalar = MASS,
        h: Scalar = SMOOTHING_LENGTH,
        inverse_h: Scalar = INVERSE_SMOOTHING_LENGTH,
        estimator: Scalar = VOLUME_ESTIMATOR,
        internal_energy: Scalar = INTERNAL_ENERGY,
    }
}
record! {
    /// Read of a neighbour.
    pub struct DensityOther {
        mass: Scalar = MASS,
        estimator: Scalar = VOLUME_ESTIMATOR,
    }
}
record! {
    /// Summed, without the powers of `h_a` common to all terms.
    pub struct DensitySums {
        normalisation: Scalar = KERNEL_NORMALISATION,
        estimator_derivative: Scalar = VOLUME_ESTIMATOR_DERIVATIVE,
        density_derivative: Scalar = STANDARD_DENSITY_DERIVATIVE,
    }
}
record! {
    /// Written.
    pub struct DensityOut {
        inverse_h: Scalar = INVERSE_SMOOTHING_LENGTH,
        normalisation: Scalar = KERNEL_NORMALISATION,
        volume: Scalar = VOLUME,
        density: Scalar = DENSITY,
        pressure: Scalar = PRESSURE,
        sound_speed: Scalar = SOUND_SPEED,
        critical_separation: Scalar = CRITICAL_SEPARATION,
        estimator_derivative: Scalar = VOLUME_ESTIMATOR_DERIVATIVE,
        density_derivative: Scalar = STANDARD_DENSITY_DERIVATIVE,
    }
}

impl Density {
    /// `1/h`, which the sweep before has where there is one.
    #[inline(always)]
    fn inverse_h<R: Real, const D: usize>(&self, own: &DensityOwn<R, D>) -> R {
        match self.0.volume_element {
            VolumeElement::Standard => R::one() / own.h,
            VolumeElement::Generalised => own.inverse_h,
        }
    }
}

impl<const D: usize> Pass<D> for Density {
    type Own<R: Real> = DensityOwn<R, D>;
    type Other<R: Real> = DensityOther<R, D>;
    type Sums<R: Real> = DensitySums<R, D>;
    type Out<R: Real> = DensityOut<R, D>;
    const NAME: &'static str = "density";

    fn uses(&self, part: Part, field: Field) -> bool {
        let first = self.0.volume_element == VolumeElement::Standard;
        match (part, field) {
            (Part::Own, SMOOTHING_LENGTH) | (Part::Out, INVERSE_SMOOTHING_LENGTH) => first,
            (Part::Own, INVERSE_SMOOTHING_LENGTH) => !first,
            (Part::Sums, KERNEL_NORMALISATION) => true,
            _ => self.0.knows(field),
        }
    }

    #[inline(always)]
    fn pair<R: Real>(&self, own: &Self::Own<R>, other: &Self::Other<R>, at: &Separation<R, D>) -> Self::Sums<R> {
        let inverse_h = self.inverse_h(own);
        let q_squared = at.r_squared * (inverse_h * inverse_h);
        let shape = kernel_shape::<R, D>(self.0.kernel, q_squared);
        let derivative = smoothing_length_derivative::<R, D>(shape, q_squared);
        let (estimator, estimator_derivative) = match self.0.volume_element {
            VolumeElement::Standard => (other.mass, R::zero()),
            VolumeElement::Generalised => (other.estimator, other.estimator * derivative),
        };
        DensitySums {
            normalisation: estimator * shape.value,
            estimator_derivative,
            density_derivative: other.mass * derivative,
        }
    }

    #[inline(always)]
    fn finish<R: Real>(&self, own: &Self::Own<R>, sums: &Self::Sums<R>) -> Self::Out<R> {
        let inverse_h = self.inverse_h(own);
        let scale = inverse_volume::<R, D>(inverse_h);
        let derivative_scale = scale * inverse_h;
        let estimator = match self.0.volume_element {
            VolumeElement::Standard => own.mass,
            VolumeElement::Generalised => own.estimator,
        };
        let with_self = sums.normalisation + estimator * central_value::<R, D>(self.0.kernel);
        let normalisation = with_self * scale;
        let volume = volume_element(estimator, normalisation);
        let density = match self.0.volume_element {
            VolumeElement::Standard => normalisation,
            VolumeElement::Generalised => density(own.mass, volume),
        };
        let ball = R::lit(support_volume(D, self.0.kernel.support()));
        let neighbours = effective_neighbours::<R, D>(inverse_h, volume, ball);
        let gamma_minus_one = R::lit(self.0.gamma_minus_one);
        DensityOut {
            inverse_h,
            normalisation,
            volume,
            density,
            pressure: pressure(gamma_minus_one, density, own.internal_energy),
            sound_speed: sound_speed(gamma_minus_one, own.internal_energy),
            critical_separation: critical_separation::<R, D>(neighbours, ball),
            estimator_derivative: sums.estimator_derivative * derivative_scale,
            density_derivative: sums.density_derivative * derivative_scale,
        }
    }
}
