/* jacobi_sncndn and the plan's arrays in float against double, at every float u of a period [0, 4K], or every STRIDE-th.
   Below 2^-13, where sn = u and cn = dn = 1 to a fraction of an ulp, only at every 61st.

   usage: exhaustive_jacobi [STRIDE]   1 takes minutes; make exhaustive */
#define VM_USE_FLOAT
#include <stdlib.h>
#include "../jacobi.h"
#include "check.h"
#include "exhaustive.h"

enum { BLOCK = 1024 };

static void check_values(const char *region, const char *suffix, const float *got[3], double *exact[3], int n,
                         const float *u, double m)
{
    static const char *const name[2][3] = {{"sn", "cn", "dn"}, {"sn by plan", "cn by plan", "dn by plan"}};
    const double largest[3] = {1, 1, m < 0 ? sqrt(1 - m) : 1};
    int i, k;
    for (k = 0; k < 3; k++) {
        double worst_eps = 0, worst_ulp = 0;
        int at_eps = 0, at_ulp = 0;
        for (i = 0; i < n; i++) {
            const double error = fabs((double)got[k][i] - exact[k][i]), ulp = ULP(exact[k][i]);
            if (!(error <= worst_eps)) {
                worst_eps = error;
                at_eps = i;
            }
            if (!(error / ulp <= worst_ulp)) {
                worst_ulp = error / ulp;
                at_ulp = i;
            }
        }
        check_error(name[*suffix != 0][k], region, "eps", worst_eps / (double)VM_EPSILON / largest[k], 4,
                    (double)u[at_eps], m);
        check_error(name[*suffix != 0][k], region, "ulp", worst_ulp, 8, (double)u[at_ulp], m);
    }
}

static void check_block(const char *region, const jacobi_plan *plan, double m, int n, const float *u)
{
    static float sn[BLOCK], cn[BLOCK], dn[BLOCK];
    static double wide[BLOCK], s[BLOCK], c[BLOCK], d[BLOCK];
    const float *got[3] = {sn, cn, dn};
    double *exact[3] = {s, c, d};
    int i;
    for (i = 0; i < n; i++) wide[i] = (double)u[i];
    reference_sncndn(m, n, wide, s, c, d);
    for (i = 0; i < n; i++) jacobi_sncndn(u[i], (float)m, sn + i, cn + i, dn + i);
    check_values(region, "", got, exact, n, u, m);
    jacobi_plan_sncndn_array(plan, n, u, sn, cn, dn);
    check_values(region, "by plan", got, exact, n, u, m);
}

int main(int argc, char **argv)
{
    static const struct {
        const char *region;
        float m;
    } cases[] = {{"m = 0.3", 0.3f}, {"m = 0.9", 0.9f}, {"m = -5", -5}, {"m = 0.9999", 0.9999f}};
    const unsigned long stride = argc > 1 ? strtoul(argv[1], NULL, 10) : 1;
    size_t k;
    for (k = 0; k < sizeof cases / sizeof *cases; k++) {
        const float last = 4 * (float)reference_K((double)cases[k].m);
        static float u[BLOCK];
        vmi_bits bits;
        jacobi_plan plan;
        int n = 0;
        jacobi_plan_init(&plan, cases[k].m);
        for (bits = 0; bits <= vmi_to_bits(last); bits += (vmi_bits)stride) { /* positive floats in their order */
            u[n++] = vmi_from_bits(bits);
            if (u[n - 1] < 1.220703125e-4f) bits += 60 * (vmi_bits)stride;
            if (n == BLOCK) {
                check_block(cases[k].region, &plan, (double)cases[k].m, n, u);
                n = 0;
            }
        }
        check_block(cases[k].region, &plan, (double)cases[k].m, n, u);
    }
    return check_finish("exhaustive jacobi.h");
}
