#!/bin/sh
# How the sweep of break-ups scales: one and two threads, one and two MPI ranks, as docs/scaling.md.
# usage: scaling.sh BUILD_FOLDER [SAMPLES], from the top of the project
build=$1/scaling samples=${2:-16000000}
mkdir -p "$build" || exit 1
mpicc -std=c99 -O2 -fopenmp -DWITH_MPI examples/sweep/breakups.c -o "$build/breakups" -lm || exit 1
seconds() { # seconds THREADS RANKS : the least of three runs
    for run in 1 2 3; do
        start=$(date +%s.%N)
        OMP_NUM_THREADS=$1 mpirun --allow-run-as-root --oversubscribe -n "$2" --bind-to none "$build/breakups" $samples >"$build/$1.$2" 2>/dev/null
        end=$(date +%s.%N)
        echo "$start $end"
    done | awk '{t = $2 - $1; if (NR == 1 || t < least) least = t} END {printf "%.2f", least}'
}
one=$(seconds 1 1) threads=$(seconds 2 1) ranks=$(seconds 1 2)
cmp -s "$build/1.1" "$build/2.1" && cmp -s "$build/1.1" "$build/1.2" || { echo "the results differ" >&2; exit 1; }
awk -v one="$one" -v threads="$threads" -v ranks="$ranks" -v samples="$samples" 'BEGIN {
    print "# How the sweep scales\n"
    print "This page is written by `make scaling`.\n"
    print "The sweep is the program examples/sweep/breakups.c. It computes " samples " random break-ups of a"
    print "body. It can run as several processes, which exchange messages by the library MPI. Such a process is called a rank, and may"
    print "have several threads. In the table the sweep runs on at most two cores. Each time is the shortest of three runs. \"Speed-up\" is the"
    print "time of one thread divided by the time of this row, and \"efficiency\" is the speed-up divided by the number of cores. The"
    print "results have the same bits in all runs.\n"
    print "| | time, s | speed-up | efficiency |\n|---|---|---|---|"
    printf "| one thread | %s | 1 | |\n| two threads, one rank | %s | %.2f | %.0f %% |\n| two ranks, a thread each | %s | %.2f | %.0f %% |\n",
        one, threads, one / threads, 50 * one / threads, ranks, one / ranks, 50 * one / ranks
    sample = one / samples
    round = 64 * 4096 * sample
    print "\n## A thousand ranks, on paper\n"
    printf "A thousand ranks were not tried; the numbers of this section are an estimate. A break-up takes %.2f us on one core. In one round\neach rank computes 64 blocks of 4096 break-ups, ", sample * 1e6
    printf "which takes %.0f ms.\nAfter a round the first rank gathers the results, 64 blocks of 240 bytes from each rank. From a\n", round * 1e3
    print "thousand ranks these are 15 MB, which take 1.5 ms at 10 GB/s. The messages reach the first rank in ten stages of some"
    print "microseconds each, which adds almost no time. All ranks wait for the slowest rank, but the times of blocks differ only by a"
    printf "few per cent. If all other time is used for computing, the gathering of the results reduces the efficiency to %.0f %%.\n\n", 100 * round / (round + 0.0015)
    printf "The file in which the sweep stores the results of finished blocks is the first limit of the speed. It grows by 15 MB\na round, which is %.0f MB/s. A disk that writes 200 MB/s\n", 15.7 / round
    printf "reduces the efficiency to %.0f %%. With blocks of 65536 break-ups instead of 4096 (the constant BLOCK\nin breakups.c), the file is a sixteenth as long, and the efficiency is %.0f %%.\n", \
        100 * round / (round + 15.7 / 200 + 0.0015), 100 * 16 * round / (16 * round + 15.7 / 200 + 0.0015)
    print "(Another value of BLOCK also changes the last digits of the sums, because the numbers are added in another order.) Every rank"
    print "needs 240 bytes of memory for each block, which is 60 MB for 1e9 break-ups."
}'
