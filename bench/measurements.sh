#!/bin/sh
# Write docs/measurements.md from what the test programs print; some minutes. Times are in docs/cost.md (make cost).
# usage: measurements.sh BUILD_FOLDER "TESTS", from the top of the project
build=$1
block() { printf '```\n'; cat; printf '```\n\n'; }
{
    printf '# Measurements\n\n'
    printf 'Written by `make measurements`: what `make test` and `make scan` print. Times: [cost.md](cost.md).\n\n'
    printf '## Accuracy\n\n'
    printf 'Worst errors over the stored arbitrary-precision tables (inputs taken as exact), identities and random bodies.\n'
    printf 'eps: of the type, times the function'"'"'s largest value; ulp: of the true value; eps\\*: eps times what an eps\n'
    printf 'in each argument or result makes; tol: the tolerance asked for.\n\n'
    for precision in double float; do
        for program in $2; do
            "$build/tests/$precision/$program" | block
        done
    done
    printf '## Random arguments against quadruple precision\n\n'
    "$build/tests/scan" 300000 | block
    "$build/tests/scan_float" 300000 | block
} >docs/measurements.md
