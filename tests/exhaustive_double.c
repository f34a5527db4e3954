/* The double half of the exhaustive float tests: reference values, accurate to a millionth of a float's ulp. */
#define VM_MIXED_PRECISIONS /* the test itself is in float */
#include "../ateb.h"
#include "../jacobi.h"
#include "exhaustive.h"

void reference_sncndn(double m, int n, const double *u, double *sn, double *cn, double *dn)
{
    jacobi_plan plan;
    if (jacobi_plan_init(&plan, m)) return;
    jacobi_plan_sncndn_array(&plan, n, u, sn, cn, dn);
}

double reference_K(double m) { return jacobi_K(m); }

void reference_saca(double alpha, int n, const double *s, double *sa, double *ca)
{
    static ateb_plan plan;
    static double prepared = -1;
    if (alpha != prepared && ateb_plan_init(&plan, alpha)) return;
    prepared = alpha;
    ateb_plan_saca_array(&plan, n, s, sa, ca);
}
