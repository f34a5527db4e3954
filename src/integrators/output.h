/* integrators/output.h - the solution at listed times
   rk45_solve_at and rk87_solve_at fill a table with the state at times that the caller lists. If a listed time is
   inside a step, the continuous extension of the step gives the state. So the steps need not end at the listed times,
   and the list does not make them shorter.

       double times[3] = {1, 2, 5}, rows[3][2], y0[2] = {1, 0}, work[RK45_WORK(2)];
       rk45 s;
       rk45_init(&s, spring, NULL, 2, 0.0, y0, NULL, work); // spring is the ode_rhs of ode.h
       if (rk45_solve_at(&s, 3, times, rows[0], NULL) >= 0) printf("x(5) = %g\n", rows[2][0]);

   Tests: tests/test_dense.c. */
#ifndef VARMASS_INTEGRATORS_OUTPUT_H
#define VARMASS_INTEGRATORS_OUTPUT_H

#include "../base/real.h"
#include "dense.h"
#include "ode.h"
#include "options.h"
#include "rk45.h"
#include "rk87.h"
#include "runs.h"
#include "steps.h"

/* Returns 1 if a run at the time t has reached `time`, else 0. The run goes forward (direction 1) or backward (-1). */
VM_API int vmi_has_reached(vm_real t, vm_real time, int direction)
{
    if (direction > 0) return t >= time;
    return t <= time;
}

/* Returns 1 if the times begin at t or later, as seen in the direction of the run, and follow each other in this
   direction, else 0. */
VM_API int vmi_times_are_in_order(vm_real t, int n_times, const vm_real *times, int direction)
{
    int i;
    for (i = 0; i < n_times; i++) {
        if (!VM_IS_FINITE(times[i]) || !vmi_has_reached(times[i], t, direction)) return 0;
        t = times[i];
    }
    return 1;
}

/* Writes the state to the row of each listed time that the run has reached, beginning with the row *done. *done
   becomes the number of filled rows. Returns a status. */
VM_API int vmi_fill_rows(rk45 *s, int n_times, const vm_real *times, int direction, vm_real *rows, int *done)
{
    while (*done < n_times && vmi_has_reached(s->t, times[*done], direction)) {
        const int status = vmi_interpolate(s, times[*done], rows + (ptrdiff_t)*done * s->n);
        if (status) { /* f failed in the continuous extension; another call begins with this step */
            vmi_take_back_step(s);
            return status;
        }
        ++*done;
    }
    return ODE_OK;
}

/* Make one step by rk45 or rk87. These two functions are not inlined, because gcc -O1 refuses to inline a function that
   is called by a pointer. */
VMI_APART int vmi_rk45_step_to(rk45 *s, vm_real t_end) { return vmi_rk45_run(s, s->f, s->n, t_end, 1); }
VMI_APART int vmi_rk87_step_to(rk45 *s, vm_real t_end) { return vmi_rk87_run(s, s->f, s->n, t_end, 1); }

/* Does the work of rk45_solve_at for the pair whose number is `method`. The function `step` makes one step by this
   pair. */
VM_API int vmi_solve_at(rk45 *s, int method, int (*step)(rk45 *s, vm_real t_end), int n_times, const vm_real *times,
                        vm_real *rows, int *n_done_or_NULL)
{
    int direction = 1, done = 0, status = ODE_OK, was_stiff;
    if (!s || s->pair.method != method || n_times < 0) return ODE_BAD_ARGUMENT;
    if (n_times > 0 && (!times || !rows)) return ODE_BAD_ARGUMENT;
    if (n_times > 0 && times[n_times - 1] < s->t) direction = -1;
    if (!vmi_times_are_in_order(s->t, n_times, times, direction)) return ODE_BAD_ARGUMENT;
    was_stiff = s->stiff;
    s->attempts = s->options.max_steps;
    s->event = -1;
    for (;;) {
        const int filled = vmi_fill_rows(s, n_times, times, direction, rows, &done);
        if (filled) status = filled;
        if (done == n_times || (status != ODE_OK && status != ODE_STIFF)) break;
        status = step(s, times[n_times - 1]);
    }
    if (n_done_or_NULL) *n_done_or_NULL = done;
    return status == ODE_OK && s->stiff > was_stiff ? (int)ODE_STIFF : status;
}

/* Continues a run of rk45 to the last of n_times times and writes the state at each of them to a row of n numbers. The
   times start at s->t or later and rise, or start at s->t or earlier and fall; equal times are allowed. The array rows
   has n_times times n numbers. *n_done_or_NULL becomes the number of rows that are filled. If neither an event nor an
   error ends the run, all rows are filled; else another call with the remaining times continues the run. If an event
   changes the state at a listed time, the row has the new state. The values are those of rk45_interpolate; the row of
   the last time has the values of s->y. Returns a status, as rk45_solve does. The status is ODE_BAD_ARGUMENT if times
   are not finite or neither rise nor fall in this way. */
VM_API int rk45_solve_at(rk45 *s, int n_times, const vm_real *times, vm_real *rows, int *n_done_or_NULL)
{
    return vmi_solve_at(s, VMI_RK45, vmi_rk45_step_to, n_times, times, rows, n_done_or_NULL);
}

/* Continues a run of rk87 to the last of n_times times and writes the state at each of them to a row of n numbers.
   All else is as in rk45_solve_at. A step with listed times before its end takes seven more evaluations of f, which may
   also end the run with ODE_RHS_STOPPED or ODE_NOT_FINITE. */
VM_API int rk87_solve_at(rk87 *s, int n_times, const vm_real *times, vm_real *rows, int *n_done_or_NULL)
{
    return vmi_solve_at(s, VMI_RK87, vmi_rk87_step_to, n_times, times, rows, n_done_or_NULL);
}

#endif
