#!/bin/sh
# Compares the kit with GSL, Boost.Math, Boost.odeint and SUNDIALS of Debian's packages, prints a table of times and errors
# at the same arguments, writes it to docs/peers.md (whose text is bench/peers.md), and fails where a peer is quicker at the
# same or a lesser error. A peer that is not here is left out, and the script says so.
# usage: [CC=cc] [CXX=c++] no_peer_wins.sh [BUILD_FOLDER], from the top of the project
cc=${CC:-cc} cxx=${CXX:-c++} build=${1:-build}/peers
mkdir -p "$build" || exit 1
echo '*' >"${1:-build}/.gitignore"
[ -n "$(command -v "$cxx")" ] || sh tests/install.sh "command -v $cxx" g++ || { echo "skipped: no compiler of C++"; exit 0; }
has() { echo "#include <$1>" | $cxx -E -x c++ - >/dev/null 2>&1; }
version() { printf '#include <%s>\n%s\n' "$1" "$2" | $cxx -E -x c++ - 2>/dev/null | tail -n 1 | tr -d '" '; }
has quadmath.h || { echo "skipped: no quadruple precision (libquadmath), so that no errors can be measured"; exit 0; }

flags= libraries= peers=
wanted() { # wanted HEADER PACKAGE: it is there, or has been installed
    sh tests/install.sh -w "for the comparison with it" "echo '#include <$1>' | $cxx -E -x c++ -" "$2" && return 0
    echo "left out: $2"
    return 1
}
add() { # add FLAG NAME LIBRARY...
    flags="$flags -D$1" peers="$peers${peers:+, }$2"
    shift 2
    libraries="$libraries $*"
}
wanted gsl/gsl_sf.h libgsl-dev && add WITH_GSL "GSL $(version gsl/gsl_version.h GSL_VERSION)" -lgsl -lgslcblas
wanted boost/math/special_functions/lambert_w.hpp libboost-math-dev &&
    add WITH_BOOST "Boost $(version boost/version.hpp BOOST_LIB_VERSION | tr _ .)"
wanted cvode/cvode.h libsundials-dev && add WITH_SUNDIALS "SUNDIALS $(version sundials/sundials_config.h SUNDIALS_VERSION)" \
    -lsundials_cvode -lsundials_arkode -lsundials_nvecserial
[ -n "$peers" ] || { echo "skipped: no peer is here"; exit 0; }

$cc -std=gnu99 -O2 -ffp-contract=off -DWITH_QUAD -c bench/exact.c -o "$build/exact.o" || exit 1
for program in peers peers_ode; do
    $cxx -std=c++17 -O2 $flags "bench/$program.cpp" "$build/exact.o" -o "$build/$program" $libraries -lquadmath -lm || exit 1
done
"$build/peers" >"$build/functions.md"
functions=$?
"$build/peers_ode" >"$build/ode.md" 2>"$build/ode.log" # peers say there where they give up
integrators=$?
cat "$build/functions.md" "$build/ode.md"
# its two tables, with an empty line between them
awk -v RS= -v folder="$build" 'NR <= 2 {print >(folder "/" (NR == 1 ? "integrators" : "motions") ".md")}' "$build/ode.md"

wins=$(cat "$build/functions.md" "$build/ode.md" | grep -c ' wins$')
rows=$(cat "$build/functions.md" "$build/ode.md" | grep -c '^| .*[0-9] |')
verdict="No peer wins in any of $rows rows."
[ "$wins" = 0 ] || verdict="A peer wins in $wins of $rows rows, which end in \"wins\"."
{
    echo "processor  $(awk -F': ' '/model name/ {print $2; exit}' /proc/cpuinfo 2>/dev/null)"
    echo "compiler   $($cxx --version | head -n 1), -O2"
    echo "system     $(. /etc/os-release 2>/dev/null && echo "$PRETTY_NAME"), $(getconf GNU_LIBC_VERSION 2>/dev/null)"
} >"$build/machine"
awk -v folder="$build" -v peers="$peers" -v verdict="$verdict" '
    function insert(file,    line) { while ((getline line < (folder "/" file)) > 0) print line }
    /^@(machine|functions|integrators|motions)@$/ {
        name = substr($0, 2, length($0) - 2)
        if (name != "machine") name = name ".md"
        insert(name)
        next
    }
    { gsub("@peers@", peers); gsub("@verdict@", verdict); print }
    ' bench/peers.md >docs/peers.md
echo "$verdict"
[ "$wins" = 0 ] || { echo "FAILED, a peer wins:" && cat "$build/functions.md" "$build/ode.md" | grep ' wins$'; }
[ "$functions" = 0 ] && [ "$integrators" = 0 ]
