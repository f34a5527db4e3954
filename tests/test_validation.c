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
    puts("# Validation by others' numbers\n\n"
         "Written by `make validation` (tests/test_validation.c), which `make test` checks row by row. Each table compares "
         "numbers that others have published with ours. The difference is relative, |ours - published|/|published|. A number "
         "that has few digits, or that its own source computed roughly, has a larger tolerance; the reason is beside it.\n\n"
         "Findings: no published number contradicts the kit. Three sources are less exact than they look. The output that "
         "CVODE's rocket prints is wrong from the fourth or fifth digit on, because its tolerance is loose. The "
         "simulation programs of the tumbling brick differ from each other by up to 2e-4. The two most accurate of them "
         "agree with our angular velocities to 4e-11. In the file of the "
         "two-stage rocket a pitch moment has no source that we could find.");
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
