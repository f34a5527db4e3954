#!/bin/sh
# The tests under the sanitizers of gcc and clang and under valgrind, and the headers by the static analysers. Accepted findings are
# in tests/analysers.txt, one a line with its reason; any other one fails. A test that passed is kept in BUILD_FOLDER/sanitized
# (tests/kept.sh), and is not run again.
# usage: sanitize.sh BUILD_FOLDER PART TEST...      PART: quick, ASan and UBSan in double alone, by $CC; or of the whole
#        run, sanitizers, or gcc, memory, clang of them; valgrind; static, or analyser, tidy, misra of it; or all, these three
build=$1/sanitize part=$2 kept=$1/sanitized
shift 2
. tests/check.sh
[ "$part" = quick ] && kept=$build/kept
. tests/kept.sh
jobs=$(nproc 2>/dev/null || echo 2)
mkdir "$build/declared"
declare_headers "$build/declared"

# Each of the tests, run by a command, runs to the end without a word of a sanitizer. As in make test the headers are compiled
# once, and the tests are linked with this object.
sanitized() { # sanitized NAME "COMPILER FLAGS" "COMMAND" TEST...
    log=$build/$1 title=$1 compile=$2 command=$3
    shift 3
    check "$title: the headers compile" $compile -O1 -DVM_API= -x c -c varmass.h -o "$log.headers.o"
    for test in "$@"; do is_kept "$title" $test || echo $test; done | xargs -P "$jobs" -I{} sh -c "
        kept=$kept; . tests/kept.sh
        { $compile -O1 -fno-inline -w -include tests/linked.h \$(declared $build/declared {}) tests/test_{}.c $log.headers.o -o $log.{} -lm &&
        $command $log.{}; } >$log.{}.log 2>&1 && keep $title {} passed"
    for test in "$@"; do
        check "$title: $test" is_kept "$title" $test
        grep -s -m 3 -E 'runtime error|ERROR: |WARNING: |^==.* at 0x' "$log.$test.log"
    done
}

if [ "$part" = quick ]; then
    sanitized quick "${CC:-gcc} -std=c99 -g -fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all" "" "$@"
    check_finish sanitize
    exit
fi
all="$*"
run() { # run SUITE...
    for precision in "" -DVM_USE_FLOAT; do
        for suite in "$@"; do
            case $suite in
            gcc) command="gcc -fsanitize=address,undefined,float-cast-overflow" ;;
            memory) command="clang -fsanitize=memory" ;;
            clang) command="clang -fsanitize=undefined,float-cast-overflow,implicit-conversion" ;;
            esac
            sanitized "$suite$precision" "$command -fno-sanitize-recover=all -std=c99 -g $precision" "" $all
        done
    done
}

valgrind_runs() {
    sh tests/install.sh "command -v valgrind" valgrind || return
    sanitized valgrind "gcc -std=c99 -g" "valgrind -q --error-exitcode=9 --suppressions=tests/valgrind.txt" $all
}

# clang-tidy and cppcheck see each header by a source that uses nothing of it: all its functions are external. So seen,
# varmass.h is too much for gcc's analyser: it gets forty functions at a time whose address is taken, and what they call.
functions() { # functions HEADER...: their names in order
    printf '#include "%s.h"\n' "$@" >"$build/some.c"
    gcc -std=c99 -DVM_API= -I. -c "$build/some.c" -o "$build/object.o" && nm "$build/object.o" | sed -n 's/^[0-9a-f]* T //p' | sort
}
analysed() { # analysed HEADER: the warnings of gcc -fanalyzer about the functions of a header
    functions "$1" >"$build/functions" && test -s "$build/functions" || return 1
    if [ "$1" = varmass ]; then functions jacobi ateb integrators; fi | comm -13 - "$build/functions" | xargs -n 40 |
        while read -r names; do
            {
                printf '#include "%s.h"\ntypedef void (*function)(void);\nfunction volatile functions[] = {' "$1"
                printf '(function)%s, ' $names
                echo '0};'
            } >"$build/some.c"
            gcc -std=c99 -O1 -fno-inline -fanalyzer '-DVM_API=static inline' -I. -c "$build/some.c" -o "$build/object.o" 2>&1 |
                grep -E 'warning:|error:'
        done | sort -u
}
accepted() { # accepted LOG: what is left of a log without what is accepted; the log's lines are FILE:LINE: TEXT
    grep -v '^ *#' tests/analysers.txt | cut -f1 | grep -v '^$' >"$build/accepted"
    grep -vEf "$build/accepted" "$1"
}
clean() { # clean NAME LOG
    accepted "$2" >"$build/left"
    check "$1" test ! -s "$build/left"
    sed -n '1,20p' "$build/left"
}
sources() { for header in jacobi ateb integrators varmass; do printf '#include "%s.h"\n' $header >"$build/$header.c"; done; }
analyser() {
    for header in jacobi ateb integrators varmass; do
        analysed $header >"$build/$header.gcc" || echo "$header.h: not analysed" >"$build/$header.gcc"
        clean "gcc -fanalyzer: $header.h" "$build/$header.gcc"
    done
}
tidy() {
    sh tests/install.sh "command -v clang-tidy" clang-tidy || return
    for header in jacobi ateb integrators varmass; do
        clang-tidy --quiet --header-filter='.*' --checks='-*,clang-analyzer-*,bugprone-*,cert-*,misc-*,performance-*,portability-*,
            -bugprone-easily-swappable-parameters,-bugprone-reserved-identifier,-cert-dcl37-c,-cert-dcl51-cpp,-misc-unused-parameters,
            -clang-analyzer-security.insecureAPI.DeprecatedOrUnsafeBufferHandling' \
            "$build/$header.c" -- -std=c99 -DVM_API= -I. 2>/dev/null | grep -E 'warning:|error:' >"$build/$header.tidy"
        clean "clang-tidy: $header.h" "$build/$header.tidy"
    done
}
misra() {
    sh tests/install.sh "command -v cppcheck" cppcheck || return
    for header in jacobi ateb integrators varmass; do
        for precision in "" -DVM_USE_FLOAT; do
            cppcheck --std=c99 --enable=warning,performance,portability --inconclusive --addon=misra --quiet -DVM_API= $precision \
                -D__GNUC__=12 -DDBL_MANT_DIG=53 -DFLT_MANT_DIG=24 \
                --template='{file}:{line}: {severity}: {message} [{id}]' -I. "$build/$header.c" 2>&1 |
                grep -v '^nofile' | grep ': ' >"$build/$header.cppcheck$precision"
            clean "cppcheck with MISRA: $header.h $precision" "$build/$header.cppcheck$precision"
        done
    done
}

case $part in
run) run gcc memory clang ;;
gcc | memory | clang) run $part ;;
valgrind) valgrind_runs ;;
analyser | tidy | misra) sources; $part ;;
static) sources; analyser; tidy; misra ;;
all) run gcc memory clang; valgrind_runs; sources; analyser; tidy; misra ;;
*) echo "no such part: $part" >&2; exit 2 ;;
esac
check_finish sanitize
