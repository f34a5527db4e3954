/* Calls that read every table of jacobi.h, ateb.h (-DATEB) or integrators.h (-DINTEGRATORS); prints the bits of each
   result. tests/test_avr.sh compares the lines of an ATmega328P, whose tables may lie in flash, with those of a PC. */
#define VM_USE_FLOAT
#ifdef ATEB
#include "../../ateb.h"
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
#else
static int cubic(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t, (void)ctx;
    dydt[0] = y[1];
    dydt[1] = -y[0] * y[0] * y[0];
    return 0;
}

static void run(int order, vm_real *work)
{
    const vm_real start[2] = {1, 0};
    vm_real inside[2];
    rk45 s;
    int step;
    if (order == 5) rk45_init(&s, cubic, NULL, 2, 0, start, NULL, work);
    else rk87_init(&s, cubic, NULL, 2, 0, start, NULL, work);
    for (step = 0; step < 5; step++) {
        if (order == 5) rk45_step(&s);
        else rk87_step(&s);
        if (order == 5) rk45_interpolate(&s, s.t_old + (s.t - s.t_old) / 3, inside);
        else rk87_interpolate(&s, s.t_old + (s.t - s.t_old) / 3, inside);
        show(s.y[0]);
        show(s.y[1]);
        show(inside[0]);
        show(inside[1]);
    }
}

/* steps, states within them and the look for stiffness of both pairs */
static void read_tables(void)
{
    vm_real work[RK87_WORK(2)];
    run(5, work);
    run(8, work);
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
