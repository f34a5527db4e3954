/* varmass.h, scenes: each effect against its force written by hand at random states, the dissertation's
   numerical examples, links and cords by closed forms; events, jumps and restarts that could go wrong, and what is
   refused. */
#include <limits.h>
#include "../examples/scenes/oscillators.h"
#include "stage_check.h"

/* ---- Effects by hand ---- */

typedef struct axis {
    double x, v, force, size; /* position and velocity, sum of the forces, of their absolute values */
} axis;

static void push(axis *a, double force) {
a->force += force;
a->size += fabs(force); }

static double spring_force(double k, double alpha, double x) { return -k * copysign(pow(fabs(x), alpha), x); }

/* A body on a line (0), one in the plane (1), a point (2); the coordinates in the order of the state */
static void draw_state(stage *s, axis *line, axis *plane, axis *point)
{
    int k;
    for (k = 0; k < vm_scene_size(&s->scene); k++) s->y[k] = (vm_real)uniform(-2, 2);
    memset(line, 0, sizeof *line);
    memset(plane, 0, 3 * sizeof *plane);
    memset(point, 0, 3 * sizeof *point);
    line->x = (double)s->y[0];
    line->v = (double)s->y[1];
    for (k = 0; k < 3; k++) {
        plane[k].x = (double)s->y[2 + k];
        plane[k].v = (double)s->y[5 + k];
        point[k].x = (double)s->y[8 + k];
        point[k].v = (double)s->y[11 + k];
    }
}

static void compare(const char *what, const axis *a, double mass, vm_real acceleration)
{
    agrees("effects", what, acceleration, a->force / mass, a->size > 0 ? a->size / mass : 1, 1e-13);
}

static vm_real stokes(vm_real t, vm_real x, vm_real v, void *ctx)
{
    return -*(const vm_real *)ctx * v * VM_FABS(v) + t * x;
}

static void two_springs(const vm_effect *e, vm_real t, const vm_real *y,
                        vm_scene *scene) /* proportional to the mass */
{
    vm_load *load = &scene->bodies[e->body].load;
    (void)t;
    load->force[0] -= load->mass * y[scene->bodies[e->body].at] * *(const vm_real *)e->ctx;
}

/* Effects of one coordinate, on the line and between the line and the point */
static void check_single(double alpha)
{
    vm_real p[8], dydt[STAGE_STATE], t;
    axis line, plane[3], point[3];
    double pull;
    stage s;
    int k;
    for (k = 0; k < 8; k++) p[k] = (vm_real)uniform(0.5, 2);
    stage_clear(&s, 1);
    s.scene.book = NULL;
    stage_body(&s, vm_scene_body_line(p[0], 0, 0));
    stage_body(&s, vm_scene_body_plane(1, 1, stage_vec(0, 0, 0), 0, stage_vec(0, 0, 0), 0));
    stage_body(&s, vm_scene_body_point(p[1], stage_vec(0, 0, 0), stage_vec(0, 0, 0)));
    stage_effect(&s, vm_effect_gravity(0, 0, -p[2]));
    stage_effect(&s, vm_effect_spring(0, 0, 2, 2, p[3], (vm_real)alpha, (vm_real)0.25));
    stage_effect(&s, vm_effect_damper(0, 0, 2, 1, p[4]));
    stage_effect(&s, vm_effect_van_der_pol(0, 0, p[5], p[6]));
    stage_effect(&s, vm_effect_motor(2, 0, p[7], p[2]));
    stage_effect(&s, vm_effect_harmonic(2, 0, p[3], p[4], p[5]));
    stage_effect(&s, vm_effect_force(2, 1, stokes, p));
    stage_effect(&s, vm_effect_custom(0, VM_GROUND, two_springs, p + 6));
    begin(&s);
    draw_state(&s, &line, plane, point);
    t = (vm_real)uniform(0, 2);
    push(&line, (double)p[0] * -(double)p[2]);
    pull = spring_force((double)p[3], alpha, line.x - point[2].x - 0.25);
    push(&line, pull);
    push(point + 2, -pull);
    pull = -(double)p[4] * (line.v - point[1].v);
    push(&line, pull);
    push(point + 1, -pull);
    push(&line, ((double)p[5] - (double)p[6] * line.x * line.x) * line.v);
    push(point, (double)p[7]);
    push(point, -(double)p[2] * point[0].v);
    push(point, (double)p[3] * cos((double)p[4] * (double)t + (double)p[5]));
    push(point + 1, -(double)p[0] * point[1].v * fabs(point[1].v));
    push(point + 1, (double)t * point[1].x);
    push(&line, -(double)p[0] * (double)p[6] * line.x);
    line.size += fabs((double)p[3] + (double)p[5] + (double)p[6] * line.x * line.x);
    point[2].size += (double)p[3];
    CHECK(vm_scene_rhs(t, s.y, dydt, &s.scene) == 0 && s.scene.status == VM_OK);
    compare("line", &line, (double)p[0], dydt[1]);
    for (k = 0; k < 3; k++) compare("point", point + k, (double)p[1], dydt[11 + k]);
    for (k = 0; k < 3; k++) CHECK(dydt[5 + k] == 0 && dydt[2 + k] == s.y[5 + k] && dydt[8 + k] == s.y[11 + k]);
}

/* Shaft, unbalance, gyroscopic coupling, a stream and a mass law in the plane and of a point */
static void check_flat(double alpha)
{
    vm_real p[8], dydt[STAGE_STATE], t;
    axis line, plane[3], point[3];
    stage s;
    int k;
    for (k = 0; k < 8; k++) p[k] = (vm_real)uniform(0.5, 2);
    stage_clear(&s, 1);
    s.scene.book = NULL;
    stage_body(&s, vm_scene_body_line(1, 0, 0));
    stage_body(&s, vm_scene_body_plane(p[0], p[1], stage_vec(0, 0, 0), 0, stage_vec(0, 0, 0), 0));
    stage_body(&s, vm_scene_body_with_mass_state(vm_scene_body_point(1, stage_vec(0, 0, 0), stage_vec(0, 0, 0))));
    stage_effect(&s, vm_effect_mass(1, VM_MASS_OF_T, p[2], p[3], (vm_real)0.5));
    stage_effect(&s, vm_effect_shaft(1, p[4], (vm_real)alpha));
    stage_effect(&s, vm_effect_unbalance(1, p[5], p[6], p[7]));
    stage_effect(&s, vm_effect_gyroscopic(2, p[2]));
    stage_effect(&s, vm_effect_stream(2, p[3], vmi_vec3(p[4], -p[5], p[6]), (vm_real)0.25));
    begin(&s);
    draw_state(&s, &line, plane, point);
    s.y[14] = p[7];
    t = (vm_real)uniform(0, 2);
    for (k = 0; k < 2; k++) {
        const double r = hypot(plane[0].x, plane[1].x), phase = (double)p[6] * (double)t + (double)p[7];
        push(plane + k, (double)p[2] * ((k ? 0 : (double)p[3]) - 0.5 * plane[k].v));
        push(plane + k, -(double)p[4] * pow(r, alpha) * plane[k].x / r);
        push(plane + k, (double)p[5] * (double)p[6] * (double)p[6] * (k ? sin(phase) : cos(phase)));
        plane[k].size += (double)p[5] * (double)p[6] * (double)p[6];
    }
    push(point, -(double)p[2] * point[1].v);
    push(point + 1, (double)p[2] * point[0].v);
    for (k = 0; k < 3; k++)
        push(point + k, (double)p[3] * ((k == 1 ? -1 : 1) * (double)p[4 + k] - 0.75 * point[k].v));
    vm_scene_rhs(t, s.y, dydt, &s.scene);
    for (k = 0; k < 2; k++) compare("plane", plane + k, (double)p[0] + (double)p[2] * (double)t, dydt[5 + k]);
    for (k = 0; k < 3; k++) compare("stream", point + k, (double)p[7], dydt[11 + k]);
    CHECK(dydt[7] == 0 && dydt[14] == p[3]);
}

static void check_effects(void)
{
    static const double powers[] = {1, 2, 3, 1.5, 0.5};
    int i, k;
    for (i = 0; i < 5; i++)
        for (k = 0; k < 100; k++) {
            check_single(powers[i]);
            check_flat(powers[i]);
        }
}

/* ---- The dissertation's numerical examples, as scenes and written by hand ---- */

typedef struct by_hand {
    double m0, rate, alpha, b, c; /* mass m0 + rate t, or its square (alpha = 1.5) */
} by_hand;

/* (m x')' + x |x|^(alpha-1) = (b - c x^2) x'; k = 1 */
static int oscillator_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    const by_hand *h = (const by_hand *)ctx;
    const vm_real root = REAL(h->m0) + REAL(h->rate) * t, x = y[0], v = y[1];
    const vm_real mass = h->alpha == 1.5 ? root * root : root;
    const vm_real rate = h->alpha == 1.5 ? 2 * REAL(h->rate) * root : REAL(h->rate);
    const vm_real power = REAL(pow(fabs((double)x), h->alpha));
    dydt[0] = v;
    dydt[1] = ((REAL(h->b) - REAL(h->c) * x * x) * v - rate * v - VM_COPYSIGN(power, x)) / mass;
    return 0;
}

static int laval_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx) /* x, y, x', y' */
{
    const vm_real c = REAL(0.01), mass = 1 + c * t, rr = y[0] * y[0] + y[1] * y[1];
    int k;
    (void)ctx;
    for (k = 0; k < 2; k++) {
        dydt[k] = y[2 + k];
        dydt[2 + k] = (-y[k] * rr - c * y[2 + k]) / mass;
    }
    return 0;
}

static int pair_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx) /* x, x', y, y' */
{
    const vm_real c = REAL(0.01), mass = 1 + c * t, d = y[0] - y[2], pull = d * d * d;
    (void)ctx;
    dydt[0] = y[1];
    dydt[1] = (-pull - c * y[1]) / mass;
    dydt[2] = y[3];
    dydt[3] = (pull - c * y[3]) / mass;
    return 0;
}

static int rotor_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx) /* (68): x, y, psi, and rates */
{
    const double s = 0.5, p2 = 4, c = cos((double)y[2]), d = sin((double)y[2]);
    int k;
    (void)t;
    for (k = 0; k < 3; k++) dydt[k] = y[3 + k];
    dydt[3] = REAL(-(double)y[0] - s * c);
    dydt[4] = REAL(-(double)y[1] - s * d);
    dydt[5] = REAL(*(const double *)ctx - (double)y[5] + s * p2 * ((double)y[0] * d - (double)y[1] * c));
    return 0;
}

/* As a scene, and by hand, with the same steps of rk4: where x |x|^(alpha-1) is not smooth, those that rk45 chooses
   depend on rounding. where[i]: number i by hand in the state of the scene. Then the scene by vm_scene_run. */
static void both(stage *s, const char *name, ode_rhs hand, void *ctx, int n, const int *where, double t_end)
{
    vm_real y[6], work[RK4_WORK(6)], t = 0;
    int k;
    vm_scene_keep_budget(&s->scene, NULL);
    begin(s);
    for (k = 0; k < n; k++) y[k] = s->y[where[k]];
    CHECK(rk4_solve(hand, ctx, n, &t, REAL(t_end), (long)(100 * t_end), y, work) >= 0);
    CHECK(rk4_solve(vm_scene_rhs, &s->scene, vm_scene_size(&s->scene), &s->t, REAL(t_end), (long)(100 * t_end),
                    s->y, s->work) >= 0);
    for (k = 0; k < n; k++) agrees(name, "by hand", s->y[where[k]], (double)y[k], 1, 1e-12);
    begin(s);
    run(s, t_end, VM_OK);
}

static void check_examples(void)
{
    static const int line[] = {0, 1}, flat[] = {0, 1, 3, 4}, pair[] = {0, 1, 2, 3}, plane[] = {0, 1, 2, 3, 4, 5};
    static const double masses[] = {0.5, 1, 1.5, 3}, displacements[] = {0.5, 1.381, 2.5},
                        omegas[] = {0.625, 1, 2.5};
    by_hand h = {1, 0.1, 3, 0, 0};
    stage s;
    int i, k;
    example1(&s);
    both(&s, "(398)", oscillator_rhs, &h, 2, line, 10);
    agrees("(398)", "x(10)", s.y[0], 0.8329476745754213932, 1, 1e-9);
    agrees("(398)", "v(10)", s.y[1], -0.1999729378502724774, 1, 1e-9);
    run(&s, 20, VM_OK);
    agrees("(398)", "x(20)", s.y[0], 0.1626996653923250896, 1, 1e-9);
    h.alpha = 1.5;
    example2(&s);
    both(&s, "(402)", oscillator_rhs, &h, 2, line, 20);
    for (i = 0; i < 3; i++) {
        h.rate = -0.01;
        h.alpha = 4. / 3;
        h.b = -0.01 * i / 2;
        h.c = 0;
        figure21(&s, i / 2.);
        both(&s, "(355)", oscillator_rhs, &h, 2, line, 50);
    }
    for (i = 0; i < 4; i++)
        for (k = 0; k < 3; k++) {
            h.m0 = masses[i];
            h.rate = 0.01 * masses[i];
            h.alpha = 5. / 3;
            h.b = h.c = 0.01;
            figure27(&s, masses[i], displacements[k]);
            both(&s, "(440)", oscillator_rhs, &h, 2, line, 30);
        }
    figure30(&s);
    both(&s, "(514)", laval_rhs, NULL, 4, flat, 10);
    agrees("(514)", "x(10)", s.y[0], -0.494339964193726892, 1, 1e-9);
    agrees("(515)", "y(10)", s.y[1], -0.8503267084380806242, 1, 1e-9);
    figure32(&s);
    both(&s, "(530)", pair_rhs, NULL, 4, pair, 5);
    agrees("(530)", "x(5)", s.y[0], 1.357393389013328054, 1, 1e-9);
    agrees("(531)", "y(5)", s.y[2], 2.642606610986671946, 1, 1e-9);
    for (i = 0; i < 3; i++) {
        double omega = omegas[i];
        figure18(&s, omega);
        both(&s, "(68)", rotor_rhs, &omega, 6, plane, 10);
        if (i == 0) agrees("(68)", "Fig. 18", s.y[2], 4.849621465461194533551, 1, 1e-9);
        if (i == 1) agrees("(68)", "Fig. 18", s.y[0], -1.091259011650718279185, 1, 1e-9);
    }
}

/* ---- Links and cords ---- */

/* ctx: the point's acceleration upwards; it moves to the right with 2 m/s, too */
static void hoist(vm_real t, vm_vec3 *r, vm_vec3 *v, vm_vec3 *a, void *ctx)
{
    const double up = *(const double *)ctx, time = (double)t;
    *r = stage_vec(2 * time, up * time * time / 2, 0);
    *v = stage_vec(2, up * time, 0);
    *a = stage_vec(0, up, 0);
}

static vm_real below_hoist(vm_real t, const vm_real *y, void *ctx) { return (void)ctx, y[0] - 2 * t; }

/* A quarter of a pendulum's period, K(sin^2(theta0/2)) sqrt(l/(g + a)), where its support has the acceleration a */
static void check_pendulum(double theta, double up, int in_plane)
{
    const vm_vec3 r = stage_vec(1.5 * sin(theta), -1.5 * cos(theta), 0), v = stage_vec(2, 0, 0);
    const double m = sin(theta / 2) * sin(theta / 2);
    stage s;
    stage_clear(&s, 10);
    stage_body(&s, in_plane ? vm_scene_body_plane(2, 1, r, 0, v, 0) : vm_scene_body_point(2, r, v));
    stage_effect(&s, vm_effect_gravity(0, 1, REAL(-gravity)));
    stage_effect(&s, vm_effect_link(0, VM_GROUND, hoist, &up, REAL(1.5), 0, 1));
    stage_event(&s, vm_then_stop(vm_event_user(below_hoist, NULL, -1)));
    begin(&s);
    run(&s, 10, VM_STOPPED);
    agrees("link", "K(m)", s.t, (double)jacobi_K((vm_real)m) * sqrt(1.5 / (gravity + up)), 1, 1e-9);
    agrees("link", "length", s.y[1], up * (double)s.t * (double)s.t / 2 - 1.5, 1, 1e-9);
    balanced(&s, "link", 10, 10);
}

static vm_real cord_length(const vm_real *y) { return VM_SQRT(y[0] * y[0] + y[1] * y[1]); }

static int longest(vm_real t, const vm_real *y, vm_scene *scene, void *ctx)
{
    vm_real *most = (vm_real *)ctx;
    (void)t;
    (void)scene;
    if (cord_length(y) > *most) *most = cord_length(y);
    return 0;
}

static void nail(vm_real t, vm_vec3 *r, vm_vec3 *v, vm_vec3 *a, void *ctx)
{
    (void)t;
    (void)ctx;
    *r = *v = *a = stage_vec(0, 0, 0);
}

/* A ball on a cord of 1 m, with v^2 = 3.5 g at the bottom. 30 degrees above the support, where v^2 = g/2, the cord
   slackens; the top of the parabola is at 0.6875 m, and after 4 cos 30 sqrt(sin 30/g) s the ball is at the bottom,
   where the cord is taut again and takes the radial velocity, sqrt(g 27/8), away. */
static void check_cord(double rate, double bound)
{
    const double v = sqrt(0.5 * gravity), c = sqrt(0.75), radial = sqrt(27. / 8 * gravity),
                 flight = 4 * c * v / gravity;
    vm_real most = 0;
    stage s;
    stage_clear(&s, 5);
    stage_body(&s, vm_scene_body_point(1, stage_vec(0, -1, 0), stage_vec(sqrt(3.5 * gravity), 0, 0)));
    stage_effect(&s, vm_effect_gravity(0, 1, REAL(-gravity)));
    stage_effect(&s, vm_effect_link(0, VM_GROUND, nail, NULL, 1, 1, REAL(rate)));
    stage_event(&s, vm_then_stop(vm_event_velocity(0, 1, 0, -1)));
    s.events[0].most = 1;
    s.scene.output = longest;
    s.scene.output_ctx = &most;
    begin(&s);
    run(&s, 5, VM_STOPPED);
    agrees("cord", "top", s.y[1], 0.6875, 1, 1e-7);
    agrees("cord", "v at the top", s.y[3], -v / 2, v, 1e-6);
    CHECK(most < 1 + (is_float ? REAL(1e-4) : REAL(1e-8)));
    run(&s, (double)s.t + flight - c * v / gravity - 0.01, VM_OK);
    CHECK(cord_length(s.y) < REAL(0.95));
    run(&s, (double)s.t + 0.3, VM_OK);
    agrees("cord", "taut again", cord_length(s.y), 1, 1, 1e-5);
    check_error("cord", "energy after", "abs",
                fabs((double)(s.y[3] * s.y[3] + s.y[4] * s.y[4]) / 2 + gravity * (double)s.y[1] -
                     (0.75 * gravity - radial * radial / 2)),
                0.02, rate, 0);
    check_error("cord", "drawn out", "rel", ((double)most - 1) * exp(1.0) * rate / radial, bound, rate, 0);
    CHECK(((double)most - 1) * exp(1.0) * rate / radial > 0.9);
}

/* ---- Events and jumps that could go wrong ---- */

static vm_body part_of(double mass, double inertia)
{
    vm_body part;
    memset(&part, 0, sizeof part);
    part.mass = REAL(mass);
    part.inertia.xx = part.inertia.yy = part.inertia.zz = REAL(inertia);
    return part;
}

typedef struct note {
    int *next, number;
} note;

static int take_down(vm_real t, vm_real *y, void *ctx)
{
    const note *n = (const note *)ctx;
    (void)t;
    (void)y;
    *n->next = *n->next * 10 + n->number;
    return VM_OK;
}

static int take_down_and_stop(vm_real t, vm_real *y, void *ctx) { return take_down(t, y, ctx), (int)VM_STOPPED; }

/* A crossing at the instant of two others at a time, one of which ends the run: all happen, in their order */
static void check_same_instant(void)
{
    int order = 0;
    note one, two, three;
    stage s;
    one.next = two.next = three.next = &order;
    one.number = 1;
    two.number = 2;
    three.number = 3;
    stage_clear(&s, 2);
    stage_body(&s, vm_scene_body_line(1, -1, 1));
    stage_event(&s, vm_then_user(vm_event_at(1), take_down_and_stop, &one));
    stage_event(&s, vm_then_user(vm_event_position(0, 0, 0, 1), take_down, &two));
    stage_event(&s, vm_then_user(vm_event_at(1), take_down, &three));
    begin(&s);
    run(&s, 2, VM_STOPPED);
    CHECK(s.t == 1 && (order == 123 || order == 13));
    run(&s, 2, VM_OK); /* goes on; a crossing that rounding put after t = 1 happens now, nothing happens twice */
    CHECK(s.events[0].count == 1 && s.events[1].count == 1 && s.events[2].count == 1 && s.t == 2);
}

/* Effects on a body that is not there yet, or no longer; and the whole again from the start */
static void check_presence(void)
{
    const vm_body part = part_of(1, 0);
    vm_real first[STAGE_STATE];
    stage s;
    int k, again;
    stage_clear(&s, 4);
    stage_body(&s, vm_scene_body_line(3, 0, 2));
    stage_body(&s, vm_scene_body_absent(vm_scene_body_line(7, 5, 9)));
    stage_effect(&s, vm_effect_motor(1, 0, 1, 0));
    stage_effect(&s, vm_effect_spring(0, 0, 1, 0, 1, 1, 0));
    stage_event(&s, vm_then_separate(vm_event_at(1), 0, 1, &part, 1));
    stage_event(&s, vm_then_switch(vm_event_at(2), 1, 1));
    stage_event(&s, vm_then_attach(vm_event_at(3), 0, 1));
    stage_event(&s,
                vm_then_switch(vm_event_at(REAL(0.25)), 1, 0)); /* on, but there is no body yet at the other end */
    for (again = 0; again < 2; again++) {
        begin(&s);
        run(&s, 0.5, VM_OK);
        CHECK(s.y[1] == 2 && s.y[2] == 5 && s.y[3] == 9); /* what is not there does not move */
        run(&s, 1, VM_OK);
        CHECK(s.y[1] == 2 && !s.bodies[1].away && s.y[3] == 2 && s.bodies[0].mass == 2 && s.bodies[1].mass == 1);
        run(&s, 3, VM_OK);
        CHECK(s.bodies[1].away && s.bodies[0].mass == 3);
        run(&s, 4, VM_OK);
        agrees("presence", "v", s.y[1], (3. * 2 + 2) / 3, 2, 1e-10); /* 1 N for 2 s */
        balanced(&s, "presence", 10, 10);
        for (k = 0; k < vm_scene_size(&s.scene); k++)
            if (again) CHECK(s.y[k] == first[k]);
            else first[k] = s.y[k];
    }
    s.bodies[1].absent = 0;
    begin(&s);
    run(&s, 4, VM_IS_THERE); /* it is there already */
    CHECK(s.t == 1);
    s.bodies[0].absent = s.bodies[1].absent = 1;
    begin(&s);
    run(&s, 4, VM_IS_AWAY); /* nothing separates */
    CHECK(s.t == 1);
}

/* A part leaves a body whose mass follows a law, which goes on from what is left */
static void check_law_and_jump(void)
{
    vm_body part = part_of(1, 0), now;
    stage s;
    part.v.x = 1;
    stage_clear(&s, 5);
    stage_body(&s, vm_scene_body_line(4, 0, 2));
    stage_body(&s, vm_scene_body_absent(vm_scene_body_line(1, 0, 0)));
    stage_effect(&s, vm_effect_mass(0, VM_MASS_OF_T, (vm_real)-0.25, 0, 1));
    stage_event(&s, vm_then_separate(vm_event_at(4), 0, 1, &part, 1));
    begin(&s);
    run(&s, 5, VM_OK);
    vm_scene_body_at(&s.scene, 0, s.y, &now);
    agrees("law and jump", "mass", now.mass, 4 - 5 * 0.25 - 1, 1, 1e-14);
    agrees("law and jump", "v", now.v.x, 2 - 1. / 2, 1, 1e-14); /* (3 2 - 1 3)/2 */
    balanced(&s, "law and jump", 10, 10);
}

/* ---- Mass laws that are switched ---- */

static vm_mass_now doubling(vm_real t, vm_real x, vm_real v, void *ctx) /* 1 + t/2 by a function */
{
    const vm_mass_now now = {1 + t / 2, REAL(0.5), 0, 0};
    return (void)x, (void)v, (void)ctx, now;
}

static void loaded(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s) /* 2 kg more while it acts */
{
    (void)t;
    (void)y;
    (void)s;
    e->load->mass += 2;
}

static vm_real mass_at(stage *s, double t)
{
    vm_body now;
    run(s, t, VM_OK);
    vm_scene_body_at(&s->scene, 0, s->y, &now);
    return now.mass;
}

/* Off at t = 4 and on again at t = 6: the mass stays what it is, and then goes on from there; so does the momentum */
static void check_switched_law(int kind, double share)
{
    const vm_vec3 zero = {0, 0, 0};
    vm_body held, then, now;
    stage s;
    stage_clear(&s, 8);
    stage_body(&s, vm_scene_body_line(1, 0, 1));
    stage_effect(&s, vm_effect_mass(0, kind, REAL(0.5), 0, REAL(share)));
    if (kind > VM_MASS_OF_V2) s.effects[0] = vm_effect_mass_law(0, doubling, NULL, zero, REAL(share));
    stage_effect(&s, vm_effect_motor(0, 0, kind == VM_MASS_OF_V2 ? REAL(0.25) : 0, 0));
    stage_event(&s, vm_then_switch(vm_event_at(4), 0, 1));
    stage_event(&s, vm_then_switch(vm_event_at(6), 0, 0));
    begin(&s);
    run(&s, 4, VM_OK);
    vm_scene_body_at(&s.scene, 0, s.y, &held);
    CHECK(s.effects[0].idle && held.mass > REAL(1.5));
    run(&s, 6, VM_OK);
    vm_scene_body_at(&s.scene, 0, s.y, &then);
    agrees("switched law", "held", then.mass, (double)held.mass, 1, 1e-14);
    run(&s, 8, VM_OK);
    vm_scene_body_at(&s.scene, 0, s.y, &now);
    if (kind == VM_MASS_OF_X)
        agrees("switched law", "of x", now.mass - then.mass, (double)(now.r.x - then.r.x) / 2, 1, 1e-13);
    else if (kind == VM_MASS_OF_V2)
        agrees("switched law", "of v", now.mass - then.mass, (double)(now.v.x * now.v.x - then.v.x * then.v.x) / 2, 1,
               1e-13);
    else agrees("switched law", "of t", now.mass, 4, 1, 1e-13);
    if (kind != VM_MASS_OF_V2) agrees("switched law", "v", now.v.x, share > 0 ? 1 : 1 / (double)now.mass, 1, 1e-9);
    balanced(&s, "switched law", 10, 10);
}

/* A law that begins to act goes on from the mass with which the body was made; an effect of one's own that adds to a
   mass leaves there what it has added; a jump while a law is off counts as well */
static void check_switched_others(void)
{
    const vm_band band = {REAL(0.2), REAL(0.01), REAL(0.5), 800, 0, 1, 0};
    vm_band_now from, to;
    vm_body part = part_of(0.5, 0);
    stage s;
    stage_clear(&s, 8);
    stage_body(&s, vm_scene_body_line(1, 0, 1));
    stage_effect(&s, vm_effect_mass(0, VM_MASS_OF_T, REAL(0.5), 0, 0));
    s.effects[0].off = 1;
    stage_event(&s, vm_then_switch(vm_event_at(4), 0, 0));
    begin(&s);
    agrees("switched on late", "mass", mass_at(&s, 3), 1, 1, 0);
    agrees("switched on late", "mass", mass_at(&s, 8), 1 + 0.5 * 4, 1, 1e-14);
    agrees("switched on late", "v", s.y[1], 1 / 3., 1, 1e-10);
    balanced(&s, "switched on late", 10, 10);
    s.effects[0] = vm_effect_custom(0, VM_GROUND, loaded, NULL);
    s.events[0] = vm_then_switch(vm_event_at(4), 0, 1);
    begin(&s);
    agrees("switched callback", "mass", mass_at(&s, 3), 3, 1, 0);
    agrees("switched callback", "mass", mass_at(&s, 5), 3, 1, 0);
    balanced(&s, "switched callback", 10, 10);
    stage_clear(&s, 8);
    stage_body(&s, vm_scene_body_line(1, 0, 1));
    stage_body(&s, vm_scene_body_absent(vm_scene_body_line(1, 0, 0)));
    stage_effect(&s, vm_effect_mass(0, VM_MASS_OF_T, REAL(0.5), 0, 1));
    stage_event(&s, vm_then_switch(vm_event_at(4), 0, 1));
    stage_event(&s, vm_then_switch(vm_event_at(6), 0, 0));
    part.v.x = 1;
    stage_event(&s, vm_then_separate(vm_event_at(5), 0, 1, &part, 1));
    begin(&s);
    agrees("jump while off", "mass", mass_at(&s, 6), 3 - 0.5, 1, 1e-14);
    agrees("jump while off", "mass", mass_at(&s, 8), 3 - 0.5 + 1, 1, 1e-14);
    balanced(&s, "jump while off", 10, 10);
    stage_clear(&s, 8);
    stage_body(&s, vm_scene_body_axle(REAL(0.8), 0, 9));
    stage_effect(&s, vm_effect_band(0, &band));
    stage_event(&s, vm_then_switch(vm_event_at(4), 0, 1));
    stage_event(&s, vm_then_switch(vm_event_at(6), 0, 0));
    begin(&s);
    mass_at(&s, 6);
    from = vm_band_at(9 * 4, &band);
    agrees("switched band", "inertia", s.bodies[0].load.mass, 0.8 + (double)from.inertia, 1, 1e-12);
    from = vm_band_at(9 * 6, &band);
    to = vm_band_at(9 * 8, &band);
    agrees("switched band", "inertia", mass_at(&s, 8) - s.bodies[0].held, (double)(to.inertia - from.inertia), 1,
           1e-12);
    balanced(&s, "switched band", 1000, 1000);
}

/* ---- Links out of the plane ---- */

static void above(vm_real t, vm_vec3 *r, vm_vec3 *v, vm_vec3 *a, void *ctx)
{
    const vm_vec3 here = {0, 0, REAL(3)}, none = {0, 0, 0};
    (void)t;
    (void)ctx;
    *r = here;
    *v = *a = none;
}

/* A body in the plane on a link of 5 m to a point 3 m above it goes round in a circle of 4 m; one that hangs on a
   point in space, which takes the reaction, keeps its distance, and what the two have of momentum along the plane;
   straight below its point a body cannot move along the link */
static void check_link_in_space(void)
{
    const vm_vec3 zero = {0, 0, 0};
    vm_real dx, dy, dz, dydt[STAGE_STATE];
    stage s;
    stage_clear(&s, 3);
    stage_body(&s, vm_scene_body_plane(2, 1, stage_vec(4, 0, 0), 0, stage_vec(0, 2, 0), 0));
    stage_effect(&s, vm_effect_link(0, VM_GROUND, above, NULL, 5, 0, 10));
    begin(&s);
    run(&s, 3, VM_OK);
    agrees("link in space", "x", s.y[0], 4 * cos(1.5), 4, 1e-9);
    agrees("link in space", "y", s.y[1], 4 * sin(1.5), 4, 1e-9);
    CHECK(s.y[2] == 0 && s.y[5] == 0); /* no torque */
    s.bodies[0].start.r = zero;
    begin(&s);
    CHECK(vm_scene_rhs(0, s.y, dydt, &s.scene) == 0 && s.scene.status == VM_SINGULAR);
    run(&s, 3, VM_SINGULAR);
    CHECK(s.t == 0);
    stage_clear(&s, 3);
    stage_body(&s, vm_scene_body_plane(2, 1, stage_vec(4, 0, 0), 0, stage_vec(0, 2, 0), 0));
    stage_body(&s, vm_scene_body_point(1, stage_vec(0, 0, 3), zero));
    stage_effect(&s, vm_effect_link(0, 1, NULL, NULL, 5, 0, 10));
    begin(&s);
    run(&s, 2, VM_OK);
    dx = s.y[0] - s.y[6];
    dy = s.y[1] - s.y[7];
    dz = s.y[8];
    agrees("link in space", "length", VM_SQRT(dx * dx + dy * dy + dz * dz), 5, 5, 1e-9);
    CHECK(VM_FABS(dz - 3) > REAL(0.1)); /* the link has moved it across the plane */
    agrees("link in space", "momentum", 2 * s.y[3] + s.y[9], 0, 4, 1e-10);
    agrees("link in space", "momentum", 2 * s.y[4] + s.y[10], 4, 4, 1e-10);
}

/* A rod in the plane loses the ball at its end, and catches it with a blow from outside */
static void check_plane(void)
{
    const vm_vec3 zero = {0, 0, 0};
    vm_body part = part_of(0.5, 0);
    stage s;
    part.r.x = 1;
    stage_clear(&s, 3);
    stage_body(&s, vm_scene_body_plane(2, 1, zero, REAL(0.5), stage_vec(1, 2, 0), 3));
    stage_body(&s, vm_scene_body_absent(vm_scene_body_point(1, zero, zero)));
    stage_event(&s, vm_then_separate(vm_event_at(1), 0, 1, &part, 1));
    stage_event(&s, vm_then_attach(vm_event_at(2), 0, 1));
    s.events[1].external.linear = stage_vec(1, -1, 0);
    s.events[1].external.at = stage_vec(2, 1, 0);
    s.events[1].external.couple.z = REAL(0.3);
    begin(&s);
    run(&s, 1.5, VM_OK);
    agrees("plane", "inertia", s.bodies[0].inertia.zz, 1 - 0.5 - 0.5 * 0.5 / 1.5, 1, 1e-14);
    agrees("plane", "omega", s.y[5], 3, 1, 1e-13); /* the part moves on as before */
    balanced(&s, "plane", 10, 10);
    run(&s, 3, VM_OK);
    balanced(&s, "plane, blow", 100, 100);
    CHECK(s.y[2] > REAL(6.3)); /* more than a turn */
    part.inertia.zz = REAL(0.1);
    s.bodies[1] = vm_scene_body_absent(vm_scene_body_plane(1, 1, zero, REAL(0.25), zero, 0)); /* a part with an angle */
    s.events[0] = vm_then_separate(vm_event_at(0), 0, 1, &part, 1);
    s.events[1].most = 1;
    s.events[1].count = 0;
    begin(&s);
    run(&s, 0, VM_OK);
    agrees("plane", "part's angle", s.y[8], 0.75, 1, 1e-15);
}

/* A satellite sheds a panel, which was fixed to it turned about x; the panel's axes turn with the satellite's */
static void check_satellite(void)
{
    const double half = sqrt(0.5);
    vm_body craft = part_of(500, 0), panel = part_of(20, 0), now, rest;
    stage s;
    craft.inertia.xx = 200;
    craft.inertia.yy = 250;
    craft.inertia.zz = 300;
    craft.q.w = craft.q.z = REAL(half); /* turned by 90 degrees about z */
    craft.v = stage_vec(1, 0, 0);
    craft.omega = stage_vec(0.1, 0.02, 0.3);
    panel.inertia.xx = 2;
    panel.inertia.yy = 5;
    panel.inertia.zz = 7;
    panel.r = stage_vec(1.5, 0, 0);
    panel.v = stage_vec(0.4, 0, 0); /* pushed off along the craft's x */
    stage_clear(&s, 100);
    stage_body(&s, vm_scene_body_free(&craft));
    stage_body(&s, vm_scene_body_absent(vm_scene_body_free(&panel)));
    stage_event(&s, vm_then_separate(vm_event_at(0), 0, 1, &panel, 1));
    begin(&s);
    run(&s, 0, VM_OK);
    vm_scene_body_at(&s.scene, 1, s.y, &now);
    agrees("satellite", "panel's x", now.r.y, 1.5, 1, 1e-15);
    agrees("satellite", "panel's q", now.q.z, half, 1, 1e-15);
    agrees("satellite", "panel's v", now.v.y, 0.4 + 0 + 0.3 * 0, 1, 1e-15);
    agrees("satellite", "panel's v", now.v.x, 1 - 0.3 * 1.5, 1, 1e-15);
    CHECK(vm_separate(&craft, &now, NULL, &rest) == VM_OK && rest.mass == 480);
    vm_scene_body_at(&s.scene, 0, s.y, &now);
    agrees("satellite", "omega", now.omega.z, (double)rest.omega.z, 0.3, 1e-14);
    run(&s, 100, VM_OK);
    balanced(&s, "satellite", 3000, 3000);
    panel.q.w = panel.q.x = REAL(half);
    s.events[0].part = panel; /* and turned itself by 90 degrees about x */
    begin(&s);
    run(&s, 0, VM_OK);
    vm_scene_body_at(&s.scene, 1, s.y, &now);
    agrees("satellite", "q", now.q.w, 0.5, 1, 1e-15);
    agrees("satellite", "q", now.q.x, 0.5, 1, 1e-15);
    agrees("satellite", "q", now.q.y, 0.5, 1, 1e-15);
    agrees("satellite", "q", now.q.z, 0.5, 1, 1e-15);
}

/* A rod with a ball at its end loses the ball: a point and a rod fly on, and the rod's spin about itself stays */
static void check_rod(void)
{
    vm_body whole = part_of(3, 0), ball = part_of(1, 0), rod;
    const vm_vec3 zero = {0, 0, 0};
    stage s;
    /* the rod, 2 kg and 2 m along x: its inertia 2/3 about y and z; the ball 1 m from its middle, 2/3 m from the
       mass centre: 2/3 (1)^2 more */
    whole.inertia.yy = whole.inertia.zz = REAL(4. / 3);
    whole.omega = stage_vec(5, 0.3, 0.4);
    ball.r.x = REAL(2. / 3);
    ball.v.z = REAL(0.7);
    stage_clear(&s, 10);
    stage_body(&s, vm_scene_body_free(&whole));
    stage_body(&s, vm_scene_body_absent(vm_scene_body_point(1, zero, zero)));
    stage_event(&s, vm_then_separate(vm_event_at(1), 0, 1, &ball, 1));
    begin(&s);
    run(&s, 10, VM_OK);
    balanced(&s, "rod", 10, 10);
    vm_scene_body_at(&s.scene, 0, s.y, &rod);
    agrees("rod", "inertia", rod.inertia.zz, 2. / 3, 1, 1e-14);
    agrees("rod", "spin", s.y[10], 5, 5, 1e-10);
    CHECK(VM_FABS(rod.inertia.xx) < 100 * VM_EPSILON);
}

/* Jumps that link only what a line, an axle or the plane needs are the same to the last bit */
static void check_bound_jumps(void)
{
    const vm_vec3 zero = {0, 0, 0};
    vm_body part = part_of(0.5, 0);
    vm_real any[STAGE_STATE];
    int bound, k;
    part.r = stage_vec(0.25, 0.125, 0);
    part.v.x = 1;
    part.omega.z = REAL(0.5);
    for (bound = 0; bound < 2; bound++) {
        stage s;
        stage_clear(&s, 3);
        stage_body(&s, vm_scene_body_plane(2, 1, zero, REAL(0.5), stage_vec(1, 2, 0), 3));
        stage_body(&s, vm_scene_body_absent(vm_scene_body_point(1, zero, zero)));
        stage_body(&s, vm_scene_body_line(3, 1, 2));
        stage_body(&s, vm_scene_body_absent(vm_scene_body_line(1, 0, 0)));
        stage_event(&s, bound ? vm_then_separate_in_plane(vm_event_at(1), 0, 1, &part, 1)
                              : vm_then_separate(vm_event_at(1), 0, 1, &part, 1));
        stage_event(&s,
                    bound ? vm_then_attach_in_plane(vm_event_at(2), 0, 1) : vm_then_attach(vm_event_at(2), 0, 1));
        stage_event(&s, bound ? vm_then_separate_on_line(vm_event_at(1), 2, 3, &part, 1)
                              : vm_then_separate(vm_event_at(1), 2, 3, &part, 1));
        stage_event(&s,
                    bound ? vm_then_attach_on_line(vm_event_at(2), 2, 3) : vm_then_attach(vm_event_at(2), 2, 3));
        begin(&s);
        run(&s, 1.5, VM_OK);
        agrees("bound jumps", "line", s.y[s.bodies[3].at + 1], 3, 3, 1e-14); /* 2 m/s, and 1 m/s relative to it */
        agrees("bound jumps", "line", s.y[s.bodies[3].at], 1 + 2 + 0.25 + 0.5 * 3, 3, 1e-13);
        agrees("bound jumps", "line", s.y[s.bodies[2].at + 1], (3 * 2 - 0.5 * 3) / 2.5, 2, 1e-14);
        balanced(&s, "bound jumps", 10, 10);
        run(&s, 3, VM_OK);
        balanced(&s, "bound jumps", 10, 10);
        for (k = 0; k < vm_scene_size(&s.scene); k++)
            if (bound) CHECK(s.y[k] == any[k]);
            else any[k] = s.y[k];
    }
}

/* An axle loses half of its inertia, which turns on 1 rad/s faster, and gets a blow */
static void check_axle_jump(void)
{
    vm_body part = part_of(1, 0);
    stage s;
    part.omega.z = 1;
    stage_clear(&s, 2);
    stage_body(&s, vm_scene_body_axle(2, REAL(0.5), 3));
    stage_body(&s, vm_scene_body_absent(vm_scene_body_axle(1, 0, 0)));
    stage_event(&s, vm_then_separate_on_line(vm_event_at(1), 0, 1, &part, 1));
    s.events[0].external.couple.z = REAL(0.25);
    begin(&s);
    run(&s, 2, VM_OK);
    agrees("axle jump", "omega", s.y[1], 3 * 2 - 4 + 0.25, 1, 1e-14);
    agrees("axle jump", "omega", s.y[3], 4, 1, 1e-14);
    agrees("axle jump", "angle", s.y[0], 0.5 + 3 + 2.25, 1, 1e-13);
    agrees("axle jump", "angle", s.y[2], 0.5 + 3 + 4, 1, 1e-13);
    balanced(&s, "axle jump", 10, 10);
}

/* ---- Runs that are refused, or end early ---- */

static void refused(stage *s, int status, const char *kind, int index)
{
    vm_scene_fault found = {NULL, -2};
    CHECK(vm_scene_check(&s->scene, &found) == status && found.index == index && !strcmp(found.kind, kind));
}

static vm_real any_time(vm_real t, const vm_real *y, void *ctx) { return (void)y, (void)ctx, t + 1; }

/* Laws first, links last, one of either for a body, whichever end of the link it is */
static void check_orders(void)
{
    const vm_vec3 zero = {0, 0, 0};
    vm_effect law[3], link[3], spring[3]; /* of body i; the link and the spring against body 2, of 2 against 0 */
    stage s;
    int i;
    stage_clear(&s, 1);
    for (i = 0; i < 3; i++) {
        stage_body(&s, vm_scene_body_point(1, stage_vec(i, 0, 0), zero));
        law[i] = vm_effect_mass(i, VM_MASS_OF_T, 1, 0, 0);
        spring[i] = vm_effect_linear_spring(i, 0, i < 2 ? 2 : 0, 0, 1, 0);
        link[i] = vm_effect_link(i, i < 2 ? 2 : 0, NULL, NULL, 1, 0, 1);
    }
#define ORDER(a, b) (s.scene.n_effects = 2, s.effects[0] = (a), s.effects[1] = (b))
    ORDER(law[0], spring[0]);
    begin(&s);
    ORDER(law[0], law[1]);
    begin(&s);
    ORDER(spring[0], link[0]);
    begin(&s);
    ORDER(law[0], link[0]);
    begin(&s);
    ORDER(spring[0], spring[0]);
    begin(&s);
    ORDER(spring[0], law[1]);
    begin(&s);
    ORDER(law[0], law[0]);
    refused(&s, VM_TWO_MASS_LAWS, "effect", 1);
    ORDER(link[0], link[0]);
    refused(&s, VM_TWO_LINKS, "effect", 1);
    ORDER(link[0], link[1]);
    refused(&s, VM_TWO_LINKS, "effect", 1); /* both pull at body 2 */
    ORDER(link[0], link[2]);
    refused(&s, VM_TWO_LINKS, "effect", 1);
    ORDER(link[0], spring[0]);
    refused(&s, VM_LINK_NOT_LAST, "effect", 1);
    ORDER(link[0], spring[1]);
    refused(&s, VM_LINK_NOT_LAST, "effect", 1); /* it loads body 2 */
    ORDER(spring[0], law[0]);
    refused(&s, VM_BAD_ORDER, "effect", 1);
    ORDER(spring[0], law[2]);
    refused(&s, VM_BAD_ORDER, "effect", 1);
    ORDER(link[1], law[2]);
    refused(&s, VM_BAD_ORDER, "effect", 1);
    stage_clear(&s, 1);
    stage_body(&s, vm_scene_body_plane(1, 1, zero, 0, zero, 0));
    stage_body(&s, vm_scene_body_absent(s.bodies[0]));
    stage_event(&s, vm_then_attach_on_line(vm_event_at(1), 0, 1));
    refused(&s, VM_BAD_MOTION, "event", 0);
    s.events[0] = vm_then_attach_in_plane(vm_event_at(1), 0, 1);
    begin(&s);
    s.bodies[0] = s.bodies[1] = vm_scene_body_line(1, 0, 0);
    refused(&s, VM_BAD_MOTION, "event", 0);
}

static void check_refusals(void)
{
    const vm_vec3 zero = {0, 0, 0};
    static const vm_real times[] = {1, 2, 2};
    vm_body part = part_of(1, 0);
    vm_event break_up;
    vm_budget b;
    rk45_options o = stage_options();
    stage s;
    stage_clear(&s, 1);
    stage_body(&s, vm_scene_body_plane(2, 1, zero, 0, zero, 0));
    stage_body(&s, vm_scene_body_axle(1, 0, 0));
    stage_body(&s, vm_scene_body_absent(vm_scene_body_point(1, zero, zero)));
    stage_effect(&s, vm_effect_link(0, 1, NULL, NULL, 1, 0, 1));
    refused(&s, VM_BAD_MOTION, "effect", 0);
    s.effects[0] = vm_effect_link(0, VM_GROUND, NULL, NULL, 1, 0, 1);
    refused(&s, VM_BAD_ARGUMENT, "effect", 0);
    s.effects[0] = vm_effect_link(0, 2, NULL, NULL, 0, 0, 1);
    refused(&s, VM_DOMAIN, "effect", 0);
    s.effects[0] = vm_effect_link(0, 2, NULL, NULL, 1, 1, -1);
    refused(&s, VM_DOMAIN, "effect", 0);
    s.effects[0] = vm_effect_link(0, 2, NULL, NULL, 1, 1, 1);
    begin(&s);
    s.bodies[0] = vm_scene_body_growing_plane(s.bodies[0]);
    refused(&s, VM_BAD_MOTION, "effect", 0);
    s.bodies[0] = vm_scene_body_plane(2, 1, zero, 0, zero, 0);
    s.effects[0] = vm_effect_spring(0, 0, VM_GROUND, 0, 1, -1, 0);
    refused(&s, VM_DOMAIN, "effect", 0);
    s.effects[0] = vm_effect_shaft(0, 1, -1);
    refused(&s, VM_DOMAIN, "effect", 0);
    s.effects[0] = vm_effect_shaft(0, 1, 0);
    begin(&s);
    s.effects[0] = vm_effect_gravity(0, 2, 1);
    refused(&s, VM_NOT_ON_ANGLE, "effect", 0);
    s.effects[0] = vm_effect_gravity(0, 1, 1);
    begin(&s);
    s.effects[0] = vm_effect_gravity(2, 2, 1);
    begin(&s); /* of a point it is z */
    s.effects[0] = vm_effect_damper(0, 0, VM_GROUND, INT_MAX, 1);
    begin(&s); /* the ground has no coordinates */
    CHECK(s.effects[0].other_x == s.effects[0].x && s.effects[0].other_v == s.effects[0].v);
    s.effects[0] = vm_effect_damper(0, 0, 1, INT_MAX, 1);
    refused(&s, VM_NO_SUCH_COORDINATE, "effect", 0);
    s.effects[0] = vm_effect_damper(0, INT_MAX, 1, 0, 1);
    refused(&s, VM_NO_SUCH_COORDINATE, "effect", 0);
    s.effects[0] = vm_effect_damper(INT_MAX, 0, 1, 0, 1);
    refused(&s, VM_NO_SUCH_BODY, "effect", 0);
    s.effects[0] = vm_effect_damper(0, 0, INT_MIN, 0, 1);
    refused(&s, VM_NO_SUCH_BODY, "effect", 0);
    s.effects[0] = vm_effect_link(0, 0, NULL, NULL, 1, 0, 1);
    refused(&s, VM_SAME_BODY, "effect", 0);
    s.effects[0] = vm_effect_mass(1, 7, 1, 0, 0);
    refused(&s, VM_BAD_ARGUMENT, "effect", 0);
    s.effects[0] = vm_effect_custom(1, VM_GROUND, NULL, NULL);
    refused(&s, VM_BAD_ARGUMENT, "effect", 0);
    s.effects[0] = vm_effect_motor(0, 2, 1, 0);
    break_up = vm_then_separate(vm_event_at(1), 0, 2, &part, 1);
    stage_event(&s, break_up);
    begin(&s);
    s.events[0].part.mass = VM_NAN;
    refused(&s, VM_NOT_FINITE, "event", 0);
    s.events[0].part.mass = 0;
    refused(&s, VM_BAD_MASS, "event", 0);
    s.events[0].part = part_of(1, 1);
    refused(&s, VM_BAD_INERTIA, "event", 0); /* a point carries no spin */
    s.events[0] = break_up;
    s.events[0].external.at.y = VM_INFINITY;
    refused(&s, VM_NOT_FINITE, "event", 0);
    s.events[0] = vm_then_separate(vm_event_at(1), 0, 2, NULL, 1);
    refused(&s, VM_BAD_ARGUMENT, "event", 0);
    s.events[0] = vm_then_stop(vm_event_user(NULL, NULL, 0));
    refused(&s, VM_BAD_ARGUMENT, "event", 0);
    s.events[0] = vm_then_stop(vm_event_at(1));
    s.events[0].most = -1;
    refused(&s, VM_BAD_ARGUMENT, "event", 0);
    s.events[0] = vm_then_user(vm_event_at(1), NULL, NULL);
    refused(&s, VM_BAD_ARGUMENT, "event", 0);
    s.events[0] = vm_then_stop(vm_event_user(any_time, NULL, 0));
    begin(&s);
    s.bodies[2] = vm_scene_body_free(NULL);
    refused(&s, VM_BAD_ARGUMENT, "body", 2);
    s.scene.n_bodies = 2;
    s.scene.times = times;
    s.scene.n_times = 3;
    refused(&s, VM_BAD_TIMES, "scene", -1);
    s.scene.n_times = 2;
    begin(&s);
    CHECK(vm_scene_start(&s.scene, VM_NAN, s.y, NULL) == VM_NOT_FINITE);
    CHECK(vm_scene_start(&s.scene, 0, NULL, NULL) == VM_BAD_ARGUMENT);
    run(&s, -1, VM_BAD_TIMES);
    run(&s, (double)VM_INFINITY, VM_NOT_FINITE);
    run(&s, (double)VM_NAN, VM_NOT_FINITE);
    CHECK(vm_scene_run(NULL, &s.t, 1, s.y, s.work, NULL) == VM_BAD_ARGUMENT);
    CHECK(vm_scene_run(&s.scene, NULL, 1, s.y, s.work, NULL) == VM_BAD_ARGUMENT);
    CHECK(vm_scene_run(&s.scene, &s.t, 1, NULL, s.work, NULL) == VM_BAD_ARGUMENT);
    CHECK(vm_scene_run(&s.scene, &s.t, 1, s.y, NULL, NULL) == VM_BAD_ARGUMENT);
    o.max_steps = 2;
    CHECK(vm_scene_run(&s.scene, &s.t, 1000, s.y, s.work, &o) == VM_MAX_STEPS);
    CHECK(s.scene.ode_status == ODE_MAX_STEPS && s.t > 0 && s.t < 1000);
    vm_scene_keep_budget(&s.scene, NULL);
    CHECK(vm_scene_size(&s.scene) == 8 && vm_scene_budget_at(&s.scene, 0, s.y, &b) == VM_BAD_ARGUMENT);
}

int main(void)
{
    int k;
    check_effects();
    check_examples();
    check_pendulum(2, 0, 0);
    check_pendulum(3, 2, 1);
    check_cord(is_float ? 100 : 1000, 1.1); /* a faster one is too stiff for float */
    check_same_instant();
    check_presence();
    check_law_and_jump();
    for (k = 0; k < 2; k++) {
        check_switched_law(VM_MASS_OF_T, k);
        check_switched_law(VM_MASS_OF_X, k);
        check_switched_law(VM_MASS_OF_V2, k);
        check_switched_law(VM_MASS_OF_V2 + 1, k);
    }
    check_switched_others();
    check_link_in_space();
    check_plane();
    check_satellite();
    check_rod();
    check_bound_jumps();
    check_axle_jump();
    check_orders();
    check_refusals();
    return check_finish("scene effects");
}
