#!/bin/sh
# Draw the figures of the examples from the CSV files in the folder named, as SVG beside them.
folder=$1
if ! sh tests/install.sh -w "which draws the figures" "command -v gnuplot" gnuplot-nox; then
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
gnuplot -e "csv='$folder/drum.csv'; svg='$folder/drum.svg'" examples/drum.gp || exit 1
echo "  $folder/drum.svg   the drum of Fig. 20, (177)-(226) as printed and corrected"
gnuplot -e "csv='$folder/dzhanibekov.csv'; svg='$folder/dzhanibekov.svg'" examples/dzhanibekov.gp || exit 1
echo "  $folder/dzhanibekov.svg   a wing nut that turns over"
gnuplot -e "csv='$folder/tumbling.csv'; svg='$folder/tumbling.svg'" examples/tumbling.gp || exit 1
echo "  $folder/tumbling.svg   a tumbling satellite sheds a panel"
for name in rocket dust; do
    gnuplot -e "csv='$folder/$name.csv'; svg='$folder/$name.svg'" examples/$name.gp || exit 1
    echo "  $folder/$name.svg   chapter 5: streams of mass"
done
slow() { # slow NUMBER PANELS CASES WAVES LOW HIGH LABEL
    gnuplot -e "csv='$folder/slow_$1.csv'; svg='$folder/figure$1.svg'; panels=$2; cases=$3; waves=$4; low=$5; high=$6" \
        -e "label='$7'" examples/slow.gp || exit 1
    echo "  $folder/figure$1.svg   Fig. $1"
}
slow 21 3 1 2 -0.2 0.3 x
slow 26 3 3 0 0 3.4 amplitude
slow 27 3 1 1 -2.8 4 x
slow 28 1 3 0 0 5 amplitude
slow 29 2 1 1 -2.8 4 x
slow 30 2 1 1 -1.1 1.6 "x, y"
slow 32 2 1 1 -1.5 5 "x, y"
gnuplot -e "folder='$folder'" examples/resonance.gp || exit 1
echo "  $folder/resonance.svg   resonance curve under harmonic force"
echo "  $folder/two_harmonics.svg   resonance curve under a force with a second harmonic"
echo "  $folder/passage.svg   passage through the resonance while the mass grows"
for figure in break transient fig18; do
    gnuplot -e "prefix='$folder/rotor'; figure='$figure'" examples/rotor.gp 2>"$folder/gnuplot.log" ||
        { cat "$folder/gnuplot.log"; exit 1; }
done
echo "  $folder/rotor_{break,transient,fig18}.svg   Figs 17 and 18, the motion after the break"
gnuplot -e "folder='$folder'" examples/models.gp || exit 1
echo "  $folder/model_{14,15,16,31}.svg   the models of Figs 14, 15, 16, 31"
gnuplot -e "prefix='$folder/pendulum'" examples/pendulum.gp || exit 1
echo "  $folder/pendulum.svg   Fig. 19"
