/* faults.h - functions of a user that fail at one of their calls, and the check of what the library does then

   A scenario is a function that gives the library functions of a user, calls it, and, where that ended with an error,
   calls it again to go on. check_faults first lets it run without a fault. Then it lets the first call of the user's
   functions fail, in a second run the second call, and so on to the last one. Each run must end with a status that the
   documentation names, must leave outputs as they are promised, and must go on to the result of the run without a
   fault. */
#ifndef FAULTS_H
#define FAULTS_H

#include "../varmass.h"
#include "check.h"

#define R(x) ((vm_real)(x))

/* How a call of the user's function fails */
enum {
    FAULT_STATUS = 1, /* it returns a number other than 0 */
    FAULT_NAN = 2,    /* it returns or writes NaN */
    FAULT_BOTH = 4,   /* it does both */
    FAULT_ALL = FAULT_STATUS + FAULT_NAN + FAULT_BOTH
};

/* The number that a failing function returns */
enum { FAULT_NUMBER = -1234 };

/* The fault of the present run: call number `at` fails in the way `kind`. `calls` counts from 0. */
static struct fault_now {
    long calls, at;
    int kind;
} fault;

/* Stops the faults, so that the test can prepare an object by calls that do not count. Returns what has to be assigned
   to `fault` afterwards. */
static inline struct fault_now fault_hold(void)
{
    const struct fault_now before = fault;
    fault.at = -1;
    return before;
}

/* Counts a call of a user's function. Returns 1 if this call has to fail. */
static inline int fault_strikes(void) { return fault.calls++ == fault.at; }

/* Does the same for a function that has no status, and so cannot fail by one. */
static inline int fault_strikes_nan(void) { return fault.kind == FAULT_STATUS ? 0 : fault_strikes(); }

/* The number that a user's function returns or writes instead of `right` */
static inline vm_real fault_value(int strikes, vm_real right)
{
    return strikes && fault.kind != FAULT_STATUS ? VM_NAN : right;
}

/* The status that a user's function returns */
static inline int fault_status(int strikes) { return strikes && fault.kind != FAULT_NAN ? (int)FAULT_NUMBER : 0; }

/* What a scenario reports */
typedef struct outcome {
    int status;    /* of the first call that did not succeed, else of the last call */
    int sound;     /* 1 if the outputs of that call were as promised */
    int again;     /* status at the end, after the calls that went on */
    double result; /* the result at the end */
} outcome;

/* What must hold after a fault */
typedef struct fault_promise {
    int kinds;         /* sum of the kinds of faults that the user's functions can have */
    int stopped;       /* status where the user's function returned a number other than 0 */
    int not_a_number;  /* status where it returned NaN; 0 is possible too, since a run may step over it */
    double difference; /* largest relative difference of the results in eps; 0: they have the same bits */
    int other;         /* 0, or a further status that all kinds of faults may have */
    int may_be_nan;    /* 1 for right-hand sides: with NaN in them an integrator tries a shorter step */
} fault_promise;

/* A scenario runs by itself, or by a row of a table that says on which functions and objects it works. */
typedef struct scenario {
    const char *name;        /* of the function that is tested */
    void (*run)(outcome *o); /* NULL if run_row is what there is to do */
    fault_promise promise;
    void (*run_row)(outcome *o, const void *row);
    const void *row; /* the second argument of run_row */
} scenario;

/* What an output is before the call */
#define FAULT_UNTOUCHED R(-77.125)

/* Fills n outputs before a call that may fail. */
static inline void fault_fill(int n, vm_real *y)
{
    int i;
    for (i = 0; i < n; i++) y[i] = FAULT_UNTOUCHED;
}

/* Whether none of n outputs has been written */
static inline int fault_is_untouched(int n, const vm_real *y)
{
    int i;
    for (i = 0; i < n; i++)
        if (y[i] != FAULT_UNTOUCHED) return 0;
    return 1;
}

/* A number that depends on each of n numbers */
static inline vm_real fault_sum(int n, const vm_real *y)
{
    vm_real sum = 0;
    int i;
    for (i = 0; i < n; i++) sum += (vm_real)(2 * i + 1) * y[i];
    return sum;
}

/* ---- Single calls ---- */

/* An object of the library, of which some laws or other functions of a user fail */
typedef union fault_object {
    vm_law law;
    vm_osc_problem problem;
    vm_odd_force odd_force;
    vm_odd_problem odd;
    vm_vdp vdp;
    vm_jeffcott rotor;
    vm_pair pair;
    vm_coupled_pair coupled;
    vm_grounded_pair grounded;
    vm_forced forced;
    vm_periodic periodic;
    vm_lagrange_system lagrange;
} fault_object;

/* A function that keeps nothing from call to call, and what it is called with. The function is a right-hand side, which
   gets the object as its last argument, or else `call`, which calls it with the object, writes its outputs to out and
   returns its status. */
typedef struct fault_row {
    const char *name;
    void (*make)(fault_object *o); /* makes the object from one whose bytes are all 0 */
    ode_rhs rhs; /* NULL where `call` is what there is to call */
    int (*call)(fault_object *o, vm_real *out);
    int n; /* number of outputs, at most FAULT_OUTPUTS */
    const fault_promise *promise;
} fault_row;

enum { FAULT_OUTPUTS = 5 };

/* The state, or other numbers, that functions are called with; they use as many of them as they need. */
static const vm_real fault_state[5] = {1, R(0.5), R(0.25), R(0.75), R(0.125)};

/* Makes the object, and calls the function. An error must leave all outputs and the object as they were. */
static inline int fault_try(const fault_row *row, outcome *o)
{
    vm_real out[FAULT_OUTPUTS];
    fault_object object, before;
    int status;
    memset(&object, 0, sizeof object);
    row->make(&object);
    memcpy(&before, &object, sizeof object);
    fault_fill(row->n, out);
    if (row->rhs) status = row->rhs(1, fault_state, out, &object);
    else status = row->call(&object, out);
    if (status < 0 && !fault_is_untouched(row->n, out)) o->sound = 0;
    if (status < 0 && !same_bytes(&object, &before, sizeof object)) o->sound = 0;
    o->result = (double)fault_sum(row->n, out);
    return status;
}

/* The run of such a row: the function is called, and where it failed, called again. */
static inline void fault_call_twice(outcome *o, const void *row)
{
    o->status = o->again = fault_try((const fault_row *)row, o);
    if (o->status < 0) o->again = fault_try((const fault_row *)row, o);
}

/* Whether the scenario is a single call, and not a run of many steps */
static inline int fault_is_single(const scenario *s) { return s->run_row == fault_call_twice; }

/* ---- The checks ---- */

/* One run of the scenario with a fault at the call `at` */
static inline outcome fault_run(const scenario *s, int kind, long at)
{
    outcome o = {0, 1, 0, 0};
    fault.calls = 0;
    fault.at = at;
    fault.kind = kind;
    if (s->run) s->run(&o);
    else s->run_row(&o, s->row);
    return o;
}

/* Whether the status is one that this fault may have */
static inline int fault_has_status(const fault_promise *p, int kind, int status)
{
    if (status == 0) return kind == FAULT_NAN || p->difference > 0;
    if (kind != FAULT_NAN && status == p->stopped) return 1;
    if (kind != FAULT_STATUS && status == p->not_a_number) return 1;
    return p->other && status == p->other;
}

/* Whether the result is that of the run without a fault. A function that keeps nothing from call to call must have the
   same bits after an error; a run that has stepped over the fault, or goes on after it, may differ as promised. */
static inline int fault_same(const scenario *s, const outcome *o, double result)
{
    const double difference = s->promise.difference;
    if (s->promise.may_be_nan && o->status == 0 && o->result != o->result) return 1;
    if (difference == 0 || (o->status < 0 && fault_is_single(s))) return o->result == result;
    return fabs(o->result - result) <= difference * (double)VM_EPSILON * fabs(result);
}

/* The call that fails after the call `at` has failed: all calls of an integrator's or a scene's run; of functions whose
   calls last longer each of the first 40, and then fewer and fewer, so that the test lasts some seconds. Where there
   are very many calls, they are the calls 0, 7, 63, 511 and so on. On emulated processors ONE_IN leaves most of them out. */
static inline long fault_next(const scenario *s, long at, long calls)
{
    if (!fault_is_single(s)) return at + ONE_IN;
    if (calls > 30000) return 8 * at + 7;
    return at < 40 ? at + ONE_IN : at + ONE_IN * (1 + at / 4);
}

/* The scenario with a fault of this kind at each call in turn. `calls` is how many calls there are without a fault. One fault at
   least must end with an error, unless only a sample of the calls is tried: the run may step over all of these. */
static inline void check_faults_of(const scenario *s, int kind, long calls, double result)
{
    const char *names[5] = {"", "status", "NaN", "", "both"};
    long at, errors = 0, bad = 0, tried = 0;
    for (at = 0; at < calls; at = fault_next(s, at, calls)) {
        const outcome o = fault_run(s, kind, at);
        const int good = fault_has_status(&s->promise, kind, o.status) && o.sound && o.again >= 0 &&
                         fault_same(s, &o, result);
        tried++;
        errors += o.status != 0;
        bad += !good;
        if (!good && bad <= 3)
            printf("%s, %s at call %ld: status %d, sound %d, then %d, %.17g instead of %.17g\n", s->name, names[kind],
                   at, o.status, o.sound, o.again, o.result, result);
    }
    printf("%-45s  %-6s  %5ld of %5ld calls, %5ld ended with an error, %ld wrong\n", s->name, names[kind], tried, calls,
           errors, bad);
    check_count(bad == 0 && (errors > 0 || kind == FAULT_NAN || ONE_IN > 1), __FILE__, __LINE__, s->name);
}

static inline void check_faults(const scenario *s)
{
    const outcome without = fault_run(s, FAULT_STATUS, -1);
    int kind;
    check_count(without.status >= 0 && without.sound && without.result == without.result, __FILE__, __LINE__,
                s->name);
    if (without.status < 0) printf("%s: status %d without a fault\n", s->name, without.status);
    for (kind = FAULT_STATUS; kind <= FAULT_BOTH; kind *= 2) {
        if (!(s->promise.kinds & kind)) continue;
        fault_run(s, kind, -1);
        check_faults_of(s, kind, fault.calls, without.result);
    }
}

/* Checks a scenario that is made of a row of another table. */
static inline void check_faults_of_row(const char *name, const fault_promise *promise,
                                       void (*run_row)(outcome *o, const void *row), const void *row)
{
    scenario s = {NULL, NULL, {0, 0, 0, 0, 0, 0}, NULL, NULL};
    s.name = name;
    s.promise = *promise;
    s.run_row = run_row;
    s.row = row;
    check_faults(&s);
}

#endif
