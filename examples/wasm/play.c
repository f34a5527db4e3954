/* The functions that the page play.html calls: they compute an oscillator whose mass, stiffness and damping change
   slowly, by any route and tolerance, and a tumbling body that throws off a part. The page reads the results at the
   address numbers().

   make wasm writes build/wasm/play.html, which contains this program and needs no server.
   cc -O2 play.c -lm && ./a.out prints the same numbers as node play.mjs play.wasm, bit for bit. */
#include <stdio.h>
#include "../../varmass.h"

#ifdef __wasm__
#define EXPORT(name) __attribute__((export_name(#name))) name
#else
#define EXPORT(name) name
#endif

enum { MOST = 1500, CONSTANT = 0, LINEAR = 1, EXPONENTIAL = 2, POWER = 3 };

static double results[2 * MOST];
static vm_osc_plan plan;
static vm_torque_free whole_motion, rest_motion, part_motion;
static double jump_time;

double *EXPORT(numbers)(void);
int EXPORT(oscillator)(double alpha, int law, double rate, double damping, double reactive);
int EXPORT(motion)(double tolerance, double end, int n);
int EXPORT(motion_at)(int route, double t, double tolerance);
double EXPORT(tumble)(double part_mass, double part_speed, double t_jump);
int EXPORT(tumble_at)(double t);

double *numbers(void) { return results; }

/* The mass in kg: 1 at first, and changing at `rate` per second */
static vm_law mass_law(int law, double rate)
{
    switch (law) {
    case LINEAR: return vm_law_linear(1, rate);
    case EXPONENTIAL: return vm_law_exponential(1, rate);
    case POWER: return vm_law_power(1, rate, 2); /* (1 + rate t)^2 */
    default: return vm_law_linear(1, 0);
    }
}

/* Prepares the motion (m x')' + b x' + x |x|^(alpha-1) = 0 that starts at rest at x = 1 m. Returns the status. */
int oscillator(double alpha, int law, double rate, double damping, double reactive)
{
    vm_osc_problem problem;
    memset(&problem, 0, sizeof problem);
    problem.alpha = alpha;
    problem.mass = mass_law(law, rate);
    problem.stiffness = vm_law_linear(1, 0);
    problem.damping = damping;
    problem.reactive = reactive;
    problem.x = 1;
    return vm_osc_plan_init(&plan, &problem);
}

/* Computes x and the amplitude at n times from 0 to `end`, and stores them in turn. Returns how many of the times are
   before the time at which no mass is left. */
int motion(double tolerance, double end, int n)
{
    vm_osc_motion now;
    int i;
    for (i = 0; i < n && i < MOST; i++) {
        if (vm_osc_plan_within(&plan, end * i / (n - 1), tolerance, &now) < 0) return i;
        results[2 * i] = now.x;
        results[2 * i + 1] = now.amplitude;
    }
    return i;
}

/* Computes x, amplitude, estimated error, route and number of evaluations at the time t, by the given route, or by the
   cheapest route within the tolerance if `route` is negative. Returns the status. */
int motion_at(int route, double t, double tolerance)
{
    vm_osc_motion now;
    int status;
    if (route < 0) status = vm_osc_plan_within(&plan, t, tolerance, &now);
    else status = vm_osc_plan_by_route(&plan, route, t, tolerance, &now);
    if (status < 0) return status;
    results[0] = now.x;
    results[1] = now.amplitude;
    results[2] = now.error;
    results[3] = now.route;
    results[4] = (double)now.evals;
    return status;
}

/* A plate of 10 kg that turns about its middle axis throws off a part at t_jump. Computes how the rest and the part
   move after the jump. Returns the energy in J that the separation gave, or NaN. */
double tumble(double part_mass, double part_speed, double t_jump)
{
    vm_body whole = {10, {0.5, 0.9, 1.2, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0.05, 3, 0}};
    vm_body now, part, rest;
    vm_vec3 arm = {0.7, 0, 0}, push = {0, 0, 0};
    const double own = part_mass * 0.01;
    jump_time = t_jump;
    if (vm_torque_free_init(&whole_motion, &whole, 0) < 0 || vm_torque_free_at(&whole_motion, t_jump, &now) < 0) return VM_NAN;
    part = now;
    part.mass = part_mass;
    part.inertia.xx = part.inertia.yy = part.inertia.zz = own;
    arm = vm_rotate(now.q, arm);
    push.x = part_speed;
    push = vm_rotate(now.q, push);
    part.r = vm_add(now.r, arm);
    part.v = vm_add(vm_add(now.v, vm_cross(now.omega, arm)), push);
    if (vm_separate(&now, &part, NULL, &rest) != VM_OK) return VM_NAN;
    if (vm_torque_free_init(&rest_motion, &rest, t_jump) < 0 || vm_torque_free_init(&part_motion, &part, t_jump) < 0)
        return VM_NAN;
    return vm_energy_gain(&now, 1, &part, NULL, &rest);
}

static double *write_body(double *to, const vm_body *b)
{
    to[0] = b->r.x;
    to[1] = b->r.y;
    to[2] = b->r.z;
    to[3] = b->q.w;
    to[4] = b->q.x;
    to[5] = b->q.y;
    to[6] = b->q.z;
    return to + 7;
}

/* Computes position and attitude of the whole before the jump, or of the rest and the part after it. Returns the
   number of bodies. */
int tumble_at(double t)
{
    vm_body body;
    double *to = results;
    if (t < jump_time) {
        if (vm_torque_free_at(&whole_motion, t, &body) < 0) return 0;
        write_body(to, &body);
        return 1;
    }
    if (vm_torque_free_at(&rest_motion, t, &body) < 0) return 0;
    to = write_body(to, &body);
    if (vm_torque_free_at(&part_motion, t, &body) < 0) return 0;
    write_body(to, &body);
    return 2;
}

#ifndef __wasm__
int main(void)
{
    int route, i, n;
    oscillator(1.5, LINEAR, -0.01, 0.002, 0);
    for (route = -1; route <= VM_ROUTE_RK87; route++) {
        if (motion_at(route, 30, 1e-9) < 0) continue;
        printf("%2d %.16e %.16e %.16e %g %g\n", route, results[0], results[1], results[2], results[3], results[4]);
    }
    n = motion(1e-6, 60, 4);
    for (i = 0; i < 2 * n; i++) printf("%.16e\n", results[i]);
    printf("%.16e\n", tumble(1, 2, 5));
    n = 7 * tumble_at(9);
    for (i = 0; i < n; i++) printf("%.16e\n", results[i]);
    return 0;
}
#endif
