#!/bin/sh
# Compile every header alone, as C99, C11, C17, C++11 and C++17, in float and double, and every program as C99, by gcc and by
# clang, under the strict flags; any warning is printed and fails. As many compilers run at a time as there are processors.
#
# gcc finds variables that may be used before they are set only where it optimises (-O2): programs are compiled whole. The
# objects of the test programs, BUILD/lint/double/NAME.o and float/NAME.o, are those that make test-all links and runs. All
# other warnings come from reading the source, so that clang reads only, as gcc does where a header is alone and no code
# is made of it.
#
# usage: lint.sh BUILD_FOLDER FLAG...                       from the top of the project
#        lint.sh one BUILD_FOLDER "FLAGS" "COMPILER STANDARD SOURCE OBJECT|-fsyntax-only EXTRA..."      one compilation

compile() { # compile COMPILER STANDARD SOURCE OBJECT|-fsyntax-only EXTRA... : ends with an error where there is a warning
    compiler=$1 standard=$2 source=$3 object=$4
    shift 4
    case $object in
    -fsyntax-only) set -- "$@" -fsyntax-only ;;
    *) set -- "$@" -O2 -c -o "$object" ;;
    esac
    $compiler -std="$standard" $flags -Werror -I. "$source" "$@" || {
        echo "lint: $compiler -std=$standard $source $*"
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
both_precisions="$(ls bench/bench_jacobi.c bench/bench_ateb.c bench/count.c examples/*_plan.c)"
double_only="$(ls tests/mixed_double.c tests/mixed_float.c tests/exhaustive_*.c examples/*.c examples/first_steps/*.c \
    examples/package/consumer/main.c bench/*.c | grep -vxF "$both_precisions")"

object_of() { # object_of COMPILER SOURCE FOLDER : where gcc writes; clang writes nothing
    case $1 in
    gcc) echo "$build/$3/$(echo "$2" | sed 's|^tests/test_||; s|/|_|g; s|[.]c$||').o" ;;
    *) echo -fsyntax-only ;;
    esac
}
programs() { # programs COMPILER PRECISION EXTRA : the test programs and what else is compiled in both precisions
    for source in tests/test_*.c $both_precisions; do
        [ $source = tests/test_gsl.c ] || echo "$1 c99 $source $(object_of $1 $source $2) -Wstrict-prototypes $3"
    done
}
c_jobs() { # c_jobs COMPILER : all that it compiles as C, a line each
    programs $1 double
    programs $1 float -DVM_USE_FLOAT
    for source in $double_only; do
        echo "$1 c99 $source $(object_of $1 $source double) -Wstrict-prototypes"
    done
    if echo '#include <gsl/gsl_sf.h>' | $1 -E - >/dev/null 2>&1; then
        echo "$1 c99 tests/test_gsl.c $(object_of $1 tests/test_gsl.c double) -Wstrict-prototypes"
    fi
}
header_jobs() { # header_jobs COMPILER SUFFIX EXTRA STANDARD... : each header alone
    compiler=$1 suffix=$2 extra=$3
    shift 3
    for standard in "$@"; do
        for header in $headers; do
            for precision in "" -DVM_USE_FLOAT; do
                echo "$compiler $standard $build/$header.$suffix -fsyntax-only $extra $precision"
            done
        done
    done
}
is_there() { command -v $1 >/dev/null || { echo "lint: no $1 here" | tee -a "$build/failed" >&2; false; }; }

: >"$build/failed"
for compiler in gcc clang; do
    is_there $compiler && { c_jobs $compiler; header_jobs $compiler c -Wstrict-prototypes c99 c11 c17; }
done >"$build/jobs"
for compiler in g++ clang++; do
    is_there $compiler && header_jobs $compiler cpp "" c++11 c++17
done >>"$build/jobs"
xargs -P "$(nproc 2>/dev/null || echo 2)" -I{} sh tests/lint.sh one "$folder" "$flags" "{}" <"$build/jobs"
failed=$(wc -l <"$build/failed")
echo "lint: $(($(wc -l <"$build/jobs"))) compilations, $((failed)) with warnings"
[ $((failed)) = 0 ]
