"""vmi_sin_cos_words: the first words of the sine and the cosine within so many ulps, for |z.hi| <= 0.79 and |z.lo| <= ulp(z.hi).

Let z = a + b, a = z.hi and b = z.lo. By Taylor's theorem sin(a + b) is sin a + b cos a less at most b^2/2, and
cos(a + b) is cos a - b sin a less at most b^2/2; |cos a - (1 - a^2/2)| <= a^4/24, |sin a - a| <= a^3/6. Sollya bounds the errors of the
two polynomials. So the true value Y differs from the code without rounding (M...) by at most delta, and Gappa bounds
what rounding adds. The sine is odd and the cosine even, in exact and in rounded arithmetic: a >= 0 is enough.
"""
import math
from fractions import Fraction as F

from provers import Case, above, between, suprema, supremum
from source import Kernel

LIMIT = F(math.ceil(F(79, 100) * 2**50), 2**50)


class Model:
    def __init__(self, precision):
        self.p = precision
        self.k = Kernel("vmi_sin_cos_words", precision)
        self.k.expect(w="1 - t / 2", sine="vmi_fast_two_sum(z.hi, z.hi * t * S + z.lo * w)",
                      cosine="vmi_fast_two_sum(w, ((1 - w) - t / 2) + (tt * C - z.hi * z.lo))")
        self.k.define["sine"] = "z.hi + (z.hi * t * S + z.lo * w)"  # the first word of vmi_fast_two_sum is the rounded sum
        self.names = [n for n in self.k.define if n not in ("sine", "cosine")]
        text = "prec = 300;\n" + self.k.sollya([n for n in self.names if n != "w"], {"z_hi": "x"})
        text += supremum("x + x * t * S", "sin(x)", -0.7901, 0.7901, "relative")
        text += supremum("1 - t / 2 + tt * C", "cos(x)", -0.7901, 0.7901, "absolute")
        self.sine_error, self.cosine_error = suprema(text)

    def begin(self):
        return f"@rnd = {self.p.rounding};\nz_hi = rnd(a_);\nz_lo = rnd(b_);\n" + self.k.rounded(self.names)

    def low_word(self, high):
        """An ulp of the numbers below `high`"""
        return F(2)**(math.floor(math.log2(high)) + 1 - self.p.digits)


def sine_case(m, e, low, high, bound, tight):
    """The sine lies in [2^e, 2^(e+1)) and z.hi in [low, high]."""
    digits, z_lo = m.p.digits, m.low_word(high)
    delta = m.sine_error * high + z_lo * high**4 / 24 + z_lo**2 / 2
    ulps = f"1b{digits - 1 - e}"
    g = m.begin() + m.k.rounded(["sine"]) + m.k.exact(m.names)
    g += f"Msine = z_hi + (z_hi * Mt * MS + z_lo * Mw);\nerror = (sine - Y) * {ulps};\n"
    g += f"{{ z_hi in {between(low, high)} /\\ |z_lo| <= {above(z_lo)} /\\ |Y - Msine| <= {above(delta)}\n"
    g += f"/\\ sine in [1b{e}, {2**digits - 1}b{e + 1 - digits}] -> |error| <= {bound} }}\n"
    g += f"error -> ((sine - Msine) - (Y - Msine)) * {ulps};\n"
    return Case(f"sine from 2^{e}, z.hi from {float(low):.4g} to {float(high):.4g}", g, 60, tight, high)


def sine(precision, bound, full):
    """Binades of the sine, the highest in parts. z.hi is at least asin(2^e) (1 - 2^-20), since a sine in this binade has
    a relative error far below 2^-20. In the binades below 2^-538 (float 2^-76) z.hi^2 is less than half the smallest
    subnormal number, so that t = 0 and w = 1. There the sine is z.hi + z.lo, rounded once; see docs/proof.md."""
    m = Model(precision)
    least = (-76 if precision.single else -538) if full else -40
    for e in range(-1, least - 1, -1):
        base = F(math.asin(2.0**e)) * (1 - F(2)**-20)
        top = LIMIT if e == -1 else F(math.asin(2.0**(e + 1))) * (1 + F(2)**-20)
        parts = 16 if e == -1 else 4 if e > -8 else 1
        for i in range(parts):
            low, high = [base + (top - base) * j / parts for j in (i, i + 1)]
            low = F(math.floor(low * F(2)**(60 - e))) / F(2)**(60 - e)
            high = F(math.ceil(high * F(2)**(60 - e))) / F(2)**(60 - e)
            yield sine_case(m, e, low, high, bound, i == parts - 1 and e > -8)


def cosine_case(m, low, high, bound):
    """z.hi in [low, high]; the cosine lies in [1/2, 1], where the unit is its ulp below 1, 2^-digits."""
    digits, z_lo = m.p.digits, m.low_word(high)
    delta = m.cosine_error + z_lo * high**3 / 6 + z_lo**2 / 2
    g = m.begin() + m.k.exact(m.names)
    g += "rest rnd= 1 - w;\nlost rnd= rest - t * 0.5;\nq rnd= tt * C - z_hi * z_lo;\n"
    g += "inner rnd= lost + q;\ncosine rnd= w + inner;\n"
    g += f"Mq = Mtt * MC - z_hi * z_lo;\nMcosine = 1 - Mt * 0.5 + Mq;\nerror = (cosine - Y) * 1b{digits};\n"
    g += f"{{ z_hi in {between(low, high)} /\\ |z_lo| <= {above(z_lo)} /\\ |Y - Mcosine| <= {above(delta)}\n"
    g += f"/\\ cosine in [0.5, 1] -> |error| <= {bound} }}\n"
    g += f"error -> ((cosine - Mcosine) - (Y - Mcosine)) * 1b{digits};\n"
    g += "rest - t * 0.5 -> (rest - (1 - w)) - (w - (1 - t * 0.5));\n"
    g += "cosine - Mcosine -> (cosine - (w + inner)) + (inner - (lost + q)) + (lost - (rest - t * 0.5))"
    g += " + (rest - (1 - w)) + (q - Mq) - (t - Mt) * 0.5;\n"
    return Case(f"cosine, z.hi from {float(low):.4g} to {float(high):.4g}", g, 60, low > F(2, 3) or low == 0, high)


def cosine(precision, bound, _full):
    """Steps of 1/32 of z.hi"""
    m = Model(precision)
    edges = [F(j, 32) for j in range(26)] + [LIMIT]
    for low, high in zip(edges, edges[1:]):
        yield cosine_case(m, low, high, bound)
