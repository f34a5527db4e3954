#!/bin/sh
# No document holds a table without rows or a number that is none, the program that counts instructions fails where it
# cannot count, docs/validation.md has the rows of its test, and docs/changes.md knows every public name of version 0.1.
# usage: test_documents.sh BUILD_FOLDER, from the top of the project
build=$1/documents
. tests/check.sh

# Prints the lines that are wrong, and fails if there are any: nan or inf, as C prints them, as a word of a table's row,
# a table without a row, a generated part without a line.
sound() { # sound DOCUMENT...
    awk '
        function wrong(why) { print FILENAME ":" FNR ": " why ": " $0; n++ }
        function is_rule(line) { return line ~ /^\|[-:| ]*-[-:| ]*$/ }
        FNR == 1 { after_rule = after_mark = 0 }
        after_rule && !/^\|/ { wrong("the table before this line has no row") }
        after_mark && /^<!-- end -->/ { wrong("nothing was generated before this line") }
        { after_rule = is_rule($0); after_mark = /^<!-- table / }
        { words = " " $0 " "; gsub(/[^A-Za-z0-9_.+-]/, " ", words) }
        /^\|/ && words ~ / [-+]?(nan|inf) / { wrong("not a number") }
        END { if (after_rule || after_mark) wrong("nothing comes after"); exit n > 0 }' "$@"
}

for document in README.md docs/*.md; do check "$document: numbers and rows" sound "$document"; done

# what sound must find
planted() { # planted NAME TEXT: a document of that text is not sound
    printf "$2" >"$build/$1.md"
    check "found: $1" fails sound "$build/$1.md"
}
planted nan '| a | b |\n|---|---|\n| `jacobi_K` | -nan | 54 |\n'
planted inf '| a | b |\n|---|---|\n| x | 12 (inf) |\n'
planted rowless '| a | b |\n|---|---|\n\ntext\n'
planted rowless_at_end '| a | b |\n|---|---|\n'
planted unwritten '<!-- table summary -->\n<!-- end -->\n'
printf '| a | b |\n|---|---|\n| NaN is refused, x infinite | `isnan` 1 |\n\ninf is a word\n' >"$build/good.md"
check "NaN in a sentence is none" sound "$build/good.md"

# numbers of the README against the documents that they are from
in_readme() { grep -qF -e "$1" README.md || { echo "README.md does not say: $1"; false; }; }
hard_cases() { # cases; those where the naive formula gives no number; those where it is 1000 times worse, or gives none
    awk -F' *[|] *' '/^\| / && $2 != "what would go wrong" {n++; if ($7 == "no number") none++
            if ($7 == "no number" || $7 >= 1000 * $5) worse++} END {print n, none, worse}' docs/hard-cases.md
}
set -- $(hard_cases)
check "README: number of hard cases" in_readme "has $1 points at which"
check "README: naive formulas without a number" in_readme "it gives no number in $2 of them"
check "README: naive formulas far off" in_readme "a thousand times worse, or more, in $3."
set -- $(awk -F' *[|] *' '$2 == "`GSL rk8pd`, 1e-09" {sub(",", "", $6); print $6}' docs/cost.md)
check "README: GSL's attitude after 1e6 turns" in_readme "$1 rad in $2 $3"
ratios() { # ratios PROBLEMS GOAL ROUTE PEER: least and largest time of the route over the peer's, of docs/cost.md
    awk -F' *[|] *' -v problems="^($1)\$" -v column="$2" -v route="\`$3\`" -v peer="\`$4\`" '
        /^<!-- table integrators/ {on = 1}
        /^<!-- end/ {on = 0}
        on && $2 ~ problems && ($3 == route || $3 == peer) {time[$2, $3] = $column + 0; seen[$2] = 1}
        END {
            for (p in seen) {
                ratio = time[p, route] / time[p, peer]
                if (least == "" || ratio < least) least = ratio
                if (ratio > most) most = ratio
            }
            if (sprintf("%.2f", least) == sprintf("%.2f", most)) printf "%.2f\n", least
            else printf "%.2f to %.2f\n", least, most
        }' docs/cost.md
}
all='cubic|mass|momentum|body|orbit' smooth='cubic|mass|momentum|body'
loop='of a hand-written Dormand-Prince loop'
check "README: rk45 beside a loop" in_readme "$(ratios "$all" 5 rk45_solve dp54_loop) $loop"
check "README: rk45 beside GSL" in_readme "$(ratios "$all" 5 rk45_solve gsl_rkf45) of GSL rkf45"
orbit=$(ratios orbit 6 rk87_solve gsl_rk8pd)
check "README: rk87 beside GSL" in_readme "$(ratios "$smooth" 7 rk87_solve gsl_rk8pd); $orbit of GSL rk8pd"

# docs/validation.md has the groups, rows and published numbers of the test program. Our numbers and the differences may
# differ in the last digits, with the C library's cosine, and are not compared.
without_ours() { awk -F' [|] ' '/^[|]/ {print $1, $2; next} {print}' "$@"; }
validation_is_fresh() {
    make -s build/tests/double/validation || return 1
    ./build/tests/double/validation markdown | without_ours >"$build/validation"
    without_ours docs/validation.md | diff "$build/validation" -
}
check "docs/validation.md has every row of tests/test_validation.c" validation_is_fresh

tables_are_fresh() {
    make -s build/tests/double/tables || return 1
    ./build/tests/double/tables markdown | diff - docs/tables.md
}
check "docs/tables.md is what make tables writes" tables_are_fresh

counted_functions() { # the rows of docs/counts.md are the functions of bench/count.c
    grep -o '^COUNT([a-z0-9_A-Z]*\|^SEPARATE static void count_[a-z_]*' bench/count.c | sed 's/^COUNT(//; s/.*count_//' |
        grep -vx nothing >"$build/functions"
    sed -n 's/^| `\([a-zA-Z0-9_]*\)` |.*/\1/p' docs/counts.md | diff "$build/functions" -
}
check "docs/counts.md has every function of bench/count.c" counted_functions

# bench/count.sh with a valgrind and a callgrind_annotate of the test's own
tool() { # tool NAME BODY
    printf '#!/bin/sh\n%s\n' "$2" >"$build/bin/$1"
    chmod +x "$build/bin/$1"
}
count() { PATH="$build/bin:$PATH" CC=${CC:-cc} FLAGS=-O2 sh bench/count.sh "$build/count"; }
cannot_count() { ! count && ! grep -qs '^|' "$build/count/counts.md"; }
mkdir -p "$build/bin" "$build/count"
case $build in /*) ;; *) build=$PWD/$build ;; esac
printf '#!/bin/sh\necho 200 calls\n' | tee "$build/count/double" >"$build/count/float"
chmod +x "$build/count/double" "$build/count/float"
runs_it='for program; do :; done; "$program"'
annotates='sed -n -e "s/^COUNT(\([a-z0-9_A-Z]*\).*/5,000 (1%) x.c:count_\1 [x]/p" \
    -e "s/^SEPARATE static void \(count_[a-z_]*\).*/5,000 x.c:\1 [x]/p" bench/count.c |
    sed "/count_nothing/ s/5,000/1,000/"'

tool valgrind "$runs_it"
tool callgrind_annotate "$annotates"
twenty_each() { # (5000 - 1000)/200 calls each; arrays have no loop
    count && [ "$(grep -c '^| `.*_array` | 25 | 25 |$\|^| `.*` | 20 | 20 |$' "$build/count/counts.md")" -gt 40 ]
}
check "instructions are counted" twenty_each
tool valgrind 'exit 1'
check "counting fails where valgrind fails" cannot_count
tool valgrind true
check "counting fails where the program is silent" cannot_count
tool valgrind "$runs_it; exit 139"
check "counting fails where the program dies at its end" cannot_count
tool valgrind "$runs_it"
tool callgrind_annotate 'exit 1'
check "counting fails where callgrind_annotate fails" cannot_count
tool callgrind_annotate true
check "counting fails where no function is found" cannot_count
tool callgrind_annotate "$annotates | grep -v 'count_ateb_pi '"
check "counting fails where a function is missing" cannot_count
tool callgrind_annotate "$annotates | sed '/count_ateb_pi / s/5,000/900/'"
check "counting fails where a function takes less than nothing" cannot_count
# docs/changes.md: what became of each public name of version 0.1, and whether the new names exist
words_of_headers() { cat jacobi.h ateb.h integrators.h varmass.h | grep -oE '[A-Za-z_][A-Za-z_0-9]*' | sort -u; }
words_of_headers >"$build/words"
sed -n 's/^\([A-Za-z_0-9]*\) -> \([A-Za-z_0-9]*\)$/\1 \2/p' docs/changes.md >"$build/renamed"
names_are_explained() {
    missing=0
    for name in $(grep -v '^#' tests/data/names_0.1.txt); do
        grep -qx "$name" "$build/words" || grep -q "^$name " "$build/renamed" || grep -q "\`$name\`" docs/changes.md ||
            { echo "$name"; missing=1; }
    done
    [ $missing = 0 ]
}
new_names_exist() {
    missing=0
    for name in $(cut -d' ' -f2 "$build/renamed"); do
        grep -qx "$name" "$build/words" || { echo "$name"; missing=1; }
    done
    [ $missing = 0 ]
}
check "docs/changes.md: the list of names is found" test "$(wc -l <"$build/renamed")" -gt 50
check "docs/changes.md: every public name of version 0.1 still exists or is listed" names_are_explained
check "docs/changes.md: every new name exists" new_names_exist
renames() { # the commands of docs/changes.md, run on a line of a program written for version 0.1
    sed -n '/^    sed -n /,/^$/p' docs/changes.md | sed -n '1s/^    //p' >"$build/rename.sh"
    sh "$build/rename.sh" || return 1
    mv names.sed "$build" && echo 'vm_culprit who; vm_rhs(t, y, d, &f); my_vm_rhs();' | sed -f "$build/names.sed" |
        grep -qx 'vm_scene_fault who; vm_flow_rhs(t, y, d, &f); my_vm_rhs();'
}
check "docs/changes.md: its commands rename" renames
check_finish documents
