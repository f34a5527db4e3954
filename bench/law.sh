#!/bin/sh
# Write docs/law.md from bench/law.md, with the numbers of bench/law.c and of two examples, and draw its figures.
# usage: sh bench/law.sh BUILD, from the top of the project; BUILD/law, BUILD/examples/solvable and BUILD/examples/law_as_data
# are there
build=$1
printed() { # printed PROGRAM: what it prints, as a block of Markdown
    echo '```'
    "$build/examples/$1" || return 1
    echo '```'
}
"$build/law" table >"$build/law_table.md" && "$build/law" random >"$build/law_random.md" || exit 1
printed solvable >"$build/law_solvable.md" && printed law_as_data >"$build/law_closed.md" || exit 1
"$build/law" slopes "$build/law_slopes.csv" && "$build/law" errors "$build/law_errors.csv" || exit 1
for name in slopes errors; do
    gnuplot -e "csv='$build/law_$name.csv'; svg='docs/figures/law_$name.svg'; name='$name'" bench/law.gp || exit 1
done
awk -v parts="$build/law_" '
function insert(file,    line) { while ((getline line < file) > 0) print line }
/^@[a-z]*@$/ { insert(parts substr($0, 2, length($0) - 2) ".md"); next }
{ print }' bench/law.md >docs/law.md
