#!/usr/bin/env python3
"""Writes tests/data/attitude_table.h: Euler's angles and modified Rodrigues parameters of quaternions, by mpmath.
usage: attitude.py, from the top of the project"""
import random
import struct

from mpmath import atan2, mp, mpf, sqrt

mp.dps = 80
random.seed(7)


def rounded(x, single):
    return struct.unpack("f", struct.pack("f", x))[0] if single else float(x)


def unit(single):
    return rounded(random.uniform(-1, 1), single)


def tiny(single):
    least = 12 if single else 60
    return rounded(random.uniform(-1, 1) * 10 ** -random.uniform(2, least), single)


def quotient(a, b, c, single):
    """a b / c rounded, and a few units in the last place away"""
    x = rounded(a * b / c, single)
    step = 2.0 ** -23 if single else 2.0 ** -52
    return rounded(x * (1 + random.randrange(-2, 3) * step), single)


def random_rows(single):
    w, x, y, z = (unit(single) for _ in range(4))
    yield "random", (w, x, y, z)
    yield "3-1-3, theta next to 0", (w, tiny(single), tiny(single), z)
    yield "3-1-3, theta next to pi", (tiny(single), x, y, tiny(single))
    yield "3-2-1, pitch next to 90", (w, x, quotient(w, 1, 1, single), quotient(-x, 1, 1, single))
    yield "3-2-1, pitch next to -90", (w, x, quotient(-w, 1, 1, single), quotient(x, 1, 1, single))
    yield "yaw next to 0", (w, x, y, quotient(-x, y, w, single))
    yield "roll next to 0", (w, quotient(-y, z, w, single), y, z)
    yield "pitch next to 0", (w, x, quotient(x, z, w, single), z)
    yield "psi next to 0", (w, x, quotient(-x, z, w, single), z)
    yield "turn next to 180", (tiny(single), x, y, z)
    yield "small turn", (w, tiny(single), tiny(single), tiny(single))
    if not single:
        factor = 2.0 ** random.choice((-500, 500, 900))
        yield "other lengths", (w * factor, x * factor, y * factor, z * factor)


def singular_rows():
    yield "locked", (1.0, 0.0, 0.0, 0.5)
    yield "locked", (0.0, -0.25, 1.0, 0.0)
    yield "locked", (0.5, 0.25, 0.5, -0.25)
    yield "locked", (0.5, -0.25, -0.5, -0.25)
    yield "identity", (0.0, 0.0, 0.0, 0.0)
    yield "identity", (-3.0, 0.0, 0.0, 0.0)
    for axis in range(3):
        q = [0.0, 0.0, 0.0, 0.0]
        q[1 + axis] = -1.0
        yield "half a turn", tuple(q)
        q[0] = 1.0
        yield "quarter turn", tuple(q)


def angle(y, x):
    return atan2(y, x) if x or y else mpf(0)


def angles_of(p, r):
    if p == (0, 0):
        p = r
    if r == (0, 0):
        r = p
    first = angle(p[1] * r[0] + p[0] * r[1], p[0] * r[0] - p[1] * r[1])
    third = angle(p[1] * r[0] - p[0] * r[1], p[0] * r[0] + p[1] * r[1])
    return first, third


def reference(q):
    w, x, y, z = (mpf(c) for c in q)
    n = sqrt(w * w + x * x + y * y + z * z)
    if n == 0:
        w = n = mpf(1)
    psi, phi = angles_of((w, z), (x, y))
    theta = 2 * angle(sqrt(x * x + y * y), sqrt(w * w + z * z))
    yaw, roll = angles_of((w - y, x + z), (w + y, z - x))
    sine, cosine = 2 * (w * y - x * z), sqrt((w - y) ** 2 + (x + z) ** 2) * sqrt((w + y) ** 2 + (z - x) ** 2)
    divisor = n + w if w >= 0 else w - n
    return [psi, theta, phi, yaw, angle(sine, cosine), roll, x / divisor, y / divisor, z / divisor]


def words(x):
    high = float(x)
    return f"{{{high!r}, {float(x - mpf(high))!r}}}"


def main():
    rows = list(singular_rows())
    for i in range(16):
        for single in (False, True):
            rows += random_rows(single)
    with open("tests/data/attitude_table.h", "w") as file:
        file.write("/* Written by tests/gen/attitude.py: a quaternion w, x, y, z; psi, theta, phi (3-1-3), yaw, pitch, roll\n"
                   "   (3-2-1) and the modified Rodrigues parameters, each as the sum of two numbers. */\n")
        file.write("static const attitude_row attitude_table[] = {\n")
        for name, q in rows:
            numbers = ", ".join(repr(c) for c in q)
            values = ", ".join(words(v) for v in reference(q))
            file.write(f'    {{"{name}", {{{numbers}}},\n     {{{values}}}}},\n')
        file.write("};\n")


main()
