/* Calls that read every table of jacobi.h and ateb.h (-DATEB), those of the law of order five from a constant plan
   (-DCLOSED=HEADER) or from a plan of this order made on the board (-DMADE=3), or of one pair of integrators.h
   (-DRK45, -DRK87: both do not fit into 32 KB of flash). It prints the bits of each result. tests/test_avr.sh compares
   the lines of an ATmega328P, whose tables may lie in flash, with those of a PC. */
#define VM_USE_FLOAT
#ifdef ATEB
#include "../../ateb.h"
#elif defined CLOSED || defined MADE
#include "../../varmass.h"
#else
#include "../../integrators.h"
#endif
#include <stdint.h>
#include <string.h>

#ifdef __AVR__
void golden_line(const char *line); /* of tests/cross/avr.c */
#else
#include <stdio.h>
static void golden_line(const char *line) { puts(line); }
#endif

static void show(vm_real x)
{
    char line[] = "tables 00000000";
    uint32_t bits;
    int digit;
    memcpy(&bits, &x, sizeof bits);
    for (digit = 0; digit < 8; digit++) line[14 - digit] = "0123456789abcdef"[bits >> 4 * digit & 15];
    golden_line(line);
}

#ifdef ATEB
/* the logarithm; Pi_alpha by each of its 33 polynomials, and in three words; both fractions; Stirling's series */
static void read_tables(void)
{
    static const vm_real alphas[4] = {(vm_real)0.3, 1, (vm_real)2.7, 40};
    const vm_real far_phase = 4000 * ateb_pi(3);
    vm_real sa, ca;
    int i, j;
    for (i = 0; i < 32; i++) show(vmi_log((vm_real)0.7 + (vm_real)0.022 * (vm_real)i).hi);
    show(ateb_pi(1e6f));
    for (i = 1; i <= 32; i++) show(ateb_pi(32 / (vm_real)i - 1));
    for (i = 0; i < 4; i++) {
        for (j = 1; j < 8; j++) {
            ateb_saca((vm_real)j / 4, alphas[i], &sa, &ca);
            show(sa);
            show(ca);
        }
    }
    ateb_saca(far_phase, 3, &sa, &ca);
    show(sa);
    show(ateb_beta((vm_real)0.5, (vm_real)3.25));
}
#elif defined CLOSED
#ifdef __AVR__
#include <avr/pgmspace.h>
#else
#define PROGMEM
#define memcpy_P memcpy
#endif
#include CLOSED /* the constant `plan` in flash, printed by examples/print_plan */

/* The motion of a leaking oscillator whose plan was made on a PC */
static void read_tables(void)
{
    static vm_osc_closed c;
    vm_real x = 0, v = 0;
    int i;
    memcpy_P(&c, &plan, sizeof c);
    show(c.error);
    for (i = 0; i < 16; i++) {
        vm_osc_closed_at(&c, 2 * (vm_real)i, &x, &v);
        show(x);
        show(v);
    }
}
#elif defined MADE
#if MADE == 2
#define CLOSED_AT vm_osc_closed_at_order2
#elif MADE == 3
#define CLOSED_AT vm_osc_closed_at_order3
#else
#define CLOSED_AT vm_osc_closed_at
#endif

/* The motion of a leaking oscillator whose plan is made here */
static void read_tables(void)
{
    static vm_osc_closed c;
    static vm_osc_problem o;
    vm_real x = 0, v = 0;
    int i;
    o.alpha = (vm_real)1.7;
    o.mass = vm_law_linear(10, (vm_real)-0.1);
    o.stiffness = vm_law_linear(100, 0);
    o.reactive = 1;
    o.x = (vm_real)0.1;
    show(vm_osc_closed_init(&c, &o, MADE, 30));
    show(c.error);
    for (i = 0; i < 16; i++) {
        CLOSED_AT(&c, 2 * (vm_real)i, &x, &v);
        show(x);
        show(v);
    }
}
#else
static int cubic(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t;
    (void)ctx;
    dydt[0] = y[1];
    dydt[1] = -y[0] * y[0] * y[0];
    return 0;
}

#ifdef RK45
#define INIT rk45_init
#define STEP rk45_step
#define INTERPOLATE rk45_interpolate
#else
#define INIT rk87_init
#define STEP rk87_step
#define INTERPOLATE rk87_interpolate
#endif

/* steps, states within them and the look for stiffness */
static void read_tables(void)
{
    const vm_real start[2] = {1, 0};
    vm_real work[RK87_WORK(2)], inside[2];
    rk45 s;
    int step;
    INIT(&s, cubic, NULL, 2, 0, start, NULL, work);
    for (step = 0; step < 10; step++) {
        STEP(&s);
        INTERPOLATE(&s, s.t_old + (s.t - s.t_old) / 3, inside);
        show(s.y[0]);
        show(s.y[1]);
        show(inside[0]);
        show(inside[1]);
    }
}
#endif

#ifdef __AVR__
int golden_main(void);
int golden_main(void)
#else
int main(void)
#endif
{
    read_tables();
    return 0;
}
