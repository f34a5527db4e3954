/* A run that is saved on one machine and resumed on another one. Without RESUMED the program begins the run; with it, it
   resumes the run from the bytes in the file RESUMED, numbers between commas. It makes ten steps, prints the run as
   bytes ("saved"), makes the steps that are left to t = 20 and prints time, state and events ("end"), which must be the
   same on all machines. tests/test_resumed.sh compiles and runs it. */
#include "../../integrators.h"
#include <stdio.h>

enum { N = 2, EVENTS = 1, BYTES = RK87_SAVED(N, EVENTS) };

/* Duffing's oscillator with a small damping */
static int duffing(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t;
    (void)ctx;
    dydt[0] = y[1];
    dydt[1] = -y[0] * (1 + y[0] * y[0]) - y[1] / 64;
    return 0;
}

static vm_real position(vm_real t, const vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    return y[0];
}

static void bounce(vm_real t, vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    y[1] *= (vm_real)0.875;
}

static void print_number(vm_real x)
{
    unsigned char bytes[sizeof(vm_real)];
    vmi_saved_place place = {NULL, NULL, 1};
    unsigned i;
    place.to = bytes;
    vmi_saved_real(&place, &x);
    for (i = 0; i < sizeof bytes; i++) printf("%02x", bytes[i]);
    printf(" ");
}

int main(void)
{
#ifdef RESUMED
    static const unsigned char before[] = {
#include RESUMED
    };
#endif
    static unsigned char bytes[BYTES];
    vm_real y0[N] = {1, 0}, work[RK87_WORK(N)];
    rk45_options options;
    ode_event event;
    rk45 s;
    int i;
    memset(&event, 0, sizeof event);
    memset(&options, 0, sizeof options);
    event.g = position;
    event.action = ODE_RESTART;
    event.change = bounce;
    options.events = &event;
    options.n_events = EVENTS;
    rk87_init(&s, duffing, NULL, N, 0, y0, &options, work);
#ifdef RESUMED
    if (rk87_resume(&s, (long)sizeof before, before)) return 1;
#endif
    for (i = 0; i < 10; i++)
        if (rk87_step(&s) < 0) return 1;
    if (rk87_save(&s, BYTES, bytes)) return 1;
    printf("saved ");
    for (i = 0; i < BYTES; i++) printf("%d,", bytes[i]);
    if (rk87_solve(&s, 20) < 0) return 1;
    printf("\nend ");
    print_number(s.t);
    print_number(s.y[0]);
    print_number(s.y[1]);
    printf("%ld %ld %ld\n", s.steps, s.evals, event.count);
    return 0;
}
