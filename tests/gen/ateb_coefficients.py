#!/usr/bin/env python3
"""Print the polynomial tables of ateb.h.

F(t) = sqrt(pi) Gamma(4 + q)/Gamma(q + 1/2), q = (1 + t)/2, -1 <= t <= 1: interpolation in the Chebyshev points,
turned into powers of t. F is analytic up to q = -4, so a coefficient is about 1/18 of the one before it. The leading
ones are given in two or three words.

g(q) = Pi - (alpha + 1), q = 1/(alpha + 1), for the quick route: powers of the distance to the nearest multiple of 1/32,
the constant term and the slope in two words, the first of the slope's with half of the digits.

The logarithm and the exponential of one word: ln((1 + t)/(1 - t)) = 2 t + t^3 L(t^2), e^z = 1 + z + z^2 E(z). The rough
ones, of base 2: log2((1 + t)/(1 - t)) = t L(t^2), 2^z/4.

The remainder of Stirling's formula: z delta(z), z >= 6, in powers of 1/z^2.

What the Pade approximant of p/(X/4) lacks beyond r = 0.55: (X/4)^3 q (1 - q) (cubic in q + (X/4) (linear in q)), by least
squares of the relative error.
"""
from mpmath import mp, mpf, atanh, binomial, cos, expm1, loggamma, lu_solve, matrix, pi, sqrt, gamma, polyval, log, nstr

mp.dps = 60


def powers(f, degree):
    n = degree + 1
    node = [cos(pi * (k + mpf(1) / 2) / n) for k in range(n)]
    value = [f(x) for x in node]
    coefficient = [2 / mpf(n) * sum(value[k] * cos(pi * j * (k + mpf(1) / 2) / n) for k in range(n)) for j in range(n)]
    coefficient[0] /= 2
    total, before, now = [mpf(0)] * n, None, [mpf(1)]
    for j in range(n):
        for i, a in enumerate(now):
            total[i] += coefficient[j] * a
        following = [mpf(0)] + [(2 if j else 1) * a for a in now]
        for i, a in enumerate(before or []):
            following[i] -= a
        before, now = now, following
    return total


def F(t):
    return sqrt(pi) * gamma(4 + (1 + t) / 2) / gamma(1 + t / 2)


def rounded(x, bits):
    mp.prec, kept = bits, mp.prec
    y = +x
    mp.prec = kept
    return y


def table(bits, degree, two_words, three_words):
    c = powers(F, degree)
    high = [rounded(x, bits) for x in c]
    low = [rounded(x - h, bits) if j < two_words else mpf(0) for j, (x, h) in enumerate(zip(c, high))]
    lowest = [rounded(x - h - l, bits) if j < three_words else mpf(0) for j, (x, h, l) in enumerate(zip(c, high, low))]
    for text, stored in (("two words", [h + l for h, l in zip(high, low)]),
                         ("three words", [h + l + m for h, l, m in zip(high, low, lowest)])):
        error = max(abs(polyval(stored[::-1], t) / F(t) - 1) for t in (mpf(k) / 500 - 1 for k in range(1001)))
        print(f"/* p = {bits}, degree {degree}, {text}: relative error 2^{nstr(log(error, 2), 4)} */")
    for name, values in (("high", high), ("low", low[:two_words]), ("lowest", lowest[:three_words])):
        print(f"{name}:")
        text = [f"VM_C({nstr(v, 20 if bits == 53 else 12, min_fixed=0, max_fixed=0)})" for v in values]
        for k in range(0, len(text), 3):
            print("    " + ", ".join(text[k:k + 3]) + ",")


def g(q):
    if q == 0:
        return 2 * log(2)
    return (sqrt(pi) * gamma(1 + q) / gamma(q + mpf(1) / 2) - 1) / q


def quick(bits, degree):
    digits = 20 if bits == 53 else 12
    print(f"/* p = {bits}, g, degree {degree} */")
    worst = mpf(0)
    for i in range(33):
        middle, half = mpf(i) / 32, mpf(1) / 64
        scaled = powers(lambda t: g(middle + half * t), degree)
        c = [x / half**j for j, x in enumerate(scaled)]
        high = [rounded(x, bits // 2 if j == 1 else bits) for j, x in enumerate(c)]
        low = [rounded(c[j] - high[j], bits) for j in (0, 1)]
        stored = [h + (low[j] if j < 2 else 0) for j, h in enumerate(high)]
        worst = max(worst, max(abs(polyval(stored[::-1], half * t / 20) - g(middle + half * t / 20))
                               for t in range(-20, 21)))
        print("{" + ", ".join(f"VM_C({nstr(v, digits, min_fixed=-3, max_fixed=2)})" for v in low + high) + "},")
    print(f"/* error 2^{nstr(log(worst, 2), 4)} */")


def L(x):
    t = sqrt(x)
    return (2 * atanh(t) - 2 * t) / t**3


def E(z):
    return (expm1(z) - z) / z**2


def remainder(w):
    """z delta(z) for z = 1/sqrt(w), delta(z) = ln Gamma(z) - (z - 1/2) ln z + z - ln(2 pi)/2"""
    z = 1 / sqrt(w)
    return z * (loggamma(z) - (z - mpf(1) / 2) * log(z) + z - log(2 * pi) / 2)


def interpolated(name, f, low, high, degree, digits):
    """coefficients of the powers of x itself, by interpolation in the Chebyshev points of low .. high"""
    middle, half = mpf(low + high) / 2, mpf(high - low) / 2
    c = powers(lambda t: f(middle + half * t), degree)
    total = [sum(c[j] * binomial(j, i) * (-middle)**(j - i) / half**j for j in range(i, degree + 1))
             for i in range(degree + 1)]
    error = max(abs(polyval(total[::-1], x) - f(x)) for x in (low + (high - low) * mpf(k + mpf(1) / 3) / 400 for k in range(400)))
    print(f"/* {name}: error 2^{nstr(log(error, 2), 4)} */ " + ", ".join(nstr(x, digits) for x in total))


def ratio_series(q, terms=70):
    """coefficients of p/(X/4) in powers of X, from v' and u' (275)"""
    alpha, u, v, w = 1 / q - 1, [mpf(1)], [mpf(1)], [mpf(1)]
    for j in range(1, terms):
        v.append(-w[j - 1] / (2 * j))
        u.append(v[j] * q / (q + j))
        w.append(sum((alpha * i - (j - i)) * u[i] * w[j - i] for i in range(1, j + 1)) / j)
    return [-2 * c for c in v[1:]]


def lacks():
    rows, rest = [], []
    for k in range(24):
        q = (1 - cos(pi * (k + mpf(1) / 2) / 24)) / 2
        half = (1 / q + g(q)) / 2
        series, limit = ratio_series(q), (2 * q * (half - mpf("0.55")))**(1 / q) / 4
        for i in range(24):
            x = limit * (1 - cos(pi * (i + mpf(1) / 2) / 24)) / 2
            pade = (1 + q) * (2 + q - q * x) / ((1 + q) * (2 + q) + 2 * (1 - q - q * q) * x)
            cube = x**3 * q * (1 - q)
            rows.append([cube, cube * q, cube * q**2, cube * q**3, cube * x, cube * x * q])
            rest.append(polyval(series[::-1], 4 * x) / pade - 1)
    A, b = matrix(rows), matrix(rest)
    c = lu_solve(A.T * A, A.T * b)
    print(f"/* lacks: error {nstr(max(abs(e) for e in A * c - b), 3)} */ " + ", ".join(nstr(x, 7) for x in c))


if __name__ == "__main__":
    mp.dps = 30
    lacks()
    interpolated("rough log2", lambda x: 2 * atanh(sqrt(x)) / sqrt(x) / log(2), mpf(0), mpf("0.02944"), 2, 10)
    interpolated("rough 2^z/4", lambda z: mpf(2)**z / 4, mpf("-0.5"), mpf("0.5"), 5, 10)
    mp.dps = 60
    table(53, 33, 22, 10)
    table(24, 17, 11, 5)
    quick(53, 9)
    quick(24, 5)
    for degree, digits in ((6, 20), (2, 12)):
        interpolated("L", L, mpf(0), mpf("0.0325"), degree, digits)
    for degree, digits in ((10, 20), (5, 12)):
        interpolated("E", E, mpf("-0.37"), mpf("0.36"), degree, digits)
    for degree, digits in ((8, 20), (3, 12)):
        interpolated("delta", remainder, mpf(0), 1 / mpf(36), degree, digits)
