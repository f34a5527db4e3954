/* Fuzz target: integrators.h. Runs of every kind of right-hand side and options: statuses, the times reached, bounded
   numbers of steps, round trips, dense output, events; what refuses its arguments changes nothing. */
#include "fuzz.h"

typedef struct system_of {
    int kind, stop_after, n;
    vm_real a, b;
    long calls;
} system_of;

/* oscillators, decay, growth, roots and poles, steps, a refusal, NaN: what users bring */
static int system_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    system_of *s = (system_of *)ctx;
    int i;
    if (++s->calls > 2000000) { /* 2041 steps are the most that are allowed */
        HOLDS(s->calls <= 2000000);
        return 1;
    }
    if (s->stop_after && s->calls > s->stop_after) return 7;
    for (i = 0; i < s->n; i++) {
        const vm_real next = y[(i + 1) % s->n];
        switch (s->kind) {
        case 0:
            if (i % 2) dydt[i] = -y[i - 1];
            else dydt[i] = i + 1 < s->n ? next : 0;
            break;
        case 1: dydt[i] = -s->a * y[i]; break;
        case 2: dydt[i] = s->a * y[i] * y[i]; break;
        case 3: dydt[i] = VM_SQRT(y[i]) * s->b; break;
        case 4: dydt[i] = (t > s->a ? 1 : -1) * R(0.5); break;
        case 5: dydt[i] = 1 / (t - s->a); break;
        case 6: dydt[i] = next > 0 ? -1 : 1; break;
        default: dydt[i] = t > s->b ? VM_NAN : s->a;
        }
    }
    return 0;
}

static vm_real first_component(vm_real t, const vm_real *y, void *ctx)
{
    (void)t;
    return y[0] - *(const vm_real *)ctx;
}

static vm_real time_itself(vm_real t, const vm_real *y, void *ctx)
{
    (void)y;
    return t - *(const vm_real *)ctx;
}

static void turned_back(vm_real t, vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    y[0] = -y[0];
}

enum { MOST = 10 };
typedef struct run_of {
    system_of system;
    vm_real y[MOST], work[RK87_WORK(MOST)], level[2];
    rk45_options options;
    ode_event events[2];
} run_of;

static void draw_system(run_of *r)
{
    int i;
    memset(r, 0, sizeof *r);
    r->system.n = 1 + draw_below(4);
    if (draw_byte() % 16 == 0) r->system.n = MOST;
    r->system.kind = draw_below(8);
    r->system.stop_after = draw_byte() % 8 ? 0 : (int)draw_byte() + 1;
    r->system.a = MOSTLY(draw_in(-2, 2));
    r->system.b = MOSTLY(draw_in(-2, 2));
    for (i = 0; i < r->system.n; i++) r->y[i] = draw_byte() % 64 ? draw_in(-2, 2) : draw_any();
}

static void draw_options(run_of *r)
{
    rk45_options *o = &r->options;
    int i;
    if (draw_byte() & 1) {
        o->rtol = MOSTLY(draw_log(1e-12, 1e-1));
        o->atol = MOSTLY(draw_log(1e-12, 1e-1));
    }
    if (draw_byte() % 8 == 0) o->h0 = MOSTLY(draw_in(-1, 1));
    if (draw_byte() % 8 == 0) o->h_max = MOSTLY(draw_log(1e-2, 10));
    if (draw_byte() % 8 == 0) o->h_min = MOSTLY(draw_log(1e-9, 1e-3));
    o->max_steps = 1 + draw_byte() * 8;
    o->n_events = draw_below(3);
    o->events = r->events;
    for (i = 0; i < o->n_events; i++) {
        r->level[i] = MOSTLY(draw_in(-1, 3));
        r->events[i].g = i ? time_itself : first_component;
        r->events[i].ctx = &r->level[i];
        r->events[i].direction = draw_below(3) - 1;
        r->events[i].action = draw_below(3);
        r->events[i].checks = draw_below(6) - 1;
        if (draw_byte() & 1) r->events[i].change = turned_back;
    }
}

static int known(int status) { return strcmp(ode_strerror(status), "unknown status") != 0; }

static int same_state(int n, const vm_real *a, const vm_real *b)
{
    return memcmp(a, b, (size_t)n * sizeof *a) == 0;
}

static void check_rk4(void)
{
    run_of r;
    vm_real before[MOST], other[MOST], low[MOST], t, t0, h;
    const vm_real t_end = MOSTLY(draw_in(-3, 3));
    const long steps = draw_below(70) - 2;
    int status, n, i;
    draw_system(&r);
    n = r.system.n;
    t = t0 = MOSTLY(draw_in(-3, 3));
    h = MOSTLY(draw_in(-1, 1));
    memcpy(before, r.y, sizeof before);
    memcpy(other, r.y, sizeof other);
    memset(low, 0, sizeof low);
    status = rk4_solve(system_rhs, &r.system, n, &t, t_end, steps, r.y, r.work);
    HOLDS(known(status) && r.system.calls <= (steps > 0 ? 4 * steps : 0));
    if (status == ODE_BAD_ARGUMENT) HOLDS(same_bits(t, t0) && same_state(n, before, r.y));
    if (status == ODE_OK) HOLDS(t == t_end && steps > 0 && vmi_all_finite(n, r.y));
    HOLDS(status == ODE_BAD_ARGUMENT || vmi_all_finite(n, r.y) || !vmi_all_finite(n, before));
    r.system.calls = 0;
    t = t0;
    i = rk4_solve_compensated(system_rhs, &r.system, n, &t, t_end, steps, other, low, r.work);
    HOLDS(i == status || fuzz.wild); /* one may overflow a rounding before the other */
    if (status == ODE_OK && r.system.kind < 2 && is_finite(r.system.a))
        HOLDS(within(other[0], r.y[0], 1e3 * EPS * larger(larger(1, fabs((double)r.y[0])), 64)));
    memcpy(before, r.y, sizeof before);
    r.system.calls = 0;
    status = rk4_step(system_rhs, &r.system, n, t0, h, r.y, r.work);
    HOLDS(known(status) && r.system.calls <= 4);
    if (status < 0) HOLDS(same_state(n, before, r.y));
    HOLDS(rk4_step(NULL, NULL, n, t0, h, r.y, r.work) == ODE_BAD_ARGUMENT);
    HOLDS(rk4_step(system_rhs, &r.system, 0, t0, h, r.y, r.work) == ODE_BAD_ARGUMENT);
}

static int start(rk45 *s, run_of *r, int high, vm_real t0)
{
    return high ? rk87_init(s, system_rhs, &r->system, r->system.n, t0, r->y, &r->options, r->work)
                : rk45_init(s, system_rhs, &r->system, r->system.n, t0, r->y, &r->options, r->work);
}

static int solve(rk45 *s, int high, int with, int n, vm_real t_end)
{
    if (with) return high ? rk87_solve_with(s, system_rhs, n, t_end) : rk45_solve_with(s, system_rhs, n, t_end);
    return high ? rk87_solve(s, t_end) : rk45_solve(s, t_end);
}

/* within the last step dense output goes from state to state; outside it is refused */
static void check_dense(rk45 *s, int high)
{
    vm_real y[MOST];
    const vm_real middle = s->t_old + (s->t - s->t_old) * draw_in(0, 1);
    const vm_real beyond = s->t + (s->t - s->t_old) + 1;
    int status;
    STAIN(y);
    status = high ? rk87_interpolate(s, beyond, y) : rk45_interpolate(s, beyond, y);
    if (s->t >= s->t_old && beyond > s->t) HOLDS(status == ODE_BAD_ARGUMENT && UNTOUCHED(y));
    status = high ? rk87_interpolate(s, s->t, y) : rk45_interpolate(s, s->t, y);
    if (status == ODE_OK) HOLDS(close_to(y[0], s->y[0], 64));
    HOLDS((high ? rk45_interpolate(s, s->t, y) : rk87_interpolate(s, s->t, y)) == ODE_BAD_ARGUMENT);
    status = high ? rk87_interpolate(s, middle, y) : rk45_interpolate(s, middle, y);
    HOLDS(known(status));
}

static void check_adaptive(void)
{
    run_of r;
    rk45 s;
    vm_real t0, t_end, far_y[MOST];
    int high = draw_below(2), with = draw_below(2), status, n;
    long i, before;
    draw_system(&r);
    draw_options(&r);
    n = r.system.n;
    t0 = MOSTLY(draw_in(-2, 2));
    t_end = MOSTLY(draw_in(-5, 5));
    STAIN(s);
    status = start(&s, &r, high, t0);
    HOLDS(known(status));
    if (status < 0) {
        HOLDS(UNTOUCHED(s) || status != ODE_BAD_ARGUMENT);
        return;
    }
    HOLDS(s.t == t0 && s.steps == 0 && vmi_all_finite(n, s.y));
    HOLDS(status == ODE_OK || status == ODE_RTOL_RAISED);
    HOLDS((high ? rk45_step(&s) : rk87_step(&s)) == ODE_BAD_ARGUMENT && s.steps == 0);
    if (draw_byte() & 1) {
        status = high ? rk87_step(&s) : rk45_step(&s);
        HOLDS(known(status) && s.steps <= 1 && vmi_all_finite(n, s.y));
        if (status == ODE_OK) HOLDS(s.steps == 1 && (s.t != t0 || r.options.n_events));
    }
    before = s.steps + s.rejected;
    for (i = 0; i < 8; i++) { /* goes on after events */
        const vm_real t = s.t;
        status = solve(&s, high, with, n, t_end);
        /* at an event next to the end of the range dense output may overflow between finite states */
        HOLDS(known(status) && is_finite(s.t) &&
              (vmi_all_finite(n, s.y) || (fuzz.wild && status == ODE_NOT_FINITE)));
        if (status == ODE_BAD_ARGUMENT) {
            HOLDS(!is_finite(t_end) && s.t == t);
            return;
        }
        HOLDS(is_finite(t_end) || (status != ODE_OK && status != ODE_STIFF)); /* no run gets there */
        HOLDS((t <= s.t && s.t <= t_end) || (t >= s.t && s.t >= t_end)); /* not beyond, not back */
        HOLDS(s.steps + s.rejected - before <= (i + 1) * r.options.max_steps + 1);
        HOLDS(s.event == -1 || status == ODE_EVENT);
        if (status == ODE_OK || status == ODE_STIFF) HOLDS(s.t == t_end);
        if (s.steps && status >= 0) check_dense(&s, high);
        if (status != ODE_EVENT) break;
        HOLDS(s.event >= 0 && s.event < r.options.n_events && r.events[s.event].count > 0);
        HOLDS(r.events[s.event].action == ODE_STOP);
    }
    if (status == ODE_RHS_STOPPED) HOLDS(s.rhs_status == 7);
    far_y[0] = VM_INFINITY;
    for (i = 1; i < n; i++) far_y[i] = 0;
    HOLDS((high ? rk87_restart(&s, s.t, far_y) : rk45_restart(&s, s.t, far_y)) == ODE_BAD_ARGUMENT);
    HOLDS((high ? rk87_restart(&s, t0, r.y) : rk45_restart(&s, t0, r.y)) == ODE_OK && s.t == t0);
}

/* linear oscillations there and back, energy; an exponential: within the tolerance's reach of the exact one */
static void check_accuracy(void)
{
    run_of r;
    rk45 s;
    const int high = draw_below(2);
    const vm_real tolerance = draw_log(IS_FLOAT ? 1e-4 : 1e-9, 1e-3), t = draw_in(-5, 5);
    memset(&r, 0, sizeof r);
    r.system.n = 2;
    r.y[0] = draw_in(-2, 2);
    r.y[1] = draw_in(-2, 2);
    r.options.rtol = r.options.atol = tolerance;
    HOLDS(start(&s, &r, high, 0) >= 0 && solve(&s, high, draw_below(2), 2, t) == ODE_OK);
    HOLDS(within(s.y[0], R((double)r.y[0] * cos((double)t) + (double)r.y[1] * sin((double)t)),
                 200 * (double)tolerance + 500 * EPS));
    HOLDS((high ? rk87_solve(&s, 0) : rk45_solve(&s, 0)) == ODE_OK);
    HOLDS(within(s.y[0], r.y[0], 400 * (double)tolerance + 1000 * EPS));
    HOLDS(s.evals >= 6 * s.steps && (s.steps > 0 || t == 0));
}

/* A run at listed times, which is saved and resumed somewhere, gives what the run that goes on gives, to the bit. */
static void check_listed(void)
{
    enum { TIMES = 6, BYTES = RK87_SAVED(MOST, 2) };
    static run_of r, copy; /* static: bytes between the fields are the same */
    unsigned char bytes[BYTES];
    vm_real times[TIMES], rows[TIMES * MOST], again[TIMES * MOST];
    rk45 s, other;
    const int high = draw_below(2), count = draw_below(TIMES + 1), first = draw_below(TIMES + 1);
    const vm_real way = MOSTLY(draw_in(-1, 1));
    int i, done = 0, more = 0, others = 0, status, fits;
    draw_system(&r);
    draw_options(&r);
    for (i = 0; i < r.options.n_events; i++) {
        r.events[i].stop_after = draw_below(5);
        r.events[i].stop_after -= draw_byte() % 16 == 0;
    }
    for (i = 0; i < TIMES; i++) times[i] = R(i) * way;
    if (start(&s, &r, high, 0) < 0) return;
    HOLDS(r.options.n_events == 0 || r.events[0].stop_after >= 0);
    fits = first <= count ? first : count;
    status = high ? rk87_solve_at(&s, fits, times, rows, &done) : rk45_solve_at(&s, fits, times, rows, &done);
    HOLDS(known(status) && done >= 0 && done <= fits && (status >= 0 ? 1 : status != ODE_OK));
    HOLDS((status != ODE_OK && status != ODE_STIFF) || done == fits);
    if (status == ODE_BAD_ARGUMENT) {
        HOLDS(!is_finite(times[TIMES - 1]));
        return;
    }
    HOLDS((high ? rk87_save(&s, BYTES, bytes) : rk45_save(&s, BYTES, bytes)) == ODE_OK);
    copy = r;
    copy.options.events = copy.events;
    for (i = 0; i < copy.options.n_events; i++) copy.events[i].ctx = &copy.level[i];
    HOLDS(start(&other, &copy, high, 0) >= 0);
    HOLDS((high ? rk45_resume(&other, BYTES, bytes) : rk87_resume(&other, BYTES, bytes)) == ODE_BAD_ARGUMENT);
    HOLDS((high ? rk87_resume(&other, BYTES, bytes) : rk45_resume(&other, BYTES, bytes)) == ODE_OK);
    copy.system.calls = r.system.calls;
    memcpy(again, rows, sizeof rows);
    i = high ? rk87_solve_at(&s, count - done, times + done, rows, &more)
             : rk45_solve_at(&s, count - done, times + done, rows, &more);
    status = high ? rk87_solve_at(&other, count - done, times + done, again, &others)
                  : rk45_solve_at(&other, count - done, times + done, again, &others);
    HOLDS(i == status && more == others && same_state(more * r.system.n, rows, again));
    HOLDS(same_bits(s.t, other.t) && s.evals == other.evals && same_state(r.system.n, s.y, other.y));
    for (i = 0; i < r.options.n_events; i++) HOLDS(r.events[i].count == copy.events[i].count);
    bytes[draw_below(140)] ^= 4; /* the smallest saved run is longer */
    HOLDS((high ? rk87_resume(&other, BYTES, bytes) : rk45_resume(&other, BYTES, bytes)) == ODE_BAD_ARGUMENT);
}

static void check_defaults(void)
{
    rk45_options o, d;
    memset(&o, 0, sizeof o);
    o.rtol = draw_any();
    o.atol = draw_any();
    o.max_steps = (long)draw_byte() - 10;
    d = rk45_defaults(&o);
    HOLDS(is_nan(o.rtol) || d.rtol >= 0);
    d = rk45_defaults(NULL);
    HOLDS(d.rtol > 0 && d.atol > 0 && d.atol < d.rtol && d.max_steps == 1000000);
    HOLDS(known(-draw_below(7)) && !known(-7 - draw_below(9)) && !known(4 + draw_below(9)));
}

static void fuzz_integrators(void)
{
    switch (draw_below(8)) {
    case 0: check_rk4(); break;
    case 1: check_accuracy(); break;
    case 2: check_defaults(); break;
    default: check_adaptive();
    }
    check_listed(); /* after the others, whose stored inputs stay what they are */
}
FUZZ_TARGET(integrators)
