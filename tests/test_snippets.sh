#!/bin/sh
# All C that is shown compiles as it stands, without a warning, as C99 and as C++11: the blocks of README.md and docs/*.md,
# which are whole files; the code in the headers' comments, which begins in column 8; the examples.
# A piece of code in a comment that is no whole program is the body of a function; those of a header are one file, which
# begins with tests/snippets.h.
# usage: CC=compiler test_snippets.sh BUILD_FOLDER, from the top of the project
cc=${CC:-cc} build=$1/snippets
. tests/check.sh
pieces_may_end="-Wno-unused-variable -Wno-unused-but-set-variable" # a piece may end with its result in a variable
flags="-Wall -Wextra -Werror -pedantic"
compilers="$cc -std=c99"
for compiler in "clang -std=c99" "g++ -std=c++11 -x c++" "clang++ -std=c++11 -x c++"; do
    command -v "${compiler%% *}" >/dev/null && compilers="$compilers,$compiler"
done

compiles() { # compiles FILE OPTION... : by each of the compilers
    file=$1
    shift
    rest=$compilers,
    while [ -n "$rest" ]; do
        ${rest%%,*} $flags "$@" -I. -Itests "$file" || { echo "${rest%%,*}"; return 1; }
        rest=${rest#*,}
    done
}
blocks() { # blocks DOCUMENT PREFIX : each block of C into PREFIX1.c and so on
    awk -v prefix="$2" '/^```/ {on = 0} on {print >file} /^```c$/ {on = 1; count++; file = prefix count ".c"}' "$1"
}
unmarked() { # lines outside such blocks that look like C: none
    awk '/^```(c|text)$/ {fence = 1} /^```$/ {fence = !fence} !fence && /^    .*([;{]|\*\/) *$/ {print FILENAME ": " $0}' "$@" |
        grep -vE '^[^:]*: +(make|sh|cc|cd|for) '
}
pieces() { # pieces HEADER PREFIX : paragraphs in comments that begin in column 8 and have a line that ends with a semicolon
    awk -v prefix="$2" '
        function finish() {
            if (is_code) {
                count++
                if (text ~ /int main\(/) {
                    file = prefix count ".c"
                    printf "%s", text >file
                    close(file)
                } else bodies = bodies "void piece" count "(void);\nvoid piece" count "(void)\n{\n" indented "}\n"
            }
            text = indented = ""
            is_code = 0
        }
        !/^       / || (text == "" && !/^       [^ ]/) { finish(); next }
        { text = text substr($0, 8) "\n"; indented = indented substr($0, 4) "\n" }
        /;( *\/\/.*)?$/ && !/^       [^ ]+  / { is_code = 1 }
        END {
            finish()
            if (bodies != "") printf "#include \"snippets.h\"\n%s", bodies >prefix "_pieces.c"
        }' "$1"
}

for document in README.md docs/*.md; do blocks "$document" "$build/$(basename "$document" .md)"; done
for header in jacobi ateb integrators varmass; do
    # only comments; their first line is without its mark
    sed -n '/^\/\*/,/\*\//p' $header.h >"$build/$header.comments"
    pieces "$build/$header.comments" "$build/$header"
    check "$header.h shows code" grep -q piece3 "$build/${header}_pieces.c"
done
check "README.md shows three pieces" test -e "$build/README3.c"
check "varmass.h shows many pieces" grep -q piece40 "$build/varmass_pieces.c"
check "no code in documents but in marked blocks" fails unmarked README.md docs/*.md
for piece in "$build"/*.c; do
    case $piece in *_pieces.c) more=$pieces_may_end ;; *) more= ;; esac
    check "$(basename "$piece" .c)" compiles "$piece" $more -fsyntax-only
    check "$(basename "$piece" .c), optimised" $cc -std=c99 $flags $more -O2 -I. -Itests -c "$piece" -o "$build/piece.o"
done
# the examples as C++; as C99 make lint compiles them, under more warnings
if command -v g++ >/dev/null; then compilers="g++ -std=c++11 -x c++"; else compilers="$cc -std=c99"; fi
for example in examples/*.c examples/first_steps/*.c examples/package/consumer/*.c examples/wasm/*.c; do
    check "$example" compiles "$example" -fsyntax-only
done
if echo | $cc -fopenmp -fsyntax-only -x c - 2>/dev/null; then
    check "examples/sweep/breakups.c" compiles examples/sweep/breakups.c -fopenmp -fsyntax-only
fi
check_finish snippets
