#!/bin/sh
# The table of errors (src/base/status.h), tested over all public functions of varmass.h, jacobi.h and ateb.h, double
# and float. A program is generated that calls each function with valid arguments, then with each mistake that can be
# made in them, and compares the statuses, and whether outputs are untouched. tests/errors/valid.txt has the valid values
# that types do not tell, exceptions.txt the exceptions, open.txt what does not yet keep to the table.
# After a function was mended, write open.txt anew: test_errors.sh BUILD_FOLDER write
# usage: CC=compiler test_errors.sh BUILD_FOLDER, from the top of the project
cc=${CC:-cc} build=$1/errors
export LC_ALL=C
. tests/check.sh

generate() { # the program, from the signatures as they are
    folder=tests/errors
    awk -f $folder/generate.awk $folder/valid.txt $folder/exceptions.txt $folder/objects.h jacobi.h ateb.h \
        integrators.h varmass.h >"$build/errors.c" 2>"$build/unused"
}

# print_failures PRECISION VERDICT FILE: the lines of the program, with the file of src/ that has the function
print_failures() {
    awk -F '\t' -v precision="$1" -v verdict="$2" -v lines="$3" '
        FNR == 1 { file = FILENAME }
        /^(VM|JACOBI|ATEB)[A-Z_]* .*\(/ {
            name = $0
            sub(/\(.*/, "", name)
            sub(/^.*[ *]/, "", name)
            file_of[name] = file
        }
        END {
            while ((getline <lines) > 0)
                printf "FAILED: %s, %s: %s, %s, %s: %s instead of %s%s\n", precision, file_of[$1], $1, $2, $3, $4, $5,
                    verdict
        }' src/*/*.h
}

# write_open: tests/errors/open.txt anew, from the lines of both precisions; its head stays
write_open() {
    grep '^#' tests/errors/open.txt >"$build/open"
    {
        comm -12 "$build/double" "$build/float"
        comm -23 "$build/double" "$build/float" | sed 's/$/\tdouble only/'
        comm -13 "$build/double" "$build/float" | sed 's/$/\tfloat only/'
    } | sort >>"$build/open"
    cp "$build/open" tests/errors/open.txt
}

# compare PRECISION: the lines of the program with tests/errors/open.txt
compare() {
    precision=$1
    awk -F '\t' -v OFS='\t' -v only="$precision only" '!/^#/ && ($6 == "" || $6 == only) { print $1, $2, $3, $4, $5 }' \
        tests/errors/open.txt | sort >"$build/listed"
    comm -13 "$build/listed" "$build/$precision" >"$build/new"
    comm -23 "$build/listed" "$build/$precision" >"$build/gone"
    print_failures "$precision" "" "$build/new"
    print_failures "$precision" " is listed in tests/errors/open.txt, but no longer occurs" "$build/gone"
    failed=$((failed + $(cat "$build/new" "$build/gone" | wc -l)))
}

# try PRECISION OPTIONS... : runs the program and counts what passed
try() {
    precision=$1
    shift
    if ! $cc -std=c99 "$@" -I. "$build/errors.c" -o "$build/errors_$precision" -lm >"$build/log" 2>&1; then
        failed=$((failed + 1))
        echo "FAILED: the generated program does not compile, $precision"
        grep -m 5 error "$build/log"
        return
    fi
    "$build/errors_$precision" 2>"$build/counts" | sort -u >"$build/$precision"
    sed '$d' "$build/counts"
    counts=$(tail -n 1 "$build/counts")
    case $counts in
    *" passed, "*" missing, "*) ;;
    *) counts="0 passed, 1 missing, after which it stopped" ;;
    esac
    passed=$((passed + ${counts%% *}))
    counts=${counts#*, }
    failed=$((failed + ${counts%% *}))
}

check "the program is generated" generate
check "every line of tests/errors/valid.txt is needed" fails grep . "$build/unused"
try double -O0
try float -O0 -DVM_USE_FLOAT
[ "$2" = write ] && write_open
compare double
compare float
check "every exception is needed" fails grep 'is not needed' "$build/counts"
echo "errors: $(grep -vc '^#' tests/errors/open.txt) outcomes do not yet keep to the table (tests/errors/open.txt)"
check_finish errors
