#!/bin/sh
# The table of errors (src/base/status.h), tested over all public functions of varmass.h, jacobi.h and ateb.h, double and
# float. A program is generated that calls each function with valid arguments, then with each mistake that can be made in
# them, and compares the statuses, and whether outputs are untouched. tests/errors/valid.txt has the valid values that
# types do not tell, tests/errors/exceptions.txt the exceptions.
# usage: CC=compiler test_errors.sh BUILD_FOLDER, from the top of the project
cc=${CC:-cc} build=$1/errors
. tests/check.sh

generate() { # the program, from the signatures as they are
    folder=tests/errors
    awk -f $folder/generate.awk $folder/valid.txt $folder/exceptions.txt $folder/objects.h jacobi.h ateb.h \
        integrators.h varmass.h >"$build/errors.c" 2>"$build/unused"
}

# print_failures PRECISION FILE: the lines of the program, with the file of src/ that has the function
print_failures() {
    awk -F '\t' -v precision="$1" -v lines="$2" '
        FNR == 1 { file = FILENAME }
        /^VM[A-Z_]* .*\(/ {
            name = $0
            sub(/\(.*/, "", name)
            sub(/^.*[ *]/, "", name)
            file_of[name] = file
        }
        END {
            while ((getline <lines) > 0)
                printf "FAILED: %s, %s: %s, %s, %s: %s instead of %s\n", precision, file_of[$1], $1, $2, $3, $4, $5
        }' src/*/*.h
}

# try PRECISION OPTIONS... : runs the program, prints what is not as it should be (in float only what double does not
# have), and counts
try() {
    precision=$1
    shift
    if ! $cc -std=c99 "$@" -I. "$build/errors.c" -o "$build/errors_$precision" -lm >"$build/log" 2>&1; then
        failed=$((failed + 1))
        echo "FAILED: the generated program does not compile, $precision"
        grep -m 5 error "$build/log"
        return
    fi
    "$build/errors_$precision" >"$build/$precision" 2>"$build/counts"
    if [ "$precision" = double ]; then cp "$build/double" "$build/new"
    else grep -vxFf "$build/double" "$build/$precision" >"$build/new"
    fi
    print_failures "$precision" "$build/new"
    sed '$d' "$build/counts"
    counts=$(tail -n 1 "$build/counts")
    case $counts in
    *" passed, "*" failed, "*) ;;
    *) counts="0 passed, 1 failed, after which it stopped" ;;
    esac
    passed=$((passed + ${counts%% *}))
    counts=${counts#*, }
    failed=$((failed + ${counts%% *}))
}

check "the program is generated" generate
check "every line of tests/errors/valid.txt is needed" fails grep . "$build/unused"
try double -O0
try float -O0 -DVM_USE_FLOAT
check "every exception is needed" fails grep 'is not needed' "$build/counts"
check_finish errors
