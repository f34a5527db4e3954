#!/bin/sh
# docs/parts.md: what each chapter costs who takes it alone. Lines: of the header that src/part.sh writes. Flash: code and
# tables of all public functions of the chapter and of everything that they call, on a Cortex-M4F, in float, gcc -Os.
# usage: sh src/parts_table.sh BUILD_FOLDER, from the top of the project
build=$1/parts_table
mkdir -p "$build"

lines() { awk 'END {print NR}' "$1"; }

# the public functions that a file of src/ defines
public_functions() {
    sed -nE 's/^VM_(API|INLINE) [^(]*[ *]([a-z][A-Za-z0-9_]*)\(.*/\2/p' "$1" | grep -v '^vmi_'
}

flash() { # flash CHAPTER : bytes, where its part is $build/part.h
    {
        echo '#include "part.h"'
        echo 'typedef void (*function)(void);'
        echo 'extern const function all[];'
        echo 'const function all[] = {'
        public_functions "src/$1.h" | sed 's/.*/    (function)&,/'
        echo '    0};'
    } >"$build/part.c"
    arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -std=c99 -Os -DVM_USE_FLOAT \
        -fno-math-errno -ffp-contract=off -I"$build" -c "$build/part.c" -o "$build/part.o" || exit 1
    pointers=$(($(public_functions "src/$1.h" | wc -l) * 4 + 4))
    arm-none-eabi-size "$build/part.o" | awk -v pointers=$pointers 'NR == 2 {print $1 + $2 - pointers}'
}

needs() { # needs CHAPTER : the chapters that it includes itself
    sed -n 's/^#include "\(.*\)\.h"/\1/p' "src/$1.h" | sed "s|^\.\./||; t; s|^|$(dirname "$1")/|" | grep -v '^base/' | sort
}

cat <<END
# Parts

The command \`make parts-table\` writes this page.

The source of the kit is divided into chapters. Each chapter is one header file in a folder of src/. A program can use a chapter,
with the chapters that it needs, without the rest of the kit. For example, \`make part PARTS="mechanics/jumps"\` writes the header
\`build/parts/jumps.h\`. This header contains the chapter \`mechanics/jumps\` and the chapters that \`mechanics/jumps\` needs, and
nothing else. If you name several chapters in \`PARTS\`, the command writes one header that contains all of them, and the header has
the name of the first chapter. For example, \`make part PARTS="mechanics/jumps oscillators/routes"\` writes a header that contains
both chapters and what they need; the name of this header is again \`build/parts/jumps.h\`, because \`mechanics/jumps\` comes
first.

Each row of the table is for one chapter that has public functions, and for the header that \`make part\` writes if you name only
this chapter. (A chapter that has only internal functions has no row.) The column
"lines" has the number of lines of this header, with its comments. The column "flash" has the size in bytes of all public
functions of the chapter, with all code and tables of constants that these functions use, in this chapter or in other chapters.
What these functions do not use is not counted; therefore the number of a chapter can be smaller than that of a chapter that it
needs. The sizes are for programs in float on the processor Cortex-M4F, compiled by gcc -Os. A program that calls only some
functions of the chapter needs less flash than this column says. The column "needs" lists the chapters that the chapter of the row
includes directly. The chapters of the folder base/ are not listed in this column.

| chapter | what it is about | lines | flash | needs |
|---|---|---|---|---|
END
for folder in mechanics oscillators scenes integrators ateb jacobi base; do
    for file in src/$folder/*.h; do
        chapter=${file#src/}
        chapter=${chapter%.h}
        [ -n "$(public_functions "$file")" ] || continue
        sh src/part.sh "$build/part.h" "$chapter" || exit 1
        title=$(sed -n '1s|^/\* [^ ]* - \(.*\)|\1|; 1s| *\*/$||; 1s/[|]/\\|/g; 1p' "$file")
        needed=$(needs "$chapter" | tr '\n' ' ' | sed 's/ $//; s/ /, /g')
        printf '| `%s` | %s | %s | %s | %s |\n' "$chapter" "$title" "$(lines "$build/part.h")" "$(flash "$chapter")" "${needed:--}"
    done
done
