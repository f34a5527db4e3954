/* Events of integrators.h that coincide, graze, jump or vanish. The oracle are closed forms: in these random runs every
   event is known beforehand. Two oscillators turn like the hand of a clock. Each event watches one of a few levels in one
   of many ways (itself, its cube, its sign, scaled, cut off at zero, by the clock), so that most of them happen at the
   same instants; some only graze, or are always zero. None may be lost, none may happen twice, at any tolerance, at any
   time on the clock, forward and backward. Then balls bounce together.

   usage: coincidences [RUNS], default 3000 */
#include "../integrators.h"
#include <stdlib.h>
#include "check.h"

#define R(x) ((vm_real)(x))
static const int is_float = PRECISION[0] == 'f';
static const double pi = 3.14159265358979323846;

enum { EVENTS = 6, TIMES = 40 };
enum { PLAIN, CUBE, SIGN, STEP, TINY, HUGE_VALUE, CUT_OFF, CLOCK, GRAZE, ZERO, KINDS };

/* What an event watches: the angle at which its component reaches the level, for each of the two passages */
typedef struct watched {
    int kind, component; /* 0: cos, 1: sin of the angle, 2 and 3 those of the second oscillator, which is alike */
    vm_real level;
} watched;

typedef struct plan {
    double speed, t0, turns, tolerance, phase, sense; /* 1 or, where t falls, -1 */
    double angle; /* at which all levels are reached: cos of it and sin of it */
    vm_real instant; /* at which it is first reached, by the clock */
    watched w[EVENTS];
    ode_event e[EVENTS];
    int events;
} plan;

static vm_real speed; /* of the run at hand */

static int turn(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    int i;
    (void)t;
    (void)ctx;
    for (i = 0; i < 4; i += 2) {
        dydt[i] = -speed * y[i + 1];
        dydt[i + 1] = speed * y[i];
    }
    return 0;
}

static vm_real watch(vm_real t, const vm_real *y, void *ctx)
{
    const watched *w = (const watched *)ctx;
    const vm_real x = y[w->component], d = x - w->level;
    switch (w->kind) {
    case CUBE: return x * x * x - w->level * w->level * w->level;
    case SIGN: return R((d > 0) - (d < 0));
    case STEP: return R(d > 0 ? 1 : -3);
    case TINY: return d * R(1e-18);
    case HUGE_VALUE: return d * R(1e18);
    case CUT_OFF: return d > 0 ? d : 0; /* reaches zero when it falls; leaving it is no event */
    case CLOCK: return t - w->level;
    case GRAZE: return x - 1; /* touched as often as the angle passes 0, and passed, if at all, by rounding */
    case ZERO: return 0;
    default: return d;
    }
}

/* The angle, or the other one within a turn at which the component has the same value */
static double angle_of(const plan *p, int odd, int mirrored)
{
    if (!mirrored) return p->angle;
    return odd ? pi - p->angle : -p->angle;
}

/* How often the event happens in the run: passages of the angle and of its mirror image at which the component rises
   or falls through its level */
static long passages(const plan *p, int which, double *times)
{
    const watched *w = p->w + which;
    const int odd = w->component & 1, direction = p->e[which].direction;
    long count = 0;
    int k, image;
    if (w->kind == ZERO) return 0;
    if (w->kind == CLOCK) {
        const int is_passed = p->sense * ((double)w->level - p->t0) < 2 * pi * p->turns / p->speed;
        if (is_passed && p->sense * direction >= 0) times[count++] = (double)w->level;
        return count;
    }
    for (k = 0; k <= (int)p->turns + 2; k++)
        for (image = 0; image < 2; image++) {
            const double angle = angle_of(p, odd, image) + 2 * pi * k;
            const double at = angle - p->phase, slope = odd ? cos(angle) : -sin(angle);
            if (at <= 0 || at >= 2 * pi * p->turns) continue;
            if (direction > 0 && slope < 0) continue;
            if (direction < 0 && slope > 0) continue;
            if (w->kind == CUT_OFF && slope > 0) continue;
            if (count < TIMES) times[count] = p->t0 + p->sense * at / p->speed;
            count++;
        }
    return count;
}

/* Are all passages far enough from both ends of the run? */
static int has_clear_ends(const plan *p)
{
    const double margin = 0.15, length = 2 * pi * p->turns;
    int image;
    for (image = 0; image < 4; image++) {
        const double angle = (image & 1 ? -p->angle : p->angle) + (image & 2 ? pi : 0);
        const double from_start = fmod(angle - p->phase + 8 * pi, 2 * pi);
        const double from_end = fmod(length - from_start + 2 * pi, 2 * pi);
        if (from_start < margin || from_start > 2 * pi - margin) return 0;
        if (from_end < margin || from_end > 2 * pi - margin) return 0;
    }
    return 1;
}

static int choose(int n) { return (int)uniform(0, n) % n; }

static void draw(plan *p)
{
    static const double starts[8] = {0, 0, 1, -3, 1e3, 1e5, 1.7e9, 1e12};
    static const double float_starts[8] = {0, 0, 1, -3, 10, 30, 100, 300};
    int i;
    do {
        p->speed = exp(uniform(-2, 2));
        p->t0 = (is_float ? float_starts : starts)[choose(8)];
        p->tolerance = pow(10, is_float ? uniform(-5, -3.5) : uniform(-12, -4));
        p->turns = uniform(0.5, 4);
        p->phase = uniform(0, 2 * pi);
        p->angle = uniform(0.45, 1.1); /* cos and sin of it change by more than the solution may be wrong */
        p->sense = choose(4) ? 1 : -1;
    } while (!has_clear_ends(p));
    p->instant = R(p->t0 + p->sense * fmod(p->angle - p->phase + 4 * pi, 2 * pi) / p->speed);
    p->events = 1 + choose(EVENTS);
    for (i = 0; i < p->events; i++) {
        watched *w = p->w + i;
        ode_event *e = p->e + i;
        w->kind = choose(KINDS);
        w->component = choose(4);
        w->level = w->kind == CLOCK ? p->instant : R(w->component & 1 ? sin(p->angle) : cos(p->angle));
        memset(e, 0, sizeof *e);
        e->g = watch;
        e->ctx = w;
        e->direction = choose(3) - 1;
        e->action = choose(3);
    }
}

/* One run; returns whether every event happened as often as it should, at the right times */
static int run(plan *p, int order)
{
    vm_real y0[4], work[RK87_WORK(4)], times[EVENTS][TIMES];
    const double end_error = 1e3 * p->tolerance * (2 * pi * p->turns) / p->speed;
    const double resolved = 4 * (double)VM_EPSILON * (fabs(p->t0) + 100) + end_error;
    rk45_options o = {0};
    rk45 s;
    int i, good = 1, status;
    long stops = 0;
    speed = R(p->sense * p->speed);
    for (i = 0; i < 4; i += 2) {
        y0[i] = R(cos(p->phase));
        y0[i + 1] = R(sin(p->phase));
    }
    for (i = 0; i < p->events; i++) {
        p->e[i].room = TIMES;
        p->e[i].times = times[i];
    }
    o.rtol = o.atol = R(p->tolerance);
    o.h_max = R(0.8 / p->speed); /* four looks a step: none has two passages between two looks */
    o.events = p->e;
    o.n_events = p->events;
    (order == 5 ? rk45_init : rk87_init)(&s, turn, NULL, 4, R(p->t0), y0, &o, work);
    do {
        const vm_real end = R(p->t0 + p->sense * 2 * pi * p->turns / p->speed);
        status = order == 5 ? rk45_solve(&s, end) : rk87_solve(&s, end);
        stops++;
    } while (status == ODE_EVENT && stops < 1000);
    if (status != ODE_OK) good = 0;
    for (i = 0; i < p->events; i++) {
        double wanted[2 * TIMES];
        const long count = passages(p, i, wanted);
        long k, j;
        if (p->w[i].kind == GRAZE) {
            const long touches = (long)p->turns + 2;
            if (p->e[i].count > (p->e[i].direction ? touches : 2 * touches)) good = 0;
            continue;
        }
        if (p->e[i].count != count) good = 0;
        for (k = 0; good && k < count; k++) {
            int found = 0;
            for (j = 0; j < count; j++) found = found || fabs((double)times[i][k] - wanted[j]) < resolved;
            if (!found) good = 0;
        }
    }
    return good;
}

static void show(const plan *p, int order)
{
    int i;
    printf("order %d, t0 %g, %.17g turns of speed %.17g, sense %g, tolerance %.3g, phase %.17g, angle %.17g\n", order,
           p->t0, p->turns, p->speed, p->sense, p->tolerance, p->phase, p->angle);
    for (i = 0; i < p->events; i++) {
        double times[2 * TIMES];
        printf("    kind %d, component %d, direction %d, action %d: %ld times, should be %ld\n", p->w[i].kind,
               p->w[i].component, p->e[i].direction, p->e[i].action, p->e[i].count, passages(p, i, times));
    }
}

static void test_random_runs(long runs)
{
    long i, wrong = 0;
    for (i = 0; i < runs; i++) {
        const int order = choose(2) && !is_float ? 8 : 5; /* rk87 in float is noisier than these margins */
        plan p;
        draw(&p);
        if (run(&p, order)) {
            check_passed++;
            continue;
        }
        check_failed++;
        if (wrong++ < 5) show(&p, order);
    }
    printf("%ld random runs, %ld with a lost or doubled event\n", runs, wrong);
}

/* ---- balls that bounce together ---- */

enum { BALLS = 4 };

static vm_real balls_weight; /* of the run at hand, m/s^2 */

static int fall(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    const int balls = *(const int *)ctx;
    int i;
    (void)t;
    for (i = 0; i < balls; i++) {
        dydt[2 * i] = y[2 * i + 1];
        dydt[2 * i + 1] = -balls_weight;
    }
    return 0;
}

/* ctx points at the ball's number */
static vm_real height(vm_real t, const vm_real *y, void *ctx)
{
    (void)t;
    return y[2 * *(const int *)ctx];
}

static void bounce(vm_real t, vm_real *y, void *ctx)
{
    vm_real *v = y + 2 * *(const int *)ctx + 1;
    (void)t;
    *v = -*v;
}

/* Balls, some of them from the same height, without loss. Each has to bounce as often as it should, and to be above the
   floor at the end, where it should be. */
static void test_random_bounces(long runs)
{
    static const double starts[6] = {0, 1, 1e3, 1e5, 1e9, 1e12}, float_starts[6] = {0, 0, 1, 3, 10, 30};
    long run_number, wrong = 0;
    for (run_number = 0; run_number < runs; run_number++) {
        const int order = choose(2) && !is_float ? 8 : 5, which = choose(6);
        const double t0 = (is_float ? float_starts : starts)[which], weight = exp(uniform(-1, 3));
        const double gentle = uniform(0, 0.99), length = t0 >= 1e12 ? 20 : uniform(1, 20);
        vm_real y0[2 * BALLS], work[RK87_WORK(2 * BALLS)];
        int balls = 1 + choose(BALLS), number[BALLS], i, good, status;
        ode_event e[BALLS];
        rk45_options o = {0};
        rk45 s;
        memset(e, 0, sizeof e);
        balls_weight = R(weight);
        for (i = 0; i < balls; i++) {
            number[i] = i;
            y0[2 * i] = i && choose(2) ? y0[0] : R(exp(uniform(0, 3)));
            y0[2 * i + 1] = 0;
            e[i].g = height;
            e[i].ctx = number + i;
            e[i].direction = choose(2) - 1;
            e[i].action = ODE_RESTART;
            e[i].change = bounce;
        }
        o.rtol = R(is_float ? 1e-5 : pow(10, uniform(-12, -5)));
        o.atol = o.rtol;
        o.h_max = R(gentle < 0.5 ? 0.2 / sqrt(weight) : pow(10, -2 * gentle)); /* shorter than a bounce */
        o.events = e;
        o.n_events = balls;
        o.max_steps = 300000;
        (order == 5 ? rk45_init : rk87_init)(&s, fall, &balls, 2 * balls, R(t0), y0, &o, work);
        status = order == 5 ? rk45_solve(&s, R(t0 + length)) : rk87_solve(&s, R(t0 + length));
        good = status == ODE_OK;
        for (i = 0; i < balls; i++) {
            const double h = (double)y0[2 * i], v = sqrt(2 * (double)balls_weight * h);
            const double first = v / (double)balls_weight;
            const double elapsed = (double)R(t0 + length) - t0, since = fmod(elapsed + first, 2 * first);
            const double wanted = since * (v - (double)balls_weight * since / 2);
            const double error = fabs((double)s.y[2 * i] - wanted) / (v * elapsed);
            const long bounces = (long)floor((elapsed + first) / (2 * first));
            const double clear = 1e-4 * elapsed; /* the end is not within a contact */
            if (since < clear || since > 2 * first - clear) continue;
            if (e[i].count != bounces || error > (is_float ? 3e-3 : 1e-9)) good = 0;
            if (!good && wrong < 5)
                printf("ball %d of %d, t0 %g, order %d: %ld bounces, should be %ld; height %g, should be %g\n", i,
                       balls, t0, order, e[i].count, bounces, (double)s.y[2 * i], wanted);
        }
        check_passed += good;
        check_failed += !good;
        wrong += !good;
    }
    printf("%ld random runs of balls, %ld with a wrong bounce\n", runs, wrong);
}

int main(int argc, char **argv)
{
    const long runs = argc > 1 ? atol(argv[1]) : 3000;
    test_random_runs(runs);
    test_random_bounces(runs / 10);
    return check_finish("coincidences");
}
