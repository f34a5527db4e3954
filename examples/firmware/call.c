/* What one call costs on a microcontroller: CALL, an expression with the variables below, from HEADER. Prints its
   instructions, the mean of 16 calls, or with TIMES the most of so many calls at u = 0, 1/8, 2/8 ...; and the depth of its
   stack. Flash is the program's size less that of one with CALL = 0. */
#include HEADER
#include "board.h"

volatile vm_real input[4] = {(vm_real)0.75, (vm_real)0.3, (vm_real)1.7, 3}, output;
extern uint32_t stack_top[];

#ifdef PLAN
static PLAN plan;
#endif
#ifdef VARMASS_INTEGRATORS_H
static vm_real y[2] = {1, 0}, work[RK45_WORK(2)];
static rk45 run;

static int oscillate(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t;
    (void)ctx;
    dydt[0] = y[1];
    dydt[1] = -y[0] * y[0] * y[0];
    return 0;
}
#endif
#ifdef CONSTANT_PLAN
#include CONSTANT_PLAN
#endif
#ifdef PROBLEM
static vm_osc_problem problem;
static vm_osc_closed made;

static void set_problem(vm_real rate)
{
    problem.alpha = (vm_real)1.7;
    problem.mass = vm_law_linear(10, rate / 10);
    problem.stiffness = vm_law_linear(100, 0);
    problem.reactive = 1;
    problem.x = (vm_real)0.1;
}
#endif
#ifdef VARMASS_H
static vm_body2 whole = {2, 3, 0, 0, 0, 0, 0, 1}, part = {1, (vm_real)0.1, 1, 0, 0, 0, 0, 1}, rest;
#endif

static int __attribute__((noinline, noclone)) call(vm_real u, vm_real m, vm_real alpha, vm_real n)
{
    vm_real a = 0, b = 0, c = 0;
    (void)u;
    (void)m;
    (void)alpha;
    (void)n;
    CALL;
    output = a + b + c;
    return 0;
}

enum { DEPTH = 1500 }; /* words of stack that are painted */

int main(void)
{
    const uint32_t paint = 0xdeadbeefu;
    volatile uint32_t *low, here = 0;
    uint32_t start, used;
    long i;
#ifdef INIT
    INIT;
#endif
    for (low = &here - DEPTH; low < &here - 16; low++) *low = paint;
    call(input[0], input[1], input[2], input[3]); /* warm */
    for (low = &here - DEPTH; *low == paint && low < &here; low++) {}
#ifdef TIMES
    used = 0;
    for (i = 0; i < TIMES; i++) {
        const vm_real u = (vm_real)i / 8;
        uint32_t now;
        start = board_instructions();
        call(u, input[1], input[2], input[3]);
        now = board_instructions() - start;
        if (now > used) used = now;
    }
#else
    start = board_instructions();
    for (i = 0; i < 16; i++) call(input[0], input[1], input[2], input[3]);
    used = (board_instructions() - start) / 16;
#endif
    board_print_number((int32_t)used, 1);
    board_print(" ");
    board_print_number((int32_t)((&here - low) * 4), 1);
    board_print("\n");
    return 0;
}
