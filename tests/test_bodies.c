/* Momentum, angular momentum, kinetic energy, moments of inertia and balances (chapter 2). Bodies are made of
   particles, and each quantity must be the sum over the particles. Further oracles: numbers that can be summed in the
   head, and inertias that are combined and split again.

   usage: momenta [seed], which draws other bodies */
#include "particles.h"

static vm_vec3 vector_of(const double *a) { return vector(a[0], a[1], a[2]); }

/* |a - sum|, in eps of the size */
static void check_vector(const char *what, vm_vec3 a, const double *sum, double size, int index)
{
    check_error(what, "particles", "eps", size_of(vm_sub(a, vector_of(sum))) / size / eps, 25, index, 0);
}

/* Momenta and energy of one body, and the balance between two, against sums over their particles */
static void test_bodies(int unequal)
{
    int i;
    for (i = 0; i < 2000; i++) {
        sums sum = no_sums;
        vm_balance b;
        vm_vec3 about;
        double T;
        shot s;
        draw_shot(&s, unequal);
        about = vector_of(s.about);
        T = (double)vm_kinetic_energy(&s.whole);
        add_whole(&sum, 1, &s, &s.whole);
        check_vector("(1) K", vm_momentum(&s.whole), sum.K, sum.K_size, i);
        check_vector("(7) L", vm_angular_momentum(&s.whole, about), sum.L, sum.L_size, i);
        check_error("(93) T", "particles", "eps", fabs(T / sum.T - 1) / eps, 20, i, 0);

        add_piece(&sum, -1, &s, 0, &s.piece[0]); /* (4), (10), as if piece 0 had become the whole */
        if (vm_balance_between(1, s.piece, 1, &s.whole, NULL, about, &b)) {
            FAIL("balance");
            continue;
        }
        check_vector("(6) balance", b.momentum, sum.K, sum.K_size, i);
        check_vector("(12) balance", b.angular_momentum, sum.L, sum.L_size, i);
        check_error("energy", "particles", "eps", fabs((double)b.energy - sum.T) / eps / T, 280, i, 0);
        CHECK((double)b.momentum_scale < 1.01 * sum.K_size && b.angular_momentum_scale > 0);
    }
}

/* The balance and its scales, in numbers that can be summed in the head: a body of 2 kg with 10 N s, 4 m from the
   origin and 2 m from the point; an impulse of 2 N s, 1 m from the origin and 3 m from the point */
static void test_scales(void)
{
    vm_body b = {2, {1, 2, 3, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 4}, {3, 4, 0}, {0, 0, 2}};
    vm_impulse j = {{0, 2, 0}, {1, 0, 0}, {0, 0, -1}};
    vm_balance sum;
    CHECK(vm_balance_between(0, NULL, 1, &b, &j, vector(0, 0, 2), &sum) == VM_OK);
    CHECK(sum.momentum_scale == 12 && sum.angular_momentum_scale == 6 * 2 + (4 + 2) * 10 + 1 + (1 + 3) * 2);
    CHECK(sum.momentum.x == 6 && sum.momentum.y == 6 && sum.energy == 25 + 6);
    CHECK(sum.angular_momentum.x == -16 - 7 && sum.angular_momentum.y == 12 && sum.angular_momentum.z == 6);
    CHECK(vm_balance_between(1, &b, 0, NULL, NULL, vector(0, 0, 2), &sum) == VM_OK);
    CHECK(sum.momentum.x == -6 && sum.angular_momentum.y == -12 && sum.energy == -31);
    b.mass = is_float ? R(1e30) : R(1e200); /* momenta whose squares overflow, and underflow */
    CHECK(vm_balance_between(0, NULL, 1, &b, NULL, b.r, &sum) == VM_OK);
    CHECK(fabs((double)(sum.momentum_scale / b.mass) - 5) < 4 * eps);
    b.mass = 1 / b.mass;
    CHECK(vm_balance_between(0, NULL, 1, &b, NULL, b.r, &sum) == VM_OK);
    CHECK(fabs((double)(sum.momentum_scale / b.mass) - 5) < 4 * eps);
}

/* Momenta do not depend on the length of the quaternion. */
static void test_quaternion_length(void)
{
    double scale;
    vm_body a = random_body(2, 1), b;
    vm_vec3 L = vm_angular_momentum(&a, vector(0, 0, 0));
    for (scale = is_float ? 1e-36 : 1e-300; scale < (is_float ? 1e36 : 1e300); scale *= 1e6) {
        b = a;
        b.q.w *= R(scale);
        b.q.x *= R(scale);
        b.q.y *= R(scale);
        b.q.z *= R(scale);
        check_error("L", "length of q", "eps",
                    size_of(vm_sub(vm_angular_momentum(&b, vector(0, 0, 0)), L)) / size_of(L) / eps, 8, scale, 0);
    }
}

/* ---- Inertia ---- */

/* (13)-(15), (40): combining two inertias and splitting the sum undo each other. About the first mass centre the
   inertias add up (40). */
static void test_combined_inertia(void)
{
    int i;
    for (i = 0; i < 500; i++) {
        vm_body a = random_body(uniform(1, 4), 1), b = random_body(uniform(1, 4), 1);
        const vm_vec3 d = random_vector(2);
        const vm_real M = a.mass + b.mass, share = b.mass / M;
        vm_vec3 centre, back;
        vm_inertia whole, rest, about_a, own;
        double off;
        if (vm_combine_inertia(a.mass, &a.inertia, b.mass, &b.inertia, d, &whole, &centre)) {
            FAIL("combine");
            continue;
        }
        check_error("centre (15)", "", "eps", size_of(vm_sub(centre, vm_scale(share, d))) / eps, 4, i, 0);
        about_a = vmi_inertia_plus(a.inertia, 1, vm_parallel_axes(&b.inertia, b.mass, d));
        own = vm_parallel_axes(&about_a, -M, centre);
        off = fabs((double)(own.xx - whole.xx)) + fabs((double)(own.yz - whole.yz));
        check_error("combined (40)", "", "eps", off / eps / (double)vmi_inertia_trace(&about_a), 4, i, 0);
        if (vm_split_inertia(M, &whole, b.mass, &b.inertia, vm_sub(d, centre), &rest, &back)) {
            FAIL("split");
            continue;
        }
        off = fabs((double)(rest.xx - a.inertia.xx)) + fabs((double)(rest.xz - a.inertia.xz));
        check_error("split", "", "eps", off / eps / (double)vmi_inertia_trace(&whole), 5, i, 0);
        check_error("centre (15)", "split", "eps", size_of(vm_add(back, centre)) / eps, 12, i, 0);
    }
}

/* Which inertias a body can have: moments that form a triangle, up to some eps */
static void test_possible_inertia(void)
{
    const vm_inertia point = {0, 0, 0, 0, 0, 0}, needle = {0, 1, 1, 0, 0, 0}, plate = {1, 2, 3, 0, 0, 0};
    vm_inertia bent = plate;
    CHECK(vm_inertia_is_possible(&point) && vm_inertia_is_possible(&needle) && vm_inertia_is_possible(&plate));
    bent.zz = 3 + 24 * 4 * VM_EPSILON;
    CHECK(vm_inertia_is_possible(&bent));
    bent.zz = 3 + 24 * 16 * VM_EPSILON;
    CHECK(!vm_inertia_is_possible(&bent));
    bent = plate;
    bent.xz = R(0.1); /* takes a plate's moments 1 and 3 further apart than they can be */
    CHECK(!vm_inertia_is_possible(&bent));
    bent = needle;
    bent.xx = R(-1e-3);
    CHECK(!vm_inertia_is_possible(&bent));
}

/* Moments of a body, whose sum overflows only in the larger unit */
static void test_overflowing_trace(void)
{
    const vm_real good = is_float ? R(1e37) : R(5e306), bad = 10 * good;
    vm_inertia i = {0, 0, 0, 0, 0, 0};
    i.xx = R(1.2) * good;
    i.yy = R(1.5) * good;
    i.zz = R(1.7) * good;
    CHECK(vm_inertia_is_possible(&i));
    i.xx = R(1.2) * bad;
    i.yy = R(1.5) * bad;
    i.zz = R(1.7) * bad;
    CHECK(!vm_inertia_is_possible(&i));
}

int main(int argc, char **argv)
{
    draw_anew(argc, argv);
    test_bodies(0);
    test_bodies(1);
    test_scales();
    test_quaternion_length();
    test_combined_inertia();
    test_possible_inertia();
    test_overflowing_trace();
    return check_finish("bodies");
}
