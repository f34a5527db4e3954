/* For Frama-C's EVA: jacobi.h with any numbers at all, NaN and infinities among them. */
#include "../jacobi.h"

volatile vm_real any;
volatile int any_int;
vm_real sink[16];

int main(void)
{
    jacobi_plan plan;
    sink[0] = jacobi_K(any), sink[1] = jacobi_E(any), sink[2] = jacobi_K_m1(any), sink[3] = jacobi_E_m1(any);
    jacobi_sncndn(any, any, sink, sink + 1, sink + 2);
    jacobi_sncndn_m1(any, any, sink, sink + 1, sink + 2);
    sink[4] = jacobi_am(any, any), sink[5] = jacobi_cd(any, any);
    sink[6] = jacobi_kpK(any), sink[7] = jacobi_solve_kpK(any), sink[8] = jacobi_solve_kpK_m1(any);
    sink[9] = jacobi_solve_K(any), sink[10] = jacobi_solve_K_m1(any);
    jacobi_cn_means(any, sink, sink + 1, sink + 2);
    jacobi_agm_sncndn(any, any, any_int, sink, sink + 1, sink + 2);
    sink[11] = jacobi_agm_K(any);
    if (jacobi_plan_init(&plan, any) == 0) jacobi_plan_sncndn(&plan, any, sink, sink + 1, sink + 2);
    if (jacobi_plan_init_m1(&plan, any) == 0) jacobi_plan_sncndn(&plan, any, sink, sink + 1, sink + 2);
    return 0;
}
