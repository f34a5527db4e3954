"""The statements of a kernel, read from a header and written for Gappa and for Sollya.

The provers must judge the code that is shipped. So this module runs the compiler's preprocessor on a header, finds a
function by its name, and cuts its body into definitions `name = expression`. Nothing is copied by hand: a changed
coefficient changes what is proved, and a changed order of operations changes it too. What a model must assume about the
shape of the code it checks by `Kernel.expect`, which stops the proof where the code differs.

Only straight-line code can be read: declarations, assignments and a return. Calls of vmi_two_sum and vmi_fast_two_sum
become two exact parts, NAME_hi (the rounded sum) and NAME_lo (what rounding left), by the theorems of Knuth and Dekker.
"""
import os
import re
import subprocess
from fractions import Fraction
from functools import lru_cache

CC = os.environ.get("CC", "cc")
NUMBER = re.compile(r"(?<![\w.])(\d+\.\d*(?:[eE][+-]?\d+)?|\d+[eE][+-]?\d+)(f?)(?![\w.])")


class Precision:
    """double or float: number of binary digits, exponent of the least number, name of the rounding in Gappa"""

    def __init__(self, name):
        self.name, self.single = name, name == "float"
        self.digits, self.least = (24, -149) if self.single else (53, -1074)
        self.rounding = "float<ieee_32,ne>" if self.single else "float<ieee_64,ne>"


@lru_cache(None)
def preprocessed(precision, header):
    """The header as the compiler sees it, for a processor without fused multiply-add"""
    flags = ["-DVM_USE_FLOAT"] if precision.single else []
    command = [CC, "-E", "-P", "-std=c99", "-O0", "-U__FP_FAST_FMA", "-U__FP_FAST_FMAF", *flags, header]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def cut(text, separator):
    """The parts of text between separators that stand outside all brackets"""
    depth, start, parts = 0, 0, []
    for i, c in enumerate(text):
        depth += {"{": 1, "}": -1, "(": 1, ")": -1, "[": 1, "]": -1}.get(c, 0)
        if c == separator and depth == 0:
            parts.append(text[start:i].strip())
            start = i + 1
    return parts + [text[start:].strip()]


def nearest(q, precision):
    """q rounded to the nearest number of this precision, ties to even"""
    if q == 0:
        return Fraction(0)
    size = abs(q)
    e = size.numerator.bit_length() - size.denominator.bit_length() - precision.digits
    while size / Fraction(2)**e >= 2**precision.digits:
        e += 1
    while size / Fraction(2)**e < 2**(precision.digits - 1):
        e -= 1
    e = max(e, precision.least)
    m = round(size / Fraction(2)**e)
    return (m if q > 0 else -m) * Fraction(2)**e


def dyadic(q):
    """Gappa's notation of a number m 2^e"""
    q = Fraction(q)
    return f"{q.numerator}b-{q.denominator.bit_length() - 1}"


class Kernel:
    """define: name -> expression in C, in the order of the code. returned: the expression after `return`. body: all statements
    without blanks."""

    def __init__(self, function, precision, header="jacobi.h"):
        self.p = precision
        text = preprocessed(precision, header)
        found = re.search(r"\b" + function + r"\(([^;{}]*)\)\s*\{", text)
        depth, end = 1, found.end()
        while depth:
            depth += {"{": 1, "}": -1}.get(text[end], 0)
            end += 1
        self.define, self.returned = {}, None
        self.body = "".join(text[found.end():end - 1].split())
        for statement in cut(" ".join(text[found.end():end - 1].split()), ";"):
            self._read(statement)

    def _read(self, statement):
        statement = re.sub(r"^(static const|const)\s+", "", statement)
        statement = re.sub(r"^(vm_real|vm_two|int|vmi_bits)\s+", "", statement)
        if statement.startswith("return "):
            self.returned = statement[7:]
            return
        for part in cut(statement, ","):
            found = re.match(r"(\*?[\w.]+(?:\[\w+\])*)\s*=\s*(.*)$", part)
            if found:
                self.define[found.group(1).lstrip("*").replace(".", "_")] = found.group(2)

    def expect(self, **expressions):
        """Stops unless these names have these expressions; `returned` is the expression after return."""
        for name, expression in expressions.items():
            got = self.returned if name == "returned" else self.define[name]
            if got.replace(" ", "") != expression.replace(" ", ""):
                raise SystemExit(f"The model does not fit the code: {name} = {got}, expected {expression}")

    def expect_body(self, *statements):
        """Stops unless the body has these statements."""
        for statement in statements:
            if statement.replace(" ", "") not in self.body:
                raise SystemExit(f"The model does not fit the code: {self.body}, expected {statement}")

    def value(self, constant):
        """The number that a constant of the code is, such as (-0.35) or 0.1f"""
        constant = constant.strip(" ()")
        sign = -1 if constant.startswith("-") else 1
        return sign * nearest(Fraction(constant.lstrip("-").strip(" ()").rstrip("f")), self.p)

    def table(self):
        """The rows of the function's table, as exact numbers"""
        key = [name for name in self.define if name.startswith("table")][0]
        return [[self.value(x) for x in cut(row, ",")] for row in re.findall(r"\{([^{}]*)\}", self.define[key])]

    def clean(self, expression, sollya=False):
        """An expression of C for Gappa or Sollya: constants exact, members as names, halves as products"""
        def number(found):
            q = self.value(found.group(1))
            return f"({q.numerator}*2^(-{q.denominator.bit_length() - 1}))" if sollya else dyadic(q)
        expression = NUMBER.sub(number, expression)
        expression = re.sub(r"\(vm_real\)\s*", "", expression)
        expression = re.sub(r"\b(\w+)\.(hi|lo)\b", r"\1_\2", expression)
        return re.sub(r"/ 2(?![\w.])", "* 0.5", expression)

    def rounded(self, names):
        """Definitions in Gappa in which every operation is rounded"""
        lines, op = [], f" {self.p.rounding}= "
        for n in names:
            call = re.match(r"vmi_(?:fast_)?two_sum\((.*)\)$", self.define[n])
            if not call:
                lines.append(f"{n}{op}{self.clean(self.define[n])};")
                continue
            a, b = [self.clean(x) for x in cut(call.group(1), ",")]
            b = re.sub(r"^-\((.*)\) \* 0\.5$", r"(\1) * -1b-1", b)  # the same number; Gappa knows it better
            lines += [f"{n}_a{op}{a};", f"{n}_b{op}{b};", f"{n}_hi{op}{n}_a + {n}_b;",
                      f"{n}_lo = ({n}_a + {n}_b) - {n}_hi;"]
        return "\n".join(lines) + "\n"

    def exact(self, names, replaced=None):
        """The same definitions without rounding: NAME becomes MNAME; `replaced` gives other names for variables."""
        lines, known = [], dict(replaced or {})
        for n in names:
            expression = re.sub(r"\b[A-Za-z]\w*\b", lambda m: known.get(m.group(0), m.group(0)),
                                self.clean(self.define[n]))
            known[n] = "M" + n
            lines.append(f"M{n} = {expression};")
        return "\n".join(lines) + "\n"

    def sollya(self, names, replaced):
        """The same definitions for Sollya"""
        lines = []
        for n in names:
            expression = re.sub(r"\b[A-Za-z]\w*\b", lambda m: replaced.get(m.group(0), m.group(0)),
                                self.clean(self.define[n], True))
            lines.append(f"{n} = {expression};")
        return "\n".join(lines) + "\n"
