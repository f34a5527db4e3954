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
    print "The sweep is the program examples/sweep/breakups.c. For the table, it computes " samples " random break-ups of a body."
    print "The program can run as several processes at the same time, which exchange messages through the library MPI. Such a process is"
    print "called a rank. A rank may have several threads. In the first row of the table, the sweep ran on one core, in the other rows on two"
    print "cores. Each time is the shortest of three runs. The column \"speed-up\" has the time of one thread divided by the time of the row."
    print "The column \"efficiency\" has the speed-up divided by the number of cores. The results of all runs have the same bits.\n"
    print "| | time, s | speed-up | efficiency |\n|---|---|---|---|"
    printf "| one thread | %s | 1 | |\n| two threads, one rank | %s | %.2f | %.0f %% |\n| two ranks, a thread each | %s | %.2f | %.0f %% |\n",
        one, threads, one / threads, 50 * one / threads, ranks, one / ranks, 50 * one / ranks
    sample = one / samples
    round = 64 * 4096 * sample
    print "\n## A thousand ranks, on paper\n"
    print "The efficiency in this section is an estimate; a thousand ranks were not tried. The sweep works in rounds. In each round, each"
    printf "rank computes 64 blocks of 4096 break-ups. A break-up takes %.2f us on one core, so that a round takes %.0f ms.\n", \
        sample * 1e6, round * 1e3
    print "After each round the first rank gathers the results of all ranks: 240 bytes for each block. In one round these are 15 MB for a"
    print "thousand ranks, and it takes 1.5 ms to send them at 10 GB/s. The ranks pass the messages on to each other in ten stages, until the"
    print "first rank has them. Each stage has a delay of only some microseconds, which adds almost nothing to the 1.5 ms. At the end of a"
    print "round all ranks wait for the slowest rank. This wait is neglected here: the times of single blocks differ by a few per cent, but"
    print "the times of 64 blocks differ less. If each round loses only the 1.5 ms for sending, the efficiency is"
    printf "%.0f %%.\n\n", 100 * round / (round + 0.0015)
    print "The efficiency is lower if the sweep stores the results of finished blocks in a file. The file grows by 15 MB in each round,"
    printf "that is, by %.0f MB in each second of computing. If the disk can write 200 MB/s, and no rank computes while the disk writes, the\nefficiency is %.0f %%.\n", \
        15.36 / round, 100 * round / (round + 15.36 / 200 + 0.0015)
    print "If each block has 65536 break-ups instead of 4096 (the constant BLOCK in breakups.c), the file is only a sixteenth as long."
    printf "The efficiency with this shorter file is %.0f %%.\n", 100 * 16 * round / (16 * round + 15.36 / 200 + 0.0015)
    print "But another value of BLOCK changes the last digits of the results, because numbers are then added in another order. Every rank"
    print "also needs memory for the results of all blocks: 240 bytes for each block, which is 60 MB for 1e9 break-ups in blocks of 4096."
}'
