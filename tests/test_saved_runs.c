/* integrators.h: runs that are saved as bytes and resumed in a fresh rk45, by both methods. The oracle is the run that
   was not interrupted: all its bits, events included. */
#include "integrator_check.h"

enum { N = 3, EVENTS = 3, ROOM = 20, STEPS = 120, BYTES = RK87_SAVED(N, EVENTS) };

/* A run with an event of each action, whose functions depend on nothing but t and y */
typedef struct watched_run {
    rk45 s;
    rk45_options options;
    ode_event events[EVENTS];
    vm_real work[RK87_WORK(N)], times[ROOM], states[ROOM * N];
} watched_run;

static vm_real first(vm_real t, const vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    return y[0];
}

static vm_real second(vm_real t, const vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    return y[1] - R(0.5);
}

static vm_real clock_of(vm_real t, const vm_real *y, void *ctx)
{
    (void)y;
    (void)ctx;
    return t - 2;
}

static void halve(vm_real t, vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    y[2] /= 2;
}

static void begin(const method *m, watched_run *r)
{
    const vm_real y0[N] = {1, 0, 1};
    memset(r, 0, sizeof *r);
    r->events[0].g = first;
    r->events[0].times = r->times;
    r->events[0].states = r->states;
    r->events[0].room = ROOM;
    r->events[1].g = second;
    r->events[1].action = ODE_RESTART;
    r->events[1].change = halve;
    r->events[1].stop_after = 3;
    r->events[2].g = clock_of;
    r->events[2].action = ODE_STOP;
    r->options.events = r->events;
    r->options.n_events = EVENTS;
    r->options.h_max = R(0.3);
    CHECK(m->init(&r->s, linear_rhs, NULL, N, 0, y0, &r->options, r->work) == ODE_OK);
}

/* Do the two runs have the same bits, in all that a user sees? */
static int same_runs(const watched_run *a, const watched_run *b)
{
    int i, same = a->s.t == b->s.t && a->s.t_old == b->s.t_old && a->s.h == b->s.h && a->s.event == b->s.event;
    same = same && a->s.steps == b->s.steps && a->s.rejected == b->s.rejected && a->s.evals == b->s.evals;
    same = same && !memcmp(a->s.y, b->s.y, N * sizeof(vm_real)) && !memcmp(a->work, b->work, sizeof a->work);
    for (i = 0; i < EVENTS; i++)
        same = same && a->events[i].count == b->events[i].count && a->events[i].t == b->events[i].t;
    return same && !memcmp(a->times, b->times, sizeof a->times) && !memcmp(a->states, b->states, sizeof a->states);
}

/* Takes the run a, saved as bytes, into a fresh b. The caller's arrays of event times are the caller's to copy. */
static void continue_in(const method *m, const watched_run *a, watched_run *b)
{
    unsigned char bytes[BYTES];
    begin(m, b);
    CHECK(m->save(&a->s, BYTES, bytes) == ODE_OK);
    CHECK(m->resume(&b->s, BYTES, bytes) == ODE_OK);
    memcpy(b->times, a->times, sizeof b->times);
    memcpy(b->states, a->states, sizeof b->states);
    CHECK(b->s.y == b->work && b->s.options.events == b->events);
}

/* Step by step, saved after every step, with dense output after it */
static void test_every_step(const method *m)
{
    static watched_run whole, parts[STEPS + 1];
    vm_real y[N], z[N], middle;
    int i;
    begin(m, &whole);
    begin(m, parts);
    for (i = 0; i < STEPS; i++) {
        continue_in(m, parts + i, parts + i + 1);
        CHECK(m->step(&whole.s) == m->step(&parts[i + 1].s));
        CHECK(same_runs(&whole, parts + i + 1));
        if (i % 3) continue;
        middle = whole.s.t_old / 2 + whole.s.t / 2;
        CHECK(m->interpolate(&whole.s, middle, y) == ODE_OK && m->interpolate(&parts[i + 1].s, middle, z) == ODE_OK);
        CHECK(!memcmp(y, z, sizeof y));
    }
    CHECK(whole.events[0].count >= 4 && whole.events[1].count >= 4 && whole.events[2].count == 1);
}

/* From stop to stop, and where max_steps has ended a call in the middle */
static void test_stops(const method *m)
{
    static watched_run whole, part, next;
    int i, status = ODE_OK, again;
    begin(m, &whole);
    begin(m, &part);
    whole.s.options.max_steps = part.s.options.max_steps = 7;
    for (i = 0; i < 80; i++) {
        status = m->solve(&whole.s, 15);
        again = m->solve(&part.s, 15);
        CHECK(status == again && same_runs(&whole, &part));
        if (status == ODE_OK) break;
        continue_in(m, &part, &next);
        next.s.options.max_steps = 7;
        part = next;
        part.s.work = part.s.y = part.work;
        part.s.options.events = part.events;
        part.events[0].times = part.times;
        part.events[0].states = part.states;
    }
    CHECK(status == ODE_OK && whole.s.t == 15 && i > 5);
}

/* Changes the first number of a saved run, its format, and gives it the right checksum. */
static void make_other_format(const rk45 *s, unsigned char *bytes)
{
    const int before = (int)vmi_saved_size(s) - VMI_SAVED_SUM_BYTES;
    vmi_saved_place place = {0};
    uint32_t sum;
    bytes[0] ^= 1;
    sum = vmi_saved_checksum(bytes, before);
    place.to = bytes + before;
    place.saves = 1;
    vmi_saved_move_sum(&place, &sum);
}

static void test_refusals(const method *m, const method *other)
{
    const vm_real y0[N] = {1, 0, 1};
    static watched_run a, b, untouched;
    vm_real work[RK87_WORK(N)];
    unsigned char bytes[BYTES];
    rk45 plain;
    begin(m, &a);
    CHECK(m->solve(&a.s, 1) == ODE_OK);
    CHECK(m->save(NULL, BYTES, bytes) == ODE_BAD_ARGUMENT && m->save(&a.s, BYTES, NULL) == ODE_BAD_ARGUMENT);
    CHECK(m->save(&a.s, -1, bytes) == ODE_BAD_ARGUMENT && other->save(&a.s, BYTES, bytes) == ODE_BAD_ARGUMENT);
    CHECK(m->save(&a.s, 0, bytes) == ODE_WORK_TOO_SMALL);
    CHECK(m->save(&a.s, 100, bytes) == ODE_WORK_TOO_SMALL && m->save(&a.s, BYTES, bytes) == ODE_OK);
    begin(m, &b);
    begin(m, &untouched);
    CHECK(m->resume(NULL, BYTES, bytes) == ODE_BAD_ARGUMENT && m->resume(&b.s, BYTES, NULL) == ODE_BAD_ARGUMENT);
    CHECK(other->resume(&b.s, BYTES, bytes) == ODE_BAD_ARGUMENT && m->resume(&b.s, -1, bytes) == ODE_BAD_ARGUMENT);
    CHECK(m->resume(&b.s, 100, bytes) == ODE_WORK_TOO_SMALL && m->resume(&b.s, 0, bytes) == ODE_WORK_TOO_SMALL);
    bytes[200] ^= 1; /* a damaged byte */
    CHECK(m->resume(&b.s, BYTES, bytes) == ODE_BAD_ARGUMENT);
    bytes[200] ^= 1;
    CHECK(same_runs(&b, &untouched));
    CHECK(m->init(&plain, linear_rhs, NULL, N, 0, y0, NULL, work) == ODE_OK); /* no events: another run */
    CHECK(m->resume(&plain, BYTES, bytes) == ODE_BAD_ARGUMENT && plain.t == 0);
    CHECK(m->resume(&b.s, BYTES, bytes) == ODE_OK && b.s.t == 1 && same_runs(&a, &b));
    make_other_format(&b.s, bytes);
    CHECK(m->resume(&b.s, BYTES, bytes) == ODE_BAD_ARGUMENT && same_runs(&a, &b));
    make_other_format(&b.s, bytes);
    CHECK(m->resume(&b.s, BYTES, bytes) == ODE_OK);
    CHECK(m->restart(&b.s, 3, y0) == ODE_OK && b.s.t == 3 && m->solve(&b.s, 4) == ODE_OK); /* its events begin again */
}

/* The macro for the number of bytes is exact. */
static void test_sizes(void)
{
    static watched_run r;
    unsigned char bytes[BYTES];
    begin(methods, &r);
    CHECK(rk45_save(&r.s, RK45_SAVED(N, EVENTS) - 1, bytes) == ODE_WORK_TOO_SMALL);
    CHECK(rk45_save(&r.s, RK45_SAVED(N, EVENTS), bytes) == ODE_OK);
    begin(methods + 1, &r);
    CHECK(rk87_save(&r.s, RK87_SAVED(N, EVENTS) - 1, bytes) == ODE_WORK_TOO_SMALL);
    CHECK(rk87_save(&r.s, RK87_SAVED(N, EVENTS), bytes) == ODE_OK);
}

int main(void)
{
    int i;
    for (i = 0; i < METHODS; i++) {
        test_every_step(methods + i);
        test_stops(methods + i);
        test_refusals(methods + i, methods + 1 - i);
    }
    test_sizes();
    return check_finish("saved runs");
}
