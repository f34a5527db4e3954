/* All chapters from many threads at once. Each thread computes, with plans that all share, what one thread computed
   before, and must get the same bits. Under ThreadSanitizer (make test-threads) a race would show.

   usage: threads [THREADS [ROUNDS]] */
#define _POSIX_C_SOURCE 200809L
#include "../varmass.h"
#include "check.h"
#include <pthread.h>
#include <stdlib.h>

#define R(x) ((vm_real)(x))
enum { JOBS = 48, MOST_THREADS = 64 };

/* Prepared once, read by all threads */
static jacobi_plan elliptic;
static ateb_plan periodic;
static vm_torque_free tumbling;
static vm_osc_plan oscillator;
static const vm_real table_time[3] = {0, 5, 10}, table_mass[3] = {2, R(1.5), 1};

typedef struct work_of {
    uint64_t hash, state;
} work_of;

static void fold(work_of *w, vm_real x) /* FNV-1a over the bits */
{
    const uint64_t bits = x == x ? vmi_to_bits(x) : 0;
    int shift;
    for (shift = 0; shift < 64; shift += 8) w->hash = (w->hash ^ (bits >> shift & 255)) * UINT64_C(1099511628211);
}

static vm_real draw(work_of *w, double low, double high)
{
    w->state = w->state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return R(low + (high - low) * ((double)(w->state >> 11) / 9007199254740992.0));
}

static void special_functions(work_of *w)
{
    const vm_real m = draw(w, -3, 1), u = draw(w, -20, 20), alpha = draw(w, 0, 6), a = draw(w, 0.1, 9);
    vm_real x, y, z, own[3], xs[3], ys[3], zs[3];
    int i;
    jacobi_plan p;
    jacobi_sncndn(u, m, &x, &y, &z);
    fold(w, x);
    fold(w, y);
    fold(w, z);
    fold(w, jacobi_K(m));
    fold(w, jacobi_E(m));
    fold(w, jacobi_am(u, m));
    fold(w, jacobi_ns(u, m));
    fold(w, jacobi_solve_kpK(a));
    fold(w, jacobi_solve_K(a));
    jacobi_cn_means(m, &x, &y, &z);
    fold(w, z);
    jacobi_agm_sncndn(u, m, 9, &x, &y, &z);
    fold(w, x);
    fold(w, jacobi_agm_K(m));
    if (jacobi_plan_init(&p, m) == 0) {
        jacobi_plan_sncndn(&p, u, &x, &y, &z);
        fold(w, x);
        fold(w, z);
    }
    jacobi_plan_sncndn(&elliptic, u, &x, &y, &z);
    fold(w, y);
    for (i = 0; i < 3; i++) own[i] = u + R(i);
    jacobi_plan_sncndn_array(&elliptic, 3, own, xs, ys, zs);
    fold(w, xs[2]);
    fold(w, zs[1]);
    ateb_saca(u, alpha, &x, &y);
    fold(w, x);
    fold(w, y);
    fold(w, ateb_phase(x, y, alpha));
    fold(w, ateb_pi(alpha));
    ateb_plan_saca(&periodic, u, &x, &y);
    fold(w, x);
    fold(w, y);
    ateb_plan_saca_array(&periodic, 3, own, xs, ys);
    fold(w, xs[1]);
    fold(w, ys[0]);
    fold(w, ateb_beta(alpha + 1, a));
    fold(w, ateb_beta_inc(R(0.3), alpha + 1, a));
    fold(w, ateb_mean(alpha, 2, 1));
    fold(w, ateb_beta_inc_inv(R(0.3), alpha + 1, a));
    fold(w, vm_lambert_w0(a));
    fold(w, vm_lambert_wm1(-a / 30));
    ateb_saca_nm(u, alpha, a, &x, &y);
    fold(w, x);
    fold(w, y);
}

static int pendulum(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t;
    dydt[0] = y[1];
    dydt[1] = -*(const vm_real *)ctx * y[0];
    return 0;
}

static vm_real crossing(vm_real t, const vm_real *y, void *ctx)
{
    (void)t;
    (void)ctx;
    return y[0];
}

static void integrators(work_of *w)
{
    vm_real k = draw(w, 0.5, 4), y[2], work[RK87_WORK(2)], t = 0;
    rk45_options o;
    ode_event event;
    rk45 s;
    memset(&o, 0, sizeof o);
    memset(&event, 0, sizeof event);
    event.g = crossing;
    o.events = &event;
    o.n_events = 1;
    y[0] = draw(w, 0.5, 2);
    y[1] = 0;
    rk45_init(&s, pendulum, &k, 2, 0, y, &o, work);
    rk45_solve(&s, 5);
    fold(w, s.y[0]);
    fold(w, event.t);
    rk87_init(&s, pendulum, &k, 2, 0, y, &o, work);
    rk87_solve(&s, 5);
    fold(w, s.y[0]);
    fold(w, R(s.evals));
    rk4_solve(pendulum, &k, 2, &t, 5, 50, y, work);
    fold(w, y[0]);
    fold(w, y[1]);
}

static vm_body some_body(work_of *w)
{
    vm_body b;
    memset(&b, 0, sizeof b);
    b.mass = draw(w, 2, 4);
    b.inertia.xx = draw(w, 2, 3);
    b.inertia.yy = draw(w, 2, 3);
    b.inertia.zz = draw(w, 2, 3);
    b.q.w = 1;
    b.q.x = draw(w, -1, 1);
    b.r.y = draw(w, -1, 1);
    b.v.z = draw(w, -3, 3);
    b.omega.x = draw(w, -2, 2);
    b.omega.y = draw(w, -2, 2);
    b.omega.z = draw(w, -2, 2);
    return b;
}

static void bodies(work_of *w)
{
    vm_body whole = some_body(w), part = whole, rest, later;
    vm_flow flow;
    vm_stream jet;
    vm_real y[VM_FLOW_STATES], dydt[VM_FLOW_STATES], work[RK45_WORK(VM_FLOW_STATES)];
    rk45 s;
    part.mass = R(0.5);
    part.inertia.xx = part.inertia.yy = part.inertia.zz = R(0.05);
    part.v.x = draw(w, -3, 3);
    fold(w, R(vm_separate(&whole, &part, NULL, &rest)));
    fold(w, rest.omega.x);
    fold(w, rest.v.x);
    fold(w, R(vm_attach(&rest, &part, NULL, &later)));
    fold(w, later.omega.y);
    fold(w, vm_kinetic_energy(&later));
    fold(w, R(vm_torque_free_at(&tumbling, draw(w, 0, 100), &later)));
    fold(w, later.q.x);
    fold(w, later.omega.z);
    fold(w, R(vm_torque_free_rotation(&whole, draw(w, 0, 9), &later)));
    fold(w, later.q.y);
    memset(&flow, 0, sizeof flow);
    memset(&jet, 0, sizeof jet);
    jet.rate = R(-0.1);
    jet.velocity.x = draw(w, 1, 5);
    jet.at.y = R(0.25);
    flow.n = 1;
    flow.streams = &jet;
    vm_flow_start(&flow, &whole, y);
    vm_flow_rhs(0, y, dydt, &flow);
    fold(w, dydt[VM_Y_P]);
    fold(w, dydt[VM_Y_H + 2]);
    if (rk45_init(&s, vm_flow_rhs, &flow, VM_FLOW_STATES, 0, y, NULL, work) >= 0 && rk45_solve(&s, 1) >= 0) fold(w, s.y[VM_Y_Q]);
}

static void oscillators(work_of *w)
{
    const vm_real t = draw(w, 0, 5), alpha = draw(w, 0.5, 5);
    vm_osc_motion motion;
    vm_osc_problem own;
    vm_forced f;
    vm_steady_state steady[3];
    vm_drum drum;
    vm_real x, v;
    int route;
    memset(&own, 0, sizeof own);
    memset(&f, 0, sizeof f);
    memset(&drum, 0, sizeof drum);
    own.alpha = alpha;
    own.mass = vm_law_table(3, table_time, table_mass);
    own.stiffness = vm_law_linear(3, 0);
    own.x = 1;
    for (route = 0; route <= VM_ROUTE_RK87; route++) {
        fold(w, R(vm_osc_plan_by_route(&oscillator, route, t, 0, &motion)));
        fold(w, motion.x);
        fold(w, motion.error);
    }
    fold(w, R(vm_osc_within(&own, t, R(1e-2), &motion)));
    fold(w, motion.x);
    fold(w, motion.v);
    vm_osc_exact(t, 1, 2, alpha, &x, &v);
    fold(w, x);
    fold(w, v);
    f.alpha = 3;
    f.damping = R(0.05);
    f.mass = vm_law_linear(1, 0);
    f.stiffness = vm_law_linear(1, 0);
    f.frequency = vm_law_linear(draw(w, 0.5, 2), 0);
    f.force = vm_law_linear(R(0.1), 0);
    vm_forced_init(&f);
    fold(w, R(vm_forced_steady_states(&f, 0, steady)));
    fold(w, steady[0].A);
    drum.radius = R(0.5);
    drum.mass = 2;
    drum.inertia = 1;
    drum.band = R(0.1);
    drum.speed = draw(w, -1, 1);
    drum.omega = 3;
    fold(w, vm_drum_angle(&drum, 1));
    fold(w, vm_drum_angle_lambert(&drum, 1));
}

static void scenes(work_of *w)
{
    vm_scene_body list[2];
    vm_effect effects[3];
    vm_event events[1];
    ode_event located[1];
    vm_scene scene;
    vm_real y[8], work[VM_SCENE_WORK(8)], t = 0;
    memset(&scene, 0, sizeof scene);
    list[0] = vm_scene_body_line(2, draw(w, 0.5, 1), 0);
    list[1] = vm_scene_body_axle(1, 0, draw(w, 1, 2));
    effects[0] = vm_effect_mass(0, VM_MASS_OF_T, R(-0.125), 0, 0);
    effects[1] = vm_effect_spring(0, 0, VM_GROUND, 0, 3, R(1.5), 0);
    effects[2] = vm_effect_motor(1, 0, R(0.5), R(0.1));
    events[0] = vm_then_switch(vm_event_position(0, 0, 0, -1), 2, 1);
    scene.bodies = list;
    scene.n_bodies = 2;
    scene.effects = effects;
    scene.n_effects = 3;
    scene.events = events;
    scene.located = located;
    scene.n_events = 1;
    fold(w, R(vm_scene_start(&scene, 0, y, NULL)));
    fold(w, R(vm_scene_run(&scene, &t, 3, y, work, NULL)));
    fold(w, y[0]);
    fold(w, y[1]);
    fold(w, y[3]);
    fold(w, located[0].t);
}

static uint64_t job(int number)
{
    work_of w;
    w.hash = UINT64_C(14695981039346656037);
    w.state = (uint64_t)number + 1;
    special_functions(&w);
    integrators(&w);
    bodies(&w);
    oscillators(&w);
    scenes(&w);
    return w.hash;
}

static uint64_t alone[JOBS];
static int rounds;

/* Every job, beginning with another one in each thread; null if all results are those of one thread */
static void *all_jobs(void *number)
{
    const int start = *(const int *)number * 7;
    int i, k;
    long differing = 0;
    for (k = 0; k < rounds; k++)
        for (i = 0; i < JOBS; i++) differing += job((start + i) % JOBS) != alone[(start + i) % JOBS];
    return differing ? number : NULL;
}

static void prepare(void)
{
    work_of w;
    vm_body body;
    vm_osc_problem p;
    memset(&w, 0, sizeof w);
    memset(&p, 0, sizeof p);
    body = some_body(&w);
    p.alpha = R(1.5);
    p.mass = vm_law_table(3, table_time, table_mass);
    p.stiffness = vm_law_exponential(3, R(-0.01));
    p.x = 1;
    p.reactive = 1;
    CHECK(jacobi_plan_init(&elliptic, R(0.7)) == 0 && ateb_plan_init(&periodic, R(2.2)) == 0);
    CHECK(vm_torque_free_init(&tumbling, &body, 0) == VM_OK && vm_osc_plan_init(&oscillator, &p) == VM_OK);
}

int main(int argc, char **argv)
{
    const int wanted = argc > 1 ? (int)strtol(argv[1], NULL, 10) : 8;
    const int threads = wanted < MOST_THREADS ? wanted : MOST_THREADS;
    pthread_t thread[MOST_THREADS];
    int number[MOST_THREADS], i;
    rounds = argc > 2 ? (int)strtol(argv[2], NULL, 10) : 2;
    prepare();
    for (i = 0; i < JOBS; i++) alone[i] = job(i);
    CHECK(alone[0] != alone[1]);
    for (i = 0; i < threads; i++) {
        number[i] = i;
        CHECK(pthread_create(thread + i, NULL, all_jobs, number + i) == 0);
    }
    for (i = 0; i < threads; i++) {
        void *differing;
        CHECK(pthread_join(thread[i], &differing) == 0 && differing == NULL);
    }
    return check_finish("threads");
}
