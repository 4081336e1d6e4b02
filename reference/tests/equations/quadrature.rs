//! Gauss-Legendre quadrature, and integrals over the space around a point.

use std::f64::consts::PI;

/// Points of the rule on each unit interval: polynomials up to degree 47 are integrated exactly.
pub const POINTS: usize = 24;

/// Nodes and weights on (0, 1), by Newton's method on the Legendre polynomial.
fn rule() -> Vec<(f64, f64)> {
    let n = POINTS as f64;
    (0..POINTS)
        .map(|i| {
            let mut x = (PI * (i as f64 + 0.75) / (n + 0.5)).cos();
            let mut slope = 0.0;
            for _ in 0..10 {
                let (mut p, mut previous) = (1.0, 0.0);
                for k in 0..POINTS {
                    let k = k as f64;
                    (p, previous) = (((2.0 * k + 1.0) * x * p - k * previous) / (k + 1.0), p);
                }
                slope = n * (x * p - previous) / (x * x - 1.0);
                x -= p / slope;
            }
            (0.5 * (1.0 + x), 1.0 / ((1.0 - x * x) * slope * slope))
        })
        .collect()
}

/// The integral over all space of a function of the distance, smooth between whole numbers and zero beyond `reach`.
pub fn over_space<const D: usize>(reach: usize, f: impl Fn(f64) -> f64) -> f64 {
    let shell = |q: f64| [2.0, 2.0 * PI * q, 4.0 * PI * q * q][D - 1];
    let rule = rule();
    let piece = |start: usize| -> f64 {
        rule.iter().map(|(x, weight)| (start as f64 + x, weight)).map(|(q, weight)| weight * shell(q) * f(q)).sum()
    };
    (0..reach).map(piece).sum()
}

#[test]
fn quadrature_is_exact_for_polynomials() {
    // Volume of the ball of radius 3, and of r^8 in it.
    for (got, due) in
        [(over_space::<3>(3, |_| 1.0), 36.0 * PI), (over_space::<1>(3, |q| q.powi(8)), 2.0 * 3_f64.powi(9) / 9.0)]
    {
        // Nodes and weights are good to a few roundings, the sum has 72 terms.
        assert!((got / due - 1.0).abs() < 1e-14, "{got} instead of {due}");
    }
}
