#!/bin/sh
# Abstract interpretation by Frama-C's EVA of jacobi.h, ateb.h and integrators.h called with any numbers at all. What
# it cannot exclude is an alarm; the accepted kinds are in tests/eva.txt with their reason, any other one fails.
# usage: eva.sh BUILD_FOLDER, from the top of the project
build=$1/eva
. tests/check.sh
sh tests/install.sh "command -v frama-c" frama-c-base || { echo "EVA: 0 passed, 0 failed, 3 skipped"; exit 0; }

analysed() { # analysed HEADER: no alarm that tests/eva.txt does not know; how many there are of each kind
    split="-eva-split-return auto"
    [ "$1" = jacobi ] && split="-eva-split-return-function jacobi_plan_init:0,jacobi_plan_init_m1:0,vmi_plan_init:0"
    frama-c -eva -eva-precision 2 $split -eva-interprocedural-splits -warn-special-float none \
        -cpp-extra-args="-std=c99 -I. -U__GNUC__" -c11 "tests/eva_$1.c" >"$build/$1.log" 2>&1 || return 1
    grep -A1 '\[eva:alarm\]' "$build/$1.log" | sed '/^--/d; s/^\[eva:alarm\] //' | paste -s -d ' ' |
        sed 's/ \([a-z]*\.h:[0-9]*: Warning:\)/\n\1/g' >"$build/$1.alarms"
    grep -v '^#' tests/eva.txt | cut -f1 >"$build/accepted"
    echo "$1.h: $(grep -c Warning "$build/$1.alarms") alarms"
    ! grep -vFf "$build/accepted" "$build/$1.alarms"
}
for header in jacobi ateb integrators; do
    check "EVA: $header.h" analysed $header
    [ -s "$build/log" ] && head -1 "$build/log"
done
check_finish EVA
