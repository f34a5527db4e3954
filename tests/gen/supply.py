"""What is left of tanks and grains (src/mechanics/supply.h) in 40 digits: tests/data/supply_table.h.

Every input has at most 24 bits, so that it is the same in float and double. The mass that is left runs from 2^-20 of
the full mass to 1 - 2^-20 of it. usage: python3 tests/gen/supply.py"""
import random

from mpmath import matrix, mp, mpf, sqrt

mp.dps = 40
random.seed(23)


def number(low, high):
    return mpf(int(random.uniform(low, high) * 2**12)) / 2**12


def revolution(e, axial, transverse):
    """axial e e^T + transverse (E - e e^T) as xx, yy, zz, xy, xz, yz"""
    outer = e * e.T
    t = axial * outer + transverse * (mp.eye(3) - outer)
    return [t[0, 0], t[1, 1], t[2, 2], t[0, 1], t[0, 2], t[1, 2]]


def left(kind, at, axis, length, radius, bore, full, m):
    e = matrix(axis) / sqrt(sum(a * a for a in axis))
    b = matrix(at)
    R2 = radius**2
    if kind == 0:
        h = length * m / full
        centre, next_at, rate = b + e * h / 2, b + e * h, e * length / full / 2
        inertia = revolution(e, m * R2 / 2, m * (R2 / 4 + h * h / 12))
        gyration = revolution(e, R2 / 2, R2 / 4)
        by_mass = revolution(e, R2 / 2, R2 / 4 + h * h / 4)
        size = h
    else:
        r2 = (m * bore**2 + (full - m) * R2) / full if kind == 2 else mpf(0)
        centre = next_at = b + e * length / 2
        rate = 0 * e
        inertia = revolution(e, m * (R2 + r2) / 2, m * ((R2 + r2) / 4 + length**2 / 12))
        gyration = by_mass = revolution(e, r2 if kind == 2 else R2 / 2,
                                        (r2 / 2 if kind == 2 else R2 / 4) + length**2 / 12)
        size = sqrt(r2) if kind == 2 else length
    return [size, *centre, *rate, *inertia, *by_mass, *next_at, *gyration]


def row(kind, fraction):
    at = [number(-4, 4) for _ in range(3)]
    axis = [number(-2, 2) for _ in range(3)]
    length, radius, bore, full = number(0.5, 5), number(0.5, 2), number(0.01, 0.49), mpf(random.randrange(1, 15))
    m = full * fraction
    inputs = [*at, *axis, length, radius, bore, full, m]
    return f"    {{{kind}, {{" + ", ".join(mp.nstr(x, 17) for x in inputs) + "}, {" + \
        ", ".join(mp.nstr(x, 20) for x in left(kind, at, axis, length, radius, bore, full, m)) + "}},"


fractions = [mpf(2)**-20, mpf(2)**-10, mpf(1) / 4, mpf(1) / 2, 1 - mpf(2)**-10, 1 - mpf(2)**-20]
with open("tests/data/supply_table.h", "w") as table:
    print("/* Written by tests/gen/supply.py: what is left of tanks and grains, in 40 digits. Inputs: at, axis, length, radius,"
          "\n   bore, full, mass. Outputs: size, centre, centre_by_mass, inertia, inertia_by_mass, store.at, store.gyration. */",
          file=table)
    print("static const struct {\n    int kind;\n    double in[11], out[28];\n} supply_table[] = {", file=table)
    for kind in range(3):
        for k in range(24):
            print(row(kind, fractions[k % len(fractions)]), file=table)
    print("};", file=table)
