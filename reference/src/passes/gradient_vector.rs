//! The vector that stands for the gradient of a pair's kernel, as the scene chooses.

use super::Physics;
use crate::equations::gradients::integral_gradient;
use crate::equations::kernels::{Shape, inverse_volume, kernel_shape};
use crate::schemes::Gradients;
use etalon_kernels_gen::{Real, Symmetric, Vector};

/// `A_ab(h)` (C25 5), or `grad_a W_ab(h) = h^-(nu+2) (-w'/q) x_ba`; both point to the neighbour. `c` is not looked at for the second.
///
/// Each choice asks for its own part of the kernel's shape: value and slope are not both computed.
#[inline(always)]
pub(super) fn gradient_vector<R: Real, const D: usize>(
    physics: &Physics,
    c: Symmetric<R, D>,
    inverse_h: R,
    x_ba: Vector<R, D>,
    r_squared: R,
) -> Vector<R, D> {
    match physics.gradients {
        Gradients::Integral => {
            let shape = kernel_shape::<R, D>(physics.kernel, r_squared * (inverse_h * inverse_h));
            integral_gradient(c, x_ba, shape.value * inverse_volume::<R, D>(inverse_h))
        }
        Gradients::Kernel => {
            let shape = kernel_shape::<R, D>(physics.kernel, r_squared * (inverse_h * inverse_h));
            x_ba.scale(weight(physics, shape) * gradient_scale::<R, D>(physics, inverse_h))
        }
    }
}

/// What `x_ba` is multiplied with in the terms of a gradient's sum, the same powers of `h` aside for all of them: `W` where the moments' inverse
/// follows, else the slope.
#[inline(always)]
pub(super) fn weight<R: Real>(physics: &Physics, shape: Shape<R>) -> R {
    match physics.gradients {
        Gradients::Integral => shape.value,
        Gradients::Kernel => -shape.slope_over_q,
    }
}

/// Those powers of `h`.
#[inline(always)]
pub(super) fn gradient_scale<R: Real, const D: usize>(physics: &Physics, inverse_h: R) -> R {
    match physics.gradients {
        Gradients::Integral => inverse_volume::<R, D>(inverse_h),
        Gradients::Kernel => inverse_volume::<R, D>(inverse_h) * (inverse_h * inverse_h),
    }
}
