/* For Frama-C's EVA: integrators.h on two equations whose right-hand side returns any numbers, and any status. */
#include "../integrators.h"

volatile vm_real any;
volatile int any_int;

static int right_hand_side(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t, (void)y, (void)ctx;
    dydt[0] = any, dydt[1] = any;
    return any_int;
}

int main(void)
{
    vm_real y[2], y_low[2], t = any, work[RK87_WORK(2)];
    rk45 s;
    y[0] = any, y[1] = any, y_low[0] = y_low[1] = 0;
    rk4_step(right_hand_side, NULL, 2, any, any, y, work);
    rk4_solve(right_hand_side, NULL, 2, &t, any, 3, y, work);
    rk4_solve_compensated(right_hand_side, NULL, 2, &t, any, 3, y, y_low, work);
    if (rk45_init(&s, right_hand_side, NULL, 2, any, y, NULL, work) >= 0) {
        rk45_step(&s);
        rk45_interpolate(&s, any, y);
        rk45_restart(&s, any, y);
        rk45_step(&s);
    }
    if (rk87_init(&s, right_hand_side, NULL, 2, any, y, NULL, work) >= 0) {
        rk87_step(&s);
        rk87_interpolate(&s, any, y);
    }
    return 0;
}
