#!/bin/sh
# Draw the plots of costs from the CSV files of the bench programs, as SVG.
# usage: plots.sh FOLDER FIGURES, from the top of the project
folder=$1 figures=$2
if ! sh tests/install.sh -w "which draws the figures" "command -v gnuplot" gnuplot-nox; then
    echo "no gnuplot: the CSV files are in $folder, no plots drawn"
    exit 0
fi
draw() { # draw SCRIPT NAME SETTINGS : FIGURES/cost_NAME.svg, where the script and its data are there
    [ -f "bench/$1.gp" ] && [ -f "$folder/$1.csv" ] || return 0
    svg=$figures/cost_$2.svg
    gnuplot -e "folder='$folder'; csv='$folder/$1.csv'; svg='$svg'; $3" "bench/$1.gp" 2>"$folder/gnuplot.log" &&
        echo "  $svg" || { cat "$folder/gnuplot.log"; exit 1; }
}
echo "plots:"
draw oscillator oscillator "all=0"
draw oscillator oscillator_all "all=1"
draw jacobi jacobi
draw ateb ateb
for problem in cubic mass body orbit; do draw integrators integrators_$problem "problem='$problem'"; done
draw rotation rotation
draw scenes scenes
