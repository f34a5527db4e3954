#!/usr/bin/env python3
"""Print the tables and polynomials of the elementary functions, src/base/elementary.h.

Logarithm: x = 2^k z, z from 0.7083 to 1.4167 in 32 intervals of 1/44, one of them with 1 in its middle. Of each: 1/c,
close to the reciprocal of its middle and short, and ln c in two words, the first a multiple of a power of two, so
that k ln 2 + ln c is exact in the high words. Then ln(1 + r) = r - r^2/2 + r^3 L(r).
Exponential: e^r = 1 + r + r^2/2 + r^3 E(r), |r| <= ln(2)/2. L and E by interpolation in the Chebyshev points.
Hyperbolic functions, for src/jacobi/theta.h: sinh r = r + r y P(y) and cosh r = 1 + y C(y) with y = r^2, for the same r.
"""
import random
import struct
import sys
from mpmath import beta, mp, mpf, cos, sin, pi, log, exp, sqrt, sinh, cosh, factorial, floor, polyval, nstr

mp.dps = 60
N = 32


def nearest(x, bits):
    """The multiple of 2^-bits next to x."""
    return floor(mpf(x) * mpf(2)**bits + mpf(1) / 2) / mpf(2)**bits


def single(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def rounded(x, bits):
    kept, mp.prec = mp.prec, bits
    y = +mpf(x)
    mp.prec = kept
    return y


def powers(f, degree, bound, least=None):
    """Coefficients of the polynomial that agrees with f in the Chebyshev points of [least, bound], or [-bound, bound]."""
    middle, half = (0, bound) if least is None else ((bound + least) / 2, (bound - least) / 2)
    node = [middle + half * cos(pi * (2 * k + 1) / (2 * degree + 2)) for k in range(degree + 1)]
    difference = [f(x) for x in node]
    for order in range(1, degree + 1):
        for k in range(degree, order - 1, -1):
            difference[k] = (difference[k] - difference[k - 1]) / (node[k] - node[k - order])
    total = [difference[degree]]
    for k in range(degree - 1, -1, -1):
        total = [mpf(0)] + total
        for j in range(len(total) - 1):
            total[j] -= node[k] * total[j + 1]
        total[0] += difference[k]
    return total


def L(r):
    return sum((-1)**n * r**n / (n + 3) for n in range(60))


def E(r):
    return sum(r**n / factorial(n + 3) for n in range(50))


def P(y):
    return sum(y**n / factorial(2 * n + 3) for n in range(30))


def C(y):
    return sum(y**n / factorial(2 * n + 2) for n in range(30))


def show(name, values, digits):
    text = [f"VM_C({nstr(v, digits, min_fixed=-4, max_fixed=3) if v else '0.0'})" for v in values]
    print(f"{name}: " + ", ".join(text))


def tables(bits, short, grid, log_degree, exp_degree, hyperbolic_degree):
    digits = 20 if bits == 53 else 12
    print(f"---- {bits} bits")
    widest = mpf(0)
    for i in range(N):
        middle = 1 + mpf(i - 13) / 44
        reciprocal = nearest(1 / middle, short)
        ends = max(middle - mpf(1) / 88, mpf(17) / 24), middle + mpf(1) / 88
        widest = max([widest] + [abs(reciprocal * z - 1) for z in ends])
        first = nearest(-log(reciprocal), grid)
        show(f"{i}", [reciprocal, first, rounded(-log(reciprocal) - first, bits)], digits)
    first = nearest(log(2), grid)
    show("ln 2", [first, rounded(log(2) - first, bits)], digits)
    print("largest |r|", nstr(widest, 5))
    for name, f, degree, bound in (("L", L, log_degree, widest), ("E", E, exp_degree, log(2) / 2)):
        c = [rounded(x, bits) for x in powers(f, degree, bound)]
        error = max(abs(polyval(c[::-1], x) - f(x)) for x in (bound * (mpf(k) / 100 - 1) for k in range(201)))
        show(name, c, digits)
        print(f"   |r| <= {nstr(bound, 5)}, error of r^3 {name}: {nstr(error * bound**3, 3)}"
              f" = 2^{nstr(log(error * bound**3, 2), 4)}")
    bound = log(2)**2 / 4 * mpf("1.001")
    for name, f in (("P", P), ("C", C)):
        c = [rounded(x, bits) for x in powers(f, hyperbolic_degree, bound, mpf(0))]
        error = max(abs(polyval(c[::-1], x) - f(x)) for x in (bound * mpf(k) / 200 for k in range(201)))
        show(name, c, digits)
        print(f"   0 <= y <= {nstr(bound, 5)}, error of y {name}: {nstr(error * bound, 3)}")


def words(x):
    high = float(x)
    return f"{high!r}, {float(x - mpf(high))!r}"


def reference():
    """tests/data/elementary_table.h: x, y; ln x, e^y, x^y"""
    random.seed(40)
    with open("tests/data/elementary_table.h", "w") as file:
        file.write("/* Written by tests/gen/elementary.py: x, y, ln x, e^y, x^y as high and low words */\n")
        for count in range(400):
            near = single if count % 2 else float
            large = 40 if count % 2 else 350
            x = near(random.choice((1 + random.uniform(-1, 1) * 2.0 ** random.uniform(-20, -1),
                                    2.0 ** random.uniform(-large, large), 1 + random.choice((-1, 1)) / 88)))
            y = near(random.choice((-1, 1)) * random.choice((2.0 ** random.uniform(-20, 6), random.uniform(0, 2 * large))))
            if abs(y) > 2 * large or x == 1:
                continue
            power = abs(y * log(mpf(x))) < 2 * large
            file.write(f"    {{{x!r}, {y!r}, {words(log(mpf(x)))}, {words(exp(mpf(y)))}, "
                       f"{words(mpf(x)**mpf(y)) if power else '0, 0'}}},\n")


# Where the errors of the kernels are largest, as far as a search found; of each bound of tests/proof/bounds.txt one point in
# double and one in float. An argument is a pair of words; a power has a second argument of one word (pow_two: with a low word in
# the first argument). The argument of g is alpha: g = Pi_alpha - (alpha + 1).
POINTS = """
double sine     0x1.770d3a0a8d98cp-1  -0x1.9b29d4a081482p-55
double cosine   0x1.8c5987a858075p-1   0x1.83d9889367f6p-54
double exp     -0x1.5d432eedecb6ep-2   0x1.b10a9668bfdb2p-55
double exp     -0x1.5d911d0777eaep-2   0x1.97ab20555957cp-56
double log      0x1.fa2c38efad3abp-1   0x0p+0
double log      0x1.fa2b8d3d4f1b3p-1   0x0p+0
double pow      0x1.fa2c38efad3abp-1   0x0p+0               -0x1.e1991e13f56edp+15
double pow      0x1.fa2b8d3d4f1b3p-1   0x0p+0               -0x1.de11e024367dfp+15
double pow_two  0x1.0000000000082p+0   0x1.f8f2f493a91e4p-54  -0x1.53502953b0cadp+54
float  sine     0x1.861c4p-1           0x1.b2b526p-26
float  cosine   0x1.8b7022p-1          0x1.e2ff3p-25
float  exp     -0x1.60ce08p-2         -0x1.c653fap-26
float  exp     -0x1.5d79p-2           -0x1.fe83acp-33
float  exp     -0x1.1f4a04p+2          0x0p+0
float  log      0x1.034be6p+0          0x0p+0
float  pow      0x1.034be6p+0          0x0p+0                0x1.a73baep+12
double g        0x1.f96c68ccafe9ap+5   0x0p+0
float  g        0x1.f1a776p+5          0x0p+0
"""


def points():
    """tests/data/kernel_points.h: whether the point is for float; kernel; hi, lo and y of the argument; the value"""
    functions = {"sine": sin, "cosine": cos, "exp": exp, "log": log,
                 "g": lambda alpha: beta(1 / (alpha + 1), mpf(1) / 2) - (alpha + 1)}
    with open("tests/data/kernel_points.h", "w") as file:
        file.write("/* Written by tests/gen/elementary.py: 1 for float; kernel; the argument's words; y; the value's words */\n")
        for line in POINTS.strip().split("\n"):
            precision, name, *numbers = line.split()
            hi, lo, y = [float.fromhex(x) for x in (numbers + ["0x0p+0"])[:3]]
            x = mpf(hi) + mpf(lo)
            value = x**mpf(y) if name.startswith("pow") else functions[name](x)
            file.write(f'    {{{int(precision == "float")}, "{name}", {hi!r}, {lo!r}, {y!r}, {words(value)}}},\n')


if len(sys.argv) > 1:  # any argument: the tables of the tests
    reference()
    points()
else:
    tables(53, 10, 42, 7, 9, 4)
    tables(24, 8, 16, 3, 5, 2)
