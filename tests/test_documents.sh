#!/bin/sh
# No document holds a table without rows or a number that is none, the program that counts instructions fails where it
# cannot count, docs/validation.md has the rows of its test, docs/names.md knows every public name of version 0.1, and what
# is written from a text of bench/ has this text.
# usage: test_documents.sh BUILD_FOLDER, from the top of the project
build=$1/documents
. tests/check.sh

# What every document must satisfy: tests/check_docs.sh says what that is. That the documents are written from today's headers
# is asked by make check-docs alone.
check "the documents are sound" sh tests/check_docs.sh .

# A document that is written from a text of bench/ has all its lines, except those with a @name@ that stands for numbers. Else
# somebody has corrected only the document, and the next make docs would undo this.
texts_are_kept() { # texts_are_kept FOLDER: with the documents
    for text in bench/*.md; do
        document=$1/$(basename "$text" | tr _ -)
        ! grep -v '@[A-Za-z]*@' "$text" | grep -vxF -f "$document" || return 1
    done
}
check "the documents have the texts of bench/" texts_are_kept docs

# lies, each planted in a copy of the documents, which check_docs.sh must refuse for the reason given
copy=$build/copy
fresh_copy() {
    rm -rf "$copy" && mkdir -p "$copy/bench" "$copy/src/jacobi"
    cp README.md jacobi.h ateb.h integrators.h varmass.h "$copy" && cp bench/documents.txt "$copy/bench"
    mkdir -p "$copy/docs" && cp docs/*.md "$copy/docs"
    cp src/jacobi.h src/ateb.h "$copy/src" && cp src/jacobi/means.h "$copy/src/jacobi"
}
refused() { # refused REASON [today] : the copy is refused with these words
    sh tests/check_docs.sh "$copy" "$2" >"$build/said" 2>&1 && return 1
    grep -q "$1" "$build/said" || { cat "$build/said"; false; }
}
lie() { # lie NAME FILE SED REASON [today]
    fresh_copy && sed "$3" "$2" >"$copy/$2"
    check "changed: $1" fails cmp -s "$2" "$copy/$2"
    check "found: $1" refused "$4" "$5"
}
fresh_copy && sed 's/at each time with little work/at each time/' docs/duffing.md >"$copy/docs/duffing.md"
check "found: a sentence that only the document has" fails texts_are_kept "$copy/docs"
lie "a count that is no number" docs/counts.md 's/^| `jacobi_K` | [0-9]*/| `jacobi_K` | -nan/' 'not a number'
lie "infinity beside a number" docs/counts.md 's/^| `jacobi_K` | [0-9]*/| `jacobi_K` | 12 (inf)/' 'not a number'
lie "an empty cell" docs/counts.md 's/^| `jacobi_E` | [0-9]*/| `jacobi_E` | /' 'an empty cell'
lie "a table without rows" docs/promises.md '/^| [^p]/d' 'has no row'
lie "a generated part without a line" docs/cost.md '/^<!-- table summary/,/^<!-- end/{/^|/d}' 'nothing was generated'
lie "a row that lacks a cell" docs/counts.md 's/^| `jacobi_E` | [0-9]* /| `jacobi_E` /' 'a row with 2 cells'
lie "a marked number of the README" README.md 's/has [0-9]*<!--hard_cases-->/has 999<!--hard_cases-->/' 'hard_cases is'
lie "a marked number of a manual" src/jacobi.h 's/[0-9]* \[jacobi_plan_bytes\]/999 [jacobi_plan_bytes]/' 'jacobi_plan_bytes is'
lie "a mark that has no source" README.md 's/<!--hard_cases-->/<!--hard_case-->/' 'no number of this name'
lie "a document without a stamp" docs/counts.md '/^The results on this page/d' 'which headers it was measured on'
lie "a document that hides its age" docs/exhaustive.md \
    's/^The results on this page.*/The results on this page were obtained with the headers ateb.h 00000000, jacobi.h 00000000 (bench)./' 'does not say so' today
lie "a document of make docs from other headers" docs/counts.md \
    's/^The results on this page.*/The results on this page were obtained with the headers ateb.h 00000000 (bench)./' 'make docs' today
fresh_copy && printf '\nint new_line(void);\n' >>"$copy/jacobi.h"
check "found: headers that changed since" refused 'counts.md: written from other headers' today
fresh_copy && printf '\n/* a comment */\n' >>"$copy/jacobi.h"
stamp() { STAMP_ROOT=$1 sh bench/stamp.sh of jacobi; }
check "comments and blanks do not change a stamp" test "$(stamp .)" = "$(stamp "$copy")"
fresh_copy && printf '\nNaN is refused, x infinite; inf is a word.\n' >>"$copy/docs/glossary.md"
check "NaN in a sentence is none" sh tests/check_docs.sh "$copy"

# docs/numbers.md is what the documents say
numbers_are_fresh() { # the table holds no stamp
    BUILD=$build CC=${CC:-cc} sh bench/numbers.sh table >"$build/fresh_numbers" && grep -v '^The results on this page' docs/numbers.md |
        sed '$ {/^$/d}' | diff "$build/fresh_numbers" -
}
check "docs/numbers.md is what the documents say" numbers_are_fresh

# docs/validation.md has the groups, rows and published numbers of the test program. Our numbers and the differences may
# differ in the last digits, with the C library's cosine, and are not compared.
without_ours() { awk -F' [|] ' '/^The results on this page/ {next} /^[|]/ {print $1, $2; next} /./' "$@"; }
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
# The campaigns, each replaced by a target that takes no time: a part that fails does not stop the others, a second call runs
# that part alone, a third one none, and after a change of a header those run that depend on it.
campaigns=$build/campaigns
mkdir -p "$campaigns/bench" "$campaigns/docs" && cp jacobi.h ateb.h integrators.h varmass.h "$campaigns"
cp bench/campaigns.sh bench/stamp.sh bench/documents.txt "$campaigns/bench" && cp docs/*.md "$campaigns/docs"
sed -i '/^| [a-z-]* | `make/d' "$campaigns/docs/campaigns.md" # no campaign has run with these headers
printf '.DEFAULT:\n\t@echo $@ >>ran; echo "3 passed, 0 failed"; ! [ -e broken_$@ ]\n' >"$campaigns/Makefile"
run_campaigns() { (cd "$campaigns" && rm -f ran && touch ran && sh bench/campaigns.sh "$@"); }
ran() { [ "$(paste -s -d ' ' "$campaigns/ran")" = "$1" ] || { cat "$campaigns/ran"; false; }; }
all_of_them=$(sed -n 's/^[a-z-]*; [^;]*; make \([a-z-]*\)[^;]*; .*/\1/p' bench/campaigns.sh | paste -s -d ' ' -)
touch "$campaigns/broken_exhaustive"
check "campaigns: one that fails is told" fails run_campaigns
check "campaigns: the others run nevertheless" ran "$all_of_them"
rm "$campaigns/broken_exhaustive"
check "campaigns: the second call passes" run_campaigns
check "campaigns: it runs what failed" ran exhaustive
each_has_a_row() { [ "$(grep -cE '^[|] .* [|] (passed|3 passed, 0 failed) [|]$' "$campaigns/docs/campaigns.md")" = "$(echo "$all_of_them" | wc -w)" ]; }
check "campaigns: the document has a row for each" each_has_a_row
check "campaigns: a third call passes" run_campaigns
check "campaigns: it runs none" ran ""
echo 'typedef int vmi_changed;' >>"$campaigns/integrators.h"
check "campaigns: after a change of integrators.h" run_campaigns scan events exhaustive
check "campaigns: only what depends on it runs" ran test-events

# docs/names.md: what became of each public name of version 0.1, and whether the new names exist
words_of_headers() { cat jacobi.h ateb.h integrators.h varmass.h | grep -oE '[A-Za-z_][A-Za-z_0-9]*' | sort -u; }
words_of_headers >"$build/words"
sed -n 's/^\([A-Za-z_0-9]*\) -> \([A-Za-z_0-9]*\)$/\1 \2/p' docs/names.md >"$build/renamed"
names_are_explained() {
    missing=0
    for name in $(grep -v '^#' tests/data/names_0.1.txt); do
        grep -qx "$name" "$build/words" || grep -q "^$name " "$build/renamed" || grep -q "\`$name\`" docs/names.md docs/changes.md ||
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
check "docs/names.md: the list of names is found" test "$(wc -l <"$build/renamed")" -gt 50
check "docs/names.md: every public name of version 0.1 still exists or is listed" names_are_explained
check "docs/names.md: every new name exists" new_names_exist
renames() { # the commands of docs/names.md, run on a line of a program written for version 0.1
    sed -n '/^    sed -n /,/^$/p' docs/names.md | sed -n '1s/^    //p' >"$build/rename.sh"
    sh "$build/rename.sh" || return 1
    mv names.sed "$build" && echo 'vm_culprit who; vm_rhs(t, y, d, &f); my_vm_rhs();' | sed -f "$build/names.sed" |
        grep -qx 'vm_scene_fault who; vm_flow_rhs(t, y, d, &f); my_vm_rhs();'
}
check "docs/names.md: its commands rename" renames
check_finish documents
