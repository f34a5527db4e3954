/* varmass.h: free rotation in closed form beside rk45 and rk87 (integrators.h) and the C library's sin: the error
   of attitude after so many turns against the time that it took, and what preparing a motion costs. Each row: a
   body, a method, the tolerance, turns, error (rad), microseconds. Errors are taken against the closed form, which
   tests/test_rotation compares with 60-digit values; a CSV file of the table is written where one is named. */
#include "timing.h"

#include "../varmass.h"
#include <stdio.h>

enum { POINTS = 256 };

typedef struct case_of {
    const char *name;
    vm_vec3 moments, omega;
} case_of;

static const vm_quat unit = {1, 0, 0, 0};
static const case_of *body;
static vm_free_motion motion;
static vm_real times[POINTS], sink;
static double t_end, tolerance, sines[POINTS];
static vm_quat reached;
static FILE *csv;

static int free_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    const vm_vec3 J = *(const vm_vec3 *)ctx;
    (void)t;
    dydt[0] = (J.y - J.z) * y[1] * y[2] / J.x;
    dydt[1] = (J.z - J.x) * y[2] * y[0] / J.y;
    dydt[2] = (J.x - J.y) * y[0] * y[1] / J.z;
    dydt[3] = -(y[4] * y[0] + y[5] * y[1] + y[6] * y[2]) / 2;
    dydt[4] = (y[3] * y[0] + y[5] * y[2] - y[6] * y[1]) / 2;
    dydt[5] = (y[3] * y[1] + y[6] * y[0] - y[4] * y[2]) / 2;
    dydt[6] = (y[3] * y[2] + y[4] * y[1] - y[5] * y[0]) / 2;
    return 0;
}

static void start(vm_real *y, rk45_options *options, vm_vec3 *J)
{
    static const rk45_options none;
    *options = none;
    options->rtol = options->atol = (vm_real)tolerance;
    options->max_steps = 100000000;
    *J = body->moments;
    y[0] = body->omega.x, y[1] = body->omega.y, y[2] = body->omega.z;
    y[3] = 1, y[4] = y[5] = y[6] = 0;
}

static void take(const vm_real *y) { reached.w = y[3], reached.x = y[4], reached.y = y[5], reached.z = y[6]; }

static void by_rk45(void)
{
    vm_real y[7], work[RK45_WORK(7)];
    rk45_options options;
    vm_vec3 J;
    rk45 s;
    start(y, &options, &J);
    rk45_init(&s, free_rhs, &J, 7, 0, y, &options, work);
    if (rk45_solve_with(&s, free_rhs, 7, (vm_real)t_end) < 0) puts("rk45 failed");
    take(s.y);
}

static void by_rk87(void)
{
    vm_real y[7], work[RK87_WORK(7)];
    rk87_options options;
    vm_vec3 J;
    rk87 s;
    start(y, &options, &J);
    rk87_init(&s, free_rhs, &J, 7, 0, y, &options, work);
    if (rk87_solve_with(&s, free_rhs, 7, (vm_real)t_end) < 0) puts("rk87 failed");
    take(s.y);
}

static void by_closed_form(void) /* in one call, prepared for this one time */
{
    vm_vec3 omega;
    vm_free_init_principal(&motion, body->moments, unit, body->omega, 0);
    vm_free_attitude(&motion, (vm_real)t_end, &reached, &omega);
}

static void evaluate(void)
{
    int i;
    for (i = 0; i < POINTS; i++) {
        vm_vec3 omega;
        vm_free_attitude(&motion, times[i], &reached, &omega);
        sink += omega.x;
    }
}

static void prepare(void) { vm_free_init_principal(&motion, body->moments, unit, body->omega, 0); }

static void prepare_tilted(void)
{
    static const vm_inertia tilted = {3, 2, VM_C(2.5), VM_C(0.1), VM_C(0.2), VM_C(-0.3)};
    vm_body b = {1, {0, 0, 0, 0, 0, 0}, {1, 2, 3, 4}, {0, 0, 0}, {0, 0, 0}, {1, 2, 3}};
    vm_free_motion m;
    b.inertia = tilted;
    if (!vm_free_init(&m, &b, 0)) sink += m.phase_rate.hi;
}

static void library_sin(void)
{
    int i;
    for (i = 0; i < POINTS; i++) sink += (vm_real)sin(sines[i]);
}

static double error_of(vm_quat q)
{
    const double w = (double)(q.w - reached.w), x = (double)(q.x - reached.x), y = (double)(q.y - reached.y);
    const double z = (double)(q.z - reached.z);
    return 2 * sqrt(w * w + x * x + y * y + z * z);
}

/* The least of some, in microseconds: what disturbs only adds */
static double least_us(void (*body_of_loop)(void))
{
    double least = call_ns(body_of_loop, 1);
    int i;
    for (i = 0; i < 6 && least < 2e7; i++) {
        const double ns = call_ns(body_of_loop, 1);
        if (ns < least) least = ns;
    }
    return least / 1e3;
}

static void report(const char *method, double tol, double turns, double error, double us)
{
    printf("%-12s %-8s %7.0e %9.0f %10.1e %12.2f\n", body->name, method, tol, turns, error, us);
    if (csv) fprintf(csv, "%s,%s,%g,%g,%g,%g\n", body->name, method, tol, turns, error, us);
}

static void compare(double turns)
{
    static const double tolerances[] = {1e-6, 1e-9, 1e-12};
    const double speed = sqrt((double)vmi_dot(body->omega, body->omega));
    vm_quat exact;
    int i;
    t_end = turns * 8 * atan(1) / speed;
    by_closed_form();
    exact = reached;
    report("exact", 0, turns, 0, least_us(by_closed_form));
    for (i = 0; i < 3; i++) {
        double us;
        tolerance = tolerances[i];
        us = least_us(by_rk45);
        report("rk45", tolerance, turns, error_of(exact), us);
        us = least_us(by_rk87);
        report("rk87", tolerance, turns, error_of(exact), us);
    }
}

int main(int argc, char **argv)
{
    static const case_of cases[] = {
        {"triaxial", {3, 2, 1}, {VM_C(0.25), VM_C(0.5), VM_C(1.5)}},
        {"m > 1/2", {3, 2, 1}, {VM_C(0.2), VM_C(1.0), VM_C(0.5)}},
        {"middle axis", {3, 2, 1}, {VM_C(1e-6), 1, VM_C(1e-6)}},
        {"symmetric", {2, 2, 1}, {VM_C(0.5), VM_C(1.25), VM_C(-0.75)}},
    };
    int i, k;
    csv = argc > 1 ? fopen(argv[1], "w") : NULL;
    if (csv) fputs("body,method,tolerance,turns,error,microseconds\n", csv);
    for (k = 0; k < POINTS; k++)
        sines[k] = 20.0 * rand() / RAND_MAX - 10, times[k] = (vm_real)(1e4 * rand() / RAND_MAX);
    printf("free rotation: a prepared motion at any time, and its preparation\n%-12s %10s %8s %12s\n", "body",
           "at, ns", "sin", "prepare, us");
    for (i = 0; i < 4; i++) {
        timing at;
        body = cases + i;
        prepare();
        at = time_beside(evaluate, POINTS, library_sin, POINTS);
        printf("%-12s %10.0f %8.1f %12.2f\n", body->name, at.ns, at.ratio, least_us(prepare));
    }
    printf("with products of inertia and an attitude: prepare %.2f us\n\n", least_us(prepare_tilted));
    printf("%-12s %-8s %7s %9s %10s %12s\n", "body", "method", "tol", "turns", "error, rad", "us");
    for (i = 0; i < 3; i += 2) {
        body = cases + i;
        compare(1), compare(100);
    }
    body = cases;
    compare(2000);
    if (csv) fclose(csv);
    return sink == 1;
}
