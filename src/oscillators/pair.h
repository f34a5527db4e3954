/* oscillators/pair.h - two bodies with a nonlinear connection

   Two bodies of equal mass m(t) move on a line, and a spring connects them. Their coordinates x and y obey (517) and
   (518) of the dissertation:
       m x'' = -k (x - y)|x - y|^(alpha-1) - r m' x',   m y'' = k (x - y)|x - y|^(alpha-1) - r m' y'
   k is the stiffness of the spring, r the share of the reactive force (`reactive`). The sum q = x + y drifts. The
   difference p = y - x vibrates with the amplitude A and the Ateb phase psi, (520)-(522); Om is the rate of psi. The
   drift and the vibration are the two modes. This file has the equations of motion, the averaged equations of both
   modes, and the motion in closed form for a mass that is linear in time, (528), (529).

       vm_real y[4] = {1, 3, 0, 0}; // x, y, x', y'
       vm_pair p;
       p.alpha = 3;
       p.k = 1; // cubic spring of 1 N/m^3
       p.reactive = 1;
       p.mass = vm_law_linear(1, VM_C(0.01)); // 1 kg, and 0.01 kg/s joins at rest
       int status = vm_pair_at(&p, 50, y, y); // the motion at t = 50 s

   Bodies of different masses, several springs, damping and further forces are in coupled_pair.h.
   Tests: tests/test_pair.c. */
#ifndef VARMASS_OSCILLATORS_PAIR_H
#define VARMASS_OSCILLATORS_PAIR_H

#include "../ateb/functions.h"
#include "../base/arrays.h"
#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/scalars.h"
#include "../base/status.h"
#include "constant_mass.h"
#include "laws.h"
#include "slow.h"
#include "waves.h"

/* Two bodies of equal mass and the spring between them */
typedef struct VM_TAG(vm_pair) {
    vm_real alpha;    /* exponent of the spring, >= 0 */
    vm_real k;        /* stiffness, N/m^alpha, > 0 */
    vm_real reactive; /* r: 1 where mass that joins or leaves is at rest, 0 where this mass has the body's velocity */
    vm_law mass;      /* mass m(t) of each body, kg, > 0; it must vary slowly */
} vm_pair;

/* Indices of the four numbers that describe the modes: the mean amplitude A, m, of p = y - x; the Ateb phase psi of p;
   the sum q = x + y, m; its rate q', m/s */
enum {
    VMI_PAIR_A = 0,
    VMI_PAIR_PSI = 1,
    VMI_PAIR_SUM = 2,
    VMI_PAIR_SUM_RATE = 3,
    VMI_PAIR_MODES = 4
};

/* Writes the mass and its rate at time t. It checks both numbers, the fields of the pair, and the four numbers of a
   state. Functions that an integrator calls pass NULL for the state, so that the state is not checked. If the state
   overflows in a trial step, the integrator must be able to repeat the step, and an error would stop it. */
VM_API int vmi_pair_now(const vm_pair *p, vm_real t, const vm_real *state_or_NULL, vm_real *mass, vm_real *rate)
{
    const vm_real numbers[3] = {p->alpha, p->k, p->reactive};
    int status = vmi_law_at(&p->mass, VM_BAD_MASS, t, mass, rate);
    if (!vmi_all_finite(3, numbers)) status = vmi_first_error(status, VM_NOT_FINITE);
    if (state_or_NULL && !vmi_all_finite(4, state_or_NULL)) status = vmi_first_error(status, VM_NOT_FINITE);
    if (p->k <= 0) status = vmi_first_error(status, VM_BAD_STIFFNESS);
    if (p->alpha < 0) status = vmi_first_error(status, VM_DOMAIN);
    return status;
}

/* Equations of motion (517), (518) of two bodies, for rk45 or rk87.
   The array y = (x, y, x', y') is in m and m/s; pair points to a vm_pair. Returns VM_BAD_ARGUMENT for null pointers or
   where no constructor made the mass, VM_NOT_FINITE for t or a field that is infinite or NaN (y is not checked),
   VM_BAD_MASS or VM_BAD_STIFFNESS for a mass or a stiffness that is not positive, and VM_DOMAIN for alpha < 0 or a t at
   which a law has no value. These statuses stop the integration. */
VM_API int vm_pair_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *pair)
{
    if (!y || !dydt || !pair) return VM_BAD_ARGUMENT;
    const vm_pair *p = (const vm_pair *)pair;
    vm_real mass, rate, force;
    const int status = vmi_pair_now(p, t, NULL, &mass, &rate);
    if (status) return status;
    force = p->k * vmi_osc_elastic(y[0] - y[1], p->alpha);
    dydt[0] = y[2];
    dydt[1] = y[3];
    dydt[2] = (-force - p->reactive * rate * y[2]) / mass;
    dydt[3] = (force - p->reactive * rate * y[3]) / mass;
    return VM_OK;
}

/* The amplitude of y - x at the Ateb phase psi, divided by the mean amplitude A. This ratio is (1 + s sa ca/(2
   Om))^(2/(alpha+3)). Here sa and ca are the Ateb functions of psi, Om is the rate of psi, and s = (2r - 1) m'/m with
   the field r = `reactive`. The spring acts on both bodies, so that y - x vibrates with the stiffness 2 k. */
VM_API vm_real vmi_pair_ripple(const vm_pair *p, vm_real mass, vm_real rate, vm_real A, vm_real psi)
{
    const vm_real q = vmi_slow_q(vmi_slow_drag(p->reactive, rate, 0), mass, p->k, 0);
    const vm_real Om = vmi_slow_rate(A, 2 * p->k, mass, p->alpha);
    vm_real sa, ca;
    ateb_saca(psi, p->alpha, &sa, &ca);
    return vmi_pow_checked(1 + q / (2 * Om) * sa * ca, 2 / (p->alpha + 3));
}

/* Computes the modes from the motion y. The mean amplitude A solves exact = A ripple(A), where `exact` is the amplitude
   at this instant and `ripple` is the result of vmi_pair_ripple. Three iterations are enough where the ripple is small.
   Returns VM_NOT_FINITE where the exact amplitude overflows. Returns VM_DOMAIN where three iterations are not enough,
   because the ripple is as large as the motion. */
VM_API int vmi_pair_split(const vm_pair *p, vm_real mass, vm_real rate, const vm_real *y, vm_real *modes)
{
    vm_real exact, A, psi, found[VMI_PAIR_MODES];
    int i;
    vmi_slow_phase(y[1] - y[0], y[3] - y[2], 2 * p->k, mass, p->alpha, &exact, &psi);
    if (!VM_IS_FINITE(exact)) return VM_NOT_FINITE;
    A = exact;
    for (i = 0; i < 3 && exact > 0; i++) A = exact / vmi_pair_ripple(p, mass, rate, A, psi);
    if (exact > 0 && !vmi_slow_is_solved(A * vmi_pair_ripple(p, mass, rate, A, psi), exact)) return VM_DOMAIN;
    if (!(A >= 0)) return VM_DOMAIN;
    found[VMI_PAIR_A] = A;
    found[VMI_PAIR_PSI] = psi;
    found[VMI_PAIR_SUM] = y[0] + y[1];
    found[VMI_PAIR_SUM_RATE] = y[2] + y[3];
    return vmi_copy_if_finite(VMI_PAIR_MODES, found, modes);
}

/* Computes the motion y from the modes, the inverse of vmi_pair_split. */
VM_API int vmi_pair_join(const vm_pair *p, vm_real mass, vm_real rate, const vm_real *modes, vm_real *y)
{
    const vm_real sum = modes[VMI_PAIR_SUM], sum_rate = modes[VMI_PAIR_SUM_RATE];
    vm_real A = modes[VMI_PAIR_A], x, v, joined[4];
    if (!vmi_all_finite(VMI_PAIR_MODES, modes)) return VM_NOT_FINITE; /* a closed form may overflow */
    if (A > 0) A *= vmi_pair_ripple(p, mass, rate, A, modes[VMI_PAIR_PSI]);
    if (!(A >= 0)) return VM_DOMAIN;
    vmi_slow_motion(A, modes[VMI_PAIR_PSI], 2 * p->k, mass, p->alpha, &x, &v);
    joined[0] = (sum - x) / 2;
    joined[1] = (sum + x) / 2;
    joined[2] = (sum_rate - v) / 2;
    joined[3] = (sum_rate + v) / 2;
    return vmi_copy_if_finite(4, joined, y);
}

/* Converts a motion y = (x, y, x', y') of two bodies to the modes (A, psi, q, q'), (520)-(522). q = x + y drifts; p = y
   - x vibrates with the mean amplitude A, m, and the Ateb phase psi. A does not contain the ripple of the amplitude
   within a period. Any initial velocities are allowed. Returns VM_BAD_ARGUMENT for null pointers or where no
   constructor made the mass, VM_NOT_FINITE for a number that is infinite or NaN, VM_BAD_MASS or VM_BAD_STIFFNESS for a
   mass or a stiffness that is not positive, and VM_DOMAIN for alpha < 0, for a t at which a law has no value, and where
   the ripple is as large as the motion. The ripple is as large as the motion where |(2r - 1) m'/m| is about twice the
   rate of psi, for example where the mass m tends to 0; r is the field `reactive`. modes and y may be the same array.
   */
VM_API int vm_pair_to_averaged(const vm_pair *p, vm_real t, const vm_real *y, vm_real *modes)
{
    if (!p || !y || !modes) return VM_BAD_ARGUMENT;
    vm_real mass, rate;
    const int status = vmi_pair_now(p, t, y, &mass, &rate);
    if (status) return status;
    return vmi_pair_split(p, mass, rate, y, modes);
}

/* Converts the modes (A, psi, q, q') of two bodies to the motion y = (x, y, x', y'). This is the inverse of
   vm_pair_to_averaged, and returns the same statuses; it also returns VM_DOMAIN for A < 0. y and modes may be the same
   array. */
VM_API int vm_pair_from_averaged(const vm_pair *p, vm_real t, const vm_real *modes, vm_real *y)
{
    if (!p || !modes || !y) return VM_BAD_ARGUMENT;
    vm_real mass, rate;
    const int status = vmi_pair_now(p, t, modes, &mass, &rate);
    if (status) return status;
    return vmi_pair_join(p, mass, rate, modes, y);
}

/* Averaged equations of the two modes of a pair, for rk45 or rk87.
   The mass may follow any slow law. The array modes = (A, psi, q, q') is that of vm_pair_to_averaged; pair points to a
   vm_pair. The relative error of the motion is of the order of m'/(m Om) up to the time m/m', where m is the mass and
   Om the rate of psi. Returns the statuses of vm_pair_rhs. */
VM_API int vm_pair_averaged_rhs(vm_real t, const vm_real *modes, vm_real *dmodes, void *pair)
{
    if (!modes || !dmodes || !pair) return VM_BAD_ARGUMENT;
    const vm_pair *p = (const vm_pair *)pair;
    vm_real mass, rate;
    const int status = vmi_pair_now(p, t, NULL, &mass, &rate);
    if (status) return status;
    dmodes[VMI_PAIR_A] = -vmi_slow_drag(p->reactive, rate, 0) / ((p->alpha + 3) * mass) * modes[VMI_PAIR_A];
    dmodes[VMI_PAIR_PSI] = vmi_slow_rate(modes[VMI_PAIR_A], 2 * p->k, mass, p->alpha);
    dmodes[VMI_PAIR_SUM] = modes[VMI_PAIR_SUM_RATE];
    dmodes[VMI_PAIR_SUM_RATE] = -p->reactive * rate / mass * modes[VMI_PAIR_SUM_RATE];
    return VM_OK;
}

/* Computes the averaged motion at time t by closed formulas, which hold for a mass that is linear in time. y0 contains
   x, y, x' and y' at t = 0. The results are written to `modes` in the order VMI_PAIR_..., and the mass at t with its
   integrals to *m. The averaged equations contain powers of m/m0, where m is the mass at t and m0 the mass at t = 0.
   For any exponent e the integral of (m/m0)^e dt is m0 (exp(u) - 1)/u times the integral of dt/m, with u = (1 + e)
   ln(m/m0). */
VM_API int vmi_pair_modes_at(const vm_pair *p, vm_real t, const vm_real *y0, vmi_linear_mass *m, vm_real *modes)
{
    const vm_real fall = (2 * p->reactive - 1) / (p->alpha + 3); /* A is proportional to (m/m0)^-fall */
    vm_real rate0, exponent;
    int status = vmi_pair_now(p, 0, y0, &m->m0, &m->rate);
    if (status != VM_BAD_ARGUMENT && !VM_IS_FINITE(t)) status = VM_NOT_FINITE;
    if (!status) status = vmi_linear_mass_of(&p->mass, t, m);
    if (!status) status = vmi_pair_split(p, m->m0, m->rate, y0, modes);
    if (status) return status;
    rate0 = vmi_slow_rate(modes[VMI_PAIR_A], 2 * p->k, m->m0, p->alpha);
    exponent = VM_C(0.5) - (p->alpha - 1) / 2 * fall;
    modes[VMI_PAIR_PSI] += rate0 * m->m0 * m->integral * vmi_exp_ratio(exponent * m->ln_ratio);
    modes[VMI_PAIR_A] *= vmi_exp(-fall * m->ln_ratio, 0);
    modes[VMI_PAIR_SUM] +=
        modes[VMI_PAIR_SUM_RATE] * m->m0 * m->integral * vmi_exp_ratio((1 - p->reactive) * m->ln_ratio);
    modes[VMI_PAIR_SUM_RATE] *= vmi_exp(-p->reactive * m->ln_ratio, 0);
    return VM_OK;
}

/* Motion of two bodies at time t, in closed form for a mass m that is linear in time: (528), (529) with p0 = y(0) -
   x(0). The array y0 = (x, y, x', y') is the motion at t = 0. The relative error of the motion is of the order of m'/(m
   Om) up to the time m/m', where Om is the rate of the Ateb phase of y - x. Returns the statuses of
   vm_pair_to_averaged, at 0 and at t, and VM_NO_LAW unless the mass is a vm_law_linear, a vm_law_power with the
   exponent 1, or a vm_law_exponential with the rate 0 (integrate vm_pair_averaged_rhs instead). y and y0 may be the
   same array. */
VM_API int vm_pair_at(const vm_pair *p, vm_real t, const vm_real *y0, vm_real *y)
{
    if (!p || !y0 || !y) return VM_BAD_ARGUMENT;
    vmi_linear_mass m;
    vm_real modes[VMI_PAIR_MODES];
    const int status = vmi_pair_modes_at(p, t, y0, &m, modes);
    if (status) return status;
    return vmi_pair_join(p, m.m, m.rate, modes, y);
}

/* The three methods of (524), named after the periodic function that describes the vibration p = y - x */
enum {
    VM_PAIR_ATEB = 0,  /* the Ateb function ca, which is exact where the mass is constant */
    VM_PAIR_TRIG = 1,  /* the cosine with the exact period */
    VM_PAIR_JACOBI = 2 /* Jacobi's cn with the exact period and the exact velocity at p = 0 */
};

/* Motion of two bodies at time t by one of the three methods of (524), so that the methods can be compared. The
   difference p = y - x is A(t) times ca, cos or cn. A is the mean amplitude of vm_pair_to_averaged; its law is the same
   for all three methods. x and y follow from p and the sum q = x + y by (528), (529). `method` is VM_PAIR_ATEB,
   VM_PAIR_TRIG or VM_PAIR_JACOBI. Unlike vm_pair_at, this function leaves out the ripple of the amplitude within a
   period, as the dissertation does. The other arguments are those of vm_pair_at. The error has two parts: the error
   that vm_osc_approximation_errors gives, times A/2; and a part of the order of m'/(m Om), where m is the mass and Om
   the rate of the phase of p. Returns the statuses of vm_pair_at, and VM_BAD_ARGUMENT for a method that does not exist.
   y and y0 may be the same array. */
VM_API int vm_pair_by_method(const vm_pair *p, int method, vm_real t, const vm_real *y0, vm_real *y)
{
    if (!p || !y0 || !y || method < VM_PAIR_ATEB || method > VM_PAIR_JACOBI) return VM_BAD_ARGUMENT;
    vmi_linear_mass m;
    vmi_osc_wave w;
    vm_real modes[VMI_PAIR_MODES], found[4], c, s, x, v;
    const int status = vmi_pair_modes_at(p, t, y0, &m, modes);
    if (status) return status;
    w = vmi_osc_wave_ca(p->alpha, NULL);
    if (method == VM_PAIR_TRIG) w = vmi_osc_wave_cos(p->alpha, ateb_pi(p->alpha));
    if (method == VM_PAIR_JACOBI) w = vmi_osc_wave_cn(p->alpha, ateb_pi(p->alpha));
    vmi_osc_wave_at(&w, modes[VMI_PAIR_PSI], &c, &s);
    x = modes[VMI_PAIR_A] * c;
    v = -w.speed * vm_osc_vmax(modes[VMI_PAIR_A], VM_SQRT(2 * p->k / m.m), p->alpha) * s;
    found[0] = (modes[VMI_PAIR_SUM] - x) / 2;
    found[1] = (modes[VMI_PAIR_SUM] + x) / 2;
    found[2] = (modes[VMI_PAIR_SUM_RATE] - v) / 2;
    found[3] = (modes[VMI_PAIR_SUM_RATE] + v) / 2;
    return vmi_copy_if_finite(4, found, y);
}

#endif
