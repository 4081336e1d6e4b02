"""The smoothing kernels w(q), W = h^-nu w(r/h), in as many digits as mpmath is set to.

Independent of the Rust code on purpose: sines instead of polynomials, quadrature instead of closed
norms. Each kernel is a shape f(q), its derivative, its support, and the points where it is not
smooth; the normalisation 1/int f dV is computed for 1, 2 and 3 dimensions.
"""

from dataclasses import dataclass, field
from typing import Callable

from mpmath import mp, mpf

# Normalisations B of S_n = B sinc(pi q/2)^n as published with the equations, 18 digits.
PUBLISHED_SINC = {
    4: ("0.752215012981181464", "0.580312175416713882", "0.458917516687635347"),
    9: ("1.10394401102938183", "1.23244006128305170", "1.39132214892178846"),
}


@dataclass
class Kernel:
    """A normalised kernel in one dimension."""

    name: str
    dimension: int
    support: int
    shape: Callable = field(repr=False)
    slope: Callable = field(repr=False)
    normalisation: mpf = mpf(1)

    def value(self, q):
        """w(q)."""
        return self.normalisation * self.shape(q) if q < self.support else mpf(0)

    def derivative(self, q):
        """dw/dq."""
        return self.normalisation * self.slope(q) if q < self.support else mpf(0)


def sinc_power(n):
    """sinc(pi q/2)^n and its derivative n s^(n-1) s'; the series takes over where s' cancels."""

    def s(q):
        return mp.sinc(mp.pi * q / 2)

    def s_prime(q):
        x = mp.pi * q / 2
        if x < mpf("0.01"):
            terms = ((-1) ** k * 2 * k * x ** (2 * k - 1) / mp.factorial(2 * k + 1) for k in range(1, 20))
            return mp.pi / 2 * mp.fsum(terms)
        return mp.pi / 2 * (mp.cos(x) - mp.sinc(x)) / x

    return (lambda q: s(q) ** n), (lambda q: n * s(q) ** (n - 1) * s_prime(q))


def truncated_powers(degree, terms):
    """sum_k c_k (a_k - q)_+^degree and its derivative: the B-splines M4 and M6."""

    def shape(q):
        return mp.fsum(c * max(a - q, mpf(0)) ** degree for a, c in terms)

    def slope(q):
        return mp.fsum(-degree * c * max(a - q, mpf(0)) ** (degree - 1) for a, c in terms)

    return shape, slope


def wendland(power, polynomial):
    """(1 - q/2)^power times a polynomial in q (lowest power first), and its derivative."""

    def shape(q):
        return (1 - q / 2) ** power * mp.polyval(polynomial[::-1], q)

    def slope(q):
        u = 1 - q / 2
        rising = [k * c for k, c in enumerate(polynomial)][1:]
        first = -mpf(power) / 2 * u ** (power - 1) * mp.polyval(polynomial[::-1], q)
        return first + u**power * mp.polyval(rising[::-1], q)

    return shape, slope


def wendland_shape(order, dimension):
    """Wendland's C2, C4, C6: the polynomials of one dimension differ from those of two and three."""
    one = {
        2: (3, [1, mpf(3) / 2]),
        4: (5, [1, mpf(5) / 2, 2]),
        6: (7, [1, mpf(7) / 2, mpf(19) / 4, mpf(21) / 8]),
    }
    more = {
        2: (4, [1, 2]),
        4: (6, [1, 3, mpf(35) / 12]),
        6: (8, [1, 4, mpf(25) / 4, 4]),
    }
    return wendland(*(one if dimension == 1 else more)[order])


def normalisation(shape, dimension, support):
    """1 / int f dV, by quadrature between the integers, where the splines have their knots."""
    shell = {1: lambda q: mpf(2), 2: lambda q: 2 * mp.pi * q, 3: lambda q: 4 * mp.pi * q**2}[dimension]
    return 1 / mp.quad(lambda q: shape(q) * shell(q), list(range(support + 1)))


def sinc_normalisation(n):
    """B of S_n in 1, 2 and 3 dimensions, checked against the published digits."""
    shape, _ = sinc_power(n)
    values = [normalisation(shape, dimension, 2) for dimension in (1, 2, 3)]
    for value, published in zip(values, PUBLISHED_SINC[n]):
        unit = mpf(10) ** -len(published.split(".")[1])
        if abs(value - mpf(published)) > unit / 2 * (1 + mpf("1e-9")):
            raise ValueError(f"S_{n}: {mp.nstr(value, 20)} is not the published {published}")
    return values


def mixed_sinc(dimension):
    """S^0.9_{4,9} = 0.9 S_4 + 0.1 S_9, each member normalised on its own."""
    parts = []
    for weight, n in ((mpf(9) / 10, 4), (mpf(1) / 10, 9)):
        shape, slope = sinc_power(n)
        parts.append((weight * sinc_normalisation(n)[dimension - 1], shape, slope))
    return Kernel(
        "sinc_4_9",
        dimension,
        2,
        lambda q: mp.fsum(c * shape(q) for c, shape, _ in parts),
        lambda q: mp.fsum(c * slope(q) for c, _, slope in parts),
    )


def inverse_second_moments():
    """h^2 / int r^2 W dV = 1 / (nu sigma^2) of the mixed sinc kernel in 1, 2 and 3 dimensions."""
    kernels = [mixed_sinc(dimension) for dimension in (1, 2, 3)]
    return [normalisation(lambda q, k=k: q**2 * k.value(q), k.dimension, k.support) for k in kernels]


def all_kernels():
    """Every kernel in every dimension, in the order of the check table."""
    kernels = [mixed_sinc(dimension) for dimension in (1, 2, 3)]
    splines = {"m4": (2, 3, [(2, mpf(1) / 4), (1, -1)]), "m6": (3, 5, [(3, 1), (2, -6), (1, 15)])}
    shapes = [
        (name, support, lambda dimension, d=degree, t=terms: truncated_powers(d, t))
        for name, (support, degree, terms) in splines.items()
    ]
    shapes += [
        (f"wendland_c{order}", 2, lambda dimension, o=order: wendland_shape(o, dimension))
        for order in (2, 4, 6)
    ]
    for name, support, build in shapes:
        for dimension in (1, 2, 3):
            shape, slope = build(dimension)
            norm = normalisation(shape, dimension, support)
            kernels.append(Kernel(name, dimension, support, shape, slope, norm))
    for kernel in kernels:
        _check(kernel)
    return kernels


def check_points(support):
    """Points q, all exact in f32: 0, close to 0, on and beside the knots, between, close to the edge, beyond."""
    points = {mpf(0), mpf(support), mpf(support) + mpf(1) / 4}
    points |= {mpf(2) ** -k for k in (30, 20, 12, 8, 5)}
    points |= {support - mpf(2) ** -k for k in (20, 16, 10, 5)}
    for knot in range(1, support):
        points |= {mpf(knot), knot - mpf(2) ** -10, knot + mpf(2) ** -10}
    for k in range(1, 16):  # all 22 fraction bits in use, so that q^2 is never exact by luck
        points.add(mpf(support * k) / 16 + mpf((k * 40503) % 65536 | 1) / 2**22)
    return sorted(points)


def _check(kernel):
    """The derivative is that of the value, and the integral is 1."""
    total = normalisation(kernel.value, kernel.dimension, kernel.support)
    if abs(total - 1) > mpf("1e-35"):
        raise ValueError(f"{kernel}: the integral is {mp.nstr(1 / total, 20)}")
    for k in range(1, 8):
        q = mpf(kernel.support) * k / 8 + mpf(1) / 100
        if abs(mp.diff(kernel.value, q) - kernel.derivative(q)) > mpf("1e-15"):
            raise ValueError(f"{kernel}: the derivative at {q} is not that of the value")
