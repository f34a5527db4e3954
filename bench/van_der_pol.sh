#!/bin/sh
# Write docs/van-der-pol.md from bench/van_der_pol.md, with the numbers of bench/van_der_pol.c, and draw its figures.
# usage: sh bench/van_der_pol.sh BUILD, from the top of the project; BUILD/van_der_pol is there
build=$1
for part in table cycle; do "$build/van_der_pol" $part >"$build/vdp_$part.md" || exit 1; done
for name in wave slopes; do
    "$build/van_der_pol" $name "$build/vdp_$name.csv" || exit 1
    gnuplot -e "csv='$build/vdp_$name.csv'; svg='docs/figures/van_der_pol_$name.svg'; name='$name'" \
        bench/van_der_pol.gp || exit 1
done
awk -v table="$build/vdp_table.md" -v cycle="$build/vdp_cycle.md" '
function insert(file,    line) { while ((getline line < file) > 0) print line }
/^@table@$/ { insert(table); next }
/^@cycle@$/ { insert(cycle); next }
{ print }' bench/van_der_pol.md >docs/van-der-pol.md
