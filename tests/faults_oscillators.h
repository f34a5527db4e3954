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

/* ---- What must hold after a fault ---- */

/* A user's function of a law may be defined only close to t. A call that fails may therefore only make steps shorter:
   the results then differ within the tolerances of the calls. */
#define FAULT_TOLERANCE (5e-3 / (double)VM_EPSILON)

/* A function that calls laws at many times. It returns the status of the law that fails, or VM_NOT_INTEGRATED, or steps
   over the fault. */
static const fault_promise shorter_steps = {
    FAULT_ALL, VM_DOMAIN, VM_NOT_FINITE, FAULT_TOLERANCE, VM_NOT_INTEGRATED, 0};
/* Such a function that takes a fifth of a second. Only one kind of fault is tried, the error with a NaN. */
static const fault_promise shorter_steps_of_a_long_call = {
    FAULT_BOTH, VM_DOMAIN, VM_NOT_FINITE, FAULT_TOLERANCE, VM_NOT_INTEGRATED, 0};
/* Such a function where the user's functions have no status, so that they can only return NaN */
static const fault_promise shorter_steps_over_nan = {
    FAULT_NAN, 0, VM_NOT_FINITE, FAULT_TOLERANCE, VM_NOT_INTEGRATED, 0};

/* A function that calls each law once, or a few times: an error at any of these calls is its status. */
static const fault_promise error_of_law = {FAULT_ALL, VM_DOMAIN, VM_NOT_FINITE, 0, 0, 0};
/* A function that calls another function of a user, and returns the number that this one has returned */
static const fault_promise error_of_user = {FAULT_ALL, FAULT_NUMBER, VM_NOT_FINITE, 0, 0, 0};
/* A function of numbers, whose NaN stands for an error */
static const fault_promise nan_for_error = {FAULT_ALL, VM_NOT_FINITE, VM_NOT_FINITE, 0, 0, 0};

/* A right-hand side, whose derivatives may be NaN where a law or another function of a user returns NaN */
static const fault_promise rhs_error_of_law = {FAULT_ALL, VM_DOMAIN, VM_NOT_FINITE, 0, VM_DOMAIN, 1};
static const fault_promise rhs_error_of_user = {FAULT_ALL, FAULT_NUMBER, VM_NOT_FINITE, 0, VM_DOMAIN, 1};
static const fault_promise rhs_nan = {FAULT_NAN, 0, VM_NOT_FINITE, 0, 0, 1};

/* The stiffness and the force of a rotor have no status, so that both kinds of faults at once are those of a NaN. */
static const fault_promise rotor_rhs_error = {FAULT_STATUS + FAULT_NAN, VM_DOMAIN, VM_NOT_FINITE, 0, 0, 1};
static const fault_promise rotor_error = {FAULT_STATUS + FAULT_NAN, VM_DOMAIN, VM_NOT_FINITE, 0, VM_BAD_STIFFNESS, 0};
/* The kinetic energy has no status either. */
static const fault_promise energy_error = {FAULT_STATUS + FAULT_NAN, FAULT_NUMBER, VM_NOT_FINITE, 0, 0, 1};
/* The reduced mass of two bodies is a law of its own, which fails where one of theirs does. */
static const fault_promise shorter_steps_of_reduced_mass = {
    FAULT_ALL, VM_DOMAIN, VM_NOT_FINITE, FAULT_TOLERANCE, VM_DOMAIN, 0};

/* Rows of the tables: the function that is tried, the number of its outputs, the object, whose name says which of its
   functions fail, and what must hold then. FAULT_RHS tries a right-hand side. FAULT_CALL tries one of the functions
   call_... below, each of which calls a function of the library. */
#define FAULT_RHS(rhs, outputs, object, promise) {#rhs ", " #object, object, rhs, NULL, outputs, &promise}
#define FAULT_CALL(call, outputs, object, promise) {#call ", " #object, object, NULL, call, outputs, &promise}

/* A function of numbers returns NaN where it fails; here this is the status VM_NOT_FINITE. */
static inline int fault_number(vm_real number, vm_real *out)
{
    if (number != number) return VM_NOT_FINITE;
    *out = number;
    return VM_OK;
}

/* ---- Laws ---- */

static inline void one_law(fault_object *o) { o->law = a_faulty_law(); }

static inline int call_law_at(fault_object *o, vm_real *out) { return vm_law_at(&o->law, 3, out, out + 1); }
static inline int call_inverse_integral(fault_object *o, vm_real *out)
{
    return vm_law_inverse_integral(&o->law, 3, out);
}
static inline int call_ratio_integral(fault_object *o, vm_real *out)
{
    return vm_law_ratio_integral(&o->law, &o->law, 3, out);
}

/* ---- Oscillators ---- */

/* A cubic oscillator whose mass fails */
static inline void problem_mass(fault_object *o)
{
    vm_osc_problem *p = &o->problem;
    p->alpha = 3;
    p->mass = a_faulty_law();
    p->stiffness = vm_law_linear(3, R(0.01));
    p->damping = R(0.01);
    p->reactive = 1;
    p->x = 1;
    p->v = R(0.25);
}

/* The same oscillator with laws that do not fail and a further force that does */
static inline void problem_force(fault_object *o)
{
    problem_mass(o);
    o->problem.mass = vm_law_linear(2, R(0.01));
    o->problem.force = faulty_force;
}

/* The same oscillator, in which nothing fails */
static inline void problem_sound(fault_object *o)
{
    problem_mass(o);
    o->problem.mass = vm_law_linear(2, R(0.01));
}

static inline vm_osc_motion untouched_motion(void)
{
    const vm_osc_motion m = {FAULT_UNTOUCHED, FAULT_UNTOUCHED, 0, 0, 0, 0};
    return m;
}

/* The two outputs of a call that returns a motion */
static inline int fault_motion(int status, const vm_osc_motion *m, vm_real *out)
{
    out[0] = m->x;
    out[1] = m->v;
    return status;
}

static int fault_route; /* route of the next function */

static inline int call_by_route(fault_object *o, vm_real *out)
{
    vm_osc_motion m = untouched_motion();
    const int status = vm_osc_by_route(&o->problem, fault_route, 5, R(1e-3), &m);
    return fault_motion(status, &m, out);
}

static inline int fault_within(const fault_object *o, vm_real t, vm_real tolerance, vm_real *out)
{
    vm_osc_motion m = untouched_motion();
    const int status = vm_osc_within(&o->problem, t, tolerance, &m);
    return fault_motion(status, &m, out);
}
static inline int call_within(fault_object *o, vm_real *out) { return fault_within(o, 5, R(1e-4), out); }
static inline int call_within_coarse(fault_object *o, vm_real *out) { return fault_within(o, 5, R(1e-3), out); }

/* A plan is made first; an error of vm_osc_plan_init leaves it untouched. */
static inline int call_plan(fault_object *o, vm_real *out)
{
    vm_osc_motion m = untouched_motion();
    vm_osc_plan plan;
    int status;
    memset(&plan, 0, sizeof plan);
    status = vm_osc_plan_init(&plan, &o->problem);
    if (status && plan.A != 0) out[0] = plan.A;
    if (status) return status;
    status = vm_osc_plan_within(&plan, 5, R(1e-4), &m);
    return fault_motion(status, &m, out);
}

static inline int fault_averaged(const fault_object *o, int route, vm_real *out)
{
    vm_osc_plan plan;
    const int status = vm_osc_plan_init(&plan, &o->problem);
    return status ? status : vm_osc_averaged(&plan, route, 1, 1, out, out + 1, out + 2);
}
static inline int call_averaged_ateb(fault_object *o, vm_real *out) { return fault_averaged(o, VM_ROUTE_ATEB, out); }

/* The motion with a load, whose damping, or the velocity of its mass, is a law that fails */
static inline int fault_load(const fault_object *o, const vm_law *u, const vm_law *damping, int route, vm_real t,
                             vm_real *out)
{
    vm_osc_problem p = o->problem;
    vm_osc_motion m = untouched_motion();
    vm_osc_load load;
    int status = vm_osc_load_init(&load, &p, u, damping);
    if (!status) status = vm_osc_by_route(&p, route, t, R(1e-3), &m);
    return fault_motion(status, &m, out);
}
static inline int call_load_velocity(fault_object *o, vm_real *out)
{
    const vm_law u = a_faulty_law();
    return fault_load(o, &u, NULL, VM_ROUTE_RK87, 3, out);
}

/* The force of a load; an error of vm_osc_load_init stands for a force of NaN. */
static inline int call_load_force(fault_object *o, vm_real *out)
{
    const vm_law law = a_faulty_law();
    vm_osc_problem p = o->problem;
    vm_osc_load load;
    const int status = vm_osc_load_init(&load, &p, &law, &law);
    return fault_number(status ? VM_NAN : vm_osc_load_force(1, 1, 1, &load), out);
}

static inline int call_adiabaticity(fault_object *o, vm_real *out)
{
    return fault_number(vm_adiabaticity(&o->problem, 3, 1), out);
}

/* ---- Odd forces ---- */

static inline void odd_force(fault_object *o) { o->odd_force = vm_odd_force_user(faulty_elastic, NULL); }

static inline int call_odd_period(fault_object *o, vm_real *out)
{
    return fault_number(vm_odd_period(&o->odd_force, 1), out);
}
static inline int call_odd_action(fault_object *o, vm_real *out)
{
    return fault_number(vm_odd_action(&o->odd_force, 1), out);
}
static inline int call_odd_exact(fault_object *o, vm_real *out)
{
    return vm_odd_exact_from(&o->odd_force, 2, 1, R(0.5), out, out + 1);
}

/* An oscillator whose force fails, and whose laws do not */
static inline void odd_problem_force(fault_object *o)
{
    vm_odd_problem *p = &o->odd;
    p->force = vm_odd_force_user(faulty_elastic, NULL);
    p->mass = vm_law_linear(2, R(0.01));
    p->stiffness = vm_law_linear(1, 0);
    p->damping = vm_law_linear(R(0.01), 0);
    p->reactive = 1;
    p->x = 1;
}

/* An oscillator with Duffing's force, of which the linear coefficient and the mass fail */
static inline void duffing_laws(fault_object *o)
{
    static vm_law laws[2];
    odd_problem_force(o);
    laws[0] = a_faulty_law();
    laws[1] = vm_law_linear(1, R(0.01));
    o->odd.force = vm_duffing_force_of_laws(laws);
    o->odd.mass = a_faulty_law();
}

/* The two outputs of a call that returns the motion of such an oscillator */
static inline int fault_odd_motion(int status, const vm_odd_motion *m, vm_real *out)
{
    out[0] = m->x;
    out[1] = m->v;
    return status;
}

static inline int fault_odd_within(const fault_object *o, vm_real tolerance, vm_real *out)
{
    vm_odd_motion m;
    int status;
    m.x = m.v = FAULT_UNTOUCHED;
    status = vm_odd_within(&o->odd, R(0.5), tolerance, &m);
    return fault_odd_motion(status, &m, out);
}
static inline int call_odd_within(fault_object *o, vm_real *out) { return fault_odd_within(o, 1, out); }
static inline int call_odd_integrated(fault_object *o, vm_real *out) { return fault_odd_within(o, R(1e-2), out); }

/* ---- Van der Pol ---- */

static inline void vdp_mass(fault_object *o)
{
    o->vdp = a_vdp();
    vm_vdp_init(&o->vdp);
    o->vdp.mass = a_faulty_law();
}

static inline int fault_vdp_by_route(const fault_object *o, int route, vm_real t, vm_real *out)
{
    vm_osc_motion m = untouched_motion();
    vm_vdp_plan plan;
    int status = vm_vdp_plan_init(&plan, &o->vdp, 1, 0);
    if (!status) status = vm_vdp_plan_by_route(&plan, route, t, R(1e-3), &m);
    return fault_motion(status, &m, out);
}
static inline int call_vdp_order2(fault_object *o, vm_real *out)
{
    return fault_vdp_by_route(o, VM_ROUTE_ORDER2, R(0.5), out);
}
static inline int call_vdp_rk87(fault_object *o, vm_real *out)
{
    return fault_vdp_by_route(o, VM_ROUTE_RK87, 3, out);
}

static inline int call_vdp_within(fault_object *o, vm_real *out)
{
    vm_osc_motion m = untouched_motion();
    const int status = vm_vdp_within(&o->vdp, 1, 0, 3, R(1e-5), &m);
    return fault_motion(status, &m, out);
}

/* ---- Laval's rotor ---- */

static inline void rotor_mass_shaft_and_force(fault_object *o)
{
    o->rotor = a_laval();
    o->rotor.mass = a_faulty_law();
    o->rotor.stiffness = faulty_shaft;
    o->rotor.force = faulty_pull;
    o->rotor.nodes = 4;
}

/* A rotor without a force, which closed forms do not allow */
static inline void rotor_mass_and_shaft(fault_object *o)
{
    rotor_mass_shaft_and_force(o);
    o->rotor.force = NULL;
}

/* A rotor on a linear shaft, of which only the mass fails */
static inline void rotor_mass(fault_object *o)
{
    static vm_power_force linear = {3, 1};
    o->rotor = a_laval();
    o->rotor.mass = a_faulty_law();
    o->rotor.stiffness_ctx = &linear;
}

/* A rotor on a linear shaft, whose stiffness is a function of a user */
static inline vm_real faulty_linear_shaft(vm_real rho, vm_real *slope, void *ctx)
{
    const vm_real stiffness = fault_value(fault_strikes_nan(), 2);
    (void)rho;
    (void)ctx;
    *slope = 0 * stiffness;
    return stiffness;
}
static inline void rotor_mass_and_linear_shaft(fault_object *o)
{
    rotor_mass(o);
    o->rotor.stiffness = faulty_linear_shaft;
}

static inline int call_rotor_to_averaged(fault_object *o, vm_real *out)
{
    return vm_jeffcott_to_averaged(&o->rotor, 1, fault_state, R(0.5), out);
}
static inline int call_rotor_from_averaged(fault_object *o, vm_real *out)
{
    return vm_jeffcott_from_averaged(&o->rotor, 1, fault_state, out);
}
static inline int call_rotor_linear_at(fault_object *o, vm_real *out)
{
    return vm_jeffcott_linear_at(&o->rotor, fault_state, 2, out);
}

/* Forward whirl has the sense 1, backward whirl -1. */
static inline int call_rotor_frequency(fault_object *o, vm_real *out)
{
    return fault_number(vm_jeffcott_frequency(&o->rotor, 1, 2, 1), out);
}
static inline int call_rotor_backward_frequency(fault_object *o, vm_real *out)
{
    return fault_number(vm_jeffcott_frequency(&o->rotor, 1, 2, -1), out);
}
static inline int fault_whirl_at(const fault_object *o, int sense, vm_real *out)
{
    vm_jeffcott_whirl whirl;
    int status;
    whirl.radius = FAULT_UNTOUCHED;
    status = vm_jeffcott_whirl_at(&o->rotor, 1, 0, sense, 2, &whirl);
    out[0] = whirl.radius;
    return status;
}
static inline int call_rotor_whirl_at(fault_object *o, vm_real *out) { return fault_whirl_at(o, 1, out); }
static inline int call_rotor_backward_whirl_at(fault_object *o, vm_real *out) { return fault_whirl_at(o, -1, out); }

static inline int call_rotor_amplitude(fault_object *o, vm_real *out)
{
    return fault_number(vm_jeffcott_amplitude(&o->rotor, 1, 2, 3), out);
}
static inline int call_rotor_whirl_amplitude(fault_object *o, vm_real *out)
{
    vm_jeffcott r = o->rotor;
    r.gyro = R(0.125);
    r.reactive = R(0.5);
    return fault_number(vm_jeffcott_whirl_amplitude(&r, 1, 2, 3, 1), out);
}

/* ---- Two bodies ---- */

static const vm_real pair_start[4] = {0, 1, R(0.5), R(-0.25)};

static inline void pair_mass(fault_object *o)
{
    o->pair = a_pair();
    o->pair.mass = a_faulty_law();
}

static inline int call_pair_to_averaged(fault_object *o, vm_real *out)
{
    return vm_pair_to_averaged(&o->pair, 3, pair_start, out);
}

static inline void coupled_masses(fault_object *o)
{
    o->coupled = a_coupled_pair();
    o->coupled.mass[0] = a_faulty_law();
    o->coupled.mass[1] = a_faulty_law();
}
static inline void coupled_masses_and_force(fault_object *o)
{
    coupled_masses(o);
    o->coupled.force = faulty_pair_force;
}

static inline int call_coupled_to_modes(fault_object *o, vm_real *out)
{
    return vm_coupled_pair_to_modes(&o->coupled, 1, pair_start, out);
}
static inline int call_coupled_from_modes(fault_object *o, vm_real *out)
{
    return vm_coupled_pair_from_modes(&o->coupled, 1, pair_start, out);
}

/* The oscillator of the relative motion, and its motion. vm_coupled_pair_oscillator writes the momentum to its pair. */
static inline int call_coupled_oscillator(fault_object *o, vm_real *out)
{
    vm_coupled_pair pair = o->coupled;
    vm_osc_motion m = untouched_motion();
    vm_osc_problem p;
    int status = vm_coupled_pair_oscillator(&pair, pair_start, &p);
    if (!status) status = vm_osc_by_route(&p, VM_ROUTE_RK87, 2, R(1e-3), &m);
    return fault_motion(status, &m, out);
}

/* ---- Excited oscillators ---- */

static inline void forced_mass_and_frequency(fault_object *o)
{
    o->forced = a_forced();
    o->forced.mass = a_faulty_law();
    o->forced.frequency = a_faulty_law();
}

static inline int call_forced_init(fault_object *o, vm_real *out)
{
    const int status = vm_forced_init(&o->forced);
    if (!status) out[0] = o->forced.pi + o->forced.Om1;
    return status;
}
static inline int call_forced_to_averaged(fault_object *o, vm_real *out)
{
    return vm_forced_to_averaged(&o->forced, 1, fault_state, out);
}
static inline int call_forced_peak(fault_object *o, vm_real *out)
{
    return fault_number(vm_forced_peak(&o->forced, 1), out);
}
static inline int call_forced_passage(fault_object *o, vm_real *out)
{
    vm_passage passage;
    int status;
    passage.A = FAULT_UNTOUCHED;
    status = vm_forced_passage(&o->forced, 1, 1, &passage);
    out[0] = passage.A;
    return status;
}

/* The two outputs of a search for steady states, of which `found` are in the list: those of the first state, which was
   zero before the search. An error must leave the list as it was. */
static inline int fault_steady(int found, const vm_steady_state *steady, vm_real *out)
{
    vm_steady_state zero;
    memset(&zero, 0, sizeof zero);
    if (found >= 0 || memcmp(steady, &zero, sizeof zero) != 0) {
        out[0] = steady[0].A;
        out[1] = steady[0].nu;
    }
    return found < 0 ? found : VM_OK;
}
static inline int call_forced_steady_states(fault_object *o, vm_real *out)
{
    vm_steady_state steady[3];
    memset(steady, 0, sizeof steady);
    return fault_steady(vm_forced_steady_states(&o->forced, 1, steady), steady, out);
}

/* ---- Diagnostics, whose functions get no object ---- */

static inline void motion_or_envelope(fault_object *o) { (void)o; }

static inline int fault_find(int kind, vm_real *out)
{
    vm_sample samples[4];
    const long found = vm_find_samples(faulty_motion, NULL, kind, 0, 10, R(0.7), 4, samples);
    if (found < 0) return (int)found;
    out[0] = samples[0].t + samples[1].x + samples[1].v + samples[2].t;
    return VM_OK;
}
static inline int call_find_samples(fault_object *o, vm_real *out)
{
    (void)o;
    return fault_find(VM_ZERO_CROSSINGS, out);
}
static inline int call_find_turning_points(fault_object *o, vm_real *out)
{
    (void)o;
    return fault_find(VM_TURNING_POINTS, out);
}

static inline int call_envelope_error(fault_object *o, vm_real *out)
{
    const vm_sample samples[3] = {{0, 1, 0}, {3, -1, 0}, {6, 1, 0}};
    (void)o;
    return fault_number(vm_envelope_error(VM_TURNING_POINTS, 3, samples, faulty_envelope, NULL), out);
}
static inline int call_envelope_of_crossings(fault_object *o, vm_real *out)
{
    const vm_sample samples[3] = {{0, 0, 1}, {3, 0, -1}, {6, 0, 1}};
    (void)o;
    return fault_number(vm_envelope_error(VM_ZERO_CROSSINGS, 3, samples, faulty_envelope, NULL), out);
}

/* ---- Lagrange's equations ---- */

static const vm_real faulty_q[2] = {1, R(0.5)}, faulty_rates[2] = {R(0.25), R(0.75)};

/* Only the energy and the masses fail, which have no status. */
static inline void energy_and_masses(fault_object *o)
{
    o->lagrange = system_of_two();
    o->lagrange.energy = faulty_energy;
    o->lagrange.masses = faulty_masses;
}
static inline void generalized_forces(fault_object *o)
{
    o->lagrange = system_of_two();
    o->lagrange.forces = faulty_forces;
}

/* The right-hand side may write derivatives where the forces fail. They are outputs only where it succeeds. */
static inline int call_lagrange_rhs(fault_object *o, vm_real *out)
{
    vm_real dydt[4];
    const int status = vm_lagrange_rhs(1, fault_state, dydt, &o->lagrange);
    if (!status) memcpy(out, dydt, sizeof dydt);
    return status;
}
static inline int call_lagrange_start(fault_object *o, vm_real *out)
{
    return vm_lagrange_start(&o->lagrange, 0, faulty_q, faulty_rates, out);
}
static inline int call_lagrange_rates(fault_object *o, vm_real *out)
{
    return vm_lagrange_rates(&o->lagrange, 0, fault_state, out);
}
static inline int call_lagrange_partial(fault_object *o, vm_real *out)
{
    return fault_number(vm_lagrange_partial_q(&o->lagrange, 0, faulty_q, faulty_rates, 0), out);
}
static inline int call_lagrange_needed_forces(fault_object *o, vm_real *out)
{
    return vm_lagrange_needed_forces(&o->lagrange, 0, 1, faulty_q, faulty_rates, faulty_rates, out);
}
static inline int call_lagrange_drive_forces(fault_object *o, vm_real *out)
{
    return vm_lagrange_drive_forces(&o->lagrange, 0, 1, faulty_q, faulty_rates, faulty_rates, out);
}

/* ---- The table ---- */

static const fault_row fault_oscillators[] = {
    FAULT_CALL(call_law_at, 2, one_law, shorter_steps),
    FAULT_CALL(call_inverse_integral, 1, one_law, shorter_steps),
    FAULT_CALL(call_ratio_integral, 1, one_law, shorter_steps),
    FAULT_CALL(call_within, 2, problem_mass, shorter_steps),
    FAULT_CALL(call_plan, 2, problem_mass, shorter_steps),
    FAULT_CALL(call_load_velocity, 2, problem_sound, shorter_steps),
    FAULT_CALL(call_load_force, 1, problem_mass, nan_for_error),
    FAULT_CALL(call_load_force, 1, problem_force, nan_for_error),
    FAULT_CALL(call_adiabaticity, 1, problem_mass, nan_for_error),
    FAULT_CALL(call_within_coarse, 2, problem_force, shorter_steps_over_nan),
    FAULT_CALL(call_averaged_ateb, 3, problem_force, shorter_steps_over_nan),
    FAULT_CALL(call_odd_period, 1, odd_force, nan_for_error),
    FAULT_CALL(call_odd_action, 1, odd_force, nan_for_error),
    FAULT_CALL(call_odd_exact, 2, odd_force, shorter_steps),
    FAULT_CALL(call_odd_within, 2, odd_problem_force, shorter_steps),
    FAULT_CALL(call_odd_integrated, 2, odd_problem_force, shorter_steps),
    FAULT_CALL(call_odd_within, 2, duffing_laws, shorter_steps),
    FAULT_CALL(call_odd_integrated, 2, duffing_laws, shorter_steps),
    FAULT_RHS(vm_odd_rhs, 2, duffing_laws, rhs_error_of_law),
    FAULT_CALL(call_vdp_order2, 2, vdp_mass, shorter_steps),
    FAULT_CALL(call_vdp_rk87, 2, vdp_mass, shorter_steps),
    FAULT_CALL(call_vdp_within, 2, vdp_mass, shorter_steps),
    FAULT_RHS(vm_vdp_rhs, 2, vdp_mass, rhs_error_of_law),
    FAULT_RHS(vm_vdp_averaged_rhs, 2, vdp_mass, rhs_error_of_law),
    FAULT_RHS(vm_jeffcott_rhs, 4, rotor_mass_shaft_and_force, rotor_rhs_error),
    FAULT_RHS(vm_jeffcott_exact_rhs, 5, rotor_mass_shaft_and_force, rotor_rhs_error),
    FAULT_RHS(vm_jeffcott_averaged_rhs, 5, rotor_mass_shaft_and_force, rotor_rhs_error),
    FAULT_RHS(vm_jeffcott_forward_whirl_rhs, 2, rotor_mass_and_shaft, rhs_error_of_law),
    FAULT_CALL(call_rotor_to_averaged, 5, rotor_mass_shaft_and_force, rotor_error),
    FAULT_CALL(call_rotor_from_averaged, 4, rotor_mass_shaft_and_force, rotor_error),
    FAULT_CALL(call_rotor_frequency, 1, rotor_mass_and_shaft, shorter_steps_over_nan),
    FAULT_CALL(call_rotor_amplitude, 1, rotor_mass_and_shaft, shorter_steps_over_nan),
    FAULT_CALL(call_rotor_whirl_amplitude, 1, rotor_mass_and_shaft, shorter_steps_over_nan),
    FAULT_CALL(call_rotor_whirl_at, 1, rotor_mass_and_shaft, rotor_error),
    FAULT_CALL(call_rotor_linear_at, 4, rotor_mass, shorter_steps),
    FAULT_CALL(call_rotor_linear_at, 4, rotor_mass_and_linear_shaft, rotor_error),
    FAULT_RHS(vm_jeffcott_forward_whirl_rhs, 2, rotor_mass_shaft_and_force, rotor_rhs_error),
    FAULT_RHS(vm_jeffcott_backward_whirl_rhs, 2, rotor_mass_shaft_and_force, rotor_rhs_error),
    FAULT_RHS(vm_pair_rhs, 4, pair_mass, rhs_error_of_law),
    FAULT_RHS(vm_pair_averaged_rhs, 4, pair_mass, rhs_error_of_law),
    FAULT_CALL(call_pair_to_averaged, 4, pair_mass, shorter_steps),
    FAULT_RHS(vm_coupled_pair_rhs, 4, coupled_masses_and_force, rhs_error_of_user),
    FAULT_CALL(call_coupled_to_modes, 4, coupled_masses_and_force, shorter_steps),
    FAULT_CALL(call_coupled_from_modes, 4, coupled_masses_and_force, shorter_steps),
    FAULT_CALL(call_coupled_oscillator, 2, coupled_masses, shorter_steps_of_reduced_mass),
    FAULT_CALL(call_forced_init, 1, forced_mass_and_frequency, shorter_steps),
    FAULT_RHS(vm_forced_rhs, 3, forced_mass_and_frequency, rhs_error_of_law),
    FAULT_RHS(vm_forced_exact_rhs, 3, forced_mass_and_frequency, rhs_error_of_law),
    FAULT_RHS(vm_forced_averaged_rhs, 3, forced_mass_and_frequency, rhs_error_of_law),
    FAULT_CALL(call_forced_to_averaged, 3, forced_mass_and_frequency, shorter_steps),
    FAULT_CALL(call_forced_steady_states, 2, forced_mass_and_frequency, shorter_steps),
    FAULT_CALL(call_forced_peak, 1, forced_mass_and_frequency, nan_for_error),
    FAULT_CALL(call_forced_passage, 1, forced_mass_and_frequency, shorter_steps),
    FAULT_CALL(call_find_samples, 1, motion_or_envelope, shorter_steps_over_nan),
    FAULT_CALL(call_find_turning_points, 1, motion_or_envelope, shorter_steps_over_nan),
    FAULT_CALL(call_envelope_error, 1, motion_or_envelope, shorter_steps_over_nan),
    FAULT_CALL(call_envelope_of_crossings, 1, motion_or_envelope, shorter_steps_over_nan),
    FAULT_CALL(call_lagrange_rhs, 4, energy_and_masses, rhs_nan),
    FAULT_CALL(call_lagrange_rhs, 4, generalized_forces, rhs_error_of_user),
    FAULT_CALL(call_lagrange_start, 4, energy_and_masses, shorter_steps_over_nan),
    FAULT_CALL(call_lagrange_rates, 2, energy_and_masses, shorter_steps_over_nan),
    FAULT_CALL(call_lagrange_partial, 1, energy_and_masses, shorter_steps_over_nan),
    FAULT_CALL(call_lagrange_needed_forces, 2, energy_and_masses, shorter_steps_over_nan),
    FAULT_CALL(call_lagrange_drive_forces, 2, generalized_forces, error_of_user),
};

#endif
