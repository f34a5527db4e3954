"""Pi_alpha (src/ateb/period.h): the errors of its two tables, and what rounding adds to them.

With q = 1/(alpha + 1) the tables approximate
    F(t) = sqrt(pi) Gamma(4 + q)/Gamma(q + 1/2), t = 2 q - 1, by a polynomial of degree 33 (float 17), and
    g(q) = Pi_alpha - 1/q, by a polynomial in the distance of q from the nearest multiple of 1/32.
How far a polynomial is from its function is bounded for all arguments. Both functions are integrals,
    F = (q + 1/2) (q + 3/2) (q + 5/2) (q + 7/2) B(q + 4, 1/2),  B(a, 1/2) = integral of s^(a-1) (1 - s)^(-1/2) from 0 to 1,
    g = integral of s^(q-1) ((1 - s)^(-1/2) - 1) from 0 to 1;
the integrals are largest for real q, so that a bound M of the function on an ellipse around the interval is known.
Interpolation by a polynomial of degree n, in n + 1 Chebyshev points, is within 4 M/(r^n (r - 1)) of the function, where r
is the sum of the half axes of the ellipse for the interval [-1, 1] (Trefethen, Approximation Theory and Approximation
Practice, theorem 8.2). The
Chebyshev coefficients of the interpolation of function minus polynomial add up to a bound of the rest. mpmath computes
them with 120 digits.
"""
import math
from fractions import Fraction as F

from mpmath import cos, digamma, fsum, gamma, log, mp, mpf, pi, polyval, sqrt

from provers import Case, above, between, outward
from source import Kernel, cut, dyadic

mp.dps = 120
POINTS = 80
HALF = mpf(1) / 2


def real(q):
    return mpf(q.numerator) / q.denominator


def rational(x):
    """A short number above x >= 0"""
    return outward(F(int(x * mpf(2)**300) + 1, 2**300), True, 40)


def distance(function, polynomial, largest, ratio):
    """A bound of |function - polynomial| on [-1, 1]. largest: M on the ellipse whose half axes have the sum `ratio`"""
    angles = [pi * (k + HALF) / POINTS for k in range(POINTS)]
    value = [function(cos(a)) - polynomial(cos(a)) for a in angles]
    size = fsum(abs(fsum(v * cos(j * a) for v, a in zip(value, angles))) for j in range(POINTS))
    return rational(2 * size / POINTS + 4 * largest / (mpf(ratio)**(POINTS - 1) * (ratio - 1)))


# ---- F in two words ----

def F_of(t):
    return sqrt(pi) * gamma(4 + (1 + t) / 2) / gamma(1 + t / 2)


def words_of_coefficients(precision):
    """The lists of the first and of the second words, equally long"""
    k = Kernel("vmi_ateb_coefficient", precision, "ateb.h")
    high, low = [[k.value(x) for x in cut(k.define[key].strip("{}"), ",")]
                 for name in ("high[", "low[") for key in k.define if key.startswith(name)]
    return high, low + [F(0)] * (len(high) - len(low))


def series(precision, _goal):
    """The relative error of the polynomial. On the ellipse with the half axes 6.042 and 5.958, |q| < 3.53 and the real part
    of q is above -2.53, so that |B(q + 4, 1/2)| < B(1.47, 1/2) < 2. F is at least 6."""
    c = [real(sum(words)) for words in zip(*words_of_coefficients(precision))]
    largest = 2 * mpf("4.03") * mpf("5.03") * mpf("6.03") * mpf("7.03")
    return distance(F_of, lambda t: polyval(c[::-1], t), largest, 12) / 6


def rounding(precision):
    """The relative error that rounding adds in vmi_ateb_polynomial, in parts of the interval, by the rule that each operation
    has the error u times its result. Dekker's sum of a coefficient and a product is exact, as the coefficient has no
    smaller exponent. The bound is computed in double, and 1/1000 is added for this."""
    k = Kernel("vmi_ateb_polynomial", precision, "ateb.h")
    k.expect_body("tail = vmi_ateb_coefficient(0, i) + tail * t.hi;", "p = vmi_two_product(sum.hi, t.hi);",
                  "hi = high + p.hi;", "sum.hi = hi;",
                  "sum.lo = (p.hi - (hi - high)) + (p.lo + (sum.hi * t.lo + sum.lo * t.hi) + low);",
                  f"TWO_WORDS = {precision.digits} > 24 ? 17 : 8")
    two_words = 8 if precision.single else 17
    high, low = words_of_coefficients(precision)
    c, parts, u, worst = [float(x) for x in high], 64, 2.0**-precision.digits, 0.0
    for part in range(parts):
        a, b = [2 * (part + end) / parts - 1 for end in (0, 1)]
        t, middle, value, slope = max(abs(a), abs(b)), (a + b) / 2, 0.0, 0.0
        size, error, lo = 0.0, 0.0, 0.0  # of the sum: its largest magnitude, its error, its low word
        for i in range(len(c) - 1, -1, -1):
            slope = slope * t + abs(value) + slope * (b - a) / 2  # a bound of the derivative of the sum
            value = value * middle + c[i]
            before, size = size, (abs(value) + slope * (b - a) / 2) * (1 + 1e-9)
            if i >= two_words:
                error = error * t + u * (2 * before * t + size)  # product, sum, and t.lo, which is left out
                continue
            if math.frexp(c[i])[1] < math.frexp(before)[1]:
                raise SystemExit(f"Dekker's sum need not be exact for coefficient {i}")
            first, second = before * u * t, lo * t       # sum.hi t.lo, sum.lo t.hi
            three = before * u * t + first + second      # with p.lo
            four = three + abs(float(low[i]))
            error = error * t + u * (first + 2 * second + (first + second) + three + four + (u * size + four))
            lo = u * size + four
        worst = max(worst, error / float(F_of(a)))  # F grows with t
    return worst * 1.001


def ratio(precision, goal):
    """f(q) of vmi_ateb_gamma_ratio: the polynomial, what the error of t makes of it, three sums, two products, a quotient"""
    k = Kernel("vmi_ateb_gamma_ratio", precision, "ateb.h")
    k.expect(twice_q="vmi_two(2 * q.hi, 2 * q.lo)", q_plus_1="vmi_two_plus(one, q)", q_plus_2="vmi_two_plus(one, q_plus_1)",
             q_plus_3="vmi_two_plus(one, q_plus_2)",
             divisor="vmi_two_times(vmi_two_times(q_plus_1, q_plus_2), q_plus_3)",
             returned="vmi_two_over(vmi_ateb_polynomial(vmi_two_plus(minus_one, twice_q)), divisor)")
    by_t = rational((digamma(4) - digamma(HALF)) / 2)  # F'/F is largest for q = 0
    sums = (3 + by_t) * goal("two_plus_sharp") + 2 * goal("two_times_sharp") + goal("two_over_sharp")
    return (goal("Pi_series") + F(rounding(precision)) + sums) * (1 + F(2)**-20)


def fine(precision, goal):
    """Pi_alpha/2 of vmi_ateb_fine_quarter by f(q): what the error of q makes of it, and the product with alpha + 1"""
    k = Kernel("vmi_ateb_fine_quarter", precision, "ateb.h")
    k.expect(returned="vmi_half(vmi_two_times(c->n, vmi_ateb_gamma_ratio(vmi_two_over(one, c->n))))")
    by_q = rational(digamma(2) - digamma(3 * HALF))  # q f'/f is largest for q = 1
    return (goal("Pi_ratio") + by_q * goal("two_over_sharp") + goal("two_times_sharp")) * (1 + F(2)**-20)


# ---- g by its table ----

def g_of(q):
    return (sqrt(pi) * gamma(1 + q) / gamma(q + HALF) - 1) / q if q else 2 * log(2)


def rows(precision):
    k = Kernel("vmi_ateb_g_constant", precision, "ateb.h")
    return k.table()


def row_error(row, constants):
    """The error of the polynomial of a row for |h| <= 1/64. On the ellipse |h| < 1/2, so that |g| < g(-1/2) = 2."""
    low, slope_low, value, slope, *series_of_row = [real(x) for x in constants]
    c = [value + low, slope + slope_low] + series_of_row
    return distance(lambda x: g_of(mpf(row) / 32 + x / 64), lambda x: polyval(c[::-1], x / 64), 2, 60)


def g(precision, bound, _full):
    """Gappa's proof for each row. h = q.hi - row/32 is exact (Sterbenz), and so is Dekker's sum. M is the polynomial without
    rounding, at H = h + q.lo."""
    k = Kernel("vmi_ateb_g", precision, "ateb.h")
    constant = "vmi_ateb_g_constant"
    k.expect(h="q.hi - (shifted - to_row)", h_head="vmi_head(h)", hh="(h + q.lo) * (h + q.lo)",
             g=f"vmi_fast_two_sum({constant}(row, VMI_ATEB_G_VALUE), slope * h_head)",
             series=f"({constant}(row, S) + h * {constant}(row, S + 1)) + hh * ({constant}(row, S + 2) + h * {constant}(row, S + 3))")
    k.expect_body(f"g.lo += (slope * ((h - h_head) + q.lo) + {constant}(row, VMI_ATEB_G_SLOPE_LOW) * h + "
                  f"{constant}(row, VMI_ATEB_G_LOW)) + hh * series;")
    if not precision.single:
        k.expect_body(f"series += (hh * hh) * (({constant}(row, S + 4) + h * {constant}(row, S + 5)) + "
                      f"hh * ({constant}(row, S + 6) + h * {constant}(row, S + 7)));")
    head = precision.digits // 2  # digits that vmi_head keeps
    for row, constants in enumerate(rows(precision)):
        low, slope_low, value, slope = [dyadic(x) for x in constants[:4]]
        pairs = [f"{dyadic(x)} + @ * {dyadic(y)}" for x, y in zip(constants[4::2], constants[5::2])]
        text = f"@rnd = {precision.rounding};\nh = rnd(a_);\nq_lo = rnd(b_);\nh_head = float<{head},-2000,zr>(h);\n"
        text += f"product = {slope} * h_head;\ng_hi rnd= {value} + product;\ng_lo = {value} + product - g_hi;\n"
        text += "x rnd= h + q_lo;\nhh rnd= x * x;\nH = h + q_lo;\nHH = H * H;\n"
        for i, pair in enumerate(pairs):
            text += f"p{i} rnd= {pair.replace('@', 'h')};\nM{i} = {pair.replace('@', 'H')};\n"
        for name, operator, p, square in (("series", "rnd=", "p", "hh"), ("Mseries", "=", "M", "HH")):
            text += f"{name} {operator} ({p}0 + {square} * {p}1)"
            text += "" if precision.single else f" + ({square} * {square}) * ({p}2 + {square} * {p}3)"
            text += ";\n"
        text += f"small rnd= {slope} * ((h - h_head) + q_lo) + {slope_low} * h + {low};\n"
        text += f"Msmall = {slope} * ((h - h_head) + q_lo) + {slope_low} * H + {low};\n"
        text += "added rnd= small + hh * series;\nlow rnd= g_lo + added;\nresult = g_hi + low;\n"
        text += f"M = {value} + product + Msmall + HH * Mseries;\nerror = result - G;\n"
        most_h = "[0, 1b-6]" if row == 0 else "[-1b-6, 1b-6]" if row < 32 else "[-1b-6, 0]"
        most_low = outward(F(2 * row + 1, 32) * F(2)**-precision.digits, True, 10)  # q.lo is below an ulp of q.hi
        text += f"{{ h in {most_h} /\\ |q_lo| <= {dyadic(most_low)} /\\ |G - M| <= {above(row_error(row, constants))}"
        text += f" -> |error| <= {bound} }}\n"
        text += "error -> (result - M) - (G - M);\nh - H -> -q_lo;\n"
        text += "result - M -> (low - (g_lo + added)) + (added - (small + hh * series)) + (small - Msmall)"
        text += " + (hh * series - HH * Mseries);\n"
        yield Case(f"row {row}", text, 120, row in (0, 1))


def in_ulps(precision, goal):
    """ateb_pi in ulps of the result, which are at least 2^(2 - p): half an ulp of the last sum, the error of g, that of q,
    which is below three units of rounding and counts by the factor |q g'| < 1/4, and two sums of low words below 2^-11"""
    Kernel("ateb_pi", precision, "ateb.h").expect(returned="2 * vmi_fast_two_sum(c.quarter.hi, c.quarter.lo).hi")
    k = Kernel("vmi_ateb_period_constants", precision, "ateb.h")
    k.expect_body("c->quarter = vmi_fast_two_sum(c->n.hi, c->g.hi);", "c->quarter.lo += c->n.lo + c->g.lo;")
    u = F(2)**-precision.digits
    return F(1, 2) + (goal("Pi_g") + F(3, 4) * u + 2 * u * F(2)**-11) / (4 * u) + 4 * u
