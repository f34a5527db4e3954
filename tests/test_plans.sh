#!/bin/sh
# What examples/print_plan prints compiles without a warning, to the bits that init computes, into read-only data; in double
# and float.
# usage: CC=compiler test_plans.sh BUILD_FOLDER, from the top of the project
cc=${CC:-cc} build=$1/plans
parameters="0.3 0.9 -20 1 -1e10"
. tests/check.sh

print_plans() { # print_plans PRINTER : the constants plan_0, plan_1, ... and a table of them
    i=0 table=
    for m in $parameters; do
        "$1" jacobi $m plan_$i || return 1
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
    check "$precision: the printer builds" $compile examples/print_plan.c -o "$folder/print" -lm
    check "$precision: m = 2 is refused" fails "$folder/print" jacobi 2
    check "$precision: a word is refused" fails "$folder/print" jacobi 0.3x
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
refused_by() { # refused_by PRECISION FLAG: a program of the other precision does not compile with the plans, and says why
    ! $cc -std=c99 $2 -I. -I"$build/$1" -fsyntax-only "$build/compare.c" 2>"$build/said" && grep -q "this plan is for $1" "$build/said"
}
check "a plan for float is refused in double" refused_by float ""
check "a plan for double is refused in float" refused_by double -DVM_USE_FLOAT

ateb_round_trip() { # ateb_round_trip PRECISION ALPHA ACCURACY : the printed plan has the bits that init computes
    folder=$build/$1 float=
    [ $1 = float ] && float=-DVM_USE_FLOAT
    { printf '#include "ateb.h"\n'
      "$folder/print" ateb $2 $3
      printf 'int main(void) { ateb_plan p = plan; ateb_plan_init_to(&p, (vm_real)%s, (vm_real)%s);\n' $2 $3
      printf 'return memcmp(&p, &plan, sizeof p) != 0; }\n'; } >"$folder/ateb.c"
    $cc -std=c99 $float -I. "$folder/ateb.c" -o "$folder/ateb" -lm && "$folder/ateb"
}
closed_round_trip() { # closed_round_trip PRECISION ARGUMENT... : so has the printed oscillator; it lies in read-only data
    folder=$build/$1 float=
    [ $1 = float ] && float=-DVM_USE_FLOAT
    shift
    { printf '#include "varmass.h"\nstatic vm_osc_closed c;\n'
      "$folder/print" closed "$@" || return 1
      echo "static const double a[] = {$(echo "$@" | tr ' ' ',')};"
      cat <<'END'
int main(void)
{
    const vm_osc_closed *volatile printed = &plan;
    vm_osc_problem p = {0};
    p.alpha = (vm_real)a[0];
    p.mass = vm_law_linear((vm_real)a[1], (vm_real)a[2]);
    p.stiffness = vm_law_linear((vm_real)a[3], (vm_real)a[4]);
    p.reactive = (vm_real)a[5];
    p.damping = (vm_real)a[6];
    p.x = (vm_real)a[7];
    p.v = (vm_real)a[8];
    if (vm_osc_closed_init(&c, &p, (int)a[9], (vm_real)a[10])) return 1;
    return memcmp(&c, printed, sizeof c) != 0;
}
END
    } >"$folder/closed.c"
    $cc -std=c99 -Wall -Wextra -Werror $float -I. -c "$folder/closed.c" -o "$folder/closed.o" || return 1
    $cc "$folder/closed.o" -o "$folder/closed" -lm && "$folder/closed" && is_read_only "$folder/closed.o" plan
}
rotation_round_trip() { # rotation_round_trip PRECISION ARGUMENT... : so has the printed rotation of a free body
    folder=$build/$1 float=
    [ $1 = float ] && float=-DVM_USE_FLOAT
    shift
    { printf '#include "varmass.h"\n'
      "$folder/print" rotation "$@" || return 1
      echo "static const double a[] = {$(echo "$@" | tr ' ' ',')};"
      cat <<'END'
int main(void)
{
    const vm_torque_free *volatile printed = &plan;
    const vm_vec3 moments = {(vm_real)a[0], (vm_real)a[1], (vm_real)a[2]};
    const vm_vec3 omega = {(vm_real)a[3], (vm_real)a[4], (vm_real)a[5]};
    const vm_quat none = {1, 0, 0, 0};
    vm_torque_free r;
    if (vm_torque_free_init_principal(&r, moments, none, omega, 0)) return 1;
    return memcmp(&r, printed, sizeof r) != 0;
}
END
    } >"$folder/rotation.c"
    $cc -std=c99 -Wall -Wextra -Werror $float -I. -c "$folder/rotation.c" -o "$folder/rotation.o" || return 1
    $cc "$folder/rotation.o" -o "$folder/rotation" -lm && "$folder/rotation" && is_read_only "$folder/rotation.o" plan
}
for alpha in 0 0.1 1 1.5 2.7 3 100; do
    check "printed plan, alpha $alpha" ateb_round_trip double $alpha 0
    check "printed plan, alpha $alpha, float" ateb_round_trip float $alpha 0
done
check "printed plan to 1e-4" ateb_round_trip double 1.5 1e-4
for precision in double float; do
    check "$precision: a printed oscillator of order 5" closed_round_trip $precision 1.7 10 -0.1 100 -1 1 0.02 0.1 0.2 5 30
    check "$precision: of order 2, which lacks polynomials" closed_round_trip $precision 3 2 0.01 5 0 0 0 0.1 -0.2 2 -20
    check "$precision: whose error is unknown" closed_round_trip $precision 3 2 0.01 5 0 1 0 0.1 0 3 1e9
    check "$precision: at rest" closed_round_trip $precision 0 2 0.01 5 0 0 0 0 0 4 1
    check "$precision: one without a law is refused" fails "$build/$precision/print" closed 1 1 10 1 0 0 0 0.1 0 5 1
done
for precision in double float; do
    check "$precision: a printed rotation, next to the middle axis" rotation_round_trip $precision 1 2 3 0.01 5 0
    check "$precision: of a symmetric body" rotation_round_trip $precision 2 2 1 0.3 0.4 2
    check "$precision: of a body at rest" rotation_round_trip $precision 1 2 2.5 0 0 0
    check "$precision: of an impossible body is refused" fails "$build/$precision/print" rotation 1 1 5 0 0 1
done
stored_plan_is_current() {
    { echo '/* This file is written by examples/print_plan ateb 3, built with -DVM_USE_FLOAT */'; "$build/float/print" ateb 3 0; } |
        cmp - examples/firmware/plan.h
}
check "the firmware example's plan is what init computes" stored_plan_is_current
guide_plan_is_current() { # the plan that the guide's program shows
    "$build/float/print" jacobi 0.5 swing >"$build/guide" && grep -Fxf "$build/guide" docs/guide-firmware.md | cmp - "$build/guide"
}
check "the firmware guide's plan is what init computes" guide_plan_is_current
check_finish plans
