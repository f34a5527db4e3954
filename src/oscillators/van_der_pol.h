/* oscillators/van_der_pol.h - the Van der Pol oscillator with variable mass

   The equation is (404) of the dissertation. The spring has any exponent alpha; the mass m(t) and the stiffness k may
   vary slowly:
       m x'' + k x|x|^(alpha-1) = (feed - c x^2) x' - r m' x'
   The term with feed > 0 brings energy into the vibration, and the term with c > 0 limits the vibration. With both
   terms the vibration tends to a steady vibration, the limit cycle. r is the field `reactive`: 1 where mass that joins
   or leaves is at rest, 0 where this mass has the body's velocity. This file has the equation of motion, the averaged
   equations (410), the amplitude in closed form for a mass that is linear in time, and the amplitude of the limit
   cycle. These are the equations (403) to (440), as corrected in docs/errata.md.

       vm_vdp v;
       memset(&v, 0, sizeof v);
       v.alpha = v.k = v.reactive = 1;
       v.feed = v.c = VM_C(0.1);
       v.mass = vm_law_linear(1, VM_C(0.02)); // 1 kg, and 0.02 kg/s joins at rest
       int status = vm_vdp_init(&v);
       vm_real A = vm_vdp_amplitude(&v, 100, VM_C(0.3)); // A at t = 100 s, if A = 0.3 m at t = 0

   Tests: tests/test_van_der_pol.c. */
#ifndef VARMASS_OSCILLATORS_VAN_DER_POL_H
#define VARMASS_OSCILLATORS_VAN_DER_POL_H

#include "../ateb/beta.h"
#include "../base/arrays.h"
#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/scalars.h"
#include "../base/status.h"
#include "../jacobi/means.h"
#include "constant_mass.h"
#include "force_terms.h"
#include "laws.h"
#include "slow.h"

/* Methods of averaging. Each method takes the means over one period of an approximate motion x. The comment beside the
   name of the method has this motion. A is the amplitude and psi the Ateb phase. */
enum {
    VM_VDP_ATEB = 0,         /* x = A ca(psi), the exact motion without damping; the means are exact to first order */
    VM_VDP_JACOBI = 1,       /* x = A cn with Jacobi's cn (411)-(413); the error of the limit cycle's amplitude is at
                                most 0.51 % for 1/3 <= alpha <= 5 */
    VM_VDP_TRIGONOMETRIC = 2 /* x = A cos(psi) for every alpha; the amplitude of the limit cycle then does not depend on
                                alpha */
};

/* A Van der Pol oscillator. Fill all fields but a1, a2, a3, then call vm_vdp_init. The fields feed and c are eps b and
   eps c in the dissertation; both may have either sign. */
typedef struct VM_TAG(vm_vdp) {
    vm_real alpha;      /* exponent of the spring's force, >= 0 */
    vm_real k;          /* stiffness, N/m^alpha, > 0, if the stiffness is constant */
    vm_real feed;       /* coefficient of the term that brings energy into the vibration, N s/m; if it is < 0, the term
                           takes energy out */
    vm_real c;          /* coefficient of the term that limits the vibration, N s/m^3 */
    vm_real reactive;   /* r: 1 where mass that joins or leaves is at rest, 0 where this mass has the body's velocity */
    int method;         /* method of averaging, VM_VDP_... */
    vm_law mass;        /* slow mass m, kg, > 0; vm_vdp_init and vm_vdp_limit_cycle do not use it */
    vm_law stiffness;   /* law of a slow stiffness, N/m^alpha, > 0, in place of k; if all fields of the law are 0, as
                           after memset, the stiffness is the constant k. vm_vdp_init and vm_vdp_limit_cycle do not use
                           it */
    vm_real a1, a2, a3; /* mean values in the averaged equations (410), pure numbers; vm_vdp_init writes them */
} vm_vdp;

/* Writes the mean values a1, a2, a3 in the averaged equations (410), for the method in the field `method`. For
   VM_VDP_JACOBI the expression for a1 in (411) is simplified by (1 - m) + m C4 = 2 a2, where m is the parameter of cn
   and C4 the mean of cn^4. */
VM_API void vmi_vdp_means(vm_vdp *v)
{
    v->a1 = 1;
    v->a2 = 2 / (v->alpha + 3);
    if (v->method == VM_VDP_ATEB) {
        v->a3 = 2 / (v->alpha + 1) * ateb_mean(v->alpha, 2, 2);
    } else if (v->method == VM_VDP_TRIGONOMETRIC) {
        v->a3 = v->a2 / 4;
    } else {
        const vm_real m = vm_osc_jacobi_parameter(v->alpha);
        vm_real C2, C4, C6;
        jacobi_cn_means(m, &C2, &C4, &C6);
        v->a2 = (1 - m) - (1 - 2 * m) * C2 - m * C4;
        v->a1 = (v->alpha + 3) / 2 * v->a2;
        v->a3 = (1 - m) * C2 - (1 - 2 * m) * C4 - m * C6;
    }
}

/* Returns 1 if the stiffness follows a law, 0 if it is the constant k. */
VM_API int vmi_vdp_has_stiffness_law(const vm_vdp *v) { return v->stiffness.derivatives != NULL; }

/* Returns the law of the stiffness, which may be constant. */
VM_API vm_law vmi_vdp_stiffness(const vm_vdp *v)
{
    if (vmi_vdp_has_stiffness_law(v)) return v->stiffness;
    return vm_law_linear(v->k, 0);
}

/* Checks that the fields alpha, k, feed, c and reactive are in their domains. The sign of k is checked only if the
   stiffness follows no law. */
VM_API int vmi_vdp_check(const vm_vdp *v)
{
    const vm_real numbers[5] = {v->alpha, v->k, v->feed, v->c, v->reactive};
    if (!vmi_all_finite(5, numbers)) return VM_NOT_FINITE;
    if (v->k <= 0 && !vmi_vdp_has_stiffness_law(v)) return VM_BAD_STIFFNESS;
    if (v->alpha < 0) return VM_DOMAIN;
    return VM_OK;
}

/* Prepares a Van der Pol oscillator: checks the fields alpha, k, feed, c, reactive and method, and writes the mean
   values a1, a2, a3 (411)-(413). vm_vdp_amplitude, vm_vdp_limit_cycle and vm_vdp_averaged_rhs need this call; the other
   functions do not. The mass may be set and changed later. The mean values are within 20 eps of the true values.
   Returns VM_BAD_ARGUMENT for a null pointer or an unknown method, VM_NOT_FINITE for a number that is infinite or NaN,
   VM_BAD_STIFFNESS for k <= 0 without a law of the stiffness, VM_DOMAIN for alpha < 0, and VM_OK otherwise. An error
   leaves *v as it was. */
VM_API int vm_vdp_init(vm_vdp *v)
{
    int status;
    if (!v || v->method < VM_VDP_ATEB || v->method > VM_VDP_TRIGONOMETRIC) return VM_BAD_ARGUMENT;
    status = vmi_vdp_check(v);
    if (status) return status;
    vmi_vdp_means(v);
    return VM_OK;
}

/* The drive 2 feed - (2 reactive - 1) m', N s/m, where m' is the mass rate. If the drive is positive, a small vibration
   grows on average. */
VM_API vm_real vmi_vdp_drive(const vm_vdp *v, vm_real mass_rate)
{
    return -vmi_slow_drag(v->reactive, mass_rate, -v->feed);
}

/* The growth a1 m A'/A at the amplitude A, N s/m, where m is the mass and a1 the mean value of (410). The growth is the
   sum of the averages of Van der Pol's term and of the reactive force (410), and is 0 on the limit cycle.
   vm_vdp_amplitude is the solution of A' = A growth(A)/(a1 m). */
VM_API vm_real vmi_vdp_growth(const vm_vdp *v, vm_real mass_rate, vm_real A)
{
    return vmi_vdp_drive(v, mass_rate) * v->a2 / 2 - v->c * A * A * v->a3;
}

/* Returns 1 if the closed forms in this file may be used, that is if vm_vdp_init has prepared the oscillator; else
   0. */
VM_API int vmi_vdp_has_closed_forms(const vm_vdp *v) { return v->a1 > 0; }

/* Amplitude of a Van der Pol oscillator at time t, in closed form for a mass that is linear in time. first_A is the
   amplitude, m, at t = 0, of either sign. One formula replaces the equations (422), (424), (427), (429), (431)-(435)
   and (437), as corrected in docs/errata.md, and has no singularity where terms cancel. The error is the sum of the
   error of averaging, which depends on the field `method`, and of the rounding error. Tests bound the rounding error by
   12 eps; the changes that rounding errors of t and of the two terms of `drive` (see below) make come in addition.
   Returns NaN for a null pointer, an oscillator that vm_vdp_init has not prepared, infinite arguments, a mass that is
   not positive at 0 or at t, a mass that is neither linear nor constant, and a stiffness that follows a law (integrate
   vm_vdp_averaged_rhs instead). For c < 0, and for c > 0 backward in time, it also returns NaN from the time at which
   the amplitude becomes infinite.
   Method: the solution of (416) is
     1/A^2 = e^-F (1/first_A^2 + 2 c a3/a1 times the integral of e^F dt/m),  F = drive a2/a1 times the integral of dt/m,
   where drive = 2 feed - (2r - 1) m'. If the mass is linear in time, F is proportional to the integral of dt/m; hence
   the integral of e^F dt/m is (e^F - 1)/F times the integral of dt/m. So that nothing overflows, the code uses
   e^(-|F|/2) and divides by the larger of the two terms in the bracket. */
VM_API vm_real vm_vdp_amplitude(const vm_vdp *v, vm_real t, vm_real first_A)
{
    if (!v) return VM_NAN;
    vmi_linear_mass m;
    vm_real F, half, limit, root, size, scale, gain = 1, free_part = 1, denominator;
    if (!VM_IS_FINITE(first_A) || !VM_IS_FINITE(v->c) || !vmi_vdp_has_closed_forms(v)) return VM_NAN;
    if (vmi_vdp_has_stiffness_law(v)) return VM_NAN;
    if (vmi_linear_mass_of(&v->mass, t, &m)) return VM_NAN;
    if (first_A == 0) return first_A;
    F = vmi_vdp_drive(v, 0) * (v->a2 / v->a1) * m.integral -
        (2 * v->reactive - 1) * (v->a2 / v->a1) * m.ln_ratio;
    half = vmi_exp(-VM_FABS(F) / 2, 0);
    limit = 2 * v->c * (v->a3 / v->a1) * m.integral * vmi_exp_ratio(-VM_FABS(F));
    root = VM_SQRT(VM_FABS(limit));
    size = VM_FABS(first_A) * root; /* the square of `size` is added to that of free_part, with the sign of `limit` */
    if (F > 0) free_part = half;
    else gain = half;
    if (size > free_part) {
        scale = VM_COPYSIGN(1 / root, first_A);
        denominator = (free_part / size) * (free_part / size) + VM_COPYSIGN(1, limit);
    } else {
        scale = first_A / free_part;
        denominator = 1 + VM_COPYSIGN((size / free_part) * (size / free_part), limit);
    }
    if (denominator < 0) return VM_NAN;
    return scale * gain / VM_SQRT(denominator);
}

/* Amplitude of the limit cycle, m, while the mass changes at mass_rate (kg/s): (425), (430), (438). The stiffness must
   be constant. The result is 0 where there is no limit cycle. *stable_or_NULL becomes 1 if amplitudes near the result
   tend to the result, else 0. The relative rounding error is at most 3e-15 (float 6e-6); where 2 feed and (2r - 1)
   mass_rate nearly cancel, their rounding errors make a larger error. The error of averaging must be added. Returns
   NaN for a null pointer, for an oscillator that vm_vdp_init has not prepared, and for an infinite mass_rate. */
VM_API vm_real vm_vdp_limit_cycle(const vm_vdp *v, vm_real mass_rate, int *stable_or_NULL)
{
    if (!v) return VM_NAN;
    const vm_real drive = vmi_vdp_drive(v, mass_rate);
    const int exists = (drive > 0 && v->c > 0) || (drive < 0 && v->c < 0);
    const int limited = v->c > 0, rest_is_stable = drive < 0 || (drive == 0 && limited);
    if (!VM_IS_FINITE(drive) || !vmi_vdp_has_closed_forms(v)) return VM_NAN;
    if (stable_or_NULL) *stable_or_NULL = exists ? limited : rest_is_stable;
    if (!exists) return 0;
    return VM_SQRT(drive / v->c * (v->a2 / (2 * v->a3)));
}

/* Writes mass and stiffness at t, and their rates. It also checks the fields of the oscillator. */
VM_API int vmi_vdp_laws_at(const vm_vdp *v, vm_real t, vm_real *mass, vm_real *mass_rate, vm_real *k, vm_real *k_rate)
{
    int status = vmi_first_error(vmi_law_at(&v->mass, VM_BAD_MASS, t, mass, mass_rate), vmi_vdp_check(v));
    *k = v->k;
    *k_rate = 0;
    if (vmi_vdp_has_stiffness_law(v))
        status = vmi_first_error(status, vmi_law_at(&v->stiffness, VM_BAD_STIFFNESS, t, k, k_rate));
    return status;
}

/* Equation of motion (404) of a Van der Pol oscillator, for rk45 or rk87.
   The array y = (x, x') is in m and m/s; `vdp` points to a vm_vdp. Returns VM_BAD_ARGUMENT for null pointers or where
   no constructor made the mass, VM_NOT_FINITE for t or a field that is infinite or NaN (y is not checked), VM_BAD_MASS
   for a mass that is not positive, VM_BAD_STIFFNESS for a stiffness that is not positive, and VM_DOMAIN for alpha < 0
   and for a t at which a law has no value. These statuses stop the integration. */
VM_API int vm_vdp_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *vdp)
{
    if (!y || !dydt || !vdp) return VM_BAD_ARGUMENT;
    const vm_vdp *v = (const vm_vdp *)vdp;
    vm_real mass, rate, k, k_rate, feed;
    const int status = vmi_vdp_laws_at(v, t, &mass, &rate, &k, &k_rate);
    if (status) return status;
    feed = vmi_van_der_pol_feed(v->feed, v->c, y[0]) - v->reactive * rate;
    dydt[0] = y[1];
    dydt[1] = (feed * y[1] - k * vmi_osc_elastic(y[0], v->alpha)) / mass;
    return VM_OK;
}

/* Averaged equations (410) of a Van der Pol oscillator, for rk45 or rk87. Mass and stiffness may follow any slow law.
   The array y = (A, psi) contains the mean amplitude A, in metres, and the Ateb phase psi: x = A ca(psi), and |x| = A
   at the turning points. `vdp` points to a vm_vdp that vm_vdp_init has prepared. The errors are known for the method
   VM_VDP_ATEB and a start from rest. Let e be the largest of feed, c A^2 and m', divided by m psi', where m is the
   mass. Then, up to the time m/feed, the relative error of A is of the order of e^2, and the error of psi is of the
   order of e. Returns the statuses of vm_vdp_rhs. */
VM_API int vm_vdp_averaged_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *vdp)
{
    if (!y || !dydt || !vdp) return VM_BAD_ARGUMENT;
    const vm_vdp *v = (const vm_vdp *)vdp;
    vm_real mass, rate, k, k_rate;
    const int status = vmi_vdp_laws_at(v, t, &mass, &rate, &k, &k_rate);
    if (status) return status;
    dydt[0] = y[0] / (v->a1 * mass) * vmi_vdp_growth(v, rate, y[0]);
    if (k_rate != 0) dydt[0] -= y[0] * k_rate / k / (v->alpha + 3);
    dydt[1] = vmi_slow_rate(y[0], k, mass, v->alpha);
    return VM_OK;
}

#endif
