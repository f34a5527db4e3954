/* varmass.h, scenes: bodies and motions. How many numbers of the state a body takes, bodies that are not there, the
   quaternion of a free body, and a chain of a thousand bodies, against closed forms and conservation laws. */
#include "stage_check.h"

/* ---- The state ---- */

/* A body on a line or an axle has two numbers in the state, in the plane or as a point six, and a free one 13; a mass
   that is a state is one more. */
static void check_sizes(void)
{
    const vm_vec3 zero = {0, 0, 0};
    const vm_inertia inertia = {1, 1, 1, 0, 0, 0};
    vm_scene_body bodies[7];
    vm_body free_body;
    vm_scene scene;
    int i;
    memset(&free_body, 0, sizeof free_body);
    memset(&scene, 0, sizeof scene);
    free_body.mass = 1;
    free_body.inertia = inertia;
    for (i = 0; i < 7; i++) bodies[i] = vm_scene_body_line(1, 0, 0);
    scene.bodies = bodies;
    scene.n_bodies = 7;
    CHECK(vm_scene_size(&scene) == 7 * 2);
    bodies[0] = vm_scene_body_with_mass_state(bodies[0]);
    CHECK(vm_scene_size(&scene) == 7 * 2 + 1);
    bodies[1] = vm_scene_body_axle(1, 0, 0);
    CHECK(vm_scene_size(&scene) == 7 * 2 + 1);
    bodies[2] = vm_scene_body_plane(1, 1, zero, 0, zero, 0);
    bodies[3] = vm_scene_body_point(1, zero, zero);
    CHECK(vm_scene_size(&scene) == 5 * 2 + 1 + 2 * 6);
    bodies[4] = vm_scene_body_free(&free_body);
    CHECK(vm_scene_size(&scene) == 4 * 2 + 1 + 2 * 6 + 13 && vm_scene_check(&scene, NULL) == VM_OK);
}

/* The length L of a free body's quaternion returns to 1 by L' = |omega| L (1 - L^2)/8, so that
   L^2 = 1/(1 + (1/L0^2 - 1) exp(-|omega| t/4)). The spin of a sphere stays as it is meanwhile. */
static void check_quaternion_length(void)
{
    const double start = 0.6 * 0.6 + 0.3 * 0.3 + 0.2 * 0.2 + 0.5 * 0.5, omega = sqrt(0.74);
    vm_body body;
    int i;
    memset(&body, 0, sizeof body);
    body.mass = 1;
    body.inertia.xx = body.inertia.yy = body.inertia.zz = 2;
    body.omega = stage_vec(0.3, -0.7, 0.4);
    for (i = 1; i <= 4; i++) {
        double length = 0;
        vm_body now;
        stage s;
        int k;
        stage_clear(&s, 4);
        stage_body(&s, vm_scene_body_free(&body));
        begin(&s);
        s.y[3] = (vm_real)0.6;
        s.y[4] = (vm_real)0.3;
        s.y[5] = (vm_real)-0.2;
        s.y[6] = (vm_real)0.5;
        run(&s, 3 * i, VM_OK);
        for (k = 3; k < 7; k++) length += (double)(s.y[k] * s.y[k]);
        agrees("quaternion", "L^2", (vm_real)length, 1 / (1 + (1 / start - 1) * exp(-3. * i * omega / 4)), 1, 1e-9);
        vm_scene_body_at(&s.scene, 0, s.y, &now);
        agrees("quaternion", "|omega|", size_of(now.omega), omega, 1, 1e-9);
    }
}

/* A slow body takes as many steps for its turns as a fast one: the law of the quaternion's length has no time of its
   own. */
static void check_slow_rotation(void)
{
    double omega;
    for (omega = 1e-6; omega < 2e6; omega *= 1000) {
        rk45_options o = rk45_defaults(NULL);
        vm_body body;
        stage s;
        memset(&body, 0, sizeof body);
        body.mass = 1;
        body.inertia.xx = 1;
        body.inertia.yy = 2;
        body.inertia.zz = REAL(2.5);
        body.omega = stage_vec(omega, omega / 3, omega / 10);
        stage_clear(&s, 1);
        s.scene.budget = NULL;
        stage_body(&s, vm_scene_body_free(&body));
        begin(&s);
        o.max_steps = 1000; /* 16 turns */
        CHECK(vm_scene_run(&s.scene, &s.t, REAL(100 / omega), s.y, s.work, &o) == VM_OK);
    }
}

/* The length that the quaternion of a free body has at the start does not change the accuracy with which it turns. */
static void check_first_quaternion_length(void)
{
    const double length[3] = {1, 1e-9, is_float ? 1e30 : 1e100};
    const vm_vec3 at = {1, 2, 3};
    vm_vec3 wanted = {0, 0, 0}, r, v;
    int i;
    for (i = 0; i < 3; i++) {
        vm_body body = probe();
        stage s;
        body.inertia = inertia_of(1, 1, 1, 0, 0, 0); /* only the quaternion varies, and determines the steps */
        body.q.w *= REAL(length[i]);
        body.q.x *= REAL(length[i]);
        body.q.y *= REAL(length[i]);
        stage_clear(&s, 1);
        stage_body(&s, vm_scene_body_free(&body));
        begin(&s);
        run(&s, 10, VM_OK);
        vm_scene_point_at(&s.scene, 0, at, s.y, &r, &v);
        if (i == 0) wanted = r;
        agrees("first length", "point", size_of(vm_sub(r, wanted)), 0, 1, 1e-12);
    }
}

/* ---- Bodies that are not there ---- */

/* A spring to a body that is not there, the first of the scene, does not pull. */
static void check_absent_end(void)
{
    stage s;
    stage_clear(&s, 2);
    stage_body(&s, vm_scene_body_absent(vm_scene_body_line(7, 5, 9)));
    stage_body(&s, vm_scene_body_line(3, 0, 2));
    stage_effect(&s, vm_effect_spring(1, 0, 0, 0, 1, 1, 0));
    begin(&s);
    run(&s, 4, VM_OK);
    CHECK(s.y[3] == 2);
    agrees("absent", "x", s.y[2], 8, 8, 1e-14);
}

/* Effects do not act on a body that is not there yet, or no longer. A second run from the start has the same bits. */
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
    stage_event(&s, vm_then_switch(vm_event_at(REAL(0.25)), 1, 0)); /* on, but its other end is not there yet */
    for (again = 0; again < 2; again++) {
        begin(&s);
        run(&s, 0.5, VM_OK);
        CHECK(s.y[1] == 2 && s.y[2] == 5 && s.y[3] == 9); /* a body that is not there does not move */
        run(&s, 1, VM_OK);
        CHECK(s.y[1] == 2 && !s.bodies[1].away && s.y[3] == 2 && s.bodies[0].mass == 2 && s.bodies[1].mass == 1);
        run(&s, 3, VM_OK);
        CHECK(s.bodies[1].away && s.bodies[0].mass == 3);
        run(&s, 4, VM_OK);
        agrees("presence", "v", s.y[1], (3. * 2 + 2) / 3, 2, 1e-10); /* 1 N for 2 s */
        balanced(&s, "presence", 10, 10);
        for (k = 0; k < vm_scene_size(&s.scene); k++) {
            if (again) CHECK(s.y[k] == first[k]);
            else first[k] = s.y[k];
        }
    }
    s.bodies[1].absent = 0;
    begin(&s);
    run(&s, 4, VM_IS_THERE); /* the part is there already */
    CHECK(s.t == 1);
    s.bodies[0].absent = s.bodies[1].absent = 1;
    begin(&s);
    run(&s, 4, VM_IS_AWAY); /* the body from which it separates is not there */
    CHECK(s.t == 1);
}

/* ---- Many bodies ---- */

/* A thousand bodies between springs, the first of which gets a velocity: the wave travels, and the energy stays. */
static void check_chain(void)
{
    enum { N = 1000 };
    static vm_scene_body bodies[N];
    static vm_effect effects[N + 1];
    static vm_real y[2 * N], work[VM_SCENE_WORK(2 * N)];
    vm_scene scene;
    vm_real t = 0, energy = 0;
    int i;
    memset(&scene, 0, sizeof scene);
    for (i = 0; i < N; i++) bodies[i] = vm_scene_body_line(1, 0, i == 0);
    for (i = 0; i <= N; i++)
        effects[i] = vm_effect_spring(i < N ? i : N - 1, 0, i < N ? i - 1 : VM_GROUND, 0, 1, 1, 0);
    scene.bodies = bodies;
    scene.n_bodies = N;
    scene.effects = effects;
    scene.n_effects = N + 1;
    CHECK(vm_scene_start(&scene, 0, y, NULL) == VM_OK && vm_scene_size(&scene) == 2 * N);
    CHECK(vm_scene_run(&scene, &t, 20, y, work, NULL) == VM_OK);
    for (i = 0; i < N; i++) energy += y[2 * i + 1] * y[2 * i + 1] / 2;
    for (i = 0; i <= N; i++) {
        const vm_real d = (i < N ? y[2 * i] : 0) - (i ? y[2 * i - 2] : 0);
        energy += d * d / 2;
    }
    /* the default tolerance is 1e-6, in float 1e-4 */
    check_error("chain", "energy", "rel", fabs((double)energy - 0.5) / 0.5, is_float ? 1e-2 : 1e-4, 0, 0);
    CHECK(y[2 * 18] > (vm_real)0.3 && VM_FABS(y[2 * 28]) < (vm_real)1e-4); /* the front is at body 20 */
}

int main(void)
{
    check_sizes();
    check_quaternion_length();
    check_slow_rotation();
    check_first_quaternion_length();
    check_absent_end();
    check_presence();
    check_chain();
    return check_finish("scene bodies");
}
