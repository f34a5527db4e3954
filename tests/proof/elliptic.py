"""The polynomials under jacobi_K and jacobi_E (src/jacobi/integrals.h): how far they are from the functions that they replace.

The functions have series with known coefficients, whose first terms are a polynomial T and whose other terms are below a
geometric series. Sollya bounds the code's polynomial minus T. These are errors of the polynomials; rounding adds to them.
"""
from fractions import Fraction as F

from provers import suprema, supremum
from source import Kernel

TERMS = 72


def coefficient(n, kind):
    """K: 1 + x S = sum of (1/2 choose n, rising)^2 x^n; E: 1 + x S = sum of (1/2 choose n)^2 x^n (Gauss and Kummer)"""
    value = F(1)
    for i in range(1, n + 1):
        value *= F(2 * i - 1, 2 * i) if kind == "K" else F(2 * i - 3, 2 * i)
    return value * value


def polynomial(kind):
    """The terms 1 to TERMS of the series, as a text for Sollya"""
    return " + ".join(f"({c.numerator}/{c.denominator}) * x^{n}"
                      for n, c in ((n, coefficient(n, kind)) for n in range(1, TERMS + 1)))


def series_error(precision, kind, top):
    """The largest error of x S for 0 <= x <= top"""
    k = Kernel(f"vmi_{kind}_series", precision)
    value = k.clean(k.returned, True)
    if kind == "K":
        value = f"x * ({value})"
    text = "prec = 200;\n" + k.sollya([n for n in k.define], {}) + f"T = {polynomial(kind)};\n"
    text += supremum(value, "T", 0, top, "absolute")
    rest = F(str(top))**(TERMS + 1) / (1 - F(str(top)))  # no coefficient is above 1
    return suprema(text)[0] + rest


def k_series(precision, _goal):
    return series_error(precision, "K", "0.0299")


def e_series(precision, _goal):
    return series_error(precision, "E", "0.503")


def logarithmic_terms(kind):
    """Pairs a_n, d_n of K = sum of a_n c^n (l - d_n) and of E - 1 = sum of a_n c^n (l - d_n), where c = 1 - m and
    l = ln(4/k') (DLMF 19.12.1 and 19.12.2); the first pair belongs to c^0 (K) or c^1 (E)."""
    pairs, d = [], F(0)
    a = F(1) if kind == "K" else F(1, 2)
    for m in range(TERMS):
        pairs.append((a, d if kind == "K" else d + F(1, (2 * m + 1) * (2 * m + 2))))
        d += F(2, (2 * m + 1) * (2 * m + 2))
        a *= F((2 * m + 1)**2, (2 * m + 2)**2) if kind == "K" else F((2 * m + 1) * (2 * m + 3), (2 * m + 2) * (2 * m + 4))
    return pairs


def logarithmic_error(precision, function, kind):
    """The largest error of c^2 (l A - B) relative to K, or of c (l A - B) itself, for 0 < c <= 1/2, binade by binade. Below
    2^-30 the factor c makes the error smaller than any bound of interest."""
    k = Kernel(function, precision)
    names = [n for n in k.define if n[0] in "Ab" and n[1:].isdigit()] + ["A", "B"]
    power = 2 if kind == "K" else 1
    pairs = logarithmic_terms(kind)[2 if kind == "K" else 0:]
    text = "prec = 200;\n" + k.sollya(["cc"] + names, {"c": "x"})
    text += "SA = " + " + ".join(f"({a.numerator}/{a.denominator}) * x^{n}" for n, (a, _) in enumerate(pairs)) + ";\n"
    text += "SB = " + " + ".join(f"({(a * d).numerator}/{(a * d).denominator}) * x^{n}"
                                 for n, (a, d) in enumerate(pairs)) + ";\n"
    for j in range(1, 31):
        text += supremum("B - SB", "(A - SA) * (2 * log(2) - log(x) / 2)", f"2^(-{j + 1})", f"2^(-{j})", "absolute")
    worst = F(0)
    for j, bound in enumerate(suprema(text), 1):
        error = bound * F(2)**(-power * j) + F(2)**(-TERMS)
        worst = max(worst, error / (F(13, 10) + F(j, 3)) if kind == "K" else error)  # K > l > 1.386 + 0.346 j
    return worst


def k_by_log(precision, _goal):
    return logarithmic_error(precision, "vmi_K_by_log", "K")


def e_rest(precision, _goal):
    return logarithmic_error(precision, "vmi_E_rest", "E")
