#!/bin/sh
# The tests under the sanitizers of gcc and clang and under valgrind, the headers by the static analysers. Findings that
# are kept on purpose are in tests/analysers.txt with their reason, one a line; any other one fails.
# usage: sanitize.sh BUILD_FOLDER [quick] TEST...      quick: gcc's sanitizers in double alone, for every change
build=$1/sanitize
shift
. tests/check.sh
jobs=$(nproc 2>/dev/null || echo 2)
quick=
[ "$1" = quick ] && quick=1 && shift

# Each of the tests, built by a compiler with its flags, runs to the end without a word of a sanitizer
sanitized() { # sanitized NAME "COMPILER FLAGS" TEST...
    name=$1 command=$2
    shift 2
    printf '%s\n' "$@" | xargs -P "$jobs" -I{} sh -c "
        $command tests/test_{}.c -o $build/$name.{} -lm >$build/$name.{}.log 2>&1 &&
        $build/$name.{} >>$build/$name.{}.log 2>&1; echo \$? >$build/$name.{}.status"
    for test in "$@"; do
        check "$name: $test" test "$(cat "$build/$name.$test.status")" = 0
        grep -m 3 -E 'runtime error|ERROR: |WARNING: ' "$build/$name.$test.log"
    done
}

if [ -n "$quick" ]; then
    sanitized gcc "gcc -std=c99 -g -O1 -fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all" "$@"
    check_finish sanitize
    exit
fi
for precision in "" -DVM_USE_FLOAT; do
    sanitized "gcc$precision" "gcc -std=c99 -g -O1 $precision -fsanitize=address,undefined,float-cast-overflow \
        -fno-sanitize-recover=all" "$@"
    sanitized "clang$precision" "clang -std=c99 -g -O1 $precision -fsanitize=undefined,float-cast-overflow,implicit-conversion \
        -fno-sanitize-recover=all" "$@"
    sanitized "memory$precision" "clang -std=c99 -g -O1 $precision -fsanitize=memory -fno-sanitize-recover=all" "$@"
done

# valgrind, which is forty times slower, on what is quickest
if sh tests/install.sh "command -v valgrind" valgrind; then
    for test in jacobi ateb varmass refusals; do
        gcc -std=c99 -g -O1 tests/test_$test.c -o "$build/valgrind.$test" -lm
        check "valgrind: $test" valgrind -q --error-exitcode=9 "$build/valgrind.$test"
    done
fi

# The analysers see each header by a source that uses nothing of it: all its functions are external
for header in jacobi ateb integrators varmass; do printf '#include "%s.h"\n' $header >"$build/$header.c"; done
accepted() { # accepted LOG: what is left of a log without what is accepted; the log's lines are FILE:LINE: TEXT
    grep -v '^ *#' tests/analysers.txt | cut -f1 | grep -v '^$' >"$build/accepted"
    grep -vEf "$build/accepted" "$1"
}
clean() { # clean NAME LOG
    accepted "$2" >"$build/left"
    check "$1" test ! -s "$build/left"
    sed -n '1,20p' "$build/left"
}
for header in jacobi ateb integrators varmass; do
    gcc -std=c99 -O1 -fanalyzer -DVM_API= -I. -c "$build/$header.c" -o "$build/object.o" 2>&1 | grep 'warning:' >"$build/$header.gcc"
    clean "gcc -fanalyzer: $header.h" "$build/$header.gcc"
done
if sh tests/install.sh "command -v clang-tidy" clang-tidy; then
    for header in jacobi ateb integrators varmass; do
        clang-tidy --quiet --header-filter='.*' --checks='-*,clang-analyzer-*,bugprone-*,cert-*,misc-*,performance-*,portability-*,
            -bugprone-easily-swappable-parameters,-bugprone-reserved-identifier,-cert-dcl37-c,-cert-dcl51-cpp,-misc-unused-parameters,
            -clang-analyzer-security.insecureAPI.DeprecatedOrUnsafeBufferHandling' \
            "$build/$header.c" -- -std=c99 -DVM_API= -I. 2>/dev/null | grep -E 'warning:|error:' >"$build/$header.tidy"
        clean "clang-tidy: $header.h" "$build/$header.tidy"
    done
fi
if sh tests/install.sh "command -v cppcheck" cppcheck; then
    for header in jacobi ateb integrators varmass; do
        for precision in "" -DVM_USE_FLOAT; do
            cppcheck --std=c99 --enable=warning,performance,portability --inconclusive --addon=misra --quiet -DVM_API= $precision \
                -D__GNUC__=12 -DDBL_MANT_DIG=53 -DFLT_MANT_DIG=24 \
                --template='{file}:{line}: {severity}: {message} [{id}]' -I. "$build/$header.c" 2>&1 |
                grep -v '^nofile' | grep ': ' >"$build/$header.cppcheck$precision"
            clean "cppcheck with MISRA: $header.h $precision" "$build/$header.cppcheck$precision"
        done
    done
fi
check_finish sanitize
