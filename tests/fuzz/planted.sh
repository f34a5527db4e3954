#!/bin/sh
# Errors that are planted into copies of the headers must be found by the fuzz targets: a sign, a wrong bound, and
# others of the kinds that happen. One line each: target, header, what sed does to it.
# usage: planted.sh BUILD, from the top of the project
build=$1/planted found=0 missed=0
mkdir -p "$build"

plant() { # plant WHAT TARGET HEADER SED
    cp jacobi.h ateb.h integrators.h varmass.h "$build"
    sed "$4" "$3" >"$build/$3"
    if cmp -s "$3" "$build/$3"; then
        echo "PLANTED $1: sed changes nothing in $3"
        missed=$((missed + 1))
        return
    fi
    if ${CC:-cc} -std=c99 -O1 -DHEADERS_ELSEWHERE -I"$build" tests/fuzz/replay.c -o "$build/replay" -lm >"$build/log" 2>&1 &&
        ! "$build/replay" -n 2000 -t "$2" >"$build/log" 2>&1 && grep -q VIOLATED "$build/log"; then
        echo "planted $1: found by $2: $(grep -c VIOLATED "$build/log") times: $(sed -n 's/.*: \(.*\); drawn.*/\1/p' "$build/log" | head -1 | cut -c1-90)"
        found=$((found + 1))
    else
        echo "PLANTED $1: not found by $2"
        sed -n '1,3p' "$build/log"
        missed=$((missed + 1))
    fi
}

# signs
plant "sign: cn next to K" jacobi jacobi.h 's/theta.c = aa - rb;/theta.c = aa + rb;/'
plant "sign: the phase's half plane" ateb ateb.h 's/return VM_COPYSIGN(r, sa);/return VM_COPYSIGN(r, -sa);/'
plant "sign: a weight of the step" integrators integrators.h 's/+ VMI_H(0.01) \* k2\[i\]/- VMI_H(0.01) * k2[i]/'
plant "sign: velocity of the rest" jumps varmass.h \
    '/^VM_API int vmi_jump(/,/^}/s/b.v = vmi_add(frame.v, load.v)/b.v = vmi_sub(frame.v, load.v)/'
# bounds
plant "bound: a series is used too far" jacobi jacobi.h 's/define VMI_NEAR VM_C(2.2)/define VMI_NEAR VM_C(9.0)/'
plant "bound: alpha below 0 is taken" ateb ateb.h '/^VM_API int ateb_plan_init_to(/,/^}/s/alpha >= 0/alpha >= -1/'
plant "bound: attempts are not counted" integrators integrators.h 's/attempts -= attempts > 0;/attempts -= attempts > 100000;/'
plant "bound: masses below 0 pass" oscillators varmass.h '/^VM_API int vmi_law_derivatives(/,/^}/s/f\[0\] > 0/f[0] > -1/'
echo "planted: $found passed, $missed failed, 0 skipped"
[ $missed = 0 ]
