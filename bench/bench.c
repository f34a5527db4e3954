/* Time of each function as a ratio to the C library's sin in the same run, and of the integrators to hand-written
   loops. Medians of repeats; built for float too, where sinf is the measure. */
#include "timing.h"
#include <stdio.h>
#include "../varmass.h"

enum { COUNT = 2048 };
static vm_real arg[COUNT], parameter[COUNT];
static volatile vm_real sink;

static void print_ratio(const char *what, void (*body)(void), double calls, const char *yardstick_name,
                        void (*yardstick)(void), double yardstick_calls)
{
    const timing t = time_beside(body, calls, yardstick, yardstick_calls);
    printf("%-58s %8.1f ns %8.2f x %s\n", what, t.ns, t.ratio, yardstick_name);
}

static void fill(vm_real low, vm_real high, vm_real parameter_low, vm_real parameter_high)
{
    unsigned long state = 1;
    int i;
    for (i = 0; i < COUNT; i++) {
        state = (state * 1664525ul + 1013904223ul) & 0xfffffffful;
        arg[i] = low + (high - low) * ((vm_real)(state >> 8) / 16777216);
        state = (state * 1664525ul + 1013904223ul) & 0xfffffffful;
        parameter[i] = parameter_low + (parameter_high - parameter_low) * ((vm_real)(state >> 8) / 16777216);
    }
}

#define BODY(name, ...)                       \
    static void name(void)                    \
    {                                         \
        vm_real sum = 0, a = 0, b = 0, c = 0; \
        int i;                                \
        for (i = 0; i < COUNT; i++) {         \
            __VA_ARGS__;                      \
            sum += a + b + c;                 \
        }                                     \
        sink = sum;                           \
    }
BODY(run_sin, a = VM_LIBM(sin)(arg[i]))
BODY(run_K, a = jacobi_K(parameter[i]))
BODY(run_E, a = jacobi_E(parameter[i]))
BODY(run_sncndn, jacobi_sncndn(arg[i], parameter[i], &a, &b, &c))
BODY(run_solver, a = jacobi_solve_kpK(parameter[i]))
BODY(run_pi, a = ateb_pi(parameter[i]))
BODY(run_saca, ateb_saca(arg[i], parameter[i], &a, &b))

static void print_function(const char *what, void (*body)(void))
{
    print_ratio(what, body, COUNT, "sin", run_sin, COUNT);
}

/* ---- x'' = -x^3 ---- */

enum { STEPS = 2000 };

static int cubic(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t, (void)ctx;
    dydt[0] = y[1];
    dydt[1] = -y[0] * y[0] * y[0];
    return 0;
}

static void run_rk4(void)
{
    vm_real y[2] = {1, 0}, work[RK4_WORK(2)], t = 0;
    rk4_solve(cubic, NULL, 2, &t, 20, STEPS, y, work);
    sink = y[0];
}

static void run_rk4_by_hand(void)
{
    vm_real x = 1, v = 0, h = (vm_real)20 / STEPS;
    int i;
    for (i = 0; i < STEPS; i++) {
        vm_real a1 = v, b1 = -x * x * x, x2 = x + h / 2 * a1, a2 = v + h / 2 * b1, b2 = -x2 * x2 * x2;
        vm_real x3 = x + h / 2 * a2, a3 = v + h / 2 * b2, b3 = -x3 * x3 * x3, x4 = x + h * a3, a4 = v + h * b3;
        vm_real b4 = -x4 * x4 * x4;
        x += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
        v += h / 6 * (b1 + 2 * b2 + 2 * b3 + b4);
    }
    sink = x;
}

static long evals;

static void run_rk45(void)
{
    vm_real y[2] = {1, 0}, work[RK45_WORK(2)];
    rk45 s;
    rk45_init(&s, cubic, NULL, 2, 0, y, NULL, work);
    rk45_solve(&s, 200);
    sink = s.y[0];
    evals = s.evals;
}

int main(void)
{
    printf("varmass, %s, medians of %d, %d random arguments\n\n", sizeof(vm_real) == 8 ? "double" : "float",
           REPEATS, COUNT);
    fill(-10, 10, 0, 1);
    print_function("sin(u), -10 < u < 10", run_sin);
    print_function("jacobi_K(m), 0 < m < 1", run_K);
    print_function("jacobi_E(m), 0 < m < 1", run_E);
    print_function("jacobi_sncndn(u, m), -10 < u < 10, 0 < m < 1", run_sncndn);
    fill(-1, 1, 0, 1);
    print_function("jacobi_sncndn(u, m), -1 < u < 1, 0 < m < 1", run_sncndn);
    fill(-10, 10, 1, 2);
    print_function("jacobi_solve_kpK(c), 1 < c < 2", run_solver);
    fill(-10, 10, 0, 5);
    print_function("ateb_pi(alpha), 0 < alpha < 5", run_pi);
    print_function("ateb_saca(s, alpha), -10 < s < 10, 0 < alpha < 5", run_saca);
    fill(-10, 10, 5, 100);
    print_function("ateb_saca(s, alpha), -10 < s < 10, 5 < alpha < 100", run_saca);
    puts("\nx'' = -x^3, an evaluation of the right-hand side");
    print_ratio("a hand-written RK4 loop", run_rk4_by_hand, 4. * STEPS, "the loop", run_rk4_by_hand, 4. * STEPS);
    print_ratio("rk4_solve", run_rk4, 4. * STEPS, "the loop", run_rk4_by_hand, 4. * STEPS);
    run_rk45();
    print_ratio("rk45_solve, default tolerances", run_rk45, (double)evals, "the loop", run_rk4_by_hand, 4. * STEPS);
    return 0;
}
