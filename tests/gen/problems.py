"""The ends of the problems of bench/problems.h by mpmath's Taylor series, 20 digits; constants are the doubles that
the C code has. Prints them; a minute or two."""
from mpmath import mp, mpf, nstr, odefun, sqrt

mp.dps = 28
third, tenth, mu = mpf(1 / 3), mpf(0.1), mpf(0.012277471)
mu1 = mpf(1 - 0.012277471)


def orbit(t, y):
    r1, r2 = (y[0] + mu)**2 + y[1]**2, (y[0] - mu1)**2 + y[1]**2
    r1, r2 = mu1 / (r1 * sqrt(r1)), mu / (r2 * sqrt(r2))
    return [y[2], y[3], y[0] + 2 * y[3] - r1 * (y[0] + mu) - r2 * (y[0] - mu1),
            y[1] - 2 * y[2] - r1 * y[1] - r2 * y[1]]


problems = {
    'cubic': (lambda t, y: [y[1], -y[0]**3], 100, [1, 0]),
    'mass': (lambda t, y: [y[1], -(y[0]**3 + tenth * y[1]) / (1 + tenth * t)], 50, [1, 0]),
    'momentum': (lambda t, y: [y[1] / (1 + tenth * t), -y[0]**3], 50, [1, 0]),
    'body': (lambda t, y: [-y[1] * y[2], y[2] * y[0], -y[0] * y[1] * third], 60, [1, 0.1, 0.9]),
    'orbit': (orbit, 17.0652165601579625588917206249, [0.994, 0, 0, -2.00158510637908252240537862224]),
}
for name, (f, T, start) in problems.items():
    print(name, ', '.join(nstr(y, 20) for y in odefun(f, 0, [mpf(y) for y in start])(mpf(T))), flush=True)
