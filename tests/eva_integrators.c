/* For Frama-C's EVA (tests/eva.sh): every public function of integrators.h on two equations, whose right-hand side and
   event functions return any numbers and any status. */
#define EVA_HEADER "../integrators.h"
#include "eva_words.h"

volatile long any_long;

static int right_hand_side(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)ctx;
    sink[0] = t;
    sink[1] = y[0];
    sink[2] = y[1];
    dydt[0] = any;
    dydt[1] = any;
    return any_int;
}

static vm_real event(vm_real t, const vm_real *y, void *ctx)
{
    (void)ctx;
    sink[0] = t;
    sink[1] = y[0];
    sink[2] = y[1];
    return any;
}

static void change(vm_real t, vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    y[0] = any;
}

void eva_rk4(void)
{
    vm_real y[2] = {any, any}, low[2] = {any, any}, t = any, work[RK4_WORK(2)];
    rk4_step(right_hand_side, NULL, 2, any, any, y, work);
    rk4_solve(right_hand_side, NULL, 2, &t, any, any_long, y, work);
    rk4_solve_compensated(right_hand_side, NULL, 2, &t, any, any_long, y, low, work);
}

/* Options with any numbers, and with an event or none */
static rk45_options any_options(ode_event *e, vm_real *atol)
{
    rk45_options o;
    o.rtol = any;
    o.atol = any;
    o.h0 = any;
    o.h_min = any;
    o.h_max = any;
    o.max_steps = any_long;
    atol[0] = any;
    atol[1] = any;
    o.atol_each = any_int ? atol : NULL;
    o.events = e;
    o.n_events = e ? 1 : 0;
    o.work_size = any_long;
    if (e) {
        e->g = event;
        e->ctx = NULL;
        e->direction = any_int;
        e->action = any_int;
        e->checks = any_int;
        e->change = any_int ? change : NULL;
        e->stop_after = any_long;
        e->room = any_long;
        e->times = NULL;
        e->states = NULL;
    }
    return o;
}

void eva_defaults(void)
{
    vm_real atol[2];
    rk45_options o = any_options(NULL, atol);
    o = rk45_defaults(any_int ? &o : NULL);
    sink[0] = o.rtol + o.atol + o.h_max;
}

void eva_strerror(void) { sink[0] = ode_strerror(any_int)[0]; }

void eva_refusals(void)
{
    vm_real y[2] = {any, any}, atol[2], work[RK45_WORK(2)];
    ode_event e;
    rk45_options o = any_options(&e, atol);
    rk45 s;
    const int n = any_int;
    if (any_int) o.events = NULL;
    if (any_int) e.g = NULL;
    rk45_init(any_int ? &s : NULL, any_int ? right_hand_side : NULL, NULL, n > 2 ? 2 : n, any, any_int ? y : NULL, &o,
              any_int ? work : NULL);
    rk45_step(NULL);
    rk45_solve(NULL, any);
    rk45_solve_with(NULL, right_hand_side, 2, any);
    rk45_interpolate(NULL, any, y);
    rk45_restart(NULL, any, y);
    rk45_solve_at(NULL, any_int, y, y, NULL);
    rk45_save(NULL, any_long, NULL);
    rk45_resume(NULL, any_long, NULL);
    rk87_step(NULL);
    rk87_solve(NULL, any);
    rk87_solve_with(NULL, right_hand_side, 2, any);
    rk87_interpolate(NULL, any, y);
    rk87_restart(NULL, any, y);
    rk87_solve_at(NULL, any_int, y, y, NULL);
    rk87_save(NULL, any_long, NULL);
    rk87_resume(NULL, any_long, NULL);
}

/* The run is made twice, so that it has numbers everywhere: EVA does not keep the statuses of the second call apart. */
#define ADAPTIVE(name, method, WORK, event_or_NULL)                                                \
    void eva_##name(void)                                                                          \
    {                                                                                              \
        vm_real y[2] = {any, any}, work[WORK(2)], atol[2];                                         \
        ode_event e;                                                                               \
        const rk45_options o = any_options(event_or_NULL, atol);                                   \
        rk45_options plain = rk45_defaults(NULL);                                                  \
        rk45 s;                                                                                    \
        (void)e;                                                                                   \
        plain.events = o.events;                                                                   \
        plain.n_events = o.n_events;                                                               \
        if (method##_init(&s, right_hand_side, NULL, 2, any, y, &plain, work) < 0) return;         \
        if (method##_init(&s, right_hand_side, NULL, 2, any, y, &o, work) < 0) return;             \
        method##_step(&s);                                                                         \
        method##_interpolate(&s, any, y);                                                          \
        method##_restart(&s, any, y);                                                              \
        method##_solve(&s, any);                                                                   \
        method##_solve_with(&s, right_hand_side, 2, any);                                          \
    }

ADAPTIVE(rk45, rk45, RK45_WORK, NULL)
ADAPTIVE(rk45_event, rk45, RK45_WORK, &e)
ADAPTIVE(rk87, rk87, RK87_WORK, NULL)
ADAPTIVE(rk87_event, rk87, RK87_WORK, &e)

/* A run is saved, and a run that was made of any bytes goes on. */
#define SAVED(method, WORK, SIZE)                                                                  \
    void eva_##method##_saved(void)                                                                \
    {                                                                                              \
        vm_real y[2] = {any, any}, work[WORK(2)];                                                  \
        static unsigned char bytes[SIZE(2, 0)];                                                    \
        rk45 s;                                                                                    \
        int i;                                                                                     \
        if (method##_init(&s, right_hand_side, NULL, 2, any, y, NULL, work) < 0) return;           \
        method##_step(&s);                                                                         \
        method##_save(&s, any_long, bytes);                                                        \
        for (i = 0; i < (int)sizeof bytes; i++) bytes[i] = (unsigned char)any_int;                 \
        if (method##_resume(&s, any_long, bytes) == 0) method##_step(&s);                          \
    }

SAVED(rk45, RK45_WORK, RK45_SAVED)
SAVED(rk87, RK87_WORK, RK87_SAVED)

/* The states at two listed times */
#define AT_TIMES(method, WORK)                                                                     \
    void eva_##method##_at(void)                                                                   \
    {                                                                                              \
        vm_real y[2] = {any, any}, work[WORK(2)], times[2] = {any, any}, rows[2][2];               \
        rk45 s;                                                                                    \
        int n_done;                                                                                \
        if (method##_init(&s, right_hand_side, NULL, 2, any, y, NULL, work) < 0) return;           \
        method##_solve_at(&s, 2, times, rows[0], &n_done);                                         \
    }

AT_TIMES(rk45, RK45_WORK)
AT_TIMES(rk87, RK87_WORK)
