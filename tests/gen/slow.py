"""Write tests/data/slow_vdp.h and tests/data/slow_fourier.h: coefficients of the Van der Pol oscillator (410) by Ateb
and Jacobi functions, and the first Fourier coefficients of ca(alpha, 1, s), to 20 digits.

usage: python3 tests/gen/slow.py, from the top of the project; needs mpmath. Minutes."""
from mpmath import mp, mpf, beta, betainc, ellipk, ellipe, findroot, quad, sin, pi, nstr

mp.dps = 30
ALPHAS = [0, mpf(1) / 1024, 0.125, 0.5, 0.75, 1, 1.25, 1.5, 2, 2.5, 3, 5, 10, 100, 1024, 2**20]


def means(m):
    """C2, C4, C6: means of cn^2, cn^4, cn^6 (383), (384), (408)"""
    if m == 0:
        return mpf(1) / 2, mpf(3) / 8, mpf(5) / 16
    c2 = (ellipe(m) / ellipk(m) - 1 + m) / m
    c4 = (2 * (2 * m - 1) * c2 + (1 - m)) / (3 * m)
    return c2, c4, (4 * (2 * m - 1) * c4 + 3 * (1 - m) * c2) / (5 * m)


def jacobi_coefficients(a):
    """a1, a2, a3 of (411)-(413), a1 by its definition"""
    right = beta(1 / (a + 1), mpf(1) / 2) / (a + 1)
    mu = findroot(lambda m: ellipk(m) - right, (mpf(-5), mpf('0.7')), solver='anderson')
    m = mu / (mu - 1) if a != 1 else mpf(0)
    c2, c4, c6 = means(m)
    a2 = (1 - m) - (1 - 2 * m) * c2 - m * c4
    return (1 - m) + m * c4 + (a - 1) / 2 * a2, a2, (1 - m) * c2 - (1 - 2 * m) * c4 - m * c6


def fourier(a, n):
    """c_n = 2 int_0^1 ca cos(n pi u/2) du = (4/(n pi)) int_0^1 sin(n pi u(y)/2) dy, where y = 1 - w^2 and
    u = 1 - I_z(1/(a+1), 1/2), z = y^(a+1)"""
    def u(w):
        return 1 - betainc(1 / (a + 1), mpf(1) / 2, 0, (1 - w * w)**(a + 1), regularized=True)
    edges = [0] + [mpf(2)**-k for k in range(14, 0, -2)] + [mpf(7) / 8, 1]
    return 4 / (n * pi) * quad(lambda w: sin(n * pi / 2 * u(w)) * 2 * w, edges)


def row(*numbers):
    return "{" + ", ".join(nstr(x, 20) for x in numbers) + "},\n"


HEADER = "/* written by tests/gen/slow.py */\n"
with open("tests/data/slow_vdp.h", "w") as f:
    f.write(HEADER + "/* alpha; a3 for a1 = 1 (Ateb); a1, a2, a3 (Jacobi) */\n")
    for a in map(mpf, ALPHAS):
        a3 = 2 / (a + 1) * beta(mpf(3) / 2, 3 / (a + 1)) / beta(mpf(1) / 2, 1 / (a + 1))
        f.write(row(a, a3, *jacobi_coefficients(a)))
with open("tests/data/slow_fourier.h", "w") as f:
    f.write(HEADER + "/* alpha; c1, c3, c9 of ca(alpha, 1, s) */\n")
    for a in map(mpf, ALPHAS):
        f.write(row(a, fourier(a, 1), fourier(a, 3), fourier(a, 9)))
