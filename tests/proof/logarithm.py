"""vmi_log: the relative error of both words, for each row of the table, and next to 1 for each binade of z - 1.

On paper: the fast sums are exact (Dekker), since |a| >= |b| or a = 0, which is a goal here; z_head is z rounded to fewer
digits, ties away from 0; the row of z is that of 44 z - 30.5 rounded down, which rounding moves by less than 1e-6 in z.
r_head, r_tail, the square of r_head, and k ln2_hi + ln c are exact, which are goals too. Sollya bounds the polynomial
and what the words of ln c and ln 2 leave, so that ln x differs from the code without rounding (Mp) by at most delta.
"""
import re
from fractions import Fraction as F
from functools import lru_cache

from exponential import LN2
from provers import Case, above, between, outward, suprema, supremum
from source import Kernel, Precision, dyadic

WIDEST = outward(F(163, 10000), True)          # |r| at most
NEAR = F(1, 88) + F(1, 10**6)                  # |z - 1| at most in the row of c = 1
TOLERANCE = F(1, 10**6)                        # of the ends of the rows


class Model:
    def __init__(self, precision):
        self.p = precision
        self.k = k = Kernel("vmi_log", precision)
        k.expect(r_head="z_head * by_c - 1", r_tail="(z - z_head) * by_c", r="vmi_fast_two_sum(r_head, r_tail)",
                 sum="vmi_fast_two_sum(k_real * ln2_hi + vmi_log_constant(row, 1), r.hi)", row="(int)(44 * z - 30.5f)"
                 if precision.single else "(int)(44 * z - 30.5)", by_c="vmi_log_constant(row, 0)",
                 high="vmi_fast_two_sum(sum.hi, -(r_head * r_head) / 2)",
                 returned="vmi_fast_two_sum(high.hi, low + r.hi * rr * L)",
                 z_head="vmi_from_bits((z_bits + half_tail) & ~(2 * half_tail - 1))")
        self.rows = Kernel("vmi_log_constant", precision).table()
        self.one = [row[0] for row in self.rows].index(1)
        half_tail = int(re.match(r"\(?(0x[0-9a-fA-F]+)", k.define["half_tail"]).group(1), 16)
        self.head = precision.digits - half_tail.bit_length()
        self.poly = [n for n in k.define if re.match(r"L\d*$", n)]
        self.ln2_hi, self.ln2_lo = k.value(k.define["ln2_hi"]), k.value(k.define["ln2_lo"])
        text = "prec = 400;\n" + k.sollya(["rr"] + self.poly, {"r_hi": "x"})
        for limit in (float(WIDEST), float(NEAR)):
            text += supremum("x * (1 - x / 2 + rr * L)", "log1p(x)", -limit, limit, "relative")
        for row in self.rows:
            c, high, low = [f"({q.numerator}*2^(-{q.denominator.bit_length() - 1}))" for q in row]
            text += f"round(sup(abs([-log({c}) - {high} - {low}])), 30, RU);\n"
        self.wide, self.narrow, *self.left = suprema(text)


@lru_cache(None)
def model(name):
    return Model(Precision(name))


def definitions(m, row, with_k):
    """The code for one row: its constants as numbers; k = 0, or any k"""
    c, high, low = m.rows[row]
    g = f"@rnd = {m.p.rounding};\nz = rnd(a_);\nz_head = float<{m.head},-2000,na>(z);\n"
    g += f"ln2_hi = {dyadic(m.ln2_hi)};\nln2_lo = {dyadic(m.ln2_lo)};\n"
    code = m.k.rounded(["r_head", "r_tail", "r", "sum", "high", "rr"] + m.poly + ["low"])
    code = code.replace("by_c", dyadic(c))
    for column, q in ((1, high), (2, low)):
        code = code.replace(f"vmi_log_constant(row, {column})", dyadic(q))
    if not with_k:
        code = code.replace("k_real * ln2_hi + ", "").replace("k_real * ln2_lo + ", "")
        if high == 0:
            code = re.sub(r"sum_a \S+ 0b-0;", "sum_a = 0;", code)
    g += code.replace(" + (0b-0)", "").replace(" + 0b-0", "")
    g += f"R = z * {dyadic(c)} - 1;\n" + m.k.exact(["rr"] + m.poly, {"r_hi": "R"})
    return g


def problem(m, row, z, sign, bound, reach=WIDEST, polynomial=None, tight=False):
    """z in an interval, k of this sign (or 0). reach: |r| at most"""
    c, high, low = m.rows[row]
    kk = "k_real" if sign else "0"
    words = f"k_real * ln2_lo + {dyadic(low)}" if sign else dyadic(low)  # as it stands in the code for this k
    most = 160 if m.p.single else 1100  # |k| at most
    delta = (polynomial or m.wide) * reach * F(103, 100) + m.left[row]
    if sign:
        delta += abs(LN2 - m.ln2_hi - m.ln2_lo) * most
    g = definitions(m, row, sign != 0)
    g += "u rnd= r_hi * rr * L;\nMu = R * Mrr * ML;\ntail rnd= low + u;\nM2 = r_lo - r_tail * (R + r_head) * 0.5;\n"
    g += f"Mlow = sum_lo + high_lo + ({words}) + M2;\n".replace(" + (0b-0)", "")
    g += f"Mp = {kk} * (ln2_hi + ln2_lo) + {dyadic(high)} + {dyadic(low)} + R - R * R * 0.5 + Mu;\n"
    g += "fast1 = r_hi / sum_a;\nfast2 = high_b / sum_hi;\nfast3 = tail / high_hi;\n"
    g += "exact_r = (r_head + r_tail - R) * (1 - (R + r_head) * 0.5);\n"
    g += "result = high_hi + tail;\nerror = result - Y;\nrelative = error / Y;\n"
    g += f"exact_head = r_head - (z_head * {dyadic(c)} - 1);\nexact_tail = r_tail - (z - z_head) * {dyadic(c)};\n"
    g += "exact_square = high_b - (r_head * r_head) * -1b-1;\n"
    g += f"exact_a = sum_a - ({kk} * ln2_hi + {dyadic(high)});\n"
    g = g.replace(" + 0b-0", "")
    g += f"{{ z in {between(*z)} /\\ |Y - Mp| <= {above(delta)}\n"
    if sign:
        g += f"/\\ @FIX(k_real, 0) /\\ k_real in {between(1, most) if sign > 0 else between(-most, -1)}\n"
    sums = ["fast2", "fast3"] + ([] if sign == 0 and row == m.one else ["fast1"])
    goals = [f"|{x}| <= 1" for x in sums]
    goals += [f"exact_{x} in [0, 0]" for x in ("head", "tail", "square", "a")] + [f"|relative| <= {bound}"]
    g += "-> " + " /\\ ".join(goals) + " }\n"
    g += "error -> (result - Mp) - (Y - Mp);\nY -> Mp + (Y - Mp);\n"
    g += "result - Mp -> (tail - (low + u)) + (low - Mlow) + (u - Mu) + exact_a + exact_square + exact_r;\n"
    g += "r_head + r_tail - R -> exact_head + exact_tail;\n"
    g += "r_hi - R -> (r_hi - (r_head + r_tail)) + (exact_head + exact_tail);\n"
    where = f"row {row}, k of sign {sign}, z from {float(z[0]):.8g}"
    return Case(where, g, 100, tight)


def away(precision, bound, _full):
    """All rows with k <> 0, and the rows but that of 1 with k = 0"""
    m = model(precision.name)
    for row in range(len(m.rows)):
        low = max((F(row) + F(61, 2)) / 44, F(17, 24)) - TOLERANCE
        ends = outward(low, False), outward((F(row) + F(63, 2)) / 44 + TOLERANCE, True)
        for sign in (1, -1, 0):
            if sign == 0 and row == m.one:
                continue
            parts = 1 if sign else 12 if abs(row - m.one) == 1 else 3 if abs(row - m.one) == 2 else 1
            cuts = [outward(ends[0] + (ends[1] - ends[0]) * j / parts, False) for j in range(parts)] + [ends[1]]
            for j in range(parts):
                tight = row in (0, len(m.rows) - 1) and sign or abs(row - m.one) == 1 and sign == 0 and j in (0, parts - 1)
                yield problem(m, row, cuts[j:j + 2], sign, bound, tight=bool(tight))


def near_one(precision, bound, _full):
    """k = 0 in the row of 1, by binades of |z - 1|"""
    m = model(precision.name)
    for e in range(-7, -precision.digits - 1, -1):
        for sign in (1, -1):
            parts = 6 if e == -7 else 4 if e > -12 else 1
            top = NEAR if e == -7 else F(2)**(e + 1)
            for j in range(parts):
                a, b = [F(2)**e + (top - F(2)**e) * x / parts for x in (j, j + 1)]
                z = (1 + a, 1 + b) if sign > 0 else (1 - b, 1 - a)
                z = outward(z[0], False, 80), outward(z[1], True, 80)
                yield problem(m, m.one, z, 0, bound, b, m.narrow, e == -7 and j in (0, parts - 1))
