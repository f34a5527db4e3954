/* ateb.h: time, in units of the C library's sin (float: sinf) in the same run, and the largest error, for alpha from
   0 to 1e4: sa and ca of any alpha, of a prepared one to three accuracies, one by one and as arrays, and, where GSL
   is there (-DWITH_GSL), sa^2 by gsl_cdf_beta_Pinv. The error of the prepared ones and of GSL is taken against
   ateb_saca. Medians of interleaved repeats; arrays are worth their name with -O3 -march=native -fno-math-errno. */
#include "../ateb.h"
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#ifdef WITH_GSL
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>
#endif

#ifdef VM_USE_FLOAT
#define LIBRARY_SIN sinf
#else
#define LIBRARY_SIN sin
#endif

enum { POINTS = 1024, REPEATS = 31, LEVELS = 3, METHODS = 3 + 2 * LEVELS + 1 };

static vm_real s[POINTS], sa[POINTS], ca[POINTS], exact_sa[POINTS], exact_ca[POINTS];
static double times[METHODS][REPEATS], errors[METHODS];

static double now(void) { return (double)clock() / CLOCKS_PER_SEC; }

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void note_error(int method)
{
    int i;
    for (i = 0; i < POINTS; i++) {
        errors[method] = fmax(errors[method], fabs((double)(sa[i] - exact_sa[i])));
        errors[method] = fmax(errors[method], fabs((double)(ca[i] - exact_ca[i])));
    }
}

/* the first quarter only, which is what inversion of the distribution function gives */
static void by_gsl(double alpha)
{
#ifdef WITH_GSL
    const double half = (double)ateb_pi((vm_real)alpha) / 2;
    int i;
    for (i = 0; i < POINTS; i++) {
        const double w = gsl_cdf_beta_Pinv(fmod(fabs((double)s[i]), half) / half, 0.5, 1 / (alpha + 1));
        sa[i] = (vm_real)sqrt(w);
        ca[i] = (vm_real)pow(1 - w, 1 / (alpha + 1));
    }
#else
    (void)alpha;
#endif
}

static void run(int method, vm_real alpha, const ateb_plan *plans)
{
    int i, repeat;
    for (repeat = 0; repeat < (method == METHODS - 1 ? 1 : 20); repeat++) { /* the clock is coarse */
        if (method == 0)
            for (i = 0; i < POINTS; i++) sa[i] = LIBRARY_SIN(s[i]);
        else if (method == 1)
            for (i = 0; i < POINTS; i++) sa[i] = ateb_pi(VM_FABS(s[i]));
        else if (method == 2)
            for (i = 0; i < POINTS; i++) ateb_saca(s[i], alpha, sa + i, ca + i);
        else if (method == METHODS - 1) by_gsl((double)alpha);
        else if (method % 2)
            for (i = 0; i < POINTS; i++) ateb_plan_saca(plans + (method - 3) / 2, s[i], sa + i, ca + i);
        else ateb_plan_saca_array(plans + (method - 3) / 2, POINTS, s, sa, ca);
    }
}

static void bench(double alpha)
{
    static const double accuracies[LEVELS] = {0, 1e-8, 1e-4};
    ateb_plan plans[LEVELS];
    int i, method, repeat;
    for (i = 0; i < LEVELS; i++) ateb_plan_init_to(plans + i, (vm_real)alpha, (vm_real)accuracies[i]);
    for (i = 0; i < POINTS; i++) ateb_saca(s[i], (vm_real)alpha, exact_sa + i, exact_ca + i);
    for (method = 0; method < METHODS; method++) errors[method] = 0;
    for (repeat = 0; repeat < REPEATS; repeat++)
        for (method = 0; method < METHODS; method++) {
            const double start = now();
            run(method, (vm_real)alpha, plans);
            times[method][repeat] = (now() - start) * (method == METHODS - 1 ? 20 : 1);
            if (repeat == 0 && method > 1 && method < METHODS - 1) note_error(method);
        }
    for (method = 0; method < METHODS; method++) qsort(times[method], REPEATS, sizeof(double), compare);
    printf("%-8.4g", alpha);
    for (method = 1; method < METHODS; method++) {
        const double ratio = times[method][REPEATS / 2] / times[0][REPEATS / 2];
        if (method <= 2) printf(" %6.1f", ratio);
        else if (method < METHODS - 1) printf("  %5.2f", ratio);
#ifdef WITH_GSL
        else printf(" %6.0f", ratio);
#endif
        if (method > 2 && method % 2 && method < METHODS - 1) printf(" %7.1e", errors[method]);
    }
    printf("\n");
}

int main(void)
{
    static const double alphas[] = {0, 0.01, 0.1, 1 / 3., 0.5, 1, 1.5, 2, 2.5, 3, 5, 10, 33.3, 100, 1e3, 1e4};
    int i;
#ifdef WITH_GSL
    gsl_set_error_handler_off();
#endif
    for (i = 0; i < POINTS; i++) s[i] = (vm_real)(20 * (double)rand() / RAND_MAX - 10);
    printf("ateb.h, %s: times of sin; |s| < 10; plan of %u bytes: one, its largest error, in an array\n",
           sizeof(vm_real) == 4 ? "float" : "double", (unsigned)sizeof(ateb_plan));
    printf("%-8s %6s %6s  %-20s  %-20s  %-20s %s\n", "alpha", "Pi", "saca", "plan, full", "plan, 1e-8",
           "plan, 1e-4", "GSL");
    for (i = 0; i < (int)(sizeof alphas / sizeof *alphas); i++) bench(alphas[i]);
    return 0;
}
