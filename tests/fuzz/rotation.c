/* Fuzz target: varmass.h, torque-free rotation, attitudes and Euler's angles. Angular momentum and energy stay at any
   time, running back leads back, |q| stays, refusals change nothing. */
#include "bodies.h"

/* The length of an attitude stays. A length within 64 eps of 1 may become 1. */
static int keeps_length(vm_quat q, double length)
{
    const double now = norm4(q);
    return fabs(now - length) <= 16 * EPS * length || (fabs(length - 1) <= 65 * EPS && fabs(now - 1) <= 16 * EPS);
}

/* A body that is nearly a rod may later turn much faster about its axis than at the start; then the rounding errors of
   omega are larger, too. Returns the larger of the angular speeds at two times. */
static double larger_speed(const vm_body *a, const vm_body *b)
{
    return size3(a->omega) > size3(b->omega) ? size3(a->omega) : size3(b->omega);
}

/* A bound of the angular speed at all times */
static double fastest(const vm_torque_free *motion)
{
    return size3(vmi_vec3(motion->spin[0], motion->spin[1], motion->spin[2]));
}

static void check_free(void)
{
    const vm_vec3 origin = {0, 0, 0};
    vm_body body = draw_body(1), later, again;
    const vm_real t0 = MOSTLY(draw_in(-2, 2)), t = MOSTLY(draw_byte() & 1 ? draw_in(-5, 5) : draw_log(1, 1e5));
    vm_torque_free motion;
    vm_vec3 L, L2, omega;
    vm_quat q;
    double size, speed, trace;
    int status;
    STAIN(motion);
    STAIN(later);
    status = vm_torque_free_init(&motion, &body, t0);
    if (status) {
        HOLDS(status < 0 && UNTOUCHED(motion));
        HOLDS(!is_finite(t0) || (vm_torque_free_rotation(&body, t, &later) < 0 && UNTOUCHED(later)));
        return;
    }
    HOLDS(body.mass > 0 && vm_inertia_is_possible(&body.inertia) && finite_body(&body) && is_finite(t0));
    STAIN(q);
    STAIN(omega);
    status = vm_torque_free_at(&motion, t, &later);
    if (status) {
        HOLDS(status == VM_NOT_FINITE && UNTOUCHED(later) && vm_torque_free_attitude(&motion, t, &q, &omega) <= 0);
        return;
    }
    HOLDS(finite_body(&later) && is_finite(t));
    HOLDS(vm_torque_free_attitude(&motion, t, &q, &omega) == VM_OK);
    if (!tame_body(&body) || !tame(t) || !tame(t0)) return;
    size = norm4(body.q);
    size = size > 0 ? size : 1;
    HOLDS(keeps_length(later.q, size) && keeps_length(q, size));
    L = vm_angular_momentum(&body, body.r);
    L2 = vm_angular_momentum(&later, later.r);
    trace = trace_of(&body.inertia);
    speed = larger_speed(&body, &later);
    HOLDS(within3(L, L2, 64 * EPS * trace * speed));
    body.v = later.v = origin;
    HOLDS(fabs((double)vm_kinetic_energy(&body) - (double)vm_kinetic_energy(&later)) <= 64 * EPS * trace * speed * speed);
    speed = fastest(&motion);
    if (body.inertia.xy == 0 && VM_FABS(t - t0) * R(speed) < 10 &&
        vm_torque_free_rotation(&later, t0 - t, &again) == VM_OK)
        HOLDS(within3(vm_angular_momentum(&again, again.r), L, 128 * EPS * trace * speed));
}

static void check_principal(void)
{
    const double x = (double)draw_in(0, 1), y = (double)draw_in(0, 1);
    const double z = draw_byte() & 1 ? (double)draw_in(0, 1) : y;
    const vm_real t = MOSTLY(draw_in(-50, 50));
    vm_vec3 moments, omega = draw_vector(4), now;
    vm_quat q = draw_attitude(), q_now;
    vm_torque_free motion;
    double L = 0, L_now = 0, scale, size = norm4(q);
    moments.x = R(y * y + z * z);
    moments.y = R(z * z + x * x);
    moments.z = R(x * x + y * y);
    if (draw_byte() % 16 == 0) moments.x = draw_any();
    STAIN(motion);
    if (vm_torque_free_init_principal(&motion, moments, q, omega, 0)) {
        HOLDS(UNTOUCHED(motion));
        return;
    }
    STAIN(q_now);
    STAIN(now);
    if (vm_torque_free_attitude(&motion, t, &q_now, &now)) {
        HOLDS(UNTOUCHED(q_now) && UNTOUCHED(now));
        return;
    }
    size = size > 0 ? size : 1;
    if (!tame3(omega) || !tame3(moments) || !tame(t)) return;
    HOLDS(keeps_length(q_now, size));
    L = size3(vmi_vec3(moments.x * omega.x, moments.y * omega.y, moments.z * omega.z));
    L_now = size3(vmi_vec3(moments.x * now.x, moments.y * now.y, moments.z * now.z));
    scale = (double)(moments.x + moments.y + moments.z) * size3(omega);
    HOLDS(fabs(L - L_now) <= 32 * EPS * scale);
}

static void check_euler(void)
{
    const vm_real psi = MOSTLY(draw_in(-10, 10)), theta = MOSTLY(draw_in(-4, 4)), phi = MOSTLY(draw_in(-10, 10));
    const vm_quat q = vm_euler_313(psi, theta, phi);
    const vm_vec3 omega = draw_vector(4);
    const vm_real largest = R(0.1) / VM_EPSILON;
    vm_vec3 axis[3], body_axis[3];
    double z[3] = {0, 0, 1}, sum[3] = {0, 0, 0}, speeds = 0;
    vm_real rates[3];
    int i, status;
    vm_euler_313_axes(psi, theta, axis);
    vm_euler_313_body_axes(theta, phi, body_axis);
    STAIN(rates);
    status = vm_euler_313_rates(psi, theta, omega, rates);
    if (status) {
        HOLDS(UNTOUCHED(rates));
        return;
    }
    HOLDS(is_finite(psi) && is_finite(theta) && finite3(omega) && vmi_all_finite(3, rates));
    if (VM_FABS(psi) > largest || VM_FABS(theta) > largest) return;
    for (i = 0; i < 3; i++) HOLDS(fabs(size3(axis[i]) - 1) <= 8 * EPS);
    if (!is_finite(phi) || VM_FABS(phi) > largest) return;
    for (i = 0; i < 3; i++) HOLDS(fabs(size3(body_axis[i]) - 1) <= 8 * EPS);
    HOLDS(fabs(norm4(q) - 1) <= 8 * EPS);
    turn3(q, z, z); /* the third axis goes with the body */
    HOLDS(within(R(z[0]), axis[2].x, 8 * EPS) && within(R(z[1]), axis[2].y, 8 * EPS) &&
          within(R(z[2]), axis[2].z, 8 * EPS));
    if (!tame3(omega)) return;
    for (i = 0; i < 3; i++) {
        const double rate = (double)rates[i];
        sum[0] += rate * (double)axis[i].x;
        sum[1] += rate * (double)axis[i].y;
        sum[2] += rate * (double)axis[i].z;
        speeds += fabs(rate); /* without bound where sin(theta) is small: psi' and phi' cancel */
    }
    HOLDS(within(R(sum[0]), omega.x, 8 * EPS * speeds) && within(R(sum[1]), omega.y, 8 * EPS * speeds) &&
          within(R(sum[2]), omega.z, 8 * EPS * speeds));
}

/* Every form of an attitude is the same rotation */
static void check_attitude(void)
{
    const vm_vec3 a = draw_vector(4);
    vm_vec3 turned, p;
    vm_quat q = draw_attitude(), from_mrp, from_matrix;
    vm_real angles[3], c[9];
    double size = size3(a);
    if (draw_byte() % 8 == 0) q.x = q.y = 0;
    if (draw_byte() % 8 == 0) q.w = draw_any();
    STAIN(angles);
    STAIN(c);
    if (vm_euler_313_angles(q, angles)) {
        HOLDS(!is_finite(q.w) && UNTOUCHED(angles) && vm_euler_321_angles(q, angles) == VM_NOT_FINITE);
        HOLDS(UNTOUCHED(angles) && vm_quat_to_matrix(q, c) == VM_NOT_FINITE && UNTOUCHED(c));
        HOLDS(is_nan3(vm_rotate(q, a)) && is_nan3(vm_rotate_back(q, a)) && is_nan3(vm_quat_to_mrp(q)));
        return;
    }
    turned = vm_rotate(q, a);
    if (!tame3(a)) return;
    HOLDS(within3(vm_rotate_back(q, turned), a, 16 * EPS * size));
    HOLDS(within3(vm_rotate(vm_euler_313(angles[0], angles[1], angles[2]), a), turned, 32 * EPS * size));
    HOLDS(vm_euler_321_angles(q, angles) == VM_OK);
    HOLDS(within3(vm_rotate(vm_euler_321(angles[0], angles[1], angles[2]), a), turned, 32 * EPS * size));
    p = vm_quat_to_mrp(q);
    from_mrp = vm_quat_from_mrp(p);
    HOLDS(size3(p) <= 1 + 8 * EPS && within3(vm_rotate(from_mrp, a), turned, 32 * EPS * size));
    HOLDS(vm_quat_to_matrix(q, c) == VM_OK && vm_quat_from_matrix(c, &from_matrix) == VM_OK);
    HOLDS(within3(vm_rotate(from_matrix, a), turned, 32 * EPS * size));
    HOLDS(fabs(norm4(vm_quat_times(from_mrp, from_matrix)) - 1) <= 16 * EPS);
    HOLDS(size == 0 || fabs((double)vm_dot(vm_unit(a), a) - size) <= 8 * EPS * size);
    HOLDS(within(vm_norm(a), R(size), 8 * EPS * size) && fabs(norm4(vm_unit_quat(q)) - 1) <= 8 * EPS);
}

static void fuzz_rotation(void)
{
    switch (draw_below(4)) {
    case 0: check_principal(); break;
    case 1: check_euler(); break;
    default: check_free();
    }
    check_attitude(); /* after the others, whose stored inputs stay what they are */
}
FUZZ_TARGET(rotation)
