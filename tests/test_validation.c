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
         "`make test` checks each of its rows. Each table compares numbers that others have published with our "
         "numbers, which varmass has computed. The difference is relative, |ours - published|/|published|. Each table "
         "has a tolerance, which is the largest difference that is allowed. The tolerance is larger if the published "
         "numbers have few digits or are not accurate. The text above each table gives the reason for its "
         "tolerance.\n\nThe comparison shows that no published number contradicts the kit, but that three sources are "
         "less exact than they look. First, an example of the integrator CVODE computes the flight of a rocket. The "
         "numbers that it prints are wrong from the fourth, fifth or sixth digit on, because CVODE ran with a large "
         "tolerance. Second, the results of five programs that simulate a tumbling brick differ from each other by up "
         "to 2e-4. The angular velocities by the two most accurate of these programs agree with ours to 4e-11. Third, "
         "the published file of a two-stage rocket contains a pitch moment whose cause we could not find.");
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
