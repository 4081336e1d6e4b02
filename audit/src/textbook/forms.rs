//! Equations as a textbook or a paper writes them: deliberately *not* how the code evaluates them. Each is the same function on paper, and
//! loses digits, or its head, in floating point.

use super::elementary::Elementary;
use etalon_kernels_gen::{Constant, Mask, Real};

/// `sin x / x` and its slope by `t`, `(cos x - sinc x) pi^2 / (2 x^2)`, with `x = pi sqrt(t)`.
pub fn sinc<R: Elementary>(t: R) -> (R, R) {
    let pi = Constant::PI;
    let x = R::constant(pi) * t.sqrt();
    let sinc = x.sin() / x;
    (sinc, (x.cos() - sinc) * R::constant(pi.times(pi).times(Constant::new(0.5))) / (x * x))
}

/// The quintic spline with its powers multiplied out, piece by piece, in 3-D.
pub fn quintic_spline<R: Real>(q_squared: R) -> (R, R) {
    let norm = R::constant(Constant::ratio(1.0, 120.0).over(Constant::PI));
    let lit = |value: f64| R::lit(value);
    let polynomial = |coefficients: &[f64], q: R| {
        let mut powers = coefficients.iter().rev();
        let first = powers.next().map_or(R::zero(), |c| R::lit(*c));
        powers.fold(first, |value, c| value * q + R::lit(*c))
    };
    let q = q_squared.sqrt();
    let (value, slope) = q.lt(lit(1.0)).choose(
        || (polynomial(&[66.0, 0.0, -60.0, 0.0, 30.0, -10.0], q), polynomial(&[-120.0, 0.0, 120.0, -50.0], q)),
        || {
            q.lt(lit(2.0)).choose(
                || {
                    let slope = polynomial(&[75.0, -420.0, 450.0, -180.0, 25.0], q);
                    (polynomial(&[51.0, 75.0, -210.0, 150.0, -45.0, 5.0], q), slope / q)
                },
                || {
                    q.lt(lit(3.0)).choose(
                        || {
                            let slope = polynomial(&[-405.0, 540.0, -270.0, 60.0, -5.0], q);
                            (polynomial(&[243.0, -405.0, 270.0, -90.0, 15.0, -1.0], q), slope / q)
                        },
                        || (R::zero(), R::zero()),
                    )
                },
            )
        },
    );
    (norm * value, norm * slope)
}

/// `max(0, min(1, 4 F / (1 + F)^2))` with `F = A / B`.
pub fn slope_limiter<R: Real>(slope_a: R, slope_b: R) -> R {
    let ratio = slope_a / slope_b;
    let sum = R::one() + ratio;
    R::zero().max(R::one().min(R::lit(4.0) * ratio / (sum * sum)))
}

/// `2 a b / (a + b)` where `a b > 0`, else zero.
pub fn van_leer<R: Real>(slope_a: R, slope_b: R) -> R {
    let product = slope_a * slope_b;
    product.gt(R::zero()).choose(|| R::lit(2.0) * product / (slope_a + slope_b), R::zero)
}

/// The inverse of a symmetric matrix in 3-D: its cofactors over its determinant. Upper triangle, row by row.
pub fn inverse<R: Real>(m: [R; 6]) -> [R; 6] {
    let [xx, xy, xz, yy, yz, zz] = m;
    let cofactors = [
        yy * zz - yz * yz,
        xz * yz - xy * zz,
        xy * yz - xz * yy,
        xx * zz - xz * xz,
        xy * xz - xx * yz,
        xx * yy - xy * xy,
    ];
    let determinant = xx * cofactors[0] + xy * cofactors[1] + xz * cofactors[2];
    cofactors.map(|cofactor| cofactor / determinant)
}

/// `P / (Omega k rho^2)`.
pub fn pressure_coefficient<R: Real>(pressure: R, grad_h: R, normalisation: R, density: R) -> R {
    pressure / (grad_h * normalisation * (density * density))
}

/// `(gamma - 1) rho u` with the adiabatic index as it is told, which begins with a one.
pub fn pressure<R: Real>(gamma_minus_one: R, density: R, internal_energy: R) -> R {
    let gamma = R::one() + gamma_minus_one;
    (gamma - R::one()) * density * internal_energy
}

/// `1 - exp(-y)` with `y = rate dt`.
pub fn decayed_share<R: Elementary>(rate: R, time_step: R) -> R {
    R::one() - (rate * time_step).exp_minus()
}

/// `f x + sigma sqrt(1 - f^2) z` with `f = exp(-dt/T)`.
pub fn ornstein_uhlenbeck<R: Elementary>(x: R, decay: R, sigma: R, normal: R) -> R {
    let f = decay.exp_minus();
    f * x + sigma * (R::one() - f * f).sqrt() * normal
}
