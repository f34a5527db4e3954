#!/bin/sh
# The guides, docs/guide-*.md: their program prints what is shown below it, and the functions that they name exist. That the
# programs compile without a warning in C and C++ is checked by tests/test_snippets.sh.
# usage: CC=compiler test_guides.sh BUILD_FOLDER, from the top of the project
build=$1/guides
. tests/check.sh
prints_as_shown() { # prints_as_shown GUIDE PROGRAM : the block of C, and the indented lines after it
    awk '/^```$/ {on = 0} on {print} /^```c$/ {on = ++block == 1}' "$1" >"$2.c" # the first block
    awk '/^```/ {fence = !fence; block++} block >= 2 && !fence && /^    / {print substr($0, 5)}' "$1" >"$2.shown"
    [ -s "$2.shown" ] && ${CC:-cc} -std=c99 -O1 -I. "$2.c" -o "$2" -lm && "$2" >"$2.printed" && diff "$2.shown" "$2.printed"
}
for guide in docs/guide-*.md; do
    check "$guide prints what is shown" prints_as_shown "$guide" "$build/$(basename "$guide" .md)"
    for name in $(grep -o '`[a-z0-9_]*[a-z0-9]`' "$guide" | tr -d '`' | grep -E '^(vm|jacobi|ateb|rk4|rk45|rk87|ode)_' | sort -u); do
        check "$guide: $name" grep -qw "$name" varmass.h ateb.h jacobi.h integrators.h
    done
    for link in $(grep -oh ']([A-Za-z0-9_./-]*)' "$guide" | tr -d ']()' | sort -u); do
        check "$guide links to $link" test -e "docs/$link"
    done
done
each_line_is_shown() { # the program of docs/duffing.md, which has formulas beside it
    awk '/^```$/ {on = 0} on {print} /^```c$/ {on = 1}' docs/duffing.md >"$build/duffing.c"
    ${CC:-cc} -std=c99 -O1 -I. "$build/duffing.c" -o "$build/duffing" -lm && "$build/duffing" >"$build/duffing.printed" || return 1
    [ -s "$build/duffing.printed" ] && while IFS= read -r line; do
        grep -qxF "$line" docs/duffing.md || { echo "not shown: $line"; return 1; }
    done <"$build/duffing.printed"
}
check "docs/duffing.md shows what its program prints" each_line_is_shown
# the errors of envelopes in the guide of oscillators are those that the examples print, for t <= 50
envelopes() {
    make -s build/examples/example1 build/examples/table5 || return 1
    ./build/examples/example1 "$build/example1" | awk '
        /^t <= 200/ {exit}
        / m\^/ {sub(/^ +/, ""); split($0, cell, /  +/); print cell[1] " | " $(NF - 3) " | " $NF}' |
        sed 's/e-0/e-/g; s/^Ateb corrected/Ateb functions, corrected/; s/(400) as printed/, as printed (400)/
            s/^Jacobi (401) as printed/Jacobi functions, as printed (401)/; s/^Jacobi, exact means of cn^2, cn^4/Jacobi functions, exact means/
            s/trigonometric ,/trigonometric,/' >"$build/envelopes"
    sed -n 's/^| \(.*functions.*\|trigonometric.*\) |$/\1/p' docs/guide-oscillators.md >"$build/envelopes_shown"
    [ "$(wc -l <"$build/envelopes_shown")" = 5 ] || return 1
    while IFS= read -r line; do
        grep -qxF "$line" "$build/envelopes" || { echo "not printed: $line"; return 1; }
    done <"$build/envelopes_shown"
    ./build/examples/table5 | grep -q '^38 rows; 17 have a printed digit off'
}
check "the errors of envelopes in docs/guide-oscillators.md" envelopes
for guide in docs/guide-*.md; do check "$guide has a figure" grep -q '^!\[.*](figures/' "$guide"; done
same_rules() { # the MISRA rules of the firmware guide are those whose findings tests/analysers.txt accepts
    sed -n 's/^misra-c2012-\([0-9]*\)\\\.\([0-9]*\).*/\1.\2/p' tests/analysers.txt | sort >"$build/accepted"
    sed -n 's/^| \([0-9]*\.[0-9]*\) | .*/\1/p' docs/guide-firmware.md | sort >"$build/listed"
    [ -s "$build/listed" ] && diff "$build/accepted" "$build/listed"
}
check "the MISRA rules that the firmware guide lists" same_rules
check_finish guides
