#!/usr/bin/env python3
"""Write tests/data/loads_table.h: oscillators with a velocity u of the mass that joins or leaves and a damping by a law
of time. Motions for alpha = 1, m = m0 + m1 t and constant u are Bessel functions about the shifted middle m1 u/k; for
alpha = 3, linear mass and u and an exponential damping mpmath's Taylor series solve the equation. Integrals of f/g by
mpmath's quadrature. All inputs are floats."""
import random
import struct
from mpmath import mp, mpf, besselj, bessely, diff, exp, lu_solve, matrix, odefun, quad, sqrt

mp.dps = 30
random.seed(248)


def single(low, high):
    return struct.unpack("f", struct.pack("f", random.uniform(low, high)))[0]


def bessel(k, m0, m1, u, x0, v0, t):
    """(m x')' + k x = m1 u: x - m1 u/k = c1 J0(s) + c2 Y0(s), s = 2 sqrt(k m)/|m1|"""
    s = lambda time: 2 * sqrt(k * (m0 + m1 * time)) / abs(m1)
    J, Y, rest = lambda time: besselj(0, s(time)), lambda time: bessely(0, s(time)), m1 * u / k
    c = lu_solve(matrix([[J(0), Y(0)], [diff(J, 0), diff(Y, 0)]]), matrix([x0 - rest, v0]))
    return rest + c[0] * J(t) + c[1] * Y(t), c[0] * diff(J, t) + c[1] * diff(Y, t)


def cubic(k, m0, m1, r, u0, u1, b0, b1, x0, v0, t):
    def rhs(time, y):
        push = r * m1 * (u0 + u1 * time - y[1]) - b0 * exp(b1 * time) * y[1]
        return [y[1], (push - k * y[0] ** 3) / (m0 + m1 * time)]

    return odefun(rhs, 0, [x0, v0], tol=mpf(10) ** -22)(t)


with open("tests/data/loads_table.h", "w") as file:
    file.write("/* Written by tests/gen/loads_reference.py */\n")
    file.write("#ifdef LOADS_BESSEL /* k, m0, m1, u, x0, v0, t; x, v */\n")
    for row in range(12):
        data = [single(1, 4), single(1, 3), single(0.02, 0.2) * (-1) ** row, single(-3, 3), single(-1, 1),
                single(-1, 1), single(1, 10 if row % 2 == 0 else 4)]
        x, v = bessel(*map(mpf, data))
        file.write("    {" + ", ".join(map(repr, data + [float(x), float(v)])) + "},\n")
    file.write("#endif\n#ifdef LOADS_CUBIC /* k, m0, m1, r, u0, u1, b0, b1, x0, v0, t; x, v */\n")
    for row in range(8):
        data = [single(1, 4), single(1, 3), single(-0.1, 0.2), single(0, 1), single(-2, 2), single(-0.3, 0.3),
                single(0, 0.1), single(-0.2, 0.2), single(0.5, 1), single(-1, 1), single(1, 6)]
        x, v = cubic(*map(mpf, data))
        file.write("    {" + ", ".join(map(repr, data + [float(x), float(v)])) + "},\n")
    file.write("#endif\n#ifdef LOADS_INTEGRAL /* kinds of f and g (0 linear, 1 quadratic, 2 exponential, 3 power), their"
               " numbers, t; the\n   integral of f/g, the integral of |f|/g */\n")
    laws = (lambda a, t: a[0] + a[1] * t, lambda a, t: a[0] + a[1] * t + a[2] * t * t, lambda a, t: a[0] * exp(a[1] * t),
            lambda a, t: a[0] * (1 + a[1] * t) ** a[2])
    for row in range(32):
        f, g = row % 4, row // 4 % 4
        a = [single(-1, 1), single(-0.1, 0.1), single(-1, 1)]
        b = [single(1, 2), single(-0.05, 0.1), single(-0.5, 2) if g == 3 else single(0, 0.01)]
        if row > 15:
            b[1] = a[1]  # the same base: closed forms
        if row % 8 == 4:
            a[1] = 0.0
        t = single(-3, 8)
        A, B, T = [mpf(x) for x in a], [mpf(x) for x in b], mpf(t)
        parts = [0, T / 4, T / 2, 3 * T / 4, T]
        value = quad(lambda x: laws[f](A, x) / laws[g](B, x), parts)
        size = quad(lambda x: abs(laws[f](A, x)) / laws[g](B, x), parts)
        file.write("    {" + ", ".join(map(repr, [f, g, *a, *b, t, float(value), abs(float(size))])) + "},\n")
    file.write("#endif\n")
