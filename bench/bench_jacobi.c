/* What jacobi.h costs. First table: the time of a call, and its ratio to that of the C library's sin (float: sinf) in
   the same run, for independent arguments (throughput) and where each argument waits for the result before (latency,
   beside sin in a chain of the same kind). Second table: error beside time by the AGM, step by step, and beside it by
   theta functions. With -DWITH_GSL, linked with -lgsl -lgslcblas, also GSL's functions.
   usage: bench_jacobi [CSV] */
#include "timing.h"
#include <stdio.h>
#include <unistd.h>
#include "../jacobi.h"
#if defined(WITH_GSL) && !defined(VM_USE_FLOAT)
#include <gsl/gsl_sf.h>
#define GSL 1
#else
#define GSL 0
#endif

enum { COUNT = 2048 };
static vm_real angle[COUNT], arg[COUNT], parameter[COUNT];
static vm_real sn_out[COUNT], cn_out[COUNT], dn_out[COUNT];
static jacobi_plan plan;
static int steps;
static volatile vm_real sink;
static FILE *csv;

/* ---- Measuring ---- */

static vm_real random_number(void) /* 0 <= x < 1 */
{
    static unsigned long state = 1;
    state = (state * 1664525ul + 1013904223ul) & 0xfffffffful;
    return (vm_real)(state >> 8) / 16777216;
}

/* Parameters between low and high, and arguments between +-size, or where size = 0 between +-quarters K(m) */
static void fill(vm_real size, vm_real quarters, vm_real low, vm_real high)
{
    int i;
    for (i = 0; i < COUNT; i++) {
        parameter[i] = low + (high - low) * random_number();
        arg[i] = (2 * random_number() - 1) * (size > 0 ? size : quarters * jacobi_K(parameter[i]));
    }
}

/* Twice the loop over all arguments: over independent ones, and with the result before, times 0, in each argument */
#define BODY(name, ...)                                                           \
    static void name##_apart(void)                                                \
    {                                                                             \
        vm_real sum = 0, a = 0, b = 0, c = 0;                                     \
        int i;                                                                    \
        for (i = 0; i < COUNT; i++) {                                             \
            const vm_real x = angle[i], u = arg[i], m = parameter[i];             \
            (void)x, (void)u, (void)m;                                            \
            __VA_ARGS__;                                                          \
            sum += a + b + c;                                                     \
        }                                                                         \
        sink = sum;                                                               \
    }                                                                             \
    static void name##_chain(void)                                                \
    {                                                                             \
        vm_real z = 0, a = 0, b = 0, c = 0;                                       \
        int i;                                                                    \
        for (i = 0; i < COUNT; i++) {                                             \
            const vm_real x = angle[i] + z, u = arg[i] + z, m = parameter[i] + z; \
            (void)x, (void)u, (void)m;                                            \
            __VA_ARGS__;                                                          \
            z = 0 * (a + b + c);                                                  \
        }                                                                         \
        sink = z;                                                                 \
    }
BODY(sin, a = VM_LIBM(sin)(x))
BODY(K, a = jacobi_K(m))
BODY(E, a = jacobi_E(m))
BODY(sncndn, jacobi_sncndn(u, m, &a, &b, &c))
BODY(plan, jacobi_plan_sncndn(&plan, u, &a, &b, &c))
BODY(am, a = jacobi_am(u, m))
BODY(solve, a = jacobi_solve_kpK(m))
BODY(means, jacobi_cn_means(m, &a, &b, &c))
BODY(agm, jacobi_agm_sncndn(u, m, steps, &a, &b, &c))
#if GSL
BODY(gsl_elljac, gsl_sf_elljac_e(u, m, &a, &b, &c))
BODY(gsl_K, a = gsl_sf_ellint_Kcomp(m, GSL_PREC_DOUBLE))
#endif

static void array(void)
{
    static int k;
    jacobi_plan_sncndn_array(&plan, COUNT, arg, sn_out, cn_out, dn_out);
    k = (k + 1) % COUNT;
    sink = sn_out[k] + cn_out[k] + dn_out[k];
}

static void progress(const char *what)
{
    if (isatty(2)) fprintf(stderr, "\r%-70s\r", what);
}

/* Time of a call, beside sin, as two columns and as a line of the CSV; error < 0 where none is measured */
static timing print_time(const char *function, const char *arguments, int chained, void (*body)(void), double error)
{
    const timing t = time_beside(body, COUNT, chained ? sin_chain : sin_apart, COUNT);
    printf(" %9.1f %6.2f", t.ns, t.ratio);
    if (!csv) return t;
    fprintf(csv, "\"%s\",\"%s\",%s,%.2f,%.3f,", function, arguments, chained ? "latency" : "throughput", t.ns,
            t.ratio);
    if (error >= 0) fprintf(csv, "%.3g", error);
    fputc('\n', csv);
    return t;
}

/* ---- First table ---- */

/* chain is NULL where the results come all at once */
static void print_function(const char *function, const char *arguments, void (*apart)(void), void (*chain)(void))
{
    progress(function);
    printf("%-24s %-30s", function, arguments);
    print_time(function, arguments, 0, apart, -1);
    if (chain) print_time(function, arguments, 1, chain, -1);
    putchar('\n');
}

static void print_sncndn(void)
{
    static const vm_real range[4][2] = {{0, VM_C(0.5)}, {VM_C(0.5), 1}, {-1, 0}, {-30, -1}};
    const vm_real far = sizeof(vm_real) == sizeof(float) ? VM_C(1e4) : VM_C(1e9);
    const struct {
        const char *label;
        vm_real size, quarters;
    } reach[3] = {
        {"|u| < K/2", 0, VM_C(0.5)}, {"|u| < 2K", 0, 2}, {far > VM_C(1e5) ? "|u| < 1e9" : "|u| < 1e4", far, 0}};
    char arguments[40];
    int i, j;
    for (i = 0; i < 3; i++)
        for (j = 0; j < 4; j++) {
            fill(reach[i].size, reach[i].quarters, range[j][0], range[j][1]);
            snprintf(arguments, sizeof arguments, "%s, %g < m < %g", reach[i].label, (double)range[j][0],
                     (double)range[j][1]);
            print_function("jacobi_sncndn", arguments, sncndn_apart, sncndn_chain);
#if GSL
            if (range[j][0] >= 0) print_function("gsl_sf_elljac_e", arguments, gsl_elljac_apart, gsl_elljac_chain);
#endif
        }
}

static void print_plans(void)
{
    enum { KINDS = 4 };
    static const vm_real m[KINDS] = {VM_C(0.3), VM_C(0.9), -20, VM_C(0.99)}; /* the last by theta functions */
    char arguments[40];
    int i;
    for (i = 0; i < 2 * KINDS; i++) {
        fill(0, 2, m[i % KINDS], m[i % KINDS]);
        jacobi_plan_init(&plan, m[i % KINDS]);
        snprintf(arguments, sizeof arguments, "|u| < 2K, m = %g", (double)m[i % KINDS]);
        if (i < KINDS) print_function("jacobi_plan_sncndn", arguments, plan_apart, plan_chain);
        else print_function("jacobi_plan_sncndn_array", arguments, array, NULL);
    }
}

static void print_functions(void)
{
    printf("%-55s    throughput         latency\n%-55s %9s %6s %9s %6s\n", "", "", "ns", "x sin", "ns", "x sin");
    print_function("sin", "|x| < 10", sin_apart, sin_chain);
    fill(1, 0, 0, 1);
    print_function("jacobi_K", "0 < m < 1", K_apart, K_chain);
#if GSL
    print_function("gsl_sf_ellint_Kcomp", "0 < k < 1", gsl_K_apart, gsl_K_chain);
#endif
    print_function("jacobi_E", "0 < m < 1", E_apart, E_chain);
    print_function("jacobi_cn_means", "0 < m < 1", means_apart, means_chain);
    fill(1, 0, -30, -1);
    print_function("jacobi_K", "-30 < m < -1", K_apart, K_chain);
    print_function("jacobi_E", "-30 < m < -1", E_apart, E_chain);
    print_function("jacobi_cn_means", "-30 < m < -1", means_apart, means_chain);
    print_sncndn();
    print_plans();
    fill(0, 2, 0, 1);
    print_function("jacobi_am", "|u| < 2K, 0 < m < 1", am_apart, am_chain);
    fill(1, 0, 0, VM_C(1.3));
    print_function("jacobi_solve_kpK", "0 < c < 1.3", solve_apart, solve_chain);
    fill(1, 0, VM_C(1.32), VM_C(1.85));
    print_function("jacobi_solve_kpK", "1.32 < c < 1.85", solve_apart, solve_chain);
    fill(1, 0, VM_C(1.86), 20);
    print_function("jacobi_solve_kpK", "1.86 < c < 20", solve_apart, solve_chain);
}

/* ---- Second table: error beside time ---- */

static double larger(double error, vm_real x, vm_real reference)
{
    const double e = (double)VM_FABS(x - reference) / (double)VM_EPSILON;
    return e > error ? e : error;
}

/* The largest difference from jacobi_sncndn in eps, by so many steps of the AGM, or where steps = 0 by the plan */
static double largest_error(void)
{
    double error = 0;
    vm_real sn, cn, dn;
    int i;
    for (i = 0; i < COUNT; i++) {
        if (steps == 0) jacobi_plan_sncndn(&plan, arg[i], &sn, &cn, &dn);
        else jacobi_agm_sncndn(arg[i], parameter[i], steps, &sn, &cn, &dn);
        jacobi_sncndn(arg[i], parameter[i], sn_out + i, cn_out + i, dn_out + i);
        error = larger(larger(larger(error, sn, sn_out[i]), cn, cn_out[i]), dn, dn_out[i]);
    }
    return error;
}

static timing print_route(vm_real m, const char *route, double error, void (*apart)(void), void (*chain)(void))
{
    char arguments[40];
    timing t;
    progress(route);
    snprintf(arguments, sizeof arguments, "|u| < 2K, m = %g", (double)m);
    printf("%-22s %-19s", route, arguments);
    if (error < 0) printf(" %12s", "reference");
    else printf(" %12.3g", error);
    t = print_time(route, arguments, 0, apart, error);
    print_time(route, arguments, 1, chain, error);
    return t;
}

/* Steps until one more changes nothing; at the end of a line what one step less saves (throughput) and costs */
static void print_error_beside_time(vm_real m)
{
    double error, error_before = 0;
    timing t, before = {0, 0};
    char route[24];
    fill(0, 2, m, m);
    jacobi_plan_init(&plan, m);
    for (steps = 1;; steps++) {
        error = largest_error();
        if (steps > 1 && error == error_before) break;
        snprintf(route, sizeof route, "AGM, %d step%s", steps, steps > 1 ? "s" : "");
        t = print_route(m, route, error, agm_apart, agm_chain);
        if (steps > 1) printf("   %+.1f ns, %+.3g eps", before.ns - t.ns, error_before - error);
        putchar('\n');
        error_before = error;
        before = t;
    }
    steps = 0;
    print_route(m, "theta functions", -1, sncndn_apart, sncndn_chain);
    putchar('\n');
    print_route(m, "theta functions, plan", largest_error(), plan_apart, plan_chain);
    puts("\n");
}

int main(int argc, char **argv)
{
    static const vm_real m[4] = {VM_C(0.1), VM_C(0.5), VM_C(0.9), VM_C(0.99)};
    int i;
    if (argc > 1) {
        csv = fopen(argv[1], "w");
        if (!csv) {
            perror(argv[1]);
            return 1;
        }
        fputs("function,arguments,kind,ns,per_sin,error_eps\n", csv);
    }
    for (i = 0; i < COUNT; i++) angle[i] = 20 * random_number() - 10;
    printf("jacobi.h, %s, medians of %d, %d random arguments\n\n",
           sizeof(vm_real) == sizeof(float) ? "float" : "double", REPEATS, COUNT);
    print_functions();
    puts("\nError beside time, |u| < 2K: largest difference from jacobi_sncndn, itself within 4 eps\n");
    printf("%-55s    throughput         latency\n%-42s %12s %9s %6s %9s %6s   a step less\n", "", "", "error/eps",
           "ns", "x sin", "ns", "x sin");
    for (i = 0; i < 4; i++) print_error_beside_time(m[i]);
    progress("");
    if (csv && fclose(csv) != 0) {
        perror(argv[1]);
        return 1;
    }
    return 0;
}
