/* Print a plan of jacobi.h as a C constant, for flash: the digits are so many that they compile to the bits that
   jacobi_plan_init computes here. Built with -DVM_USE_FLOAT it prints the plan of float.
   usage: jacobi_plan [M [NAME]], by default 0.3 plan */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../jacobi.h"

enum { DIGITS = VM_MANT_DIG > 24 ? 17 : 9 };

/* a constant of the plan's type: a point even where none is needed, for the suffix */
static void print_real(vm_real x)
{
    char text[40];
    snprintf(text, sizeof text, "%.*g", DIGITS, (double)x);
    printf("%s%s%s", text, strpbrk(text, ".e") ? "" : ".0", sizeof(vm_real) == sizeof(float) ? "f" : "");
}

static void print_reals(const char *before, const vm_real *x, int n, const char *after)
{
    int i;
    fputs(before, stdout);
    for (i = 0; i < n; i++) {
        if (i > 0) fputs(", ", stdout);
        print_real(x[i]);
    }
    puts(after);
}

static void print_plan(const jacobi_plan *p, const char *m, const char *name)
{
    const vmi_theta_form *t = &p->theta;
    const vm_real head[4] = {t->kp, t->kp_lo, t->q, t->defect};
    const int is_float = sizeof(vm_real) == sizeof(float);
    printf("/* sn, cn, dn for m = %s in %s, %d bytes; include jacobi.h %s VM_USE_FLOAT */\n", m,
           is_float ? "float" : "double", (int)sizeof *p, is_float ? "with" : "without");
    printf("static const jacobi_plan %s = {\n    %d,\n", name, p->form);
    print_reals("    ", &p->m1, 1, ",");
    print_reals("    {", p->K, 4, "},");
    print_reals("    ", &p->per_K, 1, ",");
    print_reals("    {", p->a, VMI_TERMS, "},");
    print_reals("    {", p->b, VMI_TERMS, "},");
    print_reals("    {", head, 4, ",");
    print_reals("     {", t->f, 3, "},");
    print_reals("     {", t->g, 2, "},");
    print_reals("     {", t->scale, 2, "}}};");
}

int main(int argc, char **argv)
{
    const char *m = argc > 1 ? argv[1] : "0.3";
    char *end;
    jacobi_plan p;
    if (jacobi_plan_init(&p, (vm_real)strtod(m, &end)) != 0 || end == m || *end != 0) {
        fprintf(stderr, "jacobi_plan: %s is no parameter m <= 1\n", m);
        return 1;
    }
    print_plan(&p, m, argc > 2 ? argv[2] : "plan");
    return 0;
}
