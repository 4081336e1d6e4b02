"""The approximated functions as power series, and certified bounds of a fit's relative error.

All functions here are positive or negative on the whole of [0, 1] and monotone in magnitude
there, which `certified_relative_error` relies on:

* p(t) = sinc(pi sqrt t)/(1 - t) = prod_{n >= 2} (1 - t/n^2), every factor decreasing;
* |d sinc/dt|: sinc(pi sqrt t) = prod_{n >= 1} (1 - t/n^2) has only real zeros n^2, so its
  derivative has only real zeros too, one between each two of them, hence none below 1;
* P(x) = (1 - exp(-x))/x = int_0^1 exp(-x s) ds, decreasing;
* P(t) = artanh(z)/z, t = 4 z^2: all coefficients are positive, so it increases.
"""

from functools import cache

from mpmath import mp, mpf

DEGREE = 50  # the series are cut here; see REMAINDER

# More than the sum of all terms left out on [0, 1], together with the arithmetic's own rounding:
# for p and the sinc about pi^102/103! = 5e-114, times 51 in the derivative; for P 1/52! = 1.2e-68.
REMAINDER = mpf("1e-45")

# The artanh's series is geometric, 4^-k / (2k + 1): what is left out after this many terms is 1e-50.
ARTANH_DEGREE = 80


def sinc_series():
    """sinc(pi sqrt t) = sum_k (-pi^2 t)^k / (2k + 1)!, lowest power first."""
    return [(-(mp.pi**2)) ** k / mp.factorial(2 * k + 1) for k in range(DEGREE + 2)]


def reduced_sinc_series():
    """p(t) = sinc(pi sqrt t)/(1 - t): partial sums, which are minus the tails as the sum is 0."""
    terms = [(-(mp.pi**2)) ** k / mp.factorial(2 * k + 1) for k in range(DEGREE + 30)]
    return [-mp.fsum(reversed(terms[k + 1 :])) for k in range(DEGREE + 1)]


def reduced_expm1_series():
    """P(x) = (1 - exp(-x))/x = sum_k (-x)^k / (k + 1)!."""
    return [mpf(-1) ** k / mp.factorial(k + 1) for k in range(DEGREE + 1)]


def reduced_artanh_series():
    """P(t) = artanh(z)/z = sum_k t^k / (4^k (2k + 1)), t = 4 z^2."""
    return [1 / (mpf(4) ** k * (2 * k + 1)) for k in range(ARTANH_DEGREE + 1)]


def derivative(polynomial):
    """Coefficients of the derivative."""
    return [k * c for k, c in enumerate(polynomial)][1:]


def times_one_minus(polynomial):
    """Coefficients of (1 - t) p(t)."""
    return [a - b for a, b in zip(polynomial + [mpf(0)], [mpf(0)] + polynomial)]


def evaluate(polynomial, point):
    """Horner's rule, lowest power first."""
    return mp.polyval(polynomial[::-1], point)


def certified_relative_error(series, fit, parts=64):
    """Upper bound of max over [0, 1] of |fit/function - 1|.

    On each part the difference, a polynomial, is enclosed by its Bernstein coefficients, and the
    function is at least the smaller of its values at the part's ends.
    """
    padded = list(fit) + [mpf(0)] * (len(series) - len(fit))
    difference = [a - b for a, b in zip(padded, series)]
    bound = mpf(0)
    for part in range(parts):
        left, right = mpf(part) / parts, mpf(part + 1) / parts
        enclosure = max(abs(c) for c in _bernstein(difference, left, right)) + REMAINDER
        least = min(abs(evaluate(series, left)), abs(evaluate(series, right)))
        bound = max(bound, enclosure / (least - REMAINDER))
    return bound


def sampled_relative_error(series, fit, samples=4000):
    """Lower bound of the same maximum, by looking: says how sharp the certified one is."""
    points = (mpf(k) / samples for k in range(samples + 1))
    return max(abs(evaluate(fit, t) / evaluate(series, t) - 1) for t in points)


def _bernstein(polynomial, left, right):
    """Bernstein coefficients of a polynomial on [left, right]."""
    shifted = list(polynomial)
    degree = len(shifted) - 1
    for i in range(degree):  # Taylor shift to `left`
        for k in range(degree - 1, i - 1, -1):
            shifted[k] += left * shifted[k + 1]
    width = right - left
    scaled = [c * width**k / _choose(degree, k) for k, c in enumerate(shifted)]
    return [mp.fsum(_choose(i, k) * scaled[k] for k in range(i + 1)) for i in range(degree + 1)]


@cache
def _choose(n, k):
    return mp.binomial(n, k)
