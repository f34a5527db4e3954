/* oscillators/odd_laws.h - a vibration under an odd elastic force, and its slowly changing numbers at one time

   The equation of motion is in oscillators/odd_motion.h, which also shows the shortest useful call. This file reads the
   laws of mass, stiffness and damping at one time, and computes from them the numbers that averaging needs.

   Where k1 and k3 of Duffing's force follow laws of their own (vm_duffing_force_of_laws), the shape of the force
   changes with time. A new coordinate y = x/s makes the shape constant, where s(t)^2 is the ratio k1/k3 divided by the
   value of this ratio at t = 0. The coordinate y obeys, without any approximation,
       m y'' + K F(y) + (reactive m' + b + 2 m s'/s) y' + m G y = 0
   with F(y) = k1(0) y + k3(0) y^3, K(t) = k(t) k1(t)/k1(0) and G = s''/s + (s'/s) (reactive m' + b)/m. The change of
   shape therefore acts like additional damping and like a weak linear spring. The stiffness m G of this spring is of
   second order in the rates of the laws. Where k1 or k3 is 0 all the time, s is 1. Where k1 or k3 is 0 at some times
   only, there is no such s; then the equation of motion is integrated numerically. Guide: docs/duffing.md. Tests:
   tests/test_duffing_laws.c. */
#ifndef VARMASS_OSCILLATORS_ODD_LAWS_H
#define VARMASS_OSCILLATORS_ODD_LAWS_H

#include "../base/real.h"
#include "../base/status.h"
#include "laws.h"
#include "odd_force.h"
#include "reduction.h"

/* A vibration under an odd elastic force, and its state at t = 0 */
typedef struct VM_TAG(vm_odd_problem) {
    vm_odd_force force; /* F(x), N, by vm_duffing_force, vm_duffing_force_of_laws or vm_odd_force_user */
    vm_law mass;        /* mass m(t), kg, positive */
    vm_law stiffness;   /* factor k(t) of the whole elastic force, a pure number, positive */
    vm_law damping;     /* damping b(t), kg/s; positive takes energy out */
    vm_real reactive;   /* share of the full reactive force: 1 where mass that joins or leaves is at rest, 0 where this
                           mass has the body's own velocity; numbers between are allowed */
    vm_real x, v;       /* position, m, and velocity, m/s, at t = 0 */
} vm_odd_problem;

/* -- All laws of a problem -- */

/* Writes pointers to the laws of a problem, and for each law the status that is returned if the law is not positive
   (VM_OK if the law may have any sign). Returns the number of laws. */
enum { VMI_ODD_LAWS = 5 };
VM_API int vmi_odd_all_laws(const vm_odd_problem *o, const vm_law **laws, int *if_not_positive)
{
    laws[0] = &o->mass;
    laws[1] = &o->stiffness;
    laws[2] = &o->damping;
    if_not_positive[0] = VM_BAD_MASS;
    if_not_positive[1] = VM_BAD_STIFFNESS;
    if_not_positive[2] = VM_OK;
    if (!o->force.laws) return 3;
    laws[3] = &o->force.laws[0];
    laws[4] = &o->force.laws[1];
    if_not_positive[3] = VM_OK;
    if_not_positive[4] = VM_OK;
    return VMI_ODD_LAWS;
}

/* Returns 1 if constructors made all laws of a problem, else 0. */
VM_API int vmi_odd_has_laws(const vm_odd_problem *o)
{
    const vm_law *laws[VMI_ODD_LAWS];
    int statuses[VMI_ODD_LAWS], i;
    const int n = vmi_odd_all_laws(o, laws, statuses);
    for (i = 0; i < n; i++)
        if (!laws[i]->derivatives) return 0;
    return 1;
}

/* Returns the first time between t and t_end at which the table of any law has a point, or t_end if there is no such
   time. */
VM_API vm_real vmi_odd_next_knot(const vm_odd_problem *o, vm_real t, vm_real t_end)
{
    const vm_law *laws[VMI_ODD_LAWS];
    int statuses[VMI_ODD_LAWS], i;
    const int n = vmi_odd_all_laws(o, laws, statuses);
    for (i = 0; i < n; i++) t_end = vmi_law_next_knot(laws[i], t, t_end);
    return t_end;
}

/* Checks all laws of a problem between the times 0 and t. If several laws are wrong, it returns the status that comes
   first in the table of errors in src/base/status.h. */
VM_API int vmi_odd_check_laws(const vm_odd_problem *o, vm_real t)
{
    const vm_law *laws[VMI_ODD_LAWS];
    int statuses[VMI_ODD_LAWS], i, status = VM_OK;
    const int n = vmi_odd_all_laws(o, laws, statuses);
    for (i = 0; i < n; i++) status = vmi_first_error(status, vmi_law_check(laws[i], statuses[i], t));
    return status;
}

/* -- The laws at one time -- */

/* Mass, stiffness and damping at one time, as the equation of motion needs them */
typedef struct VM_TAG(vmi_odd_now) {
    vm_real m, k, b; /* mass, factor of the elastic force, and damping */
    vm_real m_rate;  /* dm/dt, kg/s */
    vm_real k1, k3;  /* coefficients of x and x^3 of Duffing's force if they follow laws; else unused */
} vmi_odd_now;

/* Reads the laws at t. Where the rate of a law jumps at t, side = 1 means the rate after t, and side = -1 the rate
   before t. */
VM_API int vmi_odd_read_laws(const vm_odd_problem *o, vm_real t, int side, vmi_odd_now *now)
{
    vm_real m[VMI_LAW_ORDERS], k[VMI_LAW_ORDERS], b[VMI_LAW_ORDERS], k1[VMI_LAW_ORDERS], k3[VMI_LAW_ORDERS];
    int status = vmi_law_derivatives(&o->mass, VM_BAD_MASS, t, side, 0, m);
    k1[0] = 0;
    k3[0] = 0;
    if (!status) status = vmi_law_derivatives(&o->stiffness, VM_BAD_STIFFNESS, t, side, 0, k);
    if (!status) status = vmi_law_derivatives(&o->damping, VM_OK, t, side, 0, b);
    if (!status && o->force.laws) status = vmi_law_derivatives(&o->force.laws[0], VM_OK, t, side, 0, k1);
    if (!status && o->force.laws) status = vmi_law_derivatives(&o->force.laws[1], VM_OK, t, side, 0, k3);
    if (status) return status;
    now->m = m[0];
    now->k = k[0];
    now->b = b[0];
    now->m_rate = m[1];
    now->k1 = k1[0];
    now->k3 = k3[0];
    return VM_OK;
}

/* Writes the force F(x) to *f, with the coefficients k1 and k3 of the present time if they follow laws. */
VM_API int vmi_odd_elastic(const vm_odd_problem *o, const vmi_odd_now *now, vm_real x, vm_real *f)
{
    if (!o->force.laws) return o->force.at(&o->force, x, f);
    *f = x * (now->k1 + now->k3 * (x * x));
    return VM_IS_FINITE(*f) ? VM_OK : VM_NOT_FINITE;
}

/* -- The shape of the force -- */

/* ratio1 and ratio3 are the coefficients k1 and k3 of Duffing's force, divided by their values at t = 0. rate1 and
   rate3 are power series, in the variable time/unit, of the relative rates of change k1'/k1 and k3'/k3, multiplied by
   the time `unit`. For constant k1 or k3 the ratio is 1 and the rate 0. */
typedef struct VM_TAG(vmi_odd_shape) {
    vm_real ratio1, ratio3;
    vm_real rate1[4], rate3[4];
} vmi_odd_shape;

/* Writes the ratio and the rates of vmi_odd_shape for one coefficient, k1 or k3. `law` is the law of the coefficient,
   and `first` the value of the law at t = 0. The first `orders` terms of the power series of the rate are written. The
   comment of vmi_law_scaled_derivatives explains side, length and unit. Returns VM_NO_LAW where the law is 0 at some
   times but not at all times. */
VM_API int vmi_odd_coefficient(const vm_law *law, vm_real first, vm_real t, int side, vm_real length, vm_real unit,
                               int orders, vm_real *ratio, vm_real *rates)
{
    vm_real f[VMI_LAW_ORDERS];
    int i, status = vmi_law_scaled_derivatives(law, VM_OK, t, side, length, unit, f);
    if (status) return status;
    *ratio = 1;
    for (i = 0; i < orders; i++) rates[i] = 0;
    if (first == 0) return f[0] == 0 && f[1] == 0 ? VM_OK : VM_NO_LAW;
    *ratio = f[0] / first;
    if (!(*ratio > 0)) return VM_NO_LAW;
    if (orders == 1) {
        rates[0] = f[1] / f[0];
        return VM_OK;
    }
    vmi_series_of_derivatives(4, 1, f);
    vmi_series_log_rate(4, f, rates);
    return VM_OK;
}

/* Reads the shape of Duffing's force k1 x + k3 x^3 at t. With orders = 1 the function writes only the relative rates at
   t, with orders = 4 their power series in time; `unit`, s, is the unit of the rates. If one of k1 and k3 is 0 all the
   time, its ratio and its rates become those of the other coefficient, so that the factor s at the top of this file is
   1. */
VM_API int vmi_odd_shape_at(const vm_odd_problem *o, vm_real t, int side, vm_real length, vm_real unit, int orders,
                            vmi_odd_shape *shape)
{
    const vm_odd_force *force = &o->force;
    int i, status;
    shape->ratio1 = 1;
    shape->ratio3 = 1;
    for (i = 0; i < 4; i++) {
        shape->rate1[i] = 0;
        shape->rate3[i] = 0;
    }
    if (!force->laws) return VM_OK;
    status = vmi_odd_coefficient(&force->laws[0], force->k1, t, side, length, unit, orders, &shape->ratio1,
                                 shape->rate1);
    if (!status)
        status = vmi_odd_coefficient(&force->laws[1], force->k3, t, side, length, unit, orders, &shape->ratio3,
                                     shape->rate3);
    if (status) return status;
    if (force->k1 == 0) {
        shape->ratio1 = shape->ratio3;
        for (i = 0; i < orders; i++) shape->rate1[i] = shape->rate3[i];
    }
    if (force->k3 == 0) {
        shape->ratio3 = shape->ratio1;
        for (i = 0; i < orders; i++) shape->rate3[i] = shape->rate1[i];
    }
    return VM_OK;
}

/* -- What the averaging needs -- */

/* Mass, stiffness and damping in the equation of y = x/s at the top of this file, and the rates that follow from them,
   at one time */
typedef struct VM_TAG(vmi_odd_rates) {
    vm_real m, k, b;       /* mass m, stiffness factor K and damping b */
    vm_real loss;          /* (reactive m' + b)/m, 1/s */
    vm_real speed;         /* sqrt(K/m), 1/s: how fast the new time of orbit_ripple.h grows with t */
    vm_real turn;          /* relative rate of change of `speed`, 1/s */
    vm_real h;             /* the damping h of orbit_ripple.h, multiplied by `speed`, 1/s */
    vm_real ratio1, ratio3; /* k1 and k3 divided by their values at t = 0; 1 where they are constant */
    vm_real scale;         /* the factor s(t) at the top of this file */
    vm_real scale_rate;    /* s'/s of this factor, 1/s */
} vmi_odd_rates;

/* Computes the fields of *r at t. Where the rate of a law jumps at t, side = 1 means the rate after t, and side = -1
   the rate before t. Returns VM_NO_LAW where the shape of the force cannot be made constant. */
VM_API int vmi_odd_rates_at(const vm_odd_problem *o, vm_real t, int side, vmi_odd_rates *r)
{
    vm_real m[VMI_LAW_ORDERS], k[VMI_LAW_ORDERS], b[VMI_LAW_ORDERS];
    vmi_odd_shape shape;
    int status = vmi_law_derivatives(&o->mass, VM_BAD_MASS, t, side, 0, m);
    if (!status) status = vmi_law_derivatives(&o->stiffness, VM_BAD_STIFFNESS, t, side, 0, k);
    if (!status) status = vmi_law_derivatives(&o->damping, VM_OK, t, side, 0, b);
    if (!status) status = vmi_odd_shape_at(o, t, side, 0, 1, 1, &shape);
    if (status) return status;
    r->m = m[0];
    r->k = k[0] * shape.ratio1;
    r->b = b[0];
    r->loss = (o->reactive * m[1] + b[0]) / m[0];
    r->speed = VM_SQRT(r->k / m[0]);
    r->turn = (k[1] / k[0] + shape.rate1[0] - m[1] / m[0]) / 2;
    r->ratio1 = shape.ratio1;
    r->ratio3 = shape.ratio3;
    r->scale = VM_SQRT(shape.ratio1 / shape.ratio3);
    r->scale_rate = (shape.rate1[0] - shape.rate3[0]) / 2;
    r->h = (r->turn + r->loss) / 2 + r->scale_rate;
    return VM_OK;
}

/* The damping h of orbit_ripple.h, and its first two derivatives h1 and h2 with respect to the new time of that file,
   which grows at the rate sqrt(K/m). spring is the stiffness m G of the weak linear spring at the top of this file,
   divided by K; spring1 is the derivative of spring with respect to the new time. */
typedef struct VM_TAG(vmi_odd_slow) {
    vm_real h, h1, h2;
    vm_real spring, spring1;
} vmi_odd_slow;

/* Computes the fields of *slow at t. `length`, in seconds, is needed for the derivatives of laws that are functions of
   the user (see vmi_law_scaled_derivatives); in this time the phase grows by about 16. All rates are computed in a unit
   of about length/16, but of at most 1 s. Where a derivative of a law jumps at t, side = 1 means the derivative after
   t, and side = -1 the derivative before t. */
VM_API int vmi_odd_slow_at(const vm_odd_problem *o, vm_real t, int side, vm_real length, vmi_odd_slow *slow)
{
    enum { TERMS = 4 };
    const vm_real unit = vmi_law_unit(length / 16);
    vm_real m[VMI_LAW_ORDERS], k[VMI_LAW_ORDERS], b[VMI_LAW_ORDERS], ln_m[TERMS], ln_k[TERMS], inverse[TERMS];
    vm_real h[3], turn[2], scale[3], loss[3], speed, rate, rate_rate, G, G_rate;
    vmi_odd_shape shape;
    int i, status = vmi_law_scaled_derivatives(&o->mass, VM_BAD_MASS, t, side, length, unit, m);
    if (!status) status = vmi_law_scaled_derivatives(&o->stiffness, VM_BAD_STIFFNESS, t, side, length, unit, k);
    if (!status) status = vmi_law_scaled_derivatives(&o->damping, VM_OK, t, side, length, unit, b);
    if (!status) status = vmi_odd_shape_at(o, t, side, length, unit, TERMS, &shape);
    if (status) return status;
    speed = VM_SQRT(k[0] * shape.ratio1 / m[0]) * unit;
    vmi_series_of_derivatives(TERMS, 1, m);
    vmi_series_of_derivatives(TERMS, 1, k);
    vmi_series_of_derivatives(TERMS, 1, b);
    vmi_series_log_rate(TERMS, m, ln_m);
    vmi_series_log_rate(TERMS, k, ln_k);
    vmi_series_inverse(TERMS, m, inverse);
    for (i = 0; i < 3; i++) {
        ln_k[i] += shape.rate1[i];
        scale[i] = (shape.rate1[i] - shape.rate3[i]) / 2;
        loss[i] = o->reactive * ln_m[i] + vmi_series_product(i, b, inverse) * unit;
        h[i] = ((ln_k[i] - ln_m[i]) / 2 + loss[i]) / 2 + scale[i];
    }
    for (i = 0; i < 2; i++) turn[i] = (ln_k[i] - ln_m[i]) / 2;
    rate = h[1] - turn[0] * h[0];
    rate_rate = 2 * h[2] - turn[1] * h[0] - turn[0] * h[1];
    G = scale[1] + scale[0] * (scale[0] + loss[0]);
    G_rate = 2 * (scale[2] + scale[0] * scale[1]) + scale[1] * loss[0] + scale[0] * loss[1];
    slow->h = h[0] / speed;
    slow->h1 = rate / (speed * speed);
    slow->h2 = (rate_rate - 2 * turn[0] * rate) / (speed * speed * speed);
    slow->spring = G / (speed * speed);
    slow->spring1 = (G_rate - 2 * turn[0] * G) / (speed * speed * speed);
    return VM_OK;
}

#endif
