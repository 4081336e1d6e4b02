use etalon_kernels_gen::{Real, equation};

/// Documented.
#[equation("gs25:31")]
fn no_such_number<R: Real>(x: R) -> R {
    x
}

/// Documented.
#[equation("xy99:1", "gs25")]
fn no_such_paper<R: Real>(x: R) -> R {
    x
}

/// Documented.
#[equation]
fn no_source<R: Real>(x: R) -> R {
    x
}

/// Documented.
#[equation("gs25:8", "gs25:8")]
fn twice<R: Real>(x: R) -> R {
    x
}

/// Documented.
#[equation("gs25:8", unnumbered = "section 3")]
fn both<R: Real>(x: R) -> R {
    x
}

/// Documented.
#[equation(unnumbered = " ")]
fn nowhere<R: Real>(x: R) -> R {
    x
}

/// Documented.
#[equation(number = "gs25:8")]
fn other_key<R: Real>(x: R) -> R {
    x
}

/// Documented.
#[equation(8)]
fn no_text<R: Real>(x: R) -> R {
    x
}

/// Documented.
#[equation("gs25:8")]
struct NoFunction;

// A refused equation can still be called: no further complaints come from here.
fn main() {
    no_such_number(1.0);
}
