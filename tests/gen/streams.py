"""Reference values of the closed forms of chapter 5 and of the variable pendulum of chapter 6, by mpmath with 40
digits at the stored inputs, which are floats. Writes tests/data/streams_line.h, streams_jet.h, streams_pendulum.h."""
import random
import struct
from mpmath import mp, mpf, log, exp, sin, cos, quad, odefun

mp.dps = 40
random.seed(7)


def single(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def uniform(low, high):
    return single(random.uniform(low, high))


def number(x):
    return mp.nstr(x, 20, strip_zeros=False)


def write(name, rows):
    with open("tests/data/" + name, "w") as f:
        for row in rows:
            f.write("{" + ", ".join(number(x) if isinstance(x, mpf) else repr(x) for x in row) + "},\n")


def line(t, x0, v0, m0, rate, force, w, relative):
    """By quadrature of the solution of M v' = F + M' (u - v), not by the header's formulas."""
    t, x0, v0, m0, rate, force, w = map(mpf, (t, x0, v0, m0, rate, force, w))
    if relative:
        def v(s):
            return v0 + (force + rate * w) * quad(lambda z: 1 / (m0 + rate * z), [0, s])
        x = x0 + v0 * t + (force + rate * w) * quad(lambda z: (t - z) / (m0 + rate * z), [0, t / 2, t])
    else:
        def v(s):
            return (m0 * v0 + (force + rate * w) * s) / (m0 + rate * s)
        x = x0 + quad(v, [0, t / 2, t])
    return v(t), x


rows = []
for k in range(60):
    m0, t = uniform(0.5, 10), uniform(0.1, 4)
    change = single(random.choice([-1, 1]) * 10 ** random.uniform(-12, 0) if k % 3 else random.uniform(-0.97, 6))
    change = max(change, -0.97)
    rate = single(change * m0 / t)
    x0, v0, force, w = uniform(-2, 2), uniform(-3, 3), uniform(-5, 5), uniform(-6, 6)
    relative = k % 2
    v, x = line(t, x0, v0, m0, rate, force, w, relative)
    m = single(m0 * (1 + change))
    rows.append((t, x0, v0, m0, rate, force, w, relative, v, x, m, mpf(v0) + mpf(w) * log(mpf(m) / mpf(m0))))
write("streams_line.h", rows)

rows = []
for k in range(40):
    A0, C0 = uniform(2, 9), uniform(1, 3)
    axial, transverse = uniform(0.1, 0.5), uniform(0.1, 1) if k % 4 else single(1e-6 * random.random())
    out, nozzle, t = uniform(0, 0.1), uniform(0, 2), uniform(0.5, 3)
    rate = single(-min(A0 / transverse, C0 / axial, 3) / t * random.uniform(0.05, 0.9))
    if k % 5 == 0:
        rate = -rate
    omega = (uniform(-2, 2), uniform(-2, 2), uniform(-9, 9))
    A = lambda s: mpf(A0) + mpf(rate) * mpf(transverse) * s
    C = lambda s: mpf(C0) + mpf(rate) * mpf(axial) * s
    decay = exp(quad(lambda s: mpf(rate) * (mpf(nozzle) ** 2 + mpf(out) - mpf(transverse)) / A(s), [0, t]))
    phase = mpf(omega[2]) * quad(lambda s: C(s) / A(s) - 1, [0, t])
    x = decay * (omega[0] * cos(phase) - omega[1] * sin(phase))
    y = decay * (omega[1] * cos(phase) + omega[0] * sin(phase))
    rows.append((t, rate, C0, A0, axial, transverse, out, nozzle) + omega + (x, y, phase))
write("streams_jet.h", rows)

# A uniform rod, sigma per metre, hangs from its end and loses its tip at l' = -c, what leaves moving with it:
# sigma l^3/3 phi'' = -sigma g l^2/2 sin phi; l = 2 - t/4, phi(0) = 1, phi'(0) = 1/2, g = 9.8125.
mp.dps = 25
solution = odefun(lambda s, y: [y[1], -mpf("1.5") * mpf("9.8125") / (2 - s / 4) * sin(y[0])], 0, [mpf(1), mpf("0.5")])
write("streams_pendulum.h", [(s,) + tuple(mpf(z) for z in solution(mpf(s))) for s in (1.0, 2.0, 4.0)])
