#!/bin/sh
# Compile every header alone, as C99, C11, C17, C++11 and C++17, in float and double, and every program as C99, by gcc and by
# clang, under the strict flags; any warning is printed and fails. As many compilers run at a time as there are processors.
#
# gcc finds variables that may be used before they are set only where it optimises (-O2). It does so for every program in
# double, and writes the objects of the test programs, BUILD/lint/double/NAME.o, which make test-all links and runs. In float
# gcc only reads the programs, since their statements are the same; float code of the headers is optimised under these
# warnings by tests/test_headers.sh. All other warnings come from reading the source, so that clang only reads, too.
#
# Most of the time would be spent on reading varmass.h once for each program. Each compiler reads it once in each precision
# and stores what it has read (a precompiled header); programs begin with that. Their own #include line then adds nothing.
#
# usage: lint.sh BUILD_FOLDER FLAG...                       from the top of the project
#        lint.sh one BUILD_FOLDER "FLAGS" "COMPILER STANDARD SOURCE MODE EXTRA..."      one compilation; MODE is the
#               object to be written, or -fsyntax-only where the compiler only reads

compile() { # compile COMPILER STANDARD SOURCE MODE EXTRA... : ends with an error where there is a warning
    compiler=$1 standard=$2 source=$3 mode=$4
    shift 4
    case $mode in
    -fsyntax-only) set -- "$@" -fsyntax-only ;;
    *) set -- "$@" -c -o "$mode" ;;
    esac
    $compiler -std="$standard" $flags -Werror -I. "$@" "$source" || {
        echo "lint: $compiler -std=$standard $* $source"
        return 1
    }
}

if [ "$1" = one ]; then
    build=$2/lint flags=$3
    compile $4 || echo "$4" >>"$build/failed"
    exit 0
fi

build=$1/lint
folder=$1
shift
flags="$*"
mkdir -p "$build/double" "$build/float"
headers="jacobi ateb integrators varmass"
for header in $headers; do
    printf '#include "%s.h"\n' $header | tee "$build/$header.c" >"$build/$header.cpp"
done
both_precisions="$(ls tests/test_*.c bench/bench_jacobi.c bench/bench_ateb.c bench/count.c examples/*_plan.c |
    grep -vxF tests/test_gsl.c)"
double_only="$(ls tests/mixed_double.c tests/mixed_float.c tests/exhaustive_*.c examples/*.c examples/first_steps/*.c \
    examples/package/consumer/main.c bench/*.c | grep -vxF "$both_precisions")"

float_flag() { if [ "$1" = float ]; then echo -DVM_USE_FLOAT; fi; } # float_flag PRECISION

# Without the stored header are compiled: programs that name another of the headers than varmass.h; those that take the time,
# since a macro has to stand before the first header of the C library; and the one that sets the precision itself.
starts_with_varmass() { # starts_with_varmass SOURCE
    case $1 in tests/mixed_float.c | examples/package/consumer/main.c) return 1 ;; esac
    ! grep -Eq '^#include "((\.\./)*(jacobi|ateb|integrators)|timing)\.h"' "$1"
}
stored_header() { # stored_header COMPILER PRECISION : the options that make it the beginning of a program
    case $1 in
    gcc) echo "-Winvalid-pch -include $build/$2/varmass.h" ;;
    clang) echo "-include-pch $build/$2/varmass.pch" ;;
    esac
}
storing_jobs() { # storing_jobs COMPILER : what has to come before all other jobs
    for precision in double float; do
        case $1 in
        gcc) stored=$build/$precision/varmass.h.gch level=-O2 ;;
        clang) stored=$build/$precision/varmass.pch level= ;;
        esac
        echo "$1 c99 varmass.h $stored -Wstrict-prototypes $level $(float_flag $precision) -x c-header"
    done
}
mode_of() { # mode_of COMPILER SOURCE PRECISION : the object that gcc writes in double, and the level
    case $1,$3 in
    gcc,double) echo "$build/double/$(echo "$2" | sed 's|^tests/test_||; s|/|_|g; s|[.]c$||').o -O2" ;;
    gcc,float) echo "-fsyntax-only -O2" ;;
    *) echo -fsyntax-only ;;
    esac
}
programs() { # programs COMPILER PRECISION SOURCE...
    compiler=$1 precision=$2
    shift 2
    for source in "$@"; do
        stored=
        starts_with_varmass $source && stored=$(stored_header $compiler $precision)
        echo "$compiler c99 $source $(mode_of $compiler $source $precision) -Wstrict-prototypes $(float_flag $precision) $stored"
    done
}
c_jobs() { # c_jobs COMPILER : all that it compiles as C, a line each
    programs $1 double $both_precisions $double_only
    programs $1 float $both_precisions
    if echo '#include <gsl/gsl_sf.h>' | $1 -E - >/dev/null 2>&1; then programs $1 double tests/test_gsl.c; fi
}
header_jobs() { # header_jobs COMPILER SUFFIX EXTRA STANDARD... : each header alone
    compiler=$1 suffix=$2 extra=$3
    shift 3
    for standard in "$@"; do
        for header in $headers; do
            for precision in double float; do
                echo "$compiler $standard $build/$header.$suffix -fsyntax-only $extra $(float_flag $precision)"
            done
        done
    done
}
is_there() { command -v $1 >/dev/null || { echo "lint: no $1 here" | tee -a "$build/failed" >&2; false; }; }
run_jobs() { # run_jobs FILE : the jobs in it, several at a time
    xargs -P "$(nproc 2>/dev/null || echo 2)" -I{} sh tests/lint.sh one "$folder" "$flags" "{}" <"$1"
}

: >"$build/failed"
: >"$build/first_jobs"
for compiler in gcc clang; do
    is_there $compiler || continue
    storing_jobs $compiler >>"$build/first_jobs"
    c_jobs $compiler
    header_jobs $compiler c -Wstrict-prototypes c99 c11 c17
done >"$build/jobs"
for compiler in g++ clang++; do
    is_there $compiler && header_jobs $compiler cpp "" c++11 c++17
done >>"$build/jobs"
run_jobs "$build/first_jobs"
[ -s "$build/failed" ] || run_jobs "$build/jobs" # with a warning in varmass.h alone, each program would have it, too
failed=$(wc -l <"$build/failed")
echo "lint: $(cat "$build/first_jobs" "$build/jobs" | wc -l) compilations, $((failed)) with warnings"
[ $((failed)) = 0 ]
