/* Functions of a user that fail at each of their calls in turn, in every function of the library that takes one: the
   status is right, outputs are as promised, and a second call goes on. */
#include "faults_flow.h"
#include "faults_integrators.h"
#include "faults_laws.h"
#include "faults_masses.h"
#include "faults_oscillators.h"
#include "faults_runs.h"
#include "faults_scenes.h"

#define LENGTH(table) (int)(sizeof table / sizeof *table)

static void check_all(int n, const scenario *scenarios)
{
    int i;
    for (i = 0; i < n; i++) check_faults(scenarios + i);
}

static void check_calls(int n, const fault_row *rows)
{
    int i;
    for (i = 0; i < n; i++) check_faults_of_row(rows[i].name, rows[i].promise, fault_call_twice, rows + i);
}

/* All routes to the motion of an oscillator: with laws that fail, and with a force that fails if a route allows one */
static void check_routes(void)
{
    static const fault_row by_laws = FAULT_CALL(call_by_route, 2, problem_mass, shorter_steps);
    static const fault_row by_force = FAULT_CALL(call_by_route, 2, problem_force, shorter_steps_over_nan);
    int route;
    for (route = VM_ROUTE_TRIG; route <= VM_ROUTE_RK87; route++) {
        fault_route = route;
        printf("route %s\n", vm_osc_route_name(route));
        check_calls(1, &by_laws);
        if (route >= VM_ROUTE_COLLOCATION) check_calls(1, &by_force);
    }
}

int main(void)
{
    int i;
    check_all(LENGTH(fault_integrators), fault_integrators);
    check_all(LENGTH(fault_runs), fault_runs);
    for (i = 0; i < LENGTH(fault_flows); i++) check_flow(fault_flows + i);
    check_calls(LENGTH(fault_laws), fault_laws);
    check_calls(LENGTH(fault_oscillators), fault_oscillators);
    check_all(LENGTH(fault_scenes), fault_scenes);
    for (i = 0; i < LENGTH(fault_mass_laws); i++) check_mass_law(fault_mass_laws + i);
    check_all(LENGTH(fault_effects), fault_effects);
    check_routes();
    for (i = 0; i < LENGTH(fault_refusals); i++) check_refused(fault_refusals + i);
    return check_finish("faults");
}
