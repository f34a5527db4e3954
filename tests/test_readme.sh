#!/bin/sh
# What the documents say exists: names of the glossary, files that are linked, targets; and the README's commands run as
# they stand, in a copy of the project. usage: CC=compiler test_readme.sh BUILD_FOLDER [quick|all], from the top of the project
# Without "all", a command that takes minutes, or that another script of make test-all runs, is only checked to be there; with
# "quick", one that takes many seconds, too.
build=$PWD/$1/readme
[ "$2" = quick ] && build=${build}_quick
copy=$build/copy
. tests/check.sh
skipped=0
long='test|test-all|lint|bench|measurements|cost|scan|points|exhaustive|data|figures|test-.*|evaluations|coverage|first-steps|scene-sizes|sweep|firmware-table|docs|check-docs|campaigns|peers|parts-table'
elsewhere='packages|amalgamation|site|wasm' # by test_package, test_site and test_page
[ "$2" = quick ] && long="$long|run|bench-quick|bench-count|toronto|validation|firmware"

# indented lines and `spans` that begin with a command; a line may go on with && and so on
commands() {
    awk '/^```/ {fence = !fence} !fence && /^    (make|cc|sh|python3|\.\/|build\/)/ {print substr($0, 5)}' README.md
    grep -o '`[^`]*`' README.md | tr -d '`' | grep -E '^(make|sh|python3) |^build/[a-z0-9_/]*[a-z0-9]( |$)'
}
unique() { awk '!seen[$0]++'; }
known_name() { grep -qwF -e "$1" jacobi.h ateb.h integrators.h varmass.h; }
is_long() { echo "$1" | grep -Eq "^(make ($long|$elsewhere)( |\$)|build/|sh (tests|bench)/)"; }
builds() { # what a program under build/ needs: make knows how
    set -- $1
    case $1 in build/*) make -s "$1" ;; *) true ;; esac
}
tools() { # tools COMMAND : what it would install, which takes minutes
    case $1 in
    "make firmware") echo arm-none-eabi-gcc qemu-system-arm ;;
    "make wasm") echo clang wasm-ld node ;;
    python3*) echo python3 ;;
    esac
}
there() { for tool in "$@"; do command -v "$tool" >/dev/null || return 1; done; }
run() { cd "$copy" && builds "$1" && HOME=$build/home sh -c "$1"; }
dry_run() { # that the script or the target is there; make -n would run recipes that call make
    set -- $1
    case $1 in
    sh) test -e "$2" ;;
    make) grep -E '^[.]PHONY' Makefile | grep -qwF -e "$2" ;;
    *) make -n "$1" ;;
    esac
}

mkdir -p "$copy" "$build/home"
tar -cf - --exclude=./build --exclude=./.git . | tar -xf - -C "$copy"
# the README's programs: example.c, as it calls the first, example2.c and so on; what they print is in it, indented
awk -v name="$copy/example" '/^```$/ {on = 0} on {print >file}
                             /^```c$/ {on = 1; n++; file = name (n > 1 ? n : "") ".c"}' README.md
prints_as_shown() {
    ${CC:-cc} -std=c99 -O2 "$copy/$1.c" -o "$copy/$1" -lm && "$copy/$1" >"$copy/$1.txt" || return 1
    while IFS= read -r line; do grep -qxF "    $line" README.md || { echo "$line"; return 1; }; done <"$copy/$1.txt"
}
for program in example example2; do check "README's $program.c prints what is shown" prints_as_shown "$program"; done

for name in $(awk '/^\|/ && !/^\|[-|]*$/ {n = split($0, cell, "|"); print cell[n - 1]}' docs/glossary.md | grep -o '`[^`]*`' |
    tr -d '`' | sed 's/\[.*//; s/\.h$//' | sort -u); do
    check "glossary: $name" known_name "$name"
done
for link in $(grep -oh ']([A-Za-z0-9_./-]*)' README.md | tr -d ']()' | grep -v '^http' | sort -u); do
    check "README links to $link" test -e "$link"
done
for document in docs/*.md; do
    for link in $(grep -oh ']([A-Za-z0-9_./-]*)' "$document" | tr -d ']()' | grep -v '^http' | sort -u); do
        check "$document links to $link" test -e "docs/$link"
    done
done

commands | unique >"$build/commands"
check "commands are found" test "$(wc -l <"$build/commands")" -gt 10
while IFS= read -r command <&3; do
    if [ "$2" != all ] && is_long "$command"; then
        check "is there: $command" dry_run "$command"
    elif [ "$2" != all ] && ! there $(tools "$command"); then
        skipped=$((skipped + 1))
        echo "skipped: $command: not here: $(tools "$command")"
    else
        check "runs: $command" run "$command"
    fi
done 3<"$build/commands"
echo "readme: $passed passed, $failed failed, $skipped skipped"
[ $failed = 0 ]
