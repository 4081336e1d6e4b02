"""The text of the generated files."""

from decimal import Decimal

from mpmath import mp

COMMAND = "python3 kernels-gen/coefficients/fit.py"

RUST_HEADER = f"""\
//! Minimax polynomials that stand for the transcendental functions inside kernels, and the
//! normalisations of the sinc kernels.
//!
//! Generated; do not edit. Command: `{COMMAND}`
//!
//! Kernels call no library `sin` or `exp`: these polynomials are the same text on every target.
//! Each function has a set of coefficients for each precision: the `single` ones are exact in `f32`,
//! the `double` ones in `f64`, and of these every coefficient was rounded and the later ones fitted
//! again; the `extended` ones are sums of two `f64`, for the oracle.
//! Errors are those of the polynomial with the coefficients as they stand here, in exact arithmetic,
//! certified by enclosing the difference to the power series with Bernstein coefficients. They are
//! not errors of its evaluation, to which rounding adds a few units in the last place.

use crate::constant::Constant;

/// A polynomial on an interval, in three precisions; lowest power first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polynomial {{
    /// Coefficients for `f32` evaluation, each exactly representable in `f32`.
    pub single: &'static [f64],
    /// Coefficients for `f64` evaluation.
    pub double: &'static [f64],
    /// Coefficients for evaluation with more digits than `f64` has.
    pub extended: &'static [Constant],
    /// Certified bound of the relative error of `single` over the whole interval.
    pub single_error: f64,
    /// Certified bound of the relative error of `double` over the whole interval.
    pub double_error: f64,
    /// Certified bound of the relative error of `extended` over the whole interval.
    pub extended_error: f64,
}}
"""

RUST_FOOTER = """
#[cfg(test)]
mod tests;
"""


def rust_polynomial(name, documentation, fits):
    """A `Polynomial` constant; `fits` holds (coefficients, error) for single, double and extended."""
    lines = [f"/// {line}".rstrip() for line in documentation.splitlines()]
    lines.append(f"pub const {name}: Polynomial = Polynomial {{")
    for field, (coefficients, _) in zip(("single", "double"), fits):
        lines.append(f"    {field}: &[")
        for value in map(float, coefficients):
            lines.append(f"        {rust_float(value)}, // {value.hex()}")
        lines.append("    ],")
    lines.append("    extended: &[")
    lines += [f"        {rust_pair(value)}," for value in fits[2][0]]
    lines.append("    ],")
    for field, (_, error) in zip(("single", "double", "extended"), fits):
        lines.append(f"    {field}_error: {rounded_up(error)},")
    lines.append("};")
    return "\n".join(lines) + "\n"


def rust_constant(name, documentation, type_name, text):
    """A constant with its doc comment."""
    lines = [f"/// {line}".rstrip() for line in documentation.splitlines()]
    return "\n".join(lines) + f"\npub const {name}: {type_name} = {text};\n"


def rust_array(values):
    """An array of constants, one a line."""
    return "[\n" + "".join(f"    {rust_pair(value)},\n" for value in values) + "]"


def pair(value):
    """The nearest f64, and the f64 nearest to what is left."""
    high = float(value)
    return high, float(value - mp.mpf(high))


def rust_pair(value):
    """A `Constant`."""
    high, low = pair(value)
    return f"Constant::pair({rust_float(high)}, {rust_float(low)})"


def rust_float(value):
    """The shortest decimal that reads back as the same f64."""
    return repr(value)


def rounded_up(bound):
    """Three significant digits, never below the bound."""
    exponent = int(mp.floor(mp.log10(bound)))
    digits = int(mp.ceil(bound * mp.mpf(10) ** (2 - exponent)))
    if digits == 1000:
        digits, exponent = 100, exponent + 1
    return f"{digits // 100}.{digits % 100:02d}e{exponent}"


def kernel_table(kernels, check_points):
    """TOML: values and derivatives of all kernels."""
    lines = [
        "# Smoothing kernels W(r, h) = h^-nu w(q), q = r/h: w and dw/dq to 30 digits, for tests.",
        f"# Generated; do not edit. Command: {COMMAND}",
        "# Every q is exact in f32. w and dw are text, so that no reader loses digits.",
        "# sinc_4_9 is 0.9 S_4 + 0.1 S_9 with each member normalised; the one-dimensional",
        "# Wendland kernels are those with the one-dimensional polynomials.",
    ]
    for kernel in kernels:
        lines += [
            "",
            "[[kernel]]",
            f'name = "{kernel.name}"',
            f"dimension = {kernel.dimension}",
            f"support = {kernel.support}",
            "values = [",
        ]
        for q in check_points(kernel.support):
            w, dw = (thirty_digits(f(q)) for f in (kernel.value, kernel.derivative))
            lines.append(f'    {{ q = {float(q)!r}, w = "{w}", dw = "{dw}" }},')
        lines.append("]")
    return "\n".join(lines) + "\n"


def function_table(tables):
    """TOML: values of the functions; `tables` holds (name, meaning, [(x, value)])."""
    lines = [
        "# Functions beyond arithmetic, to 34 digits, for tests of the oracle.",
        f"# Generated; do not edit. Command: {COMMAND}",
        "# Every x is exact in f32. Values are text, so that no reader loses digits.",
    ]
    for name, meaning, values in tables:
        lines += ["", "[[function]]", f'name = "{name}"', f'meaning = "{meaning}"', "values = ["]
        for x, value in values:
            lines.append(f'    {{ x = {float(x)!r}, value = "{mp.nstr(value, 34, min_fixed=0, max_fixed=0)}" }},')
        lines.append("]")
    return "\n".join(lines) + "\n"


def thirty_digits(value):
    """Scientific notation with 30 significant digits; plain 0 for zero.

    Through 40 digits, where the noise of the arithmetic is gone: many spline values are finite
    decimals that end in 5 just behind the thirtieth digit, and a tie must not hang on the noise.
    """
    if value == 0:
        return "0"
    forty = Decimal(mp.nstr(value, 40, strip_zeros=False, min_fixed=0, max_fixed=0))
    return f"{forty:.29e}"
