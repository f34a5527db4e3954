/* trials.h - what the program that generate.awk writes is made of: tables of types and functions, and the search for
   all mistakes that can be made in the arguments of a function

   A mistake is one number, pointer or choice of the arguments that is spoiled, as deep as it may lie: fields of
   structs, and of what pointers point to, count as well. The search walks over the arguments of a function in a fixed
   order and counts the mistakes that it could make; it makes the one whose turn it is. */
#ifndef ERRORS_TRIALS_H
#define ERRORS_TRIALS_H

#define _POSIX_C_SOURCE 200809L /* of signals */
#include <setjmp.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "objects.h"

/* ---- Types: written by generate.awk for each struct, and for the arguments of each function ---- */

enum kind { REAL, INTEGER, LONG, STRUCT, POINTER, CODE, USER, UNKNOWN };

typedef struct type type;

typedef struct field {
    const char *name;
    enum kind kind;
    const type *type; /* of a struct, or of what a pointer shows; NULL where that is not spoiled */
    size_t offset;
    int count;        /* elements of an array, or numbers that a pointer shows */
    int is_output;    /* a pointer to what the function writes and does not read */
} field;

struct type {
    const char *name; /* "" for the arguments of a function */
    size_t size;
    const field *fields;
    int n_fields;
};

static const field field_vm_real[] = {{"", REAL, NULL, 0, 1, 0}};
static const type type_vm_real = {"vm_real", sizeof(vm_real), field_vm_real, 1};

/* ---- Functions: one trial each ---- */

/* What a function returns; MINUS_ONE: -1 for all mistakes, as jacobi.h and ateb.h do */
enum result { STATUS, MINUS_ONE, NUMBER, NOTHING, TEXT, ANSWER };

typedef struct outcome {
    enum result kind;
    long status;
    vm_real number;
    const char *text;
    unsigned char returned[512]; /* a struct */
} outcome;

/* What a function may write; the last entry of a list has no memory */
typedef struct output {
    const char *name;
    void *memory;
    size_t size;
    const type *type;
} output;

typedef struct trial {
    const char *name;
    int is_right_hand_side;
    const type *arguments;
    void *given;
    void (*fill)(void);
    void (*call)(outcome *o);
    const output *outputs;
} trial;

typedef struct exception {
    const char *function, *argument, *mistake, *instead;
    int line;
    int used;
} exception;

typedef struct status_name {
    int status;
    const char *name;
} status_name;

/* Memory for outputs: numbers in lists, and structs */
enum { ROOM = 1024, ROOMS = 8, ROOM_BYTES = 65536, STAIN = 0x55 };
static union room {
    double alignment;
    void *pointer;
    unsigned char bytes[ROOM_BYTES];
} room[ROOMS];
#define ROOM_FOR(type) (sizeof(type) < 2048 ? 8192 : 4 * sizeof(type))

/* ---- The search for mistakes ---- */

enum { LEVELS = 8 }; /* of structs in structs */

typedef struct search {
    long target;         /* the number of the mistake to be made, -1 for none */
    long counted;        /* mistakes before the present place */
    int probes;          /* an integer gets another value that may be good */
    const char *mistake; /* which mistake was made, NULL before that */
    int status;          /* what the table of errors says */
    char path[256];      /* where */
    const char *owner[LEVELS]; /* the structs and their fields that lead there, an argument's struct being "" */
    const char *name[LEVELS];
    int depth; /* how many of them there are */
} search;

static int is_made(const search *s) { return s->mistake != NULL; }

/* Is it the turn of this mistake? */
static int turn(search *s, const char *mistake, int status)
{
    if (is_made(s)) return 0;
    s->counted++;
    if (s->counted - 1 != s->target) return 0;
    s->mistake = mistake;
    s->status = status;
    return 1;
}

/* The name of the argument or field where the search is */
static const char *name_at(const search *s) { return s->depth > 0 ? s->name[s->depth - 1] : ""; }

static int is_one_of(const char *name, const char *list)
{
    char padded[64];
    snprintf(padded, sizeof padded, " %s ", name);
    return strstr(list, padded) != NULL;
}

static int ends_with(const char *text, const char *end)
{
    const size_t a = strlen(text), b = strlen(end);
    return a >= b && !strcmp(text + a - b, end);
}

static int is_mass(const char *name) { return is_one_of(name, " mass m m0 mass0 mass_a mass_b part_mass "); }
static int is_stiffness(const char *name) { return is_one_of(name, " stiffness k "); }

static void spoil_real(search *s, const char *name, vm_real *x)
{
    if (turn(s, "nan", VM_NOT_FINITE)) *x = VM_NAN;
    if (turn(s, "infinite", VM_NOT_FINITE)) *x = VM_INFINITY;
    if (is_mass(name) && turn(s, "zero_mass", VM_BAD_MASS)) *x = 0;
    if (is_mass(name) && turn(s, "negative_mass", VM_BAD_MASS)) *x = -1;
    if (is_stiffness(name) && turn(s, "zero_stiffness", VM_BAD_STIFFNESS)) *x = 0;
    if (is_stiffness(name) && turn(s, "negative_stiffness", VM_BAD_STIFFNESS)) *x = -1;
    if (!strcmp(name, "inertia") && turn(s, "inertia", VM_BAD_INERTIA)) *x = -1;
    if (!strcmp(name, "alpha") && turn(s, "alpha", VM_DOMAIN)) *x = -1;
}

/* A negative number, which is no count and no choice; and a choice beyond all that exist. A search that probes takes
   another choice, which may exist. */
static int spoil_integer(search *s, const char *name, long good, long *x)
{
    const int is_count = (name[0] == 'n' && (name[1] == 0 || name[1] == '_')) || ends_with(name, "size") ||
                         is_one_of(name, " room samples steps max_steps nodes ");
    if (ends_with(name, "status")) return 0; /* it is written, not read */
    if (turn(s, "negative", VM_BAD_ARGUMENT)) *x = -99;
    else if (!is_count && turn(s, "choice", VM_BAD_ARGUMENT)) *x = 99;
    else return 0;
    if (s->probes) *x = good + 1;
    return 1;
}

static void spoil_inertia(search *s, vm_inertia *i)
{
    if (!turn(s, "inertia", VM_BAD_INERTIA)) return;
    i->xx = 1;
    i->yy = 1;
    i->zz = 9;
}

static void spoil_law(search *s, const char *name, vm_law *law)
{
    if (turn(s, "nan", VM_NOT_FINITE)) *law = vm_law_linear(VM_NAN, 0);
    if (turn(s, "infinite", VM_NOT_FINITE)) *law = vm_law_linear(VM_INFINITY, 0);
    if (turn(s, "nan_rate", VM_NOT_FINITE)) *law = vm_law_linear(1, VM_NAN);
    if (turn(s, "nan_function", VM_NOT_FINITE)) *law = vm_law_user(law_of_nan, NULL);
    if (turn(s, "null", VM_BAD_ARGUMENT)) *law = vm_law_user(NULL, NULL);
    if (turn(s, "table", VM_BAD_ARGUMENT)) *law = vm_law_table(-99, a_time, a_value);
    if (is_mass(name) && turn(s, "zero_mass", VM_BAD_MASS)) *law = vm_law_linear(0, 0);
    if (is_mass(name) && turn(s, "negative_mass", VM_BAD_MASS)) *law = vm_law_linear(-1, 0);
    if (is_mass(name) && turn(s, "mass_function", VM_BAD_MASS)) *law = vm_law_user(law_of_zero, NULL);
    if (is_stiffness(name) && turn(s, "zero_stiffness", VM_BAD_STIFFNESS)) *law = vm_law_linear(0, 0);
    if (is_stiffness(name) && turn(s, "negative_stiffness", VM_BAD_STIFFNESS)) *law = vm_law_linear(-1, 0);
    if (is_stiffness(name) && turn(s, "stiffness_function", VM_BAD_STIFFNESS)) *law = vm_law_user(law_of_zero, NULL);
}

static void spoil_struct(search *s, const type *t, char *at);

static void spoil_pointer(search *s, const field *f, char *at)
{
    char *shown;
    int i;
    memcpy(&shown, at, sizeof shown);
    if (!shown) return;
    if (!ends_with(f->name, "_or_NULL") && turn(s, "null", VM_BAD_ARGUMENT)) {
        shown = NULL;
        memcpy(at, &shown, sizeof shown);
        return;
    }
    if (f->is_output || !f->type) return;
    for (i = 0; i < f->count && !is_made(s); i++) {
        const size_t length = strlen(s->path);
        if (f->count > 1) snprintf(s->path + length, sizeof s->path - length, "[%d]", i);
        spoil_struct(s, f->type, shown + (size_t)i * f->type->size);
        if (!is_made(s)) s->path[length] = 0;
    }
}

static void spoil_code(search *s, char *at)
{
    void (*code)(void);
    memcpy(&code, at, sizeof code);
    if (!code) return;
    if (turn(s, "null", VM_BAD_ARGUMENT)) memset(at, 0, sizeof code);
}

static void spoil_value(search *s, const field *f, char *at)
{
    long number, good;
    int small_number;
    switch (f->kind) {
    case REAL: spoil_real(s, name_at(s), (vm_real *)(void *)at); break;
    case INTEGER:
        memcpy(&small_number, at, sizeof small_number);
        if (spoil_integer(s, f->name, small_number, &number)) {
            small_number = (int)number;
            memcpy(at, &small_number, sizeof small_number);
        }
        break;
    case LONG:
        memcpy(&good, at, sizeof good);
        if (spoil_integer(s, f->name, good, &number)) memcpy(at, &number, sizeof number);
        break;
    case STRUCT: spoil_struct(s, f->type, at); break;
    default: break;
    }
}

static void spoil_field(search *s, const type *t, const field *f, char *at)
{
    const size_t length = strlen(s->path);
    size_t size = 0;
    int i;
    if (*f->name) {
        s->owner[s->depth] = t->name;
        s->name[s->depth] = f->name;
        s->depth++;
    }
    snprintf(s->path + length, sizeof s->path - length, "%s%s", length && *f->name ? "." : "", f->name);
    if (f->kind == POINTER) spoil_pointer(s, f, at);
    else if (f->kind == CODE) spoil_code(s, at);
    else {
        if (f->kind == REAL) size = sizeof(vm_real);
        if (f->kind == STRUCT) size = f->type->size;
        for (i = 0; i < f->count && !is_made(s); i++) spoil_value(s, f, at + (size_t)i * size);
    }
    if (is_made(s)) return;
    s->path[length] = 0;
    if (*f->name) s->depth--;
}

static void spoil_struct(search *s, const type *t, char *at)
{
    int i;
    if (s->depth >= LEVELS) return;
    if (!strcmp(t->name, "vm_law")) {
        spoil_law(s, name_at(s), (vm_law *)(void *)at);
        return;
    }
    for (i = 0; i < t->n_fields && !is_made(s); i++) spoil_field(s, t, t->fields + i, at + t->fields[i].offset);
    if (!strcmp(t->name, "vm_inertia")) spoil_inertia(s, (vm_inertia *)(void *)at);
}

/* Makes mistake number target of a trial; if there are fewer, the result has none. */
static search make_mistake(const trial *t, long target, int probes)
{
    search s;
    memset(&s, 0, sizeof s);
    s.target = target;
    s.probes = probes;
    if (target >= 0) spoil_struct(&s, t->arguments, (char *)t->given);
    return s;
}

/* ---- Outcomes ---- */

/* The number that tells what is wrong with a struct: NaN if one of its numbers is NaN, infinite if one is infinite */
static vm_real worst_number(const type *t, const void *at)
{
    vm_real worst = 0, x;
    int i, k;
    for (i = 0; i < t->n_fields; i++) {
        const field *f = t->fields + i;
        const char *place = (const char *)at + f->offset;
        for (k = 0; k < f->count; k++) {
            x = 0;
            if (f->kind == STRUCT) x = worst_number(f->type, place + (size_t)k * f->type->size);
            if (f->kind == REAL) memcpy(&x, place + (size_t)k * sizeof x, sizeof x);
            if (x != x || (worst == worst && !VM_IS_FINITE(x))) worst = x;
        }
    }
    return worst;
}

/* The outcome of a function that returns a struct of numbers */
static void keep_struct(outcome *o, const type *t, const void *returned)
{
    o->number = worst_number(t, returned);
    memcpy(o->returned, returned, t->size < sizeof o->returned ? t->size : sizeof o->returned);
}

#endif
