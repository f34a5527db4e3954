#!/bin/sh
# Errors that are planted into copies of the headers must be found by the fuzz targets: signs, bounds, inertias, of
# the kinds that happen. Twice: by replay of pseudo-random inputs, and by clang's libFuzzer, which begins with none,
# within SECONDS each. One line each: target, header, what sed does to it. With 0 for SECONDS no target runs; it is only
# checked that sed still finds what it changes.
# usage: planted.sh BUILD [SECONDS], from the top of the project
build=$1/planted seconds=${2:-20} found=0 missed=0 skipped=0
mkdir -p "$build"

count() { # count WHAT COMMAND...
    what=$1
    shift
    if "$@"; then found=$((found + 1)); else
        missed=$((missed + 1))
        echo "PLANTED $what: not found: $*"
        sed -n '1,3p' "$build/log"
    fi
}

by_replay() {
    ${CC:-cc} -std=c99 -O0 -DHEADERS_ELSEWHERE -I"$build" tests/fuzz/replay.c -o "$build/replay" -lm \
        >"$build/log" 2>&1 &&
        ! "$build/replay" -n 2000 -t "$1" >"$build/log" 2>&1 && grep -q VIOLATED "$build/log" &&
        echo "    $1, 2000 inputs replayed: $(grep -c VIOLATED "$build/log") times" \
            "$(sed -n 's/.*: \(.*\); drawn.*/\1/p' "$build/log" | head -1 | cut -c1-80)"
}

by_fuzzer() {
    clang -std=c99 -O0 -fsanitize=fuzzer -DHEADERS_ELSEWHERE -I"$build" "tests/fuzz/$1.c" -o "$build/fuzzer" -lm \
        >"$build/log" 2>&1 || return 1
    start=$(date +%s)
    ! "$build/fuzzer" -seed=1 -max_total_time="$seconds" -max_len=768 -len_control=0 -print_final_stats=1 \
        -artifact_prefix="$build/" >"$build/log" 2>&1 && grep -q VIOLATED "$build/log" &&
        echo "    $1, libFuzzer: $(sed -n 's/.*executed_units: *//p' "$build/log") inputs," \
            "$(($(date +%s) - start)) s: $(sed -n 's/.*VIOLATED.*: \(.*\); drawn.*/\1/p' "$build/log" | cut -c1-80)"
}

plant() { # plant WHAT TARGET HEADER SED
    cp jacobi.h ateb.h integrators.h varmass.h "$build"
    sed "$4" "$3" >"$build/$3"
    echo "planted $1"
    if cmp -s "$3" "$build/$3"; then
        echo "PLANTED $1: sed changes nothing in $3"
        missed=$((missed + 1))
        return
    fi
    if [ "$seconds" = 0 ]; then found=$((found + 1)) && return; fi
    count "$1" by_replay "$2"
    if command -v clang >/dev/null; then count "$1" by_fuzzer "$2"; else skipped=$((skipped + 1)); fi
}

# signs
plant "sign: cn next to K" jacobi jacobi.h 's/theta.c = aa - rb;/theta.c = aa + rb;/'
plant "sign: the phase's half plane" ateb ateb.h 's/return VM_COPYSIGN(r, sa);/return VM_COPYSIGN(r, -sa);/'
plant "sign: a weight of the step" integrators integrators.h 's/+ VMI_H(0.01) \* k2\[i\]/- VMI_H(0.01) * k2[i]/'
plant "sign: velocity of the rest" jumps varmass.h \
    '/^VM_API int vmi_jump(/,/^}/s/b.v = vm_add(frame.v, lump.v)/b.v = vm_sub(frame.v, lump.v)/'
plant "sign: Tsiolkovsky's formula" streams varmass.h \
    '/^VM_API vm_real vm_tsiolkovsky(/,/^}/s/return v0 + w/return v0 - w/'
# bounds
plant "bound: a series is used too far" jacobi jacobi.h 's/define VMI_NEAR VM_C(2.2)/define VMI_NEAR VM_C(9.0)/'
plant "bound: alpha below 0 is taken" ateb ateb.h '/^VM_API int ateb_plan_init_to(/,/^}/s/alpha >= 0/alpha >= -1/'
plant "bound: attempts are not counted" integrators integrators.h \
    's/status == ODE_OK \&\& p->attempts > 0) p->attempts--/status == ODE_OK \&\& p->attempts > 100000) p->attempts--/'
plant "bound: masses below 0 pass" oscillators varmass.h \
    '/^VM_API int vmi_law_status(/,/^}/s/f\[0\] > 0/f[0] > -1/'
# inertias
plant "inertia: a product of a point's" jumps varmass.h \
    '/^VM_API vm_inertia vmi_inertia_of_point(/,/^}/s/p.xz = -d.x \* d.z/p.xz = d.x * d.z/'
plant "inertia: the part's mass for the reduced one" jumps varmass.h \
    '/^VM_API int vmi_join(/,/^}/s/b->inertia), reduced, moved/b->inertia), sign * b->mass, moved/'
plant "inertia: not turned" jumps varmass.h \
    '/^VM_API vmi_lump vmi_lump_of(/,/^}/s/lump.inertia = vmi_inertia_along(.*;/lump.inertia = body->inertia;/'
plant "inertia: of the plane, sizes of its terms" jumps varmass.h \
    's/b.inertia = lump.inertia.zz;/b.inertia = lump.sizes.zz;/'
plant "inertia: of streams, without the place" streams varmass.h \
    '/^VM_INLINE int vmi_stream_sums(/,/^}/s/s->rate, vmi_inertia_of_point(stored)/0, vmi_inertia_of_point(stored)/'
plant "inertia: of streams in the plane" streams varmass.h \
    's/s->rate \* (s->gyration + dx \* dx + dy \* dy)/s->rate * (s->gyration + dx * dx - dy * dy)/'
plant "inertia: of the drum's band" drum varmass.h \
    's/m->J = d->inertia + d->band \* d->radius/m->J = d->inertia + d->band \/ 2 * d->radius/'
plant "inertia: of the scenes' band" scenes varmass.h \
    '/^VM_API vm_band_now vm_band_at(/,/^}/s/inertia = line/inertia = VM_C(0.9) * line/'
plant "inertia: of the broken rotor" rotor varmass.h \
    '/^VM_API int vmi_broken_rotor_rest(/,/^}/s/share \* whole->mass/share * p->mass/'
plant "inertia: of the cut pendulum" lagrange varmass.h \
    '/^VM_API int vm_pendulum_separate(/,/^}/s/part \* (part \* c.rate) \/ 12/part * (part * c.rate) \/ 3/'
plant "inertia: Lagrange's matrix" lagrange varmass.h \
    '/^VM_API void vm_lagrange_mass(/,/^}/s/+= vm_dot(turn_or_NULL\[i\], spin)/-= vm_dot(turn_or_NULL[i], spin)/'
echo "planted: $found passed, $missed failed, $skipped skipped"
[ $missed = 0 ]
