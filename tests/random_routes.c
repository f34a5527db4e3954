/* A campaign of minutes (make routes): random oscillators with variable mass, each by vm_osc_plan_within to a random
   tolerance and by single routes, against the exact motion in long double (tests/exact_motion.h). It prints a table in
   Markdown, a row a route, and fails where an estimate promises too much.

       random_routes [COUNT [SEED]]

   Only for double: float cannot hold most of the phases that occur here. */
#define EXACT_LONG
#include "../varmass.h"
#include "check.h"
#include "oscillator_checks.h"
#include "routes_problems.h"
#include "exact_motion.h"
#include "random_routes.h"

/* The rate of the laws, 1/s, and the longest run, s: some 100 vibrations, which the exact motion has to follow */
static const double slowest = 1e-4, fastest = 0.15, longest = 600;

/* Rows of the table: the routes in the order of VM_ROUTE_..., then the choice of vm_osc_plan_within, then its results by
   law and by collocation */
enum { ROUTES = VM_ROUTE_RK87 + 1, WITHIN = ROUTES, WITHIN_LAW, WITHIN_COLLOCATION, WITHIN_RK87, ROWS };
static random_tally tallies[ROWS];

static const char *row_name(int row)
{
    switch (row) {
    case WITHIN: return "**vm_osc_plan_within**";
    case WITHIN_LAW: return "- of these by a law";
    case WITHIN_COLLOCATION: return "- by collocation";
    case WITHIN_RK87: return "- by rk87";
    default: return vm_osc_route_name(row);
    }
}

static int row_of(int route)
{
    if (route == VM_ROUTE_RK87) return WITHIN_RK87;
    return route == VM_ROUTE_COLLOCATION ? WITHIN_COLLOCATION : WITHIN_LAW;
}

/* Tells on the standard error stream which problem missed its tolerance or its estimate. */
static void print_problem(const routes_case *c, int number, double tolerance, const vm_osc_motion *m, double error)
{
    fprintf(stderr,
           "problem %d: alpha %g, r %g, damping %g, mass %d (%g, %g, %g), stiffness %d (%g, %g, %g), x %g, v %g, t %g,\n"
           "    tolerance %.1e, route %d, estimate %.1e, error %.1e\n",
           number, c->alpha, c->reactive, c->damping, c->mass.kind, c->mass.a, c->mass.b, c->mass.c, c->stiffness.kind,
           c->stiffness.a, c->stiffness.b, c->stiffness.c, c->x0, c->v0, c->T, tolerance, m->route, (double)m->error, error);
}

/* One result: its true error is counted in the row. */
static void judge_result(int row, int status, double tolerance, const routes_case *c, const vm_osc_problem *o,
                         const vm_osc_motion *m, int number)
{
    const double own = 1e-12 + 1e-15 * fabs(c->T);
    double error = 0;
    if (status >= 0) error = case_error(c, o, m->x, m->v);
    random_count(&tallies[row], status, tolerance, error, (double)m->error, own);
    if (status < 0) return;
    if ((status == VM_OK && tolerance > 0 && error > tolerance + own) || error > 10 * ((double)m->error + own))
        print_problem(c, number, tolerance, m, error);
}

/* All routes on one problem. Returns 0 where the exact motion was lost. */
static int try_problem(random_numbers *g, int number)
{
    const double rate = draw_spread(g, slowest, fastest), tolerance = draw_spread(g, 1e-11, 1e-2);
    const double T = draw_end(fmin(draw_uniform(g, 0.3, 3) / rate, longest));
    exact_motion exact;
    routes_case c;
    vm_osc_problem o;
    vm_osc_plan plan;
    vm_osc_motion m = {0, 0, 0, 0, 0, 0};
    int route, status;
    exact.c = draw_case(g, rate, T);
    exact_start(&exact, 1e-17L);
    if (!exact_follow(&exact, T)) return 0;
    c = exact.c;
    o = problem_of(&c);
    if (number % 2) o = reversed_problem(&exact.c, &c);
    status = vm_osc_plan_init(&plan, &o);
    CHECK(status == VM_OK);
    if (status) return 1;
    for (route = VM_ROUTE_ATEB; route <= VM_ROUTE_COLLOCATION; route++) {
        const double asked = route == VM_ROUTE_COLLOCATION ? tolerance : 0;
        status = vm_osc_plan_by_route(&plan, route, R(c.T), R(asked), &m);
        judge_result(route, status, asked, &c, &o, &m, number);
    }
    status = vm_osc_plan_within(&plan, R(c.T), R(tolerance), &m);
    judge_result(WITHIN, status, tolerance, &c, &o, &m, number);
    if (status >= 0) judge_result(row_of(m.route), status, tolerance, &c, &o, &m, -1);
    return 1;
}

static void print_row(int row)
{
    random_tally *t = &tallies[row];
    const double runs = fmax(t->runs, 1), n = fmax(t->n, 1);
    qsort(t->ratio, (size_t)t->n, sizeof *t->ratio, random_rising);
    printf("| %s | %d | %d | %.2f %% | %d | %.2f %% | %.2g | %.2g |\n", row_name(row), t->runs, t->failed,
           100 * t->unknown / runs, t->n, 100 * random_above(t, 3) / n, random_worst(t), t->ratio[t->n / 2]);
}

int main(int argc, char **argv)
{
    random_numbers g = {2026};
    int count = 2000, lost = 0, i;
    const random_tally *within = &tallies[WITHIN];
    if (argc > 1) count = atoi(argv[1]);
    if (argc > 2) g.state = strtoull(argv[2], NULL, 10);
    for (i = 0; i < ROWS; i++) {
        tallies[i].ratio = (double *)malloc(sizeof(double) * (size_t)(count + 1));
        tallies[i].ratio[0] = 0;
    }
    for (i = 0; i < count; i++) lost += !try_problem(&g, i);
    for (i = VM_ROUTE_ATEB; i < ROWS; i++)
        if (tallies[i].runs) print_row(i);
    printf("\nThe exact motion could not be computed in %d of the %d problems. In the other problems `vm_osc_plan_within`\n"
           "returned %d times the status VM_OK, which says that the estimated error is within the tolerance. In %d of these\n"
           "cases, which is %.3f %% of them, the true error was above the tolerance.\n", lost, count, within->ok, within->above,
           100. * within->above / fmax(within->ok, 1));
    CHECK(lost <= count / 50);
    CHECK(100 * random_above(within, 3) <= within->n);    /* the true error is above 3 estimates in 1 % at most */
    CHECK(random_above(within, 10) == 0);
    CHECK(1000 * within->above <= within->ok);
    for (i = 0; i < ROWS; i++) free(tallies[i].ratio);
    printf("routes: %ld passed, %ld failed\n", check_passed, check_failed);
    return check_failed > 0;
}
