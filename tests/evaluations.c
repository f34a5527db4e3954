/* Random evaluations of every special function, by the thousand million. They check ranges, symmetries, identities within
   the promised bounds, that neighbours are in order, and inverses. bench/evaluations.sh runs this program for each row of
   docs/evaluations.md. The first violations go to stderr with their inputs.

   usage: evaluations COUNT SEED ROW   COUNT evaluations of the functions of this row, counted from 1, or COUNT/10 if they
                                       are slow; prints NAME|EVALUATIONS|VIOLATIONS. With -fopenmp on all cores.
          evaluations rows             the names of the rows, a line each */
#include "../varmass.h"

#include "evaluations/ateb.h"
#include "evaluations/elliptic.h"
#include "evaluations/jacobi.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct job {
    const char *name;
    trial (*run)(random_bits *g);
    int evaluations; /* of each of its functions in one trial, at least */
    int slower;      /* how many times fewer trials a slow function gets */
} job;

static const job jobs[] = {{"sn, cn, dn", try_sncndn, 2 * PHASES, 1},
                           {"sn, cn, dn, m1", try_sncndn_m1, PHASES, 1},
                           {"sn rises", try_sn_rises, 2 * PHASES, 1},
                           {"cd, sd, sc", try_quotients, PHASES, 1},
                           {"jacobi_plan", try_jacobi_plan, 64, 1},
                           {"am", try_am, 3 * PHASES, 1},
                           {"K, k'K", try_K, 1, 1},
                           {"E", try_E, 2, 1},
                           {"K, E, Legendre", try_legendre, 1, 1},
                           {"F, E, incomplete", try_incomplete, 2, 1},
                           {"Pi, incomplete", try_Pi, 1, 1},
                           {"inverse sn, cn", try_inverse_sn, 1, 1},
                           {"R_F, R_C, R_D, R_J, R_G", try_carlson, 1, 1},
                           {"solve k'K, m1", try_solve_kpK, 1, 1},
                           {"solve K, m1", try_solve_K, 1, 1},
                           {"cn means", try_cn_means, 1, 1},
                           {"sa, ca", try_saca, 2 * PHASES, 1},
                           {"sa, ca monotone", try_saca_rises, 2 * PHASES, 1},
                           {"ateb_plan", try_ateb_plan, 256, 1},
                           {"Pi_alpha", try_pi, 2, 1},
                           {"ateb_phase", try_phase, PHASES, 1},
                           {"ateb integrals", try_integrals, PHASES, 1},
                           {"beta", try_beta, 2, 1},
                           {"beta_inc", try_beta_inc, 2, 1},
                           {"beta_inc_inv", try_beta_inverse, 2, 10},
                           {"sa, ca (n, m)", try_saca_nm, 1, 10},
                           {"ateb_mean", try_mean, 2, 1},
                           {"Lambert W", try_lambert, 1, 1},
                           {"ns, nc, nd, cs, ds, dc", try_reciprocals, PHASES, 1},
                           {"sn, cn, dn, m > 1", try_large_m, PHASES, 1},
                           {"agm", try_agm, PHASES, 1},
                           {"jacobi_plan, arrays", try_jacobi_arrays, 64, 1},
                           {"D", try_D, 1, 1},
                           {"D, incomplete", try_D_incomplete, 1, 1},
                           {"F, E, D, incomplete, m1", try_incomplete_m1, 1, 1},
                           {"Pi", try_Pi_complete, 1, 1},
                           {"Pi, incomplete, m1", try_Pi_m1, 1, 1},
                           {"inverse dn", try_inverse_dn, 1, 1},
                           {"inverse sn, cn, dn, m1", try_inverses_m1, 1, 1},
                           {"solve K, k'K", try_solve_m, 1, 1},
                           {"ateb_plan, shorter", try_short_plan, 256, 1},
                           {"ateb_plan, arrays", try_ateb_arrays, 256, 1},
                           {"ln beta", try_ln_beta, 2, 1},
                           {"ln beta_inc", try_ln_beta_inc, 1, 1},
                           {"beta_inc_inv, both", try_both_inverses, 1, 10},
                           {"ateb_mean (n, m)", try_mean_nm, 3, 1},
                           {"Lambert W, x < 0", try_lambert_branches, 1, 1}};

static long run(const job *j, int number, double count, uint64_t seed)
{
    const long blocks = (long)(count / j->slower / j->evaluations / BLOCK) + 1;
    long violations = 0, done = 0, b;
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic) reduction(+ : violations)
#endif
    for (b = 0; b < blocks; b++) {
        random_bits g;
        long i;
        g.state = (seed << 40) ^ ((uint64_t)number << 32) ^ (uint64_t)b * UINT64_C(0xd1342543de82ef95);
        for (i = 0; i < BLOCK; i++) {
            const trial t = j->run(&g);
            if (t.good) continue;
            violations++;
            if (violations <= 3)
                fprintf(stderr, "VIOLATED %s: %.17g %.17g %.17g\n", j->name, (double)t.x, (double)t.y, (double)t.z);
        }
#ifdef _OPENMP
#pragma omp atomic
#endif
        done++;
        if (b % 64 == 0) fprintf(stderr, "%-16s %3.0f %%\r", j->name, 100. * (double)done / (double)blocks);
    }
    printf("%s|%.0f|%ld\n", j->name, (double)blocks * BLOCK * j->evaluations, violations);
    return violations;
}

int main(int argc, char **argv)
{
    const int rows = (int)(sizeof jobs / sizeof *jobs), row = argc == 4 ? atoi(argv[3]) : 0;
    int i;
    if (argc == 2 && strcmp(argv[1], "rows") == 0) {
        for (i = 0; i < rows; i++) printf("%s\n", jobs[i].name);
        return 0;
    }
    if (row < 1 || row > rows) {
        fprintf(stderr, "usage: evaluations COUNT SEED ROW, with ROW from 1 to %d\n", rows);
        return 2;
    }
    return run(jobs + row - 1, row - 1, strtod(argv[1], NULL), (uint64_t)strtol(argv[2], NULL, 10)) != 0;
}
