#!/usr/bin/env python3
"""Write tests/data/ripple_table.h, slow_laws.h and slow_solved.h for tests/test_slow_motion.c, by mpmath to 20 digits.

ripple_table.h: sa, ca and S, S2, S3, Q, the integrals of the ripple of ca^2 over the Ateb phase, and their constants. Each
function is a product of a power and a series at the nearest zero of ca or sa, whose coefficients come from products of series
(the headers have recurrences); a few values are compared with the defining integrals, by quadrature.

slow_laws.h: laws and their six derivatives, and the numbers a, p, G_0 ... G_4 of problems, by Taylor series of the laws.
slow_solved.h: motions with G_0 = 0, known by one integral, and motions of alpha = 3 that are Duffing's, by Jacobi's functions.
All inputs are numbers of single precision, but for alpha = 0.1 and 4/3 and for exponents.
"""
import struct

from mpmath import (acos, beta, binomial, ellipf, ellipfun, exp, expm1, floor, log, mp, mpf, nstr, quad, sign, sin, sqrt, tanh,
                    taylor)

mp.dps = 40
TERMS = 150


def single(x):
    return struct.unpack("f", struct.pack("f", float(x)))[0]


def digits(x):
    return nstr(x, 20, strip_zeros=False)


# ---- The ripple ----

def product(a, b):
    return [mp.fsum(a[k] * b[i - k] for k in range(i + 1)) for i in range(TERMS)]


def power(p):
    """(1 - y)^p"""
    return [(-1) ** i * binomial(p, i) for i in range(TERMS)]


class Ripple:
    """On the quarter from sa = 0 (distance t = 0) to ca = 0 (distance s = 0), t + s = Pi/2"""

    def __init__(self, alpha):
        self.alpha, n = alpha, alpha + 1
        self.n = n
        self.pi = beta(mpf(1) / 2, 1 / n)
        self.m2 = beta(mpf(1) / 2, 3 / n) / self.pi
        self.m4 = beta(mpf(1) / 2, 5 / n) / self.pi
        # s = x sum w^i zero[1]_i, integrals of ca^2, ca^4 and of integrals: x^j sum w^i zero[...]_i
        root = power(mpf(-1) / 2)

        def zero(c, j):
            c = product(c, root) if c else root
            return [n / 2 * c[i] / (j + i * n) for i in range(TERMS)]
        self.zero_s, self.zero_2, self.zero_4 = zero(None, 1), zero(None, 3), zero(None, 5)
        self.zero_first = zero(self.zero_2, 4)
        self.zero_second = zero(self.zero_first, 5)
        # the same from sa = 0, u = |sa|: u^j sum u^(2i)
        rate = power(-alpha / n)

        def turn(c, j):
            return [c[i] / (2 * i + j) for i in range(TERMS)]
        self.turn_t, self.turn_2, self.turn_4 = turn(rate, 1), turn(power((2 - alpha) / n), 1), turn(power((4 - alpha) / n), 1)
        self.turn_first = turn(product(self.turn_2, rate), 2)
        self.turn_second = turn(product(self.turn_first, rate), 3)
        # S2 at ca = 0 and sa = 0: S2 is continuous and the mean of it vanishes, at w = 0.45
        w = mpf("0.45")
        z, u = self.from_zero(w), self.from_turn(w)
        assert abs(z["s"] + u["t"] - self.pi / 2) < mpf(10) ** -35
        jump = z["S2"] - u["S2"]
        self.at_ca_0 = -(z["S3"] + u["S3"] + jump * u["t"]) / (self.pi / 2)
        self.at_sa_0 = self.at_ca_0 + jump

    def value(self, c, y):
        return mp.fsum(c[i] * y**i for i in range(TERMS))

    def from_zero(self, w):
        """Integrals from ca = 0 on to w = |ca|^(alpha+1), of the ripple too"""
        x = w ** (1 / self.n)
        s, c2, c4, d, e = (x**j * self.value(c, w) for j, c in (
            (1, self.zero_s), (3, self.zero_2), (5, self.zero_4), (4, self.zero_first), (5, self.zero_second)))
        return dict(s=s, S=c2 - self.m2 * s, S2=d - self.m2 * s**2 / 2, S3=e - self.m2 * s**3 / 6,
                    Q=c4 - 2 * self.m2 * c2 + (2 * self.m2**2 - self.m4) * s)

    def from_turn(self, w):
        """The same from sa = 0 on"""
        u = sqrt(1 - w)
        t, c2, c4, d, e = (u**j * self.value(c, u * u) for j, c in (
            (1, self.turn_t), (1, self.turn_2), (1, self.turn_4), (2, self.turn_first), (3, self.turn_second)))
        return dict(t=t, S=c2 - self.m2 * t, S2=d - self.m2 * t**2 / 2, S3=e - self.m2 * t**3 / 6,
                    Q=c4 - 2 * self.m2 * c2 + (2 * self.m2**2 - self.m4) * t)

    def solve(self, series, distance, power_of):
        """The size whose series is the distance, from below by Newton's method"""
        size = distance / series[0]
        size = min(size, power_of(mpf("0.55")))
        for _ in range(200):
            y = size ** self.n if series is self.zero_s else size**2
            value = size * self.value(series, y)
            slope = mp.fsum(c * (1 + i * (self.n if series is self.zero_s else 2)) * y**i for i, c in enumerate(series))
            step = (value - distance) / slope
            size -= step
            if abs(step) < 1000 * mp.eps * size or size == 0:
                return size
        raise ValueError

    def at(self, psi):
        """sa, ca, S, S2, S3, Q"""
        turns = floor(psi / self.pi + mpf(1) / 2)
        theta = psi - turns * self.pi
        side, t = (-1 if theta < 0 else 1), abs(theta)
        s = self.pi / 2 - t
        sign = -1 if int(turns) % 2 else 1
        if s < self.value(self.zero_s, mpf(1) / 2) * mpf(1) / 2 ** (1 / self.n):
            x = self.solve(self.zero_s, s, lambda w: w ** (1 / self.n))
            w = x**self.n
            f = self.from_zero(w)
            S3 = -(self.at_ca_0 * s + f["S3"])
            S, S2, Q = -f["S"], self.at_ca_0 + f["S2"], -f["Q"]
        else:
            u = self.solve(self.turn_t, t, sqrt)
            w = 1 - u * u
            x = w ** (1 / self.n)
            f = self.from_turn(w)
            S3 = self.at_sa_0 * t + f["S3"]
            S, S2, Q = f["S"], self.at_sa_0 + f["S2"], f["Q"]
        return sign * side * sqrt(1 - w), sign * x, side * S, S2, side * S3, side * Q

    def check(self, psi):
        """Derivatives, and means over a quarter, by quadrature"""
        def ripple(f, i):
            return self.at(f)[i]
        joint = self.pi / 2 - self.value(self.zero_s, mpf(1) / 2) / 2 ** (1 / self.n)
        nodes = sorted([mpf(0), psi] + ([joint] if joint < psi else []))
        C = lambda f: ripple(f, 1) ** 2 - self.m2
        for i, rate in ((2, C), (3, lambda f: ripple(f, 2)), (4, lambda f: ripple(f, 3)),
                        (5, lambda f: C(f) ** 2 - self.m4 + self.m2**2)):
            difference = ripple(psi, i) - ripple(mpf(0), i) - quad(rate, nodes)
            assert abs(difference) < mpf(10) ** -12, (self.alpha, psi, i, difference)
        assert abs(quad(lambda f: ripple(f, 3), [0, joint, self.pi / 2])) < mpf(10) ** -12


def write_ripple(file):
    constants, rows = [], []
    for index, alpha in enumerate((mpf(0), mpf("0.1"), mpf("0.5"), mpf(1), mpf(4) / 3, mpf(2), mpf(3), mpf(5), mpf(10), mpf(30))):
        r = Ripple(alpha)
        if index in (2, 4, 6):
            mp.dps = 20
            r.check(mpf("0.9"))
            mp.dps = 40
        constants.append("    {%s, {%s}}," % (digits(alpha), ", ".join(
            digits(c) for c in (r.pi, r.m2, r.m4, r.m4 - r.m2**2, r.at_sa_0, r.at_ca_0))))
        joint = r.pi / 2 - r.value(r.zero_s, mpf(1) / 2) / 2 ** (1 / r.n)
        phases = [r.pi * mpf(k) / 23 for k in range(-30, 60, 4)]
        for place, turns in ((joint, 0), (joint, 2), (-joint, 1)):
            phases += [place + turns * r.pi + d for d in (-mpf(10) ** -6, 0, mpf(10) ** -6)]
        for place in (mpf(0), r.pi / 2, -r.pi / 2, r.pi, 3 * r.pi / 2):
            phases += [place + side * mpf(10) ** -k for k in (1, 3, 5, 7) for side in (-1, 1)]
        for psi in [0] + phases:
            psi = mpf(single(psi))
            values = r.at(psi)
            rows.append("    {%d, %s, {%s}}," % (index, nstr(psi, 17), ", ".join(digits(c) for c in values)))
    file.write("/* Written by tests/gen/slow_motion.py: alpha, then Pi, the means of ca^2, ca^4 and C^2, S2 at sa = 0 and at ca = 0 */\n"
               "static const ripple_constants ripple_constant_rows[] = {\n" + "\n".join(constants) + "\n};\n\n"
               "/* Index of alpha, psi, then sa, ca, S, S2, S3, Q */\n"
               "static const ripple_row ripple_rows[] = {\n" + "\n".join(rows) + "\n};\n")
    print("ripple_table.h", len(rows))


# ---- Laws and reductions ----

LINEAR, QUADRATIC, EXPONENTIAL, POWER, TABLE, SINE, FILL = range(7)
TABLE_TIMES = [0, 1.5, 2, 4, 5, 8]
TABLE_VALUES = [1, 1.25, 1.375, 1.75, 1.625, 1]


def table_slope(i):
    """Fritsch and Butland inside; the parabola through three points at the ends"""
    t, f = [mpf(x) for x in TABLE_TIMES], [mpf(x) for x in TABLE_VALUES]
    h = [b - a for a, b in zip(t, t[1:])]
    d = [(b - a) / c for a, b, c in zip(f, f[1:], h)]
    last = len(t) - 1
    if 0 < i < last:
        if d[i - 1] * d[i] <= 0:
            return mpf(0)
        w1, w2 = 2 * h[i] + h[i - 1], h[i] + 2 * h[i - 1]
        return (w1 + w2) / (w1 / d[i - 1] + w2 / d[i])
    a, b = (0, 1) if i == 0 else (last - 1, last - 2)
    slope = d[a] + h[a] * (d[a] - d[b]) / (h[a] + h[b])
    assert slope * d[a] > 0 and abs(slope) < 3 * abs(d[a])
    return slope


def law(kind, a, b, c, piece=0):
    """A function of t, which mpmath can differentiate"""
    a, b, c = mpf(a), mpf(b), mpf(c)
    if kind == LINEAR:
        return lambda t: a + b * t
    if kind == QUADRATIC:
        return lambda t: a + b * t + c * t * t
    if kind == EXPONENTIAL:
        return lambda t: a * exp(b * t)
    if kind == POWER:
        return lambda t: a * (1 + b * t) ** c
    if kind == SINE:
        return lambda t: 1 + a * sin(b * t + c)
    if kind == FILL:
        return lambda t: 1 + a * (1 + tanh((t - b) / c))
    t0, t1 = mpf(TABLE_TIMES[piece]), mpf(TABLE_TIMES[piece + 1])
    h, f0, f1 = t1 - t0, mpf(TABLE_VALUES[piece]), mpf(TABLE_VALUES[piece + 1])
    s0, s1 = table_slope(piece), table_slope(piece + 1)
    return lambda t: ((f0 * (1 + 2 * (t - t0) / h) + s0 * (t - t0)) * ((t1 - t) / h) ** 2 +
                      (f1 * (1 + 2 * (t1 - t) / h) + s1 * (t - t1)) * ((t - t0) / h) ** 2)


def piece_of(t, side):
    for i in range(len(TABLE_TIMES) - 2, 0, -1):
        if t > TABLE_TIMES[i] or (t == TABLE_TIMES[i] and side > 0):
            return i
    return 0


def derivatives(kind, numbers, t, side):
    f = law(kind, *numbers, piece=piece_of(t, side))
    mp.dps = 120
    c = [mp.factorial(i) * x for i, x in enumerate(taylor(f, mpf(t), 8))]
    mp.dps = 40
    degree = {LINEAR: 1, QUADRATIC: 2, TABLE: 3}.get(kind, 9)
    return [x if i <= degree else mpf(0) for i, x in enumerate(c)]


def series_ratio(a, b):
    c = []
    for i in range(len(a)):
        c.append((a[i] - sum(b[k] * c[i - k] for k in range(1, i + 1))) / b[0])
    return c


def reduced(alpha, r, b, mass, stiffness):
    """a, p, G_0 ... G_4 from derivatives of m and k"""
    m = [x / mp.factorial(i) for i, x in enumerate(mass)]
    k = [x / mp.factorial(i) for i, x in enumerate(stiffness)]
    rate = lambda f: [(i + 1) * x for i, x in enumerate(f[1:])]
    mul = lambda f, g: [sum(f[j] * g[i - j] for j in range(i + 1)) for i in range(min(len(f), len(g)))]
    n = len(m) - 1
    a = series_ratio([r * x + (b if i == 0 else 0) for i, x in enumerate(rate(m))], m[:n])
    ln_k, ln_m = series_ratio(rate(k), k[:n]), series_ratio(rate(m), m[:n])
    p = [(x + 2 * y - z) / (alpha + 3) for x, y, z in zip(ln_k, a, ln_m)]
    d = [2 * x - y for x, y in zip(p, a)]
    G = [x - y - z for x, y, z in zip(mul(p, p), mul(a, p), rate(p))]
    result = [a[0], p[0]]
    for i in range(5):
        result.append(G[0])
        G = [x - (i + 2) * y for x, y in zip(rate(G), mul(d, G))]
    return result


def write_laws(file):
    laws, rows = [], []
    for kind, numbers, times in (
            (LINEAR, (2, 0.375, 0), (0, 3, -2)), (QUADRATIC, (1, -0.25, 0.125), (0, 1.5, -4)),
            (EXPONENTIAL, (1.5, -0.3125, 0), (0, 2, -3)), (POWER, (2, 0.25, 1.75), (0, 5, -2)),
            (POWER, (1, 0.125, -2.5), (1, 8, -4)), (POWER, (1, 0.5, 3), (0, 1, -1)), (SINE, (0.5, 0.75, 0.25), (0, 2, -3)),
            (FILL, (0.25, 1, 2), (0, 1.5, -1)), (TABLE, (0, 0, 0), (0, 0.5, 1.5, 1.75, 3, 4, 6, 8))):
        for t in times:
            for side in (1, -1):
                f = derivatives(kind, numbers, t, side)
                laws.append("    {{%d, %r, %r, %r, {0}}, %r, %d, {%s}}," % (
                    kind, *numbers, t, side, ", ".join(digits(x) for x in f[:7])))
    one = (LINEAR, (1, 0, 0))
    line, parabola = (LINEAR, (1, 0.0625, 0)), (QUADRATIC, (2, 0.125, 0.03125))
    growth, decay = (EXPONENTIAL, (1, 0.125, 0)), (EXPONENTIAL, (0.75, -0.0625, 0))
    steep, wave, fill, table = ((POWER, (1, 0.125, 1.75)), (SINE, (0.5, 0.25, 0.5)), (FILL, (0.25, 4, 4)), (TABLE, (0, 0, 0)))
    problems = [(line, one), (one, line), (parabola, one), (growth, one), (steep, one), (one, decay), (parabola, growth),
                (line, steep), (steep, parabola), (wave, one), (one, wave), (fill, line), (table, one), (one, table),
                (growth, table)]
    for alpha in (mpf(0), mpf("0.5"), mpf(1), mpf(3), mpf(7)):
        for i, (m, k) in enumerate(problems):
            t, side = (0, 1.5, 3, 5)[(i + int(alpha)) % 4], (-1, 1)[i % 2]
            if t == 0:
                side = 1
            r, b = (1, 0, 0.375)[i % 3], (0, 0.0625, -0.03125)[(i + 1) % 3 if i % 4 else 0]
            values = reduced(alpha, mpf(r), mpf(b), derivatives(*m, t, side), derivatives(*k, t, side))
            rows.append("    {%r, %r, %r, {%d, %r, %r, %r, {0}}, {%d, %r, %r, %r, {0}}, %r, %d,\n     {%s}}," % (
                float(alpha), r, b, m[0], *m[1], k[0], *k[1], t, side, ", ".join(digits(x) for x in values)))
    file.write("/* Written by tests/gen/slow_motion.py: the points of the table */\n"
               "enum { SLOW_POINTS = %d };\n" % len(TABLE_TIMES) +
               "static const vm_real slow_times[SLOW_POINTS] = {%s};\n" % ", ".join(f"VM_C({x}.)" if x == int(x) else f"VM_C({x})" for x in TABLE_TIMES) +
               "static const vm_real slow_values[SLOW_POINTS] = {%s};\n\n" % ", ".join(f"VM_C({x}.)" if x == int(x) else f"VM_C({x})" for x in TABLE_VALUES) +
               "/* Law, time, side, f and its first six derivatives */\n"
               "static const law_row law_rows[] = {\n" + "\n".join(laws) + "\n};\n\n"
               "/* alpha, r, b, laws of mass and stiffness, time, side, then a, p, G_0 ... G_4 */\n"
               "static const reduction_row reduction_rows[] = {\n" + "\n".join(rows) + "\n};\n")
    print("slow_laws.h", len(laws), len(rows))


# ---- Motions that are solved ----

class Solved:
    """mu ~ base^P, kappa ~ base^K with base = 1 + rate t or exp(rate t), where G_0 = 0; m0 = k0 = 1"""

    def __init__(self, r, rate, exponential, P, K):
        self.r, self.n, self.rate, self.exponential, self.P, self.K = r, r.alpha + 1, mpf(rate), exponential, P, K
        self.decay = (P + K) / (r.alpha + 3)
        turn = (K - P) / 2 - (r.alpha - 1) / 2 * self.decay
        assert self.G0() < mpf(10) ** -14
        self.turn = turn

    def G0(self):
        """From p = decay rate/base, a = P rate/base"""
        p, a = self.decay, self.P
        return abs(p * p - a * p + (0 if self.exponential else p))

    def base(self, t):
        return exp(self.rate * t) if self.exponential else 1 + self.rate * t

    def motion(self, x0, v0, t):
        r, n = self.r, self.n
        p = self.decay * self.rate
        V = v0 + p * x0
        energy = abs(x0) ** n + n / 2 * V * V
        A = energy ** (1 / n)
        w = abs(x0) ** n / energy
        if w < mpf("0.5"):
            theta = r.pi / 2 - w ** (1 / n) * r.value(r.zero_s, w)
        else:
            theta = sqrt(1 - w) * r.value(r.turn_t, 1 - w)
        psi = -sign(V) * (theta if x0 > 0 else r.pi - theta)
        u = log(self.base(t)) / self.rate
        e = self.rate * (self.turn + (0 if self.exponential else 1))
        W = sqrt(n / 2) * A ** ((r.alpha - 1) / 2)
        sa, ca = r.at(psi + W * (expm1(e * u) / e if e else u))[:2]
        A, W = A * self.base(t) ** -self.decay, W * self.base(t) ** self.turn
        p /= 1 if self.exponential else self.base(t)
        return A * ca, -2 / n * W * A * sa - p * A * ca


def solved_rows():
    one, c = (LINEAR, (1, 0, 0)), 0.03125
    for alpha in (mpf("0.5"), mpf(1), mpf(4) / 3, mpf(3), mpf(5)):
        ripple, n = Ripple(alpha), alpha + 1
        power = lambda e: (POWER, (1, c, float(e)))
        growth = lambda e: (EXPONENTIAL, (1, float(c * e), 0))
        line = (LINEAR, (1, c, 0))
        e1, e2, e3 = (alpha + 3) / (alpha + 2), (alpha + 3) / (1 + 3 * n / 8), alpha + 3
        cases = [  # r, b, mass, stiffness, exponential, P, K
            (0, 0, power(e3), one, False, mpf(0), -e3), (1, 0, power(e1), one, False, e1, mpf(0)),
            (0.375, 0, power(e2), one, False, 3 * e2 / 8, -5 * e2 / 8), (0.5, 0, line, one, False, mpf(1) / 2, -mpf(1) / 2),
            (1, 0, power(2), power(-2), False, mpf(2), mpf(-2)), (0, 0, one, power(-e3), False, mpf(0), -e3),
            (1, c / n, line, one, False, 1 + 1 / n, 1 / n), (0.25, c / 4, line, one, False, mpf(1) / 2, -mpf(1) / 2),
            (0, c, one, growth(n), True, mpf(1), 1 + n), (1, c, one, growth(-2), True, mpf(1), mpf(-1)),
            (1, 0, growth(1), growth(alpha + 2), True, mpf(1), alpha + 2)]
        for i, (r, b, m, k, exponential, P, K) in enumerate(cases):
            t = (40, -12)[i % 2]
            motion = Solved(ripple, c, exponential, P, K).motion(mpf(0.8125), mpf((-0.375, 0.5)[i % 3 == 1]), mpf(t))
            yield alpha, r, b, m, k, 0.8125, (-0.375, 0.5)[i % 3 == 1], t, *motion


def duffing_rows():
    """y'' + y^3/2 + g y = 0 with g constant, x = y/B, B^6 = 2 mu kappa, dtau = B^2/mu dt; alpha = 3"""
    c, B0 = 0.03125, mpf(2) ** (mpf(1) / 6)
    # exponents of mu and kappa by 1 + c t; then B grows with the exponent e = (P + K)/6, and g = -(c e/B0^2)^2
    for r, b, m, P, K in ((1, 0, (POWER, (1, c, 1.5)), mpf(1.5), mpf(0)), (0, 0, (POWER, (1, c, 3)), mpf(0), mpf(-3)),
                          (1, c, (LINEAR, (1, c, 0)), mpf(2), mpf(1)), (0, 2 * c, (LINEAR, (1, c, 0)), mpf(2), mpf(1))):
        e = (P + K) / 6
        assert abs(2 * e - P + 1) < mpf(10) ** -30
        for t in (5, 40, -12):
            x0, v0, rate = mpf(0.8125), mpf(-0.375), mpf(c)
            g = -(rate * e / B0**2) ** 2
            y0, slope = B0 * x0, (v0 + rate * e * x0) / B0
            energy = slope**2 / 2 + y0**4 / 8 + g * y0**2 / 2
            a2 = -2 * g + sqrt(4 * g * g + 8 * energy)
            lam = sqrt(a2 / 2 + g)
            k2, a = a2 / (4 * lam**2), sqrt(a2)
            u = ellipf(acos(y0 / a), k2) * (-1 if slope > 0 else 1) + lam * B0**2 * log(1 + rate * t) / rate
            y, slope = a * ellipfun("cn", u, m=k2), -a * lam * ellipfun("sn", u, m=k2) * ellipfun("dn", u, m=k2)
            base = 1 + rate * t
            B, mu = B0 * base**e, base**P
            x = y / B
            yield mpf(3), r, b, m, (LINEAR, (1, 0, 0)), 0.8125, -0.375, t, x, slope * B / mu - rate * e / base * x


def write_solved(file):
    for name, comment, rows in (("solved_rows", "G_0 = 0", solved_rows()), ("duffing_rows", "alpha = 3, g constant", duffing_rows())):
        file.write("/* Written by tests/gen/slow_motion.py: %s, each a routes_case */\n"
                   "static const routes_case %s[] = {\n" % (comment, name))
        for alpha, r, b, m, k, x0, v0, t, x, v in rows:
            file.write("    {%s, %r, %s, {%d, %r, %r, %r, {0}}, {%d, %r, %r, %r, {0}}, 0, 0, 0, %r, %r, %r, %s, %s},\n" % (
                digits(alpha), r, digits(mpf(b)), m[0], *m[1], k[0], *k[1], x0, v0, t, digits(x), digits(v)))
        file.write("};\n")
    print("slow_solved.h")


def main():
    for name, write in (("ripple_table", write_ripple), ("slow_laws", write_laws), ("slow_solved", write_solved)):
        with open(f"tests/data/{name}.h", "w") as file:
            write(file)


if __name__ == "__main__":
    main()
