#!/usr/bin/env python3
"""Write tests/data/lambert_table.h: both real branches of Lambert's W, from the argument and from its logarithm, and
the kernels expm1 and log1p beneath, at the exact value of the stored argument. Every other argument is a float.

The branches are solved for as w = -1 - v, v - ln(1 + v) = s, or w + ln|w| = l, in 80 digits, and compared with
mpmath's lambertw where that applies."""
import random
import struct
from mpmath import mp, mpf, e, exp, expm1, fabs, lambertw, log, log1p, sqrt

mp.dps = 80
random.seed(7)
W0, WM1, W0_EXP, W0_MEXP, WM1_MEXP, EXPM1, LOG1P = range(7)


def single(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def near(s, sign):
    """-1 - v of v - ln(1 + v) = s, v of this sign"""
    if s <= 0:
        return mpf(-1)
    root = sign * sqrt(2 * s)
    v = root + s if sign > 0 else max(root * (1 + root / 3 + root**2 / 36), -1 + exp(-s - 1))
    for _ in range(300):
        step = (s - (v - log1p(v))) * (1 + v) / v
        while v + step <= -1 or v * (v + step) <= 0:
            step /= 2
        v += step
        if fabs(step) < mpf(10)**-70 * fabs(v) * (1 + v):
            return -1 - v
    raise ValueError(s)


def far(l, sign):
    """w of w + ln|w| = l, w of this sign, above -1"""
    w = sign * (exp(l) if l < 0 else l + 1)
    if sign < 0 or l < 0:
        w = w / (1 + w) if w > mpf(-0.4) else w
    for _ in range(300):
        step = w * (l - log(fabs(w)) - w) / (1 + w)
        w += step
        if fabs(step) < mpf(10)**-70 * fabs(w):
            return w
    raise ValueError(l)


def value(form, x):
    x = mpf(x)
    if form in (W0, WM1) and x < 0:
        if form == W0 and x > -0.3:
            return far(log(-x), -1)
        return near(-1 - log(-x), 1 if form == WM1 else -1)
    if form == W0:
        return far(log(x), 1)
    if form == W0_EXP:
        return far(x, 1)
    if form == W0_MEXP:
        return far(x, -1) if x < -1.2 else near(-1 - x, -1)
    if form == WM1_MEXP:
        return near(-1 - x, 1)
    return expm1(x) if form == EXPM1 else log1p(x)


def arguments(form, shape, large):
    """One random argument, for a type whose largest number is e^large"""
    size = lambda low, high: 10**random.uniform(low, high)
    eps = 2.3e-16 if large > 100 else 1.2e-7
    decades = large * 0.4342
    if form == W0:
        return (size(-3, 3), size(-decades, decades), -0.36787944 * random.random(), -size(-decades, -0.5),
                -1 / float(e) + size(-15.7 if large > 100 else -7, -1))[shape % 5]
    if form == WM1:
        return (-0.36787944 * random.random(), -size(-decades, -0.5),
                -1 / float(e) + size(-15.7 if large > 100 else -7, -1))[shape % 3]
    if form == W0_EXP:
        return (random.uniform(-3, 5), random.uniform(-large, large), size(0, decades - 0.1))[shape % 3]
    if form in (W0_MEXP, WM1_MEXP):
        return (-1 - size(-15.3 if large > 100 else -6.5, 0), -random.uniform(1, 3), -random.uniform(1, large),
                -size(0, decades - 0.1))[shape % (3 if form == W0_MEXP else 4)]
    if form == EXPM1:
        return random.choice((-1, 1)) * (size(-18, 0), random.uniform(0, large - 1))[shape % 2]
    return (random.choice((-1, 1)) * size(-18, -0.01), size(-2, decades - 10), -1 + size(-15, 0) + eps)[shape % 3]


FIXED = {
    W0: [-0.25, -0.3678794411714423, -0.36787942051887512, single(-0.3678794), single(-0.36787942), 0.9999999, 1.0,
         float(single(2.718281828)), 5e-324, -5e-324, 2.2250738585072014e-308, 1.7976931348623157e308,
         single(3.4028235e38), single(1e-45), -single(1e-45), 1e-300],
    WM1: [-0.25, -0.3678794411714423, single(-0.3678794), single(-0.36787942), -5e-324, -2.2250738585072014e-308,
          -single(1e-45), -0.2500000001, -0.2499999999],
    W0_EXP: [0.0, 1.0, -869 * 2.302585092994046, -37.0, -36.0, 40.0, 39.0, -744.0, 1e300, single(3e38)],
    W0_MEXP: [-1.0, -1.375, -1.3749999, -1.3750001, -36.0, -39.0, -17.5, -18.5, -744.0, -103.0],
    WM1_MEXP: [-1.0, -869 * 2.302585092994046, single(-2000.9), -1e300, single(-3e38), -4.5e15, -4.6e15, -8388600.0,
               -8388616.0],
    EXPM1: [0.25, -0.25, 0.34, 0.36, -0.36, 709.7, -745.0, single(88.7), 1e-300],
    LOG1P: [0.25, -0.25, 1e-300, 5e-17, 1.2e-16, -1.2e-16, 3e-16, single(6e-8), single(-6e-8), single(1.3e-7)],
}
COUNT = {W0: 110, WM1: 80, W0_EXP: 60, W0_MEXP: 50, WM1_MEXP: 60, EXPM1: 60, LOG1P: 60}


def compare(form, x, w):
    if form in (W0, WM1):
        mp.dps = 120
        other = lambertw(mpf(x), 0 if form == W0 else -1)
        mp.dps = 80
        if fabs(other - w) > mpf(10)**-40 * fabs(w):
            raise ValueError(f"{form} {x!r}: {w} or {other}")


with open("tests/data/lambert_table.h", "w") as file:
    file.write("/* Written by tests/gen/lambert_reference.py: form (0 W0, 1 W_-1, 2 W0(e^x), 3 W0(-e^x), "
               "4 W_-1(-e^x), 5 expm1,\n   6 log1p), x, value as high and low words */\n")
    for form in range(7):
        points = list(FIXED[form])
        for count in range(COUNT[form]):
            floats = count % 2
            x = arguments(form, count // 2, 88 if floats else 700)
            points.append(single(x) if floats else x)
        for x in points:
            inside = -1 / e <= x if form == W0 else -1 / e <= x < 0 if form == WM1 else True
            if x in (0, -1) and form in (W0, WM1, LOG1P) or not inside or x <= -1 and form == LOG1P:
                continue
            w = value(form, x)
            compare(form, x, w)
            high = float(w)
            file.write(f"    {{{form}, {x!r}, {high!r}, {float(w - mpf(high)):.9g}}},\n")
