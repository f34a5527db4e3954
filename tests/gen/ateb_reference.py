#!/usr/bin/env python3
"""Write tests/data/jacobi_table.h and tests/data/ateb_table.h: arbitrary-precision values at exactly the stored inputs.

Every value is given as high + low word (about 32 digits). About half of the inputs of each region are numbers of single
precision, which the float build of the tests uses; the double build uses all of them.

sn, cn, dn come from the descending Landen transformation in 60 digits and more, sa and ca from Newton's method on the
incomplete beta function as hypergeometric series; the script compares both with a second route of mpmath on a sample.
"""
import random
import struct
import sys
from mpmath import (mp, mpf, agm, cos, ellipe, ellipfun, ellipk, exp, expm1, floor, gamma, hyp2f1, log, log1p, nint, pi,
                    quad, sin, sqrt)

random.seed(20 if len(sys.argv) < 3 else int(sys.argv[2]))
DIGITS = 60


def single(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def words(x):
    high = float(x)
    return f"{high!r}, {float(x - mpf(high))!r}"


# ---- Ateb --------------------------------------------------------------------------------------------------------

def saca_first_quarter(r, d, q):
    """r and d, distances from the zeros of sa and ca; q = 1/(alpha + 1)"""
    def newton(f, x):  # f gives the Newton step; the last step is below 10^(-dps/2), its square rounding
        for _ in range(200):
            step = f(x)
            x += step
            if abs(step) <= mpf(10) ** (-mp.dps * 2 / 3) * abs(x):
                return x
        raise ArithmeticError("no convergence")

    if r < mpf("0.6"):
        v = newton(lambda v: (r - v * hyp2f1(mpf(1) / 2, 1 - q, mpf(3) / 2, v * v)) * (1 - v * v) ** (1 - q), r * (1 - r * r / 8))
        return v, (1 - v * v) ** q
    y = 2 * q * d
    if y == 0:
        return mpf(1), mpf(0)

    def step(z):  # unknown z = -ln |ca|^(alpha+1)
        v = sqrt(-expm1(-z))
        p = exp(-z) / (2 * (1 + v))
        value = -q * z + log(hyp2f1(1, 2 * q, 1 + q, p)) - log(y)
        return v * value / q * hyp2f1(1, 2 * q, 1 + q, p)

    z = newton(step, max(-log(y) / q, mpf(1) / 2))
    return sqrt(-expm1(-z)), exp(-q * z)


def saca(s, alpha):
    q = 1 / (1 + alpha)
    half = sqrt(pi) * gamma(1 + q) / gamma(q + mpf(1) / 2) / q / 2
    j = int(nint(abs(s) / half))
    rest = abs(s) - j * half
    r, d = (half - abs(rest), abs(rest)) if j % 2 else (abs(rest), half - abs(rest))
    v, u = saca_first_quarter(r, d, q)
    if j % 2:
        u = -u if rest > 0 else u
    else:
        v = -v if rest < 0 else v
    if j & 2:
        v, u = -v, -u
    return (v if s >= 0 else -v), u, 2 * half


def ateb_row(region, s, alpha):
    with mp.workdps(DIGITS + 2 * int(log1p(mpf(alpha)) / log(10)) + 20):
        sa, ca, period = saca(mpf(s), mpf(alpha))
        return f'    {{"{region}", {s!r}, {alpha!r}, {words(sa)}, {words(ca)}, {words(period)}}},'


def ateb_regions():
    uniform = random.uniform
    special = (0.0, 1e-6, 1e-3, 0.01, 0.1, 1 / 3, 0.5, 2 / 3, 1.0, 4 / 3, 1.5, 5 / 3, 2.0, 2.5, 3.0, 5.0, 7.0, 10.0, 30.0, 33.3, 100.0,
               1e3, 1e4, 1e6)

    def half(alpha):
        q = 1 / (1 + mpf(alpha))
        return float(sqrt(pi) * gamma(1 + q) / gamma(q + mpf(1) / 2) / q / 2)

    def alphas():
        for alpha in special:
            yield alpha
            yield single(alpha)
        for _ in range(12):
            yield single(10 ** uniform(-4, 6))
            yield 10 ** uniform(-4, 6)

    for k, alpha in enumerate(alphas()):
        near = single if k % 2 else float
        h = half(alpha)
        for _ in range(3):
            yield "first quarter", near(uniform(0, min(h, 2))), alpha
            yield "first quarter", near(uniform(0, h)), alpha
        yield "s near 0", near(10 ** uniform(-30, -2)), alpha
        yield "s near Pi/2", near(h * (1 - 10 ** uniform(-12, -2))), alpha
        yield "s near j Pi/2", near(h * random.choice((1, 2, 3, 4, 5, 31, 100, 199))), alpha
        yield "|s| < 100 Pi", near(uniform(-200, 200) * h), alpha
        if alpha <= 1e3:
            yield "|s| < 1e4", near(uniform(-1e4, 1e4)), alpha
        yield "|s| < 1e9", uniform(-1e9, 1e9), alpha
    for exponent in (-300, -20, 9, 12, 15, 20, 30, 33):
        alpha = 10.0 ** exponent
        yield "alpha extreme", 0.5, alpha
        yield "alpha extreme", 3.0, alpha
        yield "alpha extreme", single(0.3 * half(alpha)), single(alpha)
        for j in (1, 2, 3, 32, 99):
            yield "alpha extreme", j * half(alpha), alpha
            yield "alpha extreme", single(j * half(single(alpha))), single(alpha)
    for k in range(64):  # 1/(alpha + 1) at the edges of the table of Pi, where its errors are felt most
        for near in float, single:
            alpha = near(32 / (k // 2 + 0.4995 + 0.001 * (k % 2)) - 1)
            for j in (0, 1):
                j += int(127 * (alpha + 1) / half(alpha))
                yield "cells of Pi", near(j * half(alpha) + (-1) ** (k // 4) * j * half(alpha) / (1014 * (alpha + 1))), alpha


def check_ateb():
    with mp.workdps(30):
        for s, alpha in ((0.3, 0.5), (0.9, 2.5), (2.0, 3.0)):
            sa, ca, period = saca(mpf(s), mpf(alpha))
            assert abs(quad(lambda t: (1 - t * t) ** (1 / (1 + mpf(alpha)) - 1), [0, sa / 2, sa]) - s) < mpf(10) ** -20
            assert abs(sa ** 2 + ca ** (1 + mpf(alpha)) - 1) < mpf(10) ** -25
        sa, ca, period = saca(mpf(1), mpf(1))
        assert abs(sa - sin(1)) + abs(ca - cos(1)) + abs(period - pi) < mpf(10) ** -25
        sa, ca, period = saca(mpf(1), mpf(3))
        assert abs(ca - ellipfun("cn", 1 / sqrt(mpf(2)), m=mpf(1) / 2)) < mpf(10) ** -25


def write(name, comment, rows):
    with open(f"tests/data/{name}", "w") as file:
        file.write(f"/* Written by tests/gen/ateb_reference.py: {comment} */\n")
        file.write("\n".join(rows) + "\n")
    print(name, len(rows))


mp.dps = DIGITS
if len(sys.argv) > 3:  # ROUNDS SEED FILE: only sa and ca, that often anew
    with open(sys.argv[3], "w") as file:
        for _ in range(int(sys.argv[1])):
            file.writelines(ateb_row(*r) + "\n" for r in ateb_regions())
    sys.exit()
check_ateb()
write("ateb_table.h", "region, s, alpha, sa, ca, Pi_alpha as high and low words", [ateb_row(*r) for r in ateb_regions()])
