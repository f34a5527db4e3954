#!/usr/bin/env python3
"""Print the polynomial tables of jacobi.h: best approximations by Remez' exchange, weighted as the function is used.

Each line of FUNCTIONS: name, f, interval, weight w (the error printed and levelled is w (p - f)), degrees for double and
for float.
"""
from mpmath import (mp, mpf, agm, atan, cos, ellipe, ellipk, linspace, log, lu_solve, matrix, nstr, pi, polyval, qfrom,
                    sin, sqrt)

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


def agm_defect(x):
    return (1 - agm(1, sqrt(1 - x))) / x


def half_nome(x):
    """The nome of m from k1 = (1 - k')/(1 + k'), x = k1^2: q = k1/4 (1 + x f(x)), since q^2 is the nome of x."""
    return (4 * sqrt(qfrom(m=x) / x) - 1) / x


def e_over_k(x):
    return 4 * (1 - ellipe(x) / ellipk(x)) / x


T = mpf("0.63")  # (pi/4)^2 and a margin
Y = mpf("0.0295")  # k1^2 for m from -1 to 1/2
X = ((1 - mpf("0.3") ** mpf("0.25")) / (1 + mpf("0.3") ** mpf("0.25"))) ** 4  # two steps of the AGM for m = 0.7
FUNCTIONS = [
    ("(sin z/z - 1)/z^2 of z^2", sine, 0, T, lambda t: t, 5, 3),
    ("(cos z - 1 + z^2/2)/z^4 of z^2", cosine, 0, T, lambda t: t * t, 5, 2),
    ("(atan z/z - 1)/z^2 of z^2", arctangent, 0, mpf("0.1717"), lambda t: t, 9, 4),
    ("(1 - agm(1, sqrt(1 - x)))/x", agm_defect, 0, Y, lambda x: x, 6, 2),
    ("(4 q/k1 - 1)/k1^2 of k1^2", half_nome, 0, Y, lambda x: x, 5, 2),
    ("4 (1 - E(x)/K(x))/x", e_over_k, 0, X, lambda x: x, 3, 1),
]

if __name__ == "__main__":
    for name, f, low, high, weight, *degrees in FUNCTIONS:
        for bits, degree in zip((53, 24), degrees):
            c, error = remez(f, mpf(low) if low else mpf(10) ** -12, high, degree, weight)
            print(f"/* {name}, degree {degree}, p = {bits}: error 2^{nstr(log(error, 2), 4)} */")
            text = [f"VM_C({nstr(rounded(v, bits), 18 if bits == 53 else 10, min_fixed=-3, max_fixed=9)})" for v in c]
            for k in range(0, len(text), 4):
                print("    " + ", ".join(text[k:k + 4]) + ",")
