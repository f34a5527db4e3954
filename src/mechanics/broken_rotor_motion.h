/* mechanics/broken_rotor_motion.h - motion of the broken rotor in closed form

   This chapter computes the state of the rotor after a given time without an integrator. Before the break the shaft
   passes through the mass centre, and the solution (46)-(51) of the dissertation [1] is exact
   (vm_broken_rotor_free_motion). After the break the linearised equations (69) are a good approximation for short
   times, while the angle psi of the remainder is small. vm_broken_rotor_linear solves all three equations.
   vm_broken_rotor_linear_uncoupled has the solution (70)-(72), which leaves out the term s p^2 omega^2 y of the third
   equation. For long times integrate vm_broken_rotor_rhs.

       vm_broken_rotor whole = {2, 1, 20, 1, 3, 0};
       vm_real y[VM_BROKEN_ROTOR_STATES] = {VM_C(0.01), 0, 0, 0, 0, 3};
       int status = vm_broken_rotor_free_motion(&whole, 5, y, y); // y at 5 s

   The linearised equations (69) are as follows; omega, p, k*, M*, s and psi are explained at vm_broken_rotor:
     x'' + omega^2 (x + s) = 0,  y'' + omega^2 (y + s psi) = 0,  psi'' + k* psi' = M* - s p^2 omega^2 y.
   Tests: tests/test_broken_rotor.c. */
#ifndef VARMASS_MECHANICS_BROKEN_ROTOR_MOTION_H
#define VARMASS_MECHANICS_BROKEN_ROTOR_MOTION_H

#include <string.h>

#include "../base/arrays.h"
#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/scalars.h"
#include "../base/status.h"
#include "../base/sums.h"
#include "../base/words.h"
#include "broken_rotor.h"

/* The coefficients (67) of the linearised equations (69), which are at the top of mechanics/broken_rotor_motion.h */
typedef struct VM_TAG(vmi_broken_rotor_linear) {
    vm_real omega, k, torque, s; /* omega, k*, M* and s, as explained at vm_broken_rotor */
    vm_real coupling;            /* s p^2 omega^2, the factor of y in the equation of psi; 0 to leave out this term */
} vmi_broken_rotor_linear;

/* Indices in the array z. z contains y, psi and their rates, because the linearised equations (69) couple them. */
enum {
    VMI_BROKEN_ROTOR_Y = 0,
    VMI_BROKEN_ROTOR_PSI = 1,
    VMI_BROKEN_ROTOR_Y_RATE = 2,
    VMI_BROKEN_ROTOR_PSI_RATE = 3,
    VMI_BROKEN_ROTOR_COUPLED = 4 /* the number of coupled states */
};

/* Returns the coefficients of the linearised equations for the rotor *r, with the coupling term if coupled = 1 and
   without it if coupled = 0. */
VM_API vmi_broken_rotor_linear vmi_broken_rotor_reduced(const vm_broken_rotor *r, int coupled)
{
    vmi_broken_rotor_linear a;
    a.omega = VM_SQRT(r->stiffness / r->mass);
    a.k = r->damping / r->inertia;
    a.torque = r->torque / r->inertia;
    a.s = r->s;
    a.coupling = 0;
    if (coupled) a.coupling = r->s * (r->stiffness / r->inertia);
    return a;
}

/* Returns an upper bound, in 1/s, of the rates at which solutions of the linearised equations grow, decay or
   oscillate. For times up to 1 divided by this bound, the Taylor series of vmi_broken_rotor_series converges fast. */
VM_API vm_real vmi_broken_rotor_rate(const vmi_broken_rotor_linear *a)
{
    return VM_FABS(a->k) + VM_C(1.5) * a->omega + VM_SQRT(VM_FABS(a->s * a->coupling));
}

/* Returns the product x y of numbers in two words (vm_two, base/sums.h), and 0 if a factor is 0, even if the other
   factor has overflowed. If the product is too large for the arithmetic in two words, only its first word is computed.
   */
VM_API vm_two vmi_broken_rotor_product(vm_two x, vm_two y)
{
    vm_two p = vmi_two(0, 0);
    if (x.hi == 0 || y.hi == 0) return p;
    p = vmi_two_times(x, y);
    if (!VM_IS_FINITE(p.hi)) p = vmi_two(x.hi * y.hi, 0); /* p.hi is NaN where p.lo is */
    return p;
}

/* Sets `change` to the change of the states z within the time h, by the Taylor series in h. The time must be short: |h|
   times vmi_broken_rotor_rate must be at most 1. The n-th terms of the series of y and of s psi are then at most 1/n!
   times the first terms, so that a fixed number of terms is enough. In the loop y0, y1, y2 are three successive terms
   of the series of y, and psi0, psi1, psi2 are three successive terms of the series of psi. All sums have two words.
   The rounding of the coefficients omega_h2, k_h and coupling_h2 acts like a rounding of the inputs. */
VM_API void vmi_broken_rotor_series(const vmi_broken_rotor_linear *a, vm_real h, const vm_real *z, vm_two *change)
{
    const int terms = VM_MANT_DIG > 24 ? 28 : 17;
    const vm_two step = vmi_two(h, 0), k_h = vmi_two(-a->k * h, 0), s = vmi_two(a->s, 0);
    const vm_two omega_h2 = vmi_two(-(a->omega * h) * (a->omega * h), 0);
    const vm_two coupling_h2 = vmi_two(-a->coupling * h * h, 0);
    vm_two y0 = vmi_two(z[VMI_BROKEN_ROTOR_Y], 0), psi0 = vmi_two(z[VMI_BROKEN_ROTOR_PSI], 0);
    vm_two y1 = vmi_broken_rotor_product(vmi_two(z[VMI_BROKEN_ROTOR_Y_RATE], 0), step);
    vm_two psi1 = vmi_broken_rotor_product(vmi_two(z[VMI_BROKEN_ROTOR_PSI_RATE], 0), step);
    vm_two drive = vmi_two(a->torque * h * h, 0);
    int n;
    change[VMI_BROKEN_ROTOR_Y] = y1;
    change[VMI_BROKEN_ROTOR_PSI] = psi1;
    change[VMI_BROKEN_ROTOR_Y_RATE] = vmi_two(0, 0);
    change[VMI_BROKEN_ROTOR_PSI_RATE] = vmi_two(0, 0);
    for (n = 2; n < terms && h != 0; n++) {
        const vm_two share = vmi_two_over(vmi_two(1, 0), vmi_two((vm_real)(n * (n - 1)), 0));
        const vm_two degree = vmi_two((vm_real)n, 0), below = vmi_two((vm_real)(n - 1), 0);
        const vm_two bent = vmi_two_plus(y0, vmi_broken_rotor_product(psi0, s));
        const vm_two slowed = vmi_two_times(vmi_broken_rotor_product(psi1, k_h), below);
        const vm_two pulled = vmi_two_plus(slowed, vmi_broken_rotor_product(y0, coupling_h2));
        const vm_two y2 = vmi_two_times(vmi_broken_rotor_product(bent, omega_h2), share);
        const vm_two psi2 = vmi_two_times(vmi_two_plus(drive, pulled), share);
        const vm_two y_rate = vmi_two_over(vmi_two_times(y2, degree), step);
        const vm_two psi_rate = vmi_two_over(vmi_two_times(psi2, degree), step);
        change[VMI_BROKEN_ROTOR_Y] = vmi_two_plus(change[VMI_BROKEN_ROTOR_Y], y2);
        change[VMI_BROKEN_ROTOR_PSI] = vmi_two_plus(change[VMI_BROKEN_ROTOR_PSI], psi2);
        change[VMI_BROKEN_ROTOR_Y_RATE] = vmi_two_plus(change[VMI_BROKEN_ROTOR_Y_RATE], y_rate);
        change[VMI_BROKEN_ROTOR_PSI_RATE] = vmi_two_plus(change[VMI_BROKEN_ROTOR_PSI_RATE], psi_rate);
        y0 = y1;
        psi0 = psi1;
        y1 = y2;
        psi1 = psi2;
        drive = vmi_two(0, 0);
    }
}

/* Replaces the matrix m for some time by the matrix for twice this time. m describes how the states z change within
   this time. Row m[j] is the change of the states without torque, if z[j] = 1 and all other z = 0 at the start. The
   last row of m is the change that the torque causes if all states start from 0. For the formulas, write the states as
   a row with a last number 1, give m a last column of zeros, and let E be the unit matrix. The product of this row and
   m + E is then the row at the end of the time. The matrix for twice the time is therefore (m + E)^2 - E = 2 m + m m.
   The matrix m + E itself is not stored, because digits of m would be lost in the sum. */
VM_API void vmi_broken_rotor_double(vm_two m[VMI_BROKEN_ROTOR_COUPLED + 1][VMI_BROKEN_ROTOR_COUPLED])
{
    vm_two old[VMI_BROKEN_ROTOR_COUPLED + 1][VMI_BROKEN_ROTOR_COUPLED];
    int i, j, k;
    memcpy(old, m, sizeof old);
    for (j = 0; j <= VMI_BROKEN_ROTOR_COUPLED; j++)
        for (i = 0; i < VMI_BROKEN_ROTOR_COUPLED; i++) {
            m[j][i] = vmi_two_shifted(m[j][i], 2);
            for (k = 0; k < VMI_BROKEN_ROTOR_COUPLED; k++)
                m[j][i] = vmi_two_plus(m[j][i], vmi_broken_rotor_product(old[k][i], old[j][k]));
        }
}

/* Advances the states z by the time t, for any coefficients *a. The function halves t until the Taylor series converges
   fast. The series gives the matrix for the short time h that results. The function then doubles the time as often as
   it has halved it; vmi_broken_rotor_double gives the matrix for each doubled time. The entries of the matrix have two
   words: the motion may depend on differences of entries, from which the fast vibrations cancel out. */
VM_API void vmi_broken_rotor_advance(vm_real t, const vmi_broken_rotor_linear *a, vm_real *z)
{
    enum { n = VMI_BROKEN_ROTOR_COUPLED };
    vm_two m[n + 1][n], change[n];
    vm_real start[n], h = t;
    vmi_broken_rotor_linear driven = *a;
    int doublings = 0, i, j;
    for (; VM_FABS(h) * vmi_broken_rotor_rate(a) > 1; h /= 2) doublings++;
    if (doublings == 0) {
        vmi_broken_rotor_series(a, h, z, change);
        for (i = 0; i < n; i++) z[i] += change[i].hi;
        return;
    }
    for (j = 0; j <= n; j++) {
        for (i = 0; i < n; i++) start[i] = i == j;
        driven.torque = 0;
        if (j == n) driven.torque = a->torque;
        vmi_broken_rotor_series(&driven, h, start, m[j]);
    }
    for (; doublings > 0; doublings--) vmi_broken_rotor_double(m);
    memcpy(start, z, sizeof start);
    for (i = 0; i < n; i++) {
        vm_two sum = vmi_two_plus(m[n][i], vmi_two(start[i], 0));
        for (j = 0; j < n; j++) {
            const vm_two part = vmi_broken_rotor_product(m[j][i], vmi_two(start[j], 0));
            sum = vmi_two_plus(sum, part);
        }
        z[i] = sum.hi;
    }
}

/* Returns (e^z - 1 - z)/z^2. The argument `ratio` must be (e^z - 1)/z. For |z| <= 1 the function sums a power series in
   z, because the subtractions in the formula would lose digits. */
VM_API vm_real vmi_broken_rotor_exp_rest(vm_real z, vm_real ratio)
{
    const int terms = VM_MANT_DIG > 24 ? 20 : 12;
    vm_real sum = 0;
    int n;
    if (VM_FABS(z) > 1) return (ratio - 1) / z;
    for (n = terms; n >= 2; n--) sum = (1 + z * sum) / (vm_real)n;
    return sum;
}

/* Returns w - sin w. The argument `sine` must be sin w. For |w| <= 1 the function sums a power series in w, because the
   subtraction would lose digits. */
VM_API vm_real vmi_broken_rotor_less_sine(vm_real w, vm_real sine)
{
    const int terms = VM_MANT_DIG > 24 ? 19 : 11;
    vm_real sum = 0;
    int n;
    if (VM_FABS(w) > 1) return w - sine;
    for (n = terms; n >= 3; n -= 2) sum = w * w * (1 - sum) / (vm_real)(n * (n - 1));
    return w * sum;
}

/* The values, at the time t, of functions that describe a free oscillation with the angular frequency w. For w = 0 the
   fields are the limits of these functions as w tends to 0. */
typedef struct VM_TAG(vmi_broken_rotor_swing) {
    vm_real c;    /* cos(w t) */
    vm_real c1;   /* 1 - cos(w t) */
    vm_real w_s;  /* w sin(w t) */
    vm_real s_w;  /* sin(w t)/w */
    vm_real late; /* t - sin(w t)/w */
} vmi_broken_rotor_swing;

VM_API vmi_broken_rotor_swing vmi_broken_rotor_swing_at(vm_real t, vm_real w)
{
    vmi_broken_rotor_swing g;
    vm_real half, sine;
    vmi_sincos(w * t / 2, &half, &g.c);
    vmi_sincos(w * t, &sine, &g.c);
    g.c1 = 2 * half * half;
    g.w_s = w * sine;
    g.s_w = t;
    g.late = 0;
    if (w > 0) {
        g.s_w = sine / w;
        g.late = vmi_broken_rotor_less_sine(w * t, sine) / w;
    }
    return g;
}

/* Returns the product a b, and 0 if a = 0, even if b has overflowed. */
VM_API vm_real vmi_broken_rotor_part(vm_real a, vm_real b)
{
    if (a == 0) return 0;
    return a * b;
}

/* Advances the states z by the time t with the solution (71), (72), which lacks the coupling term s p^2 omega^2 y. The
   dissertation [1] writes k* Omega instead of M*, where Omega is M* divided by k*. This function is used if there is no
   coupling and |t| times vmi_broken_rotor_rate exceeds 2. Let w = omega and k = k*. The initial angle is psi0, and its
   initial rate is rate0. *g must be the result of vmi_broken_rotor_swing_at for t and omega. Then the angle is psi =
   psi0 + rate0 E1 + M* E2, where E1 = (1 - e^(-kt))/k and E2 = (t - E1)/k. E0 = e^(-kt) is the derivative of E1. The
   angle influences y by the equation y'' + w^2 y = -w^2 s psi. The functions g0, g1, g2 give the response of y: each
   solves G'' + w^2 G = F with G = G' = 0 at the start, where F is w^2 E0 for g0, w^2 E1 for g1 and w^2 E2 for g2.
   Therefore g2' = g1 and g1' = g0. With negative damping or a negative time these functions may overflow;
   vmi_broken_rotor_part makes their products with rate0 = 0 or M* = 0 equal to 0 even then. */
VM_API void vmi_broken_rotor_follow(vm_real t, const vmi_broken_rotor_linear *a, const vmi_broken_rotor_swing *g,
                                    vm_real *z)
{
    const vm_real w2 = a->omega * a->omega, sum = w2 + a->k * a->k;
    const vm_real y0 = z[VMI_BROKEN_ROTOR_Y], v0 = z[VMI_BROKEN_ROTOR_Y_RATE];
    const vm_real psi0 = z[VMI_BROKEN_ROTOR_PSI], rate0 = z[VMI_BROKEN_ROTOR_PSI_RATE];
    const vm_real exponent = -a->k * t, ratio = vmi_exp_ratio(exponent);
    const vm_real E0 = vmi_exp(exponent, 0), E1 = ratio * t, E2 = vmi_broken_rotor_exp_rest(exponent, ratio) * (t * t);
    vm_real g0, g1, g2, follow, follow_rate;
    g0 = w2 * ((E0 - g->c) + a->k * g->s_w) / sum;
    g1 = (w2 * (E1 - g->s_w) + a->k * g->c1) / sum;
    g2 = (w2 * E2 + (a->k * g->late - g->c1)) / sum;
    follow = psi0 * g->c1 + (vmi_broken_rotor_part(rate0, g1) + vmi_broken_rotor_part(a->torque, g2));
    follow_rate = psi0 * g->w_s + (vmi_broken_rotor_part(rate0, g0) + vmi_broken_rotor_part(a->torque, g1));
    z[VMI_BROKEN_ROTOR_Y] = y0 * g->c + v0 * g->s_w - vmi_broken_rotor_part(a->s, follow);
    z[VMI_BROKEN_ROTOR_PSI] = psi0 + (vmi_broken_rotor_part(rate0, E1) + vmi_broken_rotor_part(a->torque, E2));
    z[VMI_BROKEN_ROTOR_Y_RATE] = v0 * g->c - y0 * g->w_s - vmi_broken_rotor_part(a->s, follow_rate);
    z[VMI_BROKEN_ROTOR_PSI_RATE] = vmi_broken_rotor_part(rate0, E0) + vmi_broken_rotor_part(a->torque, E1);
}

/* Checks the arguments of vm_broken_rotor_linear, vm_broken_rotor_linear_uncoupled and vm_broken_rotor_free_motion.
   Returns VM_OK or the error. */
VM_API int vmi_broken_rotor_check_motion(const vm_broken_rotor *rotor, vm_real t, const vm_real *start,
                                         const vm_real *end)
{
    if (!rotor || !start || !end) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t) || !vmi_all_finite(VM_BROKEN_ROTOR_STATES, start)) return VM_NOT_FINITE;
    return vmi_check_broken_rotor(rotor);
}

/* Computes the results of vm_broken_rotor_linear, vm_broken_rotor_linear_uncoupled and vm_broken_rotor_free_motion. If
   coupled = 1, it solves the complete linearised equations (69). If coupled = 0, it leaves out the term -s p^2 omega^2
   y of the equation of psi. */
VM_API int vmi_broken_rotor_linearised(const vm_broken_rotor *rotor, vm_real t, const vm_real *start, int coupled,
                                       vm_real *end)
{
    vm_real y[VM_BROKEN_ROTOR_STATES], z[VMI_BROKEN_ROTOR_COUPLED], x0, vx0, rate;
    vmi_broken_rotor_linear a;
    vmi_broken_rotor_swing g;
    const int status = vmi_broken_rotor_check_motion(rotor, t, start, end);
    if (status) return status;
    a = vmi_broken_rotor_reduced(rotor, coupled);
    rate = vmi_broken_rotor_rate(&a);
    if (!VM_IS_FINITE(rate)) return VM_NOT_FINITE;
    g = vmi_broken_rotor_swing_at(t, a.omega);
    z[VMI_BROKEN_ROTOR_Y] = start[VM_BROKEN_ROTOR_X + 1];
    z[VMI_BROKEN_ROTOR_PSI] = start[VM_BROKEN_ROTOR_ANGLE];
    z[VMI_BROKEN_ROTOR_Y_RATE] = start[VM_BROKEN_ROTOR_V + 1];
    z[VMI_BROKEN_ROTOR_PSI_RATE] = start[VM_BROKEN_ROTOR_OMEGA];
    if (a.coupling != 0 || VM_FABS(t) * rate <= 2) vmi_broken_rotor_advance(t, &a, z);
    else vmi_broken_rotor_follow(t, &a, &g, z);
    x0 = start[VM_BROKEN_ROTOR_X];
    vx0 = start[VM_BROKEN_ROTOR_V];
    y[VM_BROKEN_ROTOR_X] = x0 * g.c + (vx0 * g.s_w - a.s * g.c1); /* the solution (70) */
    y[VM_BROKEN_ROTOR_V] = vx0 * g.c - g.w_s * (x0 + a.s);
    y[VM_BROKEN_ROTOR_X + 1] = z[VMI_BROKEN_ROTOR_Y];
    y[VM_BROKEN_ROTOR_ANGLE] = z[VMI_BROKEN_ROTOR_PSI];
    y[VM_BROKEN_ROTOR_V + 1] = z[VMI_BROKEN_ROTOR_Y_RATE];
    y[VM_BROKEN_ROTOR_OMEGA] = z[VMI_BROKEN_ROTOR_PSI_RATE];
    return vmi_copy_if_finite(VM_BROKEN_ROTOR_STATES, y, end);
}

/* State of the remainder t seconds after the state `start`, by the complete linearised equations (69).
   The result describes the rotor for short times, while |psi| << 1, because solutions of (69) grow exponentially with
   t. t may have any sign. The arrays start and end have VM_BROKEN_ROTOR_STATES numbers, and end may be the same array
   as start. The fields damping, stiffness and s may be 0. Rounding of all inputs, t included, would change the result;
   the error of the function is at most this change. Only if damping slows the rotation, psi' may have an additional
   error, of a few eps^2 of its value in `start`. Returns VM_BAD_ARGUMENT for a null pointer; VM_NOT_FINITE if an
   argument, the result or a coefficient of (69) is infinite or NaN; VM_BAD_MASS or VM_BAD_INERTIA if the mass or the
   inertia of the rotor is not positive; VM_BAD_STIFFNESS if the stiffness is negative; VM_OK otherwise. */
VM_API int vm_broken_rotor_linear(const vm_broken_rotor *rotor, vm_real t, const vm_real *start, vm_real *end)
{
    return vmi_broken_rotor_linearised(rotor, t, start, 1, end);
}

/* State of the remainder t seconds after the state `start`, by the solution (70)-(72), which lacks one term of (69).
   The dissertation [1] leaves out the term -s p^2 omega^2 y, although it is as large as the other terms. Use this
   function only to compare [1] with vm_broken_rotor_linear. Rounding of all inputs would change the result; the error
   of the function is at most three times this change. The arguments and the statuses are those of
   vm_broken_rotor_linear. */
VM_API int vm_broken_rotor_linear_uncoupled(const vm_broken_rotor *rotor, vm_real t, const vm_real *start, vm_real *end)
{
    return vmi_broken_rotor_linearised(rotor, t, start, 0, end);
}

/* State of the unbroken rotor t seconds after the state `start`, by the exact solution (46)-(51).
   t may have any sign. The arrays start and end have VM_BROKEN_ROTOR_STATES numbers, and end may be the same array as
   start. The fields damping and stiffness may be 0. Rounding of all inputs, t included, would change the result; the
   error of the function is at most this change. Returns VM_BAD_ARGUMENT for a null pointer; VM_NOT_FINITE if an
   argument or the result is infinite or NaN; VM_BAD_MASS or VM_BAD_INERTIA if the mass or the inertia of the rotor is
   not positive; VM_BAD_STIFFNESS if the stiffness is negative; VM_DOMAIN if s is not 0; VM_OK otherwise. */
VM_API int vm_broken_rotor_free_motion(const vm_broken_rotor *rotor, vm_real t, const vm_real *start, vm_real *end)
{
    const int status = vmi_broken_rotor_check_motion(rotor, t, start, end);
    if (status) return status;
    if (rotor->s != 0) return VM_DOMAIN;
    return vmi_broken_rotor_linearised(rotor, t, start, 0, end); /* for s = 0 the linearised equations are exact (46) */
}

/* Constants A0, B0, C0, D0 (51) of the unbroken rotor's elliptic orbit, m. The function writes these constants to the
   array abcd of 4 numbers. The orbit of the mass centre is, with w^2 = stiffness/mass and w > 0,
     x + i y = (A0 + i B0) exp(i w t) + (C0 + i D0) exp(-i w t).                                                   (50)
   Its semi-axes are the sum and the absolute difference of |A0 + i B0| and |C0 + i D0|. The speed of the mass centre at
   the time t, which the dissertation [1] prints wrongly after (52), is
     w sqrt(A0^2 + B0^2 + C0^2 + D0^2 - 2 (A0 C0 + B0 D0) cos(2 w t) + 2 (B0 C0 - A0 D0) sin(2 w t)).
   Returns VM_BAD_ARGUMENT for a null pointer; VM_NOT_FINITE if an argument or the result is infinite or NaN;
   VM_BAD_MASS or VM_BAD_INERTIA if the mass or the inertia of the rotor is not positive; VM_BAD_STIFFNESS if the
   stiffness is not positive; VM_OK otherwise. */
VM_API int vm_broken_rotor_orbit(const vm_broken_rotor *rotor, const vm_real *start, vm_real *abcd)
{
    vm_real w, x, y, vx, vy, c[4];
    int status;
    if (!rotor || !start || !abcd) return VM_BAD_ARGUMENT;
    if (!vmi_all_finite(VM_BROKEN_ROTOR_STATES, start)) return VM_NOT_FINITE;
    status = vmi_check_broken_rotor(rotor);
    if (rotor->stiffness == 0 && (!status || status == VM_BAD_INERTIA)) status = VM_BAD_STIFFNESS;
    if (status) return status;
    w = VM_SQRT(rotor->stiffness / rotor->mass);
    x = start[VM_BROKEN_ROTOR_X];
    y = start[VM_BROKEN_ROTOR_X + 1];
    vx = start[VM_BROKEN_ROTOR_V] / w;
    vy = start[VM_BROKEN_ROTOR_V + 1] / w;
    c[0] = (x + vy) / 2;
    c[1] = (y - vx) / 2;
    c[2] = (x - vy) / 2;
    c[3] = (y + vx) / 2;
    return vmi_copy_if_finite(4, c, abcd);
}

#endif
