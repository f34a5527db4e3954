/* Attitudes: vectors turned by quaternions, direction cosines, Euler's angles 3-1-3 and 3-2-1, modified Rodrigues
   parameters, and the functions of vectors. Oracles: a table in arbitrary precision (tests/data/attitude_table.h) with
   gimbal lock, angles next to 0 and to 180 degrees; the ways there and back; long double arithmetic; definitions. */
#include "bodies.h"

typedef struct attitude_row {
    const char *region;
    double q[4];
    double values[9][2]; /* psi, theta, phi, yaw, pitch, roll, Rodrigues parameters */
} attitude_row;

#include "data/attitude_table.h"

static const double pi = 3.14159265358979323846;

/* A bound or size that differs between the two types */
static double by_precision(double in_double, double in_float) { return is_float ? in_float : in_double; }

typedef long double wide;
typedef struct wide_quat {
    wide w, x, y, z;
} wide_quat;

static vm_quat quaternion(double w, double x, double y, double z) { return vmi_quat(R(w), vector(x, y, z)); }

static wide_quat widened(vm_quat q)
{
    wide_quat a;
    const wide most = (wide)vmi_larger(VM_FABS(q.w), vmi_norm_max(vmi_quat_vector(q)));
    wide length;
    a.w = (long double)q.w / most;
    a.x = (long double)q.x / most;
    a.y = (long double)q.y / most;
    a.z = (long double)q.z / most;
    length = sqrtl(a.w * a.w + a.x * a.x + a.y * a.y + a.z * a.z);
    a.w /= length;
    a.x /= length;
    a.y /= length;
    a.z /= length;
    return a;
}

static wide_quat product(wide_quat p, wide_quat q)
{
    wide_quat r;
    r.w = p.w * q.w - p.x * q.x - p.y * q.y - p.z * q.z;
    r.x = p.w * q.x + p.x * q.w + p.y * q.z - p.z * q.y;
    r.y = p.w * q.y + p.y * q.w + p.z * q.x - p.x * q.z;
    r.z = p.w * q.z + p.z * q.w + p.x * q.y - p.y * q.x;
    return r;
}

/* The angle between two attitudes, in units of eps */
static double between(wide_quat a, wide_quat b)
{
    wide_quat d;
    a.x = -a.x;
    a.y = -a.y;
    a.z = -a.z;
    d = product(a, b);
    return (double)(2 * sqrtl(d.x * d.x + d.y * d.y + d.z * d.z)) / eps;
}
static double apart(vm_quat a, vm_quat b) { return between(widened(a), widened(b)); }

/* The attitude after a turn by an angle about one of the axes 1, 2, 3 of the body */
static wide_quat turned(wide_quat q, int axis, vm_real angle)
{
    wide_quat turn = {1, 0, 0, 0};
    const wide sine = sinl((wide)angle / 2);
    turn.w = cosl((wide)angle / 2);
    if (axis == 1) turn.x = sine;
    if (axis == 2) turn.y = sine;
    if (axis == 3) turn.z = sine;
    return product(q, turn);
}

static wide_quat by_angles(const int *axes, const vm_real *angles)
{
    wide_quat q = {1, 0, 0, 0};
    int i;
    for (i = 0; i < 3; i++) q = turned(q, axes[i], angles[i]);
    return q;
}

static const int axes_313[3] = {3, 1, 3}, axes_321[3] = {3, 2, 1};

static void check_relative(const char *function, const char *region, vm_real got, const double *want, double bound)
{
    double error = (double)VM_FABS(got) / (eps * eps);
    if (want[0] != 0) error = fabs(((double)got - want[0]) - want[1]) / (eps * fabs(want[0]));
    check_error(function, region, "eps", error, bound, want[0], 0);
}

/* The angles are those of the table, each relative to itself, and all together they are the same rotation. */
static void test_table(void)
{
    int i, k;
    for (i = 0; i < (int)(sizeof attitude_table / sizeof *attitude_table); i++) {
        const attitude_row *row = attitude_table + i;
        const vm_quat q = quaternion(row->q[0], row->q[1], row->q[2], row->q[3]);
        const vm_quat identity = {1, 0, 0, 0}, given = vmi_quat_is_none(q) ? identity : q;
        vm_real angles[6];
        vm_vec3 mrp;
        int known = 1;
        for (k = 0; k < 4; k++) known = known && representable(row->q[k]);
        if (!known) continue;
        CHECK(vm_euler_313_angles(q, angles) == VM_OK);
        CHECK(vm_euler_321_angles(q, angles + 3) == VM_OK);
        mrp = vm_quat_to_mrp(q);
        for (k = 0; k < 3; k++) check_relative("euler_313_angles", row->region, angles[k], row->values[k], 4);
        for (k = 3; k < 6; k++) check_relative("euler_321_angles", row->region, angles[k], row->values[k], 4);
        check_relative("quat_to_mrp", row->region, mrp.x, row->values[6], 4);
        check_relative("quat_to_mrp", row->region, mrp.y, row->values[7], 4);
        check_relative("quat_to_mrp", row->region, mrp.z, row->values[8], 4);
        check_error("313 angles", row->region, "eps", between(widened(given), by_angles(axes_313, angles)), 8, i, 0);
        check_error("321 angles", row->region, "eps", between(widened(given), by_angles(axes_321, angles + 3)), 8, i,
                    0);
    }
}

/* A random attitude; every third one has some components next to 0, every third one is next to gimbal lock of 3-2-1 */
static vm_quat some_attitude(int i)
{
    vm_quat q = random_attitude();
    const vm_real tiny = R(pow(10, -uniform(1, by_precision(100, 12))));
    if (i % 3 == 1) {
        if (i & 4) q.w *= tiny;
        if (i & 8) q.x *= tiny;
        if (i & 16) q.y *= tiny;
        if (i & 32) q.z *= tiny;
    }
    if (i % 3 == 2) {
        q.y = q.w + tiny * q.z;
        q.z = -q.x + tiny * q.x;
        if (i & 4) q = quaternion((double)q.w, -(double)q.x, -(double)q.y, (double)q.z);
    }
    return q;
}

/* There and back, in every form */
static void test_round_trips(void)
{
    int i;
    for (i = 0; i < 20000; i++) {
        const vm_quat q = some_attitude(i);
        vm_real angles[3], c[9];
        vm_quat back = {0, 0, 0, 0};
        CHECK(vm_euler_313_angles(q, angles) == VM_OK);
        check_error("313 angles", "random", "eps", between(widened(q), by_angles(axes_313, angles)), 8, i, 0);
        CHECK(angles[1] >= 0 && (double)angles[1] <= (double)R(pi));
        check_error("313 back", "random", "eps", apart(q, vm_euler_313(angles[0], angles[1], angles[2])), 16, i, 0);
        CHECK(vm_euler_321_angles(q, angles) == VM_OK);
        check_error("321 angles", "random", "eps", between(widened(q), by_angles(axes_321, angles)), 8, i, 0);
        CHECK((double)VM_FABS(angles[1]) <= (double)R(pi / 2));
        check_error("321 back", "random", "eps", apart(q, vm_euler_321(angles[0], angles[1], angles[2])), 16, i, 0);
        check_error("mrp back", "random", "eps", apart(q, vm_quat_from_mrp(vm_quat_to_mrp(q))), 8, i, 0);
        CHECK(vm_norm(vm_quat_to_mrp(q)) <= 1 + 4 * VM_EPSILON);
        CHECK(vm_quat_to_matrix(q, c) == VM_OK && vm_quat_from_matrix(c, &back) == VM_OK && back.w >= 0);
        check_error("matrix back", "random", "eps", apart(q, back), 8, i, 0);
    }
}

/* Angles give the attitude that the turns about the body's axes give, one after the other */
static void test_from_angles(void)
{
    int i, k;
    for (i = 0; i < 2000; i++) {
        vm_real a[3];
        for (k = 0; k < 3; k++) a[k] = R(uniform(-8, 8));
        check_error("euler_321", "", "eps", between(by_angles(axes_321, a), widened(vm_euler_321(a[0], a[1], a[2]))), 8,
                    i, 0);
        check_error("euler_313", "", "eps", between(by_angles(axes_313, a), widened(vm_euler_313(a[0], a[1], a[2]))), 8,
                    i, 0);
    }
}

/* The vector turned in long double */
static void turn_wide(vm_quat attitude, vm_vec3 a, wide *result)
{
    wide_quat q = widened(attitude), v = {0, 0, 0, 0}, conjugate = q;
    v.x = (wide)a.x;
    v.y = (wide)a.y;
    v.z = (wide)a.z;
    conjugate.x = -q.x;
    conjugate.y = -q.y;
    conjugate.z = -q.z;
    v = product(product(q, v), conjugate);
    result[0] = v.x;
    result[1] = v.y;
    result[2] = v.z;
}

static double vector_error(vm_vec3 a, const wide *want)
{
    const wide x = (wide)a.x - want[0], y = (wide)a.y - want[1], z = (wide)a.z - want[2];
    return (double)sqrtl(x * x + y * y + z * z);
}

static void test_rotate(void)
{
    int i, k;
    for (i = 0; i < 5000; i++) {
        const vm_quat q = some_attitude(i), inverse = vmi_quat(q.w, vm_scale(-1, vmi_quat_vector(q)));
        const vm_vec3 a = random_vector(4);
        const double size = size_of(a);
        vm_real c[9];
        wide want[3];
        turn_wide(q, a, want);
        check_error("rotate", "", "eps", vector_error(vm_rotate(q, a), want) / (eps * size), 6, i, 0);
        turn_wide(inverse, a, want);
        check_error("rotate_back", "", "eps", vector_error(vm_rotate_back(q, a), want) / (eps * size), 6, i, 0);
        CHECK(vm_quat_to_matrix(q, c) == VM_OK);
        for (k = 0; k < 3; k++) { /* column k is the image of axis k */
            const vm_vec3 axis = vector(k == 0, k == 1, k == 2);
            const vm_vec3 image = vmi_vec3(c[k], c[3 + k], c[6 + k]);
            turn_wide(q, axis, want);
            check_error("quat_to_matrix", "", "eps", vector_error(image, want) / eps, 6, i, k);
        }
    }
}

/* The distance from 1 to the next number that `wide` can be. It is measured, because valgrind computes long double with the 53
   bits of double. On ARM long double has no more bits than double. */
static double wide_eps(void)
{
    volatile wide sum = 2;
    wide distance = 2;
    while (sum > 1) {
        distance /= 2;
        sum = 1 + distance / 2;
    }
    return (double)distance;
}

/* The matrix of an attitude, without another error than that of rounding its entries: by half an eps at most, so that the
   promised 4 eps of vm_quat_from_matrix include what they change. What the computation in `wide` adds, a few of its own eps, is
   next to nothing where it has more bits than vm_real. */
static void test_rounded_matrices(void)
{
    const double bound = 4 + 6 * wide_eps() / eps;
    int i;
    for (i = 0; i < 20000; i++) {
        const vm_quat attitude = some_attitude(i);
        const wide_quat q = widened(attitude);
        const wide entries[9] = {
            1 - 2 * (q.y * q.y + q.z * q.z), 2 * (q.x * q.y - q.w * q.z), 2 * (q.x * q.z + q.w * q.y),
            2 * (q.x * q.y + q.w * q.z), 1 - 2 * (q.x * q.x + q.z * q.z), 2 * (q.y * q.z - q.w * q.x),
            2 * (q.x * q.z - q.w * q.y), 2 * (q.y * q.z + q.w * q.x), 1 - 2 * (q.x * q.x + q.y * q.y)};
        vm_real c[9];
        vm_quat back = {0, 0, 0, 0};
        int k;
        for (k = 0; k < 9; k++) c[k] = (vm_real)entries[k];
        CHECK(vm_quat_from_matrix(c, &back) == VM_OK);
        check_error("quat_from_matrix", "random", "eps", apart(attitude, back), bound, i, 0);
    }
}

/* Small turns keep their relative accuracy on the way through the matrix; a printed matrix is accepted, and a wrong one
   is not. */
static void test_matrices(void)
{
    const vm_real printed[9] = {R(0.866), R(-0.5), 0, R(0.5), R(0.866), 0, 0, 0, 1};
    const vm_real reflection[9] = {1, 0, 0, 0, 1, 0, 0, 0, -1}, twice[9] = {2, 0, 0, 0, 2, 0, 0, 0, 2};
    vm_real c[9];
    vm_quat q = quaternion(1, 1e-9, -3e-12, 2e-20), back;
    CHECK(vm_quat_to_matrix(q, c) == VM_OK && vm_quat_from_matrix(c, &back) == VM_OK);
    check_error("matrix back", "small x", "eps", fabs((double)(back.x - q.x)) / (eps * (double)q.x), 4, 1e-9, 0);
    check_error("matrix back", "small y", "eps", fabs((double)(back.y - q.y)) / (eps * -(double)q.y), 4, 3e-12, 0);
    CHECK(vm_quat_from_matrix(printed, &q) == VM_OK && VM_FABS(2 * vmi_atan2(q.z, q.w) - R(pi / 6)) < R(1e-3));
    back.w = 7;
    CHECK(vm_quat_from_matrix(reflection, &back) == VM_DOMAIN && back.w == 7);
    CHECK(vm_quat_from_matrix(twice, &back) == VM_DOMAIN && back.w == 7);
    CHECK(vm_quat_from_matrix(NULL, &back) == VM_BAD_ARGUMENT && vm_quat_from_matrix(printed, NULL) == VM_BAD_ARGUMENT);
    c[4] = VM_NAN;
    CHECK(vm_quat_from_matrix(c, &back) == VM_NOT_FINITE && back.w == 7);
}

/* The shadow set is the same attitude, and w is accurate next to 180 degrees. */
static void test_rodrigues(void)
{
    const vm_vec3 half_turn = {1, 0, 0}, third = vector(0, 0, tan(pi / 6));
    vm_quat q = vm_quat_from_mrp(half_turn);
    int i;
    CHECK(q.w == 0 && q.x == 1 && q.y == 0 && q.z == 0);
    check_error("quat_from_mrp", "120 degrees", "eps", apart(vm_quat_from_mrp(third), quaternion(1, 0, 0, sqrt(3))),
                8, 0, 0);
    for (i = 0; i < 5000; i++) {
        const vm_vec3 p = vm_scale(R(pow(10, uniform(-1, 1) * by_precision(250, 30))), vm_unit(random_vector(1)));
        const double size = size_of(vm_unit(p));
        const vm_vec3 shadow = vm_scale(-1 / vm_norm(p), vm_unit(p));
        check_error("mrp shadow", "random", "eps", apart(vm_quat_from_mrp(p), vm_quat_from_mrp(shadow)), 16, i, 0);
        check_error("unit", "", "eps", fabs(size - 1) / eps, 4, i, 0);
    }
    for (i = 1; i < 20; i++) { /* |p| = 1 + i eps along an axis: w is known without rounding */
        const double s = 1 + i * eps, exact = -i * eps * (2 + i * eps) / (1 + s * s);
        q = vm_quat_from_mrp(vector(0, s, 0));
        check_error("quat_from_mrp", "w next to 0", "eps", fabs((double)q.w - exact) / (eps * fabs(exact)), 8, i, 0);
    }
}

/* Next to half turns about axes that are not along x, y or z, w is about eps^2; in the table by exact fractions. The
   first four rows are for double only. */
static void test_rodrigues_half_turns(void)
{
    static const double rows[][4] = {
        {0x1.3bccb8c2c7fe9p-5, 0x1.ed187d3f8a158p-2, 0x1.c04b9328b1d9cp-1, 1.7785002325819559176e-22},
        {0x1.984c81f88b7d6p-4, -0x1.a768acc8eca70p-2, 0x1.cf611cb7f6630p-1, 6.2863905885517196347e-22},
        {0x1.31332481f43f4p-5, 0x1.85cb14635c15cp-1, 0x1.4b6c5777b6d8bp-1, 7.1537041477519468467e-22},
        {-0x1.02464afc4fe7ap-4, 0x1.f9c30f044b000p-3, -0x1.ef1725e220132p-1, 8.6867837060432703155e-22},
        {-0x1.eb7a0ap-5, 0x1.117092p-2, -0x1.ec737ep-1, -4.147376886365178394e-14},
        {0x1.9379d2p-2, 0x1.d69098p-1, -0x1.e86358p-8, 1.6798888669014624248e-13},
        {-0x1.564a82p-6, 0x1.786e92p-1, 0x1.5ae256p-1, -2.2848563319128098714e-13},
        {-0x1.b03432p-2, 0x1.cf79dp-1, -0x1.92e72ap-5, -4.8489684489870590131e-13},
    };
    size_t i;
    for (i = 0; i < sizeof rows / sizeof *rows; i++) {
        const double *p = rows[i], w = p[3];
        if (!representable(p[0])) continue;
        check_error("quat_from_mrp", "half turns", "eps",
                    fabs((double)vm_quat_from_mrp(vector(p[0], p[1], p[2])).w - w) / (eps * fabs(w)), 8, (double)i, 0);
    }
}

/* Components that are integers, whose products and their sums fit into 64 bits, so that the true results are known. The
   products have more digits than a vm_real: they are rounded there. */
typedef struct integers {
    long long x, y, z;
} integers;

static integers random_integers(void)
{
    const double size = by_precision(1 << 30, 1 << 23);
    integers a;
    a.x = (long long)(size * uniform(-1, 1));
    a.y = (long long)(size * uniform(-1, 1));
    a.z = (long long)(size * uniform(-1, 1));
    return a;
}
static vm_vec3 as_vector(integers a) { return vector((double)a.x, (double)a.y, (double)a.z); }

/* The error of a result, in eps of a size */
static double integer_error(vm_real result, long long exact, double size)
{
    return fabs((double)((long long)result - exact)) / (eps * size);
}

/* A vector k (2, 3, 6), k (1, 4, 8) or k (12, 16, 21), with its components in any order, has the length 7 k, 9 k or 29 k. */
static void test_lengths(void)
{
    static const int sides[3][4] = {{2, 3, 6, 7}, {1, 4, 8, 9}, {12, 16, 21, 29}};
    int i;
    for (i = 0; i < 5000; i++) {
        const int *side = sides[i % 3], first = i % 2, second = 1 - first;
        const double k = floor(by_precision(1 << 25, 1 << 18) * uniform(0.1, 1));
        const vm_vec3 a = vector(k * side[first], -k * side[second], k * side[2]);
        check_error("norm", "", "eps", fabs((double)vm_norm(a) / (k * side[3]) - 1) / eps, 4, k, side[3]);
    }
}

static void test_products(void)
{
    int i;
    for (i = 0; i < 5000; i++) {
        const integers a = random_integers(), b = random_integers();
        const vm_vec3 u = as_vector(a), v = as_vector(b), cross = vm_cross(u, v);
        const double size = size_of(u) * size_of(v);
        check_error("dot", "", "eps", integer_error(vm_dot(u, v), a.x * b.x + a.y * b.y + a.z * b.z, size), 2, i, 0);
        check_error("cross", "", "eps", integer_error(cross.x, a.y * b.z - a.z * b.y, size), 2, i, 0);
        check_error("cross", "", "eps", integer_error(cross.y, a.z * b.x - a.x * b.z, size), 2, i, 1);
        check_error("cross", "", "eps", integer_error(cross.z, a.x * b.y - a.y * b.x, size), 2, i, 2);
    }
}

static void test_vectors(void)
{
    const vm_vec3 a = {1, 2, 3}, b = {-2, R(0.5), 4}, c = vm_cross(a, b), huge = {VM_MAX / 4, 0, VM_MAX / 4};
    CHECK(c.x == R(6.5) && c.y == -10 && c.z == R(4.5) && vm_dot(a, c) == 0 && vm_dot(b, c) == 0);
    CHECK(vm_add(a, b).x == -1 && vm_sub(a, b).y == R(1.5) && vm_scale(2, a).z == 6 && vm_dot(a, b) == 11);
    CHECK(VM_FABS(vm_unit(huge).x - R(sqrt(0.5))) <= 2 * VM_EPSILON && vm_unit(huge).y == 0);
    CHECK(vm_unit(vector(0, 0, 0)).x != vm_unit(vector(0, 0, 0)).x && vm_norm(vector(3, 4, 12)) == 13);
}

/* The body is nearly upside down, so that w is a subnormal number. Its product with y had lost its digits. */
static void test_euler_subnormal(void)
{
    const vm_real x = (vm_real)0.999755859375, y = (vm_real)-0.890625;
    const vm_quat q = {VM_MIN * VM_EPSILON * 65536, x, y, 0};
    const double psi[2] = {atan2((double)y, (double)x), 0}, phi[2] = {-psi[0], 0};
    vm_real angles[3] = {7, 7, 7};
    CHECK(vm_euler_313_angles(q, angles) == VM_OK);
    check_relative("euler_313_angles", "subnormal", angles[0], psi, 4);
    check_relative("euler_313_angles", "subnormal", angles[2], phi, 4);
}

static void test_refusals(void)
{
    const vm_quat bad = quaternion((double)NAN, 0, 0, 1), one = {1, 0, 0, 0};
    const vm_vec3 endless = vector((double)INFINITY, 0, 0);
    vm_real angles[3] = {7, 7, 7}, c[9] = {7};
    CHECK(vm_euler_313_angles(bad, angles) == VM_NOT_FINITE && angles[0] == 7);
    CHECK(vm_euler_321_angles(bad, angles) == VM_NOT_FINITE && angles[0] == 7);
    CHECK(vm_euler_313_angles(one, NULL) == VM_BAD_ARGUMENT && vm_euler_321_angles(one, NULL) == VM_BAD_ARGUMENT);
    CHECK(vm_quat_to_matrix(bad, c) == VM_NOT_FINITE && c[0] == 7 && vm_quat_to_matrix(one, NULL) == VM_BAD_ARGUMENT);
    CHECK(vm_rotate(bad, vector(1, 2, 3)).x != vm_rotate(bad, vector(1, 2, 3)).x);
    CHECK(vm_rotate_back(one, endless).y != vm_rotate_back(one, endless).y);
    CHECK(vm_quat_to_mrp(bad).x != vm_quat_to_mrp(bad).x && vm_quat_from_mrp(endless).w != vm_quat_from_mrp(endless).w);
    CHECK(vm_euler_321(VM_INFINITY, 0, 0).w != vm_euler_321(VM_INFINITY, 0, 0).w);
}

int main(void)
{
    test_table();
    test_round_trips();
    test_from_angles();
    test_rotate();
    test_matrices();
    test_rounded_matrices();
    test_rodrigues();
    test_rodrigues_half_turns();
    test_vectors();
    test_products();
    test_lengths();
    test_refusals();
    test_euler_subnormal();
    return check_finish("attitude");
}
