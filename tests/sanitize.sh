#!/bin/sh
# The tests under the sanitizers of gcc and clang and under valgrind, the headers by the static analysers. Findings that
# are kept on purpose are in tests/analysers.txt with their reason, one a line; any other one fails.
# usage: sanitize.sh BUILD_FOLDER PART TEST...      PART: quick, ASan and UBSan in double alone, by $CC; or of the whole
#        run, sanitizers; valgrind; static, the analysers; or all, these three
build=$1/sanitize part=$2
shift 2
. tests/check.sh
jobs=$(nproc 2>/dev/null || echo 2)

# Each of the tests, built by a compiler with its flags, runs to the end without a word of a sanitizer
sanitized() { # sanitized NAME "COMPILER FLAGS" TEST...
    suite=$1 command=$2
    shift 2
    printf '%s\n' "$@" | xargs -P "$jobs" -I{} sh -c "
        $command tests/test_{}.c -o $build/$suite.{} -lm >$build/$suite.{}.log 2>&1 &&
        $build/$suite.{} >>$build/$suite.{}.log 2>&1; echo \$? >$build/$suite.{}.status"
    for test in "$@"; do
        check "$suite: $test" test "$(cat "$build/$suite.$test.status")" = 0
        grep -m 3 -E 'runtime error|ERROR: |WARNING: ' "$build/$suite.$test.log"
    done
}

if [ $part = quick ]; then
    sanitized quick "${CC:-gcc} -std=c99 -g -O0 -fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all" "$@"
    check_finish sanitize
    exit
fi
all="$*"
run() { # without optimisation: with it they take minutes to compile
    for precision in "" -DVM_USE_FLOAT; do
        sanitized "gcc$precision" "gcc -std=c99 -g -O0 $precision -fsanitize=address,undefined,float-cast-overflow \
            -fno-sanitize-recover=all" $all
        sanitized "memory$precision" "clang -std=c99 -g -O0 $precision -fsanitize=memory -fno-sanitize-recover=all" $all
        sanitized "clang$precision" "clang -std=c99 -g -O0 $precision \
            -fsanitize=undefined,float-cast-overflow,implicit-conversion -fno-sanitize-recover=all" $all
    done
}

valgrind_runs() { # forty times slower: on what is quickest
    sh tests/install.sh "command -v valgrind" valgrind || return
    for test in events varmass dissertation refusals; do
        gcc -std=c99 -g -O1 -fno-inline tests/test_$test.c -o "$build/valgrind.$test" -lm
        check "valgrind: $test" valgrind -q --error-exitcode=9 "$build/valgrind.$test"
    done
}

# The analysers see each header by a source that uses nothing of it: all its functions are external
accepted() { # accepted LOG: what is left of a log without what is accepted; the log's lines are FILE:LINE: TEXT
    grep -v '^ *#' tests/analysers.txt | cut -f1 | grep -v '^$' >"$build/accepted"
    grep -vEf "$build/accepted" "$1"
}
clean() { # clean NAME LOG
    accepted "$2" >"$build/left"
    check "$1" test ! -s "$build/left"
    sed -n '1,20p' "$build/left"
}
static() {
    for header in jacobi ateb integrators varmass; do printf '#include "%s.h"\n' $header >"$build/$header.c"; done
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
}

case $part in
run) run ;;
valgrind) valgrind_runs ;;
static) static ;;
all) run; valgrind_runs; static ;;
esac
check_finish sanitize
