/* faults_laws.h - periodic forces, weakly coupled oscillators and the other functions of oscillators that
   faults_oscillators.h leaves out, with laws and forces of a user that fail */
#ifndef FAULTS_LAWS_H
#define FAULTS_LAWS_H

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

/* ---- Excited oscillators ---- */

/* An oscillator all of whose laws fail */
static inline void forced_all_laws(fault_object *o)
{
    o->forced = a_forced();
    o->forced.mass = a_faulty_law_of(&fault_mass);
    o->forced.stiffness = a_faulty_law_of(&fault_stiffness);
    o->forced.frequency = a_faulty_law_of(&fault_frequency);
    o->forced.force = a_faulty_law_of(&fault_force);
}

static inline int call_forced_from_averaged(fault_object *o, vm_real *out)
{
    return vm_forced_from_averaged(&o->forced, 1, fault_state, out);
}
static inline int call_forced_curve(fault_object *o, vm_real *out)
{
    vm_steady_state curve[2];
    memset(curve, 0, sizeof curve);
    return fault_steady(vm_forced_curve(&o->forced, 1, R(0.5), curve), curve, out);
}

/* ---- Periodic forces ---- */

static inline void periodic_all_laws(fault_object *o)
{
    fault_object oscillator;
    forced_all_laws(&oscillator);
    o->periodic = a_periodic();
    o->periodic.oscillator = oscillator.forced;
}

static inline int call_periodic_init(fault_object *o, vm_real *out)
{
    const int status = vm_periodic_init(&o->periodic);
    if (!status) out[0] = o->periodic.oscillator.pi;
    return status;
}
static inline int call_periodic_to_averaged(fault_object *o, vm_real *out)
{
    return vm_periodic_to_averaged(&o->periodic, 1, fault_state, out);
}
static inline int call_periodic_from_averaged(fault_object *o, vm_real *out)
{
    return vm_periodic_from_averaged(&o->periodic, 1, fault_state, out);
}
static inline int call_periodic_curve(fault_object *o, vm_real *out)
{
    vm_steady_state steady;
    memset(&steady, 0, sizeof steady);
    return fault_steady(vm_periodic_curve(&o->periodic, 1, R(-1.5), &steady), &steady, out);
}
static inline int call_periodic_steady_states(fault_object *o, vm_real *out)
{
    vm_steady_state steady[4];
    memset(steady, 0, sizeof steady);
    return fault_steady(vm_periodic_steady_states(&o->periodic, 1, 4, steady), steady, out);
}

/* ---- Weakly coupled oscillators ---- */

static inline void grounded_masses_and_stiffnesses(fault_object *o)
{
    static vm_real other_stiffness = R(4.5);
    int i;
    o->grounded = a_grounded_pair();
    for (i = 0; i < 2; i++) o->grounded.oscillator[i].mass = a_faulty_law_of(&fault_mass);
    o->grounded.oscillator[0].stiffness = a_faulty_law_of(&fault_stiffness);
    o->grounded.oscillator[1].stiffness = a_faulty_law_of(&other_stiffness);
}

static inline int call_grounded_init(fault_object *o, vm_real *out)
{
    const int status = vm_grounded_pair_init(&o->grounded);
    if (!status) out[0] = o->grounded.mean[0];
    return status;
}
static inline int call_grounded_to_averaged(fault_object *o, vm_real *out)
{
    return vm_grounded_pair_to_averaged(&o->grounded, 1, fault_state, out);
}
static inline int call_grounded_from_averaged(fault_object *o, vm_real *out)
{
    return vm_grounded_pair_from_averaged(&o->grounded, 1, fault_state, out);
}

/* ---- Two bodies ---- */

static inline int call_pair_from_averaged(fault_object *o, vm_real *out)
{
    return vm_pair_from_averaged(&o->pair, 3, fault_state, out);
}

/* ---- Oscillators ---- */

/* An oscillator whose mass and stiffness are laws that fail */
static inline void problem_laws(fault_object *o)
{
    problem_mass(o);
    o->problem.stiffness = a_faulty_law_of(&fault_stiffness);
}
/* An oscillator whose force fails, too */
static inline void problem_laws_and_force(fault_object *o)
{
    problem_laws(o);
    o->problem.force = faulty_force;
}

static inline int call_averaged_trig(fault_object *o, vm_real *out) { return fault_averaged(o, VM_ROUTE_TRIG, out); }

static inline int call_plan_by_route(fault_object *o, vm_real *out)
{
    vm_osc_motion m = untouched_motion();
    vm_osc_plan plan;
    int status = vm_osc_plan_init(&plan, &o->problem);
    if (!status) status = vm_osc_plan_by_route(&plan, VM_ROUTE_RK45, 2, R(1e-3), &m);
    return fault_motion(status, &m, out);
}

static inline int call_within_short(fault_object *o, vm_real *out) { return fault_within(o, 2, R(1e-4), out); }

/* The damping of a load is a law, too. */
static inline int call_load_damping(fault_object *o, vm_real *out)
{
    const vm_law damping = a_faulty_law_of(&fault_damping);
    return fault_load(o, NULL, &damping, VM_ROUTE_RK45, 2, out);
}

/* The averaged equations alone: the plan is made without faults. */
static inline int call_averaged_alone(fault_object *o, vm_real *out)
{
    const struct fault_now before = fault_hold();
    vm_osc_plan plan;
    const int status = vm_osc_plan_init(&plan, &o->problem);
    fault = before;
    return status ? status : vm_osc_averaged(&plan, VM_ROUTE_JACOBI, 1, 1, out, out + 1, out + 2);
}

/* ---- Odd forces ---- */

/* An oscillator whose force and three laws fail */
static inline void odd_problem_all(fault_object *o)
{
    static vm_real one = 1;
    odd_problem_force(o);
    o->odd.mass = a_faulty_law_of(&fault_mass);
    o->odd.stiffness = a_faulty_law_of(&one);
    o->odd.damping = a_faulty_law_of(&fault_damping);
}

/* An oscillator for the averaged routes. In float their plans reach nowhere with laws of a user, so that only the force
   fails there. */
static inline void odd_problem_averaged(fault_object *o)
{
#if VM_MANT_DIG > 24
    odd_problem_all(o);
#else
    odd_problem_force(o);
#endif
}

static inline int fault_odd_by_route(const fault_object *o, int route, vm_real *out)
{
    vm_odd_plan plan;
    vm_odd_motion m;
    int status;
    memset(&plan, 0, sizeof plan);
    m.x = m.v = FAULT_UNTOUCHED;
    status = vm_odd_plan_init(&plan, &o->odd, R(0.5));
    if (!status) status = vm_odd_plan_by_route(&plan, route, R(0.5), R(1e-2), &m);
    return fault_odd_motion(status, &m, out);
}
static inline int call_odd_mean(fault_object *o, vm_real *out) { return fault_odd_by_route(o, VM_ODD_MEAN, out); }
static inline int call_odd_rk87(fault_object *o, vm_real *out) { return fault_odd_by_route(o, VM_ODD_RK87, out); }

/* A motion by a plan that is made without faults. The route -1 stands for the cheapest route. */
static inline int fault_odd_alone(const fault_object *o, int route, vm_real *out)
{
    const struct fault_now before = fault_hold();
    const vm_real t = R(0.25), tolerance = R(1e-2);
    vm_odd_plan plan;
    vm_odd_motion m;
    int status = vm_odd_plan_init(&plan, &o->odd, R(0.5));
    fault = before;
    m.x = m.v = FAULT_UNTOUCHED;
    if (!status && route < 0) status = vm_odd_plan_within(&plan, t, tolerance, &m);
    else if (!status) status = vm_odd_plan_by_route(&plan, route, t, tolerance, &m);
    return fault_odd_motion(status, &m, out);
}
static inline int call_odd_mean_alone(fault_object *o, vm_real *out) { return fault_odd_alone(o, VM_ODD_MEAN, out); }
static inline int call_odd_order2_alone(fault_object *o, vm_real *out)
{
    return fault_odd_alone(o, VM_ODD_ORDER2, out);
}
static inline int call_odd_rk87_alone(fault_object *o, vm_real *out) { return fault_odd_alone(o, VM_ODD_RK87, out); }
static inline int call_odd_within_alone(fault_object *o, vm_real *out) { return fault_odd_alone(o, -1, out); }

/* ---- Van der Pol ---- */

static inline void vdp_laws(fault_object *o)
{
    vdp_mass(o);
    o->vdp.stiffness = a_faulty_law_of(&fault_stiffness);
}

static inline int call_vdp_ateb(fault_object *o, vm_real *out)
{
    return fault_vdp_by_route(o, VM_ROUTE_ATEB, R(0.5), out);
}
static inline int call_vdp_order3(fault_object *o, vm_real *out)
{
    return fault_vdp_by_route(o, VM_ROUTE_ORDER3, R(0.5), out);
}
static inline int call_vdp_rk87_short(fault_object *o, vm_real *out)
{
    return fault_vdp_by_route(o, VM_ROUTE_RK87, R(0.5), out);
}

static inline int call_vdp_cycle(fault_object *o, vm_real *out)
{
    vm_vdp_cycle cycle;
    int status;
    cycle.largest_x = cycle.period = cycle.epsilon = FAULT_UNTOUCHED;
    cycle.stable = -1;
    status = vm_vdp_cycle_of(&o->vdp, &cycle);
    out[0] = cycle.largest_x;
    out[1] = cycle.period;
    out[2] = cycle.epsilon;
    if (cycle.stable >= 0) out[3] = (vm_real)cycle.stable;
    return status;
}

/* ---- Lagrange's equations ---- */

static inline void energy_masses_and_forces(fault_object *o)
{
    energy_and_masses(o);
    o->lagrange.forces = faulty_forces;
}

/* ---- Closed forms, which no law of a user has ---- */

static inline int call_pair_at(fault_object *o, vm_real *out) { return vm_pair_at(&o->pair, 3, fault_state, out); }
static inline int call_pair_by_method(fault_object *o, vm_real *out)
{
    return vm_pair_by_method(&o->pair, VM_PAIR_ATEB, 3, fault_state, out);
}
/* The result NaN stands for the refusal. */
static inline int call_vdp_amplitude(fault_object *o, vm_real *out)
{
    return fault_number(vm_vdp_amplitude(&o->vdp, 3, 1), out) ? VM_NO_LAW : VM_OK;
}
static inline int call_closed_init(fault_object *o, vm_real *out)
{
    vm_osc_closed closed, before;
    int status;
    memset(&closed, 0, sizeof closed);
    before = closed;
    status = vm_osc_closed_init(&closed, &o->problem, 3, 2);
    if (memcmp(&closed, &before, sizeof closed) != 0) out[0] = 0;
    return status;
}

/* ---- The tables ---- */

static const fault_row fault_laws[] = {
    FAULT_CALL(call_forced_init, 1, forced_all_laws, error_of_law),
    FAULT_RHS(vm_forced_rhs, 3, forced_all_laws, error_of_law),
    FAULT_RHS(vm_forced_exact_rhs, 3, forced_all_laws, error_of_law),
    FAULT_RHS(vm_forced_averaged_rhs, 3, forced_all_laws, error_of_law),
    FAULT_CALL(call_forced_to_averaged, 3, forced_all_laws, error_of_law),
    FAULT_CALL(call_forced_from_averaged, 3, forced_all_laws, error_of_law),
    FAULT_CALL(call_forced_steady_states, 2, forced_all_laws, error_of_law),
    FAULT_CALL(call_forced_curve, 2, forced_all_laws, error_of_law),
    FAULT_CALL(call_forced_passage, 1, forced_all_laws, error_of_law),
    FAULT_CALL(call_periodic_init, 1, periodic_all_laws, error_of_law),
    FAULT_RHS(vm_periodic_rhs, 3, periodic_all_laws, error_of_law),
    FAULT_RHS(vm_periodic_exact_rhs, 3, periodic_all_laws, error_of_law),
    FAULT_RHS(vm_periodic_averaged_rhs, 3, periodic_all_laws, error_of_law),
    FAULT_CALL(call_periodic_to_averaged, 3, periodic_all_laws, error_of_law),
    FAULT_CALL(call_periodic_from_averaged, 3, periodic_all_laws, error_of_law),
    FAULT_CALL(call_periodic_curve, 2, periodic_all_laws, error_of_law),
    FAULT_CALL(call_periodic_steady_states, 2, periodic_all_laws, error_of_law),
    FAULT_CALL(call_grounded_init, 1, grounded_masses_and_stiffnesses, error_of_law),
    FAULT_RHS(vm_grounded_pair_rhs, 4, grounded_masses_and_stiffnesses, error_of_law),
    FAULT_RHS(vm_grounded_pair_averaged_rhs, 4, grounded_masses_and_stiffnesses, error_of_law),
    FAULT_CALL(call_grounded_to_averaged, 4, grounded_masses_and_stiffnesses, error_of_law),
    FAULT_CALL(call_grounded_from_averaged, 4, grounded_masses_and_stiffnesses, error_of_law),
    FAULT_CALL(call_pair_from_averaged, 4, pair_mass, error_of_law),
    FAULT_RHS(vm_jeffcott_backward_whirl_rhs, 2, rotor_mass_and_shaft, rhs_error_of_law),
    FAULT_CALL(call_rotor_backward_whirl_at, 1, rotor_mass_and_shaft, rotor_error),
    FAULT_CALL(call_rotor_backward_frequency, 1, rotor_mass_and_shaft, shorter_steps_over_nan),
    FAULT_CALL(call_averaged_trig, 3, problem_laws_and_force, shorter_steps),
    FAULT_CALL(call_plan_by_route, 2, problem_laws_and_force, shorter_steps),
    FAULT_CALL(call_within_short, 2, problem_laws, shorter_steps),
    FAULT_CALL(call_averaged_alone, 3, problem_laws_and_force, error_of_law),
    FAULT_CALL(call_load_damping, 2, problem_mass, shorter_steps),
    FAULT_CALL(call_load_damping, 2, problem_force, shorter_steps),
    FAULT_CALL(call_odd_mean, 2, odd_problem_averaged, shorter_steps_of_a_long_call),
    FAULT_CALL(call_odd_rk87, 2, odd_problem_all, shorter_steps_of_a_long_call),
    FAULT_RHS(vm_odd_rhs, 2, odd_problem_all, error_of_law),
    FAULT_CALL(call_odd_mean_alone, 2, odd_problem_force, shorter_steps),
    FAULT_CALL(call_odd_order2_alone, 2, odd_problem_force, shorter_steps),
    FAULT_CALL(call_odd_rk87_alone, 2, odd_problem_force, shorter_steps),
    FAULT_CALL(call_odd_within_alone, 2, odd_problem_force, shorter_steps),
    FAULT_CALL(call_odd_mean_alone, 2, duffing_laws, shorter_steps),
    FAULT_CALL(call_odd_order2_alone, 2, duffing_laws, shorter_steps),
    FAULT_CALL(call_odd_rk87_alone, 2, duffing_laws, shorter_steps),
    FAULT_CALL(call_odd_within_alone, 2, duffing_laws, shorter_steps),
    FAULT_CALL(call_vdp_ateb, 2, vdp_laws, shorter_steps),
    FAULT_CALL(call_vdp_order3, 2, vdp_laws, shorter_steps),
    FAULT_CALL(call_vdp_rk87_short, 2, vdp_laws, shorter_steps),
    FAULT_CALL(call_vdp_cycle, 4, vdp_laws, error_of_law),
    FAULT_RHS(vm_vdp_rhs, 2, vdp_laws, error_of_law),
    FAULT_RHS(vm_vdp_averaged_rhs, 2, vdp_laws, error_of_law),
    FAULT_CALL(call_lagrange_rhs, 4, energy_masses_and_forces, energy_error),
    FAULT_CALL(call_lagrange_drive_forces, 2, energy_masses_and_forces, energy_error),
};

/* Functions that refuse laws of a user. What they promise is in check_refused. */
static const fault_row fault_refusals[] = {
    FAULT_CALL(call_pair_at, 4, pair_mass, error_of_law),
    FAULT_CALL(call_pair_by_method, 4, pair_mass, error_of_law),
    FAULT_CALL(call_closed_init, 1, problem_laws, error_of_law),
    FAULT_CALL(call_vdp_amplitude, 1, vdp_mass, error_of_law),
};

/* The status of a function that refuses laws of a user is VM_NO_LAW, or where a law fails at any of its calls, the
   status of that law; its outputs always stay as they were. */
static inline void check_refused(const fault_row *row)
{
    int kind;
    for (kind = FAULT_STATUS; kind <= FAULT_BOTH; kind *= 2) {
        long at, calls = 0;
        for (at = -1; at < calls; at++) {
            outcome o = {0, 1, 0, 0};
            fault.calls = 0;
            fault.at = at;
            fault.kind = kind;
            o.status = fault_try(row, &o);
            if (at < 0) calls = fault.calls;
            if (at < 0) CHECK(o.status == VM_NO_LAW);
            else if (kind == FAULT_STATUS) CHECK(o.status == VM_DOMAIN || o.status == VM_NO_LAW);
            else CHECK(o.status == VM_NOT_FINITE || o.status == VM_DOMAIN || o.status == VM_NO_LAW);
            CHECK(o.sound);
        }
    }
}

#endif
