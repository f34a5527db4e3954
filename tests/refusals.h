/* refusals.h - what functions refuse. A trial calls a function with good arguments, and then again and again with one
   of them spoiled: each number NaN and infinite in turn, each pointer null. The function must refuse that, by a
   negative status or by NaN, and leave its output as it was. Numbers of any size must be refused, or give finite
   results. */
#ifndef REFUSALS_H
#define REFUSALS_H

#include <stddef.h>
#include <stdlib.h>

#include "../varmass.h"
#include "check.h"

#define R(x) ((vm_real)(x))

enum { NUMBERS = 64, OUTPUT = 8192, STAIN = 0x55 };

static long refusal_rounds = 400 / ONE_IN; /* how often each function is called with numbers of any size */

/* The program's first argument, if there is one, is another number of rounds. */
static inline void read_refusal_rounds(int argc, char **argv)
{
    if (argc > 1) refusal_rounds = atol(argv[1]);
}

/* One call: a wrapper takes numbers and pointers from it, calls the function, and returns its status. */
typedef struct trial {
    union {
        double number;
        void *pointer;
    } alignment;                  /* of what follows it */
    unsigned char output[OUTPUT]; /* what the function writes */
    vm_real x[NUMBERS];           /* the numbers that it is given */
    int taken;                    /* how many of them the wrapper has taken */
    int null_pointer;             /* which pointer is null, -1 for none */
    int is_value;                 /* the output is a value, which may be infinite */
} trial;

/* The next numbers of the trial, as a struct that has nothing but numbers */
static inline void take(trial *a, void *numbers, size_t size)
{
    memcpy(numbers, a->x + a->taken, size);
    a->taken += (int)(size / sizeof(vm_real));
}

/* The next number of the trial */
static inline vm_real next(trial *a) { return a->x[a->taken++]; }

/* Input pointer k, and output pointer k at a place in the output; null if it is their turn */
#define POINTER(k, pointer) (a->null_pointer == (k) ? NULL : (pointer))
#define OUT(k, type, at) (a->null_pointer == (k) ? NULL : (type *)(void *)a->output + (at))

/* The status of a function with a value: NaN is its refusal */
static inline int value(trial *a, vm_real y)
{
    if (y == y) memcpy(a->output, &y, sizeof y);
    a->is_value = 1;
    return y == y ? 0 : -1;
}

static inline void start_trial(trial *a, const vm_real *good, int numbers)
{
    memset(a, 0, sizeof *a);
    memcpy(a->x, good, (size_t)numbers * sizeof *good);
    memset(a->output, STAIN, sizeof a->output);
    a->null_pointer = -1;
}

static inline int is_untouched(const trial *a)
{
    int i;
    for (i = 0; i < OUTPUT; i++)
        if (a->output[i] != STAIN) return 0;
    return 1;
}

/* With good arguments the function works, takes all numbers, and writes something. Only the first number of the
   output is compared, since a struct's padding may be anything. */
static inline void check_works(const char *name, int (*call)(trial *), const vm_real *good, int numbers)
{
    unsigned char before[sizeof(vm_real)];
    static trial a;
    int status, worked;
    memset(before, STAIN, sizeof before);
    start_trial(&a, good, numbers);
    status = call(&a);
    worked = status >= 0 && memcmp(a.output, before, sizeof before) != 0 && a.taken == numbers;
    if (!worked) printf("%s, good arguments: status %d\n", name, status);
    CHECK(worked);
}

/* Numbers that are none are refused, and so are null pointers. */
static inline void check_refuses(const char *name, int (*call)(trial *), const vm_real *good, int numbers,
                                 int pointers)
{
    const vm_real bad[3] = {VM_NAN, VM_INFINITY, -VM_INFINITY};
    static trial a;
    int i, k, status, refused;
    for (i = 0; i < numbers; i++) {
        for (k = 0; k < 3; k++) {
            start_trial(&a, good, numbers);
            a.x[i] = bad[k];
            status = call(&a);
            refused = status < 0 && is_untouched(&a);
            if (!refused) printf("%s: number %d is %g, status %d\n", name, i, (double)bad[k], status);
            CHECK(refused);
        }
    }
    for (i = 0; i < pointers; i++) {
        start_trial(&a, good, numbers);
        a.null_pointer = i;
        status = call(&a);
        refused = status < 0 && is_untouched(&a);
        if (!refused) printf("%s: pointer %d is null, status %d\n", name, i, status);
        CHECK(refused);
    }
}

/* Numbers out of their range, or whose results are, may be refused or not; but nothing is done by halves. */
static inline void check_whole_results(const char *name, int (*call)(trial *), const vm_real *good, int numbers)
{
    static trial a;
    int i, k, worked;
    for (i = 0; i < numbers; i++) {
        const vm_real extreme[5] = {0, -good[i], VM_MAX / 2, -VM_MAX / 2, VM_MIN};
        for (k = 0; k < 5; k++) {
            if ((5 * i + k) % ONE_IN != 0) continue;
            start_trial(&a, good, numbers);
            a.x[i] = extreme[k];
            worked = call(&a) >= 0 || is_untouched(&a);
            if (!worked) printf("%s: number %d is %g\n", name, i, (double)extreme[k]);
            CHECK(worked);
        }
    }
}

/* Are all numbers that the function has written finite? Where a double may begin at any fourth byte of a struct, as on i386, it
   is not known where the numbers begin, and the answer is always yes. */
static inline int all_finite(const trial *a)
{
    struct after_char {
        char first;
        vm_real x;
    };
    unsigned char before[sizeof(vm_real)];
    vm_real x;
    int i;
    if (offsetof(struct after_char, x) != sizeof x) return 1;
    memset(before, STAIN, sizeof before);
    for (i = 0; i < OUTPUT; i += (int)sizeof x) {
        if (memcmp(a->output + i, before, sizeof x) == 0) continue;
        memcpy(&x, a->output + i, sizeof x);
        if (!VM_IS_FINITE(x)) return 0;
    }
    return 1;
}

static inline vm_real any_size(void)
{
    const int is_double = VM_MANT_DIG > 24;
    const int least = is_double ? DBL_MIN_EXP : FLT_MIN_EXP, most = is_double ? DBL_MAX_EXP : FLT_MAX_EXP;
    const vm_real size = (vm_real)ldexp(1, (int)uniform(least, most));
    return uniform(-1, 1) < 0 ? -size : size;
}

/* One to three numbers of any size: the results are finite, or the function refuses and writes nothing. */
static inline void check_all_sizes(const char *name, int (*call)(trial *), const vm_real *good, int numbers)
{
    static trial a;
    long round;
    int k, worked;
    for (round = 0; round < refusal_rounds; round++) {
        start_trial(&a, good, numbers);
        for (k = 0; k < 1 + round % 3; k++) a.x[(int)uniform(0, numbers)] = any_size();
        if (call(&a) < 0) worked = is_untouched(&a);
        else worked = a.is_value || all_finite(&a);
        if (!worked) {
            printf("%s:", name);
            for (k = 0; k < numbers; k++) printf(" %g", (double)a.x[k]);
            printf("\n");
        }
        CHECK(worked);
    }
}

static inline void check_spoiled(const char *name, int (*call)(trial *), const vm_real *good, int numbers,
                                 int pointers)
{
    check_works(name, call, good, numbers);
    check_refuses(name, call, good, numbers, pointers);
    check_whole_results(name, call, good, numbers);
}

/* A wrapper, the number of its pointers, and good numbers */
#define REFUSES(call, pointers, ...)                                                   \
    do {                                                                               \
        const vm_real good[] = {__VA_ARGS__};                                          \
        check_spoiled(#call, call, good, (int)(sizeof good / sizeof *good), pointers); \
        check_all_sizes(#call, call, good, (int)(sizeof good / sizeof *good));         \
    } while (0)

/* REFUSES without numbers of any size, for functions that may integrate for long */
#define REFUSES_SPOILED(call, pointers, ...)                                           \
    do {                                                                               \
        const vm_real good[] = {__VA_ARGS__};                                          \
        check_spoiled(#call, call, good, (int)(sizeof good / sizeof *good), pointers); \
    } while (0)

/* A wrapper that takes no numbers */
#define REFUSES_NULL(call, pointers)                    \
    do {                                                \
        const vm_real none = 0;                         \
        check_spoiled(#call, call, &none, 0, pointers); \
    } while (0)

/* The numbers of a body that holds the part below: all of it, and without its motion */
#define RESTING \
    R(3), R(0.4), R(0.5), R(0.6), R(0.01), R(0.02), R(0.03), R(0.8), R(0.1), R(0.2), R(0.3), R(0.1), R(0.2), R(0.1)
#define BODY RESTING, R(1), R(-2), R(0.5), R(0.7), R(-0.4), R(1.1)
#define RESTING_PART R(0.5), R(0.01), R(0.01), R(0.01), 0, 0, 0, 1, 0, 0, 0, R(0.1), R(0.3), R(0.1)
#define PART RESTING_PART, 1, 2, R(0.5), R(0.7), R(0.4), R(0.1)

#endif
