"""Write tests/data/hard.h: the true values of the hard cases, whose points are read from tests/hard/*.c.

A function here for each kernel there, in arbitrary precision, of the point exactly as the test has it (rounded to
double, or to float for the float build). It returns the value, or the value and the scale of its error.

usage: python3 tests/gen/hard_reference.py, from the top of the project; needs mpmath. Minutes."""
import glob
import re
import struct

from mpmath import (agm, besselj, bessely, beta, betainc, cos, ellipe, ellipf, ellipfun, ellipk, ellippi, exp, expm1, fabs, findroot,
                    lambertw, log, log1p, mp, mpf, nstr, pi, quad, sin, sqrt)

mp.dps = 60
INPUTS = 6
IN_FLOAT = False
half = mpf(1) / 2


def single(x):
    return struct.unpack("f", struct.pack("f", x))[0]


# -- removable singularities --

def means(m):
    if m == 0:
        return half, mpf(3) / 8, mpf(5) / 16
    c2 = (ellipe(m) / ellipk(m) - 1 + m) / m
    c4 = (2 * (2 * m - 1) * c2 + (1 - m)) / (3 * m)
    return c2, c4, (4 * (2 * m - 1) * c4 + 3 * (1 - m) * c2) / (5 * m)


def with_digits(digits, function):
    """The function evaluated with more digits than the cancellation in it takes"""
    def evaluated(*x):
        with mp.workdps(digits):
            value = function(*x)
        return value
    return evaluated


C2 = with_digits(120, lambda m: means(m)[0])
C4 = with_digits(120, lambda m: means(m)[1])
C6 = with_digits(120, lambda m: means(m)[2])


@lambda f: with_digits(90, f)
def power_law(rate, p, t):
    ln = log1p(rate * t)
    return expm1((1 - p) * ln) / (rate * (1 - p)) if p != 1 else ln / rate


def exponential_law(rate, t):
    return -expm1(-rate * t) / rate if rate else t


def linear_law(rate, t):
    return log1p(rate * t) / rate


def quadratic_law(b, c, t):
    return quad(lambda s: 1 / (1 + b * s + c * s * s), [0, t / 4, t / 2, t])


@lambda f: with_digits(120, f)
def rocket_way(t, rate):
    m = 1 + rate * t
    return 3 * (m / rate * log(m) - t)


@lambda f: with_digits(120, f)
def wagon_way(t, rate):
    return 2 / rate * (t - log(1 + rate * t) / rate)


def tsiolkovsky(m0, m):
    return 1000 * log(m / m0)


@lambda f: with_digits(120, f)
def jet(rate, t):
    C1, A1 = rate / 2, rate * 3 / 4
    ln = log((3 + A1 * t) / 3)
    return exp((mpf(3) / 2 / (mpf(3) / 4) - 1) * ln) * sin(4 * (C1 / A1 * t + (1 - 3 * C1 / A1) / A1 * ln - t))


@lambda f: with_digits(120, f)
def whirl_angle(c, n, t):
    e = 1 - n / 2
    return 2 * (expm1(e * log1p(c * t)) / (c * e) if e else log1p(c * t) / c)


def ratio_laws(f, g, t):
    return expm1((f - g) * t) / (f - g)


def drum_time(phi, D):
    e = 1 - D
    if e == 0:
        return phi / 2 * (1 + phi / 16)
    z = e * phi / 2
    return phi / 2 * (log(1 + z) / z + phi / 8 * (z - log(1 + z)) / z**2)


def drum_unbalance(phi, square):
    if square == 1:
        return (sin(phi) - phi * cos(phi)) / 2
    k = sqrt(square)
    return (sin(phi) - sin(k * phi) / k) / (square - 1)


def drum_angle(t, D):
    return findroot(lambda phi: drum_time(phi, D) - t, 2 * t)


def vdp(b, rate, t):
    F, a3 = (2 * b - rate) / rate * log1p(rate * t) / 3, ateb_mean(3, 2, 2) / 2
    return sqrt(exp(F) / (4 + 6 * a3 / (2 * b - rate) * expm1(F)))


def ateb_mean(alpha, p, q):
    return beta((p + 1) / mpf(2), (q + 1) / (alpha + 1)) / beta(half, 1 / (alpha + mpf(1)))


@lambda f: with_digits(90, f)
def spin_up(k, t):
    return t / k + expm1(-k * t) / k**2


def free_shaft(c, t):
    return sin(sqrt(c) * t) / sqrt(c) if c else t


def free_body(I1, I2, I3, w1, w3, t):
    if I1 == I3:
        return w1
    m = I1 * (I1 - I2) * w1**2 / (I3 * (I2 - I3) * w3**2)
    return w1 * ellipfun("cn", w3 * sqrt((I1 - I3) * (I2 - I3) / (I1 * I2)) * t, m=m)


def lambert_w0(x):
    return lambertw(x).real


def lambert_wm1(x):
    return lambertw(x, -1).real


def mean_phase(alpha, r, rate, t):
    share, m = (2 * r - 1) / (alpha + 3), 1 + rate * t
    left = half - (alpha - 1) / 2 * share
    integral = (m**left - 1) / (rate * left) if left else log(m) / rate
    return m**-share * ateb(sqrt((alpha + 1) / 2) * integral, alpha)[1], mpf(1)


# -- Ateb functions: s(ca) is an incomplete beta function, inverted by Newton's method --

def ateb_pi(alpha):
    return beta(1 / (alpha + 1), half)


def ateb(s, alpha):
    """sa(1, alpha, s), ca(alpha, 1, s)"""
    Pi = ateb_pi(alpha)
    turn = s / Pi
    k = int(mp.nint(turn))
    d = s - k * Pi  # of the nearest extremum of ca, |d| <= Pi/2
    a, b = mpf(1) / (alpha + 1), half
    if alpha == 0:
        sa, ca = d, 1 - d * d
    else:
        sign, d = (1 if d >= 0 else -1), fabs(d)
        far = Pi / 2 - d
        if d < far:  # d = B_z(1/2, a)/2 of z = sa^2
            def rate(z):
                return z**(b - 1) * (1 - z)**(a - 1) / 2
            goal, guess = d, min(d * d, mpf("0.9"))
            z = invert(lambda z: betainc(b, a, 0, z) / 2, rate, goal, guess)
            sa, ca = sqrt(z), (1 - z)**a
        elif far == 0:
            sa, ca = mpf(1), mpf(0)
        else:  # far = B_y(a, 1/2)/2 of y = ca^(alpha+1), in terms of ca itself
            def s_of(c):
                y = c**(alpha + 1)
                return c * mp.hyp2f1(a, half, 1 + a, y) / (2 * a)

            def slope(c):
                return 1 / sqrt(1 - c**(alpha + 1)) / (2 * a)
            ca = invert(s_of, slope, far, min(2 * a * far, mpf("0.9")))
            sa = sqrt(1 - ca**(alpha + 1))
        sa *= sign
    return (-sa, -ca) if k % 2 else (sa, ca)


def invert(function, slope, goal, guess):
    """The zero of function - goal, which rises and is convex or concave, in (0, 1)"""
    low, high, x = mpf(0), mpf(1), guess
    for _ in range(400):
        f = function(x) - goal
        if f > 0:
            high = x
        else:
            low = x
        step = f / slope(x)
        if fabs(step) <= fabs(x) * mpf(10)**(-mp.dps + 8):
            return x - step
        x = x - step if low < x - step < high else (low + high) / 2
    raise ValueError("no convergence")


@lambda f: with_digits(50, f)
def integral_sa2(s, alpha):
    sa, ca = ateb(s, alpha)
    return (s - sa * ca) * (alpha + 1) / (alpha + 3)


def amplitude_law(ratio, alpha):
    return ratio**(1 / (alpha + 3))


def frozen_motion(t, rate):
    return ateb(sqrt(mpf(2)) * log1p(rate * t) / rate, mpf(3))[1]


# -- cancellation --

def ca(s, alpha):
    return ateb(s, alpha)[1]


def sa(s, alpha):
    return ateb(s, alpha)[0]


def beta_rest(y, a, b):
    return betainc(b, a, 0, y, regularized=True)


def beta_inverse_rest(q, a, b):
    """The y with I_y(b, a) = q, by Newton's method on the logarithms"""
    l = (log(q) + log(b * beta(a, b))) / b
    for _ in range(60):
        y = exp(l)
        part = betainc(b, a, 0, y, regularized=True)
        l -= log(part / q) * part * beta(a, b) / (y**b * (1 - y)**(a - 1))
    return exp(l)


def K_near_1(m1):
    return pi / (2 * agm(1, sqrt(m1)))


@lambda f: with_digits(320, f)
def E_near_1(m1):
    return ellipe(1 - m1)


def F_incomplete(phi, m1):
    return ellipf(phi, 1 - m1)


def Pi_incomplete(phi, n, m):
    return ellippi(n, phi, m)


def rotating(u, m):
    """sn for m > 1, whose largest value is 1/k"""
    k = sqrt(m)
    return jacobi(k * u, 1 - 1 / m)[0] / k, 1 / k


def falling_root(function, goal, low, high):
    """x with function(x) = goal, bisected in ln x, function falling"""
    low, high = log(low), log(high)
    for _ in range(240):
        middle = (low + high) / 2
        if function(exp(middle)) > goal:
            low = middle
        else:
            high = middle
    return exp(low)


def modulus_rest(c):
    return falling_root(lambda m1: -sqrt(m1) * K_near_1(m1), -c, mpf(10)**-330, mpf(1))


def modulus_of_K_rest(c):
    m1 = falling_root(K_near_1, c, mpf(10)**-330, mpf(1))
    return m1, (1 + 2 * c) * m1


def jacobi(u, m1):
    """sn, cn, dn by the descending ladder, so that m1 keeps its digits"""
    a, b, ladder = mpf(1), sqrt(m1), []
    while fabs(a - b) > a * mpf(10)**-(mp.dps // 2 + 5):
        ladder.append((a, b))
        a, b = (a + b) / 2, sqrt(a * b)
    s, c, d, q = sin(a * u), cos(a * u), mpf(1), mpf(1)
    for n in range(len(ladder) - 1, -1, -1):
        upper = ladder[n + 1][0] if n + 1 < len(ladder) else a
        ra, rb = ladder[n][0] / upper, ladder[n][1] / upper
        s, c, d, q = ra * s * q, c * d, c * c + rb * s * s, c * c + ra * s * s
    return s / q, c / q, d / q


def cn(u, m):
    return jacobi(u, 1 - m)[1]


def sn(u, m):
    return jacobi(u, 1 - m)[0]


def dn(u, m):
    return jacobi(u, 1 - m)[2]


def cn_m1(u, m1):
    return jacobi(u, m1)[1]


def dn_m1(u, m1):
    return jacobi(u, m1)[2]


def energy_gain(v):
    return mpf(5) / 32


def energy_loss(v):
    return mpf(3) / 32


def plane_rest(M, I, r, v, w, m, i, r2, v2, w2):
    """M, I, r, v, w of what is left of a lamina: complex places and velocities"""
    M1 = M - m
    r1, v1 = (M * r - m * r2) / M1, (M * v - m * v2) / M1

    def about_r(mass, inertia, place, velocity, spin):
        return inertia * spin + mass * ((place - r).conjugate() * velocity).imag
    I1 = I - i - m * abs(r2 - r)**2 - M1 * abs(r1 - r)**2
    L1 = about_r(M, I, r, v, w) - about_r(m, i, r2, v2, w2) - about_r(M1, 0, r1, v1, 0)
    return M1, I1, r1, v1, L1 / I1


def far_spin(X, X2):
    return plane_rest(mpf(5), mpf(2), X, mp.mpc(10, 3), 3, mpf(1), mpf(1) / 8, X2, mp.mpc(8, 5), 1)[4]


def about_far_point(X, place):
    return half + 21 * (place - X)


def far_relative(X, place):
    return mpf(3) / 2 - 3 * (place - X)


def split_inertia(X):
    return plane_rest(mpf(5), mpf(2), X, 0, 0, mpf(1), mpf(1) / 8, X + mpf(3) / 8, 0, 0)[1]


def drum_stop(mu, v, D):
    return 2 / (D - mu * v / 2)


def drum_rate(mu, v, D, phi):
    return (2 + (mu * v / 2 - D) * phi) / (1 + mu / 4 * phi)


def drum_rate_elastic(mu, v, D, phi, rise):
    return drum_rate(mu, v, D, phi) * (1 - mu / 2 * rise / (1 + mu / 4 * phi))


def start_velocity(t, alpha):
    n = alpha + 1
    return -sqrt(2 / n) * ateb(sqrt(n / 2) * t, alpha)[0]


def broken_rotor(t):
    return -2 * sin(t)**2 / 8


# -- under- and overflow --

def ln_beta_inverse(p, a, b):
    """x is so small that I_x = x^a/(a B(a, b)) to all digits"""
    return (log(p) + log(a * beta(a, b))) / a


def amplitude(x, v, alpha):
    n = alpha + 1
    return (fabs(x)**n + n / 2 * v * v)**(1 / n)


def phase(x, v, alpha):
    """In the first quarter: I_(sa^2)(1/2, 1/(alpha+1)) Pi/2"""
    n = alpha + 1
    w = n / 2 * v * v / (fabs(x)**n + n / 2 * v * v)
    return betainc(half, 1 / n, 0, w) / 2


def period(A, alpha):
    return 2 * ateb_pi(alpha) / sqrt((alpha + 1) / 2 * A**(alpha - 1))


def vmax(A, alpha):
    return sqrt(2 / (alpha + 1) * A**(alpha + 1))


def motion(t, A, alpha):
    return A * ateb(t * sqrt((alpha + 1) / 2 * A**(alpha - 1)), alpha)[1]


@lambda f: with_digits(400, f)
def K(m):
    return pi / (2 * agm(1, sqrt(1 - m)))


@lambda f: with_digits(700, f)
def E(m):
    n = m / (m - 1)
    return sqrt(1 - m) * ellipe(n)


@lambda f: with_digits(400, f)
def cn_far_m(u, m):
    return jacobi(u, 1 - m)[1]


@lambda f: with_digits(340, f)
def modulus(c):
    """k'K(k^2) = K(1 - 1/m1), m1 = 1 - m large"""
    m1 = 1 / falling_root_of(K_near_1, c, mpf(10)**-330, mpf(1), 1200)
    return 1 - m1, (1 + 2 * c) * m1


def falling_root_of(function, goal, low, high, steps):
    low, high = log(low), log(high)
    for _ in range(steps):
        middle = (low + high) / 2
        low, high = (middle, high) if function(exp(middle)) > goal else (low, middle)
    return exp(low)


def w0_exp(l):
    w = l - log(l) if l > 1 else exp(l)
    for _ in range(20):
        w -= (w + log(w) - l) * w / (1 + w)
    return w


def wm1_mexp(l):
    """w = -v, v - ln v = -l"""
    v = -l
    for _ in range(60):
        v = -l + log(v)
    return -v


def steady(c, Omega):
    return c / (c - Omega**2)


def pair_inertia(a, b):
    return a * b / (a + b) * 4


def heavy_separation(M, v):
    return v / 2


def distance(x, y):
    return sqrt(x * x + y * y)


def scaled_attitude(scale):
    return 2 * mpf("0.8")**2 + 5 * mpf("0.6")**2


def rocket_speed(m0, m):
    return 3 * log(m / m0)


def levi_civita(v0, m0, m):
    return (m0 * v0 + (m - m0) * 2) / m


def hit(scale):
    return mpf(2) / 5


def mean(alpha, p, q):
    return ateb_mean(alpha, p, q)


# -- long times; the scale is the largest value --

def unit(function):
    """Errors in eps of 1"""
    def scaled(*x):
        return function(*x), mpf(1)
    return scaled


cn_late, sn_late = unit(cn), unit(sn)
ca_late, sa_late = unit(lambda s, alpha: ca(s, alpha)), unit(lambda s, alpha: sa(s, alpha))
euler_late = unit(lambda psi: cos(psi / 2))


def free_body_late(I1, I2, I3, w1, w3, t):
    m1 = 1 - I1 * (I1 - I2) * w1**2 / (I3 * (I2 - I3) * w3**2)
    u = w3 * sqrt((I1 - I3) * (I2 - I3) / (I1 * I2)) * t
    return w1 * jacobi(u, m1)[1], sqrt(w1**2 + w3**2)


@unit
def precession(A, C, w1, w3, t):
    across, along = A * w1, C * w3
    L2 = across**2 + along**2
    return (along**2 + across**2 * cos(sqrt(L2) / A * t)) / L2


def attitude_length(steps, t):
    return mpf(1)


def amplification(z):
    return 1 + z + z**2 / 2 + z**3 / 6 + z**4 / 24


def steps_growing(n, h):
    return amplification(h)**int(n)


@unit
def steps_circling(n, h):
    return (amplification(mp.mpc(0, 1) * h)**int(n)).real


def steps_clock(n, t):
    return t * t


def energy_late(t, alpha):
    return 1 / (alpha + 1)


@unit
def adiabatic_late(t, rate, alpha):
    return ateb(sqrt((alpha + 1) / 2) * log1p(rate * t) / rate, alpha)[1]


@unit
def bessel(t, rate):
    """(m x')' + x = 0 is Bessel's equation in z = 2 sqrt(m)/rate"""
    z0, z = 2 / rate, 2 * sqrt(1 + rate * t) / rate
    return pi * z0 / 2 * (besselj(1, z0) * bessely(0, z) - bessely(1, z0) * besselj(0, z))


# -- forces that are not smooth --

ca_path, sa_path = ca_late, sa_late


def spring(x, alpha):
    return mpf(0), mpf(1)


def period_path(alpha):
    return period(mpf(1), alpha)


def mean_path(alpha, p, q):
    return ateb_mean(alpha, p, q)


def friction(alpha):
    """The energy falls by friction times way: A' = -vmax <|sa|>, the mean being (alpha + 1)/Pi"""
    return -sqrt(2 * (alpha + 1)) / ateb_pi(alpha)


@unit
def branches(t, alpha):
    return ateb(sqrt((alpha + 1) / 2) * t, alpha)[1]


@unit
def bounces(t, keeps):
    speed, now = mpf(2), mpf(1)
    while True:
        speed *= keeps
        if now + speed >= t:
            return speed * (t - now) - (t - now)**2
        now += speed


@unit
def arcs(third):
    """32/pi^3 sum (-1)^j cos (2j+1)x/(2j+1)^3"""
    return 32 / pi**3 * (1 - third / 27)


rough_spring = adiabatic_late


def grain_bore(m, R, L):
    return R * sqrt((40 - m) / 40)


def slim_orbit(t, v):
    """By Kepler's equation, with the digits that it loses"""
    a = 1 / (2 - v * v)
    e, M = 1 - 1 / a, t / (a * sqrt(a))
    with mp.workdps(120):
        E = findroot(lambda E: E - e * sin(E) - M, (M, (6 * M)**(mpf(1) / 3) + M), solver="anderson", tol=mpf(10)**-220)
        x = a * (cos(E) - e)
    return x, 1 + fabs(x)


# -- oscillators with slow mass; the scale is the amplitude --

def whole_phase(x, V, alpha):
    """Amplitude and phase of x = A ca(psi), V = -sqrt(2/(alpha+1)) A^((alpha+1)/2) sa(psi)"""
    n = alpha + 1
    A = amplitude(x, V, alpha)
    psi = betainc(half, 1 / n, 0, n / 2 * V * V / A**n) / 2 if V else mpf(0)
    if x < 0:
        psi = ateb_pi(alpha) - psi
    return A, -psi if V > 0 else psi


def leak(alpha, rate, t, x, v):
    """m = (1 + rate t)^(alpha+3) and no reactive force"""
    A, psi = whole_phase(x, v - rate * x, alpha)
    el = 1 + rate * t
    W = sqrt((alpha + 1) / 2) * A**((alpha - 1) / 2)
    return A * el * ateb(psi + W * t / el, alpha)[1], A * el


slow_leak = turning_leak = crossing_leak = wall_leak = leak


def leak_width(alpha, rate, t, x, v):
    return whole_phase(x, v - rate * x, alpha)[0] * (1 + rate * t)


@lambda f: with_digits(90, f)
def nearly_solved(d, rate, t):
    """With s = 1 + rate t: rate^2 x_ss + s^-(4+d) x = 0 has the solutions sqrt(s) Z_nu(2 nu/rate s^(-1/(2 nu)))"""
    nu = 1 / (2 + d)

    def solution(Z, s):
        return sqrt(s) * Z(nu, 2 * nu / rate * s**(-1 / (2 * nu)))

    s = 1 + rate * t
    slope = [mp.diff(lambda z: solution(Z, z), mpf(1)) for Z in (besselj, bessely)]
    start = [solution(Z, mpf(1)) for Z in (besselj, bessely)]
    end = [solution(Z, s) for Z in (besselj, bessely)]
    return (end[0] * slope[1] - end[1] * slope[0]) / (start[0] * slope[1] - start[1] * slope[0]), s


@unit
def half_quadratic(alpha, b, c, t):
    way = quad(lambda s: 1 / sqrt(1 + b * s + c * s * s), [0, t / 4, t / 2, t])
    return ateb(sqrt((alpha + 1) / 2) * way, alpha)[1]


@unit
def half_table(alpha, t):
    """The monotone cubics of Fritsch and Butland through points 20 s apart"""
    mass = [mpf(z) for z in (1, 1.125, 1.5, 1.75, 2.5, 2.75)]
    d = [b - a for a, b in zip(mass, mass[1:])]
    slope = [2 * d[i - 1] * d[i] / (d[i - 1] + d[i]) for i in range(1, 5)]
    slope = [(3 * d[0] - d[1]) / 2] + slope + [(3 * d[4] - d[3]) / 2]

    def cubic(i, u):
        f0, f1, s0, s1 = mass[i], mass[i + 1], slope[i], slope[i + 1]
        return (f0 * (1 + 2 * u) + s0 * u) * (1 - u)**2 + (f1 * (3 - 2 * u) - s1 * (1 - u)) * u * u

    way = mpf(0)
    for i in range(5):
        last = min(1, max(0, t / 20 - i))
        if last > 0:
            way += 20 * quad(lambda u: 1 / sqrt(cubic(i, u)), [0, last / 2, last])
    return ateb(sqrt((alpha + 1) / 2) * way, alpha)[1]


# -- stiffness --

def burnt_mass(m):
    return 3 * log(m)


def burnt_speed(t):
    return 3 * log(1 - t)


def burnt_way(t):
    return -3 * ((1 - t) * log(1 - t) + t)


def empty_wagon(t):
    return (1 + 2 * t) / (1 - t)


def last_mass(m):
    return 1 / m


def jet_end(t, spin):
    return ((4 - t) / 4)**half


def braked_shaft(k, t):
    return t / k + expm1(-k * t) / k**2


def relaxing(k):
    """y = k (k cos t + sin t - k e^(-k t))/(k^2 + 1)"""
    return k * (k * cos(1) + sin(1) - k * exp(-k)) / (k * k + 1)


@unit
def vanishing_mass(t, alpha):
    return ateb(-sqrt((alpha + 1) / 2) * log(1 - t), alpha)[1]


def vdp_end(b, t):
    return vdp(b, mpf(-1), t)


def drum_end(mu, v, D, phi):
    """The integral of (1 + mu phi/4)/(2 + e phi)"""
    e, s = mu * v / 2 - D, mu / 4
    return s * phi / e + (1 - 2 * s / e) / e * log(1 + e * phi / 2)


def light_mass(rate, alpha):
    phase = sqrt((alpha + 1) / 2) * rate
    return ateb(phase, alpha)[1], 1 + phase


# -- resonance --

def near_resonance(m, c, Omega):
    return c / (c - m * Omega**2) / 8


def stability(m, c, Omega):
    """Coefficients of (81), corrected, for J = 2, k = 1/2, s = 1/8, and D"""
    w2, O2, k = c / m, Omega**2, mpf(1) / 4
    D = w2 - O2
    G = m / 2 * w2**2 / (64 * D)
    return [1, k, 2 * (w2 + O2) + G, 2 * k * (w2 + O2), D**2 + G * (w2 + 3 * O2), k * D**2], D


def slowest_rate(m, c, Omega):
    p, _ = stability(m, c, Omega)
    l = mpf(0)
    for _ in range(60):
        f, slope = mpf(0), mpf(0)
        for a in p:
            slope = slope * l + f
            f = f * l + a
        l -= f / slope
    return l


def routh(m, c, Omega):
    return stability(m, c, Omega)[0][5]


def stable(m, c, Omega):
    return mpf(1 if m * Omega**2 < c else 0), mpf(1)


@lambda f: with_digits(90, f)
def caught(t, c, Omega):
    w = sqrt(c)
    A, B = (Omega - w) / (4 * w), mpf(1) / 64
    r = (3 * B * t)**(mpf(1) / 3)
    if A:
        r = findroot(lambda r: r * r / (2 * A) - B * r / A**2 + B**2 / A**3 * log1p(A * r / B) - t,
                     (r, r + sqrt(2 * A * t)), solver="anderson", tol=mpf(10)**-140)
    return r + mpf(1) / 32


def taylor(coefficients, y, t_end, order=36, step=half / 2):
    """y at t_end, by Taylor series: coefficients(t, y, order) gives those of all components at t"""
    with mp.workdps(36):
        n = int(mp.ceil(t_end / step))
        h = t_end / n
        for i in range(n):
            y = [mp.polyval(series[::-1], h) for series in coefficients(i * h, y, order)]
    return y


def product(a, b, k):
    return sum(a[i] * b[k - i] for i in range(k + 1))


def caught_path(torque, t_end):
    def coefficients(t, y, order):
        x, z, psi, vx, vz, rate = ([value] for value in y)
        c, s = [cos(psi[0])], [sin(psi[0])]
        for k in range(order):
            fx, fz = [-(a + b / 8) for a, b in zip(x, c)], [-(a + b / 8) for a, b in zip(z, s)]
            turn = product(c, fz, k) - product(s, fx, k)
            x.append(vx[k] / (k + 1)), z.append(vz[k] / (k + 1)), psi.append(rate[k] / (k + 1))
            vx.append(fx[k] / (k + 1)), vz.append(fz[k] / (k + 1))
            c.append(-product(s, rate, k) / (k + 1)), s.append(product(c[:k + 1], rate, k) / (k + 1))
            rate.append(((torque if k == 0 else 0) - rate[k] / 2 + turn / 8) / 2 / (k + 1))
        return x, z, psi, vx, vz, rate
    return taylor(coefficients, [mpf(0)] * 6, t_end)[0], mpf(1)


def first_harmonic(alpha):
    """c_1 of ca"""
    Pi = ateb_pi(alpha)
    with mp.workdps(30):
        def rest(w):  # of the quarter, at ca = 1 - w^2
            return 1 - betainc(1 / (alpha + 1), half, 0, (1 - w * w)**(alpha + 1), regularized=True)
        return 4 / pi * quad(lambda w: sin(pi / 2 * rest(w)) * 2 * w, [0, half / 64, half / 8, half, 1])


@mp.memoize
def cubic_harmonic():
    return first_harmonic(mpf(3))


def folded(force, nu, which):
    """A w sqrt((w - nu)^2 + p^2) = force G, w = Om1 A, p = b/6 (alpha = 3: p = 2b/(2 (alpha+3)) m')"""
    Om1 = pi / ateb_pi(mpf(3)) * sqrt(mpf(2))
    G, p = Om1**2 / 2 * cubic_harmonic(), 2 * mpf(1) / 64 / 6
    polynomial = [Om1**4, -2 * nu * Om1**3, Om1**2 * (nu**2 + p**2), 0, 0, 0, -(force * G)**2]
    roots = mp.polyroots(polynomial, maxsteps=500, extraprec=200)
    real = sorted(r.real for r in roots if fabs(r.imag) < mpf(10)**-30 and r.real > 0)
    return real[int(which)]


def passage(alpha, b, force, sweep, t_end):
    def coefficients(t, y, order):
        x, v, theta = [y[0]], [y[1]], y[2]
        c, s, nu = [cos(theta)], [sin(theta)], [half + sweep * t, sweep]
        square = []
        for k in range(order):
            square.append(product(x, x, k))
            elastic = product(square, x, k) if alpha == 3 else x[k]
            x.append(v[k] / (k + 1))
            v.append((force * c[k] - b * v[k] - elastic) / (k + 1))
            turn = [nu[0] * f[k] + (nu[1] * f[k - 1] if k else 0) for f in (c, s)]
            c.append(-turn[1] / (k + 1)), s.append(turn[0] / (k + 1))
        return x, v, [theta, nu[0], nu[1] / 2]
    return taylor(coefficients, [mpf(0)] * 3, t_end)[0], mpf(1)


# -- ill-posed jumps --

def spin_of(text):
    """A constant as the test has it, which is not that of the point"""
    return mpf(single(float(text))) if IN_FLOAT else mpf(float(text))


def thin_rest(inertia):
    return spin_of("3.3")


def tilted_rest(C):
    return spin_of("0.7"), mpf(2)


def rod_rest(whole, part):
    return mpf(3)


def rod_of_points(m):
    """Angular momentum is 0; the spin (3, 1, 4) along (1, 2, 0)/sqrt 5 stays"""
    return mpf(1)


def light_rest(M, m, v, u):
    value = (M * v - m * u) / (M - m)
    return value, fabs(value - v) + v


def fast_spin(V, U):
    return plane_rest(mpf(5), mpf(2), mpf(0), mp.mpc(0, V), 3, mpf(1), mpf(1) / 8, mpf(3) / 8, mp.mpc(0, U), 3)[4]


def wanted_spin(inertia):
    return spin_of("1.7")


def short_pendulum(l, Omega):
    rate, left = spin_of("1.7"), 1 - l
    change = l**3 / left**3 * Omega / 4
    return rate - change, rate + fabs(change)


def refused(m, xx, yy, zz, d):
    if m >= 5:
        return mpf(-3), mpf(1)
    steiner = 5 * m / (5 - m) * d**2
    moments = sorted([2 - xx, 2 - yy - steiner, 3 - zz - steiner])
    if moments[0] < 0 or moments[0] + moments[1] < moments[2]:
        return mpf(-4), mpf(1)
    return mpf(0), mpf(1)


def no_lever(d):
    return mpf(-5), mpf(1)


def hit_or_not(a, b, c):
    return mpf(-5), mpf(1)


def far_attach(x, y):
    mu = mpf(4) / 5
    return (1 + mpf(1) / 4 + mu * (y - x) * 2) / (1 + mpf(1) / 4 + mu * (y - x)**2)


# -- attitudes --

@lambda f: with_digits(120, f)
def mrp_half_turn(x, y, z):
    square = x * x + y * y + z * z
    return (1 - square) / (1 + square)


@lambda f: with_digits(500, f)
def mrp_full_turn(x):
    return 2 * x / (2 + x * x)


@lambda f: with_digits(120, f)
def mrp_shadow(w, x, z):
    """The parameters of -q, where w < 0"""
    return -x / (sqrt(w * w + x * x + z * z) - w)


def turn(c, s):
    """Half the angle of a rotation whose cosine and sine are c and s"""
    return mp.atan2(s, c) / 2


def turn_w(c, s):
    return cos(turn(c, s))


def turn_x(c, s):
    return sin(turn(c, s))


def tilt_313(w, x, y, z):
    return 2 * mp.atan2(sqrt(x * x + y * y), sqrt(w * w + z * z))


def whole_turns(angle):
    """The angle from -pi to pi"""
    return angle - 2 * pi * mp.nint(angle / (2 * pi))


@lambda f: with_digits(120, f)
def first_313(w, x, y, z):
    """psi is the sum of the angles of w + i z and x + i y"""
    if x == y == 0:
        return whole_turns(2 * mp.atan2(z, w))
    if w == z == 0:
        return whole_turns(2 * mp.atan2(y, x))
    return whole_turns(mp.atan2(z, w) + mp.atan2(y, x))


@lambda f: with_digits(120, f)
def yaw(w, x, y, z):
    if w == y and x == -z:
        return mp.atan2(2 * (w + y) * (z - x), (w + y)**2 - (z - x)**2)
    return mp.atan2(2 * (x * y + w * z), w * w + x * x - y * y - z * z)


@lambda f: with_digits(120, f)
def pitch(w, x, y, z):
    c = sqrt((w * w + x * x - y * y - z * z)**2 + 4 * (x * y + w * z)**2)
    return mp.atan2(2 * (w * y - x * z), c)


@lambda f: with_digits(120, f)
def roll(w, x, y, z):
    return mp.atan2(2 * (y * z + w * x), w * w - x * x - y * y + z * z)


def axle_rest(m, inertia, faster=mpf(0)):
    rate = spin_of("3.3")
    spin = mpf(single(float(rate + faster))) if IN_FLOAT else mpf(float(rate + faster))
    return rate - inertia * (spin - rate) / (4 - m - inertia)


def far_axle(at, place, speed):
    d = place - at
    return -mpf(1.25) * d * speed / (8 - mpf(1.25) * d * d)


# -- weak forces --

def feeding(feed, x, v, t_end):
    def coefficients(t, y, order):
        x, v, square = [y[0]], [y[1]], []
        for k in range(order):
            square.append(product(x, x, k))
            x.append(v[k] / (k + 1))
            v.append((feed * (v[k] - product(square, v, k)) - x[k]) / (k + 1))
        return x, v
    end = taylor(coefficients, [x, v], t_end)
    return end[0], sqrt(end[0]**2 + end[1]**2)


def pair_drift(m1, rate1, m2, rate2):
    return m1 * m2 / (m1 + m2) * (rate1 / m1 - rate2 / m2)


def reduced_rate(m1, rate1, m2, rate2):
    return (rate1 * m2**2 + rate2 * m1**2) / (m1 + m2)**2


def pair_centre(m1, rate1, m2, rate2, x, y):
    return (m1 * x + m2 * y) / (m1 + m2)


def coupled_rate(A, other, spring):
    return 1 + spring / 2 * (1 - other / A)


def lightly_damped(b, force, nu):
    return force / 2 / sqrt((1 - nu)**2 + b * b / 4)


# -- joints of scenes --

def rod_pull(mass, length, speed):
    return mass * speed**2 / length


def far_rod(pivot, place, speed):
    return speed**2 / (place - pivot)


def upper_rod(above, below):
    return 10 * (above + below)


def lower_rod(above, below):
    return 10 * below


def flat_rods(mass, height):
    return 10 * mass * sqrt(1 + height**2) / (2 * height)


def thin_bar(mass, length):
    return 10 * mass / 4


def dead_centre(angle, radius, length, speed, force):
    s, c = sin(angle), cos(angle)
    root = sqrt(length**2 - (radius * s)**2)
    part = radius**2 * s * c / root
    slope = -radius * s - part
    bend = -radius * c - radius**2 * (c * c - s * s) / root - part**2 / root
    return slope * (force - bend * speed**2) / (1 + slope**2)


def rod_swing(t, start):
    k = sin(start / 2)
    z = k * ellipfun("cd", t, m=k * k)
    return 2 * z * sqrt(1 - z * z), 1


def rod_length(t, start):
    return mpf(1)


def spring_rod(t, start, stiffness):
    return rod_swing(t, start)


def split(text):
    """Arguments of a macro: text up to commas that are in neither quotes nor parentheses"""
    parts, depth, quoted, part = [], 0, False, ""
    for i, c in enumerate(text):
        if c == '"' and text[i - 1] != "\\":
            quoted = not quoted
        elif not quoted and c in "()":
            depth += 1 if c == "(" else -1
        if c == "," and not quoted and depth == 0:
            parts.append(part.strip())
            part = ""
        else:
            part += c
    return parts + [part.strip()]


def arguments(source, start):
    """What stands between the parenthesis that opens before start and the one that closes it"""
    depth, quoted, i = 1, False, start
    while depth:
        c = source[i]
        if c == '"':
            quoted = not quoted
        elif not quoted and c in "()":
            depth += 1 if c == "(" else -1
        i += 1
    return split(source[start:i - 1])


def cases():
    for name in sorted(glob.glob("tests/hard/*.c")):
        source = open(name).read()
        for found in re.finditer(r"^\s*CASE\(", source, re.M):
            part = arguments(source, found.end())
            yield part[0], part[3:]


def point(numbers, in_float):
    x = []
    for number in numbers:
        chosen = re.match(r"R\((.*),(.*)\)$", number)
        value = float(chosen[2 if in_float else 1] if chosen else number)
        x.append(single(value) if in_float else value)
    return x


def row(kernel, x, in_float):
    global IN_FLOAT
    IN_FLOAT = in_float
    try:
        value = globals()[kernel](*map(mpf, x))
    except Exception:
        print(kernel, x)
        raise
    value, scale = value if isinstance(value, tuple) else (value, fabs(value))
    value, scale = value.real, scale.real  # a root may come with an imaginary zero
    high = float(value)
    low = float(value - high) if abs(high) > 1e-280 else 0
    x = x + [0.0] * (INPUTS - len(x))
    return '{"%s", {%s}, %r, %r, %s},\n' % (kernel, ", ".join(repr(z) for z in x), high, low, nstr(scale, 6))


def main():
    rows = {True: [], False: []}
    for kernel, numbers in cases():
        for in_float in (False, True):
            new = row(kernel, point(numbers, in_float), in_float)
            if new not in rows[in_float]:
                rows[in_float].append(new)
    with open("tests/data/hard.h", "w") as f:
        f.write("/* written by tests/gen/hard_reference.py: kernel, point, value in two words, scale of error */\n")
        f.write("#ifdef VM_USE_FLOAT\n" + "".join(rows[True]) + "#else\n" + "".join(rows[False]) + "#endif\n")


if __name__ == "__main__":
    main()
