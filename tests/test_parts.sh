#!/bin/sh
# The rooms of src/ and the parts made of them. The headers at the top are what `make headers` writes; no room is too
# long; the part of each chapter holds all that it needs and compiles alone, as C99 and as C++11, in double and in float.
# C99 is tried in double and C++11 in float: a part is a piece of varmass.h, which make lint compiles in all four ways, so that
# what may be missing in a part is missing in both languages or in both precisions.
# usage: CC=compiler test_parts.sh BUILD_FOLDER [quick], from the top of the project
# With "quick", the parts are not compiled.
cc=${CC:-cc} build=$1/parts_test
[ "$2" = quick ] && build=$1/parts_quick
. tests/check.sh
strict="-Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wdouble-promotion -Wfloat-conversion -Wshadow -Wundef -Werror"

written_from_source() { awk -f src/headers.awk "src/$1.h" | diff - "$1.h"; }
for header in jacobi ateb integrators varmass; do
    check "$header.h is what make headers writes" written_from_source $header
done

most_lines=700
short_enough() { [ "$(wc -l <"$1")" -le $most_lines ]; }

# A cycle of includes: following the includes from a file leads back to it
reached() { # reached FILE : the files that it includes, directly or not
    awk -v root="$1" '
        function visit(file,    line, name) {
            while ((getline line < file) > 0) {
                if (line !~ /^#include "/) continue
                name = file
                sub(/[^\/]*$/, "", name)
                name = name substr(line, 11, length(line) - 11)
                while (sub(/[^\/.]+\/\.\.\//, "", name)) {}
                if (!seen[name]++) {
                    print name
                    pending[++count] = name
                }
            }
            close(file)
        }
        BEGIN { visit(root); for (i = 1; i <= count; i++) visit(pending[i]) }'
}
no_cycle() { ! reached "$1" | grep -qx "$1"; }

as_float="$cc -x c -std=c99" # where there is no compiler of C++
if command -v g++ >/dev/null; then as_float="g++ -x c++ -std=c++11"; fi
compiles() { # compiles CHAPTER : its part, by the C compiler and by that of C++
    sh src/part.sh "$build/part.h" "$1" && $cc -x c -std=c99 $strict -fsyntax-only "$build/part.h" &&
        $as_float $strict -DVM_USE_FLOAT -fsyntax-only "$build/part.h"
}
for file in src/*/*.h; do
    check "$file has at most $most_lines lines" short_enough "$file"
    check "$file does not include itself by way of others" no_cycle "$file"
done
check "there are chapters" test "$(find src -name '*.h' | wc -l)" -gt 60
[ "$2" = quick ] && { check_finish parts; exit; }

for file in src/*/*.h; do
    chapter=${file#src/}
    chapter=${chapter%.h}
    check "the part of $chapter compiles alone" compiles "$chapter"
done

# What a controller takes that needs jumps in space only
sh src/part.sh "$build/jumps.h" mechanics/jumps
check "the part for jumps in space has at most 1500 lines" test "$(wc -l <"$build/jumps.h")" -le 1500

# Two parts and the whole header in one program
sh src/part.sh "$build/drum.h" mechanics/drum base/self_check
together() {
    printf '#include "%s"\n' drum.h jumps.h varmass.h >"$build/together.c"
    printf 'int main(void) { return vm_self_check() ? 0 : 1; }\n' >>"$build/together.c"
    $cc -std=c99 $strict -I"$build" -I. "$build/together.c" -o "$build/together" -lm && "$build/together"
}
check "two parts and varmass.h in one program" together
check "a chapter that does not exist is refused" fails sh src/part.sh "$build/none.h" mechanics/none
check_finish parts
