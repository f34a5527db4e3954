#!/usr/bin/env python3
"""Proves the bounds of tests/proof/bounds.txt with Gappa and Sollya.

usage: prove.py quick|full [NAME...]   from the top of the project; a NAME is the first column of bounds.txt

"quick" takes the cases that decide a bound, "full" all cases. Each bound is a goal that Gappa must prove in each case; the
run prints a line for each bound and precision, and fails where a case is not proved. Times go to the standard error.
JOBS is the number of cases that are tried at a time.
"""
import math
import os
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction as F

sys.dont_write_bytecode = True  # no folder beside the sources

import elliptic
import exponential
import logarithm
import period
import sin_cos
import words
from provers import outward
from source import Precision, dyadic

def power(precision, goal):
    """The bound of the power in ulps that follows from those of the logarithm and the exponential, as docs/proof.md
    shows: the error of y ln x becomes the relative error of the result."""
    p, single = precision.digits, precision.single
    largest = F("88.73") if single else F("709.79")  # of |y ln x|, where the result is a normal number
    low_word = 3 * F(2)**(-p - 16)                   # what x.lo loses, for |ln x| > 2^14 eps
    rounding = F(2)**(4 - 2 * p)                     # of the product y ln x in two words
    log = goal("log_floats") if single else goal("log")
    return goal("exp_ulp") + F(2)**p * largest * (log + low_word + rounding) * (1 + F(2)**-10)


PROVERS = {
    "two_product": words.product,
    "two_times_sharp": words.times, "two_plus_sharp": words.plus, "two_over_sharp": words.over,
    "sine": sin_cos.sine, "cosine": sin_cos.cosine,
    "exp_reduced": exponential.reduced, "exp_lost": exponential.lost, "exp_words": exponential.in_words,
    "exp_ulp": exponential.in_ulps, "exp_p": exponential.p_alone,
    "log": logarithm.away, "log_near": logarithm.near_one,
    "Pi_g": period.g,
}

# Functions of the precision and of the other bounds that return a bound, which must be below the goal; how they find it
COMPUTED = {
    "two_times": (lambda _, goal: goal("two_times_sharp"), "from two_times_sharp"),
    "two_plus": (lambda _, goal: goal("two_plus_sharp"), "from two_plus_sharp"),
    "two_over": (lambda _, goal: goal("two_over_sharp"), "from two_over_sharp"),
    "K_series": (elliptic.k_series, "by Sollya"), "E_series": (elliptic.e_series, "by Sollya"),
    "K_by_log": (elliptic.k_by_log, "by Sollya"), "E_rest": (elliptic.e_rest, "by Sollya"),
    "power": (power, "from exp_ulp and log"), "Pi_series": (period.series, "by interpolation"),
    "Pi_ratio": (period.ratio, "from Pi_series and the bounds of two words"),
    "Pi_fine": (period.fine, "from Pi_ratio and the bounds of two words"), "Pi": (period.in_ulps, "from Pi_g"),
}
MINUTES = ("K_by_log", "E_rest")  # the quick run leaves these out


def number(text, digits):
    """The goal that a bound means: a number, or 2^ and an exponent, which may be a formula with p"""
    if not text.startswith("2^"):
        return F(text)
    exponent = eval(text[2:].replace("2p", "2 * p"), {"p": digits})  # a line of bounds.txt
    if exponent == int(exponent):
        return F(2)**int(exponent)
    return outward(F(2.0**exponent) * (1 - F(2)**-40), False)


def bounds():
    """Lines of bounds.txt: name, bound in double, bound in float; a name that occurs again is left out."""
    lines = {}
    with open(os.path.join(os.path.dirname(__file__), "bounds.txt"), encoding="utf-8") as file:
        for line in file:
            if line.strip() and not line.startswith("#"):
                name, *both = [x.strip() for x in line.split(";")][:3]
                lines[name] = both
    return lines


def by_gappa(name, precision, bound, full, pool):
    """Proves the cases of a bound and returns the numbers of those proved, of those tried and of all."""
    cases = list(PROVERS[name](precision, dyadic(number(bound, precision.digits)), full))
    chosen = [c for c in cases if full or c.tight]
    failures = 0
    for case, said in zip(chosen, pool.map(lambda c: c.prove(), chosen)):
        if said:
            failures += 1
            print(f"FAILED: {name}, {precision.name}, {case.where}, goal {bound}\n{said}", flush=True)
    return len(chosen) - failures, len(chosen), len(cases)


def every_float(lines, full):
    """Tries the floats in a program in C; returns whether it kept both bounds."""
    program = os.path.join("build", "proof", "every_float")
    os.makedirs(os.path.dirname(program), exist_ok=True)
    source = os.path.join(os.path.dirname(__file__), "every_float.c")
    subprocess.run([os.environ.get("CC", "cc"), "-std=c99", "-O2", source, "-o", program, "-lm"], check=True)
    goals = [str(float(number(lines[name][1], 24))) for name in ("log_floats", "exp_floats")]
    run = subprocess.run([program, "full" if full else "quick", *goals], capture_output=True, text=True)
    print(run.stdout, end="", flush=True)
    return run.returncode == 0


# Goals that are false: a prover that proves them proves nothing. Counterexamples: tests/data/kernel_points.h
LIES = (("two_times_sharp", "2^-(2p - 1)"), ("sine", "0.7"), ("cosine", "0.7"), ("Pi_g", "2^-63.3"))


def main():
    full, wanted = sys.argv[1] == "full", sys.argv[2:]
    lines, passed, failed = bounds(), 0, 0
    with ThreadPoolExecutor(int(os.environ.get("JOBS", os.cpu_count()))) as pool:
        for name, both in lines.items():
            for precision, bound in zip((Precision("double"), Precision("float")), both):
                start = time.time()
                if wanted and name not in wanted or bound == "-" or name.endswith("_floats"):
                    continue
                if name in MINUTES and not full:
                    print(f"{name:15} {precision.name:6} {bound:12} left to the full run", flush=True)
                    continue
                if name in COMPUTED:
                    compute, way = COMPUTED[name]
                    error = compute(precision, lambda other: number(lines[other][precision.single], precision.digits))
                    kept = error <= number(bound, precision.digits)
                    how = f"{float(error):.4f}" if error > F(1, 1000) else f"2^{math.log2(error):.2f}"
                    how += f" {way}" if kept else " FAILED"
                elif name not in PROVERS:
                    kept, how = True, "on paper"
                else:
                    proved, tried, of_all = by_gappa(name, precision, bound, full, pool)
                    kept, how = proved == tried > 0, f"{proved} cases proved, {tried} of {of_all} tried"
                print(f"{name:15} {precision.name:6} {bound:12} {how}", flush=True)
                print(f"{name}, {precision.name}: {time.time() - start:.0f} s", file=sys.stderr)
                passed, failed = passed + kept, failed + (not kept)
        for name, bound in LIES:
            if not wanted:
                refused = is_refused(name, bound)
                print(f"{name:15} double {bound:12} {'is refused, as it must be' if refused else 'FAILED: is false'}", flush=True)
                passed, failed = passed + refused, failed + (not refused)
    if not wanted or "log_floats" in wanted:
        kept = every_float(lines, full)
        passed, failed = passed + kept, failed + (not kept)
    print(f"bounds of the kernels ({sys.argv[1]}): {passed} passed, {failed} failed, 0 skipped")
    sys.exit(failed > 0)


def is_refused(name, bound):
    """Does Gappa refuse a false bound in double in the case for the largest arguments?"""
    precision = Precision("double")
    goal = dyadic(number(bound, precision.digits))
    largest = max(PROVERS[name](precision, goal, False), key=lambda case: case.size)
    return largest.prove() != ""


if __name__ == "__main__":
    main()
