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
    print "Written by `make scaling`: " samples " break-ups (examples/sweep/breakups.c), the least of three runs, on " \
        "two cores; the results have the same bits each time.\n"
    print "| | time, s | speed-up | efficiency |\n|---|---|---|---|"
    printf "| one thread | %s | 1 | |\n| two threads, one rank | %s | %.2f | %.0f %% |\n| two ranks, a thread each | %s | %.2f | %.0f %% |\n",
        one, threads, one / threads, 50 * one / threads, ranks, one / ranks, 50 * one / ranks
    sample = one / samples
    round = 64 * 4096 * sample
    print "\n## A thousand ranks, on paper\n"
    printf "A break-up takes %.2f us, so that a round, 64 blocks of 4096 break-ups a rank, takes %.0f ms. After a round\n", sample * 1e6, round * 1e3
    print "the first rank gathers 64 blocks of 240 bytes from each: 15 MB from a thousand, which at 10 GB/s take 1.5 ms; a tree of"
    print "ten messages of some microseconds each adds nothing to speak of. Ranks wait for the slowest: blocks cost the same but for"
    printf "a few per cent. So gathering alone would leave an efficiency of %.0f %%. ", 100 * round / (round + 0.0015)
    print "What limits first is the file of finished"
    printf "blocks, 15 MB a round, %.0f MB/s: a disk of 200 MB/s would ", 15.7 / round
    printf "bring the efficiency down to %.0f %%. ", 100 * round / (round + 15.7 / 200 + 0.0015)
    print "With BLOCK = 65536 the"
    printf "file takes a sixteenth of that, and the efficiency is %.0f %% again. ", 100 * 16 * round / (16 * round + 15.7 / 200 + 0.0015)
    print "(Another BLOCK adds up in another order: the last digits of"
    print "the sums change.) Memory: 240 bytes a block, 60 MB for 1e9 break-ups, on every rank."
}'
