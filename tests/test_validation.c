/* The kit against numbers that others have published: special functions (validation_functions.h), rockets and orbits
   (validation_motions.h), NASA's check cases and an asteroid (validation_flights.h). Each row must agree within the
   tolerance of its group, whose reason stands beside it.

   usage: validation             checks all rows
          validation markdown    prints them as docs/validation.md */
#include "validation.h"
#include "validation_flights.h"
#include "validation_functions.h"
#include "validation_motions.h"

static void print_head(void)
{
    puts("# Validation by others' numbers\n\nThis page is written by `make validation` (tests/test_validation.c); "
         "`make test` checks it row by row. Each table compares numbers that others have published with our numbers, "
         "which varmass has computed. The difference is relative, |ours - published|/|published|. Each table has a "
         "tolerance, which is the largest difference that is allowed. The tolerance is larger where the published "
         "numbers have few digits or are not accurate. The reason for each tolerance stands behind it.\n\nFindings: no "
         "published number contradicts the kit. Three sources are less exact than they look. The numbers that CVODE's "
         "example of a rocket prints are wrong from the fourth, fifth or sixth digit on, because CVODE ran with a "
         "large tolerance. The results of five programs that simulate a tumbling brick differ from each other by up to "
         "2e-4. The angular velocities by the two most accurate programs agree with ours to 4e-11. The file of the "
         "two-stage rocket contains a pitch moment whose cause we could not find.");
}

int main(int argc, char **argv)
{
    validation_prints = argc > 1 && strcmp(argv[1], "markdown") == 0;
    if (validation_prints) print_head();
    validate_functions();
    validate_motions();
    validate_flights();
    if (validation_prints) return 0;
    CHECK(validation_rows > 150); /* no group was forgotten */
    return check_finish("validation");
}
