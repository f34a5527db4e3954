# What checks of hours share, which run all tests in other ways than make test. To be sourced once $kept is set, a folder: a test
# that passed is kept there, so that a run that was broken off goes on where it was. A test stays kept while the code of the
# headers (bench/stamp.sh), the files that tests share and the test stay as they are.
stamp=$(sh bench/stamp.sh of jacobi ateb integrators varmass)
shared=$(ls tests/*.h tests/data/*.h tests/hard/* tests/cross/* examples/*.h examples/scenes/*.h | grep -v /eva_)
mkdir -p "$kept" || exit 1

kept_file() { echo "$kept/$(echo "$1.$2" | tr -c 'a-zA-Z0-9_.\n' -)"; } # kept_file RUN TEST
sources_of() { { echo "$stamp" && cat $shared "tests/test_$1.c"; } | cksum; } # sources_of TEST
is_kept() { [ "$(head -n 1 "$(kept_file "$1" "$2")" 2>/dev/null)" = "$(sources_of "$2")" ]; }   # is_kept RUN TEST
keep() { printf '%s\n%s\n' "$(sources_of "$2")" "$3" >"$(kept_file "$1" "$2")"; } # keep RUN TEST WORD
kept_word() { sed -n 2p "$(kept_file "$1" "$2")"; }                               # kept_word RUN TEST: the word kept with it

# As in make test the headers are compiled once, and the tests are linked with this object. They read the headers without the
# functions' bodies, from a folder that declare_headers fills.
declare_headers() { # declare_headers FOLDER
    for header in jacobi.h ateb.h integrators.h varmass.h; do awk -f tests/declared.awk $header >"$1/$header"; done
}
declared() { # declared FOLDER TEST: options for the headers that the test includes, or varmass.h where its own headers do
    names=$(sed -n 's|^#include "\.\./\([a-z]*\.h\)".*|\1|p' "tests/test_$2.c")
    for header in ${names:-varmass.h}; do echo "-include $1/$header"; done | paste -s -d ' ' -
}
