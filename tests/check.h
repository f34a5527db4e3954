/* check.h - the test programs' checks, the table of worst errors, and the closing line that the runner adds up. */
#ifndef CHECK_H
#define CHECK_H

#include <math.h>
#include <stdio.h>
#include <string.h>

typedef struct check_row {
    const char *function, *region, *unit;
    double worst, bound, at[2];
    long count;
} check_row;

static check_row check_rows[500];
static int check_row_count;
static long check_passed, check_failed, check_skipped;

static inline void check_count(int good, const char *file, int line, const char *what)
{
    if (good) {
        check_passed++;
    } else {
        check_failed++;
        printf("FAILED %s:%d: %s\n", file, line, what);
    }
}
#define CHECK(condition) check_count((condition) != 0, __FILE__, __LINE__, #condition)
#define FAIL(text) check_count(0, __FILE__, __LINE__, text)

/* Whether two structs have the same bytes. Unused bytes between their fields count, too. They may never have been written,
   and MemorySanitizer would report a comparison by memcmp. */
#if defined __clang__
__attribute__((no_sanitize("memory"), noinline))
#endif
static inline int same_bytes(const void *a, const void *b, size_t size)
{
    const unsigned char *x = (const unsigned char *)a, *y = (const unsigned char *)b;
    size_t i;
    for (i = 0; i < size; i++)
        if (x[i] != y[i]) return 0;
    return 1;
}

/* A test of a row of tests/data/errata.txt, which it calls by its name there: in numbers, the printed form misses the
   truth and the corrected one meets it. tests/test_errata.sh finds the tests of a row by this macro alone. */
#define ERRATUM(row, printed_misses, corrected_holds)                                                             \
    do {                                                                                                          \
        check_count((printed_misses) != 0, __FILE__, __LINE__, "erratum " row ", printed: " #printed_misses);     \
        check_count((corrected_holds) != 0, __FILE__, __LINE__, "erratum " row ", corrected: " #corrected_holds); \
    } while (0)

/* One observation: the row of this function, region and unit keeps the worst and its inputs. NaN is the worst. */
static inline void check_error(const char *function, const char *region, const char *unit, double error,
                               double bound, double x, double parameter)
{
    check_row *row = check_rows;
    while (row < check_rows + check_row_count &&
           (strcmp(row->function, function) || strcmp(row->region, region) || strcmp(row->unit, unit)))
        row++;
    if (row == check_rows + check_row_count) {
        if (check_row_count == (int)(sizeof check_rows / sizeof *check_rows)) {
            FAIL("check_rows is too short");
            return;
        }
        check_row_count++;
        row->function = function;
        row->region = region;
        row->unit = unit;
        row->worst = -1;
        row->count = 0;
        row->bound = bound;
    }
    row->count++;
    if (bound < row->bound) row->bound = bound;
    if (row->worst == row->worst && !(error <= row->worst)) {
        row->worst = error;
        row->at[0] = x;
        row->at[1] = parameter;
    }
}

/* Have the errors of this function been observed, and are all of them within their bounds? */
static inline int check_holds(const char *function)
{
    int i, found = 0;
    for (i = 0; i < check_row_count; i++) {
        if (strcmp(check_rows[i].function, function) != 0) continue;
        if (!(check_rows[i].worst <= check_rows[i].bound)) return 0;
        found = 1;
    }
    return found;
}

/* |got - (high + low)| in units of eps scale */
static inline double error_eps(double got, double high, double low, double scale, double eps)
{
    return fabs((got - high) - low) / (eps * scale);
}

/* A unit in the last place of x in the type tested; below its smallest normal number, that number's. */
static inline double ulp_of(double x, int mantissa_digits, int least_exponent)
{
    int exponent = least_exponent;
    if (x != 0) frexp(x, &exponent);
    return ldexp(1, (exponent < least_exponent ? least_exponent : exponent) - mantissa_digits);
}
#define ERROR_EPS(got, high, low, scale) error_eps((double)(got), high, low, scale, (double)VM_EPSILON)
#ifdef VM_USE_FLOAT
#define ULP(x) ulp_of(x, FLT_MANT_DIG, FLT_MIN_EXP)
#define PRECISION "float"
#else
#define ULP(x) ulp_of(x, DBL_MANT_DIG, DBL_MIN_EXP)
#define PRECISION "double"
#endif
#define ERROR_ULP(got, high, low) (fabs(((double)(got) - (high)) - (low)) / ULP(high))

/* Is the input a number of the type tested? */
static inline int representable(double x) { return (double)(vm_real)x == x; }

/* A deterministic generator of uniform numbers in [low, high), rounded to the type tested. */
static inline double uniform(double low, double high)
{
    static unsigned long long state = 20;
    volatile vm_real rounded; /* gcc 12 vectorises double to float to double without the rounding */
    state = state * 6364136223846793005ull + 1442695040888963407ull;
    rounded = (vm_real)(low + (high - low) * ((double)(state >> 11) / 9007199254740992.0));
    return (double)rounded;
}

/* Prints the table of worst errors and the closing line. At least two blanks are between the words of a row, which may
   have one blank themselves: tests/rows.awk reads the table again. */
static inline int check_finish(const char *program)
{
    int i;
    if (check_row_count)
        printf("%-14s  %-16s  %-5s  %9s %9s %6s   worst at\n", program, PRECISION, "unit", "worst", "bound", "n");
    for (i = 0; i < check_row_count; i++) {
        const check_row *row = check_rows + i;
        int good = row->worst <= row->bound;
        printf("%-14s  %-16s  %-5s  %9.3g %9.3g %6ld   %.17g, %.17g%s\n", row->function, row->region, row->unit,
               row->worst, row->bound, row->count, row->at[0], row->at[1], good ? "" : "   FAILED");
        if (good) check_passed++;
        else check_failed++;
    }
    printf("%s %s: %ld passed, %ld failed, %ld skipped\n", program, PRECISION, check_passed, check_failed,
           check_skipped);
    return check_failed != 0;
}

/* Where a test tries very many cases of one kind, it tries every ONE_IN-th of them. This is every case, except on emulated
   processors, where all cases would take an hour a test: tests/cross.sh compiles the tests for them with SAMPLE defined. */
#ifdef SAMPLE
enum { ONE_IN = 19 }; /* a prime, so that no pattern of two or three cases is always left out */
#else
enum { ONE_IN = 1 };
#endif

/* Whether a check that needs all its cases, such as a median or a share of them, has to be left out */
static inline int only_a_sample(void)
{
    if (ONE_IN == 1) return 0;
    check_skipped++;
    return 1;
}

#endif
