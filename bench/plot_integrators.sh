#!/bin/sh
# Draw the work-precision plots, one a problem: error at the end against time, log-log.
# usage: plot_integrators.sh FOLDER, with FOLDER/integrators.csv; from the top of the project
folder=$1
if ! sh tests/install.sh "command -v gnuplot" gnuplot-nox; then
    echo "no gnuplot: $folder/integrators.csv stays without plots"
    exit 0
fi
for problem in $(awk -F, 'NR > 1 && !seen[$1]++ {print $1}' "$folder/integrators.csv"); do
    {
        echo "set terminal svg size 800,600 font 'sans,13'; set output '$folder/integrators_$problem.svg'"
        echo "set datafile separator ','; set logscale xy; set format '10^{%L}'; set key outside; set grid"
        echo "set title '$problem'; set xlabel 'microseconds'; set ylabel 'error at the end'"
        printf 'plot '
        awk -F, -v p="$problem" 'NR > 1 && $1 == p && !seen[$2]++ {print $2}' "$folder/integrators.csv" |
            while read -r method; do
                grep "^$problem,$method," "$folder/integrators.csv" >"$folder/$problem.$method.csv"
                printf "'%s' using 7:4 with linespoints title '%s', " "$folder/$problem.$method.csv" "$method"
            done
        echo
    } | sed 's/, $//' >"$folder/plot.gp"
    gnuplot "$folder/plot.gp" && echo "wrote $folder/integrators_$problem.svg"
    rm -f "$folder/$problem".*.csv
done
rm -f "$folder/plot.gp"
