"""vmi_exp_core and vmi_exp: the reduction, 1 + p + p_lo, p alone, and the result in ulps.

Let x + x_lo = n ln 2 + a + b, where a = r.hi and b = r.lo. On paper: the fast sums are exact (Dekker), head has half of the
digits (Veltkamp), e^(a + b) is e^a + b e^a but for at most b^2, and e^a is 1 + a + a^2/2 but for |a|^3/4, as |a| < 0.4.
Sollya bounds the error of the polynomial E, so that the true value Y = e^(a + b) - 1 differs from the code
without rounding by at most delta; Gappa bounds the rounding. The reduction is odd in x: x > 0 is enough.
"""
import math
from fractions import Fraction as F
from functools import lru_cache

from provers import Case, above, between, outward, suprema, supremum
from source import Kernel, Precision, dyadic

LN2 = F("0.69314718055994530941723212145817656807550013436025525412068000949339362196969471560586332699641868")
WIDEST = F("0.3468")  # |r.hi| at most: the bound exp_reduced


class Model:
    def __init__(self, precision):
        self.p = precision
        self.k = k = Kernel("vmi_exp_core", precision)
        k.expect(head="split - excess", tail="r.hi - head", p="vmi_fast_two_sum(r.hi, head * head / 2)",
                 sum="vmi_fast_two_sum(p.hi, low + r.hi * rr * E)", returned="sum.hi",
                 low="p.lo + tail * (r.hi + head) / 2 + (r.lo + r.lo * p.hi)",
                 r="vmi_fast_two_sum(x - (vm_real)n * ln2_hi, x_lo - (vm_real)n * ln2_lo)")
        assert k.define["n"].replace(" ", "").startswith("(int)(t+copysign"), k.define["n"]
        self.poly = [n for n in k.define if n.startswith("E")]
        # tail is below 2^(head - digits) |r.hi|, and head has so many digits
        self.head = precision.digits - (12 if precision.single else 27)
        text = "prec = 300;\n" + k.sollya(["rr"] + self.poly, {"r_hi": "x"})
        text += supremum("1 + x + x^2 / 2 + x * rr * E", "exp(x)", -0.3475, 0.3475, "absolute")
        text += supremum("x + x^2 / 2 + x * rr * E", "expm1(x)", -0.3475, 0.3475, "relative")
        text += supremum("1 + x + x^2 / 2 + x * rr * E", "exp(x)", -0.2878, -0.24, "absolute")
        self.absolute, self.relative, self.local = suprema(text)

    def lost(self):
        """What the words of r lack: the rounding of x_lo - n ln2_lo and what ln 2 has beyond its words (the bound exp_lost)"""
        return F(2)**(-34 if self.p.single else -84)


@lru_cache(None)
def model(name):
    return Model(Precision(name))


def reduction(m, e, goal):
    """x in [2^e, 2^(e+1)]"""
    k = m.k
    g = f"@rnd = {m.p.rounding};\nx = rnd(a_);\nx_lo = rnd(b_);\n"
    g += "".join(f"{n} = {dyadic(k.value(k.define[n]))};\n" for n in ("one_over_ln2", "ln2_hi", "ln2_lo"))
    g += k.rounded(["t"]) + "half rnd= t + 0.5;\nn = int<dn>(half);\n" + k.rounded(["r"])
    g += f"ln2 = {dyadic(outward(LN2, False, 300))};\nMa = x - n * ln2_hi;\nMb = x_lo - n * (ln2 - ln2_hi);\n"
    g += "exact = r_a - Ma;\nlost = r_b - Mb;\n"
    most = F(200 if m.p.single else 1500)
    g += f"{{ x in {between(F(2)**e, min(F(2)**(e + 1), most))} /\\ |x_lo| <= 1b{e + 1 - m.p.digits} -> {goal} }}\n"
    g += "Ma -> (x * one_over_ln2 - n) * ln2_hi + x * (1 - one_over_ln2 * ln2_hi);\n"
    g += "x * one_over_ln2 - n -> (half - n - 0.5) - (half - (t + 0.5)) - (t - x * one_over_ln2);\n"
    return Case(f"x from 2^{e}", g, 200, True)


def reduced(precision, bound, _full):
    """|r.hi| and, as a goal beside it, that x - n ln2_hi has no rounding error"""
    m = model(precision.name)
    for e in range(-2, 8 if precision.single else 11):
        yield reduction(m, e, f"|r_hi| <= {bound} /\\ exact in [0, 0]")


def lost(precision, bound, _full):
    """What the low word of r loses"""
    m = model(precision.name)
    for e in range(-2, 8 if precision.single else 11):
        yield reduction(m, e, f"|lost| <= {bound}")


def core(m, low, high, goal, extra="", one_word=False, absolute=None):
    """1 + p + p_lo for r.hi in [low, high]. one_word: k = 0, where r is x + x_lo and nothing was lost"""
    top = max(abs(low), abs(high))
    r_lo = F(2)**(math.frexp(float(top))[1] - 1 - m.p.digits)  # half an ulp
    if one_word:
        r_lo *= 2
    absolute = absolute or m.absolute
    delta = min(absolute, m.relative * top * F(6, 5)) + r_lo * top**3 / 4 + r_lo**2
    if not one_word:
        delta += m.lost() * F(3, 2)
    g = f"@rnd = {m.p.rounding};\nr_hi = rnd(a_);\nr_lo = rnd(b_);\ntail = r_hi - head;\n"
    g += m.k.rounded(["p", "rr"] + m.poly + ["low", "sum"]) + m.k.exact(["rr"] + m.poly)
    g += "u rnd= r_hi * rr * E;\nMu = r_hi * Mrr * ME;\n"
    g += "Mlow = p_lo + tail * (r_hi + head) * 0.5 + (r_lo + r_lo * (r_hi + r_hi * r_hi * 0.5));\n"
    g += "Mp = r_hi + r_hi * r_hi * 0.5 + Mu + r_lo * (1 + r_hi + r_hi * r_hi * 0.5);\n"
    g += "s = p_hi + sum_b;\nerror = s - Y;\nrelative = error / (1 + Y);\np_error = sum_hi - Y;\n"
    g += f"{{ r_hi in {between(low, high)} /\\ |r_lo| <= {dyadic(r_lo)} /\\ @FLT(head, {m.head})\n"
    g += f"/\\ head -/ r_hi in [-1b-{m.head}, 1b-{m.head}] /\\ |Y - Mp| <= {above(delta)} {extra} -> {goal} }}\n"
    g += "error -> (s - Mp) - (Y - Mp);\np_error -> (sum_hi - s) + (s - Mp) - (Y - Mp);\nY -> Mp + (Y - Mp);\n"
    g += "s - Mp -> (sum_b - (low + u)) + (low - Mlow) + (u - Mu) + (p_b - head * head * 0.5);\n"
    g += "p_hi - (r_hi + r_hi * r_hi * 0.5) -> (p_hi - (r_hi + p_b)) + (p_b - head * head * 0.5)"
    g += " - tail * (r_hi + head) * 0.5;\n"
    return g


def steps(parts):
    """Intervals of r.hi on both sides of 0; below 2^-100 every term but r itself is beyond the low word"""
    for i in range(parts):
        low = outward(WIDEST * i / parts, False) if i else F(2)**-100
        high = outward(WIDEST * (i + 1) / parts, True)
        yield low, high, i == parts - 1
        yield -high, -low, i == parts - 1


def in_words(precision, bound, _full):
    """The relative error of 1 + p + p_lo"""
    m = model(precision.name)
    for low, high, tight in steps(24):
        yield Case(f"r from {float(low):.4g}", core(m, low, high, f"|relative| <= {bound}"), 120, tight)


def in_ulps(precision, bound, _full):
    """The error of vmi_exp in ulps, where the result is normal. y = 1 + p is exact in two words. 1 + p + p_lo lies in
    [0.7, 1) for p < 0, where an ulp is 2^-digits, and in [1, 1.42) else. The last sum adds half an ulp, and the sum y.lo +
    p_lo a rounding error of 2^-digits ulps, for which the goal leaves 2^-20 (float 2^-16)."""
    m = model(precision.name)
    small = F(2)**(-16 if precision.single else -20)
    allowed = F(int(bound.split("b")[0])) * F(2)**int(bound.split("b")[1]) - F(1, 2) - small
    for low, high, tight in steps(24):
        ulp = F(2)**(-precision.digits + (1 if low > 0 else 0))
        yield Case(f"r from {float(low):.4g}", core(m, low, high, f"|error| <= {dyadic(allowed * ulp)}"), 120, tight)


def p_alone(precision, bound, full):
    """The error of p in ulps for |x| <= 0.34, by binades of p"""
    m, digits = model(precision.name), precision.digits
    for e in range(-2, -1000 if full and not precision.single else -100 if full else -40, -1):
        for sign in (1, -1):
            ends = [abs(math.log1p(sign * 2.0**j)) for j in (e, e + 1)]
            low, high = F(min(ends)) * (1 - F(2)**-18), min(F(max(ends)) * (1 + F(2)**-18), F(34, 100))
            parts = 32 if e == -2 else 8 if e > -6 else 1
            for i in range(parts):
                a, b = outward(low + (high - low) * i / parts, False), outward(low + (high - low) * (i + 1) / parts, True)
                inside = between(F(2)**e, F(2**digits - 1) * F(2)**(e + 1 - digits))
                if sign < 0:
                    a, b = -b, -a
                    inside = between(-F(2**digits - 1) * F(2)**(e + 1 - digits), -F(2)**e)
                local = m.local if F(-28779, 100000) <= a and b <= F(-24, 100) else None
                g = core(m, a, b, f"|p_error * 1b{digits - 1 - e}| <= {bound}", f"/\\ sum_hi in {inside}", True, local)
                yield Case(f"p from {sign} 2^{e}, part {i}", g, 120, e == -2 and i in (0, parts - 1))
