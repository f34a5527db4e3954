/* Jumps in space (chapter 3): separation and attachment, of one part and of several, with impulses. The first oracle
   are random bodies made of particles, whose momenta are summed particle by particle; then the balances of momentum,
   angular momentum and energy, and other ways to the same motion. Then come the cases in which digits could be lost.
   test_jump_equations.c tests the equations one by one, test_refusals_bodies.c what is refused.

   usage: jumps [seed], which draws other bodies */
#include "jumps.h"
#include "particles.h"

/* ---- Particles ---- */

static const double particle_bound = 25; /* in eps of the momenta involved; the worst that was seen is 8.5 */

/* The sums hold what is after less what was before: the impulse taken off, nothing may be left. */
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

/* What is left after k pieces have gone. The rest's inertia and mass centre carry the rounding errors of the whole's,
   those of the input included. So the momenta that the whole would have if it moved like the rest count, too. */
static void check_rest(const char *what, const shot *s, int k, const vm_body *rest, const vm_impulse *j, int index)
{
    sums sum = no_sums, with_rest = no_sums;
    int i;
    for (i = 0; i < PIECES; i++) add_piece(&sum, 1, s, i, i < PIECES - k ? rest : &s->piece[i]);
    add_whole(&sum, -1, s, &s->whole);
    add_whole(&with_rest, 1, s, rest);
    sum.K_size += with_rest.K_size;
    sum.L_size += with_rest.L_size;
    check_sums(what, &sum, j, s->about, index);
}

/* Separation and attachment, of one piece and of all, against the sums over the particles */
static void test_particles(int unequal)
{
    int i, k;
    for (i = 0; i < 2000; i++) {
        sums attached = no_sums, all = no_sums;
        const vm_impulse *j;
        vm_body rest, whole;
        shot s;
        draw_shot(&s, unequal);
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
        check_error("attach_all: r", "particles", "eps", size_of(vm_sub(whole.r, s.whole.r)) / 15 / eps, 12, i, 0);
    }
}

/* ---- Balances ---- */

/* A body is attached, and the opposite impulse separates it again: the first body is as it was. Then it separates
   with a motion of its own. The balances hold about random points. */
static void test_balance(int with_impulse)
{
    const char *region = with_impulse ? "with impulse" : "free";
    int i;
    for (i = 0; i < 3000; i++) {
        vm_body a = random_body(uniform(1, 10), 1), b = random_body(uniform(0.1, 5), 0.5), whole, rest, part;
        vm_impulse impulse = random_impulse(), back = opposite(impulse);
        const vm_impulse *j = with_impulse ? &impulse : NULL, *minus_j = with_impulse ? &back : NULL;
        vm_vec3 about = random_vector(4);
        b.r = vm_add(a.r, random_vector(1));
        if (vm_attach(&a, &b, j, &whole)) FAIL("attach");
        check_defect("attach", region, joined(&a, &b, &whole, j, about), i);
        if (vm_separate(&whole, &b, minus_j, &rest)) FAIL("separate"); /* the opposite impulse there undoes it */
        check_error("undone: v", region, "eps", size_of(vm_sub(rest.v, a.v)) / eps, 60, i, 0);

        part = b;
        part.omega = random_vector(3);
        part.v = random_vector(5);
        if (vm_separate(&whole, &part, j, &rest)) FAIL("separate");
        check_defect("separate", region, parted(&whole, &rest, &part, j, about), i);
        check_error("rest: r", region, "eps", size_of(vm_sub(rest.r, a.r)) / eps, 16, i, 0);
    }
}

/* The change of kinetic energy between the whole and its n pieces, from the bodies and from the theorem. Rounding
   errors of omega cost energy in proportion to the angular momentum, so |omega| |L| is the size. */
static void check_energy(const char *what, const char *region, const vm_body *whole, int n, const vm_body *pieces,
                         double difference, double theorem, double index)
{
    double size = 0;
    int i;
    for (i = -1; i < n; i++) {
        const vm_body *b = i < 0 ? whole : pieces + i;
        const double trace = (double)vmi_inertia_trace(&b->inertia);
        size += (double)b->mass * size_of(b->v) * size_of(b->v) +
                trace * size_of(b->omega) * (size_of(b->omega) + size_of(whole->omega));
    }
    check_error(what, region, "eps", fabs(difference - theorem) / eps / size, 2, index, n);
}

/* Carnot's loss of energy in an attachment and the gain (113), (118) in a separation, of one piece and of several,
   with the work of an impulse and without */
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
            pieces[k].r = vm_add(pieces[0].r, random_vector(2));
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

/* Masses up to 1e4 and sizes up to 100 apart, thin bodies among them: joined, then parted with another motion */
static void test_unequal_bodies(void)
{
    int i, balanced = 0, done = 1;
    for (i = 0; i < 20000; i++) {
        double ratio = pow(10, uniform(-4, 4));
        vm_body a = random_body(1, pow(10, uniform(-1, 1))), b = random_body(ratio, pow(10, uniform(-1, 1)));
        vm_body whole, rest;
        vm_vec3 about = random_vector(4);
        int status;
        b.r = vm_add(a.r, random_vector(1));
        if (i % 4 == 0) a.inertia = vmi_inertia_plus(rod(2, random_vector(1)).inertia, R(1e-4), a.inertia);
        done = done && vm_attach(&a, &b, NULL, &whole) >= 0;
        check_defect("attach", "unequal", joined(&a, &b, &whole, NULL, about), ratio);
        b.omega = vm_add(b.omega, random_vector(1));
        b.v = vm_add(b.v, random_vector(1));
        status = vm_separate(&whole, &b, NULL, &rest);
        done = done && status >= 0;
        if (status) continue; /* in float the whole's rounding errors hide a rest of 1e-4 of its mass and size */
        balanced++;
        check_defect("separate", "unequal", parted(&whole, &rest, &b, NULL, about), ratio);
    }
    CHECK(done && balanced > (is_float ? 15000 : 19990));
}

/* A mass centre of the jump, or a point close to the whole's */
static vm_vec3 point_beside(int which, const vm_body *a, const vm_body *b, const vm_body *whole)
{
    if (which == 0) return a->r;
    if (which == 1) return b->r;
    return vm_add(whole->r, random_vector(pow(10, uniform(-6, 0))));
}

/* Fast bodies far from the origin, and angular momenta about points next to one of them. There its momentum has
   hardly an arm; an eps of its position is more than all the rest, and belongs to the scale. Sizes are 0.01 to 1 m.
 */
static void test_points_beside_bodies(void)
{
    const double farthest =
        is_float ? 2 : 6; /* 100 m, 1000 km; farther off an eps of the positions changes the inertia */
    int i, done = 0;
    for (i = 0; i < 20000; i++) {
        vm_body a = random_body(uniform(1, 10), 1), b = random_body(pow(10, uniform(-3, 1)), pow(10, uniform(-2, 0)));
        vm_body whole, rest;
        vm_impulse impulse = random_impulse();
        const vm_impulse *j = i % 2 ? &impulse : NULL;
        vm_vec3 about;
        a.r = random_vector(pow(10, uniform(-1, farthest)));
        b.r = vm_add(a.r, random_vector(1));
        a.v = random_vector(pow(10, uniform(-3, 6)));
        b.v = random_vector(pow(10, uniform(-3, 6)));
        impulse.at = vm_add(a.r, random_vector(1));
        if (vm_attach(&a, &b, j, &whole)) continue;
        about = point_beside(i % 3, &a, &b, &whole);
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
    const double least = is_float ? 1e-8 : 1e-14, most = is_float ? 1e9 : 1e15;
    double ratio;
    for (ratio = least; ratio < most; ratio *= 7) {
        const vm_vec3 about = vector(0, 0, 0);
        vm_body a = random_body(1, 1), b = random_body(ratio, 1), whole;
        CHECK(vm_attach(&a, &b, NULL, &whole) >= 0);
        check_defect("attach", "mass ratios", joined(&a, &b, &whole, NULL, about), ratio);
        CHECK(vm_attach(&b, &a, NULL, &whole) >= 0);
        check_defect("attach", "mass ratios", joined(&a, &b, &whole, NULL, about), ratio);
    }
}

/* ---- Several parts at once ---- */

enum { BURST = 5 };

/* Separate the parts one after another, in the order of their numbers or backward; the impulse comes with one of
 * them. */
static vm_body separated_one_by_one(const vm_body *whole, const vm_body *parts, int backward, int struck,
                                    const vm_impulse *j)
{
    vm_body rest = *whole;
    int i;
    for (i = 0; i < BURST; i++) {
        const int k = backward ? BURST - 1 - i : i;
        CHECK(vm_separate(&rest, &parts[k], k == struck ? j : NULL, &rest) == VM_OK);
    }
    return rest;
}

/* Parts that go or come at once do what they do one after another, in either order, wherever among them the impulse
   falls. */
static void test_burst(void)
{
    int i, k;
    for (i = 0; i < 1000; i++) {
        vm_body parts[BURST], core = random_body(5, 1), whole, one = core, at_once;
        const vm_impulse impulse = random_impulse(), *j = i % 2 ? &impulse : NULL;
        const int struck = i % BURST; /* the impulse comes with this part */
        for (k = 0; k < BURST; k++) {
            parts[k] = random_body(uniform(0.1, 3), 1);
            parts[k].r = vm_add(core.r, random_vector(2));
        }
        CHECK(vm_attach_all(&core, BURST, parts, j, &whole) == VM_OK);
        for (k = 0; k < BURST; k++) CHECK(vm_attach(&one, &parts[k], k == struck ? j : NULL, &one) == VM_OK);
        check_error("attach_all", "one by one", "eps", apart(&whole, &one), 24, i, 0);
        for (k = 0; k < BURST; k++) {
            parts[k].v = random_vector(5);
            parts[k].omega = random_vector(3);
        }
        CHECK(vm_separate_all(&whole, BURST, parts, j, &at_once) == VM_OK);
        for (k = 0; k < 2; k++) {
            one = separated_one_by_one(&whole, parts, k, struck, j);
            check_error("separate_all", "one by one", "eps", apart(&at_once, &one), 600, i, k);
        }
        CHECK(vm_separate_all(&whole, BURST, parts, j, &parts[BURST - 1]) == VM_OK); /* an input as the output */
        CHECK(memcmp(&parts[BURST - 1], &at_once, sizeof at_once) == 0);
    }
}

/* Without parts a jump is a blow: v + J/M, and I (omega1 - omega) = the moment about S. */
static void test_blow(void)
{
    vm_body b = random_body(3, 1), struck, plain;
    vm_impulse j = random_impulse();
    CHECK(vm_separate_all(&b, 0, NULL, &j, &struck) == VM_OK && vm_attach_all(&b, 0, NULL, &j, &plain) == VM_OK);
    CHECK(memcmp(&struck, &plain, sizeof plain) == 0 && struck.mass == b.mass);
    check_defect("blow", "with impulse", defect_of(1, &b, 1, &struck, &j, random_vector(3)), 0);
    CHECK(vm_separate_all(&b, 0, NULL, NULL, &struck) == VM_OK && apart(&struck, &b) == 0);
}

/* ---- Small and large parts: digits that could be lost ---- */

/* m to 0: the whole goes on, and the part's kick goes with m/M. A difference of momenta must not grow by 1/m. */
static void test_small_part(void)
{
    double m;
    for (m = 1; m > (is_float ? 1e-30 : 1e-290); m *= 1e-3) {
        vm_body body = random_body(10, 1), part = random_body(m, 0.5), whole, rest;
        part.r = vm_add(body.r, random_vector(0.5));
        CHECK(vm_attach(&body, &part, NULL, &whole) == VM_OK);
        part.v = random_vector(5);
        part.omega = random_vector(3);
        CHECK(vm_separate(&whole, &part, NULL, &rest) == VM_OK);
        check_defect("separate", "m to 0", parted(&whole, &rest, &part, NULL, random_vector(3)), m);
        check_error("rest - whole", "m to 0", "eps", apart(&rest, &whole) / (1 + m / 10 / eps), 12, m, 0);
    }
}

/* m to M: the rest is a share f of the whole. If the part leaves as it moved, the rest moves on too, however much
   rounding has taken from its inertia. If the part is kicked, the rest keeps the balances, or the function says that
   it cannot. */
static void test_small_rest(void)
{
    double f;
    int kept = 0, lost = 0;
    for (f = 0.5; f > 4 * eps; f /= 3) {
        vm_body body = random_body(1, 1), left = random_body(f, 1), whole, rest;
        const vm_vec3 about = random_vector(3);
        vm_vec3 carried;
        defect d;
        int status;
        left.q = body.q;
        left.r = vm_add(body.r, random_vector(0.3));
        CHECK(vm_attach(&body, &left, NULL, &whole) == VM_OK);
        body.omega = whole.omega;
        body.v = vm_add(whole.v, vm_cross(whole.omega, vm_sub(body.r, whole.r)));
        CHECK(vm_separate(&whole, &body, NULL, &rest) >= 0);
        /* the part's v is rounded, and that rounding kicks the rest, M/f and M/I times */
        carried = vm_add(whole.v, vm_cross(whole.omega, vm_sub(rest.r, whole.r)));
        check_error("carried: v", "m to M", "eps/f", f * size_of(vm_sub(rest.v, carried)) / eps, 30, f, 0);
        check_error("carried: mass", "m to M", "eps/f", f * fabs((double)rest.mass / f - 1) / eps, 2, f, 0);
        body.v = random_vector(5);
        body.omega = random_vector(3);
        status = vm_separate(&whole, &body, NULL, &rest);
        CHECK(status >= 0);
        d = parted(&whole, &rest, &body, NULL, about);
        if (status == VM_OK) {
            kept++;
            check_defect("separate", "m to M", d, f);
        } else {
            lost++;
            check_error("separate", "m to M, lost", "eps K", d.K, 3, f, 0);
        }
    }
    CHECK(kept > (is_float ? 5 : 20) && lost > 0);
}

/* The part carries all of the inertia but 1e-3 to eps/10 of it, so that no digit of I_S1 is left. (34) as it stands
   divides the whole's rounding errors by I_S1. In relative motions the part that moves on as before leaves the rest's
   spin at Omega. */
static void test_lost_inertia(void)
{
    double own, worst_printed = 0;
    for (own = 1e-3; own > eps / 10; own /= 3) {
        vm_body heavy = random_body(5, 1), slow, whole, part, rest;
        const vm_inertia ball = inertia(own, 0, 0, own, 0, own);
        vm_vec3 left;
        heavy.r = vector(0, 0, 0);
        slow = heavy;
        slow.mass = 2;
        slow.inertia = ball;
        CHECK(vm_attach(&heavy, &slow, NULL, &whole) == VM_OK);
        part = heavy;
        part.omega = whole.omega;
        part.v = whole.v;
        CHECK(vm_separate(&whole, &part, NULL, &rest) == VM_OK);
        check_error("omega kept", "I_S1 lost", "eps", size_of(vm_sub(rest.omega, whole.omega)) / eps, 1, own, 0);
        check_error("I_S1", "I_S1 lost", "eps",
                    fabs((double)(rest.inertia.xx - ball.xx)) / eps / (double)vmi_inertia_trace(&whole.inertia), 8, own, 0);
        /* as printed: |I_S Omega - I_S2 Omega| against I_S1 Omega, with each product rounded */
        left = vm_sub(vmi_spin_momentum(&whole), vmi_spin_momentum(&part));
        left = vm_sub(left, vm_scale(R(own), whole.omega));
        worst_printed = fmax(worst_printed, size_of(left) / own / size_of(whole.omega));
    }
    CHECK(worst_printed > 0.5);
}

/* Velocities of a light body, fast and spinning, that joins a heavy one at rest, whichever is named first: the
   result's small velocities are right to some eps of themselves, not of the light one's. */
static void test_light_on_heavy(void)
{
    const vm_inertia ball = {1, 1, 1, 0, 0, 0};
    double m;
    for (m = 1; m > (is_float ? 1e-20 : 1e-40); m /= 10) {
        vm_body light = random_body(1, 1), heavy = random_body(1, 1), whole;
        double expected;
        int i;
        light.mass = R(m);
        light.inertia = inertia(m, 0, 0, m, 0, m);
        heavy.mass = 1;
        heavy.inertia = ball;
        light.r = heavy.r = heavy.v = heavy.omega = vector(0, 0, 0);
        light.v = vector(1e4, 0, 0);
        light.omega = vector(0, 1e4, 0);
        light.q = heavy.q = vm_quat_times(light.q, heavy.q);
        expected = 1e4 * (double)light.mass / (1 + (double)light.mass);
        for (i = 0; i < 2; i++) {
            const vm_body *first = i ? &light : &heavy, *second = i ? &heavy : &light;
            CHECK(vm_attach(first, second, NULL, &whole) == VM_OK);
            check_error("attach: v", "light on heavy", "eps", fabs((double)whole.v.x / expected - 1) / eps, 4, m, i);
            check_error("attach: omega", "light on heavy", "eps", fabs((double)whole.omega.y / expected - 1) / eps,
                        16, m, i);
        }
    }
}

/* ---- Far from the origin ---- */

/* The same jump near the origin, and far from it at high speed. The offsets are powers of two, and places and
   velocities are multiples of a grain, so that the inputs are exact. */
typedef struct distant {
    vm_body whole, part, far_whole, far_part;
    vm_impulse impulse, far_impulse;
    vm_vec3 rush; /* the speed that all share */
} distant;

static double grains(double size)
{
    const double grain = is_float ? 1. / 256 : 1. / 1048576;
    return floor(uniform(-size, size) / grain) * grain;
}

static void draw_distant(distant *d, double distance, double speed)
{
    const vm_vec3 there = vector(distance, -distance, 0.5 * distance);
    double x, y;
    d->rush = vector(speed, 0.5 * speed, -speed);
    d->whole = random_body(5, 1);
    d->part = random_body(1, 0.2);
    d->impulse = random_impulse();
    d->whole.r = d->whole.v = vector(0, 0, 0);
    x = grains(0.2);
    y = grains(0.2);
    d->part.r = vector(x, y, 0);
    x = grains(3);
    y = grains(3);
    d->part.v = vector(x, 0, y);
    x = grains(1);
    y = grains(1);
    d->impulse.at = vector(x, 0, y);
    d->whole.inertia.xx += 1;
    d->whole.inertia.yy += 1;
    d->whole.inertia.zz += 1;
    d->far_whole = d->whole;
    d->far_part = d->part;
    d->far_impulse = d->impulse;
    d->far_whole.r = there;
    d->far_part.r = vm_add(d->part.r, there);
    d->far_impulse.at = vm_add(d->impulse.at, there);
    d->far_whole.v = d->rush;
    d->far_part.v = vm_add(d->part.v, d->rush);
}

/* Place and velocity that all share must not cost a digit of the spin, nor of the relative velocities. Where no
   impulse acts the gain of energy is right, too; the difference of the energies has lost it in M v^2. */
static void test_far_and_fast(void)
{
    const double distance = is_float ? 4096 : 1073741824., speed = is_float ? 512 : 16384; /* 1e9 m, 1e4 m/s */
    double lost = 0;
    int i;
    for (i = 0; i < 300; i++) {
        const vm_impulse *j, *far_j;
        vm_body rest, far_rest;
        distant d;
        draw_distant(&d, distance, speed);
        j = i % 2 ? &d.impulse : NULL;
        far_j = i % 2 ? &d.far_impulse : NULL;
        CHECK(vm_separate(&d.whole, &d.part, j, &rest) == VM_OK);
        CHECK(vm_separate(&d.far_whole, &d.far_part, far_j, &far_rest) == VM_OK);
        check_error("separate: omega", "far and fast", "eps", size_of(vm_sub(far_rest.omega, rest.omega)) / eps, 1,
                    i, 0);
        check_error("separate: v", "far and fast", "eps",
                    size_of(vm_sub(vm_sub(far_rest.v, d.rush), rest.v)) / eps / speed, 3, i, 0);
        if (!j) {
            const double gain = (double)vm_energy_gain(&d.whole, 1, &d.part, NULL, &rest);
            const double far_gain = (double)vm_energy_gain(&d.far_whole, 1, &d.far_part, NULL, &far_rest);
            const double difference = parted(&d.far_whole, &far_rest, &d.far_part, NULL, d.far_whole.r).energy;
            lost = fmax(lost, fabs(difference / gain - 1) / eps);
            check_error("energy gain", "far and fast", "eps", fabs(far_gain / gain - 1) / eps / speed, 12, i, 0);
        }
        CHECK(vm_attach(&d.whole, &d.part, j, &rest) == VM_OK);
        CHECK(vm_attach(&d.far_whole, &d.far_part, far_j, &far_rest) == VM_OK);
        check_error("attach: omega", "far and fast", "eps", size_of(vm_sub(far_rest.omega, rest.omega)) / eps, 1, i,
                    0);
    }
    CHECK(lost > 1000 * speed);
}

/* The rounding errors of positions far from the origin make no rod impossible. */
static void test_far_rods(void)
{
    double distance;
    int i;
    for (distance = 1; distance < (is_float ? 1e5 : 1e12); distance *= 10) {
        for (i = 0; i < 50; i++) {
            vm_body stick = rod(2, random_vector(0.5)), point = rod(1, vector(1, 0, 0)), whole, rest;
            int status;
            stick.r = vm_scale(R(distance), vector(0.3, 0.7, -0.11));
            stick.omega = random_vector(1);
            point.r = vm_add(stick.r, random_vector(0.5));
            point.v = random_vector(1);
            status = vm_attach(&stick, &point, NULL, &whole);
            CHECK(status >= 0 && vm_separate(&whole, &point, NULL, &rest) >= 0);
            if (status == VM_OK)
                check_defect("attach", "far away", joined(&stick, &point, &whole, NULL, vector(0, 0, 0)), distance);
        }
    }
}

/* ---- Shapes: equal moments, points, rods and plates ---- */

/* Principal moments that are equal to some eps: their axes cannot be trusted, and are not needed. */
static void test_nearly_equal_moments(void)
{
    int i;
    for (i = 0; i < 600; i++) {
        vm_body a = random_body(3, 1), b = random_body(1, 0.5), whole, rest, part;
        double off = pow(10, uniform(is_float ? -9 : -18, -3));
        a.inertia = inertia(1, uniform(-off, off), uniform(-off, off), 1 + uniform(-off, off), uniform(-off, off),
                            1 + uniform(-off, off));
        b.inertia = vmi_inertia_plus(a.inertia, R(-0.9), a.inertia);
        b.r = i % 2 ? a.r : vm_add(a.r, random_vector(off));
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

/* A point that is left by a body moving on as before keeps the whole's spin. If the body gets another spin, angular
   momentum is left that a point cannot have. */
static void check_point_left(int i, vm_body a, const vm_body *point)
{
    vm_body whole, rest, again;
    CHECK(vm_attach(&a, point, NULL, &whole) == VM_OK);
    a.omega = whole.omega;
    a.v = vm_add(whole.v, vm_cross(whole.omega, vm_sub(a.r, whole.r)));
    CHECK(vm_separate(&whole, &a, NULL, &rest) == VM_OK);
    CHECK(rest.inertia.xx == 0 && rest.inertia.yy == 0 && rest.inertia.zz == 0 && rest.inertia.xy == 0);
    check_error("point: spin kept", "null axes", "eps", size_of(vm_sub(rest.omega, whole.omega)) / eps, 60, i, 0);
    CHECK(vm_attach(&rest, &a, NULL, &again) == VM_OK && vm_attach(&a, &rest, NULL, &again) == VM_OK);
    a.omega = random_vector(3);
    CHECK(vm_separate(&whole, &a, NULL, &rest) == VM_NULL_AXIS && VM_NULL_AXIS > 0);
}

/* Two points make a rod, whose spin about itself stays the first one's. It can be used again. */
static void check_rod_made(int i, const vm_body *a, vm_body first, const vm_body *point)
{
    vm_body whole, rest, again;
    vm_vec3 axis;
    first.q.x = R(0.6);
    first.q.w = R(0.8);
    first.omega = random_vector(2);
    CHECK(vm_attach(&first, point, NULL, &whole) == VM_OK);
    check_defect("attach", "two points", joined(&first, point, &whole, NULL, vector(0, 0, 0)), i);
    axis = vm_sub(point->r, first.r);
    check_error("rod: spin kept", "null axes", "eps",
                fabs((double)vm_dot(axis, vm_sub(whole.omega, first.omega))) / size_of(axis) / eps, 20, i, 0);
    CHECK(vm_separate(&whole, point, NULL, &rest) >= 0 && vm_attach(&whole, a, NULL, &again) == VM_OK);
}

/* Points and rods in general position: the spin about an axis without inertia stays the first body's, the rest of the
   motion balances, and what comes out can be used again. */
static void test_null_axes(void)
{
    int i;
    for (i = 0; i < 500; i++) {
        const vm_body a = random_body(3, 1), first = rod(1, vector(1, 0, 0));
        vm_body point = first;
        point.r = vm_add(a.r, random_vector(1));
        point.v = random_vector(2);
        point.omega = random_vector(2);
        check_point_left(i, a, &point);
        check_rod_made(i, &a, first, &point);
    }
}

/* A blow at a point of a rod turns it about no axis that it lacks; a twist about the rod would. Rounding errors, of
   places far away too, are told from twists. */
static void test_blow_on_rod(void)
{
    int i;
    for (i = 0; i < 1000; i++) {
        vm_vec3 axis = random_vector(1);
        vm_body stick = rod(2, axis), struck;
        vm_impulse j = random_impulse();
        vmi_mat3 turn;
        double twist;
        stick.q = random_attitude();
        stick.r = random_vector(i % 2 ? 1 : 100);
        stick.v = random_vector(3);
        stick.omega = random_vector(3);
        turn = vmi_rotation(stick.q);
        axis = vmi_times(&turn, axis);
        j.couple = vector(0, 0, 0);
        j.at = vm_add(stick.r, vm_scale(R(uniform(-1, 1)), axis));
        CHECK(vm_attach_all(&stick, 0, NULL, &j, &struck) == VM_OK);
        twist = 1e4 * eps * (1 + size_of(j.linear)) * (1 + size_of(j.at)) / size_of(axis);
        j.couple = vm_scale(R(twist), axis);
        CHECK(vm_attach_all(&stick, 0, NULL, &j, &struck) == VM_NULL_AXIS);
    }
}

/* Two opposite quaternions describe the same attitude. One of these two differs from the other body's only by its w, the other
   one by all but its w. */
static void test_opposite_quaternions(void)
{
    int i;
    for (i = 0; i < 3; i++) {
        vm_body a, b, whole, again;
        memset(&a, 0, sizeof a);
        a.mass = 2;
        a.inertia = inertia(1, 0.1, 0.2, 2, 0.3, 2.5);
        a.q.w = R(0.6);
        if (i == 0) a.q.x = R(0.8);
        else if (i == 1) a.q.y = R(0.8);
        else a.q.z = R(0.8);
        b = a;
        b.r = vector(1, 2, 3);
        b.omega = vector(3, 1, 2);
        b.q.w = -a.q.w;
        CHECK(vm_attach(&a, &b, NULL, &whole) == VM_OK);
        b.q.w = a.q.w;
        b.q.x = -a.q.x;
        b.q.y = -a.q.y;
        b.q.z = -a.q.z;
        CHECK(vm_attach(&a, &b, NULL, &again) == VM_OK);
        CHECK(size_of(vm_sub(whole.omega, again.omega)) < 100 * eps);
        CHECK(fabs((double)(whole.inertia.yz - again.inertia.yz)) < 100 * eps);
    }
}

/* Small moments are not taken for none where they are resolved: a needle along x, and balls so far apart that their
   own inertia is below an eps of the whole's */
static void test_small_moments(void)
{
    vm_body a, b, whole;
    memset(&a, 0, sizeof a);
    a.mass = 1;
    a.inertia.xx = R(0.1) * VM_EPSILON;
    a.inertia.yy = a.inertia.zz = R(1. / 12);
    b = a;
    b.omega.x = 100;
    CHECK(vm_attach(&a, &b, NULL, &whole) == VM_OK && fabs((double)whole.omega.x - 50) < 1e-4);
    a.inertia = inertia(1, 0, 0, 1, 0, 1);
    b = a;
    a.omega.x = 1;
    b.omega.x = -3;
    b.r.x = 1 / VM_EPSILON;
    CHECK(vm_attach(&a, &b, NULL, &whole) == VM_OK && whole.inertia.xx == 2 && whole.omega.x == -1);
}

/* Collinear rods along x, y and z: a couple along them has no axis to turn about, a couple across them has */
static void test_collinear_rods(void)
{
    int i;
    for (i = 0; i < 3; i++) {
        const vm_vec3 e = vector(i == 0, i == 1, i == 2);
        vm_body a = rod(2, e), b = a, whole;
        vm_impulse twist;
        b.r = vm_scale(5, e);
        memset(&twist, 0, sizeof twist);
        twist.couple = e;
        CHECK(vm_attach(&a, &b, &twist, &whole) == VM_NULL_AXIS && size_of(whole.omega) == 0);
        twist.couple = vector(i == 1, i == 2, i == 0);
        CHECK(vm_attach(&a, &b, &twist, &whole) == VM_OK && size_of(whole.omega) < 0.2 && size_of(whole.omega) > 0);
    }
}

/* Rods and plates in general position are possible bodies. */
static void test_rods_and_plates(void)
{
    int i;
    for (i = 0; i < 500; i++) {
        const vm_vec3 e = random_vector(1), f = random_vector(1);
        vm_body a = rod(2 + i % 3, e), b, whole;
        if (i % 2) a.inertia = vmi_inertia_plus(a.inertia, 3, rod(2, f).inertia);
        b = random_body(1, 1);
        a.q = b.q;
        a.omega = random_vector(2);
        CHECK(vm_attach(&a, &b, NULL, &whole) == VM_OK);
        check_defect("attach", "rods and plates", joined(&a, &b, &whole, NULL, vector(0, 0, 0)), i);
    }
}

/* Two equal points on the x axis are a rod. One taken away leaves a point, whose spin stays the rod's. */
static void test_rod_to_point(void)
{
    vm_body stick, part, rest;
    memset(&stick, 0, sizeof stick);
    stick.mass = 2;
    stick.inertia = inertia(0, 0, 0, 2, 0, 2);
    stick.omega = vector(3, 0.5, -0.25);
    stick.v = vector(1, 2, 3);
    part = stick;
    part.mass = 1;
    part.r = vector(1, 0, 0);
    memset(&part.inertia, 0, sizeof part.inertia);
    part.v = vm_add(stick.v, vm_cross(stick.omega, part.r));
    CHECK(vm_separate(&stick, &part, NULL, &rest) == VM_OK);
    CHECK(size_of(vm_sub(rest.omega, stick.omega)) == 0 && rest.r.x == -1 && rest.inertia.yy == 0);
    CHECK(size_of(vm_sub(rest.v, vm_add(stick.v, vm_cross(stick.omega, vector(-1, 0, 0))))) == 0);
}

/* An input may be the output. */
static void test_outputs_as_inputs(void)
{
    vm_body part, whole = whole_and_part(&part), x = whole, y = part, rest;
    CHECK(vm_attach(&whole, &part, NULL, &rest) == VM_OK && vm_attach(&x, &part, NULL, &x) == VM_OK);
    CHECK(memcmp(&x, &rest, sizeof x) == 0 && vm_attach(&whole, &y, NULL, &y) == VM_OK);
    CHECK(memcmp(&y, &rest, sizeof y) == 0);
    CHECK(vm_separate(&whole, &part, NULL, &whole) == VM_OK && whole.mass == 4);
}

/* A thin rod, of which a moment of 26 eps of the whole's trace is left. It may be only a rounding error, so that it becomes 0;
   vm_separate promises that such a moment is below 50 eps of the trace. The exact inertia by mpmath. */
static void test_lost_moment(void)
{
    const vm_body whole = {R(0.18119380749386654),
                           {R(0.0068209076018334895), R(0.032698090973319785), R(0.039437680305336245),
                            R(-0.014878338474558616), R(0.0011393587943421787), R(0.0005194746977508211)},
                           {R(-0.29448827536129296), R(0.38981781987589237), R(0.8366193212482029), R(-0.6990013266065684)},
                           {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    const vm_body part = {R(0.15430347401623717),
                          {R(3.226053144933245e-06), R(4.3942134644395926e-07), R(3.198191265452912e-06),
                           R(6.475106690998318e-07), R(-1.3460621478394526e-07), R(5.068496632678684e-08)},
                          {R(0.48479123539847), R(0.7845227970165622), R(0.7526454222021906), R(0.7338562768604393)},
                          {R(0.09984116028031928), R(-0.14445517285974188), R(0.08443773854142653)}, {0, 0, 0}, {0, 0, 0}};
    const double exact[6] = {7.8721226145524533082e-7, 8.2957289800603146058e-7, 4.8831443177001845964e-7,
                             2.4323679816560274836e-7, -3.8692740908564405574e-7, 3.5469909909977650978e-7};
    const double trace = 0.078956678880489519594;
    vm_body rest;
    double got[6];
    int i;
    if (is_float) return; /* the fields of the bodies are rounded there */
    CHECK(vm_separate(&whole, &part, NULL, &rest) >= 0);
    got[0] = (double)rest.inertia.xx;
    got[1] = (double)rest.inertia.yy;
    got[2] = (double)rest.inertia.zz;
    got[3] = (double)rest.inertia.xy;
    got[4] = (double)rest.inertia.xz;
    got[5] = (double)rest.inertia.yz;
    for (i = 0; i < 6; i++) check_error("lost moment", "entries", "bound", fabs(got[i] - exact[i]) / (50 * eps * trace), 1, i, 0);
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
    test_burst();
    test_blow();
    test_small_part();
    test_small_rest();
    test_lost_inertia();
    test_lost_moment();
    test_light_on_heavy();
    test_far_and_fast();
    test_far_rods();
    test_nearly_equal_moments();
    test_null_axes();
    test_blow_on_rod();
    test_small_moments();
    test_collinear_rods();
    test_rods_and_plates();
    test_opposite_quaternions();
    test_rod_to_point();
    test_outputs_as_inputs();
    return check_finish("jumps");
}
