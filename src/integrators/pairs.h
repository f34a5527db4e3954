/* integrators/pairs.h - the stages of the Runge-Kutta pairs */
#ifndef VARMASS_INTEGRATORS_PAIRS_H
#define VARMASS_INTEGRATORS_PAIRS_H

#include "../base/arrays.h"
#include "../base/real.h"
#include "ode.h"
#include "runs.h"

/* A step is made in w, m numbers a part. h is folded into the coefficients and the newest k comes last in every sum:
   the chain from one evaluation of f to the next is a multiplication and an addition long. */
#define VMI_H(c) (h * VM_C(c))
#define VMI_EVAL(t, y, k)        \
    do {                         \
        int stop_;               \
        ++*evals;                \
        stop_ = f(t, y, k, ctx); \
        if (stop_) return stop_; \
    } while (0)

/* Stages 2 to 7 of [1], whose coefficients, given to 16 digits, satisfy the order conditions to 1.1e-14:
   z becomes the new state, k_7 its derivative. Returns what f returns. */
VM_INLINE int vmi_rk45_stages(ode_rhs f, void *ctx, int n, vm_real t, vm_real t_new, vm_real h, vm_real *w,
                              ptrdiff_t m, long *evals)
{
    const vm_real *y = w + VMI_Y * m;
    vm_real *z = w + VMI_Z * m, *k1 = w + VMI_K * m, *k2 = k1 + m, *k3 = k2 + m, *k4 = k3 + m, *k5 = k4 + m,
            *k6 = k5 + m, *k7 = k6 + m;
    int i;
    VMI_EACH(i, n) z[i] = y[i] + VMI_H(0.161) * k1[i];
    VMI_EVAL(t + VMI_H(0.161), z, k2);
    VMI_EACH(i, n) z[i] = y[i] - VMI_H(0.008480655492356989) * k1[i] + VMI_H(0.335480655492357) * k2[i];
    VMI_EVAL(t + VMI_H(0.327), z, k3);
    VMI_EACH(i, n)
    z[i] = y[i] + VMI_H(2.8971530571054935) * k1[i] - VMI_H(6.359448489975075) * k2[i] +
           VMI_H(4.3622954328695815) * k3[i];
    VMI_EVAL(t + VMI_H(0.9), z, k4);
    VMI_EACH(i, n)
    z[i] = y[i] + VMI_H(5.325864828439257) * k1[i] - VMI_H(11.748883564062828) * k2[i] +
           VMI_H(7.4955393428898365) * k3[i] - VMI_H(0.09249506636175525) * k4[i];
    VMI_EVAL(t + VMI_H(0.9800255409045097), z, k5);
    VMI_EACH(i, n)
    z[i] = y[i] + VMI_H(5.86145544294642) * k1[i] - VMI_H(12.92096931784711) * k2[i] +
           VMI_H(8.159367898576159) * k3[i] - VMI_H(0.071584973281401) * k4[i] -
           VMI_H(0.028269050394068383) * k5[i];
    VMI_EVAL(t_new, z, k6);
    VMI_EACH(i, n)
    z[i] = y[i] + VMI_H(0.09646076681806523) * k1[i] + VMI_H(0.01) * k2[i] + VMI_H(0.4798896504144996) * k3[i] +
           VMI_H(1.379008574103742) * k4[i] - VMI_H(3.290069515436081) * k5[i] + VMI_H(2.324710524099774) * k6[i];
    VMI_EVAL(t_new, z, k7);
    return 0;
}

/* Stages 2 to 13 of [4]: z becomes the new state. Its derivative, k_14, is evaluated when the step is accepted. Large
   coefficients of opposite sign belong to nearly equal times: there differences of k, which are exact, keep the
   roundings small. */
VM_INLINE int vmi_rk87_stages(ode_rhs f, void *ctx, int n, vm_real t, vm_real t_new, vm_real h, vm_real *w,
                              ptrdiff_t m, long *evals)
{
    const vm_real *y = w + VMI_Y * m;
    vm_real *z = w + VMI_Z * m, *k1 = w + VMI_K * m, *k2 = k1 + m, *k3 = k2 + m, *k4 = k3 + m, *k5 = k4 + m,
            *k6 = k5 + m, *k7 = k6 + m, *k8 = k7 + m, *k9 = k8 + m, *k10 = k9 + m, *k11 = k10 + m, *k12 = k11 + m,
            *k13 = k12 + m;
    int i;
    VMI_EACH(i, n) z[i] = y[i] + VMI_H(0.05) * k1[i];
    VMI_EVAL(t + VMI_H(0.05), z, k2);
    VMI_EACH(i, n) z[i] = y[i] - VMI_H(0.0069931640625) * k1[i] + VMI_H(0.1135556640625) * k2[i];
    VMI_EVAL(t + VMI_H(0.1065625), z, k3);
    VMI_EACH(i, n) z[i] = y[i] + VMI_H(0.0399609375) * k1[i] + VMI_H(0.1198828125) * k3[i];
    VMI_EVAL(t + VMI_H(0.15984375), z, k4);
    VMI_EACH(i, n)
    z[i] = y[i] + h * (VM_C(0.36139756280045751241) * k1[i] - VM_C(1.3415240667004927718) * k3[i]) +
           VMI_H(1.3701265039000352594) * k4[i];
    VMI_EVAL(t + VMI_H(0.39), z, k5);
    VMI_EACH(i, n)
    z[i] = y[i] + h * (VM_C(0.049047202797202797203) * k1[i] + VM_C(0.23509720422144047399) * k4[i]) +
           VMI_H(0.18085559298135672881) * k5[i];
    VMI_EVAL(t + VMI_H(0.465), z, k6);
    VMI_EACH(i, n)
    z[i] = y[i] +
           h * (VM_C(0.06169289044289044289) * k1[i] + VM_C(0.11236568314640276623) * k4[i] -
                VM_C(0.03885046071451366767) * k5[i]) +
           VMI_H(0.019791887125220458554) * k6[i];
    VMI_EVAL(t + VMI_H(0.155), z, k7);
    VMI_EACH(i, n)
    z[i] = y[i] +
           h * (VM_C(-1.7676302402223268757) * k1[i] - VM_C(6.0618893773766691008) * k5[i] +
                VM_C(5.6508231982227631386) * k6[i] + VM_C(3.121696419376232838) * k7[i]) -
           VMI_H(62.5) * (k4[i] - k7[i]);
    VMI_EVAL(t + VMI_H(0.943), z, k8);
    VMI_EACH(i, n)
    z[i] = y[i] +
           h * (VM_C(-1.1809450665549707998) * k1[i] - VM_C(4.4344383191037250112) * k5[i] +
                VM_C(4.2604081885861330248) * k6[i] + VM_C(2.2489058133185074338) * k7[i] -
                VM_C(41.504734411143208416) * (k4[i] - k7[i])) +
           VMI_H(0.0078714254899123106874) * k8[i];
    VMI_EVAL(t + VMI_H(0.90180204173585695826), z, k9);
    VMI_EACH(i, n)
    z[i] = y[i] +
           h * (VM_C(-1.2814059994414884055) * k1[i] - VM_C(4.7313620694495764773) * k5[i] +
                VM_C(4.5149670165938078412) * k6[i] + VM_C(2.4019556115899850465) * k7[i] -
                VM_C(45.047139960139866302) * (k4[i] - k7[i]) + VM_C(0.010592282971116611357) * k8[i]) -
           VMI_H(0.0057468422638446162544) * k9[i];
    VMI_EVAL(t + VMI_H(0.909), z, k10);
    VMI_EACH(i, n)
    z[i] = y[i] +
           h * (VM_C(-1.7244701342624851918) * k1[i] - VM_C(5.9515183762223924552) * k5[i] +
                VM_C(5.556523730698456236) * k6[i] + VM_C(3.0595218955025132032) * k7[i] -
                VM_C(60.923490084830540165) * (k4[i] - k7[i]) + VM_C(0.014642028250414961593) * k8[i] +
                VM_C(0.064604087723582036036) * k9[i]) -
           VMI_H(0.07930323169008878984) * k10[i];
    VMI_EVAL(t + VMI_H(0.94), z, k11);
    VMI_EACH(i, n)
    z[i] = y[i] +
           h * (VM_C(-3.3016226677470790164) * k1[i] - VM_C(10.141422388456112486) * k5[i] +
                VM_C(9.1393113322320579235) * k6[i] + VM_C(5.3646704686517598018) * k7[i] -
                VM_C(118.01127235975250857) * (k4[i] - k7[i]) + VM_C(4.6232443788745804748) * k8[i] -
                VM_C(3.3832777380682019237) * k9[i] + VM_C(4.5275921003246181895) * k10[i]) -
           VMI_H(5.8284954858116229632) * k11[i];
    VMI_EVAL(t_new, z, k12);
    VMI_EACH(i, n)
    z[i] = y[i] +
           h * (VM_C(-3.03951503376630903) * k1[i] - VM_C(9.2906424974002934497) * k5[i] +
                VM_C(8.4305049817649111421) * k6[i] + VM_C(4.9401329484155058871) * k7[i] -
                VM_C(109.26086808941762547) * (k4[i] - k7[i]) - VM_C(0.96372713421454793582) * k8[i] -
                VM_C(5.0348840888021897912) * k9[i]) +
           VMI_H(5.9581308240029231775) * k10[i];
    VMI_EVAL(t_new, z, k13);
    VMI_EACH(i, n)
    z[i] = y[i] +
           h * (VM_C(0.044279894190079510747) * k1[i] + VM_C(0.35410493917244487448) * k6[i] +
                VM_C(0.24796921549564378287) * k7[i] - VM_C(6.6543028207017138549) * k10[i] +
                VM_C(25.084064965558562613) * (k9[i] - k10[i]) + VM_C(7.2440812351506999013) * k11[i] -
                VM_C(15.694202038838084051) * (k8[i] - k11[i])) -
           VMI_H(0.23613246330715421453) * k12[i];
    return 0;
}
#undef VMI_EVAL
#undef VMI_H

#define VMI_LARGER(a, b) ((a) > (b) ? (a) : (b))
#define VMI_SMALLER(a, b) ((a) < (b) ? (a) : (b))
#define VMI_WORST VM_C(1e4) /* no error is told from a worse one */

/* An error e of component i, whose state goes from y to z: *worst becomes the largest over the tolerance; *bad stays
   0 while all is finite: x - x is 0 or NaN */
VM_INLINE void vmi_weigh(const rk45_options *o, int i, vm_real e, vm_real y, vm_real z, vm_real *worst,
                         vm_real *bad)
{
    vm_real ratio = VM_FABS(e) / vmi_tolerance(o, i, VMI_LARGER(VM_FABS(y), VM_FABS(z)));
    *worst = VMI_LARGER(ratio, *worst);
    e += z;
    *bad += e - e;
}

#endif
