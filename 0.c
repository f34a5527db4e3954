#include "snippets.h"
int piece(void);
int piece(void)
{
vm_flow flow;
ode_event empty;
rk45_options options = rk45_defaults(NULL);
rk45 s;
vm_real y[VM_RHS], work[RK45_WORK(VM_RHS)];
memset(&flow, 0, sizeof flow); // what is not set is zero: not there
flow.n = 1;
flow.streams = &nozzle;
flow.least_mass = dry;
memset(&empty, 0, sizeof empty);
empty.g = vm_flow_mass_left;
empty.ctx = &flow;
empty.direction = -1;
empty.action = ODE_STOP;
options.events = &empty;
options.n_events = 1;
if (vm_flow_start(&flow, &body, y) == VM_OK &&
    rk45_init(&s, vm_rhs, &flow, VM_RHS, 0, y, &options, work) >= 0 && rk45_solve(&s, 3) >= 0)
    vm_flow_body(&flow, VM_RHS, s.y, &body);
    return 0;
}
