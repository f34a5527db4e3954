/* Joints of scenes: short and long rods, heavy bodies beside light ones, thin bars, dead centres, drift. g is
   10 m/s^2, and 1 m/s^2 where a pendulum of 1 m swings for a time. */

typedef struct joined {
    vm_scene scene;
    vm_scene_body bodies[2];
    vm_effect effects[3];
    vm_joint list[2];
    vm_joints joints;
    vm_real room[VM_JOINTS_WORK(2)], t, y[13], dydt[13], work[VM_SCENE_WORK(13)];
} joined;

static const vm_vec3 joint_origin = {0, 0, 0};

/* Adds the joints as the last effect and starts the scene */
static int joined_start(joined *j, int n_bodies, int n_effects, int n_joints, vm_real rate)
{
    j->joints.joints = j->list;
    j->joints.n_joints = n_joints;
    j->joints.rate = rate;
    j->joints.work = j->room;
    j->scene.bodies = j->bodies;
    j->scene.n_bodies = n_bodies;
    j->scene.effects = j->effects;
    j->scene.n_effects = n_effects + 1;
    j->effects[n_effects] = vm_effect_joints(&j->joints);
    return vm_scene_start(&j->scene, 0, j->y, NULL);
}

/* The same, and evaluates forces and accelerations at the start */
static int joined_now(joined *j, int n_bodies, int n_effects, int n_joints)
{
    const int status = joined_start(j, n_bodies, n_effects, n_joints, 1);
    if (status < 0) return status;
    vm_scene_rhs(0, j->y, j->dydt, &j->scene);
    return j->scene.status;
}

/* Pull of a rod of the length x1 that turns a point of x0 kg at the speed x2. Naive: the multiplier of d^2 = l^2 */
static vm_real rod_pull_at(vm_real mass, vm_real pivot, vm_real place, vm_real speed)
{
    joined j;
    memset(&j, 0, sizeof j);
    j.bodies[0] = vm_scene_body_point(mass, vmi_vec3(place, 0, 0), vmi_vec3(0, speed, 0));
    j.list[0] = vm_joint_rod(0, joint_origin, VM_GROUND, vmi_vec3(pivot, 0, 0), place - pivot);
    return joined_now(&j, 1, 0, 1) == VM_OK ? -j.list[0].force.x : VM_NAN;
}
static vm_real rod_pull_ours(const vm_real *x) { return rod_pull_at(x[0], 0, x[1], x[2]); }
static vm_real rod_pull_naive(const vm_real *x)
{
    const vm_real square = x[1] * x[1], multiplier = x[2] * x[2] / (square / x[0]);
    return multiplier * x[1];
}

/* Pull of a rod between x0 and x1 that turns 1 kg at x1 at the speed x2. Naive: the square of the distance from the
   squares of the positions */
static vm_real far_rod_ours(const vm_real *x) { return rod_pull_at(1, x[0], x[1], x[2]); }
static vm_real far_rod_naive(const vm_real *x)
{
    return x[2] * x[2] / SQRT(x[0] * x[0] - 2 * (x[0] * x[1]) + x[1] * x[1]);
}

/* A point of x1 kg hangs by a rod from a point of x0 kg, which hangs by a rod from the ground: pull of the upper or
   of the lower rod. Naive: Cramer's rule, and the pull of the lower rod as the rest of the upper one's. */
static vm_real hanging(const vm_real *x, int rod)
{
    joined j;
    memset(&j, 0, sizeof j);
    j.bodies[0] = vm_scene_body_point(x[0], vmi_vec3(0, -1, 0), joint_origin);
    j.bodies[1] = vm_scene_body_point(x[1], vmi_vec3(0, -2, 0), joint_origin);
    j.effects[0] = vm_effect_gravity(0, 1, -10);
    j.effects[1] = vm_effect_gravity(1, 1, -10);
    j.list[0] = vm_joint_rod(0, joint_origin, VM_GROUND, joint_origin, 1);
    j.list[1] = vm_joint_rod(1, joint_origin, 0, joint_origin, 1);
    return joined_now(&j, 2, 2, 2) == VM_OK ? j.list[rod].force.y : VM_NAN;
}
static vm_real upper_rod_ours(const vm_real *x) { return hanging(x, 0); }
static vm_real upper_rod_naive(const vm_real *x)
{
    const vm_real a = 1 / x[0], b = -1 / x[0], c = 1 / x[0] + 1 / x[1];
    return 10 * c / (a * c - b * b);
}
static vm_real lower_rod_ours(const vm_real *x) { return hanging(x, 1); }
static vm_real lower_rod_naive(const vm_real *x) { return 10 * (x[0] + x[1]) - 10 * x[0]; }

/* A point of x0 kg hangs in a plane between two rods, x1 below the line between their upper ends, which are 2 m apart:
   pull of a rod. Naive: Cramer's rule */
static vm_real flat_rods_ours(const vm_real *x)
{
    const vm_vec3 right = {1, 0, 0}, left = {-1, 0, 0}, place = {0, -x[1], 0};
    joined j;
    memset(&j, 0, sizeof j);
    j.bodies[0] = vm_scene_body_point(x[0], place, joint_origin);
    j.effects[0] = vm_effect_gravity(0, 1, -10);
    j.list[0] = vm_joint_rod(0, joint_origin, VM_GROUND, right, vm_norm(vm_sub(place, right)));
    j.list[1] = vm_joint_rod(0, joint_origin, VM_GROUND, left, vm_norm(vm_sub(place, left)));
    return joined_now(&j, 1, 1, 2) == VM_OK ? vm_norm(j.list[0].force) : VM_NAN;
}
static vm_real flat_rods_naive(const vm_real *x)
{
    const vm_real square = 1 + x[1] * x[1], s = x[1] / SQRT(square), coupling = (x[1] * x[1] - 1) / square / x[0];
    const vm_real a = 1 / x[0];
    return 10 * s * (a - coupling) / (a * a - coupling * coupling);
}

/* A bar of x0 kg and the length x1 leaves a level position about a ball joint at its end: reaction of the joint. It
   has no moment of inertia about its own axis. Naive: inverts each moment */
static vm_real thin_bar_ours(const vm_real *x)
{
    vm_body bar = {1, {0, 0, 0, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    joined j;
    memset(&j, 0, sizeof j);
    bar.mass = x[0];
    bar.inertia.yy = bar.inertia.zz = x[0] * x[1] * x[1] / 12;
    bar.r.x = x[1] / 2;
    j.bodies[0] = vm_scene_body_free(&bar);
    j.effects[0] = vm_effect_gravity(0, 1, -10);
    j.list[0] = vm_joint_pin(0, vmi_vec3(-x[1] / 2, 0, 0), VM_GROUND, joint_origin);
    return joined_now(&j, 1, 1, 1) == VM_OK ? j.list[0].force.y : VM_NAN;
}
static vm_real thin_bar_naive(const vm_real *x)
{
    const vm_real I = x[0] * x[1] * x[1] / 12, axial = 0;
    const vm_vec3 arm = {-x[1] / 2, 0, 0}, up = {0, 1, 0}, turn = vm_cross(arm, up);
    const vm_vec3 spin = vmi_vec3(turn.x / axial, turn.y / I, turn.z / I);
    const vm_real mobility = 1 / x[0] + vm_dot(turn, spin);
    return 10 / mobility;
}

/* Acceleration of a crank of 1 kg m^2 and the radius x1 at the angle x0 and the speed x3. A rod of the length x2
   joins it to a slider of 1 kg that the force x4 pushes. Naive: the angle from the slider's place by the law of
   cosines */
static vm_real slider_root(const vm_real *x)
{
    const vm_real c = x[1] * COS(x[0]);
    return SQRT((x[2] - x[1]) * (x[2] + x[1]) + c * c);
}
static vm_real dead_centre_ours(const vm_real *x)
{
    const vm_real root = slider_root(x), place = x[1] * COS(x[0]) + root;
    joined j;
    memset(&j, 0, sizeof j);
    j.bodies[0] = vm_scene_body_axle(1, x[0], x[3]);
    j.bodies[1] = vm_scene_body_line(1, place, -x[3] * x[1] * SIN(x[0]) * place / root);
    j.effects[0] = vm_effect_gravity(1, 0, x[4]);
    j.list[0] = vm_joint_rod(1, joint_origin, 0, vmi_vec3(x[1], 0, 0), x[2]);
    return joined_now(&j, 2, 1, 1) == VM_OK ? j.dydt[1] : VM_NAN;
}
static vm_real dead_centre_naive(const vm_real *x)
{
    const vm_real r = x[1], place = r * COS(x[0]) + slider_root(x);
    const vm_real c = (place * place + r * r - x[2] * x[2]) / (2 * place * r), s = SQRT(1 - c * c);
    const vm_real root = SQRT(x[2] * x[2] - r * r * s * s), part = r * r * s * c / root, slope = -r * s - part;
    const vm_real bend = -r * c - r * r * (c * c - s * s) / root - part * part / root;
    return slope * (x[4] - bend * x[3] * x[3]) / (1 + slope * slope);
}

/* A point swings from rest at the angle x1, on a rod of 1 m under g = 1: where it is at t = x0. Naive: the multiplier
   alone, by rk4 */
static int rod_swings(const vm_real *x, joined *j)
{
    rk45_options o;
    memset(j, 0, sizeof *j);
    memset(&o, 0, sizeof o);
    o.rtol = R(VM_C(1e-13), VM_C(1e-6));
    o.atol = R(VM_C(1e-14), VM_C(1e-6));
    o.max_steps = 1000000;
    j->bodies[0] = vm_scene_body_point(1, vmi_vec3(SIN(x[1]), -COS(x[1]), 0), joint_origin);
    j->effects[0] = vm_effect_gravity(0, 1, -1);
    j->list[0] = vm_joint_rod(0, joint_origin, VM_GROUND, joint_origin, 1);
    if (joined_start(j, 1, 1, 1, 10) < 0) return VM_BAD_ARGUMENT;
    return vm_scene_run(&j->scene, &j->t, x[0], j->y, j->work, &o);
}
static void bare_multiplier(vm_real t, const vm_real *y, vm_real *dydt, const vm_real *x)
{
    const vm_real pull = (y[2] * y[2] + y[3] * y[3] - y[1]) / (y[0] * y[0] + y[1] * y[1]);
    (void)t, (void)x;
    dydt[0] = y[2], dydt[1] = y[3], dydt[2] = -pull * y[0], dydt[3] = -pull * y[1] - 1;
}
static vm_real rod_swing_ours(const vm_real *x)
{
    joined j;
    return rod_swings(x, &j) == VM_OK ? j.y[0] : VM_NAN;
}
static vm_real rod_swing_naive(const vm_real *x)
{
    vm_real y[4] = {SIN(x[1]), -COS(x[1]), 0, 0};
    naive_rk4(bare_multiplier, x, 4, y, x[0], (long)(x[0] * 16));
    return y[0];
}
static vm_real rod_length_ours(const vm_real *x)
{
    joined j;
    return rod_swings(x, &j) == VM_OK ? vm_norm(vmi_vec3(j.y[0], j.y[1], j.y[2])) : VM_NAN;
}
static vm_real rod_length_naive(const vm_real *x)
{
    vm_real y[4] = {SIN(x[1]), -COS(x[1]), 0, 0};
    naive_rk4(bare_multiplier, x, 4, y, x[0], (long)(x[0] * 16));
    return SQRT(y[0] * y[0] + y[1] * y[1]);
}

/* The same; naive: the rod as a spring of the stiffness x2, by rk4 */
static vm_real spring_rod_ours(const vm_real *x) { return rod_swing_ours(x); }
static void spring_for_rod(vm_real t, const vm_real *y, vm_real *dydt, const vm_real *x)
{
    const vm_real pull = x[2] * (1 - 1 / SQRT(y[0] * y[0] + y[1] * y[1]));
    (void)t;
    dydt[0] = y[2], dydt[1] = y[3], dydt[2] = -pull * y[0], dydt[3] = -pull * y[1] - 1;
}
static vm_real spring_rod_naive(const vm_real *x)
{
    vm_real y[4] = {SIN(x[1]), -COS(x[1]), 0, 0};
    naive_rk4(spring_for_rod, x, 4, y, x[0], (long)(x[0] * 64));
    return y[0];
}

static const hard_case joints_cases[] = {
    CASE(rod_pull, 4, "pull of a rod so short that the square of its length underflows", 3, R(1e-200, 1e-25),
         R(1e-100, 1e-12)),
    CASE(rod_pull, 4, "pull of a rod so long that the square of its length overflows", 3, R(1e200, 1e25),
         R(1e100, 1e12)),
    CASE(rod_pull, 4, "pull of a short rod on a light point: the square of the length underflows", R(1e-150, 1e-15),
         R(1e-170, 1e-24), R(1e-5, 0.001)),
    CASE(far_rod, 4, "pull of a rod far from the origin, its length from the squares of its ends: they cancel",
         R(100000000.1, 10000.1), R(100000000.6, 10000.6), 3),
    CASE(far_rod, 4, "pull of a rod of about 1e-6 m far from the origin: the squares of its ends cancel",
         R(1000000.1, 100.1), R(1000000.100001, 100.1001), 0.25),
    CASE(far_rod, 4, "pull of a rod by the squares of the positions of its ends: the squares overflow", R(1e200, 1e25),
         R(1.5e200, 1.5e25), R(1e100, 1e12)),
    CASE(upper_rod, 8, "pull of the upper of two rods with bodies of 1e-200 kg: the determinant overflows",
         R(2e-200, 2e-25), R(1e-200, 1e-25)),
    CASE(upper_rod, 8, "pull of the upper of two rods with bodies of 1e200 kg: the determinant underflows",
         R(2e200, 2e25), R(1e200, 1e25)),
    CASE(upper_rod, 4,
         "pull of the upper rod, if a heavy body hangs below a body of 1 kg: the determinant loses digits", 1,
         R(1e9, 1e4)),
    CASE(flat_rods, 4, "pull of each of two rods nearly in line, a point between them: the determinant loses digits", 2,
         R(1e-4, 1e-2)),
    CASE(flat_rods, 4, "the same pull, if the point is closer to the line: the determinant loses more digits", 2,
         R(1e-5, 0.003)),
    CASE(lower_rod, 8,
         "pull of the lower rod on a light body, as both weights minus that of the heavy body above: they cancel",
         R(1e12, 1e5), 0.01),
    CASE(lower_rod, 8, "pull of the lower rod on a body 1e30 times lighter than the body above: no digit is left",
         R(1e15, 1e12), R(1e-15, 1e-12)),
    CASE(thin_bar, 8, "reaction of a ball joint on a bar without inertia about its own axis: the formula divides by 0",
         3, 0.75),
    CASE(thin_bar, 8, "the same reaction for a bar 1 mm long and of 1 mg: the formula divides by 0", 1e-6, 0.001),
    CASE(dead_centre, 8,
         "acceleration of a crank next to its outer dead centre, its angle from the sides: the cosine rounds to 1",
         R(1e-9, 1e-5), 1, 3, 2, 5),
    CASE(dead_centre, 8,
         "acceleration of a crank with a short rod next to its outer dead centre: the cosine rounds to 1",
         R(1e-8, 1e-4), 1, 1.0625, 2, 5),
    CASE(dead_centre, 8, "acceleration of a crank next to its inner dead centre: the cosine of its angle rounds to -1",
         R(3.14159265, 3.1416), 1, 3, 2, 5),
    CASE(rod_swing, R(2e4, 100),
         "position of a pendulum by Lagrange's multiplier without correction: the length of its rod drifts", R(200, 20),
         2),
    CASE(rod_swing, R(3e5, 1200),
         "position of a pendulum that starts nearly upright, by this method: the length of its rod drifts", R(60, 15),
         3),
    CASE(rod_length, 32,
         "length of a pendulum's rod after 200 s, by Lagrange's multiplier without correction: it drifts", R(200, 20),
         2),
    CASE(rod_length, 32,
         "length of a pendulum's rod after 600 s, by Lagrange's multiplier without correction: it drifts", R(600, 200),
         2.5),
    CASE(spring_rod, R(5e3, 500),
         "position of a pendulum whose rod is replaced by a stiff spring: the steps are too long", 10, 2, 1e6),
    CASE(spring_rod, R(5e3, 500), "position of a pendulum whose rod is replaced by a soft spring: the spring stretches",
         10, 2, 1000),
};
