/* Chapter 4 of varmass.h: the pendulum that loses its outer part, (119)-(132), vm_pendulum_separate.
   Oracles: the reference case D2 in 22 digits, the equations of the dissertation written out by hand, the vector form
   by vm_separate with the impulse of the pivot, and Lagrange's equations across a jump. The equations that the
   dissertation prints wrongly are evaluated as printed and must miss by a known amount. */
#include "rods.h"

/* ---- Case D2 ---- */

/* Mass and length of the pendulum, length of the part, phi', Omega, u, mass of the part, distance and place of its
   mass centre S2, and the sense of phi: 1 if it turns from x to y */
typedef struct pendulum_numbers {
    double M, L, l, phi_rate, Omega, ux, uy, m, rho, x, y, sense;
} pendulum_numbers;

static pendulum_numbers numbers_D2(int axes)
{
    pendulum_numbers n = {3, 2, 0.5, 1.3, 0.6, 0.4, -0.25, 0.75, 1.75, 0, 0, 1};
    n.x = n.rho * cos(0.7);
    n.y = n.rho * sin(0.7);
    if (axes == VM_AXES_SIN_COS) {
        n.x = n.rho * sin(0.7);
        n.y = n.rho * cos(0.7);
        n.sense = -1;
    }
    return n;
}

/* The printed equations differ in two places: they take the angular velocity of the part, phi' + Omega, for the
   dragging velocity of S2, and they know one sense of phi. */
static double dragging_rate(const pendulum_numbers *n, int printed)
{
    return printed ? n->phi_rate + n->Omega : n->phi_rate;
}

/* The moment x u_y - y u_x in the sense of phi */
static double moment_of_u(const pendulum_numbers *n, int printed)
{
    const double moment = n->x * n->uy - n->y * n->ux;
    return printed ? moment : n->sense * moment;
}

/* phi1' by (125), corrected and as printed */
static double rate_125(const pendulum_numbers *n, int printed)
{
    const double before = n->M * n->L * n->L * n->phi_rate;
    const double spin = n->m * n->l * n->l / 4 * (n->phi_rate + n->Omega);
    const double motion = dragging_rate(n, printed) * n->rho * n->rho + moment_of_u(n, printed);
    return (before - spin - 3 * n->m * motion) / ((n->M - n->m) * (n->L - n->l) * (n->L - n->l));
}

/* T_S2 by (122) */
static double energy_122(const pendulum_numbers *n, int printed)
{
    const double with = n->phi_rate + n->Omega, drag = dragging_rate(n, printed);
    const double speed2 = n->ux * n->ux + n->uy * n->uy + drag * drag * n->rho * n->rho +
                          2 * drag * moment_of_u(n, printed);
    return n->m / 2 * speed2 + n->m * n->l * n->l / 24 * with * with;
}

/* L_2 by (128), which is printed with rho instead of its square */
static double momentum_128(const pendulum_numbers *n, int printed)
{
    const double with = n->phi_rate + n->Omega;
    const double dragging = printed ? n->rho * with : n->rho * n->rho * n->phi_rate;
    return n->m * (n->l * n->l / 12 * with + dragging + moment_of_u(n, printed));
}

/* All that vm_pendulum_separate gives, against the corrected equations */
static void check_D2(const char *region, const pendulum_numbers *n, const vm_pendulum_cut *c)
{
    const double part_spin = n->m * n->l * n->l / 12, rest_mass = 2.25, rest_length = 1.5;
    const double rest_inertia = rest_mass * rest_length * rest_length, rest_rate = (double)c->rest.rate;
    const double part_v2 = (double)(c->vx * c->vx + c->vy * c->vy), part_rate = (double)c->rate;
    check_case("phi1' (125)", region, c->rest.rate, rate_125(n, 0), 1, 3);
    check_case("T_S2 (122)", region, c->T_S2, energy_122(n, 0), 2, 3);
    check_case("T_S2 (120)", region, c->T_S2, n->m / 2 * part_v2 + part_spin / 2 * part_rate * part_rate, 2, 3);
    check_case("L_2 (128)", region, c->L2, momentum_128(n, 0), 2, 3);
    check_case("L_2 (129)", region, c->L2, part_spin * 1.9 + n->m * n->rho * n->rho * 1.3 + n->m * moment_of_u(n, 0),
               2, 3);
    check_case("T1 (119)", region, c->T1, 3 * 4 * 1.69 / 6, 3, 3);
    check_case("T_S1 (124)", region, c->T_S1, rest_inertia * rest_rate * rest_rate / 6, 2, 3);
    check_case("L_1 (130)", region, c->L1, rest_inertia * rest_rate / 3, 2, 3);
    check_case("L_1 (131)", region, c->L1, rest_inertia * rest_rate * (1. / 12 + 1. / 4), 2, 3);
    check_case("L (126), (132)", region, c->L1 + c->L2, 3 * 4 * 1.3 / 3, 5, 3);
    check_case("L (127)", region, R(3 * 4 * 1.3 / 12 + 3 * 1 * 1.3), 3 * 4 * 1.3 / 3, 5, 2); /* I_S + M L^2/4 */
    check_case("v_S2 (121)", region, c->vx, 0.4 - n->sense * 1.3 * n->y, 3, 3);
    check_case("v_S2 (121)", region, c->vy, -0.25 + n->sense * 1.3 * n->x, 3, 3);
    check_case("S2 (123)", region, c->x, n->x, 2, 2);
    check_case("S2 (123)", region, c->y, n->y, 2, 2);
    check_case("rate of part (121)", region, c->rate, 1.9, 2, 1);
    CHECK(c->mass == R(0.75) && c->rest.mass == R(rest_mass) && c->rest.length == R(rest_length));
}

static vm_pendulum_cut cut_D2(int axes)
{
    const vm_pendulum p = {3, 2, R(0.7), R(1.3), axes};
    vm_pendulum_cut c;
    memset(&c, 0, sizeof c);
    CHECK(vm_pendulum_separate(&p, R(0.5), R(0.6), R(0.4), R(-0.25), &c) == VM_OK);
    return c;
}

/* S2 at (cos phi, sin phi) */
static void test_D2_cos_sin(void)
{
    const char *region = "D2, (cos, sin)";
    const pendulum_numbers n = numbers_D2(VM_AXES_COS_SIN);
    const vm_pendulum_cut c = cut_D2(VM_AXES_COS_SIN);
    check_case("phi1' (125)", region, c.rest.rate, 1.643587039112598855137, 1, 3);
    check_case("T_S2 (122)", region, c.T_S2, 1.286568432946736261544, 2, 3);
    check_case("L_2 (128)", region, c.L2, 2.426446871497489431957, 2, 3);
    check_D2(region, &n, &c);
    ERRATUM("(125),(132)", fabs(rate_125(&n, 1) - 0.826920) < 1e-6,
            check_holds("phi1' (125)") && check_holds("L (126), (132)"));
}

/* S2 at (sin phi, cos phi), as (123) has it, while the sign of (125) is that of (cos, sin) */
static void test_D2_sin_cos(void)
{
    const pendulum_numbers n = numbers_D2(VM_AXES_SIN_COS);
    const vm_pendulum_cut c = cut_D2(VM_AXES_SIN_COS);
    pendulum_numbers other_sense = n;
    CHECK(fabs((double)c.rest.rate - 0.931229) < 1e-6 && fabs((double)c.T_S2 - 2.84930) < 1e-5);
    CHECK(fabs((double)c.L2 - 3.628551) < 1e-6);
    check_D2("D2, (sin, cos)", &n, &c);
    ERRATUM("(125),(132)", fabs(rate_125(&n, 1) - 0.840993) < 1e-6,
            check_holds("phi1' (125)") && check_holds("L (126), (132)"));
    ERRATUM("(122)", fabs(energy_122(&n, 1) - 3.09294) < 1e-5, check_holds("T_S2 (122)"));
    ERRATUM("(128),(129)", fabs(momentum_128(&n, 1) - 1.910511) < 1e-6,
            check_holds("L_2 (128)") && check_holds("L_2 (129)"));
    other_sense.sense = -n.sense;
    ERRATUM("(123)", fabs(rate_125(&other_sense, 0) - (double)c.rest.rate) > 0.1, check_holds("S2 (123)"));
}

/* The mass m of the part is not free: the moments of inertia about O add up for m = M l/L = 0.75 only. */
static void test_mass_of_part(void)
{
    const double l = 0.5, rho = 1.75, masses[] = {0.4, 0.75}, expected[] = {0.8167, 0};
    int i;
    for (i = 0; i < 2; i++) {
        const double m = masses[i], missing = 4 - (3 - m) * 2.25 / 3 - m * l * l / 12 - m * rho * rho;
        CHECK(fabs(missing - expected[i]) < 1e-4);
    }
}

/* ---- The vector form ---- */

/* A random cut, as vm_pendulum_separate takes it and as bodies */
typedef struct random_cut {
    vm_pendulum pendulum;
    vm_pendulum_cut cut;
    double l, Omega, ux, uy, sense;
    vm_vec3 across; /* unit vector, across the rod */
    vm_body whole, part;
} random_cut;

static void random_cut_init(random_cut *r, int axes)
{
    const vm_pendulum start = {3, 2, 0, 0, 0};
    double angle;
    vm_vec3 along;
    memset(r, 0, sizeof *r);
    r->pendulum = start;
    r->l = (double)R(uniform(0.1, 1.6));
    r->Omega = uniform(-2, 2);
    r->ux = uniform(-1, 1);
    r->uy = uniform(-1, 1);
    r->pendulum.angle = R(uniform(-3, 3));
    r->pendulum.rate = R(uniform(-2, 2));
    r->pendulum.axes = axes;
    r->sense = axes == VM_AXES_COS_SIN ? 1 : -1;
    CHECK(vm_pendulum_separate(&r->pendulum, R(r->l), R(r->Omega), R(r->ux), R(r->uy), &r->cut) == VM_OK);
    angle = (double)r->pendulum.angle;
    if (axes == VM_AXES_SIN_COS) angle = 2 * atan(1.) - angle;
    along = vector(cos(angle), sin(angle), 0);
    r->across = vector(-sin(angle), cos(angle), 0);
    r->whole = rod_at(3, 2, angle, along);
    r->whole.omega.z = R(r->sense) * r->pendulum.rate;
    r->whole.v = vm_scale(r->whole.omega.z, r->across);
    r->part = rod_at(3 * r->l / 2, r->l, angle, vm_scale(R(2 - r->l / 2), along));
    r->part.omega.z = R(r->sense) * (r->pendulum.rate + R(r->Omega));
    r->part.v = vm_add(vm_scale(r->whole.omega.z * R(2 - r->l / 2), r->across), vector(r->ux, r->uy, 0));
}

/* The velocity of the pivot's point of the rest after the cut with this impulse at the pivot */
static vm_vec3 velocity_at_pivot(const random_cut *r, vm_vec3 impulse, vm_body *rest)
{
    vm_impulse j;
    memset(&j, 0, sizeof j);
    j.linear = impulse;
    CHECK(vm_separate(&r->whole, &r->part, &j, rest) >= 0);
    return vm_add(rest->v, vm_cross(rest->omega, vm_scale(-1, rest->r)));
}

/* The impulse with which the pivot's point stays in place. The velocity depends linearly on it, so that the velocities
   without an impulse and with the two unit ones give two linear equations. */
static vm_vec3 impulse_of_pivot(const random_cut *r)
{
    vm_body rest;
    const vm_vec3 v0 = velocity_at_pivot(r, vector(0, 0, 0), &rest);
    const vm_vec3 by_x = vm_sub(velocity_at_pivot(r, vector(1, 0, 0), &rest), v0);
    const vm_vec3 by_y = vm_sub(velocity_at_pivot(r, vector(0, 1, 0), &rest), v0);
    const double xx = (double)by_x.x, xy = (double)by_x.y, yx = (double)by_y.x, yy = (double)by_y.y;
    const double x = (double)v0.x, y = (double)v0.y, determinant = xx * yy - yx * xy;
    return vector((-x * yy + y * yx) / determinant, (-y * xx + x * xy) / determinant, 0);
}

static void test_vector_form(void)
{
    int i;
    for (i = 0; i < 300; i++) {
        random_cut r;
        vm_body rest;
        vm_vec3 impulse;
        double size;
        memset(&rest, 0, sizeof rest);
        random_cut_init(&r, i % 2);
        impulse = impulse_of_pivot(&r);
        velocity_at_pivot(&r, impulse, &rest);
        size = (1 + fabs((double)r.cut.rest.rate)) * pow(2 / (2 - r.l), 3);
        check_case("phi1'", "vm_separate", R(r.sense) * rest.omega.z, (double)r.cut.rest.rate, size, 10);
        check_case("impulse of the pivot", "vm_separate", impulse.x, (double)r.cut.pivot_x, size * 3, 3);
        check_case("impulse of the pivot", "vm_separate", impulse.y, (double)r.cut.pivot_y, size * 3, 3);
    }
}

/* Lagrange's equation (96) with the one coordinate phi, and the gain of energy (118) */
static void test_lagrange_form(void)
{
    int i;
    for (i = 0; i < 300; i++) {
        random_cut r;
        vm_vec3 dr, turn;
        vm_real before = 4, after, momentum = 0, rate, work[VM_LAGRANGE_WORK(1)];
        double size, change, part_energy;
        random_cut_init(&r, i % 2);
        after = r.cut.rest.mass * r.cut.rest.length * r.cut.rest.length / 3;
        dr = vm_scale(R(r.sense * (2 - r.l / 2)), r.across);
        turn = vector(0, 0, r.sense);
        vm_lagrange_momentum(1, &r.part, &dr, &turn, &momentum);
        CHECK(vm_lagrange_separate(1, &before, &after, &r.pendulum.rate, &momentum, NULL, &rate, work) == VM_OK);
        size = (1 + fabs((double)r.cut.rest.rate)) * pow(2 / (2 - r.l), 3);
        check_case("L_2 = dT_S2/dphi'", "(96)", momentum, (double)r.cut.L2, 10, 4);
        check_case("phi1'", "(96)", rate, (double)r.cut.rest.rate, size, 5);
        change = (double)(r.cut.rest.rate - r.pendulum.rate);
        part_energy = 3 * r.l / 2 * ((r.ux * r.ux + r.uy * r.uy) / 2 + r.l * r.l * r.Omega * r.Omega / 24);
        check_case("gain (118)", "pendulum", r.cut.T_S1 + r.cut.T_S2 - r.cut.T1,
                   (double)after / 2 * change * change + part_energy, 10 + (double)r.cut.T_S1, 6);
    }
}

/* ---- A pendulum that is not uniform ---- */

/* A random disc, its mass centre anywhere, from which a disc anywhere in it is cut, so that the rest is possible */
static vm_compound_pendulum random_compound(vm_compound_part *part)
{
    vm_compound_pendulum p;
    p.mass = R(uniform(2, 3));
    p.x = R(uniform(-1, 1));
    p.y = R(uniform(-1, 1));
    p.inertia = p.mass * (p.x * p.x + p.y * p.y + R(uniform(1, 2)));
    p.rate = R(uniform(-3, 3));
    part->mass = R(uniform(0.2, 0.5));
    part->inertia = part->mass * R(uniform(0, 0.5));
    part->x = p.x + R(uniform(-0.5, 0.5));
    part->y = p.y + R(uniform(-0.5, 0.5));
    part->ux = R(uniform(-2, 2));
    part->uy = R(uniform(-2, 2));
    part->Omega = R(uniform(-2, 2));
    return p;
}

/* The body of the plane that belongs to a compound pendulum */
static vm_body2 plane_body_of(const vm_compound_pendulum *p)
{
    vm_body2 b;
    memset(&b, 0, sizeof b);
    b.mass = p->mass;
    b.inertia = p->inertia - p->mass * (p->x * p->x + p->y * p->y);
    b.x = p->x;
    b.y = p->y;
    b.vx = -p->rate * p->y;
    b.vy = p->rate * p->x;
    b.omega = p->rate;
    return b;
}

/* Angular momentum about O stays, the momentum changes by the impulse of the pivot, and energies, mass and mass centre
   are those of the bodies */
static void test_compound(void)
{
    int i;
    for (i = 0; i < 1000; i++) {
        vm_compound_part part;
        const vm_compound_pendulum p = random_compound(&part);
        const vm_body2 whole = plane_body_of(&p);
        vm_compound_cut c;
        vm_body2 rest, piece;
        double scale;
        memset(&c, 0, sizeof c);
        CHECK(vm_compound_pendulum_separate(&p, &part, &c) == VM_OK);
        rest = plane_body_of(&c.rest);
        memset(&piece, 0, sizeof piece);
        piece.mass = part.mass;
        piece.inertia = part.inertia;
        piece.x = part.x;
        piece.y = part.y;
        piece.vx = c.vx;
        piece.vy = c.vy;
        piece.omega = c.rate;
        scale = 20 + 20 * fabs((double)c.rest.rate);
        check_case("L about O", "compound", c.L1 + c.L2, (double)(p.inertia * p.rate), scale, 4);
        check_case("L1", "compound", c.L1, (double)vm_angular_momentum2(&rest, 0, 0), scale, 4);
        check_case("L2", "compound", c.L2, (double)vm_angular_momentum2(&piece, 0, 0), scale, 4);
        check_case("impulse of the pivot", "compound", c.pivot_x,
                   (double)(rest.mass * rest.vx + piece.mass * piece.vx - whole.mass * whole.vx), scale, 4);
        check_case("impulse of the pivot", "compound", c.pivot_y,
                   (double)(rest.mass * rest.vy + piece.mass * piece.vy - whole.mass * whole.vy), scale, 4);
        check_case("T1", "compound", c.T1, (double)vm_kinetic_energy2(&whole), scale * (1 + fabs((double)p.rate)), 4);
        check_case("T_S1", "compound", c.T_S1, (double)vm_kinetic_energy2(&rest),
                   scale * (1 + fabs((double)c.rest.rate)), 4);
        check_case("T_S2", "compound", c.T_S2, (double)vm_kinetic_energy2(&piece), scale * (1 + fabs((double)c.rate)),
                   4);
        check_case("mass centre", "compound", rest.mass * rest.x + part.mass * part.x, (double)(p.mass * p.x), 5, 4);
        check_case("mass", "compound", rest.mass + part.mass, (double)p.mass, 5, 1);
    }
}

/* Two point masses at the ends of a weightless rod, of which one is cut off: the rest has exactly the smallest possible
   inertia, and rounding errors must not make it too small, in any units. */
static void test_compound_of_points(void)
{
    int i;
    for (i = 0; i < 1000; i++) {
        const double unit = ldexp(1, 4 * (i % 5 - 2)), m1 = uniform(1, 3), m2 = uniform(1, 3);
        const double x1 = unit * uniform(-3, 3), y1 = unit * uniform(-3, 3);
        const double x2 = unit * uniform(-3, 3), y2 = unit * uniform(-3, 3);
        vm_compound_pendulum p;
        vm_compound_part part;
        vm_compound_cut c;
        memset(&part, 0, sizeof part);
        part.mass = R(m2);
        part.x = R(x2);
        part.y = R(y2);
        p.mass = R(m1 + m2);
        p.x = R((m1 * x1 + m2 * x2) / (m1 + m2));
        p.y = R((m1 * y1 + m2 * y2) / (m1 + m2));
        p.inertia = R(m1 * (x1 * x1 + y1 * y1) + m2 * (x2 * x2 + y2 * y2));
        p.rate = 1;
        CHECK(vm_compound_pendulum_separate(&p, &part, &c) == VM_OK);
    }
}

/* The uniform rod of case D2, and the same cut by an axle in space */
static void test_compound_D2(void)
{
    const double x = 1.75 * cos(0.7), y = 1.75 * sin(0.7);
    const vm_compound_pendulum rod = {3, 4, R(cos(0.7)), R(sin(0.7)), R(1.3)};
    const vm_compound_part part = {R(0.75), R(0.75 * 0.25 / 12), R(x), R(y), R(0.4), R(-0.25), R(0.6)};
    const vm_pendulum_cut uniform_rod = cut_D2(VM_AXES_COS_SIN);
    vm_compound_cut c;
    memset(&c, 0, sizeof c);
    CHECK(vm_compound_pendulum_separate(&rod, &part, &c) == VM_OK);
    check_case("phi1' (125)", "D2, compound", c.rest.rate, 1.643587039112598855137, 4, 4);
    check_case("T_S2 (122)", "D2, compound", c.T_S2, 1.286568432946736261544, 2, 4);
    check_case("L_2 (128)", "D2, compound", c.L2, 2.426446871497489431957, 2, 4);
    check_case("impulse of the pivot", "D2, compound", c.pivot_x, (double)uniform_rod.pivot_x, 4, 4);
    check_case("impulse of the pivot", "D2, compound", c.pivot_y, (double)uniform_rod.pivot_y, 4, 4);
    check_case("inertia", "D2, compound", c.rest.inertia, 2.25 * 2.25 / 3, 4, 4);
}

static void test_bad_compounds(void)
{
    const int expected[] = {VM_NOT_FINITE, VM_BAD_MASS,    VM_BAD_MASS,    VM_BAD_MASS,
                            VM_NOT_FINITE, VM_BAD_INERTIA, VM_BAD_INERTIA, VM_BAD_INERTIA};
    vm_compound_cut c, kept;
    int i;
    memset(&c, 1, sizeof c);
    memset(&kept, 1, sizeof kept);
    for (i = 0; i < 8; i++) {
        vm_compound_pendulum p = {3, 4, 1, 0, 2};
        vm_compound_part part = {R(0.5), R(0.1), 1, 0, 1, 1, 1};
        if (i == 0) p.rate = VM_NAN;
        if (i == 1) p.mass = 0;
        if (i == 2) part.mass = -1;
        if (i == 3) part.mass = 3;
        if (i == 4) part.Omega = VM_INFINITY;
        if (i == 5) part.inertia = -1;
        if (i == 6) p.inertia = R(2.9); /* less than M d^2 */
        if (i == 7) part.x = 3;         /* the part cannot have been in the whole */
        CHECK(vm_compound_pendulum_separate(&p, &part, &c) == expected[i]);
        CHECK(memcmp(&c, &kept, sizeof c) == 0);
        CHECK(vm_compound_pendulum_separate(i == 0 ? NULL : &p, i == 1 ? NULL : &part, i > 1 ? NULL : &c) ==
              VM_BAD_ARGUMENT);
    }
}

/* ---- Limits ---- */

/* phi1' by (125) as it stands, without a relative velocity: it must come out as phi', but cancellation destroys it
   where the rest, of the length 2 - l, is short. */
static double direct_125(const vm_pendulum *p, double l)
{
    const double left = 2 - l;
    const vm_real m = R(1.5 * l), rho = R(2 - l / 2), rest = R(1.5 * left * left * left);
    return (double)((12 * p->rate - m * R(l * l) / 4 * p->rate - 3 * m * rho * rho * p->rate) / rest);
}

/* l -> L: vm_pendulum_separate keeps the digits that (125) loses. */
static void test_short_rest(void)
{
    const vm_pendulum p = {3, 2, R(0.7), R(1.3), 0};
    double left, worst = 0;
    vm_pendulum_cut c;
    memset(&c, 0, sizeof c);
    for (left = 1; left > (is_float ? 1e-5 : 1e-13); left /= 2) {
        const double l = 2 - left;
        double expected;
        CHECK(vm_pendulum_separate(&p, R(l), 0, 0, 0, &c) == VM_OK && c.rest.rate == p.rate);
        worst = fmax(worst, fabs(direct_125(&p, l) / (double)p.rate - 1));
        CHECK(vm_pendulum_separate(&p, R(l), R(0.5), 0, 0, &c) == VM_OK);
        expected = (double)p.rate - l * l * l / 8 / (left * left * left);
        check_error("phi1'", "l -> L", "eps", fabs((double)c.rest.rate / expected - 1) / eps, 4, left, 0);
    }
    CHECK(worst > 1);
}

/* l -> 0: the change of phi' is as accurate as phi'. */
static void test_short_part(void)
{
    const vm_pendulum p = {3, 2, R(0.7), R(1.3), 0};
    double l;
    vm_pendulum_cut c;
    memset(&c, 0, sizeof c);
    for (l = 0.1; l > (is_float ? 1e-12 : 1e-100); l /= 10) {
        const double change = 3 * l * (1 - l / 4) * 2e3 * sin(0.7) / pow(2 - l, 3);
        CHECK(vm_pendulum_separate(&p, R(l), 0, R(1e3), 0, &c) == VM_OK);
        check_error("phi1' - phi'", "l -> 0", "eps",
                    fabs((double)c.rest.rate - 1.3 - change) / eps / (1 + 1e3 * l), 8, l, 0);
    }
}

/* The same pendulum with all lengths s times as long and all angular velocities 1/s times as large: if s is a power of two,
   the results have the same bits, also if the cube of a length underflows. */
static void test_small_lengths(void)
{
    const vm_real s = VM_LIBM(ldexp)(1, is_float ? -50 : -360);
    const vm_pendulum p = {3, 2, R(0.7), R(1.3), 0};
    vm_pendulum small = p;
    vm_pendulum_cut c, d;
    small.length *= s;
    small.rate /= s;
    CHECK(vm_pendulum_separate(&p, R(0.5), R(0.6), R(0.4), R(-0.25), &c) == VM_OK);
    CHECK(vm_pendulum_separate(&small, R(0.5) * s, R(0.6) / s, R(0.4), R(-0.25), &d) == VM_OK);
    CHECK(d.rest.rate * s == c.rest.rate && d.rate * s == c.rate && d.rest.mass == c.rest.mass && d.mass == c.mass);
    CHECK(d.vx == c.vx && d.vy == c.vy && d.pivot_x == c.pivot_x && d.pivot_y == c.pivot_y);
    CHECK(d.T1 == c.T1 && d.T_S1 == c.T_S1 && d.T_S2 == c.T_S2 && d.L1 / s == c.L1 && d.L2 / s == c.L2);
}

/* ---- Refusals ---- */

static void test_bad_pendulums(void)
{
    const vm_pendulum good = {3, 2, R(0.7), R(1.3), 0};
    const int expected[] = {VM_NOT_FINITE, VM_NOT_FINITE, VM_NOT_FINITE, VM_NOT_FINITE,
                            VM_BAD_MASS,   VM_DOMAIN,     VM_BAD_ARGUMENT};
    vm_pendulum bad[7];
    vm_pendulum_cut c, kept;
    int i;
    memset(&c, 1, sizeof c);
    memset(&kept, 1, sizeof kept);
    for (i = 0; i < 7; i++) bad[i] = good;
    bad[0].mass = VM_NAN;
    bad[1].length = VM_INFINITY;
    bad[2].angle = VM_INFINITY;
    bad[3].rate = VM_NAN;
    bad[4].mass = 0;
    bad[5].length = R(0.5); /* that of the part */
    bad[6].axes = 2;
    for (i = 0; i < 7; i++) CHECK(vm_pendulum_separate(&bad[i], R(0.5), 0, 0, 0, &c) == expected[i]);
    CHECK(memcmp(&c, &kept, sizeof c) == 0);
}

static void test_bad_parts(void)
{
    const vm_pendulum good = {3, 2, R(0.7), R(1.3), 0};
    vm_pendulum_cut c, kept;
    memset(&c, 1, sizeof c);
    memset(&kept, 1, sizeof kept);
    CHECK(vm_pendulum_separate(NULL, 1, 0, 0, 0, &c) == VM_BAD_ARGUMENT);
    CHECK(vm_pendulum_separate(&good, 1, 0, 0, 0, NULL) == VM_BAD_ARGUMENT);
    CHECK(vm_pendulum_separate(&good, 0, 0, 0, 0, &c) == VM_DOMAIN);
    CHECK(vm_pendulum_separate(&good, 2, 0, 0, 0, &c) == VM_DOMAIN);
    CHECK(vm_pendulum_separate(&good, VM_NAN, 0, 0, 0, &c) == VM_NOT_FINITE);
    CHECK(vm_pendulum_separate(&good, 1, VM_NAN, 0, 0, &c) == VM_NOT_FINITE);
    CHECK(vm_pendulum_separate(&good, 1, 0, VM_INFINITY, 0, &c) == VM_NOT_FINITE);
    CHECK(vm_pendulum_separate(&good, 1, 0, 0, VM_NAN, &c) == VM_NOT_FINITE);
    CHECK(memcmp(&c, &kept, sizeof c) == 0);
}

int main(void)
{
    test_D2_cos_sin();
    test_D2_sin_cos();
    test_mass_of_part();
    test_vector_form();
    test_lagrange_form();
    test_compound();
    test_compound_of_points();
    test_compound_D2();
    test_bad_compounds();
    test_short_rest();
    test_short_part();
    test_small_lengths();
    test_bad_pendulums();
    test_bad_parts();
    return check_finish("pendulum");
}
