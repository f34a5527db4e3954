/* ateb_saca and ateb_plan_saca in float against double, at every float s from 1/1024 to a period, for each alpha given.
   Prints the worst errors in ulp and eps; the exit status is 1 where they are beyond the promises.

   usage: exhaustive_ateb ALPHA... */
#define VM_USE_FLOAT
#include <stdlib.h>
#include "../ateb.h"
#include "check.h"
#include "exhaustive.h"

/* The relative errors of the zeros: ateb_saca has Pi_alpha in three words, 2^-58, and a plan in two words, 2^-42 */
static const double zeros_error = 3.5e-18, plan_zeros_error = 2.3e-13;

static void compare(const char *function, float got, double exact, double moved, double bound, float s,
                    double alpha)
{
    const double error = fabs((double)got - exact);
    check_error(function, "every s", "eps", error / (double)VM_EPSILON, 4, (double)s, alpha);
    check_error(function, "every s", "ulp", (error - moved) / ULP(exact), bound, (double)s, alpha);
}

int main(int argc, char **argv)
{
    int i;
    for (i = 1; i < argc; i++) {
        const float alpha = (float)atof(argv[i]), period = 2 * ateb_pi(alpha);
        float s, sa, ca;
        ateb_plan plan;
        ateb_plan_init(&plan, alpha);
        for (s = 0.0009765625f; s <= period; s = vmi_from_bits(vmi_to_bits(s) + 1)) {
            const double wide = (double)s, moved = 2 * zeros_error * wide, plan_moved = 2 * plan_zeros_error * wide;
            double exact_sa, exact_ca;
            reference_saca((double)alpha, 1, &wide, &exact_sa, &exact_ca);
            ateb_saca(s, alpha, &sa, &ca);
            compare("sa", sa, exact_sa, moved, 8, s, (double)alpha);
            compare("ca", ca, exact_ca, moved, 8, s, (double)alpha);
            ateb_plan_saca(&plan, s, &sa, &ca);
            compare("plan sa", sa, exact_sa, plan_moved, 2, s, (double)alpha);
            compare("plan ca", ca, exact_ca, plan_moved, 2, s, (double)alpha);
        }
    }
    return check_finish("exhaustive ateb.h");
}
