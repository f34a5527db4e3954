#!/bin/sh
# Fuzz every target in both precisions, two runs at a time, for SECONDS in all, by clang's libFuzzer with ASan and UBSan; inputs that
# violate a property stay in BUILD/fuzz/TARGET-PRECISION-crash-*, from where they go to tests/fuzz/corpus with a line of what
# went wrong. A run that came to its end has a line in tests/fuzz/kept.txt, and is not run again while its time and the machine
# code of the target stay as they are. So a run of hours that was broken off goes on where it was, also in another checkout, and
# a change of the headers only repeats the targets that call what was changed.
# usage: fuzz.sh BUILD SECONDS [TARGET...], from the top of the project
build=$1/fuzz seconds=$2 kept=tests/fuzz/kept.txt
shift 2
[ $# -gt 0 ] || set -- $(ls tests/fuzz/*.c | sed 's|.*/||; s|\.c$||; /^replay$/d')
each=$((seconds / (2 * $#)))
[ $each -gt 0 ] || each=1
sh tests/fuzz/called.sh tests/fuzz/*.c tests/fuzz/*.h || exit 1
if ! command -v clang >/dev/null; then
    echo "fuzz: clang is not there: 0 passed, 0 failed, 1 skipped"
    exit 0
fi
mkdir -p "$build"

flags_of() { [ "$1" = double ] || echo -DVM_USE_FLOAT; } # flags_of PRECISION
code_of() { # code_of TARGET PRECISION: the run's time and a checksum of the target's machine code, without sanitizers
    echo "$each s, $(clang -std=c99 -O1 $(flags_of "$2") -S "tests/fuzz/$1.c" -o - | cksum)"
}
is_kept() { grep -sqF "$1 $2: $(code_of "$1" "$2"): " $kept; } # is_kept TARGET PRECISION
fuzz() { # fuzz TARGET PRECISION
    is_kept "$1" "$2" && return
    program=$build/$1-$2
    code_of "$1" "$2" >"$program.code"
    rm -f "$program.result"
    mkdir -p "$program.corpus"
    clang -std=c99 -g -O1 -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=undefined $(flags_of "$2") \
        "tests/fuzz/$1.c" -o "$program" -lm >"$program.log" 2>&1 || return
    "$program" -max_total_time=$each -max_len=768 -len_control=0 -timeout=20 -rss_limit_mb=1024 -print_final_stats=1 \
        -artifact_prefix="$program-" -close_fd_mask=0 "$program.corpus" >"$program.log" 2>&1 || return
    awk '/cov:/ {for (i = 1; i < NF; i++) if ($i == "cov:") cov = $(i + 1)}
        /number_of_executed_units/ {n = $2} /average_exec_per_sec/ {rate = $2}
        END {printf "%d inputs, %d inputs/s, %d edges\n", n, rate, cov}' "$program.log" >"$program.result"
}

passed=0 failed=0
for target in "$@"; do
    fuzz "$target" double &
    fuzz "$target" float
    wait
    for precision in double float; do
        run=$build/$target-$precision
        [ ! -f "$run.result" ] || sh tests/keep_line.sh $kept "$target $precision" "$(cat "$run.code")" "$(cat "$run.result")"
        rm -f "$run.result"
        if is_kept "$target" $precision; then
            grep "^$target $precision: " $kept
            passed=$((passed + 1))
        else
            echo "$target $precision: FAILED"
            grep -m 4 -E 'VIOLATED|ERROR|runtime error|Test unit written|error:' "$build/$target-$precision.log"
            failed=$((failed + 1))
        fi
    done
done
echo "fuzz: $passed passed, $failed failed, 0 skipped"
[ $failed = 0 ]
