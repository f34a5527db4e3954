#!/usr/bin/env python3
"""Write tests/data/beta_table.h and tests/data/ateb_nm_table.h: arbitrary-precision values at exactly the stored inputs,
as high and low words. Every other row has inputs of single precision, which the float build of the tests uses.

beta_table.h: x, a, b, I_x(a, b), I_y(b, a) with y = 1 - x, B(a, b); then the same way back: p, whether it is the tail of
x or of y, x and y = 1 - x, and ln x for I = p. By hypergeometric series and Newton's method in 60 digits.
"""
import random
import struct
from mpmath import mp, mpf, beta, exp, gamma, hyp2f1, log, sqrt

random.seed(30)
mp.dps = 60


def single(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def words(x):
    high = float(x)
    return f"{high!r}, {float(x - mpf(high))!r}"


def lower(x, y, a, b):
    return x**a * y**b / (a * beta(a, b)) * hyp2f1(1, a + b, a + 1, x, maxterms=10**6)


def tails(x, y, a, b):
    if x * (a + b + 2) <= a + 1:
        p = lower(x, y, a, b)
        return p, 1 - p
    q = lower(y, x, b, a)
    return 1 - q, q


def at(t):
    e = exp(-abs(t))
    small, large = e / (1 + e), 1 / (1 + e)
    return (small, large) if t < 0 else (large, small)


def invert(p, a, b):
    """ln(x/y) for which I_x(a, b) = p, from the left"""
    t = (log(p) + log(a) + log(beta(a, b))) / a
    for _ in range(200):
        x, y = at(t)
        value = tails(x, y, a, b)[0]
        step = (log(p) - log(value)) * value * beta(a, b) / (x**a * y**b)
        t += step
        if abs(step) < mpf(10) ** -38 * max(1, abs(t)):
            return t
    raise ArithmeticError


def beta_rows():
    count = 0
    while count < 360:
        near = single if count % 2 else float
        a, b = near(10 ** random.uniform(-3, 3)), near(10 ** random.uniform(-3, 3))
        if count % 12 == 11:
            a, b = near(10 ** random.uniform(3, 4)), near(10 ** random.uniform(2, 4))
        x = near(random.random() if count % 3 else min(random.betavariate(a, b), 0.999))
        if x < 1e-30:
            x = near(random.random())
        p, q = tails(mpf(x), 1 - mpf(x), mpf(a), mpf(b))
        if p < mpf(10) ** -30 or q < mpf(10) ** -30:
            continue
        tail = near(random.choice((random.random() / 2, 10 ** random.uniform(-25, -1))))
        of_y = count // 2 % 2
        t = invert(mpf(tail), mpf(b), mpf(a)) if of_y else invert(mpf(tail), mpf(a), mpf(b))
        t = -t if of_y else t
        X, Y = at(t)
        log_x = t - log(1 + exp(t)) if t < 0 else -log(1 + exp(-t))
        density = X ** mpf(a) * Y ** mpf(b) / beta(mpf(a), mpf(b))
        yield (f"    {{{x!r}, {a!r}, {b!r}, {words(p)}, {words(q)}, {words(beta(mpf(a), mpf(b)))}, {tail!r}, {of_y}, "
               f"{words(X)}, {words(Y)}, {words(log_x)}, {float(mpf(tail) / density)!r}}},")
        count += 1


def nm_rows():
    indices = (0.0, 0.001, 0.125, 0.5, 1.0, 1.5, 3.0, 10.0, 100.0, 1000.0)
    for count in range(160):
        near = single if count % 2 else float
        n, m = near(random.choice(indices)), near(random.choice(indices))
        a, b = 1 / (mpf(n) + 1), 1 / (mpf(m) + 1)
        period = beta(a, b)
        s = near(float(period / 2) * random.choice((random.random(), 10 ** random.uniform(-6, 0))))
        if not 0 < mpf(s) < period / 2:
            continue
        p = 2 * mpf(s) / period
        t = invert(p, a, b) if p < 0.5 else -invert(1 - p, b, a)
        ln_x = t - log(1 + exp(t)) if t < 0 else -log(1 + exp(-t))
        yield f"    {{{s!r}, {n!r}, {m!r}, {words(exp(a * ln_x))}, {words(exp(b * (ln_x - t)))}, {words(period)}}},"


def nm_far_rows():
    """beyond the first quarter, zeros to an ulp included"""
    indices = (0.0, 0.001, 0.125, 0.5, 1.0, 1.5, 3.0, 10.0, 100.0, 1000.0)
    for count in range(80):
        near = single if count % 2 else float
        n, m = near(random.choice(indices)), near(random.choice(indices))
        a, b = 1 / (mpf(n) + 1), 1 / (mpf(m) + 1)
        half = beta(a, b) / 2
        s = near(float(half) * (random.uniform(-200, 200) if count % 4 < 2 else random.choice((1, 2, 3, 32, 199))))
        quarter = int(mp.nint(abs(s) / half))
        rest = abs(mpf(s)) - quarter * half
        if rest == 0:
            continue
        near_zero, far_zero = abs(rest), half - abs(rest)
        r, d = (far_zero, near_zero) if quarter % 2 else (near_zero, far_zero)
        t = invert(r / half, a, b) if r < d else -invert(d / half, b, a)
        l = log(1 + exp(-abs(t)))
        ln_x, ln_y = (t - l, -l) if t < 0 else (-l, -t - l)
        sa, ca = exp(a * ln_x), exp(b * ln_y)
        if quarter % 2:
            ca = -ca if rest > 0 else ca
        elif rest < 0:
            sa = -sa
        if quarter & 2:
            sa, ca = -sa, -ca
        yield f"    {{{s!r}, {n!r}, {m!r}, {words(sa if s > 0 else -sa)}, {words(ca)}, {words(2 * half)}}},"


def write(name, comment, rows):
    with open(f"tests/data/{name}", "w") as file:
        file.write(f"/* Written by tests/gen/beta_reference.py: {comment} */\n")
        file.write("\n".join(rows) + "\n")
    print(name, len(rows))


write("beta_table.h", "x, a, b, I_x(a, b), I_y(b, a), B(a, b), p, of y?, x, y, ln x, p/(dp/dln(x/y))", list(beta_rows()))
write("ateb_nm_table.h", "s, n, m, sa(n, m, s), ca(m, n, s), Pi(n, m)", list(nm_rows()) + list(nm_far_rows()))
