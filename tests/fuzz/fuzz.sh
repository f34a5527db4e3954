#!/bin/sh
# Fuzz every target in both precisions, two runs at a time, for SECONDS in all, by clang's libFuzzer with ASan and UBSan; inputs that
# violate a property stay in BUILD/fuzz/TARGET-PRECISION-crash-*, from where they go to tests/fuzz/corpus with a line of what
# went wrong. A run that came to its end is kept in BUILD/fuzz/TARGET-PRECISION.kept, and is not run again while its time and the
# machine code of the target stay as they are. So a run of hours that was broken off goes on where it was, and a change of the
# headers only repeats the targets that call what was changed.
# usage: fuzz.sh BUILD SECONDS [TARGET...], from the top of the project
build=$1/fuzz seconds=$2
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
sources_of() { # sources_of TARGET PRECISION: the run's time and a hash of the target's machine code, without sanitizers
    echo "$each s, $(clang -std=c99 -O1 $(flags_of "$2") -S "tests/fuzz/$1.c" -o - | cksum)"
}
is_kept() { [ "$(head -n 1 "$build/$1-$2.kept" 2>/dev/null)" = "$(sources_of "$1" "$2")" ]; } # is_kept TARGET PRECISION
fuzz() { # fuzz TARGET PRECISION
    is_kept "$1" "$2" && return
    program=$build/$1-$2
    rm -f "$program.kept"
    mkdir -p "$program.corpus"
    clang -std=c99 -g -O1 -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=undefined $(flags_of "$2") \
        "tests/fuzz/$1.c" -o "$program" -lm >"$program.log" 2>&1 || return
    "$program" -max_total_time=$each -max_len=768 -len_control=0 -timeout=20 -rss_limit_mb=1024 -print_final_stats=1 \
        -artifact_prefix="$program-" -close_fd_mask=0 "$program.corpus" >"$program.log" 2>&1 || return
    {
        sources_of "$1" "$2"
        awk -v name="$1 $2" '/cov:/ {for (i = 1; i < NF; i++) if ($i == "cov:") cov = $(i + 1)}
            /number_of_executed_units/ {n = $2} /average_exec_per_sec/ {rate = $2}
            END {printf "%-20s %9d inputs, %7d inputs/s, %5d edges\n", name, n, rate, cov}' "$program.log"
    } >"$program.kept"
}

passed=0 failed=0
for target in "$@"; do
    fuzz "$target" double &
    fuzz "$target" float
    wait
    for precision in double float; do
        if is_kept "$target" $precision; then
            sed -n 2p "$build/$target-$precision.kept"
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
