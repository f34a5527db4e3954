#!/bin/sh
# Fuzz every target in both precisions for SECONDS in all, by clang's libFuzzer with ASan and UBSan; inputs that
# violate a property stay in BUILD/fuzz/TARGET-crash-*, from where they go to tests/fuzz/corpus with a line of what
# went wrong.
# usage: fuzz.sh BUILD SECONDS [TARGET...], from the top of the project
build=$1/fuzz seconds=$2
shift 2
[ $# -gt 0 ] || set -- $(ls tests/fuzz/*.c | sed 's|.*/||; s|\.c$||; /^replay$/d')
each=$((seconds / (2 * $#))) failed=0
[ $each -gt 0 ] || each=1
sh tests/fuzz/called.sh tests/fuzz/*.c tests/fuzz/*.h || exit 1
if ! command -v clang >/dev/null; then
    echo "fuzz: clang is not there: 0 passed, 0 failed, 1 skipped"
    exit 0
fi
mkdir -p "$build"
for target in "$@"; do
    for precision in double float; do
        program=$build/$target-$precision flags=
        [ $precision = float ] && flags=-DVM_USE_FLOAT
        clang -std=c99 -g -O1 -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=undefined $flags \
            tests/fuzz/$target.c -o "$program" -lm 2>"$program.log" || { cat "$program.log"; exit 1; }
        mkdir -p "$program.corpus"
        if "$program" -max_total_time=$each -max_len=768 -len_control=0 -timeout=20 -rss_limit_mb=1024 \
            -print_final_stats=1 -artifact_prefix="$program-" -close_fd_mask=0 "$program.corpus" >"$program.log" 2>&1
        then
            awk -v name="$target $precision" '/cov:/ {for (i = 1; i < NF; i++) if ($i == "cov:") cov = $(i + 1)}
                /number_of_executed_units/ {n = $2} /average_exec_per_sec/ {rate = $2}
                END {printf "%-20s %9d inputs, %7d inputs/s, %5d edges\n", name, n, rate, cov}' "$program.log"
        else
            grep -E 'VIOLATED|ERROR|runtime error|Test unit written' "$program.log" | head -4
            failed=$((failed + 1))
        fi
    done
done
echo "fuzz: $((2 * $# - failed)) passed, $failed failed, 0 skipped"
[ $failed = 0 ]
