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
number. Some of these formulas are from textbooks, and some are from the dissertation whose equations the kit uses
([glossary.md](glossary.md)). The command `make hard-cases` writes this page from the output of tests/test_hard.c. In each table,
the first column says what is computed and why the usual formula goes wrong. The columns "error" and "naive" say by how much the
result of the kit and the result of the usual formula differ from the true value, which was computed in arbitrary precision
(tests/gen/hard_reference.py). The columns "error", "bound" and "naive" occur twice in each table: first for double, then for
float.

- The name in the column "kernel" stands for two test functions in the folder tests/hard/, which both compute the quantity of the
  row. For example, C2 stands for `C2_ours`, which calls a function of the kit, and for `C2_naive`, which uses the naive formula
  (the usual formula, which goes wrong). The column "at" has the arguments of both functions. Arguments that this column does not
  show are zero.
- Values of arguments in the first column are those of the test in double. The column "at" also shows the arguments of the test in
  double. If the test in float uses other arguments, the column "at" shows these as well, after "float:". A number in brackets,
  such as (482), is the number of an equation of the dissertation on which the kit is based. In the first column, a difference
  "cancels" if nearly equal numbers are subtracted, so that mainly their rounding errors are left. The words "small" and "next to"
  and the sign "->" mean that an argument is close to a special value, for example to 0.
- The column "error" has the error of the function of the kit, and the column "naive" has the error of the naive formula in the
  same precision. The words "no number" mean that the naive formula gives infinity or NaN, or divides by zero. The unit of both
  errors is eps times the true value, or eps times a typical size of the result, such as the largest value of an oscillation. The
  number eps is 2.2e-16 in double and 1.2e-7 in float.
- The column "bound" has the largest error that the test allows the function of the kit to make. The test also fails if the error
  of the naive formula is less than four times this bound, because the naive formula does not go wrong then, and the case is not
  hard.
- In the tables, K, E, F and Pi are elliptic integrals, sn, cn and dn are elliptic functions of u with the parameter m, and k' is
  sqrt(1 - m). The Ateb functions sa(s) and ca(s) take the place of sine and cosine in oscillations whose elastic force is
  proportional to abs(x)^alpha; x is the deflection. The number `reactive` is a factor of the reactive force, which joining or
  leaving mass exerts on a body: if `reactive` is 1, the full force acts. The other letters of a row are explained in the comment
  above the function of the kit that is tested; the source in tests/hard/ shows which function this is.
- In rows on separations, the "part" is what leaves a body, and the "rest" is what remains of the body. The word "spin" stands for
  an angular velocity, and omega_1 is the first component of the angular velocity. The words "by rk4" mean that the column "naive"
  is not for a formula, but for an integration of the motion with fixed steps of the classical Runge-Kutta method.
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
