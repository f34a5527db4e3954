#!/usr/bin/env python3
"""Write tests/data/drum_table.h: the drum on a rigid shaft, (196), (197), its inverse and the stop angle, at exactly
the stored data. Every other row is made of floats. By the closed forms (196), (197) as they are written, in 250
digits, which is what e and k1 next to zero cost."""
import random
import struct
from mpmath import mp, mpf, exp, fabs, log, sqrt

mp.dps = 250
random.seed(52)


def single(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def words(x):
    high = float(x)
    return f"{high!r}, {float(x - mpf(high)):.9g}"


def time(phi, J0, j, e, omega):
    if e == 0:
        return (phi + j * phi**2 / (2 * J0)) / omega
    y = log(1 + e * phi / (J0 * omega))
    return J0 / e * y + j / e * (phi - J0 * omega / e * y)


def angle(t, J0, j, e, omega):
    """By Newton's method in y = ln(1 + x), from above, where (197) is convex"""
    if e == 0:
        return J0 / j * (sqrt(1 + 2 * j * omega * t / J0) - 1)
    rho, w = j * omega / e, e * t / J0
    y = 2 * w / (1 + sqrt(1 + 2 * rho * w))
    if e > 0:
        y = min(y, log(1 + w / rho + y))
    for _ in range(400):
        step = (w - y - rho * (exp(y) - 1 - y)) / (1 + rho * (exp(y) - 1))
        y += step
        if fabs(step) < mpf(10) ** -150 * fabs(y):
            return J0 * omega / e * (exp(y) - 1)
    raise ArithmeticError


def drum(kind, near, wide):
    size = lambda low, high: 10 ** random.uniform(low, high)
    sign = random.choice((-1, 1))
    R, J0, mu, omega = near(size(-1, 1)), near(size(-wide, wide)), near(size(-wide, wide)), near(size(-1, 1))
    v, D = near(omega * R * size(-wide, wide)), 0.0
    j, eps = mu * R * R, 1e-7 if near is single else 1e-16
    if kind == "any e":
        D = near(mu * v * R * size(-2, 2))
    elif kind == "e near 0":
        D = near(mu * v * R * (1 + sign * size(-1, 0) * random.choice((eps, eps**0.5, 0.01))))
    elif kind == "e = 0":
        v = 0.0
    elif kind == "k1 near 0":
        v, D = near(omega * R), near(sign * j * omega * random.choice((1e-30, eps, eps**0.5, 0.01)) * size(-1, 0))
    elif kind == "k1 = 0":
        R, v = near(1.0), omega
    elif kind == "e large":
        D = -near(j * omega * size(2, 20 if near is float else 12))
    elif kind == "at the stop":
        D = near(mu * v * R + j * omega * size(-2, 2))
    return R, J0, mu, v, D, omega


KINDS = ("any e", "e near 0", "e = 0", "k1 near 0", "k1 = 0", "e large", "at the stop", "e > 0")
with open("tests/data/drum_table.h", "w") as file:
    file.write("/* Written by tests/gen/drum_reference.py: region, R, J0, mu, v, D, Omega_b; phi, phi'(phi), t(phi); t,"
               " phi(t); stop angle\n   (0: none); results as high and low words */\n")
    count = 0
    while count < 136:
        near, kind, wide = (single, float)[count % 2], KINDS[count // 2 % 8], 1.5 if count % 3 else 6
        data = drum(kind, near, wide)
        R, J0, mu, v, D, omega = (mpf(x) for x in data)
        j, e = mu * R * R, mu * v * R - D
        stop = J0 * omega / -e if e < 0 else None
        phi = near(10 ** random.uniform(-4, 3) if wide < 2 else 10 ** random.uniform(-12, 12))
        if kind == "at the stop":
            phi = near(float(stop) * (1 - 10 ** random.uniform(-6 if near is single else -15, -1)))
        if stop and phi >= stop:
            phi = near(float(stop) * random.random())
        t = near(10 ** random.uniform(-4, 3) / (data[5] if wide < 2 else 10 ** random.uniform(-6, 6)))
        if e > 0 and kind == "e large":
            t = near(float(J0 / e) * 10 ** random.uniform(-2, 1.9))
        results = (J0 * omega + e * phi) / (J0 + j * phi), time(mpf(phi), J0, j, e, omega), \
            angle(mpf(t), J0, j, e, omega)
        if not all(1e-30 < x < 1e30 for x in results):
            continue
        file.write(f'    {{"{kind}", {", ".join(repr(x) for x in data)}, {phi!r}, {words(results[0])}, '
                   f'{words(results[1])}, {t!r}, {words(results[2])}, {words(stop) if stop else "0, 0"}}},\n')
        count += 1
