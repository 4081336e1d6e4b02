use etalon_kernels_gen::{Real, equation};

/// Functions that differ, or that not every target has.
#[equation("gs25:8")]
fn calls<R: Real>(x: R, n: usize) -> R {
    let a = x.sin() + x.exp() + x.powf(0.5) + x.cbrt() + x.hypot(1.0) + atan2(x, 1.0);
    let b = x.powi(2).clamp(0.0, 1.0).recip().signum().copysign(1.0);
    let c = f64::floor(x) + R::log10(x) + [x].map(f64::tanh)[0];
    let d = x.is_nan() || x.to_bits() == 0 || x.partial_cmp(&1.0).is_none() || x.rem_euclid(1.0) == x;
    // Whole numbers may: they are known while generating.
    let e = n.pow(2).clamp(1, 3).rem_euclid(2);
    // Constants are plain arithmetic, but not the platform's functions.
    let f = R::lit((2.0_f64).sqrt().floor()) + R::lit(f64::sin(1.0));
    a
}

/// Numbers that leave their type.
#[equation("gs25:8")]
fn types<R: Real>(x: R, n: usize) -> R {
    let a = n as f64;
    let b = x as usize;
    let c = n as R;
    let d: f64 = 0.5;
    let e = 1.5f32 + 2.5_f64;
    let f = Vec::<f32>::new();
    let g = R::lit(n as f64 / 3.0);
    a
}

/// Comparisons that no target can promise.
#[equation("gs25:8")]
fn comparisons<R: Real>(x: R, y: R) -> R {
    let a = x == y;
    let b = x * y != 0.5;
    let c = x < 0;
    let d = (x < y) == (y < x);
    let e = x % 2.0;
    a
}

fn main() {}
