#!/usr/bin/env python3
"""Write tests/data/jeffcott_table.h: radius and angle of circular whirl in arbitrary precision, from the averaged
equations: A by d(A^2 S)/dm = (1 - r) A^2 W with S^2 = g^2 + m k A^(alpha-1), W = (g + S)/m, and the angle as the integral
of W. Where g = 0 the radius is a power of the mass, and quadrature gives the angle; elsewhere mpmath's Taylor series
solve both equations together. Masses are m0 + m1 t (kind 0), m0 exp(m1 t) (1) and m0 (1 + m1 t)^2 (2)."""
import random
import struct
from mpmath import mp, mpf, exp, odefun, quad, sqrt

mp.dps = 30
random.seed(499)


def single(low, high):
    return struct.unpack("f", struct.pack("f", random.uniform(low, high)))[0]


MASSES = (lambda m0, m1, t: m0 + m1 * t, lambda m0, m1, t: m0 * exp(m1 * t), lambda m0, m1, t: m0 * (1 + m1 * t)**2)
RATES = (lambda m0, m1, t: m1, lambda m0, m1, t: m1 * m0 * exp(m1 * t), lambda m0, m1, t: 2 * m0 * m1 * (1 + m1 * t))


def without_gyro(kind, m0, m1, k, alpha, r, A0, sense, t):
    m = lambda time: MASSES[kind](m0, m1, time)
    A = lambda time: A0 * (m0 / m(time))**((2 * r - 1) / (alpha + 3))
    return A(t), sense * quad(lambda x: sqrt(k * A(x)**(alpha - 1) / m(x)), [0, t / 3, 2 * t / 3, t])


def with_gyro(kind, m0, m1, k, alpha, g, r, A0, sense, t):
    def rhs(part, y):
        time = t * part
        m, rate, A = MASSES[kind](m0, m1, time), RATES[kind](m0, m1, time), y[0]
        S = sense * sqrt(g * g + m * k * A**(alpha - 1))
        W = (g + S) / m
        # A^2 S grows: 2 A' S + A S' with 2 S S' = m' k A^(alpha-1) + m k (alpha-1) A^(alpha-2) A'
        right = (1 - r) * rate * A * W - A * rate * k * A**(alpha - 1) / (2 * S)
        return [right / (2 * S + m * k * (alpha - 1) * A**(alpha - 1) / (2 * S)) * t, W * t]

    with mp.workdps(20):
        return odefun(rhs, 0, [A0, mpf(0)], tol=mpf(10)**-17)(1)


with open("tests/data/jeffcott_table.h", "w") as file:
    file.write("/* Written by tests/gen/jeffcott_reference.py: kind and two numbers of the mass, k, alpha, g, r, radius, sense,"
               " t;\n   radius and angle at t */\n")
    for row in range(20):
        kind, sense, gyro = row % 3, (-1)**row, row % 5 > 1
        data = [single(1, 3), single(-0.02, 0.06), single(0.5, 3), single(1, 4) if row % 4 else 1.0,
                single(-0.5, 0.5) if gyro else 0.0, single(0, 1) if row % 6 else 1.0, single(0.5, 1.5)]
        t = single(-2, 4) if gyro else single(-5, 20)
        m0, m1, k, alpha, g, r, A0 = map(mpf, data)
        if gyro:
            A, psi = with_gyro(kind, m0, m1, k, alpha, g, r, A0, sense, mpf(t))
        else:
            A, psi = without_gyro(kind, m0, m1, k, alpha, r, A0, sense, mpf(t))
        file.write("    {" + ", ".join(map(repr, [kind, *data, sense, t, float(A), float(psi)])) + "},\n")
