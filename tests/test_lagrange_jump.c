/* Chapter 4 of varmass.h: Lagrange's equations across a jump of the mass, (83)-(96).
   Oracles: the vector form by vm_separate and vm_attach, virtual work, derivatives of the kinetic energy by
   differences, and the angular momenta of a double pendulum about its pivot and its hinge. (86) as printed must miss.
   The example of the cut pendulum is in tests/test_pendulum.c. */
#include "rods.h"

/* ---- Virtual work (83)-(86) ---- */

/* The virtual work of the momenta of a body */
static double work_of(const vm_body *b, vm_vec3 dr, vm_vec3 turn)
{
    return (double)(vm_dot(vm_momentum(b), dr) + vm_dot(vmi_spin_momentum(b), turn));
}

/* As printed, (86) has the spin of the whole body with the wrong sign, so that 2 I_S Omega dphi is left over. */
static void test_virtual_work(void)
{
    int i;
    double least_left_over = 1e9;
    for (i = 0; i < 300; i++) {
        vm_body whole = random_body(4, 1), part = random_body(0.5, 0.1), rest;
        vm_impulse j = random_impulse();
        vm_vec3 dr = random_vector(1), turn = random_vector(1), dr1, dr2, moment;
        double left, right, printed, spin_work;
        part.r = vm_add(whole.r, random_vector(0.2));
        if (vm_separate(&whole, &part, &j, &rest) != VM_OK) continue;
        dr1 = vm_add(dr, vm_cross(turn, vm_sub(rest.r, whole.r))); /* (83) */
        dr2 = vm_add(dr, vm_cross(turn, vm_sub(part.r, whole.r)));
        moment = vm_add(j.couple, vm_cross(vm_sub(j.at, whole.r), j.linear));
        right = (double)(vm_dot(j.linear, dr) + vm_dot(moment, turn));
        left = work_of(&part, dr2, turn) + work_of(&rest, dr1, turn);
        printed = left - work_of(&whole, dr, vm_scale(-1, turn));
        left -= work_of(&whole, dr, turn);
        check_error("(86)", "virtual work", "eps", fabs(left - right) / eps / 100, 4, i, 0);
        spin_work = (double)vm_dot(vmi_spin_momentum(&whole), turn);
        least_left_over = fmin(least_left_over, fabs(printed - right) / fabs(spin_work));
    }
    ERRATUM("(86)", least_left_over > 1.9 && least_left_over < 2.1, check_holds("(86)"));
}

/* ---- Free bodies (87)-(96) ---- */

/* Six coordinates: the place of the point S, which is fixed in the body, and turns about the axes through S */
static void free_coordinates(vm_vec3 from_S, vm_vec3 *dr, vm_vec3 *turn)
{
    int i;
    for (i = 0; i < 3; i++) {
        dr[i] = vector(i == 0, i == 1, i == 2);
        turn[i] = vector(0, 0, 0);
        turn[i + 3] = dr[i];
        dr[i + 3] = vm_cross(turn[i + 3], from_S);
    }
}

/* The velocities of these coordinates, from and to those of the body */
static void free_rates(vm_vec3 v, vm_vec3 omega, vm_real *qdot)
{
    vmi_set3(qdot, v);
    vmi_set3(qdot + 3, omega);
}

/* A thin body turns an eps of angular momentum into several of omega: by this factor. */
static double thinness(const vm_body *b)
{
    const vmi_principal axes = vmi_principal_axes(&b->inertia);
    const double a = (double)axes.moment[0], m = (double)axes.moment[1], c = (double)axes.moment[2];
    return fmax(fmax(a, m), c) / fmin(fmin(a, m), c) * (1 + size_of(b->omega));
}

/* (96) gives the velocities that vm_separate or vm_attach gives. */
static void check_free_jump(int i, int attach)
{
    const char *region = attach ? "vm_attach" : "vm_separate";
    vm_body whole = random_body(uniform(1, 8), 1), part = random_body(uniform(0.1, 0.5), 0.2), rest;
    vm_impulse j = random_impulse();
    const vm_vec3 S = whole.r;
    vm_vec3 dr[6], turn[6], v, omega;
    vm_real before[36] = {0}, after[36] = {0}, p[6] = {0}, Q[6] = {0}, qdot[6], work[VM_LAGRANGE_WORK(6)];
    double factor;
    part.r = vm_add(S, random_vector(0.3));
    if ((attach ? vm_attach : vm_separate)(&whole, &part, &j, &rest) != VM_OK) return;
    free_coordinates(vector(0, 0, 0), dr, turn);
    vm_lagrange_mass(6, &whole, dr, turn, before);
    vm_lagrange_impulse(6, &j, S, dr, turn, Q);
    free_coordinates(vm_sub(part.r, S), dr, turn);
    vm_lagrange_momentum(6, &part, dr, turn, p);
    free_coordinates(vm_sub(rest.r, S), dr, turn);
    vm_lagrange_mass(6, &rest, dr, turn, after);
    free_rates(whole.v, whole.omega, qdot);
    CHECK((attach ? vm_lagrange_attach : vm_lagrange_separate)(6, before, after, qdot, p, Q, qdot, work) == VM_OK);
    omega = vmi_get3(qdot + 3);
    v = vm_add(vmi_get3(qdot), vm_cross(omega, vm_sub(rest.r, S)));
    factor = thinness(&rest);
    check_error("v_S1 (96)", region, "eps*", size_of(vm_sub(v, rest.v)) / eps / factor, 3, i, 0);
    check_error("Omega_1 (96)", region, "eps*", size_of(vm_sub(omega, rest.omega)) / eps / factor, 10, i, 0);
}

/* The kinetic energy of the rest and the part as a function of the body's velocities v and omega. The relative
   velocities (98)-(102) are held. */
static double energy_after(const vm_body *whole, const vm_body *rest, const vm_body *part, vm_vec3 v, vm_vec3 omega)
{
    const vm_vec3 dv = vm_sub(v, whole->v), domega = vm_sub(omega, whole->omega);
    vm_body a = *rest, b = *part;
    a.omega = vm_add(a.omega, domega);
    b.omega = vm_add(b.omega, domega);
    a.v = vm_add(a.v, vm_add(dv, vm_cross(domega, vm_sub(rest->r, whole->r))));
    b.v = vm_add(b.v, vm_add(dv, vm_cross(domega, vm_sub(part->r, whole->r))));
    return (double)(vm_kinetic_energy(&a) + vm_kinetic_energy(&b));
}

/* The rule d(T2 - T1)/dqdot = Q^I. The derivatives are central differences, which are exact for a quadratic. */
static void test_derivative_rule(void)
{
    int i, k, side;
    for (i = 0; i < 100; i++) {
        vm_body whole = random_body(4, 1), part = random_body(0.5, 0.1), rest, moved;
        vm_impulse j = random_impulse();
        vm_vec3 dr[6], turn[6];
        vm_real Q[6] = {0};
        part.r = vm_add(whole.r, random_vector(0.2));
        if (vm_separate(&whole, &part, &j, &rest) != VM_OK) continue;
        free_coordinates(vector(0, 0, 0), dr, turn);
        vm_lagrange_impulse(6, &j, whole.r, dr, turn, Q);
        for (k = 0; k < 6; k++) {
            const double scale = 200 * (1 + size_of(rest.omega) * size_of(rest.omega));
            double slope = 0;
            for (side = -1; side < 2; side += 2) {
                vm_real qdot[6];
                double change;
                free_rates(whole.v, whole.omega, qdot);
                qdot[k] += R(side);
                moved = whole;
                moved.v = vmi_get3(qdot);
                moved.omega = vmi_get3(qdot + 3);
                change = energy_after(&whole, &rest, &part, moved.v, moved.omega) -
                         (double)vm_kinetic_energy(&moved);
                slope += side * change / 2;
            }
            check_case("(92)-(96)", "derivatives", Q[k], slope, scale, 0.2);
        }
    }
}

/* ---- A constrained body: a double pendulum whose lower rod loses its outer part ---- */

typedef struct double_pendulum {
    double L1, L2, M1, M2, l, m;        /* lengths and masses of the rods and of the part */
    vm_vec3 hinge;                      /* the pivot is the origin */
    vm_body upper, lower, rest, part;
    vm_vec3 dr_upper[2], dr_lower[2], dr_rest[2], dr_part[2];
    vm_vec3 turn_upper[2], turn_lower[2]; /* turn_lower is that of the rest and the part too */
} double_pendulum;

static void random_double_pendulum(double_pendulum *p)
{
    const vm_vec3 O = vector(0, 0, 0), z = vector(0, 0, 1);
    double a1, a2;
    vm_vec3 e1, e2, f1, f2;
    p->L1 = uniform(0.5, 2);
    p->L2 = uniform(0.5, 2);
    p->M1 = uniform(1, 3);
    p->M2 = uniform(1, 3);
    p->l = p->L2 * uniform(0.02, 0.8);
    p->m = p->M2 * p->l / p->L2;
    a1 = uniform(-3, 3);
    a2 = uniform(-3, 3);
    e1 = vector(cos(a1), sin(a1), 0);
    e2 = vector(cos(a2), sin(a2), 0);
    f1 = vm_cross(z, e1);
    f2 = vm_cross(z, e2);
    p->hinge = vm_scale(R(p->L1), e1);
    p->upper = rod_at(p->M1, p->L1, a1, vm_scale(R(p->L1 / 2), e1));
    p->lower = rod_at(p->M2, p->L2, a2, vm_add(p->hinge, vm_scale(R(p->L2 / 2), e2)));
    p->rest = rod_at(p->M2 - p->m, p->L2 - p->l, a2, vm_add(p->hinge, vm_scale(R((p->L2 - p->l) / 2), e2)));
    p->part = rod_at(p->m, p->l, a2, vm_add(p->hinge, vm_scale(R(p->L2 - p->l / 2), e2)));
    p->turn_upper[0] = z;
    p->turn_upper[1] = O;
    p->turn_lower[0] = O;
    p->turn_lower[1] = z;
    p->dr_upper[0] = vm_scale(R(p->L1 / 2), f1);
    p->dr_upper[1] = O;
    p->dr_lower[0] = vm_scale(R(p->L1), f1);
    p->dr_lower[1] = vm_scale(R(p->L2 / 2), f2);
    p->dr_rest[0] = p->dr_lower[0];
    p->dr_rest[1] = vm_scale(R((p->L2 - p->l) / 2), f2);
    p->dr_part[0] = p->dr_lower[0];
    p->dr_part[1] = vm_scale(R(p->L2 - p->l / 2), f2);
}

/* Gives a body the velocities that belong to those of the two coordinates. */
static void move(vm_body *b, const vm_vec3 *dr, const vm_vec3 *turn, const vm_real *qdot)
{
    b->v = vm_add(vm_scale(qdot[0], dr[0]), vm_scale(qdot[1], dr[1]));
    b->omega = vm_add(vm_scale(qdot[0], turn[0]), vm_scale(qdot[1], turn[1]));
}

static vm_real about(const vm_body *b, vm_vec3 point) { return vm_angular_momentum(b, point).z; }

/* vm_lagrange_impact gives the same velocities, by the momentum of the motion of the part relative to the body. */
static void check_hit(const double_pendulum *p, const vm_real *after, const vm_real *qdot, const vm_real *expected)
{
    const double thinned = pow(p->L2 / (p->L2 - p->l), 3);
    const double size = (1 + fabs((double)expected[0]) + fabs((double)expected[1])) * thinned;
    vm_body relative = p->part;
    vm_real momentum[2] = {0}, got[2], work[VM_LAGRANGE_WORK(2)];
    move(&relative, p->dr_part, p->turn_lower, qdot);
    relative.v = vm_sub(relative.v, p->part.v);
    relative.omega = vm_sub(relative.omega, p->part.omega);
    vm_lagrange_momentum(2, &relative, p->dr_part, p->turn_lower, momentum);
    CHECK(vm_lagrange_impact(2, after, qdot, momentum, got, work) == VM_OK);
    check_case("vm_lagrange_impact", "double pendulum", got[0], (double)expected[0], size, 10);
    check_case("vm_lagrange_impact", "double pendulum", got[1], (double)expected[1], size, 10);
}

/* The impulse of the pivot has no moment about the pivot, and that of the hinge none about the hinge. */
static void test_double_pendulum(void)
{
    const vm_vec3 O = vector(0, 0, 0);
    int i;
    for (i = 0; i < 300; i++) {
        double_pendulum p;
        vm_body upper_after;
        vm_real before[4] = {0}, after[4] = {0}, momentum[2] = {0}, qdot[2], qdot1[2], work[VM_LAGRANGE_WORK(2)];
        double size;
        random_double_pendulum(&p);
        upper_after = p.upper;
        qdot[0] = R(uniform(-2, 2));
        qdot[1] = R(uniform(-2, 2));
        move(&p.upper, p.dr_upper, p.turn_upper, qdot);
        move(&p.lower, p.dr_lower, p.turn_lower, qdot);
        move(&p.part, p.dr_part, p.turn_lower, qdot);
        p.part.v.x += R(uniform(-1, 1));
        p.part.v.y += R(uniform(-1, 1));
        p.part.omega.z += R(uniform(-1, 1));
        vm_lagrange_mass(2, &p.upper, p.dr_upper, p.turn_upper, before);
        memcpy(after, before, sizeof after);
        vm_lagrange_mass(2, &p.lower, p.dr_lower, p.turn_lower, before);
        vm_lagrange_mass(2, &p.rest, p.dr_rest, p.turn_lower, after);
        vm_lagrange_momentum(2, &p.part, p.dr_part, p.turn_lower, momentum);
        CHECK(vm_lagrange_separate(2, before, after, qdot, momentum, NULL, qdot1, work) == VM_OK);
        move(&upper_after, p.dr_upper, p.turn_upper, qdot1);
        move(&p.rest, p.dr_rest, p.turn_lower, qdot1);
        size = 1 + p.M2 * 20 + fabs((double)qdot1[1]) * 10;
        check_case("L about the pivot", "double pendulum", about(&p.upper, O) + about(&p.lower, O),
                   (double)(about(&upper_after, O) + about(&p.rest, O) + about(&p.part, O)), size, 3);
        check_case("L about the hinge", "double pendulum", about(&p.lower, p.hinge),
                   (double)(about(&p.rest, p.hinge) + about(&p.part, p.hinge)), size, 2);
        check_hit(&p, after, qdot, qdot1);
    }
}

/* ---- The solution of the linear equations ---- */

enum { MOST = 12 };

/* A random positive mass matrix of n coordinates whose units are unit[i] */
static void random_mass_matrix(int n, const double *unit, vm_real *matrix)
{
    double root[MOST * MOST];
    int i, j, k;
    for (i = 0; i < n * n; i++) root[i] = uniform(-1, 1);
    for (i = 0; i < n; i++) {
        for (j = 0; j < n; j++) {
            double sum = i == j ? 1 : 0;
            for (k = 0; k < n; k++) sum += root[i * n + k] * root[j * n + k];
            matrix[i * n + j] = R(sum * unit[i] * unit[j]);
        }
    }
}

/* The part's momentum is such that the velocities x come out. */
static void check_units(int n, const double *unit)
{
    vm_real before[MOST * MOST], after[MOST * MOST], qdot[MOST], part[MOST], Q[MOST], got[MOST],
        work[VM_LAGRANGE_WORK(MOST)];
    double x[MOST];
    int i, j;
    random_mass_matrix(n, unit, after);
    for (i = 0; i < n * n; i++) before[i] = after[i] * 2;
    for (i = 0; i < n; i++) {
        x[i] = uniform(-1, 1) / unit[i];
        qdot[i] = R(uniform(-1, 1) / unit[i]);
        Q[i] = R(uniform(-1, 1) * unit[i]);
    }
    for (i = 0; i < n; i++) {
        double sum = 0;
        for (j = 0; j < n; j++)
            sum += (double)before[i * n + j] * (double)qdot[j] - (double)after[i * n + j] * x[j];
        part[i] = R(sum + (double)Q[i]);
    }
    CHECK(vm_lagrange_separate(n, before, after, qdot, part, Q, got, work) == VM_OK);
    for (i = 0; i < n; i++)
        check_error("qdot, separate", "any units", "eps", fabs((double)got[i] - x[i]) * unit[i] / eps, 40, n, i);
    for (i = 0; i < n; i++) part[i] = -part[i];
    CHECK(vm_lagrange_attach(n, before, after, qdot, part, Q, got, work) == VM_OK);
    for (i = 0; i < n; i++)
        check_error("qdot, attach", "any units", "eps", fabs((double)got[i] - x[i]) * unit[i] / eps, 40, n, i);
}

/* One to twelve coordinates in units of 1e-10 to 1e10, in float of 1e-4 to 1e4 */
static void test_units(void)
{
    int n, i, round;
    for (n = 1; n <= MOST; n++) {
        for (round = 0; round < 20; round++) {
            double unit[MOST];
            for (i = 0; i < n; i++) unit[i] = pow(10, uniform(-1, 1) * (is_float ? 4 : 10));
            check_units(n, unit);
        }
    }
}

/* A part of no mass changes nothing. One of little mass changes the velocities by little, and that to a few eps of
   the change: with the mass matrix ((3, 1), (1, 2)), the momentum (m, 2 m) makes the change (0, -m). */
static void test_light_part(void)
{
    double m;
    for (m = 1e-3; m > (is_float ? 1e-30 : 1e-300); m *= 1e-3) {
        const vm_real matrix[4] = {3, 1, 1, 2};
        vm_real qdot[2] = {0, 0}, part[2], got[2], work[VM_LAGRANGE_WORK(2)];
        part[0] = R(m);
        part[1] = R(2 * m);
        CHECK(vm_lagrange_separate(2, matrix, matrix, qdot, part, NULL, got, work) == VM_OK);
        check_error("qdot", "light part", "eps", fabs((double)got[0]) / m / eps, 4, m, 0);
        check_error("qdot", "light part", "eps", fabs((double)got[1] / m + 1) / eps, 4, m, 1);
        qdot[0] = 1;
        qdot[1] = 2;
        CHECK(vm_lagrange_separate(2, matrix, matrix, qdot, NULL, NULL, got, work) == VM_OK);
        CHECK(got[0] == 1 && got[1] == 2);
    }
}

/* ---- Refusals ---- */

/* A rod has no inertia about its axis, so that three turns about fixed axes have a singular mass matrix. */
static void test_rod_in_space(void)
{
    const vm_body rod_in_plane = rod_at(1, 2, 0.3, vector(0, 0, 0));
    const vm_real before[9] = {2, 0, 0, 0, 2, 0, 0, 0, 2}, qdot[3] = {1, 2, 3};
    vm_real matrix[9] = {0}, got[3] = {7, 7, 7}, work[VM_LAGRANGE_WORK(3)];
    vm_vec3 dr[3], turn[3];
    int i;
    for (i = 0; i < 3; i++) {
        dr[i] = vector(0, 0, 0);
        turn[i] = vector(i == 0, i == 1, i == 2);
    }
    vm_lagrange_mass(3, &rod_in_plane, dr, turn, matrix);
    CHECK(vm_lagrange_separate(3, before, matrix, qdot, NULL, NULL, got, work) == VM_SINGULAR);
    CHECK(got[0] == 7 && got[1] == 7 && got[2] == 7);
}

static void test_refusals(void)
{
    const vm_real good[9] = {2, 0, 0, 0, 2, 0, 0, 0, 2}, qdot[3] = {1, 2, 3}, kept[3] = {7, 7, 7};
    vm_real part[3] = {0, 0, 0}, got[3] = {7, 7, 7}, work[VM_LAGRANGE_WORK(3)], bad[9];
    memcpy(bad, good, sizeof bad);
    bad[4] = 0;
    CHECK(vm_lagrange_separate(3, good, bad, qdot, part, NULL, got, work) == VM_SINGULAR);
    bad[4] = -1;
    CHECK(vm_lagrange_separate(3, good, bad, qdot, part, NULL, got, work) == VM_SINGULAR);
    bad[4] = VM_NAN;
    CHECK(vm_lagrange_separate(3, good, bad, qdot, part, NULL, got, work) == VM_NOT_FINITE);
    CHECK(vm_lagrange_separate(3, bad, good, qdot, part, NULL, got, work) == VM_NOT_FINITE);
    part[1] = VM_INFINITY;
    CHECK(vm_lagrange_separate(3, good, good, qdot, part, NULL, got, work) == VM_NOT_FINITE);
    CHECK(vm_lagrange_attach(3, good, good, qdot, NULL, part, got, work) == VM_NOT_FINITE);
    CHECK(vm_lagrange_attach(0, good, good, qdot, NULL, NULL, got, work) == VM_BAD_ARGUMENT);
    CHECK(vm_lagrange_attach(3, NULL, good, qdot, NULL, NULL, got, work) == VM_BAD_ARGUMENT);
    CHECK(vm_lagrange_attach(3, good, NULL, qdot, NULL, NULL, got, work) == VM_BAD_ARGUMENT);
    CHECK(vm_lagrange_attach(3, good, good, NULL, NULL, NULL, got, work) == VM_BAD_ARGUMENT);
    CHECK(vm_lagrange_attach(3, good, good, qdot, NULL, NULL, NULL, work) == VM_BAD_ARGUMENT);
    CHECK(vm_lagrange_attach(3, good, good, qdot, NULL, NULL, got, NULL) == VM_BAD_ARGUMENT);
    CHECK(vm_lagrange_impact(3, good, qdot, NULL, got, work) == VM_BAD_ARGUMENT);
    CHECK(memcmp(got, kept, sizeof got) == 0);
}

int main(void)
{
    int i;
    test_virtual_work();
    for (i = 0; i < 1000; i++) check_free_jump(i, i % 2);
    test_derivative_rule();
    test_double_pendulum();
    test_units();
    test_light_part();
    test_rod_in_space();
    test_refusals();
    return check_finish("lagrange_jump");
}
