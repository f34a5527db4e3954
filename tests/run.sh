#!/bin/sh
# Run test programs, keep what they print, and add up their closing lines 'NAME: N passed, N failed, N skipped'.
#
#   run.sh one LOG COMMAND...   runs the commands, each a command line of its own, writes all that they print to LOG, and
#                               prints one line; after it, where something failed, the failures, and what is skipped
#   run.sh sum LOG...           prints the sum over these logs and fails where a test has failed. A log that is not there
#                               belongs to a program that was not built, which is one failure.
#
# A command that does not end with a closing line, or ends with an error without having counted it, is one failure.
closing=': [0-9]+ passed, [0-9]+ failed, [0-9]+ skipped$'
sum_of='{passed += $(NF-5); failed += $(NF-3); skipped += $(NF-1)}
    END {printf "%d passed, %d failed, %d skipped\n", passed, failed, skipped; exit failed > 0}'

run() { # run COMMAND : what it prints, to the file $log.one
    sh -c "$1" >"$log.one" 2>&1
    status=$?
    if ! tail -n 1 "$log.one" | grep -Eq "$closing"; then
        echo "FAILED: $1 ended with status $status and no closing line: 0 passed, 1 failed, 0 skipped" >>"$log.one"
    elif [ $status != 0 ] && tail -n 1 "$log.one" | grep -q ' 0 failed,'; then
        echo "FAILED: $1 ended with status $status: 0 passed, 1 failed, 0 skipped" >>"$log.one"
    fi
}

# What a reader needs of a log in which something failed: all but the rows of the table of worst errors that hold and
# the closing lines of programs that pass
failures() {
    awk '/ unit +worst +bound +n +worst at$/ {in_table = 1; next}
        / passed, 0 failed, / {in_table = 0; next}
        / passed, [0-9]+ failed, / {in_table = 0}
        !in_table || /FAILED/ {print "    " $0}' "$1"
}
skips() { grep -E '^(skipped: |NOT CHECKED|not here: |installing )' "$1" | sort -u | sed 's/^/    /'; }

one() {
    log=$1
    shift
    : >"$log"
    for command in "$@"; do
        run "$command"
        cat "$log.one" >>"$log"
    done
    name=$(basename "$log" .log)
    total=$(grep -E "$closing" "$log" | awk "$sum_of")
    {
        echo "$name: $total"
        case $total in
        *" 0 failed, "*) skips "$log" ;;
        *) failures "$log" ;;
        esac
    } >"$log.one"
    cat "$log.one"
    rm -f "$log.one"
}

sum() {
    for log in "$@"; do
        if [ -e "$log" ]; then
            grep -E "$closing" "$log"
        else
            name=$(basename "$log" .log)
            echo "FAILED: $name was not built: 0 passed, 1 failed, 0 skipped"
            echo "FAILED: $name was not built" >&2
        fi
    done | awk "$sum_of"
}

mode=$1
shift
case $mode in
one) one "$@" ;;
sum) sum "$@" ;;
*) echo "run.sh one or sum, not $mode" >&2; exit 2 ;;
esac
