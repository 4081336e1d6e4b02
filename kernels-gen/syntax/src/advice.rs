//! Functions that an equation may not call, and what to write instead.

/// Why a function is refused.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Reason {
    /// It is computed differently by every library and driver.
    Transcendental,
    /// It exists on numbers, but not on lanes or symbols, or not with the same meaning on every target.
    NotOffered,
}

const WHOLE_POWER: &str = "write `.power(n)` for a whole power";
const NO_JUMPS: &str = "results would jump by one for a last-bit difference; compare with `if` where the cases meet";
const FINITE: &str = "every value is finite for legal input: state the domain in the doc comment";
const BITS: &str = "bit patterns exist on scalars only; use arithmetic";
const ORDER: &str = "write `a < b` or `a <= b`";
const POLYNOMIAL: &str =
    "write the polynomial or the ratio that you need with `+ - * /` (`functions::horner`), and state its range";

const TRANSCENDENTAL: &[(&[&str], &str)] = &[
    (&["exp"], "write `functions::exp_negative(y)` for a decaying exponential exp(-y)"),
    (&["cbrt"], "write `functions::cube_root(x)`"),
    (&["hypot"], "write `(x * x + y * y).sqrt()` or `Vector::norm`"),
    (&["powf"], "write `.power(n)` for a whole power, `.sqrt()` or `functions::cube_root(x)` for a root"),
    (
        &[
            "sin", "cos", "tan", "sin_cos", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "asinh", "acosh",
            "atanh", "exp2", "exp_m1", "ln", "ln_1p", "log", "log2", "log10", "erf", "erfc",
        ],
        POLYNOMIAL,
    ),
];

const NOT_OFFERED: &[(&[&str], &str)] = &[
    (&["powi", "pow"], WHOLE_POWER),
    (&["clamp"], "write `.max(low).min(high)`"),
    (&["recip"], "write `1.0 / x`"),
    (&["rsqrt"], "write `1.0 / x.sqrt()`"),
    (&["maximum", "fmax"], "write `.max(other)`"),
    (&["minimum", "fmin"], "write `.min(other)`"),
    (&["to_radians", "to_degrees"], "multiply by the constant: `x * R::lit(CONSTANT)`"),
    (&["signum"], "write `if x < 0.0 { -1.0 } else { 1.0 }`, which also says what happens at zero"),
    (&["copysign"], "write `if sign < 0.0 { -x.abs() } else { x.abs() }`, which also says what happens at zero"),
    (&["rem_euclid", "div_euclid", "floor", "ceil", "round", "round_ties_even", "trunc", "fract"], NO_JUMPS),
    (
        &[
            "is_nan",
            "is_finite",
            "is_infinite",
            "is_normal",
            "is_subnormal",
            "is_sign_negative",
            "is_sign_positive",
            "classify",
        ],
        FINITE,
    ),
    (
        &[
            "to_bits",
            "from_bits",
            "next_up",
            "next_down",
            "to_int_unchecked",
            "to_ne_bytes",
            "to_le_bytes",
            "to_be_bytes",
        ],
        BITS,
    ),
    (&["partial_cmp", "total_cmp", "cmp"], ORDER),
];

/// Whether a function of this name is refused: why, and what to write instead.
pub(crate) fn refusal(name: &str) -> Option<(Reason, &'static str)> {
    let find = |table: &'static [(&[&str], &'static str)]| {
        table.iter().find(|(names, _)| names.contains(&name)).map(|(_, advice)| *advice)
    };
    match find(TRANSCENDENTAL) {
        Some(advice) => Some((Reason::Transcendental, advice)),
        None => find(NOT_OFFERED).map(|advice| (Reason::NotOffered, advice)),
    }
}

/// The sentence for a refused function.
pub(crate) fn sentence(name: &str, reason: Reason, advice: &str) -> String {
    match reason {
        Reason::Transcendental => format!("`{name}` differs from one library and driver to the next; {advice}"),
        Reason::NotOffered => format!("`{name}` is not offered on every target; {advice}"),
    }
}
