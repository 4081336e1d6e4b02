"""The functions beyond arithmetic that equations use, in as many digits as mpmath is set to.

Independent of the Rust code on purpose: mpmath's own functions instead of polynomials and Halley steps.
"""

from mpmath import mp, mpf


def points(low, high, count):
    """Points between `low` and `high`, all exact in f32: multiples of 2^-18 with odd numerators."""
    width = mpf(high) - mpf(low)
    raw = (mpf(low) + width * k / count for k in range(1, count))
    return [(2 * mp.floor(x * 2**17) + 1) / 2**18 for x in raw]


def sinc(t):
    """sinc(pi sqrt t)."""
    x = mp.pi * mp.sqrt(t)
    return mp.sin(x) / x


def sinc_slope(t):
    """d/dt sinc(pi sqrt t), for t away from 0, where the two terms cancel only a few digits."""
    x = mp.pi * mp.sqrt(t)
    return (mp.cos(x) - mp.sin(x) / x) / (2 * t)


def all_functions():
    """(name, meaning, [(x, value)]) for each function."""
    tables = []

    def table(name, meaning, function, where):
        tables.append((name, meaning, [(x, function(x)) for x in where]))

    table("sinc", "sinc(pi sqrt x)", sinc, points(0, 1, 24))
    table("sinc_slope", "d/dx sinc(pi sqrt x)", sinc_slope, points(0, 1, 24))
    table("exp_negative", "exp(-x)", lambda x: mp.exp(-x), points(0, 1, 8) + points(1, 40, 16))
    table("artanh", "artanh x", mp.atanh, points(0, mpf(1) / 2, 24))
    table("square_root", "x^(1/2)", mp.sqrt, points(0, 2, 12) + points(2, 1000, 8))
    table("cube_root", "x^(1/3)", mp.cbrt, points(0, 2, 12) + points(2, 1000, 8))
    return tables
