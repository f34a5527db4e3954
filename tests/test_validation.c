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
         "`make test` checks each row of its tables. Each table compares numbers that others have published with our "
         "numbers, which varmass has computed. The column \"difference\" has the relative difference, |ours - "
         "published|/|published|. Each table has its own tolerance, which is the largest relative difference that is "
         "allowed. The fewer correct digits the published numbers have, the larger is the tolerance. The text above "
         "each table gives the reason for its tolerance.\n\nThe comparison shows no error of varmass: all differences "
         "are smaller than the tolerances. But three of the published sources need a remark. The first source is an "
         "example of the integrator CVODE, which computes the flight of a rocket. The numbers that this example prints "
         "are wrong from the fourth, fifth or sixth digit on, because CVODE ran with a large tolerance. The second "
         "source consists of the results of five programs that simulate a tumbling brick. The angular velocities that "
         "these programs computed differ from each other by relative differences of up to 2e-4. But two of the "
         "programs are much more accurate: their angular velocities differ from ours by relative differences of at "
         "most 4e-11. The third source, a file on the flight of a two-stage rocket, contains a pitch moment whose "
         "cause we could not find. For this reason we compare only the flight of this rocket, not its rotation.");
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
