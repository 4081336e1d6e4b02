//! Gradients by the integral approach: C25 (1)-(5).
//!
//! `x_ba = x_b - x_a` points from the particle to its neighbour; so do the vectors `A_ab`.

use etalon_kernels_gen::functions::ratio_or_zero;
use etalon_kernels_gen::{Matrix, Real, Symmetric, Vector, equation, equation_part};

/// Below this quality (see [`inverse_moments`]) the moment matrix is lifted before it is inverted.
///
/// A slab one hundredth as thick as wide has quality 6e-4. Ours: no particle of the scenes' flows comes near.
const QUALITY_FLOOR: f64 = 1e-3;

/// One neighbour's part of the moment matrix, `V_b x_ba x_ba^T W_ab(h_a)`.
///
/// `tau_ij,a = sum_b V_b (x_i,b - x_i,a)(x_j,b - x_j,a) W_ab(h_a)`. `volume` is `V_b = X_b/k_b` (L^nu), `kernel` is `W_ab(h_a)`; up to a
/// factor common to all neighbours, which the inverse undoes. The particle itself contributes nothing. Source: C25 (2).
#[equation("c25:2")]
pub fn moment_term<R: Real, const D: usize>(volume: R, x_ba: Vector<R, D>, kernel: R) -> Symmetric<R, D> {
    Symmetric::outer(x_ba, volume * kernel)
}

/// One neighbour's part of the integral `I` of a vector field, `V_b (f_b - f_a) x_ba^T W_ab(h_a)`; row: component, column: axis.
///
/// `f_a` is kept: with it the gradient of a linear field is exact however large the field's offset; the form without it is
/// meant for the pressure force only. Source: C25 (3), difference form.
#[equation("c25:3")]
pub fn integral_term<R: Real, const D: usize>(
    volume: R,
    f_ba: Vector<R, D>,
    x_ba: Vector<R, D>,
    kernel: R,
) -> Matrix<R, D> {
    let weighted = f_ba.scale(volume * kernel);
    Matrix::from_fn(|i, j| weighted[i] * x_ba[j])
}

/// The inverse `c = tau^-1` of the moment matrix, kept finite where the neighbours do not span the space.
///
/// The matrix is first divided by the mean of its diagonal, `tau' = nu tau / tr(tau)`, so that its scale does not matter. Its quality
/// is `det(tau')`: 1 for an isotropic neighbourhood, 0 for a flat one. Where that falls below 1e-3 the missing part is added to
/// the diagonal, a continuous change that leaves every well-posed particle alone. Without neighbours `c = 0`.
/// Source: C25 (1), whose inverse it is; the treatment of flat neighbourhoods is ours.
#[equation("c25:1")]
pub fn inverse_moments<R: Real, const D: usize>(tau: Symmetric<R, D>) -> Symmetric<R, D> {
    let scale = ratio_or_zero(R::lit(D as f64), tau.trace());
    let scaled = tau.scale(scale);
    let quality = determinant(scaled);
    let lift = 0.0.max(R::lit(QUALITY_FLOOR) - quality);
    let lifted = Symmetric::from_fn(|i, j| if i == j { scaled.at(i, i) + lift } else { scaled.at(i, j) });
    let inverse_determinant = ratio_or_zero(scale, determinant(lifted));
    adjugate(lifted).scale(inverse_determinant)
}

/// The gradient from its integral: `df/dx_j = sum_k I_k c_kj`, for each component of `f`.
///
/// Source: C25 (1).
#[equation("c25:1")]
pub fn gradient<R: Real, const D: usize>(integral: Matrix<R, D>, c: Symmetric<R, D>) -> Matrix<R, D> {
    Matrix::from_fn(|i, j| Vector(integral.0[i]).dot(Vector::from_fn(|k| c.at(k, j))))
}

/// One neighbour's part of a derivative, `V_b (f_b - f_a) A_ab`: the same gradient, summed in another order.
///
/// Source: C25 (4), difference form.
#[equation("c25:4")]
pub fn gradient_term<R: Real, const D: usize>(volume: R, f_ba: R, a_ab: Vector<R, D>) -> Vector<R, D> {
    a_ab.scale(volume * f_ba)
}

/// The vector that replaces the kernel's gradient, `A_ab = c_a (x_b - x_a) W_ab(h_a)` (L^-(nu+1)); it points to the neighbour.
///
/// With `c_b` and `W_ab(h_b)` but the same separation it is `A_ab(h_b)`, which equals `-A_ba(h_b)`: hence action equals reaction.
/// Source: C25 (5).
#[equation("c25:5")]
pub fn integral_gradient<R: Real, const D: usize>(c: Symmetric<R, D>, x_ba: Vector<R, D>, kernel: R) -> Vector<R, D> {
    c.apply(x_ba).scale(kernel)
}

/// The determinant of a symmetric matrix of up to three dimensions.
#[equation_part]
#[inline(always)]
pub(super) fn determinant<R: Real, const D: usize>(m: Symmetric<R, D>) -> R {
    m.row(0).dot(Vector::from_fn(
        #[inline(always)]
        |j| cofactor(m, 0, j),
    ))
}

/// The matrix of cofactors, which divided by the determinant is the inverse.
#[equation_part]
#[inline(always)]
fn adjugate<R: Real, const D: usize>(m: Symmetric<R, D>) -> Symmetric<R, D> {
    Symmetric::from_fn(
        #[inline(always)]
        |i, j| cofactor(m, i, j),
    )
}

/// The determinant of what is left without row `i` and column `j`, with its sign.
#[equation_part]
#[inline(always)]
fn cofactor<R: Real, const D: usize>(m: Symmetric<R, D>, i: usize, j: usize) -> R {
    match D {
        1 => R::one(),
        2 => {
            let opposite = m.at(1 - i, 1 - j);
            if i == j { opposite } else { -opposite }
        }
        _ => {
            // Going round cyclically brings the sign with it.
            let (i1, i2) = ((i + 1) % 3, (i + 2) % 3);
            let (j1, j2) = ((j + 1) % 3, (j + 2) % 3);
            m.at(i1, j1) * m.at(i2, j2) - m.at(i1, j2) * m.at(i2, j1)
        }
    }
}
