/* integrators/rk87.h - rk87: adaptive runs by a Runge-Kutta pair of orders 8 and 7
   Verner's "most efficient" pair [4] has 13 stages. Its continuous extension of order 8, which gives the states inside
   a step, takes seven more evaluations of f in each step in which it is used. The coefficients of the pair are up to
   123, so that its rounding errors are larger than those of rk45. Use rk87 for a smooth f in double, where the errors
   must be small.

   Tests: tests/gen/order_conditions.py, tests/test_adaptive.c, tests/test_dense.c. */
#ifndef VARMASS_INTEGRATORS_RK87_H
#define VARMASS_INTEGRATORS_RK87_H

#include "../base/arrays.h"
#include "../base/real.h"
#include "dense.h"
#include "loop.h"
#include "ode.h"
#include "options.h"
#include "pairs.h"
#include "runs.h"

enum { VMI_RK87 = 87 }; /* the value of the field `method` for this pair, rk87 */

/* Computes stages 2 to 7 of a step of Verner's pair [4]. Returns 0, or the number with which f has stopped the run. */
VMI_FOLDED int vmi_rk87_early_stages(vmi_rk_system sys, vm_real t, vm_real h, long *evals)
{
    const ptrdiff_t m = sys.m;
    const vm_real *y = sys.w + VMI_Y * m;
    vm_real *z = sys.w + VMI_Z * m, *k1 = sys.w + VMI_K * m, *k2 = k1 + m, *k3 = k2 + m, *k4 = k3 + m, *k5 = k4 + m,
            *k6 = k5 + m, *k7 = k6 + m;
    int i;
    VMI_EACH(i, sys.n) z[i] = y[i] + VMI_H(0.05) * k1[i];
    VMI_EVAL(t + VMI_H(0.05), z, k2);
    VMI_EACH(i, sys.n) z[i] = y[i] - VMI_H(0.0069931640625) * k1[i] + VMI_H(0.1135556640625) * k2[i];
    VMI_EVAL(t + VMI_H(0.1065625), z, k3);
    VMI_EACH(i, sys.n) z[i] = y[i] + VMI_H(0.0399609375) * k1[i] + VMI_H(0.1198828125) * k3[i];
    VMI_EVAL(t + VMI_H(0.15984375), z, k4);
    VMI_EACH(i, sys.n)
    z[i] = y[i] + h * (VM_C(0.36139756280045751241) * k1[i] - VM_C(1.3415240667004927718) * k3[i]) +
           VMI_H(1.3701265039000352594) * k4[i];
    VMI_EVAL(t + VMI_H(0.39), z, k5);
    VMI_EACH(i, sys.n)
    z[i] = y[i] + h * (VM_C(0.049047202797202797203) * k1[i] + VM_C(0.23509720422144047399) * k4[i]) +
           VMI_H(0.18085559298135672881) * k5[i];
    VMI_EVAL(t + VMI_H(0.465), z, k6);
    VMI_EACH(i, sys.n)
    z[i] = y[i] +
           h * (VM_C(0.06169289044289044289) * k1[i] + VM_C(0.11236568314640276623) * k4[i] -
                VM_C(0.03885046071451366767) * k5[i]) +
           VMI_H(0.019791887125220458554) * k6[i];
    VMI_EVAL(t + VMI_H(0.155), z, k7);
    return 0;
}

/* Computes stages 8 to 13 of a step of Verner's pair [4], and the new state, whose derivative is evaluated only after
   the step is accepted. Some large coefficients, which have opposite signs, belong to derivatives k at nearly equal
   times, such as k_4 and k_7. Therefore the sums use the differences of these derivatives. The difference of two
   nearly equal numbers has no rounding error, so that the rounding errors of the sums are small. Returns 0, or the
   number with which f has stopped the run. */
VMI_FOLDED int vmi_rk87_late_stages(vmi_rk_system sys, vm_real t, vm_real t_new, vm_real h, long *evals)
{
    const ptrdiff_t m = sys.m;
    const vm_real *y = sys.w + VMI_Y * m;
    vm_real *z = sys.w + VMI_Z * m, *k1 = sys.w + VMI_K * m, *k4 = k1 + 3 * m, *k5 = k4 + m, *k6 = k5 + m, *k7 = k6 + m,
            *k8 = k7 + m, *k9 = k8 + m, *k10 = k9 + m, *k11 = k10 + m, *k12 = k11 + m, *k13 = k12 + m;
    int i;
    VMI_EACH(i, sys.n)
    z[i] = y[i] +
           h * (VM_C(-1.7676302402223268757) * k1[i] - VM_C(6.0618893773766691008) * k5[i] +
                VM_C(5.6508231982227631386) * k6[i] + VM_C(3.121696419376232838) * k7[i]) -
           VMI_H(62.5) * (k4[i] - k7[i]);
    VMI_EVAL(t + VMI_H(0.943), z, k8);
    VMI_EACH(i, sys.n)
    z[i] = y[i] +
           h * (VM_C(-1.1809450665549707998) * k1[i] - VM_C(4.4344383191037250112) * k5[i] +
                VM_C(4.2604081885861330248) * k6[i] + VM_C(2.2489058133185074338) * k7[i] -
                VM_C(41.504734411143208416) * (k4[i] - k7[i])) +
           VMI_H(0.0078714254899123106874) * k8[i];
    VMI_EVAL(t + VMI_H(0.90180204173585695826), z, k9);
    VMI_EACH(i, sys.n)
    z[i] = y[i] +
           h * (VM_C(-1.2814059994414884055) * k1[i] - VM_C(4.7313620694495764773) * k5[i] +
                VM_C(4.5149670165938078412) * k6[i] + VM_C(2.4019556115899850465) * k7[i] -
                VM_C(45.047139960139866302) * (k4[i] - k7[i]) + VM_C(0.010592282971116611357) * k8[i]) -
           VMI_H(0.0057468422638446162544) * k9[i];
    VMI_EVAL(t + VMI_H(0.909), z, k10);
    VMI_EACH(i, sys.n)
    z[i] = y[i] +
           h * (VM_C(-1.7244701342624851918) * k1[i] - VM_C(5.9515183762223924552) * k5[i] +
                VM_C(5.556523730698456236) * k6[i] + VM_C(3.0595218955025132032) * k7[i] -
                VM_C(60.923490084830540165) * (k4[i] - k7[i]) + VM_C(0.014642028250414961593) * k8[i] +
                VM_C(0.064604087723582036036) * k9[i]) -
           VMI_H(0.07930323169008878984) * k10[i];
    VMI_EVAL(t + VMI_H(0.94), z, k11);
    VMI_EACH(i, sys.n)
    z[i] = y[i] +
           h * (VM_C(-3.3016226677470790164) * k1[i] - VM_C(10.141422388456112486) * k5[i] +
                VM_C(9.1393113322320579235) * k6[i] + VM_C(5.3646704686517598018) * k7[i] -
                VM_C(118.01127235975250857) * (k4[i] - k7[i]) + VM_C(4.6232443788745804748) * k8[i] -
                VM_C(3.3832777380682019237) * k9[i] + VM_C(4.5275921003246181895) * k10[i]) -
           VMI_H(5.8284954858116229632) * k11[i];
    VMI_EVAL(t_new, z, k12);
    VMI_EACH(i, sys.n)
    z[i] = y[i] +
           h * (VM_C(-3.03951503376630903) * k1[i] - VM_C(9.2906424974002934497) * k5[i] +
                VM_C(8.4305049817649111421) * k6[i] + VM_C(4.9401329484155058871) * k7[i] -
                VM_C(109.26086808941762547) * (k4[i] - k7[i]) - VM_C(0.96372713421454793582) * k8[i] -
                VM_C(5.0348840888021897912) * k9[i]) +
           VMI_H(5.9581308240029231775) * k10[i];
    VMI_EVAL(t_new, z, k13);
    VMI_EACH(i, sys.n)
    z[i] = y[i] +
           h * (VM_C(0.044279894190079510747) * k1[i] + VM_C(0.35410493917244487448) * k6[i] +
                VM_C(0.24796921549564378287) * k7[i] - VM_C(6.6543028207017138549) * k10[i] +
                VM_C(25.084064965558562613) * (k9[i] - k10[i]) + VM_C(7.2440812351506999013) * k11[i] -
                VM_C(15.694202038838084051) * (k8[i] - k11[i])) -
           VMI_H(0.23613246330715421453) * k12[i];
    return 0;
}

/* Computes stages 2 to 13 and the new state of a step */
VMI_FOLDED int vmi_rk87_stages(vmi_rk_system sys, vm_real t, vm_real t_new, vm_real h, long *evals)
{
    const int stopped = vmi_rk87_early_stages(sys, t, h, evals);
    if (stopped) return stopped;
    return vmi_rk87_late_stages(sys, t, t_new, h, evals);
}

/* Estimates the error that a jump of f inside a step of size 1 causes in a component whose derivatives are k1 ... k13.
   This error is up to a quarter of the jump. The difference of the results of orders 8 and 7 is nearly the same with
   and without a jump in the first nine tenths of the step: in this difference the weights of the k before the jump add
   up to 4.2e-4 at most. `seen` is the magnitude of another sum of the k, of order 5. In this sum the weights of the k
   before the jump add up in magnitude to
     0.11 for a jump before 0.155 of the step (only k1 is before it), 0.17 for a jump between 0.155 and 0.465 (k1 and
     k7 are before it), 0.25 for a jump between 0.465 and 0.9 (k1, k7 and k6 are before it).
   If f is smooth, `seen` is much smaller than `change`, the change of f along the step. The returned value
   seen^2/(seen + change) is then of order 9. It is smaller than the difference of the results of orders 8 and 7,
   unless the tolerance is loose. */
VM_INLINE vm_real vmi_rk87_jump(vm_real k1, vm_real k6, vm_real k7, vm_real k9, vm_real k10, vm_real k13)
{
    const vm_real seen = VM_FABS(VM_C(-0.10566347241843193175) * (k1 - k6) + VM_C(0.27305974723615654296) * (k7 - k6) -
                                 VM_C(1.2953622033829957737) * (k10 - k6) + VM_C(1.5453622033829957737) * (k13 - k6) +
                                 VM_C(30.024202087387960709) * (k9 - k10));
    const vm_real change = VM_FABS(k1 - k6) + VM_FABS(k13 - k6);
    return seen * (seen / (seen + change + VM_MIN));
}

/* Returns the largest ratio of the error of a component to its tolerance, at most VMI_WORST, or NaN if the error or the
   new state is not finite. The error is the larger of two numbers: the difference of the new states of orders 8 and 7,
   and the error that a jump of f may cause (vmi_rk87_jump). */
VMI_FOLDED vm_real vmi_rk87_error(const rk45_options *o, vmi_rk_system sys, vm_real h)
{
    const ptrdiff_t m = sys.m;
    const vm_real *y = sys.w + VMI_Y * m, *z = sys.w + VMI_Z * m, *k1 = sys.w + VMI_K * m;
    const vm_real *k6 = k1 + 5 * m, *k7 = k6 + m, *k8 = k7 + m, *k9 = k8 + m, *k10 = k9 + m, *k11 = k10 + m,
                  *k12 = k11 + m, *k13 = k12 + m;
    vm_real worst = 0, bad = 0;
    int i;
    VMI_EACH(i, sys.n)
    {
        const vm_real smooth = VM_C(-0.000032721039010281377697) * k1[i] - VM_C(0.00050462506187777030476) * k6[i] +
                               VM_C(0.00012117235897847590476) * k7[i] - VM_C(20.142336771313868544) * k8[i] +
                               VM_C(5.2371785994398289141) * k9[i] - VM_C(8.1567444087946580486) * k10[i] +
                               VM_C(22.938283273988783952) * k11[i] - VM_C(0.23613246330715421453) * k12[i] +
                               VM_C(0.36016794372897751621) * k13[i];
        const vm_real jump = vmi_rk87_jump(k1[i], k6[i], k7[i], k9[i], k10[i], k13[i]);
        vmi_weigh(o, i, h * (jump > VM_FABS(smooth) ? jump : smooth), y[i], z[i], &worst, &bad);
    }
    return VMI_SMALLER(worst, VMI_WORST) + bad;
}

/* Returns, for the test of stiffness, the factor of k_{j+1} in the new state minus its factor in the state of stage 13.
   The run evaluates f for both states at the end of the step. */
VM_API vm_real vmi_rk87_end_difference(int j)
{
    VM_TABLE vm_real weights[13] = {VM_C(3.0837949279563885408),
                                    0,
                                    0,
                                    VM_C(109.26086808941762547),
                                    VM_C(9.2906424974002934497),
                                    VM_C(-8.0764000425924662677),
                                    VM_C(-113.95303182233748757),
                                    VM_C(-14.730474904623536115),
                                    VM_C(30.118949054360752405),
                                    VM_C(-37.696498610263199646),
                                    VM_C(22.938283273988783952),
                                    VM_C(-0.23613246330715421453),
                                    0};
    return VM_READ(weights[j]);
}

/* The number of k_i that a step itself computes, and the number that the continuous extension adds */
#define VMI_RK87_OWN 14
#define VMI_RK87_EXTRA 7

/* Returns the coefficient of k_{j+1} in the stage of the continuous extension that evaluates k_{15+stage}. */
VM_API vm_real vmi_rk87_extra_coefficient(int stage, int j)
{
    VM_TABLE vm_real a[7][20] = {
        {VM_C(0.046207006467549631017), 0, 0, 0, 0, VM_C(0.045039041608424808668), VM_C(0.23368166977134244108),
         VM_C(37.839013684210674108), VM_C(-15.949113289454246103), VM_C(23.028368351816102851),
         VM_C(-44.855785077694125248), VM_C(-0.063798587686474440095), 0, VM_C(-0.012595035543861662682)},
        {VM_C(0.050379468554820409931), 0, 0, 0, 0, VM_C(0.041098361310460793399), VM_C(0.17180541533481957833),
         VM_C(4.6141053199815188697), VM_C(-1.7916678830853964497), VM_C(2.5316589304850414085),
         VM_C(-5.3249778602057307193), VM_C(-0.030655325953856347349), 0, VM_C(-0.0052544799794296135705),
         VM_C(-0.083991946442247929975)},
        {VM_C(0.040828971329970796202), 0, 0, 0, 0, VM_C(0.42444795142476322189), VM_C(0.23260915312752345395),
         VM_C(2.6779825207118060628), VM_C(0.74208266573389452165), VM_C(0.14603778479414611939),
         VM_C(-3.579344509890565218), VM_C(0.11388443896001737045), 0, VM_C(0.012677906510331900474),
         VM_C(-0.074434363499466744298), VM_C(0.047827480797578515546)},
        {VM_C(0.052126823936684136299), 0, 0, 0, 0, VM_C(0.053925083967447977182), VM_C(0.016607580974346408285),
         VM_C(-4.4544857579267796554), VM_C(6.8352182786321463817), VM_C(-8.7113348221819937398),
         VM_C(6.4916358392329170537), VM_C(-0.070725518098443464221), 0, VM_C(-0.018540314919932164291),
         VM_C(0.023504021054353846451), VM_C(0.23447951034078220906), VM_C(-0.082410725011528988858)},
        {VM_C(0.050201028703557135987), 0, 0, 0, 0, VM_C(0.15522090347954981149), VM_C(0.12642684240892349147),
         VM_C(-5.149206303539847017), VM_C(8.4683409990369292661), VM_C(-10.662130681081495275),
         VM_C(7.5418332249597283629), VM_C(-0.074369681138321424394), 0, VM_C(-0.020558876866183826193),
         VM_C(0.077537952647102980726), VM_C(0.10462592203525442963), VM_C(-0.11792133064519793521)},
        {VM_C(0.037373414464578256928), 0, 0, 0, 0, VM_C(0.35049307053383164068), VM_C(0.49226528193730254333),
         VM_C(8.5536954393593122423), VM_C(-10.353172990305913485), VM_C(13.833204272529149904),
         VM_C(-12.280924330784618637), VM_C(0.17191515956565097627), 0, VM_C(0.036415831143144963801),
         VM_C(0.029619205802887630549), VM_C(-0.26517939386270670026), VM_C(0.094295039617380665532)},
        {VM_C(0.039390583455282509434), 0, 0, 0, 0, VM_C(0.35585161412344241831), VM_C(0.41973822259526100294),
         VM_C(0.87204497780719416629), VM_C(0.89895208348765948613), VM_C(-0.63058061610598835902),
         VM_C(-1.1218872205954835507), VM_C(0.04298219512400197177), 0, VM_C(0.01332557566873915707),
         VM_C(0.018762270539641480344), VM_C(-0.18594111329221055705), VM_C(0.17736142719246027452)}};
    return VM_READ(a[stage][j]);
}

/* Evaluates the seven further stages that the continuous extension of order 8 needs. If the derivative at the end of
   the step is not finite, it is evaluated again first. Returns a status. If one of these stages lies outside the
   domain of f, the status is ODE_NOT_FINITE; this may happen even if all stages of the step itself lie inside the
   domain. */
VM_API int vmi_rk87_extend(rk45 *s)
{
    VM_TABLE vm_real c[7] = {
        VM_C(0.31101776349538638639), VM_C(0.1725), VM_C(0.7846), VM_C(0.37), VM_C(0.5), VM_C(0.7), VM_C(0.9)};
    const vm_real *k1 = vmi_part(s, VMI_K), *y_old = vmi_part(s, VMI_Y_OLD);
    vm_real *z = vmi_part(s, VMI_Z), *last_k = vmi_part(s, vmi_last_k(&s->pair));
    int i, j, stage, status = ODE_OK;
    if (!vmi_all_finite(s->n, last_k)) status = vmi_eval(s, s->t, s->y, last_k);
    if (status) return status;
    if (!vmi_all_finite(s->n, last_k)) return ODE_NOT_FINITE;
    for (stage = 0; stage < VMI_RK87_EXTRA; stage++) {
        vm_real *k = vmi_part(s, VMI_K + VMI_RK87_OWN + stage);
        for (i = 0; i < s->n; i++) {
            vm_real sum = 0;
            for (j = 1; j < VMI_RK87_OWN + stage; j++)
                sum += vmi_rk87_extra_coefficient(stage, j) * (vmi_part(s, VMI_K + j)[i] - k1[i]);
            z[i] = y_old[i] + s->h_done * (VM_READ(c[stage]) * k1[i] + sum);
        }
        status = vmi_eval(s, s->t_old + VM_READ(c[stage]) * s->h_done, z, k);
        if (status) return status;
        if (!vmi_all_finite(s->n, k)) return ODE_NOT_FINITE;
    }
    return ODE_OK;
}

/* Returns coefficient i of the polynomial b_{j+1}(x)/x, if this polynomial is written as a sum of Bernstein's
   polynomials of degree 7. b_{j+1}(x) is the weight of k_{j+1} in the continuous extension. In powers of x the
   coefficients would be larger [4]. */
VM_API vm_real vmi_rk87_bernstein(int i, int j)
{
    VM_TABLE vm_real c[8][21] = {
        {VM_C(1.0)},
        {VM_C(-0.43416495007921699754), 0, 0, 0, 0, VM_C(22.599667701739659115), VM_C(15.825878858282545737),
         VM_C(-1001.6345768873305842), VM_C(1600.9139385497353343), VM_C(-2025.6045200650977012),
         VM_C(1463.9659668459635268), VM_C(-15.07043425264423982), 0, VM_C(-2.1233733390382044607),
         VM_C(2.0499551075579231761), VM_C(-14.649321001586286937), VM_C(-5.4474375904092477119),
         VM_C(-9.4832565472422686612), VM_C(-12.916982247390083982), VM_C(-8.5341205186269588664),
         VM_C(-8.4572196638341962641)},
        {VM_C(0.69319890739505714536), 0, 0, 0, 0, VM_C(-28.322636845067825264), VM_C(-19.833504880369087028),
         VM_C(1255.2809513415663983), VM_C(-2006.3172919246540112), VM_C(2538.5533084238865914),
         VM_C(-1834.6896502962782204), VM_C(18.886757189012005795), 0, VM_C(2.6943768290163844672),
         VM_C(-3.0569914252730377376), VM_C(21.845770438002692514), VM_C(8.1234803348592602041),
         VM_C(9.4063330192350021072), VM_C(18.54462542925865921), VM_C(8.8787596622304847795),
         VM_C(10.312513797179645635)},
        {VM_C(-0.3338485911070980487), 0, 0, 0, 0, VM_C(25.558764868971263012), VM_C(17.898047082901598187),
         VM_C(-1132.7840290910181075), VM_C(1810.5302905715595678), VM_C(-2290.8279152212470487),
         VM_C(1655.6509775545015219), VM_C(-17.043688014358484614), 0, VM_C(-2.3369125341274148978),
         VM_C(2.6643387606508049922), VM_C(-19.039809026959079785), VM_C(-7.0800668096793834609),
         VM_C(-5.8665758746530908169), VM_C(-18.840844904715375167), VM_C(-7.4879415981794647994),
         VM_C(-9.6607871725402081249)},
        {VM_C(0.28379400641185437856), 0, 0, 0, 0, VM_C(-12.759481686923881245), VM_C(-8.9350876365402469061),
         VM_C(565.50999817576301139), VM_C(-903.85541729421673952), VM_C(1143.6302568613132692),
         VM_C(-826.5363540196210053), VM_C(8.5085733294123855395), 0, VM_C(1.0603712833693789051),
         VM_C(-1.4442533272143088419), VM_C(10.320875086467535406), VM_C(3.837879100734673622),
         VM_C(2.5580949193757614888), VM_C(11.224293673899100669), VM_C(2.4797359224550151757),
         VM_C(5.1167216053141960113)},
        {VM_C(0.0072914402964293461022), 0, 0, 0, 0, VM_C(3.7687355910342448606), VM_C(2.6391340660294149651),
         VM_C(-167.03324707890411572), VM_C(266.9694713223930137), VM_C(-337.79115467001014473),
         VM_C(244.13193663420704719), VM_C(-2.5131556220142955157), 0, VM_C(-0.17281686321712024563),
         VM_C(0.3583670958947128915), VM_C(-2.5609510202503622271), VM_C(-0.95230494665234715357),
         VM_C(-0.5896647722763897408), VM_C(-2.8631165722737584704), VM_C(-0.47177361047292321216),
         VM_C(-1.9267509937834059465)},
        {VM_C(0.050605593360090869425), 0, 0, 0, 0, VM_C(0.40469135905422271369), VM_C(0.28339338913787860899),
         VM_C(-17.936230901529238915), VM_C(28.667502817781214415), VM_C(-36.272420327154601678),
         VM_C(26.215180884558610231), VM_C(-0.26986567235103338803), 0, VM_C(-0.14285714285714285714)},
        {VM_C(0.044279894190079510747), 0, 0, 0, 0, VM_C(0.35410493917244487448), VM_C(0.24796921549564378287),
         VM_C(-15.694202038838084051), VM_C(25.084064965558562613), VM_C(-31.738367786260276468),
         VM_C(22.938283273988783952), VM_C(-0.23613246330715421453)}};
    return VM_READ(c[i][j]);
}

/* Computes the weights b[0], b[1] ... of k_1, k_2 ... in Verner's continuous extension [4], which has order 8, at the
   fraction x of the step */
VM_API void vmi_rk87_weights(vm_real x, vm_real *b)
{
    VM_TABLE vm_real binomial[8] = {1, 7, 21, 35, 35, 21, 7, 1};
    const int count = VMI_RK87_OWN + VMI_RK87_EXTRA;
    const vm_real u = 1 - x;
    vm_real powers[8], power = x; /* powers[i] is (1 - x)^i, and power is x^(i + 1) */
    int i, j;
    powers[0] = 1;
    for (i = 1; i < 8; i++) powers[i] = powers[i - 1] * u;
    for (j = 0; j < count; j++) b[j] = 0;
    for (i = 0; i < 8; i++) {
        const vm_real bernstein = VM_READ(binomial[i]) * power * powers[7 - i];
        for (j = 0; j < count; j++) b[j] += bernstein * vmi_rk87_bernstein(i, j);
        power *= x;
    }
}

/* Computes the state y at the fraction x of the last step by the continuous extension. The function is not inlined, so
   that the compiler fuses its multiplications and additions in one way only: equal x give equal y. */
VMI_APART void vmi_rk87_inside(const rk45 *s, vm_real x, vm_real *y)
{
    vm_real b[VMI_RK87_OWN + VMI_RK87_EXTRA];
    vmi_rk87_weights(x, b);
    vmi_weigh_inside(s, VMI_RK87_OWN + VMI_RK87_EXTRA, b, x, y);
}

/* Returns the descriptor of rk87: its vmi_rk_pair. */
VMI_FOLDED vmi_rk_pair vmi_rk87_pair(void)
{
    vmi_rk_pair pair;
    pair.method = VMI_RK87;
    pair.order = 8;
    pair.stages = 13;
    pair.last_is_first = 0;
    pair.derivatives = VMI_RK87_OWN + VMI_RK87_EXTRA;
    pair.rounding = 256;
    pair.keep_from = VM_C(0.1);
    pair.stiff_beyond = VM_C(5.69);
    pair.end_difference = vmi_rk87_end_difference;
    pair.inside = vmi_rk87_inside;
    pair.extend = vmi_rk87_extend;
    return pair;
}

/* Makes steps of rk87 to t_end, or only one if `single` is not 0. f and n are those of s. Returns a status. */
VMI_LOOP int vmi_rk87_run(rk45 *s, ode_rhs f, int n, vm_real t_end, int single)
{
    vmi_rk_stepper stepper;
    stepper.pair = vmi_rk87_pair();
    stepper.make_stages = vmi_rk87_stages;
    stepper.step_error = vmi_rk87_error;
    return vmi_run(s, stepper, f, n, t_end, single);
}

/* -- Functions for users -- */

#define RK87_WORK(n) (24 * (n)) /* number of elements of the array work for n components */

/* A run by rk87 has the options and the fields of a run by rk45, with the same meanings. */
typedef rk45_options rk87_options;
typedef rk45 rk87;

/* Begins a run of y' = f(t, y) by rk87, as rk45_init begins one by rk45. work has RK87_WORK(n) numbers, and rtol
   becomes at least 256 VM_EPSILON. */
VM_INLINE int rk87_init(rk87 *s, ode_rhs f, void *ctx, int n, vm_real t0, const vm_real *y0,
                        const rk87_options *options_or_NULL, vm_real *work)
{
    return vmi_ode_init(s, vmi_rk87_pair(), f, ctx, n, t0, y0, options_or_NULL, work);
}

/* Continues a run of rk87 from another time or state, such as after a jump. All else is as in rk45_restart. */
VM_API int rk87_restart(rk87 *s, vm_real t, const vm_real *y) { return vmi_restart(s, t, y); }

/* Makes one accepted step of rk87, or the part of it before an event that ends the step. All else is as in
   rk45_step. */
VM_INLINE int rk87_step(rk87 *s)
{
    vm_real t_end;
    const int status = vmi_begin_step(s, VMI_RK87, &t_end);
    if (status) return status;
    return vmi_rk87_run(s, s->f, s->n, t_end, 1);
}

/* Makes steps of rk87 to t_end. The caller gives f and n once more, so that the compiler can inline f. All else is as
   in rk45_solve_with. */
VM_INLINE int rk87_solve_with(rk87 *s, ode_rhs f, int n, vm_real t_end)
{
    const int status = vmi_begin_solve(s, VMI_RK87, f, n, t_end);
    if (status) return status;
    return vmi_end_solve(t_end, vmi_rk87_run(s, f, n, vmi_last_time(t_end), 0));
}

/* Makes steps of rk87 to t_end exactly, forward or backward, or to an event that ends the run. All else is as in
   rk45_solve. */
VM_INLINE int rk87_solve(rk87 *s, vm_real t_end)
{
    if (!s) return ODE_BAD_ARGUMENT;
    return rk87_solve_with(s, s->f, s->n, t_end);
}

/* Computes the state y(t) at a time t within the last step of rk87, accurate to order 8. y receives n numbers. The
   first call after a step evaluates f seven times, unless t is s->t or the run has events: then the search for events
   has made these evaluations. Returns ODE_BAD_ARGUMENT if t is not between s->t_old and s->t. In these evaluations f
   may also stop the run (then the status is ODE_RHS_STOPPED) or give a number that is not finite (ODE_NOT_FINITE),
   although the step itself has succeeded. */
VM_API int rk87_interpolate(rk87 *s, vm_real t, vm_real *y)
{
    if (!s || s->pair.method != VMI_RK87) return ODE_BAD_ARGUMENT;
    return vmi_interpolate(s, t, y);
}

#endif
