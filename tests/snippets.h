/* What the short pieces of C in the headers' comments take as given. tests/test_snippets.sh includes this, then the piece as
   the body of a function. */
#include "varmass.h"
#include <stdio.h>

extern vm_body body;           /* the rocket */
extern vm_stream nozzle;       /* what leaves it */
extern vm_real dry;            /* its mass without fuel, kg */
extern vm_body whole, part;    /* a body, and what leaves it in an instant */
extern vm_osc_problem problem; /* an oscillator ... */
extern vm_osc_plan plan;       /* ... after vm_osc_plan_init */
extern vmi_osc_reduced reduced; /* its reduced state at t = 0 */
extern vm_vdp vdp;             /* Van der Pol's oscillator, with all fields set */
extern vmi_orbit orbit;        /* a motion under an odd force, complete */
extern vm_forced forced;       /* after vm_forced_init */
extern vm_scene scene;         /* a scene whose state has two numbers */
extern vm_real y[2];           /* its state, from vm_scene_start */

/* functions of the user */
vm_real f(vm_real x, void *ctx);                                          /* for vmi_find_zero */
int spring(vm_real t, const vm_real *state, vm_real *rates, void *ctx);   /* an ode_rhs */
int fall(vm_real t, const vm_real *state, vm_real *rates, void *ctx);     /* an ode_rhs */
int hard(vm_real x, vm_real *f, void *ctx);                               /* a vm_odd_function */
vm_real height(vm_real t, const vm_real *state, void *ctx);               /* an ode_event_function */
void motion(vm_real t, vm_real *x, vm_real *v, void *ctx);                /* a vm_motion_function */
void pivot(vm_real t, vm_vec3 *r, vm_vec3 *v, vm_vec3 *a, void *ctx);     /* a vm_moving_point */
