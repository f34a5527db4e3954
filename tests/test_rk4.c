/* integrators.h: rk4_step, rk4_solve and rk4_solve_compensated. The measured order, the energy over a million steps
   with and without compensation, and runs that are refused or end early, against closed forms. */
#include "integrator_check.h"

/* ---- Order ---- */

static double error_at_2(long steps)
{
    vm_real y[3] = {1, 0, 1}, work[RK4_WORK(3)], t = 0;
    CHECK(rk4_solve(linear_rhs, NULL, 3, &t, 2, steps, y, work) == ODE_OK && t == 2);
    return linear_error(y, 2);
}

static double error_of_time(long steps)
{
    vm_real y[1] = {1}, work[RK4_WORK(1)], t = 0;
    CHECK(rk4_solve(time_rhs, NULL, 1, &t, 1, steps, y, work) == ODE_OK);
    return fabs((double)y[0] - exp(1.));
}

static void test_orders(void)
{
    if (is_float) return; /* in float rounding hides them */
    check_order("rk4", log2(error_at_2(40) / error_at_2(80)), 4, 0.1);
    check_order("rk4, f of t", log2(error_of_time(40) / error_of_time(80)), 4, 0.2);
}

/* A run of rk4_solve has the bits of the same steps by rk4_step. */
static void test_single_steps(void)
{
    vm_real y[3] = {1, 0, 1}, by_steps[3] = {1, 0, 1}, work[RK4_WORK(3)], t = 0;
    int i;
    CHECK(rk4_solve(linear_rhs, NULL, 3, &t, 2, 16, y, work) == ODE_OK);
    for (i = 0; i < 16; i++)
        CHECK(rk4_step(linear_rhs, NULL, 3, R(i) / 8, R(0.125), by_steps, work) == ODE_OK);
    CHECK(memcmp(y, by_steps, sizeof y) == 0);
}

/* ---- A million steps ---- */

/* The relative error of the energy of x'' = -x^3 after a million steps */
static double energy_error(int compensated)
{
    const double h = is_float ? 1. / 512 : 1. / 4096;
    const long steps = 1000000;
    const vm_real t_end = R((double)steps * h);
    vm_real y[2] = {1, 0}, low[2] = {0, 0}, work[RK4_WORK(2)], t = 0;
    int status;
    if (compensated) status = rk4_solve_compensated(cubic_rhs, NULL, 2, &t, t_end, steps, y, low, work);
    else status = rk4_solve(cubic_rhs, NULL, 2, &t, t_end, steps, y, work);
    CHECK(status == ODE_OK && t == t_end);
    return fabs((double)y[1] * (double)y[1] / 2 + pow((double)y[0], 4) / 4 - 0.25) / 0.25;
}

/* With compensation the roundings do not add up. */
static void test_compensated(void)
{
    const double plain = energy_error(0), compensated = energy_error(1);
    printf("energy after 1e6 steps of rk4: off by %.1e, compensated %.1e\n", plain, compensated);
    CHECK(compensated < 4 * eps && plain > 20 * compensated && plain < 2000 * eps);
}

/* ---- Runs that end early or are refused ---- */

/* f ends at t = 1: the run stops at the last good step, which is at 0.9. */
static void test_endings(void)
{
    wall w = {1, 0};
    for (w.use_nan = 0; w.use_nan < 2; w.use_nan++) {
        vm_real y[1] = {1}, work[RK4_WORK(1)], t = 0;
        CHECK(rk4_solve(wall_rhs, &w, 1, &t, 2, 20, y, work) == (w.use_nan ? ODE_NOT_FINITE : ODE_RHS_STOPPED));
        check_error("y before the end", "f stops, rk4", "1e-6", 1e6 * fabs((double)y[0] * exp((double)t) - 1), 2,
                    (double)t, w.use_nan);
        CHECK(fabs((double)t - 0.9) < 1e-6);
    }
}

static void test_refusals(void)
{
    vm_real y[1] = {1}, low[1] = {0}, work[RK4_WORK(1)], t = 0;
    CHECK(rk4_step(time_rhs, NULL, 0, 0, 1, y, work) == ODE_BAD_ARGUMENT);
    CHECK(rk4_solve(time_rhs, NULL, 1, &t, 1, 0, y, work) == ODE_BAD_ARGUMENT);
    CHECK(rk4_solve(time_rhs, NULL, 1, &t, VM_INFINITY, 10, y, work) == ODE_BAD_ARGUMENT);
    CHECK(rk4_solve(NULL, NULL, 1, &t, 1, 10, y, work) == ODE_BAD_ARGUMENT && t == 0 && y[0] == 1);
    CHECK(rk4_solve_compensated(time_rhs, NULL, 1, &t, 1, 10, y, NULL, work) == ODE_BAD_ARGUMENT && y[0] == 1);
    CHECK(rk4_solve_compensated(time_rhs, NULL, 1, &t, 1, 0, y, low, work) == ODE_BAD_ARGUMENT && t == 0);
}

int main(void)
{
    test_orders();
    test_single_steps();
    test_compensated();
    test_endings();
    test_refusals();
    return check_finish("rk4");
}
