/* faults_laws.h - periodic forces, weakly coupled oscillators and the other functions of oscillators that
   faults_oscillators.h leaves out, with laws and forces of a user that fail */
#ifndef FAULTS_LAWS_H
#define FAULTS_LAWS_H

#include "faults_flow.h"
#include "faults_oscillators.h"

/* The law a (1 + t/100), where ctx points to a */
static inline int faulty_scaled_law(vm_real t, vm_real *f, vm_real *rate, void *ctx)
{
    const vm_real a = *(const vm_real *)ctx;
    const int strikes = fault_strikes();
    *f = fault_value(strikes, a * (1 + R(0.01) * t));
    *rate = fault_value(strikes, a * R(0.01));
    return fault_status(strikes);
}
static inline vm_law a_faulty_law_of(vm_real *a) { return vm_law_user(faulty_scaled_law, a); }

static vm_real fault_mass = 2, fault_stiffness = 3, fault_frequency = 2, fault_force = R(0.25);
static vm_real fault_damping = R(0.02);

/* Fills n outputs before a call that may fail. */
static inline void fault_fill(int n, vm_real *y)
{
    int i;
    for (i = 0; i < n; i++) y[i] = FAULT_UNTOUCHED;
}

/* The result of a call with n outputs: after an error they all must be as before. */
static inline vm_real fault_outputs(int status, int n, const vm_real *y)
{
    if (status >= 0) return fault_sum(n, y);
    return fault_is_untouched(n, y) ? FAULT_UNTOUCHED : 0;
}

/* Like call_rhs, but checks that an error leaves all derivatives. */
static inline int call_long_rhs(ode_rhs f, int n, void *object, vm_real *result)
{
    const vm_real y[5] = {1, R(0.5), R(0.25), R(0.75), R(0.125)};
    vm_real dydt[5];
    int status;
    fault_fill(n, dydt);
    status = f(1, y, dydt, object);
    *result = fault_outputs(status < 0 ? status : 0, n, dydt);
    return status;
}

/* ---- Excited oscillators ---- */

/* An oscillator all of whose laws fail */
static inline vm_forced all_faulty_forced(void)
{
    vm_forced f = a_forced();
    f.mass = a_faulty_law_of(&fault_mass);
    f.stiffness = a_faulty_law_of(&fault_stiffness);
    f.frequency = a_faulty_law_of(&fault_frequency);
    f.force = a_faulty_law_of(&fault_force);
    return f;
}

static inline int call_all_forced_init(vm_real *result)
{
    vm_forced f = all_faulty_forced();
    const vm_forced before = f;
    const int status = vm_forced_init(&f);
    *result = f.pi + f.Om1;
    if (status && memcmp(&f, &before, sizeof f) == 0) *result = FAULT_UNTOUCHED;
    return status;
}
static inline int call_all_forced_rhs(vm_real *result)
{
    vm_forced f = all_faulty_forced();
    return call_long_rhs(vm_forced_rhs, 3, &f, result);
}
static inline int call_all_forced_exact_rhs(vm_real *result)
{
    vm_forced f = all_faulty_forced();
    return call_long_rhs(vm_forced_exact_rhs, 3, &f, result);
}
static inline int call_all_forced_averaged_rhs(vm_real *result)
{
    vm_forced f = all_faulty_forced();
    return call_long_rhs(vm_forced_averaged_rhs, 3, &f, result);
}

static const vm_real fault_motion[3] = {1, R(0.5), R(0.25)};

static inline int call_all_forced_to_averaged(vm_real *result)
{
    const vm_forced f = all_faulty_forced();
    vm_real y[3];
    int status;
    fault_fill(3, y);
    status = vm_forced_to_averaged(&f, 1, fault_motion, y);
    *result = fault_outputs(status, 3, y);
    return status;
}
static inline int call_forced_from_averaged(vm_real *result)
{
    const vm_forced f = all_faulty_forced();
    vm_real motion[3];
    int status;
    fault_fill(3, motion);
    status = vm_forced_from_averaged(&f, 1, fault_motion, motion);
    *result = fault_outputs(status, 3, motion);
    return status;
}

/* The result of a search for steady states: an error leaves the list as it was. */
static inline int fault_steady(int found, const vm_steady_state *steady, vm_real *result)
{
    vm_steady_state blank;
    memset(&blank, 0, sizeof blank);
    *result = found >= 0 ? steady[0].A + steady[0].nu : FAULT_UNTOUCHED;
    if (found < 0 && memcmp(steady, &blank, sizeof blank) != 0) *result = 0;
    return found;
}
static inline int call_all_forced_steady(vm_real *result)
{
    const vm_forced f = all_faulty_forced();
    vm_steady_state steady[3];
    memset(steady, 0, sizeof steady);
    return fault_steady(vm_forced_steady_states(&f, 1, steady), steady, result);
}
static inline int call_forced_curve(vm_real *result)
{
    const vm_forced f = all_faulty_forced();
    vm_steady_state curve[2];
    memset(curve, 0, sizeof curve);
    return fault_steady(vm_forced_curve(&f, 1, R(0.5), curve), curve, result);
}
static inline int call_all_forced_passage(vm_real *result)
{
    const vm_forced f = all_faulty_forced();
    vm_passage passage;
    int status;
    passage.A = FAULT_UNTOUCHED;
    status = vm_forced_passage(&f, 1, 1, &passage);
    *result = passage.A;
    return status;
}

/* ---- Periodic forces ---- */

static inline vm_periodic a_faulty_periodic(void)
{
    vm_periodic p = a_periodic();
    p.oscillator = all_faulty_forced();
    return p;
}

static inline int call_periodic_init(vm_real *result)
{
    vm_periodic p = a_faulty_periodic();
    int status;
    p.oscillator.pi = FAULT_UNTOUCHED;
    status = vm_periodic_init(&p);
    *result = p.oscillator.pi;
    return status;
}
static inline int call_periodic_rhs(vm_real *result)
{
    vm_periodic p = a_faulty_periodic();
    return call_long_rhs(vm_periodic_rhs, 3, &p, result);
}
static inline int call_periodic_exact_rhs(vm_real *result)
{
    vm_periodic p = a_faulty_periodic();
    return call_long_rhs(vm_periodic_exact_rhs, 3, &p, result);
}
static inline int call_periodic_averaged_rhs(vm_real *result)
{
    vm_periodic p = a_faulty_periodic();
    return call_long_rhs(vm_periodic_averaged_rhs, 3, &p, result);
}
static inline int call_periodic_to_averaged(vm_real *result)
{
    const vm_periodic p = a_faulty_periodic();
    vm_real y[3];
    int status;
    fault_fill(3, y);
    status = vm_periodic_to_averaged(&p, 1, fault_motion, y);
    *result = fault_outputs(status, 3, y);
    return status;
}
static inline int call_periodic_from_averaged(vm_real *result)
{
    const vm_periodic p = a_faulty_periodic();
    vm_real motion[3];
    int status;
    fault_fill(3, motion);
    status = vm_periodic_from_averaged(&p, 1, fault_motion, motion);
    *result = fault_outputs(status, 3, motion);
    return status;
}
static inline int call_periodic_curve(vm_real *result)
{
    const vm_periodic p = a_faulty_periodic();
    vm_steady_state steady;
    memset(&steady, 0, sizeof steady);
    return fault_steady(vm_periodic_curve(&p, 1, R(-1.5), &steady), &steady, result);
}
static inline int call_periodic_steady(vm_real *result)
{
    const vm_periodic p = a_faulty_periodic();
    vm_steady_state steady[4];
    memset(steady, 0, sizeof steady);
    return fault_steady(vm_periodic_steady_states(&p, 1, 4, steady), steady, result);
}

/* ---- Weakly coupled oscillators ---- */

static vm_real fault_stiffness_1 = R(4.5);

static inline vm_grounded_pair a_faulty_grounded_pair(void)
{
    vm_grounded_pair p = a_grounded_pair();
    int i;
    for (i = 0; i < 2; i++) p.oscillator[i].mass = a_faulty_law_of(&fault_mass);
    p.oscillator[0].stiffness = a_faulty_law_of(&fault_stiffness);
    p.oscillator[1].stiffness = a_faulty_law_of(&fault_stiffness_1);
    return p;
}

static inline int call_grounded_init(vm_real *result)
{
    vm_grounded_pair p = a_faulty_grounded_pair();
    int status;
    p.mean[0] = FAULT_UNTOUCHED;
    status = vm_grounded_pair_init(&p);
    *result = p.mean[0];
    return status;
}
static inline int call_grounded_rhs(vm_real *result)
{
    vm_grounded_pair p = a_faulty_grounded_pair();
    return call_long_rhs(vm_grounded_pair_rhs, 4, &p, result);
}
static inline int call_grounded_averaged_rhs(vm_real *result)
{
    vm_grounded_pair p = a_faulty_grounded_pair();
    return call_long_rhs(vm_grounded_pair_averaged_rhs, 4, &p, result);
}

static const vm_real fault_pair_motion[4] = {1, R(0.5), R(0.75), R(0.25)};

static inline int call_grounded_to_averaged(vm_real *result)
{
    const vm_grounded_pair p = a_faulty_grounded_pair();
    vm_real y[4];
    int status;
    fault_fill(4, y);
    status = vm_grounded_pair_to_averaged(&p, 1, fault_pair_motion, y);
    *result = fault_outputs(status, 4, y);
    return status;
}
static inline int call_grounded_from_averaged(vm_real *result)
{
    const vm_grounded_pair p = a_faulty_grounded_pair();
    vm_real motion[4];
    int status;
    fault_fill(4, motion);
    status = vm_grounded_pair_from_averaged(&p, 1, fault_pair_motion, motion);
    *result = fault_outputs(status, 4, motion);
    return status;
}

/* ---- Two bodies ---- */

static inline int call_pair_from_averaged(vm_real *result)
{
    const vm_pair p = a_faulty_pair();
    vm_real y[4];
    int status;
    fault_fill(4, y);
    status = vm_pair_from_averaged(&p, 3, fault_pair_motion, y);
    *result = fault_outputs(status, 4, y);
    return status;
}

/* ---- Closed forms, which no law of a user has ---- */

static inline int call_pair_at(vm_real *result)
{
    const vm_pair p = a_faulty_pair();
    vm_real y[4];
    int status;
    fault_fill(4, y);
    status = vm_pair_at(&p, 3, fault_pair_motion, y);
    *result = fault_outputs(status, 4, y);
    return status;
}
static inline int call_pair_by_method(vm_real *result)
{
    const vm_pair p = a_faulty_pair();
    vm_real y[4];
    int status;
    fault_fill(4, y);
    status = vm_pair_by_method(&p, VM_PAIR_ATEB, 3, fault_pair_motion, y);
    *result = fault_outputs(status, 4, y);
    return status;
}
static inline int call_closed_init(vm_real *result)
{
    vm_osc_problem o = a_faulty_problem();
    vm_osc_closed closed, before;
    int status;
    o.stiffness = a_faulty_law_of(&fault_stiffness);
    memset(&closed, 0, sizeof closed);
    before = closed;
    status = vm_osc_closed_init(&closed, &o, 3, 2);
    *result = memcmp(&closed, &before, sizeof closed) == 0 ? FAULT_UNTOUCHED : 0;
    return status;
}

/* A function that refuses laws of a user. Its status is VM_NO_LAW, or where a law fails at any of its calls, the
   status of that law; its outputs always stay as they were. */
static inline void check_refused(int (*call)(vm_real *result))
{
    int kind;
    for (kind = FAULT_STATUS; kind <= FAULT_BOTH; kind *= 2) {
        long at, calls = 0;
        for (at = -1; at < calls; at++) {
            vm_real result = 0;
            int status;
            fault.calls = 0;
            fault.at = at;
            fault.kind = kind;
            status = call(&result);
            if (at < 0) calls = fault.calls;
            if (at < 0) CHECK(status == VM_NO_LAW);
            else if (kind == FAULT_STATUS) CHECK(status == VM_DOMAIN || status == VM_NO_LAW);
            else CHECK(status == VM_NOT_FINITE || status == VM_DOMAIN || status == VM_NO_LAW);
            CHECK(result == FAULT_UNTOUCHED);
        }
    }
}

/* ---- Laval's rotor ---- */

static inline int call_rotor_backward_whirl_rhs(vm_real *result)
{
    vm_jeffcott r = a_faulty_free_rotor();
    return call_rhs(vm_jeffcott_backward_whirl_rhs, 2, &r, result);
}

static inline int call_rotor_backward_whirl_at(vm_real *result)
{
    const vm_jeffcott r = a_faulty_free_rotor();
    vm_jeffcott_whirl whirl;
    const int status = vm_jeffcott_whirl_at(&r, 1, 0, -1, 2, &whirl);
    if (!status) *result = whirl.radius;
    return status;
}

static inline int call_rotor_backward_frequency(vm_real *result)
{
    const vm_jeffcott r = a_faulty_free_rotor();
    return fault_number_status(vm_jeffcott_frequency(&r, 1, 2, -1), result);
}

/* ---- Oscillators ---- */

/* A problem whose mass and stiffness are laws that fail, and whose force fails, too */
static inline vm_osc_problem all_faulty_problem(void)
{
    vm_osc_problem o = a_faulty_problem();
    o.stiffness = a_faulty_law_of(&fault_stiffness);
    o.force = faulty_force;
    return o;
}

/* A plan is made without faults; what it uses at t fails. */
static inline int call_averaged_laws(vm_real *result)
{
    const vm_osc_problem o = all_faulty_problem();
    vm_real rates[3];
    vm_osc_plan plan;
    int status;
    fault_fill(3, rates);
    status = vm_osc_plan_init(&plan, &o);
    if (!status) status = vm_osc_averaged(&plan, VM_ROUTE_TRIG, 1, 1, rates, rates + 1, rates + 2);
    *result = fault_outputs(status, 3, rates);
    return status;
}

static inline int call_plan_by_route(vm_real *result)
{
    const vm_osc_problem o = all_faulty_problem();
    vm_osc_motion m = untouched_motion();
    vm_osc_plan plan;
    int status = vm_osc_plan_init(&plan, &o);
    if (!status) status = vm_osc_plan_by_route(&plan, VM_ROUTE_RK45, 2, R(1e-3), &m);
    *result = fault_position(&m);
    return status;
}

static inline int call_stiffness_within(vm_real *result)
{
    vm_osc_problem o = all_faulty_problem();
    vm_osc_motion m = untouched_motion();
    int status;
    o.force = NULL;
    status = vm_osc_within(&o, 2, R(1e-4), &m);
    *result = fault_position(&m);
    return status;
}

/* The damping of a load is a law, too. */
static inline int call_load_damping(vm_real *result)
{
    const vm_law damping = a_faulty_law_of(&fault_damping);
    vm_osc_problem o = a_faulty_problem();
    vm_osc_motion m = untouched_motion();
    vm_osc_load load;
    int status = vm_osc_load_init(&load, &o, NULL, &damping);
    if (!status) status = vm_osc_by_route(&o, VM_ROUTE_RK45, 2, R(1e-3), &m);
    *result = fault_position(&m);
    return status;
}

/* ---- Odd forces ---- */

/* A force and three laws of a user */
static inline vm_odd_problem all_faulty_odd(void)
{
    static vm_real one = 1;
    vm_odd_problem o = a_faulty_odd_force();
    o.mass = a_faulty_law_of(&fault_mass);
    o.stiffness = a_faulty_law_of(&one);
    o.damping = a_faulty_law_of(&fault_damping);
    return o;
}

/* The same for the averaged routes. In float their plans reach nowhere with laws of a user, so that only the force
   fails there. */
static inline vm_odd_problem averaged_faulty_odd(void)
{
#if VM_MANT_DIG > 24
    return all_faulty_odd();
#else
    return a_faulty_odd_force();
#endif
}

static inline int call_odd_by_route(int route, vm_real *result)
{
    const vm_odd_problem o = route == VM_ODD_RK87 ? all_faulty_odd() : averaged_faulty_odd();
    vm_odd_plan plan;
    vm_odd_motion m;
    int status;
    memset(&plan, 0, sizeof plan);
    m.x = m.v = FAULT_UNTOUCHED;
    status = vm_odd_plan_init(&plan, &o, R(0.5));
    if (!status) status = vm_odd_plan_by_route(&plan, route, R(0.5), R(1e-2), &m);
    *result = m.x == FAULT_UNTOUCHED || m.v == FAULT_UNTOUCHED ? m.x : m.x + 3 * m.v;
    return status;
}
static inline int call_odd_mean(vm_real *result) { return call_odd_by_route(VM_ODD_MEAN, result); }
static inline int call_odd_rk87(vm_real *result) { return call_odd_by_route(VM_ODD_RK87, result); }

static inline int call_all_odd_rhs(vm_real *result)
{
    vm_odd_problem o = all_faulty_odd();
    return call_long_rhs(vm_odd_rhs, 2, &o, result);
}

/* ---- Van der Pol ---- */

static inline vm_vdp all_faulty_vdp(void)
{
    vm_vdp v = a_faulty_vdp();
    v.stiffness = a_faulty_law_of(&fault_stiffness);
    return v;
}

static inline int call_vdp_by_route(int route, vm_real *result)
{
    const vm_vdp v = all_faulty_vdp();
    vm_osc_motion m = untouched_motion();
    vm_vdp_plan plan;
    int status = vm_vdp_plan_init(&plan, &v, 1, 0);
    if (!status) status = vm_vdp_plan_by_route(&plan, route, R(0.5), R(1e-3), &m);
    *result = fault_position(&m);
    return status;
}
static inline int call_vdp_ateb(vm_real *result) { return call_vdp_by_route(VM_ROUTE_ATEB, result); }
static inline int call_vdp_order3(vm_real *result) { return call_vdp_by_route(VM_ROUTE_ORDER3, result); }
static inline int call_vdp_stiffness(vm_real *result) { return call_vdp_by_route(VM_ROUTE_RK87, result); }

static inline int call_vdp_cycle(vm_real *result)
{
    const vm_vdp v = all_faulty_vdp();
    vm_vdp_cycle cycle;
    int status;
    fault_fill((int)(sizeof cycle / sizeof(vm_real)), (vm_real *)&cycle);
    status = vm_vdp_cycle_of(&v, &cycle);
    *result = fault_outputs(status, (int)(sizeof cycle / sizeof(vm_real)), (vm_real *)&cycle);
    return status;
}

static inline int call_all_vdp_rhs(vm_real *result)
{
    vm_vdp v = all_faulty_vdp();
    return call_long_rhs(vm_vdp_rhs, 2, &v, result);
}
static inline int call_all_vdp_averaged_rhs(vm_real *result)
{
    vm_vdp v = all_faulty_vdp();
    return call_long_rhs(vm_vdp_averaged_rhs, 2, &v, result);
}

/* ---- Diagnostics ---- */

static inline int call_find_turning_points(vm_real *result)
{
    vm_sample samples[4];
    const long found = vm_find_samples(faulty_motion, NULL, VM_TURNING_POINTS, 0, 10, R(0.7), 4, samples);
    if (found < 0) return (int)found;
    *result = samples[0].t + samples[1].x + samples[2].t;
    return VM_OK;
}

static inline int call_envelope_of_crossings(vm_real *result)
{
    const vm_sample samples[3] = {{0, 0, 1}, {3, 0, -1}, {6, 0, 1}};
    return fault_number_status(vm_envelope_error(VM_ZERO_CROSSINGS, 3, samples, faulty_envelope, NULL), result);
}

/* ---- Lagrange's equations: the energy, the masses and the forces at once ---- */

static inline vm_lagrange_system all_faulty_system(void)
{
    vm_lagrange_system l = a_faulty_energy();
    l.forces = faulty_forces;
    return l;
}

static inline int call_all_lagrange_rhs(vm_real *result)
{
    vm_lagrange_system l = all_faulty_system();
    return call_rhs(vm_lagrange_rhs, 4, &l, result);
}
static inline int call_all_lagrange_drive(vm_real *result)
{
    vm_lagrange_system l = all_faulty_system();
    vm_real Q[2];
    int status;
    fault_fill(2, Q);
    status = vm_lagrange_drive_forces(&l, 0, 1, faulty_q, faulty_rates, faulty_rates, Q);
    *result = fault_outputs(status, 2, Q);
    return status;
}

#endif
