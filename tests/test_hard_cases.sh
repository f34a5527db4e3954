#!/bin/sh
# docs/hard-cases.md from what tests/test_hard.c prints in double and in float; as a test, says whether the cases
# there are those of the program: texts, points and bounds; not the measured errors, which depend on the compiler.
# usage: CC=compiler test_hard_cases.sh BUILD_FOLDER [write], from the top of the project
cc=${CC:-cc} build=$1/hard_cases
. tests/check.sh

# one table from both programs' lines, | text | kernel | point | error | bound | naive error |
tables() {
    awk -F' *[|] *' '
        FNR == 1 { file++ }
        file == 2 && /^## / { print "\n" $0 }
        !/^\| / { next }
        $2 == "what would go wrong" {
            if (file == 2) {
                print "\n| " $2 " | kernel | at | error | bound | naive | in float: error | bound | naive |"
                print "|---|---|---|---|---|---|---|---|---|"
            }
            next
        }
        file == 1 { point[++n] = $4; measured[n] = $5 " | " $6 " | " $7; next }
        {
            k++
            at = point[k] == $4 || point[k] == "" ? $4 : $4 " (float: " point[k] ")"
            print "| " $2 " | " $3 " | " at " | " $5 " | " $6 " | " $7 " | " measured[k] " |"
        }' "$build/float.txt" "$build/double.txt"
}
write() {
    cat <<'END'
# Hard cases

A hard case is a set of arguments at which a usual formula goes wrong: the result of the formula has few correct digits or is no
number. The formula is from textbooks, or from the dissertation that the kit follows ([glossary.md](glossary.md)). The command
`make hard-cases` writes this page from the output of tests/test_hard.c. The first column of the tables says what is computed and
why the formula goes wrong. The true values are computed with arbitrary precision (tests/gen/hard_reference.py).

- The column "kernel" names a pair of functions in tests/hard/. For example, C2 stands for `C2_ours`, which uses a function of the
  headers, and `C2_naive`, which uses the naive formula (the formula that goes wrong). The column "at" has the arguments of both
  functions. Arguments that are missing at the end are zero.
- The numbers in the first column are those in double; in float the arguments may be others. Numbers in brackets, such as (482),
  are equations of the dissertation. A difference "cancels" if nearly equal numbers are subtracted, so that their rounding errors
  remain. The words "small", "next to" and "->" mean that an argument is close to a limit.
- The column "error" has the error of the function of the headers, and the column "naive" has the error of the naive formula in
  the same precision. "No number" means that the naive formula gives infinity or NaN, or divides by zero. The unit of both errors
  is eps (2.2e-16, in float 1.2e-7) times the true value, or times a typical size, such as the largest value of an oscillation.
- The column "bound" has the largest error that the test allows. The test also fails if the error of the naive formula is less
  than four times the bound, because the arguments are then no hard case.
- K, E, F and Pi are elliptic integrals, sn, cn and dn are elliptic functions of u with the parameter m, and k' is sqrt(1 - m).
  The Ateb functions sa(s) and ca(s) take the place of sine and cosine if the force is proportional to abs(x)^alpha. The factor
  `reactive` is 1 if the full reactive force acts. The comment above the tested function explains the other letters.
- In a separation, a "part" leaves a body, and the "rest" is what remains of the body. "Spin" is an angular velocity, and omega_1
  is the first component of the angular velocity. "By rk4" means integration with fixed steps of the classical Runge-Kutta method.
END
    tables
}
# what does not depend on the compiler: without the measured errors
lasting() { awk -F' *[|] *' '/^The results on this page/ {next} /^\| / {$5 = $7 = $8 = $10 = ""} /./' "$1"; }
same_cases() { lasting "$build/hard-cases.md" >"$build/new" && lasting docs/hard-cases.md | diff - "$build/new"; }
program() { # program double|float : the program of make test, by its compiler
    make -s CC="$cc" "build/tests/$1/hard" && "./build/tests/$1/hard" >"$build/$1.txt"
}

check "the cases in double" program double
check "the cases in float" program float
write >"$build/hard-cases.md"
[ "$2" = write ] && cp "$build/hard-cases.md" docs/hard-cases.md
check "docs/hard-cases.md is up to date" same_cases
check_finish hard_cases
