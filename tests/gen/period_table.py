#!/usr/bin/env python3
"""Print src/jacobi/period_table.h: polynomials for the quarter period K as a function of k' = sqrt(1 - m).

Each octave of k' has eight pieces. K = c_0 + c_1 t + c_2 t^2 + ... with t = k' - c, where c is the middle of the piece;
the polynomial interpolates K at Chebyshev's points. The first coefficients are split into a head and a low word. The
heads have so few digits that the products that vmi_period_by_table forms with them are exact.
"""
from mpmath import mp, mpf, agm, cos, frexp, ldexp, nint, nstr, pi, log

mp.prec = 260
FIRST, LAST, OCTAVE = mpf("0.171875"), mpf("1.5"), 8
# digits, degree, and the digits of the heads of the coefficients that are split
PRECISIONS = [(53, 13, (32, 39, 25, 11, 20)), (24, 6, (24, 14, 4))]


def rounded(x, digits):
    mantissa, exponent = frexp(x)
    return ldexp(nint(ldexp(mantissa, digits)), exponent - digits)


def coefficients(middle, half, degree):
    """The polynomial in t that equals K at degree + 1 points, by Newton's divided differences, and its error."""
    points = [cos(pi * (2 * i + 1) / (2 * (degree + 1))) for i in range(degree + 1)]
    d = [pi / (2 * agm(1, middle + half * x)) for x in points]
    for k in range(1, degree + 1):
        for i in range(degree, k - 1, -1):
            d[i] = (d[i] - d[i - 1]) / (points[i] - points[i - k])
    c = [d[degree]]
    for k in range(degree - 1, -1, -1):
        c = [a - b * points[k] for a, b in zip([mpf(0)] + c, c + [mpf(0)])]
        c[0] += d[k]
    error = max(abs(sum(a * x**i for i, a in enumerate(c)) - pi / (2 * agm(1, middle + half * x)))
                for x in [mpf(j) / 30 for j in range(-30, 31)])
    return [a / half**i for i, a in enumerate(c)], error


def row(middle, half, digits, degree, heads):
    c, error = coefficients(middle, half, degree)
    split = [rounded(a, n) for a, n in zip(c, heads)]
    numbers = [x for a, head in zip(c, split) for x in (head, rounded(a - head, digits))]
    return numbers + [rounded(a, digits) for a in c[len(split):]], error


def written(x, digits):
    return f"VM_C({float(x)!r})" if digits == 53 else f"VM_C({nstr(x, 9, min_fixed=-4, max_fixed=9)})"


def lines(numbers, digits):
    text, line = [], "        {"
    for i, x in enumerate(numbers):
        item = written(x, digits) + ("}" if i == len(numbers) - 1 else ",")
        if len(line) + len(item) + 2 > 114:
            text.append(line.rstrip())
            line = "         "
        line += item + " "
    return text + [line.rstrip()]


if __name__ == "__main__":
    for digits, degree, heads in PRECISIONS:
        k, worst, text, count = FIRST, mpf(0), [], 0
        while k < LAST:
            width = ldexp(mpf(1), frexp(k)[1] - 1) / OCTAVE
            numbers, error = row(k + width / 2, width / 2, digits, degree, heads)
            text.append("\n".join(lines(numbers, digits)))
            worst, k, count = max(worst, error), k + width, count + 1
        print(f"/* {count} rows of {len(numbers)}, p = {digits}: error 2^{nstr(log(worst, 2), 4)} */")
        print("    VM_TABLE vm_real table[VMI_PERIOD_ROWS][VMI_PERIOD_COLUMNS] = {\n" + ",\n".join(text) + "};")
