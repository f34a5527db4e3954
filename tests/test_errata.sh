#!/bin/sh
# docs/errata.md from tests/data/errata.txt, each row with the tests that show it. A test shows a row where it calls
# ERRATUM("the row's name", ...) (tests/check.h), in code that is compiled: an equation's number elsewhere does not
# count. As a test: every row that is wrong, ambiguous or a misprint has its test, but for those that were checked by reading alone
# and are misprints; every ERRATUM names such a row; and the document is up to date.
# usage: test_errata.sh BUILD_FOLDER [write], from the top of the project
build=$1/errata
. tests/check.sh
errata=tests/data/errata.txt

marks() { # of each ERRATUM("row", ...) outside of comments and of #if 0: the row, the test
    awk '
        function name_of(file) { sub(/.*\/test_/, "", file); sub(/\.c$/, "", file); return file }
        FNR == 1 { in_comment = left_out = 0 }
        /^ *# *if 0/ { left_out = 1 }
        left_out { if (/^ *# *(else|endif)/) left_out = 0; next }
        {
            line = $0; code = ""
            while (line != "") {
                if (in_comment) {
                    end = index(line, "*/")
                    if (!end) break
                    line = substr(line, end + 2); in_comment = 0
                } else {
                    start = match(line, /\/[*\/]/)
                    if (!start) { code = code line; break }
                    code = code substr(line, 1, start - 1)
                    if (substr(line, start, 2) == "//") break
                    line = substr(line, start + 2); in_comment = 1
                }
            }
            while (match(code, /(^|[^A-Za-z0-9_])ERRATUM\("[^"]*"/)) {
                mark = substr(code, RSTART, RLENGTH)
                code = substr(code, RSTART + RLENGTH)
                sub(/^.*ERRATUM\("/, "", mark); sub(/"$/, "", mark)
                print mark "\t" name_of(FILENAME)
            }
        }' tests/test_*.c | sort -u
}
list() { # each row with a last column: the tests that show it, separated by commas
    awk -F'\t' '
        FILENAME == ARGV[1] { tests[$1] = tests[$1] (tests[$1] == "" ? "" : ", ") $2; next }
        /^#/ || NF == 0 { next }
        { print $1 "\t" $2 "\t" $3 "\t" $4 "\t" $5 "\t" tests[$1] }' "$build/marks" "$errata"
}
write() {
    cat <<'END'
# Errata

This page lists what is wrong, misprinted or ambiguous in Cveticanin's dissertation *Dynamics of Mass Variable System*, and what
is right instead. The table below has a row for each such item. The command `sh tests/test_errata.sh build write` writes this page
from tests/data/errata.txt.

- The column "equation" names the place in the dissertation; for example, (16) means equation 16, and T3.6 means row 6 of Table 3.
- The verdict "wrong" means that the printed formula, number or statement is false, and not only misprinted, so that results that
  are computed with it are wrong. The verdict "misprint" means a slip of writing, such as a wrong sign: the dissertation itself goes
  on with the right form, so that its later results do not contain the slip. The verdict "ambiguous" means that the printed text
  can be read in several ways, of which only one is right.
- The column "how it was checked" shows how far the printed form and the corrected form are from the truth: it gives their errors,
  or their values and the true value. If only one number is given, such as 3e-15, this number is the error of the corrected form.
  The truth is, for example, an exact solution, or a motion that was integrated numerically from the right equations. In this
  column "ODE" means the result of direct numerical integration of the equation of motion. A residual is the difference of the two
  sides of a balance, such as the balance of momentum. "The sample" is the set of numbers with which the test computes the item.
  "Reading" means that the item was found by reading; only if the row names a test, something was computed, too. If the column
  "how it was checked" is empty, the column "what is true" has the numbers, if there are any.
- The last column, "tests", has the names of the tests that compute the item with numbers; the test NAME is the file
  tests/test_NAME.c. For each item that has a test, the test calls the macro ERRATUM. The first argument of the call repeats the
  cell of the column "equation", as in ERRATUM("(16)", ...). The call checks that the printed form of the equation is wrong and
  that the corrected form is right.
- In the formulas S is the mass centre of the initial body, S1 the mass centre of the final body, and S2 the mass centre of the
  part that joins or leaves. The letters O and Om mean an angular velocity Omega; only in dL_O, I^M_O, "about O" and O=S is O a
  point, the origin of the position vectors. O1 and Om1 mean Omega_1, the angular velocity of the final body, and O2 and Om2 mean
  Omega_2, that of the part. Or means Omega_r and Or1 means Omega_r1: these are Omega_2 and Omega_1 relative to the initial body.
  Ob means Omega_b, the angular velocity before the break or at the start. The letter w means the Greek letter omega. For a column
  vector d, P(d) means the matrix |d|^2 E - d d^T, where E is the unit matrix. The letters a and alpha mean the exponent of the
  elastic force, but l in the row (81) means lambda. In products such as Om2 k the letter k is the unit vector perpendicular to the
  plane of the motion. The [glossary](glossary.md) has the other symbols.

END
    awk -F'\t' '$2 != "verified" {n[$2]++; if ($6 == "") none++} $2 == "verified" {v++} END {
        printf "%d items of the dissertation (equations, tables and statements) were checked. %d of them are right as\n", NR, v
        printf "printed; %d are wrong, %d are misprints and %d are ambiguous. ", n["wrong"], n["misprint"], n["ambiguous"]
        printf "%d misprints have no test,\nbecause they are misprints of words, in which there is nothing to compute.\n\n", none}' "$build/rows"
    echo '| equation | what is printed | verdict | what is true | how it was checked | tests |'
    echo '|---|---|---|---|---|---|'
    awk -F'\t' '$2 != "verified" {
        for (i = 1; i <= 5; i++) gsub(/\|/, "\\|", $i)
        print "| " $1 " | " $3 " | " $2 " | " $4 " | " $5 " | " $6 " |"}' "$build/rows"
}
every_row_is_shown() {
    awk -F'\t' '$2 != "verified" && $6 == "" && !($2 == "misprint" && $5 == "reading") {print "no test shows " $1; n++}
        END {exit n > 0}' "$build/rows"
}
every_mark_is_a_row() {
    awk -F'\t' 'FILENAME == ARGV[1] {verdict[$1] = $2; next}
        !($1 in verdict) {print "tests/test_" $2 ".c names no row of the errata: " $1; n++}
        verdict[$1] == "verified" {print "tests/test_" $2 ".c names a row that holds as printed: " $1; n++}
        END {exit n > 0}' "$build/rows" "$build/marks"
}
rows_are_whole() { # five columns, a known verdict, a name of its own without quotes
    awk -F'\t' '/^#/ || NF == 0 {next}
        NF != 5 {print "not five columns: " $0; n++}
        $2 !~ /^(verified|misprint|ambiguous|wrong)$/ {print "no verdict: " $0; n++}
        seen[$1]++ {print "twice: " $1; n++}
        $1 ~ /["\\]/ {print "a quote in the name: " $1; n++}
        END {exit n > 0}' "$errata"
}
readme_counts() { # the README says how many items there are
    items=$(awk -F'\t' '$2 != "verified"' "$build/rows" | wc -l)
    grep -q "lists $((items)) places" README.md || { echo "README.md does not say: lists $((items)) places"; false; }
}

marks >"$build/marks"
list >"$build/rows"
write >"$build/errata.md"
[ "$2" = write ] && cp "$build/errata.md" docs/errata.md
check "the rows are whole" rows_are_whole
check "a test shows every row" every_row_is_shown
check "every ERRATUM names a row" every_mark_is_a_row
check "docs/errata.md is up to date" cmp "$build/errata.md" docs/errata.md
check "the README counts the errata" readme_counts
check_finish errata
