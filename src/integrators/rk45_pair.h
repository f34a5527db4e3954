/* integrators/rk45_pair.h - the pair of orders 5 and 4 of Dormand and Prince: error and dense output */
#ifndef VARMASS_INTEGRATORS_RK45_PAIR_H
#define VARMASS_INTEGRATORS_RK45_PAIR_H

#include "../base/arrays.h"
#include "../base/real.h"
#include "pairs.h"
#include "runs.h"

/* The largest error of a component over its tolerance, NaN where anything is not finite: by the difference of orders
   5 and 4 */
VM_INLINE vm_real vmi_rk45_error(const rk45_options *o, int n, vm_real h, const vm_real *w, ptrdiff_t m)
{
    const vm_real *y = w + VMI_Y * m, *z = w + VMI_Z * m, *k1 = w + VMI_K * m, *k2 = k1 + m, *k3 = k2 + m,
                  *k4 = k3 + m, *k5 = k4 + m, *k6 = k5 + m, *k7 = k6 + m;
    vm_real worst = 0, bad = 0;
    int i;
    VMI_EACH(i, n)
    vmi_weigh(o, i,
              h * (VM_C(-0.00178001105222577714) * k1[i] - VM_C(0.0008164344596567469) * k2[i] +
                   VM_C(0.007880878010261995) * k3[i] - VM_C(0.1447110071732629) * k4[i] +
                   VM_C(0.5823571654525552) * k5[i] - VM_C(0.45808210592918697) * k6[i] +
                   VM_C(0.01515151515151515152) * k7[i]),
              y[i], z[i], &worst, &bad);
    return VMI_SMALLER(worst, VMI_WORST) + bad;
}

/* Weights b_j of y(t_old + x h) = y_old + h sum b_j k_j, of order 4 [1]; returns how many */
VM_API int vmi_rk45_weights(vm_real x, vm_real *b)
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
    return 7;
}

#endif
