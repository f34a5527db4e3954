#!/bin/sh
# Write docs/law.md from bench/law.md, with the numbers of bench/law.c and examples/solvable.c, and draw its figures.
# usage: sh bench/law.sh BUILD, from the top of the project; BUILD/law and BUILD/examples/solvable are there
build=$1
"$build/law" table >"$build/law_table.md" || exit 1
{ echo '```'; "$build/examples/solvable"; echo '```'; } >"$build/law_solvable.md" || exit 1
"$build/law" slopes "$build/law_slopes.csv" && "$build/law" errors "$build/law_errors.csv" || exit 1
for name in slopes errors; do
    gnuplot -e "csv='$build/law_$name.csv'; svg='docs/figures/law_$name.svg'; name='$name'" bench/law.gp || exit 1
done
awk -v table="$build/law_table.md" -v solvable="$build/law_solvable.md" '
function insert(file,    line) { while ((getline line < file) > 0) print line }
/^@table@$/ { insert(table); next }
/^@solvable@$/ { insert(solvable); next }
{ print }' bench/law.md >docs/law.md
