/* integrators/rk45.h - rk45: adaptive runs by a Runge-Kutta pair of orders 5 and 4
   Tsitouras' pair [1] has seven stages. The last stage of a step is also the first stage of the next step, so that a
   step takes six evaluations of f. The continuous extension of order 4, which gives the states inside a step, takes no
   further evaluation. Try this method first. It is better than rk87 in float, for loose tolerances, for right-hand
   sides that are not smooth, and for many events.

       double y0[2] = {1, 0}, work[RK45_WORK(2)];
       rk45 s;
       rk45_init(&s, spring, NULL, 2, 0.0, y0, NULL, work); // spring is the ode_rhs of ode.h
       if (rk45_solve(&s, 10.0) >= 0) printf("x(10) = %g\n", s.y[0]);

   Tests: tests/gen/order_conditions.py, tests/test_adaptive.c, tests/test_dense.c, tests/test_events.c. */
#ifndef VARMASS_INTEGRATORS_RK45_H
#define VARMASS_INTEGRATORS_RK45_H

#include "../base/arrays.h"
#include "../base/real.h"
#include "dense.h"
#include "loop.h"
#include "ode.h"
#include "options.h"
#include "pairs.h"
#include "runs.h"

enum { VMI_RK45 = 45 }; /* the value of the field `method` for this pair, rk45 */

/* Computes stages 2 to 7 of a step of Tsitouras' pair [1]. Its coefficients, which are published to 16 digits, satisfy
   the order conditions with an error of 2e-14. */
VMI_FOLDED int vmi_rk45_stages(vmi_rk_system sys, vm_real t, vm_real t_new, vm_real h, long *evals)
{
    const ptrdiff_t m = sys.m;
    const vm_real *y = sys.w + VMI_Y * m;
    vm_real *z = sys.w + VMI_Z * m, *k1 = sys.w + VMI_K * m, *k2 = k1 + m, *k3 = k2 + m, *k4 = k3 + m, *k5 = k4 + m,
            *k6 = k5 + m, *k7 = k6 + m;
    int i;
    VMI_EACH(i, sys.n) z[i] = y[i] + VMI_H(0.161) * k1[i];
    VMI_EVAL(t + VMI_H(0.161), z, k2);
    VMI_EACH(i, sys.n) z[i] = y[i] - VMI_H(0.008480655492356989) * k1[i] + VMI_H(0.335480655492357) * k2[i];
    VMI_EVAL(t + VMI_H(0.327), z, k3);
    VMI_EACH(i, sys.n)
    z[i] = y[i] + VMI_H(2.8971530571054935) * k1[i] - VMI_H(6.359448489975075) * k2[i] +
           VMI_H(4.3622954328695815) * k3[i];
    VMI_EVAL(t + VMI_H(0.9), z, k4);
    VMI_EACH(i, sys.n)
    z[i] = y[i] + VMI_H(5.325864828439257) * k1[i] - VMI_H(11.748883564062828) * k2[i] +
           VMI_H(7.4955393428898365) * k3[i] - VMI_H(0.09249506636175525) * k4[i];
    VMI_EVAL(t + VMI_H(0.9800255409045097), z, k5);
    VMI_EACH(i, sys.n)
    z[i] = y[i] + VMI_H(5.86145544294642) * k1[i] - VMI_H(12.92096931784711) * k2[i] +
           VMI_H(8.159367898576159) * k3[i] - VMI_H(0.071584973281401) * k4[i] -
           VMI_H(0.028269050394068383) * k5[i];
    VMI_EVAL(t_new, z, k6);
    VMI_EACH(i, sys.n)
    z[i] = y[i] + VMI_H(0.09646076681806523) * k1[i] + VMI_H(0.01) * k2[i] + VMI_H(0.4798896504144996) * k3[i] +
           VMI_H(1.379008574103742) * k4[i] - VMI_H(3.290069515436081) * k5[i] + VMI_H(2.324710524099774) * k6[i];
    VMI_EVAL(t_new, z, k7);
    return 0;
}

/* Returns the largest ratio of the error of a component to its tolerance, at most VMI_WORST, or NaN if the error or the
   new state is not finite. The error is the difference of the two new states, of order 5 and of order 4. */
VMI_FOLDED vm_real vmi_rk45_error(const rk45_options *o, vmi_rk_system sys, vm_real h)
{
    const ptrdiff_t m = sys.m;
    const vm_real *y = sys.w + VMI_Y * m, *z = sys.w + VMI_Z * m, *k1 = sys.w + VMI_K * m, *k2 = k1 + m, *k3 = k2 + m,
                  *k4 = k3 + m, *k5 = k4 + m, *k6 = k5 + m, *k7 = k6 + m;
    vm_real worst = 0, bad = 0;
    int i;
    VMI_EACH(i, sys.n)
    vmi_weigh(o, i,
              h * (VM_C(-0.00178001105222577714) * k1[i] - VM_C(0.0008164344596567469) * k2[i] +
                   VM_C(0.007880878010261995) * k3[i] - VM_C(0.1447110071732629) * k4[i] +
                   VM_C(0.5823571654525552) * k5[i] - VM_C(0.45808210592918697) * k6[i] +
                   VM_C(0.01515151515151515152) * k7[i]),
              y[i], z[i], &worst, &bad);
    return VMI_SMALLER(worst, VMI_WORST) + bad;
}

/* Returns, for the test of stiffness, the factor of k_{j+1} in the state of stage 7 minus its factor in the state of
   stage 6. Both stages evaluate f at the end of the step. */
VM_API vm_real vmi_rk45_end_difference(int j)
{
    VM_TABLE vm_real weights[6] = {VM_C(-5.764994676128355), VM_C(12.93096931784711),   VM_C(-7.67947824816166),
                                   VM_C(1.4505935473851428), VM_C(-3.2618004650420125), VM_C(2.324710524099774)};
    return VM_READ(weights[j]);
}

/* Computes the weights b[0], b[1] ... of k_1, k_2 ... in Tsitouras' continuous extension [1], which has order 4, at
   the fraction x of the step */
VM_API void vmi_rk45_weights(vm_real x, vm_real *b)
{
    const vm_real xx = x * x;
    b[0] = VM_C(-1.0530884977290216) * x * (x - VM_C(1.3299890189751412)) *
           ((x - VM_C(1.4364028541716351)) * x + VM_C(0.7139816917074209));
    b[1] = VM_C(0.1017) * xx * ((x - VM_C(2.1966568338249754)) * x + VM_C(1.2949852507374631));
    b[2] = VM_C(2.490627285651252793) * xx * ((x - VM_C(2.38535645472061657)) * x + VM_C(1.57803468208092486));
    b[3] = VM_C(-16.54810288924490272) * xx * (x - VM_C(1.21712927295533244)) * (x - VM_C(0.61620406037800089));
    b[4] = VM_C(47.37952196281928122) * xx * (x - VM_C(1.203071208372362603)) * (x - VM_C(0.658047292653547382));
    b[5] = VM_C(-34.87065786149660974) * xx * (x - VM_C(1.2)) * (x - VM_C(0.666666666666666667));
    b[6] = VM_C(2.5) * xx * (x - 1) * (x - VM_C(0.6));
}

/* Computes the state y at the fraction x of the last step by the continuous extension. The function is not inlined, so
   that the compiler fuses its multiplications and additions in one way only: equal x give equal y. */
VMI_APART void vmi_rk45_inside(const rk45 *s, vm_real x, vm_real *y)
{
    vm_real b[7];
    vmi_rk45_weights(x, b);
    vmi_weigh_inside(s, 7, b, x, y);
}

/* Returns the descriptor of rk45: its vmi_rk_pair. */
VMI_FOLDED vmi_rk_pair vmi_rk45_pair(void)
{
    vmi_rk_pair pair;
    pair.method = VMI_RK45;
    pair.order = 5;
    pair.stages = 7;
    pair.last_is_first = 1;
    pair.derivatives = 7;
    pair.rounding = 16;
    pair.keep_from = VM_C(0.25);
    pair.stiff_beyond = VM_C(3.4);
    pair.end_difference = vmi_rk45_end_difference;
    pair.inside = vmi_rk45_inside;
    pair.extend = NULL;
    return pair;
}

/* Makes steps of rk45 to t_end, or only one if `single` is not 0. f and n are those of s. Returns a status. */
VMI_LOOP int vmi_rk45_run(rk45 *s, ode_rhs f, int n, vm_real t_end, int single)
{
    vmi_rk_stepper stepper;
    stepper.pair = vmi_rk45_pair();
    stepper.make_stages = vmi_rk45_stages;
    stepper.step_error = vmi_rk45_error;
    return vmi_run(s, stepper, f, n, t_end, single);
}

/* -- Functions for users -- */

#define RK45_WORK(n) (10 * (n)) /* number of elements of the array work for n components */

/* Returns the options of rk45 as rk45_init uses them. Each zero is replaced by its default (h0 and h_min stay 0), each
   negative tolerance by 0, and a positive rtol below 16 VM_EPSILON by 16 VM_EPSILON. If options_or_NULL is NULL, all
   options have their defaults. Do not pass a result with a tolerance 0 to rk45_init, which would replace this 0 by the
   default. */
VM_API rk45_options rk45_defaults(const rk45_options *options_or_NULL)
{
    const vmi_rk_pair pair = vmi_rk45_pair();
    return vmi_defaults(vmi_least_rtol(&pair), options_or_NULL);
}

/* Begins a run of y' = f(t, y) by rk45 from state y0 at time t0. y0 has n numbers, f receives the pointer ctx, and work
   has RK45_WORK(n) numbers and must exist as long as s. y0 and the options are copied, but not the arrays to which the
   options point. f is not evaluated yet. Returns ODE_OK; ODE_RTOL_RAISED if rtol was too small and was raised;
   ODE_BAD_ARGUMENT if an argument or an option is wrong; ODE_WORK_TOO_SMALL if options_or_NULL->work_size is too
   small. */
VM_INLINE int rk45_init(rk45 *s, ode_rhs f, void *ctx, int n, vm_real t0, const vm_real *y0,
                        const rk45_options *options_or_NULL, vm_real *work)
{
    return vmi_ode_init(s, vmi_rk45_pair(), f, ctx, n, t0, y0, options_or_NULL, work);
}

/* Continues a run of rk45 from another time or state, such as after a jump. The step size and the counters are kept. y
   has n numbers and may be s->y. If t is s->t, events that have just happened are not found again. Returns ODE_OK, or
   ODE_BAD_ARGUMENT if s or y is NULL or a number is not finite. */
VM_API int rk45_restart(rk45 *s, vm_real t, const vm_real *y) { return vmi_restart(s, t, y); }

/* Makes one accepted step of rk45, or the part of it before an event that ends the step. The step goes forward if s->h
   is positive or 0, and backward if s->h is negative; s->h is at first the option h0. Returns a status. */
VM_INLINE int rk45_step(rk45 *s)
{
    vm_real t_end;
    const int status = vmi_begin_step(s, VMI_RK45, &t_end);
    if (status) return status;
    return vmi_rk45_run(s, s->f, s->n, t_end, 1);
}

/* Makes steps of rk45 to t_end. The caller gives f and n once more, so that the compiler can inline f. It inlines f if
   f and n are constants in this call, wherever rk45_init was called. Returns ODE_BAD_ARGUMENT if f or n differs from
   the f or n of s. All else is as in rk45_solve. */
VM_INLINE int rk45_solve_with(rk45 *s, ode_rhs f, int n, vm_real t_end)
{
    const int status = vmi_begin_solve(s, VMI_RK45, f, n, t_end);
    if (status) return status;
    return vmi_end_solve(t_end, vmi_rk45_run(s, f, n, vmi_last_time(t_end), 0));
}

/* Makes steps of rk45 to t_end exactly, forward or backward, or to an event that ends the run. t_end may be infinite if
   there is such an event. If s->t is t_end already, s->event becomes -1 and s->y changes only by rounding errors: if an
   event has ended the last step just before t_end, a step shorter than the resolution of t is made. After an error s->t
   and s->y are those of the last accepted step. Returns a status. The status is ODE_MAX_STEPS after options.max_steps
   attempts; another call then continues the run. */
VM_INLINE int rk45_solve(rk45 *s, vm_real t_end)
{
    if (!s) return ODE_BAD_ARGUMENT;
    return rk45_solve_with(s, s->f, s->n, t_end);
}

/* Computes the state y(t) at a time t within the last step of rk45, accurate to order 4. y receives n numbers; f is not
   evaluated. Returns ODE_OK, or ODE_BAD_ARGUMENT if t is not between s->t_old and s->t. */
VM_API int rk45_interpolate(const rk45 *s, vm_real t, vm_real *y) { return vmi_interpolate_ready(s, VMI_RK45, t, y); }

#endif
