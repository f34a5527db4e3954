/* faults_oscillators.h - the functions of oscillators, with laws, forces and motions of a user that fail */
#ifndef FAULTS_OSCILLATORS_H
#define FAULTS_OSCILLATORS_H

#include "faults.h"
#include "valid_objects.h"

/* ---- Functions of a user ---- */

/* The law 2 + t/100, as a mass in kg or another number */
static inline int faulty_law(vm_real t, vm_real *f, vm_real *rate, void *ctx)
{
    const int strikes = fault_strikes();
    (void)ctx;
    *f = fault_value(strikes, 2 + R(0.01) * t);
    *rate = fault_value(strikes, R(0.01));
    return fault_status(strikes);
}
static inline vm_law a_faulty_law(void) { return vm_law_user(faulty_law, NULL); }

/* A further force on an oscillator, N */
static inline vm_real faulty_force(vm_real t, vm_real x, vm_real v, void *ctx)
{
    (void)ctx;
    return fault_value(fault_strikes_nan(), R(0.05) * (x * t - v));
}

/* An odd elastic force F(x) = x + x^3 */
static inline int faulty_elastic(vm_real x, vm_real *f, void *ctx)
{
    const int strikes = fault_strikes();
    (void)ctx;
    *f = fault_value(strikes, x + x * x * x);
    return fault_status(strikes);
}

/* The stiffness K(rho) = 2 + rho^2 of a shaft */
static inline vm_real faulty_shaft(vm_real rho, vm_real *slope, void *ctx)
{
    const int strikes = fault_strikes_nan();
    (void)ctx;
    *slope = fault_value(strikes, 2 * rho);
    return fault_value(strikes, 2 + rho * rho);
}

static inline vm_complex faulty_pull(vm_real t, vm_complex z, vm_complex v, void *ctx)
{
    const int strikes = fault_strikes_nan();
    vm_complex force;
    (void)t;
    (void)v;
    (void)ctx;
    force.re = fault_value(strikes, -R(0.01) * z.re);
    force.im = fault_value(strikes, R(0.02));
    return force;
}

static inline int faulty_pair_force(vm_real t, const vm_real *y, vm_real *force, void *ctx)
{
    const int strikes = fault_strikes();
    (void)t;
    (void)ctx;
    force[0] += fault_value(strikes, -y[0]);
    force[1] += fault_value(strikes, -2 * y[1]);
    return fault_status(strikes);
}

static inline void faulty_motion(vm_real t, vm_real *x, vm_real *v, void *ctx)
{
    const int strikes = fault_strikes_nan();
    (void)ctx;
    *x = fault_value(strikes, (vm_real)cos((double)t));
    *v = fault_value(strikes, (vm_real)-sin((double)t));
}

static inline vm_real faulty_envelope(vm_real t, void *ctx)
{
    (void)ctx;
    return fault_value(fault_strikes_nan(), 1 + R(0.01) * t);
}

/* A function of numbers returns NaN where it fails; here this is the status VM_NOT_FINITE. */
static inline int fault_number_status(vm_real number, vm_real *result)
{
    *result = number;
    return number == number ? (int)VM_OK : (int)VM_NOT_FINITE;
}

/* ---- Laws ---- */

static inline int call_law_at(vm_real *result)
{
    const vm_law law = a_faulty_law();
    vm_real rate;
    return vm_law_at(&law, 3, result, &rate);
}

static inline int call_inverse_integral(vm_real *result)
{
    const vm_law law = a_faulty_law();
    return vm_law_inverse_integral(&law, 3, result);
}

static inline int call_ratio_integral(vm_real *result)
{
    const vm_law f = a_faulty_law(), g = a_faulty_law();
    return vm_law_ratio_integral(&f, &g, 3, result);
}

/* ---- Oscillators ---- */

/* A cubic oscillator whose mass and stiffness are laws that fail */
static inline vm_osc_problem a_faulty_problem(void)
{
    vm_osc_problem o;
    memset(&o, 0, sizeof o);
    o.alpha = 3;
    o.mass = a_faulty_law();
    o.stiffness = vm_law_linear(3, R(0.01));
    o.damping = R(0.01);
    o.reactive = 1;
    o.x = 1;
    o.v = R(0.25);
    return o;
}

/* The same with laws that do not fail and a further force that does */
static inline vm_osc_problem a_faulty_force(void)
{
    vm_osc_problem o = a_faulty_problem();
    o.mass = vm_law_linear(2, R(0.01));
    o.force = faulty_force;
    return o;
}

static inline vm_osc_motion untouched_motion(void)
{
    const vm_osc_motion m = {FAULT_UNTOUCHED, FAULT_UNTOUCHED, 0, 0, 0, 0};
    return m;
}

/* The position of the motion, or NaN where only one of its numbers was written */
static inline vm_real fault_position(const vm_osc_motion *m)
{
    if (m->x == FAULT_UNTOUCHED || m->v == FAULT_UNTOUCHED) return m->x == m->v ? FAULT_UNTOUCHED : 0;
    return m->x + 3 * m->v;
}

static int fault_route; /* route of the calls below */

static inline int call_by_route(vm_real *result)
{
    const vm_osc_problem o = a_faulty_problem();
    vm_osc_motion m = untouched_motion();
    const int status = vm_osc_by_route(&o, fault_route, 5, R(1e-3), &m);
    *result = fault_position(&m);
    return status;
}

static inline int call_force_by_route(vm_real *result)
{
    const vm_osc_problem o = a_faulty_force();
    vm_osc_motion m = untouched_motion();
    const int status = vm_osc_by_route(&o, fault_route, 5, R(1e-3), &m);
    *result = fault_position(&m);
    return status;
}

static inline int call_within(vm_real *result)
{
    const vm_osc_problem o = a_faulty_problem();
    vm_osc_motion m = untouched_motion();
    const int status = vm_osc_within(&o, 5, R(1e-4), &m);
    *result = fault_position(&m);
    return status;
}

static inline int call_force_within(vm_real *result)
{
    const vm_osc_problem o = a_faulty_force();
    vm_osc_motion m = untouched_motion();
    const int status = vm_osc_within(&o, 5, R(1e-3), &m);
    *result = fault_position(&m);
    return status;
}

/* A plan is made first; an error of vm_osc_plan_init leaves it untouched. */
static inline int call_plan(vm_real *result)
{
    const vm_osc_problem o = a_faulty_problem();
    vm_osc_motion m = untouched_motion();
    vm_osc_plan plan;
    int status;
    memset(&plan, 0, sizeof plan);
    status = vm_osc_plan_init(&plan, &o);
    if (status) return plan.A == 0 ? status : 1;
    status = vm_osc_plan_within(&plan, 5, R(1e-4), &m);
    *result = fault_position(&m);
    return status;
}

static inline int call_averaged(vm_real *result)
{
    const vm_osc_problem o = a_faulty_force();
    vm_real rates[3] = {FAULT_UNTOUCHED, FAULT_UNTOUCHED, FAULT_UNTOUCHED};
    vm_osc_plan plan;
    int status = vm_osc_plan_init(&plan, &o);
    if (!status) status = vm_osc_averaged(&plan, VM_ROUTE_ATEB, 1, 1, rates, rates + 1, rates + 2);
    *result = status ? rates[0] : fault_sum(3, rates);
    return status;
}

/* A damping and a velocity of the mass that are laws, by integration */
static inline int call_load(vm_real *result)
{
    const vm_law u = a_faulty_law();
    vm_osc_problem o = a_faulty_problem();
    vm_osc_motion m = untouched_motion();
    vm_osc_load load;
    int status;
    o.mass = vm_law_linear(2, R(0.01));
    status = vm_osc_load_init(&load, &o, &u, NULL);
    if (!status) status = vm_osc_by_route(&o, VM_ROUTE_RK87, 3, R(1e-3), &m);
    *result = fault_position(&m);
    return status;
}

static inline int call_load_force(vm_real *result)
{
    const vm_law law = a_faulty_law();
    vm_osc_problem o = a_faulty_problem();
    vm_osc_load load;
    const int status = vm_osc_load_init(&load, &o, &law, &law);
    return status ? (int)VM_NOT_FINITE : fault_number_status(vm_osc_load_force(1, 1, 1, &load), result);
}

static inline int call_adiabaticity(vm_real *result)
{
    const vm_osc_problem o = a_faulty_problem();
    return fault_number_status(vm_adiabaticity(&o, 3, 1), result);
}

/* ---- Odd forces ---- */

static inline int call_odd_period(vm_real *result)
{
    const vm_odd_force force = vm_odd_force_user(faulty_elastic, NULL);
    return fault_number_status(vm_odd_period(&force, 1), result);
}

static inline int call_odd_action(vm_real *result)
{
    const vm_odd_force force = vm_odd_force_user(faulty_elastic, NULL);
    return fault_number_status(vm_odd_action(&force, 1), result);
}

static inline int call_odd_exact(vm_real *result)
{
    const vm_odd_force force = vm_odd_force_user(faulty_elastic, NULL);
    vm_real v;
    return vm_odd_exact_from(&force, 2, 1, R(0.5), result, &v);
}

/* A force of a user, constant laws */
static inline vm_odd_problem a_faulty_odd_force(void)
{
    vm_odd_problem o;
    memset(&o, 0, sizeof o);
    o.force = vm_odd_force_user(faulty_elastic, NULL);
    o.mass = vm_law_linear(2, R(0.01));
    o.stiffness = vm_law_linear(1, 0);
    o.damping = vm_law_linear(R(0.01), 0);
    o.reactive = 1;
    o.x = 1;
    return o;
}

/* Duffing's force, with laws of its own, all laws of a user */
static inline vm_odd_problem a_faulty_duffing(void)
{
    static vm_law laws[2];
    vm_odd_problem o = a_faulty_odd_force();
    laws[0] = a_faulty_law();
    laws[1] = vm_law_linear(1, R(0.01));
    o.force = vm_duffing_force_of_laws(laws);
    o.mass = a_faulty_law();
    return o;
}

static inline int call_odd(const vm_odd_problem *o, vm_real tolerance, vm_real *result)
{
    vm_odd_motion m;
    int status;
    m.x = FAULT_UNTOUCHED;
    m.v = 0;
    status = vm_odd_within(o, R(0.5), tolerance, &m);
    *result = m.x;
    return status;
}
static inline int call_odd_within(vm_real *result)
{
    const vm_odd_problem o = a_faulty_odd_force();
    return call_odd(&o, 1, result);
}
static inline int call_odd_integrated(vm_real *result)
{
    const vm_odd_problem o = a_faulty_odd_force();
    return call_odd(&o, R(1e-2), result);
}
static inline int call_duffing_within(vm_real *result)
{
    const vm_odd_problem o = a_faulty_duffing();
    return call_odd(&o, 1, result);
}
static inline int call_duffing_integrated(vm_real *result)
{
    const vm_odd_problem o = a_faulty_duffing();
    return call_odd(&o, R(1e-2), result);
}

static inline int call_odd_rhs(vm_real *result)
{
    const vm_real y[2] = {1, R(0.5)};
    vm_odd_problem o = a_faulty_duffing();
    vm_real dydt[2];
    const int status = vm_odd_rhs(1, y, dydt, &o);
    if (!status) *result = fault_sum(2, dydt);
    return status;
}

/* ---- Van der Pol ---- */

static inline vm_vdp a_faulty_vdp(void)
{
    vm_vdp v = a_vdp();
    vm_vdp_init(&v);
    v.mass = a_faulty_law();
    return v;
}

static inline int call_vdp(int integrate, vm_real *result)
{
    const vm_vdp v = a_faulty_vdp();
    vm_osc_motion m = untouched_motion();
    vm_vdp_plan plan;
    int status = vm_vdp_plan_init(&plan, &v, 1, 0);
    if (!status && integrate) status = vm_vdp_plan_by_route(&plan, VM_ROUTE_RK87, 3, R(1e-3), &m);
    else if (!status) status = vm_vdp_plan_by_route(&plan, VM_ROUTE_ORDER2, R(0.5), R(1e-3), &m);
    *result = fault_position(&m);
    return status;
}
static inline int call_vdp_law(vm_real *result) { return call_vdp(0, result); }
static inline int call_vdp_rk87(vm_real *result) { return call_vdp(1, result); }

static inline int call_vdp_within(vm_real *result)
{
    const vm_vdp v = a_faulty_vdp();
    vm_osc_motion m = untouched_motion();
    const int status = vm_vdp_within(&v, 1, 0, 3, R(1e-5), &m);
    *result = fault_position(&m);
    return status;
}

/* A right-hand side with an object whose functions fail; the object is y's last argument. */
static inline int call_rhs(ode_rhs f, int n, void *object, vm_real *result)
{
    const vm_real y[5] = {1, R(0.5), R(0.25), R(0.75), R(0.125)};
    vm_real dydt[5];
    const int status = f(1, y, dydt, object);
    if (!status) *result = fault_sum(n, dydt);
    return status;
}
static inline int call_vdp_rhs(vm_real *result)
{
    vm_vdp v = a_faulty_vdp();
    return call_rhs(vm_vdp_rhs, 2, &v, result);
}
static inline int call_vdp_averaged_rhs(vm_real *result)
{
    vm_vdp v = a_faulty_vdp();
    return call_rhs(vm_vdp_averaged_rhs, 2, &v, result);
}

/* ---- Laval's rotor ---- */

static inline vm_jeffcott a_faulty_rotor(void)
{
    vm_jeffcott r = a_laval();
    r.mass = a_faulty_law();
    r.stiffness = faulty_shaft;
    r.force = faulty_pull;
    r.nodes = 4;
    return r;
}

/* The same without a force, which closed forms do not allow */
static inline vm_jeffcott a_faulty_free_rotor(void)
{
    vm_jeffcott r = a_faulty_rotor();
    r.force = NULL;
    return r;
}

/* A rotor on a linear shaft, of which only the mass fails */
static inline vm_jeffcott a_faulty_linear_rotor(void)
{
    static vm_power_force linear = {3, 1};
    vm_jeffcott r = a_laval();
    r.mass = a_faulty_law();
    r.stiffness_ctx = &linear;
    return r;
}

static inline int call_rotor_rhs(vm_real *result)
{
    vm_jeffcott r = a_faulty_rotor();
    return call_rhs(vm_jeffcott_rhs, 4, &r, result);
}
static inline int call_rotor_exact_rhs(vm_real *result)
{
    vm_jeffcott r = a_faulty_rotor();
    return call_rhs(vm_jeffcott_exact_rhs, 5, &r, result);
}
static inline int call_rotor_averaged_rhs(vm_real *result)
{
    vm_jeffcott r = a_faulty_rotor();
    return call_rhs(vm_jeffcott_averaged_rhs, 5, &r, result);
}
static inline int call_rotor_whirl_rhs(vm_real *result)
{
    vm_jeffcott r = a_faulty_free_rotor();
    return call_rhs(vm_jeffcott_forward_whirl_rhs, 2, &r, result);
}

static inline int call_rotor_to_averaged(vm_real *result)
{
    const vm_jeffcott r = a_faulty_rotor();
    const vm_real motion[4] = {1, R(0.5), R(0.25), R(0.75)};
    vm_real y[5] = {FAULT_UNTOUCHED, 0, 0, 0, 0};
    const int status = vm_jeffcott_to_averaged(&r, 1, motion, R(0.5), y);
    *result = status ? y[0] : fault_sum(5, y);
    return status;
}

static inline int call_rotor_from_averaged(vm_real *result)
{
    const vm_jeffcott r = a_faulty_rotor();
    const vm_real y[5] = {1, R(0.5), R(0.25), R(0.75), R(0.125)};
    vm_real motion[4] = {FAULT_UNTOUCHED, 0, 0, 0};
    const int status = vm_jeffcott_from_averaged(&r, 1, y, motion);
    *result = status ? motion[0] : fault_sum(4, motion);
    return status;
}

static inline int call_rotor_frequency(vm_real *result)
{
    const vm_jeffcott r = a_faulty_free_rotor();
    return fault_number_status(vm_jeffcott_frequency(&r, 1, 2, 1), result);
}

static inline int call_rotor_amplitude(vm_real *result)
{
    const vm_jeffcott r = a_faulty_free_rotor();
    return fault_number_status(vm_jeffcott_amplitude(&r, 1, 2, 3), result);
}

static inline int call_rotor_whirl_amplitude(vm_real *result)
{
    vm_jeffcott r = a_faulty_free_rotor();
    r.gyro = R(0.125);
    r.reactive = R(0.5);
    return fault_number_status(vm_jeffcott_whirl_amplitude(&r, 1, 2, 3, 1), result);
}

static inline int call_rotor_whirl_at(vm_real *result)
{
    const vm_jeffcott r = a_faulty_free_rotor();
    vm_jeffcott_whirl whirl;
    const int status = vm_jeffcott_whirl_at(&r, 1, 0, 1, 2, &whirl);
    if (!status) *result = whirl.radius;
    return status;
}

static inline int call_rotor_linear_at(vm_real *result)
{
    const vm_jeffcott r = a_faulty_linear_rotor();
    const vm_real start[4] = {1, R(0.5), R(0.25), R(0.75)};
    vm_real motion[4] = {FAULT_UNTOUCHED, 0, 0, 0};
    const int status = vm_jeffcott_linear_at(&r, start, 2, motion);
    *result = status ? motion[0] : fault_sum(4, motion);
    return status;
}

/* ---- Two bodies ---- */

static const vm_real pair_start[4] = {0, 1, R(0.5), R(-0.25)};

static inline vm_pair a_faulty_pair(void)
{
    vm_pair p = a_pair();
    p.mass = a_faulty_law();
    return p;
}

static inline int call_pair_rhs(vm_real *result)
{
    vm_pair p = a_faulty_pair();
    return call_rhs(vm_pair_rhs, 4, &p, result);
}
static inline int call_pair_averaged_rhs(vm_real *result)
{
    vm_pair p = a_faulty_pair();
    return call_rhs(vm_pair_averaged_rhs, 4, &p, result);
}
static inline int call_pair_to_averaged(vm_real *result)
{
    const vm_pair p = a_faulty_pair();
    vm_real modes[4] = {FAULT_UNTOUCHED, 0, 0, 0};
    const int status = vm_pair_to_averaged(&p, 3, pair_start, modes);
    *result = status ? modes[0] : fault_sum(4, modes);
    return status;
}

static inline vm_coupled_pair a_faulty_coupled_pair(void)
{
    vm_coupled_pair p = a_coupled_pair();
    p.mass[0] = a_faulty_law();
    p.mass[1] = a_faulty_law();
    p.force = faulty_pair_force;
    return p;
}

static inline int call_coupled_rhs(vm_real *result)
{
    vm_coupled_pair p = a_faulty_coupled_pair();
    return call_rhs(vm_coupled_pair_rhs, 4, &p, result);
}

static inline int call_coupled_to_modes(vm_real *result)
{
    const vm_coupled_pair p = a_faulty_coupled_pair();
    vm_real modes[4] = {FAULT_UNTOUCHED, 0, 0, 0};
    const int status = vm_coupled_pair_to_modes(&p, 1, pair_start, modes);
    *result = status ? modes[0] : fault_sum(4, modes);
    return status;
}

static inline int call_coupled_from_modes(vm_real *result)
{
    const vm_coupled_pair p = a_faulty_coupled_pair();
    vm_real y[4] = {FAULT_UNTOUCHED, 0, 0, 0};
    const int status = vm_coupled_pair_from_modes(&p, 1, pair_start, y);
    *result = status ? y[0] : fault_sum(4, y);
    return status;
}

/* The oscillator of the relative motion, and its motion */
static inline int call_coupled_oscillator(vm_real *result)
{
    vm_coupled_pair p = a_faulty_coupled_pair();
    vm_osc_motion m = untouched_motion();
    vm_osc_problem o;
    int status;
    p.force = NULL;
    status = vm_coupled_pair_oscillator(&p, pair_start, &o);
    if (!status) status = vm_osc_by_route(&o, VM_ROUTE_RK87, 2, R(1e-3), &m);
    *result = fault_position(&m);
    return status;
}

/* ---- Excited oscillators ---- */

static inline vm_forced a_faulty_forced(void)
{
    vm_forced f = a_forced();
    f.mass = a_faulty_law();
    f.frequency = a_faulty_law();
    return f;
}

static inline int call_forced_init(vm_real *result)
{
    vm_forced f = a_faulty_forced();
    int status;
    f.pi = FAULT_UNTOUCHED;
    status = vm_forced_init(&f);
    *result = f.pi;
    return status;
}
static inline int call_forced_rhs(vm_real *result)
{
    vm_forced f = a_faulty_forced();
    return call_rhs(vm_forced_rhs, 3, &f, result);
}
static inline int call_forced_exact_rhs(vm_real *result)
{
    vm_forced f = a_faulty_forced();
    return call_rhs(vm_forced_exact_rhs, 3, &f, result);
}
static inline int call_forced_averaged_rhs(vm_real *result)
{
    vm_forced f = a_faulty_forced();
    return call_rhs(vm_forced_averaged_rhs, 3, &f, result);
}
static inline int call_forced_to_averaged(vm_real *result)
{
    const vm_forced f = a_faulty_forced();
    const vm_real motion[3] = {1, R(0.5), R(0.25)};
    vm_real y[3] = {FAULT_UNTOUCHED, 0, 0};
    const int status = vm_forced_to_averaged(&f, 1, motion, y);
    *result = status ? y[0] : fault_sum(3, y);
    return status;
}
static inline int call_forced_steady(vm_real *result)
{
    const vm_forced f = a_faulty_forced();
    vm_steady_state steady[3];
    const int found = vm_forced_steady_states(&f, 1, steady);
    if (found > 0) *result = steady[0].A;
    return found;
}
static inline int call_forced_peak(vm_real *result)
{
    const vm_forced f = a_faulty_forced();
    return fault_number_status(vm_forced_peak(&f, 1), result);
}
static inline int call_forced_passage(vm_real *result)
{
    const vm_forced f = a_faulty_forced();
    vm_passage passage;
    const int status = vm_forced_passage(&f, 1, 1, &passage);
    if (!status) *result = passage.A;
    return status;
}

/* ---- Diagnostics ---- */

static inline int call_find_samples(vm_real *result)
{
    vm_sample samples[4];
    const long found = vm_find_samples(faulty_motion, NULL, VM_ZERO_CROSSINGS, 0, 10, R(0.7), 4, samples);
    if (found < 0) return (int)found;
    *result = samples[0].t + samples[1].v + samples[2].t;
    return VM_OK;
}

static inline int call_envelope_error(vm_real *result)
{
    const vm_sample samples[3] = {{0, 1, 0}, {3, -1, 0}, {6, 1, 0}};
    return fault_number_status(vm_envelope_error(VM_TURNING_POINTS, 3, samples, faulty_envelope, NULL), result);
}

/* ---- Lagrange's equations ---- */

static inline vm_real faulty_energy(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, void *ctx)
{
    return fault_value(fault_strikes_nan(), kinetic(t, q, rates, masses, ctx));
}

static inline void faulty_masses(vm_real t, const vm_real *q, vm_real *masses, void *ctx)
{
    one_mass(t, q, masses, ctx);
    masses[0] = fault_value(fault_strikes_nan(), masses[0]);
}

static inline int faulty_forces(vm_real t, const vm_real *q, const vm_real *rates, const vm_real *masses, vm_real *Q,
                                void *ctx)
{
    const int strikes = fault_strikes();
    (void)t;
    (void)rates;
    (void)masses;
    (void)ctx;
    Q[0] += fault_value(strikes, -q[0]);
    Q[1] += fault_value(strikes, -q[1]);
    return fault_status(strikes);
}

static const vm_real faulty_q[2] = {1, R(0.5)}, faulty_rates[2] = {R(0.25), R(0.75)};

/* Only the energy and the masses fail, which have no status. */
static inline vm_lagrange_system a_faulty_energy(void)
{
    vm_lagrange_system l = system_of_two();
    l.energy = faulty_energy;
    l.masses = faulty_masses;
    return l;
}

static inline vm_lagrange_system a_faulty_system(void)
{
    vm_lagrange_system l = system_of_two();
    l.forces = faulty_forces;
    return l;
}

static inline int call_lagrange_rhs(vm_real *result)
{
    vm_lagrange_system l = a_faulty_energy();
    return call_rhs(vm_lagrange_rhs, 4, &l, result);
}
static inline int call_lagrange_forces_rhs(vm_real *result)
{
    vm_lagrange_system l = a_faulty_system();
    return call_rhs(vm_lagrange_rhs, 4, &l, result);
}
static inline int call_lagrange_start(vm_real *result)
{
    vm_lagrange_system l = a_faulty_energy();
    vm_real y[4] = {FAULT_UNTOUCHED, 0, 0, 0};
    const int status = vm_lagrange_start(&l, 0, faulty_q, faulty_rates, y);
    *result = status ? y[0] : fault_sum(4, y);
    return status;
}
static inline int call_lagrange_rates(vm_real *result)
{
    vm_lagrange_system l = a_faulty_energy();
    const vm_real y[4] = {1, R(0.5), R(0.25), R(0.75)};
    vm_real rates[2] = {FAULT_UNTOUCHED, 0};
    const int status = vm_lagrange_rates(&l, 0, y, rates);
    *result = status ? rates[0] : fault_sum(2, rates);
    return status;
}
static inline int call_lagrange_partial(vm_real *result)
{
    vm_lagrange_system l = a_faulty_energy();
    return fault_number_status(vm_lagrange_partial_q(&l, 0, faulty_q, faulty_rates, 0), result);
}
static inline int call_lagrange_needed(vm_real *result)
{
    vm_lagrange_system l = a_faulty_energy();
    vm_real Q[2] = {FAULT_UNTOUCHED, 0};
    const int status = vm_lagrange_needed_forces(&l, 0, 1, faulty_q, faulty_rates, faulty_rates, Q);
    *result = status ? Q[0] : fault_sum(2, Q);
    return status;
}
static inline int call_lagrange_drive(vm_real *result)
{
    vm_lagrange_system l = a_faulty_system();
    vm_real Q[2] = {FAULT_UNTOUCHED, 0};
    const int status = vm_lagrange_drive_forces(&l, 0, 1, faulty_q, faulty_rates, faulty_rates, Q);
    *result = status ? Q[0] : fault_sum(2, Q);
    return status;
}

#endif
