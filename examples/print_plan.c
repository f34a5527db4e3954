/* Prints a prepared plan as a C constant, for the flash of a microcontroller. Every number is printed with enough
   digits to restore its bits. If the program is built with -DVM_USE_FLOAT, it prints plans for the float build.
   usage: print_plan jacobi M [NAME]                  sn, cn, dn for the parameter M
          print_plan ateb ALPHA [ACCURACY [NAME]]     sa, ca for ALPHA; 0 stands for the full accuracy
          print_plan closed ALPHA M0 M1 K0 K1 REACTIVE DAMPING X V ORDER T_END [NAME]
                                                      the motion of an oscillator with the mass M0 + M1 t and the
                                                      stiffness K0 + K1 t from the position X and the velocity V
          print_plan rotation IX IY IZ WX WY WZ [NAME]
                                                      the rotation of a free body with the principal moments of inertia
                                                      IX, IY, IZ that turns at t = 0 with the angular velocity (WX, WY,
                                                      WZ); its body axes are those of space at t = 0 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../varmass.h"

enum { DIGITS = VM_MANT_DIG > 24 ? 17 : 9 };

static void print_number(vm_real x)
{
    char text[40];
    if (!VM_IS_FINITE(x)) {
        printf("VM_INFINITY"); /* an error that is not known */
        return;
    }
    snprintf(text, sizeof text, "%.*g", DIGITS, (double)x);
    printf("VM_C(%s%s)", text, strpbrk(text, ".e") ? "" : ".0"); /* the suffix of float needs a decimal point */
}

static void print_numbers(const char *before, const vm_real *x, int n, const char *after)
{
    int i;
    printf("%s", before);
    for (i = 0; i < n; i++) {
        if (i > 0) printf(i % 4 == 0 ? ",\n     " : ", ");
        print_number(x[i]);
    }
    printf("%s", after);
}

/* Prints the lines before the numbers. A program that computes in the other precision does not compile with the plan. */
static void print_head(const char *type, const char *what, size_t size, const char *name)
{
    const int is_float = sizeof(vm_real) == sizeof(float);
    printf("/* %s, %s, %u bytes */\n", what, is_float ? "float" : "double", (unsigned)size);
    printf("#if VM_MANT_DIG %s 24\n", is_float ? ">" : "<=");
    printf("#error \"this plan is for %s VM_USE_FLOAT\"\n", is_float ? "float: define" : "double: do not define");
    printf("#endif\n");
    printf("static const %s %s = {\n", type, name);
}

/* Returns the argument i as a number, or `otherwise` if there are fewer arguments. If the argument is not a number,
   the program ends. */
static vm_real number(int argc, char **argv, int i, double otherwise)
{
    char *end;
    double x;
    if (i >= argc) return (vm_real)otherwise;
    x = strtod(argv[i], &end);
    if (end != argv[i] && *end == 0) return (vm_real)x;
    fprintf(stderr, "print_plan: %s is no number\n", argv[i]);
    exit(1);
}

static const char *name(int argc, char **argv, int i) { return i < argc ? argv[i] : "plan"; }

static void print_theta_form(const vmi_theta_form *t, const char *after)
{
    print_numbers("    {", &t->kp, 1, ", ");
    print_numbers("", &t->kp_lo, 1, ", ");
    print_numbers("", &t->q, 1, ", ");
    print_numbers("", &t->defect, 1, ",\n");
    print_numbers("     {", t->f, 3, "},\n");
    print_numbers("     {", t->g, 2, "},\n");
    print_numbers("     {", t->scale, 2, "}}");
    printf("%s", after);
}

static int print_jacobi(int argc, char **argv)
{
    const vm_real m = number(argc, argv, 2, 0.3);
    jacobi_plan p;
    if (jacobi_plan_init(&p, m) != 0) return 1;
    print_head("jacobi_plan", argc > 2 ? argv[2] : "0.3", sizeof p, name(argc, argv, 3));
    printf("    %d,\n", p.form);
    print_numbers("    ", &p.m1, 1, ",\n");
    print_numbers("    {", p.K, (int)(sizeof p.K / sizeof *p.K), "},\n");
    print_numbers("    ", &p.per_K, 1, ",\n");
    print_numbers("    {", p.a, VMI_TERMS, "},\n");
    print_numbers("    {", p.b, VMI_TERMS, "},\n");
    print_theta_form(&p.theta, "\n};\n");
    return 0;
}

static void print_part(const vmi_ateb_part *part, const char *after)
{
    print_numbers("    {{", part->odd, ATEB_PLAN_LENGTH, "},\n");
    print_numbers("     {", part->even, ATEB_PLAN_LENGTH, "}}");
    printf("%s", after);
}

static void print_ateb_members(const ateb_plan *p)
{
    print_numbers("    {", &p->quarter.hi, 1, ", ");
    print_numbers("", &p->quarter.lo, 1, "},\n");
#if VM_MANT_DIG > 24
    print_numbers("    ", &p->quarter_low, 1, ",\n");
#endif
    print_numbers("    {", p->quarter_parts, 3, "},\n");
    print_numbers("    ", &p->per_quarter, 1, ", ");
    print_numbers("", &p->longest, 1, ", ");
    print_numbers("", &p->change_over, 1, ",\n");
    print_numbers("    ", &p->n, 1, ", ");
    print_numbers("", &p->g, 1, ", ");
    print_numbers("{", &p->twice_q.hi, 1, ", ");
    print_numbers("", &p->twice_q.lo, 1, "},\n");
    printf("    %d, %d,\n    {\n", p->length, p->twice_alpha);
    print_part(p->part, ",\n");
    print_part(p->part + 1, "\n    }\n");
}

static int print_ateb(int argc, char **argv)
{
    const vm_real alpha = number(argc, argv, 2, 1.5), accuracy = number(argc, argv, 3, 0);
    char what[80];
    ateb_plan p;
    if (ateb_plan_init_to(&p, alpha, accuracy) != 0) return 1;
    snprintf(what, sizeof what, "alpha = %.17g, accuracy %g (0: full)", (double)alpha, (double)accuracy);
    print_head("ateb_plan", what, sizeof p, name(argc, argv, 4));
    print_ateb_members(&p);
    printf("};\n");
    return 0;
}

static void print_ripple(const vmi_ripple *r)
{
    int i;
    print_numbers("    {", &r->alpha, 1, ", ");
    print_numbers("", &r->gamma, 1, ", ");
    print_numbers("", &r->scale, 1, ", ");
    print_numbers("", &r->pi, 1, ",\n    ");
    print_numbers("", &r->mean2, 1, ", ");
    print_numbers("", &r->mean4, 1, ", ");
    print_numbers("", &r->variance, 1, ", ");
    printf("%d,\n", r->has_polynomials);
    print_numbers("    ", &r->at_sa_0, 1, ", ");
    print_numbers("", &r->at_ca_0, 1, ",\n    {\n");
    for (i = 0; i < VMI_RIPPLE_FUNCTIONS; i++) print_numbers("    {", r->near_ca_0[i], VMI_RIPPLE_TERMS, "},\n");
    printf("    },\n    {\n");
    for (i = 0; i < VMI_RIPPLE_FUNCTIONS; i++) print_numbers("    {", r->near_sa_0[i], VMI_RIPPLE_TERMS, "},\n");
    printf("    }}\n");
}

static void print_mean(const vmi_osc_closed_mean *m)
{
    print_numbers("    {{", &m->start.A, 1, ", ");
    print_numbers("", &m->start.psi, 1, ", ");
    print_numbers("", &m->start.W, 1, "}, ");
    print_numbers("", &m->base, 1, ",\n     ");
    print_numbers("{", &m->rates.p, 1, ", ");
    print_numbers("", &m->rates.rest, 1, ", ");
    print_numbers("", &m->rates.delta, 1, "}, ");
    print_numbers("", &m->first, 1, ", ");
    print_numbers("", &m->second, 1, "},\n");
}

static int print_closed(int argc, char **argv)
{
    static vm_osc_closed c; /* static: fields that a lower order does not use are 0 */
    vm_osc_problem p;
    char what[80];
    int status;
    if (argc < 13) return 1;
    p.alpha = number(argc, argv, 2, 0);
    p.mass = vm_law_linear(number(argc, argv, 3, 0), number(argc, argv, 4, 0));
    p.stiffness = vm_law_linear(number(argc, argv, 5, 0), number(argc, argv, 6, 0));
    p.reactive = number(argc, argv, 7, 0);
    p.damping = number(argc, argv, 8, 0);
    p.x = number(argc, argv, 9, 0);
    p.v = number(argc, argv, 10, 0);
    p.force = NULL;
    p.ctx = NULL;
    status = vm_osc_closed_init(&c, &p, (int)number(argc, argv, 11, 0), number(argc, argv, 12, 0));
    if (status) {
        fprintf(stderr, "print_plan: %s\n", vm_strerror(status));
        return 1;
    }
    snprintf(what, sizeof what, "an oscillator with alpha = %.17g, order %d", (double)p.alpha, c.order);
    print_head("vm_osc_closed", what, sizeof c, name(argc, argv, 13));
    printf("    %d, %d, ", c.order, c.beyond);
    print_number(c.error);
    printf(",\n");
    print_mean(&c.mean);
    printf("    {\n");
    print_ateb_members(&c.ateb);
    printf("    },\n");
    print_ripple(&c.ripple);
    printf("};\n");
    return 0;
}

static void print_vector(const char *before, vm_vec3 a, const char *after)
{
    print_numbers(before, &a.x, 1, ", ");
    print_numbers("", &a.y, 1, ", ");
    print_numbers("", &a.z, 1, after);
}

static void print_quaternion(const char *before, vm_quat q, const char *after)
{
    print_numbers(before, &q.w, 1, ", ");
    print_numbers("", &q.x, 1, ", ");
    print_numbers("", &q.y, 1, ", ");
    print_numbers("", &q.z, 1, after);
}

static void print_two(const char *before, vm_two a, const char *after)
{
    print_numbers(before, &a.hi, 1, ", ");
    print_numbers("", &a.lo, 1, after);
}

static void print_body(const vm_body *body)
{
    const vm_inertia *i = &body->inertia;
    print_numbers("    {", &body->mass, 1, ", ");
    print_numbers("{", &i->xx, 1, ", ");
    print_numbers("", &i->yy, 1, ", ");
    print_numbers("", &i->zz, 1, ", ");
    print_numbers("", &i->xy, 1, ", ");
    print_numbers("", &i->xz, 1, ", ");
    print_numbers("", &i->yz, 1, "},\n");
    print_quaternion("     {", body->q, "},\n");
    print_vector("     {", body->r, "}, ");
    print_vector("{", body->v, "},\n");
    print_vector("     {", body->omega, "}},\n");
}

static void print_doubled_theta(const vmi_doubled_theta *t)
{
    print_numbers("    {", &t->decay, 1, ", ");
    print_numbers("", &t->shift, 1, ", ");
    print_numbers("", &t->Q, 1, ",\n");
    print_numbers("     {", t->re, 4, "},\n");
    print_numbers("     {", t->im, 4, "}}\n");
}

static void print_torque_free(const vm_torque_free *r)
{
    print_body(&r->body);
    print_numbers("    ", &r->t0, 1, ",\n");
    print_vector("    {{", r->axes.x, "},\n");
    print_vector("     {", r->axes.y, "},\n");
    print_vector("     {", r->axes.z, "}},\n");
    print_quaternion("    {", r->start, "},\n");
    print_numbers("    {", r->spin, 3, "},\n");
    print_numbers("    {", r->lean, 3, "},\n");
    print_two("    {", r->phase, "}, ");
    print_two("{", r->phase_rate, "},\n");
    print_two("    {", r->K, "}, ");
    print_two("{", r->turn_rate, "},\n");
    print_numbers("    ", &r->m1, 1, ",\n");
    print_theta_form(&r->far_form, ",\n");
    print_doubled_theta(&r->theta);
}

static int print_rotation(int argc, char **argv)
{
    const vm_quat none = {1, 0, 0, 0};
    vm_vec3 moments, omega;
    vm_torque_free r;
    int status;
    if (argc < 8) return 1;
    moments.x = number(argc, argv, 2, 0);
    moments.y = number(argc, argv, 3, 0);
    moments.z = number(argc, argv, 4, 0);
    omega.x = number(argc, argv, 5, 0);
    omega.y = number(argc, argv, 6, 0);
    omega.z = number(argc, argv, 7, 0);
    status = vm_torque_free_init_principal(&r, moments, none, omega, 0);
    if (status) {
        fprintf(stderr, "print_plan: %s\n", vm_strerror(status));
        return 1;
    }
    print_head("vm_torque_free", "the rotation of a free body", sizeof r, name(argc, argv, 8));
    print_torque_free(&r);
    printf("};\n");
    return 0;
}

int main(int argc, char **argv)
{
    int failed = 1;
    if (argc > 1 && strcmp(argv[1], "jacobi") == 0) failed = print_jacobi(argc, argv);
    if (argc > 1 && strcmp(argv[1], "ateb") == 0) failed = print_ateb(argc, argv);
    if (argc > 1 && strcmp(argv[1], "closed") == 0) failed = print_closed(argc, argv);
    if (argc > 1 && strcmp(argv[1], "rotation") == 0) failed = print_rotation(argc, argv);
    if (failed) fprintf(stderr, "usage: print_plan jacobi M [NAME], print_plan ateb ALPHA [ACCURACY [NAME]],\n"
                                "       print_plan closed ALPHA M0 M1 K0 K1 REACTIVE DAMPING X V ORDER T_END [NAME], or\n"
                                "       print_plan rotation IX IY IZ WX WY WZ [NAME]\n");
    return failed;
}
