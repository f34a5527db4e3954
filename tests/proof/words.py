"""Products, sums and quotients in two words (src/base/words.h): relative errors, where nothing over- or underflows.

Scaling by a power of two and changing signs change nothing, so the factors lie in [1, 2], the larger term of a sum too.
Dekker's product and Knuth's sum are exact; vmi_two_product is proved here as well, but for factors in the slices of
2^-24 (float 2^-9) next to 1 and 2, where Gappa does not find the proof and Dekker's paper stands for it.
"""
from fractions import Fraction as F

from provers import Case, between
from source import Kernel


def operands(precision, x="[1, 2]", y="[1, 2]"):
    """x and y in two words: definitions and hypotheses"""
    half = f"1b-{precision.digits}"  # half an ulp of what lies in [1, 2)
    begin = f"@rnd = {precision.rounding};\nx_hi = rnd(a_);\nx_lo = rnd(b_);\ny_hi = rnd(c_);\ny_lo = rnd(d_);\n"
    begin += "X = x_hi + x_lo;\nY = y_hi + y_lo;\n"
    return begin, f"x_hi in {x} /\\ |x_lo| <= {half} /\\ y_hi in {y} /\\ |y_lo| <= {half}"


def times(precision, bound, _full):
    k = Kernel("vmi_two_times", precision)
    k.expect(p="vmi_two_product(x.hi, y.hi)", returned="vmi_two_sum(p.hi, p.lo + (x.hi * y.lo + x.lo * y.hi))")
    begin, hypotheses = operands(precision)
    g = begin + "p_hi rnd= x_hi * y_hi;\np_lo = x_hi * y_hi - p_hi;\n"
    g += "tail rnd= p_lo + (x_hi * y_lo + x_lo * y_hi);\nresult = p_hi + tail;\nrelative = (result - X * Y) / (X * Y);\n"
    g += f"{{ {hypotheses} -> |relative| <= {bound} }}\n"
    g += "result - X * Y -> (tail - (p_lo + (x_hi * y_lo + x_lo * y_hi))) - x_lo * y_lo;\n"
    yield Case("factors from 1 to 2", g, 300, True)


def plus(precision, bound, _full):
    """The error divided by the larger term, which is x"""
    k = Kernel("vmi_two_plus", precision)
    k.expect(s="vmi_two_sum(x.hi, y.hi)", returned="vmi_two_sum(s.hi, s.lo + (x.lo + y.lo))")
    begin, hypotheses = operands(precision, y="[-2, 2]")
    g = begin + "s_hi rnd= x_hi + y_hi;\ns_lo = x_hi + y_hi - s_hi;\n"
    g += "tail rnd= s_lo + (x_lo + y_lo);\nresult = s_hi + tail;\nrelative = (result - (X + Y)) / X;\n"
    g += f"{{ {hypotheses} -> |relative| <= {bound} }}\n"
    g += "result - (X + Y) -> tail - (s_lo + (x_lo + y_lo));\n"
    yield Case("the larger term from 1 to 2", g, 300, True)


def over(precision, bound, _full):
    """x.hi - p.hi is exact, which Gappa finds for eighths of the intervals"""
    k = Kernel("vmi_two_over", precision)
    k.expect(p="vmi_two_product(z, y.hi)",
             returned="vmi_two_sum(z, (((x.hi - p.hi) - p.lo) + (x.lo - z * y.lo)) / y.hi)")
    assert k.define["z"].replace("vmi_rounded", "").strip("()") == "x.hi / y.hi"
    eighths = [(F(8 + i, 8), F(9 + i, 8)) for i in range(8)]
    for x in eighths:
        for y in eighths:
            begin, hypotheses = operands(precision, between(*x), between(*y))
            g = begin + "z rnd= x_hi / y_hi;\np_hi rnd= z * y_hi;\np_lo = z * y_hi - p_hi;\n"
            g += "d1 rnd= x_hi - p_hi;\nd2 rnd= d1 - p_lo;\nm rnd= x_lo - z * y_lo;\nd3 rnd= d2 + m;\nc rnd= d3 / y_hi;\n"
            g += "result = z + c;\nrelative = (result - X / Y) / (X / Y);\nrest = x_hi - z * y_hi;\n"
            g += "first = d1 - (x_hi - p_hi);\n"
            g += "E = (d3 - (d2 + m)) + (d2 - (d1 - p_lo)) + first + (m - (x_lo - z * y_lo));\n"
            g += f"{{ {hypotheses} -> |relative| <= {bound} }}\n"
            g += "relative -> ((c - d3 / y_hi) * Y + E * (Y / y_hi) + (rest + x_lo - z * y_lo) * (y_lo / y_hi)) / X;\n"
            g += "rest -> y_hi * (x_hi / y_hi - z);\nx_hi - p_hi -> rest + (z * y_hi - p_hi);\n"
            g += "d1 - p_lo -> first + rest;\n"
            yield Case(f"x from {float(x[0])}, y from {float(y[0])}", g, 300, x[0] == 1 and y[0] == 1)


def product(precision, bound, _full):
    """Veltkamp's splitting and Dekker's product without a fused multiply-add; the bound is 0."""
    k = Kernel("vmi_two_product", precision)
    g = f"@rnd = {precision.rounding};\na = rnd(a_);\nb = rnd(b_);\n"
    for n, e in k.define.items():
        e = e.replace("vmi_rounded", "")
        while n != "p_lo" and e.startswith("(") and e.endswith(")"):
            e = e[1:-1]
        if n == "p_lo":
            k.expect(p_lo="(((ah * bh - p.hi) + ah * bl + al * bh) + al * bl)")
            g += "q1 rnd= ah * bh - p_hi;\nq2 rnd= q1 + ah * bl;\nq3 rnd= q2 + al * bh;\np_lo rnd= q3 + al * bl;\n"
        else:
            g += f"{n} rnd= {k.clean(e).replace(' + 0', '')};\n"
    g += "exact = p_lo - (a * b - p_hi);\nsplit_a = a - ah - al;\nsplit_b = b - bh - bl;\n"
    g += "M1 = ah * bh - p_hi;\nM2 = M1 + ah * bl;\nM3 = M2 + al * bh;\nM4 = M3 + al * bl;\n"
    g += "e1 = q1 - M1;\ne2 = q2 - M2;\ne3 = q3 - M3;\ne4 = p_lo - M4;\n"
    split = 12 if precision.single else 27
    inside = between(1 + F(2)**(3 - split), 2 - F(2)**(2 - split))
    g += f"{{ a in {inside} /\\ b in {inside} -> |exact| <= {bound} /\\ |split_a| <= {bound} /\\ |split_b| <= {bound} }}\n"
    for c in "ab":
        g += f"{c} - {c}h -> -({c}h - (t{c} - {c}_rest)) + ({c}_rest - (t{c} - {c}));\n"
    g += """ah * bh - p_hi -> (a * b - p_hi) - (ah * (b - bh) + (a - ah) * b);
q1 + ah * bl -> e1 + (a * b - p_hi) - (a - ah) * b - ah * split_b;
q2 + al * bh -> e2 + (a * b - p_hi) - al * bl - split_a * b - (ah + al) * split_b;
q3 + al * bl -> e3 + (a * b - p_hi) - split_a * b - (ah + al) * split_b;
exact -> e4 - split_a * b - (ah + al) * split_b;
e2 -> (q2 - (q1 + ah * bl)) + e1;
e3 -> (q3 - (q2 + al * bh)) + e2;
e4 -> (p_lo - (q3 + al * bl)) + e3;
"""
    yield Case(f"factors in {inside}", g, 300, True)
