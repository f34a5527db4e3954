"""The luffing crane of examples/scenes/luffing_crane.h in six coordinates: x and y of the undercarriage, and the
angles of undercarriage, jib, rope and block. Each point is a sum of vectors that turn with these angles. Lagrange's
equations J^T m J q'' = J^T (F - m a0) are integrated by Gragg's method with extrapolation. Prints the numbers of
check_luffing_crane in tests/test_scenes.c.

usage: python3 tests/gen/luffing_crane_reference.py; needs mpmath. Minutes."""
from mpmath import cos, findroot, hypot, lu_solve, matrix, mp, mpf, nstr, sin, sqrt

mp.dps = 30
g = mpf("9.81")
BASE, JIB, ROPE, BLOCK = 2, 3, 4, 5  # coordinates that are angles


def v(x, y):
    return (mpf(str(x)), mpf(str(y)))


def minus(a, b):
    return (a[0] - b[0], a[1] - b[1])


base, foot, top, end = v(0, 0.5), v(1, 2.5), v(5, 7.5), v(5.8, 3.5)  # m


def point(on, place):
    """A point of a body as the list of (angle, vector) that lead to it from the undercarriage at the start"""
    place = v(*place)
    if on == BASE:
        return [(BASE, minus(place, base))]
    path = [(BASE, minus(foot, base))]
    if on == JIB:
        return path + [(JIB, minus(place, foot))]
    return path + [(JIB, minus(top, foot)), (ROPE, minus(end, top)), (BLOCK, minus(place, end))]


def motion(path, q, w):
    """Position, velocity, the rows of the Jacobian, and the acceleration for q'' = 0"""
    r, rate, a0 = [base[0] + q[0], base[1] + q[1]], [w[0], w[1]], [mpf(0), mpf(0)]
    rows = {0: (mpf(1), mpf(0)), 1: (mpf(0), mpf(1))}
    for k, (x, y) in path:
        c, s = cos(q[k]), sin(q[k])
        px, py = c * x - s * y, s * x + c * y
        r[0] += px
        r[1] += py
        rate[0] -= w[k] * py
        rate[1] += w[k] * px
        a0[0] -= w[k]**2 * px
        a0[1] -= w[k]**2 * py
        rows[k] = (-py, px)
    return r, rate, rows, a0


BODIES = [(6000, 4000, point(BASE, (0, 0.5)), BASE), (4000, 5000, point(BASE, (-0.4, 2)), BASE),
          (900, 3000, point(JIB, (3, 5)), JIB)]
LOAD = point(BLOCK, (5.8, 3))
SPRINGS = [((BASE, (-2, 0)), v(-2, -1), 10**6, 20000), ((BASE, (2, 0)), v(2, -1), 10**6, 20000),
           ((BASE, (0, 0.2)), v(-3, 0.2), 200000, 10000), ((BASE, (1.5, 1.5)), (JIB, (3, 5)), 2 * 10**6, 20000)]


def springs():
    for (on, place), other, k, c in SPRINGS:
        other_path = point(*other) if isinstance(other[1], tuple) else None
        there = v(*other[1]) if other_path else other
        yield point(on, place), other_path, other, hypot(*minus(v(*place), there)), k, c


ALL_SPRINGS = list(springs())


def load_now(stage, t, since):
    """Mass and inertia of block and load: before the pick-up, while it leaks, after the drop"""
    if stage == 0:
        return mpf(200), mpf(60)
    if stage == 1:
        return 1700 - 40 * (t - since), mpf(360)
    return since, mpf(220)


def system(q, w, mass, inertia):
    M, f = matrix(6, 6), matrix(6, 1)
    for m, J, path, angle in BODIES + [(mass, inertia, LOAD, BLOCK)]:
        _, _, rows, a0 = motion(path, q, w)
        M[angle, angle] += J
        for i, a in rows.items():
            f[i] += m * (a[1] * (-g - a0[1]) - a[0] * a0[0])
            for k, b in rows.items():
                M[i, k] += m * (a[0] * b[0] + a[1] * b[1])
    for path, other, place, rest, k, c in ALL_SPRINGS:
        r, rate, rows, _ = motion(path, q, w)
        R, Rate, Rows, _ = motion(other, q, w) if other else (place, (0, 0), {}, None)
        d, dv = minus(r, R), minus(rate, Rate)
        length = sqrt(d[0]**2 + d[1]**2)
        n = (d[0] / length, d[1] / length)
        pull = k * (length - rest) + c * (n[0] * dv[0] + n[1] * dv[1])
        for i, a in rows.items():
            f[i] -= pull * (a[0] * n[0] + a[1] * n[1])
        for i, a in Rows.items():
            f[i] += pull * (a[0] * n[0] + a[1] * n[1])
    return M, f


def rates(t, z, stage, since):
    q, w = z[:6], z[6:]
    return w + list(lu_solve(*system(q, w, *load_now(stage, t, since))))


def gragg(t, z, H, n, *law):
    h = H / n
    old, now = z, [a + h * b for a, b in zip(z, rates(t, z, *law))]
    for i in range(1, n):
        old, now = now, [a + 2 * h * b for a, b in zip(old, rates(t + i * h, now, *law))]
    last = rates(t + H, now, *law)
    return [(a + b + h * c) / 2 for a, b, c in zip(old, now, last)]


def step(t, z, H, *law):
    rows = []
    for j in range(12):
        row = [gragg(t, z, H, 2 * (j + 1), *law)]
        for k in range(1, j + 1):
            ratio = (mpf(j + 1) / (j + 1 - k))**2 - 1
            row.append([a + (a - b) / ratio for a, b in zip(row[k - 1], rows[j - 1][k - 1])])
        if j > 4 and max(abs(a - b) for a, b in zip(row[-1], row[-2])) < mpf(10)**-19:
            return row[-1]
        rows.append(row)
    return row[-1]


def swing(z):
    x, y = minus(end, top)
    return cos(z[ROPE]) * x - sin(z[ROPE]) * y


def run(t, z, t_end, sign, *law):
    """Integrates until the rope passes the vertical with this sign, or until t_end"""
    H = mpf(1) / 16
    while t < t_end:
        h = min(H, t_end - t)
        new = step(t, z, h, *law)
        if sign and sign * swing(z) < 0 <= sign * swing(new):
            h = findroot(lambda h: swing(step(t, z, h, *law)), (h / 2, h), tol=mpf(10)**-36, maxsteps=9, verify=False)
            return t + h, step(t, z, h, *law)
        t, z = t + h, new
    return t, z


def main():
    t, z = run(mpf(0), [mpf(0)] * 12, 8, -1, 0, None)
    print("pick-up", nstr(t, 20), "rate of the rope", nstr(z[6 + ROPE], 20))
    M, _ = system(z[:6], z[6:], *load_now(0, t, None))
    momenta = M * matrix(z[6:])  # the heap has none
    M, _ = system(z[:6], z[6:], *load_now(1, t, t))
    z = z[:6] + list(lu_solve(M, momenta))
    start = t
    t, z = run(t, z, 8, 1, 1, start)
    mass = load_now(1, t, start)[0] - 700
    print("drop", nstr(t, 20), "load", nstr(mass, 20), "rate of the rope", nstr(z[6 + ROPE], 20))
    t, z = run(t, z, 8, 0, 2, mass)
    print("t", nstr(t, 20), "coordinates", *[nstr(x, 20) for x in z[:6]], sep="\n")
    print("block", *[nstr(x, 20) for x in motion(LOAD, z[:6], z[6:])[0]], sep="\n")


if __name__ == "__main__":
    main()
