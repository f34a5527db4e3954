#!/bin/sh
# make site: Doxygen warns of nothing, and the reference has each public function with its comment.
# usage: test_site.sh BUILD_FOLDER, from the top of the project
build=$1/site_test
. tests/check.sh
if ! sh tests/install.sh -w "for the reference in HTML" "command -v doxygen" doxygen; then
    echo "site: 0 passed, 0 failed, 2 skipped"
    exit 0
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
