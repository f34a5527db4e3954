#!/usr/bin/env python3
"""Print the polynomial tables of ateb.h.

F(t) = sqrt(pi) Gamma(4 + q)/Gamma(q + 1/2), q = (1 + t)/2, -1 <= t <= 1: interpolation in the Chebyshev points,
turned into powers of t. F is analytic up to q = -4, so a coefficient is about 1/18 of the one before it. The leading
ones are given in two or three words.

g(q) = Pi - (alpha + 1), q = 1/(alpha + 1), for the quick route: in 32 intervals, powers of the distance to the middle,
the constant term and the slope in two words, the first of the slope's with half of the digits.
"""
from mpmath import mp, mpf, cos, pi, sqrt, gamma, polyval, log, nstr

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
    for i in range(32):
        middle, half = (i + mpf(1) / 2) / 32, mpf(1) / 64
        scaled = powers(lambda t: g(middle + half * t), degree)
        c = [x / half**j for j, x in enumerate(scaled)]
        high = [rounded(x, bits // 2 if j == 1 else bits) for j, x in enumerate(c)]
        low = [rounded(c[j] - high[j], bits) for j in (0, 1)]
        stored = [h + (low[j] if j < 2 else 0) for j, h in enumerate(high)]
        worst = max(worst, max(abs(polyval(stored[::-1], half * t / 20) - g(middle + half * t / 20))
                               for t in range(-20, 21)))
        print("{" + ", ".join(f"VM_C({nstr(v, digits, min_fixed=-3, max_fixed=2)})" for v in low + high) + "},")
    print(f"/* error 2^{nstr(log(worst, 2), 4)} */")


if __name__ == "__main__":
    table(53, 33, 22, 10)
    table(24, 17, 11, 5)
    quick(53, 9)
    quick(24, 5)
