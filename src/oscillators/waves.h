/* oscillators/waves.h - the wave forms of a strongly nonlinear oscillator: cosine, cn, ca */
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

/* Routes to x(t), x'(t), the cheapest first. q = (ln k)' + (2r-1)(ln m)' + 2b/m is the rate at which things change,
   Om the rate of the Ateb phase; q/Om must be small for the first four. */
enum {
    VM_ROUTE_TRIG = 0,      /* (329), (330), averaged to first order, with the sign of (335) mended */
    VM_ROUTE_JACOBI = 1,    /* (370), (371), averaged to first order */
    VM_ROUTE_ATEB = 2,      /* (310), (311), averaged to first order: error q/Om */
    VM_ROUTE_SECOND = 3,    /* the second-order law: error (q/Om)^2; without F only */
    VM_ROUTE_VARIATION = 4, /* exact equations of amplitude and phase, (314), (315) completed, by rk45 */
    VM_ROUTE_RK45 = 5,      /* the equation of motion itself */
    VM_ROUTE_RK87 = 6
};

/* A periodic function that stands for the motion, x = A c, x' = -speed vmax(A) s, as a function of the Ateb phase
   psi, of which its own angle is turn psi. In the averaged equations with a force F by mass, V = speed vmax(A),
     A'/A = -q/(alpha+3) - gain_A <F s>/V,   theta' = -gain_theta <F c>/V   (in its own angle) */
typedef struct VM_TAG(vmi_osc_wave) {
    int method;
    vm_real alpha, turn, speed, gain_A, gain_theta;
    vm_real m; /* k^2 of cn */
    const ateb_plan *ateb;
} vmi_osc_wave;

VM_API vmi_osc_wave vmi_osc_wave_of(int method, vm_real alpha, vm_real pi, const ateb_plan *ateb_or_NULL)
{
    vmi_osc_wave w;
    w.method = method;
    w.alpha = alpha;
    w.ateb = ateb_or_NULL;
    w.turn = w.speed = w.gain_theta = 1;
    w.gain_A = 2 / (alpha + 1);
    w.m = 0;
    if (method == VM_ROUTE_TRIG) {
        w.turn = VM_PI / pi;
        w.gain_A = w.gain_theta = 4 / (alpha + 3); /* 5 - alpha in (337)-(339): the sign in (335) */
    }
    if (method == VM_ROUTE_JACOBI) {
        vm_real C2, C4, C6, bracket;
        w.m = jacobi_solve_kpK(pi / (alpha + 1));
        w.turn = 2 * jacobi_K(w.m) / pi;
        jacobi_cn_means(w.m, &C2, &C4, &C6);
        bracket = (1 - w.m) + w.m * C4; /* = 2 <sn^2 dn^2> */
        w.gain_A = 4 / ((alpha + 3) * bracket);
        w.gain_theta = 1 / bracket;
    }
    if (method != VM_ROUTE_ATEB) w.speed = (alpha + 1) / 2 * w.turn;
    return w;
}

VM_API void vmi_osc_wave_at(const vmi_osc_wave *w, vm_real psi, vm_real *c, vm_real *s)
{
    if (w->method == VM_ROUTE_TRIG) vmi_sincos(w->turn * psi, s, c);
    else if (w->method == VM_ROUTE_JACOBI) {
        vm_real dn;
        jacobi_sncndn(w->turn * psi, w->m, s, c, &dn);
        *s *= dn;
    } else if (w->ateb) ateb_plan_saca(w->ateb, psi, s, c);
    else ateb_saca(psi, w->alpha, s, c);
}

/* Largest differences from ca and sa, over a quarter of the period, at points that crowd where x = 0 */
VM_API void vmi_osc_wave_errors(const vmi_osc_wave *w, vm_real pi, vm_real *x_error, vm_real *v_error)
{
    const int points = 256;
    int i;
    *x_error = *v_error = 0;
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

/* -- The plan -- */
VM_API const char *vm_osc_route_name(int route)
{
    switch (route) {
    case VM_ROUTE_TRIG: return "trigonometric";
    case VM_ROUTE_JACOBI: return "Jacobi";
    case VM_ROUTE_ATEB: return "Ateb, first order";
    case VM_ROUTE_SECOND: return "second-order law";
    case VM_ROUTE_VARIATION: return "variation of constants, rk45";
    case VM_ROUTE_RK45: return "direct, rk45";
    case VM_ROUTE_RK87: return "direct, rk87";
    default: return "unknown route";
    }
}

#endif
