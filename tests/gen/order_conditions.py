"""Check the coefficients in integrators.h: every order condition of both pairs, of their error estimates and of their
continuous extensions, as sums over rooted trees (Butcher's theory; Hairer, Norsett, Wanner I, II.2).

For each tree t of order r: sum_i b_i Phi_i(t) = x^r/gamma(t). Prints the largest residual by order and fails where an
order that is claimed is not reached to rounding, or where the next one is (then the check would check nothing).

usage: python3 tests/gen/order_conditions.py    from the top of the project; needs mpmath"""
import re
import sys
from functools import lru_cache

from mpmath import binomial, mp, mpf

mp.dps = 40
SOURCE = open("integrators.h").read()
NUMBER = r"-?[\d.]+(?:e-?\d+)?"


def body(name):
    start = SOURCE.index(name + "(")
    while SOURCE[SOURCE.index(")", start):][:40].lstrip(")").lstrip()[:1] != "{":
        start = SOURCE.index(name + "(", start + 1)
    return SOURCE[start:SOURCE.index("\n}", start)]


def terms(text):
    """{j: coefficient of k_j} of a C sum"""
    found = {}
    k = r"k(\d+)(?:\[i\])?"
    pattern = r"([+-]?)\s*(?:h \*\s*)?\(?\s*VM(?:I_H|_C)\((" + NUMBER + r")\) \* \(?" + k + r"(?: - " + k + r"\))?"
    for sign, number, j, minus in re.findall(pattern, text):
        value = mpf(number) * (-1 if sign == "-" else 1)
        found[int(j)] = found.get(int(j), mpf(0)) + value
        if minus:
            found[int(minus)] = found.get(int(minus), mpf(0)) - value
    return found


def table(name, text):
    """rows of numbers of a VM_TABLE"""
    rows = text[text.index(name):]
    rows = rows[rows.index("=") + 1:rows.index(";")]
    rows = re.findall(r"\{([^{}]*)\}", rows)
    return [[mpf(x) for x in re.findall(r"VM_C\((" + NUMBER + r")\)|\b(0)\b", row) for x in x if x] for row in rows]


def stages(*names):
    """rows of A, the last being b"""
    return [terms(s) for name in names for s in re.findall(r"z\[i\] =(.*?);", body(name), re.S)]


@lru_cache(None)
def trees(order):
    """rooted trees as sorted tuples of subtrees"""
    if order == 1:
        return ((),)

    def forests(total, largest):
        if total == 0:
            yield ()
            return
        for size in range(min(total, largest[0]), 0, -1):
            pool = trees(size)
            last = largest[1] if size == largest[0] else len(pool) - 1
            for index in range(last, -1, -1):
                for rest in forests(total - size, (size, index)):
                    yield (pool[index],) + rest

    return tuple(forests(order - 1, (order - 1, len(trees(order - 1)) - 1)))


def size(tree):
    return 1 + sum(size(t) for t in tree)


def gamma(tree):
    product = mpf(size(tree))
    for t in tree:
        product *= gamma(t)
    return product


class Method:
    def __init__(self, rows):
        self.rows = rows  # rows[i] = {j: a_ij}, both from 1; row 0 is stage 1
        self.phi = lru_cache(None)(self._phi)

    def _phi(self, tree):
        result = []
        for row in self.rows:
            value = mpf(1)
            for t in tree:
                inner = self.phi(t)
                value *= sum(a * inner[j - 1] for j, a in row.items())
            result.append(value)
        return result

    def residual(self, weights, order, x=mpf(1), error=False):
        """the largest violation over the trees of this order"""
        worst = mpf(0)
        for tree in trees(order):
            phi = self.phi(tree)
            wanted = 0 if error else x**order / gamma(tree)
            worst = max(worst, abs(sum(w * phi[j - 1] for j, w in weights.items()) - wanted))
        return worst


failures = 0


def check(what, residuals, order, tolerance):
    global failures
    good = all(r < tolerance for r in residuals[:order]) and (len(residuals) == order or residuals[order] > 1e-9)
    failures += not good
    print(f"{what:44} order {order}: {float(max(residuals[:order])):.1e}, next: "
          f"{float(residuals[order]) if len(residuals) > order else float('nan'):.1e}{'' if good else '   FAILED'}")


def check_jumps(pair, weights):
    """A jump of f between two stages shows in the sum of the weights behind it: none of these sums may be small"""
    global failures
    time = pair.phi(((),))
    moments = sorted(set(time[j - 1] for j in weights))[1:]
    sums = [sum(w for j, w in weights.items() if time[j - 1] >= moment) for moment in moments]
    good = min(abs(s) for s in sums) > 0.1 and abs(sums[2] - mpf("0.25")) < mpf("1e-15")
    failures += not good
    print("    jumps before c =", ", ".join(f"{float(c):.3g}: {float(s):.3f}" for c, s in zip(moments, sums)),
          "" if good else "  FAILED")


def rk45_weights(x):
    b = [mpf(0)] * 7
    env = {"x": x, "xx": x * x, "b": b, "mpf": mpf}
    for line in re.findall(r"b\[\d\] =.*?;", body("vmi_rk45_weights"), re.S):
        line = re.sub(r"VM_C\((" + NUMBER + r")\)", r'mpf("\1")', line)
        exec(" ".join(line.rstrip(";").split()), env)
    return {j + 1: b[j] for j in range(7)}


def rk87_weights(x):
    c, u = table("c[8][21]", body("vmi_rk87_bernstein")), 1 - x
    c = [row + [mpf(0)] * (21 - len(row)) for row in c]
    return {j + 1: x * sum(binomial(7, i) * x**i * u**(7 - i) * c[i][j] for i in range(8)) for j in range(21)}


def main():
    rows = stages("vmi_rk45_stages")
    pair = Method([{}] + rows)
    check("rk45", [pair.residual(rows[-1], r) for r in range(1, 7)], 5, mpf("2e-14"))  # 16 digits are given
    error = terms(body("vmi_rk45_error"))
    check("rk45, error estimate", [pair.residual(error, r, error=True) for r in range(1, 6)], 4, mpf("2e-15"))
    for x in (mpf("0.3"), mpf("0.77")):
        check(f"rk45, continuous extension at {x}", [pair.residual(rk45_weights(x), r, x) for r in range(1, 6)], 4,
              mpf("2e-14"))

    rows = stages("vmi_rk87_early_stages", "vmi_rk87_late_stages")
    extra = [{j + 1: a for j, a in enumerate(row)} for row in table("a[7][20]", body("vmi_rk87_extra_coefficient"))]
    pair = Method([{}] + rows + extra)
    check("rk87", [pair.residual(rows[-1], r) for r in range(1, 10)], 8, mpf("1e-16"))
    error = terms(body("vmi_rk87_error"))
    check("rk87, error estimate", [pair.residual(error, r, error=True) for r in range(1, 9)], 7, mpf("1e-16"))
    jump = terms(body("vmi_rk87_jump"))
    check("rk87, estimate of jumps", [pair.residual(jump, r, error=True) for r in range(1, 7)], 5, mpf("1e-16"))
    check_jumps(pair, jump)
    for x in (mpf("0.3"), mpf("0.77")):
        check(f"rk87, continuous extension at {x}", [pair.residual(rk87_weights(x), r, x) for r in range(1, 10)], 8,
              mpf("1e-16"))
    return failures


sys.exit(main() != 0)
