/* varmass.h: jumps by the balances of momentum, angular momentum and energy with random bodies, not by comparison;
   bad input; the oscillator's constants and laws by their definitions. */
#include "../varmass.h"
#include "check.h"

#define R(x) ((vm_real)(x))
static const int is_float = PRECISION[0] == 'f';

static vm_vec3 vector(double x, double y, double z) { return vmi_vec3(R(x), R(y), R(z)); }
static vm_vec3 random_vector(double size)
{
    double x = uniform(-size, size), y = uniform(-size, size), z = uniform(-size, size);
    return vector(x, y, z);
}
static double size_of(vm_vec3 a) { return sqrt((double)vmi_dot(a, a)); }

/* A body of a few random particles rigidly joined: its inertia is possible by construction. */
static vm_body random_body(double mass, double size)
{
    vm_vec3 at[6], centre = vector(0, 0, 0);
    vm_body b;
    int i;
    memset(&b, 0, sizeof b);
    for (i = 0; i < 6; i++) {
        at[i] = random_vector(size);
        centre = vmi_add(centre, vmi_scale(R(1. / 6), at[i]));
    }
    for (i = 0; i < 6; i++)
        b.inertia = vmi_inertia_plus(b.inertia, R(mass / 6), vmi_inertia_of_point(vmi_sub(at[i], centre)));
    b.mass = R(mass);
    b.q.w = R(uniform(-1, 1)), b.q.x = R(uniform(-1, 1)), b.q.y = R(uniform(-1, 1)), b.q.z = R(uniform(-1, 1));
    b.r = random_vector(3), b.v = random_vector(5), b.omega = random_vector(4);
    return b;
}

/* n points of equal mass on a line along axis, from its middle */
static vm_body rod(int n, vm_vec3 axis)
{
    vm_body b;
    int i;
    memset(&b, 0, sizeof b);
    b.mass = R(n);
    for (i = 0; i < n; i++)
        b.inertia = vmi_inertia_plus(b.inertia, 1, vmi_inertia_of_point(vmi_scale(R(i - (n - 1) / 2.), axis)));
    return b;
}

static vm_impulse random_impulse(void)
{
    vm_impulse j;
    j.linear = random_vector(3), j.couple = random_vector(3), j.at = random_vector(3);
    return j;
}

/* The size of what the momenta are sums of, which their rounding errors go by */
static double momentum_scale(const vm_body *b, vm_vec3 about)
{
    double trace = (double)(b->inertia.xx + b->inertia.yy + b->inertia.zz);
    return trace * size_of(b->omega) + (size_of(b->r) + size_of(about)) * size_of(vm_momentum(b));
}

/* before + moment of j about the point - after - other, over eps times the sizes */
static double angular_defect(const vm_body *before, const vm_body *after, const vm_body *other, const vm_impulse *j,
                             vm_vec3 about)
{
    vm_vec3 L = vm_angular_momentum(before, about);
    double scale = momentum_scale(before, about) + momentum_scale(after, about) + momentum_scale(other, about);
    if (j) {
        L = vmi_add(L, vmi_add(j->couple, vmi_cross(vmi_sub(j->at, about), j->linear)));
        scale += size_of(j->couple) + size_of(vmi_sub(j->at, about)) * size_of(j->linear);
    }
    L = vmi_sub(L, vmi_add(vm_angular_momentum(after, about), vm_angular_momentum(other, about)));
    return size_of(L) / ((double)VM_EPSILON * scale);
}

static double linear_defect(const vm_body *before, const vm_body *after, const vm_body *other, const vm_impulse *j)
{
    vm_vec3 K = vmi_sub(vm_momentum(before), vmi_add(vm_momentum(after), vm_momentum(other)));
    double scale = size_of(vm_momentum(before)) + size_of(vm_momentum(after)) + size_of(vm_momentum(other));
    if (j) K = vmi_add(K, j->linear), scale += size_of(j->linear);
    return size_of(K) / ((double)VM_EPSILON * scale);
}

/* Attachment, undone by the opposite impulse; then the separation of what was attached, with a motion of its own: both
   balances about random points, and the first body's place back. */
static void test_balance(int with_impulse)
{
    const char *region = with_impulse ? "with impulse" : "free";
    int i;
    for (i = 0; i < 3000; i++) {
        vm_body a = random_body(uniform(1, 10), 1), b = random_body(uniform(0.1, 5), 0.5), whole, rest, part = b;
        vm_impulse impulse = random_impulse(), opposite = impulse;
        const vm_impulse *j = with_impulse ? &impulse : NULL, *minus_j = with_impulse ? &opposite : NULL;
        vm_vec3 about = random_vector(4);
        opposite.linear = vmi_scale(-1, impulse.linear), opposite.couple = vmi_scale(-1, impulse.couple);
        b.r = vmi_add(a.r, random_vector(1));
        if (vm_attach(&a, &b, j, &whole)) FAIL("attach");
        check_error("attach: K", region, "eps", linear_defect(&whole, &a, &b, minus_j), 3, i, 0);
        check_error("attach: L", region, "eps", angular_defect(&whole, &a, &b, minus_j, about), 12, i, 0);
        if (vm_separate(&whole, &b, minus_j, &rest)) FAIL("separate"); /* the opposite impulse there undoes it */
        check_error("undone: v", region, "eps", size_of(vmi_sub(rest.v, a.v)) / (double)VM_EPSILON, 60, i, 0);

        part = b;
        part.omega = random_vector(3), part.v = random_vector(5);
        if (vm_separate(&whole, &part, j, &rest)) FAIL("separate");
        check_error("separate: K", region, "eps", linear_defect(&whole, &rest, &part, j), 3, i, 0);
        check_error("separate: L", region, "eps", angular_defect(&whole, &rest, &part, j, about), 12, i, 0);
        check_error("rest: r", region, "eps", size_of(vmi_sub(rest.r, a.r)) / (double)VM_EPSILON, 16, i, 0);
    }
}

/* Kinetic energy of x relative to what moves on rigidly with whole */
static double relative_energy(vm_body x, const vm_body *whole)
{
    vm_vec3 carried = vmi_add(whole->v, vmi_cross(whole->omega, vmi_sub(x.r, whole->r)));
    x.v = vmi_sub(x.v, carried), x.omega = vmi_sub(x.omega, whole->omega);
    return (double)vm_kinetic_energy(&x);
}

/* Without impulse an attachment loses the energy of the motions relative to the final body (Carnot; (113)/(118) for an
   addition), and a separation gains that relative to the whole (113), (118). The bounds are wide because thin bodies
   turn an eps of angular momentum into several of angular velocity. */
static void test_energy(void)
{
    int i;
    for (i = 0; i < 3000; i++) {
        vm_body a = random_body(uniform(1, 10), 1), b = random_body(uniform(0.1, 5), 0.5), whole, rest;
        double apart = (double)(vm_kinetic_energy(&a) + vm_kinetic_energy(&b)), joined, difference;
        if (vm_attach(&a, &b, NULL, &whole)) FAIL("attach");
        joined = (double)vm_kinetic_energy(&whole);
        difference = relative_energy(a, &whole) + relative_energy(b, &whole);
        check_error("Carnot's loss", "free", "eps", fabs(apart - joined - difference) / (double)VM_EPSILON / apart,
                    25, i, 0);
        b.v = random_vector(5), b.omega = random_vector(3);
        if (vm_separate(&whole, &b, NULL, &rest)) FAIL("separate");
        apart = (double)(vm_kinetic_energy(&rest) + vm_kinetic_energy(&b));
        difference = relative_energy(rest, &whole) + relative_energy(b, &whole);
        check_error("gain (118)", "free", "eps",
                    fabs(apart - joined - difference) / (double)VM_EPSILON / (apart + joined), 25, i, 0);
    }
}

/* Masses up to 1e4 and sizes up to 100 apart, thin ones among them: joined, then parted with another motion */
static void test_unequal_bodies(void)
{
    int i, balanced = 0, done = 1;
    for (i = 0; i < 40000; i++) {
        double ratio = pow(10, uniform(-4, 4));
        vm_body a = random_body(1, pow(10, uniform(-1, 1))), b = random_body(ratio, pow(10, uniform(-1, 1))), whole,
                rest;
        vm_vec3 about = random_vector(4);
        int status;
        b.r = vmi_add(a.r, random_vector(1));
        if (i % 4 == 0) a.inertia = vmi_inertia_plus(rod(2, random_vector(1)).inertia, R(1e-4), a.inertia);
        done = done && vm_attach(&a, &b, NULL, &whole) >= 0;
        check_error("attach: L", "unequal", "eps", angular_defect(&whole, &a, &b, NULL, about), 12, ratio, 0);
        b.omega = vmi_add(b.omega, random_vector(1)), b.v = vmi_add(b.v, random_vector(1));
        status = vm_separate(&whole, &b, NULL, &rest);
        done = done && status >= 0;
        if (status) continue; /* in float a rest of 1e-4 the mass and size is lost in the whole's rounding errors */
        balanced++;
        check_error("separate: K", "unequal", "eps", linear_defect(&whole, &rest, &b, NULL), 3, ratio, 0);
        check_error("separate: L", "unequal", "eps", angular_defect(&whole, &rest, &b, NULL, about), 12, ratio, 0);
    }
    CHECK(done && balanced > (is_float ? 30000 : 39990));
}

/* Masses of any ratio, in either order */
static void test_mass_ratios(void)
{
    double ratio;
    for (ratio = is_float ? 1e-8 : 1e-14; ratio < (is_float ? 1e9 : 1e15); ratio *= 7) {
        vm_body a = random_body(1, 1), b = random_body(ratio, 1), whole;
        vm_vec3 about = vector(0, 0, 0);
        CHECK(vm_attach(&a, &b, NULL, &whole) >= 0);
        check_error("attach: K", "mass ratios", "eps", linear_defect(&whole, &a, &b, NULL), 3, ratio, 0);
        check_error("attach: L", "mass ratios", "eps", angular_defect(&whole, &a, &b, NULL, about), 12, ratio, 0);
        CHECK(vm_attach(&b, &a, NULL, &whole) >= 0);
        check_error("attach: K", "mass ratios", "eps", linear_defect(&whole, &a, &b, NULL), 3, ratio, 0);
        check_error("attach: L", "mass ratios", "eps", angular_defect(&whole, &a, &b, NULL, about), 12, ratio, 0);
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
        point.r = vmi_add(a.r, axis), point.v = random_vector(2), point.omega = random_vector(2);
        CHECK(vm_attach(&a, &point, NULL, &whole) == VM_OK);
        a.omega = whole.omega, a.v = vmi_add(whole.v, vmi_cross(whole.omega, vmi_sub(a.r, whole.r)));
        CHECK(vm_separate(&whole, &a, NULL, &rest) == VM_OK); /* moving on as before: the point is left */
        CHECK(rest.inertia.xx == 0 && rest.inertia.yy == 0 && rest.inertia.zz == 0 && rest.inertia.xy == 0);
        check_error("point: spin kept", "null axes", "eps",
                    size_of(vmi_sub(rest.omega, whole.omega)) / (double)VM_EPSILON, 60, i, 0);
        CHECK(vm_attach(&rest, &a, NULL, &again) == VM_OK && vm_attach(&a, &rest, NULL, &again) == VM_OK);
        a.omega = random_vector(3); /* with another spin angular momentum is left that a point cannot have */
        CHECK(vm_separate(&whole, &a, NULL, &rest) == VM_NULL_AXIS && VM_NULL_AXIS > 0);

        pair.q.x = R(0.6), pair.q.w = R(0.8), pair.omega = random_vector(2);
        CHECK(vm_attach(&pair, &point, NULL, &whole) == VM_OK); /* two points: a rod */
        check_error("attach: L", "two points", "eps", angular_defect(&whole, &pair, &point, NULL, vector(0, 0, 0)),
                    12, i, 0);
        axis = vmi_sub(point.r, pair.r), before = pair.omega;
        check_error("rod: spin kept", "null axes", "eps",
                    fabs((double)vmi_dot(axis, vmi_sub(whole.omega, before))) / size_of(axis) / (double)VM_EPSILON,
                    20, i, 0);
        CHECK(vm_separate(&whole, &point, NULL, &rest) >= 0 && vm_attach(&whole, &a, NULL, &again) == VM_OK);
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
            stick.r = vmi_scale(R(R0), vector(0.3, 0.7, -0.11)), stick.omega = random_vector(1);
            point.r = vmi_add(stick.r, random_vector(0.5)), point.v = random_vector(1);
            int status = vm_attach(&stick, &point, NULL, &whole);
            CHECK(status >= 0 && vm_separate(&whole, &point, NULL, &rest) >= 0);
            if (status == VM_OK)
                check_error("attach: L", "far away", "eps", angular_defect(&whole, &stick, &point, NULL, stick.r),
                            12, R0, 0);
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
    a.mass = 1, a.inertia.xx = R(0.1) * VM_EPSILON, a.inertia.yy = a.inertia.zz = R(1. / 12); /* a needle along x */
    b = a, b.omega.x = 100;
    CHECK(vm_attach(&a, &b, NULL, &whole) == VM_OK && fabs((double)whole.omega.x - 50) < 1e-4);
    a.inertia.xx = a.inertia.yy = a.inertia.zz =
        1; /* balls far apart: their own inertia is below an eps of the whole's */
    b = a, a.omega.x = 1, b.omega.x = -3, b.r.x = 1 / VM_EPSILON;
    CHECK(vm_attach(&a, &b, NULL, &whole) == VM_OK && whole.inertia.xx == 2 && whole.omega.x == -1);
    for (i = 0; i < 3; i++) { /* collinear rods along x, y, z and a couple along and across them */
        vm_vec3 e = vector(i == 0, i == 1, i == 2);
        a = rod(2, e), b = a, b.r = vmi_scale(5, e);
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
        b = random_body(1, 1), a.q = b.q, a.omega = random_vector(2);
        CHECK(vm_attach(&a, &b, NULL, &whole) == VM_OK);
        check_error("attach: L", "rods and plates", "eps", angular_defect(&whole, &a, &b, NULL, vector(0, 0, 0)),
                    12, i, 0);
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
            bad.inertia.xx = R(moment[0]), bad.inertia.yy = R(moment[1]), bad.inertia.zz = R(moment[2]);
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
        b.q.w *= R(scale), b.q.x *= R(scale), b.q.y *= R(scale), b.q.z *= R(scale);
        check_error("L", "length of q", "eps",
                    size_of(vmi_sub(vm_angular_momentum(&b, vector(0, 0, 0)), L)) / size_of(L) / (double)VM_EPSILON,
                    8, scale, 0);
    }
}

static void test_jump_domain(void)
{
    vm_body whole = random_body(5, 1), part = whole, rest, before, stick;
    int status, other;
    part.mass = 1;
    part.inertia = vmi_inertia_plus(vmi_inertia_of_point(vector(0, 0, 0)), R(0.01),
                                    vmi_inertia_of_point(vector(1, 1, 1)));
    part.r = vmi_add(whole.r, vector(0.1, 0, 0));
    memset(&rest, 7, sizeof rest);
    before = rest;
#define REFUSED(status, call) CHECK((call) == (status) && memcmp(&rest, &before, sizeof rest) == 0)
    {
        vm_body x = part;
        x.mass = 6;
        REFUSED(VM_BAD_MASS, vm_separate(&whole, &x, NULL, &rest));
        x.mass = whole.mass;
        REFUSED(VM_BAD_MASS, vm_separate(&whole, &x, NULL, &rest));
        x.mass = -1;
        REFUSED(VM_BAD_MASS, vm_separate(&whole, &x, NULL, &rest));
        REFUSED(VM_BAD_MASS, vm_attach(&whole, &x, NULL, &rest));
        x.mass = 0;
        REFUSED(VM_BAD_MASS, vm_attach(&whole, &x, NULL, &rest));
        x = part, x.mass = VM_NAN;
        REFUSED(VM_NOT_FINITE, vm_attach(&whole, &x, NULL, &rest));
        x = part, x.omega.y = VM_INFINITY;
        REFUSED(VM_NOT_FINITE, vm_attach(&x, &whole, NULL, &rest));
        x = whole, x.v.z = VM_MAX, part.v.z = -VM_MAX; /* the momenta overflow */
        REFUSED(VM_NOT_FINITE, vm_attach(&x, &part, NULL, &rest));
        part.v = whole.v;
        x = part, x.inertia.xx = -1;
        REFUSED(VM_BAD_INERTIA, vm_separate(&whole, &x, NULL, &rest));
        x = part, x.inertia.xx = 1; /* 1 > 0.02 + 0.02 */
        REFUSED(VM_BAD_INERTIA, vm_attach(&whole, &x, NULL, &rest));
        x = part, x.inertia.xy = R(0.5); /* moments 0.02 +- 0.5 */
        REFUSED(VM_BAD_INERTIA, vm_attach(&whole, &x, NULL, &rest));
        x = part, x.r = vmi_add(whole.r, vector(20, 0, 0)); /* never was inside */
        REFUSED(VM_BAD_INERTIA, vm_separate(&whole, &x, NULL, &rest));
        REFUSED(VM_BAD_ARGUMENT, vm_separate(NULL, &part, NULL, &rest));
        REFUSED(VM_BAD_ARGUMENT, vm_attach(&whole, NULL, NULL, &rest));
        CHECK(vm_attach(&whole, &part, NULL, NULL) == VM_BAD_ARGUMENT);
    }
    CHECK(vm_separate(&whole, &part, NULL, &whole) == VM_OK && whole.mass == 4); /* an output may be an input */

    /* two equal points on the x axis are a rod; one taken away leaves a point, whose spin stays the rod's */
    stick = part;
    memset(&stick.q, 0, sizeof stick.q);
    stick.r = vector(0, 0, 0), stick.mass = 2;
    stick.inertia = vmi_inertia_plus(vmi_inertia_of_point(vector(0, 0, 0)), 2,
                                     vmi_inertia_of_point(vector(1, 0, 0)));
    stick.omega = vector(3, 0.5, -0.25), stick.v = vector(1, 2, 3);
    part = stick;
    part.mass = 1, part.r = vector(1, 0, 0);
    memset(&part.inertia, 0, sizeof part.inertia);
    part.v = vmi_add(stick.v, vmi_cross(stick.omega, part.r));
    CHECK(vm_separate(&stick, &part, NULL, &rest) == VM_OK);
    CHECK(size_of(vmi_sub(rest.omega, stick.omega)) == 0 && rest.r.x == -1 && rest.inertia.yy == 0);
    CHECK(size_of(vmi_sub(rest.v, vmi_add(stick.v, vmi_cross(stick.omega, vector(-1, 0, 0))))) == 0);
    for (status = VM_BAD_INERTIA; status <= VM_NULL_AXIS; status++) /* each has its own words */
        for (other = status + 1; other <= VM_NULL_AXIS + 1; other++)
            CHECK(strcmp(vm_strerror(status), vm_strerror(other)) != 0);
}

static void test_oscillator(void)
{
    const double alphas[] = {0, 0.1, 0.5, 1, 4. / 3, 3, 10, 100};
    const vm_real x0 = R(-1.7), omega0 = R(0.8);
    int i, k;
    for (i = 0; i < 8; i++) {
        double alpha = (double)R(alphas[i]), w2 = (double)omega0 * (double)omega0, vmax;
        double E0 = pow(fabs((double)x0), alpha + 1) * w2 / (alpha + 1), unit = (double)VM_EPSILON * (alpha + 1);
        vm_real period = vm_osc_period(x0, omega0, R(alpha)), x, v, T, kp, K;
        vmax = (double)vm_osc_vmax(x0, omega0, R(alpha));
        check_error("vmax^2/2 = E", "", "eps*", fabs(vmax * vmax / 2 / E0 - 1) / unit, 3, alpha, 0);
        for (k = 0; k <= 40; k++) { /* the energy integral (259) along the exact motion */
            double E, t = uniform(0, 3) * (double)period;
            vm_osc_exact(R(t), x0, omega0, R(alpha), &x, &v);
            E = (double)v * (double)v / 2 + w2 * pow(fabs((double)x), alpha + 1) / (alpha + 1);
            check_error("energy (259)", "", "eps*", fabs(E / E0 - 1) / unit, 6, t, alpha);
        }
        for (k = 0; k < 20; k++) { /* x' is the slope of x, for x0 and omega0 of either sign */
            vm_real x_plus, x_minus, h = R(is_float ? 1e-2 : 1e-5), start = k % 2 ? x0 : -x0,
                                     w = k % 4 < 2 ? omega0 : -omega0;
            double t = uniform(0.1, 2) * (double)period, slope;
            vm_osc_exact(R(t), start, w, R(alpha), &x, &v);
            vm_osc_exact(R(t) + h, start, w, R(alpha), &x_plus, &v);
            vm_osc_exact(R(t) - h, start, w, R(alpha), &x_minus, &v);
            vm_osc_exact(R(t), start, w, R(alpha), &x, &v);
            slope = (double)(x_plus - x_minus) / (2 * (double)h);
            if (alpha < 20) CHECK(fabs(slope - (double)v) < (is_float ? 2e-2 : 1e-3) * vmax);
        }
        CHECK(vm_osc_period(x0, -omega0, R(alpha)) == period && (double)vm_osc_vmax(x0, -omega0, R(alpha)) == vmax);
        vm_osc_exact(period / 2, x0, omega0, R(alpha), &x, &v);
        check_error("x(T/2) = -x0", "", "eps", fabs((double)(x + x0)) / (double)VM_EPSILON, 4, alpha, 0);
        /* the three frequencies go with one period: Omega_alpha T = 2 pi, Omega_1* T = 4 K; and (307) */
        T = vm_osc_period(1, 1, R(alpha));
        check_error("Omega_a T/(2 pi)", "", "eps",
                    fabs((double)(vm_osc_omega_trig(R(alpha)) * T) / 6.283185307179586 - 1) / (double)VM_EPSILON, 4,
                    alpha, 0);
        K = jacobi_K(vm_osc_m_jacobi(R(alpha))), kp = VM_SQRT(1 - vm_osc_m_jacobi(R(alpha)));
        check_error("Omega_1 T/(4 K)", "", "eps",
                    fabs((double)(vm_osc_omega_jacobi(R(alpha)) * T / (4 * K)) - 1) / (double)VM_EPSILON, 12, alpha,
                    0);
        check_error("Omega_1 k' = vmax", "", "eps",
                    fabs((double)(vm_osc_omega_jacobi(R(alpha)) * kp / vm_osc_vmax(1, 1, R(alpha))) - 1) /
                        (double)VM_EPSILON,
                    12, alpha, 0);
    }
    for (i = 0; i < 8; i++) { /* no amplitude, no motion */
        vm_real x, v;
        vm_osc_exact(1, 0, 1, R(alphas[i]), &x, &v);
        CHECK(x == 0 && v == 0 && vm_osc_vmax(0, 1, R(alphas[i])) == 0);
        vm_osc_exact(1, 0, 0, R(alphas[i]), &x, &v);
        CHECK(x == 0 && v == 0 && vm_osc_vmax(0, 0, R(alphas[i])) == 0);
    }
}

static void test_laws(void)
{
    const double m = 6, eps = (double)VM_EPSILON;
    int r;
    double alpha, D;
    for (alpha = 0; alpha < 20; alpha = 1.5 * alpha + 0.25) {
        for (D = 0; D < 1; D += 0.3) {
            for (r = 0; r <= 1; r++) { /* the adiabatic invariant sqrt(k/m) A^((alpha+3)/2) exp(int (r m' + b)/m) */
                double A = (double)vm_osc_amplitude_law(R(m), R(D), R(r), R(alpha));
                double v = (double)vm_osc_velocity_law(R(m), R(D), R(r), R(alpha));
                double J = pow(m, -0.5) * pow(A, (alpha + 3) / 2) * pow(m, r) * exp(D);
                check_error("invariant", "", "eps*", fabs(J - 1) / eps / (alpha + 1), 6, alpha, D);
                check_error("v^2 m = A^(a+1)", "", "eps*",
                            fabs(v * v * m / pow(A, alpha + 1) - 1) / eps / (alpha + 1), 6, alpha, D);
            }
        }
    }
    /* m' = -2 b (reactive) keeps the amplitude (348): (m0/m)^(1/(a+3)) exp(-2/(a+3) b ln(m/m0)/m') = 1 */
    check_error("m' = -2 b", "", "eps",
                fabs((double)vm_osc_amplitude_law(R(0.5), R(-0.5 * log(0.5)), 1, R(1.5)) - 1) / eps, 2, 0, 0);
    CHECK(vm_osc_amplitude_law(1, 0, 1, 3) == 1 && vm_osc_velocity_law(1, 0, 0, 3) == 1);
    CHECK(isnan(vm_osc_amplitude_law(-1, 0, 1, 3)) && isnan(vm_osc_velocity_law(0, 0, 1, 3)));
    CHECK(isnan(vm_osc_amplitude_law(2, 0, 1, -1)) && isnan(vm_osc_velocity_law(2, 0, 1, VM_INFINITY)));
    CHECK(isnan(vm_osc_period(1, 1, -1)) && isnan(vm_osc_vmax(1, 1, VM_NAN)) && isnan(vm_osc_omega_trig(R(-0.1))));
    CHECK(isnan(vm_osc_period(VM_INFINITY, 1, 1)) && isnan(vm_osc_vmax(1, VM_INFINITY, 3)) &&
          isnan(vm_osc_vmax(VM_NAN, 1, 3)));
    CHECK(isnan(vm_osc_amplitude_law(2, VM_INFINITY, 1, 3)) && isnan(vm_osc_velocity_law(2, 0, VM_INFINITY, 3)));
    CHECK(isnan(vm_osc_amplitude_law(VM_INFINITY, 0, 1, 3)) && isnan(vm_osc_velocity_law(2, -VM_INFINITY, 1, 3)));
    CHECK(isnan(vm_osc_m_jacobi(VM_INFINITY)) && isnan(vm_osc_omega_jacobi(-1)));
}

int main(void)
{
    test_balance(0);
    test_balance(1);
    test_energy();
    test_unequal_bodies();
    test_mass_ratios();
    test_null_axes();
    test_thin_bodies();
    test_impossible();
    test_quaternion_length();
    test_jump_domain();
    test_oscillator();
    test_laws();
    return check_finish("varmass.h");
}
