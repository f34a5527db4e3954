/* Functions of a user that fail at each of their calls in turn, in every function of the library that takes one: the
   status is right, outputs are as promised, and a second call goes on. */
#include "faults_flow.h"
#include "faults_integrators.h"
#include "faults_laws.h"
#include "faults_masses.h"
#include "faults_oscillators.h"
#include "faults_runs.h"
#include "faults_scenes.h"

/* A user's function of a law may be defined only close to t. A call that fails may therefore only make steps shorter:
   the results then differ within the tolerances of the calls. */
#define FAULT_TOLERANCE (5e-3 / (double)VM_EPSILON)
#define ROW(call, kinds, stopped, difference, other, nan) \
    {#call, NULL, kinds, stopped, VM_NOT_FINITE, difference, call, other, nan}
#define LAW(call) ROW(call, FAULT_ALL, VM_DOMAIN, FAULT_TOLERANCE, VM_NOT_INTEGRATED, 0)
/* A call that takes a fifth of a second: one kind of fault, the error with a NaN */
#define LONG(call) ROW(call, FAULT_BOTH, VM_DOMAIN, FAULT_TOLERANCE, VM_NOT_INTEGRATED, 0)
#define RHS(call, stopped) ROW(call, FAULT_ALL, stopped, 0, VM_DOMAIN, 1)
#define NUMBER(call) ROW(call, FAULT_ALL, VM_NOT_FINITE, 0, 0, 0) /* a function of numbers; NaN stands for an error */
#define ONLY_NAN(call) ROW(call, FAULT_NAN, 0, FAULT_TOLERANCE, VM_NOT_INTEGRATED, 0)
/* The stiffness and the force of a rotor have no status, so that both kinds of faults at once are those of a NaN. */
#define ROTOR(call) ROW(call, FAULT_STATUS + FAULT_NAN, VM_DOMAIN, 0, 0, 1)
#define WHIRL(call) ROW(call, FAULT_STATUS + FAULT_NAN, VM_DOMAIN, 0, VM_BAD_STIFFNESS, 0)

/* A function that calls each law once: an error at any of them is its status. */
#define ONCE(call) ROW(call, FAULT_ALL, VM_DOMAIN, 0, 0, 0)
#define RIGHT(call) RHS(call, VM_DOMAIN)
#define DRIVEN(call, stopped) ROW(call, FAULT_STATUS + FAULT_NAN, stopped, 0, 0, 1) /* an energy has no status */

static const scenario fault_laws[] = {
    ONCE(call_all_forced_init),
    ONCE(call_all_forced_rhs),
    ONCE(call_all_forced_exact_rhs),
    ONCE(call_all_forced_averaged_rhs),
    ONCE(call_all_forced_to_averaged),
    ONCE(call_forced_from_averaged),
    ONCE(call_all_forced_steady),
    ONCE(call_forced_curve),
    ONCE(call_all_forced_passage),
    ONCE(call_periodic_init),
    ONCE(call_periodic_rhs),
    ONCE(call_periodic_exact_rhs),
    ONCE(call_periodic_averaged_rhs),
    ONCE(call_periodic_to_averaged),
    ONCE(call_periodic_from_averaged),
    ONCE(call_periodic_curve),
    ONCE(call_periodic_steady),
    ONCE(call_grounded_init),
    ONCE(call_grounded_rhs),
    ONCE(call_grounded_averaged_rhs),
    ONCE(call_grounded_to_averaged),
    ONCE(call_grounded_from_averaged),
    ONCE(call_pair_from_averaged),
    RIGHT(call_rotor_backward_whirl_rhs),
    WHIRL(call_rotor_backward_whirl_at),
    ONLY_NAN(call_rotor_backward_frequency),
    LAW(call_averaged_laws),
    LAW(call_plan_by_route),
    LAW(call_stiffness_within),
    LAW(call_load_damping),
    LONG(call_odd_mean),
    LONG(call_odd_rk87),
    ONCE(call_all_odd_rhs),
    LAW(call_vdp_ateb),
    LAW(call_vdp_order3),
    LAW(call_vdp_stiffness),
    ONCE(call_vdp_cycle),
    ONCE(call_all_vdp_rhs),
    ONCE(call_all_vdp_averaged_rhs),
    ONLY_NAN(call_find_turning_points),
    ONLY_NAN(call_envelope_of_crossings),
    DRIVEN(call_all_lagrange_rhs, FAULT_NUMBER),
    DRIVEN(call_all_lagrange_drive, FAULT_NUMBER),
};

static const scenario fault_oscillators[] = {
    LAW(call_law_at),
    LAW(call_inverse_integral),
    LAW(call_ratio_integral),
    LAW(call_within),
    LAW(call_plan),
    LAW(call_load),
    NUMBER(call_load_force),
    NUMBER(call_adiabaticity),
    ONLY_NAN(call_force_within),
    ONLY_NAN(call_averaged),
    NUMBER(call_odd_period),
    NUMBER(call_odd_action),
    LAW(call_odd_exact),
    LAW(call_odd_within),
    LAW(call_odd_integrated),
    LAW(call_duffing_within),
    LAW(call_duffing_integrated),
    RHS(call_odd_rhs, VM_DOMAIN),
    LAW(call_vdp_law),
    LAW(call_vdp_rk87),
    LAW(call_vdp_within),
    RHS(call_vdp_rhs, VM_DOMAIN),
    RHS(call_vdp_averaged_rhs, VM_DOMAIN),
    ROTOR(call_rotor_rhs),
    ROTOR(call_rotor_exact_rhs),
    ROTOR(call_rotor_averaged_rhs),
    RHS(call_rotor_whirl_rhs, VM_DOMAIN),
    WHIRL(call_rotor_to_averaged),
    WHIRL(call_rotor_from_averaged),
    ONLY_NAN(call_rotor_frequency),
    ONLY_NAN(call_rotor_amplitude),
    ONLY_NAN(call_rotor_whirl_amplitude),
    WHIRL(call_rotor_whirl_at),
    LAW(call_rotor_linear_at),
    RHS(call_pair_rhs, VM_DOMAIN),
    RHS(call_pair_averaged_rhs, VM_DOMAIN),
    LAW(call_pair_to_averaged),
    RHS(call_coupled_rhs, FAULT_NUMBER),
    LAW(call_coupled_to_modes),
    LAW(call_coupled_from_modes),
    ROW(call_coupled_oscillator, FAULT_ALL, VM_DOMAIN, FAULT_TOLERANCE, VM_DOMAIN, 0), /* the reduced mass is a law */
    LAW(call_forced_init),
    RHS(call_forced_rhs, VM_DOMAIN),
    RHS(call_forced_exact_rhs, VM_DOMAIN),
    RHS(call_forced_averaged_rhs, VM_DOMAIN),
    LAW(call_forced_to_averaged),
    LAW(call_forced_steady),
    NUMBER(call_forced_peak),
    LAW(call_forced_passage),
    ONLY_NAN(call_find_samples),
    ONLY_NAN(call_envelope_error),
    ROW(call_lagrange_rhs, FAULT_NAN, 0, 0, 0, 1),
    RHS(call_lagrange_forces_rhs, FAULT_NUMBER),
    ONLY_NAN(call_lagrange_start),
    ONLY_NAN(call_lagrange_rates),
    ONLY_NAN(call_lagrange_partial),
    ONLY_NAN(call_lagrange_needed),
    ROW(call_lagrange_drive, FAULT_ALL, FAULT_NUMBER, 0, 0, 0),
};

#define CHECK_ALL(scenarios) check_all(scenarios, (int)(sizeof scenarios / sizeof *scenarios))
static void check_all(const scenario *scenarios, int n)
{
    int i;
    for (i = 0; i < n; i++) check_faults(scenarios + i);
}

/* All routes to the motion of an oscillator: with laws that fail, and with a force that fails if a route allows one */
static void check_routes(void)
{
    static const scenario by_laws = LAW(call_by_route), by_force = ONLY_NAN(call_force_by_route);
    int route;
    for (route = VM_ROUTE_TRIG; route <= VM_ROUTE_RK87; route++) {
        fault_route = route;
        printf("route %s\n", vm_osc_route_name(route));
        check_faults(&by_laws);
        if (route >= VM_ROUTE_COLLOCATION) check_faults(&by_force);
    }
}

int main(void)
{
    CHECK_ALL(fault_integrators);
    CHECK_ALL(fault_runs);
    CHECK_ALL(fault_flows);
    CHECK_ALL(fault_laws);
    CHECK_ALL(fault_oscillators);
    CHECK_ALL(fault_scenes);
    CHECK_ALL(fault_mass_laws);
    check_routes();
    check_refused(call_pair_at);
    check_refused(call_pair_by_method);
    check_refused(call_closed_init);
    return check_finish("faults");
}
