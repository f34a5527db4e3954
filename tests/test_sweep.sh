#!/bin/sh
# examples/sweep: the same bits from one thread, several, two MPI ranks, and a run that was interrupted.
# usage: CC=compiler test_sweep.sh BUILD_FOLDER, from the top of the project
cc=${CC:-cc} build=$1/sweep samples=600000
. tests/check.sh
skipped=0

report() { "$@" 2>/dev/null >"$build/out" && cmp "$build/reference" "$build/out"; }
interrupted() { # killed after the first round is on file, then run again, which goes on
    rm -f "$build/blocks"
    OMP_NUM_THREADS=1 "$build/threads" $samples 1 "$build/blocks" >/dev/null 2>&1 &
    tries=0
    while [ "$(wc -c <"$build/blocks" 2>/dev/null || echo 0)" -lt 1000 ] && [ $tries -lt 200 ]; do
        sleep 0.05
        tries=$((tries + 1))
    done
    kill $! 2>/dev/null
    wait $! 2>/dev/null
    printf 'torn' >>"$build/blocks"
    "$build/threads" $samples 1 "$build/blocks" 2>"$build/err" >"$build/out" && grep -q 'blocks were there' "$build/err" &&
        cmp "$build/reference" "$build/out"
}

check "builds" $cc -std=c99 -O2 examples/sweep/breakups.c -o "$build/single" -lm
"$build/single" $samples 1 2>/dev/null >"$build/reference"
check "says something" grep -q "break-ups" "$build/reference"
if $cc -std=c99 -O2 -fopenmp examples/sweep/breakups.c -o "$build/threads" -lm 2>"$build/log"; then
    check "three threads: the same bits" report env OMP_NUM_THREADS=3 "$build/threads" $samples 1
    check "interrupted: goes on to the same bits" interrupted
else
    skipped=$((skipped + 2))
fi
if command -v mpicc >/dev/null && command -v mpirun >/dev/null; then
    check "with MPI: builds" mpicc -std=c99 -O2 -DWITH_MPI examples/sweep/breakups.c -o "$build/ranks" -lm
    check "two ranks: the same bits" report mpirun --allow-run-as-root --oversubscribe -n 2 "$build/ranks" $samples 1
    check "without mpirun: the same bits" report "$build/ranks" $samples 1
else
    skipped=$((skipped + 3))
fi
echo "sweep: $passed passed, $failed failed, $skipped skipped"
[ $failed = 0 ]
