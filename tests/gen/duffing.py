"""Writes tests/data/duffing_table.h: motions of x'' + c1 x + c3 x^3 = 0 with 20 digits, from mpmath.

The motions come from Taylor series of the equation (odefun), periods and actions from quadrature of the energy integral,
so that nothing of Jacobi's functions is shared with the header. Each row holds
    c1, c3, x0, v0, t, x(t), v(t), period, action
where the inputs are exact in float. Run: python3 tests/gen/duffing.py > tests/data/duffing_table.h"""
from mpmath import mp, mpf, quad, sqrt, pi, odefun, sin, cos, nstr

mp.dps = 30


def orbit(c1, c3, x0, v0):
    """The largest and the smallest x^2 of the orbit; the second is negative for a motion around 0."""
    twice = v0 * v0 + c1 * x0 * x0 + c3 * x0**4 / 2
    if c3 == 0:
        return twice / c1, None
    root = sqrt(c1 * c1 + 2 * c3 * twice)
    return (root - c1) / c3, (-root - c1) / c3


def numbers(c1, c3, x0, v0):
    """Period and action, by x = A cos(angle) around 0 and by x^2 = (a^2 + b^2)/2 + ... in a well."""
    high, low = orbit(c1, c3, x0, v0)
    cuts = [0, pi / 64, pi / 8, 3 * pi / 8, 31 * pi / 64, pi / 2]
    if c1 < 0 and low > 0:
        x = lambda s: sqrt(high * cos(s)**2 + low * sin(s)**2)
        period = 2 * quad(lambda s: 1 / (x(s) * sqrt(c3 / 2)), cuts)
        square = lambda s: c3 / 2 * ((high - low) * sin(s) * cos(s))**2 / (x(s) * sqrt(c3 / 2))
        return period, 2 * quad(square, cuts) / (2 * pi)
    g = lambda s: c1 + c3 * high * (1 + cos(s)**2) / 2
    period = 4 * quad(lambda s: 1 / sqrt(g(s)), cuts)
    return period, 4 * quad(lambda s: high * sin(s)**2 * sqrt(g(s)), cuts) / (2 * pi)


def row(c1, c3, x0, v0, t):
    c1, c3, x0, v0, t = map(mpf, (c1, c3, x0, v0, t))
    period, action = numbers(c1, c3, x0, v0)
    side = 1 if t > 0 else -1  # odefun goes forward only
    x, v = odefun(lambda s, y: [y[1], -y[0] * (c1 + c3 * y[0]**2)], 0, [x0, side * v0])(abs(t))
    values = [c1, c3, x0, v0, t, x, side * v, period, action]
    print("    {" + ", ".join(nstr(value, 20) for value in values) + "},")


CASES = [
    (1, 0, 1, 0.5), (1, 0.5, 2, 0), (1, 0.5, 1, 2), (2, 8, -0.75, 0.25), (0.25, 16, 0.5, -1), (1, 0.0009765625, 1, 1),
    (0, 1, 1, 0.5), (0, 2, 0, 1), (0.0009765625, 1, 1, 0), (-0.0009765625, 1, 1, 0),
    (1, -0.25, 1.25, 0.25), (1, -1, 0.5, 0), (1, -1, 0.9375, 0), (1, -1, 0.9990234375, 0), (4, -0.5, -1, -2),
    (-1, 1, 1.75, 0.25), (-1, 1, 0, 0.5), (-1, 1, 1.5, 0), (-1, 1, 0, 0.0078125),
    (-1, 1, 1.125, 0.125), (-1, 1, -0.875, 0.25), (-2, 0.5, 2.0625, 0), (-1, 1, 1.375, 0), (-1, 1, 1, 0.0078125),
]
for case in CASES:
    for time in (1.5, -7.25):
        row(*case, time)
