/* What the functions of slow vibrations and of excitation refuse (7.6 to 8): Van der Pol's oscillator, Laval's rotor,
   the pair of oscillators, harmonic excitation, and the search for points of a motion. Numbers and pointers that are
   none, masses that are none, shafts without stiffness, motions at the ends of the numbers. The outputs must stay as
   they were. */
#include "refusals.h"
#include "valid_objects.h"

static const double eps = (double)VM_EPSILON;

/* ---- Van der Pol's oscillator, Laval's rotor, pairs, harmonic excitation: each number spoiled ---- */

static int vdp_init(trial *a)
{
    vm_vdp v;
    memset(&v, 0, sizeof v);
    v.alpha = next(a);
    v.k = next(a);
    v.feed = next(a);
    v.c = next(a);
    v.reactive = next(a);
    v.method = VM_VDP_JACOBI;
    if (a->null_pointer == 0) return vm_vdp_init(NULL);
    if (vm_vdp_init(&v) < 0) return v.a1 == 0 && v.a2 == 0 && v.a3 == 0 ? -1 : 0;
    return value(a, v.a1);
}

/* The linear law that the next two numbers make */
static vm_law next_law(trial *a)
{
    const vm_real f0 = next(a);
    return vm_law_linear(f0, next(a));
}

static int vdp_amplitude(trial *a)
{
    vm_vdp v = a_vdp();
    const vm_real t = next(a), A0 = next(a);
    v.mass = next_law(a);
    if (vm_vdp_init(&v)) return -1;
    return value(a, vm_vdp_amplitude(&v, t, A0));
}

static int laval_frequency(trial *a)
{
    const vm_jeffcott r = a_laval();
    const vm_real A = next(a);
    return value(a, vm_jeffcott_frequency(&r, A, next(a), 1));
}

static int laval_amplitude(trial *a)
{
    const vm_jeffcott r = a_laval();
    const vm_real A0 = next(a), mass0 = next(a);
    return value(a, vm_jeffcott_amplitude(&r, A0, mass0, next(a)));
}

/* A pair and its state, of the next numbers */
static vm_pair next_pair(trial *a, vm_real *y)
{
    vm_pair p = a_pair();
    p.alpha = next(a);
    p.k = next(a);
    p.reactive = next(a);
    take(a, y, 4 * sizeof *y);
    p.mass = next_law(a);
    return p;
}

static int pair_at(trial *a)
{
    const vm_real t = next(a);
    vm_real y[4];
    const vm_pair p = next_pair(a, y);
    return vm_pair_at(&p, t, y, (vm_real *)(void *)a->output);
}

static int pair_split(trial *a)
{
    const vm_real t = next(a);
    vm_real y[4];
    const vm_pair p = next_pair(a, y);
    return vm_pair_to_averaged(&p, t, y, (vm_real *)(void *)a->output);
}

static vm_forced forced(trial *a)
{
    vm_forced f;
    memset(&f, 0, sizeof f);
    f.alpha = next(a);
    f.damping = next(a);
    f.reactive = next(a);
    f.mass = next_law(a);
    f.stiffness = next_law(a);
    f.frequency = next_law(a);
    f.force = next_law(a);
    return f;
}

#define FORCED 3, R(0.1), 1, 2, R(0.01), 3, R(0.01), 2, R(0.01), R(0.5), R(0.01)

static int forced_init(trial *a)
{
    vm_forced f = forced(a);
    if (a->null_pointer == 0) return vm_forced_init(NULL);
    return vm_forced_init(&f) < 0 ? -1 : value(a, f.pi);
}

static int forced_split(trial *a)
{
    const vm_forced f = a_forced();
    vm_real motion[3];
    take(a, motion, sizeof motion);
    return vm_forced_to_averaged(&f, 0, motion, (vm_real *)(void *)a->output);
}

static int forced_join(trial *a)
{
    const vm_forced f = a_forced();
    vm_real y[3];
    take(a, y, sizeof y);
    return vm_forced_from_averaged(&f, 0, y, (vm_real *)(void *)a->output);
}

static int adiabaticity(trial *a)
{
    const vm_real t = next(a), A = next(a);
    vm_osc_problem o;
    memset(&o, 0, sizeof o);
    o.mass = next_law(a);
    o.stiffness = next_law(a);
    o.damping = next(a);
    o.reactive = next(a);
    o.alpha = next(a);
    return value(a, vm_adiabaticity(&o, t, A));
}

/* A rotor with every number of the next ones: gyro, reactive, both parts of u, and the law of the mass */
static vm_jeffcott next_laval(trial *a)
{
    vm_jeffcott r = a_laval();
    r.gyro = next(a);
    r.reactive = next(a);
    r.u.re = next(a);
    r.u.im = next(a);
    r.mass = next_law(a);
    return r;
}

static int laval_split(trial *a)
{
    static const vm_power_force linear = {2, 1};
    vm_jeffcott r = a_laval();
    vm_real motion[4], t;
    r.stiffness_ctx = (void *)&linear;
    r.mass = next_law(a);
    take(a, motion, sizeof motion);
    t = next(a);
    return vm_jeffcott_to_averaged(POINTER(0, &r), t, POINTER(1, motion), next(a), OUT(2, vm_real, 0));
}

static int laval_join(trial *a)
{
    static const vm_power_force linear = {2, 1};
    vm_jeffcott r = a_laval();
    vm_real y[5];
    r.stiffness_ctx = (void *)&linear;
    r.mass = next_law(a);
    take(a, y, sizeof y);
    return vm_jeffcott_from_averaged(POINTER(0, &r), next(a), POINTER(1, y), OUT(2, vm_real, 0));
}

static int laval_whirl_amplitude(trial *a)
{
    const vm_real first_A = next(a), mass0 = next(a), mass = next(a);
    vm_jeffcott r = a_laval();
    r.gyro = next(a);
    r.reactive = next(a);
    return value(a, vm_jeffcott_whirl_amplitude(POINTER(0, &r), first_A, mass0, mass, 1));
}

/* mass0 and mass where vm_jeffcott_amplitude has no closed form, too: both without spoiled numbers */
static int laval_whirl(trial *a)
{
    vm_jeffcott r = next_laval(a);
    const vm_real A = next(a), angle = next(a);
    r.u.re -= 1; /* good numbers are not 0 */
    r.u.im -= 1;
    return vm_jeffcott_whirl_at(POINTER(0, &r), A, angle, 1, next(a), OUT(1, vm_jeffcott_whirl, 0));
}

static int laval_linear(trial *a)
{
    static const vm_power_force linear = {2, 1};
    vm_jeffcott r = next_laval(a);
    vm_real start[4];
    take(a, start, sizeof start);
    r.u.re -= 1;
    r.u.im -= 1;
    r.stiffness_ctx = (void *)&linear;
    return vm_jeffcott_linear_at(POINTER(0, &r), POINTER(1, start), next(a), OUT(2, vm_real, 0));
}

/* Two bodies of different masses, of the next numbers */
static vm_coupled_pair next_coupled_pair(trial *a, vm_connection *spring)
{
    vm_coupled_pair p = a_coupled_pair();
    spring->k = next(a);
    spring->alpha = next(a);
    p.connections = spring;
    p.mass[0] = next_law(a);
    p.mass[1] = next_law(a);
    p.reactive = next(a);
    p.damping = next(a);
    return p;
}

#define COUPLED 2, 3, 2, R(0.01), 3, R(0.02), 1, R(0.1)

static int coupled_split(trial *a)
{
    vm_connection spring;
    const vm_coupled_pair p = next_coupled_pair(a, &spring);
    vm_real y[4];
    take(a, y, sizeof y);
    return vm_coupled_pair_to_modes(POINTER(0, &p), next(a), POINTER(1, y), OUT(2, vm_real, 0));
}

static int coupled_join(trial *a)
{
    vm_connection spring;
    const vm_coupled_pair p = next_coupled_pair(a, &spring);
    vm_real modes[4];
    take(a, modes, sizeof modes);
    return vm_coupled_pair_from_modes(POINTER(0, &p), next(a), POINTER(1, modes), OUT(2, vm_real, 0));
}

/* The pair stays as it was if the oscillator is refused. */
static int coupled_oscillator(trial *a)
{
    static const vm_osc_problem none;
    vm_connection spring;
    vm_coupled_pair p = next_coupled_pair(a, &spring);
    vm_osc_problem o = none;
    vm_real y[4];
    int status;
    take(a, y, sizeof y);
    status = vm_coupled_pair_oscillator(POINTER(0, &p), POINTER(1, y), POINTER(2, &o));
    if (status < 0) CHECK(p.momentum == 0 && o.x == 0);
    return status < 0 ? status : value(a, o.x);
}

static int forced_curve(trial *a)
{
    const vm_forced f = a_forced();
    const vm_real t = next(a);
    a->is_value = 1; /* results that overflow are NaN */
    return vm_forced_curve(POINTER(0, &f), t, next(a), OUT(1, vm_steady_state, 0));
}

/* The oscillator under a periodic force, with the next numbers as the coefficients of its shape */
static vm_periodic next_periodic(trial *a)
{
    vm_periodic p = a_periodic();
    take(a, p.cosine, sizeof p.cosine);
    take(a, p.sine, sizeof p.sine);
    return p;
}

#define SHAPE 0, 1, 0, 0, 0, R(0.1), 0, 0, 0, 0, 0, 0, 0, R(0.5), 0, 0, 0, 0, R(0.1), 0

/* Stains the output again where a function has written no vm_real: an int, and the unused bytes after it */
static int without_rest(trial *a, int status, size_t numbers, size_t size)
{
    if (status >= 0) memset(a->output + numbers, STAIN, size - numbers);
    return status;
}

static int periodic_curve(trial *a)
{
    const vm_periodic p = next_periodic(a);
    const vm_real t = next(a);
    const int status = vm_periodic_curve(POINTER(0, &p), t, next(a), OUT(1, vm_steady_state, 0));
    return without_rest(a, status, offsetof(vm_steady_state, stable), sizeof(vm_steady_state));
}

static int periodic_split(trial *a)
{
    const vm_periodic p = next_periodic(a);
    vm_real motion[3];
    take(a, motion, sizeof motion);
    return vm_periodic_to_averaged(POINTER(0, &p), next(a), POINTER(1, motion), OUT(2, vm_real, 0));
}

static int periodic_join(trial *a)
{
    const vm_periodic p = next_periodic(a);
    vm_real y[3];
    take(a, y, sizeof y);
    return vm_periodic_from_averaged(POINTER(0, &p), next(a), POINTER(1, y), OUT(2, vm_real, 0));
}

static int grounded_split(trial *a)
{
    vm_grounded_pair p = a_grounded_pair();
    vm_real motion[4];
    p.spring = next(a);
    p.damper = next(a);
    take(a, motion, sizeof motion);
    return vm_grounded_pair_to_averaged(POINTER(0, &p), next(a), POINTER(1, motion), OUT(2, vm_real, 0));
}

static int grounded_join(trial *a)
{
    vm_grounded_pair p = a_grounded_pair();
    vm_real y[4];
    p.spring = next(a);
    p.damper = next(a);
    take(a, y, sizeof y);
    return vm_grounded_pair_from_averaged(POINTER(0, &p), next(a), POINTER(1, y), OUT(2, vm_real, 0));
}

/* A Van der Pol oscillator, of the next numbers */
static vm_vdp next_vdp(trial *a)
{
    vm_vdp v = a_vdp();
    v.k = next(a);
    v.feed = next(a);
    v.c = next(a);
    v.reactive = next(a);
    v.mass = next_law(a);
    return v;
}

#define VDP 2, R(0.1), R(0.2), 1, 2, R(0.01)

static int vdp_plan(trial *a)
{
    vm_vdp v = next_vdp(a);
    static vm_vdp_plan plan;
    vm_osc_motion motion = {0, 0, 0, 0, 0, 0};
    const vm_real x = next(a), rate = next(a), t = next(a), tolerance = next(a);
    int status = vm_vdp_init(&v);
    if (!status) status = vm_vdp_plan_init(POINTER(0, &plan), POINTER(1, &v), x, rate);
    if (!status) status = vm_vdp_plan_by_route(&plan, VM_ROUTE_ORDER2, t, tolerance, POINTER(2, &motion));
    return status < 0 ? status : value(a, motion.x);
}

static int vdp_cycle(trial *a)
{
    vm_vdp v = next_vdp(a);
    int status;
    status = vm_vdp_init(&v);
    if (status < 0) return status;
    status = vm_vdp_cycle_of(POINTER(0, &v), OUT(1, vm_vdp_cycle, 0));
    return without_rest(a, status, offsetof(vm_vdp_cycle, stable), sizeof(vm_vdp_cycle));
}

static void test_rotors(void)
{
    REFUSES(laval_split, 3, 2, R(0.01), R(0.1), R(0.2), R(0.3), R(0.4), R(0.5), 1);
    REFUSES(laval_join, 3, 2, R(0.01), R(0.1), R(0.2), R(0.3), R(0.4), R(0.5), 1);
    REFUSES_SPOILED(laval_whirl_amplitude, 1, R(0.1), 2, 3, R(0.2), R(0.5));
    REFUSES_SPOILED(laval_whirl, 2, R(0.2), R(0.5), 1, 1, 2, R(0.01), R(0.1), R(0.2), 3);
    REFUSES_SPOILED(laval_linear, 3, R(0.2), R(0.5), 1, 1, 2, R(0.01), R(0.1), R(0.2), R(0.3), R(0.4), 3);
}

static void test_pairs_and_forces(void)
{
    REFUSES(coupled_split, 3, COUPLED, R(0.1), R(0.2), R(0.3), R(0.4), 1);
    REFUSES(coupled_join, 3, COUPLED, R(0.1), R(0.2), R(0.3), R(0.4), 1);
    REFUSES(coupled_oscillator, 3, COUPLED, R(0.1), R(0.2), R(0.3), R(0.4));
    REFUSES(forced_curve, 2, 1, R(0.2));
    REFUSES(periodic_curve, 2, SHAPE, 1, R(-0.7));
    REFUSES(periodic_split, 3, SHAPE, 1, R(0.2), R(0.3), R(0.4));
    REFUSES(periodic_join, 3, SHAPE, 1, R(0.2), R(0.3), R(0.4));
    REFUSES(grounded_split, 3, R(0.001), R(0.001), 1, R(0.9), R(0.2), R(0.3), 1);
    REFUSES(grounded_join, 3, R(0.001), R(0.001), 1, R(0.2), R(0.9), R(0.3), 1);
    REFUSES_SPOILED(vdp_plan, 3, VDP, R(0.1), R(0.2), 1, R(0.1));
    REFUSES(vdp_cycle, 2, 2, R(0.1), R(0.2), 1, 2, 0);
}

static void test_slow_vibrations(void)
{
    REFUSES(vdp_init, 1, 3, 2, R(0.1), R(0.2), 1);
    REFUSES(vdp_amplitude, 0, 1, R(0.1), 2, R(0.01));
    REFUSES(laval_frequency, 0, R(0.1), 2);
    REFUSES(laval_amplitude, 0, R(0.1), 2, 3);
    REFUSES(pair_at, 0, 1, 3, 2, 1, R(0.1), R(0.2), R(0.3), R(0.4), 2, R(0.01));
    REFUSES(pair_split, 0, 1, 3, 2, 1, R(0.1), R(0.2), R(0.3), R(0.4), 2, R(0.01));
    REFUSES(forced_init, 1, FORCED);
    REFUSES(forced_split, 0, 1, R(0.2), R(0.3));
    REFUSES(forced_join, 0, 1, R(0.2), R(0.3));
    REFUSES(adiabaticity, 0, 1, R(0.1), 2, R(0.01), 3, R(0.02), R(0.1), 1, 3);
}

/* ---- Van der Pol's oscillator and pairs ---- */

static void test_van_der_pol(void)
{
    const vm_vdp good = a_vdp();
    vm_vdp v = good;
    int stable;
    v.method = -1;
    CHECK(vm_vdp_init(&v) == VM_BAD_ARGUMENT);
    v.method = VM_VDP_TRIGONOMETRIC + 1;
    CHECK(vm_vdp_init(&v) == VM_BAD_ARGUMENT);
    v = good;
    v.alpha = -1;
    CHECK(vm_vdp_init(&v) == VM_DOMAIN);
    v.alpha = 1;
    v.k = 0;
    CHECK(vm_vdp_init(&v) == VM_BAD_STIFFNESS);
    v.alpha = -1; /* of two mistakes the first in the order of statuses */
    CHECK(vm_vdp_init(&v) == VM_BAD_STIFFNESS);
    v = good; /* neither driven nor damped but by c: rest is stable where c damps */
    v.feed = 0;
    CHECK(vm_vdp_init(&v) == VM_OK);
    v.c = -1;
    stable = 7;
    CHECK(vm_vdp_limit_cycle(&v, 0, &stable) == 0 && stable == 0);
    v.c = 1;
    stable = 7;
    CHECK(vm_vdp_limit_cycle(&v, 0, &stable) == 0 && stable == 1);
}

/* A law of 1 kg, whose rate is what ctx points to */
static int one_kg(vm_real t, vm_real *mass, vm_real *rate, void *ctx)
{
    (void)t;
    *mass = 1;
    *rate = *(const vm_real *)ctx;
    return 0;
}

static void test_pair(void)
{
    const vm_real y[4] = {R(0.1), R(0.2), R(0.3), R(0.4)};
    vm_real infinite = VM_INFINITY, rates[4];
    vm_pair pair = a_pair();
    pair.mass = vm_law_user(one_kg, &infinite);
    CHECK(vm_pair_averaged_rhs(0, y, rates, &pair) == VM_NOT_FINITE);
    pair.mass = vm_law_linear(0, 0);
    CHECK(vm_pair_averaged_rhs(0, y, rates, &pair) == VM_BAD_MASS);
    pair.k = 0; /* of two mistakes the first in the order of statuses */
    CHECK(vm_pair_averaged_rhs(0, y, rates, &pair) == VM_BAD_MASS);
    pair.mass = vm_law_linear(1, 0);
    CHECK(vm_pair_averaged_rhs(0, y, rates, &pair) == VM_BAD_STIFFNESS);
    memset(&pair.mass, 0, sizeof pair.mass);
    CHECK(vm_pair_averaged_rhs(0, y, rates, &pair) == VM_BAD_ARGUMENT);
}

/* ---- Laval's rotor ---- */

/* A damping and a nonlinear cross coupling */
static vm_complex pull(vm_real t, vm_complex z, vm_complex v, void *ctx)
{
    (void)t;
    (void)ctx;
    return vmi_complex(R(-0.1) * v.re, R(-0.1) * v.im - R(0.2) * z.re * z.re * z.im);
}

/* Averages by 64 nodes are those by the default number; a shaft without stiffness is refused. */
static void test_laval(void)
{
    const vm_power_force none = {0, 1};
    vm_jeffcott r = a_laval();
    vm_real y[4] = {R(0.1), R(0.2), R(0.3), R(0.4)}, rates[2][4], rate = R(0.1);
    r.mass = vm_law_user(one_kg, &rate);
    r.force = pull;
    CHECK(vm_jeffcott_forward_whirl_rhs(0, y, rates[0], &r) == VM_OK);
    r.nodes = 64;
    CHECK(vm_jeffcott_forward_whirl_rhs(0, y, rates[1], &r) == VM_OK);
    check_error("Laval", "nodes", "eps", ERROR_EPS(rates[0][1], (double)rates[1][1], 0, 1), 64, 0, 0);
    CHECK(vm_jeffcott_amplitude(&r, R(0.1), 2, 2) == R(0.1));
    r.stiffness_ctx = (void *)&none;
    CHECK(vm_jeffcott_forward_whirl_rhs(0, y, rates[0], &r) == VM_BAD_STIFFNESS);
    CHECK(vm_jeffcott_backward_whirl_rhs(0, y, rates[0], &r) == VM_BAD_STIFFNESS);
}

/* An elastic force of 3 N/m that is known up to a radius */
static vm_real known_to(vm_real rho, vm_real *slope, void *radius)
{
    *slope = 0;
    return rho <= *(const vm_real *)radius ? 3 : VM_NAN;
}

/* The amplitude (m0/m)^(1/4) is inside the radius to which the stiffness is known, or not; and it is, but for some
   eps, the first point that is looked at, e^(1/16). */
static void test_stiffness_known_to_a_radius(void)
{
    vm_jeffcott r = a_laval();
    vm_real radius = R(1.05);
    double A;
    int k;
    r.stiffness = known_to;
    r.stiffness_ctx = &radius;
    A = (double)vm_jeffcott_amplitude(&r, 1, 1, (vm_real)pow(1.04, -4));
    check_error("Laval", "known to 1.05", "eps", fabs(A - 1.04) / eps, 8, 0, 0);
    CHECK(isnan((double)vm_jeffcott_amplitude(&r, 1, 1, (vm_real)pow(1.1, -4))));
    radius = 1;
    CHECK(isnan((double)vm_jeffcott_amplitude(&r, 1, 1, R(0.5))));
    radius = VM_MAX;
    for (k = -8; k < 9; k++) {
        const vm_real mass = (vm_real)exp(-0.25) * (1 + (vm_real)k * VM_EPSILON / 2);
        A = (double)vm_jeffcott_amplitude(&r, 1, 1, mass);
        check_error("Laval", "first point", "eps", fabs(A - pow((double)mass, -0.25)) / eps, 4, k, 0);
    }
    CHECK(vmi_find_zero(NULL, NULL, 1, 2, 0, 3) == 1 && vmi_find_zero(NULL, NULL, 1, 2, 3, 0) == 2); /* at an end */
}

/* ---- Harmonic excitation ---- */

static void test_forced(void)
{
    const vm_real y[3] = {-1, 0, 0};
    vm_forced f = a_forced();
    vm_steady_state curve[2];
    vm_passage passage;
    vm_real motion[3];
    CHECK(vm_forced_from_averaged(&f, 0, y, motion) == VM_DOMAIN);
    CHECK(vm_forced_curve(&f, 0, VM_NAN, curve) == VM_NOT_FINITE);
    CHECK(vm_forced_curve(&f, 0, VM_INFINITY, curve) == VM_NOT_FINITE && vm_forced_curve(&f, 0, 0, curve) == VM_DOMAIN);
    f.force = vm_law_linear(0, 0);
    CHECK(vm_forced_curve(&f, 0, 1, curve) == 0 && vm_forced_passage(&f, 0, 1, &passage) == VM_DOMAIN);
    f = a_forced();
    CHECK(vm_forced_init(&f) == VM_OK);
    f.alpha = -1;
    CHECK(vm_forced_init(&f) == VM_DOMAIN);
    f = a_forced();
    f.alpha = 1;
    CHECK(vm_forced_init(&f) == VM_OK);
    CHECK(vm_forced_passage(&f, 0, VM_NAN, &passage) == VM_DOMAIN);
    CHECK(vm_forced_passage(&f, 0, VM_INFINITY, &passage) == VM_DOMAIN);
    CHECK(vm_forced_passage(&f, 0, 1, &passage) == VM_OK && isnan(passage.delta)); /* linear: nothing holds it */
}

/* Free vibration holds itself without a force. A force that counts for nothing holds the backbone, nu = w(A). */
static void test_backbone(void)
{
    const vm_real A = (vm_real)ldexp(1, 40);
    vm_forced f = a_forced();
    vm_steady_state curve[3];
    double w;
    f.damping = 0;
    f.mass = vm_law_linear(2, 0);
    f.stiffness = vm_law_linear(3, 0);
    f.force = vm_law_linear(0, 0);
    CHECK(vm_forced_curve(&f, 0, 1, curve) == 0);
    f.force = vm_law_linear(VM_MIN, 0);
    CHECK(vm_forced_curve(&f, 0, A, curve) == 1);
    w = (double)(2 * VM_PI / vm_osc_period(A, VM_SQRT(f.stiffness.f0 / f.mass.f0), f.alpha));
    check_error("backbone", "", "eps", ERROR_EPS(curve[0].nu, w, 0, w), 8, (double)A, 0);
}

/* Motions within the ripple that the force makes have no amplitude of their own; motions at the end of the numbers */
static void test_forced_split(void)
{
    const vm_real ripple[3] = {R(0.001), 0, 0}, largest[3] = {VM_MAX, VM_MAX / 2, 0};
    vm_forced f = a_forced();
    vm_real y[3] = {7, 7, 7};
    f.force = vm_law_linear(1000, 0);
    CHECK(vm_forced_to_averaged(&f, 0, ripple, y) == VM_DOMAIN && y[0] == 7);
    if (vm_forced_to_averaged(&f, 0, largest, y) < 0) CHECK(y[0] == 7);
    else CHECK(VM_IS_FINITE(y[0]) && VM_IS_FINITE(y[1]));
}

/* alpha next to 1, where the turns of the resonance curve are far away */
static void test_nearly_linear(void)
{
    int k, j, found;
    for (k = 0; k < 40; k++) {
        const vm_real rates[3] = {R(1.25) + R(0.02) * (vm_real)(k % 5), R(0.2), 3};
        vm_forced f = a_forced();
        vm_steady_state curve[3];
        f.alpha = 1 + R(0.002) * (vm_real)(k - 20);
        f.damping = R(0.02) * (vm_real)(k % 3);
        f.mass = vm_law_linear(2, 0);
        f.stiffness = vm_law_linear(3, 0);
        CHECK(vm_forced_init(&f) == VM_OK);
        for (j = 0; j < 3; j++) {
            f.frequency = vm_law_linear(rates[j], 0);
            found = vm_forced_steady_states(&f, 0, curve);
            CHECK(found >= 0 && found <= 3);
            while (found > 0) {
                found--;
                CHECK(curve[found].A > 0 && VM_IS_FINITE(curve[found].A));
            }
        }
    }
}

/* ---- Points of a motion ---- */

/* x = t - 1 between two times, no number elsewhere */
static void line(vm_real t, vm_real *x, vm_real *v, void *ctx)
{
    const vm_real *from_to = (const vm_real *)ctx;
    *x = t - 1;
    if (t < from_to[0] || t > from_to[1]) *x = VM_NAN;
    *v = 1;
}

/* A zero exactly at a step is found once; one where the search begins is not. Motions that are no number are refused.
 */
static void test_points_found(void)
{
    vm_real known[2] = {-9, 9};
    vm_sample points[4];
    CHECK(vm_find_samples(line, known, VM_ZERO_CROSSINGS, 0, 2, R(0.25), 4, points) == 1);
    CHECK(points[0].t == 1 && points[0].x == 0 && points[0].v == 1);
    CHECK(vm_find_samples(line, known, VM_ZERO_CROSSINGS, 1, 2, R(0.25), 4, points) == 0);
    CHECK(vm_find_samples(line, known, VM_ZERO_CROSSINGS, 1, 1, R(0.25), 4, points) == 0);
    known[1] = R(0.75);
    CHECK(vm_find_samples(line, known, VM_ZERO_CROSSINGS, 0, 2, R(0.25), 4, points) == VM_NOT_FINITE);
    CHECK(vm_find_samples(line, known, VM_ZERO_CROSSINGS, 2, 2, R(0.25), 4, points) == VM_NOT_FINITE);
}

/* Before the first step there are no points in it. Null pointers, and components that the state lacks, are refused.
 */
static void test_points_of_step(void)
{
    const vm_real y[2] = {1, 0};
    vm_real work[RK45_WORK(2)], buffer[2];
    vm_sample points[4];
    rk45 s;
    CHECK(rk45_init(&s, oscillate, NULL, 2, 0, y, NULL, work) == ODE_OK);
    CHECK(vm_find_samples_of_step(&s, 0, 1, VM_ZERO_CROSSINGS, buffer, 4, points) == 0);
    CHECK(vm_find_samples_of_step(NULL, 0, 1, VM_ZERO_CROSSINGS, buffer, 4, points) == VM_BAD_ARGUMENT);
    CHECK(vm_find_samples_of_step(&s, 0, 1, VM_ZERO_CROSSINGS, NULL, 4, points) == VM_BAD_ARGUMENT);
    CHECK(vm_find_samples_of_step(&s, -1, 1, VM_ZERO_CROSSINGS, buffer, 4, points) == VM_BAD_ARGUMENT);
    CHECK(vm_find_samples_of_step(&s, 0, -1, VM_ZERO_CROSSINGS, buffer, 4, points) == VM_BAD_ARGUMENT);
    CHECK(vm_find_samples_of_step(&s, 2, 1, VM_ZERO_CROSSINGS, buffer, 4, points) == VM_BAD_ARGUMENT);
    CHECK(vm_find_samples_of_step(&s, 0, 2, VM_ZERO_CROSSINGS, buffer, 4, points) == VM_BAD_ARGUMENT);
}

/* The oscillator until *ctx evaluations are used up */
static int stops(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    long *left = (long *)ctx;
    oscillate(t, y, dydt, NULL);
    (*left)--;
    return *left >= 0 ? 0 : 9;
}

/* The inside of a step of rk87 takes evaluations of its own. If they fail, there are no points. */
static void test_points_of_broken_step(void)
{
    const vm_real y[2] = {1, 0};
    vm_real work[RK87_WORK(2)], buffer[2];
    long left = 1000;
    vm_sample points[4];
    rk87 s;
    CHECK(rk87_init(&s, stops, &left, 2, 0, y, NULL, work) == ODE_OK && rk87_step(&s) == ODE_OK);
    left = 0;
    CHECK(vm_find_samples_of_step(&s, 0, 1, VM_ZERO_CROSSINGS, buffer, 4, points) == VM_NOT_FINITE);
}

/* ---- Fields that are none ---- */

/* Rotors without stiffness or mass law, with a negative number of nodes; a power that is none */
static void test_impossible_shafts(void)
{
    const vm_power_force powers[3] = {{1, -1}, {1, VM_NAN}, {1, VM_INFINITY}};
    const vm_law unmade = {0}, constant = vm_law_linear(2, 0);
    vm_real y[6] = {R(0.1), R(0.2), 0, R(0.1), 0, 0}, d[6] = {7}, slope;
    vm_jeffcott_whirl whirl;
    vm_jeffcott r = a_laval();
    int k;
    for (k = 0; k < 3; k++) CHECK(isnan(vm_jeffcott_power(1, &slope, (void *)&powers[k])) && isnan(slope));
    r.nodes = -1;
    CHECK(vm_jeffcott_averaged_rhs(0, y, d, &r) == VM_BAD_ARGUMENT);
    CHECK(vm_jeffcott_forward_whirl_rhs(0, y, d, &r) == VM_BAD_ARGUMENT && d[0] == 7);
    r.nodes = 0;
    r.gyro = VM_NAN;
    CHECK(vm_jeffcott_forward_whirl_rhs(0, y, d, &r) == VM_NOT_FINITE);
    r.mass = unmade;
    CHECK(vm_jeffcott_forward_whirl_rhs(0, y, d, &r) == VM_BAD_ARGUMENT);
    r.mass = vm_law_linear(-1, 0);
    CHECK(vm_jeffcott_forward_whirl_rhs(0, y, d, &r) == VM_NOT_FINITE);
    r = a_laval();
    y[0] = VM_NAN;
    CHECK(vm_jeffcott_forward_whirl_rhs(0, y, d, &r) == VM_NOT_FINITE);
    r.mass = unmade;
    CHECK(vm_jeffcott_whirl_at(&r, 1, 0, 1, 1, &whirl) == VM_BAD_ARGUMENT);
    r.mass = constant;
    r.stiffness = NULL;
    r.gyro = 1;
    r.reactive = 0;
    CHECK(vm_jeffcott_whirl_at(&r, 1, 0, 1, 1, &whirl) == VM_BAD_ARGUMENT);
    CHECK(isnan(vm_jeffcott_whirl_amplitude(&r, 1, 1, 2, 1)) && isnan(vm_jeffcott_frequency(&r, 1, 1, 1)));
}

/* A disc at rest in the centre, where neither whirl has an amplitude; a shaft whose frequencies are 0 */
static void test_rotor_at_rest(void)
{
    static const vm_power_force linear = {2, 1}, softest = {VM_MIN, 1};
    const vm_real rest[4] = {0, 0, 0, 0};
    vm_real motion[4] = {7, 7, 7, 7}, y[5];
    vm_jeffcott r = a_laval();
    r.stiffness_ctx = (void *)&linear;
    CHECK(vm_jeffcott_linear_at(&r, rest, 1, motion) == VM_OK && motion[0] == 0 && motion[3] == 0);
    r.stiffness_ctx = (void *)&softest;
    r.mass = vm_law_linear(VM_MAX / 2, 0);
    CHECK(vm_jeffcott_to_averaged(&r, 0, rest, 0, y) < 0);
}

/* Velocities and amplitudes that overflow although the motion is finite */
static void test_overflowing_motions(void)
{
    const vm_power_force hardest = {VM_SQRT(VM_MAX), 1};
    const vm_real half = VM_MAX / 2, apart[4] = {-half, half, 0, 0}, fast[4] = {0, 0, -half, half};
    const vm_real wide[4] = {-VM_MAX, VM_MAX, 0, 0}, wild[4] = {0, 0, -VM_MAX, VM_MAX}, motion[3] = {0, half, 0};
    vm_real found[4] = {7, 7, 7, 7};
    vm_jeffcott r = a_laval();
    vm_coupled_pair coupled = a_coupled_pair();
    vm_pair pair = a_pair();
    vm_forced forced = a_forced();
    vm_jeffcott_whirl whirl;
    vm_osc_problem o;
    static vm_vdp_plan plan;
    vm_vdp v = a_vdp();
    vm_osc_motion m = {7, 7, 7, 7, 7, 7};
    r.stiffness_ctx = (void *)&hardest;
    CHECK(vm_jeffcott_whirl_at(&r, half, 0, 1, 1, &whirl) == VM_NOT_FINITE);
    coupled.mass[0] = coupled.mass[1] = vm_law_linear(R(0.125), 0);
    CHECK(vm_coupled_pair_oscillator(&coupled, wide, &o) == VM_NOT_FINITE);
    CHECK(vm_coupled_pair_oscillator(&coupled, wild, &o) == VM_NOT_FINITE && coupled.momentum == 0);
    pair.alpha = 0;
    CHECK(vm_pair_to_averaged(&pair, 0, fast, found) < 0 && found[0] == 7);
    CHECK(vm_pair_to_averaged(&pair, 0, apart, found) == VM_OK && VM_IS_FINITE(found[0]));
    forced.alpha = 0;
    CHECK(vm_forced_init(&forced) == VM_OK && vm_forced_to_averaged(&forced, 0, motion, found) < 0);
    v.alpha = 0;
    CHECK(vm_vdp_plan_init(&plan, &v, 0, half) < 0 || vm_vdp_plan_by_route(&plan, VM_ROUTE_ORDER2, 1, 0, &m) < 0);
    CHECK(m.x == 7);
}

/* Mass laws that no constructor made: null pointers and numbers that are none do not matter any more. */
static void test_unmade_laws(void)
{
    static const vm_law unmade;
    vm_real y[4] = {VM_NAN, 0, 0, 0}, found[4] = {7, 7, 7, 7};
    vm_coupled_pair coupled = a_coupled_pair();
    vm_grounded_pair grounded = a_grounded_pair();
    vm_periodic periodic = a_periodic();
    vm_forced forced = a_forced();
    vm_pair pair = a_pair();
    vm_steady_state steady[2];
    vm_osc_problem o;
    coupled.mass[1] = pair.mass = forced.mass = periodic.oscillator.mass = grounded.oscillator[1].mass = unmade;
    CHECK(vm_coupled_pair_to_modes(&coupled, 0, y, found) == VM_BAD_ARGUMENT);
    CHECK(vm_coupled_pair_from_modes(&coupled, 0, y, found) == VM_BAD_ARGUMENT);
    CHECK(vm_coupled_pair_oscillator(&coupled, y, &o) == VM_BAD_ARGUMENT);
    CHECK(vm_grounded_pair_to_averaged(&grounded, 0, y, found) == VM_BAD_ARGUMENT);
    CHECK(vm_grounded_pair_from_averaged(&grounded, 0, y, found) == VM_BAD_ARGUMENT);
    CHECK(vm_pair_at(&pair, VM_NAN, y, found) == VM_BAD_ARGUMENT && found[0] == 7);
    CHECK(vm_forced_curve(&forced, 0, VM_NAN, steady) == VM_BAD_ARGUMENT);
    CHECK(vm_periodic_curve(&periodic, 0, VM_NAN, steady) == VM_BAD_ARGUMENT);
}

/* Numbers of vibrations, methods and routes that do not exist; mass laws that are not linear */
static void test_unknown_numbers(void)
{
    const int vibrations[4][2] = {{1, 0}, {1, 99}, {99, 1}, {0, 1}};
    const vm_real y[4] = {R(0.1), R(0.2), 0, 0};
    vm_grounded_pair grounded = a_grounded_pair();
    vm_periodic periodic = a_periodic();
    vm_pair pair = a_pair();
    vm_vdp v = a_vdp();
    vm_vdp_plan plan;
    vm_vdp_cycle cycle;
    vm_real found[4];
    int k;
    for (k = 0; k < 4; k++) {
        grounded.vibrations[0] = vibrations[k][0];
        grounded.vibrations[1] = vibrations[k][1];
        CHECK(vm_grounded_pair_init(&grounded) == VM_BAD_ARGUMENT);
    }
    periodic.periods = 0;
    CHECK(vm_periodic_init(&periodic) == VM_BAD_ARGUMENT);
    CHECK(vm_pair_by_method(&pair, VM_PAIR_ATEB - 1, 1, y, found) == VM_BAD_ARGUMENT);
    CHECK(vm_pair_by_method(&pair, VM_PAIR_JACOBI + 1, 1, y, found) == VM_BAD_ARGUMENT);
    pair.mass = vm_law_power(2, R(0.1), 3);
    CHECK(vm_pair_at(&pair, 1, y, found) == VM_NO_LAW);
    v.method = VM_VDP_ATEB - 1;
    CHECK(vm_vdp_plan_init(&plan, &v, 1, 0) == VM_BAD_ARGUMENT && vm_vdp_cycle_of(&v, &cycle) == VM_BAD_ARGUMENT);
}

/* A pair without momentum, on whose relative motion no force of the mass centre acts; a vibration that negative damping
   feeds, which is not stable */
static void test_special_motions(void)
{
    const vm_real y[4] = {0, R(0.1), 0, 0};
    vm_coupled_pair pair = a_coupled_pair();
    vm_periodic p = a_periodic();
    vm_steady_state steady;
    vm_osc_problem o;
    int k;
    CHECK(vm_coupled_pair_oscillator(&pair, y, &o) == VM_OK && pair.momentum == 0 && !o.force);
    p.oscillator.damping = R(-0.1);
    p.oscillator.reactive = R(0.5);
    CHECK(vm_periodic_curve(&p, 0, R(0.7), &steady) == VM_OK && steady.trace > 0 && !steady.stable);
    p.oscillator.damping = 50; /* where the force would have a frequency below 0, there is no such vibration */
    for (k = -3; k <= 3; k++) {
        const int status = vm_periodic_curve(&p, 0, (vm_real)k, &steady);
        CHECK(status == VM_DOMAIN || (status == VM_OK && steady.nu > 0 && steady.A > 0));
    }
}

/* A Van der Pol oscillator at rest stays there; one whose amplitude underflows has no phase. */
static void test_van_der_pol_at_rest(void)
{
    static vm_vdp_plan plan;
    vm_vdp v = a_vdp();
    vm_osc_motion motion = {7, 7, 7, 7, 7, 7};
    CHECK(vm_vdp_plan_init(&plan, &v, 0, 0) == VM_OK);
    CHECK(vm_vdp_plan_by_route(&plan, VM_ROUTE_ORDER2, 1, 0, &motion) == VM_OK && motion.x == 0 && motion.v == 0);
}

/* Samples and positions that are infinite */
static void infinite_velocity(vm_real t, vm_real *x, vm_real *v, void *ctx)
{
    (void)ctx;
    *x = t - 1;
    *v = VM_INFINITY;
}

static vm_real constant_law(vm_real t, void *ctx)
{
    (void)t;
    (void)ctx;
    return 1;
}

static void test_infinite_samples(void)
{
    const vm_sample samples[2] = {{0, 1, 1}, {1, VM_INFINITY, VM_INFINITY}};
    vm_sample points[4];
    CHECK(vm_envelope_error(VM_TURNING_POINTS, 1, samples, constant_law, NULL) == 0);
    CHECK(isnan(vm_envelope_error(VM_TURNING_POINTS, 2, samples, constant_law, NULL)));
    CHECK(isnan(vm_envelope_error(VM_ZERO_CROSSINGS, 2, samples, constant_law, NULL)));
    CHECK(vm_find_samples(infinite_velocity, NULL, VM_ZERO_CROSSINGS, 0, 2, R(0.25), 4, points) == VM_NOT_FINITE);
}

int main(int argc, char **argv)
{
    read_refusal_rounds(argc, argv);
    test_slow_vibrations();
    test_rotors();
    test_pairs_and_forces();
    test_van_der_pol();
    test_pair();
    test_laval();
    test_stiffness_known_to_a_radius();
    test_forced();
    test_backbone();
    test_forced_split();
    test_nearly_linear();
    test_points_found();
    test_points_of_step();
    test_points_of_broken_step();
    test_impossible_shafts();
    test_rotor_at_rest();
    test_overflowing_motions();
    test_unmade_laws();
    test_unknown_numbers();
    test_special_motions();
    test_van_der_pol_at_rest();
    test_infinite_samples();
    return check_finish("refusals slow");
}
