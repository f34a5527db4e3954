#!/bin/sh
# The first steps: build and run them, draw their figures, and write down what they say.
# usage: [CC=compiler] [LEVEL=-O2] steps.sh BUILD_FOLDER [write], from the top of the project
# Without write, docs/first-steps.md is compared with what it would be.
build=$1/first_steps doc=$1/first_steps/first-steps.md
mkdir -p "$build" || exit 1
{
    echo '# First steps'
    echo
    echo "Each section of this page describes one of $(ls examples/first_steps/*.c | wc -l) programs of less than 60 lines, and shows what the program prints and its"
    echo "figure. The comment at the top of a program contains the command that compiles it. The command \`make first-steps\` writes this"
    echo "page: it builds and runs the programs, and draws the figures. A number in round brackets, such as (325), is the number of an"
    echo "equation in Cveticanin's dissertation *Dynamics of Mass Variable System*. Names that begin with vm_ are functions and structs of"
    echo "the header varmass.h of the kit varmass. In formulas a prime means d/dt, the time derivative. If the output of a program counts"
    echo "evaluations, an evaluation is one call of the function that computes the derivatives in the differential equation."
} >"$doc"
for source in examples/first_steps/*.c; do
    name=$(basename "$source" .c)
    ${CC:-cc} -std=c99 ${LEVEL:--O2} -ffp-contract=off "$source" -o "$build/$name" -lm || exit 1
    "$build/$name" "$build/$name.csv" >"$build/$name.txt" || { echo "$name failed"; exit 1; }
    title=$(sed -n '1s|^/\* \([^.]*\)\..*|\1|p' "$source")
    {
        printf '\n## %s\n\n' "$title"
        awk 'NR == 1 {sub("^/\\* [^.]*\\. ", "")} /^$/ {exit} {sub("^   ", ""); print}' "$source" | sed "s/\*/\\\\*/g"
        printf '\nThe program [%s](../%s) prints this:\n\n' "$(basename "$source")" "$source"
        sed 's/^/    /' "$build/$name.txt"
        printf '\n![%s](figures/first_steps/%s.svg)\n' "$title" "$name"
    } >>"$doc"
done
if [ "$2" = write ]; then
    sh tests/install.sh "command -v gnuplot" gnuplot-nox || exit 1
    mkdir -p docs/figures/first_steps
    cp "$doc" docs/first-steps.md
    for source in examples/first_steps/*.c; do
        name=$(basename "$source" .c)
        title=$(sed -n '1s|^/\* \([^.]*\)\..*|\1|p' "$source")
        gnuplot -e "csv='$build/$name.csv'; svg='docs/figures/first_steps/$name.svg'; title='$title'" \
            examples/first_steps/draw.gp || exit 1
    done
    echo "docs/first-steps.md and its figures are written"
else
    grep -v '^The results on this page' docs/first-steps.md | sed '$ {/^$/d}' | diff - "$doc"
fi
