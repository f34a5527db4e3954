/* varmass.h, scenes: effects. The accelerations that effects make at random states, against the forces written by
   hand; the dissertation's numerical examples as scenes, against the same equations written by hand and reference
   values. */
#include "../examples/scenes/oscillators.h"
#include "stage_check.h"

/* ---- Effects at random states ---- */

/* One coordinate: position, velocity, the sum of the forces on it, and the sum of their absolute values */
typedef struct axis {
    double x, v, force, size;
} axis;

static void push(axis *a, double force)
{
    a->force += force;
    a->size += fabs(force);
}

static double spring_force(double k, double alpha, double x) { return -k * copysign(pow(fabs(x), alpha), x); }

/* Draws the state of a scene of a body on a line (0), one in the plane (1) and a point (2): the numbers in the order
   of the state, as axes. */
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

/* The acceleration of a mass, against the forces that have been pushed; relative to the sum of their sizes */
static void compare(const char *what, const axis *a, double mass, vm_real acceleration)
{
    agrees("effects", what, acceleration, a->force / mass, a->size > 0 ? a->size / mass : 1, 1e-13);
}

/* A force of the user's: drag by the square of the velocity, with a coefficient, and a force that grows with time */
static vm_real stokes(vm_real t, vm_real x, vm_real v, void *ctx)
{
    return -*(const vm_real *)ctx * v * VM_FABS(v) + t * x;
}

/* A force proportional to the mass and the position */
static void two_springs(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *scene)
{
    vm_load *load = &scene->bodies[e->body].load;
    (void)t;
    load->force[0] -= load->mass * y[scene->bodies[e->body].at] * *(const vm_real *)e->ctx;
}

static double draw(void) { return uniform(0.5, 2); }

/* Effects on one coordinate: of the body on the line, of the point, and between the two */
static void check_single(double alpha)
{
    const double mass = draw(), point_mass = draw(), g = draw(), k = draw(), rest = 0.25, b = draw();
    const double feed = draw(), limit = draw(), torque = draw(), kappa = draw();
    const double force = draw(), frequency = draw(), phase = draw();
    vm_real drag = REAL(draw()), pull = REAL(draw()), dydt[STAGE_STATE];
    axis line, plane[3], point[3];
    double t, between;
    stage s;
    int i;
    stage_clear(&s, 1);
    s.scene.budget = NULL;
    stage_body(&s, vm_scene_body_line(REAL(mass), 0, 0));
    stage_body(&s, vm_scene_body_plane(1, 1, stage_vec(0, 0, 0), 0, stage_vec(0, 0, 0), 0));
    stage_body(&s, vm_scene_body_point(REAL(point_mass), stage_vec(0, 0, 0), stage_vec(0, 0, 0)));
    stage_effect(&s, vm_effect_gravity(0, 0, REAL(-g)));
    stage_effect(&s, vm_effect_spring(0, 0, 2, 2, REAL(k), REAL(alpha), REAL(rest)));
    stage_effect(&s, vm_effect_damper(0, 0, 2, 1, REAL(b)));
    stage_effect(&s, vm_effect_van_der_pol(0, 0, REAL(feed), REAL(limit)));
    stage_effect(&s, vm_effect_custom(0, VM_GROUND, two_springs, &pull));
    stage_effect(&s, vm_effect_motor(2, 0, REAL(torque), REAL(kappa)));
    stage_effect(&s, vm_effect_harmonic(2, 0, REAL(force), REAL(frequency), REAL(phase)));
    stage_effect(&s, vm_effect_force(2, 1, stokes, &drag));
    begin(&s);
    draw_state(&s, &line, plane, point);
    t = uniform(0, 2);
    push(&line, -mass * g);
    between = spring_force(k, alpha, line.x - point[2].x - rest);
    push(&line, between);
    push(point + 2, -between);
    between = -b * (line.v - point[1].v);
    push(&line, between);
    push(point + 1, -between);
    push(&line, (feed - limit * line.x * line.x) * line.v);
    push(&line, -mass * (double)pull * line.x);
    push(point, torque);
    push(point, -kappa * point[0].v);
    push(point, force * cos(frequency * t + phase));
    push(point + 1, -(double)drag * point[1].v * fabs(point[1].v));
    push(point + 1, t * point[1].x);
    line.size += k + feed + limit * line.x * line.x; /* terms that cancel in the extension and in Van der Pol's force */
    point[2].size += k;
    CHECK(vm_scene_rhs(REAL(t), s.y, dydt, &s.scene) == 0 && s.scene.status == VM_OK);
    compare("line", &line, mass, dydt[1]);
    for (i = 0; i < 3; i++) compare("point", point + i, point_mass, dydt[11 + i]);
    for (i = 0; i < 3; i++) CHECK(dydt[5 + i] == 0 && dydt[2 + i] == s.y[5 + i] && dydt[8 + i] == s.y[11 + i]);
}

/* A mass law, a shaft and an unbalance of the body in the plane; gyroscopic coupling and a stream of the point */
static void check_vectors(double alpha)
{
    const double mass = draw(), inertia = draw(), growth = draw(), growth_u = draw(), k = draw();
    const double unbalance = draw(), frequency = draw(), phase = draw();
    const double point_mass = draw(), gyro = draw(), rate = draw();
    const double ux = draw(), uy = -draw(), uz = draw(); /* the stream's own velocity */
    const double centrifugal = unbalance * frequency * frequency;
    vm_real dydt[STAGE_STATE];
    axis line, plane[3], point[3];
    double t, r, angle;
    stage s;
    int i;
    stage_clear(&s, 1);
    s.scene.budget = NULL;
    stage_body(&s, vm_scene_body_line(1, 0, 0));
    stage_body(&s, vm_scene_body_plane(REAL(mass), REAL(inertia), stage_vec(0, 0, 0), 0, stage_vec(0, 0, 0), 0));
    stage_body(&s, vm_scene_body_with_mass_state(vm_scene_body_point(1, stage_vec(0, 0, 0), stage_vec(0, 0, 0))));
    stage_effect(&s, vm_effect_mass(1, VM_MASS_OF_T, REAL(growth), REAL(growth_u), REAL(0.5)));
    stage_effect(&s, vm_effect_shaft(1, REAL(k), REAL(alpha)));
    stage_effect(&s, vm_effect_unbalance(1, REAL(unbalance), REAL(frequency), REAL(phase)));
    stage_effect(&s, vm_effect_gyroscopic(2, REAL(gyro)));
    stage_effect(&s, vm_effect_stream(2, REAL(rate), stage_vec(ux, uy, uz), REAL(0.75)));
    begin(&s);
    draw_state(&s, &line, plane, point);
    s.y[14] = REAL(point_mass);
    t = uniform(0, 2);
    r = hypot(plane[0].x, plane[1].x);
    angle = frequency * t + phase;
    push(plane, growth * (growth_u - 0.5 * plane[0].v));
    push(plane + 1, growth * -0.5 * plane[1].v);
    push(plane, centrifugal * cos(angle));
    push(plane + 1, centrifugal * sin(angle));
    for (i = 0; i < 2; i++) {
        push(plane + i, -k * pow(r, alpha) * plane[i].x / r);
        plane[i].size += centrifugal; /* the angle is rounded */
    }
    push(point, -2 * gyro * point[1].v);
    push(point + 1, 2 * gyro * point[0].v);
    push(point, rate * (ux - 0.75 * point[0].v));
    push(point + 1, rate * (uy - 0.75 * point[1].v));
    push(point + 2, rate * (uz - 0.75 * point[2].v));
    vm_scene_rhs(REAL(t), s.y, dydt, &s.scene);
    for (i = 0; i < 2; i++) compare("plane", plane + i, mass + growth * t, dydt[5 + i]);
    for (i = 0; i < 3; i++) compare("stream", point + i, point_mass, dydt[11 + i]);
    CHECK(dydt[7] == 0 && dydt[14] == REAL(rate));
}

static void check_effects(void)
{
    static const double powers[] = {1, 2, 3, 1.5, 0.5};
    int i, k;
    for (i = 0; i < 5; i++) {
        for (k = 0; k < 100; k++) {
            check_single(powers[i]);
            check_vectors(powers[i]);
        }
    }
}

/* ---- Effects on one coordinate, in numbers ---- */

static vm_real soft(vm_real t, vm_real x, vm_real v, void *ctx)
{
    (void)ctx;
    return -2 * x + v - t;
}

/* A linear spring and a user's force between two bodies on lines, and a damper of the rotation of a free body:
   I omega' + omega x I omega = -b omega */
static void check_numbers(void)
{
    const vm_body body = probe();
    vm_real dydt[STAGE_STATE];
    vm_vec3 omega, torque;
    stage s;
    stage_clear(&s, 1);
    stage_body(&s, vm_scene_body_line(2, 3, 1));
    stage_body(&s, vm_scene_body_line(4, 1, 2));
    stage_body(&s, vm_scene_body_free(&body));
    stage_effect(&s, vm_effect_linear_spring(0, 0, 1, 0, 5, REAL(0.5)));
    begin(&s);
    s.scene.budget = NULL;
    vm_scene_rhs(3, s.y, dydt, &s.scene);
    agrees("numbers", "linear spring", dydt[1], -5 * (2 - 0.5) / 2, 1, 1e-15);
    agrees("numbers", "linear spring", dydt[3], 5 * (2 - 0.5) / 4, 1, 1e-15);
    s.effects[0] = vm_effect_force_between(0, 0, 1, 0, soft, NULL);
    begin(&s);
    vm_scene_rhs(3, s.y, dydt, &s.scene);
    agrees("numbers", "user between", dydt[1], (-2. * 2 - 1 - 3) / 2, 1, 1e-15);
    agrees("numbers", "user between", dydt[3], (2. * 2 + 1 + 3) / 4, 1, 1e-15);
    s.effects[0] = vm_effect_rotational_damper(2, REAL(0.25));
    begin(&s);
    vm_scene_rhs(0, s.y, dydt, &s.scene);
    omega = vmi_get3(s.y + 14);
    torque = vm_add(vmi_inertia_times(&body.inertia, vmi_get3(dydt + 14)),
                     vm_cross(omega, vmi_inertia_times(&body.inertia, omega)));
    agrees("numbers", "rotational damper", size_of(vm_sub(torque, vm_scale(REAL(-0.25), omega))), 0, 1, 1e-14);
}

/* ---- The dissertation's numerical examples ---- */

typedef struct by_hand {
    double m0, rate, alpha, b, c; /* mass m0 + rate t, or its square (alpha = 1.5) */
} by_hand;

/* (m x')' + x |x|^(alpha-1) = (b - c x^2) x' */
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

/* The state is x, y, x', y'. */
static int laval_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
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

/* The state is x, x', y, y'. */
static int pair_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    const vm_real c = REAL(0.01), mass = 1 + c * t, d = y[0] - y[2], pull = d * d * d;
    (void)ctx;
    dydt[0] = y[1];
    dydt[1] = (-pull - c * y[1]) / mass;
    dydt[2] = y[3];
    dydt[3] = (pull - c * y[3]) / mass;
    return 0;
}

/* Equations (68); the state is x, y, psi and their rates. */
static int rotor_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
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

/* The scene against the same equations written by hand, both with the same steps of rk4: where x |x|^(alpha-1) is not
   smooth, the steps that rk45 chooses depend on rounding. Number i by hand is number where[i] in the state of the
   scene. Then vm_scene_run goes to the same end, for the caller's comparison with reference values. */
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
    for (i = 0; i < 4; i++) {
        for (k = 0; k < 3; k++) {
            h.m0 = masses[i];
            h.rate = 0.01 * masses[i];
            h.alpha = 5. / 3;
            h.b = h.c = 0.01;
            figure27(&s, masses[i], displacements[k]);
            both(&s, "(440)", oscillator_rhs, &h, 2, line, 30);
        }
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

int main(void)
{
    check_effects();
    check_numbers();
    check_examples();
    return check_finish("scene effects");
}
