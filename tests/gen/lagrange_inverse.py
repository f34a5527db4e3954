# tests/data/lagrange_inverse.h: the generalized forces that a given motion of a double pendulum needs, by (247).
# The rod lengths are 1 and 1 + s/4 with s = sin(q2)/2, and the masses 2 - t/8 and 1 + t/16 + q1^2/8 depend on time and
# place. T is written out with symbols for the masses, so that they stay constant in dT/dq; the total time derivative of
# dT/dq' lets them vary. Derivatives are numerical ones of mpmath with 60 digits.
import os
import random
from mpmath import mp, mpf, cos, sin, diff

mp.dps = 60


def masses(t, q):
    return [2 - t / 8, 1 + t / 16 + q[0] ** 2 / 8]


def energy(q, v, m):
    b, db = 1 + sin(q[1]) / 8, cos(q[1]) / 8 * v[1]
    # the second point is at the distance b from the first, in the direction q2
    x = cos(q[0]) * v[0] + b * cos(q[1]) * v[1] + db * sin(q[1])
    y = -sin(q[0]) * v[0] - b * sin(q[1]) * v[1] + db * cos(q[1])
    return m[0] * v[0] ** 2 / 2 + m[1] * (x ** 2 + y ** 2) / 2


def moved(list_, i, x):
    return [x if k == i else value for k, value in enumerate(list_)]


def force(i, t, q, v, a):
    def momentum(s):
        q_s = [q[k] + v[k] * s + a[k] * s * s / 2 for k in (0, 1)]
        v_s = [v[k] + a[k] * s for k in (0, 1)]
        return diff(lambda x: energy(q_s, moved(v_s, i, x), masses(t + s, q_s)), v_s[i])
    frozen = masses(t, q)
    return diff(momentum, 0) - diff(lambda x: energy(moved(q, i, x), v, frozen), q[i])


random.seed(7)
here = os.path.dirname(os.path.abspath(__file__))
with open(os.path.join(here, "../data/lagrange_inverse.h"), "w") as out:
    out.write("/* t, q1, q2, q1', q2', q1'', q2'', Q1, Q2; written by tests/gen/lagrange_inverse.py */\n")
    for row in range(24):
        x = [mpf(random.randint(-96, 96)) / 32 for _ in range(7)]
        x[0] = abs(x[0])
        forces = [force(i, x[0], x[1:3], x[3:5], x[5:7]) for i in (0, 1)]
        numbers = [mp.nstr(n, 8) for n in x] + [mp.nstr(n, 22) for n in forces]
        out.write("{" + ", ".join(numbers) + "},\n")
