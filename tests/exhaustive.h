/* exhaustive.h - what the double half of the exhaustive float tests offers to the float half */
#ifndef EXHAUSTIVE_H
#define EXHAUSTIVE_H

void reference_sncndn(double m, int n, const double *u, double *sn, double *cn, double *dn);
double reference_K(double m);

#endif
