/* Tables 1 to 4 of the dissertation, row by row, with numbers: what the text prints, what is true, and the call
   that gives it. Tables 2 to 4 are separations in the plane. For each row the text gives a motion of the part
   and the motion of the rest that follows; its formula is evaluated here as printed and, where it is wrong, as
   corrected, and the call must give the corrected values. tests/test_jump_equations.c has the same rows for
   random bodies.

   usage: tables             checks all rows
          tables markdown    prints them as docs/tables.md */
#include "../varmass.h"
#include "check.h"

#define R(x) ((vm_real)(x))
static const double eps = (double)VM_EPSILON;
static int prints;

/* ---- The sample: a plate of 5 kg from which a part of 1 kg separates ---- */

/* The letters of the text: M, I_S of the whole; m, I_S2, SS2 of the part; I_S1, SS1 of the rest; v_S, Omega */
typedef struct sample {
    double M, I, m, I2, d[2], I1, d1[2], v[2], O;
} sample;

/* The motion of one body: velocity of its mass centre and angular velocity */
typedef struct motion {
    double v[2], O;
} motion;

static double cross(const double *a, const double *b) { return a[0] * b[1] - a[1] * b[0]; }

static sample make_sample(double vx, double vy, double O)
{
    sample s;
    memset(&s, 0, sizeof s);
    s.M = 5;
    s.I = 2;
    s.m = 1;
    s.I2 = 0.125;
    s.d[0] = 0.5;
    s.d[1] = 0.25;
    s.d1[0] = -s.d[0] * s.m / (s.M - s.m);
    s.d1[1] = -s.d[1] * s.m / (s.M - s.m);
    s.I1 = s.I - s.I2 - s.m * s.M / (s.M - s.m) * (s.d[0] * s.d[0] + s.d[1] * s.d[1]);
    s.v[0] = vx;
    s.v[1] = vy;
    s.O = O;
    return s;
}

/* The motion of the part with v_r and Omega_r relative to the whole, (25), (41) */
static motion relative(const sample *s, double vx, double vy, double Or)
{
    motion p;
    p.v[0] = s->v[0] - s->O * s->d[1] + vx;
    p.v[1] = s->v[1] + s->O * s->d[0] + vy;
    p.O = s->O + Or;
    return p;
}

static motion absolute(double vx, double vy, double O)
{
    motion p;
    p.v[0] = vx;
    p.v[1] = vy;
    p.O = O;
    return p;
}

/* v_S1 = v_S + Omega x SS1 - m/(M - m) v_r, which is the first line of every row (28); Omega_1 is given. */
static motion rest_of(const sample *s, const motion *p, double O1)
{
    const double k = s->m / (s->M - s->m);
    motion r;
    r.v[0] = s->v[0] - s->O * s->d1[1] - k * (p->v[0] - s->v[0] + s->O * s->d[1]);
    r.v[1] = s->v[1] + s->O * s->d1[0] - k * (p->v[1] - s->v[1] - s->O * s->d[0]);
    r.O = O1;
    return r;
}

static vm_body2 whole_of(const sample *s)
{
    vm_body2 b;
    memset(&b, 0, sizeof b);
    b.mass = R(s->M);
    b.inertia = R(s->I);
    b.vx = R(s->v[0]);
    b.vy = R(s->v[1]);
    b.omega = R(s->O);
    return b;
}

static vm_body2 part_of(const sample *s, const motion *p)
{
    vm_body2 b;
    memset(&b, 0, sizeof b);
    b.mass = R(s->m);
    b.inertia = R(s->I2);
    b.x = R(s->d[0]);
    b.y = R(s->d[1]);
    b.vx = R(p->v[0]);
    b.vy = R(p->v[1]);
    b.omega = R(p->O);
    return b;
}

/* ---- Rows ---- */

/* A row with its formulas in words. `correction` is NULL where the row holds as printed. `printed` is the
   motion of the rest by the text, `truth` the corrected one, and asked_O is the Omega_1 that the row wants, or
   NaN. */
typedef struct table_row {
    const char *name, *input, *output, *correction;
    motion part, printed, truth;
    double asked_O;
} table_row;

/* What is a rounding error from 0 is printed as 0. */
static double clean(double x) { return fabs(x) < 1e-12 ? 0 : x; }

static void print_motion(const motion *p)
{
    printf(" (%.6g, %.6g), %.6g |", clean(p->v[0]), clean(p->v[1]), clean(p->O));
}

/* The call of a row, and how its result compares with both formulas */
static void try_row(const sample *s, const table_row *row)
{
    const vm_body2 whole = whole_of(s);
    vm_body2 part = part_of(s, &row->part), rest = part, moving = part;
    const vm_real asked = R(row->asked_O);
    const double size = 10 * eps;
    motion got;
    double off, as_printed;
    CHECK(vm_separate2(&whole, &part, NULL, &rest) == VM_OK);
    got = absolute((double)rest.vx, (double)rest.vy, (double)rest.omega);
    off = fabs(got.v[0] - row->truth.v[0]) + fabs(got.v[1] - row->truth.v[1]) + fabs(got.O - row->truth.O);
    as_printed =
        fabs(got.v[0] - row->printed.v[0]) + fabs(got.v[1] - row->printed.v[1]) + fabs(got.O - row->printed.O);
    check_error("row", row->name, "10 eps", off / (1 + fabs(got.O)) / size, 8, got.O, 0);
    CHECK((as_printed > 0.1) == (row->correction != NULL));
    if (asked == asked) { /* the inverse question: which Omega_2 gives this Omega_1? */
        part.omega = 0;
        CHECK(vm_separation_for_rest2(&whole, &part, NULL, NULL, &asked, &moving) == VM_OK);
        check_error("asked", row->name, "10 eps",
                    fabs((double)moving.omega - row->part.O) / (1 + fabs(row->part.O)) / size, 8, row->part.O,
                    0);
    }
    if (!prints) return;
    printf("| %s | %s |", row->name, row->input);
    print_motion(&row->part);
    printf(" %s |", row->output);
    print_motion(&row->printed);
    print_motion(&got);
    printf(" %s | %s |\n", row->correction ? row->correction : "holds",
           asked == asked ? "`vm_separation_for_rest2`" : "`vm_separate2`");
}

static void give_row(const sample *s, const char *name, const char *input, const char *output, motion part,
                     double printed_O, const char *correction, double true_O)
{
    table_row row;
    row.name = name;
    row.input = input;
    row.output = output;
    row.correction = correction;
    row.part = part;
    row.printed = rest_of(s, &part, printed_O);
    row.truth = rest_of(s, &part, true_O);
    row.asked_O = (double)VM_NAN;
    try_row(s, &row);
}

/* A row that asks for an angular velocity of the rest: the part's Omega_2 is the answer. */
static void give_answer(const sample *s, const char *name, const char *input, const char *output, motion part,
                        double asked)
{
    table_row row;
    row.name = name;
    row.input = input;
    row.output = output;
    row.correction = NULL;
    row.part = part;
    row.printed = row.truth = rest_of(s, &part, asked);
    row.asked_O = asked;
    try_row(s, &row);
}

static void print_table_head(const char *title, const char *text)
{
    if (!prints) return;
    printf("\n## %s\n\n%s\n\n", title, text);
    puts("| row | part in the text | its **v**_S2, Ω_2 | rest in the text | **v**_S1, Ω_1 as printed | true | "
         "verdict | call |");
    puts("|---|---|---|---|---|---|---|---|");
}

/* Omega_1 by I_S1 Omega_1 = I_S Omega - m M/(M - m) SS2 x (v_S2 - v_S) - I_S2 Omega_2, (34) in the plane */
static double true_spin(const sample *s, const motion *p)
{
    const double v[2] = {p->v[0] - s->v[0], p->v[1] - s->v[1]};
    return (s->I * s->O - s->m * s->M / (s->M - s->m) * cross(s->d, v) - s->I2 * p->O) / s->I1;
}

/* The whole is in translation: v_S = (3, 1), Omega = 0 */
static void table2(void)
{
    const sample s = make_sample(3, 1, 0);
    const double share = s.m * s.M / (s.M - s.m), all = s.M / s.m, dxv = cross(s.d, s.v);
    motion p = absolute(4, -1, 2), p0 = absolute(4, -1, 0), q;
    const double vr[2] = {p.v[0] - s.v[0], p.v[1] - s.v[1]};
    const motion r = rest_of(&s, &p, 0);
    const double slip[2] = {r.v[0] - p.v[0], r.v[1] - p.v[1]};
    print_table_head("Table 2: the whole is in translation",
                     "Before the separation, the plate has the velocity **v**_S = (3, 1) m/s and the angular velocity "
                     "Ω = 0.");
    give_row(&s, "T2.1", "**v**_S2, Ω_2",
             "**v**_r1 = -m/(M-m) **v**_r; I_S1 Ω_1 = m **SS**_2×(**v**_S1-**v**_S2) - I_S2 Ω_2", p,
             (s.m * cross(s.d, slip) - s.I2 * p.O) / s.I1, NULL, true_spin(&s, &p));
    give_row(&s, "T2.2", "**v**_S2, Ω_2 = 0",
             "**v**_r1 = -m/(M-m) **v**_r; I_S1 Ω_1 = m **SS**_2×(**v**_S1-**v**_S2)", p0,
             s.m * cross(s.d, slip) / s.I1, NULL, true_spin(&s, &p0));
    q = absolute(0, 0, 2);
    give_row(&s, "T2.3", "**v**_S2 = 0, Ω_2",
             "**v**_S1 = M/(M-m) **v**_S; I_S1 Ω_1 = Mm/(M-m) **SS**_2×**v**_S - I_S2 Ω_2", q,
             (share * dxv - s.I2 * q.O) / s.I1, NULL, true_spin(&s, &q));
    q = absolute(0, 0, 0);
    give_row(&s, "T2.4", "**v**_S2 = 0, Ω_2 = 0",
             "**v**_S1 = M/(M-m) **v**_S; I_S1 Ω_1 = Mm/(M-m) **SS**_2×**v**_S", q, share * dxv / s.I1, NULL,
             true_spin(&s, &q));
    q = absolute(4, -1, -share / s.I2);
    give_row(&s, "T2.5", "**v**_S2, Ω_2 = -mM/(I_S2(M-m)) (cut off)",
             "**v**_S1 = **v**_S - m/(M-m) **v**_r; Ω_1 = 0", q, 0,
             "wrong: the factor **SS**_2×**v**_r is missing", true_spin(&s, &q));
    give_answer(&s, "T2.5 corrected", "**v**_S2, Ω_2 = -mM/(I_S2(M-m)) **SS**_2×**v**_r", "Ω_1 = 0",
                absolute(4, -1, -share / s.I2 * cross(s.d, vr)), 0);
    q = absolute(all * s.v[0], all * s.v[1], 2);
    give_row(&s, "T2.6", "**v**_S2 = M/m **v**_S, Ω_2",
             "**v**_S1 = 0; I_S1 Ω_1 = -M(**SS**_2×**v**_S) - I_S2 Ω_2", q, (-s.M * dxv - s.I2 * q.O) / s.I1,
             NULL, true_spin(&s, &q));
    give_answer(&s, "T2.7", "**v**_S2 = M/m **v**_S, Ω_2 = M/I_S2 (**v**_S×**SS**_2) (cut off)",
                "**v**_S1 = 0; Ω_1 = 0 (cut off)", absolute(all * s.v[0], all * s.v[1], -s.M / s.I2 * dxv), 0);
    q = absolute(s.v[0], s.v[1], 2);
    give_row(&s, "T2.8", "**v**_S2 = **v**_S, Ω_2", "**v**_S1 = **v**_S; I_S1 Ω_1 = -I_S2 Ω_r", q,
             -s.I2 * q.O / s.I1, NULL, true_spin(&s, &q));
}

/* Rows 6 to 8 of Table 3, where v_r stops the rest, or a spin is asked */
static void table3_special(const sample *s)
{
    const double square = s->d1[0] * s->d1[0] + s->d1[1] * s->d1[1],
                 turn = s->M * (s->M - s->m) / s->m * s->O * square;
    const double back = (s->M - s->m) / s->m * s->O, vr[2] = {-back * s->d1[1], back * s->d1[0]},
                 any[2] = {1, -2};
    const double pull = s->M * cross(s->d1, any);
    motion p = relative(s, vr[0], vr[1], 3);
    give_row(s, "T3.6", "**v**_r = (M-m)/m (**Ω**×**SS**_1), Ω_r",
             "**v**_S1 = 0; Ω_r1 = M(M-m)/(m I_S1) Ω SS_1² + I_S2/I_S1 Ω_r", p,
             s->O + turn / s->I1 + s->I2 / s->I1 * 3, "wrong: the last sign is minus", true_spin(s, &p));
    p = relative(s, any[0], any[1], (pull + s->I1 * s->O) / s->I2);
    give_row(s, "T3.7", "**v**_r, I_S2 Ω_r = M(**SS**_1×**v**_r) + I_S1 Ω", "Ω_r1 = 0, Ω_1 = Ω", p, s->O,
             "wrong: this gives Ω_1 = 0", true_spin(s, &p));
    give_answer(s, "T3.7 corrected", "**v**_r, I_S2 Ω_r = M(**SS**_1×**v**_r)", "Ω_r1 = 0, Ω_1 = Ω",
                relative(s, any[0], any[1], pull / s->I2), s->O);
    p = relative(s, vr[0], vr[1], s->I1 / s->I2 * s->O - turn / s->I2);
    give_row(s, "T3.8", "**v**_r as in row 6, Ω_r = (I_S1/I_S2 - M(M-m)/m SS_1²/I_S2) Ω",
             "**v**_S1 = 0; Ω_r1 = 0, Ω_1 = Ω", p, s->O, "wrong: this gives neither Ω_1 = Ω nor 0",
             true_spin(s, &p));
    give_answer(s, "T3.8 corrected", "**v**_r as in row 6, Ω_r = M(M-m)/m SS_1²/I_S2 Ω", "Ω_1 = Ω",
                relative(s, vr[0], vr[1], turn / s->I2), s->O);
    give_answer(s, "T3.8 for Ω_1 = 0", "**v**_r as in row 6, Ω_r = (I_S1/I_S2 + M(M-m)/m SS_1²/I_S2) Ω",
                "Ω_1 = 0", relative(s, vr[0], vr[1], (turn + s->I1 * s->O) / s->I2), 0);
}

/* The whole rotates about S: v_S = 0, Omega = 2 */
static void table3(void)
{
    const sample s = make_sample(0, 0, 2);
    const double vr[2] = {1, -2}, along[2] = {s.d1[0] * 8, s.d1[1] * 8};
    motion p = relative(&s, vr[0], vr[1], 3);
    print_table_head("Table 3: the whole rotates about its mass centre",
                     "Before the separation, the plate has the velocity **v**_S = 0 and the angular velocity Ω = 2 rad/s.");
    give_row(&s, "T3.1", "**v**_r, Ω_r",
             "**v**_S1 = **Ω**×**SS**_1 - m/(M-m) **v**_r; Ω_r1 = M/I_S1 (**SS**_1×**v**_r) - I_S2/I_S1 Ω_r", p,
             s.O + s.M / s.I1 * cross(s.d1, vr) - s.I2 / s.I1 * 3, NULL, true_spin(&s, &p));
    p = relative(&s, 0, 0, 3);
    give_row(&s, "T3.2", "**v**_r = 0, Ω_r", "**v**_S1 = **Ω**×**SS**_1; Ω_r1 = -I_S2/I_S1 Ω_r", p,
             s.O - s.I2 / s.I1 * 3, NULL, true_spin(&s, &p));
    p = relative(&s, 0, 0, 0);
    give_row(&s, "T3.3", "**v**_r = 0, Ω_r = 0", "**v**_S1 = **Ω**×**SS**_1; Ω_r1 = 0, Ω_1 = Ω", p, s.O, NULL,
             true_spin(&s, &p));
    p = relative(&s, along[0], along[1], 3);
    give_row(&s, "T3.4", "**v**_r ∥ **SS**_1, Ω_r",
             "**v**_S1 = **Ω**×**SS**_1 - m/(M-m) **v**_r; Ω_r1 = -I_S2/I_S1 Ω_r", p, s.O - s.I2 / s.I1 * 3,
             NULL, true_spin(&s, &p));
    p = relative(&s, vr[0], vr[1], -s.O);
    give_row(&s, "T3.5", "**v**_S2 = **Ω**×**SS**_2 + **v**_r, Ω_2 = 0",
             "**v**_S1 = -m/(M-m) **v**_S2; I_S1 Ω_1 = I_S Ω - Mm/(M-m) (**SS**_2×**v**_S2)", p,
             (s.I * s.O - s.M * s.m / (s.M - s.m) * cross(s.d, p.v)) / s.I1, NULL, true_spin(&s, &p));
    table3_special(&s);
}

/* Plane motion: v_S = (3, 1), Omega = 2 */
static void table4(void)
{
    const sample s = make_sample(3, 1, 2);
    motion p = absolute(3, 1, 5);
    print_table_head("Table 4: plane motion of the whole",
                     "Before the separation, the plate has the velocity **v**_S = (3, 1) m/s and the angular velocity "
                     "Ω = 2 rad/s.");
    give_row(&s, "T4.1", "**v**_r = **SS**_2×**Ω** (**v**_S2 = **v**_S), Ω_2",
             "**v**_S1 = **v**_S; Ω_1 = (I_S Ω - I_S2 Ω_2)/I_S1", p, (s.I * s.O - s.I2 * p.O) / s.I1, NULL,
             true_spin(&s, &p));
    give_answer(&s, "T4.2", "**v**_S2 = **v**_S, Ω_2 = (I_S/I_S2) Ω", "**v**_S1 = **v**_S; Ω_1 = 0",
                absolute(3, 1, s.I / s.I2 * s.O), 0);
    p = absolute(3, 1, 0);
    give_row(&s, "T4.3", "**v**_S2 = **v**_S, Ω_2 = 0", "**v**_S1 = **v**_S; Ω_1 = (I_S/I_S1) Ω", p,
             s.I / s.I1 * s.O, NULL, true_spin(&s, &p));
    p = absolute(3, 1, s.O);
    give_row(&s, "T4.4", "**v**_S2 = **v**_S, Ω_r = 0", "**v**_S1 = **v**_S; Ω_1 = Ω, Ω_r1 = 0", p, s.O,
             "wrong: Ω_1 = (I_S-I_S2)/I_S1 Ω", true_spin(&s, &p));
    p = relative(&s, 0, 0, 0);
    give_row(&s, "T4.5", "**v**_r = 0, Ω_r = 0", "**v**_r1 = 0, Ω_r1 = 0", p, s.O, NULL, true_spin(&s, &p));
}

/* ---- Table 1: nomenclature ---- */

/* A row: the printed label with its entries, the label that belongs to them, and three values by a call */
static void name_row(const char *printed, const char *entries, const char *label, const char *call,
                     const char *values)
{
    if (prints) printf("| %s | %s | %s | `%s` | %s |\n", printed, entries, label, call, values);
}

/* The three bodies of the sample of Table 4, with row 1: whole, rest and part in space */
static void table1(void)
{
    const sample s = make_sample(3, 1, 2);
    const motion p = absolute(3, 1, 5);
    const vm_body2 whole2 = whole_of(&s), part2 = part_of(&s, &p);
    const vm_vec3 origin = {0, 0, 0};
    vm_body2 rest2 = whole2;
    vm_body whole, part, rest;
    char line[5][96];
    CHECK(vm_separate2(&whole2, &part2, NULL, &rest2) == VM_OK);
    whole = vm_body_from_body2(&whole2);
    part = vm_body_from_body2(&part2);
    rest = vm_body_from_body2(&rest2);
    snprintf(line[0], sizeof line[0], "-, (%g, %g), (%g, %g)", (double)rest.r.x, (double)rest.r.y,
             (double)part.r.x, (double)part.r.y);
    snprintf(line[1], sizeof line[1], "%g, %g, %g", (double)whole.mass, (double)rest.mass, (double)part.mass);
    snprintf(line[2], sizeof line[2], "%g, %.6g, %g", (double)whole.omega.z, (double)rest.omega.z,
             (double)part.omega.z);
    snprintf(line[3], sizeof line[3], "(%g, %g), (%g, %g), (%g, %g)", (double)vm_momentum(&whole).x,
             (double)vm_momentum(&whole).y, (double)vm_momentum(&rest).x, (double)vm_momentum(&rest).y,
             (double)vm_momentum(&part).x, (double)vm_momentum(&part).y);
    snprintf(line[4], sizeof line[4], "%.6g, %.6g, %.6g", (double)vm_angular_momentum(&whole, origin).z,
             (double)vm_angular_momentum(&rest, origin).z, (double)vm_angular_momentum(&part, origin).z);
    CHECK(vm_momentum(&whole).x == vm_momentum(&rest).x + vm_momentum(&part).x);
    if (prints)
        puts("\n## Table 1: nomenclature\n\nIn each row, Table 1 of the dissertation has a label, which says what the "
             "letters of the row mean. But each label is printed one row too high, beside the letters of the row above "
             "its own. For example, the label \"Mass center\" is printed beside the indices -, 1, 2 of the bodies; it "
             "should be in the next row, beside S, S_1, S_2. The table below shows each printed label, the entries "
             "beside it, and the label that these entries should have. The column \"here\" has the names that the kit "
             "uses. The last column has the values for row T4.1 (row 1 of Table 4), in this order: the whole, the "
             "rest, the part.\n\n| the printed label | entries in its row | their true label | here | values "
             "|\n|---|---|---|---|---|");
    name_row("Mass center", "-, 1, 2", "body (index)", "vm_body whole, rest, part", "");
    name_row("Position of mass center", "S, S_1, S_2", "mass center", "r", "(0, 0) is S");
    name_row("Position vector of mass center", "**SS**_1, **SS**_2", "position of mass center",
             "rest.r - whole.r", line[0]);
    name_row("Mass", "**r**_S, **r**_S1, **r**_S2", "position vector of mass center", "r", "");
    name_row("Absolute velocity of mass center", "M, M∓m, ∓m", "mass", "mass", line[1]);
    name_row("Relative velocity of mass center", "**v**_S, **v**_S1, **v**_S2",
             "absolute velocity of mass center", "v", "");
    name_row("Absolute angular velocity", "**v**_r1, **v**_r", "relative velocity of mass center",
             "vm_to_relative", "");
    name_row("Relative angular velocity", "**Ω**, **Ω**_1, **Ω**_2", "absolute angular velocity", "omega",
             line[2]);
    name_row("Moment of inertia tensor", "**Ω**_r1, **Ω**_r", "relative angular velocity", "vm_to_relative",
             "");
    name_row("Linear momentum", "**I**_S, **I**_S1, **I**_S2", "moment of inertia tensor", "inertia", "");
    name_row("Angular momentum relating to O", "**K**, **K**_1, **K**_2", "linear momentum", "vm_momentum",
             line[3]);
    name_row("Angular momentum relating to mass center", "**L**_O, **L**_S, **L**_S1",
             "angular momentum relating to O (and to the mass center)", "vm_angular_momentum", line[4]);
    name_row("(none)", "**L**_S2, **L**_S2", "angular momentum relating to mass center", "vm_angular_momentum",
             "");
}

static void print_head(void)
{
    puts("# Tables 1 to 4 of the dissertation\n\nThis page is written by `make tables` (tests/test_tables.c). `make "
         "test` checks each row of the tables on this page. The dissertation is *Dynamics of Mass Variable System* by "
         "Cveticanin. This page has every row of the dissertation's Tables 1 to 4, with an example in numbers. The "
         "program build/examples/table5 prints Table 5 of the dissertation. [errata.md](errata.md) lists the errors of "
         "the dissertation.\n\nTables 2 to 4 are about a body from which a part separates: they give the motion of "
         "what remains. In the example of this page, the body is a plate. The plate before the separation is called "
         "the whole, and what remains of the plate is called the rest. The whole has the mass M = 5 kg, the moment of "
         "inertia I_S = 2 kg m² and its mass centre S at the origin. The part has the mass m = 1 kg and the moment of "
         "inertia I_S2 = 0.125 kg m², and the vector from S to its mass centre is **SS**_2 = (0.5, 0.25) m. From this "
         "it follows that the vector from S to the mass centre of the rest is **SS**_1 = (-0.125, -0.0625) m, and that "
         "the rest has the moment of inertia I_S1 = 1.484375 kg m². In the tables, **v** is a velocity and Ω an "
         "angular velocity. The index after such a letter says which body is meant: no index or the index S means the "
         "whole, S1 or 1 means the rest, and S2 or 2 means the part. All lengths in the tables are in m, velocities in "
         "m/s, angular velocities in rad/s. The index r means that the motion of the part is given relative to the "
         "whole, which may rotate: **v**_r = **v**_S2 - **v**_S - **Ω**×**SS**_2 and Ω_r = Ω_2 - Ω. The index r1 means "
         "the same for the rest: **v**_r1 = **v**_S1 - **v**_S - **Ω**×**SS**_1 and Ω_r1 = Ω_1 - Ω. In Tables 2 to 4, "
         "the column \"call\" names the function of the kit that computes the row. The function `vm_separate2` "
         "computes the motion of the rest from **v**_S2 and Ω_2, the motion of the part. (The function "
         "`vm_separate_relative2` computes the same from **v**_r and Ω_r.) In some rows the rest shall get a given "
         "angular velocity Ω_1, for example 0; the formula in the second column then says which angular velocity the "
         "part must have. In these rows the kit does not use this formula: `vm_separation_for_rest2` computes Ω_2 from "
         "Ω_1, and the third column has the result.\n\nIn Tables 2 to 4, the column \"part in the text\" has the "
         "motion that the dissertation assumes for the part; the third column has this motion in numbers. The column "
         "\"rest in the text\" has the dissertation's formula for the motion of the rest. The column \"as printed\" "
         "has the values that this formula gives. The column \"true\" has the values that the kit computes; they are "
         "correct, because `make test` compares them with the laws of conservation of momentum and angular momentum. "
         "The verdict \"holds\" means that the dissertation's formula is right. The words \"(cut off)\" mean that the "
         "dissertation prints only a part of the formula. If a row has a wrong formula for Ω_2 or Ω_r, a row "
         "\"corrected\" with the right formula follows. Row T3.8 is followed by one more row, \"T3.8 for Ω_1 = 0\", "
         "which has the formula for a rest that does not rotate.");
}

int main(int argc, char **argv)
{
    prints = argc > 1 && strcmp(argv[1], "markdown") == 0;
    if (prints) print_head();
    table1();
    table2();
    table3();
    table4();
    return prints ? 0 : check_finish("tables");
}
