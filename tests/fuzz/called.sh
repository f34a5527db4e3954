#!/bin/sh
# Every public function of the four headers is called by a fuzz target: names those that are not.
# usage: called.sh, from the top of the project
# comments are left out, so that a name in prose does not count
code=$(cat tests/fuzz/*.c tests/fuzz/*.h | sed 's|/\*.*\*/||; /\/\*/,/\*\//d')
missing=0
# of the scenes' section, tested in tests/test_scene_*.c, no target yet: each is named in every run
later="vm_effect_stream_mass vm_effect_user_between vm_effect_varying vm_force_gravity vm_force_gyroscopic vm_force_shaft
    vm_force_unbalance vm_scene_growing_free vm_scene_growing_plane vm_then_attach_in_plane vm_then_attach_on_line
    vm_then_separate_in_plane vm_then_separate_on_line"
for name in $(cat jacobi.h ateb.h integrators.h varmass.h |
    sed -nE 's/^VM_(API|INLINE) ([a-z_0-9]+ )+\*?([a-z0-9]+_[a-zA-Z0-9_]+)\(.*/\3/p' | grep -v '^vmi_' | sort -u); do
    if ! echo "$code" | grep -qw "$name"; then
        echo "$name is called by no fuzz target"
        case " $(echo $later) " in *" $name "*) ;; *) missing=$((missing + 1)) ;; esac
    fi
done
[ $missing = 0 ]
