/* validation.h - rows that compare a number which others have published with what the kit gives

   A group is a set of rows from one source. It has one tolerance, with its reason. test_validation.c checks each row;
   `test_validation markdown` prints the same rows as docs/validation.md. */
#ifndef VALIDATION_H
#define VALIDATION_H

#include "../varmass.h"
#include "check.h"
#include <stdlib.h>

typedef struct validation_group {
    const char *title;
    const char *source;      /* publication or file, with its version */
    const char *method;      /* what was computed, by which call, with what input, and what was left out */
    const char *reason;      /* why the tolerance is what it is */
    double tolerance;        /* largest relative difference; for a published 0, the largest absolute one */
    double single_tolerance; /* the same with -DVM_USE_FLOAT; 0: the group needs more digits than float has */
} validation_group;

static int validation_prints;
static long validation_rows;
static const validation_group *validation_now;

static void validation_begin(const validation_group *group)
{
    validation_now = group;
    if (!validation_prints) return;
    printf("\n## %s\n\nSource: %s.\n\n%s\n\n", group->title, group->source, group->method);
    printf("The relative difference between our numbers and the published numbers may be at most %.1g. The reason for "
           "this tolerance is as follows. %s\n\n", group->tolerance, group->reason);
    printf("| what | published | ours | difference |\n|---|---|---|---|\n");
}

/* Relative difference of our number from the published one; the absolute difference where the published one is 0. */
static double validation_difference(double ours, double theirs)
{
    const double difference = fabs(ours - theirs);
    if (theirs == 0) return difference;
    return difference / fabs(theirs);
}

/* A row of the present group: what it is, the published number as its source prints it, and our number. */
static void validation_row(const char *what, const char *published, double ours)
{
    const double theirs = strtod(published, NULL);
    const double difference = validation_difference(ours, theirs);
    double tolerance = validation_now->tolerance;
    validation_rows++;
    if (validation_prints) {
        printf("| %s | %s | %.16g | %.2g |\n", what, published, ours, difference);
        return;
    }
#ifdef VM_USE_FLOAT
    tolerance = validation_now->single_tolerance;
    if (theirs != 0 && fabs(theirs) < 1e-37) tolerance = 0; /* such a number is no normal float */
#endif
    if (tolerance == 0) {
        check_skipped++;
        return;
    }
    if (!(difference <= tolerance)) printf("%s: published %s, ours %.17g\n", what, published, ours);
    check_error(validation_now->title, "all rows", "tol", difference / tolerance, 1, ours, theirs);
    CHECK(difference <= tolerance);
}

#endif
