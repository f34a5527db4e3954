#!/bin/sh
# Write docs/duffing.md from bench/duffing.md, with the numbers of bench/duffing.c, and draw its figure.
# usage: sh bench/duffing.sh BUILD, from the top of the project; BUILD/duffing is there
build=$1
"$build/duffing" table >"$build/duffing_table.md" && "$build/duffing" slopes "$build/duffing_slopes.csv" || exit 1
gnuplot -e "csv='$build/duffing_slopes.csv'; svg='docs/figures/duffing_slopes.svg'" bench/duffing.gp || exit 1
awk -v table="$build/duffing_table.md" '
function insert(file,    line) { while ((getline line < file) > 0) print line }
/^@table@$/ { insert(table); next }
{ print }' bench/duffing.md >docs/duffing.md
