/* oscillators/waves.h - the periodic functions ca, cos and cn that describe a strongly nonlinear oscillator

   The motion of x'' + omega0^2 x|x|^(alpha-1) = 0 is x = A ca(psi), x' = -vmax(A) sa(psi) with the Ateb functions of
   the phase psi, (282) and (283) of the dissertation; A is the amplitude, vmax(A) the largest velocity. Two simpler
   waves with the same amplitude and period approximate ca: cos (291), (329) and Jacobi's cn (297), (370). A
   vmi_osc_wave describes one of these three waves: the wave c of the position, the wave s of the velocity, and the
   factors turn, speed, gain_A and gain_theta. Each wave has an angle of its own, the argument of ca, cos or cn. While
   psi grows by 1, this angle grows by `turn`, which is 1 for ca. A small force F on the mass m adds a slow part theta
   to the angle. The averaged equations are then
     A'/A = -q/(alpha+3) - gain_A <F s>/(m V),   theta' = -gain_theta <F c>/(m V),   V = speed vmax(A),
   where <> is the mean over a period, and q the rate at which damping and slow changes of stiffness and mass change the
   motion. To add another wave, write a constructor and a function that evaluates the wave.
       vmi_osc_wave w = vmi_osc_wave_cn(3, ateb_pi(3));
       vm_real c, s;
       vmi_osc_wave_at(&w, VM_C(0.5), &c, &s); // at psi = 0.5: x = A c, x' = -w.speed vmax(A) s
   Tests: tests/test_constant_mass.c, tests/test_averaging.c. */
#ifndef VARMASS_OSCILLATORS_WAVES_H
#define VARMASS_OSCILLATORS_WAVES_H

#include "../ateb/functions.h"
#include "../ateb/plans.h"
#include "../base/elementary.h"
#include "../base/real.h"
#include "../jacobi/functions.h"
#include "../jacobi/integrals.h"
#include "../jacobi/means.h"
#include "../jacobi/modulus.h"

typedef struct VM_TAG(vmi_osc_wave) vmi_osc_wave;
struct VM_TAG(vmi_osc_wave) {
    /* writes to *c the wave of the position, and to *s the wave of the velocity, at the Ateb phase psi */
    void (*at)(const vmi_osc_wave *w, vm_real psi, vm_real *c, vm_real *s);
    /* estimates the error of the wave compared with ca, where mean_ca2 is the mean of ca^2; null for ca itself */
    vm_real (*error)(const vmi_osc_wave *w, vm_real mean_ca2);
    vm_real alpha;              /* exponent of the spring */
    vm_real turn;               /* the wave's own angle, the argument of ca, cos or cn, is turn psi */
    vm_real speed;              /* the velocity is x' = -speed vmax(A) s */
    vm_real gain_A, gain_theta; /* the factors gain_A and gain_theta in the averaged equations at the top of this
                                   file */
    vm_real m;                  /* parameter m = k^2 of cn; 0 for ca and cos */
    vm_real mean_c2;            /* mean of cn^2; 0 for ca and cos */
    const ateb_plan *ateb;      /* plan of ca, or null */
};

/* Writes to *c the wave of the position, and to *s the wave of the velocity, at the Ateb phase psi. */
VM_API void vmi_osc_wave_at(const vmi_osc_wave *w, vm_real psi, vm_real *c, vm_real *s) { w->at(w, psi, c, s); }

/* -- ca: exact -- */
VM_API void vmi_osc_ca_at(const vmi_osc_wave *w, vm_real psi, vm_real *c, vm_real *s)
{
    ateb_saca(psi, w->alpha, s, c);
}

VM_API void vmi_osc_ca_by_plan(const vmi_osc_wave *w, vm_real psi, vm_real *c, vm_real *s)
{
    ateb_plan_saca(w->ateb, psi, s, c);
}

/* Makes the wave x = A ca(psi), x' = -vmax(A) sa(psi). With a plan of the Ateb functions for this alpha, the wave is
   evaluated faster. */
VM_API vmi_osc_wave vmi_osc_wave_ca(vm_real alpha, const ateb_plan *ateb_or_NULL)
{
    vmi_osc_wave w;
    w.at = ateb_or_NULL ? vmi_osc_ca_by_plan : vmi_osc_ca_at;
    w.error = NULL;
    w.alpha = alpha;
    w.turn = 1;
    w.speed = 1;
    w.gain_A = 2 / (alpha + 1);
    w.gain_theta = 1;
    w.m = 0;
    w.mean_c2 = 0;
    w.ateb = ateb_or_NULL;
    return w;
}

/* -- cos: exact for alpha = 1 -- */
VM_API void vmi_osc_cos_at(const vmi_osc_wave *w, vm_real psi, vm_real *c, vm_real *s)
{
    vmi_sincos(w->turn * psi, s, c);
}

/* Estimates the error of cos in place of ca. The estimate is the error of the velocity at x = 0, where the velocity is
   largest, times a factor that grows with alpha. */
VM_API vm_real vmi_osc_cos_error(const vmi_osc_wave *w, vm_real mean_ca2)
{
    (void)mean_ca2;
    return VM_FABS(w->speed - 1) * (1 + w->alpha / 100);
}

/* Makes the wave x = A cos(turn psi), whose period is that of ca; the argument `pi` is Pi_alpha, half the period of ca.
   The fields gain_A and gain_theta become the factors 4/(alpha + 3) in the averaged equations (337)-(339). The
   dissertation has 5 - alpha instead of alpha + 3, because of a wrong sign in (335). */
VM_API vmi_osc_wave vmi_osc_wave_cos(vm_real alpha, vm_real pi)
{
    vmi_osc_wave w = vmi_osc_wave_ca(alpha, NULL);
    w.at = vmi_osc_cos_at;
    w.error = vmi_osc_cos_error;
    w.turn = VM_PI / pi;
    w.speed = (alpha + 1) / 2 * w.turn;
    w.gain_A = 4 / (alpha + 3);
    w.gain_theta = w.gain_A;
    return w;
}

/* -- cn: exact for alpha = 1 and 3 -- */

/* Writes c = cn and s = sn dn at the Ateb phase psi. The argument of cn, sn and dn is turn psi. */
VM_API void vmi_osc_cn_at(const vmi_osc_wave *w, vm_real psi, vm_real *c, vm_real *s)
{
    vm_real sn, dn;
    jacobi_sncndn(w->turn * psi, w->m, &sn, c, &dn);
    *s = sn * dn;
}

/* Estimates the error of cn in place of ca. The estimate is the difference between the means of cn^2 and of ca^2, times
   a factor that fits the largest errors of cn. This difference is 0 where cn is exact. */
VM_API vm_real vmi_osc_cn_error(const vmi_osc_wave *w, vm_real mean_ca2)
{
    return VM_FABS(w->mean_c2 - mean_ca2) * (VM_C(2.7) + w->alpha / 2);
}

/* Makes the wave x = A cn(turn psi | m), whose period and whose velocity at x = 0 are those of A ca(psi); the argument
   `pi` is Pi_alpha, half the period of ca. The parameter m follows from (307), the factors gain_A and gain_theta from
   (380)-(382). */
VM_API vmi_osc_wave vmi_osc_wave_cn(vm_real alpha, vm_real pi)
{
    vmi_osc_wave w = vmi_osc_wave_ca(alpha, NULL);
    vm_real C2, C4, C6, bracket; /* the means of cn^2, cn^4 and cn^6; bracket is twice the mean of sn^2 dn^2 */
    w.at = vmi_osc_cn_at;
    w.error = vmi_osc_cn_error;
    w.m = jacobi_solve_kpK(pi / (alpha + 1));
    w.turn = 2 * jacobi_K(w.m) / pi;
    w.speed = (alpha + 1) / 2 * w.turn;
    jacobi_cn_means(w.m, &C2, &C4, &C6);
    w.mean_c2 = C2;
    bracket = (1 - w.m) + w.m * C4;
    w.gain_A = 4 / ((alpha + 3) * bracket);
    w.gain_theta = 1 / bracket;
    return w;
}

/* -- How good a wave is -- */

/* Estimates the larger one of the errors of x/A and of x'/vmax that the wave w in place of ca causes; the result is at
   most 1. mean_ca2 is the mean of ca^2. */
VM_API vm_real vmi_osc_wave_error(const vmi_osc_wave *w, vm_real mean_ca2)
{
    const vm_real error = w->error ? w->error(w, mean_ca2) : 0;
    return vmi_smaller(error, 1);
}

/* Writes to *x_error the largest difference between the wave c and ca, and to *v_error the largest difference between
   w->speed s and sa. The function compares the waves at 257 points of a quarter of the period, which are densest near x
   = 0. The argument `pi` is Pi_alpha, half the period of ca. */
VM_API void vmi_osc_wave_differences(const vmi_osc_wave *w, vm_real pi, vm_real *x_error, vm_real *v_error)
{
    const int points = 256;
    int i;
    *x_error = 0;
    *v_error = 0;
    for (i = 0; i <= points; i++) {
        const vm_real u = (vm_real)i / (vm_real)points, psi = pi / 2 * (1 - u * u);
        vm_real sa, ca, c, s;
        ateb_saca(psi, w->alpha, &sa, &ca);
        vmi_osc_wave_at(w, psi, &c, &s);
        c = VM_FABS(c - ca);
        s = VM_FABS(w->speed * s - sa);
        if (c > *x_error) *x_error = c;
        if (s > *v_error) *v_error = s;
    }
}

#endif
