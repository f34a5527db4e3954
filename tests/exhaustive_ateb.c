/* ateb_saca and the plan's arrays in float against double, at every float s of a period [0, 2 Pi_alpha], or every STRIDE-th.

   usage: exhaustive_ateb [STRIDE]   1 takes minutes; make exhaustive */
#define VM_USE_FLOAT
#include <stdlib.h>
#include "../ateb.h"
#include "check.h"
#include "every_float.h"
#include "exhaustive.h"

/* The relative errors of the zeros: ateb_saca has Pi_alpha in three words, 2^-58, and a plan in two words, 2^-42 */
static const double zeros_error = 3.5e-18, plan_zeros_error = 2.3e-13;

static ateb_plan plan; /* of the present case */

static void check_block(const float_case *c, int n, const float *s)
{
    static float sa[BLOCK], ca[BLOCK];
    static double wide[BLOCK], exact_sa[BLOCK], exact_ca[BLOCK];
    int i;
    for (i = 0; i < n; i++) wide[i] = (double)s[i];
    reference_saca((double)c->parameter, n, wide, exact_sa, exact_ca);
    for (i = 0; i < n; i++) ateb_saca(s[i], c->parameter, sa + i, ca + i);
    check_floats("sa", c, n, s, sa, exact_sa, 1, 2 * zeros_error, 8);
    check_floats("ca", c, n, s, ca, exact_ca, 1, 2 * zeros_error, 8);
    ateb_plan_saca_array(&plan, n, s, sa, ca);
    check_floats("sa by plan", c, n, s, sa, exact_sa, 1, 2 * plan_zeros_error, 2);
    check_floats("ca by plan", c, n, s, ca, exact_ca, 1, 2 * plan_zeros_error, 2);
}

int main(int argc, char **argv)
{
    static const float_case cases[] = {
        {"alpha = 0", 0}, {"alpha = 0.5", 0.5f}, {"alpha = 1.5", 1.5f}, {"alpha = 3", 3}, {"alpha = 33.3", 33.3f}};
    const unsigned long stride = argc > 1 ? strtoul(argv[1], NULL, 10) : 1;
    size_t k;
    for (k = 0; k < sizeof cases / sizeof *cases; k++) {
        ateb_plan_init(&plan, cases[k].parameter);
        for_every_float(cases + k, 2 * ateb_pi(cases[k].parameter), stride, check_block);
    }
    return check_finish("exhaustive ateb.h");
}
