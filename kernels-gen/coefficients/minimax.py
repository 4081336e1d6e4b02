"""Best approximation in the maximum norm by a linear family, and rounding of its coefficients.

A fit makes max_i |target_i - sum_j a_j row_ij| as small as possible over samples i. The exchange is
the simplex step on the dual linear programme (Stiefel's form of the Remez exchange): one sample
enters, the ratio test says which one leaves, and the level rises until no sample is above it.
"""

from mpmath import lu_solve, matrix, mp, mpf

TOLERANCE = mpf("1e-4")  # the level is at most this fraction below the best possible one
MOST_EXCHANGES = 1000


def minimax(rows, targets):
    """Return the coefficients with the smallest maximal residual, and that residual."""
    count = len(rows[0])
    last = len(rows) - 1
    reference = [round(last * (2 * k + 1) / (2 * count + 2)) for k in range(count + 1)]
    signs = [1 if value >= 0 else -1 for value in _null_vector([rows[i] for i in reference])]
    for _ in range(MOST_EXCHANGES):
        basis = matrix(count + 1, count + 1)
        for column, (i, sign) in enumerate(zip(reference, signs)):
            for j in range(count):
                basis[j, column] = sign * rows[i][j]
            basis[count, column] = 1
        weights = lu_solve(basis, matrix([0] * count + [1]))
        dual = lu_solve(basis.T, matrix([sign * targets[i] for i, sign in zip(reference, signs)]))
        coefficients, level = [dual[j] for j in range(count)], dual[count]
        residuals = [t - mp.fdot(coefficients, row) for row, t in zip(rows, targets)]
        enter = max(range(len(rows)), key=lambda i: abs(residuals[i]))
        if abs(residuals[enter]) <= level * (1 + TOLERANCE):
            return coefficients, abs(residuals[enter])
        sign = 1 if residuals[enter] > 0 else -1
        step = lu_solve(basis, matrix([sign * value for value in rows[enter]] + [1]))
        candidates = (k for k in range(count + 1) if step[k] > 0)
        leave = min(candidates, key=lambda k: weights[k] / step[k])
        reference[leave], signs[leave] = enter, sign
    raise RuntimeError(f"no best approximation after {MOST_EXCHANGES} exchanges")


def minimax_rounded(rows, targets, bits, beam=3):
    """Like `minimax`, with every coefficient representable in `bits` binary digits.

    Coefficients are rounded one after the other, lowest power first, each down and up, and all
    later ones are fitted again, so that they take up most of the rounding error. The best few
    partial choices are kept.
    """
    count = len(rows[0])
    free, error = minimax(rows, targets)
    kept = [(error, [], free)]
    for k in range(1, count + 1):
        tried = []
        for _, fixed, free in kept:
            for value in _neighbours(free[0], bits):
                chosen = fixed + [value]
                rest = [t - mp.fdot(chosen, row[:k]) for row, t in zip(rows, targets)]
                if k < count:
                    free_now, error = minimax([row[k:] for row in rows], rest)
                else:
                    free_now, error = [], max(abs(value) for value in rest)
                tried.append((error, chosen, free_now))
        kept = sorted(tried, key=lambda entry: entry[0])[:beam]
    return kept[0][1]


def _neighbours(value, bits):
    """The two numbers of `bits` binary digits that enclose `value`."""
    mantissa, exponent = mp.frexp(value)
    scaled = mantissa * mpf(2) ** bits
    unit = mpf(2) ** (exponent - bits)
    return mp.floor(scaled) * unit, mp.ceil(scaled) * unit


def _null_vector(rows):
    """A vector l with sum_i l_i rows_i = 0, for one row more than there are columns."""
    count = len(rows[0])
    system = matrix(count, count)
    for i in range(count):
        for j in range(count):
            system[j, i] = rows[i][j]
    solution = lu_solve(system, matrix([-value for value in rows[count]]))
    return [solution[i] for i in range(count)] + [mpf(1)]
