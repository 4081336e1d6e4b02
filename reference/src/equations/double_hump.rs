//! Double-humped kernels for drag: `D(r, h) = h^-nu d(q)` with `d` zero at the centre and `nu int r_i r_j / r^2 D dV = delta_ij`.

use crate::equations::kernels::kernel_shape;
use crate::schemes::Kernel;
use etalon_kernels_gen::polynomials::MIXED_SINC_DOUBLE_HUMP;
use etalon_kernels_gen::{Constant, Real, equation};

/// The double-humped partner of a bell kernel at squared distance `q^2`, `d = C q^2 w(q)`, normalised to `int D dV = 1`.
///
/// `C = h^2 / int r^2 W dV = 1 / (nu sigma^2)`, see [`double_hump_factor`]. Coincident particles do not drag each other. `D_ai(h)` of a
/// pair takes the larger of the two smoothing lengths, for the kernel and for `h^-nu`, and is then the same for both.
/// Source: PL20 section 2.2; Laibe & Price 2012a.
#[equation(unnumbered = "the double-humped kernel D of PL20 (4)-(6)")]
pub fn double_hump<R: Real, const D: usize>(kernel: Kernel, q_squared: R) -> R {
    // Far outside of the support powers of q would leave the numbers; at its edge the bell is zero as well.
    let inside = R::lit(kernel.support() * kernel.support()).min(q_squared);
    let bell = kernel_shape::<R, D>(kernel, inside).value;
    R::constant(double_hump_factor::<D>(kernel)) * (inside * bell)
}

/// `C = h^2 / int r^2 W dV` of a bell kernel `W` in `D` dimensions: the inverse of `nu` times its second moment along one axis.
///
/// The moments of the polynomial kernels are fractions (Wendland's with the polynomials of the dimension); that of the mixed sinc
/// kernel is computed in 50 digits by `kernels-gen/coefficients`.
pub const fn double_hump_factor<const D: usize>(kernel: Kernel) -> Constant {
    let factors = match kernel {
        Kernel::MixedSinc => MIXED_SINC_DOUBLE_HUMP,
        Kernel::CubicSpline => ratios([(3.0, 1.0), (49.0, 31.0), (10.0, 9.0)]),
        Kernel::QuinticSpline => ratios([(2.0, 1.0), (2868.0, 2771.0), (5.0, 7.0)]),
        Kernel::WendlandC2 => ratios([(21.0, 8.0), (9.0, 5.0), (5.0, 4.0)]),
        Kernel::WendlandC4 => ratios([(15.0, 4.0), (33.0, 14.0), (13.0, 8.0)]),
        Kernel::WendlandC6 => ratios([(39.0, 8.0), (35.0, 12.0), (2.0, 1.0)]),
    };
    factors[D - 1]
}

/// Fractions in one, two and three dimensions.
const fn ratios([one, two, three]: [(f64, f64); 3]) -> [Constant; 3] {
    [Constant::ratio(one.0, one.1), Constant::ratio(two.0, two.1), Constant::ratio(three.0, three.1)]
}
