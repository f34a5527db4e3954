#!/bin/sh
# Write docs/measurements.md from what the test and bench programs print, on the machine at hand; some minutes.
# usage: measurements.sh BUILD_FOLDER, from the top of the project
build=$1
block() { printf '```\n'; cat; printf '```\n\n'; }
{
    printf '# Measurements\n\n'
    printf 'Written by `make measurements`: what `make test`, `make scan` and `make bench` print.\n\n'
    printf '## Accuracy\n\n'
    printf 'Worst errors over the stored arbitrary-precision tables (inputs taken as exact), identities and random bodies.\n'
    printf 'eps: of the type, times the function'"'"'s largest value; ulp: of the true value; ulp/K: that divided by\n'
    printf "K max(1, k'), towards m = 1; eps\\*: eps times what an eps in each argument or result makes; tol: the tolerance asked for.\n\n"
    for precision in double float; do
        for program in jacobi ateb integrators varmass dissertation; do
            "$build/tests/$precision/$program" | block
        done
    done
    printf '## Random arguments against quadruple precision\n\n'
    "$build/tests/scan" 1000000 | block
    "$build/tests/scan_float" 1000000 | block
    printf '## Time\n\n%s, %s\n\n' "$(awk -F': ' '/model name/ {print $2; exit}' /proc/cpuinfo)" "$(cc --version | head -n 1)"
    "$build/bench/double" | block
    "$build/bench/float" | block
    printf '## The pair of orders 5 and 4\n\n'
    "$build/bench/pairs" | block
} >docs/measurements.md
