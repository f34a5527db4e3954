/* jacobi_sncndn and the plan's arrays in float against double, at every float u of a period [0, 4K], or every STRIDE-th.

   usage: exhaustive_jacobi [STRIDE]   1 takes minutes; make exhaustive */
#define VM_USE_FLOAT
#include <stdlib.h>
#include "../jacobi.h"
#include "check.h"
#include "every_float.h"
#include "exhaustive.h"

static jacobi_plan plan; /* of the present case */

static void check_block(const float_case *c, int n, const float *u)
{
    static float sn[BLOCK], cn[BLOCK], dn[BLOCK];
    static double wide[BLOCK], exact_sn[BLOCK], exact_cn[BLOCK], exact_dn[BLOCK];
    const double m = (double)c->parameter, largest_dn = m < 0 ? sqrt(1 - m) : 1;
    int i;
    for (i = 0; i < n; i++) wide[i] = (double)u[i];
    reference_sncndn(m, n, wide, exact_sn, exact_cn, exact_dn);
    for (i = 0; i < n; i++) jacobi_sncndn(u[i], c->parameter, sn + i, cn + i, dn + i);
    check_floats("sn", c, n, u, sn, exact_sn, 1, 0, 8);
    check_floats("cn", c, n, u, cn, exact_cn, 1, 0, 8);
    check_floats("dn", c, n, u, dn, exact_dn, largest_dn, 0, 8);
    jacobi_plan_sncndn_array(&plan, n, u, sn, cn, dn);
    check_floats("sn by plan", c, n, u, sn, exact_sn, 1, 0, 8);
    check_floats("cn by plan", c, n, u, cn, exact_cn, 1, 0, 8);
    check_floats("dn by plan", c, n, u, dn, exact_dn, largest_dn, 0, 8);
}

int main(int argc, char **argv)
{
    static const float_case cases[] = {{"m = 0.3", 0.3f}, {"m = 0.9", 0.9f}, {"m = -5", -5}, {"m = 0.9999", 0.9999f}};
    const unsigned long stride = argc > 1 ? strtoul(argv[1], NULL, 10) : 1;
    size_t k;
    for (k = 0; k < sizeof cases / sizeof *cases; k++) {
        jacobi_plan_init(&plan, cases[k].parameter);
        for_every_float(cases + k, 4 * (float)reference_K((double)cases[k].parameter), stride, check_block);
    }
    return check_finish("exhaustive jacobi.h");
}
