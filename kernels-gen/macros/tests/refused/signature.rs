use etalon_kernels_gen::{Real, Vector, equation};

#[equation("gs25:8")]
fn undocumented<R: Real>(x: R) -> R {
    x
}

///
#[equation("gs25:8")]
fn empty_documentation<R: Real>(x: R) -> R {
    x
}

/// Documented.
#[equation("gs25:8")]
fn no_number_type(x: usize) -> usize {
    x
}

/// Documented.
#[equation("gs25:8")]
fn two_number_types<R: Real, S: Real, T>(x: R, _: S, _: T) -> R
where
    T: Real,
{
    x
}

/// Documented.
#[equation("gs25:8")]
fn floats<R: Real>(x: R, gamma: f64, v: Vector<f32, 3>) -> Option<f64> {
    Some(gamma)
}

/// Documented.
#[equation("gs25:8")]
#[inline]
fn inlined<R: Real>(x: R) -> R {
    x
}

/// Documented.
#[equation("gs25:8")]
unsafe extern "C" fn foreign<R: Real>(x: R) -> R {
    x
}

/// Documented.
#[equation("gs25:8")]
async fn later<R: Real>(x: R) -> R {
    x
}

/// Documented.
#[equation("gs25:8")]
const fn constant<R: Real>(x: R) -> R {
    x
}

fn main() {}
