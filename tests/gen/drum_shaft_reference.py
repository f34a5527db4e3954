#!/usr/bin/env python3
"""Write tests/data/drum_shaft_table.h: deflection and slope of the drum's elastic shaft by (224) corrected, and amplitude
and phase from a start, at exactly the stored data, which are floats. The slope is the derivative of the deflection by
mpmath's differences in 60 digits; amplitude and phase solve the two equations at phi = 0."""
import random
import struct
from mpmath import mp, mpf, atan2, cos, diff, exp, hypot, quad, sqrt

mp.dps = 60
random.seed(218)


def single(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def deflection(k, delta, A, particular, phi, a, alpha):
    phase = quad(lambda x: k * sqrt(1 - A * x), [0, phi])
    return a * (1 - A * phi) ** (-mpf(1) / 4) * exp(-delta * phi) * cos(phase + alpha) + particular / (1 - A * phi)


def start(k, delta, A, particular, at_0, slope_0):
    """a cos alpha and a sin alpha from the slope of a general wave: linear equations"""
    cosine = at_0 - particular
    sine = (cosine * (A / 4 - delta) + A * particular - slope_0) / k
    wave = lambda x: deflection(k, delta, A, particular, x, hypot(cosine, sine), atan2(sine, cosine))
    assert abs(diff(wave, 0) - slope_0) < mpf(10) ** -25 * (1 + abs(slope_0))
    return hypot(cosine, sine), atan2(sine, cosine)


with open("tests/data/drum_shaft_table.h", "w") as file:
    file.write("/* Written by tests/gen/drum_shaft_reference.py: k, delta, A, particular, phi, a, alpha; deflection, slope;"
               " deflection\n   and slope at phi = 0; amplitude, phase */\n")
    for row in range(24):
        k, delta = single(random.uniform(0.5, 30)), single(random.uniform(-0.05, 0.05))
        A = single(random.uniform(-0.1, 0.15)) if row % 4 else 0.0
        particular = single(random.uniform(-0.02, 0.02)) if row % 2 else 0.0
        phi, a, alpha = single(random.uniform(0.1, 6.2)), single(random.uniform(0.001, 0.1)), single(random.uniform(-3, 3))
        at_0, slope_0 = single(random.uniform(-0.1, 0.1)), single(random.uniform(-0.3, 0.3))
        K = [mpf(x) for x in (k, delta, A, particular)]
        wave = lambda x: deflection(*K, x, mpf(a), mpf(alpha))
        results = [wave(mpf(phi)), diff(wave, mpf(phi)), *start(*K, mpf(at_0), mpf(slope_0))]
        numbers = [k, delta, A, particular, phi, a, alpha, *map(float, results[:2]), at_0, slope_0, *map(float, results[2:])]
        file.write("    {" + ", ".join(repr(x) for x in numbers) + "},\n")
