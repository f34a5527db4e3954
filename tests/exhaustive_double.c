/* The double half of the exhaustive float tests: reference values, accurate to a millionth of a float's ulp. */
#include "../jacobi.h"
#include "exhaustive.h"

void reference_sncndn(double m, int n, const double *u, double *sn, double *cn, double *dn)
{
    jacobi_plan plan;
    if (jacobi_plan_init(&plan, m)) return;
    jacobi_plan_sncndn_array(&plan, n, u, sn, cn, dn);
}

double reference_K(double m) { return jacobi_K(m); }
