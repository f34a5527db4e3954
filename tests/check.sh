# What the test scripts share; to be sourced once $build is set: checks are counted, what they print goes to $build/log
passed=0 failed=0
rm -rf "$build" && mkdir -p "$build" && echo '*' >"${build%/*}/.gitignore" || exit 1

check() { # check NAME COMMAND...
    name=$1
    shift
    if "$@" >"$build/log" 2>&1; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: $name"
        sed -n '1,5p' "$build/log"
    fi
}

fails() { ! "$@"; }

check_finish() { # check_finish NAME
    echo "$1: $passed passed, $failed failed, 0 skipped"
    [ $failed = 0 ]
}
