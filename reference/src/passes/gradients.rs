//! The third sweep: what gradients need, the grad-h factor, and the coefficient of the pressure force.

use super::Physics;
use super::gradient_vector::{gradient_scale, weight};
use crate::equations::dissipation::{balsara_limiter, wave_aware_limiter};
use crate::equations::grad_h::{
    density_derivative_corrected, density_derivative_exact, grad_h_factor, partition_derivative_term,
};
use crate::equations::gradients::{gradient, integral_term, inverse_moments, moment_term};
use crate::equations::hydrodynamics::pressure_coefficient;
use crate::equations::kernels::{Shape, central_value, inverse_volume, kernel_shape, smoothing_length_derivative};
use crate::fields::*;
use crate::schemes::{GradH, Gradients as Way, VolumeElement};
use etalon_kernels_gen::{Field, Matrix, Part, Pass, Real, Scalar, Separation, Symmetric, Vector, record};

/// The trace of the moment matrix in units of `h^2` below which a particle has no neighbours to speak of: one alone, half-way to the
/// edge, makes 0.1.
pub(super) const SMALLEST_SPREAD: f64 = 1e-20;

/// The inverse moment matrix `c` (C25 1, 2) where gradients are integral ones, Omega (C25 24; 31, or 29 for standard volume elements) and the
/// pressure coefficient (C25 22).
#[derive(Clone, Copy, Debug)]
pub struct Gradients(pub Physics);

/// [`Gradients`], with the velocity gradient (C25 3, or 4 with the kernel's gradient) and Balsara's limiter (GS25 8, or 28) besides.
#[derive(Clone, Copy, Debug)]
pub struct VelocityGradients(pub Physics);

record! {
    /// Read of the particle.
    pub struct GradientsOwn {
        mass: Scalar = MASS,
        inverse_h: Scalar = INVERSE_SMOOTHING_LENGTH,
        standard_density: Scalar = STANDARD_DENSITY,
        estimator: Scalar = VOLUME_ESTIMATOR,
        normalisation: Scalar = KERNEL_NORMALISATION,
        density: Scalar = DENSITY,
        pressure: Scalar = PRESSURE,
        estimator_derivative: Scalar = VOLUME_ESTIMATOR_DERIVATIVE,
        density_derivative: Scalar = STANDARD_DENSITY_DERIVATIVE,
    }
}
record! {
    /// Read of a neighbour.
    pub struct GradientsOther { volume: Scalar = VOLUME }
}
record! {
    /// Summed, without the powers of `h_a` common to all terms.
    pub struct GradientsSums {
        moments: Symmetric = MOMENT_MATRIX,
        partition_derivative: Scalar = PARTITION_DERIVATIVE,
    }
}
record! {
    /// Written.
    pub struct GradientsOut {
        c: Symmetric = GRADIENT_MATRIX,
        grad_h: Scalar = GRAD_H,
        pressure_coefficient: Scalar = PRESSURE_COEFFICIENT,
    }
}
record! {
    /// Read of the particle.
    pub struct VelocityGradientsOwn {
        base: GradientsOwn,
        velocity: Vector = VELOCITY,
        sound_speed: Scalar = SOUND_SPEED,
    }
}
record! {
    /// Read of a neighbour.
    pub struct VelocityGradientsOther {
        base: GradientsOther,
        velocity: Vector = VELOCITY,
    }
}
record! {
    /// Summed.
    pub struct VelocityGradientsSums {
        base: GradientsSums,
        velocity_moments: Matrix = VELOCITY_MOMENT,
    }
}
record! {
    /// Written.
    pub struct VelocityGradientsOut {
        base: GradientsOut,
        strain_rate: Symmetric = STRAIN_RATE,
        balsara: Scalar = BALSARA,
    }
}

impl Gradients {
    /// The kernel's shape as the particle sees the neighbour.
    #[inline(always)]
    fn shape<R: Real, const D: usize>(&self, own: &GradientsOwn<R, D>, at: &Separation<R, D>) -> (Shape<R>, R) {
        let q_squared = at.r_squared * (own.inverse_h * own.inverse_h);
        (kernel_shape::<R, D>(self.0.kernel, q_squared), q_squared)
    }

    #[inline(always)]
    fn terms<R: Real, const D: usize>(
        &self,
        other: &GradientsOther<R, D>,
        at: &Separation<R, D>,
        (shape, q_squared): (Shape<R>, R),
    ) -> GradientsSums<R, D> {
        let partition_derivative = match self.0.grad_h {
            GradH::Exact => R::zero(),
            GradH::Corrected => {
                partition_derivative_term(other.volume, smoothing_length_derivative::<R, D>(shape, q_squared))
            }
        };
        // The second moments are the same for x_ab and -x_ab.
        let moments = match self.0.gradients {
            Way::Integral => moment_term(other.volume, at.x_ab, shape.value),
            Way::Kernel => Symmetric::zero(),
        };
        GradientsSums { moments, partition_derivative }
    }

    #[inline(always)]
    fn density_derivative<R: Real, const D: usize>(&self, own: &GradientsOwn<R, D>, partition_sum: R) -> R {
        let kernel = self.0.kernel;
        let scale = inverse_volume::<R, D>(own.inverse_h);
        let self_kernel = central_value::<R, D>(kernel) * scale;
        match (self.0.volume_element, self.0.grad_h) {
            (VolumeElement::Standard, GradH::Exact) => {
                own.density_derivative + own.mass * self.self_derivative(own, scale)
            }
            // (29) in its two sums: what one neighbour gives to their difference is `plain_density_derivative_term`, which asks for its density.
            // The self terms cancel.
            (VolumeElement::Standard, GradH::Corrected) => own.density_derivative - own.density * partition_sum,
            (VolumeElement::Generalised, GradH::Exact) => {
                let self_d = self.self_derivative(own, scale);
                density_derivative_exact(
                    own.mass,
                    own.estimator,
                    own.normalisation,
                    own.estimator_derivative,
                    own.density_derivative,
                    self_kernel,
                    self_d,
                )
            }
            (VolumeElement::Generalised, GradH::Corrected) => density_derivative_corrected(
                own.mass,
                own.estimator,
                own.normalisation,
                own.density,
                own.estimator_derivative,
                own.density_derivative,
                partition_sum,
                self_kernel,
            ),
        }
    }

    /// `D_aa`, of the particle itself.
    #[inline(always)]
    fn self_derivative<R: Real, const D: usize>(&self, own: &GradientsOwn<R, D>, scale: R) -> R {
        let shape = Shape { value: central_value::<R, D>(self.0.kernel), slope_over_q: R::zero() };
        smoothing_length_derivative::<R, D>(shape, R::zero()) * scale * own.inverse_h
    }

    /// What the sums make of the moment matrix's inverse; nothing where no gradient asks for it.
    #[inline(always)]
    fn inverse_moments<R: Real, const D: usize>(
        &self,
        own: &GradientsOwn<R, D>,
        sums: &GradientsSums<R, D>,
        scale: R,
    ) -> Symmetric<R, D> {
        match self.0.gradients {
            Way::Kernel => Symmetric::zero(),
            Way::Integral => {
                // Neighbours that all but touch the edge of the support have no weight to speak of. In single precision the inverse of
                // their moments would overflow; they count as none.
                let spread = sums.moments.trace() * scale * (own.inverse_h * own.inverse_h);
                let weight = R::pick(spread.gt(R::lit(SMALLEST_SPREAD)), scale, R::zero());
                inverse_moments(sums.moments.scale(weight))
            }
        }
    }
}

impl<const D: usize> Pass<D> for Gradients {
    type Own<R: Real> = GradientsOwn<R, D>;
    type Other<R: Real> = GradientsOther<R, D>;
    type Sums<R: Real> = GradientsSums<R, D>;
    type Out<R: Real> = GradientsOut<R, D>;
    const NAME: &'static str = "gradients";

    fn uses(&self, _: Part, field: Field) -> bool {
        self.0.knows(field)
    }

    #[inline(always)]
    fn pair<R: Real>(&self, own: &Self::Own<R>, other: &Self::Other<R>, at: &Separation<R, D>) -> Self::Sums<R> {
        self.terms(other, at, self.shape(own, at))
    }

    #[inline(always)]
    fn finish<R: Real>(&self, own: &Self::Own<R>, sums: &Self::Sums<R>) -> Self::Out<R> {
        let scale = inverse_volume::<R, D>(own.inverse_h);
        let partition_sum = sums.partition_derivative * scale * own.inverse_h;
        let derivative = self.density_derivative(own, partition_sum);
        let grad_h = grad_h_factor::<R, D>(R::one() / own.inverse_h, own.density, derivative);
        let (normalisation, standard_density) = match self.0.volume_element {
            VolumeElement::Standard => (R::one(), own.density),
            VolumeElement::Generalised => (own.normalisation, own.standard_density),
        };
        GradientsOut {
            c: self.inverse_moments(own, sums, scale),
            grad_h,
            pressure_coefficient: pressure_coefficient(own.pressure, grad_h, normalisation, standard_density),
        }
    }
}

impl<const D: usize> Pass<D> for VelocityGradients {
    type Own<R: Real> = VelocityGradientsOwn<R, D>;
    type Other<R: Real> = VelocityGradientsOther<R, D>;
    type Sums<R: Real> = VelocityGradientsSums<R, D>;
    type Out<R: Real> = VelocityGradientsOut<R, D>;
    const NAME: &'static str = "velocity_gradients";

    fn uses(&self, _: Part, field: Field) -> bool {
        self.0.knows(field)
    }

    #[inline(always)]
    fn pair<R: Real>(&self, own: &Self::Own<R>, other: &Self::Other<R>, at: &Separation<R, D>) -> Self::Sums<R> {
        let plain = Gradients(self.0);
        let (shape, q_squared) = plain.shape(&own.base, at);
        let v_ba = other.velocity - own.velocity;
        VelocityGradientsSums {
            base: plain.terms(&other.base, at, (shape, q_squared)),
            velocity_moments: integral_term(other.base.volume, v_ba, -at.x_ab, weight(&self.0, shape)),
        }
    }

    #[inline(always)]
    fn finish<R: Real>(&self, own: &Self::Own<R>, sums: &Self::Sums<R>) -> Self::Out<R> {
        let base = Gradients(self.0).finish(&own.base, &sums.base);
        let scale = gradient_scale::<R, D>(&self.0, own.base.inverse_h);
        let integral = sums.velocity_moments.scale(scale);
        let jacobian = match self.0.gradients {
            Way::Integral => gradient(integral, base.c),
            Way::Kernel => integral,
        };
        let viscosity = &self.0.viscosity;
        let (divergence, curl) = (jacobian.trace(), curl(jacobian));
        let balsara = if viscosity.dissipation.knows_waves() {
            let frequency = R::lit(viscosity.angular_frequency());
            wave_aware_limiter(divergence, curl, own.sound_speed, own.base.inverse_h, frequency)
        } else {
            balsara_limiter(divergence, curl, own.sound_speed, own.base.inverse_h)
        };
        VelocityGradientsOut { base, strain_rate: jacobian.symmetric_part(), balsara }
    }
}

/// The size of the velocity's curl, from its gradient; zero in one dimension.
#[inline(always)]
fn curl<R: Real, const D: usize>(jacobian: Matrix<R, D>) -> R {
    let rotation = |i: usize, j: usize| jacobian.0[i][j] - jacobian.0[j][i];
    match D {
        1 => R::zero(),
        2 => rotation(1, 0).abs(),
        _ => {
            let (x, y, z) = (rotation(2, 1), rotation(0, 2), rotation(1, 0));
            x.mul_add(x, y.mul_add(y, z * z)).sqrt()
        }
    }
}
