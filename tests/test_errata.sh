#!/bin/sh
# docs/errata.md from tests/data/errata.txt, each row with the tests that name its equation; as a test, says which
# items no test names and whether the file is up to date.
# usage: test_errata.sh BUILD_FOLDER [write], from the top of the project
build=$1/errata
. tests/check.sh
list() { # what each row needs: equations, verdict, printed, true, checked, tests that name one of its equations
    awk -F'\t' '
        function number(text) { gsub(/[^0-9]/, "", text); return text + 0 }
        FILENAME != ARGV[ARGC - 1] { # a test: every (n), and every n of a range (n)-(m)
            file = FILENAME
            sub(/.*test_/, "", file)
            sub(/.*tests\//, "", file) # hard/GROUP
            sub(/\.c$/, "", file)
            files[file] = 1
            line = $0
            while (match(line, /\([0-9]+[a-d]?\)(-\([0-9]+\))?/)) {
                found = substr(line, RSTART, RLENGTH)
                line = substr(line, RSTART + RLENGTH)
                split(found, end, "-")
                first = number(end[1])
                last = end[2] == "" ? first : number(end[2])
                for (n = first; n <= last && n <= 536; n++) seen[n, file] = 1
            }
            line = $0
            while (match(line, /T[234]\.[0-9]+/)) {
                seen[substr(line, RSTART, RLENGTH), file] = 1
                line = substr(line, RSTART + RLENGTH)
            }
            next
        }
        /^#/ { next }
        {
            tests = ""
            for (file in files) {
                rest = $1; named = 0
                while (match(rest, /\([0-9]+[a-d]?\)(-\([0-9]+\))?/)) {
                    found = substr(rest, RSTART, RLENGTH); rest = substr(rest, RSTART + RLENGTH)
                    split(found, end, "-")
                    first = number(end[1]); last = end[2] == "" ? first : number(end[2])
                    for (n = first; n <= last; n++) if ((n, file) in seen) named = 1
                }
                rest = $1
                while (match(rest, /T[234]\.[0-9]+/)) {
                    if ((substr(rest, RSTART, RLENGTH), file) in seen) named = 1
                    rest = substr(rest, RSTART + RLENGTH)
                }
                if (named) tests = tests (tests == "" ? "" : ", ") file
            }
            print $0 "\t" tests
        }' tests/test_*.c tests/hard/*.c tests/data/errata.txt
}
write() {
    cat <<'END'
# Errata

What [1], L. Cveticanin, *Dynamics of Mass Variable System*, prints, and what is true. Written by `sh tests/test_errata.sh build
write` from tests/data/errata.txt; the last column names the tests (tests/test_NAME.c) in which the equation is tested.

wrong: a formula or number that gives wrong results where it is used; misprint: a slip that goes no further; ambiguous: right
in one reading. S: mass centre of the initial body, S1 of the final, S2 of the part; Om1, Or: angular velocities Omega_1,
Omega_r; P(d) = |d|^2 E - d d^T; a or alpha: the exponent; J: the adiabatic invariant; ODE: direct integration.

END
    awk -F'\t' '$2 != "verified" {n[$2]++} $2 == "verified" {v++} END {
        printf "Of 250 items %d hold as printed; %d are wrong, %d misprints, %d ambiguous.\n\n", v, n["wrong"], n["misprint"], n["ambiguous"]}' "$build/rows"
    echo '| equation | what is printed | | what is true | how it was checked | tests |'
    echo '|---|---|---|---|---|---|'
    awk -F'\t' '$2 != "verified" {for (i = 1; i <= 5; i++) gsub(/\|/, "\\|", $i); print "| " $1 " | " $3 " | " $2 " | " $4 " | " $5 " | " $6 " |"}' "$build/rows"
}
every_equation_is_tested() { awk -F'\t' '$1 ~ /\([0-9]|T[234]\./ && $6 == "" {print "no test names " $1; n++} END {exit n > 0}' "$build/rows"; }

list >"$build/rows"
write >"$build/errata.md"
[ "$2" = write ] && cp "$build/errata.md" docs/errata.md
check "a test names every equation of the errata" every_equation_is_tested
check "docs/errata.md is up to date" cmp "$build/errata.md" docs/errata.md
check_finish errata
