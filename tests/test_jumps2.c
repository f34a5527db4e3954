/* Jumps in the plane (chapter 3). The oracle are the jumps of the same laminas in space, which test_jumps.c tests;
   then parts that go one by one, and points, about which nothing turns.

   usage: jumps2 [seed], which draws other bodies */
#include "jumps.h"

/* Momenta, energy and jumps of bodies in the plane are those of the laminas in space. */
static void test_laminas(void)
{
    int i;
    for (i = 0; i < 1000; i++) {
        vm_body2 a = random_body2(uniform(1, 5)), b = random_body2(uniform(0.5, 3)), whole, rest;
        const vm_body a_in_space = vm_body_from_body2(&a);
        vm_body b_in_space = vm_body_from_body2(&b), joined_in_space, rest_in_space;
        const vm_impulse2 impulse = random_impulse2(), *j = i % 2 ? &impulse : NULL;
        const vm_impulse blow = impulse_in_space(&impulse), *blow_or_null = i % 2 ? &blow : NULL;
        const double L = (double)vm_angular_momentum(&a_in_space, vmi_vec3(1, 2, 0)).z;
        const double T = (double)vm_kinetic_energy(&a_in_space);
        check_error("L2", "as in space", "eps", fabs((double)vm_angular_momentum2(&a, 1, 2) - L) / eps / 100, 2, i,
                    0);
        check_error("T2", "as in space", "eps", fabs((double)vm_kinetic_energy2(&a) / T - 1) / eps, 4, i, 0);
        CHECK(vm_attach(&a_in_space, &b_in_space, blow_or_null, &joined_in_space) == VM_OK);
        CHECK(vm_attach2(&a, &b, j, &whole) == VM_OK);
        check_error("attach2", "as in space", "eps", apart2(&whole, &joined_in_space), 12, i, 0);

        b.vx = R(uniform(-3, 3));
        b.vy = R(uniform(-3, 3));
        b.omega = R(uniform(-3, 3));
        b_in_space = vm_body_from_body2(&b);
        CHECK(vm_separate2(&whole, &b, j, &rest) == VM_OK && rest.angle == whole.angle);
        CHECK(vm_separate(&joined_in_space, &b_in_space, blow_or_null, &rest_in_space) == VM_OK);
        check_error("separate2", "as in space", "eps",
                    apart2(&rest, &rest_in_space) * (double)(rest.inertia / whole.inertia), 12, i, 0);
    }
}

/* Parts that join at once do what they do one by one. Parting at once undoes it, but for rounding errors of the
   whole's inertia. The bounds are some 3 times the worst of 15 seeds. */
static void test_burst2(void)
{
    int i;
    for (i = 0; i < 1000; i++) {
        vm_body2 body = random_body2(uniform(1, 5)), parts[2], whole, one;
        vm_body in_space;
        vm_impulse2 impulse = random_impulse2();
        const vm_impulse2 *j = i % 2 ? &impulse : NULL;
        parts[0] = random_body2(uniform(0.5, 3));
        parts[1] = random_body2(uniform(1, 5));
        CHECK(vm_attach_all2(&body, 2, parts, j, &whole) == VM_OK);
        CHECK(vm_attach2(&body, &parts[0], j, &one) == VM_OK && vm_attach2(&one, &parts[1], NULL, &one) == VM_OK);
        in_space = vm_body_from_body2(&one);
        check_error("attach_all2", "one by one", "eps", apart2(&whole, &in_space), 10, i, 0);
        impulse.jx = -impulse.jx;
        impulse.jy = -impulse.jy;
        impulse.couple = -impulse.couple;
        CHECK(vm_separate_all2(&whole, 2, parts, j, &one) == VM_OK);
        in_space = vm_body_from_body2(&body);
        check_error("separate_all2", "undoes it", "eps",
                    apart2(&one, &in_space) * (double)(one.inertia / whole.inertia), 15, i, 0);
    }
}

/* The part carries all of the inertia but 1e-3 to eps/10 of it: if it moves on as before, the rest keeps its spin. */
static void test_lost_inertia2(void)
{
    double own;
    for (own = 1e-3; own > eps / 10; own /= 3) {
        vm_body2 large = random_body2(5), small_one = large, both, left;
        small_one.mass = 2;
        small_one.inertia = R(own);
        CHECK(vm_attach2(&large, &small_one, NULL, &both) == VM_OK);
        large.omega = both.omega;
        large.vx = both.vx;
        large.vy = both.vy;
        CHECK(vm_separate2(&both, &large, NULL, &left) == VM_OK && left.omega == both.omega);
    }
}

/* A part leaves a point, which keeps the whole's spin. If the part is kicked, angular momentum is left that a point
   cannot have. */
static void test_point_left(void)
{
    const vm_body2 whole = {2, 2, 0, 0, 0, 1, 2, 3};
    vm_body2 part = {1, 0, 1, 0, 0, 1, 5, 0}, rest; /* moves on at v + Omega x SS2 */
    CHECK(vm_separate2(&whole, &part, NULL, &rest) == VM_OK);
    CHECK(rest.inertia == 0 && rest.omega == 3 && rest.x == -1 && rest.vx == 1 && rest.vy == -1);
    part.vy = 6;
    CHECK(vm_separate2(&whole, &part, NULL, &rest) == VM_NULL_AXIS && rest.omega == 3);
}

/* Two points, one of which leaves. Rounding errors of the inertia must not be taken for the other point's, which
   would then spin anyhow, nor for an inertia that no body has. */
static void test_two_points(void)
{
    int i, kept = 0;
    for (i = 0; i < 1000; i++) {
        vm_body2 a = random_body2(uniform(1, 5)), b = random_body2(uniform(0.5, 3)), whole, part, rest;
        a.inertia = b.inertia = 0;
        CHECK(vm_attach2(&a, &b, NULL, &whole) == VM_OK);
        CHECK(vm_to_relative2(&whole, &b, &part) == VM_OK);
        part.vx = part.vy = part.omega = 0;
        CHECK(vm_to_absolute2(&whole, &part, &part) == VM_OK);
        CHECK(vm_separate2(&whole, &part, NULL, &rest) == VM_OK && rest.inertia == 0);
        kept += rest.omega == whole.omega;
        part = whole;
        part.mass /= 2;
        part.inertia *= 1 + 8 * VM_EPSILON;
        CHECK(vm_separate2(&whole, &part, NULL, &rest) == VM_OK && rest.inertia == 0);
        part.inertia = whole.inertia * (1 + 128 * VM_EPSILON);
        CHECK(vm_separate2(&whole, &part, NULL, &rest) == VM_BAD_INERTIA);
    }
    CHECK(kept == 1000);
}

int main(int argc, char **argv)
{
    draw_anew(argc, argv);
    test_laminas();
    test_burst2();
    test_lost_inertia2();
    test_point_left();
    test_two_points();
    return check_finish("jumps2");
}
