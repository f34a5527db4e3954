#!/bin/sh
# Every public function of the four headers is called by these programs: names those that are not.
# usage: called.sh FILE..., from the top of the project
# comments are left out, so that a name in prose does not count
code=$(cat "$@" | sed 's|/\*.*\*/||; /\/\*/,/\*\//d')
missing=0
for name in $(cat jacobi.h ateb.h integrators.h varmass.h |
    sed -nE 's/^VM_(API|INLINE) ([a-z_0-9]+ )+\*?([a-z0-9]+_[a-zA-Z0-9_]+)\(.*/\3/p' | grep -v '^vmi_' | sort -u); do
    if ! echo "$code" | grep -qw "$name"; then
        echo "$name is not called"
        missing=$((missing + 1))
    fi
done
[ $missing = 0 ]
