/* Jumps, varmass.h: random bodies made of particles, whose momenta are summed particle by particle; the balances of
   momentum, angular momentum and energy; several parts at once, relative motion, inverse questions, the plane; the
   cases in which digits could be lost, each with what would go wrong; bad input. The equations one by one are in
   test_jump_equations.c.

   usage: jumps [seed], which draws other bodies */
#include "bodies.h"

/* ---- Particles: the judge that needs no formula ---- */

enum { PARTICLES = 14, PIECES = 4 };

/* 1e-13 relative to the momenta involved, and the like in float */
static const double particle_bound = 25; /* worst: 8.5 */

typedef struct shot {
    particle p[PARTICLES];
    int first[PIECES + 1]; /* the particles of piece i are first[i] to first[i + 1] - 1; piece 0 is the rest */
    vm_body whole, piece[PIECES];
    vm_impulse impulse;
    double about[3];
} shot;

static void draw_shot(shot *s, double rest_weight)
{
    int i, k;
    double size = pow(10, uniform(-1, 1));
    vm_vec3 place = random_vector(2 * size),
            about = random_vector(5); /* near: at r a mass centre is right to eps r */
    s->first[0] = 0;
    s->first[1] = 5;
    s->first[2] = 8;
    s->first[3] = 10;
    s->first[4] = PARTICLES;
    for (i = 0; i < PARTICLES; i++) {
        s->p[i].m = uniform(0.3, 1) * (i < s->first[1] ? rest_weight : 1);
        s->p[i].r[0] = (double)place.x + uniform(-size, size);
        s->p[i].r[1] = (double)place.y + uniform(-size, size);
        s->p[i].r[2] = (double)place.z + uniform(-size, size);
    }
    s->whole = body_of(PARTICLES, s->p, random_attitude());
    s->whole.v = random_vector(5);
    s->whole.omega = random_vector(3);
    for (k = 0; k < PIECES; k++) {
        s->piece[k] = body_of(s->first[k + 1] - s->first[k], s->p + s->first[k], random_attitude());
        s->piece[k].v = random_vector(5);
        s->piece[k].omega = random_vector(3);
    }
    s->impulse = random_impulse();
    s->about[0] = (double)about.x;
    s->about[1] = (double)about.y;
    s->about[2] = (double)about.z;
}

static void add_piece(sums *sum, double sign, const shot *s, int piece, const vm_body *motion)
{
    add_particles(sum, sign, s->first[piece + 1] - s->first[piece], s->p + s->first[piece], motion, s->about);
}

static void add_whole(sums *sum, double sign, const shot *s, const vm_body *motion)
{
    add_particles(sum, sign, PARTICLES, s->p, motion, s->about);
}

/* The sums hold after - before: less the impulse nothing must be left */
static void check_sums(const char *what, sums *s, const vm_impulse *j, const double *about, double index)
{
    if (j) {
        const double J[3] = {(double)j->linear.x, (double)j->linear.y, (double)j->linear.z};
        const double C[3] = {(double)j->couple.x, (double)j->couple.y, (double)j->couple.z};
        double arm[3] = {(double)j->at.x - about[0], (double)j->at.y - about[1], (double)j->at.z - about[2]};
        int k;
        for (k = 0; k < 3; k++) {
            int k1 = (k + 1) % 3, k2 = (k + 2) % 3;
            s->K[k] -= J[k];
            s->L[k] -= C[k] + arm[k1] * J[k2] - arm[k2] * J[k1];
        }
        s->K_size += length3(J);
        s->L_size += length3(C) + length3(arm) * length3(J);
    }
    check_error(what, "particles", "eps K", length3(s->K) / s->K_size / eps, particle_bound, index, 0);
    check_error(what, "particles", "eps L", length3(s->L) / s->L_size / eps, particle_bound, index, 0);
}

/* Each function of momenta and energy, and the balance, of the same motions */
static void check_momenta(const shot *s, int i)
{
    const vm_vec3 about = vector(s->about[0], s->about[1], s->about[2]);
    vm_vec3 K = vm_momentum(&s->whole), L = vm_angular_momentum(&s->whole, about);
    vm_balance b;
    sums sum = {0, {0, 0, 0}, {0, 0, 0}, 0, 0, 0};
    add_whole(&sum, 1, s, &s->whole);
    check_error("(1) K", "particles", "eps",
                size_of(vmi_sub(K, vector(sum.K[0], sum.K[1], sum.K[2]))) / sum.K_size / eps, 25, i, 0);
    check_error("(7) L", "particles", "eps",
                size_of(vmi_sub(L, vector(sum.L[0], sum.L[1], sum.L[2]))) / sum.L_size / eps, 25, i, 0);
    check_error("(93) T", "particles", "eps", fabs((double)vm_kinetic_energy(&s->whole) / sum.T - 1) / eps, 20, i,
                0);
    add_piece(&sum, -1, s, 0, &s->piece[0]); /* (4), (10): as if the whole came of piece 0 and nothing else */
    if (vm_balance_between(1, s->piece, 1, &s->whole, NULL, about, &b)) {
        FAIL("balance");
        return;
    }
    check_error("(6) balance", "particles", "eps",
                size_of(vmi_sub(b.momentum, vector(sum.K[0], sum.K[1], sum.K[2]))) / sum.K_size / eps, 25, i, 0);
    check_error("(12) balance", "particles", "eps",
                size_of(vmi_sub(b.angular_momentum, vector(sum.L[0], sum.L[1], sum.L[2]))) / sum.L_size / eps, 25,
                i, 0);
    check_error("energy", "particles", "eps",
                fabs((double)b.energy - sum.T) / eps / (double)vm_kinetic_energy(&s->whole), 280, i, 0);
    CHECK((double)b.momentum_scale < 1.01 * sum.K_size && b.angular_momentum_scale > 0);
}

/* What is left after k pieces have gone. Its inertia and mass centre have the whole's rounding errors, those of the
   input included: to the momenta involved belong those that the whole would have if it moved like the rest. */
static void check_rest(const char *what, const shot *s, int k, const vm_body *rest, const vm_impulse *j, int index)
{
    sums sum = {0, {0, 0, 0}, {0, 0, 0}, 0, 0, 0}, with_rest = sum;
    int i;
    for (i = 0; i < PIECES; i++) add_piece(&sum, 1, s, i, i < PIECES - k ? rest : &s->piece[i]);
    add_whole(&sum, -1, s, &s->whole);
    add_whole(&with_rest, 1, s, rest);
    sum.K_size += with_rest.K_size;
    sum.L_size += with_rest.L_size;
    check_sums(what, &sum, j, s->about, index);
}

static void test_particles(int unequal)
{
    int i, k;
    for (i = 0; i < 2000; i++) {
        sums attached = {0, {0, 0, 0}, {0, 0, 0}, 0, 0, 0}, all = attached;
        const vm_impulse *j;
        vm_body rest, whole;
        shot s;
        draw_shot(&s, unequal ? pow(10, uniform(is_float ? -1 : -2, 2)) : 1);
        check_momenta(&s, i);
        j = i % 2 ? &s.impulse : NULL;

        CHECK(vm_separate(&s.whole, &s.piece[PIECES - 1], j, &rest) == VM_OK);
        check_rest("separate", &s, 1, &rest, j, i);
        CHECK(vm_separate_all(&s.whole, PIECES - 1, s.piece + 1, j, &rest) == VM_OK);
        check_rest("separate_all", &s, PIECES - 1, &rest, j, i);

        CHECK(vm_attach(&s.piece[0], &s.piece[1], j, &whole) == VM_OK);
        for (k = 0; k < 2; k++) {
            add_piece(&attached, 1, &s, k, &whole);
            add_piece(&attached, -1, &s, k, &s.piece[k]);
        }
        check_sums("attach", &attached, j, s.about, i);

        CHECK(vm_attach_all(&s.piece[0], PIECES - 1, s.piece + 1, j, &whole) == VM_OK);
        for (k = 0; k < PIECES; k++) add_piece(&all, -1, &s, k, &s.piece[k]);
        add_whole(&all, 1, &s, &whole);
        check_sums("attach_all", &all, j, s.about, i);
        check_error("attach_all: r", "particles", "eps", size_of(vmi_sub(whole.r, s.whole.r)) / 15 / eps, 12, i, 0);
    }
}

/* ---- Balances ---- */

/* What the balance of before (with other where it joined) and after (with other where it left) leaves, in eps of the
   scales: of K, and of L about the point */
typedef struct defect {
    double K, L, energy;
} defect;

static defect defect_of(int n_before, const vm_body *before, int n_after, const vm_body *after, const vm_impulse *j,
                        vm_vec3 about)
{
    vm_balance b;
    defect d = {1e99, 1e99, 1e99};
    if (vm_balance_between(n_before, before, n_after, after, j, about, &b)) return d;
    d.K = size_of(b.momentum) / (eps * (double)b.momentum_scale);
    d.L = size_of(b.angular_momentum) / (eps * (double)b.angular_momentum_scale);
    d.energy = (double)b.energy;
    return d;
}

static defect parted(const vm_body *whole, const vm_body *rest, const vm_body *part, const vm_impulse *j,
                     vm_vec3 about)
{
    vm_body after[2];
    after[0] = *rest;
    after[1] = *part;
    return defect_of(1, whole, 2, after, j, about);
}

static defect joined(const vm_body *a, const vm_body *b, const vm_body *whole, const vm_impulse *j, vm_vec3 about)
{
    vm_body before[2];
    before[0] = *a;
    before[1] = *b;
    return defect_of(2, before, 1, whole, j, about);
}

static void check_defect(const char *what, const char *region, defect d, double x)
{
    check_error(what, region, "eps K", d.K, 3, x, 0);
    check_error(what, region, "eps L", d.L, 6, x, 0);
}

/* Attachment, undone by the opposite impulse; then the separation of what was attached, with its own motion: both
   balances about random points, and the first body's place back. */
static void test_balance(int with_impulse)
{
    const char *region = with_impulse ? "with impulse" : "free";
    int i;
    for (i = 0; i < 3000; i++) {
        vm_body a = random_body(uniform(1, 10), 1), b = random_body(uniform(0.1, 5), 0.5), whole, rest, part;
        vm_impulse impulse = random_impulse(), back = opposite(impulse);
        const vm_impulse *j = with_impulse ? &impulse : NULL, *minus_j = with_impulse ? &back : NULL;
        vm_vec3 about = random_vector(4);
        b.r = vmi_add(a.r, random_vector(1));
        if (vm_attach(&a, &b, j, &whole)) FAIL("attach");
        check_defect("attach", region, joined(&a, &b, &whole, j, about), i);
        if (vm_separate(&whole, &b, minus_j, &rest)) FAIL("separate"); /* the opposite impulse there undoes it */
        check_error("undone: v", region, "eps", size_of(vmi_sub(rest.v, a.v)) / eps, 60, i, 0);

        part = b;
        part.omega = random_vector(3);
        part.v = random_vector(5);
        if (vm_separate(&whole, &part, j, &rest)) FAIL("separate");
        check_defect("separate", region, parted(&whole, &rest, &part, j, about), i);
        check_error("rest: r", region, "eps", size_of(vmi_sub(rest.r, a.r)) / eps, 16, i, 0);
    }
}

/* The whole's kinetic energy before and after, with n pieces apart, from the bodies and from the theorem. Rounding
   errors of omega cost energy by the angular momentum: |omega| |L| is the size. */
static void check_energy(const char *what, const char *region, const vm_body *whole, int n, const vm_body *pieces,
                         double difference, double theorem, double index)
{
    double size = 0, trace;
    int i;
    for (i = -1; i < n; i++) {
        const vm_body *b = i < 0 ? whole : pieces + i;
        trace = (double)vmi_trace(&b->inertia);
        size += (double)b->mass * size_of(b->v) * size_of(b->v) +
                trace * size_of(b->omega) * (size_of(b->omega) + size_of(whole->omega));
    }
    check_error(what, region, "eps", fabs(difference - theorem) / eps / size, 2, index, n);
}

/* Carnot's loss of an attachment and the gain (113), (118) of a separation, of one piece and of several, with the
   work of an impulse and without */
static void test_energy(int with_impulse)
{
    const char *region = with_impulse ? "with impulse" : "free";
    const vm_vec3 origin = vector(0, 0, 0);
    int i, k;
    for (i = 0; i < 2000; i++) {
        vm_body pieces[4], whole;
        vm_impulse impulse = random_impulse();
        const vm_impulse *j = with_impulse ? &impulse : NULL;
        int n = 1 + i % 3;
        for (k = 0; k <= n; k++) {
            pieces[k] = random_body(uniform(1, 5), 1);
            pieces[k].r = vmi_add(pieces[0].r, random_vector(2));
        }
        if (vm_attach_all(pieces, n, pieces + 1, j, &whole)) FAIL("attach_all");
        check_energy("loss (Carnot)", region, &whole, n + 1, pieces,
                     -defect_of(n + 1, pieces, 1, &whole, j, origin).energy,
                     (double)vm_energy_loss(pieces, n, pieces + 1, j, &whole), i);
        for (k = 1; k <= n; k++) {
            pieces[k].v = random_vector(5);
            pieces[k].omega = random_vector(3);
        }
        if (vm_separate_all(&whole, n, pieces + 1, j, pieces)) FAIL("separate_all");
        check_energy("gain (118)", region, &whole, n + 1, pieces,
                     defect_of(1, &whole, n + 1, pieces, j, origin).energy,
                     (double)vm_energy_gain(&whole, n, pieces + 1, j, pieces), i);
    }
}

/* Masses up to 1e4 and sizes up to 100 apart, thin ones among them: joined, then parted with another motion */
static void test_unequal_bodies(void)
{
    int i, balanced = 0, done = 1;
    for (i = 0; i < 20000; i++) {
        double ratio = pow(10, uniform(-4, 4));
        vm_body a = random_body(1, pow(10, uniform(-1, 1))), b = random_body(ratio, pow(10, uniform(-1, 1))), whole,
                rest;
        vm_vec3 about = random_vector(4);
        int status;
        b.r = vmi_add(a.r, random_vector(1));
        if (i % 4 == 0) a.inertia = vmi_inertia_plus(rod(2, random_vector(1)).inertia, R(1e-4), a.inertia);
        done = done && vm_attach(&a, &b, NULL, &whole) >= 0;
        check_defect("attach", "unequal", joined(&a, &b, &whole, NULL, about), ratio);
        b.omega = vmi_add(b.omega, random_vector(1));
        b.v = vmi_add(b.v, random_vector(1));
        status = vm_separate(&whole, &b, NULL, &rest);
        done = done && status >= 0;
        if (status) continue; /* in float a rest of 1e-4 the mass and size is lost in the whole's rounding errors */
        balanced++;
        check_defect("separate", "unequal", parted(&whole, &rest, &b, NULL, about), ratio);
    }
    CHECK(done && balanced > (is_float ? 15000 : 19990));
}

/* Fast bodies, far from the origin, and points next to one of them, where its momentum has hardly an arm: an eps
   of its position is then more than all the rest, and belongs to the scale. Sizes are 0.01 to 1 m. */
static void test_points_beside_bodies(void)
{
    const double farthest = is_float ? 2 : 6; /* 100 m, 1000 km: beyond, an eps of the positions changes the inertia */
    int i, done = 0;
    for (i = 0; i < 20000; i++) {
        vm_body a = random_body(uniform(1, 10), 1), b = random_body(pow(10, uniform(-3, 1)), pow(10, uniform(-2, 0)));
        vm_body whole, rest;
        vm_impulse impulse = random_impulse();
        const vm_impulse *j = i % 2 ? &impulse : NULL;
        vm_vec3 about;
        a.r = random_vector(pow(10, uniform(-1, farthest)));
        b.r = vmi_add(a.r, random_vector(1));
        a.v = random_vector(pow(10, uniform(-3, 6)));
        b.v = random_vector(pow(10, uniform(-3, 6)));
        impulse.at = vmi_add(a.r, random_vector(1));
        if (vm_attach(&a, &b, j, &whole)) continue;
        about = i % 3 == 0 ? a.r : i % 3 == 1 ? b.r : vmi_add(whole.r, random_vector(pow(10, uniform(-6, 0))));
        check_defect("attach", "beside bodies", joined(&a, &b, &whole, j, about), i);
        b.v = random_vector(pow(10, uniform(-3, 6)));
        b.omega = random_vector(3);
        if (vm_separate(&whole, &b, j, &rest)) continue;
        check_defect("separate", "beside bodies", parted(&whole, &rest, &b, j, about), i);
        done++;
    }
    CHECK(done > 19900);
}

/* Masses of any ratio, in either order */
static void test_mass_ratios(void)
{
    double ratio;
    for (ratio = is_float ? 1e-8 : 1e-14; ratio < (is_float ? 1e9 : 1e15); ratio *= 7) {
        vm_body a = random_body(1, 1), b = random_body(ratio, 1), whole;
        vm_vec3 about = vector(0, 0, 0);
        CHECK(vm_attach(&a, &b, NULL, &whole) >= 0);
        check_defect("attach", "mass ratios", joined(&a, &b, &whole, NULL, about), ratio);
        CHECK(vm_attach(&b, &a, NULL, &whole) >= 0);
        check_defect("attach", "mass ratios", joined(&a, &b, &whole, NULL, about), ratio);
    }
}

/* Numbers that can be summed in the head: body 2 kg at 10 N s, 4 m from the origin and 2 m from the point; impulse
   2 N s, 1 m and 3 m from them */
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

/* ---- Several parts at once ---- */

static double apart(const vm_body *a, const vm_body *b)
{
    double moved = size_of(vmi_sub(a->v, b->v)) / (5 + size_of(b->v));
    double turned = size_of(vmi_sub(a->omega, b->omega)) / (5 + size_of(b->omega));
    double shifted = size_of(vmi_sub(a->r, b->r)) / (5 + size_of(b->r));
    return fmax(fmax(moved, turned), fmax(shifted, fabs((double)(a->mass / b->mass - 1)))) / eps;
}

/* A burst is what comes of its parts one after another, in either order, wherever the impulse falls among them */
static void test_burst(void)
{
    enum { N = 5 };
    int i, k;
    for (i = 0; i < 1000; i++) {
        vm_body parts[N], core = random_body(5, 1), whole, one = core, at_once, last;
        vm_impulse impulse = random_impulse(), *j = i % 2 ? &impulse : NULL;
        int struck = i % N; /* the impulse comes with this part */
        for (k = 0; k < N; k++) {
            parts[k] = random_body(uniform(0.1, 3), 1);
            parts[k].r = vmi_add(core.r, random_vector(2));
        }
        CHECK(vm_attach_all(&core, N, parts, j, &whole) == VM_OK);
        for (k = 0; k < N; k++) CHECK(vm_attach(&one, &parts[k], k == struck ? j : NULL, &one) == VM_OK);
        check_error("attach_all", "one by one", "eps", apart(&whole, &one), 24, i, 0);
        for (k = 0; k < N; k++) {
            parts[k].v = random_vector(5);
            parts[k].omega = random_vector(3);
        }
        CHECK(vm_separate_all(&whole, N, parts, j, &at_once) == VM_OK);
        for (one = whole, k = 0; k < N; k++)
            CHECK(vm_separate(&one, &parts[k], k == struck ? j : NULL, &one) == VM_OK);
        check_error("separate_all", "one by one", "eps", apart(&at_once, &one), 600, i, 0);
        for (one = whole, k = N - 1; k >= 0; k--)
            CHECK(vm_separate(&one, &parts[k], k == struck ? j : NULL, &one) == VM_OK);
        check_error("separate_all", "one by one", "eps", apart(&at_once, &one), 600, i, 1);
        last = parts[N - 1]; /* an output may be one of the inputs */
        CHECK(vm_separate_all(&whole, N, parts, j, &parts[N - 1]) == VM_OK &&
              memcmp(&parts[N - 1], &at_once, sizeof last) == 0);
    }
}

/* Without parts a blow: v + J/M, and I (omega1 - omega) = the moment about S */
static void test_blow(void)
{
    vm_body b = random_body(3, 1), struck, plain;
    vm_impulse j = random_impulse();
    CHECK(vm_separate_all(&b, 0, NULL, &j, &struck) == VM_OK && vm_attach_all(&b, 0, NULL, &j, &plain) == VM_OK);
    CHECK(memcmp(&struck, &plain, sizeof plain) == 0 && struck.mass == b.mass);
    check_defect("blow", "with impulse", defect_of(1, &b, 1, &struck, &j, random_vector(3)), 0);
    CHECK(vm_separate_all(&b, 0, NULL, NULL, &struck) == VM_OK && apart(&struck, &b) == 0);
}

/* ---- Relative motion ---- */

/* There and back; and the jump in relative motions is the jump, in space and for either sign */
static void test_relative(void)
{
    int i;
    for (i = 0; i < 1000; i++) {
        vm_body a = random_body(4, 1), b = random_body(1.5, 0.5), whole, rest, part, relative, back;
        vm_impulse impulse = random_impulse(), *j = i % 2 ? &impulse : NULL;
        b.r = vmi_add(a.r, random_vector(1));
        CHECK(vm_attach(&a, &b, j, &whole) == VM_OK);
        CHECK(vm_to_relative(&a, &b, &relative) == VM_OK && vm_to_absolute(&a, &relative, &back) == VM_OK);
        check_error("relative", "there and back", "eps", apart(&back, &b), 4, i, 0);
        CHECK(vm_attach_relative(&a, &relative, j, &rest) == VM_OK && vm_to_absolute(&a, &rest, &rest) == VM_OK);
        check_error("attach_relative", "space", "eps", apart(&rest, &whole), 12, i, 0);

        part = b;
        part.v = random_vector(5);
        part.omega = random_vector(3);
        CHECK(vm_separate(&whole, &part, j, &rest) == VM_OK && vm_to_relative(&whole, &part, &relative) == VM_OK);
        CHECK(vm_separate_relative(&whole, &relative, j, &back) == VM_OK);
        CHECK(vm_to_absolute(&whole, &back, &back) == VM_OK);
        check_error("separate_relative", "space", "eps", apart(&back, &rest), 12, i, 0);
    }
}

/* ---- Inverse questions ---- */

/* The part that leaves as vm_separation_for_rest says leaves the rest with the motion asked for */
static void test_inverse(void)
{
    int i;
    for (i = 0; i < 1000; i++) {
        vm_body a = random_body(4, 1), b = random_body(1.5, 0.5), whole, rest, moving;
        vm_impulse impulse = random_impulse(), *j = i % 2 ? &impulse : NULL;
        vm_vec3 v = random_vector(3), omega = random_vector(3);
        const vm_vec3 still = vector(0, 0, 0);
        b.r = vmi_add(a.r, random_vector(1));
        CHECK(vm_attach(&a, &b, NULL, &whole) == VM_OK);
        if (i % 3 == 0) v = omega = still;   /* at rest */
        if (i % 3 == 1) omega = whole.omega; /* turning as before */
        CHECK(vm_separation_for_rest(&whole, &b, j, &v, &omega, &moving) == VM_OK);
        CHECK(vm_separate(&whole, &moving, j, &rest) == VM_OK);
        check_error("separate_for: v", "space", "eps", size_of(vmi_sub(rest.v, v)) / eps, 30, i, 0);
        check_error("separate_for: w", "space", "eps",
                    size_of(vmi_sub(rest.omega, omega)) / eps / (1 + size_of(moving.omega)), 20, i, 0);
        CHECK(vm_separation_for_rest(&whole, &b, j, NULL, &omega, &moving) == VM_OK &&
              size_of(vmi_sub(moving.v, b.v)) == 0);
        CHECK(vm_separate(&whole, &moving, j, &rest) == VM_OK);
        check_error("separate_for: w", "space", "eps",
                    size_of(vmi_sub(rest.omega, omega)) / eps / (1 + size_of(moving.omega)), 20, i, 1);
        CHECK(vm_separation_for_rest(&whole, &b, j, &v, NULL, &moving) == VM_OK);
        CHECK(size_of(vmi_sub(moving.omega, b.omega)) == 0);
        CHECK(vm_separation_for_rest(&whole, &b, j, NULL, NULL, &moving) == VM_OK && apart(&moving, &b) == 0);
    }
    { /* a point cannot be given the spin that would stop the rest, but for one that need not stop */
        vm_body whole = random_body(4, 1), point = rod(1, vector(1, 0, 0)), moving;
        vm_vec3 still = vector(0, 0, 0);
        point.r = vmi_add(whole.r, vector(0.01, 0, 0));
        point.v = whole.v;
        CHECK(vm_separation_for_rest(&whole, &point, NULL, NULL, &still, &moving) == VM_NULL_AXIS);
        point.v = vmi_add(whole.v, vmi_cross(whole.omega, vmi_sub(point.r, whole.r)));
        CHECK(vm_separation_for_rest(&whole, &point, NULL, NULL, &whole.omega, &moving) == VM_OK);
    }
}

/* ---- In the plane ---- */

static vm_body2 random_body2(double mass)
{
    vm_body2 b;
    b.mass = R(mass);
    b.inertia = R(mass * uniform(0.05, 0.5));
    b.angle = R(uniform(-3, 3));
    b.x = R(uniform(-2, 2));
    b.y = R(uniform(-2, 2));
    b.vx = R(uniform(-3, 3));
    b.vy = R(uniform(-3, 3));
    b.omega = R(uniform(-3, 3));
    return b;
}

/* As a lamina in space, the jump of the plane is that of space */
static double apart2(const vm_body2 *got, const vm_body *in_space)
{
    vm_body b = vm_body_from_body2(got);
    double of_inertia = fabs((double)(got->inertia / in_space->inertia.zz - 1)) / eps;
    return fmax(apart(&b, in_space), of_inertia);
}

static vm_impulse2 random_impulse2(void)
{
    vm_impulse2 j;
    j.jx = R(uniform(-3, 3));
    j.jy = R(uniform(-3, 3));
    j.couple = R(uniform(-3, 3));
    j.x = R(uniform(-3, 3));
    j.y = R(uniform(-3, 3));
    return j;
}

static vm_impulse impulse_in_space(const vm_impulse2 *j)
{
    vm_impulse blow;
    blow.linear = vmi_vec3(j->jx, j->jy, 0);
    blow.couple = vmi_vec3(0, 0, j->couple);
    blow.at = vmi_vec3(j->x, j->y, 0);
    return blow;
}

/* Momenta, energy and jumps, absolute and relative, are those of the laminas in space */
static void test_plane(void)
{
    int i;
    for (i = 0; i < 1000; i++) {
        vm_body2 a = random_body2(uniform(1, 5)), b = random_body2(uniform(0.5, 3)), whole, rest, moving;
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
        CHECK(vm_to_relative2(&a, &b, &rest) == VM_OK && vm_attach_relative2(&a, &rest, j, &moving) == VM_OK);
        CHECK(vm_to_absolute2(&a, &moving, &rest) == VM_OK);
        check_error("attach_relative2", "as in space", "eps", apart2(&rest, &joined_in_space), 12, i, 0);
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

/* Joined at once is joined one by one; parted at once undoes it, but for rounding errors of the whole's inertia.
   These bounds and those of the inverse questions are some 3 times the worst of 15 seeds. */
static void test_plane_burst(void)
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

/* The rest of what the inverse questions answer moves as asked for. A part that has to be fast brings the rounding
   errors of its momentum into the rest's: the errors are counted in those of the part's motion. */
static void test_plane_inverse(void)
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

/* A point of the plane keeps the whole's spin */
static void test_plane_point(void)
{
    vm_body2 whole = {2, 2, 0, 0, 0, 1, 2, 3}, part = {1, 0, 1, 0, 0, 1, 5, 0}, rest; /* at v + Omega x SS2 */
    CHECK(vm_separate2(&whole, &part, NULL, &rest) == VM_OK);
    CHECK(rest.inertia == 0 && rest.omega == 3 && rest.x == -1 && rest.vx == 1 && rest.vy == -1);
    part.vy = 6;
    CHECK(vm_separate2(&whole, &part, NULL, &rest) == VM_NULL_AXIS && rest.omega == 3);
    part.x = 0;
    CHECK(vm_separation_for_spin2(&whole, &part, NULL, 0, &rest) == VM_SINGULAR);
    CHECK(vm_separation_for_rest2(&whole, &part, NULL, NULL, &part.omega, &rest) == VM_NULL_AXIS);
}

/* The spin that a small point leaves can be had again by its motion, also where it differs from the whole's by less
   than what the wanted spin is rounded to and more than the point's moment of momentum is */
static void test_plane_point_again(void)
{
    int i;
    for (i = 0; i < 1000; i++) {
        vm_body2 whole = random_body2(uniform(2, 5)), point = whole, rest, moving;
        vm_real v[2], omega;
        double fast;
        whole.inertia = R(uniform(1, 3));
        whole.omega = R(uniform(5, 50));
        point.mass = R(pow(10, uniform(-6, -1)));
        point.inertia = 0;
        point.x = whole.x + R(uniform(0.2, 0.5));
        point.y = whole.y + R(uniform(0.2, 0.5));
        point.vx -= whole.omega * (point.y - whole.y);
        point.vy += whole.omega * (point.x - whole.x);
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
        fast = 1 + hypot((double)point.vx, (double)point.vy) +
               hypot((double)v[0], (double)v[1]) / (double)point.mass;
        check_error("separate_for2: v", "a point", "eps",
                    hypot((double)(moving.vx - point.vx), (double)(moving.vy - point.vy)) / eps / fast, 10, i, 0);
    }
}

/* Two points, one of which leaves: rounding errors of the inertia must neither be taken for that of the other, which
   would spin anyhow, nor for one that no body has */
static void test_plane_nothing_left(void)
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

/* ---- Hard cases: each names what would go wrong ---- */

/* m to 0: the whole goes on, the part's kick goes with m/M; a difference of momenta must not grow by 1/m */
static void test_small_part(void)
{
    double m;
    for (m = 1; m > (is_float ? 1e-30 : 1e-290); m *= 1e-3) {
        vm_body body = random_body(10, 1), part = random_body(m, 0.5), whole, rest;
        part.r = vmi_add(body.r, random_vector(0.5));
        CHECK(vm_attach(&body, &part, NULL, &whole) == VM_OK);
        part.v = random_vector(5);
        part.omega = random_vector(3);
        CHECK(vm_separate(&whole, &part, NULL, &rest) == VM_OK);
        check_defect("separate", "m to 0", parted(&whole, &rest, &part, NULL, random_vector(3)), m);
        check_error("rest - whole", "m to 0", "eps", apart(&rest, &whole) / (1 + m / 10 / eps), 12, m, 0);
    }
}

/* m to M: the rest is a share f of the whole; with the part leaving as it moved the rest moves on too, however much
   rounding has taken from its inertia; kicked, it keeps the balances or says that it cannot */
static void test_small_rest(void)
{
    double f;
    int kept = 0, lost = 0;
    for (f = 0.5; f > 4 * eps; f /= 3) {
        vm_body body = random_body(1, 1), left = random_body(f, 1), whole, rest;
        vm_vec3 about = random_vector(3);
        int status;
        left.q = body.q;
        left.r = vmi_add(body.r, random_vector(0.3));
        CHECK(vm_attach(&body, &left, NULL, &whole) == VM_OK);
        body.omega = whole.omega;
        body.v = vmi_add(whole.v, vmi_cross(whole.omega, vmi_sub(body.r, whole.r)));
        CHECK(vm_separate(&whole, &body, NULL, &rest) >= 0);
        /* v of the part is rounded, and that rounding is the rest's kick, M/f and M/I times */
        check_error(
            "carried: v", "m to M", "eps/f",
            f * size_of(vmi_sub(rest.v, vmi_add(whole.v, vmi_cross(whole.omega, vmi_sub(rest.r, whole.r))))) / eps,
            30, f, 0);
        check_error("carried: mass", "m to M", "eps/f", f * fabs((double)rest.mass / f - 1) / eps, 2, f, 0);
        body.v = random_vector(5);
        body.omega = random_vector(3);
        status = vm_separate(&whole, &body, NULL, &rest);
        CHECK(status >= 0);
        if (status == VM_OK) {
            kept++;
            check_defect("separate", "m to M", parted(&whole, &rest, &body, NULL, about), f);
        } else {
            lost++;
            check_error("separate", "m to M, lost", "eps K", parted(&whole, &rest, &body, NULL, about).K, 3, f, 0);
        }
    }
    CHECK(kept > (is_float ? 5 : 20) && lost > 0);
}

/* I_S1 without a digit: the part carries all of the inertia but 1e-3 to eps/10 of it. (34) as it stands divides the
   whole's rounding errors by I_S1; in relative motions the part that moves on as before leaves the rest at Omega. */
static void test_lost_inertia(void)
{
    double own, worst_printed = 0;
    for (own = 1e-3; own > eps / 10; own /= 3) {
        vm_body heavy = random_body(5, 1), whole, part, rest, slow = heavy;
        vm_inertia ball = {0, 0, 0, 0, 0, 0};
        double printed;
        ball.xx = ball.yy = ball.zz = R(own);
        heavy.r = vector(0, 0, 0);
        slow = heavy;
        slow.mass = 2;
        slow.inertia = ball;
        CHECK(vm_attach(&heavy, &slow, NULL, &whole) == VM_OK);
        part = heavy;
        part.omega = whole.omega;
        part.v = whole.v;
        CHECK(vm_separate(&whole, &part, NULL, &rest) == VM_OK);
        check_error("omega kept", "I_S1 lost", "eps", size_of(vmi_sub(rest.omega, whole.omega)) / eps, 1, own, 0);
        check_error("I_S1", "I_S1 lost", "eps",
                    fabs((double)(rest.inertia.xx - ball.xx)) / eps / (double)vmi_trace(&whole.inertia), 8, own, 0);
        /* |I_S O - I_S2 O| against I_S1 O: the products are rounded apart */
        printed = size_of(vmi_sub(vmi_sub(vmi_spin_momentum(&whole), vmi_spin_momentum(&part)),
                                  vmi_scale(R(own), whole.omega))) /
                  own / size_of(whole.omega);
        worst_printed = fmax(worst_printed, printed);
        {
            vm_body2 large = random_body2(5), small = large, both, left;
            small.mass = 2;
            small.inertia = R(own);
            CHECK(vm_attach2(&large, &small, NULL, &both) == VM_OK);
            large.omega = both.omega;
            large.vx = both.vx;
            large.vy = both.vy;
            CHECK(vm_separate2(&both, &large, NULL, &left) == VM_OK && left.omega == both.omega);
        }
    }
    CHECK(worst_printed > 0.5);
}

/* Far from the origin at high speed: place and velocity that all share must not cost a digit of the spin, nor of the
   relative velocities. The offsets are powers of two, so that the inputs are exact. */
static void test_far_and_fast(void)
{
    const double far = is_float ? 4096 : 1073741824., fast = is_float ? 512 : 16384; /* 1e9 m, 1e4 m/s */
    const double grain = is_float ? 1. / 256 : 1. / 1048576;
    double lost = 0;
    int i;
    for (i = 0; i < 300; i++) {
        vm_body whole = random_body(5, 1), part = random_body(1, 0.2), far_whole, far_part, rest, far_rest;
        vm_impulse impulse = random_impulse(), far_impulse, *j = i % 2 ? &impulse : NULL;
        vm_vec3 there = vector(far, -far, 0.5 * far), rush = vector(fast, 0.5 * fast, -fast);
        whole.r = whole.v = vector(0, 0, 0);
        part.r = vector(floor(uniform(-.2, .2) / grain) * grain, floor(uniform(-.2, .2) / grain) * grain, 0);
        part.v = vector(floor(uniform(-3, 3) / grain) * grain, 0, floor(uniform(-3, 3) / grain) * grain);
        impulse.at = vector(floor(uniform(-1, 1) / grain) * grain, 0, floor(uniform(-1, 1) / grain) * grain);
        whole.inertia.xx += 1;
        whole.inertia.yy += 1;
        whole.inertia.zz += 1;
        far_whole = whole;
        far_part = part;
        far_impulse = impulse;
        far_whole.r = there;
        far_part.r = vmi_add(part.r, there);
        far_impulse.at = vmi_add(impulse.at, there);
        far_whole.v = rush;
        far_part.v = vmi_add(part.v, rush);
        CHECK(vm_separate(&whole, &part, j, &rest) == VM_OK);
        CHECK(vm_separate(&far_whole, &far_part, j ? &far_impulse : NULL, &far_rest) == VM_OK);
        check_error("separate: omega", "far and fast", "eps", size_of(vmi_sub(far_rest.omega, rest.omega)) / eps, 1,
                    i, 0);
        check_error("separate: v", "far and fast", "eps",
                    size_of(vmi_sub(vmi_sub(far_rest.v, rush), rest.v)) / eps / fast, 3, i, 0);
        if (!j) { /* free, the gain is the same; the difference of the energies has lost it in M v^2 */
            double gain = (double)vm_energy_gain(&whole, 1, &part, NULL, &rest), difference;
            difference = parted(&far_whole, &far_rest, &far_part, NULL, there).energy;
            lost = fmax(lost, fabs(difference / gain - 1) / eps);
            check_error("energy gain", "far and fast", "eps",
                        fabs((double)vm_energy_gain(&far_whole, 1, &far_part, NULL, &far_rest) / gain - 1) / eps /
                            fast,
                        12, i, 0);
        }
        CHECK(vm_attach(&whole, &part, j, &rest) == VM_OK);
        CHECK(vm_attach(&far_whole, &far_part, j ? &far_impulse : NULL, &far_rest) == VM_OK);
        check_error("attach: omega", "far and fast", "eps", size_of(vmi_sub(far_rest.omega, rest.omega)) / eps, 1,
                    i, 0);
    }
    CHECK(lost > 1000 * fast);
}

/* A light body, fast and spinning, joins a heavy one at rest, whichever is named first: the result's small velocities
   are right to some eps of themselves, not of the light one's */
static void test_light_on_heavy(void)
{
    const vm_inertia ball = {1, 1, 1, 0, 0, 0};
    double m;
    for (m = 1; m > (is_float ? 1e-20 : 1e-40); m /= 10) {
        vm_body light = random_body(1, 1), heavy = random_body(1, 1), whole;
        int i;
        light.mass = R(m);
        light.inertia = vmi_inertia_plus(vmi_inertia_of_point(vector(0, 0, 0)), R(m), ball);
        heavy.mass = 1;
        heavy.inertia = ball;
        light.r = heavy.r = heavy.v = heavy.omega = vector(0, 0, 0);
        light.v = vector(1e4, 0, 0);
        light.omega = vector(0, 1e4, 0);
        light.q = heavy.q = vmi_quat_times(light.q, heavy.q);
        for (i = 0; i < 2; i++) {
            double to = 1e4 * (double)light.mass / (1 + (double)light.mass);
            CHECK((i ? vm_attach(&light, &heavy, NULL, &whole) : vm_attach(&heavy, &light, NULL, &whole)) == VM_OK);
            check_error("attach: v", "light on heavy", "eps", fabs((double)whole.v.x / to - 1) / eps, 4, m, i);
            check_error("attach: omega", "light on heavy", "eps", fabs((double)whole.omega.y / to - 1) / eps, 16, m,
                        i);
        }
    }
}

/* Principal moments equal to some eps: no axis of theirs may be trusted, none is needed */
static void test_nearly_equal_moments(void)
{
    int i;
    for (i = 0; i < 600; i++) {
        vm_body a = random_body(3, 1), b = random_body(1, 0.5), whole, rest, part;
        double off = pow(10, uniform(is_float ? -9 : -18, -3));
        a.inertia = inertia(1, uniform(-off, off), uniform(-off, off), 1 + uniform(-off, off), uniform(-off, off),
                            1 + uniform(-off, off));
        b.inertia = vmi_inertia_plus(a.inertia, R(-0.9), a.inertia);
        b.r = i % 2 ? a.r : vmi_add(a.r, random_vector(off));
        CHECK(vm_attach(&a, &b, NULL, &whole) == VM_OK);
        check_defect("attach", "equal moments", joined(&a, &b, &whole, NULL, a.r), off);
        part = b;
        part.omega = random_vector(3);
        part.v = random_vector(3);
        CHECK(vm_separate(&whole, &part, NULL, &rest) == VM_OK);
        check_defect("separate", "equal moments", parted(&whole, &rest, &part, NULL, a.r), off);
        check_error("rest: I", "equal moments", "eps",
                    fabs((double)(rest.inertia.xx - a.inertia.xx)) / eps +
                        fabs((double)(rest.inertia.xy - a.inertia.xy)) / eps,
                    16, off, 0);
    }
}

/* Points and rods in general position: the spin about an axis without inertia stays the first body's, the rest of the
   motion balances, and what comes out can be used again. */
static void test_null_axes(void)
{
    int i;
    for (i = 0; i < 500; i++) {
        vm_body a = random_body(3, 1), point = rod(1, vector(1, 0, 0)), pair = point, whole, rest, again;
        vm_vec3 axis = random_vector(1), before;
        point.r = vmi_add(a.r, axis);
        point.v = random_vector(2);
        point.omega = random_vector(2);
        CHECK(vm_attach(&a, &point, NULL, &whole) == VM_OK);
        a.omega = whole.omega;
        a.v = vmi_add(whole.v, vmi_cross(whole.omega, vmi_sub(a.r, whole.r)));
        CHECK(vm_separate(&whole, &a, NULL, &rest) == VM_OK); /* moving on as before: the point is left */
        CHECK(rest.inertia.xx == 0 && rest.inertia.yy == 0 && rest.inertia.zz == 0 && rest.inertia.xy == 0);
        check_error("point: spin kept", "null axes", "eps", size_of(vmi_sub(rest.omega, whole.omega)) / eps, 60, i,
                    0);
        CHECK(vm_attach(&rest, &a, NULL, &again) == VM_OK && vm_attach(&a, &rest, NULL, &again) == VM_OK);
        a.omega = random_vector(3); /* with another spin angular momentum is left that a point cannot have */
        CHECK(vm_separate(&whole, &a, NULL, &rest) == VM_NULL_AXIS && VM_NULL_AXIS > 0);

        pair.q.x = R(0.6);
        pair.q.w = R(0.8);
        pair.omega = random_vector(2);
        CHECK(vm_attach(&pair, &point, NULL, &whole) == VM_OK); /* two points: a rod */
        check_defect("attach", "two points", joined(&pair, &point, &whole, NULL, vector(0, 0, 0)), i);
        axis = vmi_sub(point.r, pair.r);
        before = pair.omega;
        check_error("rod: spin kept", "null axes", "eps",
                    fabs((double)vmi_dot(axis, vmi_sub(whole.omega, before))) / size_of(axis) / eps, 20, i, 0);
        CHECK(vm_separate(&whole, &point, NULL, &rest) >= 0 && vm_attach(&whole, &a, NULL, &again) == VM_OK);
    }
}

/* A blow at a point of a rod turns it about no axis that it lacks, a twist would: rounding errors, of places far away
   too, are told from twists. The same of points that leave a body of the plane as they moved. */
static void test_nothing_left(void)
{
    int i;
    for (i = 0; i < 1000; i++) {
        vm_vec3 e = random_vector(1);
        vm_body stick = rod(2, e), struck;
        vm_impulse j = random_impulse();
        vm_body2 whole = random_body2(3), point, moving;
        vm_real omega;
        stick.q = random_attitude();
        stick.r = random_vector(i % 2 ? 1 : 100);
        stick.v = random_vector(3);
        stick.omega = random_vector(3);
        {
            const vmi_mat3 turn = vmi_rotation(stick.q);
            e = vmi_times(&turn, e);
        }
        j.couple = vector(0, 0, 0);
        j.at = vmi_add(stick.r, vmi_scale(R(uniform(-1, 1)), e));
        CHECK(vm_attach_all(&stick, 0, NULL, &j, &struck) == VM_OK);
        j.couple = vmi_scale(R(1e4 * eps * (1 + size_of(j.linear)) * (1 + size_of(j.at)) / size_of(e)), e);
        CHECK(vm_attach_all(&stick, 0, NULL, &j, &struck) == VM_NULL_AXIS);

        point = whole;
        point.mass = 1;
        point.inertia = 0;
        point.x += R(uniform(-.1, .1));
        point.y += R(uniform(-.1, .1));
        point.vx -= whole.omega * (point.y - whole.y);
        point.vy += whole.omega * (point.x - whole.x);
        omega = whole.omega;
        CHECK(vm_separation_for_rest2(&whole, &point, NULL, NULL, &omega, &moving) == VM_OK);
        omega += R(1e-3);
        CHECK(vm_separation_for_rest2(&whole, &point, NULL, NULL, &omega, &moving) == VM_NULL_AXIS);
    }
}

/* The rounding errors of positions far from the origin make no rod impossible. */
static void far_from_the_origin(void)
{
    double R0;
    int i;
    for (R0 = 1; R0 < (is_float ? 1e5 : 1e12); R0 *= 10) {
        for (i = 0; i < 50; i++) {
            vm_body stick = rod(2, random_vector(0.5)), point = rod(1, vector(1, 0, 0)), whole, rest;
            stick.r = vmi_scale(R(R0), vector(0.3, 0.7, -0.11));
            stick.omega = random_vector(1);
            point.r = vmi_add(stick.r, random_vector(0.5));
            point.v = random_vector(1);
            int status = vm_attach(&stick, &point, NULL, &whole);
            CHECK(status >= 0 && vm_separate(&whole, &point, NULL, &rest) >= 0);
            if (status == VM_OK)
                check_defect("attach", "far away", joined(&stick, &point, &whole, NULL, vector(0, 0, 0)), R0);
        }
    }
}

/* Small moments are not mistaken for none where they are resolved, nor noise for moments. */
static void test_thin_bodies(void)
{
    vm_body a, b, whole;
    vm_impulse twist;
    int i;
    memset(&a, 0, sizeof a);
    a.mass = 1;
    a.inertia.xx = R(0.1) * VM_EPSILON;
    a.inertia.yy = a.inertia.zz = R(1. / 12); /* a needle along x */
    b = a;
    b.omega.x = 100;
    CHECK(vm_attach(&a, &b, NULL, &whole) == VM_OK && fabs((double)whole.omega.x - 50) < 1e-4);
    a.inertia.xx = a.inertia.yy = a.inertia.zz =
        1; /* balls far apart: their own inertia is below an eps of the whole's */
    b = a;
    a.omega.x = 1;
    b.omega.x = -3;
    b.r.x = 1 / VM_EPSILON;
    CHECK(vm_attach(&a, &b, NULL, &whole) == VM_OK && whole.inertia.xx == 2 && whole.omega.x == -1);
    for (i = 0; i < 3; i++) { /* collinear rods along x, y, z and a couple along and across them */
        vm_vec3 e = vector(i == 0, i == 1, i == 2);
        a = rod(2, e);
        b = a;
        b.r = vmi_scale(5, e);
        memset(&twist, 0, sizeof twist);
        twist.couple = e;
        CHECK(vm_attach(&a, &b, &twist, &whole) == VM_NULL_AXIS && size_of(whole.omega) == 0);
        twist.couple = vector(i == 1, i == 2, i == 0);
        CHECK(vm_attach(&a, &b, &twist, &whole) == VM_OK && size_of(whole.omega) < 0.2 && size_of(whole.omega) > 0);
    }
    far_from_the_origin();
    for (i = 0; i < 500; i++) { /* rods and plates in general position are possible bodies */
        vm_vec3 e = random_vector(1), f = random_vector(1);
        a = rod(2 + i % 3, e);
        if (i % 2) a.inertia = vmi_inertia_plus(a.inertia, 3, rod(2, f).inertia);
        b = random_body(1, 1);
        a.q = b.q;
        a.omega = random_vector(2);
        CHECK(vm_attach(&a, &b, NULL, &whole) == VM_OK);
        check_defect("attach", "rods and plates", joined(&a, &b, &whole, NULL, vector(0, 0, 0)), i);
    }
}

/* What no body has, about each axis, is refused, in the first body as in the second */
static void test_impossible(void)
{
    const double excess[] = {is_float ? 1e-4 : 1e-12, 1e-3, 1};
    vm_body good = random_body(3, 1), whole;
    int i, k;
    for (i = 0; i < 3; i++) {
        for (k = 0; k < 3; k++) {
            vm_body bad = good;
            double moment[3] = {1, 2, 3};
            moment[k] = moment[(k + 1) % 3] + moment[(k + 2) % 3] + excess[i];
            bad.inertia = vmi_inertia_plus(rod(1, vector(1, 0, 0)).inertia, 0, bad.inertia);
            bad.inertia.xx = R(moment[0]);
            bad.inertia.yy = R(moment[1]);
            bad.inertia.zz = R(moment[2]);
            CHECK(vm_attach(&good, &bad, NULL, &whole) == VM_BAD_INERTIA);
            CHECK(vm_attach(&bad, &good, NULL, &whole) == VM_BAD_INERTIA);
        }
    }
    good.q.y = VM_NAN;
    CHECK(vm_attach(&good, &good, NULL, &whole) == VM_NOT_FINITE);
}

/* A quaternion of any length */
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
                    size_of(vmi_sub(vm_angular_momentum(&b, vector(0, 0, 0)), L)) / size_of(L) / eps, 8, scale, 0);
    }
}

/* ---- Bad input ---- */

/* A body with room for any part, and a part of it */
static vm_body whole_and_part(vm_body *part)
{
    vm_body whole = random_body(5, 1);
    whole.inertia.xx += 1;
    whole.inertia.yy += 1;
    whole.inertia.zz += 1;
    *part = whole;
    part->mass = 1;
    part->inertia = vmi_inertia_plus(vmi_inertia_of_point(vector(0, 0, 0)), R(0.01),
                                     vmi_inertia_of_point(vector(1, 1, 1)));
    part->r = vmi_add(whole.r, vector(0.1, 0, 0));
    return whole;
}

static void test_jump_domain(void)
{
    vm_body part, whole = whole_and_part(&part), x = part, rest, before;
    memset(&rest, 7, sizeof rest);
    before = rest;
#define REFUSED(status, call) CHECK((call) == (status) && memcmp(&rest, &before, sizeof rest) == 0)
    x.mass = 6;
    REFUSED(VM_BAD_MASS, vm_separate(&whole, &x, NULL, &rest));
    x.mass = whole.mass;
    REFUSED(VM_BAD_MASS, vm_separate(&whole, &x, NULL, &rest));
    x.mass = -1;
    REFUSED(VM_BAD_MASS, vm_separate(&whole, &x, NULL, &rest));
    REFUSED(VM_BAD_MASS, vm_attach(&whole, &x, NULL, &rest));
    x.mass = 0;
    REFUSED(VM_BAD_MASS, vm_attach(&whole, &x, NULL, &rest));
    x = part;
    x.mass = VM_NAN;
    REFUSED(VM_NOT_FINITE, vm_attach(&whole, &x, NULL, &rest));
    x = part;
    x.omega.y = VM_INFINITY;
    REFUSED(VM_NOT_FINITE, vm_attach(&x, &whole, NULL, &rest));
    x = whole;
    x.v.z = VM_MAX;
    part.v.z = -VM_MAX; /* the momenta overflow */
    REFUSED(VM_NOT_FINITE, vm_attach(&x, &part, NULL, &rest));
    part.v = whole.v;
    x = part;
    x.inertia.xx = -1;
    REFUSED(VM_BAD_INERTIA, vm_separate(&whole, &x, NULL, &rest));
    x = part;
    x.inertia.xx = 1; /* 1 > 0.02 + 0.02 */
    REFUSED(VM_BAD_INERTIA, vm_attach(&whole, &x, NULL, &rest));
    x = part;
    x.inertia.xy = R(0.5); /* moments 0.02 +- 0.5 */
    REFUSED(VM_BAD_INERTIA, vm_attach(&whole, &x, NULL, &rest));
    x = part;
    x.r = vmi_add(whole.r, vector(20, 0, 0)); /* never was inside */
    REFUSED(VM_BAD_INERTIA, vm_separate(&whole, &x, NULL, &rest));
    REFUSED(VM_BAD_ARGUMENT, vm_separate(NULL, &part, NULL, &rest));
    REFUSED(VM_BAD_ARGUMENT, vm_attach(&whole, NULL, NULL, &rest));
    CHECK(vm_attach(&whole, &part, NULL, NULL) == VM_BAD_ARGUMENT);
#undef REFUSED
}

static void test_outputs_as_inputs(void)
{
    vm_body part, whole = whole_and_part(&part), x = whole, y = part, rest;
    CHECK(vm_attach(&whole, &part, NULL, &rest) == VM_OK && vm_attach(&x, &part, NULL, &x) == VM_OK);
    CHECK(memcmp(&x, &rest, sizeof x) == 0 && vm_attach(&whole, &y, NULL, &y) == VM_OK);
    CHECK(memcmp(&y, &rest, sizeof y) == 0);
    x = whole;
    y = part;
    CHECK(vm_to_relative(&whole, &part, &rest) == VM_OK && vm_to_relative(&x, &y, &x) == VM_OK);
    CHECK(memcmp(&x, &rest, sizeof x) == 0 && vm_to_relative(&whole, &y, &y) == VM_OK);
    CHECK(memcmp(&y, &rest, sizeof y) == 0);
    x = whole;
    y = part;
    CHECK(vm_separation_for_rest(&whole, &part, NULL, &part.v, &part.omega, &rest) >= 0);
    CHECK(vm_separation_for_rest(&x, &part, NULL, &part.v, &part.omega, &x) >= 0 && memcmp(&x, &rest, sizeof x) == 0);
    CHECK(vm_separation_for_rest(&whole, &y, NULL, &y.v, &y.omega, &y) >= 0 && memcmp(&y, &rest, sizeof y) == 0);
    CHECK(vm_separate(&whole, &part, NULL, &whole) == VM_OK && whole.mass == 4);
}

/* Two equal points on the x axis are a rod; one taken away leaves a point, whose spin stays the rod's */
static void test_rod_to_point(void)
{
    vm_body stick, part, rest;
    memset(&stick, 0, sizeof stick);
    stick.mass = 2;
    stick.inertia = vmi_inertia_plus(vmi_inertia_of_point(vector(0, 0, 0)), 2,
                                     vmi_inertia_of_point(vector(1, 0, 0)));
    stick.omega = vector(3, 0.5, -0.25);
    stick.v = vector(1, 2, 3);
    part = stick;
    part.mass = 1;
    part.r = vector(1, 0, 0);
    memset(&part.inertia, 0, sizeof part.inertia);
    part.v = vmi_add(stick.v, vmi_cross(stick.omega, part.r));
    CHECK(vm_separate(&stick, &part, NULL, &rest) == VM_OK);
    CHECK(size_of(vmi_sub(rest.omega, stick.omega)) == 0 && rest.r.x == -1 && rest.inertia.yy == 0);
    CHECK(size_of(vmi_sub(rest.v, vmi_add(stick.v, vmi_cross(stick.omega, vector(-1, 0, 0))))) == 0);
}

/* ---- Bad input: refused with the outputs as they were ---- */

static struct {
    vm_body a, b;
    vm_body2 a2, b2;
    vm_impulse j;
    vm_impulse2 j2;
    vm_inertia i;
} in;
static struct {
    vm_body body;
    vm_body2 body2;
    vm_balance sum;
    vm_inertia inertia;
    vm_vec3 centre;
} out, kept;

#define REFUSES(status, call) CHECK((call) == (status) && memcmp(&out, &kept, sizeof out) == 0)
#define REFUSES_NULL(call) REFUSES(VM_BAD_ARGUMENT, call)

static void prepare_refusals(void)
{
    const vm_impulse2 j2 = {1, 2, 3, 4, 5};
    in.a = random_body(3, 1);
    in.b = random_body(1, 1);
    in.a2 = random_body2(3);
    in.b2 = random_body2(1);
    in.i = in.a.inertia;
    in.j = random_impulse();
    in.j2 = j2;
    in.b.r = in.a.r;
    in.b2.x = in.a2.x + R(0.1);
    in.b2.y = in.a2.y;
    if (vm_attach(&in.a, &in.b, NULL, &in.a) || vm_attach2(&in.a2, &in.b2, NULL, &in.a2)) FAIL("attach");
    memset(&out, 7, sizeof out);
    memset(&kept, 7, sizeof kept);
}

/* Any member: the structs are nothing but numbers */
static void test_not_finite_member(vm_real bad)
{
    size_t k;
    for (k = 0; k < sizeof(vm_body) / sizeof(vm_real); k++) {
        vm_body x = in.b;
        ((vm_real *)(void *)&x)[k] = bad;
        REFUSES(VM_NOT_FINITE, vm_separate(&in.a, &x, NULL, &out.body));
        REFUSES(VM_NOT_FINITE, vm_attach(&x, &in.a, &in.j, &out.body));
        REFUSES(VM_NOT_FINITE, vm_separate_all(&in.a, 1, &x, NULL, &out.body));
        REFUSES(VM_NOT_FINITE, vm_attach_all(&x, 0, NULL, NULL, &out.body));
        REFUSES(VM_NOT_FINITE, vm_attach_relative(&in.a, &x, NULL, &out.body));
        REFUSES(VM_NOT_FINITE, vm_separation_for_rest(&in.a, &x, NULL, NULL, NULL, &out.body));
    }
    for (k = 0; k < sizeof(vm_impulse) / sizeof(vm_real); k++) {
        vm_impulse x = in.j;
        vm_body point = rod(1, vector(1, 0, 0));
        ((vm_real *)(void *)&x)[k] = bad;
        REFUSES(VM_NOT_FINITE, vm_attach(&in.a, &in.b, &x, &out.body));
        REFUSES(VM_NOT_FINITE, vm_attach_all(&point, 0, NULL, &x, &out.body));
        REFUSES(VM_NOT_FINITE, vm_separation_for_rest(&in.a, &in.b, &x, NULL, NULL, &out.body));
        REFUSES(VM_NOT_FINITE, vm_balance_between(1, &in.a, 1, &in.b, &x, in.a.r, &out.sum));
    }
}

static void test_not_finite_member2(vm_real bad)
{
    size_t k;
    for (k = 0; k < sizeof(vm_body2) / sizeof(vm_real); k++) {
        vm_body2 x = in.b2;
        ((vm_real *)(void *)&x)[k] = bad;
        REFUSES(VM_NOT_FINITE, vm_separate2(&in.a2, &x, NULL, &out.body2));
        REFUSES(VM_NOT_FINITE, vm_attach2(&x, &in.a2, NULL, &out.body2));
        REFUSES(VM_NOT_FINITE, vm_attach_all2(&in.a2, 1, &x, NULL, &out.body2));
        REFUSES(VM_NOT_FINITE, vm_separation_for_rest2(&in.a2, &x, NULL, NULL, NULL, &out.body2));
        REFUSES(VM_NOT_FINITE, vm_separation_for_spin2(&x, &in.b2, NULL, 0, &out.body2));
    }
    for (k = 0; k < sizeof(vm_impulse2) / sizeof(vm_real); k++) {
        vm_impulse2 x = in.j2;
        ((vm_real *)(void *)&x)[k] = bad;
        REFUSES(VM_NOT_FINITE, vm_attach2(&in.a2, &in.b2, &x, &out.body2));
    }
}

static void test_not_finite(vm_real bad)
{
    const vm_vec3 nowhere = vector(0, (double)bad, 0);
    vm_inertia i = in.i;
    test_not_finite_member(bad);
    test_not_finite_member2(bad);
    REFUSES(VM_NOT_FINITE, vm_separation_for_rest(&in.a, &in.b, NULL, &nowhere, NULL, &out.body));
    REFUSES(VM_NOT_FINITE, vm_separation_for_rest(&in.a, &in.b, NULL, NULL, &nowhere, &out.body));
    REFUSES(VM_NOT_FINITE, vm_separation_for_spin2(&in.a2, &in.b2, NULL, bad, &out.body2));
    REFUSES(VM_NOT_FINITE, vm_balance_between(1, &in.a, 1, &in.b, NULL, nowhere, &out.sum));
    REFUSES(VM_NOT_FINITE, vm_combine_inertia(1, &i, 1, &i, nowhere, &out.inertia, &out.centre));
    i.yz = bad;
    CHECK(!vm_inertia_possible(&i));
}

static void test_null(void)
{
    const vm_real wanted = 1;
    const vm_vec3 d = vector(1, 0, 0);
    REFUSES_NULL(vm_separate_all(&in.a, -1, &in.b, NULL, &out.body));
    REFUSES_NULL(vm_separate_all(&in.a, 1, NULL, NULL, &out.body));
    REFUSES_NULL(vm_attach_all(NULL, 1, &in.b, NULL, &out.body));
    REFUSES_NULL(vm_attach_relative(NULL, &in.b, NULL, &out.body));
    REFUSES_NULL(vm_separate_relative(&in.a, NULL, NULL, &out.body));
    REFUSES_NULL(vm_separation_for_rest(&in.a, NULL, NULL, NULL, NULL, &out.body));
    REFUSES_NULL(vm_separation_for_rest(NULL, &in.b, NULL, NULL, NULL, &out.body));
    REFUSES_NULL(vm_to_relative(&in.a, NULL, &out.body));
    REFUSES_NULL(vm_to_absolute(NULL, &in.b, &out.body));
    REFUSES_NULL(vm_separate2(NULL, &in.b2, NULL, &out.body2));
    REFUSES_NULL(vm_attach2(&in.a2, NULL, NULL, &out.body2));
    REFUSES_NULL(vm_attach_all2(&in.a2, -1, &in.b2, NULL, &out.body2));
    REFUSES_NULL(vm_separate_relative2(NULL, &in.b2, NULL, &out.body2));
    REFUSES_NULL(vm_attach_relative2(&in.a2, NULL, NULL, &out.body2));
    REFUSES_NULL(vm_to_relative2(NULL, &in.b2, &out.body2));
    REFUSES_NULL(vm_to_absolute2(&in.a2, NULL, &out.body2));
    REFUSES_NULL(vm_separation_for_rest2(&in.a2, NULL, NULL, NULL, &wanted, &out.body2));
    REFUSES_NULL(vm_separation_for_spin2(NULL, &in.b2, NULL, 1, &out.body2));
    REFUSES_NULL(vm_balance_between(-1, &in.a, 1, &in.b, NULL, d, &out.sum));
    REFUSES_NULL(vm_balance_between(1, NULL, 1, &in.b, NULL, d, &out.sum));
    REFUSES_NULL(vm_balance_between(1, &in.a, 1, NULL, NULL, d, &out.sum));
    REFUSES_NULL(vm_combine_inertia(1, NULL, 1, &in.i, d, &out.inertia, &out.centre));
    REFUSES_NULL(vm_split_inertia(2, &in.i, 1, &in.i, d, &out.inertia, NULL));
    CHECK(vm_separate_all(&in.a, 1, &in.b, NULL, NULL) == VM_BAD_ARGUMENT &&
          vm_to_relative(&in.a, &in.b, NULL) == VM_BAD_ARGUMENT);
    CHECK(vm_separate2(&in.a2, &in.b2, NULL, NULL) == VM_BAD_ARGUMENT &&
          vm_to_absolute2(&in.a2, &in.b2, NULL) == VM_BAD_ARGUMENT);
    CHECK(vm_balance_between(1, &in.a, 1, &in.b, NULL, d, NULL) == VM_BAD_ARGUMENT);
    CHECK(isnan(vm_momentum(NULL).y) && isnan(vm_angular_momentum(NULL, d).x) && isnan(vm_kinetic_energy(NULL)));
    CHECK(isnan(vm_angular_momentum2(NULL, 0, 0)) && isnan(vm_kinetic_energy2(NULL)) &&
          isnan(vm_body_from_body2(NULL).mass));
    CHECK(isnan(vm_energy_gain(&in.a, -1, &in.b, NULL, &in.b)) &&
          isnan(vm_energy_gain(&in.a, 1, NULL, NULL, &in.b)) && isnan(vm_energy_loss(NULL, 0, NULL, NULL, &in.b)));
    CHECK(vm_energy_gain(&in.a, 0, NULL, NULL, &in.a) == 0 && isnan(vm_energy_gain(NULL, 0, NULL, NULL, &in.b)));
    CHECK(isnan(vm_parallel_axes(NULL, 1, d).xx) && !vm_inertia_possible(NULL));
}

static void test_impossible_parts(void)
{
    const vm_real wanted[2] = {1, 2};
    const vm_vec3 d = vector(1, 0, 0);
    REFUSES(VM_BAD_MASS, vm_separate2(&in.b2, &in.a2, NULL, &out.body2));
    REFUSES(VM_BAD_MASS, vm_separate2(&in.b2, &in.b2, NULL, &out.body2)); /* the part is the whole */
    REFUSES(VM_BAD_MASS, vm_separate(&in.b, &in.b, NULL, &out.body));
    REFUSES(VM_BAD_MASS, vm_separate_relative2(&in.b2, &in.a2, NULL, &out.body2));
    REFUSES(VM_BAD_MASS, vm_split_inertia(1, &in.i, 1, &in.i, d, &out.inertia, &out.centre));
    in.b2.x = in.a2.x + 10;
    REFUSES(VM_BAD_INERTIA, vm_separate2(&in.a2, &in.b2, NULL, &out.body2)); /* it never was inside */
    REFUSES(VM_BAD_INERTIA, vm_separation_for_rest2(&in.a2, &in.b2, NULL, NULL, NULL, &out.body2));
    REFUSES(VM_BAD_INERTIA, vm_separation_for_spin2(&in.a2, &in.b2, NULL, 1, &out.body2));
    in.b2.inertia = -1;
    REFUSES(VM_BAD_INERTIA, vm_attach2(&in.a2, &in.b2, NULL, &out.body2));
    in.b.mass = in.b2.mass = 0; /* what the part's velocity would be divided by */
    REFUSES(VM_BAD_MASS, vm_separation_for_rest(&in.a, &in.b, NULL, &d, NULL, &out.body));
    REFUSES(VM_BAD_MASS, vm_separation_for_rest2(&in.a2, &in.b2, NULL, wanted, NULL, &out.body2));
    REFUSES(VM_BAD_MASS, vm_attach2(&in.a2, &in.b2, NULL, &out.body2));
}

static void test_bad_input(void)
{
    prepare_refusals();
    test_not_finite(VM_NAN);
    test_not_finite(VM_INFINITY);
    test_not_finite(-VM_INFINITY);
    test_null();
    test_impossible_parts();
}

/* ---- Inertia ---- */

/* (13)-(15), (40): combining and splitting undo each other and are the sums over particles; what is possible */
static void test_inertia(void)
{
    const vm_inertia point = {0, 0, 0, 0, 0, 0}, needle = {0, 1, 1, 0, 0, 0}, plate = {1, 2, 3, 0, 0, 0};
    vm_inertia bent = {1, 2, 3, 0, 0, 0};
    int i;
    for (i = 0; i < 500; i++) {
        vm_body a = random_body(uniform(1, 4), 1), b = random_body(uniform(1, 4), 1);
        vm_vec3 d = random_vector(2), centre, back;
        vm_inertia whole, rest, about_a, own;
        vm_real m = b.mass / (a.mass + b.mass);
        if (vm_combine_inertia(a.mass, &a.inertia, b.mass, &b.inertia, d, &whole, &centre)) {
            FAIL("combine");
            continue;
        }
        check_error("centre (15)", "", "eps", size_of(vmi_sub(centre, vmi_scale(m, d))) / eps, 4, i, 0);
        /* about a's mass centre the inertias add up (40) */
        about_a = vmi_inertia_plus(a.inertia, 1, vm_parallel_axes(&b.inertia, b.mass, d));
        own = vm_parallel_axes(&about_a, -(a.mass + b.mass), centre);
        check_error("combined (40)", "", "eps",
                    (fabs((double)(own.xx - whole.xx)) + fabs((double)(own.yz - whole.yz))) / eps /
                        (double)vmi_trace(&about_a),
                    4, i, 0);
        if (vm_split_inertia(a.mass + b.mass, &whole, b.mass, &b.inertia, vmi_sub(d, centre), &rest, &back)) {
            FAIL("split");
            continue;
        }
        check_error("split", "", "eps",
                    (fabs((double)(rest.xx - a.inertia.xx)) + fabs((double)(rest.xz - a.inertia.xz))) / eps /
                        (double)vmi_trace(&whole),
                    5, i, 0);
        check_error("centre (15)", "split", "eps", size_of(vmi_add(back, centre)) / eps, 12, i, 0);
    }
    CHECK(vm_inertia_possible(&point) && vm_inertia_possible(&needle) && vm_inertia_possible(&plate));
    bent.zz = 3 + 24 * 4 * VM_EPSILON;
    CHECK(vm_inertia_possible(&bent));
    bent.zz = 3 + 24 * 16 * VM_EPSILON;
    CHECK(!vm_inertia_possible(&bent));
    bent = plate;
    bent.xz = R(0.1); /* a plate's moments 1 and 3 cannot grow apart */
    CHECK(!vm_inertia_possible(&bent));
    bent = needle;
    bent.xx = R(-1e-3);
    CHECK(!vm_inertia_possible(&bent));
}

int main(int argc, char **argv)
{
    draw_anew(argc, argv);
    test_particles(0);
    test_particles(1);
    test_balance(0);
    test_balance(1);
    test_energy(0);
    test_energy(1);
    test_unequal_bodies();
    test_points_beside_bodies();
    test_mass_ratios();
    test_scales();
    test_burst();
    test_blow();
    test_relative();
    test_inverse();
    test_plane();
    test_plane_burst();
    test_plane_inverse();
    test_plane_point();
    test_plane_point_again();
    test_plane_nothing_left();
    test_small_part();
    test_small_rest();
    test_lost_inertia();
    test_far_and_fast();
    test_light_on_heavy();
    test_nearly_equal_moments();
    test_null_axes();
    test_thin_bodies();
    test_nothing_left();
    test_impossible();
    test_quaternion_length();
    test_inertia();
    test_jump_domain();
    test_outputs_as_inputs();
    test_rod_to_point();
    test_bad_input();
    return check_finish("jumps");
}
