# Functions for the checks that take hours and that run all tests in other ways than make test does (tests/cross.sh,
# tests/sanitize.sh). Set $kept to a folder, then source this file. The folder records each test that has passed, so that a
# check that was interrupted continues where it stopped. A recorded test is run again only if the code that it runs has changed.
# This code is known by a checksum of three parts: the machine code of the test and of the functions that it reaches, for this
# machine in double and in float; the files of src/ whose code differs from target to target; and the files of tests/cross/ and
# tests/linked.h, which tests on other processors need.
mkdir -p "$kept" || exit 1
by_target=$(grep -rlE '^ *# *(if|elif).*(__[A-Z]|FAST_FMA|FLT_EVAL)' src | LC_ALL=C sort)
by_target_code=$(for file in $by_target; do ${CC:-cc} -fpreprocessed -dD -E -P "$file" 2>/dev/null; done | cksum)
text=$(cat src/*/*.h tests/cross/* tests/*.h tests/data/*.h tests/hard/* examples/*.h examples/scenes/*.h | cksum)

machine_code() { # machine_code TEST: in both precisions, without optimisation, which takes the least time
    for flags in "" -DVM_USE_FLOAT; do ${CC:-cc} -std=c99 -w -O0 $flags -S "tests/test_$1.c" -o - || return 1; done
}
# code_of TEST: its checksum, which is computed again only where a file has changed
code_of() {
    file=$kept/code.$1 sources=$({ echo "$text" && cat "tests/test_$1.c"; } | cksum)
    if [ "$(head -n 1 "$file" 2>/dev/null)" != "$sources" ]; then
        printf '%s\n%s\n' "$sources" "$({ machine_code "$1" && echo "$by_target_code" && cat tests/cross/* tests/linked.h; } |
            cksum)" >"$file.$$"
        mv "$file.$$" "$file"
    fi
    sed -n 2p "$file"
}

kept_file() { echo "$kept/$(echo "$1.$2" | tr -c 'a-zA-Z0-9_.\n' -)"; } # kept_file RUN TEST
is_kept() { [ "$(head -n 1 "$(kept_file "$1" "$2")" 2>/dev/null)" = "$(code_of "$2")" ]; }         # is_kept RUN TEST
keep() { printf '%s\n%s\n' "$(code_of "$2")" "$3" >"$(kept_file "$1" "$2")"; }    # keep RUN TEST WORD
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
