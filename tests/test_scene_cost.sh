#!/bin/sh
# A scene pays for the effects that it lists: an executable holds no other effect, and a right-hand side takes as many
# instructions whatever else the program knows, and with each effect those of that effect; of a chain of bodies start
# and right-hand side take as many a body, however long it is.
# usage: CC=compiler test_scene_cost.sh BUILD_FOLDER, from the top of the project
cc=${CC:-cc} build=$1/scene_cost
. tests/check.sh

# program NAME LIST OTHERS: a scene of a line body with the effects LIST evaluates its right-hand side N times, N the
# first argument of the program; OTHERS makes effects that are not listed
program() {
    cat >"$build/$1.c" <<END
#include <stdlib.h>
#include "varmass.h"
volatile vm_real sink;
ode_rhs volatile rhs = vm_scene_rhs; /* one function for itself, as an integrator calls it */
int main(int argc, char **argv)
{
    long i, n = argc > 1 ? atol(argv[1]) : 0;
    vm_scene_body bodies[1];
    vm_effect effects[8] = {$2}, others[8] = {$3};
    vm_scene scene;
    vm_real y[2] = {0, 0}, d[2] = {0, 0};
    memset(&scene, 0, sizeof scene);
    bodies[0] = vm_scene_body_line(1, 1, 0);
    scene.bodies = bodies, scene.n_bodies = 1, scene.effects = effects;
    while (scene.n_effects < 8 && effects[scene.n_effects].apply) scene.n_effects++;
    if (vm_scene_start(&scene, 0, y, NULL)) return 1;
    for (i = 0; i < n; i++) rhs(0, y, d, &scene);
    sink = d[1] + others[0].p[0];
    return 0;
}
END
    $cc -std=c99 $4 -I. "$build/$1.c" -o "$build/$1" -lm
}
zero="{0}"
spring="vm_effect_linear_spring(0, 0, VM_GROUND, 0, 2, 0)"
damper="vm_effect_damper(0, 0, VM_GROUND, 0, 1)"
drive="vm_effect_motor(0, 0, 1, 1)"
unlisted="vm_effect_unbalance(0, 1, 1, 0), vm_effect_van_der_pol(0, 0, 1, 1)"

has_only() { # has_only PROGRAM WORD... : of the functions that belong to effects and motions, those with one of the words
    file=$build/$1
    shift
    wanted=$(echo "$*" | tr ' ' '|')
    nm "$file" | awk '{print $NF}' | grep -E '^vmi_(apply|axle|plane|point|free|growth|crossing|band|then|jump|link)|^vmi_scene_(totals|rates)' |
        sort >"$build/linked"
    cat "$build/linked"
    ! grep -vE "$wanted" "$build/linked"
}

count() { # count PROGRAM : instructions of a right-hand side
    for n in 1000 3000; do
        valgrind --tool=callgrind --callgrind-out-file=/dev/null "$build/$1" $n 2>&1 | awk '/Collected/ {print $NF}'
    done | awk 'NR == 1 {a = $1} NR == 2 {print ($1 - a)/2000}'
}

# the chain: N bodies between springs, started once, its right-hand side evaluated so often
chain() {
    cat >"$build/chain.c" <<END
#include <stdlib.h>
#include "varmass.h"
enum { MOST = 1000 };
static vm_scene_body bodies[MOST];
static vm_effect effects[MOST];
static vm_real y[2 * MOST], d[2 * MOST];
int main(int argc, char **argv)
{
    const int n = atoi(argv[1]);
    vm_scene scene;
    int i;
    memset(&scene, 0, sizeof scene);
    for (i = 0; i < n; i++) bodies[i] = vm_scene_body_line(1, 0, i == 0);
    for (i = 0; i < n; i++) effects[i] = vm_effect_linear_spring(i, 0, i - 1, 0, 1, 0);
    scene.bodies = bodies, scene.n_bodies = n, scene.effects = effects, scene.n_effects = n;
    for (i = atoi(argv[2]); i > 0; i--) if (vm_scene_start(&scene, 0, y, NULL)) return 1;
    for (i = argc > 3 ? atoi(argv[3]) : 0; i > 0; i--) vm_scene_rhs(0, y, d, &scene);
    return 0;
}
END
    $cc -std=c99 -O2 -I. "$build/chain.c" -o "$build/chain" -lm
}
collected() { valgrind --tool=callgrind --callgrind-out-file=/dev/null "$@" 2>&1 | awk '/Collected/ {print $NF}'; }
of_chain() { # of_chain N start|rhs : instructions a body
    case $2 in
    start) echo "$(collected "$build/chain" "$1" 1) $(collected "$build/chain" "$1" 3)" ;;
    rhs) echo "$(collected "$build/chain" "$1" 1 1) $(collected "$build/chain" "$1" 1 3)" ;;
    esac | awk -v n="$1" '{print ($2 - $1)/2/n}'
}
linear() { # linear start|rhs : as many a body in a chain of 1000 as in one of 100, to 5 %
    echo "$(of_chain 100 "$1") $(of_chain 1000 "$1")"
    awk -v a="$(of_chain 100 "$1")" -v b="$(of_chain 1000 "$1")" 'BEGIN {exit !(b > 10 && b <= 1.05*a && b >= 0.95*a)}'
}

same_count() { [ "$(count "$1")" = "$(count "$2")" ] && echo "$(count "$1") instructions"; }
more_by() { # more_by A B LEAST MOST : B takes so many more than A
    echo "$(count "$1") $(count "$2")"
    awk -v a="$(count "$1")" -v b="$(count "$2")" -v least="$3" -v most="$4" 'BEGIN {exit !(b - a >= least && b - a <= most)}'
}

check "two effects: builds" program two "$spring, $damper" "$zero" -Os
check "two effects: no other is linked" has_only two vmi_apply_linear_spring vmi_apply_damper
check "three effects: builds" program three "$spring, $damper, $drive" "$zero" -Os
check "three effects: no other is linked" has_only three vmi_apply_linear_spring vmi_apply_damper vmi_apply_motor
check "the third is linked" grep -q vmi_apply_motor "$build/linked"
if command -v valgrind >/dev/null; then
    check "counted: builds" program two "$spring, $damper" "$zero" -O2
    check "with effects that are not listed: builds" program named "$spring, $damper" "$unlisted" -O2
    check "with a third: builds" program three "$spring, $damper, $drive" "$zero" -O2
    check "effects that are not listed take no instruction" same_count two named
    check "a listed one takes its own" more_by two three 5 35
    check "chain: builds" chain
    check "a chain's right-hand side: linear in its length" linear rhs
    check "a chain's start: linear in its length" linear start
else
    echo "no valgrind: instructions are not counted"
fi
check_finish "scene cost"
