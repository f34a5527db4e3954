/* oscillators/loads.h - mass that joins or leaves an oscillator with a velocity, and damping that depends on time

   In the equation of motion of a vm_osc_problem (oscillators/problem.h) the mass that joins or leaves has the absolute
   velocity u = 0, and the damping is constant. Equation (248) of the dissertation has the reactive force m' (u - x')
   with any velocity u along x. A vm_osc_load adds the missing part m' u of this force, and a damping that depends on
   time, on the right side:
     m x'' + k x|x|^(alpha-1) + (reactive m' + b) x' = reactive m' u(t) - damping(t) x' + force(t, x, x')
   m' is the rate of the mass, and u(t) the absolute velocity of the mass that joins or leaves. damping(t) is a law of
   time; b is the constant damping of the problem. `force` is the further force that the problem had before, if any. The
   motion is computed by those routes of oscillators/routes.h that allow a force: the first-order averaged equations and
   the integrations. The shortest useful call, for a problem with the fields of oscillators/problem.h:
       const vm_law u = vm_law_linear(VM_C(0.3), 0), damping = vm_law_linear(VM_C(0.02), VM_C(0.001));
       vm_osc_load load;
       vm_osc_motion motion;
       int status = vm_osc_load_init(&load, &problem, &u, &damping); // 0.3 m/s; 0.02 kg/s, growing
       if (!status) status = vm_osc_within(&problem, 10, VM_C(1e-6), &motion);
   To first order a thrust m' u does not change the averaged amplitude, since the work of the thrust over a period is 0.
   The thrust only moves the middle of the vibration, for alpha = 1 by m' u/k. The results of the averaged equations do
   not contain this shift; their field `error`, an estimate, includes it. With damping(t) the amplitude follows
   vm_osc_amplitude_law; the argument decay of this function is computed by vm_law_ratio_integral(&damping, &mass, t,
   &decay).
   Tests: tests/test_loads.c. */
#ifndef VARMASS_OSCILLATORS_LOADS_H
#define VARMASS_OSCILLATORS_LOADS_H

#include "../base/real.h"
#include "../base/status.h"
#include "laws.h"
#include "problem.h"

/* What vm_osc_load_force adds to an oscillator. vm_osc_load_init fills the load. The problem then points to it, so the
   load must exist at the same address as long as the problem is used. */
typedef struct VM_TAG(vm_osc_load) {
    vm_law mass;        /* mass m(t) of the oscillator, kg, whose rate m' the thrust needs */
    vm_law u;           /* velocity of the mass that joins or leaves, m/s */
    vm_law damping;     /* damping, kg/s, in addition to the damping of the problem; positive damping takes energy
                           out */
    vm_real reactive;   /* share of the thrust m' u that acts; vm_osc_load_init copies it from the problem. If u is the
                           velocity relative to the oscillator, set the field `reactive` of the problem to 0, call
                           vm_osc_load_init, and then set this field to 1. */
    vm_osc_force force; /* the further force that the problem had before, or NULL */
    void *ctx;          /* the user's pointer, last argument of the function `force` */
} vm_osc_load;

/* Force of a vm_osc_load on an oscillator, N: reactive m' u(t) - damping(t) v + force(t, x, v).
   The function is a vm_osc_force, which vm_osc_load_init makes the force of a problem. Its last argument `load` points
   to the vm_osc_load. t is the time (s), x the position (m) and v the velocity (m/s). Each call evaluates the laws of
   mass, u and damping once. Returns NaN for a null pointer, for arguments that are infinite or NaN, and where a law has
   no value at t; the functions of oscillators/routes.h then return VM_NOT_INTEGRATED or VM_NOT_FINITE. */
VM_API vm_real vm_osc_load_force(vm_real t, vm_real x, vm_real v, void *load)
{
    if (!load) return VM_NAN;
    const vm_osc_load *l = (const vm_osc_load *)load;
    vm_real mass, rate, u, damping, force, unused;
    int status = vmi_law_at(&l->mass, VM_BAD_MASS, t, &mass, &rate);
    if (!status) status = vmi_law_at(&l->u, VM_OK, t, &u, &unused);
    if (!status) status = vmi_law_at(&l->damping, VM_OK, t, &damping, &unused);
    if (status || !VM_IS_FINITE(x) || !VM_IS_FINITE(v)) return VM_NAN;
    force = l->reactive * rate * u - damping * v;
    if (l->force) force += l->force(t, x, v, l->ctx);
    return force;
}

/* Gives an oscillator a velocity u of the mass that joins or leaves, and a damping that depends on time.
   u_or_NULL is the law of this velocity, m/s, and damping_or_NULL the law of the damping, kg/s, which adds to the
   problem's constant damping; a null pointer means 0. The function fills *load, and sets problem->force and
   problem->ctx so that the problem uses *load. A force that the problem had before still acts. Call vm_osc_load_init
   once for a problem, after the other fields of the problem are set. If u or damping is a table, the integrations make
   no stop at the points of this table. Therefore the integrations need more steps, but they are not less accurate.
   Returns VM_BAD_ARGUMENT if load or problem is null, for a law that no constructor made, and for a problem that has
   this load already; VM_NOT_FINITE where a number of the problem or a law at t = 0 is infinite or NaN; VM_BAD_MASS or
   VM_BAD_STIFFNESS for a mass or a stiffness that is not positive at t = 0 or in its table; VM_DOMAIN for alpha < 0,
   for a law that has no value at t = 0, and for a table or a change_time that is not valid; VM_OK otherwise. An error
   leaves *load and *problem untouched. */
VM_API int vm_osc_load_init(vm_osc_load *load, vm_osc_problem *problem, const vm_law *u_or_NULL,
                            const vm_law *damping_or_NULL)
{
    vm_osc_load l;
    vm_real mass, stiffness;
    int status;
    if (!load || !problem || problem->ctx == load) return VM_BAD_ARGUMENT;
    status = vmi_osc_check_problem(problem, 0, &mass, &stiffness);
    if (u_or_NULL) status = vmi_first_error(status, vmi_law_check(u_or_NULL, VM_OK, 0));
    if (damping_or_NULL) status = vmi_first_error(status, vmi_law_check(damping_or_NULL, VM_OK, 0));
    if (status) return status;
    l.mass = problem->mass;
    l.u = vm_law_linear(0, 0);
    if (u_or_NULL) l.u = *u_or_NULL;
    l.damping = vm_law_linear(0, 0);
    if (damping_or_NULL) l.damping = *damping_or_NULL;
    l.reactive = problem->reactive;
    l.force = problem->force;
    l.ctx = problem->ctx;
    *load = l;
    problem->force = vm_osc_load_force;
    problem->ctx = load;
    return VM_OK;
}

#endif
