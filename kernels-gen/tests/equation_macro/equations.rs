//! Equations as users write them: each tries one part of the language.

use etalon_kernels_gen::{Real, Symmetric, Vector, equation, functions};

/// Which slope to take: known while generating.
#[derive(Clone, Copy, PartialEq)]
pub enum Slope {
    /// None.
    Flat,
    /// As steep as this.
    Steep {
        /// Times the usual.
        factor: u32,
    },
}

/// The Balsara factor `f_a = |div v| / (|div v| + |curl v| + 1e-4 c_a / h_a)`, dimensionless.
///
/// | symbol | meaning | unit |
/// |---|---|---|
/// | `div_v`, `curl_v` | divergence and curl of the velocity | 1/s |
/// | `c_a` | speed of sound | m/s |
/// | `h_a` | smoothing length | m |
#[equation("gs25:8")]
pub fn balsara_limiter<R: Real>(div_v: R, curl_v: R, c_a: R, h_a: R) -> R {
    let shear = curl_v.abs(); // a comment that the source text keeps
    let floor_rate = 1e-4 * c_a / h_a;
    div_v.abs() / (div_v.abs() + shear + floor_rate)
}

/// Three pieces: `-2` below `-1`, `x` up to `1`, `3` above; dimensionless.
#[equation("gs25:11", "gs25:12")]
#[must_use]
pub fn pieces<R>(x: R) -> R
where
    R: Real,
{
    if x < -1.0 {
        -2.0
    } else if x <= 1.0 && !(x > 1.0) {
        let inside = x;
        inside
    } else {
        3.0
    }
}

/// A costly side that few need: `x^2` where `x` is above `limit` or below `-limit`, else `x`; dimensionless.
#[equation(unnumbered = "a test of rare branches")]
pub fn rarely_squared<R: Real>(x: R, limit: R) -> R {
    if rare(x >= limit || x <= -limit) { x.squared() } else { x }
}

/// Masks have names too, and a branch may give several values: `(x, 1)` where `0 < x`, else `(0, -1)`; dimensionless.
#[equation("gs25:13")]
pub fn sorted_out<R: Real>(x: R, known: R::Mask) -> (R, R) {
    let positive: R::Mask = 0.0 < x;
    let both = positive && known;
    let (kept, sign) = if both { (x, 1.0) } else { (0.0, -1.0) };
    (kept, sign)
}

/// Decisions that are made while generating: dimension, scheme, flags; `sum_i x_i^2` and more, m^2.
#[equation("c25:1")]
pub fn decided_early<R: Real, const D: usize>(x: Vector<R, D>, slope: Slope, double: bool) -> R {
    const WEIGHT: f64 = 0.5 * 4.0;
    assert!(D <= 3, "at most {} dimensions", 3);
    let mut sum = R::lit(0.0);
    for axis in 0..D {
        if axis >= 2 {
            continue;
        }
        sum += x[axis] * x[axis];
    }
    if D < 3 {
        sum -= 0.25;
    }
    let scaled = match slope {
        Slope::Flat => sum,
        Slope::Steep { factor } if factor > 1 => sum * R::lit(factor as f64),
        Slope::Steep { .. } => sum + R::lit(WEIGHT),
    };
    let twice = if double || matches!(slope, Slope::Flat) { scaled * 2.0 } else { scaled };
    twice.power(D as u32)
}

/// A user's own type: a drawing has no name for it.
#[derive(Clone, Copy)]
pub struct State<R> {
    /// Any number.
    pub rho: R,
}

/// Every type a `let` may hold, with nothing but `R: Real` known; the sum of all that is in them.
#[equation("c25:2")]
pub fn every_let<R: Real, const D: usize>(x: R, v: Vector<R, D>, flag: bool) -> R {
    let number = x * 2.0;
    let vector = Vector::from_fn(|i| v[i] + number);
    let matrix: Symmetric<R, D> = Symmetric::outer(vector, 1.0);
    let array = [x, number];
    let tuple = (number, flag);
    let state = State { rho: number };
    let copied = state;
    let count = 2;
    let mut last = 0;
    for i in 0..count {
        let next = i + 1;
        last = next;
    }
    let chosen = if flag { 1 } else { 0 };
    let answer = tuple.1;
    let square = |t: R| t * t;
    let borrowed = &array;
    let r#type = square(x);
    let _unused = 1.0;
    let total: R = copied.rho + matrix.trace() + borrowed[chosen] + array[last - 1] + r#type;
    if answer { total } else { -total }
}

/// Branches within branches, loops within branches, vectors as values; dimensionless.
#[equation("c25:3")]
pub fn nested<R: Real, const D: usize>(v: Vector<R, D>, x: R) -> Vector<R, D> {
    let scaled = Vector::from_fn(|i| if v[i] > x { v[i] } else { x });
    if x < 0.5 {
        let mut sum = 0.0;
        for i in 0..D {
            if i == 2 {
                break;
            }
            sum += scaled[i];
        }
        let factor = functions::ratio_or_zero(1.0, if sum > 2.0 { sum } else { 2.0 });
        scaled * factor
    } else {
        -scaled
    }
}

/// An equation of an object; `(x + offset) / 2`, m.
pub struct Shift<const N: usize>;

impl<const N: usize> Shift<N> {
    /// The shifted value `x + N`, m.
    #[equation("pl20:1")]
    pub fn shifted<R: Real>(&self, x: R) -> R {
        if N < 2 { x + R::lit(N as f64) } else { x + 2.0 }
    }
}

/// The mean of a list, nothing for an empty one: an equation of whole lists.
#[equation("gs25:20", host)]
pub fn mean(values: &[f64]) -> Option<f64> {
    if values.is_empty() {
        return None;
    }
    Some(values.iter().sum::<f64>() / values.len() as f64)
}
