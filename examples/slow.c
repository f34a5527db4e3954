/* Figs 21, 26-30 and 32: vibrations that change slowly, by direct integration, with the curves as printed and as
   corrected. (Figs 22-25 are in example1.c and example2.c.) A case is one motion with its two curves. A figure is a row
   of diagrams; each diagram shows some cases.

   usage: slow [prefix] writes prefix_21.csv and so on, one file for each figure. For every case a file has two blocks.
   The first block has the columns t, the motion, both branches of the printed curve, and both branches of the corrected
   curve (in Fig. 21 the curves are the motion itself). The second block has t and x at the turning points of the
   motion. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "../varmass.h"
#include "csv.h"

typedef struct motion_case motion_case;
typedef double (*curve)(double t, const motion_case *c);
struct motion_case {
    const char *figure, *label;
    ode_rhs f;
    int n, x, v; /* size of the state; the components that are drawn, and its velocity */
    double t_end;
    curve printed, corrected;
    int waves;                     /* 1: the curves are the motion itself; 0: they are its amplitudes */
    double printed_centre, centre; /* the amplitudes are measured from these values */
    double m0, m1, x0, b;          /* mass m0 + m1 t, first displacement, and b of Fig. 21; b = -1 for (440) */
};

/* ---- Fig. 21, (355): m x'' + x|x|^(1/3) = 0.01 (1 - b) x', m = 1 - 0.01 t ---- */

/* The solution (356). As printed, exponent is 0.27273 and rate is 0.0909; both follow from the wrong 1/(5 - alpha) in
   place of 1/(alpha + 3). */
static double solution_356(double t, double b, double exponent, double rate)
{
    const double m = 1 - 0.01 * t, half = 0.5 * (1 - rate * (1 - 2 * b));
    return 0.1 * pow(m, -exponent * (1 - 2 * b)) * cos(66.02806593723911 / half * (1 - pow(m, half)));
}
static double damped_printed(double t, const motion_case *c) { return solution_356(t, c->b, 0.27273, 0.0909); }
static double damped(double t, const motion_case *c) { return solution_356(t, c->b, 3. / 13, 1. / 13); }

/* ---- Figs 26-29, (440): alpha = 5/3, eps b = eps c = 0.01, m = m0 (1 + 0.01 t) ---- */

/* The amplitude by (424) and case c) as printed, with the means (383), (384), (408) from their printed series */
static double vdp_printed(double t, const motion_case *c)
{
    const double alpha = 5. / 3, k2 = vm_osc_jacobi_parameter(alpha);
    const double C2 = 0.5 + k2 / 16, C4 = 3. / 8 + k2 / 32, C6 = 5. / 16 + 5 * k2 / 256;
    const double a2 = (1 - k2) - (1 - 2 * k2) * C2 - k2 * C4, a1 = (1 - k2) + k2 * C4 + (alpha - 1) / 2 * a2;
    const double a3 = (1 - k2) * C2 - (1 - 2 * k2) * C4 - k2 * C6, x2 = c->x0 * c->x0;
    const double drive = (2 - c->m0) * a2, q = drive / (c->m0 * a1), M = pow(1 + 0.01 * t, q);
    if (drive > 0) return sqrt(M * x2 * drive / (drive + 2 * a3 * x2 * (M - 1)));
    return sqrt(M * x2 * -drive / (-drive + 2 * a3 * x2 * (1 - 1 / M)));
}

static vm_vdp vdp_of(const motion_case *c)
{
    vm_vdp v;
    memset(&v, 0, sizeof v);
    v.k = 1;
    v.reactive = 1;
    if (c->b < 0) { /* (440) */
        v.alpha = 5. / 3;
        v.feed = v.c = 0.01;
    } else { /* (355) */
        v.alpha = 4. / 3;
        v.feed = -0.01 * c->b;
    }
    v.mass = vm_law_linear(c->m0, c->m1);
    vm_vdp_init(&v);
    return v;
}

static double vdp_corrected(double t, const motion_case *c)
{
    const vm_vdp v = vdp_of(c);
    return vm_vdp_amplitude(&v, t, c->x0);
}

/* ---- Fig. 30, (514)-(516), and Fig. 32, (530)-(532): m = 1 + 0.01 t ---- */

/* (513) */
static double fifth_root(double t, const motion_case *c)
{
    (void)c;
    return pow(1 + 0.01 * t, -0.2);
}

static double radius(double t, const motion_case *c)
{
    vm_power_force cubic = {1, 3};
    vm_jeffcott r;
    memset(&r, 0, sizeof r);
    r.stiffness = vm_jeffcott_power;
    r.stiffness_ctx = &cubic;
    r.reactive = 1;
    return vm_jeffcott_amplitude(&r, c->x0, c->m0, c->m0 + c->m1 * t);
}

/* (536) */
static double pair_printed(double t, const motion_case *c)
{
    (void)c;
    return -pow(1 + 0.01 * t, -1. / 6);
}

/* Half of the amplitude of p = y - x; the amplitude is 2 at first */
static double pair(double t, const motion_case *c)
{
    return vm_osc_amplitude_law((c->m0 + c->m1 * t) / c->m0, 0, 1, 3);
}

/* ---- Any case ---- */

enum { MOST_POINTS = 1000 };

typedef struct context {
    vm_vdp vdp;
    vm_power_force cubic;
    vm_jeffcott rotor;
    vm_pair pair;
} context;

/* Writes the state at the start to y, and returns the pointer that the function c->f needs */
static void *start(const motion_case *c, context *x, vm_real *y)
{
    const double half = sqrt(0.5);
    memset(x, 0, sizeof *x);
    x->vdp = vdp_of(c);
    x->cubic.k = 1;
    x->cubic.alpha = 3;
    x->rotor.mass = x->pair.mass = vm_law_linear(c->m0, c->m1);
    x->rotor.stiffness = vm_jeffcott_power;
    x->rotor.stiffness_ctx = &x->cubic;
    x->rotor.reactive = 1;
    x->pair.alpha = 3;
    x->pair.k = 1;
    x->pair.reactive = 1;
    if (c->f == vm_jeffcott_rhs) {
        y[0] = y[1] = y[3] = half;
        y[2] = -half;
        return &x->rotor;
    }
    if (c->f == vm_pair_rhs) {
        y[0] = 1;
        y[1] = 3;
        y[2] = y[3] = 0;
        return &x->pair;
    }
    y[0] = c->x0;
    y[1] = 0;
    return &x->vdp;
}

/* The two branches of a curve at t. They are the same if the curve is the motion itself, and for (536), which gives a
   negative amplitude. */
typedef struct branches {
    double upper, lower;
} branches;

static branches at(const motion_case *c, double t, curve f, double centre)
{
    const double value = f(t, c);
    branches b;
    b.upper = centre + value;
    b.lower = c->waves || value < 0 ? b.upper : centre - value;
    return b;
}

typedef struct errors {
    double printed, corrected;
    long turning_points;
} errors;

/* Compares x with the nearer branch of each curve. If a printed formula gives NaN, because it has the root of a
   negative number, this counts as the largest error. */
static void compare(errors *e, const motion_case *c, double t, double x)
{
    const branches p = at(c, t, c->printed, c->printed_centre), k = at(c, t, c->corrected, c->centre);
    const double printed = fmin(fabs(x - p.upper), fabs(x - p.lower));
    const double corrected = fmin(fabs(x - k.upper), fabs(x - k.lower));
    if (!(printed <= e->printed)) e->printed = printed;
    if (!(corrected <= e->corrected)) e->corrected = corrected;
}

static void write_row(FILE *csv, const motion_case *c, double t, double x)
{
    const branches p = at(c, t, c->printed, c->printed_centre), k = at(c, t, c->corrected, c->centre);
    fprintf(csv, "%.6g,%.6g,%.6g,%.6g,%.6g,%.6g\n", t, x, p.upper, p.lower, k.upper, k.lower);
}

/* Integrates a case, writes its two blocks, and finds the largest errors: if a curve is an amplitude, at the turning
   points; if it is the motion, at all times */
static int run(const motion_case *c, FILE *csv, errors *e)
{
    static vm_sample points[MOST_POINTS];
    vm_real y[4], work[RK45_WORK(4)], sample[4];
    const double spacing = c->t_end / 1500;
    rk45_options options = rk45_defaults(NULL);
    rk45 s;
    context x;
    double t_next = 0;
    void *ctx = start(c, &x, y);
    long i, n = 0;
    int status;
    options.rtol = options.atol = 1e-10;
    status = rk45_init(&s, c->f, ctx, c->n, 0, y, &options, work);
    e->printed = e->corrected = 0;
    if (csv) fprintf(csv, "t,\"%s\"\n", c->label);
    while (status >= 0 && s.t < c->t_end) {
        status = rk45_step(&s);
        n += vm_find_samples_of_step(&s, c->x, c->v, VM_TURNING_POINTS, sample, MOST_POINTS - n, points + n);
        for (; t_next <= s.t && t_next <= c->t_end; t_next += spacing) {
            rk45_interpolate(&s, t_next, sample);
            if (c->waves) compare(e, c, t_next, sample[c->x]);
            if (csv) write_row(csv, c, t_next, sample[c->x]);
        }
    }
    if (csv) fprintf(csv, "\n\nt,\"turning points\"\n");
    for (i = 0; i < n; i++) {
        if (points[i].t > c->t_end) continue;
        if (!c->waves) compare(e, c, points[i].t, points[i].x);
        if (csv) fprintf(csv, "%.6g,%.6g\n", points[i].t, points[i].x);
    }
    if (csv) fprintf(csv, "\n\n");
    e->turning_points = n;
    return status;
}

int main(int argc, char **argv)
{
#define DAMPED(label, b)                                                                        \
    {                                                                                           \
        "21", label, vm_vdp_rhs, 2, 0, 1, 90, damped_printed, damped, 1, 0, 0, 1, -0.01, 0.1, b \
    }
#define VDP(figure, m0, x0)                                                                                   \
    {                                                                                                         \
        figure, "m0 = " #m0 "; x0 = " #x0, vm_vdp_rhs, 2, 0, 1, 400, vdp_printed, vdp_corrected, 0, 0, 0, m0, \
            0.01 * m0, x0, -1                                                                                 \
    }
#define ROTOR(label, x)                                                                         \
    {                                                                                           \
        "30", label, vm_jeffcott_rhs, 4, x, x + 2, 200, fifth_root, radius, 0, 0, 0, 1, 0.01, 1, 0 \
    }
#define PAIR(label, x)                                                                        \
    {                                                                                         \
        "32", label, vm_pair_rhs, 4, x, x + 2, 60, pair_printed, pair, 0, 0, 2, 1, 0.01, 1, 0 \
    }
    static const motion_case cases[] = {
        DAMPED("b = 0", 0),     DAMPED("b = 1/2", 0.5), DAMPED("b = 1", 1),    VDP("26", 0.5, 0.5),
        VDP("26", 0.5, 1.691),  VDP("26", 0.5, 2.5),    VDP("26", 1, 0.5),     VDP("26", 1, 1.381),
        VDP("26", 1, 2.5),      VDP("26", 1.5, 0.5),    VDP("26", 1.5, 0.976), VDP("26", 1.5, 2.5),
        VDP("27", 1, 2.5),      VDP("27", 1, 1.381),    VDP("27", 1, 0.5),     VDP("28", 3, 0.5),
        VDP("28", 3, 1.5),      VDP("28", 3, 2.5),      VDP("29", 3, 2.5),     VDP("29", 3, 0.5),
        ROTOR("x of (514)", 0), ROTOR("y of (515)", 1), PAIR("x of (530)", 0), PAIR("y of (531)", 1),
    };
    const motion_case *const end = cases + sizeof cases / sizeof *cases, *c;
    const char *open = "";
    FILE *csv = NULL;
    puts("Largest error of the curves against direct integration (of amplitudes at the turning points)");
    printf("  %-6s %-22s %-14s %-12s %s\n", "figure", "", "turning points", "as printed", "corrected");
    for (c = cases; c < end; c++) {
        errors e;
        if (argc > 1 && strcmp(open, c->figure)) {
            csv_close(csv);
            csv = csv_open(argv[1], c->figure);
            open = c->figure;
        }
        if (run(c, csv, &e) < 0) return 1;
        printf("  %-6s %-22s %-14ld %-12.1e %.1e\n", c->figure, c->label, e.turning_points, e.printed, e.corrected);
    }
    csv_close(csv);
    return 0;
}
