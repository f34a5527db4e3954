/* Functions that are easier to write in C than in Python: loops over times, and structs that Python does not need to
   know. varmass.py compiles this file together with the headers. The route -1 stands for the cheapest route within the
   tolerance. */
#include <time.h>
#include "varmass.h"

typedef struct { double alpha, mass[2], stiffness[2], reactive, damping, x, v; } oscillator;

static int prepare(vm_osc_plan *plan, const oscillator *o)
{
    vm_osc_problem p = {0};
    p.alpha = o->alpha;
    p.mass = vm_law_linear(o->mass[0], o->mass[1]);
    p.stiffness = vm_law_linear(o->stiffness[0], o->stiffness[1]);
    p.reactive = o->reactive;
    p.damping = o->damping;
    p.x = o->x;
    p.v = o->v;
    return vm_osc_plan_init(plan, &p);
}

static int motion_at(const vm_osc_plan *plan, int route, double t, double tolerance, vm_osc_motion *m)
{
    if (route < 0) return vm_osc_plan_within(plan, t, tolerance, m);
    return vm_osc_plan_by_route(plan, route, t, tolerance, m);
}

/* The motion at n times; the statuses are those of vm_osc_plan_within. */
int py_oscillator(const oscillator *o, int route, double tolerance, int n, const double *t, double *x, double *v,
                  double *amplitude, double *error, int *routes)
{
    vm_osc_plan plan;
    int status = prepare(&plan, o), i;
    for (i = 0; i < n && status >= 0; i++) {
        vm_osc_motion m;
        status = motion_at(&plan, route, t[i], tolerance, &m);
        if (status < 0) break;
        x[i] = m.x;
        v[i] = m.v;
        amplitude[i] = m.amplitude;
        error[i] = m.error;
        routes[i] = m.route;
    }
    return status < 0 ? status : 0;
}

/* Returns the processor time in s of one call that computes the motion at t from a plan that was made before */
double py_seconds(const oscillator *o, int route, double t, double tolerance)
{
    vm_osc_plan plan;
    vm_osc_motion m;
    double taken = 0, each = 0;
    long n, i;
    if (prepare(&plan, o)) return VM_NAN;
    for (n = 1; taken < 0.01; n *= 4) {
        const clock_t start = clock();
        for (i = 0; i < n; i++) {
            if (motion_at(&plan, route, t, tolerance, &m) < 0) return VM_NAN;
        }
        taken = (double)(clock() - start) / CLOCKS_PER_SEC;
        each = taken / (double)n;
    }
    return each;
}

/* Computes a body on which no torque acts at n times after t = 0 */
int py_rotation(const vm_body *body, int n, const double *t, vm_body *later)
{
    vm_torque_free motion;
    int status = vm_torque_free_init(&motion, body, 0), i;
    for (i = 0; i < n && status >= 0; i++) status = vm_torque_free_at(&motion, t[i], later + i);
    return status;
}

/* Computes the solution of y' = f(t, y) that starts with y0 at t[0]: a row of n numbers for each of the `count`
   times */
int py_solve(ode_rhs f, int n, double rtol, double atol, const double *y0, int count, const double *t, double *y,
             double *work)
{
    rk87 s;
    rk87_options o = {0};
    int status;
    o.rtol = rtol;
    o.atol = atol;
    status = rk87_init(&s, f, NULL, n, t[0], y0, &o, work);
    return status < 0 ? status : rk87_solve_at(&s, count, t, y, NULL);
}

/* The number of elements of the work space that py_solve needs */
int py_work(int n) { return RK87_WORK(n); }
