#!/bin/sh
# What compilers' options may do to results. Harmless ones leave the bits as they are, and vm_self_check says 1. Those that
# change values are refused where the compiler's macros show them; and compiled nevertheless, by VM_ALLOW_FAST_MATH, they
# leave the bits as they are or vm_self_check says 0. So nobody who calls it gets wrong results unknowingly.
# usage: test_options.sh BUILD_FOLDER, from the top of the project
build=$1/options
. tests/check.sh
skipped=0
none="-ffp-contract=off"
# the chapters whose results are printed, a quarter of varmass.h, which would be read some fifty times
sh src/part.sh "$build/part.h" oscillators/constant_mass ateb/beta base/self_check || exit 1

knows() { echo 'int x;' | $compiler -Werror "$@" -x c -c - -o "$build/known.o" 2>/dev/null; }
answer() { # answer OPTION... : prints the bits of results, and what vm_self_check says
    $compiler -std=c99 -O2 $none "-DPART=\"../$build/part.h\"" "$@" tests/options.c -o "$build/program" -lm && "$build/program"
}
same_bits() { # same_bits OPTION... : and the check says 1
    answer "$@" >"$build/bits" && cmp "$build/bits" "$build/expected" && grep -q ' 1$' "$build/bits"
}
told() { # told OPTION... : the same bits, or the check says 0; whatever it is goes into the log
    answer -w -DVM_ALLOW_FAST_MATH "$@" >"$build/bits" || return 1
    grep -q ' 0$' "$build/bits" || cmp "$build/bits" "$build/expected"
}
accepted() { # accepted OPTION... : the check in a small program says 1
    answer "-DALONE=\"../ateb.h\"" "$@" >"$build/bits" && grep -q ' 1$' "$build/bits"
}
warned() { # warned OPTION... : the check in a small program says 0
    answer -w -DVM_ALLOW_FAST_MATH "-DALONE=\"../ateb.h\"" "$@" >"$build/bits" && grep -q ' 0$' "$build/bits"
}
refused() { # refused HEADER OPTION... : with words that tell how to go on
    printf '#include "%s.h"\n' "$1" >"$build/refused.c"
    shift
    ! $compiler -std=c99 "$@" -I. -fsyntax-only "$build/refused.c" 2>"$build/refused.log" &&
        grep -q -e VM_ALLOW_FAST_MATH -e vmi_constants_are_vm_real "$build/refused.log"
}
split="-fassociative-math -fno-signed-zeros -fno-trapping-math"
compiles_alone() { # compiles_alone FUNCTION OPTION... : a program that uses only this function of integrators.h compiles
    printf '#include "integrators.h"\nvoid *alone = (void *)%s;\n' "$1" >"$build/alone.c"
    shift
    $compiler -std=c99 "$@" -I. -w -c "$build/alone.c" -o "$build/alone.o"
}
unsafe="-funsafe-math-optimizations -fno-associative-math -fno-reciprocal-math"

for compiler in gcc clang; do
    command -v $compiler >/dev/null || { skipped=$((skipped + 1)); echo "skipped: no $compiler"; continue; }
    answer -O0 >"$build/expected"
    check "$compiler: the check says 1" grep -q ' 1$' "$build/expected"
    for options in -O1 "-std=gnu11 -O3 $none" "-fno-math-errno -fno-trapping-math -frounding-math -funsigned-char -fshort-enums"; do
        check "$compiler $options: the same bits" same_bits $options
    done
    for options in -O0 -O1 -O2 -O3 -Os "-O3 -march=native" "-O3 -march=native -ffp-contract=fast" -mfpmath=387 "-x c++ -std=c++11"; do
        for precision in "" -DVM_USE_FLOAT; do
            knows $options || { skipped=$((skipped + 1)); continue; }
            check "$compiler $options $precision: the check says 1" accepted $options $precision
        done
    done
    for function in rk45_solve_at rk87_solve_at; do
        for options in -O0 -O1 -O2 -O3 -Os; do
            check "$compiler $options: $function alone compiles" compiles_alone $function $options
        done
    done
    for options in -ffast-math -funsafe-math-optimizations "$split" "$unsafe" -freciprocal-math -ffinite-math-only \
        -fno-signed-zeros -fno-honor-nans -fsingle-precision-constant "-std=gnu99 -mfpmath=387"; do
        knows $options || { skipped=$((skipped + 1)); continue; }
        case "$compiler $options" in "gcc -fsingle-precision-constant") continue ;; esac # which is an error in any case
        check "$compiler $options: the check says 0, or the same bits" told $options
    done
    for options in -ffast-math -funsafe-math-optimizations "$split" "-std=gnu99 -ffinite-math-only" "-std=gnu99 -mfpmath=387"; do
        for precision in "" -DVM_USE_FLOAT; do
            knows $options || { skipped=$((skipped + 1)); continue; }
            check "$compiler $options $precision: the check says 0" warned $options $precision
        done
    done
    check "$compiler: the check notices rounding upwards" warned -DUPWARD
    if echo '#include <xmmintrin.h>' | $compiler -E -x c - >/dev/null 2>&1; then
        check "$compiler: the check notices flushing to zero" warned -DFLUSH
    fi
done
compiler=clang
if command -v clang >/dev/null; then check "clang: the check notices #pragma float_control" warned -DPRAGMA_CLANG; fi
compiler=gcc
if command -v gcc >/dev/null; then check "gcc: #pragma optimize is refused" fails answer -DPRAGMA_GCC; fi
for header in jacobi ateb integrators varmass; do
    for compiler in gcc clang; do
        command -v $compiler >/dev/null || continue
        for options in -ffast-math -Ofast -ffinite-math-only; do
            check "$compiler: $header.h refuses $options" refused $header $options
        done
    done
    compiler=gcc
    command -v gcc >/dev/null || continue
    for options in -funsafe-math-optimizations "$split" "$unsafe" -freciprocal-math -fno-signed-zeros \
        -fsingle-precision-constant; do
        check "gcc: $header.h refuses $options" refused $header $options
    done
    for macro in _M_FP_FAST __ARM_FP_FAST; do
        check "$header.h refuses $macro" refused $header -D$macro
    done
done
echo "options: $passed passed, $failed failed, $skipped skipped"
[ $failed = 0 ]
