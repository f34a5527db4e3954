/* oscillators/problem.h - the data of an oscillator whose mass and stiffness vary slowly, and of its motion

   The equation of motion, with mass m(t), stiffness k(t), damping b and a further small force F, is
     m x'' + k x|x|^(alpha-1) + (reactive m' + b) x' = F(t, x, x'),   x(0) and x'(0) given.
   Ten methods, called routes, compute x(t) and x'(t). The functions of the routes are in oscillators/routes.h, which
   also shows the shortest useful call. `reactive` is 1 where mass that joins or leaves is at rest, and 0 where this
   mass has the body's velocity. With a plan (oscillators/plan.h) one motion is evaluated at many values of t.
   Tests: tests/test_averaging.c, tests/test_routes.c. */
#ifndef VARMASS_OSCILLATORS_PROBLEM_H
#define VARMASS_OSCILLATORS_PROBLEM_H

#include "../base/arrays.h"
#include "../base/real.h"
#include "../base/status.h"
#include "laws.h"

/* Routes, which are the methods to compute x(t) and x'(t), the cheapest first. Numbers in brackets are equations of the
   dissertation. The first seven use averaging: for these, mass and stiffness must change little within a period. The
   routes VM_ROUTE_ORDER2 to VM_ROUTE_ORDER5 exist only if there is no further force F. */
enum {
    VM_ROUTE_TRIG = 0,        /* cosine (329), (330), averaged to first order; the sign of (335) is corrected */
    VM_ROUTE_JACOBI = 1,      /* Jacobi's cn (370), (371), averaged to first order */
    VM_ROUTE_ATEB = 2,        /* Ateb function ca (310), (311), averaged to first order */
    VM_ROUTE_ORDER2 = 3,      /* the law of order five (oscillators/expansion.h), cut off after order two */
    VM_ROUTE_ORDER3 = 4,      /* the law of order five, cut off after order three */
    VM_ROUTE_ORDER4 = 5,      /* the law of order five, cut off after order four */
    VM_ROUTE_ORDER5 = 6,      /* the whole law of order five */
    VM_ROUTE_COLLOCATION = 7, /* integration from each zero of x to the next (oscillators/collocation.h) */
    VM_ROUTE_RK45 = 8,        /* integration of the equation of motion by rk45 */
    VM_ROUTE_RK87 = 9         /* integration of the equation of motion by rk87 */
};

/* Returns the order, 2 to 5, after which the law of order five is cut off by one of the routes VM_ROUTE_ORDER2 to
   VM_ROUTE_ORDER5. */
VM_API int vmi_osc_order_of(int route) { return route - VM_ROUTE_ORDER2 + 2; }

/* Returns the route, VM_ROUTE_ORDER2 to VM_ROUTE_ORDER5, that cuts off the law of order five after the given order, 2
   to 5. */
VM_API int vmi_osc_route_of_order(int order) { return VM_ROUTE_ORDER2 + order - 2; }

/* A user's function for a further small force. It returns the force F, N, at the time t (s), the position x (m) and the
   velocity v (m/s). */
typedef vm_real (*vm_osc_force)(vm_real t, vm_real x, vm_real v, void *ctx);

/* An oscillator and its state at t = 0 */
typedef struct VM_TAG(vm_osc_problem) {
    vm_real alpha;      /* exponent of the spring's force, >= 0 */
    vm_law mass;        /* mass m(t), kg, positive */
    vm_law stiffness;   /* stiffness k(t), N/m^alpha, positive */
    vm_real reactive;   /* share of the full reactive force: 1 where mass that joins or leaves is at rest, 0 where this
                           mass has the body's own velocity, as in a leak; numbers between are allowed */
    vm_real damping;    /* damping b, kg/s, the dissertation's eps b; a positive b takes energy out */
    vm_real x, v;       /* position, m, and velocity, m/s, at t = 0 */
    vm_osc_force force; /* function for a further small force F, or NULL */
    void *ctx;          /* the user's pointer, last argument of `force` */
} vm_osc_problem;

/* The motion at one time */
typedef struct VM_TAG(vm_osc_motion) {
    vm_real x, v;      /* position, m, and velocity, m/s */
    vm_real amplitude; /* amplitude A, m. The routes rk45 and rk87, and with a force collocation, give the amplitude
                          that belongs to x and v. All other routes leave out the ripple of first order; the ripple is
                          the swing of the amplitude within a period, which damping and slow changes of mass and
                          stiffness cause */
    vm_real error;     /* estimate of the larger of |error of x|/A and |error of v|/vmax, where vmax is the largest
                          velocity at the amplitude A; it includes all causes of errors */
    int route;         /* the route by which x and v were computed, VM_ROUTE_... */
    long evals;        /* number of evaluations of the equations that were integrated; 0 where nothing was integrated */
} vm_osc_motion;

/* Checks mass and stiffness by vmi_law_check: both must be finite and positive between 0 and t. */
VM_API int vmi_osc_check_laws(const vm_osc_problem *o, vm_real t)
{
    return vmi_first_error(vmi_law_check(&o->mass, VM_BAD_MASS, t),
                           vmi_law_check(&o->stiffness, VM_BAD_STIFFNESS, t));
}

/* Checks the fields of the problem, and its laws between 0 and t. Writes mass and stiffness at t = 0. */
VM_API int vmi_osc_check_problem(const vm_osc_problem *o, vm_real t, vm_real *mass, vm_real *stiffness)
{
    const vm_real numbers[5] = {o->alpha, o->reactive, o->damping, o->x, o->v};
    vm_real f[VMI_LAW_ORDERS];
    int status = vmi_osc_check_laws(o, t);
    if (!vmi_all_finite(5, numbers)) status = vmi_first_error(status, VM_NOT_FINITE);
    if (o->alpha < 0) status = vmi_first_error(status, VM_DOMAIN);
    if (status) return status;
    status = vmi_law_derivatives(&o->mass, VM_BAD_MASS, 0, 1, 0, f);
    *mass = f[0];
    if (!status) status = vmi_law_derivatives(&o->stiffness, VM_BAD_STIFFNESS, 0, 1, 0, f);
    *stiffness = f[0];
    return status;
}

#endif
