//! Components of a velocity around an axis, for the tests that are round: blast, vortex, piston.

use etalon_kernels_gen::functions::ratio_or_zero;
use etalon_kernels_gen::{Real, Vector, equation};

/// The velocity away from the centre, `v_r = v . x / |x|`; zero at the centre itself, where no direction leads away.
///
/// `x` is measured from the centre. Source: the definition; GS25 section 3 measures blast and piston with it.
#[equation(unnumbered = "radial velocity, GS25 section 3")]
pub fn radial_velocity<R: Real, const D: usize>(v: Vector<R, D>, x: Vector<R, D>) -> R {
    let r = x.norm();
    ratio_or_zero(v.dot(x), r)
}

/// The velocity around the z axis, `v_phi = (x v_y - y v_x) / r`, counter-clockwise; zero on the axis, where it has no direction.
///
/// `x` is measured from the axis. No angle is formed. Source: the definition; GS25 section 3 measures the vortex with it.
#[equation(unnumbered = "azimuthal velocity, GS25 section 3")]
pub fn azimuthal_velocity<R: Real>(v: Vector<R, 2>, x: Vector<R, 2>) -> R {
    let r = x.norm();
    ratio_or_zero(x[0] * v[1] - x[1] * v[0], r)
}
