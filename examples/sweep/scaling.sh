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
    print "body. The program can run as several processes, which exchange messages through the library MPI. Such a process is called a rank."
    print "A rank may have several threads. For the table, the sweep ran on one or two cores. Each time is the shortest of three runs."
    print "\"Speed-up\" is the time of one thread divided by the time of this row, and \"efficiency\" is the speed-up divided by the number of"
    print "cores. The results of all runs have the same bits.\n"
    print "| | time, s | speed-up | efficiency |\n|---|---|---|---|"
    printf "| one thread | %s | 1 | |\n| two threads, one rank | %s | %.2f | %.0f %% |\n| two ranks, a thread each | %s | %.2f | %.0f %% |\n",
        one, threads, one / threads, 50 * one / threads, ranks, one / ranks, 50 * one / ranks
    sample = one / samples
    round = 64 * 4096 * sample
    print "\n## A thousand ranks, on paper\n"
    printf "A thousand ranks were not tried; the numbers of this section are an estimate. A break-up takes %.2f us on one core. The sweep\n", sample * 1e6
    printf "works in rounds. In one round each rank computes 64 blocks of 4096 break-ups, which takes %.0f ms.\n", round * 1e3
    print "After each round the first rank gathers the results, which are 240 bytes for each block. The results of a thousand ranks have"
    print "15 MB, and it takes 1.5 ms to send them at 10 GB/s. The messages reach the first rank in ten stages. Each stage takes some"
    print "microseconds, which adds almost no time. All ranks wait for the slowest rank. This wait is short, because the times of blocks"
    print "differ only by a few per cent. If all other time is used for computing, the gathering of the results reduces the efficiency to"
    printf "%.0f %%.\n\n", 100 * round / (round + 0.0015)
    printf "A file reduces the efficiency more: the sweep stores the results of finished blocks in this file. The file grows by 15 MB\na round, which is %.0f MB/s. A disk that writes 200 MB/s\n", 15.7 / round
    printf "reduces the efficiency to %.0f %%. With larger blocks, of 65536 break-ups instead of 4096 (the constant BLOCK in breakups.c), the\nfile is a sixteenth as long, and the efficiency is %.0f %%.\n", \
        100 * round / (round + 15.7 / 200 + 0.0015), 100 * 16 * round / (16 * round + 15.7 / 200 + 0.0015)
    print "(Another value of BLOCK also changes the last digits of the sums, because the numbers are added in another order.) Every rank"
    print "needs 240 bytes of memory for each block of the whole sweep, which is 60 MB for 1e9 break-ups."
}'
