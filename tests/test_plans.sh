#!/bin/sh
# What examples/jacobi_plan and examples/ateb_plan print compiles without a warning, to the bits that init computes, the first into
# read-only data; in double and float.
# usage: CC=compiler test_plans.sh BUILD_FOLDER, from the top of the project
cc=${CC:-cc} build=$1/plans
parameters="0.3 0.9 -20 1 -1e10"
. tests/check.sh

print_plans() { # print_plans PRINTER : the constants plan_0, plan_1, ... and a table of them
    i=0 table=
    for m in $parameters; do
        "$1" $m plan_$i || return 1
        table="$table{&plan_$i, (vm_real)($m)}, "
        i=$((i + 1))
    done
    echo "static const struct { const jacobi_plan *plan; vm_real m; } printed[] = {$table};"
}

is_read_only() { # is_read_only OBJECT NAME
    nm "$1" | awk -v name="$2" '$NF == name {print; ok = $(NF-1) == "r"} END {exit !ok}'
}

# compare I: each member of the Ith plan with that of jacobi_plan_init; all members, but for padding the whole struct
cat >"$build/compare.c" <<'END'
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "jacobi.h"
#include "plans.inc"
static size_t compared, differing;
static void compare(const char *name, const void *a, const void *b, size_t size)
{
    compared += size;
    if (memcmp(a, b, size) == 0) return;
    differing++;
    printf("%s differs\n", name);
}
#define COMPARE(member) compare(#member, &p->member, &q.member, sizeof q.member)
int main(int argc, char **argv)
{
    const int i = argc > 1 ? atoi(argv[1]) : 0;
    const jacobi_plan *p = printed[i].plan;
    jacobi_plan q;
    if (jacobi_plan_init(&q, printed[i].m) != 0) return 1;
    COMPARE(form);
    COMPARE(m1);
    COMPARE(K);
    COMPARE(per_K);
    COMPARE(a);
    COMPARE(b);
    COMPARE(theta.kp);
    COMPARE(theta.kp_lo);
    COMPARE(theta.q);
    COMPARE(theta.defect);
    COMPARE(theta.f);
    COMPARE(theta.g);
    COMPARE(theta.scale);
    printf("%d of %d bytes compared\n", (int)compared, (int)sizeof q);
    return differing != 0 || sizeof q - compared >= sizeof(vm_real);
}
END

for precision in double float; do
    folder=$build/$precision
    mkdir "$folder"
    compile="$cc -std=c99 -O2 -Wall -Wextra -Werror -I. -I$folder"
    [ $precision = float ] && compile="$compile -DVM_USE_FLOAT"
    check "$precision: the printer builds" $compile examples/jacobi_plan.c -o "$folder/print" -lm
    check "$precision: m = 2 is refused" fails "$folder/print" 2
    check "$precision: a word is refused" fails "$folder/print" 0.3x
    print_plans "$folder/print" >"$folder/plans.inc"
    check "$precision: what was printed compiles" $compile -c "$build/compare.c" -o "$folder/compare.o"
    check "$precision: and links" $compile "$folder/compare.o" -o "$folder/compare" -lm
    i=0
    for m in $parameters; do
        check "$precision, m = $m: the same bits" "$folder/compare" $i
        check "$precision, m = $m: read-only" is_read_only "$folder/compare.o" plan_$i
        i=$((i + 1))
    done
done
ateb_round_trip() { # ateb_round_trip ALPHA ACCURACY OPTIONS...: the printed plan has the bits that init computes
    alpha=$1 accuracy=$2
    shift 2
    $cc -std=c99 "$@" examples/ateb_plan.c -o "$build/plan_print" -lm || return 1
    { printf '#include "ateb.h"\n'
      "$build/plan_print" $alpha $accuracy
      printf 'int main(void) { ateb_plan p = plan; ateb_plan_init_to(&p, (vm_real)%s, (vm_real)%s);\n' $alpha $accuracy
      printf 'return memcmp(&p, &plan, sizeof p) != 0; }\n'; } >"$build/plan.c"
    $cc -std=c99 "$@" -I. "$build/plan.c" -o "$build/plan" -lm && "$build/plan"
}
for alpha in 0 0.1 1 1.5 2.7 3 100; do
    check "printed plan, alpha $alpha" ateb_round_trip $alpha 0
    check "printed plan, alpha $alpha, float" ateb_round_trip $alpha 0 -DVM_USE_FLOAT
done
check "printed plan to 1e-4" ateb_round_trip 1.5 1e-4
stored_plan_is_current() {
    $cc -std=c99 -DVM_USE_FLOAT examples/ateb_plan.c -o "$build/plan_print" -lm &&
        { echo '/* Written by examples/ateb_plan 3, built with -DVM_USE_FLOAT */'; "$build/plan_print" 3 0; } |
        cmp - examples/firmware/plan.h
}
check "the firmware example's plan is what init computes" stored_plan_is_current
check_finish plans
