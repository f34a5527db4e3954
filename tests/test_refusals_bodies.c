/* What the functions of bodies refuse: jumps, inertias and balances, the broken rotor, the pendulum, torque-free
   rotation and the jumps of Lagrange's coordinates (chapters 2 to 4). Numbers and pointers that are none, masses and
   inertias that no body has, parts that never were in the whole, sums that overflow. The outputs must stay as they
   were. */
#include "jumps.h"
#include "refusals.h"

/* ---- Jumps: each number and each pointer spoiled ---- */

#define BLOW R(0.3), R(0.2), R(0.1), R(0.01), R(0.02), R(0.03), R(0.1), R(0.2), R(0.1)
#define RESTING2(mass, inertia, x) R(mass), R(inertia), R(x), R(0.2), R(0.3)
#define BODY2(mass, inertia, x) RESTING2(mass, inertia, x), R(1), R(-2), R(0.7)
#define BLOW2 R(0.3), R(0.2), R(0.01), R(0.1), R(0.2)

typedef int (*jump)(const vm_body *, const vm_body *, const vm_impulse *, vm_body *);
typedef int (*jump2)(const vm_body2 *, const vm_body2 *, const vm_impulse2 *, vm_body2 *);

/* what_matters: the size of the members of the whole that the function reads */
static int any_jump(trial *a, jump function, size_t what_matters)
{
    vm_body whole, part;
    vm_impulse blow;
    memset(&whole, 0, sizeof whole);
    take(a, &whole, what_matters);
    take(a, &part, sizeof part);
    take(a, &blow, sizeof blow);
    return function(POINTER(0, &whole), POINTER(1, &part), &blow, OUT(2, vm_body, 0));
}

static int any_jump2(trial *a, jump2 function, size_t what_matters)
{
    vm_body2 whole, part;
    vm_impulse2 blow;
    memset(&whole, 0, sizeof whole);
    take(a, &whole, what_matters);
    take(a, &part, sizeof part);
    take(a, &blow, sizeof blow);
    return function(POINTER(0, &whole), POINTER(1, &part), &blow, OUT(2, vm_body2, 0));
}

static int separate(trial *a) { return any_jump(a, vm_separate, sizeof(vm_body)); }
static int attach(trial *a) { return any_jump(a, vm_attach, sizeof(vm_body)); }
static int separate_relative(trial *a) { return any_jump(a, vm_separate_relative, offsetof(vm_body, v)); }
static int attach_relative(trial *a) { return any_jump(a, vm_attach_relative, offsetof(vm_body, v)); }
static int separate2(trial *a) { return any_jump2(a, vm_separate2, sizeof(vm_body2)); }
static int attach2(trial *a) { return any_jump2(a, vm_attach2, sizeof(vm_body2)); }
static int separate_relative2(trial *a) { return any_jump2(a, vm_separate_relative2, offsetof(vm_body2, vx)); }
static int attach_relative2(trial *a) { return any_jump2(a, vm_attach_relative2, offsetof(vm_body2, vx)); }

static int separate_for(trial *a)
{
    vm_body whole, part;
    vm_impulse blow;
    vm_vec3 v, omega;
    take(a, &whole, sizeof whole);
    take(a, &part, offsetof(vm_body, v));
    take(a, &blow, sizeof blow);
    take(a, &v, sizeof v);
    take(a, &omega, sizeof omega);
    part.v = part.omega = vmi_vec3(0, 0, 0); /* they are what is asked for */
    return vm_separation_for_rest(POINTER(0, &whole), POINTER(1, &part), &blow, &v, &omega, OUT(2, vm_body, 0));
}

static int separate_for2(trial *a)
{
    vm_body2 whole, part;
    vm_impulse2 blow;
    vm_real v[2], omega;
    take(a, &whole, sizeof whole);
    take(a, &part, sizeof part);
    take(a, &blow, sizeof blow);
    take(a, v, sizeof v);
    omega = next(a);
    return vm_separation_for_rest2(POINTER(0, &whole), POINTER(1, &part), &blow, v, &omega, OUT(2, vm_body2, 0));
}

static int separate_for_spin2(trial *a)
{
    vm_body2 whole, part;
    vm_impulse2 blow;
    take(a, &whole, sizeof whole);
    take(a, &part, offsetof(vm_body2, vx));
    take(a, &blow, sizeof blow);
    part.vx = part.vy = VM_NAN;
    part.omega = next(a); /* the velocity is what is asked for */
    return vm_separation_for_spin2(POINTER(0, &whole), POINTER(1, &part), &blow, next(a), OUT(2, vm_body2, 0));
}

static int relative(trial *a)
{
    static const vm_body b;
    return vm_to_relative(POINTER(0, &b), POINTER(1, &b), OUT(2, vm_body, 0));
}

static int absolute(trial *a)
{
    static const vm_body b;
    return vm_to_absolute(POINTER(0, &b), POINTER(1, &b), OUT(2, vm_body, 0));
}

static int relative2(trial *a)
{
    static const vm_body2 b;
    return vm_to_relative2(POINTER(0, &b), POINTER(1, &b), OUT(2, vm_body2, 0));
}

static int absolute2(trial *a)
{
    static const vm_body2 b;
    return vm_to_absolute2(POINTER(0, &b), POINTER(1, &b), OUT(2, vm_body2, 0));
}

static int balance(trial *a)
{
    vm_body before, after;
    vm_impulse blow;
    vm_vec3 about;
    take(a, &before, sizeof before);
    take(a, &after, sizeof after);
    take(a, &blow, sizeof blow);
    take(a, &about, sizeof about);
    return vm_balance_between(1, POINTER(0, &before), 1, POINTER(1, &after), &blow, about, OUT(2, vm_balance, 0));
}

static int combine(trial *a)
{
    vm_inertia first, second;
    vm_vec3 d;
    const vm_real m = next(a), n = next(a);
    take(a, &first, sizeof first);
    take(a, &second, sizeof second);
    take(a, &d, sizeof d);
    return vm_combine_inertia(m, POINTER(0, &first), n, POINTER(1, &second), d, OUT(2, vm_inertia, 0),
                              OUT(3, vm_vec3, 10));
}

static void test_jumps(void)
{
    REFUSES(separate, 3, BODY, PART, BLOW);
    REFUSES(attach, 3, BODY, PART, BLOW);
    REFUSES(separate_relative, 3, RESTING, PART, BLOW);
    REFUSES(attach_relative, 3, RESTING, PART, BLOW);
    REFUSES(separate2, 3, BODY2(3, 2, 0.1), BODY2(1, 0.1, 0.3), BLOW2);
    REFUSES(attach2, 3, BODY2(3, 2, 0.1), BODY2(1, 0.1, 0.3), BLOW2);
    REFUSES(separate_relative2, 3, RESTING2(3, 2, 0.1), BODY2(1, 0.1, 0.3), BLOW2);
    REFUSES(attach_relative2, 3, RESTING2(3, 2, 0.1), BODY2(1, 0.1, 0.3), BLOW2);
    REFUSES(balance, 3, BODY, PART, BLOW, R(0.1), R(0.2), R(0.3));
    REFUSES(combine, 4, 3, 2, R(0.4), R(0.5), R(0.6), 0, 0, 0, R(0.4), R(0.5), R(0.6), 0, 0, 0, 1, 2, 3);
    REFUSES(separate_for, 3, BODY, RESTING_PART, BLOW, 1, 2, 3, 3, 2, 1);
    REFUSES(separate_for2, 3, BODY2(3, 2, 0.1), BODY2(1, 0.1, 0.3), BLOW2, 1, 2, R(0.5));
    REFUSES(separate_for_spin2, 3, BODY2(3, 2, 0.1), RESTING2(1, 0.1, 0.3), BLOW2, R(0.1), R(0.5));
    REFUSES_NULL(relative, 3);
    REFUSES_NULL(absolute, 3);
    REFUSES_NULL(relative2, 3);
    REFUSES_NULL(absolute2, 3);
}

/* ---- Inputs that cannot be, and outputs that stay ---- */

/* A whole with a part in it, in space and in the plane, and impulses */
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

#define REFUSED(status, call) CHECK((call) == (status) && memcmp(&out, &kept, sizeof out) == 0)

static void prepare_inputs(void)
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

/* Any member of a body or an impulse: the structs are nothing but numbers. */
static void test_not_finite_member(vm_real bad)
{
    size_t k;
    for (k = 0; k < sizeof(vm_body) / sizeof(vm_real); k++) {
        vm_body x = in.b;
        ((vm_real *)(void *)&x)[k] = bad;
        REFUSED(VM_NOT_FINITE, vm_separate(&in.a, &x, NULL, &out.body));
        REFUSED(VM_NOT_FINITE, vm_attach(&x, &in.a, &in.j, &out.body));
        REFUSED(VM_NOT_FINITE, vm_separate_all(&in.a, 1, &x, NULL, &out.body));
        REFUSED(VM_NOT_FINITE, vm_attach_all(&x, 0, NULL, NULL, &out.body));
        REFUSED(VM_NOT_FINITE, vm_attach_relative(&in.a, &x, NULL, &out.body));
        REFUSED(VM_NOT_FINITE, vm_separation_for_rest(&in.a, &x, NULL, NULL, NULL, &out.body));
        REFUSED(VM_NOT_FINITE, vm_to_relative(&in.a, &x, &out.body));
        REFUSED(VM_NOT_FINITE, vm_to_absolute(&in.a, &x, &out.body));
    }
    for (k = 0; k < sizeof(vm_impulse) / sizeof(vm_real); k++) {
        vm_impulse x = in.j;
        vm_body point = rod(1, vector(1, 0, 0));
        ((vm_real *)(void *)&x)[k] = bad;
        REFUSED(VM_NOT_FINITE, vm_attach(&in.a, &in.b, &x, &out.body));
        REFUSED(VM_NOT_FINITE, vm_attach_all(&point, 0, NULL, &x, &out.body));
        REFUSED(VM_NOT_FINITE, vm_separation_for_rest(&in.a, &in.b, &x, NULL, NULL, &out.body));
        REFUSED(VM_NOT_FINITE, vm_balance_between(1, &in.a, 1, &in.b, &x, in.a.r, &out.sum));
    }
}

static void test_not_finite_member2(vm_real bad)
{
    size_t k;
    for (k = 0; k < sizeof(vm_body2) / sizeof(vm_real); k++) {
        vm_body2 x = in.b2;
        ((vm_real *)(void *)&x)[k] = bad;
        REFUSED(VM_NOT_FINITE, vm_separate2(&in.a2, &x, NULL, &out.body2));
        REFUSED(VM_NOT_FINITE, vm_attach2(&x, &in.a2, NULL, &out.body2));
        REFUSED(VM_NOT_FINITE, vm_attach_all2(&in.a2, 1, &x, NULL, &out.body2));
        REFUSED(VM_NOT_FINITE, vm_separation_for_rest2(&in.a2, &x, NULL, NULL, NULL, &out.body2));
        REFUSED(VM_NOT_FINITE, vm_to_relative2(&in.a2, &x, &out.body2));
        REFUSED(VM_NOT_FINITE, vm_to_absolute2(&in.a2, &x, &out.body2));
        REFUSED(VM_NOT_FINITE, vm_separation_for_spin2(&x, &in.b2, NULL, 0, &out.body2));
    }
    for (k = 0; k < sizeof(vm_impulse2) / sizeof(vm_real); k++) {
        vm_impulse2 x = in.j2;
        ((vm_real *)(void *)&x)[k] = bad;
        REFUSED(VM_NOT_FINITE, vm_attach2(&in.a2, &in.b2, &x, &out.body2));
    }
}

static void test_not_finite(vm_real bad)
{
    const vm_vec3 nowhere = vector(0, (double)bad, 0);
    vm_inertia i = in.i;
    test_not_finite_member(bad);
    test_not_finite_member2(bad);
    REFUSED(VM_NOT_FINITE, vm_separation_for_rest(&in.a, &in.b, NULL, &nowhere, NULL, &out.body));
    REFUSED(VM_NOT_FINITE, vm_separation_for_rest(&in.a, &in.b, NULL, NULL, &nowhere, &out.body));
    REFUSED(VM_NOT_FINITE, vm_separation_for_spin2(&in.a2, &in.b2, NULL, bad, &out.body2));
    REFUSED(VM_NOT_FINITE, vm_balance_between(1, &in.a, 1, &in.b, NULL, nowhere, &out.sum));
    REFUSED(VM_NOT_FINITE, vm_combine_inertia(1, &i, 1, &i, nowhere, &out.inertia, &out.centre));
    i.yz = bad;
    CHECK(!vm_inertia_is_possible(&i));
}

/* Null pointers where others than those of the trials may be null, and counts below 0 */
static void test_null(void)
{
    const vm_real wanted = 1;
    const vm_vec3 d = vector(1, 0, 0);
    REFUSED(VM_BAD_ARGUMENT, vm_separate_all(&in.a, -1, &in.b, NULL, &out.body));
    REFUSED(VM_BAD_ARGUMENT, vm_separate_all(&in.a, 1, NULL, NULL, &out.body));
    REFUSED(VM_BAD_ARGUMENT, vm_attach_all(NULL, 1, &in.b, NULL, &out.body));
    REFUSED(VM_BAD_ARGUMENT, vm_attach_relative(NULL, &in.b, NULL, &out.body));
    REFUSED(VM_BAD_ARGUMENT, vm_separate_relative(&in.a, NULL, NULL, &out.body));
    REFUSED(VM_BAD_ARGUMENT, vm_separation_for_rest(&in.a, NULL, NULL, NULL, NULL, &out.body));
    REFUSED(VM_BAD_ARGUMENT, vm_separation_for_rest(NULL, &in.b, NULL, NULL, NULL, &out.body));
    REFUSED(VM_BAD_ARGUMENT, vm_to_relative(&in.a, NULL, &out.body));
    REFUSED(VM_BAD_ARGUMENT, vm_to_absolute(NULL, &in.b, &out.body));
    REFUSED(VM_BAD_ARGUMENT, vm_separate2(NULL, &in.b2, NULL, &out.body2));
    REFUSED(VM_BAD_ARGUMENT, vm_attach2(&in.a2, NULL, NULL, &out.body2));
    REFUSED(VM_BAD_ARGUMENT, vm_attach_all2(&in.a2, -1, &in.b2, NULL, &out.body2));
    REFUSED(VM_BAD_ARGUMENT, vm_separate_relative2(NULL, &in.b2, NULL, &out.body2));
    REFUSED(VM_BAD_ARGUMENT, vm_attach_relative2(&in.a2, NULL, NULL, &out.body2));
    REFUSED(VM_BAD_ARGUMENT, vm_to_relative2(NULL, &in.b2, &out.body2));
    REFUSED(VM_BAD_ARGUMENT, vm_to_absolute2(&in.a2, NULL, &out.body2));
    REFUSED(VM_BAD_ARGUMENT, vm_separation_for_rest2(&in.a2, NULL, NULL, NULL, &wanted, &out.body2));
    REFUSED(VM_BAD_ARGUMENT, vm_separation_for_spin2(NULL, &in.b2, NULL, 1, &out.body2));
    REFUSED(VM_BAD_ARGUMENT, vm_balance_between(-1, &in.a, 1, &in.b, NULL, d, &out.sum));
    REFUSED(VM_BAD_ARGUMENT, vm_balance_between(1, NULL, 1, &in.b, NULL, d, &out.sum));
    REFUSED(VM_BAD_ARGUMENT, vm_balance_between(1, &in.a, 1, NULL, NULL, d, &out.sum));
    REFUSED(VM_BAD_ARGUMENT, vm_combine_inertia(1, NULL, 1, &in.i, d, &out.inertia, &out.centre));
    REFUSED(VM_BAD_ARGUMENT, vm_split_inertia(2, &in.i, 1, &in.i, d, &out.inertia, NULL));
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
    CHECK(isnan(vm_parallel_axes(NULL, 1, d).xx) && !vm_inertia_is_possible(NULL));
}

static void test_impossible_parts(void)
{
    const vm_real wanted[2] = {1, 2};
    const vm_vec3 d = vector(1, 0, 0);
    REFUSED(VM_BAD_MASS, vm_separate2(&in.b2, &in.a2, NULL, &out.body2));
    REFUSED(VM_BAD_MASS, vm_separate2(&in.b2, &in.b2, NULL, &out.body2)); /* the part is the whole */
    REFUSED(VM_BAD_MASS, vm_separate(&in.b, &in.b, NULL, &out.body));
    REFUSED(VM_BAD_MASS, vm_separate_relative2(&in.b2, &in.a2, NULL, &out.body2));
    REFUSED(VM_BAD_MASS, vm_split_inertia(1, &in.i, 1, &in.i, d, &out.inertia, &out.centre));
    in.b2.x = in.a2.x + 10;
    REFUSED(VM_BAD_INERTIA, vm_separate2(&in.a2, &in.b2, NULL, &out.body2)); /* it never was inside */
    REFUSED(VM_BAD_INERTIA, vm_separation_for_rest2(&in.a2, &in.b2, NULL, NULL, NULL, &out.body2));
    REFUSED(VM_BAD_INERTIA, vm_separation_for_spin2(&in.a2, &in.b2, NULL, 1, &out.body2));
    in.b2.inertia = -1;
    REFUSED(VM_BAD_INERTIA, vm_attach2(&in.a2, &in.b2, NULL, &out.body2));
    in.b.mass = in.b2.mass = 0; /* what the part's velocity would be divided by */
    REFUSED(VM_BAD_MASS, vm_separation_for_rest(&in.a, &in.b, NULL, &d, NULL, &out.body));
    REFUSED(VM_BAD_MASS, vm_separation_for_rest2(&in.a2, &in.b2, NULL, wanted, NULL, &out.body2));
    REFUSED(VM_BAD_MASS, vm_attach2(&in.a2, &in.b2, NULL, &out.body2));
}

/* Where several errors apply, the status is that of the first in the manual's table, whichever argument has it */
static void test_order_of_errors(void)
{
    const vm_vec3 nowhere = vector(0, (double)VM_NAN, 0);
    const vm_real not_a_number = VM_NAN;
    vm_body no_mass = in.b, not_finite = in.b, no_inertia = in.a;
    vm_body2 no_mass2 = in.b2, not_finite2 = in.b2, no_inertia2 = in.a2;
    vm_impulse nowhere_else = in.j;
    vm_impulse2 nowhere_else2 = in.j2;
    no_mass.mass = no_mass2.mass = -1;
    not_finite.v.x = not_finite2.vx = VM_INFINITY;
    no_inertia.inertia.xx = no_inertia2.inertia = -1;
    nowhere_else.at = nowhere;
    nowhere_else2.jx = VM_NAN;
    REFUSED(VM_BAD_ARGUMENT, vm_separate_all(&not_finite, -1, &in.b, NULL, &out.body));
    REFUSED(VM_BAD_ARGUMENT, vm_attach_all2(&not_finite2, -1, &in.b2, NULL, &out.body2));
    REFUSED(VM_NOT_FINITE, vm_attach(&no_mass, &not_finite, NULL, &out.body));
    REFUSED(VM_NOT_FINITE, vm_attach(&no_mass, &in.b, &nowhere_else, &out.body));
    REFUSED(VM_NOT_FINITE, vm_attach2(&no_mass2, &not_finite2, NULL, &out.body2));
    REFUSED(VM_NOT_FINITE, vm_attach2(&no_mass2, &in.b2, &nowhere_else2, &out.body2));
    REFUSED(VM_BAD_MASS, vm_attach(&no_inertia, &no_mass, NULL, &out.body));
    REFUSED(VM_BAD_MASS, vm_attach2(&no_inertia2, &no_mass2, NULL, &out.body2));
    REFUSED(VM_NOT_FINITE, vm_separation_for_rest(&no_mass, &in.b, NULL, &nowhere, NULL, &out.body));
    REFUSED(VM_NOT_FINITE, vm_separation_for_rest2(&no_mass2, &in.b2, NULL, NULL, &not_a_number, &out.body2));
    REFUSED(VM_NOT_FINITE, vm_separation_for_spin2(&no_mass2, &in.b2, NULL, VM_NAN, &out.body2));
    REFUSED(VM_NOT_FINITE, vm_torque_free_rotation(&no_mass, VM_NAN, &out.body));
    CHECK(vm_torque_free_rotation(&no_mass, 1, NULL) == VM_BAD_ARGUMENT);
}

static void test_bad_input(void)
{
    prepare_inputs();
    test_not_finite(VM_NAN);
    test_not_finite(VM_INFINITY);
    test_not_finite(-VM_INFINITY);
    test_null();
    test_order_of_errors();
    test_impossible_parts();
}

/* Masses that a part cannot have: more than the whole's, the whole's, none */
static void test_bad_masses(void)
{
    vm_body part, whole = whole_and_part(&part), x = part;
    x.mass = 6;
    REFUSED(VM_BAD_MASS, vm_separate(&whole, &x, NULL, &out.body));
    x.mass = whole.mass;
    REFUSED(VM_BAD_MASS, vm_separate(&whole, &x, NULL, &out.body));
    x.mass = -1;
    REFUSED(VM_BAD_MASS, vm_separate(&whole, &x, NULL, &out.body));
    REFUSED(VM_BAD_MASS, vm_attach(&whole, &x, NULL, &out.body));
    x.mass = 0;
    REFUSED(VM_BAD_MASS, vm_attach(&whole, &x, NULL, &out.body));
    x.mass = VM_NAN;
    REFUSED(VM_NOT_FINITE, vm_attach(&whole, &x, NULL, &out.body));
}

/* Inertias that no body has, and a part that never was inside the whole */
static void test_bad_inertias(void)
{
    vm_body part, whole = whole_and_part(&part), x = part;
    x.inertia.xx = -1;
    REFUSED(VM_BAD_INERTIA, vm_separate(&whole, &x, NULL, &out.body));
    x = part;
    x.inertia.xx = 1; /* 1 > 0.02 + 0.02 */
    REFUSED(VM_BAD_INERTIA, vm_attach(&whole, &x, NULL, &out.body));
    x = part;
    x.inertia.xy = R(0.5); /* moments 0.02 +- 0.5 */
    REFUSED(VM_BAD_INERTIA, vm_attach(&whole, &x, NULL, &out.body));
    x = part;
    x.r = vm_add(whole.r, vector(20, 0, 0));
    REFUSED(VM_BAD_INERTIA, vm_separate(&whole, &x, NULL, &out.body));
}

/* Motions that are no numbers, or whose momenta are not */
static void test_bad_motions(void)
{
    vm_body part, whole = whole_and_part(&part), x = part;
    x.omega.y = VM_INFINITY;
    REFUSED(VM_NOT_FINITE, vm_attach(&x, &whole, NULL, &out.body));
    x = whole;
    x.v.z = VM_MAX;
    part.v.z = -VM_MAX;
    REFUSED(VM_NOT_FINITE, vm_attach(&x, &part, NULL, &out.body));
    part.v = whole.v;
    REFUSED(VM_BAD_ARGUMENT, vm_separate(NULL, &part, NULL, &out.body));
    REFUSED(VM_BAD_ARGUMENT, vm_attach(&whole, NULL, NULL, &out.body));
    CHECK(vm_attach(&whole, &part, NULL, NULL) == VM_BAD_ARGUMENT);
}

/* Moments that form no triangle, by little or much, about each axis; in the first body and in the second */
static void test_no_triangle(void)
{
    const double excess[] = {is_float ? 1e-4 : 1e-12, 1e-3, 1};
    vm_body good = random_body(3, 1), whole;
    int i, k;
    for (i = 0; i < 3; i++) {
        for (k = 0; k < 3; k++) {
            vm_body bad = good;
            double moment[3] = {1, 2, 3};
            moment[k] = moment[(k + 1) % 3] + moment[(k + 2) % 3] + excess[i];
            bad.inertia = inertia(moment[0], 0, 0, moment[1], 0, moment[2]);
            CHECK(vm_attach(&good, &bad, NULL, &whole) == VM_BAD_INERTIA);
            CHECK(vm_attach(&bad, &good, NULL, &whole) == VM_BAD_INERTIA);
        }
    }
    good.q.y = VM_NAN;
    CHECK(vm_attach(&good, &good, NULL, &whole) == VM_NOT_FINITE);
}

/* ---- Inertias, masses and motions at the ends of the numbers ---- */

/* One number alone is no inertia of a body; none at all is a point's. */
static void test_single_moments(void)
{
    int i;
    for (i = 0; i < 6; i++) {
        vm_real numbers[6] = {0, 0, 0, 0, 0, 0};
        vm_inertia one;
        memcpy(&one, numbers, sizeof one);
        CHECK(vm_inertia_is_possible(&one));
        numbers[i] = 1;
        memcpy(&one, numbers, sizeof one);
        CHECK(!vm_inertia_is_possible(&one));
    }
}

/* Negative moments, also so small ones that the slack for rounding errors is 0 */
static void test_negative_moments(void)
{
    const vm_real tiny = VM_MIN * VM_EPSILON;
    vm_inertia i = {1, -1, 0, 0, 0, 0};
    CHECK(!vm_inertia_is_possible(&i));
    i.xx = tiny;
    i.yy = -tiny;
    CHECK(!vm_inertia_is_possible(&i));
    i.xx = 0;
    i.yy = tiny;
    i.zz = -tiny;
    CHECK(!vm_inertia_is_possible(&i));
}

/* Finite numbers whose products are not */
static void test_overflowing_bodies(void)
{
    const vm_vec3 origin = {0, 0, 0};
    vm_balance left;
    vm_body huge, point, whole;
    vm_body2 flat, other;
    memset(&huge, 0, sizeof huge);
    memset(&flat, 0, sizeof flat);
    huge.mass = VM_MAX;
    huge.v.x = 4;
    CHECK(vm_balance_between(0, NULL, 1, &huge, NULL, origin, &left) == VM_NOT_FINITE);
    huge.mass = VM_MAX / 2;
    huge.v.x = 1;
    huge.r.y = 64;
    CHECK(vm_balance_between(0, NULL, 1, &huge, NULL, origin, &left) == VM_NOT_FINITE);
    huge.r.y = 0;
    point = huge;
    point.r.x = 64;
    CHECK(vm_attach(&huge, &point, NULL, &whole) == VM_NOT_FINITE);
    flat.mass = VM_MAX / 2;
    other = flat;
    other.x = 64;
    CHECK(vm_attach2(&flat, &other, NULL, &flat) == VM_NOT_FINITE);
    CHECK(vm_balance_between(-1, NULL, 0, NULL, NULL, origin, &left) == VM_BAD_ARGUMENT);
    CHECK(vm_balance_between(0, NULL, -1, NULL, NULL, origin, &left) == VM_BAD_ARGUMENT);
}

/* Places and velocities at the end of the numbers, in the plane */
static void test_overflowing_laminas(void)
{
    const vm_body2 whole = {2, 3, VM_MAX, 0, 0, VM_MAX / 2, 0, 0}, part = {1, 1, VM_MAX, R(0.5), 0, -VM_MAX, 0, 3};
    vm_body2 rest;
    CHECK(vm_separate2(&whole, &part, NULL, &rest) == VM_NOT_FINITE);
}

/* ---- Lists of bodies ---- */

/* Each body of a list in turn has no mass; and lists of the largest masses, of which only the shortest can be added
 */
static void test_bad_lists(void)
{
    vm_body list[3], whole, result;
    vm_body2 flat[2], moving;
    int k, j;
    memset(list, 0, sizeof list);
    memset(flat, 0, sizeof flat);
    for (k = 0; k < 3; k++) list[k].v.x = (vm_real)k;
    whole = list[2];
    whole.mass = 1;
    for (k = 0; k < 3; k++) {
        for (j = 0; j < 3; j++) list[j].mass = j == k ? -1 : 1;
        result.mass = 7;
        CHECK(vm_attach_all(&whole, 3, list, NULL, &result) == VM_BAD_MASS && result.mass == 7);
        for (j = 0; j < 3; j++) list[j].mass = VM_MAX / 4 * 3;
        CHECK(vm_attach_all(&whole, k + 1, list, NULL, &result) == (k ? VM_NOT_FINITE : VM_OK));
        CHECK(result.mass == (k ? 7 : VM_MAX / 4 * 3));
    }
    flat[0].mass = -1;
    flat[1].mass = 1;
    moving.mass = 7;
    CHECK(vm_attach_all2(&flat[1], 2, flat, NULL, &moving) == VM_BAD_MASS && moving.mass == 7);
}

/* Attitudes that differ in one number, turns by pi: q.w is the whole's, and y is not, z is not, or x is not */
static void test_attitudes(void)
{
    const vm_vec3 about = {1, 2, 3};
    int k;
    for (k = 0; k < 3; k++) {
        vm_body before[2], whole;
        vm_balance left;
        memset(before, 0, sizeof before);
        memset(&left, 0, sizeof left);
        before[0].mass = 3;
        before[0].inertia = inertia(2, 0, 0, 2, 0, 3);
        before[0].omega.y = 1;
        before[0].q.x = 1;
        before[1].mass = 1;
        before[1].inertia = inertia(0.1, 0, 0, 0.2, 0, 0.3);
        before[1].q.x = k != 2;
        before[1].q.y = k == 0;
        before[1].q.z = k != 0;
        before[1].r.x = R(0.25);
        before[1].v.z = 2;
        before[1].omega.y = 2;
        CHECK(vm_attach(&before[0], &before[1], NULL, &whole) == VM_OK);
        CHECK(vm_balance_between(2, before, 1, &whole, NULL, about, &left) == VM_OK);
        check_error("attach", "attitudes", "eps",
                    (double)(vmi_norm1(left.momentum) + vmi_norm1(left.angular_momentum)) / eps, 64, k, 0);
    }
}

/* Inverse questions in the plane, of a part above the mass centre and of one at it, which cannot change the spin; and
   where only the velocity is asked for */
static void test_inverse2(void)
{
    const vm_body2 whole = {2, 3, 0, 0, 0, 0, 0, 0};
    const vm_real omega = 1, v[2] = {1, 2};
    vm_body2 part = {1, 1, 0, 0, 0, 0, 0, 0}, moving;
    moving.mass = 7;
    CHECK(vm_separation_for_spin2(&whole, &part, NULL, omega, &moving) == VM_SINGULAR);
    CHECK(moving.mass == 7);
    part.y = R(0.5);
    CHECK(vm_separation_for_spin2(&whole, &part, NULL, omega, &moving) == VM_OK);
    CHECK(vm_separate2(&whole, &moving, NULL, &moving) == VM_OK && moving.omega == omega);
    part.omega = 3;
    CHECK(vm_separation_for_rest2(&whole, &part, NULL, v, NULL, &moving) == VM_OK && moving.omega == 3);
    CHECK(vm_separate2(&whole, &moving, NULL, &moving) == VM_OK);
    check_error("separate for", "v alone", "eps", hypot((double)moving.vx - 1, (double)moving.vy - 2) / eps, 16, 0,
                0);
}

/* ---- The broken rotor ---- */

#define ROTOR 10, R(0.5), 4000, R(0.3), R(0.2), R(0.01)
#define STATE6 R(0.01), R(0.02), R(0.3), R(0.1), R(-0.2), 10

static int steady(trial *a)
{
    vm_broken_rotor r;
    take(a, &r, sizeof r);
    return value(a, vm_broken_rotor_steady_radius(POINTER(0, &r), next(a)));
}

static int growth(trial *a)
{
    vm_broken_rotor r;
    take(a, &r, sizeof r);
    return value(a, vm_broken_rotor_resonance_radius(POINTER(0, &r), next(a), 25));
}

static int char_poly(trial *a)
{
    vm_broken_rotor r;
    take(a, &r, sizeof r);
    return vm_broken_rotor_characteristic(POINTER(0, &r), next(a), OUT(1, vm_real, 0));
}

static int eigenvalues(trial *a)
{
    vm_broken_rotor r;
    take(a, &r, sizeof r);
    return vm_broken_rotor_eigenvalues(POINTER(0, &r), next(a), OUT(1, vm_real, 0), OUT(2, vm_real, 8));
}

static int routh(trial *a)
{
    vm_broken_rotor r;
    take(a, &r, sizeof r);
    return vm_broken_rotor_routh(POINTER(0, &r), next(a), OUT(1, vm_real, 0));
}

static int rotor_free(trial *a)
{
    vm_broken_rotor r;
    vm_real y[6];
    const vm_real t = next(a);
    take(a, &r, offsetof(vm_broken_rotor, s));
    take(a, y, sizeof y);
    r.s = 0;
    return vm_broken_rotor_free_motion(POINTER(0, &r), t, POINTER(1, y), OUT(2, vm_real, 0));
}

static int orbit(trial *a)
{
    vm_broken_rotor r;
    vm_real y[6] = {0};
    memset(&r, 0, sizeof r);
    take(a, &r, sizeof r);
    y[0] = next(a);
    y[3] = next(a);
    return vm_broken_rotor_orbit(POINTER(0, &r), POINTER(1, y), OUT(2, vm_real, 0));
}

static int break_off(trial *a)
{
    vm_broken_rotor r;
    vm_broken_rotor_piece piece;
    vm_real y[6];
    vm_broken_rotor_break *result = OUT(3, vm_broken_rotor_break, 0);
    int status;
    take(a, &r, sizeof r);
    take(a, y, sizeof y);
    take(a, &piece, sizeof piece);
    status = vm_broken_rotor_break_off(POINTER(0, &r), POINTER(1, y), POINTER(2, &piece), result);
    if (!status) result->stop_inertia = 0; /* it may be infinite, unlike the other results */
    return status;
}

static int to_polar(trial *a)
{
    vm_real y[6];
    take(a, y, sizeof y);
    return vm_broken_rotor_to_polar(POINTER(0, y), OUT(1, vm_real, 0));
}

static int from_polar(trial *a)
{
    vm_real y[6];
    take(a, y, sizeof y);
    return vm_broken_rotor_from_polar(POINTER(0, y), OUT(1, vm_real, 0));
}

/* The numbers of a break that are neither in a state nor stop_inertia */
static int has_finite_speeds(const vm_broken_rotor_break *b)
{
    return VM_IS_FINITE(b->dragging) && VM_IS_FINITE(b->gamma) && VM_IS_FINITE(b->beta) && VM_IS_FINITE(b->normal) &&
           VM_IS_FINITE(b->tangential) && VM_IS_FINITE(b->spin_piece) && VM_IS_FINITE(b->spin_rest);
}

/* The results of a break are finite at speeds up to the largest number, or the function refuses the speed. */
static void test_fast_breaks(void)
{
    const vm_broken_rotor rotor = {10, R(0.5), 4000, R(0.3), R(0.2), 0};
    vm_broken_rotor_break b;
    int i, refused = 0;
    for (i = 0; i < 2000; i++) {
        const vm_broken_rotor_piece piece = {1, R(0.001), R(0.1), R(uniform(-3, 3)), R(0.2), R(uniform(-3, 3))};
        const vm_real y[6] = {0, 0, 0, R(uniform(-1, 1)) * VM_MAX, R(uniform(-1, 1)) * VM_MAX, R(uniform(-10, 10))};
        const int status = vm_broken_rotor_break_off(&rotor, y, &piece, &b);
        CHECK(status == VM_NOT_FINITE || (status == VM_OK && has_finite_speeds(&b)));
        refused += status == VM_NOT_FINITE;
    }
    CHECK(refused > 0 && refused < 2000);
}

static void test_rotor(void)
{
    const vm_broken_rotor rotor = {ROTOR}, centred = {10, R(0.5), 4000, R(0.3), R(0.2), 0};
    REFUSES(steady, 1, ROTOR, 15);
    REFUSES(growth, 1, ROTOR, 3);
    REFUSES(char_poly, 2, ROTOR, 15);
    REFUSES(eigenvalues, 3, ROTOR, 15);
    REFUSES(routh, 2, ROTOR, 15);
    REFUSES(rotor_free, 3, 1, 10, R(0.5), 4000, R(0.3), R(0.2), STATE6);
    REFUSES(orbit, 3, ROTOR, 1, 2);
    REFUSES(break_off, 4, 10, R(0.5), 4000, R(0.3), R(0.2), 0, STATE6, 1, R(0.001), R(0.1), R(0.3), R(0.2), R(0.7));
    test_fast_breaks();
    REFUSES(to_polar, 2, STATE6);
    REFUSES(from_polar, 2, STATE6);
    CHECK(vm_broken_rotor_is_stable(&rotor, 15) && !vm_broken_rotor_is_stable(&centred, 15) && !vm_broken_rotor_is_stable(NULL, 15));
    CHECK(!vm_broken_rotor_is_stable(&rotor, VM_NAN) && !vm_broken_rotor_is_stable(&rotor, 25));
}

/* ---- The pendulum, and Lagrange's coordinates ---- */

static int pendulum(trial *a)
{
    vm_pendulum p;
    const vm_real part = next(a), Omega = next(a), ux = next(a), uy = next(a);
    memset(&p, 0, sizeof p); /* its padding, too, which is copied to the output */
    p.axes = VM_AXES_COS_SIN;
    p.mass = next(a);
    p.length = next(a);
    p.angle = next(a);
    p.rate = next(a);
    return vm_pendulum_separate(POINTER(0, &p), part, Omega, ux, uy, OUT(1, vm_pendulum_cut, 0));
}

/* Velocities, momentum and energy overflow one without the other. */
static void test_pendulum(void)
{
    const vm_real root = VM_SQRT(VM_MAX);
    const struct {
        vm_real part, Omega, ux, uy, mass, length, angle, rate;
    } cases[] = {{1, 0, 0, 0, 1, VM_MAX / 8, 1, 16},
                 {VM_EPSILON, 0, 0, VM_MAX / 8 * 7, 1, R(0.3), 0, VM_MAX / 8 * 7},
                 {1, 64 * root, 0, 0, root, 2, 0, 0},
                 {R(0.3), 1, 0, 0, 2, 1, R(0.3), VM_MAX / 4},
                 {R(0.3), 1, 0, 0, VM_MAX / 4, 4, R(0.3), 1}};
    size_t k;
    REFUSES(pendulum, 2, R(0.3), 1, R(0.1), R(0.2), 2, 1, R(0.3), 1);
    for (k = 0; k < sizeof cases / sizeof *cases; k++) {
        const vm_pendulum p = {cases[k].mass, cases[k].length, cases[k].angle, cases[k].rate, VM_AXES_COS_SIN};
        vm_pendulum_cut cut;
        cut.mass = 7;
        CHECK(vm_pendulum_separate(&p, cases[k].part, cases[k].Omega, cases[k].ux, cases[k].uy, &cut) ==
              VM_NOT_FINITE);
        CHECK(cut.mass == 7);
    }
}

/* Forces at no place, and moments about no turn, do no work. Rates that are no numbers are refused. */
static void test_lagrange(void)
{
    const vm_vec3 turn[2] = {{1, 0, 0}, {0, 2, 0}};
    const vm_real mass[4] = {2, 0, 0, 1}, blow[2] = {2, 1}, rates[2] = {VM_NAN, 0};
    vm_real Q[2] = {1, 1}, after[2] = {7, 7}, work[VM_LAGRANGE_WORK(2)];
    vm_lagrange_add_force(2, vmi_vec3(5, 5, 5), NULL, vmi_vec3(3, 4, 5), turn, Q);
    CHECK(Q[0] == 4 && Q[1] == 9);
    vm_lagrange_add_force(2, vmi_vec3(5, 6, 7), turn, vmi_vec3(3, 4, 5), NULL, Q);
    CHECK(Q[0] == 9 && Q[1] == 21);
    CHECK(vm_lagrange_impact(2, mass, rates, blow, after, work) == VM_NOT_FINITE && after[0] == 7 && after[1] == 7);
}

/* ---- Torque-free rotation ---- */

static int free_init(trial *a)
{
    vm_body b;
    take(a, &b, sizeof b);
    return vm_torque_free_init(OUT(0, vm_torque_free, 0), POINTER(1, &b), next(a));
}

static const vm_body spinning = {3, {R(0.4), R(0.5), R(0.6), 0, 0, 0}, {1, 0, 0, 0}, {1, 2, 3}, {1, 0, 0}, {1, 2, 1}};

static int free_at(trial *a)
{
    vm_torque_free motion;
    if (vm_torque_free_init(&motion, &spinning, 0)) return -1;
    return vm_torque_free_at(POINTER(0, &motion), next(a), OUT(1, vm_body, 0));
}

static int free_attitude(trial *a)
{
    vm_torque_free motion;
    if (vm_torque_free_init(&motion, &spinning, 0)) return -1;
    return vm_torque_free_attitude(POINTER(0, &motion), next(a), OUT(1, vm_quat, 0), OUT(2, vm_vec3, 8));
}

static void test_torque_free(void)
{
    REFUSES(free_init, 2, BODY, 0);
    REFUSES(free_init, 2, 3, R(0.5), R(0.5), R(0.6), 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 3, 0); /* symmetric */
    REFUSES(free_init, 2, 3, R(0.4), R(0.5), R(0.6), 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 3, 0); /* constant */
    REFUSES(free_at, 2, 1);
    REFUSES(free_attitude, 3, 1);
}

/* Attitudes that are no unit quaternions are accepted. A place that overflows is refused. */
static void test_torque_free_limits(void)
{
    vm_torque_free motion;
    vm_body b, later;
    memset(&b, 0, sizeof b);
    b.mass = 1;
    b.inertia = inertia(6, 0, 0, 4, 0, 3);
    b.omega = vector(-0.5, -0.75, -1);
    b.q.y = 1;
    CHECK(vm_torque_free_init(&motion, &b, 0) == VM_OK);
    b.q.y = 0;
    b.q.z = 1;
    b.v.x = VM_MAX / 4;
    later.mass = 7;
    CHECK(vm_torque_free_init(&motion, &b, 0) == VM_OK && vm_torque_free_at(&motion, 64, &later) == VM_NOT_FINITE);
    CHECK(later.mass == 7 && vm_torque_free_at(&motion, 1, &later) == VM_OK && later.r.x == VM_MAX / 4);
}

/* ---- Statuses ---- */

/* Every status has a text, and no two have the same. */
static void test_statuses(void)
{
    int i, k;
    for (i = VM_NOT_JOINED; i <= VM_TOLERANCE_MISSED; i++) {
        CHECK(strcmp(vm_strerror(i), vm_strerror(99)) != 0);
        for (k = VM_NOT_JOINED; k < i; k++) CHECK(strcmp(vm_strerror(i), vm_strerror(k)) != 0);
    }
    CHECK(strcmp(vm_strerror(VM_NOT_JOINED - 1), vm_strerror(99)) == 0);
}

/* ---- Vectors, a compound pendulum, a rotation in one call ---- */

static int turned(trial *a, int back)
{
    vm_quat q;
    vm_vec3 x;
    take(a, &q, sizeof q);
    take(a, &x, sizeof x);
    x = back ? vm_rotate_back(q, x) : vm_rotate(q, x);
    CHECK((x.x == x.x) == (x.y == x.y) && (x.y == x.y) == (x.z == x.z));
    return value(a, x.x);
}

static int rotate(trial *a) { return turned(a, 0); }
static int rotate_back(trial *a) { return turned(a, 1); }

static int euler_rates(trial *a)
{
    vm_vec3 omega;
    const vm_real psi = next(a), theta = next(a);
    take(a, &omega, sizeof omega);
    return vm_euler_313_rates(psi, theta, omega, OUT(0, vm_real, 0));
}

static int compound_cut(trial *a)
{
    vm_compound_pendulum p;
    vm_compound_part part;
    take(a, &p, sizeof p);
    take(a, &part, sizeof part);
    return vm_compound_pendulum_separate(POINTER(0, &p), POINTER(1, &part), OUT(2, vm_compound_cut, 0));
}

static int rotation_of(trial *a)
{
    vm_body b;
    take(a, &b, sizeof b);
    return vm_torque_free_rotation(POINTER(0, &b), next(a), OUT(1, vm_body, 0));
}

static void test_other_motions(void)
{
    const vm_compound_pendulum bar = {3, 4, 0, 1, 1};
    const vm_compound_part whole_inertia = {1, 4, 0, 0, 0, 0, 0};
    vm_compound_cut cut;
    REFUSES(rotate, 0, R(0.7), R(0.1), R(0.2), R(0.3), 1, 2, 3);
    REFUSES(rotate_back, 0, R(0.7), R(0.1), R(0.2), R(0.3), 1, 2, 3);
    REFUSES(euler_rates, 1, 1, R(0.5), 1, 2, 3);
    REFUSES(compound_cut, 3, 3, 4, R(0.7), R(0.6), R(1.3), R(0.75), R(0.02), R(0.2), R(0.3), R(0.4), R(-0.25), R(0.6));
    REFUSES_SPOILED(rotation_of, 2, BODY, 1);
    CHECK(vm_compound_pendulum_separate(&bar, &whole_inertia, &cut) == VM_BAD_INERTIA);
}

/* The right-hand sides of a rotor that cannot be */
static void test_impossible_rotors(void)
{
    vm_real y[VM_BROKEN_ROTOR_STATES] = {1, 1, 1, 1, 1, 1}, d[VM_BROKEN_ROTOR_STATES] = {0};
    const vm_broken_rotor good = {ROTOR};
    vm_broken_rotor r = good;
    CHECK(vm_broken_rotor_rhs(0, y, d, &r) == 0 && vm_broken_rotor_polar_rhs(0, y, d, &r) == 0);
    r.mass = 0;
    d[0] = 7;
    CHECK(vm_broken_rotor_rhs(0, y, d, &r) == VM_BAD_MASS && vm_broken_rotor_polar_rhs(0, y, d, &r) == VM_BAD_MASS);
    r = good;
    y[VM_BROKEN_ROTOR_RADIUS] = VM_NAN;
    CHECK(vm_broken_rotor_polar_rhs(0, y, d, &r) == VM_NOT_FINITE);
    y[VM_BROKEN_ROTOR_RADIUS] = 0;
    CHECK(vm_broken_rotor_polar_rhs(0, y, d, &r) == VM_DOMAIN && d[0] == 7);
}

int main(int argc, char **argv)
{
    read_refusal_rounds(argc, argv);
    test_jumps();
    test_bad_input();
    test_bad_masses();
    test_bad_inertias();
    test_bad_motions();
    test_no_triangle();
    test_single_moments();
    test_negative_moments();
    test_overflowing_bodies();
    test_overflowing_laminas();
    test_bad_lists();
    test_attitudes();
    test_inverse2();
    test_rotor();
    test_pendulum();
    test_lagrange();
    test_torque_free();
    test_torque_free_limits();
    test_statuses();
    test_other_motions();
    test_impossible_rotors();
    return check_finish("refusals bodies");
}
