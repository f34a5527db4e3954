/* Random evaluations of every special function, by the thousand million. They check ranges, symmetries, identities within
   the promised bounds, that neighbours are in order, and inverses. bench/evaluations.sh runs this program for each row of
   docs/evaluations.md. The first violations go to stderr with their inputs.

   With -DROW=n the program has the row n alone. Its machine code is then the code that this row tests, by which the script
   knows whether it must be run again.

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

#ifdef ROW
#define IN_ROW(n, function) ((n) == ROW ? (function) : NULL)
#else
#define IN_ROW(n, function) (function)
#endif

static const job jobs[] = {{"sn, cn, dn", IN_ROW(1, try_sncndn), 2 * PHASES, 1},
                           {"sn, cn, dn, m1", IN_ROW(2, try_sncndn_m1), PHASES, 1},
                           {"sn rises", IN_ROW(3, try_sn_rises), 2 * PHASES, 1},
                           {"cd, sd, sc", IN_ROW(4, try_quotients), PHASES, 1},
                           {"jacobi_plan", IN_ROW(5, try_jacobi_plan), 64, 1},
                           {"am", IN_ROW(6, try_am), 3 * PHASES, 1},
                           {"K, k'K", IN_ROW(7, try_K), 1, 1},
                           {"E", IN_ROW(8, try_E), 2, 1},
                           {"K, E, Legendre", IN_ROW(9, try_legendre), 1, 1},
                           {"F, E, incomplete", IN_ROW(10, try_incomplete), 2, 1},
                           {"Pi, incomplete", IN_ROW(11, try_Pi), 1, 1},
                           {"inverse sn, cn", IN_ROW(12, try_inverse_sn), 1, 1},
                           {"R_F, R_C, R_D, R_J, R_G", IN_ROW(13, try_carlson), 1, 1},
                           {"solve k'K, m1", IN_ROW(14, try_solve_kpK), 1, 1},
                           {"solve K, m1", IN_ROW(15, try_solve_K), 1, 1},
                           {"cn means", IN_ROW(16, try_cn_means), 1, 1},
                           {"sa, ca", IN_ROW(17, try_saca), 2 * PHASES, 1},
                           {"sa, ca monotone", IN_ROW(18, try_saca_rises), 2 * PHASES, 1},
                           {"ateb_plan", IN_ROW(19, try_ateb_plan), 256, 1},
                           {"Pi_alpha", IN_ROW(20, try_pi), 2, 1},
                           {"ateb_phase", IN_ROW(21, try_phase), PHASES, 1},
                           {"ateb integrals", IN_ROW(22, try_integrals), PHASES, 1},
                           {"beta", IN_ROW(23, try_beta), 2, 1},
                           {"beta_inc", IN_ROW(24, try_beta_inc), 2, 1},
                           {"beta_inc_inv", IN_ROW(25, try_beta_inverse), 2, 10},
                           {"sa, ca (n, m)", IN_ROW(26, try_saca_nm), 1, 10},
                           {"ateb_mean", IN_ROW(27, try_mean), 2, 1},
                           {"Lambert W", IN_ROW(28, try_lambert), 1, 1},
                           {"ns, nc, nd, cs, ds, dc", IN_ROW(29, try_reciprocals), PHASES, 1},
                           {"sn, cn, dn, m > 1", IN_ROW(30, try_large_m), PHASES, 1},
                           {"agm", IN_ROW(31, try_agm), PHASES, 1},
                           {"jacobi_plan, arrays", IN_ROW(32, try_jacobi_arrays), 64, 1},
                           {"D", IN_ROW(33, try_D), 1, 1},
                           {"D, incomplete", IN_ROW(34, try_D_incomplete), 1, 1},
                           {"F, E, D, incomplete, m1", IN_ROW(35, try_incomplete_m1), 1, 1},
                           {"Pi", IN_ROW(36, try_Pi_complete), 1, 1},
                           {"Pi, incomplete, m1", IN_ROW(37, try_Pi_m1), 1, 1},
                           {"inverse dn", IN_ROW(38, try_inverse_dn), 1, 1},
                           {"inverse sn, cn, dn, m1", IN_ROW(39, try_inverses_m1), 1, 1},
                           {"solve K, k'K", IN_ROW(40, try_solve_m), 1, 1},
                           {"ateb_plan, shorter", IN_ROW(41, try_short_plan), 256, 1},
                           {"ateb_plan, arrays", IN_ROW(42, try_ateb_arrays), 256, 1},
                           {"ln beta", IN_ROW(43, try_ln_beta), 2, 1},
                           {"ln beta_inc", IN_ROW(44, try_ln_beta_inc), 1, 1},
                           {"beta_inc_inv, both", IN_ROW(45, try_both_inverses), 1, 10},
                           {"ateb_mean (n, m)", IN_ROW(46, try_mean_nm), 3, 1},
                           {"Lambert W, x < 0", IN_ROW(47, try_lambert_branches), 1, 1}};

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
    if (row < 1 || row > rows || !jobs[row - 1].run) {
        fprintf(stderr, "usage: evaluations COUNT SEED ROW, with ROW from 1 to %d\n", rows);
        return 2;
    }
    return run(jobs + row - 1, row - 1, strtod(argv[1], NULL), (uint64_t)strtol(argv[2], NULL, 10)) != 0;
}
