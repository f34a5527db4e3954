/* A sweep: how fast do the remainders of a tumbling body spin when a random part leaves the body at a random instant
   with a random velocity? The program computes millions of break-ups on all cores (OpenMP) and computers (MPI). The
   result has the same bits for any number of cores and computers, since each sample has its own random numbers, the
   samples are summed in blocks, and the blocks are summed in order. If a run was interrupted, another run continues
   after the last block in the file of finished blocks.

   usage: [mpirun -n RANKS] breakups SAMPLES [SEED [FILE]]
   make sweep; or: cc -O2 -fopenmp breakups.c -lm        mpicc -O2 -fopenmp -DWITH_MPI breakups.c -lm */
#include "../../varmass.h"
#include <stdio.h>
#include <stdlib.h>
#ifdef WITH_MPI
#include <mpi.h>
#endif

enum { BLOCK = 4096, BINS = 24 };

typedef struct block {
    double number; /* number of the block, from 0 */
    double refused, energy, spin, spin_squared, bins[BINS];
} block;

/* The generator splitmix64: converts the state x to a random number */
static uint64_t mix(uint64_t x)
{
    x = (x ^ (x >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    x = (x ^ (x >> 27)) * UINT64_C(0x94d049bb133111eb);
    return x ^ (x >> 31);
}

typedef struct random_numbers {
    uint64_t state;
} random_numbers;

static vm_real between(random_numbers *r, double low, double high)
{
    r->state += UINT64_C(0x9e3779b97f4a7c15);
    return (vm_real)(low + (high - low) * (double)(mix(r->state) >> 11) / 9007199254740992.0);
}

static vm_vec3 inside(random_numbers *r, double size)
{
    vm_vec3 a;
    a.x = between(r, -size, size);
    a.y = between(r, -size, size);
    a.z = between(r, -size, size);
    return a;
}

/* Adds one sample to *sum: a body of 100 kg tumbles, and a solid sphere of up to a third of its mass leaves */
static void sample(uint64_t seed, uint64_t i, block *sum)
{
    random_numbers r;
    vm_body whole, part, rest;
    double spin;
    int bin;
    r.state = mix(seed + mix(i));
    memset(&whole, 0, sizeof whole);
    whole.mass = 100;
    whole.inertia.xx = 30;
    whole.inertia.yy = 40;
    whole.inertia.zz = 50;
    whole.q.w = between(&r, -1, 1);
    whole.q.x = between(&r, -1, 1);
    whole.q.y = between(&r, -1, 1);
    whole.q.z = between(&r, -1, 1);
    whole.omega = inside(&r, 1);
    part = whole;
    part.mass = between(&r, 1, 33);
    part.inertia.xx = part.inertia.yy = part.inertia.zz = (vm_real)0.4 * part.mass *
                                                          (vm_real)0.01; /* radius 0.1 m */
    part.r = inside(&r, 0.4);
    part.v = inside(&r, 3);
    part.omega = inside(&r, 5);
    if (vm_separate(&whole, &part, NULL, &rest) < 0) { /* no body can have the inertia of the rest */
        sum->refused++;
        return;
    }
    spin = sqrt((double)vm_dot(rest.omega, rest.omega));
    bin = (int)(spin * 4);
    sum->bins[bin < BINS ? bin : BINS - 1]++;
    sum->spin += spin;
    sum->spin_squared += spin * spin;
    sum->energy += (double)(vm_kinetic_energy(&rest) + vm_kinetic_energy(&part) - vm_kinetic_energy(&whole));
}

static void do_block(uint64_t seed, long number, long samples, block *b)
{
    const long end = (number + 1) * BLOCK < samples ? (number + 1) * BLOCK : samples;
    long i;
    memset(b, 0, sizeof *b);
    b->number = (double)number;
    for (i = number * BLOCK; i < end; i++) sample(seed, (uint64_t)i, b);
}

static void report(const block *blocks, long count, long samples)
{
    block total;
    double done;
    long k;
    int bin;
    memset(&total, 0, sizeof total);
    for (k = 0; k < count; k++) {
        total.refused += blocks[k].refused;
        total.energy += blocks[k].energy;
        total.spin += blocks[k].spin;
        total.spin_squared += blocks[k].spin_squared;
        for (bin = 0; bin < BINS; bin++) total.bins[bin] += blocks[k].bins[bin];
    }
    done = (double)samples - total.refused;
    printf("%ld break-ups, %.0f of them impossible; mean spin %.15g rad/s, deviation %.6g, energy gained %.15g J\n",
           samples, total.refused, total.spin / done,
           sqrt(total.spin_squared / done - total.spin / done * (total.spin / done)), total.energy / done);
    for (bin = 0; bin < BINS; bin++) printf("%5.2f rad/s %8.5f\n", bin / 4., total.bins[bin] / done);
}

/* Reads the blocks that an earlier run has finished, and returns their number. A file of a run with another seed or
   size is not used. */
static long restore(const char *file_name, const double *key, block *blocks, long count)
{
    FILE *file = file_name ? fopen(file_name, "rb") : NULL;
    double found[2];
    block b;
    long restored = 0;
    if (!file) return 0;
    if (fread(found, sizeof *found, 2, file) == 2 && found[0] == key[0] && found[1] == key[1])
        while (fread(&b, sizeof b, 1, file) == 1)
            if (b.number >= 0 && b.number < (double)count && blocks[(long)b.number].number < 0) {
                blocks[(long)b.number] = b;
                restored++;
            }
    fclose(file);
    return restored;
}

/* Writes the file anew with the restored blocks only, since an interrupted run may have left an incomplete block at
   its end. Later blocks are appended to the file. */
static FILE *keep(const char *file_name, const double *key, const block *blocks, long count)
{
    FILE *file = file_name ? fopen(file_name, "wb") : NULL;
    long k;
    if (!file) return NULL;
    fwrite(key, sizeof *key, 2, file);
    for (k = 0; k < count; k++)
        if (blocks[k].number >= 0) fwrite(blocks + k, sizeof *blocks, 1, file);
    fflush(file);
    return file;
}

enum { ROUND = 64 }; /* number of blocks that a rank computes before rank 0 gathers them */

int main(int argc, char **argv)
{
    const long samples = argc > 1 ? atol(argv[1]) : 1000000, count = (samples + BLOCK - 1) / BLOCK;
    const uint64_t seed = argc > 2 ? (uint64_t)strtoul(argv[2], NULL, 10) : 1;
    const char *file_name = argc > 3 ? argv[3] : NULL;
    const double key[2] = {(double)seed, (double)samples};
    block *blocks;
    FILE *file = NULL;
    int rank = 0, ranks = 1;
    long first, k, room;
#ifdef WITH_MPI
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
#endif
    room = (count / ((long)ranks * ROUND) + 1) * (long)ranks * ROUND; /* for whole rounds */
    blocks = (block *)malloc((size_t)room * sizeof *blocks);
    if (!blocks || samples < 1) return 1;
    for (k = 0; k < room; k++) blocks[k].number = -1;
    k = rank == 0 ? restore(file_name, key, blocks, count) : 0;
    if (k) fprintf(stderr, "%ld of %ld blocks were there\n", k, count);
    if (rank == 0) file = keep(file_name, key, blocks, count);
#ifdef WITH_MPI
    MPI_Bcast(blocks, (int)((size_t)count * sizeof *blocks / sizeof(double)), MPI_DOUBLE, 0, MPI_COMM_WORLD);
#endif
    for (first = 0; first < count; first += (long)ranks * ROUND) { /* rank r computes ROUND blocks of each round */
        const long mine = first + (long)rank * ROUND;
#pragma omp parallel for schedule(dynamic)
        for (k = mine; k < mine + ROUND; k++)
            if (k < count && blocks[k].number < 0) {
                do_block(seed, k, samples, blocks + k);
                blocks[k].number = (double)k + 0.5; /* new */
            }
#ifdef WITH_MPI
        MPI_Gather(rank == 0 ? MPI_IN_PLACE : (void *)(blocks + mine),
                   ROUND * (int)(sizeof *blocks / sizeof(double)), MPI_DOUBLE, blocks + first,
                   ROUND * (int)(sizeof *blocks / sizeof(double)), MPI_DOUBLE, 0, MPI_COMM_WORLD);
#endif
        for (k = first; k < first + (long)ranks * ROUND && k < count; k++)
            if (blocks[k].number > (double)k) {
                blocks[k].number = (double)k;
                if (file) fwrite(blocks + k, sizeof *blocks, 1, file);
            }
        if (file) fflush(file);
        if (rank == 0)
            fprintf(stderr, "\r%3.0f %%",
                    100. * (double)(first + (long)ranks * ROUND < count ? first + (long)ranks * ROUND : count) /
                        (double)count);
    }
    if (rank == 0) {
        fprintf(stderr, "\n");
        report(blocks, count, samples);
    }
    if (file) fclose(file);
    free(blocks);
#ifdef WITH_MPI
    MPI_Finalize();
#endif
    return 0;
}
