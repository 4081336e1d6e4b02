//! The first sweep: plain density, and from it the estimator of the volume elements.

use super::Physics;
use crate::equations::kernels::{central_value, inverse_volume, kernel_shape};
use crate::equations::volume_elements::volume_estimator;
use crate::fields::*;
use etalon_kernels_gen::{Pass, Real, Scalar, Separation, record};

/// `rho^0_a = sum m_b W_ab(h_a)` and `X_a = m_a / rho^0_a` (C25 20). Also leaves `1/h` for the later sweeps.
#[derive(Clone, Copy, Debug)]
pub struct VolumeElements(pub Physics);

record! {
    /// Read of the particle.
    pub struct VolumeElementsOwn {
        mass: Scalar = MASS,
        h: Scalar = SMOOTHING_LENGTH,
    }
}
record! {
    /// Read of a neighbour.
    pub struct VolumeElementsOther { mass: Scalar = MASS }
}
record! {
    /// Summed.
    pub struct VolumeElementsSums { standard_density: Scalar = STANDARD_DENSITY }
}
record! {
    /// Written.
    pub struct VolumeElementsOut {
        inverse_h: Scalar = INVERSE_SMOOTHING_LENGTH,
        standard_density: Scalar = STANDARD_DENSITY,
        estimator: Scalar = VOLUME_ESTIMATOR,
    }
}

impl<const D: usize> Pass<D> for VolumeElements {
    type Own<R: Real> = VolumeElementsOwn<R, D>;
    type Other<R: Real> = VolumeElementsOther<R, D>;
    type Sums<R: Real> = VolumeElementsSums<R, D>;
    type Out<R: Real> = VolumeElementsOut<R, D>;
    const NAME: &'static str = "volume_elements";

    #[inline(always)]
    fn pair<R: Real>(&self, own: &Self::Own<R>, other: &Self::Other<R>, at: &Separation<R, D>) -> Self::Sums<R> {
        let inverse_h = R::one() / own.h;
        let shape = kernel_shape::<R, D>(self.0.kernel, at.r_squared * (inverse_h * inverse_h));
        VolumeElementsSums { standard_density: other.mass * shape.value }
    }

    #[inline(always)]
    fn finish<R: Real>(&self, own: &Self::Own<R>, sums: &Self::Sums<R>) -> Self::Out<R> {
        let inverse_h = R::one() / own.h;
        let with_self = sums.standard_density + own.mass * central_value::<R, D>(self.0.kernel);
        let standard_density = with_self * inverse_volume::<R, D>(inverse_h);
        VolumeElementsOut { inverse_h, standard_density, estimator: volume_estimator(own.mass, standard_density) }
    }
}
