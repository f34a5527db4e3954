#!/bin/sh
# Writes one header with the named chapters and all that they need, and nothing else, to FILE.
# usage: sh src/part.sh FILE CHAPTER..., from the top of the project; a chapter is a file of src/ without .h:
#        sh src/part.sh build/parts/jumps.h mechanics/jumps
file=$1
shift
folder=$(dirname "$file") name=$(basename "$file" .h)
mkdir -p "$folder"
up=$(dirname "$file" | sed 's|[^/][^/]*|..|g')
guard=VARMASS_PART_$(echo "$name" | tr 'a-z-' 'A-Z_')_H
root=$folder/$name.root
{
    echo "/* $name.h - a part of varmass: $*"
    echo
    echo "   Part of varmass (MIT licence). Copy this one file, include it, link with -lm. It needs no other file of varmass, and"
    echo "   may be included next to other parts and next to the whole headers of the same version. Written by"
    echo "   make part PARTS=\"$*\""
    echo
    echo "   INDEX"
    echo "@INDEX@ */"
    echo "#ifndef $guard"
    echo "#define $guard"
    echo
    echo "#include \"$up/src/base/real.h\""
    echo
    echo "VMI_QUIET_BEGIN"
    for chapter; do
        [ -f "src/$chapter.h" ] || { echo "there is no chapter src/$chapter.h" >&2; exit 1; }
        echo "#include \"$up/src/$chapter.h\""
    done
    echo
    echo "VMI_QUIET_END"
    echo
    echo "#endif"
} >"$root" && awk -f src/headers.awk "$root" >"$file" || exit 1
rm "$root"
