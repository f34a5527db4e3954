/* oscillators/reduction.h - amplitude and phase of an oscillator, defined so that slow changes disturb them only in
   second order

   The oscillator m x'' + k x|x|^(alpha-1) + (reactive m' + b) x' = 0 can be written d(mu x')/dt + kappa x|x|^(alpha-1)
   = 0. m(t) is the mass and k(t) the stiffness. The functions mu(t) and kappa(t) follow from mu'/mu = a with a =
   (reactive m' + b)/m, and from kappa/mu = k/m. `reactive` is 1 where mass that joins or leaves is at rest, and 0 where
   this mass has the body's velocity; b is the damping. Let p = (ln(mu kappa))'/(alpha+3) and V = x' + p x.
   Then, with the Ateb functions ca and sa, x = A ca(psi) and V = -(2/(alpha+1)) W A sa(psi) define an amplitude A and a
   phase psi, which obey the exact equations
     A'/A = -p + (G_0/W) sa ca,   psi' = W + (alpha+1)/2 (G_0/W) ca^2,   G_0 = p^2 - a p - p',
   where W is the rate that the phase has at the amplitude A if mass and stiffness are constant. Only G_0 disturbs the
   slow motion A'/A = -p, psi' = W, and G_0 is of second order in the rates of mass and stiffness. The numbers G_1, G_2
   ... follow from the derivatives of G_0 (vmi_osc_find_G).
   This file computes a, p and G_k from the derivatives of the laws of mass and stiffness. It also computes A and psi
   from x and x', and x and x' from A and psi.
       vmi_osc_slow now;
       vmi_osc_reduced r;
       int status = vmi_osc_slow_at(&problem, 0, 1, 10, 1, &now); // laws at t = 0, with their values up to 10 s
       if (!status) r = vmi_osc_reduce(&now, problem.alpha, problem.x, problem.v);
   Source: the transformations of Liouville and Kummer; docs/law.md. Tests: tests/test_slow_motion.c. */
#ifndef VARMASS_OSCILLATORS_REDUCTION_H
#define VARMASS_OSCILLATORS_REDUCTION_H

#include "../ateb/period.h"
#include "../ateb/phase.h"
#include "../base/real.h"
#include "../base/scalars.h"
#include "../base/status.h"
#include "constant_mass.h"
#include "laws.h"
#include "problem.h"

/* How many numbers G_k are computed. The law of order five needs G_0 ... G_3, and the estimate of its error needs
   G_4. */
enum { VMI_OSC_G = 5 };

/* Mass, stiffness and the numbers a, p and G_k that follow from their rates, at one time */
typedef struct VM_TAG(vmi_osc_slow) {
    vm_real m, k;         /* mass, kg, and stiffness, N/m^alpha */
    vm_real a, p;         /* the rates a and p that the top of this file defines, 1/s */
    vm_real k_rate;       /* k'/k, 1/s */
    vm_real bend;         /* absolute value of the time derivative of m'/m, 1/s^2 */
    vm_real unit;         /* a time of about 1/W, s; its powers make the G_k pure numbers, so that powers of very large
                             or small rates do not overflow */
    vm_real G[VMI_OSC_G]; /* G[i] is unit^(i+2) G_i, a pure number */
} vmi_osc_slow;

/* Mass, stiffness and the rates a and p at one time, without the numbers G_k. These numbers need only the values and
   the first derivatives of the laws. */
typedef struct VM_TAG(vmi_osc_rates) {
    vm_real m, k; /* mass, kg, and stiffness, N/m^alpha */
    vm_real a, p; /* the rates a and p that the top of this file defines, 1/s */
    vm_real k_rate; /* k'/k, 1/s */
} vmi_osc_rates;

/* Writes mass, stiffness and their rates at t to *r. Where the rates jump at t, side = 1 means the rates after t, and
   side = -1 the rates before t. Returns the statuses of vmi_law_derivatives. */
VM_API int vmi_osc_rates_at(const vm_osc_problem *o, vm_real t, int side, vmi_osc_rates *r)
{
    vm_real m[VMI_LAW_ORDERS], k[VMI_LAW_ORDERS];
    int status = vmi_law_derivatives(&o->mass, VM_BAD_MASS, t, side, 0, m);
    if (!status) status = vmi_law_derivatives(&o->stiffness, VM_BAD_STIFFNESS, t, side, 0, k);
    if (status) return status;
    r->m = m[0];
    r->k = k[0];
    r->a = (o->reactive * m[1] + o->damping) / m[0];
    r->k_rate = k[1] / k[0];
    r->p = (k[1] / k[0] + 2 * r->a - m[1] / m[0]) / (o->alpha + 3);
    return VM_OK;
}

/* Returns 1 if mass or stiffness is a function of the user, which gives no second derivative; else 0. */
VM_API int vmi_osc_has_user_law(const vm_osc_problem *o) { return o->mass.function || o->stiffness.function; }

/* Returns 1 if the fields of a law show that it is constant, as most stiffnesses are, and writes its value and its
   first two derivatives to f; else returns 0. The law must not be a function of the user. The value is not checked,
   since it was checked at t = 0. This function saves 3 to 4 % of the machine instructions of collocation. */
VM_API int vmi_law_is_constant(const vm_law *law, vm_real *f)
{
    if (law->time || law->f1 != 0 || law->f2 != 0) return 0;
    f[0] = law->f0;
    f[1] = 0;
    f[2] = 0;
    return 1;
}

/* Writes what vmi_osc_rates_at writes, but the field k_rate is not valid. In addition it writes the time derivative of
   the rate p to *p_rate, or 0 if mass or stiffness is a function of the user. */
VM_API int vmi_osc_rates_and_slope(const vm_osc_problem *o, vm_real t, int side, vmi_osc_rates *r, vm_real *p_rate)
{
    const vm_real share = 1 / (o->alpha + 3);
    vm_real m[VMI_LAW_ORDERS], k[VMI_LAW_ORDERS], per_m, per_k, m_rate, k_rate, a_rate;
    int status;
    *p_rate = 0;
    if (vmi_osc_has_user_law(o)) return vmi_osc_rates_at(o, t, side, r);
    status = vmi_law_two_derivatives(&o->mass, VM_BAD_MASS, t, side, m);
    if (!status && !vmi_law_is_constant(&o->stiffness, k))
        status = vmi_law_two_derivatives(&o->stiffness, VM_BAD_STIFFNESS, t, side, k);
    if (status) return status;
    per_m = 1 / m[0];
    per_k = 1 / k[0];
    m_rate = m[1] * per_m;
    k_rate = k[1] * per_k;
    r->m = m[0];
    r->k = k[0];
    r->a = (o->reactive * m[1] + o->damping) * per_m;
    r->p = (k_rate + 2 * r->a - m_rate) * share;
    a_rate = o->reactive * m[2] * per_m - r->a * m_rate;
    *p_rate = ((k[2] * per_k - k_rate * k_rate) + 2 * a_rate - (m[2] * per_m - m_rate * m_rate)) * share;
    return VM_OK;
}

/* The time of the next point of a law's table after `from` on the way to t, or t if there is no such point */
VM_API vm_real vmi_osc_next_knot(const vm_osc_problem *o, vm_real from, vm_real t)
{
    return vmi_law_next_knot(&o->stiffness, from, vmi_law_next_knot(&o->mass, from, t));
}

/* -- Rounding errors of the time -- */

/* An upper bound of the relative rates at which mass, stiffness, amplitude and phase rate change, 1/s. p and a are the
   rates at the top of this file, k_rate is k'/k. */
VM_API vm_real vmi_osc_relative_rate(vm_real alpha, vm_real p, vm_real a, vm_real k_rate)
{
    return (alpha + 3) * VM_FABS(p) + 2 * VM_FABS(a) + 2 * VM_FABS(k_rate);
}

/* An estimate of the error that rounding of the time t, s, causes in a motion. The laws of mass and stiffness are only
   known at a rounded time: where a mass f0 + f1 t is nearly exhausted, f0 and f1 t nearly cancel, and the rounding
   error of f1 t changes the mass as much as an error of t. W is the rate of the phase at t, and relative_rate is the
   number of vmi_osc_relative_rate, both in 1/s. */
VM_API vm_real vmi_osc_time_rounding(vm_real t, vm_real W, vm_real relative_rate)
{
    return VM_EPSILON * VM_FABS(t) * (W + relative_rate);
}

/* -- Power series in time: element i of an array is the coefficient of the ith power -- */

/* Replaces the n numbers f, f', f'' ... in the array f by the first n coefficients of the power series of f in the
   variable time/unit, where unit is a time in s. */
VM_API void vmi_series_of_derivatives(int n, vm_real unit, vm_real *f)
{
    int i, power;
    for (power = 1; power < n; power++)
        for (i = power; i < n; i++) f[i] *= unit / (vm_real)power;
}

/* Writes the coefficients of the series of f'/f to ratio. The array f has n coefficients, ratio gets n - 1. */
VM_API void vmi_series_log_rate(int n, const vm_real *f, vm_real *ratio)
{
    int i, j;
    for (i = 0; i < n - 1; i++) {
        vm_real sum = (vm_real)(i + 1) * f[i + 1];
        for (j = 1; j <= i; j++) sum -= f[j] * ratio[i - j];
        ratio[i] = sum / f[0];
    }
}

/* Writes the first n coefficients of the series of 1/f to inverse. */
VM_API void vmi_series_inverse(int n, const vm_real *f, vm_real *inverse)
{
    int i, j;
    inverse[0] = 1 / f[0];
    for (i = 1; i < n; i++) {
        vm_real sum = 0;
        for (j = 1; j <= i; j++) sum -= f[j] * inverse[i - j];
        inverse[i] = sum / f[0];
    }
}

/* Coefficient i of the product of the two series f and g */
VM_API vm_real vmi_series_product(int i, const vm_real *f, const vm_real *g)
{
    vm_real sum = 0;
    int j;
    for (j = 0; j <= i; j++) sum += f[j] * g[i - j];
    return sum;
}

/* -- The numbers G_k -- */

/* Fills now->G by G_0 = p^2 - a p - p' and G_(k+1) = G_k' - (k+2) (2p - a) G_k. The arrays a and p contain the first n
   coefficients of the power series in time of the rates a and p. The array a is overwritten. */
VM_API void vmi_osc_find_G(int n, vm_real *a, vm_real *p, vmi_osc_slow *now)
{
    vm_real G[VMI_LAW_ORDERS], next[VMI_LAW_ORDERS];
    int i, k, terms = n - 1;
    for (i = 0; i < n; i++) a[i] = p[i] - a[i]; /* the series of p - a */
    for (i = 0; i < terms; i++) G[i] = vmi_series_product(i, p, a) - (vm_real)(i + 1) * p[i + 1];
    for (i = 0; i < n; i++) a[i] += p[i]; /* the series of 2 p - a */
    for (k = 0; k < VMI_OSC_G; k++) {
        now->G[k] = G[0];
        terms--;
        for (i = 0; i < terms; i++)
            next[i] = (vm_real)(i + 1) * G[i + 1] - (vm_real)(k + 2) * vmi_series_product(i, a, G);
        for (i = 0; i < terms; i++) G[i] = next[i];
    }
}

/* Fills *now from the arrays m and k, which contain mass and stiffness with their derivatives up to the sixth, as
   vmi_law_scaled_derivatives writes them in the unit law_unit, s. Both arrays are overwritten. The argument `unit`, s,
   becomes the field `unit` of *now. */
VM_API void vmi_osc_slow_of(const vm_osc_problem *o, vm_real *m, vm_real *k, vm_real law_unit, vm_real unit,
                            vmi_osc_slow *now)
{
    const int n = VMI_LAW_ORDERS - 1;
    vm_real m_rate[VMI_LAW_ORDERS], k_rate[VMI_LAW_ORDERS], inverse[VMI_LAW_ORDERS];
    int i;
    now->m = m[0];
    now->k = k[0];
    now->unit = unit;
    vmi_series_of_derivatives(VMI_LAW_ORDERS, unit / law_unit, m);
    vmi_series_of_derivatives(VMI_LAW_ORDERS, unit / law_unit, k);
    vmi_series_log_rate(VMI_LAW_ORDERS, m, m_rate);
    vmi_series_log_rate(VMI_LAW_ORDERS, k, k_rate);
    vmi_series_inverse(n, m, inverse);
    for (i = 0; i < n; i++) {
        const vm_real a = o->reactive * m_rate[i] + o->damping * unit * inverse[i];
        m[i] = a;
        k[i] = (k_rate[i] + 2 * a - m_rate[i]) / (o->alpha + 3);
    }
    now->bend = VM_FABS(m_rate[1]) / unit / unit;
    now->a = m[0] / unit;
    now->k_rate = k_rate[0] / unit;
    now->p = k[0] / unit;
    vmi_osc_find_G(n, m, k, now);
}

/* Fills *now for the time t. Where derivatives of the laws jump at t, side = 1 means the derivatives after t, and side
   = -1 the derivatives before t. The comment of vmi_law_derivatives explains the argument `length`, s. The argument
   `unit`, s, becomes the field `unit` of *now. Returns VM_OK, or the status of a law that fails: VM_BAD_MASS or
   VM_BAD_STIFFNESS if the law is not positive, VM_DOMAIN if it has no value at t, VM_NOT_FINITE if a number is infinite
   or NaN. */
VM_API int vmi_osc_slow_at(const vm_osc_problem *o, vm_real t, int side, vm_real length, vm_real unit,
                           vmi_osc_slow *now)
{
    const vm_real law_unit = vmi_law_unit(unit);
    vm_real m[VMI_LAW_ORDERS], k[VMI_LAW_ORDERS];
    int status = vmi_law_scaled_derivatives(&o->mass, VM_BAD_MASS, t, side, length, law_unit, m);
    if (!status)
        status = vmi_law_scaled_derivatives(&o->stiffness, VM_BAD_STIFFNESS, t, side, length, law_unit, k);
    if (!status) vmi_osc_slow_of(o, m, k, law_unit, unit, now);
    return status;
}

/* -- Amplitude and phase -- */

/* The reduced state of the oscillator: the amplitude A and the phase psi that follow from the position x and from V =
   x' + p x, where p is the rate of the top of this file */
typedef struct VM_TAG(vmi_osc_reduced) {
    vm_real A;   /* amplitude, m */
    vm_real psi; /* Ateb phase */
    vm_real W;   /* rate of the phase at the amplitude A if mass and stiffness are constant, 1/s */
} vmi_osc_reduced;

/* Returns the reduced state that belongs to the position x and the velocity v at the time for which *now was filled. */
VM_API vmi_osc_reduced vmi_osc_reduce(const vmi_osc_slow *now, vm_real alpha, vm_real x, vm_real v)
{
    const vm_real omega = VM_SQRT(now->k / now->m);
    vmi_osc_reduced r;
    vm_osc_amplitude_phase(x, v + now->p * x, omega, alpha, &r.A, &r.psi);
    r.W = r.A == 0 ? 0 : vmi_osc_rate(r.A, omega, alpha);
    return r;
}

/* Returns the state that vmi_osc_reduce returns, but computes it from omega = sqrt(k/m) and V = v + p x, for alpha >=
   0. The code of this function is shorter and slower than that of vmi_osc_reduce. vm_osc_closed_init and
   vm_osc_plan_init both use this function, so that their results agree. */
VM_API vmi_osc_reduced vmi_osc_reduce_by_series(vm_real omega, vm_real alpha, vm_real x, vm_real V)
{
    const vm_real n = alpha + 1, s = 0 - V / (VM_SQRT(2 / n) * omega); /* B^(n/2), where vmax(B) = |V|; see
                                                                          vm_osc_amplitude_phase */
    const vm_real B = vmi_pow_checked(VM_FABS(s), 2 / n);
    vmi_osc_reduced r = {0, 0, 0};
    vmi_ateb c;
    r.A = vmi_osc_power_norm(VM_FABS(x), B, n);
    if (r.A == 0) return r;
    r.psi = VM_NAN;
    if (!vmi_ateb_has_phase(alpha)) return r;
    vmi_ateb_fine_constants(&c, alpha);
    r.psi = vmi_ateb_phase_by_series(c.quarter, alpha, VM_COPYSIGN(vmi_pow_checked(B / r.A, n / 2), s), x / r.A);
    r.W = vmi_osc_rate(r.A, omega, alpha);
    return r;
}

/* Writes the position x and the velocity v of a reduced state. This is the inverse of vmi_osc_reduce. p is the rate at
   the top of this file; sa and ca are the Ateb functions of the state's phase. */
VM_API void vmi_osc_unreduce(const vmi_osc_reduced *r, vm_real p, vm_real alpha, vm_real sa, vm_real ca, vm_real *x,
                             vm_real *v)
{
    *x = r->A * ca;
    *v = -2 / (alpha + 1) * r->W * r->A * sa - p * *x;
}

/* Writes the numbers E_k = G_k/W^(k+2), k = 0 ... 4, of a reduced state whose phase has the rate W. */
VM_API void vmi_osc_disturbance(const vmi_osc_slow *now, vm_real W, vm_real *E)
{
    const vm_real radian = 1 / (W * now->unit);
    vm_real power = radian * radian;
    int k;
    for (k = 0; k < VMI_OSC_G; k++) {
        E[k] = now->G[k] * power;
        power *= radian;
    }
}

#endif
