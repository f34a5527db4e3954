/* integrators.h: events that coincide, graze, jump or vanish, in random runs whose every event is known beforehand.
   Two oscillators turn like the hand of a clock; each event watches one of a few levels in one of many ways (itself, its
   cube, its sign, scaled, cut off at zero, by the clock), so that most of them happen at the same instants. None may be
   lost, none may happen twice, at any tolerance, at any time on the clock.
   usage: coincidences [RUNS], default 3000 */
#include "../integrators.h"
#include <stdlib.h>
#include "check.h"

#define R(x) ((vm_real)(x))
static const int is_float = PRECISION[0] == 'f';
static const double pi = 3.14159265358979323846;

enum { EVENTS = 6, TIMES = 40 };
enum { PLAIN, CUBE, SIGN, STEP, TINY, HUGE_VALUE, CUT_OFF, CLOCK, KINDS };

/* What an event watches: the angle at which its component reaches the level, for each of the two passages */
typedef struct watched {
    int kind, component; /* 0: cos, 1: sin of the angle, 2 and 3 those of the second oscillator, which is alike */
    vm_real level;
} watched;

typedef struct plan {
    double speed, t0, turns, tolerance, phase;
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
    case SIGN: return R(d > 0 ? 1 : d < 0 ? -1 : 0);
    case STEP: return R(d > 0 ? 1 : -3);
    case TINY: return d * R(1e-18);
    case HUGE_VALUE: return d * R(1e18);
    case CUT_OFF: return d > 0 ? d : 0; /* reaches zero when it falls; leaving it is no event */
    case CLOCK: return t - w->level;
    default: return d;
    }
}

/* How often the event happens in the run: passages of the angle and of its mirror image at which the component rises
   or falls through its level */
static long passages(const plan *p, int which, double *times)
{
    const watched *w = p->w + which;
    const int odd = w->component & 1, direction = p->e[which].direction;
    long count = 0;
    int k, image;
    if (w->kind == CLOCK) {
        if (direction >= 0 && (double)w->level < p->t0 + 2 * pi * p->turns / p->speed) times[count++] = (double)w->level;
        return count;
    }
    for (k = 0; k <= (int)p->turns + 2; k++)
        for (image = 0; image < 2; image++) {
            const double angle = (image ? odd ? pi - p->angle : -p->angle : p->angle) + 2 * pi * k;
            const double at = angle - p->phase, slope = odd ? cos(angle) : -sin(angle);
            if (at <= 0 || at >= 2 * pi * p->turns) continue;
            if (direction > 0 && slope < 0) continue;
            if (direction < 0 && slope > 0) continue;
            if (w->kind == CUT_OFF && slope > 0) continue;
            if (count < TIMES) times[count] = p->t0 + at / p->speed;
            count++;
        }
    return count;
}

/* Are all passages far enough from the ends of the run? */
static int has_clear_ends(const plan *p)
{
    const double margin = 0.15, length = 2 * pi * p->turns;
    int image;
    for (image = 0; image < 4; image++) {
        const double angle = image == 0 ? p->angle : image == 1 ? -p->angle : image == 2 ? pi - p->angle : pi + p->angle;
        const double from_start = fmod(angle - p->phase + 8 * pi, 2 * pi), from_end = fmod(length - from_start + 2 * pi, 2 * pi);
        if (from_start < margin || from_start > 2 * pi - margin) return 0;
        if (from_end < margin || from_end > 2 * pi - margin) return 0;
    }
    return 1;
}

static int choose(int n) { return (int)uniform(0, n) % n; }

static void draw(plan *p)
{
    static const double starts[8] = {0, 0, 1, -3, 1e3, 1e5, 1.7e9, 1e12}, float_starts[8] = {0, 0, 1, -3, 10, 30, 100, 300};
    int i;
    do {
        p->speed = exp(uniform(-2, 2));
        p->t0 = (is_float ? float_starts : starts)[choose(8)];
        p->tolerance = pow(10, is_float ? uniform(-5, -3.5) : uniform(-12, -4));
        p->turns = uniform(0.5, 4);
        p->phase = uniform(0, 2 * pi);
        p->angle = uniform(0.7, 2.4); /* cos and sin of it change by more than the solution may be wrong */
        if (p->angle > 1.1 && p->angle < 2.0) p->angle -= 0.7;
    } while (!has_clear_ends(p));
    p->instant = R(p->t0 + fmod(p->angle - p->phase + 4 * pi, 2 * pi) / p->speed);
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
    const double resolved = 4 * (double)VM_EPSILON * (fabs(p->t0) + 100) + 1e3 * p->tolerance * (2 * pi * p->turns) / p->speed;
    rk45_options o = {0};
    rk45 s;
    int i, good = 1, status;
    long stops = 0;
    speed = R(p->speed);
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
        const vm_real end = R(p->t0 + 2 * pi * p->turns / p->speed);
        status = order == 5 ? rk45_solve(&s, end) : rk87_solve(&s, end);
        stops++;
    } while (status == ODE_EVENT && stops < 1000);
    if (status != ODE_OK) good = 0;
    for (i = 0; i < p->events; i++) {
        double wanted[2 * TIMES];
        const long count = passages(p, i, wanted);
        long k, j;
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
    printf("order %d, t0 %g, %.17g turns of speed %.17g, tolerance %.3g, phase %.17g, angle %.17g\n", order, p->t0, p->turns,
           p->speed, p->tolerance, p->phase, p->angle);
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

int main(int argc, char **argv)
{
    test_random_runs(argc > 1 ? atol(argv[1]) : 3000);
    return check_finish("coincidences");
}
