/* The double half of the exhaustive test of float (exhaustive_float.c is the other): the reference. */
#include "../ateb.h"

void reference_init(double alpha);
void reference_saca(double s, double *sa, double *ca);

static ateb_plan plan;

void reference_init(double alpha) { ateb_plan_init(&plan, alpha); }
void reference_saca(double s, double *sa, double *ca) { ateb_plan_saca(&plan, s, sa, ca); }
