/* The catalogue of hard cases, tests/hard/, by topics of numerics. Each case is compared with its value in arbitrary
   precision. The naive formula is tried beside it, and has to be wrong there. Prints the tables of docs/hard-cases.md. */
#include "hard/hard.h"

#include "hard/removable.c"
#include "hard/cancellation.c"
#include "hard/range.c"
#include "hard/long_times.c"
#include "hard/nonsmooth.c"
#include "hard/stiffness.c"
#include "hard/resonance.c"
#include "hard/jumps.c"
#include "hard/slow_oscillators.c"
#include "hard/attitudes.c"
#include "hard/weak_forces.c"
#include "hard/joints.c"

typedef struct hard_value {
    const char *kernel;
    double x[HARD_INPUTS], high, low, scale;
} hard_value;
static const hard_value hard_values[] = {
#include "data/hard.h"
};

static const hard_value *value_of(const hard_case *c, const vm_real *x)
{
    const hard_value *v = hard_values, *end = v + sizeof hard_values / sizeof *hard_values;
    for (; v < end; v++) {
        int i = 0;
        while (i < HARD_INPUTS && (double)x[i] == v->x[i]) i++;
        if (i == HARD_INPUTS && strcmp(v->kernel, c->kernel) == 0) return v;
    }
    return NULL;
}

/* The error in eps of the scale; infinite where the result is no number */
static double error_of(vm_real got, const hard_value *v)
{
    const double error = error_eps((double)got, v->high, v->low, v->scale, (double)VM_EPSILON);
    return error == error ? error : (double)INFINITY;
}

static void print_error(double error)
{
    if (error < (double)INFINITY) printf(" %.2g |", error);
    else printf(" no number |");
}

/* Returns 1 if the compiler fuses products with sums: then 1 - (1 + 2^-p) (1 - 2^-p) is 2^-2p, not 0. */
static int is_fused(void)
{
    const volatile vm_real small = VM_EPSILON;
    const vm_real above = 1 + small, below = 1 - small;
    return 1 - above * below != 0;
}

/* Prints an argument with 15 digits, or with 17 if these would hide how close it is to 1. */
static void print_argument(double x) { printf(x != 1 && fabs(x - 1) < 5e-15 ? " %.17g" : " %.15g", x); }

/* The naive formula is to be worse than four bounds. In wider registers, and with fused operations, it may do better
   than its type can. */
static void check_case(const hard_case *c)
{
    const double worse = 4 * c->bound;
    vm_real x[HARD_INPUTS];
    const hard_value *v;
    double error, naive;
    int i, last = 0;
    for (i = 0; i < HARD_INPUTS; i++) {
        x[i] = (vm_real)c->x[i];
        if (c->x[i] != 0) last = i;
    }
    printf("| %s | %s |", c->text, c->kernel);
    for (i = 0; i <= last; i++) print_argument(c->x[i]);
    v = value_of(c, x);
    if (!v) {
        printf(" | NO VALUE\n");
        FAIL("tests/data/hard.h is not up to date: run tests/gen/hard_reference.py");
        return;
    }
    error = error_of(c->ours(x), v);
    naive = error_of(c->naive(x), v);
    printf(" |");
    print_error(error);
    print_error(c->bound);
    print_error(naive);
    printf("%s%s\n", error <= c->bound ? "" : " OURS FAILED", naive > worse ? "" : " NAIVE GOOD");
    CHECK(error <= c->bound);
    if (FLT_EVAL_METHOD == 0 && !is_fused()) CHECK(naive > worse);
    else check_skipped++;
}

#define GROUP(title, cases) check_group(title, cases, (int)(sizeof cases / sizeof *cases))
static void check_group(const char *title, const hard_case *cases, int n)
{
    int i;
    printf("\n## %s: %d cases\n\n", title, n);
    printf("| what would go wrong | kernel | at | error | bound | naive |\n|---|---|---|---|---|---|\n");
    CHECK(n >= 15);
    for (i = 0; i < n; i++) check_case(cases + i);
}

int main(void)
{
    GROUP("Removable singularities", removable_cases);
    GROUP("Cancellation", cancellation_cases);
    GROUP("Under- and overflow", range_cases);
    GROUP("Long times", long_times_cases);
    GROUP("Forces that are not smooth", nonsmooth_cases);
    GROUP("Stiffness", stiffness_cases);
    GROUP("Resonance", resonance_cases);
    GROUP("Ill-posed jumps", jumps_cases);
    GROUP("Oscillators with slow mass", slow_oscillators_cases);
    GROUP("Attitudes and axles", attitudes_cases);
    GROUP("Oscillators under weak forces", weak_forces_cases);
    GROUP("Joints of scenes", joints_cases);
    printf("\n");
    return check_finish("hard");
}
