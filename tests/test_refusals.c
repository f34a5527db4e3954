/* All headers: what is refused. Every number that a function takes is made NaN and infinite in turn, every pointer
   null; it must say so (a negative status, or NaN), and leave what it would have written as it was. */
#include "../varmass.h"
#include "check.h"

#define R(x) ((vm_real)(x))

enum { NUMBERS = 64, OUTPUT = 8192 };
typedef struct trial {
    union {
        double number;
        void *pointer;
    } alignment;                  /* of what follows it */
    unsigned char output[OUTPUT]; /* what the function writes */
    vm_real x[NUMBERS];           /* what it is given */
    int taken, null;              /* how many of them; which pointer is null, -1 for none */
    int is_value;                 /* what it writes is a value, which may be infinite */
} trial;

/* The next numbers of the trial, as a struct that has nothing else, or as a single one */
static void take(trial *a, void *numbers, size_t size)
{
    memcpy(numbers, a->x + a->taken, size);
    a->taken += (int)(size / sizeof(vm_real));
}
static vm_real next(trial *a) { return a->x[a->taken++]; }
#define POINTER(k, pointer) (a->null == (k) ? NULL : (pointer))
#define OUT(k, type, at) (a->null == (k) ? NULL : (type *)(void *)a->output + (at))

/* A function with a value: NaN is its refusal */
static int value(trial *a, vm_real y)
{
    if (y == y) memcpy(a->output, &y, sizeof y);
    a->is_value = 1;
    return y == y ? 0 : -1;
}

static void refuses(const char *name, int (*call)(trial *), const vm_real *good, int numbers, int pointers)
{
    const vm_real bad[3] = {VM_NAN, VM_INFINITY, -VM_INFINITY};
    static trial a;
    static unsigned char before[OUTPUT];
    int i, k, worked = 1;
    memset(before, 0x55, sizeof before);
    for (i = -1; i < numbers + pointers; i++) {
        for (k = 0; k < (i >= 0 && i < numbers ? 3 : 1); k++) {
            int status;
            memset(&a, 0, sizeof a);
            memcpy(a.x, good, (size_t)numbers * sizeof *good);
            memcpy(a.output, before, sizeof before);
            a.null = i >= numbers ? i - numbers : -1;
            if (i >= 0 && i < numbers) a.x[i] = bad[k];
            status = call(&a);
            if (i < 0) /* the first number is compared, since a struct's padding may be anything */
                worked = status >= 0 && memcmp(a.output, before, sizeof(vm_real)) != 0 && a.taken == numbers;
            else worked = status < 0 && memcmp(a.output, before, sizeof before) == 0;
            if (!worked) printf("%s: %s %d, status %d\n", name, i < numbers ? "number" : "pointer", i, status);
            CHECK(worked);
        }
    }
    for (i = 0; i < numbers; i++) { /* out of the range, or results out of it: refused or not, nothing by halves */
        const vm_real far[5] = {0, -good[i], VM_MAX / 2, -VM_MAX / 2, VM_MIN};
        for (k = 0; k < 5; k++) {
            memset(&a, 0, sizeof a);
            memcpy(a.x, good, (size_t)numbers * sizeof *good);
            memcpy(a.output, before, sizeof before);
            a.null = -1;
            a.x[i] = far[k];
            worked = call(&a) >= 0 || memcmp(a.output, before, sizeof before) == 0;
            if (!worked) printf("%s: number %d, %g\n", name, i, (double)far[k]);
            CHECK(worked);
        }
    }
}
/* Numbers of all sizes: what is given back is finite, or it is refused, and then nothing is written */
static int all_finite(const unsigned char *output, const unsigned char *before)
{
    vm_real x;
    int i;
    for (i = 0; i < OUTPUT; i += (int)sizeof x) {
        if (memcmp(output + i, before + i, sizeof x) == 0) continue;
        memcpy(&x, output + i, sizeof x);
        if (!VM_IS_FINITE(x)) return 0;
    }
    return 1;
}
static vm_real any_size(void)
{
    const int least = VM_MANT_DIG > 24 ? DBL_MIN_EXP : FLT_MIN_EXP,
              most = VM_MANT_DIG > 24 ? DBL_MAX_EXP : FLT_MAX_EXP;
    const vm_real size = (vm_real)ldexp(1, (int)uniform(least, most));
    return uniform(-1, 1) < 0 ? -size : size;
}
static int rounds = 400; /* of each function */
static void meets_all_sizes(const char *name, int (*call)(trial *), const vm_real *good, int numbers)
{
    static trial a;
    static unsigned char before[OUTPUT];
    int round, k, worked;
    memset(before, 0x55, sizeof before);
    for (round = 0; round < rounds; round++) {
        memset(&a, 0, sizeof a);
        memcpy(a.x, good, (size_t)numbers * sizeof *good);
        memcpy(a.output, before, sizeof before);
        a.null = -1;
        for (k = 0; k < 1 + round % 3; k++) a.x[(int)uniform(0, numbers)] = any_size();
        if (call(&a) < 0) worked = memcmp(a.output, before, sizeof before) == 0;
        else worked = a.is_value || all_finite(a.output, before);
        if (!worked) {
            printf("%s:", name);
            for (k = 0; k < numbers; k++) printf(" %g", (double)a.x[k]);
            printf("\n");
        }
        CHECK(worked);
    }
}

#define REFUSES(call, pointers, ...)                                             \
    do {                                                                         \
        const vm_real good[] = {__VA_ARGS__};                                    \
        refuses(#call, call, good, (int)(sizeof good / sizeof *good), pointers); \
        meets_all_sizes(#call, call, good, (int)(sizeof good / sizeof *good));   \
    } while (0)

#define REFUSES_NULL(call, pointers) refuses(#call, call, &nothing, 0, pointers)
static const vm_real nothing = 0;

/* -- jacobi.h, ateb.h -- */

static int agm_sncndn(trial *a)
{
    const vm_real u = next(a), m = next(a);
    vm_real sn, cn, dn;
    jacobi_agm_sncndn(u, m, 8, &sn, &cn, &dn);
    return cn == cn && dn == dn ? value(a, sn) : -1;
}
static int mean(trial *a)
{
    const vm_real alpha = next(a), p = next(a), q = next(a);
    return value(a, ateb_mean(alpha, p, q));
}
static int phase(trial *a)
{
    const vm_real sa = next(a), ca = next(a), alpha = next(a);
    return value(a, ateb_phase(sa, ca, alpha));
}
static int saca_nm(trial *a)
{
    const vm_real s = next(a), n = next(a), m = next(a);
    vm_real sa, ca;
    ateb_saca_nm(s, n, m, &sa, &ca);
    return ca == ca ? value(a, sa) : -1;
}
static int beta_inc(trial *a)
{
    const vm_real x = next(a), p = next(a), q = next(a);
    return value(a, ateb_beta_inc(x, p, q));
}
static int beta_inc_both(trial *a)
{
    const vm_real x = next(a), y = next(a), p = next(a), q = next(a);
    vm_real lower, upper;
    ateb_beta_inc_both(x, y, p, q, &lower, &upper);
    return upper == upper ? value(a, lower) : -1;
}
static int beta_inc_inv_both(trial *a)
{
    const vm_real x = next(a), y = next(a), p = next(a), q = next(a);
    vm_real lower, upper, ln;
    ateb_beta_inc_inv_both(x, y, p, q, &lower, &upper, &ln);
    return upper == upper && ln == ln ? value(a, lower) : -1;
}

static void test_special_functions(void)
{
    vm_real sn, cn, dn, p, q;
    REFUSES(agm_sncndn, 0, 1, R(0.5));
    REFUSES(mean, 0, 3, 2, 2);
    REFUSES(phase, 0, R(0.5), R(0.7), 3);
    REFUSES(saca_nm, 0, R(0.5), 2, 3);
    REFUSES(beta_inc, 0, R(0.5), 2, 3);
    REFUSES(beta_inc_both, 0, R(0.5), R(0.5), 2, 3);
    REFUSES(beta_inc_inv_both, 0, R(0.5), R(0.5), 2, 3);
    CHECK(isnan(jacobi_solve_K(VM_NAN)) && isnan(jacobi_solve_K(-1)) && isnan(jacobi_solve_K_m1(VM_NAN)));
    CHECK(isnan(jacobi_solve_K(VM_INFINITY)) && isnan(jacobi_solve_K_m1(VM_INFINITY)) &&
          isnan(jacobi_agm_K(-VM_INFINITY)));
    CHECK(isnan(jacobi_agm_K(VM_NAN)) && isnan(jacobi_agm_K(2)) && jacobi_agm_K(1) == VM_INFINITY);
    jacobi_agm_sncndn(1, 1, 8, &sn, &cn, &dn);
    CHECK(isnan(sn) || fabs((double)sn - tanh(1)) < 4 * (double)VM_EPSILON);
    ateb_beta_inc_both(R(0.5), R(0.25), 2, 3, &p, &q); /* no complement */
    CHECK(isnan(p) && isnan(q));
    ateb_beta_inc_inv_both(R(0.5), R(0.25), 2, 3, &p, &q, &sn);
    CHECK(isnan(p) && isnan(q) && isnan(sn));
    ateb_beta_inc_both(R(-0.5), R(1.5), 2, 3, &p, &q);
    CHECK(isnan(p) && isnan(q));
    CHECK(isnan(ateb_mean(3, 2, -1)) && isnan(ateb_mean(3, -1, 2)) && isnan(ateb_pi_nm(2, -1)));
}

/* -- Bodies and jumps -- */

#define RESTING \
    R(3), R(0.4), R(0.5), R(0.6), R(0.01), R(0.02), R(0.03), R(0.8), R(0.1), R(0.2), R(0.3), R(0.1), R(0.2), R(0.1)
#define BODY RESTING, R(1), R(-2), R(0.5), R(0.7), R(-0.4), R(1.1)
#define RESTING_PART R(0.5), R(0.01), R(0.01), R(0.01), 0, 0, 0, 1, 0, 0, 0, R(0.1), R(0.3), R(0.1)
#define PART RESTING_PART, 1, 2, R(0.5), R(0.7), R(0.4), R(0.1)
#define BLOW R(0.3), R(0.2), R(0.1), R(0.01), R(0.02), R(0.03), R(0.1), R(0.2), R(0.1)
#define RESTING2(mass, inertia, x) R(mass), R(inertia), R(x), R(0.2), R(0.3)
#define BODY2(mass, inertia, x) RESTING2(mass, inertia, x), R(1), R(-2), R(0.7)
#define BLOW2 R(0.3), R(0.2), R(0.01), R(0.1), R(0.2)

typedef int (*jump)(const vm_body *, const vm_body *, const vm_impulse *, vm_body *);
typedef int (*jump2)(const vm_body2 *, const vm_body2 *, const vm_impulse2 *, vm_body2 *);
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
    vm_balance left;
    vm_body huge, point, whole;
    vm_body2 flat, other;
    int i;
    memset(&huge, 0, sizeof huge);
    memset(&flat, 0, sizeof flat);
    REFUSES(separate, 3, BODY, PART, BLOW);
    REFUSES(attach, 3, BODY, PART, BLOW);
    REFUSES(separate_relative, 3, RESTING, PART, BLOW);
    REFUSES(attach_relative, 3, RESTING, PART, BLOW);
    REFUSES(separate2, 3, BODY2(3, 2, 0.1), BODY2(1, 0.1, 0.3), BLOW2);
    REFUSES(attach2, 3, BODY2(3, 2, 0.1), BODY2(1, 0.1, 0.3), BLOW2);
    REFUSES(separate_relative2, 3, RESTING2(3, 2, 0.1), BODY2(1, 0.1, 0.3), BLOW2);
    REFUSES(attach_relative2, 3, RESTING2(3, 2, 0.1), BODY2(1, 0.1, 0.3), BLOW2);
    REFUSES(balance, 3, BODY, PART, BLOW, R(0.1), R(0.2), R(0.3));
    REFUSES_NULL(relative, 3);
    REFUSES_NULL(absolute, 3);
    REFUSES_NULL(relative2, 3);
    REFUSES_NULL(absolute2, 3);
    for (i = 0; i < 6; i++) { /* an inertia of nothing but one number; a point's */
        vm_inertia one = {0, 0, 0, 0, 0, 0};
        CHECK(vm_inertia_possible(&one));
        (i == 0   ? &one.xx
         : i == 1 ? &one.yy
         : i == 2 ? &one.zz
         : i == 3 ? &one.xy
         : i == 4 ? &one.xz
                  : &one.yz)[0] = 1;
        CHECK(!vm_inertia_possible(&one));
    }
    huge.mass = VM_MAX;
    huge.v.x = 4; /* finite numbers whose products are not */
    CHECK(vm_balance_between(0, NULL, 1, &huge, NULL, vmi_vec3(0, 0, 0), &left) == VM_NOT_FINITE);
    huge.mass = VM_MAX / 2;
    huge.v.x = 1;
    huge.r.y = 64;
    CHECK(vm_balance_between(0, NULL, 1, &huge, NULL, vmi_vec3(0, 0, 0), &left) == VM_NOT_FINITE);
    huge.r.y = 0;
    point = huge;
    point.r.x = 64;
    CHECK(vm_attach(&huge, &point, NULL, &whole) == VM_NOT_FINITE);
    flat.mass = VM_MAX / 2;
    other = flat;
    other.x = 64;
    CHECK(vm_attach2(&flat, &other, NULL, &flat) == VM_NOT_FINITE);
    CHECK(vm_balance_between(-1, NULL, 0, NULL, NULL, vmi_vec3(0, 0, 0), &left) == VM_BAD_ARGUMENT);
    CHECK(vm_balance_between(0, NULL, -1, NULL, NULL, vmi_vec3(0, 0, 0), &left) == VM_BAD_ARGUMENT);
    REFUSES(combine, 4, 3, 2, R(0.4), R(0.5), R(0.6), 0, 0, 0, R(0.4), R(0.5), R(0.6), 0, 0, 0, 1, 2, 3);
    REFUSES(separate_for, 3, BODY, RESTING_PART, BLOW, 1, 2, 3, 3, 2, 1);
    REFUSES(separate_for2, 3, BODY2(3, 2, 0.1), BODY2(1, 0.1, 0.3), BLOW2, 1, 2, R(0.5));
    REFUSES(separate_for_spin2, 3, BODY2(3, 2, 0.1), RESTING2(1, 0.1, 0.3), BLOW2, R(0.1), R(0.5));
}

/* Lists with something bad in them, attitudes that differ in one number, sums that overflow, energies of nothing */
static void test_lists_of_bodies(void)
{
    const vm_real omega = 1;
    vm_body list[3], whole, result;
    vm_body2 flat[2], moving;
    vm_inertia i = {1, -1, 0, 0, 0, 0};
    vm_balance left;
    int k, j;
    memset(list, 0, sizeof list);
    memset(flat, 0, sizeof flat);
    memset(&left, 0, sizeof left);
    for (k = 0; k < 3; k++) {
        list[k].mass = 1;
        list[k].v.x = (vm_real)k;
    }
    whole = list[2];
    flat[0].mass = flat[1].mass = 1;
    for (k = 0; k < 3; k++) { /* each of them in turn without a mass; all of the largest mass */
        for (j = 0; j < 3; j++) list[j].mass = j == k ? -1 : 1;
        result.mass = 7;
        CHECK(vm_attach_all(&whole, 3, list, NULL, &result) == VM_BAD_MASS && result.mass == 7);
        for (j = 0; j < 3; j++) list[j].mass = VM_MAX / 4 * 3;
        CHECK(vm_attach_all(&whole, k + 1, list, NULL, &result) == (k ? VM_NOT_FINITE : VM_OK));
        CHECK(result.mass == (k ? 7 : VM_MAX / 4 * 3));
    }
    flat[0].mass = -1;
    moving.mass = 7;
    CHECK(vm_attach_all2(&flat[1], 2, flat, NULL, &moving) == VM_BAD_MASS && moving.mass == 7);
    for (k = 0; k < 3; k++) { /* turns by pi: q.w is the whole's, y is not, z is not, x is not */
        vm_body part;
        memset(&part, 0, sizeof part);
        memset(&whole, 0, sizeof whole);
        whole.mass = 3;
        whole.inertia.xx = 2;
        whole.inertia.yy = 2;
        whole.inertia.zz = 3;
        whole.omega.y = 1;
        part.mass = 1;
        part.inertia.xx = R(0.1);
        part.inertia.yy = R(0.2);
        part.inertia.zz = R(0.3);
        whole.q.x = 1;
        part.q.x = (k != 2);
        part.q.y = (k == 0);
        part.q.z = (k != 0);
        part.r.x = R(0.25);
        part.v.z = 2;
        part.omega.y = 2;
        CHECK(vm_attach(&whole, &part, NULL, &result) == VM_OK);
        list[0] = whole;
        list[1] = part;
        CHECK(vm_balance_between(2, list, 1, &result, NULL, vmi_vec3(1, 2, 3), &left) == VM_OK);
        check_error("attach", "attitudes", "eps",
                    (double)(vmi_norm1(left.momentum) + vmi_norm1(left.angular_momentum)) / (double)VM_EPSILON, 64, k,
                    0);
    }
    CHECK(!vm_inertia_possible(&i));
    i.xx = VM_MIN * VM_EPSILON;
    i.yy = -i.xx; /* whose slack is 0 */
    CHECK(!vm_inertia_possible(&i));
    i.zz = i.yy;
    i.yy = i.xx;
    i.xx = 0;
    CHECK(!vm_inertia_possible(&i));
    flat[0].mass = 2;
    flat[0].inertia = 3;
    flat[1].inertia = 1; /* a part above the mass centre; one at it */
    for (k = 0; k < 2; k++) {
        flat[1].y = k ? 0 : R(0.5);
        moving.mass = 7;
        CHECK(vm_separation_for_spin2(&flat[0], &flat[1], NULL, omega, &moving) == (k ? VM_SINGULAR : VM_OK));
        if (k) CHECK(moving.mass == 7);
        else CHECK(vm_separate2(&flat[0], &moving, NULL, &moving) == VM_OK && moving.omega == omega);
    }
    {
        const vm_real v[2] = {1, 2};
        flat[1].y = R(0.5);
        flat[1].omega = 3;
        CHECK(vm_separation_for_rest2(&flat[0], &flat[1], NULL, v, NULL, &moving) == VM_OK && moving.omega == 3);
        CHECK(vm_separate2(&flat[0], &moving, NULL, &moving) == VM_OK);
        check_error("separate for", "v alone", "eps",
                    hypot((double)moving.vx - 1, (double)moving.vy - 2) / (double)VM_EPSILON, 16, 0, 0);
    }
    flat[0].x = flat[1].x = VM_MAX;
    flat[0].vx = VM_MAX / 2;
    flat[1].vx = -VM_MAX; /* the end of numbers */
    flat[0].mass = 2;
    flat[1].mass = 1;
    CHECK(vm_separate2(&flat[0], &flat[1], NULL, &moving) == VM_NOT_FINITE);
}

/* -- The broken rotor, the pendulum -- */

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
    return value(a, vm_broken_rotor_resonance_radius(next(a), POINTER(0, &r), 25));
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
    return vm_broken_rotor_free_motion(t, POINTER(0, &r), POINTER(1, y), OUT(2, vm_real, 0));
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
    take(a, &r, sizeof r);
    take(a, y, sizeof y);
    take(a, &piece, sizeof piece);
    a->is_value = 1; /* energies may overflow where motions do not */
    return vm_broken_rotor_break_off(POINTER(0, &r), POINTER(1, y), POINTER(2, &piece), OUT(3, vm_broken_rotor_break, 0));
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
static int pendulum(trial *a)
{
    vm_pendulum p;
    const vm_real part = next(a), Omega = next(a), ux = next(a), uy = next(a);
    memset(&p, 0, sizeof p); /* its padding too, which all_finite reads in what becomes of it */
    p.axes = VM_AXES_COS_SIN;
    p.mass = next(a);
    p.length = next(a);
    p.angle = next(a);
    p.rate = next(a);
    return vm_pendulum_separate(POINTER(0, &p), part, Omega, ux, uy, OUT(1, vm_pendulum_cut, 0));
}

static void test_rotor(void)
{
    const vm_broken_rotor rotor = {ROTOR}, centred = {10, R(0.5), 4000, R(0.3), R(0.2), 0};
    vm_pendulum swing = {2, 1, R(0.3), 1, VM_AXES_COS_SIN};
    vm_pendulum_cut cut;
    REFUSES(steady, 1, ROTOR, 15);
    REFUSES(growth, 1, ROTOR, 3);
    REFUSES(char_poly, 2, ROTOR, 15);
    REFUSES(eigenvalues, 3, ROTOR, 15);
    REFUSES(routh, 2, ROTOR, 15);
    REFUSES(rotor_free, 3, 1, 10, R(0.5), 4000, R(0.3), R(0.2), STATE6);
    REFUSES(orbit, 3, ROTOR, 1, 2);
    REFUSES(break_off, 4, 10, R(0.5), 4000, R(0.3), R(0.2), 0, STATE6, 1, R(0.001), R(0.1), R(0.3), R(0.2), R(0.7));
    REFUSES(to_polar, 2, STATE6);
    REFUSES(from_polar, 2, STATE6);
    REFUSES(pendulum, 2, R(0.3), 1, R(0.1), R(0.2), 2, 1, R(0.3), 1);
    CHECK(vm_broken_rotor_is_stable(&rotor, 15) && !vm_broken_rotor_is_stable(&centred, 15) && !vm_broken_rotor_is_stable(NULL, 15));
    CHECK(!vm_broken_rotor_is_stable(&rotor, VM_NAN) && !vm_broken_rotor_is_stable(&rotor, 25));
    swing.rate = VM_MAX / 4; /* finite, but its energy is not */
    CHECK(vm_pendulum_separate(&swing, R(0.3), 1, 0, 0, &cut) == VM_NOT_FINITE);
    swing.rate = 1;
    swing.mass = VM_MAX / 4;
    swing.length = 4;
    CHECK(vm_pendulum_separate(&swing, R(0.3), 1, 0, 0, &cut) == VM_NOT_FINITE);
}

/* The pendulum's velocities, momentum and energy overflow one without the other */
static void test_pendulum_limits(void)
{
    const struct {
        vm_real part, Omega, uy, mass, length, angle, rate;
    } cases[3] = {{1, 0, 0, 1, VM_MAX / 8, 1, 16},
                  {VM_EPSILON, 0, VM_MAX / 8 * 7, 1, R(0.3), 0, VM_MAX / 8 * 7},
                  {1, 0, 0, VM_SQRT(VM_MAX), 2, 0, 0}};
    int k;
    for (k = 0; k < 3; k++) {
        vm_pendulum p = {0, 0, 0, 0, VM_AXES_COS_SIN};
        vm_pendulum_cut cut;
        p.mass = cases[k].mass;
        p.length = cases[k].length;
        p.angle = cases[k].angle;
        p.rate = cases[k].rate;
        cut.mass = 7;
        CHECK(vm_pendulum_separate(&p, cases[k].part, k < 2 ? 0 : 64 * VM_SQRT(VM_MAX), 0, cases[k].uy, &cut) ==
                  VM_NOT_FINITE &&
              cut.mass == 7);
    }
}

/* Forces without places, moments without turns; rates that are no numbers */
static void test_lagrange_limits(void)
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

/* -- Free rotation, streams -- */

static int free_init(trial *a)
{
    vm_body b;
    take(a, &b, sizeof b);
    return vm_torque_free_init(OUT(0, vm_torque_free, 0), POINTER(1, &b), next(a));
}
static int free_at(trial *a)
{
    const vm_body b = {3, {R(0.4), R(0.5), R(0.6), 0, 0, 0}, {1, 0, 0, 0}, {1, 2, 3}, {1, 0, 0}, {1, 2, 1}};
    vm_torque_free motion;
    if (vm_torque_free_init(&motion, &b, 0)) return -1;
    return vm_torque_free_at(POINTER(0, &motion), next(a), OUT(1, vm_body, 0));
}
static int free_attitude(trial *a)
{
    const vm_body b = {3, {R(0.4), R(0.5), R(0.6), 0, 0, 0}, {1, 0, 0, 0}, {1, 2, 3}, {1, 0, 0}, {1, 2, 1}};
    vm_torque_free motion;
    if (vm_torque_free_init(&motion, &b, 0)) return -1;
    return vm_torque_free_attitude(POINTER(0, &motion), next(a), OUT(1, vm_quat, 0), OUT(2, vm_vec3, 8));
}

/* rate, at, velocity, spin, gyration */
static void take_stream(trial *a, vm_stream *s)
{
    memset(s, 0, sizeof *s);
    s->rate = next(a);
    take(a, &s->at, sizeof s->at);
    take(a, &s->velocity, sizeof s->velocity);
    take(a, &s->spin, sizeof s->spin);
    take(a, &s->gyration, sizeof s->gyration);
}
#define STREAM R(-0.1), R(0.3), R(0.2), R(0.1), 1, 2, 3, R(0.1), R(0.2), R(0.3), R(0.01), R(0.01), R(0.01), 0, 0, 0

static int reactive_loads(trial *a)
{
    vm_body b;
    vm_stream s;
    vm_vec3 centre;
    take(a, &b, sizeof b);
    take_stream(a, &s);
    take(a, &centre, sizeof centre);
    return vm_reactive_loads(POINTER(0, &b), centre, 1, POINTER(1, &s), OUT(2, vm_reactive, 0));
}
static int accelerations(trial *a)
{
    vm_body b;
    vm_reactive loads;
    vm_vec3 force, moment;
    memset(&loads, 0, sizeof loads);
    take(a, &b, offsetof(vm_body, r));
    take(a, &loads, offsetof(vm_reactive, drift));
    b.r = b.v = b.omega = vmi_vec3(1, 2, 3);
    take(a, &force, sizeof force);
    take(a, &moment, sizeof moment);
    return vm_accelerations(POINTER(0, &b), POINTER(1, &loads), force, moment, OUT(2, vm_vec3, 0),
                            OUT(3, vm_vec3, 4));
}
static int flow_start(trial *a)
{
    vm_flow flow;
    vm_body b;
    vm_stream s;
    vm_store store;
    memset(&flow, 0, sizeof flow);
    take(a, &b, sizeof b);
    take_stream(a, &s);
    take(a, &store, sizeof store);
    take(a, &flow.centre, sizeof flow.centre);
    take(a, &flow.force, sizeof flow.force);
    take(a, &flow.moment, sizeof flow.moment);
    s.from = &store;
    flow.n = 1;
    flow.streams = POINTER(0, &s);
    return vm_flow_start(POINTER(1, &flow), POINTER(2, &b), OUT(3, vm_real, 0));
}
static int flow_body(trial *a)
{
    vm_flow flow;
    vm_real y[VM_FLOW_STATES];
    memset(&flow, 0, sizeof flow);
    take(a, y, VM_Y_CENTRE * sizeof *y);
    take(a, y + VM_Y_INERTIA, 6 * sizeof *y);
    y[VM_Y_CENTRE] = y[VM_Y_CENTRE + 1] = y[VM_Y_CENTRE + 2] = 0; /* not looked at */
    return vm_flow_body(POINTER(0, &flow), VM_FLOW_STATES, POINTER(1, y), OUT(2, vm_body, 0));
}
static int levi_civita(trial *a)
{
    const vm_real v0 = next(a), m0 = next(a), m = next(a), u = next(a);
    return value(a, vm_velocity_by_momentum(v0, m0, m, u, next(a)));
}
static int tsiolkovsky(trial *a)
{
    const vm_real v0 = next(a), m0 = next(a), m = next(a);
    return value(a, vm_tsiolkovsky(v0, m0, m, next(a)));
}
static int linear_flow(trial *a)
{
    vm_stream1 s = {0, 0, VM_RELATIVE};
    const vm_real t = next(a), x0 = next(a), v0 = next(a), m0 = next(a), force = next(a);
    s.rate = next(a);
    s.velocity = next(a);
    return vm_linear_flow(t, x0, v0, m0, force, POINTER(0, &s), OUT(1, vm_real, 0), OUT(2, vm_real, 1));
}
static int jet_damping(trial *a)
{
    vm_jet jet;
    vm_vec3 omega;
    const vm_real t = next(a);
    take(a, &jet, sizeof jet);
    take(a, &omega, sizeof omega);
    return vm_jet_damping(t, POINTER(0, &jet), omega, OUT(1, vm_vec3, 0));
}
static int stop_1(vm_real t, const vm_real *y, vm_flow1 *flow) { return (void)t, (void)y, (void)flow, 7; }
static int stop_2(vm_real t, const vm_real *y, vm_flow2 *flow) { return (void)t, (void)y, (void)flow, 7; }
static int stop_3(vm_real t, const vm_real *y, vm_flow *flow) { return (void)t, (void)y, (void)flow, 7; }

static void test_streams(void)
{
    vm_stream1 s1 = {R(-0.1), 2, VM_RELATIVE};
    vm_flow1 flow1 = {1, &s1, 0, stop_1, NULL, 0};
    vm_stream2 s2 = {R(-0.1), VM_RELATIVE, 0, 0, 0, 0, 0, 0};
    vm_flow2 flow2 = {1, &s2, 0, 0, 0, stop_2, NULL, 0};
    vm_flow flow;
    vm_stream1 late = {-1, 2, VM_ABSOLUTE};
    vm_real y[VM_FLOW_BALANCED_STATES] = {0, 1, 2}, rates[VM_FLOW_BALANCED_STATES], x, v;
    const vm_body b = {3, {R(0.4), R(0.5), R(0.6), 0, 0, 0}, {1, 0, 0, 0}, {1, 2, 3}, {1, 0, 0}, {1, 2, 1}};
    vm_jet jet = {-1, 1, 2, 1, R(0.1), 1, 1};
    vm_vec3 omega;
    memset(&flow, 0, sizeof flow);
    flow.update = stop_3;
    REFUSES(free_init, 2, BODY, 0);
    REFUSES(free_at, 2, 1);
    REFUSES(free_attitude, 3, 1);
    REFUSES(reactive_loads, 3, BODY, STREAM, R(0.1), R(0.2), R(0.3));
    REFUSES(accelerations, 4, 3, R(0.4), R(0.5), R(0.6), 0, 0, 0, 1, 0, 0, 0, 1, 2, 3, 1, 2, 3, 1, 2, 3, 1, 2, 3, 1,
            2, 3);
    REFUSES(flow_start, 4, BODY, STREAM, R(0.1), R(0.1), R(0.1), R(0.01), R(0.01), R(0.01), 0, 0, 0, 1, 2, 3, 1, 2,
            3, 1, 2, 3);
    REFUSES(flow_body, 3, 1, 2, 3, 1, 0, 0, 0, 1, 2, 3, R(0.1), R(0.2), R(0.3), 3, 2, 2, 2, 0, 0, 0);
    REFUSES(levi_civita, 0, 1, 3, 2, 1, R(0.5));
    REFUSES(tsiolkovsky, 0, 1, 3, 2, 1);
    REFUSES(linear_flow, 3, 1, 2, 3, 4, 1, R(-0.1), 2);
    REFUSES(jet_damping, 2, 1, R(-0.1), 1, 2, R(0.1), R(0.2), R(0.1), 1, 1, 2, 3);
    CHECK(vm_flow1_rhs(0, y, rates, &flow1) == 7 && vm_flow2_rhs(0, y, rates, &flow2) == 7);
    CHECK(vm_translation_rhs(0, y, rates, &flow) == 7 && vm_flow_carried_rhs(0, y, rates, &flow) == 7);
    CHECK(isnan(vm_velocity_by_momentum(1, -3, 2, 1, 0)) && isnan(vm_tsiolkovsky(1, -3, 2, 1)));
    CHECK(vm_linear_flow(1, 0, 0, -1, 0, &late, &x, &v) == VM_BAD_MASS);
    CHECK(vm_linear_flow(2, 0, 0, 1, 0, &late, &x, &v) == VM_BAD_MASS);
    late.motion = 77;
    CHECK(vm_linear_flow(R(0.1), 0, 0, 1, 0, &late, &x, &v) == VM_BAD_ARGUMENT);
    CHECK(vm_jet_damping(2, &jet, vmi_vec3(1, 2, 3), &omega) == VM_BAD_INERTIA); /* the axial moment is used up */
    jet.axial = -1;
    CHECK(vm_jet_damping(0, &jet, vmi_vec3(1, 2, 3), &omega) == VM_BAD_INERTIA);
    jet.axial = 1;
    jet.transverse = 0;
    CHECK(vm_jet_damping(0, &jet, vmi_vec3(1, 2, 3), &omega) == VM_BAD_INERTIA);
    {
        const vm_store store = {{0, 0, 0}, {0, 0, 0, 0, 0, 0}};
        vm_stream s;
        vm_reactive loads;
        memset(&s, 0, sizeof s);
        s.rate = -1;
        s.from = &store;
        CHECK(vm_reactive_loads(&b, vmi_vec3(0, 0, 0), 1, &s, &loads) == VM_STORED_STREAM);
        s.from = NULL;
        s.velocity.x = s.rate = VM_MAX / 2; /* each is finite */
        CHECK(vm_reactive_loads(&b, vmi_vec3(0, 0, 0), 1, &s, &loads) == VM_NOT_FINITE);
        s.velocity.x = 0;
        s.rate = VM_MAX / 8;
        s.at.y = 64;
        CHECK(vm_reactive_loads(&b, vmi_vec3(0, 0, 0), 1, &s, &loads) == VM_NOT_FINITE);
    }
}

static int force_1(vm_real t, const vm_real *y, vm_flow1 *flow) { return (void)y, flow->force = t, 0; }
static int force_3(vm_real t, const vm_real *y, vm_flow *flow) { return (void)y, flow->force.x = t, 0; }

/* Flows that are updated, without streams; on the separatrix in all octants; positions and loads that overflow */
static void test_stream_limits(void)
{
    const vm_body heavy = {VM_MIN, {0, 0, 0, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    vm_flow1 flow1 = {0, NULL, 0, force_1, NULL, 0};
    vm_flow2 flow2 = {0, NULL, 3, 4, 5, NULL, NULL, 0};
    vm_flow flow;
    vm_real y[VM_FLOW_STATES] = {0, 6, 2}, rates[VM_FLOW_STATES];
    vm_torque_free motion;
    vm_stream stream;
    vm_reactive loads;
    vm_body b, later;
    int k;
    memset(&flow, 0, sizeof flow);
    flow.update = force_3;
    CHECK(vm_flow1_rhs(5, y, rates, &flow1) == 0 && rates[0] == 3 && rates[1] == 5 && rates[2] == 0);
    y[3] = 8;
    y[6] = 2;
    CHECK(vm_translation_rhs(5, y, rates, &flow) == 0 && rates[0] == 4 && rates[3] == 5 && rates[6] == 0);
    y[2] = 1;
    y[3] = 2;
    y[4] = 4;
    y[5] = 6;
    y[6] = 2;
    y[7] = y[8] = 0;
    y[9] = 3;
    CHECK(vm_flow2_rhs(0, y, rates, &flow2) == 0 && rates[0] == 1 && rates[1] == 2 && rates[2] == 2);
    CHECK(rates[3] == 3 && rates[4] == 4 && rates[5] == 5 && rates[6] == 0 && rates[9] == 0);
    memset(&b, 0, sizeof b);
    b.mass = 1;
    b.inertia.xx = 6;
    b.inertia.yy = 4;
    b.inertia.zz = 3;
    for (k = 0; k < 8; k++) { /* 3 (4 - 3) w_z^2 = 6 (6 - 4) w_x^2: omega tends to the middle axis */
        vm_vec3 h, h_later;
        b.omega = vmi_vec3(k & 1 ? R(-0.5) : R(0.5), k & 2 ? R(-0.75) : R(0.75), k & 4 ? -1 : 1);
        CHECK(vm_torque_free_rotation(&b, 3, &later) == VM_OK);
        h = vm_angular_momentum(&b, b.r);
        h_later = vm_angular_momentum(&later, b.r);
        check_error("free rotation", "separatrix", "eps",
                    (double)vmi_norm1(vmi_sub(h, h_later)) / (double)VM_EPSILON, 100, k, 0);
        check_error("free rotation", "separatrix", "eps",
                    fabs((double)(vm_kinetic_energy(&b) - vm_kinetic_energy(&later))) / (double)VM_EPSILON, 100, k,
                    0);
    }
    b.q.y = 1;
    CHECK(vm_torque_free_init(&motion, &b, 0) == VM_OK);
    b.q.y = 0;
    b.q.z = 1;
    b.v.x = VM_MAX / 4;
    later.mass = 7;
    CHECK(vm_torque_free_init(&motion, &b, 0) == VM_OK && vm_torque_free_at(&motion, 64, &later) == VM_NOT_FINITE);
    CHECK(later.mass == 7 && vm_torque_free_at(&motion, 1, &later) == VM_OK && later.r.x == VM_MAX / 4);
    memset(&stream, 0, sizeof stream);
    stream.rate = -64;
    stream.at.x = 64;
    loads.mass_rate = 7;
    CHECK(vm_reactive_loads(&heavy, vmi_vec3(0, 0, 0), 1, &stream, &loads) == VM_NOT_FINITE &&
          loads.mass_rate == 7);
}

/* -- The drum, Lagrange's equations -- */

#define DRUM R(0.5), 10, 2, R(0.1), 3, R(0.05), 4000, 20

static int drum_at(trial *a)
{
    vm_drum d;
    const vm_real phi = next(a);
    take(a, &d, offsetof(vm_drum, speed));
    d.speed = 3;
    d.damping = 0;
    d.stiffness = 4000;
    d.omega = 20;
    return vm_drum_at(phi, POINTER(0, &d), OUT(1, vm_drum_geometry, 0));
}
/* What the motion of a rigid shaft needs: neither mass nor stiffness */
static vm_drum turning_drum(trial *a)
{
    vm_drum d = {0, 10, 0, 0, 0, 0, 4000, 0};
    d.radius = next(a);
    d.inertia = next(a);
    d.band = next(a);
    d.speed = next(a);
    d.damping = next(a);
    d.omega = next(a);
    return d;
}
static int drum_rate(trial *a)
{
    const vm_real phi = next(a);
    const vm_drum d = turning_drum(a);
    return value(a, vm_drum_rate(phi, POINTER(0, &d)));
}
static int drum_angle(trial *a)
{
    const vm_real t = next(a);
    const vm_drum d = turning_drum(a);
    return value(a, vm_drum_angle(t, POINTER(0, &d)));
}
static int shaft_init(trial *a)
{
    vm_drum d;
    take(a, &d, sizeof d);
    return vm_drum_shaft_init(POINTER(0, &d), OUT(1, vm_drum_shaft, 0));
}
static int deflection(trial *a)
{
    vm_drum_shaft s;
    const vm_real phi = next(a), amplitude = next(a), alpha = next(a), particular = next(a);
    s.k = next(a);
    s.A = next(a);
    s.delta = R(0.02);
    s.shift = 0;
    return value(a, vm_drum_deflection(phi, POINTER(0, &s), amplitude, alpha, particular));
}

static vm_real kinetic(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, void *ctx)
{
    (void)t;
    (void)ctx;
    return masses[0] * ((1 + q[0] * q[0]) * rates[0] * rates[0] + rates[1] * rates[1]) / 2;
}
static void one_mass(vm_real t, const vm_real *q, vm_real *masses, void *ctx)
{
    (void)q;
    (void)ctx;
    masses[0] = 2 - t;
}
static vm_real frozen_work[VM_LAGRANGE_RHS_WORK(2, 1)];
static vm_lagrange_system system_of_two(void)
{
    const vm_lagrange_system l = {2, 1, one_mass, kinetic, NULL, NULL, NULL, frozen_work};
    return l;
}
static int lagrange_start(trial *a)
{
    vm_lagrange_system l = system_of_two();
    vm_real q[2], rates[2];
    const vm_real t = next(a);
    take(a, q, sizeof q);
    take(a, rates, sizeof rates);
    return vm_lagrange_start(POINTER(0, &l), t, POINTER(1, q), POINTER(2, rates), OUT(3, vm_real, 0));
}
static int lagrange_rates(trial *a)
{
    vm_lagrange_system l = system_of_two();
    const vm_real y[4] = {1, 1, 1, 1};
    return vm_lagrange_rates(POINTER(0, &l), 0, POINTER(1, y), OUT(2, vm_real, 0));
}
static int frozen_derivative(trial *a)
{
    vm_lagrange_system l = system_of_two();
    vm_real q[2], rates[2];
    q[0] = rates[0] = rates[1] = q[1] = 1;
    return value(a, vm_lagrange_partial_q(POINTER(0, &l), 0, POINTER(1, q), POINTER(2, rates), 1));
}

static void test_lagrange(void)
{
    const vm_real scales[2] = {2, R(0.5)}, q[2] = {R(0.3), R(0.2)}, rates[2] = {1, 2};
    vm_lagrange_system l = system_of_two();
    vm_real y[4], derivative;
    int i;
    REFUSES(drum_at, 2, 1, R(0.5), 10, 2, R(0.1));
    REFUSES(drum_rate, 1, 1, R(0.5), 2, R(0.1), 3, R(0.05), 20);
    REFUSES(drum_angle, 1, 1, R(0.5), 2, R(0.1), 3, R(0.05), 20);
    REFUSES(shaft_init, 2, DRUM);
    REFUSES(deflection, 1, 1, R(0.1), R(0.2), R(0.3), 2, R(0.01));
    REFUSES(lagrange_start, 4, 1, R(0.3), R(0.2), 1, 2);
    REFUSES_NULL(lagrange_rates, 3);
    REFUSES_NULL(frozen_derivative, 3);
    CHECK(isnan(vm_lagrange_partial_q(&l, 0, q, rates, -1)) && isnan(vm_lagrange_partial_q(&l, 0, q, rates, 2)));
    derivative = vm_lagrange_partial_q(&l, 0, q, rates, 0);
    l.scales = scales; /* the difference's steps are others, the derivative m q q'^2 is not */
    check_error("dT/dq", "scales", "eps",
                fabs((double)(vm_lagrange_partial_q(&l, 0, q, rates, 0) - derivative)) / (double)VM_EPSILON, 250, 0,
                0);
    for (i = 0; i < 6; i++) {
        l = system_of_two();
        if (i == 0) l.n = 0;
        if (i == 1) l.n_masses = -1;
        if (i == 2) l.energy = NULL;
        if (i == 3) l.work = NULL;
        if (i == 4) l.masses = NULL;
        CHECK(vm_lagrange_start(i == 5 ? NULL : &l, 0, q, rates, y) == VM_BAD_ARGUMENT);
    }
}

/* A drum without a band that a motor drives; one whose band just balances the rest; a shaft whose terms overflow */
static void test_drum_limits(void)
{
    const vm_real t = 50;
    vm_drum d = {R(0.5), 10, 2, 0, 3, -2, 4000, 20};
    vm_drum_shaft shaft;
    vm_real furthest = 0;
    int i;
    check_error("drum", "no band", "eps", /* phi' = Omega + |D| phi/J0 */
                ERROR_EPS(vm_drum_angle(t, &d), 20 * expm1(50), 0, 20 * expm1(50)), 64, (double)t, 0);
    d.band = R(0.25); /* the argument of Lambert's function at t = 0, where rounding may take it beyond -1/e */
    for (i = 0; i < 2000; i++) {
        vm_real phi;
        d.damping = (vm_real)uniform(-2, 0.25);
        phi = VM_FABS(vm_drum_angle_lambert(0, &d));
        if (phi > furthest) furthest = phi;
        d.damping = R(0.375) + VM_SQRT(VM_EPSILON) * (vm_real)uniform(-4, 4); /* next to e = 0 it is wrong */
        phi = vm_drum_angle_lambert(0, &d);
        CHECK(phi == phi || vmi_drum_e(&d).hi == 0);
    }
    check_error("drum, Lambert", "t = 0", "eps", (double)(furthest / VM_EPSILON), 1e4, 0, 0);
    d.mass = 1;
    d.inertia = 1;
    d.radius = 1;
    d.band = 0;
    d.omega = 1;
    d.damping = -VM_MAX / 4 * 3;
    shaft.k = 7;
    CHECK(vm_drum_shaft_init(&d, &shaft) == VM_NOT_FINITE && shaft.k == 7);
}

/* -- Oscillators -- */

static int osc_energy(trial *a)
{
    const vm_real x = next(a), v = next(a), omega0 = next(a);
    return value(a, vm_osc_energy(x, v, omega0, next(a)));
}
static int osc_amplitude(trial *a)
{
    const vm_real x = next(a), v = next(a), omega0 = next(a);
    vm_real A, psi;
    vm_osc_amplitude_phase(x, v, omega0, next(a), &A, &psi);
    return psi == psi ? value(a, A) : -1;
}
static int osc_period(trial *a)
{
    const vm_real x0 = next(a), omega0 = next(a);
    return value(a, vm_osc_period(x0, omega0, next(a)));
}
static vm_law law_of(trial *a, int kind)
{
    vm_law law = vm_law_linear(next(a), next(a));
    law.kind = kind;
    law.f2 = next(a);
    return law;
}
static int law_at_of(trial *a, int kind)
{
    const vm_real t = next(a);
    const vm_law law = law_of(a, kind);
    return vm_law_at(POINTER(0, &law), t, OUT(1, vm_real, 0), OUT(2, vm_real, 1));
}
static int law_quadratic(trial *a) { return law_at_of(a, VM_LAW_QUADRATIC); }
static int law_power(trial *a) { return law_at_of(a, VM_LAW_POWER); }
static int law_exponential(trial *a)
{
    const vm_real t = next(a), f0 = next(a);
    const vm_law law = vm_law_exponential(f0, next(a));
    return vm_law_at(POINTER(0, &law), t, OUT(1, vm_real, 0), OUT(2, vm_real, 1));
}
static int law_integral(trial *a)
{
    const vm_real t = next(a);
    const vm_law law = law_of(a, VM_LAW_QUADRATIC);
    return vm_law_inverse_integral(POINTER(0, &law), t, OUT(1, vm_real, 0));
}

/* x, v, reactive, damping, alpha and both laws */
static vm_osc_problem osc_problem(trial *a)
{
    vm_osc_problem o;
    memset(&o, 0, sizeof o);
    o.x = next(a);
    o.v = next(a);
    o.reactive = next(a);
    o.damping = next(a);
    o.alpha = next(a);
    o.mass.f0 = next(a);
    o.mass.f1 = next(a);
    o.stiffness.f0 = next(a);
    o.stiffness.f1 = next(a);
    return o;
}
#define PROBLEM R(0.1), R(0.2), 1, R(0.01), 3, 2, R(0.01), 3, R(0.02)
static int osc_plan(trial *a)
{
    const vm_osc_problem o = osc_problem(a);
    a->is_value = 1; /* what is in a plan is its own affair */
    return vm_osc_plan_init(OUT(0, vm_osc_plan, 0), POINTER(1, &o));
}
static int osc_by(trial *a)
{
    const vm_osc_problem o = osc_problem(a);
    const vm_real t = next(a);
    return vm_osc_by_route(POINTER(0, &o), VM_ROUTE_SECOND, t, next(a), OUT(1, vm_osc_motion, 0));
}
static int osc_at(trial *a)
{
    const vm_osc_problem o = osc_problem(a);
    const vm_real t = next(a);
    return vm_osc_within(POINTER(0, &o), t, next(a), OUT(1, vm_osc_motion, 0));
}
static int osc_averaged(trial *a)
{
    const vm_real now[9] = {PROBLEM};
    const vm_real t = next(a), A = next(a);
    trial other;
    vm_osc_problem o;
    vm_osc_plan p;
    memset(&other, 0, sizeof other);
    memcpy(other.x, now, sizeof now);
    o = osc_problem(&other);
    if (vm_osc_plan_init(&p, &o)) return -1;
    return vm_osc_averaged(POINTER(0, &p), VM_ROUTE_TRIG, t, A, OUT(1, vm_real, 0), OUT(2, vm_real, 1),
                           OUT(3, vm_real, 2));
}

static int calls, fails_after;
static int failing_law(vm_real t, vm_real *f, vm_real *rate, void *ctx)
{
    (void)ctx;
    *f = 2 + t / 10;
    *rate = R(0.1);
    return ++calls > fails_after;
}

static void test_oscillators(void)
{
    const vm_real now[9] = {PROBLEM}, times[4] = {0, 1, 2, 3}, values[4] = {1, 2, 3, 4};
    trial a;
    vm_osc_problem o;
    vm_osc_plan p;
    vm_osc_motion m;
    vm_law law;
    vm_real f, rate, twice[4], unsorted[4] = {0, 2, 1, 3}, bad[4] = {1, 2, 3, 4};
    int i;
    REFUSES(osc_energy, 0, R(0.1), R(0.2), 2, 3);
    REFUSES(osc_amplitude, 0, R(0.1), R(0.2), 2, 3);
    REFUSES(osc_period, 0, R(0.1), 2, 3);
    REFUSES(law_quadratic, 3, R(0.5), 3, R(0.1), R(0.01));
    REFUSES(law_power, 3, R(0.5), 3, R(0.1), 2);
    REFUSES(law_exponential, 3, R(0.5), 3, R(0.1));
    REFUSES(law_integral, 2, R(0.5), 3, R(0.1), R(0.01));
    REFUSES(osc_plan, 2, PROBLEM);
    rounds = 0; /* these may integrate for long */
    REFUSES(osc_by, 2, PROBLEM, R(0.3), R(0.01));
    REFUSES(osc_at, 2, PROBLEM, R(0.3), R(0.1));
    rounds = 400;
    REFUSES(osc_averaged, 4, R(0.3), R(0.1));
    memset(&a, 0, sizeof a);
    memcpy(a.x, now, sizeof now);
    o = osc_problem(&a);
    CHECK(vm_osc_plan_init(&p, &o) == VM_OK);
    CHECK(vm_osc_averaged(&p, -1, 0, 1, &f, &rate, twice) == VM_BAD_ARGUMENT);
    CHECK(vm_osc_averaged(&p, VM_ROUTE_SECOND, 0, 1, &f, &rate, twice) == VM_BAD_ARGUMENT);
    CHECK(vm_osc_averaged(&p, VM_ROUTE_TRIG, 0, -1, &f, &rate, twice) == VM_BAD_ARGUMENT);
    CHECK(vm_osc_averaged(&p, VM_ROUTE_TRIG, -1000, 1, &f, &rate, twice) == VM_BAD_MASS);
    p.has_ateb = 0; /* without a plan the same wave */
    CHECK(vm_osc_averaged(&p, VM_ROUTE_ATEB, 0, 1, &f, &rate, twice) == VM_OK);
    law = vm_law_linear(1, 0);
    law.kind = 77;
    CHECK(vm_law_at(&law, 0, &f, &rate) == VM_BAD_ARGUMENT &&
          vm_law_inverse_integral(&law, 1, &f) == VM_BAD_ARGUMENT);
    law = vm_law_linear(1, -1);
    CHECK(vm_law_at(&law, 2, &f, &rate) == VM_BAD_MASS && vm_law_inverse_integral(&law, 2, &f) == VM_BAD_MASS);
    law = vm_law_quadratic(1, -3, 2); /* negative between its ends */
    CHECK(vm_law_inverse_integral(&law, 2, &f) == VM_BAD_MASS &&
          vm_law_inverse_integral(&law, R(0.25), &f) == VM_OK);
    for (i = 0; i < 8; i++) { /* a table that is none */
        bad[2] = i == 4 ? -1 : i == 5 ? VM_NAN : 3;
        unsorted[2] = i == 7 ? VM_NAN : 1;
        law = vm_law_table(i == 0 ? 1 : 4,
                           i == 1             ? NULL
                           : i == 3 || i == 7 ? unsorted
                                              : times,
                           i == 2           ? NULL
                           : i > 3 && i < 6 ? bad
                                            : values);
        CHECK(vm_law_inverse_integral(&law, i == 6 ? 4 : 1, &f) < 0);
        CHECK((i > 2 && i != 6) || vm_law_at(&law, i == 6 ? -1 : 1, &f, &rate) == VM_BAD_ARGUMENT);
    }
    for (fails_after = 0; fails_after < 40; fails_after++) { /* a law that fails at each of its calls */
        law = vm_law_user(failing_law, NULL);
        calls = 0;
        CHECK(vm_law_inverse_integral(&law, 1, &f) < 0 || fails_after >= calls);
        o.mass = law;
        for (i = VM_ROUTE_TRIG; i <= VM_ROUTE_RK87; i++) {
            int status;
            memset(&m, 0x55, sizeof m);
            calls = 0;
            status = vm_osc_by_route(&o, i, 1, 0, &m);
            if (calls > fails_after) CHECK(status < 0);
        }
        calls = 0;
        CHECK(vm_osc_within(&o, 1, 0, &m) < 0 || fails_after >= calls);
    }
}

/* Laws by tables and functions: two points, values out of range far off, backward, beside closed forms */
static int even_law(vm_real t, vm_real *f, vm_real *rate, void *ctx)
{
    (void)ctx;
    *f = 2 + t * t / 8;
    *rate = t / 4;
    return 0;
}

static void test_laws(void)
{
    const vm_real steps[2] = {1, 3}, two[2] = {2, 6};
    vm_real times[9], values[9], f = 7, rate = 7;
    vm_osc_problem o;
    vm_osc_motion forward, back, m;
    vm_law law = vm_law_table(2, steps, two);
    int i;
    CHECK(vm_law_at(&law, R(1.5), &f, &rate) == VM_OK && f == 3 && rate == 2);
    law = vm_law_quadratic(1, 0, VM_MAX);
    CHECK(vm_law_at(&law, 0, &f, &rate) == VM_NOT_FINITE && f == 3 && rate == 2);
    for (i = 0; i < 9; i++) {
        times[i] = (vm_real)(i - 4);
        even_law(times[i], values + i, &f, NULL);
    }
    for (i = 0; i < 2; i++) { /* where nothing asks for them yet */
        (i ? values : times)[8] = i ? VM_NAN : VM_INFINITY;
        law = vm_law_table(9, times, values);
        f = 7;
        CHECK(vm_law_inverse_integral(&law, R(0.5), &f) == VM_NOT_FINITE && f == 7);
        times[8] = 4;
        values[8] = 4;
    }
    memset(&o, 0, sizeof o);
    o.alpha = 3;
    o.reactive = 1;
    o.x = R(0.5);
    o.mass = law;
    o.stiffness = vm_law_linear(30, 0);
    for (i = VM_ROUTE_TRIG; i <= VM_ROUTE_RK87; i++) { /* even laws: t backward with v forward is v backward */
        o.v = R(0.25);
        CHECK(vm_osc_by_route(&o, i, R(-3.5), 0, &back) >= 0);
        o.v = R(-0.25);
        CHECK(vm_osc_by_route(&o, i, R(3.5), 0, &forward) >= 0);
        check_error("backward", vm_osc_route_name(i), "eps", ERROR_EPS(back.x, (double)forward.x, 0, 1), 200, i, 0);
    }
    for (i = 0; i < 9; i++) values[i] = 3 + times[i] / 4; /* nothing jumps at the points of a straight line */
    o.mass = vm_law_linear(3, R(0.25));
    CHECK(vm_osc_by_route(&o, VM_ROUTE_SECOND, 3, 0, &m) == VM_OK);
    o.mass = vm_law_table(9, times, values);
    CHECK(vm_osc_by_route(&o, VM_ROUTE_SECOND, 3, 0, &back) == VM_OK);
    check_error("table", "straight line", "", fabs((double)(back.x - m.x)), VM_MANT_DIG > 24 ? 1e-9 : 1e-4, 0, 0);
}

static vm_real drag(vm_real t, vm_real x, vm_real v, void *ctx)
{
    (void)t;
    (void)x;
    return -*(const vm_real *)ctx * v;
}

/* Laws of mass and stiffness that fail at one evaluation, late ones too: the call says so, or did without it */
static void test_failing_laws(void)
{
    const vm_real times[5] = {-1, 0, 1, 2, 3}, values[5] = {2, R(2.2), R(2.1), R(2.4), R(2.5)};
    unsigned char untouched[sizeof(vm_osc_motion)];
    vm_real b = R(0.01);
    vm_osc_problem o;
    vm_osc_motion m;
    int kind, i;
    memset(untouched, 0x55, sizeof untouched);
    memset(&o, 0, sizeof o);
    o.alpha = 3;
    o.reactive = R(0.5);
    o.x = R(0.5);
    o.v = R(0.25);
    for (fails_after = 0; fails_after < 20; fails_after++) {
        vm_osc_plan p;
        o.mass = vm_law_user(failing_law, NULL);
        o.stiffness = vm_law_linear(3, R(0.1));
        p.pi = 7;
        calls = 0;
        CHECK(vm_osc_plan_init(&p, &o) == VM_OK ? calls <= fails_after : calls > fails_after && p.pi == 7);
    }
    for (kind = 0; kind < 4; kind++) /* by itself, beside points of a table, beside a straight line, with a force */
        for (fails_after = 0; fails_after < 10000; fails_after += 1 + (fails_after > 40 ? fails_after / 8 : 0))
            for (i = VM_ROUTE_TRIG; i <= VM_ROUTE_RK87; i++) {
                int status;
                if (kind == 3 && i == VM_ROUTE_SECOND) continue;
                o.mass = kind == 1   ? vm_law_table(5, times, values)
                         : kind == 2 ? vm_law_linear(2, R(0.1))
                                     : vm_law_user(failing_law, NULL);
                o.stiffness = kind % 3 ? vm_law_user(failing_law, NULL) : vm_law_linear(3, R(0.1));
                o.force = kind == 3 ? drag : NULL;
                o.ctx = &b;
                memset(&m, 0x55, sizeof m);
                calls = 0;
                status = vm_osc_by_route(&o, i, R(2.5), R(1e-3), &m);
                CHECK(calls > fails_after ? status < 0 : status >= 0);
                CHECK(status >= 0 ? VM_IS_FINITE(m.x) && VM_IS_FINITE(m.v) : memcmp(&m, untouched, sizeof m) == 0);
            }
}

/* Motions that end at the limits of their laws: at rest, too fast a change, amplitudes that overflow; large alpha */
static void test_oscillator_limits(void)
{
    vm_real x, v, b = R(0.01), by_force[3], by_damping[3];
    vm_osc_problem o;
    vm_osc_plan p;
    vm_osc_motion m, other;
    int i;
    CHECK(vmi_exp_ratio(0) == 1 && vmi_exp_ratio(VM_INFINITY) == VM_INFINITY &&
          vmi_exp_ratio(-VM_MAX) == 1 / VM_MAX);
    vm_osc_exact(1, 0, VM_NAN, 3, &x, &v);
    CHECK(isnan((double)x) && isnan((double)v));
    vm_osc_trig(1, 0, VM_NAN, 3, &x, &v);
    CHECK(isnan((double)x) && isnan((double)v));
    vm_osc_exact(1, 0, 2, R(0.5), &x, &v);
    CHECK(x == 0 && v == 0); /* its rate would be infinite */
    vm_osc_trig(1, 0, 2, R(0.5), &x, &v);
    CHECK(x == 0 && v == 0);
    vm_osc_jacobi(1, 0, 2, R(0.5), &x, &v);
    CHECK(x == 0 && v == 0);
    memset(&o, 0, sizeof o);
    o.alpha = 3;
    o.reactive = 1;
    o.x = R(0.5);
    o.mass = vm_law_linear(2, 0);
    o.stiffness = vm_law_linear(3, 0);
    CHECK(vm_osc_plan_within(NULL, 1, 0, &m) == VM_BAD_ARGUMENT);
    CHECK(vm_osc_plan_by_route(NULL, VM_ROUTE_RK45, 1, 0, &m) == VM_BAD_ARGUMENT);
    o.x = 0;
    o.force = drag;
    o.ctx = &b;
    CHECK(vm_osc_within(&o, 1, 0, &m) == VM_NO_LAW && vm_osc_by_route(&o, VM_ROUTE_RK87, 1, 0, &m) == VM_NO_LAW);
    o.x = R(0.5);
    for (i = 0; i < 2; i++) { /* a force that is a damping; the quarter of the period is long for large alpha */
        int route;
        o.alpha = i ? 30 : 3;
        for (route = VM_ROUTE_TRIG; route <= VM_ROUTE_ATEB; route++) {
            o.force = drag;
            o.damping = 0;
            CHECK(vm_osc_plan_init(&p, &o) == VM_OK);
            CHECK(vm_osc_averaged(&p, route, 0, R(0.5), by_force, by_force + 1, by_force + 2) == VM_OK);
            o.force = NULL;
            o.damping = b;
            CHECK(vm_osc_plan_init(&p, &o) == VM_OK);
            CHECK(vm_osc_averaged(&p, route, 0, R(0.5), by_damping, by_damping + 1, by_damping + 2) == VM_OK);
            check_error("drag", vm_osc_route_name(route), "relative",
                        fabs((double)(by_force[0] / by_damping[0] - 1)), VM_MANT_DIG > 24 ? 1e-9 : 1e-4,
                        (double)o.alpha, 0);
        }
    }
    o.damping = 0;
    o.alpha = 300;
    o.x = 1; /* a wave's estimate is not above 1, so that 2 is content with any */
    CHECK(vm_osc_within(&o, 1, 2, &m) == VM_OK && m.route == VM_ROUTE_TRIG && m.error >= 1);
    o.alpha = 3;
    o.x = R(0.5);
    o.reactive = R(0.5);
    o.mass = vm_law_linear(2, R(0.5));
    o.v = R(0.25);
    CHECK(vm_osc_by_route(&o, VM_ROUTE_RK45, 2, 0, &m) == VM_OK && vm_osc_by_route(&o, VM_ROUTE_RK87, 2, 0, &other) == VM_OK);
    check_error("reactive 1/2", "rk45, rk87", "", fabs((double)(m.x - other.x)), (double)(m.error + other.error), 0,
                0);
    o.mass = vm_law_linear(2, 500);
    o.stiffness = vm_law_linear(R(0.001), 0);
    o.reactive = 1;
    o.v = 0;
    for (i = 0; i < 64; i++) { /* faster than any law of second order: no number, or a motion */
        o.v = R(0.01) * (vm_real)(i - 32);
        memset(&m, 0x55, sizeof m);
        other = m;
        if (vm_osc_by_route(&o, VM_ROUTE_SECOND, R(0.01) * (vm_real)i, 0, &m) < 0)
            CHECK(memcmp(&m, &other, sizeof m) == 0);
        else CHECK(VM_IS_FINITE(m.x) && VM_IS_FINITE(m.v));
    }
    o.v = R(0.25);
    o.stiffness = vm_law_linear(3, 0);
    o.mass = vm_law_exponential(2, -1);
    o.reactive = 40;
    for (i = 0; i < 2; i++, o.reactive = -o.reactive) { /* an amplitude that overflows; one that vanishes */
        memset(&m, 0x55, sizeof m);
        other = m;
        if (vm_osc_by_route(&o, VM_ROUTE_TRIG, VM_MANT_DIG > 24 ? 300 : 40, 0, &m) < 0)
            CHECK(memcmp(&m, &other, sizeof m) == 0);
        else CHECK(VM_IS_FINITE(m.x) && VM_IS_FINITE(m.v));
    }
    o.alpha = 5;
    o.mass = vm_law_linear(2, 0);
    o.reactive = 1;
    by_force[0] = 7;
    CHECK(vm_osc_plan_init(&p, &o) == VM_OK &&
          vm_osc_averaged(&p, VM_ROUTE_ATEB, 0, VM_MAX, by_force, by_force + 1, by_force + 2) == VM_NOT_FINITE &&
          by_force[0] == 7);
    o.mass = vm_law_linear(VM_MIN, 0);
    o.stiffness = vm_law_linear(VM_MAX / 4, 0); /* omega overflows */
    CHECK(vm_osc_plan_init(&p, &o) == VM_NOT_FINITE);
    o.mass = vm_law_exponential(2, VM_MAX / 8);
    o.stiffness = vm_law_linear(3, 0);
    CHECK(vm_osc_plan_init(&p, &o) == VM_OK || vm_osc_plan_init(&p, &o) == VM_NOT_FINITE);
}

/* -- Van der Pol, Laval's rotor, pairs, harmonic excitation -- */

static int vdp_init(trial *a)
{
    vm_vdp v;
    memset(&v, 0, sizeof v);
    v.alpha = next(a);
    v.k = next(a);
    v.b = next(a);
    v.c = next(a);
    v.reactive = next(a);
    v.method = VM_VDP_JACOBI;
    if (a->null == 0) return vm_vdp_init(NULL);
    if (vm_vdp_init(&v) < 0) return v.a1 == 0 && v.a2 == 0 && v.a3 == 0 ? -1 : 0;
    return value(a, v.a1);
}
static int vdp_amplitude(trial *a)
{
    vm_vdp v = {3, 2, R(0.1), R(0.2), 1, VM_VDP_ATEB, NULL, NULL, 0, 0, 0};
    vm_linear_mass m;
    const vm_real t = next(a), A0 = next(a);
    take(a, &m, sizeof m);
    if (vm_vdp_init(&v)) return -1;
    return value(a, vm_vdp_amplitude(&v, t, A0, m));
}
static const vm_power_force cubic = {2, 3};
static vm_jeffcott laval(void)
{
    vm_jeffcott r;
    memset(&r, 0, sizeof r);
    r.stiffness = vm_jeffcott_power;
    r.stiffness_ctx = (void *)&cubic;
    r.reactive = 1;
    return r;
}
static int laval_frequency(trial *a)
{
    const vm_jeffcott r = laval();
    const vm_real A = next(a);
    return value(a, vm_jeffcott_frequency(&r, A, next(a), 1));
}
static int laval_amplitude(trial *a)
{
    const vm_jeffcott r = laval();
    const vm_real A0 = next(a), mass0 = next(a);
    return value(a, vm_jeffcott_amplitude(&r, A0, mass0, next(a)));
}
static int pair_at(trial *a)
{
    vm_pair p = {0, 0, 0, NULL, NULL};
    vm_linear_mass m;
    vm_real y[4];
    const vm_real t = next(a);
    p.alpha = next(a);
    p.k = next(a);
    p.reactive = next(a);
    take(a, y, sizeof y);
    take(a, &m, sizeof m);
    return vm_pair_at(&p, t, y, m, (vm_real *)(void *)a->output);
}
static int pair_split(trial *a)
{
    vm_linear_mass m;
    vm_pair p = {0, 0, 0, vm_slow_mass_linear, NULL};
    vm_real y[4];
    const vm_real t = next(a);
    p.alpha = next(a);
    p.k = next(a);
    p.reactive = next(a);
    p.mass_ctx = &m;
    take(a, y, sizeof y);
    take(a, &m, sizeof m);
    return vm_pair_to_averaged(&p, t, y, (vm_real *)(void *)a->output);
}
static vm_forced forced(trial *a)
{
    vm_forced f;
    memset(&f, 0, sizeof f);
    f.alpha = next(a);
    f.b = next(a);
    f.reactive = next(a);
    take(a, &f.now, sizeof f.now);
    return f;
}
#define FORCED 3, R(0.1), 1, 2, R(0.01), 3, R(0.01), 2, R(0.01), R(0.5)
static int forced_init(trial *a)
{
    vm_forced f = forced(a);
    if (a->null == 0) return vm_forced_init(NULL);
    return vm_forced_init(&f) < 0 ? -1 : value(a, f.pi);
}
static vm_forced prepared(void)
{
    const vm_real now[10] = {FORCED};
    vm_forced f;
    trial a;
    memset(&a, 0, sizeof a);
    memcpy(a.x, now, sizeof now);
    f = forced(&a);
    CHECK(vm_forced_init(&f) == VM_OK);
    return f;
}
static int forced_split(trial *a)
{
    const vm_forced f = prepared();
    vm_real motion[3];
    take(a, motion, sizeof motion);
    return vm_forced_to_averaged(&f, 0, motion, (vm_real *)(void *)a->output);
}
static int forced_join(trial *a)
{
    const vm_forced f = prepared();
    vm_real y[3];
    take(a, y, sizeof y);
    return vm_forced_from_averaged(&f, 0, y, (vm_real *)(void *)a->output);
}
static int adiabaticity(trial *a)
{
    const vm_real A = next(a), mass = next(a), mass_rate = next(a), k = next(a), k_rate = next(a), b = next(a),
                  reactive = next(a);
    return value(a, vm_adiabaticity(A, mass, mass_rate, k, k_rate, b, reactive, next(a)));
}
static int oscillate(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    (void)t;
    (void)ctx;
    dydt[0] = y[1];
    dydt[1] = -y[0];
    return 0;
}

static void test_slow_vibrations(void)
{
    vm_vdp v = {3, 2, R(0.1), R(0.2), 1, -1, NULL, NULL, 0, 0, 0};
    vm_forced f = prepared();
    vm_steady_state curve[2];
    vm_passage passage;
    vm_sample points[4];
    vm_real y[3] = {1, 0, 0}, motion[3], state[2] = {1, 0}, work[RK45_WORK(2)], buffer[2];
    rk45 s;
    REFUSES(vdp_init, 1, 3, 2, R(0.1), R(0.2), 1);
    CHECK(vm_vdp_init(&v) == VM_BAD_ARGUMENT);
    v.method = VM_VDP_TRIGONOMETRIC + 1;
    CHECK(vm_vdp_init(&v) == VM_BAD_ARGUMENT);
    v.method = VM_VDP_ATEB;
    v.alpha = -1;
    CHECK(vm_vdp_init(&v) == VM_DOMAIN);
    v.alpha = 1;
    v.k = 0;
    CHECK(vm_vdp_init(&v) == VM_DOMAIN);
    REFUSES(vdp_amplitude, 0, 1, R(0.1), 2, R(0.01));
    REFUSES(laval_frequency, 0, R(0.1), 2);
    REFUSES(laval_amplitude, 0, R(0.1), 2, 3);
    REFUSES(pair_at, 0, 1, 3, 2, 1, R(0.1), R(0.2), R(0.3), R(0.4), 2, R(0.01));
    REFUSES(pair_split, 0, 1, 3, 2, 1, R(0.1), R(0.2), R(0.3), R(0.4), 2, R(0.01));
    REFUSES(forced_init, 1, FORCED);
    REFUSES(forced_split, 0, 1, R(0.2), R(0.3));
    REFUSES(forced_join, 0, 1, R(0.2), R(0.3));
    y[0] = -1;
    CHECK(vm_forced_from_averaged(&f, 0, y, motion) == VM_DOMAIN);
    CHECK(vm_forced_curve(&f, 0, VM_NAN, curve) == VM_DOMAIN &&
          vm_forced_curve(&f, 0, VM_INFINITY, curve) == VM_DOMAIN && vm_forced_curve(&f, 0, 0, curve) == VM_DOMAIN);
    f.now.force = 0;
    CHECK(vm_forced_curve(&f, 0, 1, curve) == 0 && vm_forced_passage(&f, 0, 1, &passage) == VM_DOMAIN);
    f = prepared();
    f.alpha = -1;
    CHECK(vm_forced_init(&f) == VM_DOMAIN);
    f = prepared();
    f.alpha = 1;
    CHECK(vm_forced_init(&f) == VM_OK);
    CHECK(vm_forced_passage(&f, 0, VM_NAN, &passage) == VM_DOMAIN &&
          vm_forced_passage(&f, 0, VM_INFINITY, &passage) == VM_DOMAIN);
    CHECK(vm_forced_passage(&f, 0, 1, &passage) == VM_OK && isnan(passage.delta)); /* linear: nothing holds it */
    REFUSES(adiabaticity, 0, R(0.1), 2, R(0.01), 3, R(0.02), R(0.1), 1, 3);
    CHECK(rk45_init(&s, oscillate, NULL, 2, 0, state, NULL, work) == ODE_OK);
    CHECK(vm_find_samples_of_step(&s, 0, 1, VM_ZERO_CROSSINGS, buffer, 4, points) == 0); /* no step yet */
    CHECK(vm_find_samples_of_step(NULL, 0, 1, VM_ZERO_CROSSINGS, buffer, 4, points) == VM_BAD_ARGUMENT);
    CHECK(vm_find_samples_of_step(&s, 0, 1, VM_ZERO_CROSSINGS, NULL, 4, points) == VM_BAD_ARGUMENT);
    CHECK(vm_find_samples_of_step(&s, -1, 1, VM_ZERO_CROSSINGS, buffer, 4, points) == VM_BAD_ARGUMENT);
    CHECK(vm_find_samples_of_step(&s, 0, -1, VM_ZERO_CROSSINGS, buffer, 4, points) == VM_BAD_ARGUMENT);
    CHECK(vm_find_samples_of_step(&s, 2, 1, VM_ZERO_CROSSINGS, buffer, 4, points) == VM_BAD_ARGUMENT);
    CHECK(vm_find_samples_of_step(&s, 0, 2, VM_ZERO_CROSSINGS, buffer, 4, points) == VM_BAD_ARGUMENT);
}

static vm_real no_rate(vm_real t, vm_real *rate, void *ctx) { return (void)t, (void)ctx, *rate = VM_INFINITY, 1; }
static vm_real no_mass(vm_real t, vm_real *rate, void *ctx) { return (void)t, (void)ctx, *rate = 0, 0; }
static vm_real one_kg(vm_real t, vm_real *rate, void *ctx) { return (void)t, (void)ctx, *rate = R(0.1), 1; }

/* An elastic force of 3 N/m that is known up to a radius */
static vm_real known_to(vm_real rho, vm_real *slope, void *radius)
{
    *slope = 0;
    return rho <= *(const vm_real *)radius ? 3 : VM_NAN;
}
static vm_complex pull(vm_real t, vm_complex z, vm_complex v, void *ctx)
{
    (void)t;
    (void)ctx;
    return vmi_complex(R(-0.1) * v.re, R(-0.1) * v.im - R(0.2) * z.re * z.re * z.im);
}

/* Masses that are none, dampings that cancel, rotors without stiffness, or whose stiffness is known to a radius */
static void test_slow_limits(void)
{
    vm_pair pair = {3, 2, 1, no_rate, NULL};
    vm_vdp vdp = {3, 2, 0, R(0.2), 1, VM_VDP_ATEB, NULL, NULL, 0, 0, 0};
    const vm_power_force none = {0, 1};
    vm_jeffcott r = laval();
    vm_real y[4] = {R(0.1), R(0.2), R(0.3), R(0.4)}, rates[2][4], radius = VM_MAX;
    int k, stable;
    CHECK(vm_pair_averaged_rhs(0, y, rates[0], &pair) == VM_NOT_FINITE);
    pair.mass = no_mass;
    CHECK(vm_pair_averaged_rhs(0, y, rates[0], &pair) == VM_BAD_MASS);
    pair.mass = NULL;
    CHECK(vm_pair_averaged_rhs(0, y, rates[0], &pair) == VM_BAD_ARGUMENT);
    CHECK(vm_vdp_init(&vdp) == VM_OK);
    for (k = -1; k < 2; k += 2) { /* neither driven nor damped but by c: rest is stable where that damps */
        vdp.c = (vm_real)k;
        stable = 7;
        CHECK(vm_vdp_limit_cycle(&vdp, 0, &stable) == 0 && stable == (k > 0));
    }
    r.mass = one_kg;
    r.force = pull;
    CHECK(vm_jeffcott_forward_whirl_rhs(0, y, rates[0], &r) == VM_OK);
    r.samples = 64;
    CHECK(vm_jeffcott_forward_whirl_rhs(0, y, rates[1], &r) == VM_OK);
    check_error("Laval", "samples", "eps", ERROR_EPS(rates[0][1], (double)rates[1][1], 0, 1), 64, 0, 0);
    CHECK(vm_jeffcott_amplitude(&r, R(0.1), 2, 2) == R(0.1));
    r.stiffness_ctx = (void *)&none;
    CHECK(vm_jeffcott_forward_whirl_rhs(0, y, rates[0], &r) == VM_DOMAIN &&
          vm_jeffcott_backward_whirl_rhs(0, y, rates[0], &r) == VM_DOMAIN);
    r.stiffness = known_to;
    r.stiffness_ctx = &radius;
    radius = R(1.05); /* A = (m0/m)^(1/4) is inside, or not */
    for (k = 0; k < 2; k++) {
        const double mass = pow(k ? 1.1 : 1.04, -4), A = (double)vm_jeffcott_amplitude(&r, 1, 1, (vm_real)mass);
        if (k) CHECK(isnan(A));
        else check_error("Laval", "known to 1.05", "eps", fabs(A - 1.04) / (double)VM_EPSILON, 8, 0, 0);
    }
    CHECK(vmi_find_zero(NULL, NULL, 1, 2, 0, 3) == 1 && vmi_find_zero(NULL, NULL, 1, 2, 3, 0) == 2); /* at an end */
    radius = 1;
    CHECK(isnan((double)vm_jeffcott_amplitude(&r, 1, 1, R(0.5))));
    radius = VM_MAX;
    for (k = -8; k < 9; k++) { /* the first point looked at, e^(1/16), is the amplitude, but for some eps */
        const vm_real mass = (vm_real)exp(-0.25) * (1 + (vm_real)k * VM_EPSILON / 2);
        const double A = (double)vm_jeffcott_amplitude(&r, 1, 1, mass);
        check_error("Laval", "first point", "eps", fabs(A - pow((double)mass, -0.25)) / (double)VM_EPSILON, 4, k,
                    0);
    }
}

/* Excitation without a force or without damping; motions within their ripple; alpha next to 1, where the turns of the
   resonance curve are far away */
static void test_forced_limits(void)
{
    vm_forced f = prepared();
    vm_steady_state curve[3];
    vm_real motion[3] = {R(0.001), 0, 0}, y[3] = {7, 7, 7}, w;
    const vm_real A = (vm_real)ldexp(1, 40);
    int k, j, found;
    f.now.force = f.b = f.now.mass_rate = f.now.k_rate = 0;
    CHECK(vm_forced_curve(&f, 0, 1, curve) == 0); /* free vibration holds itself */
    f.now.force = VM_MIN;                         /* a force that counts for nothing holds its backbone, w(A) */
    CHECK(vm_forced_curve(&f, 0, A, curve) == 1);
    w = 2 * VM_PI / vm_osc_period(A, VM_SQRT(f.now.k / f.now.mass), f.alpha);
    check_error("backbone", "", "eps", ERROR_EPS(curve[0].nu, (double)w, 0, (double)w), 8, (double)A, 0);
    f = prepared();
    f.now.force = 1000;
    CHECK(vm_forced_to_averaged(&f, 0, motion, y) == VM_DOMAIN && y[0] == 7);
    motion[0] = VM_MAX;
    motion[1] = VM_MAX / 2;
    CHECK(vm_forced_to_averaged(&f, 0, motion, y) < 0 ? y[0] == 7 : VM_IS_FINITE(y[0]) && VM_IS_FINITE(y[1]));
    for (k = 0; k < 40; k++) {
        f = prepared();
        f.alpha = 1 + R(0.002) * (vm_real)(k - 20);
        f.b = R(0.02) * (vm_real)(k % 3);
        f.now.mass_rate = f.now.k_rate = 0;
        CHECK(vm_forced_init(&f) == VM_OK);
        for (j = 0; j < 3; j++) {
            f.now.nu = j == 0 ? R(1.25) + R(0.02) * (vm_real)(k % 5) : j == 1 ? R(0.2) : R(3);
            found = vm_forced_steady_states(&f, 0, curve);
            CHECK(found >= 0 && found <= 3);
            while (found-- > 0) CHECK(curve[found].A > 0 && VM_IS_FINITE(curve[found].A));
        }
    }
}

/* -- integrators.h -- */

/* Stops, or ceases to be a number, at one of its evaluations */
static long countdown;
static int breaks(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    oscillate(t, y, dydt, NULL);
    if (--countdown >= 0) return 0;
    if (ctx) dydt[0] = VM_NAN;
    return ctx ? 0 : 9;
}
static vm_real no_number(vm_real t, const vm_real *y, void *ctx)
{
    (void)ctx;
    return t < R(0.1) ? y[0] : VM_NAN;
}

static void test_broken_right_hand_sides(void)
{
    int when, kind;
    vm_real work[RK87_WORK(2)], out[2];
    rk45_options o;
    ode_event e;
    rk45 s;
    for (kind = 0; kind < 2; kind++) {
        for (when = 0; when < 60; when++) {
            vm_real y[2] = {1, 0}, t = 0;
            void *ctx = kind ? &when : NULL;
            countdown = when;
            CHECK(kind || rk4_solve(breaks, ctx, 2, &t, 1, 3, y, work) == (when < 12 ? ODE_RHS_STOPPED : ODE_OK));
        }
        for (when = 0; when < 60; when++) {
            const vm_real y[2] = {1, 0};
            int status;
            countdown = when;
            if (rk45_init(&s, breaks, kind ? &when : NULL, 2, 0, y, NULL, work) == 0) {
                status = rk45_solve(&s, 1);
                CHECK(status == (kind ? ODE_NOT_FINITE : ODE_RHS_STOPPED) || status == ODE_OK);
                CHECK(isfinite((double)s.y[0]) && isfinite((double)s.t));
            }
            countdown = when;
            if (rk87_init(&s, breaks, kind ? &when : NULL, 2, 0, y, NULL, work) == 0 && rk87_step(&s) == 0) {
                out[0] = 7;
                status = rk87_interpolate(&s, s.t / 2, out);
                CHECK(status == ODE_OK || out[0] == 7);
            }
        }
    }
    memset(&e, 0, sizeof e);
    memset(&o, 0, sizeof o);
    e.g = no_number;
    o.events = &e;
    o.n_events = 1;
    out[0] = 1;
    out[1] = 0;
    CHECK(rk45_init(&s, oscillate, NULL, 2, 0, out, &o, work) == ODE_OK && rk45_solve(&s, 1) == ODE_NOT_FINITE);
    o.n_events = 0;
    o.h0 = R(1e-3);
    o.h_max = R(1e-4);
    CHECK(rk45_init(&s, oscillate, NULL, 2, 0, out, &o, work) == ODE_OK && rk45_step(&s) == ODE_OK &&
          s.t <= R(1e-4));
}

/* What is looked for is exactly at a step, or no number; steps of rk87 of which the inside cannot be had */
static void line(vm_real t, vm_real *x, vm_real *v, void *ctx)
{
    const vm_real *from_to = (const vm_real *)ctx;
    *x = t < from_to[0] || t > from_to[1] ? VM_NAN : t - 1;
    *v = 1;
}

static void test_points_found(void)
{
    const vm_real y0[2] = {1, 0};
    vm_real known[2] = {-9, 9}, work[RK87_WORK(2)], buffer[2];
    vm_sample points[4];
    rk87 s;
    CHECK(vm_find_samples(line, known, VM_ZERO_CROSSINGS, 0, 2, R(0.25), 4, points) == 1);
    CHECK(points[0].t == 1 && points[0].x == 0 && points[0].v == 1);
    CHECK(vm_find_samples(line, known, VM_ZERO_CROSSINGS, 1, 2, R(0.25), 4, points) ==
          0); /* where it begins: none */
    CHECK(vm_find_samples(line, known, VM_ZERO_CROSSINGS, 1, 1, R(0.25), 4, points) == 0);
    known[1] = R(0.75);
    CHECK(vm_find_samples(line, known, VM_ZERO_CROSSINGS, 0, 2, R(0.25), 4, points) == VM_NOT_FINITE);
    CHECK(vm_find_samples(line, known, VM_ZERO_CROSSINGS, 2, 2, R(0.25), 4, points) == VM_NOT_FINITE);
    countdown = 1000;
    CHECK(rk87_init(&s, breaks, NULL, 2, 0, y0, NULL, work) == ODE_OK && rk87_step(&s) == ODE_OK);
    countdown = 0;
    CHECK(vm_find_samples_of_step(&s, 0, 1, VM_ZERO_CROSSINGS, buffer, 4, points) == VM_NOT_FINITE);
}

static void test_integrators(void)
{
    vm_real y[2] = {1, 0}, low[2] = {0}, t = 0, work[RK87_WORK(2)], out[2] = {0};
    rk45 s;
    rk45_options o;
    int status, other;
    for (status = ODE_STEP_TOO_SMALL - 2; status <= ODE_STIFF + 2; status++)
        for (other = status + 1; other <= ODE_STIFF; other++)
            if (status >= ODE_STEP_TOO_SMALL) CHECK(strcmp(ode_strerror(status), ode_strerror(other)) != 0);
    CHECK(rk4_step(oscillate, NULL, 2, VM_NAN, 1, y, work) == ODE_BAD_ARGUMENT);
    CHECK(rk4_step(oscillate, NULL, 2, 0, VM_INFINITY, y, work) == ODE_BAD_ARGUMENT);
    CHECK(rk4_step(oscillate, NULL, 2, 0, 1, NULL, work) == ODE_BAD_ARGUMENT);
    CHECK(rk4_step(oscillate, NULL, 2, 0, 1, y, NULL) == ODE_BAD_ARGUMENT);
    CHECK(rk4_step(NULL, NULL, 2, 0, 1, y, work) == ODE_BAD_ARGUMENT);
    CHECK(rk4_solve(oscillate, NULL, 2, NULL, 1, 10, y, work) == ODE_BAD_ARGUMENT);
    CHECK(rk4_solve(oscillate, NULL, 2, &t, VM_NAN, 10, y, work) == ODE_BAD_ARGUMENT);
    CHECK(rk4_solve_compensated(oscillate, NULL, 2, NULL, 1, 10, y, low, work) == ODE_BAD_ARGUMENT);
    CHECK(rk4_solve_compensated(oscillate, NULL, 2, &t, VM_INFINITY, 10, y, low, work) == ODE_BAD_ARGUMENT);
    CHECK(rk4_solve_compensated(oscillate, NULL, 0, &t, 1, 10, y, low, work) == ODE_BAD_ARGUMENT);
    CHECK(y[0] == 1 && y[1] == 0 && t == 0);
    for (other = 0; other < 8; other++) { /* options that are none */
        memset(&o, 0, sizeof o);
        if (other == 0) o.h0 = VM_NAN;
        if (other == 1) o.h_min = -1;
        if (other == 2) o.h_max = -1;
        if (other == 3) {
            o.h_min = 2;
            o.h_max = 1;
        }
        if (other == 4) o.rtol = VM_INFINITY;
        if (other == 5) o.atol = VM_NAN;
        if (other == 6) o.n_events = -1;
        if (other == 7) o.n_events = 1;
        CHECK(rk45_init(&s, oscillate, NULL, 2, 0, y, &o, work) == ODE_BAD_ARGUMENT);
    }
    CHECK(rk45_init(&s, oscillate, NULL, 2, 0, y, NULL, work) == ODE_OK && rk45_step(&s) == ODE_OK);
    CHECK(rk45_interpolate(NULL, 0, out) == ODE_BAD_ARGUMENT && rk45_interpolate(&s, 0, NULL) == ODE_BAD_ARGUMENT);
    CHECK(rk87_interpolate(&s, 0, out) == ODE_BAD_ARGUMENT &&
          rk45_solve_with(NULL, oscillate, 2, 1) == ODE_BAD_ARGUMENT);
    CHECK(rk87_init(&s, oscillate, NULL, 2, 0, y, NULL, work) == ODE_OK && rk87_step(&s) == ODE_OK);
    CHECK(rk87_interpolate(NULL, 0, out) == ODE_BAD_ARGUMENT && rk87_interpolate(&s, 0, NULL) == ODE_BAD_ARGUMENT);
    CHECK(rk45_interpolate(&s, 0, out) == ODE_BAD_ARGUMENT &&
          rk87_solve_with(NULL, oscillate, 2, 1) == ODE_BAD_ARGUMENT);
    CHECK(rk87_solve_with(&s, oscillate, 2, 1) == ODE_OK && s.t == 1);
    CHECK(out[0] == 0 && out[1] == 0);
}

/* -- Scenes -- */

enum { BAD_SCENES = 26 };

static void test_scenes(void)
{
    const vm_real times[2] = {1, 2}, falling[2] = {2, 1}, unknown[2] = {1, VM_NAN};
    int k;
    for (k = -1; k < BAD_SCENES; k++) {
        vm_scene_body bodies[3];
        vm_effect effects[1];
        vm_event events[1];
        ode_event located[1];
        vm_scene s;
        vm_body part;
        memset(&part, 0, sizeof part);
        memset(&s, 0, sizeof s);
        part.mass = 1;
        part.q.w = 1;
        bodies[0] = vm_scene_body_point(2, vmi_vec3(0, 0, 0), vmi_vec3(1, 0, 0));
        bodies[1] = vm_scene_body_absent(vm_scene_body_point(1, vmi_vec3(0, 0, 0), vmi_vec3(0, 0, 0)));
        bodies[2] = vm_scene_body_free(&part);
        effects[0] = vm_effect_gravity(0, 1, R(-9.81));
        events[0] = vm_then_separate(vm_event_at(1), 0, 1, &part, 0);
        s.bodies = bodies;
        s.n_bodies = 3;
        s.effects = effects;
        s.n_effects = 1;
        s.events = events;
        s.located = located;
        s.n_events = 1;
        s.times = times;
        s.n_times = 2;
        switch (k) {
        case 0: s.n_bodies = 0; break;
        case 1: s.bodies = NULL; break;
        case 2: s.n_effects = -1; break;
        case 3: s.effects = NULL; break;
        case 4: s.n_events = -1; break;
        case 5: s.events = NULL; break;
        case 6: s.located = NULL; break;
        case 7: s.n_times = -1; break;
        case 8: s.times = falling; break;
        case 9: s.times = unknown; break;
        case 10: bodies[0].motion = VM_LINE - 1; break;
        case 11: bodies[0].motion = VM_FREE + 1; break;
        case 12: bodies[0].put = NULL; break;
        case 13: bodies[0].start.inertia.xx = 1; break;
        case 14: bodies[0].start.inertia.yy = 1; break;
        case 15: bodies[0].start.inertia.zz = 1; break;
        case 16: bodies[0].start.inertia.xy = 1; break;
        case 17: bodies[0].start.inertia.xz = 1; break;
        case 18: bodies[0].start.inertia.yz = 1; break;
        case 19: effects[0].coordinate = -1; break;
        case 20: effects[0].coordinate = 3; break;
        case 21:
            effects[0].body = 2;
            effects[0].coordinate = 3;
            break;
        case 22: events[0].external.linear.x = VM_NAN; break;
        case 23: events[0].external.couple.x = VM_NAN; break;
        case 24: events[0].jump_body = 3; break;
        case 25: events[0].other = 5; break;
        default: break;
        }
        CHECK((vm_scene_check(&s, NULL) == VM_OK) == (k < 0));
    }
    for (k = -1; k < 2; k++) { /* an effect that is switched */
        vm_scene_body body = vm_scene_body_line(1, 0, 0);
        vm_effect effect = vm_effect_gravity(0, 0, 1);
        vm_event event = vm_then_switch(vm_event_at(1), k, 1);
        ode_event located;
        vm_scene s;
        memset(&s, 0, sizeof s);
        s.bodies = &body;
        s.n_bodies = 1;
        s.effects = &effect;
        s.n_effects = 1;
        s.events = &event;
        s.n_events = 1;
        s.located = &located;
        CHECK(vm_scene_check(&s, NULL) == (k == 0 ? VM_OK : VM_NO_SUCH_EFFECT));
    }
    CHECK(vm_scene_check(NULL, NULL) == VM_BAD_ARGUMENT &&
          vm_scene_budget_at(NULL, 0, NULL, NULL) == VM_BAD_ARGUMENT);
}

/* A run's output at given times, events of a mass, jumps between absent and present bodies, refused runs */
static int outputs;
static int remember(vm_real t, const vm_real *y, vm_scene *scene, void *ctx)
{
    (void)y;
    (void)scene;
    if (outputs < 4) ((vm_real *)ctx)[outputs] = t;
    return ++outputs == 3; /* the third is enough */
}

static void test_runs(void)
{
    const vm_real times[5] = {R(-1), R(0.5), R(0.75), R(1.5), 9};
    vm_real seen[4], y[64], work[VM_SCENE_WORK(64)], t = 0, atol[64];
    vm_scene_body bodies[2];
    vm_effect effects[1];
    vm_event events[1];
    ode_event located[1];
    rk45_options options = rk45_defaults(NULL);
    vm_scene s;
    vm_budget book;
    vm_body part;
    int i, k;
    memset(&s, 0, sizeof s);
    memset(&part, 0, sizeof part);
    for (i = 0; i < 64; i++) atol[i] = R(1e-3);
    part.mass = R(0.5);
    part.inertia.zz = R(0.01);
    part.v.x = 1;
    s.bodies = bodies;
    s.n_bodies = 1;
    s.output = remember;
    s.output_ctx = seen;
    s.times = times;
    s.n_times = 5;
    bodies[0] = vm_scene_body_with_mass_state(vm_scene_body_line(2, 0, 1));
    effects[0] = vm_effect_stream(0, -1, vmi_vec3(0, 0, 0), 1);
    s.effects = effects;
    s.n_effects = 1;
    CHECK(vm_scene_start(&s, t, y, NULL) == VM_OK && vm_scene_run(&s, &t, 4, y, work, NULL) == VM_STOPPED);
    CHECK(outputs == 3 && seen[0] == R(0.5) && seen[1] == R(0.75) && seen[2] == R(1.5) && t == R(1.5));
    s.times = times + 1;
    s.n_times = 4;
    outputs = 0;
    t = 0; /* the first time is one to come */
    CHECK(vm_scene_start(&s, t, y, NULL) == VM_OK && vm_scene_run(&s, &t, 4, y, work, NULL) == VM_STOPPED);
    CHECK(outputs == 3 && seen[0] == R(0.5) && t == R(1.5));
    check_error("mass of a stream", "", "eps", fabs((double)y[2] - 0.5) / (double)VM_EPSILON, 16, 0, 0);
    CHECK(vm_scene_run(&s, &t, 1, y, work, NULL) == VM_BAD_TIMES &&
          vm_scene_run(&s, &t, VM_INFINITY, y, work, NULL) < 0);
    options.atol_each = atol;
    CHECK(vm_scene_run(&s, &t, R(1.75), y, work, &options) == VM_OK && t == R(1.75));
    options.h0 = VM_NAN;
    CHECK(vm_scene_run(&s, &t, 2, y, work, &options) == VM_BAD_OPTIONS);
    s.output = NULL;
    s.times = NULL;
    for (i = 0; i < 2; i++) { /* the mass passes 1.25, as a state and by a law */
        bodies[0] = vm_scene_body_line(2, 0, 1);
        if (i == 0) bodies[0] = vm_scene_body_with_mass_state(bodies[0]);
        effects[0] = i == 0 ? vm_effect_stream(0, -1, vmi_vec3(0, 0, 0), 1)
                            : vm_effect_mass(0, VM_MASS_OF_T, -1, 0, 1);
        events[0] = vm_then_stop(vm_event_mass(0, R(1.25), -1));
        s.events = events;
        s.located = located;
        s.n_events = 1;
        t = 0;
        CHECK(vm_scene_start(&s, t, y, NULL) == VM_OK && vm_scene_run(&s, &t, 4, y, work, NULL) == VM_STOPPED);
        check_error("event of a mass", i ? "law" : "state", "eps", fabs((double)t - 0.75) / (double)VM_EPSILON, 32,
                    0, 0);
    }
    for (k = 0; k < 9; k++) { /* jumps: what comes of them, with and without a book */
        const int bad = k > 3;
        vm_scene_body (*make)(vm_real, vm_real, vm_real) = k % 2 ? vm_scene_body_axle : vm_scene_body_line;
        memset(&s, 0, sizeof s);
        t = 0;
        s.bodies = bodies;
        s.n_bodies = 2;
        s.events = events;
        s.located = located;
        s.n_events = 1;
        bodies[0] = make(2, R(0.1), 3);
        bodies[1] = vm_scene_body_absent(make(R(0.5), 0, 0));
        part.mass = R(0.5);
        part.v.x = 1;
        part.omega.z = 1;
        part.inertia.zz = R(0.01);
        events[0] = vm_then_separate(vm_event_at(1), 0, 1, &part, 0);
        if (k == 2) {
            bodies[0] = vm_scene_body_plane(2, 1, vmi_vec3(0, 0, 0), 0, vmi_vec3(1, 0, 0), 2);
            bodies[1] = vm_scene_body_absent(vm_scene_body_plane(1, 1, vmi_vec3(0, 0, 0), 0, vmi_vec3(1, 0, 0), 2));
        }
        if (k == 3) {
            bodies[1].absent = 0;
            events[0] = vm_then_attach(vm_event_at(1), 0, 1);
        }
        if (k == 4 || k == 5) events[0].part.mass = 2;                /* nothing is left */
        if (k == 6) bodies[1].absent = 0;                             /* into what is there already */
        if (k == 7) events[0] = vm_then_attach(vm_event_at(1), 0, 1); /* what is not there */
        if (k == 8) {                                                 /* a plane's rest that is a point */
            bodies[0] = vm_scene_body_plane(2, R(0.01), vmi_vec3(0, 0, 0), 0, vmi_vec3(1, 0, 0), 2);
            bodies[1] = vm_scene_body_absent(vm_scene_body_plane(1, 1, vmi_vec3(0, 0, 0), 0, vmi_vec3(1, 0, 0), 2));
            part.r.x = part.v.y = 0;
            part.v.x = 1;
            part.omega.z = 2;
            events[0].part = part;
            events[0].part.r.x = 1; /* where the whole is by then */
        }
        vm_scene_keep_budget(&s, k == 0 ? &book : NULL);
        CHECK(vm_scene_start(&s, t, y, NULL) == VM_OK);
        i = vm_scene_run(&s, &t, 2, y, work, NULL);
        CHECK((i < 0) == bad && t == (bad ? 1 : 2));
        if (k == 0) { /* 2 * 3 - 0.5 * 1 over 1.5 */
            check_error("jump on a line", "", "eps", fabs((double)y[1] - 11. / 3) / (double)VM_EPSILON, 8, 0, 0);
            CHECK(vm_scene_budget_at(&s, t, NULL, &book) == VM_BAD_ARGUMENT &&
                  vm_scene_budget_at(&s, t, y, NULL) == VM_BAD_ARGUMENT);
        }
    }
    memset(&s, 0, sizeof s);
    t = 0; /* a law's mass runs out */
    bodies[0] = vm_scene_body_line(2, 0, 1);
    s.bodies = bodies;
    s.n_bodies = 1;
    effects[0] = vm_effect_mass_law(0, NULL, NULL, vmi_vec3(0, 0, 0), 0);
    s.effects = effects;
    s.n_effects = 1;
    CHECK(vm_scene_check(&s, NULL) == VM_BAD_ARGUMENT);
    effects[0] = vm_effect_mass(0, -1, 1, 0, 0);
    CHECK(vm_scene_check(&s, NULL) < 0);
    CHECK(vm_force_stream(2, 3, R(0.5), 4) == 2 && vm_force_stream(-1, 2, 1, 7) == -2);
}

/* What the check refuses of links, bands, bodies that grow and jumps between motions */
static void fixed_point(vm_real t, vm_vec3 *r, vm_vec3 *v, vm_vec3 *a, void *ctx)
{
    (void)t;
    (void)ctx;
    *r = *v = *a = vmi_vec3(0, 0, 0);
}
static void test_scene_refusals(void)
{
    int k;
    for (k = -1; k < 7; k++) {
        vm_scene_body bodies[3];
        vm_effect effects[2];
        vm_event event;
        ode_event located;
        vm_band band;
        vm_scene s;
        vm_body part;
        memset(&s, 0, sizeof s);
        memset(&part, 0, sizeof part);
        memset(&band, 0, sizeof band);
        band.radius = R(0.5);
        band.thickness = R(0.01);
        band.width = R(0.1);
        band.density = 7;
        part.mass = 1;
        bodies[0] = vm_scene_body_plane(2, 1, vmi_vec3(0, 0, 0), 0, vmi_vec3(0, 0, 0), 0);
        bodies[1] = vm_scene_body_absent(vm_scene_body_point(1, vmi_vec3(0, 0, 0), vmi_vec3(0, 0, 0)));
        bodies[2] = vm_scene_body_axle(1, 0, 0);
        effects[0] = vm_effect_link(0, VM_GROUND, fixed_point, NULL, 1, 0, 10);
        effects[1] = vm_effect_band(2, &band);
        event = vm_then_separate(vm_event_at(1), 0, 1, &part, 0);
        s.bodies = bodies;
        s.n_bodies = 3;
        s.effects = effects;
        s.n_effects = 2;
        s.events = &event;
        s.located = &located;
        s.n_events = 1;
        switch (k) {
        case 0: effects[0] = vm_effect_link(0, 0, NULL, NULL, 1, 0, 10); break;
        case 1:
            bodies[1] = vm_scene_body_growing_plane(bodies[0]);
            s.n_events = 0;
            effects[0] = vm_effect_link(0, 1, NULL, NULL, 1, 0, 10);
            break;
        case 2:
            band.width = -1;
            effects[1] = vm_effect_band(2, &band);
            break;
        case 3:
            band.density = -1;
            effects[1] = vm_effect_band(2, &band);
            break;
        case 4:
            bodies[0] = vm_scene_body_growing_free(bodies[0]);
            s.n_effects = 0;
            break;
        case 5:
            bodies[0] = vm_scene_body_line(2, 0, 0);
            s.n_effects = 0;
            break; /* a point from a line */
        case 6: event = vm_then_switch(vm_event_at(1), 2, 1); break;
        default: break;
        }
        CHECK((vm_scene_check(&s, NULL) == VM_OK) == (k < 0));
    }
}

/* Runs that begin where or when nothing is to come: from before 0, after all times of output, with fewer of them than
   there are steps; t that is no number */
static void test_run_times(void)
{
    const vm_real times[2] = {R(-1.5), R(-0.5)};
    vm_scene_body body = vm_scene_body_line(2, 0, 1);
    vm_real seen[4], y[8], work[VM_SCENE_WORK(8)], t = -2;
    vm_scene s;
    memset(&s, 0, sizeof s);
    s.bodies = &body;
    s.n_bodies = 1;
    s.output = remember;
    s.output_ctx = seen;
    s.times = times;
    s.n_times = 2;
    outputs = 0;
    CHECK(vm_scene_start(&s, t, y, NULL) == VM_OK && vm_scene_run(&s, &t, 1, y, work, NULL) == VM_OK);
    CHECK(outputs == 2 && seen[0] == R(-1.5) && seen[1] == R(-0.5) && t == 1);
    check_error("run from before 0", "", "eps", fabs((double)y[0] - 3) / (double)VM_EPSILON, 8, 0, 0);
    CHECK(vm_scene_run(&s, &t, 2, y, work, NULL) == VM_OK && outputs == 2 && t == 2); /* no more of them */
    t = -VM_INFINITY;
    CHECK(vm_scene_run(&s, &t, 2, y, work, NULL) == VM_NOT_FINITE && t == -VM_INFINITY);
}

/* Jumps that fail leave the state before them, and those into a body that grows put its mass centre where it is */
static void test_scene_jumps(void)
{
    int k;
    for (k = 0; k < 5; k++) {
        vm_scene_body bodies[2];
        vm_event event;
        ode_event located;
        vm_real y[64], work[VM_SCENE_WORK(64)], t = 0;
        vm_budget book;
        vm_scene s;
        vm_body part, now;
        int status;
        memset(&s, 0, sizeof s);
        memset(&part, 0, sizeof part);
        part.mass = R(0.5);
        part.inertia.zz = R(0.02);
        part.r.x = R(0.25);
        bodies[0] = vm_scene_body_plane(2, 1, vmi_vec3(0, 0, 0), 0, vmi_vec3(0, 0, 0), 1);
        bodies[1] = vm_scene_body_absent(vm_scene_body_plane(1, 1, vmi_vec3(0, 0, 0), 0, vmi_vec3(0, 0, 0), 0));
        s.bodies = bodies;
        s.n_bodies = 2;
        s.events = &event;
        s.located = &located;
        s.n_events = 1;
        event = vm_then_separate_in_plane(vm_event_at(1), 0, 1, &part, 1);
        if (k == 1) event.part.mass = 3;                          /* more than there is */
        if (k == 2) event = vm_then_attach(vm_event_at(1), 1, 0); /* to what is not there */
        if (k == 3) {
            /* the inertia overflows */
            bodies[1].absent = 0;
            bodies[1].start.r.x = VM_MAX / 4;
            event = vm_then_attach(vm_event_at(1), 0, 1);
        }
        if (k == 4) bodies[1] = vm_scene_body_growing_plane(bodies[1]);
        vm_scene_keep_budget(&s, k == 4 ? &book : NULL);
        CHECK(vm_scene_start(&s, t, y, NULL) == VM_OK);
        status = vm_scene_run(&s, &t, 2, y, work, NULL);
        CHECK(status == (k == 1 ? VM_BAD_MASS : k == 2 ? VM_IS_AWAY : k == 3 ? VM_NOT_FINITE : VM_OK));
        CHECK(t == (k % 4 ? 1 : 2));
        vm_scene_body_at(&s, 0, y, &now);
        CHECK(k % 4 == 0 || now.mass == 2);
        if (k % 4) continue;
        CHECK(now.mass == R(1.5));
        vm_scene_body_at(&s, 1, y, &part); /* at rest in the body at 0.25: from there on uniformly, at the spin 1 */
        check_error(
            "part after a jump", "r", "eps",
            hypot((double)part.r.x - 0.25 * (cos(1) - sin(1)), (double)part.r.y - 0.25 * (sin(1) + cos(1))) /
                (double)VM_EPSILON,
            64, k, 0);
        CHECK(fabs((double)(part.mass * part.r.x + now.mass * now.r.x)) < 64 * (double)VM_EPSILON);
    }
}

/* Two bodies whose masses run out at once; inertia that streams take away; a point as a free body */
static void test_scene_losses(void)
{
    vm_scene_body bodies[2];
    vm_effect effects[4];
    vm_real y[64], work[VM_SCENE_WORK(64)], t = 0;
    vm_stream stream;
    vm_body body;
    vm_scene s;
    int free;
    memset(&s, 0, sizeof s);
    memset(&stream, 0, sizeof stream);
    memset(&body, 0, sizeof body);
    bodies[0] = bodies[1] = vm_scene_body_line(2, 0, 1);
    effects[0] = vm_effect_mass(0, VM_MASS_OF_T, -1, 0, 1);
    effects[1] = vm_effect_mass(1, VM_MASS_OF_T, -1, 0, 1);
    s.bodies = bodies;
    s.n_bodies = 2;
    s.effects = effects;
    s.n_effects = 2;
    CHECK(vm_scene_start(&s, t, y, NULL) == VM_OK);
    CHECK(vm_scene_run(&s, &t, 3, y, work, NULL) == VM_BAD_MASS && t <= 2 && t > R(1.9));
    body.mass = 2;
    body.v.x = 1;
    body.omega.z = 1;
    body.inertia.xx = body.inertia.yy = body.inertia.zz = 1;
    stream.rate = -1;
    stream.at.x = 2;
    stream.motion = VM_RELATIVE; /* from outside of it: the inertia ends first */
    for (free = 0; free < 2; free++) {
        vm_scene_body made = vm_scene_body_plane(2, 1, vmi_vec3(0, 0, 0), 0, vmi_vec3(1, 0, 0), 1);
        bodies[0] = free ? vm_scene_body_growing_free(vm_scene_body_free(&body)) : vm_scene_body_growing_plane(made);
        effects[0] = vm_effect_stream_mass(0, &stream);
        s.n_bodies = s.n_effects = 1;
        t = 0;
        CHECK(vm_scene_start(&s, t, y, NULL) == VM_OK);
        CHECK(vm_scene_run(&s, &t, 3, y, work, NULL) < 0 && t < 2 && t > 0);
    }
    body.inertia.xx = body.inertia.yy = body.inertia.zz = 0;
    body.omega.z = 0;
    bodies[0] = vm_scene_body_free(&body);
    effects[0] = vm_effect_gravity(0, 2, -2);
    t = 0;
    CHECK(vm_scene_start(&s, t, y, NULL) == VM_OK && vm_scene_run(&s, &t, 3, y, work, NULL) == VM_OK);
    vm_scene_body_at(&s, 0, y, &body);
    check_error("point as free body", "r", "eps",
                hypot((double)body.r.x - 3, (double)body.r.z + 9) / (double)VM_EPSILON, 2000, 0,
                0); /* of 9, the roundings of all steps */
    bodies[0] = vm_scene_body_growing_free(bodies[0]);
    t = 0;
    CHECK(vm_scene_start(&s, t, y, NULL) != VM_OK || vm_scene_run(&s, &t, 3, y, work, NULL) == VM_BAD_INERTIA);
}

/* What an event makes of the state: no number, with a status of its own or without, or more events than can be */
static long happenings;
static int break_state(vm_real t, vm_real *y, void *ctx)
{
    (void)t;
    y[1] = VM_NAN;
    return *(const int *)ctx;
}
static int nothing_more(vm_real t, vm_real *y, void *ctx)
{
    (void)t;
    (void)y;
    (void)ctx;
    happenings++;
    return VM_OK;
}

/* An event that has always just not happened yet, until 10000 are enough; a ball that comes to rest */
static int wake(vm_real t, vm_real *y, void *ctx)
{
    vm_event *e = (vm_event *)ctx;
    (void)y;
    e->time = t;
    e->count = 0;
    e->most = 0;
    return ++happenings > 10000 ? -77 : VM_OK;
}
static int bounce(vm_real t, vm_real *y, void *ctx)
{
    (void)t;
    y[0] = 0;
    y[1] = -y[1] / 2;
    return ++happenings == *(const long *)ctx ? VM_STOPPED : VM_OK;
}

static void test_too_many_events(void)
{
    vm_scene_body body = vm_scene_body_line(1, 1, 0);
    vm_effect effect = vm_effect_gravity(0, 0, R(-9.81));
    vm_event event = vm_then_user(vm_event_at(1), wake, &event);
    ode_event located;
    vm_real y[8], work[VM_SCENE_WORK(8)], t = 0;
    long last = 0;
    vm_scene s;
    memset(&s, 0, sizeof s);
    s.bodies = &body;
    s.n_bodies = 1;
    s.effects = &effect;
    s.n_effects = 1;
    s.events = &event;
    s.located = &located;
    s.n_events = 1;
    happenings = 0;
    CHECK(vm_scene_start(&s, t, y, NULL) == VM_OK && vm_scene_run(&s, &t, 2, y, work, NULL) == -77 && t == 1);
    event = vm_then_user(vm_event_position(0, 0, 0, -1), bounce, &last);
    t = 0;
    happenings = 0;
    CHECK(vm_scene_start(&s, t, y, NULL) == VM_OK);
    CHECK(vm_scene_run(&s, &t, 10, y, work, NULL) == VM_TOO_MANY_EVENTS);
    last = happenings;
    t = 0;
    happenings = 0; /* the last contact also ends the run: that is what it says */
    CHECK(vm_scene_start(&s, t, y, NULL) == VM_OK);
    CHECK(vm_scene_run(&s, &t, 10, y, work, NULL) == VM_STOPPED && happenings == last);
}

static void test_events_that_break(void)
{
    const int statuses[2] = {VM_OK, -77};
    vm_scene_body body;
    vm_effect effect = vm_effect_linear_spring(0, 0, VM_GROUND, 0, 1, 0);
    vm_event events[2];
    ode_event located[2];
    vm_real y[8], work[VM_SCENE_WORK(8)], t;
    vm_scene s;
    int k;
    memset(&s, 0, sizeof s);
    s.bodies = &body;
    s.n_bodies = 1;
    s.effects = &effect;
    s.n_effects = 1;
    s.events = events;
    s.located = located;
    for (k = 0; k < 2; k++) {
        int status = statuses[k];
        body = vm_scene_body_line(1, 1, 0);
        s.n_events = 1;
        t = 0;
        events[0] = vm_then_user(vm_event_at(1), break_state, &status);
        CHECK(vm_scene_start(&s, t, y, NULL) == VM_OK);
        CHECK(vm_scene_run(&s, &t, 2, y, work, NULL) == (k ? -77 : VM_NOT_FINITE) && t == 1);
    }
    body = vm_scene_body_line(1, 1, 0);
    s.n_events = 2;
    t = 0;
    happenings = 0; /* two at the same instants, twice */
    for (k = 0; k < 2; k++) events[k] = vm_then_user(vm_event_position(0, 0, 0, 0), nothing_more, NULL);
    CHECK(vm_scene_start(&s, t, y, NULL) == VM_OK);
    CHECK(vm_scene_run(&s, &t, 6, y, work, NULL) == VM_OK && t == 6 && happenings == 4);
}

#include "null_pointers.h"

/* -- Statuses, arrays that are too short, scenes that are not started -- */

/* Every status has a text, and no two have the same */
static void test_statuses(void)
{
    int i, k;
    for (i = VM_NOT_STARTED; i <= VM_TOLERANCE_MISSED; i++) {
        CHECK(strcmp(vm_strerror(i), vm_strerror(99)) != 0);
        for (k = VM_NOT_STARTED; k < i; k++) CHECK(strcmp(vm_strerror(i), vm_strerror(k)) != 0);
    }
    CHECK(strcmp(vm_strerror(VM_NOT_STARTED - 1), vm_strerror(99)) == 0);
}

static vm_real blows_up(vm_real t, vm_real x, vm_real v, void *ctx) { return (void)t, (void)x, (void)ctx, v * v; }
static vm_real no_force(vm_real t, vm_real x, vm_real v, void *ctx)
{
    return (void)x, (void)v, (void)ctx, t < 1 ? 0 : VM_NAN;
}
static vm_mass_now no_law(vm_real t, vm_real x, vm_real v, void *ctx)
{
    vm_mass_now now = {2, 0, 0, 0};
    (void)x;
    (void)v;
    if (t >= 1) now.mass = *(const vm_real *)ctx;
    return now;
}
static vm_real no_event(vm_real t, const vm_real *y, void *ctx)
{
    return (void)y, (void)ctx, t < 1 ? 1 : VM_NAN;
}

/* Why a run ends early, a status each: the scene itself is good */
static void test_ends_of_runs(void)
{
    const vm_vec3 zero = {0, 0, 0};
    vm_real y[8], work[VM_SCENE_WORK(8)], t, none = VM_NAN, endless = VM_INFINITY, nothing_left = 0;
    vm_scene_body body = vm_scene_body_line(1, 0, 1);
    vm_effect effect;
    vm_event event = vm_event_user(no_event, NULL, 0);
    ode_event located;
    rk45_options o;
    vm_scene s;
    int k;
    memset(&s, 0, sizeof s);
    s.bodies = &body;
    s.n_bodies = 1;
    s.effects = &effect;
    s.n_effects = 1;
    s.events = &event;
    s.located = &located;
    for (k = 0; k < 10; k++) {
        static const int wanted[10] = {VM_STEP_TOO_SMALL, VM_NOT_FINITE, VM_NOT_FINITE,  VM_NOT_FINITE, VM_BAD_MASS,
                                       VM_NOT_FINITE,     VM_MAX_STEPS,  VM_BAD_OPTIONS, VM_NOT_FINITE, VM_BAD_TIMES};
        int status;
        o = rk45_defaults(NULL);
        t = 0;
        s.n_events = k == 5;
        effect = vm_effect_motor(0, 0, 1, 0);
        if (k == 0) effect = vm_effect_force(0, 0, blows_up, NULL); /* v = 1/(1 - t) */
        if (k == 1) effect = vm_effect_force(0, 0, no_force, NULL);
        if (k >= 2 && k <= 4)
            effect = vm_effect_mass_law(0, no_law, k == 2 ? &none : k == 3 ? &endless : &nothing_left, zero, 1);
        if (k == 6) {
            o.max_steps = 2;
            o.h_max = R(0.01);
        }
        if (k == 7) {
            o.h_min = 2;
            o.h_max = 1;
        }
        CHECK(vm_scene_start(&s, t, y, NULL) == VM_OK);
        if (k == 8) y[1] = VM_NAN;
        if (k == 9) t = 4;
        status = vm_scene_run(&s, &t, 3, y, work, &o);
        if (status != wanted[k]) printf("end %d: %s, not %s\n", k, vm_strerror(status), vm_strerror(wanted[k]));
        CHECK(status == wanted[k]);
        if (k < 5) CHECK(t > R(0.99) && t < R(1.001)); /* where it goes wrong */
        if (k == 6) CHECK(vm_scene_run(&s, &t, 3, y, work, NULL) == VM_OK && t == 3); /* goes on */
    }
}

/* Arrays whose size is known are checked before anything is written */
static void test_sizes_of_scenes(void)
{
    vm_scene_body bodies[2];
    vm_real y[5], work[VM_SCENE_WORK(5)], t = 0;
    vm_budget book;
    vm_scene s;
    int i;
    memset(&s, 0, sizeof s);
    bodies[0] = vm_scene_body_line(1, 0, 1);
    bodies[1] = vm_scene_body_with_mass_state(bodies[0]);
    s.bodies = bodies;
    s.n_bodies = 2;
    for (i = -1; i < 5; i++) { /* less than 5 numbers */
        s.y_size = i ? i : 4;
        y[0] = 7;
        CHECK(vm_scene_start(&s, 0, y, NULL) == VM_SHORT_ARRAY && y[0] == 7);
        CHECK(vm_scene_run(&s, &t, 1, y, work, NULL) == VM_NOT_STARTED && y[0] == 7);
    }
    s.y_size = VM_LENGTH(y);
    s.work_size = VM_LENGTH(work);
    CHECK(vm_scene_start(&s, 0, y, NULL) == VM_OK && vm_scene_run(&s, &t, 1, y, work, NULL) == VM_OK && t == 1);
    s.work_size--;
    work[0] = 7;
    CHECK(vm_scene_run(&s, &t, 2, y, work, NULL) == VM_SHORT_ARRAY && t == 1 && work[0] == 7);
    s.work_size++;
    s.y_size--;
    CHECK(vm_scene_run(&s, &t, 2, y, work, NULL) == VM_SHORT_ARRAY && t == 1 && work[0] == 7);
    s.y_size++;
    vm_scene_keep_budget(&s, &book); /* needs VM_BUDGET numbers more */
    CHECK(vm_scene_start(&s, 0, y, NULL) == VM_SHORT_ARRAY);
    s.y_size = s.work_size = 0;
    vm_scene_keep_budget(&s, NULL); /* not checked */
    CHECK(vm_scene_start(&s, 0, y, NULL) == VM_OK && vm_scene_run(&s, &t, 3, y, work, NULL) == VM_OK && t == 3);
}

static void test_sizes_of_flows(void)
{
    const vm_body body = a_body(3);
    vm_real y[VM_FLOW_BALANCED_STATES + 1], d[VM_FLOW_BALANCED_STATES];
    vm_flow flow;
    vm_body now;
    int i, k, known;
    for (i = 1; i <= VM_FLOW_BALANCED_STATES; i++) {
        memset(&flow, 0, sizeof flow);
        flow.y_size = i;
        for (k = 0; k <= VM_FLOW_BALANCED_STATES; k++) y[k] = 7;
        CHECK(vm_flow_start(&flow, &body, y) == (i < VM_FLOW_GIVEN_STATES ? VM_SHORT_ARRAY : VM_OK));
        for (known = 0; y[known] != 7; known++) continue; /* of the numbers that are written none is 7 */
        CHECK(known == (i < VM_FLOW_GIVEN_STATES ? 0 : i < VM_FLOW_STATES ? VM_FLOW_GIVEN_STATES : i < VM_FLOW_BALANCED_STATES ? VM_FLOW_STATES : i));
        if (i < VM_FLOW_GIVEN_STATES) continue;
        CHECK(vm_flow_given_rhs(0, y, d, &flow) == 0 && vm_flow_carried_rhs(0, y, d, &flow) == 0);
        CHECK(vm_flow_rhs(0, y, d, &flow) == (i < VM_FLOW_STATES ? VM_SHORT_ARRAY : VM_OK));
        CHECK(vm_flow_balanced_rhs(0, y, d, &flow) == (i < VM_FLOW_BALANCED_STATES ? VM_SHORT_ARRAY : VM_OK));
        CHECK(vm_flow_body(&flow, VM_FLOW_GIVEN_STATES, y, &now) == VM_OK);
        CHECK(vm_flow_body(&flow, VM_FLOW_STATES, y, &now) == (i < VM_FLOW_STATES ? VM_SHORT_ARRAY : VM_OK));
    }
    flow.y_size = VM_TRANSLATION_STATES - 1;
    CHECK(vm_translation_rhs(0, y, d, &flow) == VM_SHORT_ARRAY && flow.status == VM_SHORT_ARRAY);
    CHECK(vm_flow_carried_rhs(0, y, d, &flow) == VM_SHORT_ARRAY);
}

/* A scene that was never started, whose start was refused, or that has got other bodies, effects or events since, or
   was copied so that its events belong to another: none of them runs */
static void test_not_started(void)
{
    vm_scene_body bodies[2];
    vm_effect effects[2];
    vm_event events[2];
    ode_event located[2];
    vm_real y[64], work[VM_SCENE_WORK(64)], t = 0;
    vm_scene s, copy;
    vm_budget book;
    vm_body now;
    int k;
    for (k = 0; k < 6; k++) {
        memset(&s, 0, sizeof s);
        memset(y, 0, sizeof y);
        bodies[0] = bodies[1] = vm_scene_body_line(1, 0, 1);
        effects[0] = effects[1] = vm_effect_motor(0, 0, 1, 0);
        events[0] = events[1] = vm_then_stop(vm_event_at(1));
        s.bodies = bodies;
        s.n_bodies = 1;
        s.effects = effects;
        s.n_effects = 1;
        s.events = events;
        s.located = located;
        s.n_events = 1;
        vm_scene_keep_budget(&s, &book);
        if (k == 1) effects[0].p[0] = VM_NAN;
        if (k > 0) CHECK(vm_scene_start(&s, 0, y, NULL) == (k == 1 ? VM_NOT_FINITE : VM_OK));
        if (k == 2) s.n_bodies++;
        if (k == 3) effects[0] = vm_effect_damper(0, 0, VM_GROUND, 0, 1);
        if (k == 4) events[0] = vm_then_stop(vm_event_at(2));
        if (k == 5) copy = s;
        CHECK(vm_scene_run(k == 5 ? &copy : &s, &t, 2, y, work, NULL) == VM_NOT_STARTED && t == 0);
        CHECK(vm_scene_budget_at(k == 5 ? &copy : &s, 0, y, &book) == VM_NOT_STARTED);
        vm_scene_body_at(&s, k < 2 ? 0 : 7, y, &now);
        CHECK(now.mass != now.mass && now.omega.z != now.omega.z);
    }
}


int main(void)
{
    test_special_functions();
    test_jumps();
    test_lists_of_bodies();
    test_rotor();
    test_pendulum_limits();
    test_lagrange_limits();
    test_streams();
    test_stream_limits();
    test_lagrange();
    test_drum_limits();
    test_oscillators();
    test_laws();
    test_failing_laws();
    test_oscillator_limits();
    test_slow_vibrations();
    test_slow_limits();
    test_forced_limits();
    test_integrators();
    test_broken_right_hand_sides();
    test_points_found();
    test_scenes();
    test_runs();
    test_scene_refusals();
    test_run_times();
    test_scene_jumps();
    test_scene_losses();
    test_events_that_break();
    test_too_many_events();
    test_statuses();
    test_ends_of_runs();
    test_sizes_of_scenes();
    test_sizes_of_flows();
    test_not_started();
    test_null_pointers();
    return check_finish("refusals");
}
