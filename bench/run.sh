#!/bin/sh
# Run the bench programs one after the other, draw the plots, print the summary.
# usage: CC=compiler FLAGS=flags run.sh FOLDER FIGURES [quick] PROGRAM..., from the top of the project; programs are in
# build/bench, FOLDER gets their CSV files and tables, FIGURES the plots
folder=$1 figures=$2 quick=$3
shift 3
mkdir -p "$folder" "$figures"
sh bench/machine.sh "$CC" "$FLAGS" | tee "$folder/machine"
echo
for program in "$@"; do
    ./build/bench/$program "$folder/$program.csv" $quick >"$folder/$program.table" || exit 1
    cat "$folder/$program.table"
done
sh bench/plots.sh "$folder" "$figures"
echo
sh bench/summary.sh "$folder"
echo
echo "tables and CSV files: $folder; plots: $figures/cost_*.svg; bench/compare.sh compares two runs"
