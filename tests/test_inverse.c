/* Inverse questions (3.3): how must a part leave so that the rest moves as asked for? The oracle is the separation:
   the part that leaves as the answer says leaves the rest with that motion.

   usage: inverse [seed], which draws other bodies */
#include "jumps.h"

/* The error of the spin that is left, in eps of the part's spin */
static void check_spin_left(const vm_body *rest, vm_vec3 wanted, const vm_body *moving, int index, int question)
{
    check_error("separate_for: w", "space", "eps",
                size_of(vm_sub(rest->omega, wanted)) / eps / (1 + size_of(moving->omega)), 20, index, question);
}

/* In space: velocity and spin of the rest are asked for, or one of them, or nothing. Some are asked to rest, some to
   turn as before. */
static void test_inverse(void)
{
    int i;
    for (i = 0; i < 1000; i++) {
        vm_body a = random_body(4, 1), b = random_body(1.5, 0.5), whole, rest, moving;
        const vm_impulse impulse = random_impulse(), *j = i % 2 ? &impulse : NULL;
        vm_vec3 v = random_vector(3), omega = random_vector(3);
        b.r = vm_add(a.r, random_vector(1));
        CHECK(vm_attach(&a, &b, NULL, &whole) == VM_OK);
        if (i % 3 == 0) v = omega = vector(0, 0, 0);
        if (i % 3 == 1) omega = whole.omega;
        CHECK(vm_separation_for_rest(&whole, &b, j, &v, &omega, &moving) == VM_OK);
        CHECK(vm_separate(&whole, &moving, j, &rest) == VM_OK);
        check_error("separate_for: v", "space", "eps", size_of(vm_sub(rest.v, v)) / eps, 30, i, 0);
        check_spin_left(&rest, omega, &moving, i, 0);
        CHECK(vm_separation_for_rest(&whole, &b, j, NULL, &omega, &moving) == VM_OK);
        CHECK(size_of(vm_sub(moving.v, b.v)) == 0);
        CHECK(vm_separate(&whole, &moving, j, &rest) == VM_OK);
        check_spin_left(&rest, omega, &moving, i, 1);
        CHECK(vm_separation_for_rest(&whole, &b, j, &v, NULL, &moving) == VM_OK);
        CHECK(size_of(vm_sub(moving.omega, b.omega)) == 0);
        CHECK(vm_separation_for_rest(&whole, &b, j, NULL, NULL, &moving) == VM_OK && apart(&moving, &b) == 0);
    }
}

/* A point cannot be given the spin that would stop the rest. If the rest need not stop, the point needs no spin. */
static void test_inverse_of_point(void)
{
    vm_body whole = random_body(4, 1), point = rod(1, vector(1, 0, 0)), moving;
    const vm_vec3 still = vector(0, 0, 0);
    point.r = vm_add(whole.r, vector(0.01, 0, 0));
    point.v = whole.v;
    CHECK(vm_separation_for_rest(&whole, &point, NULL, NULL, &still, &moving) == VM_NULL_AXIS);
    point.v = vm_add(whole.v, vm_cross(whole.omega, vm_sub(point.r, whole.r)));
    CHECK(vm_separation_for_rest(&whole, &point, NULL, NULL, &whole.omega, &moving) == VM_OK);
}

/* ---- In the plane ---- */

/* A part that has to be fast brings the rounding errors of its momentum into the rest's: the errors are counted in
   eps of the part's motion. The bounds are some 3 times the worst of 15 seeds. */
static void test_inverse2(void)
{
    int i;
    for (i = 0; i < 1000; i++) {
        vm_body2 a = random_body2(uniform(1, 5)), b = random_body2(uniform(0.5, 3)), whole, rest, moving;
        const vm_impulse2 impulse = random_impulse2(), *j = i % 2 ? &impulse : NULL;
        vm_real v[2], omega = R(uniform(-2, 2));
        double fast;
        v[0] = R(uniform(-2, 2));
        v[1] = R(uniform(-2, 2));
        CHECK(vm_attach2(&a, &b, j, &whole) == VM_OK);
        CHECK(vm_separation_for_rest2(&whole, &b, j, v, &omega, &moving) == VM_OK);
        CHECK(vm_separate2(&whole, &moving, j, &rest) == VM_OK);
        check_error("separate_for2: v", "plane", "eps",
                    hypot((double)(rest.vx - v[0]), (double)(rest.vy - v[1])) / eps, 30, i, 0);
        check_error("separate_for2: w", "plane", "eps",
                    fabs((double)(rest.omega - omega)) / eps / (1 + fabs((double)moving.omega)), 60, i, 0);
        CHECK(vm_separation_for_spin2(&whole, &b, j, omega, &moving) == VM_OK && moving.omega == b.omega);
        CHECK(vm_separate2(&whole, &moving, j, &rest) == VM_OK);
        fast = 1 + hypot((double)moving.vx, (double)moving.vy);
        check_error("..for_spin2: w", "plane", "eps", fabs((double)(rest.omega - omega)) / eps / fast, 200, i, 0);
        CHECK(vm_to_relative2(&whole, &moving, &b) == VM_OK);
        check_error("..for_spin2", "orthogonal", "eps",
                    fabs((double)(b.vx * (b.x - whole.x) + b.vy * (b.y - whole.y))) / eps / fast, 8, i, 0);
    }
}

/* A point at the mass centre has no arm to change the spin by, and no inertia to take spin along. */
static void test_central_point(void)
{
    const vm_body2 whole = {2, 2, 0, 0, 0, 1, 2, 3}, part = {1, 0, 0, 0, 0, 1, 6, 0};
    vm_body2 moving;
    CHECK(vm_separation_for_spin2(&whole, &part, NULL, 0, &moving) == VM_SINGULAR);
    CHECK(vm_separation_for_rest2(&whole, &part, NULL, NULL, &part.omega, &moving) == VM_NULL_AXIS);
}

/* Masses whose product overflows */
static void test_heavy_bodies2(void)
{
    const vm_real mass = is_float ? R(1e20) : R(1e160), omega = R(1.25);
    vm_body2 whole = {1, 1, 0, 0, 0, 1, 2, 3}, part = {1, 1, R(0.5), R(0.25), 0, 1, 2, 3}, rest = whole, moving = part;
    double fast;
    whole.mass = whole.inertia = mass;
    part.mass = mass / 10;
    part.inertia = mass / 100;
    CHECK(vm_separation_for_spin2(&whole, &part, NULL, omega, &moving) == VM_OK);
    CHECK(vm_separate2(&whole, &moving, NULL, &rest) == VM_OK);
    fast = 1 + hypot((double)moving.vx, (double)moving.vy);
    check_error("..for_spin2: w", "heavy", "eps", fabs((double)(rest.omega - omega)) / eps / fast, 200, 0, 0);
}

/* A body and a point on it, beside its mass centre, that moves on with it */
static void draw_point_on(vm_body2 *whole, vm_body2 *point, double mass, double x, double y)
{
    *point = *whole;
    point->mass = R(mass);
    point->inertia = 0;
    point->x += R(x);
    point->y += R(y);
    point->vx -= whole->omega * (point->y - whole->y);
    point->vy += whole->omega * (point->x - whole->x);
}

/* The spin that a small point leaves can be had again by the point's motion. That holds also where it differs from
   the whole's spin by less than the rounding of the wanted spin, and by more than the point's moment of momentum. */
static void test_small_point(void)
{
    int i;
    for (i = 0; i < 1000; i++) {
        vm_body2 whole = random_body2(uniform(2, 5)), point, rest = {0, 0, 0, 0, 0, 0, 0, 0}, moving;
        vm_real v[2], omega;
        double mass, x, y, fast;
        whole.inertia = R(uniform(1, 3));
        whole.omega = R(uniform(5, 50));
        mass = pow(10, uniform(-6, -1));
        x = uniform(0.2, 0.5);
        y = uniform(0.2, 0.5);
        draw_point_on(&whole, &point, mass, x, y);
        if (i % 2) {
            point.vx += R(uniform(-10, 10));
            point.vy += R(uniform(-10, 10));
        }
        CHECK(vm_separate2(&whole, &point, NULL, &rest) == VM_OK);
        v[0] = rest.vx;
        v[1] = rest.vy;
        omega = rest.omega;
        CHECK(vm_separation_for_rest2(&whole, &point, NULL, NULL, &omega, &moving) == VM_OK);
        CHECK(vm_separation_for_rest2(&whole, &point, NULL, v, &omega, &moving) == VM_OK);
        fast = 1 + hypot((double)point.vx, (double)point.vy) + hypot((double)v[0], (double)v[1]) / (double)point.mass;
        check_error("separate_for2: v", "a point", "eps",
                    hypot((double)(moving.vx - point.vx), (double)(moving.vy - point.vy)) / eps / fast, 10, i, 0);
    }
}

/* A point that leaves as it moved leaves the whole's spin, and no other. */
static void test_point_leaves(void)
{
    int i;
    for (i = 0; i < 1000; i++) {
        vm_body2 whole = random_body2(3), point, moving;
        const double x = uniform(-.1, .1), y = uniform(-.1, .1);
        vm_real omega = whole.omega;
        draw_point_on(&whole, &point, 1, x, y);
        CHECK(vm_separation_for_rest2(&whole, &point, NULL, NULL, &omega, &moving) == VM_OK);
        omega += R(1e-3);
        CHECK(vm_separation_for_rest2(&whole, &point, NULL, NULL, &omega, &moving) == VM_NULL_AXIS);
    }
}

/* An input may be the output. */
static void test_outputs_as_inputs(void)
{
    vm_body part, whole = whole_and_part(&part), x = whole, y = part, moving;
    CHECK(vm_separation_for_rest(&whole, &part, NULL, &part.v, &part.omega, &moving) >= 0);
    CHECK(vm_separation_for_rest(&x, &part, NULL, &part.v, &part.omega, &x) >= 0 && memcmp(&x, &moving, sizeof x) == 0);
    CHECK(vm_separation_for_rest(&whole, &y, NULL, &y.v, &y.omega, &y) >= 0 && memcmp(&y, &moving, sizeof y) == 0);
}

int main(int argc, char **argv)
{
    draw_anew(argc, argv);
    test_inverse();
    test_inverse_of_point();
    test_inverse2();
    test_heavy_bodies2();
    test_central_point();
    test_small_point();
    test_point_leaves();
    test_outputs_as_inputs();
    return check_finish("inverse");
}
