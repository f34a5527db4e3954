#!/bin/sh
# make site: Doxygen warns of nothing, and the reference has each public function with its comment, which tells what happens after
# an error, units, accuracy, cost and source (tests/reference.awk).
# usage: test_site.sh BUILD_FOLDER, from the top of the project
build=$1/site_test
. tests/check.sh
lacks() { awk -f tests/reference.awk "$@"; }
nothing_lacks() { # in the functions of a header: MANUAL FILE...
    lacks "$@" >"$build/lacks"
    cat "$build/lacks"
    [ ! -s "$build/lacks" ]
}
check "each function of jacobi.h tells errors, units, accuracy, cost and source" nothing_lacks src/jacobi.h src/jacobi/*.h
check "each function of ateb.h does" nothing_lacks src/ateb.h src/ateb/*.h
check "each function of integrators.h does" nothing_lacks src/integrators.h src/integrators/*.h
check "each function of varmass.h does" nothing_lacks src/varmass.h src/base/*.h src/mechanics/*.h src/oscillators/*.h src/scenes/*.h
lie() { # lie NAME FILE SED WORDS : a manual or a chapter that lacks something is found
    sed "$3" "$2" >"$build/lie.h"
    case $2 in
    src/varmass.h) lacks "$build/lie.h" src/mechanics/drum.h >"$build/lacks" ;;
    *) lacks src/varmass.h "$build/lie.h" >"$build/lacks" ;;
    esac
    check "found: $1" grep -q "$4" "$build/lacks"
}
lie "no word of cost" src/varmass.h 's/docs.cost.md//; s/docs.counts.md//; s/instructions//g' 'vm_drum_stop lacks a cost'
lie "no word of errors" src/scenes/events.h 's/VM_NO[A-Z_]*//g; s/NaN//g; s/refuse//g' 'vm_event_at lacks what happens after an error'
lie "no comment" src/mechanics/drum.h '/^\/\* Tests whether the shaft/,/\*\//d' 'vm_drum_shaft_valid has no comment'
if ! sh tests/install.sh -w "for the reference in HTML" "command -v doxygen" doxygen; then
    echo "site: $passed passed, $failed failed, 2 skipped"
    [ $failed = 0 ]
    exit
fi
# The functions of the headers' indexes, by their names in column 8
names() { awk '/^   INDEX/ {on = 1} /\*\// {on = 0} on && /^       [a-z0-9_]+ +[^ ]/ {print $1}' ./*.h | sort -u; }
all_are_there() {
    cat build/site/*.html | grep -o '[a-z0-9_]*</a></span>[a-z0-9_]*()' | sed 's/.*>//; s/()//' | sort -u >"$build/there"
    [ -s "$build/there" ] && names | comm -23 - "$build/there" >"$build/missing"
    sed 's/^/not in the reference: /' "$build/missing"
    [ ! -s "$build/missing" ]
}
check "make site has no warning" make -s site
check "the reference has all public functions" all_are_there
check_finish site
