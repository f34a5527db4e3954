"""Runs of Gappa and Sollya, and the numbers that both read."""
import math
import re
import subprocess
from fractions import Fraction as F

from source import dyadic


class Case:
    """A problem for Gappa. It is proved if Gappa proves its goals. `tight`: the quick run takes this case. `digits`:
    with which Gappa computes. `size`: of the argument."""

    def __init__(self, where, problem, digits=120, tight=False, size=0):
        self.where, self.problem, self.digits, self.tight, self.size = where, problem, digits, tight, size

    def prove(self, seconds=600):
        """Returns the empty text, or what Gappa said."""
        try:
            run = subprocess.run(["gappa", f"-Eprecision={self.digits}"], input=self.problem, capture_output=True,
                                 text=True, timeout=seconds)
        except subprocess.TimeoutExpired:
            return f"not done in {seconds} s"
        said = run.stdout + run.stderr
        if run.returncode == 0 and "contradiction" not in said:  # from contradictory hypotheses everything follows
            return ""
        return said[-1500:] or f"exit status {run.returncode}"


def outward(q, up, bits=60):
    """q rounded to a short dyadic number, upward or downward"""
    q = F(q)
    if not q:
        return q
    scale = F(2)**(bits - math.frexp(float(q))[1])
    return F((math.ceil if up else math.floor)(q * scale)) / scale


def above(q):
    """Gappa's notation of a number at or slightly above q >= 0"""
    return dyadic(outward(q, True, 30))


def between(low, high):
    """Gappa's notation of an interval"""
    return f"[{dyadic(low)}, {dyadic(high)}]"


def suprema(text):
    """Runs Sollya on this text, which prints upper bounds as powers of two, and returns them."""
    run = subprocess.run(["sollya", "--warnonstderr"], input="display = powers!;\n" + text, capture_output=True,
                         text=True)
    found = [re.match(r"^(\d+)(?: \* 2\^\((-?\d+)\))?$", line.strip()) for line in run.stdout.split("\n")]
    bounds = [int(m.group(1)) * F(2)**int(m.group(2) or 0) for m in found if m]
    wanted = text.count("round(")
    if len(bounds) != wanted:
        raise SystemExit(f"Sollya gave {len(bounds)} bounds of {wanted}:\n{run.stdout}{run.stderr}")
    return bounds


def supremum(polynomial, function, low, high, kind):
    """Sollya's text that prints an upper bound of the error of a polynomial in x on [low, high]"""
    return (f"round(sup(supnorm({polynomial}, {function}, [{low}; {high}], {kind}, 2^(-10))), 30, RU);\n")
