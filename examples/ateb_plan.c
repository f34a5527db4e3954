/* Print a prepared alpha as C, to be kept in flash: ateb_plan ALPHA [ACCURACY [NAME]]. Built with
   -DVM_USE_FLOAT it prints a plan for the float build. Every number has the digits that bring its bits back. */
#include "../ateb.h"
#include <stdio.h>
#include <stdlib.h>

#ifdef VM_USE_FLOAT
#define NUMBER "%.9g"
#else
#define NUMBER "%.17g"
#endif

static void print_numbers(const char *before, const vm_real *x, int n, const char *after)
{
    char text[40];
    int i;
    printf("%s", before);
    for (i = 0; i < n; i++) {
        sprintf(text, NUMBER, (double)x[i]);
        if (!strpbrk(text, ".e")) strcat(text, ".0");
        if (i > 0) printf(i % 4 == 0 ? ",\n     " : ", ");
        printf("VM_C(%s)", text);
    }
    printf("%s", after);
}

static void print_part(const vmi_ateb_part *part, const char *after)
{
    print_numbers("    {{", part->odd, ATEB_PLAN_LENGTH, "},\n");
    print_numbers("     {", part->even, ATEB_PLAN_LENGTH, "}}");
    printf("%s", after);
}

int main(int argc, char **argv)
{
    const double alpha = argc > 1 ? atof(argv[1]) : 1.5, accuracy = argc > 2 ? atof(argv[2]) : 0;
    ateb_plan p;
    if (ateb_plan_init_to(&p, (vm_real)alpha, (vm_real)accuracy) != 0) {
        fprintf(stderr, "usage: %s ALPHA [ACCURACY [NAME]], ALPHA >= 0\n", argv[0]);
        return 1;
    }
    printf("/* alpha = %.17g, accuracy %g (0: full), %u bytes */\n", alpha, accuracy, (unsigned)sizeof p);
    printf("static const ateb_plan %s = {\n", argc > 3 ? argv[3] : "plan");
    print_numbers("    {", &p.quarter.hi, 1, ", ");
    print_numbers("", &p.quarter.lo, 1, "},\n");
    print_numbers("    {", p.quarter_parts, 3, "},\n");
    print_numbers("    ", &p.per_quarter, 1, ", ");
    print_numbers("", &p.longest, 1, ", ");
    print_numbers("", &p.change_over, 1, ",\n");
    print_numbers("    ", &p.n, 1, ", ");
    print_numbers("", &p.g, 1, ", ");
    print_numbers("{", &p.twice_q.hi, 1, ", ");
    print_numbers("", &p.twice_q.lo, 1, "},\n");
    printf("    %d, %d,\n    {\n", p.length, p.twice_alpha);
    print_part(p.part, ",\n");
    print_part(p.part + 1, "\n    }\n};\n");
    return 0;
}
