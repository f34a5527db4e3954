#!/usr/bin/env python3
"""Write tests/data/oscillator_table.h: the oscillator (m x')' + x|x|^(alpha-1) = 0, m = 1 + eps t, in 20 digits and more.

A row: alpha, eps, the Ateb phase psi0 of the start, x and x' there (exactly the stored numbers, amplitude 1), then x and the
amplitude at t = T i/16, 0 < i <= 16, T = 3/eps. By Taylor series of order 36 in fixed-point numbers of 136 bits. For alpha =
4/3 the motion is not smooth at x = 0; there it goes on as t and p = m x' over sigma, x = sigma^3, which both are smooth in
sigma on each side. Each motion is computed twice, with other orders, steps and precision, and must be the same.
"""
from fractions import Fraction
from operator import mul

from mpmath import mp, mpf

mp.dps = 50
POINTS = 16


class Motion:
    """From x, p at t = 0; numbers are integers over 2^bits"""

    def __init__(self, alpha, eps, x, p, order, bits, near):
        self.alpha, self.order, self.bits = alpha, order, bits
        self.eps, self.x, self.p, self.t = self.fixed(eps), self.fixed(x), self.fixed(p), 0
        self.near = 0 if alpha.denominator == 1 else self.fixed(near)

    def fixed(self, x):
        return round(Fraction(x) * 2**self.bits)

    def root(self, x, n):  # x >= 0
        return int(mp.floor(mp.root(mpf(x) / 2**self.bits, n) * 2**self.bits))

    def mass(self, t):
        return (1 << self.bits) + (self.eps * t >> self.bits)

    def convolved(self, a, b, n):
        return sum(map(mul, a[:n + 1], b[n::-1])) >> self.bits

    def length(self, series, most):
        """A step after which the series has converged, of the sign of most, at most that long"""
        tolerance = self.bits - 8 - max(abs(series[0]).bit_length() - self.bits, 0)
        sizes = [(n, abs(series[n]).bit_length() - self.bits) for n in (self.order - 1, self.order)]
        h = min(2 ** ((-tolerance - size) / n) for n, size in sizes)
        h = self.fixed(min(h, 1.0))
        return most if abs(most) <= h else h if most > 0 else -h

    def value(self, series, h):
        y = 0
        for c in reversed(series):
            y = c + (y * h >> self.bits)
        return y

    def force(self, x, f, n):
        """Term n of x^alpha, x > 0 where alpha is no integer"""
        if self.alpha == 3:
            self.square.append(self.convolved(x, x, n))
            return self.convolved(self.square, x, n)
        a, b = self.alpha.numerator, self.alpha.denominator
        if n == 0:
            return x[0] * self.root(x[0], b) >> self.bits  # 4/3
        return sum((a * k - b * (n - k)) * x[k] * f[n - k] for k in range(1, n + 1)) // (b * n * x[0])

    def far(self, t_end):
        """A step in time"""
        sign = -1 if self.x < 0 else 1
        x, p, f, m = [sign * self.x], [sign * self.p], [], self.mass(self.t)
        self.square = []
        for n in range(self.order):
            f.append(self.force(x, f, n))
            x.append(((p[n] << self.bits) - self.eps * n * x[n]) // ((n + 1) * m))
            p.append(-f[n] // (n + 1))
        h = self.length(x, self.length(p, t_end - self.t))
        self.x, self.p, self.t = sign * self.value(x, h), sign * self.value(p, h), self.t + h

    def sigma_series(self, sigma, sign):
        """t and p over sigma: t' = 3 sigma^2 m/p, p' = -3 |sigma| sigma^5 m/p"""
        one = 1 << self.bits
        t, p, m, r = [self.t], [self.p], [self.mass(self.t)], []
        powers = {n: self.binomial(sigma, n) for n in (2, 6)}
        for n in range(self.order):
            rest = m[n] * one - sum(map(mul, r, p[n:0:-1]))
            r.append(rest // p[0])
            dt, dp = (3 * sum(c * r[n - k] for k, c in enumerate(powers[j][:n + 1])) >> self.bits for j in (2, 6))
            t.append(dt // (n + 1))
            m.append(self.eps * t[-1] >> self.bits)
            p.append(-sign * dp // (n + 1))
        return t, p

    def binomial(self, sigma, n):
        terms, c = [], 1
        for k in range(n + 1):
            power = 1 << self.bits
            for _ in range(n - k):
                power = power * sigma >> self.bits
            terms.append(c * power)
            c = c * (n - k) // (k + 1)
        return terms

    def through_zero(self, t_end):
        """From |x| < near by way of 0 to |x| = near on the other side, or to t_end"""
        sign = 1 if self.x > 0 else -1
        sigma, edge = sign * self.root(abs(self.x), 3), self.root(self.near, 3)
        while True:
            goal = 0 if sigma * sign > 0 else -sign * edge
            side = sign if sigma * sign > 0 else -sign
            t, p = self.sigma_series(sigma, side)
            h = self.length(t, self.length(p, goal - sigma))
            if self.value(t, h) >= t_end:
                h = self.solved(t, t_end, h)
            sigma, self.t, self.p = sigma + h, self.value(t, h), self.value(p, h)
            self.x = (sigma * sigma >> self.bits) * sigma >> self.bits
            if abs(self.t - t_end) < 64 or sigma == -sign * edge:
                return

    def solved(self, t, t_end, h):
        """Where the series t comes to t_end: a Newton iteration"""
        rate = [n * c for n, c in enumerate(t)][1:]
        for _ in range(50):
            h -= ((self.value(t, h) - t_end) << self.bits) // self.value(rate, h)
        return h

    def go(self, t_end):
        t_end = self.fixed(t_end)
        while abs(t_end - self.t) >= 64:
            if abs(self.x) < self.near and self.x * self.p < 0:
                self.through_zero(t_end)
            else:
                self.far(t_end)

    def state(self):
        """x, p, amplitude"""
        x, p, m = (mpf(y) / 2**self.bits for y in (self.x, self.p, self.mass(self.t)))
        n = mpf(self.alpha.numerator) / self.alpha.denominator + 1
        return x, p, (abs(x) ** n + n * p**2 / (2 * m)) ** (1 / n)


def start(alpha, psi):
    """x, x' of amplitude 1 at m = 1"""
    motion = Motion(alpha, 0, 1, 0, 40, 160, 0.25)
    motion.go(Fraction(float(mp.sqrt(2 / (mpf(alpha.numerator) / alpha.denominator + 1)))) * Fraction(psi))
    return [float(y) for y in motion.state()[:2]]


def motions(alpha, eps, x, v):
    both = [Motion(alpha, eps, x, v, *how) for how in ((36, 136, 0.25), (32, 124, 0.2))]
    for i in range(1, POINTS + 1):
        for motion in both:
            motion.go(Fraction(round(3 / eps) * i, POINTS))
        (x, p, A), (x2, p2, A2) = (motion.state() for motion in both)
        assert abs(x - x2) + abs(p - p2) + abs(A - A2) < 1e-20, (alpha, eps, i, x - x2)
        yield x, A


def spec_cases():
    """Published digits of the dissertation's example 1"""
    motion = Motion(Fraction(3), Fraction(1, 10), 1, 0, 36, 128, 0)
    for t, x in ((10, "0.8329476745754213932"), (20, "0.1626996653923250896")):
        motion.go(t)
        assert abs(motion.state()[0] - mpf(x)) < 1e-18


def main():
    spec_cases()
    rows = []
    for alpha in (Fraction(3), Fraction(4, 3)):
        for psi in (0.0, 0.7):
            x, v = start(alpha, psi) if psi else (1.0, 0.0)
            for eps in (0.1, 0.01, 0.001):
                points = list(motions(alpha, eps, x, v))
                xs, As = (",\n      ".join(", ".join(mp.nstr(y[k], 20) for y in points[i:i + 4]) for i in range(0, POINTS, 4))
                          for k in (0, 1))
                rows.append(f"    {{{float(alpha)!r}, {eps}, {psi}, {x!r}, {v!r},\n     {{{xs}}},\n     {{{As}}}}},")
    with open("tests/data/oscillator_table.h", "w") as file:
        file.write("/* Written by tests/gen/oscillator_reference.py: alpha, eps, psi0, x0, x'0, x and amplitude at 3/eps i/16 */\n"
                   "static const oscillator_case oscillator_table[] = {\n" + "\n".join(rows) + "\n};\n")
    print("oscillator_table.h", len(rows))


if __name__ == "__main__":
    main()
