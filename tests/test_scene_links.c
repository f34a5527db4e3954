/* varmass.h, scenes: links and cords. Pendulums on a support that is accelerated, a ball on a cord that slackens and
   becomes taut, and links out of the plane, against closed forms and the balances of momentum and energy. */
#include "stage_check.h"

/* ---- Pendulums ---- */

/* A support that moves to the right with 2 m/s and is accelerated upwards by *ctx */
static void hoist(vm_real t, vm_vec3 *r, vm_vec3 *v, vm_vec3 *a, void *ctx)
{
    const double up = *(const double *)ctx, time = (double)t;
    *r = stage_vec(2 * time, up * time * time / 2, 0);
    *v = stage_vec(2, up * time, 0);
    *a = stage_vec(0, up, 0);
}

/* Zero when the body is straight below the support */
static vm_real below_hoist(vm_real t, const vm_real *y, void *ctx)
{
    (void)ctx;
    return y[0] - 2 * t;
}

/* A quarter of the period of a pendulum whose support has the acceleration a is K(sin^2(theta0/2)) sqrt(l/(g + a)).
   */
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

/* ---- A cord ---- */

static vm_real cord_length(const vm_real *y) { return VM_SQRT(y[0] * y[0] + y[1] * y[1]); }

/* Keeps the largest length of the cord in *ctx. */
static int longest(vm_real t, const vm_real *y, vm_scene *scene, void *ctx)
{
    vm_real *most = (vm_real *)ctx;
    (void)t;
    (void)scene;
    if (cord_length(y) > *most) *most = cord_length(y);
    return 0;
}

/* A support that rests in the origin */
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

/* ---- Links out of the plane ---- */

static void above(vm_real t, vm_vec3 *r, vm_vec3 *v, vm_vec3 *a, void *ctx)
{
    const vm_vec3 here = {0, 0, REAL(3)}, none = {0, 0, 0};
    (void)t;
    (void)ctx;
    *r = here;
    *v = *a = none;
}

/* A body in the plane on a link of 5 m to a point 3 m above the plane moves on a circle of 4 m. A body straight below
   the point cannot move along the link: the run ends at once. */
static void check_link_to_point_above(void)
{
    const vm_vec3 zero = {0, 0, 0};
    vm_real dydt[STAGE_STATE];
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
}

/* A body in the plane on a link to a free point in space, which takes the reaction: the length and the momentum along
   the plane stay. */
static void check_link_to_body_above(void)
{
    const vm_vec3 zero = {0, 0, 0};
    vm_real dx, dy, dz;
    stage s;
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
    CHECK(VM_FABS(dz - 3) > REAL(0.1)); /* the link has moved the point across the plane */
    agrees("link in space", "momentum", 2 * s.y[3] + s.y[9], 0, 4, 1e-10);
    agrees("link in space", "momentum", 2 * s.y[4] + s.y[10], 4, 4, 1e-10);
}

int main(void)
{
    check_pendulum(2, 0, 0);
    check_pendulum(3, 2, 1);
    check_cord(is_float ? 100 : 1000, 1.1); /* a faster one is too stiff for float */
    check_link_to_point_above();
    check_link_to_body_above();
    return check_finish("scene links");
}
