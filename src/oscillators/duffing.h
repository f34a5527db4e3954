/* oscillators/duffing.h - Duffing's oscillator, with the elastic force k1 x + k3 x^3

   With constant mass the equation is x'' + c1 x + c3 x^3 = 0, where c1 = k1/m and c3 = k3/m. Its exact motion is
   written with Jacobi's functions, for each sign of the coefficients:
     c1 >= 0, c3 >= 0   hardening spring: every motion is a vibration around 0, x = A cn
     c1 > 0, c3 < 0     softening spring: vibrations around 0 with A^2 < -c1/c3; in larger motions |x| goes to infinity
     c1 < 0, c3 > 0     two wells, at x^2 = -c1/c3: outer vibrations around both, x = A cn, and inner ones in one of
                        them, x = A dn; between these two kinds of motion is the separatrix x = A/cosh(lambda t), whose
                        period is infinite
       vm_real x, v;
       vm_real T = vm_duffing_period(2, 1, VM_C(0.5)); // x'' + x + x^3/2 = 0 from rest at x = 2 m
       vm_duffing_exact_from(T / 8, 2, 0, 1, VM_C(0.5), &x, &v);
   If mass, stiffness or damping varies slowly, pass vm_duffing_force(k1, k3) to the functions of
   oscillators/odd_motion.h. If k1 and k3 follow two different laws of time, pass vm_duffing_force_of_laws.
   Guide: docs/duffing.md. Tests: tests/test_duffing.c. */
#ifndef VARMASS_OSCILLATORS_DUFFING_H
#define VARMASS_OSCILLATORS_DUFFING_H

#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/status.h"
#include "../base/sums.h"
#include "../base/words.h"
#include "../jacobi/functions.h"
#include "../jacobi/integrals.h"
#include "../jacobi/means.h"
#include "../jacobi/third_kind.h"
#include "duffing_ripple.h"
#include "odd_force.h"

/* -- The orbit through a state -- */

/* Writes the force k1 x + k3 x^3 to *f. */
VM_API int vmi_duffing_at(const vm_odd_force *force, vm_real x, vm_real *f)
{
    *f = x * (force->k1 + force->k3 * (x * x));
    return VM_IS_FINITE(*f) ? VM_OK : VM_NOT_FINITE;
}

/* Returns d = A^2 - x^2, the square of the amplitude A minus x^2. The number d solves c3 d^2/2 + slope d = v^2, where
   slope = c1 + c3 x^2. Returns NaN if the motion goes to infinity, and if slope^2 or c3 v^2 overflows. */
VM_API vm_real vmi_duffing_above(vm_real c3, vm_real slope, vm_real v)
{
    const vm_real root = VM_SQRT(slope * slope + 2 * c3 * (v * v));
    if (!VM_IS_FINITE(root)) return VM_NAN;
    if (v == 0 && slope >= 0) return 0;
    if (slope >= 0) return 2 * (v * v) / (slope + root);
    if (c3 > 0) return (root - slope) / c3;
    return VM_NAN;
}

/* Returns c3 s/c1^2 for a state of a spring with two wells, where s = v^2 + c1 x^2 + c3 x^4/2 is twice the energy per
   unit mass. The result is 0 on the separatrix, positive outside it and negative in a well. No product underflows
   before the result does. */
VM_API vm_real vmi_duffing_energy_ratio(const vm_odd_force *force, vm_real x, vm_real v)
{
    const vm_real k1 = force->k1, k3 = force->k3, ratio = k3 / k1;
    return ratio * v * (v / k1) + ratio * x * x * ((k1 + k3 * (x * x) / 2) / k1);
}

/* Returns 1 - m of an orbit from the result q of vmi_duffing_energy_ratio. With r = sqrt(1 + 2 q) it is q/(r (r + 1))
   around both wells, and -2 q/(r + 1)^2 in one of them. It keeps all digits where x and v are tiny. The size of the
   orbit does not: there it rounds to the size of the separatrix. Returns 1 far from the separatrix, which means that 1
   - m is not known. */
VM_API vm_real vmi_duffing_m1(vm_real q)
{
    const vm_real r = VM_SQRT(vmi_larger(1 + 2 * q, 0));
    if (!(q < 2)) return 1;
    if (q > 0) return q / (r * (r + 1));
    return -2 * q / ((r + 1) * (r + 1));
}

/* Writes the size and place of the orbit (oscillators/odd_force.h) that contains the state (x, v). With two wells it
   writes 1 - m, too, and the orbit lies in one well if its energy is not above the energy of a body at rest at x = 0.
   Returns VM_NO_LAW if the motion goes to infinity. */
VM_API int vmi_duffing_through(const vm_odd_force *force, vm_real x, vm_real v, vmi_orbit *orbit)
{
    const vm_real k1 = force->k1, k3 = force->k3, slope = k1 + k3 * (x * x);
    vm_real above, q = 2; /* far from a separatrix */
    if (k1 < 0 && k3 > 0) q = vmi_duffing_energy_ratio(force, x, v);
    orbit->force = force;
    orbit->place = VMI_ORBIT_AROUND_0;
    orbit->m1 = vmi_duffing_m1(q);
    if (q <= 0 && x != 0) {
        const vm_real to_rest = slope / k3; /* x^2 minus its value -k1/k3 at the place of rest in the well */
        orbit->size = VM_SQRT(to_rest * to_rest + 2 * (v * v) / k3);
        if (x > 0) orbit->place = VMI_ORBIT_RIGHT;
        else orbit->place = VMI_ORBIT_LEFT;
        return VM_OK;
    }
    orbit->size = 0;
    if (x == 0 && v == 0) return VM_OK;
    above = vmi_duffing_above(k3, slope, v);
    if (!(above >= 0) || !VM_IS_FINITE(above)) return VM_NO_LAW;
    orbit->size = VM_FABS(x);
    if (above > 0) orbit->size = VM_SQRT(x * x + above);
    return VM_OK;
}

/* -- The shape of an orbit -- */

/* VMI_DUFFING_CLOSE(m1) is 1 for an orbit next to the separatrix, where 1 - m loses digits if the size gives it. */
#define VMI_DUFFING_CLOSE(m1) ((m1) < VM_C(0.25))

/* Returns 1 if an orbit of size > 0 is the separatrix, else 0. The separatrix is the motion x = A/cosh(lambda t), which
   goes from x = 0 to x = A and back to x = 0 in infinite time. An orbit whose 1 - m is so small that numbers of this
   size lose digits counts as the separatrix. */
VM_API int vmi_duffing_is_separatrix(const vmi_orbit *orbit)
{
    return orbit->m1 < VM_MIN / VM_EPSILON;
}

/* Returns 1 - m of an orbit. by_size was computed from the orbit's size. `known` is the field m1 of the orbit, which
   vmi_duffing_m1 may have computed from the energy. Close to the separatrix `known` has more correct digits, and is
   returned if the two agree to rounding errors. If they do not agree, the size was changed after `known` was computed,
   and by_size is returned. */
VM_API vm_real vmi_duffing_better_m1(vm_real by_size, vm_real known)
{
    if (VMI_DUFFING_CLOSE(known) && VM_FABS(by_size - known) <= 16 * VM_EPSILON) return known;
    return by_size;
}

/* Writes the means C2 and C4 of cn^2 and cn^4 to an orbit whose field m1 is set, where m = 1 - m1. Close to the
   separatrix 1 - m, computed from m, has fewer correct digits than m1. There the means are computed from m1, by the
   formulas of jacobi_cn_means. */
VM_API void vmi_duffing_means(vmi_orbit *orbit, vm_real m)
{
    const vm_real m1 = orbit->m1;
    vm_real C2, C4, C6;
    jacobi_cn_means(m, &C2, &C4, &C6);
    if (VMI_DUFFING_CLOSE(m1)) {
        C2 = vmi_mean_from_K(m1, vmi_log_4(m1, 0));
        C4 = C2 - (C2 - m1 / m * (1 - 2 * C2)) / 3;
    }
    orbit->C2 = C2;
    orbit->C4 = C4;
}

/* Computes all other fields of an orbit around 0 from its size, the amplitude A. The motion is x = A cn(lambda t | m)
   with lambda^2 = c1 + c3 A^2 and 1 - m = (c1 + c3 A^2/2)/lambda^2. For c3 < 0 the parameter m is negative. */
VM_API int vmi_duffing_complete_outer(vmi_orbit *orbit)
{
    const vm_real k1 = orbit->force->k1, k3 = orbit->force->k3, square = orbit->size * orbit->size;
    const vm_real lambda2 = k1 + k3 * square;
    const vm_real m1 = vmi_duffing_better_m1((k1 + k3 * square / 2) / lambda2, orbit->m1);
    const vm_real m = k3 * square / (2 * lambda2);
    if (!(lambda2 > 0) || !(m1 > 0)) return VM_NO_LAW;
    orbit->span = VM_PI / 2;
    orbit->lambda = VM_SQRT(lambda2);
    orbit->m1 = m1;
    vmi_duffing_means(orbit, m);
    orbit->w = VM_PI / 2 * orbit->lambda / jacobi_K_m1(m1);
    orbit->j = square * lambda2 * (m1 * (1 - orbit->C2) + m * (orbit->C2 - orbit->C4)) / orbit->w;
    orbit->energy_slope = orbit->size * lambda2;
    orbit->swing = orbit->size;
    orbit->vmax = orbit->size * VM_SQRT(k1 + k3 * square / 2);
    if (k1 < 0) orbit->vmax = lambda2 / VM_SQRT(2 * k3); /* the velocity at x^2 = -k1/k3, where the force is 0 */
    return VM_OK;
}

/* Computes all other fields of an orbit in a well from its size. The place of rest in the well is x = sqrt(rest), where
   rest = -c1/c3. The motion is x = A dn(lambda t | m) with A^2 = rest + size, lambda^2 = c3 A^2/2 and 1 - m = (rest -
   size)/A^2. */
VM_API int vmi_duffing_complete_inner(vmi_orbit *orbit)
{
    const vm_real k3 = orbit->force->k3, rest = -orbit->force->k1 / k3, size = orbit->size;
    const vm_real A = VM_SQRT(rest + size), B = VM_SQRT(vmi_larger(rest - size, 0));
    const vm_real m1 = vmi_duffing_better_m1((rest - size) / (rest + size), orbit->m1);
    const vm_real m = 2 * size / (rest + size);
    if (!(m1 > 0)) return VM_NO_LAW;
    orbit->span = VM_PI;
    orbit->lambda = A * VM_SQRT(k3 / 2);
    orbit->m1 = m1;
    vmi_duffing_means(orbit, m);
    orbit->w = VM_PI * orbit->lambda / jacobi_K_m1(m1);
    /* the mean of v^2 = 2 k3 size^2 sn^2 cn^2, divided by w */
    orbit->j = 2 * size * size * k3 * (orbit->C2 - orbit->C4) / orbit->w;
    orbit->energy_slope = k3 * size / 2;
    orbit->swing = size / (A + B); /* (A - B)/2, where A is the largest |x| and B the smallest |x| */
    orbit->vmax = size * VM_SQRT(k3 / 2);
    return VM_OK;
}

/* Computes all other fields of an orbit from its place and its size > 0. Returns VM_NO_LAW on a separatrix and where
   the motion goes to infinity. */
VM_API int vmi_duffing_complete(vmi_orbit *orbit)
{
    int status;
    if (vmi_duffing_is_separatrix(orbit)) return VM_NO_LAW;
    if (orbit->place == VMI_ORBIT_AROUND_0) status = vmi_duffing_complete_outer(orbit);
    else status = vmi_duffing_complete_inner(orbit);
    if (!status && !(VM_IS_FINITE(orbit->w) && VM_IS_FINITE(orbit->j))) status = VM_NO_LAW;
    return status;
}

/* Writes the point of an orbit at the angle theta. Around 0 it has x = A cos(theta), where A is the amplitude; in a
   well it has x^2 = rest^2 + size cos(2 theta), where rest^2 = -c1/c3. */
VM_API void vmi_duffing_point(const vmi_orbit *orbit, vm_real theta, vmi_orbit_point *point)
{
    const vm_real k1 = orbit->force->k1, k3 = orbit->force->k3, size = orbit->size;
    vm_real sine, cosine;
    vmi_sincos(theta, &sine, &cosine);
    if (orbit->place == VMI_ORBIT_AROUND_0) {
        const vm_real share = 1 + cosine * cosine, g = k1 + k3 * (size * size) * share / 2;
        point->x = size * cosine;
        point->v = -size * sine * VM_SQRT(g);
        point->x_size = cosine;
        point->slowness = 1 / VM_SQRT(g);
        point->slowness_size = -point->slowness * (k3 * size * share / (2 * g));
    } else {
        const vm_real cosine2 = 1 - 2 * sine * sine, x = VM_SQRT(-k1 / k3 + size * cosine2), root = VM_SQRT(k3 / 2);
        point->x = x;
        point->v = -2 * size * sine * cosine * root;
        point->x_size = cosine2 / (2 * x);
        point->slowness = 1 / (x * root);
        point->slowness_size = -point->slowness * point->x_size / x;
    }
}

/* Returns u, the incomplete elliptic integral of the first kind, from s2 = sn^2(u), c2 = cn^2(u) and d2 = dn^2(u),
   where 0 <= u <= K. */
VM_API vm_real vmi_duffing_argument(vm_real s2, vm_real c2, vm_real d2)
{
    return VM_SQRT(s2) * vmi_carlson_rf(vmi_two(c2, 0), vmi_two(d2, 0), vmi_two(1, 0)).hi;
}

/* The argument u of Jacobi's functions at the state (x, v) of an orbit whose fields are all set */
VM_API vm_real vmi_duffing_argument_of(const vmi_orbit *orbit, vm_real x, vm_real v)
{
    const vm_real k1 = orbit->force->k1, k3 = orbit->force->k3, size = orbit->size, m1 = orbit->m1;
    vm_real s2, c2, u;
    if (orbit->place == VMI_ORBIT_AROUND_0) {
        const vm_real g = k1 + k3 * (x * x + size * size) / 2; /* v^2 = g (A^2 - x^2) */
        c2 = vmi_smaller(x * x / (size * size), 1);
        s2 = vmi_smaller(v * v / (g * (size * size)), 1);
        if (VMI_DUFFING_CLOSE(m1)) { /* the same numbers, with more digits: dn^2 = m1 + m cn^2 */
            const vm_real c = x / size, s_dn = v / (size * orbit->lambda);
            c2 = vmi_smaller(c * c, 1);
            s2 = vmi_smaller(s_dn * s_dn / (m1 + (1 - m1) * c2), 1);
        }
    } else {
        const vm_real cosine = vmi_clamp((x * x + k1 / k3) / size, -1, 1); /* cosine of the angle 2 theta */
        const vm_real sine = v / (size * VM_SQRT(k3 / 2)), angle = vmi_atan2(VM_FABS(sine), cosine) / 2;
        vm_real s, c;
        vmi_sincos(angle, &s, &c);
        if (VMI_DUFFING_CLOSE(m1) && cosine < 0) c = sine / (2 * s); /* c is small, and sine = 2 s c */
        s2 = s * s;
        c2 = c * c;
    }
    u = vmi_duffing_argument(s2, c2, c2 + m1 * s2);
    if (orbit->place == VMI_ORBIT_AROUND_0 && x < 0) u = 2 * jacobi_K_m1(m1) - u;
    if (v * (orbit->place == VMI_ORBIT_LEFT ? -1 : 1) > 0) u = -u;
    return u;
}

/* Writes the state (x, v) of an orbit at the argument u of Jacobi's functions. */
VM_API void vmi_duffing_at_argument(const vmi_orbit *orbit, vm_real u, vm_real *x, vm_real *v)
{
    vm_real sn, cn, dn;
    jacobi_sncndn_m1(u, orbit->m1, &sn, &cn, &dn);
    if (orbit->place == VMI_ORBIT_AROUND_0) {
        *x = orbit->size * cn;
        *v = -orbit->size * orbit->lambda * (sn * dn);
    } else {
        const vm_real k1 = orbit->force->k1, k3 = orbit->force->k3;
        const vm_real A = (vm_real)orbit->place * VM_SQRT(orbit->size - k1 / k3);
        *x = A * dn;
        *v = -(vm_real)orbit->place * orbit->size * VM_SQRT(2 * k3) * (sn * cn);
    }
}

/* Writes the phase of the state (x, v) on an orbit whose fields are all set. */
VM_API int vmi_duffing_phase(const vmi_orbit *orbit, vm_real x, vm_real v, vm_real *phi)
{
    *phi = vmi_duffing_argument_of(orbit, x, v) * (orbit->w / orbit->lambda);
    return VM_OK;
}

/* Writes the state (x, v) of an orbit at the phase phi. */
VM_API int vmi_duffing_at_phase(const vmi_orbit *orbit, vm_real phi, vm_real *x, vm_real *v)
{
    vmi_duffing_at_argument(orbit, phi * (orbit->lambda / orbit->w), x, v);
    return VM_OK;
}

/* Duffing's force without the function that computes its ripple (oscillators/orbit_ripple.h). The functions for
   constant mass do not need the ripple. So a program that uses only these functions does not contain the code for the
   ripple. */
VM_API vm_odd_force vmi_duffing_elastic(vm_real k1, vm_real k3)
{
    vm_odd_force force = vm_odd_force_user(NULL, NULL);
    force.k1 = k1;
    force.k3 = k3;
    force.at = vmi_duffing_at;
    force.orbit_through = vmi_duffing_through;
    force.complete = vmi_duffing_complete;
    force.point = vmi_duffing_point;
    force.phase = vmi_duffing_phase;
    force.at_phase = vmi_duffing_at_phase;
    return force;
}

/* Duffing's force k1 x + k3 x^3. k1 (N/m) and k3 (N/m^3) may have either sign. If neither of them is positive, there
   are no vibrations. Then, except for a body at rest at x = 0, vm_odd_period and vm_odd_action return NaN;
   vm_odd_exact_from and the routes VM_ODD_MEAN and VM_ODD_ORDER2 return VM_NO_LAW; and vm_odd_within integrates the
   motion by rk87. */
VM_API vm_odd_force vm_duffing_force(vm_real k1, vm_real k3)
{
    vm_odd_force force = vmi_duffing_elastic(k1, k3);
    force.ripple = vmi_duffing_ripple;
    return force;
}

/* Duffing's force k1(t) x + k3(t) x^3 whose coefficients follow laws of their own: laws[0] is k1, N/m, and laws[1] is
   k3, N/m^3. k1 and k3 may have either sign; the two laws must outlive the force. The force is for a vm_odd_problem
   (oscillators/odd_motion.h), whose field `stiffness`, a factor, multiplies k1 and k3. The functions for constant mass
   refuse this force with VM_NO_LAW, except for a body at rest at x = 0. If `laws` is null, all functions refuse the
   force with VM_BAD_ARGUMENT. */
VM_API vm_odd_force vm_duffing_force_of_laws(const struct VM_TAG(vm_law) *laws)
{
    vm_odd_force force = vm_duffing_force(0, 0); /* vm_odd_plan_init replaces the zeros by k1 and k3 at t = 0 */
    force.laws = laws;
    if (!laws) force.at = NULL;
    return force;
}

/* -- Constant mass: energy, period, action and exact motion -- */

/* Energy per unit mass of Duffing's oscillator, v^2/2 + c1 x^2/2 + c3 x^4/4, m^2/s^2.
   The energy stays constant during a motion. Returns NaN for arguments that are infinite or NaN. */
VM_API vm_real vm_duffing_energy(vm_real x, vm_real v, vm_real c1, vm_real c3)
{
    if (!VM_IS_FINITE(x) || !VM_IS_FINITE(v) || !VM_IS_FINITE(c1) || !VM_IS_FINITE(c3)) return VM_NAN;
    return v * v / 2 + (x * x) * (c1 / 2 + c3 * (x * x) / 4);
}

/* Exact period, s, of Duffing's oscillator x'' + c1 x + c3 x^3 = 0 from rest at x0 (m, either sign).
   For a motion in one of two wells it is the time of one vibration in this well. The period is infinite on the
   separatrix, and for c1 < 0 < c3 also where |c3/c1| x0^2 is below 2 VM_MIN/eps. The relative error is at most 8 eps
   where the two terms of c1 + c3 x0^2, and those of c1 + c3 x0^2/2, do not cancel. Returns NaN if the motion goes to
   infinity, if the body stays at rest (at x0 = 0 or x0^2 = -c1/c3), and if an argument is infinite or NaN. */
VM_API vm_real vm_duffing_period(vm_real x0, vm_real c1, vm_real c3)
{
    const vm_odd_force force = vmi_duffing_elastic(c1, c3);
    vmi_orbit orbit;
    if (!VM_IS_FINITE(x0) || !VM_IS_FINITE(c1) || !VM_IS_FINITE(c3)) return VM_NAN;
    if (vmi_duffing_through(&force, x0, 0, &orbit) || orbit.size == 0) return VM_NAN;
    if (vmi_duffing_is_separatrix(&orbit)) return VM_INFINITY;
    if (vmi_duffing_complete(&orbit)) return VM_NAN;
    return 2 * VM_PI / orbit.w;
}

/* Action, m^2/s, of Duffing's oscillator x'' + c1 x + c3 x^3 = 0 from rest at x0 (m, either sign).
   The action is the integral of v dx over a period, divided by 2 pi. If c1 and c3 change slowly, the action stays
   nearly constant. Domain and accuracy are those of vm_duffing_period, but the action is 0 for x0 = 0 and for a body at
   rest in a well, and NaN on the separatrix. */
VM_API vm_real vm_duffing_action(vm_real x0, vm_real c1, vm_real c3)
{
    const vm_odd_force force = vmi_duffing_elastic(c1, c3);
    if (!VM_IS_FINITE(c1) || !VM_IS_FINITE(c3)) return VM_NAN;
    return vm_odd_action(&force, x0);
}

/* Writes position and velocity at time t of a motion that comes from next to x = 0 along the separatrix. Near x = 0 the
   motion is linear: the sum of a part that grows as exp(lambda |t|) and a part that falls as exp(-lambda |t|). The
   growing part has the value a at t = 0. It is the beginning of A/cosh(lambda |t| - late) with late = ln(2 A/a). Let w
   be v0/lambda for t > 0 and -v0/lambda for t < 0. Next to x = 0 the growing part is a = (x0 + w)/2 and the falling
   part is (x0 - w)/2. On the separatrix x0 may be large. There w = c x0 with c = sqrt(1 - x0^2/A^2), the falling part
   is 0, and a = 2 x0/(1 + c). The formulas a = 2 (x0 + w)/(1 + c)^2 and (c x0 - w)/2 hold in both cases. */
VM_API void vmi_duffing_from_saddle(vm_real t, vm_real x0, vm_real v0, vm_real c1, vm_real c3, vm_real *x, vm_real *v)
{
    const vm_real A = VM_SQRT(-2 * c1 / c3), lambda = VM_SQRT(-c1), side = VM_COPYSIGN((vm_real)1, t);
    const vm_real c = VM_SQRT(1 - (x0 / A) * (x0 / A)), w = side * v0 / lambda, whole = lambda * VM_FABS(t);
    const vm_real a = 2 * (x0 + w) / ((1 + c) * (1 + c));
    const vm_real falling = (c * x0 - w) / 2 * vmi_exp(-whole, 0);
    vm_real tanh_t = 0, sech_t = 0, unused, rising;
    if (a != 0) {
        const vm_two first = vmi_log(2 * A), second = vmi_log(VM_FABS(a));
        jacobi_sncndn_m1(whole - (first.hi - second.hi) - (first.lo - second.lo), 0, &tanh_t, &sech_t, &unused);
    }
    rising = VM_COPYSIGN(A, a) * sech_t;
    *x = rising + falling;
    *v = -side * lambda * (rising * tanh_t + falling);
}

/* Writes position and velocity at time t of the motion x = A/cosh(lambda t) on the separatrix, with A^2 = -2 c1/c3 and
   lambda^2 = -c1. With b for the argument of cosh at t = 0, the formula needs 1 + tanh b tanh(lambda t). Where this sum
   is small, and where x0 is so small that the motion begins linearly, vmi_duffing_from_saddle computes the motion. */
VM_API void vmi_duffing_on_separatrix(vm_real t, vm_real x0, vm_real v0, vm_real c1, vm_real c3, vm_real *x,
                                      vm_real *v)
{
    const vm_real A = VM_COPYSIGN(VM_SQRT(-2 * c1 / c3), x0), lambda = VM_SQRT(-c1);
    vm_real tanh_t, sech_t, unused, tanh0 = 0, both = 0;
    jacobi_sncndn_m1(lambda * t, 0, &tanh_t, &sech_t, &unused);
    if ((x0 / A) * (x0 / A) > VM_EPSILON) {
        tanh0 = -v0 / (lambda * x0);
        both = 1 + tanh0 * tanh_t; /* cosh(b + a) = cosh b cosh a (1 + tanh b tanh a) */
    }
    if (!(both > VM_C(0.5))) {
        vmi_duffing_from_saddle(t, x0, v0, c1, c3, x, v);
        return;
    }
    *x = A * sech_t / (A / x0 * both);
    *v = -lambda * *x * ((tanh0 + tanh_t) / both);
}

/* Exact motion x(t), v(t) of Duffing's oscillator x'' + c1 x + c3 x^3 = 0 from x0 (m) and v0 (m/s).
   c1 = k1/m is in 1/s^2, c3 = k3/m in 1/(m s)^2; each may have either sign. Let A be the amplitude. The errors of x and
   v are at most 32 eps of A and of the largest velocity, times 1 + t/period, where the two terms of c1 + c3 A^2, and
   those of c1 + c3 A^2/2, do not cancel. They cancel next to the separatrix of two wells (c1 < 0, c3 > 0), for example
   where x0 and v0 are tiny. There let lambda^2 = -c1, s = v0^2 - lambda^2 x0^2 + c3 x0^4/2 and r = (v0^2 + lambda^2
   x0^2)/|s|. The errors of x and v/lambda are at most B = 16 eps r (1 + lambda (|t| + period/4)) times the larger of
   |x| and |v|/lambda at time t, where B is below 1. The number r eps is about the relative change of the energy when x0
   and v0 are rounded. Where it is 1 or more, the computed motion may be the separatrix, or on its other side. If c3
   s/c1^2 is so small that numbers of this size lose digits, the motion is right until it comes back close to x = 0.
   Results lose digits where A^4, c1^2, (c3 A^2)^2 or the square of the largest velocity underflows, and are NaN where
   one of these numbers, lambda t or the action overflows; so choose a unit of length near A in float. NaN is also
   written to x and v for c1 = c3 = 0, if the motion goes to infinity, which includes the border of such motions, A^2 =
   -c1/c3 with c1 > 0 and c3 < 0, and if an argument is infinite or NaN. If x or v is a null pointer, nothing is
   written. Equations: DLMF 22.19(ii). */
VM_API void vm_duffing_exact_from(vm_real t, vm_real x0, vm_real v0, vm_real c1, vm_real c3, vm_real *x, vm_real *v)
{
    if (!x || !v) return;
    const vm_odd_force force = vmi_duffing_elastic(c1, c3);
    vmi_orbit orbit;
    *x = VM_NAN;
    *v = VM_NAN;
    if (!VM_IS_FINITE(t) || !VM_IS_FINITE(x0) || !VM_IS_FINITE(v0) || !VM_IS_FINITE(c1) || !VM_IS_FINITE(c3)) return;
    if (vmi_duffing_through(&force, x0, v0, &orbit)) return;
    if (orbit.size == 0) {
        *x = x0;
        *v = v0;
    } else if (vmi_duffing_is_separatrix(&orbit)) {
        vmi_duffing_on_separatrix(t, x0, v0, c1, c3, x, v);
    } else if (!vmi_duffing_complete(&orbit)) {
        vmi_duffing_at_argument(&orbit, vmi_duffing_argument_of(&orbit, x0, v0) + orbit.lambda * t, x, v);
    }
    if (VM_IS_FINITE(*x) && VM_IS_FINITE(*v)) return;
    *x = VM_NAN; /* a number has overflowed */
    *v = VM_NAN;
}

#endif
