#!/usr/bin/env python3
"""Print the polynomial tables of jacobi.h: best approximations by Remez' exchange, weighted as the function is used, and
pairs of polynomials in the logarithmic forms near m = 1.

Each line of FUNCTIONS: name, f, interval, weight w (the error printed and levelled is w (p - f)), degrees for double and
for float; of LOGARITHMIC: name, f, power of c, numbers of terms of A and B for double and for float.
"""
from mpmath import mp, mpf, atan, cos, ellipe, ellipk, linspace, log, lu_solve, matrix, nstr, pi, polyval, sin, sqrt

mp.dps = 50


def remez(f, low, high, degree, weight):
    """Coefficients of the best polynomial, lowest power first, and its weighted error."""
    n = degree + 2
    points = [(low + high) / 2 - (high - low) / 2 * cos(pi * (k + mpf(1) / 2) / n) for k in range(n)]
    grid = linspace(low, high, 40 * n)[1:]
    for _ in range(12):
        a, b = matrix(n, n), matrix(n, 1)
        for i, x in enumerate(points):
            for j in range(degree + 1):
                a[i, j] = x ** j
            a[i, degree + 1] = (-1) ** i / weight(x)
            b[i] = f(x)
        c = list(lu_solve(a, b))[:degree + 1]
        e = [weight(x) * (polyval(c[::-1], x) - f(x)) for x in grid]
        extremes, k = [], 0
        while k < len(e):  # the largest of each run of one sign
            run = k
            while run + 1 < len(e) and (e[run + 1] > 0) == (e[k] > 0):
                run += 1
            best = max(range(k, run + 1), key=lambda i: abs(e[i]))
            extremes.append(best)
            k = run + 1
        if len(extremes) < n:
            break
        while len(extremes) > n:
            extremes.pop(0 if abs(e[extremes[0]]) < abs(e[extremes[-1]]) else -1)
        points = [grid[k] for k in extremes]
    return c, max(abs(x) for x in e)


def rounded(x, bits):
    kept, mp.prec = mp.prec, bits
    y = +x
    mp.prec = kept
    return y


def sine(t):
    return (sin(sqrt(t)) / sqrt(t) - 1) / t


def cosine(t):
    return (cos(sqrt(t)) - 1 + t / 2) / t ** 2


def arctangent(t):
    return (atan(sqrt(t)) / sqrt(t) - 1) / t


def k_series(x):
    """K = pi/(1 + k') (1 + x f(x)) with x = k1^2, k1 = (1 - k')/(1 + k')."""
    return (2 * ellipk(x) / pi - 1) / x


def e_series(x):
    """E = pi/4 (1 + k') (1 + x f(x))."""
    kp = (1 - sqrt(x)) / (1 + sqrt(x))
    return (4 * ellipe(1 - kp ** 2) / (pi * (1 + kp)) - 1) / x


def log_fit(f, power, high, terms_a, terms_b):
    """a and b of f(c) = c^power (l a(c) - b(c)), l = ln(16/c)/2, on (0, high]: least squares with Lawson's weights."""
    count = 6 * (terms_a + terms_b)
    points = [high * ((1 - cos(pi * (k + mpf(1) / 2) / count)) / 2) ** 1.5 for k in range(count)]
    logs, values, weights = [log(16 / c) / 2 for c in points], [f(c) for c in points], [mpf(1)] * count
    best = None
    for _ in range(25):
        m, right = matrix(count, terms_a + terms_b), matrix(count, 1)
        for i, c in enumerate(points):
            root = sqrt(weights[i])
            for j in range(terms_a):
                m[i, j] = root * logs[i] * c ** (j + power)
            for j in range(terms_b):
                m[i, terms_a + j] = -root * c ** (j + power)
            right[i] = root * values[i]
        x = list(lu_solve(m, right))
        e = [abs(c ** power * (logs[i] * polyval(x[:terms_a][::-1], c) - polyval(x[terms_a:][::-1], c)) - values[i])
             for i, c in enumerate(points)]
        if best is None or max(e) < best[1]:
            best = x, max(e)
        total = sum(w * y for w, y in zip(weights, e))
        weights = [w * y * count / total for w, y in zip(weights, e)]
    return best[0][:terms_a], best[0][terms_a:], best[1]


T = mpf("0.63")  # (pi/4)^2 and a margin
FUNCTIONS = [
    ("(sin z/z - 1)/z^2 of z^2", sine, 0, T, lambda t: t, 5, 3),
    ("(cos z - 1 + z^2/2)/z^4 of z^2", cosine, 0, T, lambda t: t * t, 5, 2),
    ("(atan z/z - 1)/z^2 of z^2", arctangent, 0, mpf("0.1717"), lambda t: t, 9, 4),
    ("(2 K(x)/pi - 1)/x", k_series, 0, mpf("0.0295"), lambda x: x, 6, 2),  # k1^2 for m from -1 to 1/2
    ("(4 E/(pi (1 + k')) - 1)/k1^2 of k1^2", e_series, 0, mpf("0.5035"), lambda x: x, 15, 6),  # m from -33.5 to 0.971
]
LOGARITHMIC = [
    ("K - l - c (l - 1)/4 by c^2 (l A - B)", lambda c: ellipk(1 - c) - log(16 / c) / 2 - c * (log(16 / c) / 2 - 1) / 4,
     2, (9, 8), (4, 3)),
    ("E - 1 by c (l A - B)", lambda c: ellipe(1 - c) - 1, 1, (9, 8), (4, 4)),
]


def print_table(c, bits):
    text = [f"VM_C({nstr(rounded(v, bits), 18 if bits == 53 else 10, min_fixed=-3, max_fixed=9)})" for v in c]
    for k in range(0, len(text), 4):
        print("    " + ", ".join(text[k:k + 4]) + ",")


if __name__ == "__main__":
    for name, f, low, high, weight, *degrees in FUNCTIONS:
        for bits, degree in zip((53, 24), degrees):
            c, error = remez(f, mpf(low) if low else mpf(10) ** -12, high, degree, weight)
            print(f"/* {name}, degree {degree}, p = {bits}: error 2^{nstr(log(error, 2), 4)} */")
            print_table(c, bits)
    for name, f, power, *terms in LOGARITHMIC:
        for bits, (terms_a, terms_b) in zip((53, 24), terms):
            a, b, error = log_fit(f, power, mpf(1) / 2, terms_a, terms_b)
            print(f"/* {name}, c <= 1/2, p = {bits}: error 2^{nstr(log(error, 2), 4)} */")
            print_table(a, bits)
            print_table(b, bits)
