#!/bin/sh
# Run test programs, each a command line of its own, and add up their closing lines 'NAME: N passed, N failed, N skipped'.
# A program that does not close with one, or ends with an error without having counted it, is one failure.
# usage: run.sh LOG COMMAND...
log=$1
shift
: >"$log"
for command in "$@"; do
    sh -c "$command" >"$log.one" 2>&1
    status=$?
    cat "$log.one"
    if ! tail -n 1 "$log.one" | grep -Eq ': [0-9]+ passed, [0-9]+ failed, [0-9]+ skipped$'; then
        echo "$command ended with status $status and no closing line: 0 passed, 1 failed, 0 skipped" | tee -a "$log.one"
    elif [ $status != 0 ] && tail -n 1 "$log.one" | grep -q ' 0 failed,'; then
        echo "$command ended with status $status: 0 passed, 1 failed, 0 skipped" | tee -a "$log.one"
    fi
    echo
    grep -E ': [0-9]+ passed, [0-9]+ failed, [0-9]+ skipped$' "$log.one" >>"$log"
done
rm -f "$log.one"
awk '{passed += $(NF-5); failed += $(NF-3); skipped += $(NF-1)}
     END {printf "%d passed, %d failed, %d skipped\n", passed, failed, skipped; exit failed > 0}' "$log"
