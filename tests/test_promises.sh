#!/bin/sh
# No bound is promised that no test enforces. tests/promises.awk collects the bounds from the comments of public functions,
# the manuals and docs/accuracy.md; tests/promises.txt says which rows of the tests' tables enforce each; here both are compared.
# usage: test_promises.sh BUILD_FOLDER, from the top of the project; it reads BUILD_FOLDER/tests/PROGRAM.log of these programs
build=$1/promises logs=$1/tests
. tests/check.sh
programs="jacobi elliptic_integrals ateb dense attitude jumps jumps2 torque_free lambert drum broken_rotor_stability flow1 supply
    diagnostics duffing jeffcott jeffcott_motion van_der_pol"

for program in $programs; do
    [ -f "$logs/$program.log" ] || make -s "$logs/$program.log" >"$build/making" || cat "$build/making"
    awk -f tests/rows.awk "$logs/$program.log" | awk -F '\t' -v OFS='\t' -v program=$program '{$1 = program; print}'
done >"$build/rows"

# Prints what is wrong, and fails if there is anything.
kept() { # kept FOLDER ROWS: the promises of the texts in FOLDER, those of its tests/promises.txt, and the rows
    awk -f tests/promises.awk "$1/src/jacobi.h" "$1/src/ateb.h" "$1/src/varmass.h" "$1"/src/jacobi/*.h "$1"/src/ateb/*.h \
        "$1/docs/accuracy.md" >"$build/promised"
    for room in base integrators mechanics oscillators scenes; do awk -f tests/promises.awk "$1/src/$room"/*.h; done |
        grep -v '	none$' >>"$build/promised" # where nothing is promised, nothing has to be enforced
    awk -F '\t' -v folder="$1" -v rows="$2" '
        function wrong(text) { print text; failures++ }
        function name(where, bound, unit) {
            if (unit == "none") return where " @ none"
            return where " @ " (unit == "as" ? "as " bound : bound + 0 " " unit)
        }
        function in_file(file, words,    line, found) { # do the words stand in the file?
            while ((getline line <file) > 0) if (index(line, words)) found = 1
            close(file)
            return found
        }
        # does every row that matches allow no more than the bound, in both precisions?
        function check_rows(promise, bound, spec,    part, n, i, k, seen) {
            n = split(spec, part, / [\/] /)
            for (i = 1; i <= row_count; i++) {
                split(row[i], k, "\t")
                if (k[1] != part[1] || k[3] !~ "^(" part[2] ")$" || k[5] !~ "^(" part[3] ")$") continue
                if (n > 3 && k[4] !~ "^(" part[4] ")$") continue
                seen[k[2]] = 1
                if (bound != "" && k[7] + 0 > bound + 0)
                    wrong(promise ": the test allows " k[7] " in the row " k[1] ", " k[2] ", " k[3] ", " k[4])
            }
            if (!("double" in seen) || !("float" in seen)) wrong(promise ": no row of both precisions is: " spec)
        }
        BEGIN { while ((getline line <rows) > 0) row[++row_count] = line }
        FILENAME ~ /promised$/ {
            promise = name($1, $2, $3)
            promised[promise] = 1
            bound_of[promise] = $3 == "as" || $3 == "none" ? "" : $2
            next
        }
        /^#/ || /^$/ { next }
        {
            split($0, field, / @ /)
            promise = field[1] " @ " field[2]
            if (!(promise in promised)) { wrong("nowhere promised: " promise); next }
            enforced[promise] = 1
            kind = field[3]
            sub(/ .*/, "", kind)
            how = substr(field[3], length(kind) + 2)
            if (kind == "rows") check_rows(promise, bound_of[promise], how)
            else if (kind == "text") {
                file = substr(how, 1, index(how, " / ") - 1)
                if (!in_file(folder "/" file, substr(how, index(how, " / ") + 3)))
                    wrong(promise ": not in " file ": " substr(how, index(how, " / ") + 3))
            } else if (kind != "input" && kind != "none") wrong("neither rows, text, input nor none: " $0)
        }
        END {
            for (promise in promised) if (!(promise in enforced)) wrong("promised, but no test is named: " promise)
            exit failures > 0
        }' "$build/promised" "$1/tests/promises.txt"
}
check "the kernels' comments have the bounds that are proved" awk -f tests/proof/bounds.awk tests/proof/bounds.txt
check "the bounds are found" test "$(awk -f tests/promises.awk src/jacobi/*.h src/ateb/*.h | grep -c 'ulp$')" -gt 50
check "every promise is enforced by a test" kept . "$build/rows"

# what kept must find, each in a copy of the texts
copy=$build/copy
lie() { # lie NAME FILE SED: the copy, with that file changed, is refused
    rm -rf "$copy" && mkdir -p "$copy/tests" "$copy/docs" && cp -R src "$copy" && cp docs/accuracy.md "$copy/docs"
    cp tests/promises.txt tests/test_*.c "$copy/tests"
    sed "$3" "$2" >"$copy/$2"
    check "the lie changes $2" fails cmp -s "$2" "$copy/$2"
    check "found: $1" fails kept "$copy" "$build/rows"
}
lie "a comment promises more than the test asks" src/jacobi/integrals.h 's/most 2 ulp\. Returns infinity/most 1 ulp. Returns infinity/'
lie "the manual promises more than the test asks" src/ateb.h 's/Pi_alpha               <= 1 ulp/Pi_alpha               <= 0.5 ulp/'
lie "docs/accuracy.md promises more than the test asks" docs/accuracy.md 's/| 8; 5 eps |/| 4; 5 eps |/'
lie "a promise that no test is named for" src/ateb/integrals.h 's/No digits cancel for a small s/The error is at most 3 ulp/'
lie "a function of bodies promises more" src/mechanics/vectors.h 's/Its error is within 2 eps/Its error is within 1 eps/'
lie "an oscillator promises more" src/oscillators/duffing.h 's/relative error is at most 8 eps$/relative error is at most 4 eps/'
lie "a body promises what no test is named for" src/mechanics/orbit.h 's/^.. Position and velocity after t seconds on/\/* To 3 ulp: position and velocity after t seconds on/'
lie "a check that is gone" tests/test_jacobi.c 's/jacobi_dn(u, m) == dn/1/'
rm -rf "$copy" && mkdir -p "$copy" && cp -R src "$copy"
sed 's/sine is within 0.94 ulp/sine is within 0.6 ulp/' src/base/elementary.h >"$copy/src/base/elementary.h"
check "found: a kernel's comment promises more than is proved" fails awk -v root="$copy" -f tests/proof/bounds.awk tests/proof/bounds.txt
sed '/	double	K	/s/	2	/	3	/' "$build/rows" >"$build/weaker"
check "found: a test that allows more" fails kept . "$build/weaker"
check_finish promises
