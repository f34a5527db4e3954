/* integrators/rk45_pair.h - coefficients of rk45, the Runge-Kutta pair of orders 5 and 4
   Tsitouras' pair [1] has seven stages. The last stage is the first one of the next step, so that a step takes six
   evaluations of f. The continuous extension of order 4 takes none. Users call the functions of adaptive.h.

   Tests: tests/gen/order_conditions.py, tests/test_adaptive.c. */
#ifndef VARMASS_INTEGRATORS_RK45_PAIR_H
#define VARMASS_INTEGRATORS_RK45_PAIR_H

#include "../base/arrays.h"
#include "../base/real.h"
#include "options.h"
#include "pairs.h"
#include "runs.h"

enum { VMI_RK45 = 45 }; /* the number of this pair */

/* Computes stages 2 to 7 of a step [1], for vmi_make_stages. The coefficients, which [1] gives to 16 digits, satisfy
   the order conditions to 2e-14. */
VMI_FOLDED int vmi_rk45_stages(vmi_rk_system sys, vm_real t, vm_real t_new, vm_real h, long *evals)
{
    const ptrdiff_t m = sys.m;
    const vm_real *y = sys.w + VMI_Y * m;
    vm_real *z = sys.w + VMI_Z * m, *k1 = sys.w + VMI_K * m, *k2 = k1 + m, *k3 = k2 + m, *k4 = k3 + m, *k5 = k4 + m,
            *k6 = k5 + m, *k7 = k6 + m;
    int i;
    VMI_EACH(i, sys.n) z[i] = y[i] + VMI_H(0.161) * k1[i];
    VMI_EVAL(t + VMI_H(0.161), z, k2);
    VMI_EACH(i, sys.n) z[i] = y[i] - VMI_H(0.008480655492356989) * k1[i] + VMI_H(0.335480655492357) * k2[i];
    VMI_EVAL(t + VMI_H(0.327), z, k3);
    VMI_EACH(i, sys.n)
    z[i] = y[i] + VMI_H(2.8971530571054935) * k1[i] - VMI_H(6.359448489975075) * k2[i] +
           VMI_H(4.3622954328695815) * k3[i];
    VMI_EVAL(t + VMI_H(0.9), z, k4);
    VMI_EACH(i, sys.n)
    z[i] = y[i] + VMI_H(5.325864828439257) * k1[i] - VMI_H(11.748883564062828) * k2[i] +
           VMI_H(7.4955393428898365) * k3[i] - VMI_H(0.09249506636175525) * k4[i];
    VMI_EVAL(t + VMI_H(0.9800255409045097), z, k5);
    VMI_EACH(i, sys.n)
    z[i] = y[i] + VMI_H(5.86145544294642) * k1[i] - VMI_H(12.92096931784711) * k2[i] +
           VMI_H(8.159367898576159) * k3[i] - VMI_H(0.071584973281401) * k4[i] -
           VMI_H(0.028269050394068383) * k5[i];
    VMI_EVAL(t_new, z, k6);
    VMI_EACH(i, sys.n)
    z[i] = y[i] + VMI_H(0.09646076681806523) * k1[i] + VMI_H(0.01) * k2[i] + VMI_H(0.4798896504144996) * k3[i] +
           VMI_H(1.379008574103742) * k4[i] - VMI_H(3.290069515436081) * k5[i] + VMI_H(2.324710524099774) * k6[i];
    VMI_EVAL(t_new, z, k7);
    return 0;
}

/* The largest ratio of the error of a component to its tolerance. The error is the difference of orders 5 and 4. */
VMI_FOLDED vm_real vmi_rk45_error(const rk45_options *o, vmi_rk_system sys, vm_real h)
{
    const ptrdiff_t m = sys.m;
    const vm_real *y = sys.w + VMI_Y * m, *z = sys.w + VMI_Z * m, *k1 = sys.w + VMI_K * m, *k2 = k1 + m, *k3 = k2 + m,
                  *k4 = k3 + m, *k5 = k4 + m, *k6 = k5 + m, *k7 = k6 + m;
    vm_real worst = 0, bad = 0;
    int i;
    VMI_EACH(i, sys.n)
    vmi_weigh(o, i,
              h * (VM_C(-0.00178001105222577714) * k1[i] - VM_C(0.0008164344596567469) * k2[i] +
                   VM_C(0.007880878010261995) * k3[i] - VM_C(0.1447110071732629) * k4[i] +
                   VM_C(0.5823571654525552) * k5[i] - VM_C(0.45808210592918697) * k6[i] +
                   VM_C(0.01515151515151515152) * k7[i]),
              y[i], z[i], &worst, &bad);
    return VMI_SMALLER(worst, VMI_WORST) + bad;
}

/* For the test of stiffness: the weight of k_{j+1} in stage 7 minus its weight in stage 6. Both stages evaluate f at
   the end of the step. */
VM_API vm_real vmi_rk45_end_difference(int j)
{
    VM_TABLE vm_real weights[6] = {VM_C(-5.764994676128355), VM_C(12.93096931784711),   VM_C(-7.67947824816166),
                                   VM_C(1.4505935473851428), VM_C(-3.2618004650420125), VM_C(2.324710524099774)};
    return VM_READ(weights[j]);
}

/* Computes the weights b[0], b[1] ... of k_1, k_2 ... in the continuous extension, of order 4 [1], at the fraction x of
   the step */
VM_API void vmi_rk45_weights(vm_real x, vm_real *b)
{
    const vm_real xx = x * x;
    b[0] = VM_C(-1.0530884977290216) * x * (x - VM_C(1.3299890189751412)) *
           ((x - VM_C(1.4364028541716351)) * x + VM_C(0.7139816917074209));
    b[1] = VM_C(0.1017) * xx * ((x - VM_C(2.1966568338249754)) * x + VM_C(1.2949852507374631));
    b[2] = VM_C(2.490627285651252793) * xx * ((x - VM_C(2.38535645472061657)) * x + VM_C(1.57803468208092486));
    b[3] = VM_C(-16.54810288924490272) * xx * (x - VM_C(1.21712927295533244)) * (x - VM_C(0.61620406037800089));
    b[4] = VM_C(47.37952196281928122) * xx * (x - VM_C(1.203071208372362603)) * (x - VM_C(0.658047292653547382));
    b[5] = VM_C(-34.87065786149660974) * xx * (x - VM_C(1.2)) * (x - VM_C(0.666666666666666667));
    b[6] = VM_C(2.5) * xx * (x - 1) * (x - VM_C(0.6));
}

/* Computes the state y at the fraction x of the last step by the continuous extension. The function is not inlined, so
   that the compiler contracts its arithmetic in one way only: equal x give equal y. */
VMI_APART void vmi_rk45_inside(const rk45 *s, vm_real x, vm_real *y)
{
    vm_real b[7];
    vmi_rk45_weights(x, b);
    vmi_weigh_inside(s, 7, b, x, y);
}

/* The descriptor of rk45 */
VMI_FOLDED vmi_rk_pair vmi_rk45_pair(void)
{
    vmi_rk_pair pair;
    pair.method = VMI_RK45;
    pair.order = 5;
    pair.stages = 7;
    pair.last_is_first = 1;
    pair.derivatives = 7;
    pair.rounding = 16;
    pair.keep_from = VM_C(0.25);
    pair.stiff_beyond = VM_C(3.4);
    pair.end_difference = vmi_rk45_end_difference;
    pair.inside = vmi_rk45_inside;
    pair.extend = NULL;
    return pair;
}

#endif
