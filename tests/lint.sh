#!/bin/sh
# Compile every header alone, as C99, C11, C17, C++11 and C++17, in float and double, and every program as C99, by each
# compiler that is there, under the strict flags; any warning is printed and fails.
# usage: lint.sh BUILD_FOLDER FLAG..., from the top of the project
build=$1/lint
shift
flags="$*"
mkdir -p "$build"
count=0 failed=0 object=object

compile() { # compile COMPILER STANDARD SOURCE EXTRA...
    compiler=$1 standard=$2 source=$3
    shift 3
    count=$((count + 1))
    $compiler -std="$standard" $flags -Werror "$@" -O2 -I. -c "$source" -o "$build/$object.o" || {
        failed=$((failed + 1))
        echo "lint: $compiler -std=$standard $* $source"
    }
}

for header in jacobi ateb integrators varmass; do
    printf '#include "%s.h"\n' $header | tee "$build/$header.c" >"$build/$header.cpp"
done
c_programs() { # c_programs COMPILER : everything as C
    compiler=$1
    command -v $compiler >/dev/null || { echo "lint: no $compiler here"; failed=$((failed + 1)); return; }
    for precision in "" -DVM_USE_FLOAT; do
        for standard in c99 c11 c17; do
            for header in jacobi ateb integrators varmass; do
                compile $compiler $standard "$build/$header.c" -Wstrict-prototypes $precision
            done
        done
        for source in tests/test_*.c bench/bench_jacobi.c bench/bench_ateb.c bench/count.c examples/*_plan.c; do
            [ $source = tests/test_gsl.c ] || compile $compiler c99 $source -Wstrict-prototypes $precision
        done
    done
    for source in tests/mixed_double.c tests/mixed_float.c tests/exhaustive_*.c examples/*.c examples/first_steps/*.c \
        examples/package/consumer/main.c bench/*.c; do
        compile $compiler c99 $source -Wstrict-prototypes
    done
    if echo '#include <gsl/gsl_sf.h>' | $compiler -E - >/dev/null 2>&1; then
        compile $compiler c99 tests/test_gsl.c -Wstrict-prototypes
    fi
}
cpp_headers() { # cpp_headers COMPILER : the headers as C++
    compiler=$1
    command -v $compiler >/dev/null || { echo "lint: no $compiler here"; failed=$((failed + 1)); return; }
    for precision in "" -DVM_USE_FLOAT; do
        for standard in c++11 c++17; do
            for header in jacobi ateb integrators varmass; do
                compile $compiler $standard "$build/$header.cpp" $precision
            done
        done
    done
}
compilers() { # compilers C C++ : both of one kind, their counts to a file; two kinds run at a time
    object=$1
    c_programs $1
    cpp_headers $2
    echo $count $failed >"$build/$1.count"
}
compilers gcc g++ &
compilers clang clang++
wait
set -- $(cat "$build/gcc.count" "$build/clang.count")
count=$(($1 + $3)) failed=$(($2 + $4))
echo "lint: $count compilations, $failed with warnings"
[ $failed = 0 ]
