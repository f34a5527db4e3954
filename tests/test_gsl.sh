#!/bin/sh
# tests/test_gsl.c, which compares with GSL, where GSL is or can be installed.
# usage: CC=compiler test_gsl.sh BUILD_FOLDER, from the top of the project
cc=${CC:-cc} build=$1/gsl
mkdir -p "$build"
sh tests/install.sh -w "which one of the tests compares with" "echo '#include <gsl/gsl_sf.h>' | $cc -E -" libgsl-dev || {
    echo "GSL: 0 passed, 0 failed, 9 skipped"
    exit 0
}
$cc -std=c99 -O1 tests/test_gsl.c -o "$build/gsl" -lgsl -lgslcblas -lm && exec "$build/gsl"
