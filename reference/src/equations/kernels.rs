//! Interpolating kernels `W(r, h) = h^-nu w(q)`, `q = r / h`, in one, two and three dimensions.
//!
//! Each is given as its shape at `q^2`: the value `w` and `w'/q`, which stays finite at the centre. Outside the support both are
//! exactly zero.

use crate::schemes::Kernel;
use etalon_kernels_gen::functions::{horner, horner_derivative};
use etalon_kernels_gen::polynomials::{SINC, SINC_4_NORMALISATION, SINC_9_NORMALISATION};
use etalon_kernels_gen::{Constant, Real, equation, equation_part};

/// A kernel's value and slope at one distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shape<R> {
    /// `w(q)`.
    pub value: R,
    /// `w'(q) / q`; never positive.
    pub slope_over_q: R,
}

/// `weight B_n` and, for the slope, `(n/2) weight B_n`, of a member `S_n` of the mixed sinc kernel, by dimension.
const fn member(weight: Constant, n: f64, b: [Constant; 3]) -> [[Constant; 2]; 3] {
    let half = Constant::ratio(n, 2.0);
    let [one, two, three] = [weight.times(b[0]), weight.times(b[1]), weight.times(b[2])];
    [[one, one.times(half)], [two, two.times(half)], [three, three.times(half)]]
}

/// The weights of `S_4` and `S_9` in the mixed sinc kernel (GS25 section 3).
pub const MIXED_SINC_WEIGHTS: [Constant; 2] = [Constant::ratio(9.0, 10.0), Constant::ratio(1.0, 10.0)];

/// The members of the mixed sinc kernel.
const MEMBER_4: [[Constant; 2]; 3] = member(MIXED_SINC_WEIGHTS[0], 4.0, SINC_4_NORMALISATION);
const MEMBER_9: [[Constant; 2]; 3] = member(MIXED_SINC_WEIGHTS[1], 9.0, SINC_9_NORMALISATION);

/// `p / (q pi)`, as the normalisations in two and three dimensions are.
const fn over_pi(p: f64, q: f64) -> Constant {
    Constant::ratio(p, q).over(Constant::PI)
}

/// Normalisations `B` in one, two and three dimensions; each kernel's page says them.
const CUBIC_SPLINE: [Constant; 3] = [Constant::ratio(2.0, 3.0), over_pi(10.0, 7.0), over_pi(1.0, 1.0)];
const QUINTIC_SPLINE: [Constant; 3] = [Constant::ratio(1.0, 120.0), over_pi(7.0, 478.0), over_pi(1.0, 120.0)];
const WENDLAND_C2: [Constant; 3] = [Constant::ratio(5.0, 8.0), over_pi(7.0, 4.0), over_pi(21.0, 16.0)];
const WENDLAND_C4: [Constant; 3] = [Constant::ratio(3.0, 4.0), over_pi(9.0, 4.0), over_pi(495.0, 256.0)];
const THIRTY_FIVE_TWELFTHS: Constant = Constant::ratio(35.0, 12.0);
const MINUS_FOURTEEN_THIRDS: Constant = Constant::ratio(-14.0, 3.0);
const WENDLAND_C6: [Constant; 3] = [Constant::ratio(55.0, 64.0), over_pi(39.0, 14.0), over_pi(1365.0, 512.0)];

/// The shape of any [`Kernel`] at squared distance `q^2` (in units of `h^2`), in `D` dimensions.
#[inline(always)]
pub fn kernel_shape<R: Real, const D: usize>(kernel: Kernel, q_squared: R) -> Shape<R> {
    match kernel {
        Kernel::MixedSinc => mixed_sinc::<R, D>(q_squared),
        Kernel::CubicSpline => cubic_spline::<R, D>(q_squared),
        Kernel::QuinticSpline => quintic_spline::<R, D>(q_squared),
        Kernel::WendlandC2 => wendland_c2::<R, D>(q_squared),
        Kernel::WendlandC4 => wendland_c4::<R, D>(q_squared),
        Kernel::WendlandC6 => wendland_c6::<R, D>(q_squared),
    }
}

/// The kernel's value at its own centre, `w(0)`: the self term of every sum. A constant, so computed in `f64`.
#[inline(always)]
pub fn central_value<R: Real, const D: usize>(kernel: Kernel) -> R {
    R::lit(central_constant::<D>(kernel))
}

// Out of line: one copy of six kernels is enough for all the vector code that asks for their centres.
#[inline(never)]
fn central_constant<const D: usize>(kernel: Kernel) -> f64 {
    kernel_shape::<f64, D>(kernel, 0.0).value
}

/// `h^-D` from `1/h`.
#[equation_part]
#[inline(always)]
pub fn inverse_volume<R: Real, const D: usize>(inverse_h: R) -> R {
    inverse_h.power(D as u32)
}

/// The change of `W` with the smoothing length, without its factor `h^-(nu+1)`: `-(nu w + q w')`.
///
/// `dW/dh = h^-(nu+1) * shape_derivative`, `q = r/h`; it integrates to zero over space. Source: the definition of `W`.
#[equation(unnumbered = "dW/dh, from W = h^-nu w(r/h)")]
pub fn smoothing_length_derivative<R: Real, const D: usize>(shape: Shape<R>, q_squared: R) -> R {
    -(q_squared.mul_add(shape.slope_over_q, shape.value * R::lit(D as f64)))
}

/// `sinc(pi q / 2)` and its derivative with respect to `t = q^2 / 4`, for `0 <= t <= 1`.
///
/// `sinc = (1 - t) p(t)` with a fitted polynomial `p`: the zero at the support's edge is exact, and neither a sine nor a square
/// root is needed. Fit and error: `kernels-gen/coefficients`. Source: Cabezón, García-Senz & Relaño 2008.
#[equation(unnumbered = "sinc(pi q / 2), the kernels' building block")]
pub fn sinc_half_pi<R: Real>(t: R) -> (R, R) {
    let p = horner(&SINC, t);
    let p_slope = horner_derivative(&SINC, t);
    let edge = 1.0 - t;
    (edge * p, edge * p_slope - p)
}

/// The mixed sinc kernel `S = 0.9 S_4 + 0.1 S_9`, `S_n = B_n sinc(pi q / 2)^n`, support `2h`.
///
/// Each member is normalised by itself, so `w(0) = 0.9 B_4 + 0.1 B_9` (0.55216 in 3-D); normalising the sum jointly is a
/// different kernel. `w'/q = (1/2) (dw/ds) (ds/dt)` with `t = q^2/4`. Source: GS25 section 3; Cabezón & García-Senz 2024.
#[equation(unnumbered = "the mixed sinc kernel, GS25 section 3")]
pub fn mixed_sinc<R: Real, const D: usize>(q_squared: R) -> Shape<R> {
    let b_4 = R::constant(MEMBER_4[D - 1][0]);
    let b_9 = R::constant(MEMBER_9[D - 1][0]);
    let half_b_4 = R::constant(MEMBER_4[D - 1][1]);
    let half_b_9 = R::constant(MEMBER_9[D - 1][1]);
    let t = 1.0.min(q_squared * 0.25);
    let (s, s_slope) = sinc_half_pi(t);
    let s_2 = s * s;
    let s_4 = s_2 * s_2;
    let s_5 = s_4 * s;
    let value = s_4 * s_5.mul_add(b_9, b_4);
    let slope_over_q = s_2 * s * s_5.mul_add(half_b_9, half_b_4) * s_slope;
    Shape { value, slope_over_q }
}

/// The cubic spline M4: `w = B [ (2-q)^3/4 - (1-q)^3 ]`, each power only while its base is positive; support `2h`.
///
/// `B` = 2/3, 10/(7 pi), 1/pi. `w'/q = B (-3 + 9q/4)` inside `q = 1`, `-(3/4) B (2-q)^2 / q` outside. Source: PL20 section 2.4
/// names it; Monaghan & Lattanzio 1985.
#[equation(unnumbered = "the cubic spline M4")]
pub fn cubic_spline<R: Real, const D: usize>(q_squared: R) -> Shape<R> {
    let norm = R::constant(CUBIC_SPLINE[D - 1]);
    let q = q_squared.sqrt();
    let outer = 0.0.max(2.0 - q);
    let inner = 0.0.max(1.0 - q);
    let value = norm * (0.25 * outer.power(3) - inner.power(3));
    let slope = if q < 1.0 { 2.25 * q - 3.0 } else { -(0.75 * outer.power(2)) / q.max(1.0) };
    Shape { value, slope_over_q: norm * slope }
}

/// The quintic spline M6: `w = B [ (3-q)^5 - 6 (2-q)^5 + 15 (1-q)^5 ]`, each power only while its base is positive; support `3h`.
///
/// `B` = 1/120, 7/(478 pi), 1/(120 pi). Inside `q = 1` the slope is `w'/q = B (-120 + 120 q^2 - 50 q^3)`, outside it is the sum of the
/// powers' derivatives over `q`: expanding there would lose all digits at the edge. Source: PL20 section 2.4; Morris 1996.
#[equation(unnumbered = "the quintic spline M6")]
pub fn quintic_spline<R: Real, const D: usize>(q_squared: R) -> Shape<R> {
    let norm = R::constant(QUINTIC_SPLINE[D - 1]);
    let q = q_squared.sqrt();
    let outer = 0.0.max(3.0 - q);
    let middle = 0.0.max(2.0 - q);
    let inner = 0.0.max(1.0 - q);
    let value = norm * (outer.power(5) - 6.0 * middle.power(5) + 15.0 * inner.power(5));
    let slope = if q < 1.0 {
        q_squared * (120.0 - 50.0 * q) - 120.0
    } else {
        (30.0 * middle.power(4) - 5.0 * outer.power(4)) / q.max(1.0)
    };
    Shape { value, slope_over_q: norm * slope }
}

/// Wendland's C2: with `u = 1 - q/2`, `w = B u^4 (2q + 1)` in 2-D and 3-D, `w = B u^3 (3q/2 + 1)` in 1-D; support `2h`.
///
/// `B` = 5/8, 7/(4 pi), 21/(16 pi). `w'/q = -5 B u^3`, in 1-D `-3 B u^2`. Source: PL20 section 2.4; Wendland 1995.
#[equation(unnumbered = "Wendland's kernel C2")]
pub fn wendland_c2<R: Real, const D: usize>(q_squared: R) -> Shape<R> {
    let norm = R::constant(WENDLAND_C2[D - 1]);
    let q = q_squared.sqrt();
    let u = 0.0.max(1.0 - 0.5 * q);
    let (value, slope) = match D {
        1 => (u.power(3) * (1.5 * q + 1.0), -3.0 * u.power(2)),
        _ => (u.power(4) * (2.0 * q + 1.0), -5.0 * u.power(3)),
    };
    Shape { value: norm * value, slope_over_q: norm * slope }
}

/// Wendland's C4: with `u = 1 - q/2`, `w = B u^6 (35 q^2/12 + 3q + 1)`, in 1-D `w = B u^5 (2 q^2 + 5q/2 + 1)`; support `2h`.
///
/// `B` = 3/4, 9/(4 pi), 495/(256 pi). `w'/q = -(14/3) B u^5 (5q/2 + 1)`, in 1-D `-(7/2) B u^4 (2q + 1)`. Source: PL20 section 2.4; Wendland 1995.
#[equation(unnumbered = "Wendland's kernel C4")]
pub fn wendland_c4<R: Real, const D: usize>(q_squared: R) -> Shape<R> {
    let norm = R::constant(WENDLAND_C4[D - 1]);
    let q = q_squared.sqrt();
    let u = 0.0.max(1.0 - 0.5 * q);
    let (value, slope) = match D {
        1 => (u.power(5) * (q * (2.0 * q + 2.5) + 1.0), -3.5 * u.power(4) * (2.0 * q + 1.0)),
        _ => {
            let c = R::constant(THIRTY_FIVE_TWELFTHS);
            let d = R::constant(MINUS_FOURTEEN_THIRDS);
            (u.power(6) * (q * (c * q + 3.0) + 1.0), d * u.power(5) * (2.5 * q + 1.0))
        }
    };
    Shape { value: norm * value, slope_over_q: norm * slope }
}

/// Wendland's C6: with `u = 1 - q/2`, `w = B u^8 (4 q^3 + 25 q^2/4 + 4q + 1)`, in 1-D `w = B u^7 (21 q^3/8 + 19 q^2/4 + 7q/2 + 1)`; support `2h`.
///
/// `B` = 55/64, 39/(14 pi), 1365/(512 pi). `w'/q = -(11/2) B u^7 (4 q^2 + 7q/2 + 1)`, in 1-D `-(3/8) B u^6 (35 q^2 + 36q + 12)`.
/// Source: PL20 section 2.4; Wendland 1995.
#[equation(unnumbered = "Wendland's kernel C6")]
pub fn wendland_c6<R: Real, const D: usize>(q_squared: R) -> Shape<R> {
    let norm = R::constant(WENDLAND_C6[D - 1]);
    let q = q_squared.sqrt();
    let u = 0.0.max(1.0 - 0.5 * q);
    let (value, slope) = match D {
        1 => (
            u.power(7) * (q * (q * (2.625 * q + 4.75) + 3.5) + 1.0),
            -0.375 * u.power(6) * (q * (35.0 * q + 36.0) + 12.0),
        ),
        _ => (u.power(8) * (q * (q * (4.0 * q + 6.25) + 4.0) + 1.0), -5.5 * u.power(7) * (q * (4.0 * q + 3.5) + 1.0)),
    };
    Shape { value: norm * value, slope_over_q: norm * slope }
}
