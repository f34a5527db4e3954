/* exhaustive.h - what the double half of the exhaustive float tests offers to the float halves */
#ifndef EXHAUSTIVE_H
#define EXHAUSTIVE_H

void reference_sncndn(double m, int n, const double *u, double *sn, double *cn, double *dn);
double reference_K(double m);
void reference_saca(double alpha, int n, const double *s, double *sa, double *ca);

#endif
