/* Two coupled buckets. Two equal buckets of sand roll on a level floor. Each bucket is held by its own spring, and a weak spring
   of 0.01 N/m connects the two buckets. Both buckets lose sand at the same rate. They start in phase, with the amplitudes 1 m and
   0.5 m. The force of each bucket's own spring is x |x|^(alpha-1). With alpha = 1 (linear springs) the buckets exchange their
   amplitudes again and again. With alpha = 3 the amplitudes are not exchanged: the bucket with the larger amplitude vibrates
   faster, so that the two buckets are soon out of phase. The program computes the two amplitudes by averaged equations, and for
   comparison by integration of the equations of motion; the output has a column for each bucket. The field `vibrations` of
   vm_grounded_pair tells the averaged equations at which ratio of their frequencies the buckets can exchange energy, here 1 to 1.

   cc -O2 19_two_coupled_buckets.c -lm && ./a.out [file.csv] */
#include <stdio.h>
#include "../../varmass.h"

static vm_grounded_pair buckets(double alpha)
{
    vm_grounded_pair p;
    int i;
    memset(&p, 0, sizeof p);
    for (i = 0; i < 2; i++) {
        p.oscillator[i].alpha = alpha;
        p.oscillator[i].mass = vm_law_linear(1, -0.0002);
        p.oscillator[i].stiffness = vm_law_linear(1, 0);
        p.vibrations[i] = 1; /* equal frequencies */
    }
    p.spring = 0.01;
    return p;
}

static int compare(double alpha, FILE *csv)
{
    vm_real y[4] = {1, 0, 0.5, 0}; /* amplitude (m) and phase (rad) of the first, of the second */
    vm_real motion[4], direct[4] = {0}, work[2][RK45_WORK(4)], t;
    vm_grounded_pair p = buckets(alpha);
    rk45_options options = rk45_defaults(NULL);
    rk45 slow, fast;
    int status = vm_grounded_pair_init(&p);
    if (!status) status = vm_grounded_pair_from_averaged(&p, 0, y, motion);
    options.rtol = options.atol = 1e-8;
    if (!status) status = rk45_init(&slow, vm_grounded_pair_averaged_rhs, &p, 4, 0, y, &options, work[0]);
    if (!status) status = rk45_init(&fast, vm_grounded_pair_rhs, &p, 4, 0, motion, &options, work[1]);
    printf("alpha = %g, amplitudes in m\nt (s)     averaged            integrated\n", alpha);
    for (t = 0; t <= 600 && status >= 0; t++) {
        status = rk45_solve(&slow, t);
        if (status >= 0) status = rk45_solve(&fast, t);
        if (csv && alpha == 1) fprintf(csv, "%g,%.6f,%.6f,,\n", t, slow.y[0], slow.y[2]);
        if (csv && alpha == 3) fprintf(csv, "%g,,,%.6f,%.6f\n", t, slow.y[0], slow.y[2]);
        if (status < 0 || (int)t % 100 != 0) continue;
        status = vm_grounded_pair_to_averaged(&p, t, fast.y, direct);
        printf("%5g %9.4f %8.4f %11.4f %8.4f\n", t, slow.y[0], slow.y[2], direct[0], direct[2]);
    }
    return status;
}

int main(int argc, char **argv)
{
    FILE *csv = argc > 1 ? fopen(argv[1], "w") : NULL;
    if (csv) fprintf(csv, "t (s),linear springs: first (m),second (m),cubic springs: first (m),second (m)\n");
    if (compare(1, csv) < 0 || compare(3, csv) < 0) return 1;
    return csv && fclose(csv);
}
