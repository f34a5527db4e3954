/* For Frama-C's EVA: ateb.h with any numbers at all, NaN and infinities among them. */
#include "../ateb.h"

volatile vm_real any;
vm_real sink[16];

int main(void)
{
    ateb_plan plan;
    sink[0] = ateb_pi(any), sink[1] = ateb_sa(any, any), sink[2] = ateb_ca(any, any);
    sink[3] = ateb_phase(any, any, any);
    sink[4] = ateb_beta(any, any), sink[5] = ateb_mean(any, any, any);
    ateb_beta_inc_both(any, any, any, any, sink, sink + 1);
    ateb_beta_inc_inv_both(any, any, any, any, sink, sink + 1, sink + 2);
    ateb_saca_nm(any, any, any, sink, sink + 1);
    if (ateb_plan_init(&plan, any) == 0) ateb_plan_saca(&plan, any, sink, sink + 1);
    return 0;
}
