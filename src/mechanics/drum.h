/* mechanics/drum.h - a band that winds up on a drum */
#ifndef VARMASS_MECHANICS_DRUM_H
#define VARMASS_MECHANICS_DRUM_H

#include "../base/elementary.h"
#include "../base/lambert.h"
#include "../base/real.h"
#include "../base/scalars.h"
#include "../base/status.h"
#include "../base/sums.h"
#include "../base/words.h"

/* A band of constant velocity v along y winds up on a drum (Fig. 20). It meets the drum in S + (R, 0), S the centre
   of the shaft; after the angle phi it covers the arc from 0 to phi, whose mass centre is at phi/2. R stays constant:
   the first layer, 0 <= phi <= 2 pi, is what is meant. mu = R h b rho (181), j = mu R^2 (186), and
   e = mu v R - D, which decides whether the drum is driven (e > 0) or comes to rest. */
typedef struct VM_TAG(vm_drum) {
    vm_real radius;    /* R, m */
    vm_real mass;      /* M0 > 0 of the empty drum, kg */
    vm_real inertia;   /* J0 > 0 of the empty drum about its axle, kg m^2 */
    vm_real band;      /* mu >= 0, the band's mass per angle, kg/rad */
    vm_real speed;     /* v of the band, m/s */
    vm_real damping;   /* D of the rotation, N m s */
    vm_real stiffness; /* c >= 0 of the shaft, N/m */
    vm_real omega;     /* Omega_b > 0, the angular velocity at phi = 0, rad/s */
} vm_drum;

typedef struct VM_TAG(vm_drum_geometry) {
    vm_real mass;         /* M (182), kg */
    vm_real arc_centre;   /* S S' (184), m */
    vm_real offset;       /* S S1 (185) corrected, m: S1 = S + offset (cos phi/2, sin phi/2) */
    vm_real axle_inertia; /* J_S (187), about the axle, kg m^2 */
    vm_real inertia;      /* J_S1 (188), about the mass centre, kg m^2 */
} vm_drum_geometry;

/* Right-hand sides for rk45, ctx a vm_drum, of y = {xS, yS, phi, xS', yS', phi'} (VM_DRUM_STATES values). The first
   is exact; it takes the place of (177) and (191), which lack the drift of the mass centre and turn the shaft's
   torque round. With q = mu R (sin phi, 1 - cos phi):
     M rS'' + phi'' k x q - phi'^2 q = -c rS + mu phi' ((0, v) - rS' - phi' k x (R, 0))
     J_S phi'' + q x rS'' = -D phi' + mu phi' R (v - yS' - R phi')
   The second is (192), (193), what is left of it for small mu, with the unbalance mu R phi'^2 (sin phi, -cos phi),
   of the same order as what (192) keeps. Both stop a run, by VM_BAD_MASS or VM_BAD_INERTIA, where a mass or inertia
   is not positive. */
#define VM_DRUM_STATES 6

/* The elastic shaft in the first approximation, for small mu/M0, j/J0, e/(J0 Omega_b):
     x'' + 2 delta x' + k^2 (1 - A phi) x = 0 (213), y with mu v/(M0 Omega_b) on the right (214), ' = d/dphi */
typedef struct VM_TAG(vm_drum_shaft) {
    vm_real k;     /* sqrt(c/M0)/Omega_b */
    vm_real delta; /* (mu/M0 + e/(J0 Omega_b) - j/J0)/2, corrected */
    vm_real A;     /* mu/M0 - 2 j/J0 + 2 e/(J0 Omega_b), corrected, 1/rad */
    vm_real shift; /* mu v/(M0 Omega_b k^2), m: y oscillates about shift/(1 - A phi) */
} vm_drum_shaft;

/* mu (181) */
VM_API vm_real vm_drum_band(vm_real radius, vm_real thickness, vm_real width, vm_real density)
{
    return radius * thickness * width * density;
}

/* M, J_S, and |q|^2/M = M (S S1)^2 at phi; s = sin(phi/2) */
VM_API int vmi_drum_inertia(vm_real phi, vm_real s, const vm_drum *d, vm_real *M, vm_real *J, vm_real *steiner)
{
    const vm_real q = 2 * d->band * d->radius * s;
    *M = d->mass + d->band * phi;
    *J = d->inertia + d->band * d->radius * d->radius * phi;
    *steiner = q / *M * q; /* q alone may be too small to be squared */
    if (!VM_IS_FINITE(*M) || !VM_IS_FINITE(*J)) return VM_NOT_FINITE;
    if (!(*M > 0)) return VM_BAD_MASS;
    return *J - *steiner > 0 ? VM_OK : VM_BAD_INERTIA;
}

/* The drum with its band at the angle phi >= 0. VM_BAD_MASS, VM_BAD_INERTIA where no drum is like that;
   VM_BAD_ARGUMENT (phi < 0, too), VM_NOT_FINITE */
VM_API int vm_drum_at(vm_real phi, const vm_drum *d, vm_drum_geometry *g)
{
    vm_real s, c, M, J, steiner;
    int status;
    if (!d || !g || phi < 0) return VM_BAD_ARGUMENT;
    if (!(VM_IS_FINITE(phi) && VM_IS_FINITE(d->radius))) return VM_NOT_FINITE;
    if (d->mass <= 0 || d->band < 0) return VM_BAD_MASS;
    if (d->inertia <= 0) return VM_BAD_INERTIA;
    vmi_sincos(phi / 2, &s, &c);
    status = vmi_drum_inertia(phi, s, d, &M, &J, &steiner);
    if (status) return status;
    g->mass = M;
    g->arc_centre = phi > VM_MIN ? d->radius * s / (phi / 2) : d->radius;
    g->offset = 2 * d->band * d->radius * s / M;
    g->axle_inertia = J;
    g->inertia = J - steiner;
    return VM_OK;
}

VM_API int vm_drum_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *drum)
{
    if (!y || !dydt || !drum) return VM_BAD_ARGUMENT;
    const vm_drum *d = (const vm_drum *)drum;
    const vm_real flow = d->band * y[5], slip = d->speed - y[4] - d->radius * y[5];
    vm_real s, c, M, J, steiner, qx, qy, X, Y, N, turn;
    int status;
    (void)t;
    vmi_sincos(y[2] / 2, &s, &c);
    status = vmi_drum_inertia(y[2], s, d, &M, &J, &steiner);
    if (status) return status;
    qx = 2 * d->band * d->radius * s * c;
    qy = 2 * d->band * d->radius * s * s;
    X = -d->stiffness * y[0] - flow * y[3] + y[5] * y[5] * qx;
    Y = -d->stiffness * y[1] + flow * slip + y[5] * y[5] * qy;
    N = -d->damping * y[5] + flow * d->radius * slip;
    turn = (N - (qx * Y - qy * X) / M) / (J - steiner);
    dydt[0] = y[3];
    dydt[1] = y[4];
    dydt[2] = y[5];
    dydt[3] = (X + turn * qy) / M;
    dydt[4] = (Y - turn * qx) / M;
    dydt[5] = turn;
    return VM_OK;
}

VM_API int vm_drum_rhs_reduced(vm_real t, const vm_real *y, vm_real *dydt, void *drum)
{
    if (!y || !dydt || !drum) return VM_BAD_ARGUMENT;
    const vm_drum *d = (const vm_drum *)drum;
    const vm_real flow = d->band * y[5], unbalance = flow * d->radius * y[5];
    vm_real s, c, M, J, steiner;
    int status;
    (void)t;
    vmi_sincos(y[2], &s, &c);
    status = vmi_drum_inertia(y[2], 0, d, &M, &J, &steiner);
    if (status) return status;
    dydt[0] = y[3];
    dydt[1] = y[4];
    dydt[2] = y[5];
    dydt[3] = (-d->stiffness * y[0] - flow * y[3] + unbalance * s) / M;
    dydt[4] = (-d->stiffness * y[1] + flow * (d->speed - y[4]) - unbalance * c) / M;
    dydt[5] = (-d->damping * y[5] + flow * d->radius * (d->speed - y[4] - d->radius * y[5])) / J;
    return VM_OK;
}

/* -- The rigid shaft, in two words, the drum's fields taken as exact -- */
VM_API int vmi_drum_turns(const vm_drum *d)
{
    return d && d->inertia > 0 && d->band >= 0 && d->omega > 0 && VM_IS_FINITE(d->inertia) &&
           VM_IS_FINITE(d->band) && VM_IS_FINITE(d->omega) && VM_IS_FINITE(d->radius) && VM_IS_FINITE(d->speed) &&
           VM_IS_FINITE(d->damping);
}

VM_API vm_two vmi_drum_j(const vm_drum *d) /* mu R^2 */
{
    return vmi_two_times(vmi_two_product(d->band, d->radius), vmi_two(d->radius, 0));
}

/* mu v R - D, of which rounding leaves all digits also where it nearly cancels */
VM_API vm_two vmi_drum_e(const vm_drum *d)
{
    const vm_two band = vmi_two_product(d->band, d->radius);
    const vmi_three drive = vmi_three_times(vmi_three_words(band.hi, band.lo, 0), vmi_three_words(d->speed, 0, 0));
    const vmi_three e = vmi_three_plus(drive, vmi_three_words(-d->damping, 0, 0));
    return vmi_two(e.hi, e.mid);
}

/* The rigid shaft (194): angular velocity phi' (196), time t (197) at which the angle phi is reached, phi(t), and the
   angle J0 Omega_b/|e| that is never reached where e < 0 (else infinity). phi, t >= 0; NaN beyond the stop, for a
   null pointer, and for fields without the signs above. Within 4 ulp with the drum's fields taken as exact, through
   e = 0 and k1 = 1 - e/(j Omega_b) = 0, up to the stop, for data whose products in these formulas stay within the
   range of numbers. With x = e phi/(J0 Omega_b)
     t = phi/Omega_b [ln(1 + x)/x + (j phi/J0) (x - ln(1 + x))/x^2],
   and phi(t) is solved for by Newton's method: no Lambert W, no branches. */
VM_API vm_real vm_drum_rate(vm_real phi, const vm_drum *d)
{
    vm_two up, down;
    if (!(phi >= 0) || !VM_IS_FINITE(phi) || !vmi_drum_turns(d)) return VM_NAN;
    up = vmi_two_plus(vmi_two_product(d->inertia, d->omega), vmi_two_times(vmi_drum_e(d), vmi_two(phi, 0)));
    down = vmi_two_plus(vmi_two(d->inertia, 0), vmi_two_times(vmi_drum_j(d), vmi_two(phi, 0)));
    return up.hi >= 0 ? vmi_two_over(up, down).hi : VM_NAN;
}

/* (210), (211) of y = {x, y, dx/dphi, dy/dphi}, phi the independent variable, with phi'(phi) of the rigid shaft
   (196); VM_BAD_ARGUMENT where the drum does not get to phi */
VM_API int vm_drum_rhs_angle(vm_real phi, const vm_real *y, vm_real *dydt, void *drum)
{
    if (!y || !dydt || !drum) return VM_BAD_ARGUMENT;
    const vm_drum *d = (const vm_drum *)drum;
    const vm_real rate = vm_drum_rate(phi, d), j = d->band * d->radius * d->radius;
    const vm_real e = d->band * d->speed * d->radius - d->damping;
    vm_real M, J, steiner, slope, drag;
    int status = vmi_drum_inertia(phi, 0, d, &M, &J, &steiner);
    if (status) return status;
    if (!(rate > 0)) return VM_BAD_ARGUMENT;
    slope = (e - j * rate) / J; /* d phi'/d phi (195), phi'' = slope rate */
    drag = d->band / M + slope / rate;
    dydt[0] = y[2];
    dydt[1] = y[3];
    dydt[2] = -drag * y[2] - d->stiffness * y[0] / (M * rate * rate);
    dydt[3] = -drag * y[3] + (d->band * d->speed * rate - d->stiffness * y[1]) / (M * rate * rate);
    return VM_OK;
}

/* a b/c */
VM_API vm_two vmi_drum_share(vm_two a, vm_real b, vm_two c)
{
    return vmi_two_over(vmi_two_times(a, vmi_two(b, 0)), c);
}

/* Documented with vm_drum_rate. */
VM_API vm_real vm_drum_stop(const vm_drum *d)
{
    vm_two e;
    if (!vmi_drum_turns(d)) return VM_NAN;
    e = vmi_drum_e(d);
    if (!(e.hi < 0)) return VM_INFINITY;
    return vmi_two_over(vmi_two_product(d->inertia, d->omega), vmi_minus(e)).hi;
}

/* Documented with vm_drum_rate. */
VM_API vm_real vm_drum_time(vm_real phi, const vm_drum *d)
{
    vm_two x, y, s, part, sum;
    if (!(phi >= 0) || !VM_IS_FINITE(phi) || !vmi_drum_turns(d)) return VM_NAN;
    x = vmi_drum_share(vmi_drum_e(d), phi, vmi_two_product(d->inertia, d->omega));
    s = vmi_drum_share(vmi_drum_j(d), phi, vmi_two(d->inertia, 0));
    sum = vmi_two_plus(vmi_two(1, 0), x);
    if (!(sum.hi > 0)) return sum.hi == 0 ? VM_INFINITY : VM_NAN;
    y = vmi_log1p(x);
    part = VM_FABS(x.hi) > VM_EPSILON / 4 ? vmi_two_over(y, x) : vmi_two(1, 0);
    sum = vmi_two_plus(part, vmi_two_times(s, vmi_log1p_rest(x, y)));
    return vmi_drum_share(sum, phi, vmi_two(d->omega, 0)).hi;
}

/* With a = e t/J0, b = j Omega_b t/J0, f = phi/(Omega_b t) and y = a p = ln(1 + x) the equation of vm_drum_time reads
     p + b f^2 (x - y)/x^2 = 1,   x = e^y - 1,   f = p x/y.
   Its left side increases with p, with the slope 1 + b f, and is convex, so that Newton's method converges from
   anywhere. It starts where (x - y)/x^2 f^2 is p^2/2, which is the solution for e = 0; for a > 0 that is too
   much, and so is x = y + a^2/b; for a < 0 it is too little, and so is |a|/(|a| + b). */
VM_API vm_real vmi_drum_start(vm_real a, vm_real b)
{
    const vm_real p = 2 / (1 + VM_SQRT(1 + 2 * b));
    if (a < 0) return p > a / (a - b) ? p : a / (a - b);
    if (a * p > 1 && b > 0) {
        const vm_real bound = (vmi_log(a).hi + vmi_log(1 / a + a / b + p).hi) / a;
        return bound < p ? bound : p;
    }
    return p;
}

/* Documented with vm_drum_rate. */
VM_API vm_real vm_drum_angle(vm_real t, const vm_drum *d)
{
    const vm_real precise = VM_EPSILON / 8; /* relative error of phi that the last step leaves */
    const int most_steps = 40; /* 8 were the most of 400 000 drums, |a| from 1e-20 to 1e20, b alike */
    vm_two angle, a, b, p, x, y, f, rest;
    vm_real step, left;
    int i;
    if (!(t >= 0) || !VM_IS_FINITE(t) || !vmi_drum_turns(d)) return VM_NAN;
    angle = vmi_two_product(d->omega, t);
    a = vmi_drum_share(vmi_drum_e(d), t, vmi_two(d->inertia, 0));
    b = vmi_two_over(vmi_two_times(vmi_drum_j(d), angle), vmi_two(d->inertia, 0));
    f = p = vmi_two(vmi_drum_start(a.hi, b.hi), 0);
    for (i = 0, left = 1; i < most_steps && left > precise; i++) {
        y = vmi_two_times(a, p);
        x = vmi_expm1(y);
        f = VM_FABS(y.hi) > VM_EPSILON / 4 ? vmi_two_times(p, vmi_two_over(x, y)) : p;
        rest = vmi_two_times(vmi_two_times(vmi_two_times(b, f), f), vmi_log1p_rest(x, y));
        rest = vmi_two_plus(vmi_two_plus(vmi_two(1, 0), vmi_minus(p)), vmi_minus(rest));
        step = rest.hi / (1 + b.hi * f.hi);
        left = step / f.hi * (step / f.hi) * (1 + x.hi) * (x.hi > 0 ? 1 + x.hi : 1);
        p = vmi_two_plus(p, vmi_two(step, 0));
        f = vmi_two_plus(f, vmi_two(step * (1 + x.hi), 0));
    }
    return vmi_two_times(angle, f).hi;
}

/* phi(t) as published, (198)-(206) corrected: r - k1 ln r = f1, r = -k1 W(x), x = -exp(-f1/k1)/k1, by W_-1 for 0 < k1
   < 1 and W_0 for other k1. For comparison: it loses all digits next to e = 0, where r comes to the branch point; at
   e = 0 and k1 = 0 it is NaN. Next to k1 = 0 x is no number any more (1e-869 for k1 = 1e-3): ln |x| is used. */
VM_API vm_real vm_drum_angle_lambert(vm_real t, const vm_drum *d)
{
    vm_real j, e, k1, f1, l, w;
    if (!(t >= 0) || !VM_IS_FINITE(t) || !vmi_drum_turns(d)) return VM_NAN;
    j = vmi_drum_j(d).hi;
    e = vmi_drum_e(d).hi;
    k1 = 1 - e / (j * d->omega);
    if (k1 == 0 || e == 0) return VM_NAN;
    f1 = 1 + e * e * t / (d->inertia * j * d->omega);
    l = -vmi_log(VM_FABS(k1)).hi - f1 / k1; /* of the argument's size */
    if (l > -1 && k1 > 0) l = -1;           /* by rounding */
    /* e tells the branch: k1 may round to 1 */
    w = k1 < 0 ? vm_wright_omega(l) : e > 0 ? vm_lambert_wm1_neg_exp(l) : vm_lambert_w0_neg_exp(l);
    return (-k1 * w - 1) * d->inertia * d->omega / e;
}

/* VM_SINGULAR where c or Omega_b is not positive; VM_BAD_ARGUMENT, VM_NOT_FINITE, VM_BAD_MASS, VM_BAD_INERTIA */
/* -- The elastic shaft -- */
VM_API int vm_drum_shaft_init(const vm_drum *d, vm_drum_shaft *s)
{
    vm_drum_shaft r;
    vm_real j, drive, mass;
    if (!d || !s) return VM_BAD_ARGUMENT;
    if (d->mass <= 0 || d->band < 0) return VM_BAD_MASS;
    if (d->inertia <= 0) return VM_BAD_INERTIA;
    if (d->stiffness <= 0 || d->omega <= 0) return VM_SINGULAR;
    mass = d->band / d->mass;
    j = d->band * d->radius * d->radius / d->inertia;
    drive = vmi_drum_e(d).hi / (d->inertia * d->omega);
    r.k = VM_SQRT(d->stiffness / d->mass) / d->omega;
    r.delta = (mass + drive - j) / 2;
    r.A = mass + 2 * (drive - j);
    r.shift = mass * d->speed / (d->omega * r.k * r.k);
    if (!VM_IS_FINITE(d->inertia) || !VM_IS_FINITE(r.k) || !VM_IS_FINITE(r.delta) || !VM_IS_FINITE(r.A) ||
        !VM_IS_FINITE(r.shift))
        return VM_NOT_FINITE;
    *s = r;
    return VM_OK;
}

/* (224), (225) corrected: a (1 - A phi)^(-1/4) exp(-delta phi) cos(integral of k sqrt(1 - A phi) + alpha), plus
   particular/(1 - A phi): particular = 0 for x, s->shift for y. At phi = 0, to which a (m) and alpha (rad)
   belong, it is a cos alpha + particular. NaN where 1 - A phi <= 0 and for a null pointer. */
/* The phase (2k/3A)(1 - m^3), m^2 = 1 - A phi, is 2k/3 phi (1 + m + m^2)/(1 + m), which A = 0 does not trouble */
VM_API vm_real vm_drum_deflection(vm_real phi, const vm_drum_shaft *s, vm_real a, vm_real alpha, vm_real particular)
{
    const vm_real square = s ? 1 - s->A * phi : VM_NAN;
    vm_real m, sine, cosine;
    if (!(square > 0) || !VM_IS_FINITE(phi) || !VM_IS_FINITE(a) || !VM_IS_FINITE(particular)) return VM_NAN;
    m = VM_SQRT(square);
    vmi_sincos(2 * s->k / 3 * phi * ((1 + m + square) / (1 + m)) + alpha, &sine, &cosine);
    return a / VM_SQRT(m) * vmi_exp(-s->delta * phi, 0) * cosine + particular / square;
}

/* (226): is A < 1/(2 pi), so that the frequency stays real for the first layer? 0 for a null pointer. */
VM_API int vm_drum_shaft_valid(const vm_drum_shaft *s) { return s && s->A < 1 / (2 * VM_PI); }

#endif
