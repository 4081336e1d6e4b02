"""Writes kernels-gen/src/polynomials.rs, kernel_values.toml and function_values.toml beside this file.

    python3 kernels-gen/coefficients/fit.py           write all three
    python3 kernels-gen/coefficients/fit.py --check   exit 1 unless all are what would be written
"""

import argparse
import sys
from pathlib import Path

from mpmath import mp, mpf

import functions
import kernels
import render
import series
from minimax import minimax, minimax_rounded

HERE = Path(__file__).resolve().parent
RUST_FILE = HERE.parent / "src" / "polynomials.rs"
TABLE_FILE = HERE / "kernel_values.toml"
FUNCTION_FILE = HERE / "function_values.toml"

SINGLE_BITS, DOUBLE_BITS = 24, 53
SAMPLES = 160  # Chebyshev points: at least twelve in each half-wave of the error
# A fit of 32 digits in powers of t is so ill-conditioned that it eats about 30 digits.
EXTENDED_DIGITS = 100


def fit(function, degree, bits):
    """Minimax in the relative error, with the constant term held at exactly 1.

    All functions here are 1 at 0, and kernels promise the exact value there (w(0), exp(0) = 1).
    """
    rows, targets = samples_of(function, degree, SAMPLES)
    return [mpf(1)] + minimax_rounded(rows, targets, bits)


def samples_of(function, degree, count):
    """Powers and targets at Chebyshev points, divided by the function."""
    points = [(1 - mp.cos(mp.pi * k / count)) / 2 for k in range(1, count + 1)]
    values = [series.evaluate(function, t) for t in points]
    rows = [[t**j / f for j in range(1, degree + 1)] for t, f in zip(points, values)]
    return rows, [(f - 1) / f for f in values]


def extended_fit(series_of, degree):
    """The same for the oracle: each coefficient is the sum of two f64, 106 bits or a little more.

    Rounding them costs some 1e-32, as much as the fit itself, so they are not fitted again.
    """
    with mp.workdps(EXTENDED_DIGITS):
        coefficients, _ = minimax(*samples_of(series_of(), degree, 12 * (degree + 1)))
    return [mpf(1)] + [sum(map(mpf, render.pair(value))) for value in coefficients]


def certified(function, coefficients):
    """The certified bound; refuses one that the samples do not nearly reach."""
    bound = series.certified_relative_error(function, coefficients)
    seen = series.sampled_relative_error(function, coefficients)
    if not seen <= bound <= seen * mpf("1.05"):
        raise ValueError(f"bound {mp.nstr(bound, 5)} against {mp.nstr(seen, 5)} seen")
    return bound


def sinc_text():
    """`SINC` and the errors of its slope."""
    function = series.reduced_sinc_series()
    fits = [fit(function, 6, SINGLE_BITS), fit(function, 10, DOUBLE_BITS)]
    fits.append(extended_fit(series.reduced_sinc_series, 17))
    slope = series.derivative(series.sinc_series())
    slope_errors = [
        certified(slope, series.derivative(series.times_one_minus(coefficients)))
        for coefficients in fits
    ]
    text = render.rust_polynomial(
        "SINC",
        "p(t) with sinc(pi q/2) = (1 - t) p(t), t = q^2/4 in \\[0, 1\\], q in \\[0, 2\\].\n"
        "\n"
        "The factor 1 - t carries the zero at the edge of the support, so the relative error of the sinc\n"
        "there is that of p; p(0) = 1 exactly. The bounds are relative to p, hence also to the sinc.",
        [(coefficients, certified(function, coefficients)) for coefficients in fits],
    )
    words = ("single", "double", "extended")
    for word, coefficients_word, error in zip(map(str.upper, words), words, slope_errors):
        text += "\n" + render.rust_constant(
            f"SINC_SLOPE_{word}_ERROR",
            f"Certified bound of the relative error of d/dt \\[(1 - t) p(t)\\] with [`SINC`]'s `{coefficients_word}`\n"
            "coefficients, against d sinc/dt, over t in \\[0, 1\\].",
            "f64",
            render.rounded_up(error),
        )
    return text


def expm1_text():
    """`EXPM1_NEGATIVE`."""
    function = series.reduced_expm1_series()
    fits = [fit(function, 6, SINGLE_BITS), fit(function, 11, DOUBLE_BITS)]
    fits.append(extended_fit(series.reduced_expm1_series, 21))
    return render.rust_polynomial(
        "EXPM1_NEGATIVE",
        "P(x) with exp(-x) - 1 = -x P(x), x in \\[0, 1\\].\n"
        "\n"
        "For exp(-y), y >= 0: x = min(y, 32)/32, e = -x P(x), five times e <- e (2 + e), result 1 + e.\n"
        "An error r of P becomes an absolute error of at most 0.38 r in exp(-y) (y exp(-31 y/32) <= 0.38),\n"
        "and 1 - exp(-y) = -e keeps its relative accuracy as y -> 0. P(0) = 1 exactly.",
        [(coefficients, certified(function, coefficients)) for coefficients in fits],
    )


def artanh_text():
    """`ARTANH`."""
    function = series.reduced_artanh_series()
    fits = [fit(function, 6, SINGLE_BITS), fit(function, 14, DOUBLE_BITS)]
    fits.append(extended_fit(series.reduced_artanh_series, 27))
    return render.rust_polynomial(
        "ARTANH",
        "P(t) with artanh z = z P(t), t = 4 z^2 in \\[0, 1\\], |z| <= 1/2.\n"
        "\n"
        "For the logarithm of a ratio a/b of at most three: 2 artanh((a - b)/(a + b)). P(0) = 1 exactly.",
        [(coefficients, certified(function, coefficients)) for coefficients in fits],
    )


def normalisation_text():
    """B of S_4 and S_9."""
    text = ""
    for n in (4, 9):
        values = kernels.sinc_normalisation(n)
        text += "\n" + render.rust_constant(
            f"SINC_{n}_NORMALISATION",
            f"B in 1, 2 and 3 dimensions: S_{n} = B sinc(pi q/2)^{n} has unit integral over its support q < 2.",
            "[Constant; 3]",
            render.rust_array(values),
        )
    values = kernels.inverse_second_moments()
    return text + "\n" + render.rust_constant(
        "MIXED_SINC_DOUBLE_HUMP",
        "h^2 / int r^2 W dV in 1, 2 and 3 dimensions, for the mixed sinc kernel W = 0.9 S_4 + 0.1 S_9: times q^2 W\n"
        "it makes the double-humped kernel, whose integral is one.",
        "[Constant; 3]",
        render.rust_array(values),
    )


def main():
    """Write or check."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true", help="compare instead of writing")
    check = parser.parse_args().check
    mp.dps = 50
    polynomials = sinc_text() + "\n" + expm1_text() + "\n" + artanh_text() + normalisation_text()
    texts = {
        RUST_FILE: render.RUST_HEADER + "\n" + polynomials + render.RUST_FOOTER,
        TABLE_FILE: render.kernel_table(kernels.all_kernels(), kernels.check_points),
        FUNCTION_FILE: render.function_table(functions.all_functions()),
    }
    differing = []
    for path, text in texts.items():
        if not check:
            path.write_text(text, encoding="utf-8")
        elif not path.exists() or path.read_text(encoding="utf-8") != text:
            differing.append(path)
    for path in differing:
        print(f"{path} is not what this script writes; run {render.COMMAND}", file=sys.stderr)
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
