#!/usr/bin/env python3
"""Write tests/data/jacobi_table.h, amplitude_table.h, complete_table.h, means_table.h and solver_table.h:
arbitrary-precision values of what jacobi.h computes, at exactly the stored inputs.

usage: jacobi_reference.py [FACTOR [FOLDER [SEED]]]   FACTOR times as many points (make points: 20), elsewhere, others

Every value is given as high + low word (24 digits in all). About half of the inputs of each region are numbers of single
precision, which the float build of the tests uses; the double build uses all of them. sn, cn, dn come from the
descending Landen transformation in 60 digits and more; the script compares with a second route of mpmath on a sample.
"""
import random
import struct
import sys
from mpmath import mp, mpf, agm, atan2, cos, ellipe, ellipfun, ellipk, nint, pi, sin, sqrt

DIGITS = 60
FACTOR = int(sys.argv[1]) if len(sys.argv) > 1 else 1
FOLDER = sys.argv[2] if len(sys.argv) > 2 else "tests/data"
SEED = int(sys.argv[3]) if len(sys.argv) > 3 else 20
random.seed(SEED)


def single(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def words(x):
    high = float(x)
    return f"{high!r}, {float(x - mpf(high)):.8g}"


def quarter(m1):
    return pi / (2 * agm(1, sqrt(m1)))


def sncndn(u, m1):
    """sn, cn, dn of an mpf u for the complementary parameter m1, u reduced first."""
    if m1 == 0:
        return mp.tanh(u), mp.sech(u), mp.sech(u)
    K = quarter(m1)
    turns = nint(u / (2 * K))
    sign, u = (-1) ** int(turns % 2), u - 2 * K * turns
    a, b = [mpf(1)], [sqrt(m1)]
    while abs(a[-1] - b[-1]) > mpf(10) ** (5 - mp.dps) * a[-1]:
        a, b = a + [(a[-1] + b[-1]) / 2], b + [sqrt(a[-1] * b[-1])]
    s, c, d = sin(a[-1] * u), cos(a[-1] * u), mpf(1)
    for n in range(len(a) - 2, -1, -1):
        k = a[n] / a[n + 1] - 1
        s, c, d = (1 + k) * s / (1 + k * s * s), c * d / (1 + k * s * s), (1 - k * s * s) / (1 + k * s * s)
    return sign * s, sign * c, d


def digits_for(u, m):
    return 2 * DIGITS + 2 * int(abs(mp.log10(abs(m) + mpf(10) ** -320))) + (20 if abs(u) > 1 else 0)


def jacobi_row(region, u, m, complement=False):
    with mp.workdps(digits_for(u, m)):
        m1 = mpf(m) if complement else 1 - mpf(m)
        values = ", ".join(words(v) for v in sncndn(mpf(u), m1))
        K = repr(float(quarter(m1))) if m1 else "HUGE_VAL"
    return f'    {{"{region}", {int(complement)}, {u!r}, {m!r}, {K}, {values}}},'


def jacobi_regions():
    uniform, sign = random.uniform, lambda: random.choice((-1, 1))

    def pairs(region, count, draw_u, draw_m, complement=False, singles=True):
        for k in range(count * FACTOR):
            u, m = draw_u(), draw_m()
            if singles and k % 2:
                u, m = single(u), single(m)
            yield region, u, m, complement

    yield from pairs("|u| < K/2", 60, lambda: uniform(-.78, .78), lambda: uniform(0, 1))
    yield from pairs("|u| < 10", 120, lambda: uniform(-10, 10), lambda: uniform(0, 1))
    yield from pairs("-1 < m < 0", 80, lambda: uniform(-10, 10), lambda: uniform(-1, 0))
    yield from pairs("m < -1", 80, lambda: uniform(-10, 10), lambda: -10 ** uniform(0, 6))
    yield from pairs("m << -1", 30, lambda: 10 ** uniform(-8, 1), lambda: -10 ** uniform(6, 20))
    yield from pairs("m << -1", 30, lambda: 10 ** uniform(-150, -100), lambda: -10 ** uniform(200, 300), singles=False)
    yield from pairs("m << -1", 4, lambda: 10 ** uniform(-6, -4), lambda: -1e10)
    yield from pairs("m << -1", 4, lambda: 10 ** uniform(-151, -148), lambda: -1e300, singles=False)
    yield from pairs("m near 0", 40, lambda: uniform(-10, 10), lambda: sign() * 10 ** uniform(-20, -3))
    yield from pairs("m near 1", 40, lambda: uniform(-30, 30), lambda: 1 - 10 ** uniform(-7, -2))
    yield from pairs("m near 1", 60, lambda: uniform(-40, 40), lambda: 1 - 10 ** uniform(-16, -6), singles=False)
    yield from pairs("m = 1", 20, lambda: sign() * 10 ** uniform(-3, 1.5), lambda: 1.0)
    yield from pairs("m1 tiny", 30, lambda: uniform(-80, 80), lambda: 10 ** uniform(-37, -16), True)
    yield from pairs("m1 tiny", 30, lambda: uniform(-700, 700), lambda: 10 ** uniform(-300, -38), True, False)
    yield from pairs("|u| < 1e4", 60, lambda: uniform(-1e4, 1e4), lambda: uniform(-2, 1))
    yield from pairs("|u| < 1e9", 60, lambda: uniform(-1e9, 1e9), lambda: uniform(-2, 1), singles=False)
    for k in range(30 * FACTOR):  # next to multiples of K
        m1 = 10 ** uniform(-307 if k % 3 == 0 else -300, -17 if k % 3 else -290)
        with mp.workdps(40):
            u = float(random.choice((1, 2, 3, 7, 50)) * quarter(mpf(m1)))
        yield "m1 tiny", u, m1, True
    for k in range(360 * FACTOR):  # at the number next to a multiple of K, a few ulp off, farther off, to 100 K
        near, ulp = (single, 2.0 ** -23) if k % 2 else (float, 2.0 ** -52)
        m = near(random.choice((uniform(0, 1), uniform(-1, 0), -10 ** uniform(-3, 10), 1 - 10 ** uniform(-6, -1))))
        with mp.workdps(40):
            u = near(random.choice((1, 1, 2, 3, 4, 5, 8, 17, 50, 99)) * quarter(1 - mpf(m)))
        yield "u near jK", near(u * (1 + random.choice((0, 0, ulp, -ulp, 3 * ulp, 1e-12, -1e-8)))), m, False
    own = random.Random(SEED + 2)  # the draws above and below stay as they are
    for k in range(120 * FACTOR):  # u = j K +- v with v just above a power of two: its ulp is largest there, relative to v
        near, j, v = single if k % 2 else float, 2 * own.randint(0, 49) + 1, 1 + own.uniform(0, .05)
        v, j = (v / 2, j) if k % 4 < 2 else (v * 2.0 ** -own.randint(1, 3), j - own.randint(0, 1))
        m = near(-10 ** own.uniform(-6, -1) if k % 4 < 2 else own.choice((own.uniform(-.3, .3), -10 ** own.uniform(-1, 1.5))))
        with mp.workdps(40):
            u = near(j * quarter(1 - mpf(m)) + own.choice((-1, 1)) * v)
        yield "v above 2^-n", u, m, False
    for u, m in WORST:
        yield "worst", u, m, False
    for near, least in (float, -323.3), (single, -44.8):  # below eps^2 and into the subnormal numbers
        for k, m1 in enumerate([near(10 ** (least + e)) for e in (0, 0.4, 2, 4, 9, 13.5, 15.3, 17)]):
            with mp.workdps(40):
                K = float(quarter(mpf(m1)))
            for j in (3, 32, 98):
                yield "m1 least", near((j + 0.11 * (k + 1)) * K), m1, True


# where errors beyond the bounds, or nearly so, have been found: next to the edges of a series, in the last places of
# a reduced argument, in the phase of a large one
WORST = ((1.5738144120518882, 0.96372153102655389), (1.4562745436990139, 0.97095794892184717),
         (1.4609171633423244, 0.95138128720003634), (1.5037454851115841, 0.96844886342349523),
         (1.4993568845469039, 0.97073841162373842), (4.8616667323561948, 0.97060246979979015),
         (1.3917563765146419, 0.95370654105254871), (0.93906475580234328, -21.400480506316349),
         (0.92491827548618344, -22.430978598287222), (4.3011217626738585, -22.785899363234897),
         (-0.38166483960647563, -12.429652003318981), (1.0484683502383100, -2.082933610001875e-07),
         (1.8017667277183738, 0.43299245396041214), (6.6479132462336041, 0.91577786802893879),
         (50.593170400432854, 0.99999999999998601), (4.1670951843261719, -0.030139099806547165),
         (606584222.08948791, -23981.441535423004), (808314325.2519846, -36064.985706958061),
         (-954408995.3064301, -37427.30282231501), (753773701.62084389, -37067.159128921689),
         (-876790989.3410604, -35232.72552120607), (-2.4983902659658694e-18, -3.4028228579130005e38),
         (1.3e-154, -1.7e308), (0.33686122683001096, -14.404084102748524),
         (-8.3465996483446503, -0.0045901556170718071))


def amplitude_rows():
    """am u, j pi + atan2(sn, cn) with j the multiple of 2K next to u, for |u| < 100 K"""
    random.seed(SEED + 1)
    rows = [(region, u, m) for region, u, m, complement in jacobi_regions() if not complement]
    for region, u, m in random.sample(rows, 240 * FACTOR) + [("worst", u, m) for u, m in WORST]:
        with mp.workdps(digits_for(u, m)):
            m1, x = 1 - mpf(m), mpf(u)
            K = quarter(m1) if m1 else mpf(10) ** 9
            if abs(x) < 100 * K:
                turns = nint(x / (2 * K))
                sn, cn, _ = sncndn(x - 2 * K * turns, m1)
                yield f'    {{"{region}", {u!r}, {m!r}, {words(turns * pi + atan2(sn, cn))}}},'


def complete_rows():
    uniform = random.uniform
    draws = (lambda: uniform(0, 1), lambda: uniform(-1, 0), lambda: -10 ** uniform(0, 3), lambda: -10 ** uniform(3, 300),
             lambda: 1 - 10 ** uniform(-16, -1), lambda: 10 ** uniform(-20, 0), lambda: -10 ** uniform(-20, 0))
    cases = [(0, m) for m in (0.0, 0.5, -1.0, 0.9, -4.0, 0.7, 0.1, -1e10, -1e300, 0.97, 0.03)]
    for k in range(210 * FACTOR):
        m = draws[k % len(draws)]()
        cases.append((0, single(m) if k % 2 and abs(m) < 1e37 else m))
    cases += [(1, 10 ** uniform(-300, -1)) for _ in range(30 * FACTOR)]
    for complement, m in cases:
        if m == 1:
            continue
        with mp.workdps(digits_for(1, m)):
            m1 = mpf(m) if complement else 1 - mpf(m)
            yield f"    {{{complement}, {m!r}, {words(quarter(m1))}, {words(ellipe(1 - m1))}}},"


# m for which roundings add up most in C6; with 1 - 3 C2 + 3 C4 - C6 for the mean of sn^6 it lost 9 to 12 ulp. The second
# line is of single precision.
MEANS_HARD = (-4.0281081754640677, -4.1790960544325699, -4.7411273127496676, -5.4820681897461707, -5.577068179401385,
              -4.0881071090698242, -4.1351389884948730, -4.5658273696899414, -5.4466524124145508, -6.9989247322082520)


def means_row(m):
    """C2, C4, C6 by (383), (384), (408), whose divisions by m lose digits that are carried in excess"""
    with mp.workdps(150):
        x, K, E = mpf(m), ellipk(mpf(m)), ellipe(mpf(m))
        C2 = (E / K - 1 + x) / x
        C4 = (2 * (2 * x - 1) * C2 + (1 - x)) / (3 * x)
        C6 = (4 * (2 * x - 1) * C4 + 3 * (1 - x) * C2) / (5 * x)
        return f"    {{{m!r}, {{{{{words(C2)}}}, {{{words(C4)}}}, {{{words(C6)}}}}}}},"


def means_rows():
    uniform = random.uniform
    draws = (lambda: uniform(0, 1), lambda: uniform(-1, 0), lambda: -10 ** uniform(0, 1), lambda: -10 ** uniform(1, 10),
             lambda: 1 - 10 ** uniform(-15, -1), lambda: 10 ** uniform(-18, 0), lambda: -10 ** uniform(-18, 0))
    for k in range(140 * FACTOR):
        m = draws[k % len(draws)]()
        m = single(m) if k % 3 == 0 else m
        if m != 1:
            yield means_row(m)
    for m in MEANS_HARD:
        yield means_row(m)


def solver_rows():
    """k'K = c solved for k' by bisection: c, m1 = k'^2"""
    for c in (0.01, 0.3, 1.0, 1.3, 1.5, 1.578125, 1.7, 2.0, 2.5, 3.0, 4.0, 5.5, 7.0, 9.584875, 12.0, 15.0, 19.7, 25.0, 33.0, 100.0, 355.5, 1e-30, 1e-150):
        c = single(c) if c > 1e-30 and c < 99 else c
        low, high = mpf(10) ** -160, mpf(10) ** 160
        for _ in range(700):
            middle = sqrt(low * high)
            low, high = (middle, high) if middle * pi / (2 * agm(1, middle)) < c else (low, middle)
        yield f"    {{{c!r}, {words(low * low)}, {words(1 - low * low)}}},"


def check_jacobi():
    with mp.workdps(50):
        for u, m in ((0.7, 0.3), (7.7, 0.8), (2.5, -3.0), (11.0, 0.999)):
            ours = sncndn(mpf(u), 1 - mpf(m))
            theirs = [ellipfun(name, mpf(u), m=mpf(m)) for name in ("sn", "cn", "dn")]
            assert all(abs(a - b) < mpf(10) ** -45 for a, b in zip(ours, theirs)), (u, m)
            assert abs(quarter(1 - mpf(m)) - ellipk(mpf(m))) < mpf(10) ** -45


def write(name, comment, rows):
    with open(f"{FOLDER}/{name}", "w") as file:
        file.write(f"/* Written by tests/gen/jacobi_reference.py: {comment} */\n")
        file.write("\n".join(rows) + "\n")
    print(name, len(rows))


mp.dps = DIGITS
check_jacobi()
write("jacobi_table.h", "region, form (0: m, 1: m1), u, m or m1, K, sn, cn, dn as high and low words",
      [jacobi_row(region, u, m, c) for region, u, m, c in jacobi_regions()])
write("complete_table.h", "form (0: m, 1: m1), m or m1, K, E as high and low words", list(complete_rows()))
write("means_table.h", "m, means of cn^2, cn^4, cn^6 as high and low words", list(means_rows()))
write("solver_table.h", "c, m1 and m of k'K(k^2) = c as high and low words", list(solver_rows()))
write("amplitude_table.h", "region, u, m, am as high and low words", list(amplitude_rows()))
