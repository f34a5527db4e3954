#!/bin/sh
# Draw the figures of the examples from the CSV files in the folder named, as SVG beside them.
folder=$1
if ! sh tests/install.sh "command -v gnuplot" gnuplot-nox; then
    echo "no gnuplot: the curves are in $folder/*.csv, no figures drawn"
    exit 0
fi
draw() { # draw CSV NAME FIRST_COLUMN SVG
    gnuplot -e "csv='$folder/$1.csv'; name='$2'; column=$3; svg='$folder/$4.svg'" examples/envelopes.gp || exit 1
    echo "  $folder/$4.svg   $5"
}
echo
echo "figures:"
draw example1 Ateb 4 example1_ateb "Fig. 22"
draw example1 trigonometric 8 example1_trigonometric "Fig. 23"
draw example1 Jacobi 12 example1_jacobi "Fig. 24"
draw example2 Ateb 4 example2_ateb "Fig. 25"
draw example2 trigonometric 8 example2_trigonometric "the same, trigonometric"
draw example2 Jacobi 12 example2_jacobi "the same, Jacobi"
for figure in break transient fig18; do
    gnuplot -e "prefix='$folder/rotor'; figure='$figure'" examples/rotor.gp 2>"$folder/gnuplot.log" ||
        { cat "$folder/gnuplot.log"; exit 1; }
done
echo "  $folder/rotor_{break,transient,fig18}.svg   Figs 17 and 18, the motion after the break"
gnuplot -e "prefix='$folder/pendulum'" examples/pendulum.gp || exit 1
echo "  $folder/pendulum.svg   Fig. 19"
