#!/usr/bin/env python3
"""Writes tests/data/rotor_linear.h and rotor_eigenvalues.h: the broken rotor by mpmath, with 40 digits.

rotor_linear.h: x, y, psi and their rates at t of (69), complete and without its coupling term, by the exponential of
the 7 by 7 matrix; each with its condition number, the sum of |d result/d input * input| over all inputs, so that
eps times it is what one rounding of the inputs does.
rotor_eigenvalues.h: the roots of (81) corrected, over lambda, with their condition numbers against relative changes
of the coefficients. Inputs are numbers of type float. usage: rotor_reference.py"""
import os
import random
import struct
from mpmath import mp, mpf, matrix, expm, polyroots

mp.dps = 40
random.seed(20)
DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "data")


def single(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def spread(low, high):
    """Of either sign, its logarithm uniform"""
    return single(random.choice((-1, 1)) * 10 ** random.uniform(low, high))


def linear(mass, inertia, stiffness, damping, torque, s, t, x0, y0, psi0, vx0, vy0, rate0, coupled):
    w2, k, drive = stiffness / mass, damping / inertia, torque / inertia
    a = matrix(7, 7)  # x y psi vx vy rate 1
    a[0, 3] = a[1, 4] = a[2, 5] = 1
    a[3, 0], a[3, 6] = -w2, -s * w2
    a[4, 1], a[4, 2] = -w2, -s * w2
    a[5, 5], a[5, 6] = -k, drive
    if coupled:
        a[5, 1] = -s * stiffness / inertia
    return expm(a * t, method="taylor") * matrix([x0, y0, psi0, vx0, vy0, rate0, 1])


def with_condition(inputs, coupled):
    inputs = [mpf(x) for x in inputs]
    values, h = linear(*inputs, coupled), mpf(10) ** -16
    condition = [mpf(0)] * 6
    for i, x in enumerate(inputs):
        if x == 0:
            continue
        up, down = list(inputs), list(inputs)
        up[i], down[i] = x * (1 + h), x * (1 - h)
        up, down = linear(*up, coupled), linear(*down, coupled)
        condition = [c + abs(up[j] - down[j]) / (2 * h) for j, c in enumerate(condition)]
    return values, condition


def linear_cases():
    for n in range(60):
        mass, inertia = abs(spread(-1, 1)), abs(spread(-1, 1))
        omega, k = 10 ** random.uniform(-4, 2), 10 ** random.uniform(-4, 2)
        stiffness, damping = single(mass * omega**2), single(inertia * k)
        s, torque, t = spread(-2, 0), spread(-1, 1), spread(-3, 0)
        if n % 3 == 0:
            t = single(random.uniform(1, 30) / max(omega, k))
        start = [spread(-2, 0) for _ in range(6)]
        zero = n % 10
        if zero == 1:
            damping = 0
        if zero == 2:
            stiffness = 0
        if zero == 3:
            damping = stiffness = 0
        if zero == 4:
            s = 0
        if zero == 5:
            torque = damping = 0
        if zero == 6:
            damping = -damping
        if zero == 7:
            start = [0, 0, start[2], 0, 0, start[5]]
        yield [mass, inertia, stiffness, damping, torque, s, t] + start


def number(x):
    return mp.nstr(x, 22, strip_zeros=False, min_fixed=-2, max_fixed=3)


def write_linear():
    with open(os.path.join(DATA, "rotor_linear.h"), "w") as out:
        out.write("/* written by tests/gen/rotor_reference.py: {mass, inertia, stiffness, damping, torque, s}, t, start,\n"
                  "   coupled, {x, y, psi, x', y', psi'}, their condition numbers */\n")
        for case in linear_cases():
            for coupled in (0, 1):
                values, condition = with_condition(case, coupled)
                out.write("{{%s},\n %r, {%s}, %d,\n {%s},\n {%s}},\n" % (
                    ", ".join(repr(x) for x in case[:6]), case[6], ", ".join(repr(x) for x in case[7:]), coupled,
                    ", ".join(number(x) for x in values[:6]), ", ".join(mp.nstr(x, 5) for x in condition)))


def eigenvalue_cases():
    near = [2.0**-k for k in (2, 5, 8, 11)]
    for n in range(24):
        mass, inertia, s, damping = (abs(spread(-1, 1)) for _ in range(4))
        omega = single(10 ** random.uniform(-1, 1))
        stiffness = single(mass * omega**2)
        Omega = single(omega * 10 ** random.uniform(-1, 0.5))
        if n % 4 == 0:
            mass, stiffness, Omega = 1.0, 1.0, 1 + random.choice((-1, 1)) * near[n // 4 % 4]
        if n % 6 == 5:
            s = 0.0
        if n % 6 == 4:
            damping = 0.0
        yield mass, inertia, stiffness, damping, s, Omega


def write_eigenvalues():
    with open(os.path.join(DATA, "rotor_eigenvalues.h"), "w") as out:
        out.write("/* written by tests/gen/rotor_reference.py: {mass, inertia, stiffness, damping, 0, s}, Omega, real\n"
                  "   and imaginary parts of the roots of (81) over lambda, condition numbers */\n")
        for case in eigenvalue_cases():
            mass, inertia, stiffness, damping, s, Omega = (mpf(x) for x in case)
            w2, O2, k = stiffness / mass, Omega**2, damping / inertia
            D = w2 - O2
            G = s**2 * stiffness**2 / (mass * inertia * D)
            c = [mpf(1), k, 2 * (w2 + O2) + G, 2 * k * (w2 + O2), D**2 + G * (w2 + 3 * O2), k * D**2]
            roots = polyroots(c, maxsteps=500, extraprec=400)
            slope = [sum((5 - j) * c[j] * z ** (4 - j) for j in range(5)) for z in roots]
            condition = [sum(abs(c[j]) * abs(z) ** (5 - j) for j in range(6)) / abs(d) for z, d in zip(roots, slope)]
            out.write("{{%r, %r, %r, %r, 0, %r}, %r,\n {%s},\n {%s},\n {%s}},\n" % (
                case[0], case[1], case[2], case[3], case[4], case[5],
                ", ".join(number(mp.re(z)) for z in roots), ", ".join(number(mp.im(z)) for z in roots),
                ", ".join(mp.nstr(x, 5) for x in condition)))


write_linear()
write_eigenvalues()
