#!/usr/bin/env python3
"""Write tests/data/rotation_table.h: free rotation of rigid bodies in 60 digits, at exactly the stored inputs.

A row: the inertia xx yy zz xy xz yz, q, omega and t in turns of the body, then q(t), omega(t), both omegas along the body's
axes in the rows without products of inertia, along the inertial axes in the others, and 1 - m. Every other row has inputs of
single precision, which the float build of the tests uses. By Jacobi's functions and the theta series for the attitude
(secular rate included; the header has it from the integral of the third kind); each row is checked to satisfy Euler's
equations and q' = q omega/2 by differences, and to start where it must.

And tests/data/rotation_turns.h: attitudes of bodies after 1, 10 ... 1e6 turns, which bench/bench_rotation.c compares with.
"""
import random
from hard_reference import jacobi, single
from mpmath import mp, mpf, agm, cos, diag, eigsy, elliprf, exp, matrix, mpc, pi, sin, sqrt

random.seed(6)
mp.dps = 60


def times(p, q):
    return (p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3], p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
            p[0] * q[2] + p[2] * q[0] + p[3] * q[1] - p[1] * q[3], p[0] * q[3] + p[3] * q[0] + p[1] * q[2] - p[2] * q[1])


def turned(q, v):
    n = sum(x * x for x in q)
    return [x / n for x in times(times(q, (0, *v)), (q[0], -q[1], -q[2], -q[3]))[1:]]


class Motion:
    """J and omega along principal axes, q(0) = 1; no special cases"""

    def __init__(self, J, w):
        order = sorted(range(3), key=lambda k: -J[k])
        a, b, c = order
        S = J[c] * (J[b] - J[c]) * w[c] ** 2 - J[a] * (J[a] - J[b]) * w[a] ** 2
        if S < 0:
            order, S = [c, b, a], -S
        self.order = order
        self.chi = 1 if tuple(order) in ((0, 1, 2), (1, 2, 0), (2, 0, 1)) else -1
        I1, I2, I3 = (J[k] for k in order)
        w1, w2, w3 = w[order[0]], w[order[1]], self.chi * w[order[2]]
        self.sigma, self.s = (1 if I1 > I3 else -1), (1 if w3 >= 0 else -1)
        d12, d23, d13 = abs(I1 - I2), abs(I2 - I3), abs(I1 - I3)
        self.a1 = sqrt(w1**2 + I2 * d23 / (I1 * d13) * w2**2)
        self.a2 = sqrt(w2**2 + I1 * d13 / (I2 * d23) * w1**2)
        self.a3 = sqrt(w3**2 + I2 * d12 / (I3 * d13) * w2**2)
        self.wp = self.a3 * sqrt(d13 * d23 / (I1 * I2))
        self.m = I1 * d12 * self.a1**2 / (I3 * d23 * self.a3**2)
        self.m1 = S / (I3 * d23 * self.a3**2)
        self.I, self.L = (I1, I2, I3), sqrt((I1 * self.a1) ** 2 + (I3 * self.a3) ** 2)
        c, cb = I3 * self.a3 / self.L, I1 * self.a1 / self.L
        self.K, Kp = pi / (2 * agm(1, sqrt(self.m1))), pi / (2 * agm(1, sqrt(self.m)))
        sn0, cn0 = -self.sigma * self.s * w2 / self.a2, w1 / self.a1
        F = abs(sn0) * elliprf(cn0**2, cn0**2 + self.m1 * sn0**2, 1)
        self.u0 = (F if cn0 >= 0 else 2 * self.K - F) * (1 if sn0 >= 0 else -1)
        y = cb * elliprf(self.m * c**2, self.m, cb**2 + self.m * c**2)
        zy, l = pi * y / (2 * self.K), 2 * pi * Kp / self.K
        self.C, self.S, n = [], [], 0
        while not self.C or abs(self.C[-1]) > mpf(10) ** -(mp.dps + 5):
            n += 1
            e, f = exp(-l * n * n + 2 * n * zy), exp(-l * n * n - 2 * n * zy)
            self.C.append(e + f), self.S.append(e - f)
        self.energy2 = I1 * w1**2 + I2 * w2**2 + I3 * w3**2
        root = sqrt(self.m1)
        self.kappa = (self.energy2 / self.L + self.a3 * root) / (1 + c * root) / 2 + self.sigma * self.wp * pi / (
            2 * self.K) * 2 * sum((n + 1) * x for n, x in enumerate(self.S)) / (1 + sum(self.C))
        self.M0 = self.to_momentum((w1, w2, w3))
        self.U0 = self.unit(self.u0)

    def unit(self, u):
        z = pi * u / (2 * self.K)
        series = sum((-1) ** n * (C * cos(2 * n * z) - mpc(0, 1) * S * sin(2 * n * z))
                     for n, C, S in zip(range(1, 99), self.C, self.S))
        return (1 + series) / abs(1 + series)

    def to_momentum(self, w):
        l = [i * x / self.L for i, x in zip(self.I, w)]
        r = sqrt(2 * (1 + abs(l[2])))
        return ((1 + abs(l[2])) / r, self.s * l[1] / r, -self.s * l[0] / r, mpf(0))

    def at(self, t):
        u = self.u0 + self.wp * t
        sn, cn, dn = jacobi(u - 4 * self.K * mp.nint(u / (4 * self.K)), self.m1)
        w = (self.a1 * cn, -self.sigma * self.s * self.a2 * sn, self.s * self.a3 * dn)
        E = exp(mpc(0, self.kappa * t))
        f = self.unit(u) * mp.conj(self.U0)
        E *= f if self.sigma > 0 else mp.conj(f)
        M = self.M0
        X = times(times((M[0], -M[1], -M[2], -M[3]), (E.real, 0, 0, self.s * E.imag)), self.to_momentum(w))
        omega, vector = [0] * 3, [0] * 3
        for k, sign in zip(range(3), (1, 1, self.chi)):
            omega[self.order[k]], vector[self.order[k]] = sign * w[k], sign * X[k + 1]
        return omega, (X[0], *vector)


class Body:
    """A tensor, attitude, and omega along body axes"""

    def __init__(self, inertia, q, omega):
        xx, yy, zz, xy, xz, yz = map(mpf, inertia)
        if xy == xz == yz == 0:
            J, V = [xx, yy, zz], matrix([[1, 0, 0], [0, 1, 0], [0, 0, 1]])
        else:
            mp.dps += 30
            J, V = eigsy(matrix([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]))
            mp.dps -= 30
            J = list(J)
            if mp.det(V) < 0:
                V = -V
        self.V, self.q, self.J = V, q, J
        self.motion = Motion(J, list(V.T * matrix(omega)))

    def at(self, t):
        w, X = self.motion.at(t)
        return list(self.V * matrix(w)), times(self.q, (X[0], *(self.V * matrix(X[1:]))))

    def verify(self, t):
        h = mpf(10) ** -15
        (w, q), (wm, qm), (wp, qp) = self.at(t), self.at(t - h), self.at(t + h)
        speed = sqrt(sum(x * x for x in w))
        rate = times(q, (0, *w))
        assert all(abs((b - a) / (2 * h) - r / 2) < 1e-18 * (1 + speed**3) for a, b, r in zip(qm, qp, rate))
        L = turned(q, self.V * diag(self.J) * self.V.T * matrix(w))
        w0, q0 = self.at(mpf(0))
        L0 = turned(q0, self.V * diag(self.J) * self.V.T * matrix(w0))
        assert all(abs(a - b) < mpf(10) ** -30 * (1 + sum(map(abs, L0))) for a, b in zip(L, L0))
        assert all(abs(a - b) < mpf(10) ** -25 for a, b in zip(q0, self.q))


def spec_cases():
    """t = 1.25 of the reference cases A to E, H, I against the published digits"""
    half = mpf(1) / 2
    e50, e30 = mpf(2) ** -50, mpf(2) ** -30
    for J, w, q, expected in (
            ((3, 2, 1), (half / 2, half, 3 * half), (1, 0, 0, 0), "0.79900796561776830578"),
            ((2, 1, 3), (-half, mpf(3) / 8, -mpf(5) / 4), (half, half, -half, half), "0.060656206648914937666"),
            ((1, mpf(7) / 4, 2), (1, -mpf(3) / 4, half / 2), (mpf(3) / 5, 0, mpf(4) / 5, 0), "-0.29772413207268020819"),
            ((6, 4, 3), (1, -half, 2 + e50), (1, 0, 0, 0), "0.62569646153446927617"),
            ((3, 6, 4), (2 - e50, -1, half), (1, 0, 0, 0), "0.54598856449011976116"),
            ((2, 2 + e30, 1), (half, half / 2, 1), (1, 0, 0, 0), "0.56087042739557664680")):
        body = Body((*J, 0, 0, 0), q, matrix(w))
        assert abs(body.at(mpf(5) / 4)[1][3] - mpf(expected)) < 1e-19


def possible(J):
    a, b, c = sorted(J)
    return c <= a + b and a > 0


def random_moments(near, kind):
    while True:
        J = [near(random.uniform(0.3, 1)) for _ in range(3)]
        if kind == "needle":
            small = 10 ** random.uniform(-6, -1)
            J = [near(1 + small * random.uniform(-1, 1)), near(1.0), near(small * random.uniform(1.1, 2))]
        if kind == "alike":  # two moments, then all three
            small = 10 ** random.uniform(-12 if near is float else -5, -3)
            J = [near(1 + small * random.uniform(-1, 1)), near(1.0),
                 near(random.choice((0.4, 1.7, 1 + small * random.uniform(-1, 1))))]
        random.shuffle(J)
        if possible(J) and len(set(J)) == 3:
            return J


def row(kind, count):
    near = single if count % 2 else float
    q, products = (mpf(1), mpf(0), mpf(0), mpf(0)), (0.0, 0.0, 0.0)
    J = random_moments(near, kind)
    w = [near(random.uniform(-1, 1)) for _ in range(3)]
    if kind == "separatrix":  # w_a^2 = J_c (J_b - J_c)/(J_a (J_a - J_b)) w_c^2, all but 1 - m
        c, b, a = sorted(range(3), key=lambda k: J[k])
        share = near(10 ** random.uniform(-15.5 if near is float else -7, -2)) * random.choice((-1, 1))
        ratio = sqrt(mpf(J[c]) * (mpf(J[b]) - J[c]) / (mpf(J[a]) * (mpf(J[a]) - J[b])))
        w[a] = near(float(ratio * w[c] * (1 + mpf(share))))
    if kind == "middle":
        c, b, a = sorted(range(3), key=lambda k: J[k])
        for k in (a, c):
            w[k] = near(10 ** random.uniform(-12, -1) * random.choice((-1, 1)))
    if kind == "tensor":
        q = tuple(mpf(near(random.uniform(-1, 1))) for _ in range(4))
        bound = [near(random.uniform(-0.3, 0.3)) for _ in range(3)]
        products = tuple(bound)
        J = [near(random.uniform(1, 1.4)) for _ in range(3)]
    t = near(random.choice((-1, 1)) * 10 ** random.uniform(-1, 7))
    spin = turned((q[0], -q[1], -q[2], -q[3]), [mpf(x) for x in w]) if kind == "tensor" else [mpf(x) for x in w]
    body = Body((*J, *products), q, spin)
    if not possible(body.J) or body.motion.m1 < mpf(10) ** -27:
        return None
    body.verify(mpf(random.uniform(-3, 3)))
    omega, attitude = body.at(mpf(t))
    if kind == "tensor":
        omega = turned(attitude, omega)
    m1 = float(f"{float(body.motion.m1):.3g}")
    groups = (*J, *products), map(float, q), w, (t,), map(float, attitude), map(float, omega), (m1,)
    texts = [", ".join(f"{x!r}" if x else "0" for x in group) for group in groups]
    return "    {" + ", ".join(x if "," not in x else "{" + x + "}" for x in texts) + "},"


def turns():
    lines = ["/* Written by tests/gen/rotation_reference.py: body, moments, omega at q = 1, then t and q after 10^i turns */",
             "static const turned_body turned_bodies[] = {"]
    for name, J, w in (("triaxial", (3.0, 2.0, 1.0), (0.25, 0.5, 1.5)), ("middle axis", (3.0, 2.0, 1.0), (1e-6, 1.0, 1e-6))):
        body = Body((*J, 0, 0, 0), (mpf(1), mpf(0), mpf(0), mpf(0)), [mpf(x) for x in w])
        body.verify(mpf(2.5))
        lines.append(f'    {{"{name}", {{{J[0]}, {J[1]}, {J[2]}}}, {{{w[0]}, {w[1]}, {w[2]}}},\n     {{')
        for i in range(7):
            t = float(10**i * 2 * pi / sqrt(sum(mpf(x)**2 for x in w)))
            q = ", ".join(mp.nstr(x, 20) for x in body.at(mpf(t))[1])
            lines.append(f"         {{{t!r}, {{{q}}}}},")
        lines.append("     }},")
    with open("tests/data/rotation_turns.h", "w") as file:
        file.write("\n".join(lines) + "\n};\n")
    print("rotation_turns.h", 2)


def main():
    spec_cases()
    turns()
    rows = []
    for kind, number in (("tensor", 84), ("plain", 24), ("needle", 40), ("alike", 40), ("separatrix", 60), ("middle", 24)):
        rows.append(f"static const row {kind}[] = {{")
        count = 0
        while count < number:
            line = row(kind, count)
            if line:
                rows.append(line)
                count += 1
        rows.append("};")
    with open("tests/data/rotation_table.h", "w") as file:
        file.write("/* Written by tests/gen/rotation_reference.py: xx yy zz xy xz yz, q, omega, t, q(t), omega(t), 1 - m */\n")
        file.write("\n".join(rows) + "\n")
    print("rotation_table.h", len(rows))


if __name__ == "__main__":
    main()
